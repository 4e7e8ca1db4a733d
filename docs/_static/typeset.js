// Typesets what Sphinx marks as mathematics; without KaTeX the source of the formulas remains.
document.addEventListener("DOMContentLoaded", function () {
    if (typeof katex === "undefined") return;
    document.querySelectorAll("span.math, div.math").forEach(function (element) {
        var display = element.tagName === "DIV", number = element.querySelector(".eqno");
        var source = (number ? element.lastChild : element).textContent.trim();
        source = source.replace(/^\\[(\[]|\\[)\]]$/g, "");
        var target = number ? document.createElement("div") : element;
        katex.render(source, target, {displayMode: display, throwOnError: false});
        if (number) {
            element.removeChild(element.lastChild);
            element.appendChild(target);
        }
    });
});

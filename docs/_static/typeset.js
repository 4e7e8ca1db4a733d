// Typesets what Sphinx marks as mathematics; without KaTeX the source of the formulas remains. A number keeps its own column.
document.addEventListener("DOMContentLoaded", function () {
    if (typeof katex === "undefined") return;
    document.querySelectorAll("span.math, div.math").forEach(function (element) {
        var number = element.querySelector(".eqno"), source = element.textContent.trim();
        if (number) source = source.slice(number.textContent.trim().length);
        var target = element;
        if (number) {
            target = document.createElement("div");
            element.replaceChildren(target, number);
            element.classList.add("numbered");
        }
        katex.render(source.trim().replace(/^\\[(\[]|\\[)\]]$/g, ""), target,
            {displayMode: element.tagName === "DIV", throwOnError: false});
    });
});

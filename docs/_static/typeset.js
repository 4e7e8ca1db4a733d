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

    // A formula that is wider than the page is made smaller, down to half its size; what is wider still scrolls.
    function fit() {
        document.querySelectorAll(".katex-display").forEach(function (formula) {
            formula.style.fontSize = "";
            var size = formula.clientWidth / formula.scrollWidth;
            if (size < 1) formula.style.fontSize = Math.max(0.5, 0.98 * size) + "em";
        });
    }
    fit();
    document.fonts.addEventListener("loadingdone", fit);
    window.addEventListener("resize", fit);
});

// How high a result of Sphinx's search stands: pages by their titles and words, and above them the functions that are looked for.
var Scorer = {
    objNameMatch: 11,
    objPartialMatch: 6,
    objPrio: {0: 15, 1: 5, 2: -5},
    objPrioDefault: 0,
    title: 15,
    partialTitle: 7,
    term: 5,
    partialTerm: 2,

    // A page whose title is the query has 100. A function with this name, by any prefix, has more, and so has a term of the glossary.
    // A function with all words of the query in its name has less than 100, but more than any other page: the shorter the name the more.
    score: function (result) {
        var title = result[1], kind = /^(C\+\+|C|Python|Fortran|glossary) (function|class|method|term)/.exec(result[3] || "");
        if (!kind) return result[4];
        var plain = function (name) { return name.toLowerCase().replace(/^(pw85_|pypw85\.|pw85::)/, "").split(/[\s_.:]+/); };
        var query = plain(new URLSearchParams(location.search).get("q").trim()), words = plain(title);
        var first = {C: 0.3, Python: 0.2, "C++": 0.1}[kind[1]] || 0;
        if (query.join() === words.join()) return kind[2] === "term" ? 150 : 200 + first;
        if (query.every(function (word) { return words.includes(word); })) return 99 - words.length + first;
        return result[4];
    }
};

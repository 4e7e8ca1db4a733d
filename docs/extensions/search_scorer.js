// How high a result of Sphinx's search stands: pages by their titles and words, above them the functions that are looked for, and first
// of all the chapter for its own word.
var Scorer = {
    objNameMatch: 11,
    objPartialMatch: 6,
    objPrio: {0: 15, 1: 5, 2: -5},
    objPrioDefault: 0,
    title: 15,
    partialTitle: 7,
    term: 5,
    partialTerm: 2,

    asked: function () { return new URLSearchParams(location.search).get("q").trim().toLowerCase(); },

    // A function with the query as its name without prefix comes behind that chapter, then terms of the glossary. A function with all
    // words of the query in its name has less than 100, but more than any other page: the shorter the name the more.
    score: function (result) {
        var title = result[1], kind = /^(C\+\+|C|Python|Fortran|glossary) (function|class|method|term)/.exec(result[3] || "");
        var asked = Scorer.asked();
        if (!kind) return Scorer.scorePlace(result, asked);
        var query = SearchRows.words(asked), words = SearchRows.words(title);
        var first = {C: 0.3, Python: 0.2, "C++": 0.1}[kind[1]] || 0;
        if (query.join() === words.join()) return kind[2] === "term" ? 150 : (/^py|^pw85/.test(asked) ? 300 : 200) + first;
        if (query.every(function (word) { return words.includes(word); })) return 99 - words.length + first;
        return result[4];
    },

    // Sphinx gives 100 where the title of a chapter or of a section, or an entry of the index, is the query. A chapter has the most, a
    // section less than functions and terms. Chapters have no entries that are their titles, which would be a second row.
    scorePlace: function (result, asked) {
        if (result[3] !== null || result[4] !== 100) return result[4];
        return result[2].startsWith("#index-") || result[1].toLowerCase() === asked ? 250 : 140;
    }
};

// One row for a function that several languages have by the same name: that of C, with links to the others.
var SearchRows = {
    languages: ["C", "Python", "C++", "Fortran"],

    plain: function (name) { return name.toLowerCase().replace(/^(pw85_|pypw85\.|pw85::)/, ""); },

    words: function (name) { return SearchRows.plain(name).split(/[\s_.:]+/); },

    // The language of a result that is a function or a subroutine, if it is one.
    language: function (result) { return (/^(C\+\+|C|Python|Fortran) (function|subroutine)/.exec(result[3] || "") || [])[1]; },

    join: function (results) {
        var rows = new Map();
        results.forEach(function (result) {
            var key = SearchRows.language(result) ? SearchRows.plain(result[1]) : result;
            rows.set(key, (rows.get(key) || []).concat([result]));
        });
        return Array.from(rows.values(), SearchRows.row);
    },

    row: function (same) {
        if (same.length === 1) return same[0];
        var rank = function (result) { return SearchRows.languages.indexOf(SearchRows.language(result)); };
        var [row, ...others] = same.slice().sort(function (a, b) { return rank(a) - rank(b); });
        var links = new Map(others.map(function (other) {
            return [SearchRows.language(other), '<a href="' + other[0] + ".html" + other[2] + '">' + SearchRows.language(other) + "</a>"];
        }));
        links.delete(SearchRows.language(row));
        var joined = row.slice();
        if (links.size) joined[3] = SearchRows.language(row) + " function, also in " + Array.from(links.values()).join(", ");
        return joined;
    }
};

// Sphinx runs this file before it searches.
if (typeof Search !== "undefined" && Search.performObjectSearch) {
    var performObjectSearchOfSphinx = Search.performObjectSearch;
    Search.performObjectSearch = function () { return SearchRows.join(performObjectSearchOfSphinx.apply(Search, arguments)); };
}

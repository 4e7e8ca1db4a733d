// The functions of the C API, from the headers themselves: a test that is to know all of them cannot miss a new one.
#ifndef PW85_TESTS_DECLARATIONS_HPP_INCLUDED
#define PW85_TESTS_DECLARATIONS_HPP_INCLUDED

#include <set>
#include <string>

#include <glib.h>

namespace pw85_tests {

/// The functions that a header in the folder PW85_INCLUDE declares.
inline std::set<std::string> declared_in(std::string const &header)
{
    gchar *text = nullptr;
    g_assert_true(g_file_get_contents((PW85_INCLUDE "/" + header).c_str(), &text, nullptr, nullptr));
    GRegex *const declaration = g_regex_new("PW85_API[^;(]*\\b(pw85_\\w+)\\(", GRegexCompileFlags{}, {}, nullptr);
    GMatchInfo *match = nullptr;
    std::set<std::string> names;
    for (g_regex_match(declaration, text, {}, &match); g_match_info_matches(match); g_match_info_next(match, nullptr)) {
        gchar *const name = g_match_info_fetch(match, 1);
        names.insert(name);
        g_free(name);
    }
    g_match_info_free(match);
    g_regex_unref(declaration);
    g_free(text);
    return names;
}

} // namespace pw85_tests

#endif

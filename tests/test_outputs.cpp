// Every function of the libraries writes the outputs of its contract and nothing else, and returns the right status. It is called
// with valid arguments, and with NaN and null pointers in the place of each argument.
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <glib.h>

#include "calls.hpp"
#include "failures.hpp"

using namespace pw85_tests;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Three pairs: apart, overlapping, and of unlike sizes.
std::vector<Sample<double, 3>> const pairs = {
    {{3.0, 2.5, 2.0}, {2.0, 0.0, 0.0, 2.0, 0.0, 3.0}, {2.0, 0.0, 0.0, 2.0, 0.5, 3.0}},
    {{1.5, 0.5, 0.25}, {4.0, 0.5, 0.0, 3.0, 0.0, 2.0}, {1.0, 0.0, 0.25, 2.0, 0.0, 1.0}},
    {{1.0, 1.0, 1.0}, {0.25, 0.0, 0.0, 0.25, 0.0, 0.25}, {4.0, 0.0, 0.0, 2.0, 0.0, 3.0}}};

/// Whether name is one of some names.
bool is_one_of(std::string const &name, std::initializer_list<char const *> names)
{
    return std::any_of(names.begin(), names.end(), [&](char const *other) { return name == other; });
}

/// Whether an element of an output says that there is no result.
bool is_marked(Call &call, std::size_t k, std::size_t i)
{
    switch (call.parameter(k).type) {
    case Type::real:
        return std::isnan(call.elements<double>(k)[i]);
    case Type::byte:
        return call.elements<unsigned char>(k)[i] == 255;
    case Type::integer:
        return call.elements<int>(k)[i] == -1;
    case Type::int32:
        return call.elements<std::int32_t>(k)[i] == std::numeric_limits<std::int32_t>::min();
    case Type::handle:
        return *call.elements<pw85_neighbors *>(k) == nullptr;
    default:
        return true; // the index of a bad particle
    }
}

/// Whether the first row of each output is marked. Events and forces belong to particles, and bad pairs are none of theirs.
bool first_rows_marked(Call &call)
{
    bool marked = true;
    for (std::size_t k = 0; k < call.size(); ++k) {
        bool const of_particles =
            is_one_of(call.parameter(k).name, {"next", "next_pair", "forces", "torques", "virial"});
        if (!call.parameter(k).output || of_particles || call[k].pointer == nullptr) continue;
        for (std::size_t i = 0; i < call.row_length(k); ++i) marked = marked && is_marked(call, k, i);
    }
    return marked;
}

bool guards_intact(Call &call)
{
    bool intact = true;
    for (std::size_t k = 0; k < call.size(); ++k)
        intact = intact && (!call.parameter(k).output || call.guards_intact(k));
    return intact;
}

/// A status is what it should be, and nothing was written where it should not be.
void expect(Failures &failures, Call &call, std::string const &what, int expected)
{
    Answer const answer = call();
    auto const text = [&] { return what + ": " + call.text(); };
    bool const has_status = call.function().result == Result::status;
    failures.check(!has_status || answer.status == expected, "status", answer.status, expected, text);
    failures.check(guards_intact(call), "guards", 0.0, 1.0, text);
}

void test_valid()
{
    Failures failures;
    for (Function const &function : declared_functions()) {
        Call call(function, pairs);
        expect(failures, call, "valid", PW85_SUCCESS);
        for (std::size_t k = 0; k < call.size(); ++k)
            failures.check(!call.parameter(k).output || call.all_written(k), "all written", 0.0, 1.0,
                           [&] { return std::string(call.parameter(k).name) + " of " + call.text(); });
    }
    g_assert_cmpint(failures.checked(), >, 100);
}

// Sums of forces, polynomials and factors of a matrix are NaN where a number that goes into them is.
bool may_be_nan(Call const &call)
{
    std::string const name = call.function().name;
    return is_one_of(name, {"pw85_contact_forces_pairs", "pw85__cholesky_solve"}) ||
           name.find("legacy__") != std::string::npos;
}

void test_nan()
{
    Failures failures;
    for (Function const &function : declared_functions()) {
        for (std::size_t k = 0; k < function.parameters.size(); ++k) {
            Call call(function, pairs);
            Parameter const &p = call.parameter(k);
            if (p.output || may_be_nan(call) || !(p.type == Type::real || p.type == Type::motion)) continue;
            if (p.pointer)
                call.elements<double>(k)[0] = nan; // of a motion it is a coordinate of the velocity
            else
                call[k].real = nan;
            expect(failures, call, std::string("NaN in ") + p.name, PW85_EINVAL);
            bool const before_all = p.shape.empty() || p.shape[0].parameter < 0; // and so before anything is written
            bool const has_rows = function.parameters[0].type == Type::size;
            if (!(before_all && has_rows))
                failures.check(first_rows_marked(call), "outputs marked", 0.0, 1.0,
                               [&] { return std::string("NaN in ") + p.name + ": " + call.text(); });
        }
    }
}

void test_null()
{
    Failures failures;
    for (Function const &function : declared_functions()) {
        for (std::size_t k = 0; k < function.parameters.size(); ++k) {
            Parameter const &p = function.parameters[k];
            if (!p.pointer || p.nullable) continue;
            Call call(function, pairs);
            call[k].pointer = nullptr;
            expect(failures, call, std::string("null for ") + p.name, PW85_EINVAL);
        }
    }
}

// All that may be null is, and each of them: `images` go with a cell, `next_pair` with `next`, derivatives with the outputs that
// need them, and a cell with a list that was made with one.
void test_optional()
{
    Failures failures;
    for (Function const &function : declared_functions()) {
        Call none(function, pairs);
        for (std::size_t k = 0; k < none.size(); ++k)
            if (none.parameter(k).nullable) none[k].pointer = nullptr;
        expect(failures, none, "all null that may be", PW85_SUCCESS);
        for (std::size_t k = 0; k < function.parameters.size(); ++k) {
            Parameter const &p = function.parameters[k];
            if (!p.nullable) continue;
            bool const is_derivative = !p.output && std::string(p.name).rfind("d_", 0) == 0;
            Call call(function, pairs);
            call[k].pointer = nullptr;
            for (std::size_t j = 0; j < call.size(); ++j)
                if ((is_one_of(p.name, {"cell"}) && is_one_of(call.parameter(j).name, {"images"})) ||
                    (is_one_of(p.name, {"next"}) && is_one_of(call.parameter(j).name, {"next_pair"})))
                    call[j].pointer = nullptr;
            expect(failures, call, std::string("null for ") + p.name, is_derivative ? PW85_EINVAL : PW85_SUCCESS);
        }
    }
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    g_test_add_func("/outputs/valid", test_valid);
    g_test_add_func("/outputs/nan", test_nan);
    g_test_add_func("/outputs/null", test_null);
    g_test_add_func("/outputs/optional", test_optional);
    return g_test_run();
}

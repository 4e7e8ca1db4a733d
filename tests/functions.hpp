// SPDX-License-Identifier: BSD-3-Clause
// All functions of the C API with their parameters. api/tables.py reads them from the headers, so
// that a new function needs no entry in a table. The table is compiled once, in functions.cpp.
#ifndef PW85_TESTS_FUNCTIONS_HPP_INCLUDED
#define PW85_TESTS_FUNCTIONS_HPP_INCLUDED

#include <cstddef>
#include <vector>

namespace pw85_tests {

enum class Type { real, size, integer, int32, int64, byte, motion, handle };
enum class Result { none, status, real, other };

/// Instead of a number: the extent is that of a packed symmetric matrix with as many rows as the
/// other parameter says.
constexpr std::size_t packed = static_cast<std::size_t>(-1);

/// A number, or the value of another parameter.
struct Extent {
    int parameter; ///< -1 for a number
    std::size_t number;
};

struct Parameter {
    char const *name;
    Type type;
    int length, time; ///< the powers in its unit
    bool mixed_units; ///< its numbers have several units
    bool pointer, output, nullable;
    std::vector<Extent> shape;
};

/// What is passed for a parameter: the member of its type.
struct Argument {
    double real;
    std::size_t size;
    int integer;
    void *pointer;
};

struct Answer {
    int status;
    double real;
};

struct Function {
    char const *name;
    Result result;
    std::vector<Parameter> parameters;
    Answer (*call)(Argument const *);
};

std::vector<Function> const &declared_functions();

} // namespace pw85_tests

#endif

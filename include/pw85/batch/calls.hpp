// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Calls functions of the C API with spans. The functions here compare the sizes of spans, and
/// convert rows to pointers to their numbers. rows.hpp, the headers of systems/ and the Python
/// module call them.
#ifndef PW85_BATCH_CALLS_HPP_INCLUDED
#define PW85_BATCH_CALLS_HPP_INCLUDED

#include <pw85.h>

#include <cstddef>

#include <pw85/batch/values.hpp>

namespace pw85::detail {

/// The type of the numbers in C of which a row consists.
template <class Row> struct ElementOf {
    static_assert(sizeof(Row) % sizeof(double) == 0);
    using Type = double;
};
template <> struct ElementOf<unsigned char> {
    using Type = unsigned char;
};
template <> struct ElementOf<int> {
    using Type = int;
};
template <> struct ElementOf<Motion<double, 3>> {
    static_assert(sizeof(Motion<double, 3>) == sizeof(pw85_motion));
    using Type = pw85_motion;
};

static_assert(sizeof(Vector<double, 2>) == 2 * sizeof(double));
static_assert(sizeof(SymmetricMatrix<double, 2>) == 3 * sizeof(double));
static_assert(sizeof(Vector<double, 3>) == 3 * sizeof(double));
static_assert(sizeof(SymmetricMatrix<double, 3>) == 6 * sizeof(double));
static_assert(sizeof(Vector<double, 4>) == 4 * sizeof(double));

/// Returns whether an array has n rows, or is left out.
template <class Row> static bool fits(std::size_t n, std::span<Row> rows) noexcept
{
    return rows.empty() || rows.size() == n;
}

/// An input that may be left out.
template <class Row> struct Optional {
    std::span<Row const> rows;
};

template <class Row> static Optional<Row> optional(std::span<Row const> input) noexcept
{
    return {input};
}

// Arguments of functions of n rows. Inputs have n rows. Outputs have n rows or none; those without
// rows are null in C.

template <class Row> static bool has_rows(std::size_t n, std::span<Row const> input) noexcept
{
    return input.size() == n;
}

template <class Row> static bool has_rows(std::size_t n, std::span<Row> output) noexcept
{
    return fits(n, output);
}

template <class Row> static bool has_rows(std::size_t n, Optional<Row> input) noexcept
{
    return fits(n, input.rows);
}

static inline bool has_rows(std::size_t, double) noexcept { return true; }

static inline bool has_rows(std::size_t, int) noexcept { return true; }

template <class... Arguments> static bool have_rows(std::size_t n, Arguments... all) noexcept
{
    return (has_rows(n, all) && ...);
}

template <class Row> static auto in_c(std::span<Row const> input) noexcept
{
    return reinterpret_cast<typename ElementOf<Row>::Type const *>(input.data());
}

template <class Row> static auto in_c(std::span<Row> output) noexcept
{
    return output.empty() ? nullptr
                          : reinterpret_cast<typename ElementOf<Row>::Type *>(output.data());
}

static inline double in_c(double number) noexcept { return number; }

static inline int in_c(int number) noexcept { return number; }

/// Calls a function of rows if all arguments have as many rows as the first one.
template <class Function, class First, class... Rest>
static StatusCode call_rows(Function const &function, First first, Rest... rest) noexcept
{
    std::size_t const n = first.size();
    if (!have_rows(n, rest...)) return StatusCode::invalid_argument;
    return static_cast<StatusCode>(function(n, in_c(first), in_c(rest)...));
}

} // namespace pw85::detail

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Calls a function of one row for each row of arrays, in parallel. The files c_api/*_rows.cpp and
/// lists.cpp use it for functions without lanes.
#ifndef PW85_ROWS_EACH_ROW_HPP_INCLUDED
#define PW85_ROWS_EACH_ROW_HPP_INCLUDED

#include <pw85/status.hpp>

#include "../base/last_error.hpp"
#include "../base/parallel.hpp"
#include "../simd/pairs.hpp"

namespace pw85::detail::kernels {
namespace {

/// Calls row(i), which returns a status, for a range of rows, and returns the first failure.
template <class Row> Failure for_rows(Range range, Row const &row) noexcept
{
    Failure first{0, 0};
    for (std::size_t i = range.begin; i < range.end; ++i)
        first.update(Failure{i, static_cast<int>(row(i))});
    return first;
}

/// Records the first failure; see refuse_first(). It is apart, because its stack would be that of
/// each caller.
template <class Record>
[[gnu::cold, gnu::noinline]] int record_first(Failure const &first, Record const &record) noexcept
{
    refuse(first.status,
           {0, "a function of many rows", nullptr, pw85_strerror(first.status), 0, 0, 0.0});
    in_default_environment([&] { return static_cast<int>(record(first.index)); });
    return refuse_row(first.status, first.index);
}

/// Returns the status of the first failure. record(i) records the cause for row i: it is a call of
/// a function of one row in the caller's thread, since the threads of a loop have records of their
/// own.
template <class Record>
[[gnu::always_inline]] inline int refuse_first(Failure const &first, Record const &record) noexcept
{
    return first.status == 0 ? 0 : record_first(first, record);
}

// The arguments of functions of many rows. row(i) is the argument of the function of one row for
// row i.

/// An array with `columns` elements in each row.
template <int columns, class T = double const> struct RowsOf {
    static constexpr int width = columns;
    T *first;
    bool is_missing() const noexcept { return first == nullptr; }
    T *row(std::size_t i) const noexcept { return row_of(first, columns, i); }
};

/// An output that may be null.
template <int columns> struct OptionalRowsOf {
    static constexpr int width = columns;
    double *first;
    bool is_missing() const noexcept { return false; }
    double *row(std::size_t i) const noexcept { return row_or_null(first, columns, i); }
};

/// Numbers that are passed by value.
struct Numbers {
    static constexpr int width = 1;
    double const *first;
    bool is_missing() const noexcept { return first == nullptr; }
    double row(std::size_t i) const noexcept { return first[i]; }
};

/// Answers of the function of one row, an int each, as bytes: 255 for -1.
struct Bytes {
    static constexpr int width = 1;
    unsigned char *first;

    /// Takes the answer of a row, and stores it at the end of the call.
    struct Answer {
        unsigned char *byte;
        int answer = -1;
        operator int *() noexcept { return &answer; }
        ~Answer() { *byte = static_cast<unsigned char>(answer); }
    };

    bool is_missing() const noexcept { return first == nullptr; }
    Answer row(std::size_t i) const noexcept { return {first + i}; }
};

/// Two outputs, of which each may be null, for the two numbers that the function of one row writes
/// to one array.
struct TwoNumbers {
    static constexpr int width = 1;
    double *first, *second;

    /// Takes the numbers of a row, and stores them at the end of the call.
    struct Pair {
        double *first, *second;
        double numbers[2];
        operator double *() noexcept { return numbers; }
        ~Pair()
        {
            if (first != nullptr) *first = numbers[0];
            if (second != nullptr) *second = numbers[1];
        }
    };

    bool is_missing() const noexcept { return false; }
    Pair row(std::size_t i) const noexcept
    {
        return {row_or_null(first, 1, i), row_or_null(second, 1, i), {}};
    }
};

/// A number for all rows.
template <class Number> struct SameNumber {
    static constexpr int width = 0;
    Number number;
    bool is_missing() const noexcept { return false; }
    Number row(std::size_t) const noexcept { return number; }
};
template <class Number> SameNumber(Number) -> SameNumber<Number>;

/// Rows per block of a thread. Without lanes, most functions take between a hundred nanoseconds and
/// a few microseconds per row.
constexpr std::size_t block_of_calls = 256;

/// Records the first array that is missing, or else that there are too many rows. names[0] is the
/// name of the function, behind which those of the arguments are. It is not inlined, because its
/// stack would be that of each caller.
[[gnu::cold, gnu::noinline]] inline int refuse_rows(char const *const *names, std::size_t n,
                                                    bool const *missing, std::size_t count) noexcept
{
    std::size_t k = 0;
    while (k < count && !missing[k]) ++k;
    if (k == count) return refuse_arrays(names[0], "n", n);
    return refuse_arrays(names[0], "n", n, NamedArray{names[k + 1], nullptr});
}

template <class... Missing> [[gnu::cold]] int refuse_rows(char const *const *names, std::size_t n,
                                                          Missing... are_missing) noexcept
{
    bool const missing[] = {are_missing...};
    return refuse_rows(names, n, missing, sizeof...(are_missing));
}

/// Returns the largest of some numbers.
consteval std::size_t largest_of(auto... numbers) noexcept
{
    std::size_t largest = 0;
    ((largest = maximum<std::size_t>(largest, numbers)), ...);
    return largest;
}

/// Calls a function of one row for n rows, in parallel, and returns the status of the first bad
/// one. The names are those of refuse_rows().
template <class Function, class... Arguments>
int each_row(char const *const (&names)[sizeof...(Arguments) + 1], std::size_t n,
             Function const &function, Arguments... arguments) noexcept
{
    constexpr std::size_t widest = largest_of(6u, std::size_t{Arguments::width}...);
    if (n == 0) return static_cast<int>(Status::success);
    if (n > PTRDIFF_MAX / (widest * sizeof(double)) || (arguments.is_missing() || ...))
        return refuse_rows(names, n, arguments.is_missing()...);
    auto const call = [&](std::size_t i) { return function(arguments.row(i)...); };
    return refuse_first(for_blocks(
                            n, [&](Range range) { return for_rows(range, call); }, block_of_calls),
                        call);
}

} // namespace
} // namespace pw85::detail::kernels

#endif

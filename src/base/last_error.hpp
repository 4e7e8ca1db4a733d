// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Records the cause of a refusal for pw85_last_error(): one record for each thread. Nothing here
/// runs before a call has failed.
#ifndef PW85_BASE_LAST_ERROR_HPP_INCLUDED
#define PW85_BASE_LAST_ERROR_HPP_INCLUDED

#include <cstddef>
#include <cstdint>
#include <limits>

#include <pw85.h>

/// An attribute of function objects that record a refusal. If they are not inlined, each call
/// stores what they capture: 3 % of the time of an overlap.
#define PW85_IN_COLD_PATH __attribute__((always_inline))

namespace pw85::detail {

/// Requirements in the brackets of a parameter's declaration. Numbers must be finite unless the
/// brackets say otherwise.
namespace limit {
enum Limit : unsigned {
    positive = 1,
    from_zero = 1 << 1,
    not_zero = 1 << 2,
    unit_interval = 1 << 3,
    below_next = 1 << 4, ///< lower <= upper, the next argument
    until_t_max = 1 << 5,
    finite_square = 1 << 6,
    definite = 1 << 7,
    rotation = 1 << 8,
    independent = 1 << 9,       ///< the columns of a factor
    rows_not_zero = 1 << 13,    ///< vectors of three numbers
    independent_rows = 1 << 12, ///< of a cell, if nothing else is wrong
    may_be_infinite = 1 << 10,
    may_be_nan = 1 << 11,
    optional = 1 << 14, ///< the pointer may be null
    at_most_one = 1 << 15,
};
} // namespace limit

// Tests of the bits of numbers, which do not depend on the caller's floating-point environment.

constexpr std::int64_t bits_of_infinity = 0x7ff0000000000000;

[[gnu::always_inline]] inline std::int64_t bits_of(double x) noexcept
{
    return __builtin_bit_cast(std::int64_t, x);
}

[[gnu::always_inline]] inline bool is_zero(double x) noexcept { return bits_of(x) << 1 == 0; }

[[gnu::always_inline]] inline bool is_finite(double x) noexcept
{
    return (bits_of(x) & bits_of_infinity) != bits_of_infinity;
}

[[gnu::always_inline]] inline bool is_nan(double x) noexcept
{
    return (bits_of(x) & INT64_MAX) > bits_of_infinity;
}

/// Returns whether a number that is not NaN is within the ranges that these limits name. (A
/// negative number has negative bits.)
[[gnu::always_inline]] inline bool is_within(double x, unsigned limits) noexcept
{
    bool const is_from_zero = bits_of(x) >= 0 || is_zero(x), is_to_one = bits_of(x) <= bits_of(1.0);
    return (!(limits & limit::positive) || (bits_of(x) > 0 && !is_zero(x))) &&
           (!(limits & limit::from_zero) || is_from_zero) &&
           (!(limits & limit::unit_interval) || (is_from_zero && is_to_one)) &&
           (!(limits & limit::at_most_one) || is_to_one);
}

/// An argument of a call. An output that must not be null has no numbers, nor has an array of
/// another type than double.
struct Argument {
    char const *name;
    void const *pointer;
    std::size_t count = 0;
    std::size_t columns = 0; ///< the numbers of a row; 0 for an array of one row
    double number = 0.0;     ///< passed by value, if `pointer` is null and `is_number` is set
    unsigned limits = 0;
    bool is_number = false;

    [[gnu::always_inline]] Argument(char const *own, void const *array, std::size_t size = 0,
                                    unsigned allowed = 0) noexcept
        : name(own), pointer(array), count(array == nullptr ? 0 : size), limits(allowed)
    {
    }
    [[gnu::always_inline]] Argument(char const *own, double value, unsigned allowed = 0) noexcept
        : name(own), pointer(nullptr), count(1), number(value), limits(allowed), is_number(true)
    {
    }

    /// Returns an input of many rows, which may be null if there are none.
    [[gnu::always_inline]] static Argument rows(char const *own, double const *array, std::size_t n,
                                                std::size_t columns, unsigned allowed = 0) noexcept
    {
        Argument made(own, array, n * columns, allowed | (n == 0 ? limit::optional : 0u));
        made.columns = columns;
        return made;
    }

    /// Returns an output, or an array of another type than double, which may be null without rows.
    [[gnu::always_inline]] static Argument array(char const *own, void const *array,
                                                 std::size_t n) noexcept
    {
        return Argument(own, array, 0, n == 0 ? limit::optional : 0u);
    }

    bool is_null() const noexcept { return !is_number && pointer == nullptr; }
    double const *numbers() const noexcept
    {
        return is_number ? &number : static_cast<double const *>(pointer);
    }
};

/// Records the first argument that explains the status, and returns the status.
[[gnu::cold]] int refuse(int status, char const *function, Argument const *arguments,
                         std::size_t count) noexcept;

/// Notes why the function of C that works in this thread is to be refused, and returns the status:
/// see refuse_noted(). Functions that do not know by which function they were called use it.
[[gnu::cold]] int note_cause(int status, char const *argument, char const *requirement,
                             std::size_t row = 0, std::size_t entry = 0,
                             double value = std::numeric_limits<double>::quiet_NaN()) noexcept;

/// Records the cause that was noted with this status, or else the first argument that explains the
/// status. Forgets what was noted. Returns the status.
[[gnu::cold]] int refuse_noted(int status, char const *function, Argument const *arguments,
                               std::size_t count) noexcept;

/// An array that must not be null.
struct NamedArray {
    char const *name;
    void const *pointer;
};

/// Records the first of `count` arrays that is null, or else the size, which is too large, and
/// returns PW85_EINVAL.
[[gnu::cold]] int refuse_arrays_or_size(char const *function, char const *name_of_size,
                                        std::size_t size, NamedArray const *arrays,
                                        std::size_t count) noexcept;

/// Records a cause that the caller has found, and returns the status.
[[gnu::cold]] int refuse(int status, pw85_error const &cause) noexcept;

/// Sets the row of the record, and returns the status.
[[gnu::cold]] int refuse_row(int status, std::size_t row) noexcept;

namespace {

/// Calls refused(status) if the status is not success, and returns the status.
template <class Refused>
[[gnu::always_inline]] inline int checked(int status, Refused const &refused) noexcept
{
    if (status != PW85_SUCCESS) [[unlikely]]
        return refused(status);
    return status;
}

/// Records the refusal of a call whose parameters are `arguments`.
template <class... Arguments> [[gnu::cold, gnu::noinline]] int
refuse_call(int status, char const *function, Arguments... arguments) noexcept
{
    Argument const listed[] = {arguments...};
    return refuse(status, function, listed, sizeof...(arguments));
}

/// Records the first of the arrays that is null, or else that there are too many rows: `size`,
/// which is the argument `name_of_size`.
template <class... Arrays>
[[gnu::cold, gnu::noinline]] int refuse_arrays(char const *function, char const *name_of_size,
                                               std::size_t size, Arrays... arrays) noexcept
{
    NamedArray const listed[] = {arrays..., {}};
    return refuse_arrays_or_size(function, name_of_size, size, listed, sizeof...(arrays));
}

} // namespace
} // namespace pw85::detail

#endif

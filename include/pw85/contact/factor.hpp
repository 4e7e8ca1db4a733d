// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The test whether a matrix S is a valid factor of a form Q = S Sᵀ, and the status of a pair of
/// factors. The functions of factors (contact_factored.hpp, geometry_factored.hpp,
/// overlap/overlap_factored.hpp) call it.
#ifndef PW85_CONTACT_FACTOR_HPP_INCLUDED
#define PW85_CONTACT_FACTOR_HPP_INCLUDED

#include <pw85/algebra/factor.hpp>
#include <pw85/contact/scaling.hpp>
#include <pw85/status.hpp>

namespace pw85::detail {

/// The determinant of a matrix with these columns.
template <class T> PW85_FUNCTION constexpr T determinant(Vector<T, 2> const (&columns)[2]) noexcept
{
    return cross(columns[0], columns[1])[0];
}

template <class T> PW85_FUNCTION constexpr T determinant(Vector<T, 3> const (&columns)[3]) noexcept
{
    return dot(columns[0], cross(columns[1], columns[2]));
}

/// The smallest volume at which a factor counts as a factor of a positive definite form. It is the
/// volume of the parallelepiped of the columns, each scaled to length one. The computed volume errs
/// by less than 2⁻⁴⁸ in double.
template <class T> PW85_FUNCTION constexpr T least_volume() noexcept
{
    return negative_power_of_two<T>(3 * mantissa_digits<T>() / 4);
}

/// Returns whether the form S Sᵀ is positive definite. This needs three conditions: the columns of
/// S are not zero; their lengths differ by no more than forms allow (definite.hpp); and the columns
/// are linearly independent.
template <class T, int D> PW85_FUNCTION inline bool is_regular(Factor<T, D> const &s) noexcept
{
    T const largest = largest_entry(s);
    if (!(largest > T(0))) return false;
    T const floor = square_root(square_root(square_root(smallest_number<T>())));
    Factor<T, D> const scaled = unit_of(s).to_local(s);
    Vector<T, D> columns[std::size_t(D)];
    for (int j = 0; j < D; ++j) {
        columns[j] = column(scaled, j);
        T const length = magnitude(columns[j]);
        if (!(length > floor)) return false;
        columns[j] = columns[j] / length;
    }
    return absolute(determinant(columns)) > least_volume<T>();
}

/// The smallest product of the squared lengths of the columns for which is_clearly_regular() can be
/// true. If the entries are below unscaled_limit(), the lengths then differ by less than
/// is_regular() allows.
template <class T> PW85_FUNCTION constexpr T least_product_of_squares() noexcept
{
    constexpr int exponent = std::numeric_limits<typename ScalarTraits<T>::Lane>::max_exponent / 16;
    return negative_power_of_two<T>(exponent < 64 ? exponent : 64);
}

/// Returns whether a factor is regular, tested with products only. The entries must be below
/// unscaled_limit(). If the result is false, the factor may still be regular.
template <class T, int D>
PW85_FUNCTION inline bool is_clearly_regular(Factor<T, D> const &s) noexcept
{
    Vector<T, D> columns[std::size_t(D)];
    T product = T(1);
    for (int j = 0; j < D; ++j) {
        columns[j] = column(s, j);
        product = product * dot(columns[j], columns[j]);
    }
    T const volume = determinant(columns);
    T const least = T(2) * least_volume<T>();
    return volume * volume > T(least * least) * product && product > least_product_of_squares<T>();
}

/// The status of a pair of factors. If it is success, `scaled` becomes the pair in range.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline StatusCode
validate_pair(FactoredPair<T, D> const &pair, ScaledPair<T, D, Factor<T, D>> &scaled) noexcept
{
    auto const &[r12, s1, s2, ratio] = pair;
    if (!(is_finite(r12) && is_finite(s1) && is_finite(s2))) return StatusCode::invalid_argument;
    if (!(is_regular(s1) && is_regular(s2))) return StatusCode::not_positive_definite;
    scaled = scale(pair);
    return StatusCode::success;
}

/// Returns whether a pair of factors is valid and in range and has r12 != 0, tested with products
/// only. The result is true for almost all such pairs.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline bool
passes_fast_checks(FactoredPair<T, D> const &pair) noexcept
{
    return is_in_range(sum_of_magnitudes(pair.r12), squared_size(pair.q1), squared_size(pair.q2)) &&
           is_clearly_regular(pair.q1) && is_clearly_regular(pair.q2);
}

} // namespace pw85::detail

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Builders of quadratic forms, and of their factors, from lengths and directions.
#ifndef PW85_CONTACT_FORMS_HPP_INCLUDED
#define PW85_CONTACT_FORMS_HPP_INCLUDED

#include <pw85/algebra/all_nan.hpp>
#include <pw85/algebra/powers_of_two.hpp>
#include <pw85/algebra/sine_cosine.hpp>
#include <pw85/algebra/units.hpp>

namespace pw85 {

/// A quadratic form. It is NaN if the status is not success.
template <class T, int D> struct Form {
    SymmetricMatrix<T, D> q;
    StatusCode status;
};

/// A factor. It is NaN if the status is not success.
template <class T, int D> struct EllipsoidFactor {
    Factor<T, D> s;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// The largest deviation of RᵀR from the identity that counts as rounding. It is that of a rotation
/// in single precision, with some room.
inline constexpr double rotation_tolerance = 1e-6;

/// A form with its status. The entries must be finite and the diagonal positive. These conditions
/// fail if a sum of squares of lengths overflows.
template <class T, int D>
PW85_FUNCTION constexpr Form<T, D> checked_form(SymmetricMatrix<T, D> const &q) noexcept
{
    bool valid = is_finite(q);
    for (int i = 0; i < D; ++i) valid = valid && q(i, i) > T(0);
    return valid ? Form<T, D>{q, StatusCode::success}
                 : all_nan<Form<T, D>>(StatusCode::invalid_argument);
}

/// Returns whether a length is positive and its square is a positive number of `T`. If the square
/// vanishes, the form is singular. The entries of the form show this only if the axis is along x, y
/// or z, so it is tested here.
template <class T> PW85_FUNCTION constexpr bool is_length(T const &x) noexcept
{
    T const square = x * x;
    return x > T(0) && square > T(0) && square <= largest_number<T>();
}

/// S = R diag(semi_axes), a factor of Q = R diag(semi_axes²) Rᵀ. R must be orthogonal.
template <class T, int D> PW85_FUNCTION constexpr Factor<T, D>
factor_of_axes(Vector<T, D> const &semi_axes, T const (&rotation)[std::size_t(D * D)]) noexcept
{
    Factor<T, D> s{};
    for (int i = 0; i < D * D; ++i) s.entries[i] = rotation[i] * semi_axes[i % D];
    return s;
}

/// Q = R diag(semi_axes²) Rᵀ. R must be orthogonal.
template <class T, int D> PW85_FUNCTION constexpr Form<T, D>
form_of_axes(Vector<T, D> const &semi_axes, T const (&rotation)[std::size_t(D * D)]) noexcept
{
    return checked_form(form_of_factor(factor_of_axes(semi_axes, rotation)));
}

/// The rotation matrix (row-major) of a quaternion (w, x, y, z) of squared length `norm2`.
template <class T> struct RotationMatrix {
    T entries[9];
};

template <class T> PW85_FUNCTION constexpr RotationMatrix<T>
rotation_matrix(Vector<T, 4> const &quaternion, T const &norm2) noexcept
{
    auto const [w, x, y, z] = quaternion.coordinates;
    T const two = T(2) / norm2;
    return {{T(1) - two * (y * y + z * z), two * (x * y - w * z), two * (x * z + w * y),
             two * (x * y + w * z), T(1) - two * (x * x + z * z), two * (y * z - w * x),
             two * (x * z - w * y), two * (y * z + w * x), T(1) - two * (x * x + y * y)}};
}

/// Makes the rotation matrix of a quaternion of any length.
template <class T>
PW85_FUNCTION constexpr RotationMatrix<T> rotation_matrix(Vector<T, 4> const &quaternion) noexcept
{
    auto const scaled = quaternion / largest_coordinate(quaternion);
    return rotation_matrix(scaled, dot(scaled, scaled));
}

/// Returns whether lengths and a quaternion describe an ellipsoid.
template <class T> PW85_FUNCTION constexpr bool is_oriented(Vector<T, 3> const &semi_axes,
                                                            Vector<T, 4> const &quaternion) noexcept
{
    bool valid = is_finite(quaternion) && largest_coordinate(quaternion) > T(0);
    for (int i = 0; i < 3; ++i) valid = valid && is_length(semi_axes[i]);
    return valid;
}

/// Returns whether a number is positive, and so far from the limits of the type that squares and
/// their sums are in range.
template <class T> PW85_FUNCTION constexpr bool is_moderate(T const &x) noexcept
{
    constexpr int exponent = std::numeric_limits<typename ScalarTraits<T>::Lane>::max_exponent / 8;
    T const least = negative_power_of_two<T>(exponent < 128 ? exponent : 128);
    return both_true(x > least, x * least < T(1));
}

/// The form of lengths and a quaternion of any magnitudes. The quaternion is multiplied by a power
/// of two. So the form has the bits of that of moderate lengths in another unit.
template <class T> PW85_RARE constexpr Form<T, 3>
form_of_any_axes(Vector<T, 3> const &semi_axes, Vector<T, 4> const &quaternion) noexcept
{
    if (!is_oriented(semi_axes, quaternion))
        return all_nan<Form<T, 3>>(StatusCode::invalid_argument);
    auto const scaled = unit_of(quaternion).to_local(quaternion);
    return checked_form(form_of_factor(
        factor_of_axes(semi_axes, rotation_matrix(scaled, T(dot(scaled, scaled))).entries)));
}

PW85_RARE_TIER_OF(form_of_any_axes, double)

} // namespace pw85::detail

namespace pw85 {

// Q = a² (I - nnᵀ) + c² nnᵀ for the unit vector along n. There is no cancellation for any ratio of
// the lengths. The addition of zero makes 0 of -0.
template <class T>
PW85_FUNCTION constexpr Form<T, 3> spheroid(T const &a, T const &c, Vector<T, 3> n) noexcept
{
    using namespace detail;
    T const largest = largest_coordinate(n);
    if (!is_length(a) || !is_length(c) || !is_finite(n) || !(largest > T(0)))
        return all_nan<Form<T, 3>>(StatusCode::invalid_argument);
    n = n / largest;
    T const norm2 = dot(n, n), a2 = a * a, c2 = c * c;
    SymmetricMatrix<T, 3> q{};
    for (int i = 0; i < 3; ++i) {
        int const j = (i + 1) % 3, k = (i + 2) % 3;
        q(i, i) = (a2 * (n[j] * n[j] + n[k] * n[k]) + c2 * (n[i] * n[i])) / norm2;
        for (int l = i + 1; l < 3; ++l) q(i, l) = (c - a) * (c + a) * (n[i] * n[l] / norm2) + T(0);
    }
    return checked_form(q);
}

template <class T> PW85_FUNCTION constexpr Form<T, 3> ellipsoid(Vector<T, 3> const &semi_axes,
                                                                T const (&rotation)[9]) noexcept
{
    using namespace detail;
    bool valid = true;
    for (int i = 0; i < 3; ++i) {
        valid = valid && is_length(semi_axes[i]);
        for (int j = i; j < 3; ++j) {
            T product = i == j ? T(-1) : T(0);
            for (int k = 0; k < 3; ++k)
                product = product + rotation[3 * k + i] * rotation[3 * k + j];
            valid = valid && absolute(product) <= T(rotation_tolerance);
        }
    }
    return valid ? form_of_axes(semi_axes, rotation)
                 : all_nan<Form<T, 3>>(StatusCode::invalid_argument);
}

template <class T> PW85_FUNCTION constexpr EllipsoidFactor<T, 3>
ellipsoid_factor(Vector<T, 3> const &semi_axes, Vector<T, 4> const &quaternion) noexcept
{
    using namespace detail;
    if (!is_oriented(semi_axes, quaternion))
        return all_nan<EllipsoidFactor<T, 3>>(StatusCode::invalid_argument);
    auto s = factor_of_axes(semi_axes, rotation_matrix(quaternion).entries);
    for (auto &entry : s.entries) entry = entry + T(0); // makes 0 of -0
    return {s, StatusCode::success};
}

// Moderate numbers need no other check, since then the form is finite and its diagonal is positive:
// each row of R is of length one to rounding. The quaternion is not normalised first, which would
// only add rounding errors.
template <class T> PW85_FUNCTION constexpr Form<T, 3>
ellipsoid_quaternion(Vector<T, 3> const &semi_axes, Vector<T, 4> const &quaternion) noexcept
{
    using namespace detail;
    T const norm2 = dot(quaternion, quaternion);
    bool const first = both_true(is_moderate(norm2), is_moderate(semi_axes[0]));
    bool const others = both_true(is_moderate(semi_axes[1]), is_moderate(semi_axes[2]));
    if (!both_true(first, others)) return form_of_any_axes(semi_axes, quaternion);
    return {form_of_factor(factor_of_axes(semi_axes, rotation_matrix(quaternion, norm2).entries)),
            StatusCode::success};
}

template <class T>
PW85_FUNCTION inline Form<T, 2> ellipse(T const &a, T const &b, T const &angle) noexcept
{
    using namespace detail;
    if (!is_length(a) || !is_length(b) || !(angle * T(0) == T(0)))
        return all_nan<Form<T, 2>>(StatusCode::invalid_argument);
    auto const [s, c] = sine_cosine(angle);
    T const rotation[4] = {c, -s, s, c};
    return form_of_axes(Vector<T, 2>{a, b}, rotation);
}

} // namespace pw85

#endif

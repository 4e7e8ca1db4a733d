// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The support of an ellipsoid: its half-width along a direction, and the point of the surface that
/// is farthest along this direction. The distances, the walls and the proof of a penetration depth
/// call support(). The search for a normal and the certificate of a distance call
/// accurate_product().
///
/// The point of the surface that is farthest along n is p = Qn/α, with the half-width α = √(nᵀQn)
/// along n. In plain arithmetic the relative error of α is below 3u X, with X = trace Q |n|²/α². X
/// is at most D times the square of the aspect ratio. n·(Qn) has few correct digits where n is
/// across a long axis, because its terms cancel. accurate_product() removes this cancellation:
///
/// 1. With p digits, Q is the sum of H and a rest L. H is a multiple of some quantum that is at
///    least 2^(k-p-1) trace Q, and the entries of L are at most 2^(k-p) trace Q. Adding 2^k trace Q
///    and subtracting it again gives H. n is split in the same way, by 2^k Σ|n_i|, into h and l.
/// 2. H h is exact if 2k >= p + 3. Its terms are multiples of the product of the quanta,
///    2^(2k-2p-2) trace Q Σ|n_i|, and no partial sum exceeds 2 trace Q Σ|n_i|.
/// 3. The rest, H l + L n, is of size 3·2^(k-p) trace Q Σ|n_i|, and its rounding errors are below
///    2^(k-p+4) u trace Q Σ|n_i|. The sum with H h adds u |Qn|. |n| |Qn| is at most √(trace Q) |n|
///    α, and Σ|n_i| is at most √D |n|. So α errs by less than (1.5 √X + 2^(k-p+5) X) u.
#ifndef PW85_DISTANCE_SUPPORT_HPP_INCLUDED
#define PW85_DISTANCE_SUPPORT_HPP_INCLUDED

#include <pw85/contact/evaluation.hpp>

namespace pw85::detail {

/// The point Qn/α of an ellipsoid that is farthest along n, and the half-width α.
template <class T, int D> struct Support {
    Vector<T, D> point;
    T extent;
};

template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Support<T, D>
support(SymmetricMatrix<T, D> const &q, Vector<T, D> const &n) noexcept
{
    Vector<T, D> const point = product(q, n);
    T const extent = square_root(positive_form(q, n, point));
    return {T(T(1) / extent) * point, extent};
}

/// The unit vector along n, whose square is in the range of T.
template <class T, int D>
[[gnu::always_inline]] PW85_FUNCTION inline Vector<T, D> unit_along(Vector<T, D> const &n) noexcept
{
    return T(T(1) / square_root(dot(n, n))) * n;
}

/// Rounds a number that is at most `size` to a multiple of the quantum of item 1.
template <class T> PW85_FUNCTION constexpr T leading_part(T const &x, T const &size) noexcept
{
    T const shift = T(T(1) / negative_power_of_two<T>((mantissa_digits<T>() + 4) / 2)) * size;
    return (x + shift) - shift;
}

/// Computes Qn by items 1 to 3.
template <class T, int D> PW85_FUNCTION inline Vector<T, D>
accurate_product(SymmetricMatrix<T, D> const &q, Vector<T, D> const &n) noexcept
{
    T const size = trace(q);
    T sum = absolute(n[0]);
    for (int i = 1; i < D; ++i) sum = sum + absolute(n[i]);
    SymmetricMatrix<T, D> high{}, low{};
    Vector<T, D> first{}, rest{};
    for (int i = 0; i < D; ++i) {
        first[i] = leading_part(n[i], sum);
        rest[i] = n[i] - first[i];
        for (int j = i; j < D; ++j) {
            high(i, j) = leading_part(q(i, j), size);
            low(i, j) = q(i, j) - high(i, j);
        }
    }
    return product(high, first) + (product(high, rest) + product(low, n));
}

/// Computes support() from Qn.
template <class T, int D> PW85_FUNCTION inline Support<T, D>
support_from(Vector<T, D> const &product, Vector<T, D> const &n) noexcept
{
    T const extent = square_root(dot(n, product));
    return {T(T(1) / extent) * product, extent};
}

/// The largest X for which α errs by less than 106,496 u if accurate_product() computes Qn. It is
/// 2^32 if the type has enough digits.
template <class T> PW85_FUNCTION constexpr T largest_spread() noexcept
{
    constexpr int digits = mantissa_digits<T>() - (mantissa_digits<T>() + 4) / 2 + 11;
    return T(T(1) / negative_power_of_two<T>(digits < 32 ? digits : 32));
}

/// Computes support() of a valid form of any size. The form is scaled to a unit of its own, in
/// which none of its products underflows to zero.
template <class T, int D> PW85_FUNCTION inline Support<T, D>
support_of_any(SymmetricMatrix<T, D> const &q, Vector<T, D> const &n) noexcept
{
    Unit const unit = unit_of(q);
    Support<T, D> const s = support(unit.to_local(q), n);
    return {unit.to_caller(s.point), unit.to_caller(s.extent)};
}

} // namespace pw85::detail

#endif

/// @file
/// The support of an ellipsoid: how far it reaches in some direction, and where.
///
/// The point of the surface that is farthest along n is p = Qn/α, with the half-width α = √(nᵀQn) along n. In plain arithmetic the
/// relative error of α is below 3u X, with X = trace Q |n|²/α², which is at most D times the square of the aspect ratio: n·(Qn) has
/// few digits where n is across a long axis. accurate_product() removes this cancellation:
///
/// 1. With p digits, Q is the sum of H, a multiple of some quantum at least 2^(k-p-1) trace Q, and of a rest L, whose entries are at
///    most 2^(k-p) trace Q. Adding 2^k trace Q and subtracting it again gives H. n is split in the same way, by 2^k Σ|n_i|, into h
///    and l.
/// 2. H h is exact if 2k >= p + 3: its terms are multiples of the product of the quanta, 2^(2k-2p-2) trace Q Σ|n_i|, and no
///    partial sum exceeds 2 trace Q Σ|n_i|.
/// 3. The rest, H l + L n, is of size 3·2^(k-p) trace Q Σ|n_i|, and its rounding errors are below 2^(k-p+4) u trace Q Σ|n_i|. The sum
///    with H h adds u |Qn|. So α errs by less than (1.5 √X + 2^(k-p+5) X) u, as |n| |Qn| is at most √(trace Q) |n| α, and Σ|n_i| at
///    most √D |n|.
#ifndef PW85_DISTANCE_SUPPORT_HPP_INCLUDED
#define PW85_DISTANCE_SUPPORT_HPP_INCLUDED

#include <pw85/contact/evaluation.hpp>

namespace pw85::detail {

/// The point of an ellipsoid that is farthest along n, Qn/α, and α.
template <class T, int D> struct Support {
    Vector<T, D> point;
    T extent;
};

template <class T, int D>
PW85_FUNCTION inline Support<T, D> support(SymmetricMatrix<T, D> const &q, Vector<T, D> const &n) noexcept
{
    Vector<T, D> const point = product(q, n);
    T const extent = square_root(positive_form(q, n, point));
    return {T(T(1) / extent) * point, extent};
}

/// Rounds a number that is at most `size` to a multiple of the quantum of item 1.
template <class T> PW85_FUNCTION constexpr T leading_part(T const &x, T const &size) noexcept
{
    T const shift = T(T(1) / negative_power_of_two<T>((mantissa_digits<T>() + 4) / 2)) * size;
    return (x + shift) - shift;
}

/// Qn by items 1 to 3.
template <class T, int D>
PW85_FUNCTION inline Vector<T, D> accurate_product(SymmetricMatrix<T, D> const &q, Vector<T, D> const &n) noexcept
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

/// support() from Qn.
template <class T, int D>
PW85_FUNCTION inline Support<T, D> support_from(Vector<T, D> const &product, Vector<T, D> const &n) noexcept
{
    T const extent = square_root(dot(n, product));
    return {T(T(1) / extent) * product, extent};
}

/// The largest X for which α errs by less than 106,496 u if it comes from accurate_product(): 2^32, if digits suffice.
template <class T> PW85_FUNCTION constexpr T largest_spread() noexcept
{
    constexpr int digits = mantissa_digits<T>() - (mantissa_digits<T>() + 4) / 2 + 11;
    return T(T(1) / negative_power_of_two<T>(digits < 32 ? digits : 32));
}

/// support() of a valid form of any size: in a unit of its own none of its products underflows to zero.
template <class T, int D>
PW85_FUNCTION inline Support<T, D> support_of_any(SymmetricMatrix<T, D> const &q, Vector<T, D> const &n) noexcept
{
    int const unit = half_exponent(largest_diagonal(q));
    Support<T, D> const s = support(times_power_of_two(q, -2 * unit), n);
    return {times_power_of_two(s.point, unit), times_power_of_two(s.extent, unit)};
}

} // namespace pw85::detail

#endif

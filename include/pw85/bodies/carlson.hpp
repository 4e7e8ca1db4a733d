// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Carlson's symmetric elliptic integrals R_D: for three numbers, the three integrals in which each
/// of them is the last argument. surface.hpp uses this file.
///
/// R_D(x, y; z) = (3/2) ∫ dt (t+x)^(-1/2) (t+y)^(-1/2) (t+z)^(-3/2) over t > 0. The duplication
/// theorem (B. C. Carlson, Numer. Math. 33, 1, 1979; DLMF 19.26.20, 19.36(i)) maps
///
///     x' = (x + λ)/4, y' = (y + λ)/4, z' = (z + λ)/4,    λ = √(xy) + √(xz) + √(yz),
///     R_D(x, y; z) = R_D(x', y'; z')/4 + 3/(√z (z + λ)).
///
/// The sequences do not depend on which number is the last one, so one loop gives all three
/// integrals. All terms are positive, and nothing cancels. The differences shrink by a factor of
/// four in each step. When all are below ε of the mean, five orders of Taylor's series err by less
/// than 3 ε⁶ (1-ε)^(-3/2) of the integral (Carlson, equation 2.9).
#ifndef PW85_BODIES_CARLSON_HPP_INCLUDED
#define PW85_BODIES_CARLSON_HPP_INCLUDED

#include <pw85/algebra/doubled.hpp>

namespace pw85::detail {

/// The factor of A^(-3/2) in R_D of three numbers near A = (x + y + 3z)/5: Taylor's series in x' =
/// 1 - x/A and y' = 1 - y/A, without its leading 1.
template <class T> PW85_FUNCTION inline T r_d_correction(T const &x, T const &y) noexcept
{
    T const z = T(-(x + y)) / T(3), xy = x * y, zz = z * z;
    T const e2 = xy - T(6) * zz, e3 = (T(3) * xy - T(8) * zz) * z, e4 = T(3) * (xy - zz) * zz,
            e5 = xy * (zz * z);
    return T(-3) * e2 / T(14) + e3 / T(6) + T(9) * e2 * e2 / T(88) - T(3) * e4 / T(22) -
           T(9) * e2 * e3 / T(52) + T(3) * e5 / T(26);
}

/// R_D(x_j, x_k; x_i) for each i. At most one of the numbers may be zero. The integral with this
/// number as the last argument is infinite; the result then has a finite number without meaning for
/// it. `W` has more digits than `T`: the error is below 2^-(d + 9) for the d digits of T, with ε =
/// 2^-((d + 13)/6).
template <class T, class W> PW85_FUNCTION inline Vector<W, 3> carlson_r_d(Vector<W, 3> x) noexcept
{
    int const digits = mantissa_digits<T>();
    T const epsilon = negative_power_of_two<T>((digits + 13 + 5) / 6);
    Vector<W, 3> sums{};
    T weight = T(1); // 4^-n
    // The ratio of two numbers becomes its square root in each of the first steps, and afterwards
    // the differences shrink by four: 64 steps are more than any type needs.
    for (int n = 0; n < 64 + digits; ++n) {
        W const roots[] = {sqrt(x[0]), sqrt(x[1]), sqrt(x[2])};
        W const lambda = roots[0] * roots[1] + roots[0] * roots[2] + roots[1] * roots[2];
        for (int i = 0; i < 3; ++i) {
            if (x[i] > W(0))
                sums[i] = sums[i] + W(W(3) * W(weight)) / W(roots[i] * (x[i] + lambda));
            x[i] = W(0.25) * (x[i] + lambda);
        }
        weight = T(0.25) * weight;
        T const least = minimum(rounded(x[0]), minimum(rounded(x[1]), rounded(x[2])));
        T const most = maximum(rounded(x[0]), maximum(rounded(x[1]), rounded(x[2])));
        if (!(T(most - least) > epsilon * least)) break;
    }
    for (int i = 0; i < 3; ++i) {
        int const j = (i + 1) % 3, k = (i + 2) % 3;
        W const mean = W(x[j] + x[k] + W(3) * x[i]) / W(5);
        T const dx = rounded(W(W(mean - x[j]) / mean)), dy = rounded(W(W(mean - x[k]) / mean));
        W const series = W(1) + W(r_d_correction(dx, dy));
        sums[i] = sums[i] + W(W(weight) * series) / W(mean * sqrt(mean));
    }
    return sums;
}

} // namespace pw85::detail

#endif

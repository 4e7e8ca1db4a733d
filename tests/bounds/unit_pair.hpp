// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// All pairs of ellipsoids, as far as the rounding errors of the formulas in M = Q1 + t Q2 can tell
/// them apart.
///
/// The formulas are homogeneous in the units of each axis, and relative errors do not depend on
/// units. So M has a unit diagonal, and t = 1. Then M = VᵀV with columns v_i of length 1, and r =
/// Vᵀw, so that rᵀM⁻¹r = |w|². A change of the sign of a coordinate changes no magnitude: v_0·v_i
/// >= 0, and w is in a half-space.
#ifndef PW85_TESTS_BOUNDS_UNIT_PAIR_HPP_INCLUDED
#define PW85_TESTS_BOUNDS_UNIT_PAIR_HPP_INCLUDED

#include <cstddef>

#include "affine.hpp"

namespace pw85_bounds {

inline constexpr double pi = 3.14159265358979323846;

/// A range of each of N angles: center ± width.
template <int N> struct Box {
    double center[std::size_t(N)], width[std::size_t(N)];
};

/// x·y.
template <std::size_t D, int N> Affine<N> inner(Affine<N> const (&x)[D], Affine<N> const (&y)[D])
{
    Affine<N> sum = x[0] * y[0];
    for (std::size_t i = 1; i < D; ++i) sum = sum + x[i] * y[i];
    return sum;
}

template <int D, int N> struct UnitPair;

/// In two dimensions: the angle between v_0 and v_1, and that of w if N > 1.
template <int N> struct UnitPair<2, N> {
    using Number = Affine<N>;
    static constexpr double ranges[] = {pi / 2, pi};

    Number v[2][2], w[2];
    Number normals[1][2]; ///< of length 1, normal to w

    explicit UnitPair(Box<N> const &box)
        : v{{1.0, 0.0},
            {Number::cosine(0, box.center[0], box.width[0]),
             Number::sine(0, box.center[0], box.width[0])}}
    {
        if constexpr (N > 1) {
            w[0] = Number::cosine(1, box.center[1], box.width[1]);
            w[1] = Number::sine(1, box.center[1], box.width[1]);
            normals[0][0] = -w[1], normals[0][1] = w[0];
        }
    }

    /// M_ij.
    Number entry(int i, int j) const { return i == j ? Number(1.0) : inner(v[i], v[j]); }

    /// det V, the root of det M.
    Number root_of_determinant() const { return v[1][1]; }

    /// Coordinate i of det(V) V⁻¹w.
    Number scaled_solution(int i) const { return i == 0 ? v[1][1] * w[0] - v[1][0] * w[1] : w[1]; }
};

/// In three dimensions: the angles between v_0 and v_1, v_0 and v_2 and the planes of both, those
/// of w if N > 3.
template <int N> struct UnitPair<3, N> {
    using Number = Affine<N>;
    static constexpr double ranges[] = {pi / 2, pi / 2, pi, pi, pi};

    Number v[3][3], w[3];
    Number normals[2][3]; ///< of length 1, normal to w and to each other

    explicit UnitPair(Box<N> const &box)
    {
        Number c[std::size_t(N)], s[std::size_t(N)];
        for (int k = 0; k < N; ++k) {
            c[k] = Number::cosine(k, box.center[k], box.width[k]);
            s[k] = Number::sine(k, box.center[k], box.width[k]);
        }
        v[0][0] = 1.0;
        v[1][0] = c[0], v[1][1] = s[0];
        v[2][0] = c[1], v[2][1] = s[1] * c[2], v[2][2] = s[1] * s[2];
        if constexpr (N > 3) {
            w[0] = s[3] * c[4], w[1] = s[3] * s[4], w[2] = c[3];
            normals[0][0] = c[3] * c[4], normals[0][1] = c[3] * s[4], normals[0][2] = -s[3];
            normals[1][0] = -s[4], normals[1][1] = c[4], normals[1][2] = 0.0;
        }
    }

    /// M_ij.
    Number entry(int i, int j) const { return i == j ? Number(1.0) : inner(v[i], v[j]); }

    /// det V, the root of det M.
    Number root_of_determinant() const { return v[1][1] * v[2][2]; }

    /// Coordinate i of det(V) V⁻¹w.
    Number scaled_solution(int i) const
    {
        if (i == 0)
            return v[2][2] * (v[1][1] * w[0] - v[1][0] * w[1]) +
                   (v[1][0] * v[2][1] - v[1][1] * v[2][0]) * w[2];
        return i == 1 ? v[2][2] * w[1] - v[2][1] * w[2] : v[1][1] * w[2];
    }
};

} // namespace pw85_bounds

#endif

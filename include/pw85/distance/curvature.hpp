// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The motion of the point of a surface with a given normal when the normal rotates. The
/// derivatives of the distance (distance_derivatives.hpp) and the search for the depth of an
/// overlap (penetration.hpp) call this code.
///
/// The point with the normal n is p = Qn/α, with the half-width α = √(nᵀQn). A = ∂p/∂n = (Q -
/// ppᵀ)/α is positive semidefinite, and its null space is n. Two surfaces with opposite normals
/// along n, whose points differ by d n, satisfy r = p1 + p2 + d n with the points relative to their
/// own centres. If r - p1 - p2 has a part w across n, this normal turns by (A1 + A2 + d I)⁻¹w, to
/// first order.
#ifndef PW85_DISTANCE_CURVATURE_HPP_INCLUDED
#define PW85_DISTANCE_CURVATURE_HPP_INCLUDED

#include <pw85/distance/support.hpp>

namespace pw85::detail {

/// The surface of an ellipsoid at the point with a given normal.
template <class T, int D> struct SurfaceElement {
    Vector<T, D> point;         ///< p, relative to the centre
    SymmetricMatrix<T, D> turn; ///< A
};

/// The element of the ellipsoid of `q`, whose lengths are multiplied by `scale`.
template <class T, int D> PW85_FUNCTION inline SurfaceElement<T, D>
surface_element(SymmetricMatrix<T, D> const &q, T const &scale, Support<T, D> const &s) noexcept
{
    SurfaceElement<T, D> element{scale * s.point, q};
    for (int i = 0; i < D; ++i)
        for (int j = i; j < D; ++j)
            element.turn(i, j) = scale * ((q(i, j) - s.point[i] * s.point[j]) / s.extent);
    return element;
}

template <class T, int D> PW85_FUNCTION inline SurfaceElement<T, D>
surface_element(SymmetricMatrix<T, D> const &q, T const &scale, Vector<T, D> const &n) noexcept
{
    return surface_element(q, scale, support(q, n));
}

/// A1 + A2 + d I. A1 and A2 are zero along n; there the trace of A1 + A2 is added to make the
/// matrix stiff.
template <class T, int D> PW85_FUNCTION inline SymmetricMatrix<T, D>
stiffness_across(SurfaceElement<T, D> const (&elements)[2], T const &distance,
                 Vector<T, D> const &n) noexcept
{
    SymmetricMatrix<T, D> stiffness = blend(elements[0].turn, T(1), elements[1].turn);
    T const along = trace(stiffness);
    for (int i = 0; i < D; ++i) {
        stiffness(i, i) = stiffness(i, i) + distance;
        for (int j = i; j < D; ++j) stiffness(i, j) = stiffness(i, j) + along * n[i] * n[j];
    }
    return stiffness;
}

/// Returns whether a normal is isolated with half of the digits to spare: whether the pivots of
/// stiffness_across() exceed 2^-26 (in double) of its trace. At the minimum of the depth the
/// stiffness is positive semidefinite. If it is singular, other normals have the same depth to
/// second order.
template <class T, int D> PW85_FUNCTION inline bool
is_isolated(SymmetricMatrix<T, D> const &stiffness, Factorization<T, D> const &factors) noexcept
{
    T const least = negative_power_of_two<T>(mantissa_digits<T>() / 2) * trace(stiffness);
    bool isolated = true;
    for (int i = 0; i < D; ++i) isolated = isolated && factors.pivots[i] > least;
    return isolated;
}

/// The component of x perpendicular to the unit vector n.
template <class T, int D>
PW85_FUNCTION constexpr Vector<T, D> project(Vector<T, D> const &x, Vector<T, D> const &n) noexcept
{
    return add_scaled(x, T(-dot(x, n)), n);
}

/// Computes the directions orthogonal to the unit vector n: the columns of the reflection that
/// exchanges n and a unit vector of the axes.
template <class T, int D> PW85_FUNCTION inline void
fill_tangents(Vector<T, D> const &n, Vector<T, D> (&tangents)[std::size_t(D - 1)]) noexcept
{
    int pole = 0;
    for (int i = 1; i < D; ++i)
        if (absolute(n[i]) > absolute(n[pole])) pole = i;
    Vector<T, D> v = n;
    v[pole] = v[pole] + (n[pole] < T(0) ? T(-1) : T(1));
    for (int i = 0, j = 0; j < D; ++j) {
        if (j == pole) continue;
        tangents[i] = (-n[j] / (T(1) + absolute(n[pole]))) * v;
        tangents[i][j] = tangents[i][j] + T(1);
        ++i;
    }
}

} // namespace pw85::detail

#endif

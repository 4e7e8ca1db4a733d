/// @file
/// Contact point, normal and derivatives, from the maximiser λ.
///
/// With n = [(1-λ) Q1 + λ Q2]⁻¹ r12 (envelope theorem: λ may be held fixed, f being stationary there):
///
/// 1. x0 - c1 = (1-λ) Q1 n, x0 - c2 = -λ Q2 n; the common normal is along n.
/// 2. ∂μ²/∂r12 = 2λ(1-λ) n; ∂μ²/∂Q1 = -λ(1-λ)² n nᵀ; ∂μ²/∂Q2 = -λ²(1-λ) n nᵀ.
/// 3. Rotations about the own centres: ∂μ²/∂ω1 = 2λ(1-λ)² n × Q1n, ∂μ²/∂ω2 = 2λ²(1-λ) n × Q2n. Their sum plus r12 × ∂μ²/∂r12
///    vanishes: no net torque.
#ifndef PW85_GEOMETRY_HPP_INCLUDED
#define PW85_GEOMETRY_HPP_INCLUDED

#include <pw85/contact.hpp>

namespace pw85::inline PW85_TARGET {

/// Where and how the ellipsoids, scaled by μ, touch.
template <class T, int D> struct ContactGeometry {
    Vector<T, D> point;  ///< relative to the centre of ellipsoid 1
    Vector<T, D> normal; ///< unit vector, out of ellipsoid 1 and into ellipsoid 2
    Status status;
};

/// Derivatives of μ² with respect to the separation and the stored entries of the forms.
template <class T, int D> struct ContactGradient {
    Vector<T, D> r12;
    SymmetricMatrix<T, D> q1, q2;
    Status status;
};

/// Derivatives of μ² with respect to the rotation vectors of the ellipsoids, each about its own centre.
template <class T> struct ContactTorque {
    Vector<T, 3> rotation1, rotation2;
    Status status;
};

/// M⁻¹ x: by the adjugate where that is as good as rounding allows, else by factorisation.
template <class T, int D>
inline Vector<T, D> solve_blend(SymmetricMatrix<T, D> const &m, Vector<T, D> const &x) noexcept
{
    auto const adj = adjugate(m);
    T const det = determinant(m, adj);
    T diagonal = m(0, 0);
    for (int i = 1; i < D; ++i) diagonal = diagonal * m(i, i);
    if (det > fine_conditioning<T>() * diagonal) return times(T(T(1) / det), product(adj, x));
    return solve(factorize(m, T(unit_roundoff<T>())), x);
}

/// A pair at some λ, by a vector v along n whose size is that of N⁻¹r12 for weights that add up to one: in units of their
/// own the forms may be weighted by numbers far from one.
template <class T, int D> struct Tangency {
    Vector<T, D> v;
    T lambda1, lambda2; ///< 1-λ, λ
    T factor1, factor2; ///< (1-λ) n and λ n are these times v
    T weight1, weight2; ///< (1-λ) Q1 n and λ Q2 n are these times the forms in hand times v
};

/// formula(tangency, q1, q2) for a pair at λ, in units that keep everything in range, and back in the caller's.
template <class Formula, class T, int D>
[[gnu::noinline]] inline auto at_tangency_scaled(Formula formula, Vector<T, D> const &r12,
                                                 SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2,
                                                 T const &lambda1, T const &lambda2) noexcept
{
    ScaledPair<T, D> scaled;
    Status const status = lambda2 >= T(0) && lambda2 <= T(1) ? validate(r12, q1, q2, scaled) : Status::invalid_argument;
    bool const defined = status == Status::success && largest_coordinate(r12) > T(0);
    if (!defined) scaled = {{r12, q1, q2, T(1)}, 0, 0, false};
    T const small = T(1) / scaled.pair.ratio / scaled.pair.ratio;
    auto const &p1 = scaled.swapped ? scaled.pair.q2 : scaled.pair.q1;
    auto const &p2 = scaled.swapped ? scaled.pair.q1 : scaled.pair.q2;
    T const weight1 = lambda1 * (scaled.swapped ? small : T(1)), weight2 = lambda2 * (scaled.swapped ? T(1) : small);
    T const sum = weight1 + weight2;
    Tangency<T, D> at{{}, lambda1, lambda2, lambda1 / sum, lambda2 / sum, weight1 / sum, weight2 / sum};
    if (defined)
        at.v = times(T(scaled.swapped ? -1 : 1), solve_blend(blend(at.weight1, p1, at.weight2, p2), scaled.pair.r12));
    auto result = formula(at, p1, p2);
    if (status != Status::success) invalidate(result, status);
    rescale(result, scaled.length, scaled.form);
    return result;
}

/// formula(tangency, q1, q2) for a pair at λ.
template <class Formula, class T, int D>
inline auto at_tangency(Formula formula, Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                        SymmetricMatrix<T, D> const &q2, T const &lambda) noexcept
{
    // A maximiser that rounds to 1 is that of a pair of very different sizes, not the end.
    T const lambda1 = maximum(T(T(1) - lambda), T(T(0.5) * unit_roundoff<T>()));
    if (lambda >= T(0) && lambda <= T(1) && is_finite(r12) && is_ordinary(r12, q1, q2)) {
        Vector<T, D> const v = solve_blend(blend(lambda1, q1, lambda, q2), r12);
        return formula(Tangency<T, D>{v, lambda1, lambda, lambda1, lambda, lambda1, lambda}, q1, q2);
    }
    return at_tangency_scaled(formula, r12, q1, q2, lambda1, lambda);
}

template <class T, int D> inline void invalidate(ContactGeometry<T, D> &g, Status status) noexcept
{
    for (int i = 0; i < D; ++i) g.point[i] = g.normal[i] = quiet_nan<T>();
    g.status = status;
}

template <class T, int D> inline void rescale(ContactGeometry<T, D> &g, int length, int) noexcept
{
    g.point = times_power_of_two(g.point, length);
}

template <class T, int D>
inline ContactGeometry<T, D> contact_geometry(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                              SymmetricMatrix<T, D> const &q2, T const &lambda) noexcept
{
    return at_tangency(
        [](Tangency<T, D> const &at, SymmetricMatrix<T, D> const &p1, SymmetricMatrix<T, D> const &) {
            T const norm2 = dot(at.v, at.v);
            ContactGeometry<T, D> result{times(at.weight1, product(p1, at.v)),
                                         times(T(T(1) / square_root(norm2)), at.v), Status::success};
            if (!(norm2 > T(0))) invalidate(result, Status::invalid_argument);
            return result;
        },
        r12, q1, q2, lambda);
}

template <class T, int D> inline void invalidate(ContactGradient<T, D> &g, Status status) noexcept
{
    g.r12 = times(quiet_nan<T>(), g.r12);
    g.q1 = times(quiet_nan<T>(), g.q1);
    g.q2 = times(quiet_nan<T>(), g.q2);
    g.status = status;
}

template <class T, int D> inline void rescale(ContactGradient<T, D> &g, int length, int form) noexcept
{
    g.r12 = times_power_of_two(g.r12, length - 2 * form);
    g.q1 = times_power_of_two(g.q1, 2 * (length - 2 * form));
    g.q2 = times_power_of_two(g.q2, 2 * (length - 2 * form));
}

template <class T, int D>
inline ContactGradient<T, D> contact_gradient(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                              SymmetricMatrix<T, D> const &q2, T const &lambda) noexcept
{
    return at_tangency(
        [](Tangency<T, D> const &at, SymmetricMatrix<T, D> const &, SymmetricMatrix<T, D> const &) {
            Vector<T, D> const v1 = times(at.factor1, at.v), v2 = times(at.factor2, at.v);
            return ContactGradient<T, D>{times(T(T(2) * at.lambda2), v1), times(T(-at.lambda2), outer_weights(v1)),
                                         times(T(-at.lambda1), outer_weights(v2)), Status::success};
        },
        r12, q1, q2, lambda);
}

template <class T> inline void invalidate(ContactTorque<T> &t, Status status) noexcept
{
    t.rotation1 = times(quiet_nan<T>(), t.rotation1);
    t.rotation2 = times(quiet_nan<T>(), t.rotation2);
    t.status = status;
}

template <class T> inline void rescale(ContactTorque<T> &t, int length, int form) noexcept
{
    t.rotation1 = times_power_of_two(t.rotation1, 2 * (length - form));
    t.rotation2 = times_power_of_two(t.rotation2, 2 * (length - form));
}

template <class T> inline ContactTorque<T> contact_torque(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
                                                          SymmetricMatrix<T, 3> const &q2, T const &lambda) noexcept
{
    return at_tangency(
        [](Tangency<T, 3> const &at, SymmetricMatrix<T, 3> const &p1, SymmetricMatrix<T, 3> const &p2) {
            Vector<T, 3> const v1 = times(at.factor1, at.v), v2 = times(at.factor2, at.v);
            Vector<T, 3> const arm1 = times(at.weight1, product(p1, at.v)), arm2 = times(at.weight2, product(p2, at.v));
            return ContactTorque<T>{times(T(T(2) * at.lambda2), cross(v1, arm1)),
                                    times(T(T(2) * at.lambda1), cross(v2, arm2)), Status::success};
        },
        r12, q1, q2, lambda);
}

} // namespace pw85::inline PW85_TARGET

#endif

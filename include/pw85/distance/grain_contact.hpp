// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The contact of two grains along their common normal, and the derivatives of its radius.
/// src/simd/lanes/grains.hpp runs the same steps on lanes.
///
/// The overlap along a unit vector n is δ(n) = √(n·Q1n) + √(n·Q2n) - n·r12. The normal is the
/// minimum of δ near a given vector. There the points p1 = Q1n/√(n·Q1n) and r12 - Q2n/√(n·Q2n) are
/// on both surfaces and δ n apart. A motion of a body changes δ only by its explicit dependence on
/// r12, Q1 and Q2, because δ is stationary in n. So the forces and torques of an energy U(δ) are
/// those of the force U′(δ) n between these points, and the energy is conserved.
#ifndef PW85_DISTANCE_GRAIN_CONTACT_HPP_INCLUDED
#define PW85_DISTANCE_GRAIN_CONTACT_HPP_INCLUDED

#include <pw85/distance/hertz.hpp>

namespace pw85 {

/// The contact of two ellipsoids along their common normal.
template <class T> struct GrainContact {
    Vector<T, 3> normal;     ///< unit vector, out of ellipsoid 1
    T depth;                 ///< the least δ near the start
    Vector<T, 3> point;      ///< the middle of both points, relative to the centre of ellipsoid 1
    Vector<T, 2> curvatures; ///< of the gap, the smaller one first
    T radius;                ///< R of Hertz's equations
    StatusCode status;
};

/// Derivatives of the radius, while the normal follows each motion.
template <class T> struct GrainRadiusGradient {
    Vector<T, 3> r12, rotation1, rotation2;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// The surface of an ellipsoid at the point p with the normal of a frame. The radii of curvature
/// are the second derivatives of h = √(n·Qn) on the tangent plane, Q/h - ppᵀ/h (curvature.hpp).
template <class T> struct FacingSurface {
    Support<T, 3> support;
    Vector<T, 2> across; ///< p in the tangent plane
    T reciprocal;        ///< 1/h
    SymmetricMatrix<T, 2> radii;
};

template <class T> PW85_FUNCTION inline Vector<T, 2> in_plane(Vector<T, 3> const &x,
                                                              TangentFrame<T> const &frame) noexcept
{
    return {dot(frame.e1, x), dot(frame.e2, x)};
}

template <class T> PW85_FUNCTION inline Vector<T, 3> in_space(Vector<T, 2> const &x,
                                                              TangentFrame<T> const &frame) noexcept
{
    return add_scaled(x[0] * frame.e1, x[1], frame.e2);
}

/// The frame of a normal that is a unit vector already.
template <class T>
PW85_FUNCTION inline TangentFrame<T> frame_of_unit(Vector<T, 3> const &normal) noexcept
{
    Vector<T, 3> e1, e2;
    complete_basis(normal, e1, e2);
    return {normal, e1, e2};
}

template <class T> [[gnu::always_inline]] PW85_FUNCTION inline FacingSurface<T>
facing_surface(SymmetricMatrix<T, 3> const &q, TangentFrame<T> const &frame) noexcept
{
    Vector<T, 3> const qn = product(q, frame.normal);
    T const extent = square_root(dot(frame.normal, qn)), reciprocal = T(1) / extent;
    Support<T, 3> const s{reciprocal * qn, extent};
    Vector<T, 3> const q1 = product(q, frame.e1), q2 = product(q, frame.e2);
    Vector<T, 2> const p = in_plane(s.point, frame);
    return {s,
            p,
            reciprocal,
            {reciprocal * T(dot(frame.e1, q1) - p[0] * p[0]),
             reciprocal * T(dot(frame.e1, q2) - p[0] * p[1]),
             reciprocal * T(dot(frame.e2, q2) - p[1] * p[1])}};
}

template <class T> PW85_FUNCTION inline T determinant(SymmetricMatrix<T, 2> const &m) noexcept
{
    return m[0] * m[2] - m[1] * m[1];
}

template <class T>
PW85_FUNCTION inline SymmetricMatrix<T, 2> inverse(SymmetricMatrix<T, 2> const &m) noexcept
{
    return T(T(1) / determinant(m)) * adjugate(m);
}

/// The second derivatives of δ on the tangent plane, A1 + A2 - δ.
template <class T> PW85_FUNCTION inline SymmetricMatrix<T, 2>
stiffness(DistancePair<T, 3> const &pair, FacingSurface<T> const &surface1,
          FacingSurface<T> const &surface2, T const &depth) noexcept
{
    return plus_multiple_of_identity(
        blend(pair.scale1, surface1.radii, pair.scale2, surface2.radii), T(-depth));
}

/// Change of a point p and of the radii of curvature A there if the normal turns by x in the
/// tangent plane, to first order: by Ax and -(A (p·x) + Ax pᵀ + p (Ax)ᵀ)/h.
template <class T> struct TurnedSurface {
    Vector<T, 2> move;
    SymmetricMatrix<T, 2> radii; ///< after the turn
};

template <class T> PW85_FUNCTION inline TurnedSurface<T>
turned_surface(FacingSurface<T> const &surface, Vector<T, 2> const &x) noexcept
{
    auto const &a = surface.radii;
    auto const &p = surface.across;
    Vector<T, 2> const move = product(a, x);
    T const along = dot(p, x), factor = -surface.reciprocal;
    return {move,
            {a[0] + factor * T(a[0] * along + T(move[0] + move[0]) * p[0]),
             a[1] + factor * T(a[1] * along + T(move[0] * p[1] + move[1] * p[0])),
             a[2] + factor * T(a[2] * along + T(move[1] + move[1]) * p[1])}};
}

/// Result of a step of Newton's method. Where the step is short, the depth is stationary, and the
/// normal, the points and the curvatures change by their derivatives.
template <class T> struct GrainStep {
    Vector<T, 3> normal;             ///< after the step
    T depth;                         ///< there
    Vector<T, 3> ends;               ///< p1 - p2, both relative to their own centres
    SymmetricMatrix<T, 2> curvature; ///< sum of both second fundamental forms
    T square;                        ///< of the step in radians
    typename ScalarTraits<T>::Mask is_minimum;
};

template <class T> PW85_FUNCTION inline GrainStep<T> grain_step(DistancePair<T, 3> const &pair,
                                                                Vector<T, 3> const &normal) noexcept
{
    auto const frame = frame_of_unit(normal);
    auto const surface1 = facing_surface(pair.q1, frame), surface2 = facing_surface(pair.q2, frame);
    Vector<T, 3> const p1 = pair.scale1 * surface1.support.point,
                       p2 = pair.scale2 * surface2.support.point;
    Vector<T, 3> const slope = (p1 + p2) - pair.r12;
    T const depth = dot(normal, slope);
    auto const m = stiffness(pair, surface1, surface2, depth);
    T const det = determinant(m);
    Vector<T, 2> const gradient = in_plane(slope, frame);
    Vector<T, 2> const x = T(T(-1) / det) * product(adjugate(m), gradient);
    auto const turned1 = turned_surface(surface1, x), turned2 = turned_surface(surface2, x);
    T const square = dot(x, x);
    Vector<T, 2> const move = pair.scale1 * turned1.move - pair.scale2 * turned2.move;
    // The curvatures are in the unit of the smaller ellipsoid: see hertz_facing().
    return {T(T(1) / square_root(T(T(1) + square))) * (normal + in_space(x, frame)),
            depth + T(0.5) * dot(gradient, x),
            (p1 - p2) + in_space(move, frame),
            blend(pair.scale2, inverse(turned1.radii), pair.scale1, inverse(turned2.radii)),
            square,
            m[0] > T(0) && det > T(0)};
}

/// The number of steps after which a search gives up. Most pairs take two steps from the normal of
/// the contact function, and one step from the normal of the previous time step of a simulation.
inline constexpr int max_grain_steps = 30;

/// The iteration converges quadratically. After a step of 2^-22 radians (in double) the error of
/// the normal is some 1e-13. That of the depth, to which the second order of the step is added, is
/// of third order, far below rounding.
template <class T> PW85_FUNCTION constexpr T last_grain_step_squared() noexcept
{
    return negative_power_of_two<T>(2 * (mantissa_digits<T>() / 2 - 4));
}

template <class T>
PW85_FUNCTION inline typename ScalarTraits<T>::Mask is_found(GrainStep<T> const &step) noexcept
{
    return step.is_minimum && step.square <= last_grain_step_squared<T>();
}

/// Takes another step of a search, from the normal of the given step.
template <class T>
PW85_FUNCTION inline typename ScalarTraits<T>::Mask is_too_long(GrainStep<T> const &step) noexcept
{
    return step.is_minimum && step.square > last_grain_step_squared<T>();
}

/// The contact that a step has found, except its radius.
template <class T> PW85_FUNCTION inline GrainContact<T> contact_of(GrainStep<T> const &step,
                                                                   Vector<T, 3> const &r12) noexcept
{
    auto const values = principal_values(step.curvature);
    return {step.normal,
            step.depth,
            T(0.5) * (r12 + step.ends),
            {minimum(values.smaller, values.larger), values.larger},
            T(0),
            StatusCode::success};
}

/// The part of an ellipsoid in the derivatives of R. Let A be its radii of curvature, K = 1/A, and
/// G = -K R_W K, so that R changes by tr(G dA). `weight` is that of K in the sum W.
template <class T> struct RadiusPart {
    FacingSurface<T> surface;
    SymmetricMatrix<T, 2> curvature; ///< K times its weight
    Vector<T, 2> by_normal;          ///< D
    T by_spin;                       ///< S, by a rotation about the normal
};

/// If the normal turns by x, A changes as in turned_surface(). So R changes by D·x with D =
/// -(tr(GA) p + 2 AG p)/h, where GA = -K R_W. A rotation about the normal turns K against R_W, and
/// gives twice the entry (1, 2) of their commutator.
template <class T> PW85_FUNCTION inline void
differentiate(RadiusPart<T> &part, SymmetricMatrix<T, 2> const &by_curvature) noexcept
{
    auto const &k = part.curvature, &w = by_curvature;
    auto const &p = part.surface.across;
    Vector<T, 2> const wkp = product(w, product(k, p));
    part.by_normal = part.surface.reciprocal * (contraction(k, w) * p + T(2) * wkp);
    part.by_spin = T(2) * T(k[1] * T(w[2] - w[0]) + w[1] * T(k[0] - k[2]));
}

/// The derivative by a rotation ω of the ellipsoid, n×(A y - D) + S n - p×y. Here y is the
/// derivative of R with respect to r12, and a fixed normal turns by -ω×n as seen from the
/// ellipsoid.
template <class T>
PW85_FUNCTION inline Vector<T, 3> by_rotation(RadiusPart<T> const &part, T const &scale,
                                              Vector<T, 2> const &y,
                                              TangentFrame<T> const &frame) noexcept
{
    Vector<T, 2> const turn = scale * product(part.surface.radii, y) - part.by_normal;
    return cross(frame.normal, in_space(turn, frame)) + part.by_spin * frame.normal -
           scale * cross(part.surface.support.point, in_space(y, frame));
}

/// The derivatives of R with respect to the sum of curvatures W, as a symmetric matrix. Because R
/// is the largest value of 2 agm(1, k)²/(κ1 + κ2 k²) over k, they are -R/(κ1 + κ2 k²) times 1 and
/// k² along the directions of κ1 and κ2.
template <class T> PW85_FUNCTION inline SymmetricMatrix<T, 2>
radius_by_curvature(SymmetricMatrix<T, 2> const &sum) noexcept
{
    auto const values = principal_values(sum);
    T const smaller = minimum(values.smaller, values.larger), gap = values.larger - smaller;
    auto const h = hertz_ordered(smaller, values.larger);
    T const k2 = h.ellipse[1] / h.ellipse[0];
    T const factor = -h.radius / T(smaller + values.larger * k2);
    // times W - κ1, which is κ2 - κ1 along the direction of κ2
    T const part = gap > T(0) ? T(T(k2 - T(1)) / gap) : T(0);
    return {factor * T(T(1) + part * T(sum[0] - smaller)), factor * T(part * sum[1]),
            factor * T(T(1) + part * T(sum[2] - smaller))};
}

/// Computes grain_radius_gradient() in the units of grain_step(). A change of r12 turns the normal
/// by H⁻¹ times its part across the normal, with the second derivatives H of δ.
template <class T> PW85_FUNCTION inline GrainRadiusGradient<T>
radius_gradient(DistancePair<T, 3> const &pair, TangentFrame<T> const &frame) noexcept
{
    RadiusPart<T> part1{facing_surface(pair.q1, frame), {}, {}, T(0)},
        part2{facing_surface(pair.q2, frame), {}, {}, T(0)};
    T const depth = pair.scale1 * part1.surface.support.extent +
                    pair.scale2 * part2.surface.support.extent - dot(frame.normal, pair.r12);
    auto const h = stiffness(pair, part1.surface, part2.surface, depth);
    if (!(h[0] > T(0) && determinant(h) > T(0)))
        return all_nan<GrainRadiusGradient<T>>(StatusCode::no_convergence);
    part1.curvature = pair.scale2 * inverse(part1.surface.radii);
    part2.curvature = pair.scale1 * inverse(part2.surface.radii);
    auto const by_curvature =
        radius_by_curvature(blend(T(1), part1.curvature, T(1), part2.curvature));
    differentiate(part1, by_curvature);
    differentiate(part2, by_curvature);
    Vector<T, 2> const y = product(inverse(h), part1.by_normal + part2.by_normal);
    return {in_space(y, frame), by_rotation(part1, pair.scale1, y, frame),
            by_rotation(part2, pair.scale2, y, frame), StatusCode::success};
}

} // namespace pw85::detail

namespace pw85 {

template <class T> PW85_FUNCTION inline GrainContact<T>
grain_contact(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
              SymmetricMatrix<T, 3> const &q2, Vector<T, 3> start) noexcept
{
    using namespace detail;
    StatusCode const status = validate_facing(r12, q1, q2, start);
    if (status != StatusCode::success) return all_nan<GrainContact<T>>(status);
    auto const [pair, units] = scale_facing(r12, q1, q2);
    GrainStep<T> step = grain_step(pair, T(T(1) / magnitude(start)) * start);
    for (int i = 1; i < max_grain_steps && is_too_long(step); ++i)
        step = grain_step(pair, step.normal);
    if (!is_found(step)) return all_nan<GrainContact<T>>(StatusCode::no_convergence);
    GrainContact<T> result = contact_of(step, pair.r12);
    result.radius = hertz_radius(result.curvatures[0], result.curvatures[1]);
    Unit const smaller = smaller_unit(units);
    result.depth = units.length.to_caller(result.depth);
    result.point = units.length.to_caller(result.point);
    result.curvatures = smaller.to_caller(result.curvatures, -1);
    result.radius = smaller.to_caller(result.radius);
    return result;
}

template <class T> PW85_FUNCTION inline GrainRadiusGradient<T>
grain_radius_gradient(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
                      SymmetricMatrix<T, 3> const &q2, Vector<T, 3> normal) noexcept
{
    using namespace detail;
    StatusCode const status = validate_facing(r12, q1, q2, normal);
    if (status != StatusCode::success) return all_nan<GrainRadiusGradient<T>>(status);
    auto const [pair, units] = scale_facing(r12, q1, q2);
    auto result = radius_gradient(pair, tangent_frame(normal));
    Unit const smaller = smaller_unit(units);
    result.r12 = (smaller / units.length).to_caller(result.r12);
    result.rotation1 = smaller.to_caller(result.rotation1);
    result.rotation2 = smaller.to_caller(result.rotation2);
    return result;
}

} // namespace pw85

#endif

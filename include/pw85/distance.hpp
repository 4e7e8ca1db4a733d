/// @file
/// The distance of two ellipsoids, and their closest points.
///
/// With α(n) = √(nᵀQ1n), β(n) = √(nᵀQ2n) and r = r12, the distance of ellipsoids that are apart is the largest value over unit
/// vectors n of φ(n) = n·r - α - β, the width of the slab between them that is normal to n. φ is concave in the unit ball.
///
/// 1. For any n, Q1n/α and r - Q2n/β are points of the surfaces; for the vector w from the first to the second n·w = φ(n). So
///    φ(n) <= distance <= |w|, with equality where w = φ n, that is, r = (Q1/α + Q2/β + φ I) n.
/// 2. With u = n/α, t = α/β and s = αφ this is M u = r, M = Q1 + t Q2 + s I, where A = uᵀQ1u = 1 and t²B = t²uᵀQ2u = 1:
///    two equations for t and s. 1/√A and 1/√B are nearly affine in t and s (exactly, where r is an eigenvector of both
///    forms), so that Newton's method on 1/√A = 1 and 1/√B = t converges from afar, at once for spheres.
/// 3. For fixed t, s is the root of 1/√(A + tB) = 1/√(1 + 1/t). The left side is concave in s and increases: Newton's method
///    is monotone from s = 0, and each step divides residual times slope by 4 at least. If there is no root, s = 0 stands
///    for it.
/// 4. Then t is too large if and only if t²B > A. For the dual function g(y) = ½ rᵀ(Q1/y1 + Q2/y2 + I)⁻¹r - ½(y1 + y2) of
///    minimal |w|² under the constraints that the points are in the ellipsoids is concave, its largest value ½ distance² at
///    y = (αφ, βφ), and s in item 3 that of its maximum on the ray y1 = t y2: over the rays these have one maximum, and t²B - A
///    the sign of minus their slope. Where that maximum is at y = 0, f <= 1 at λ = t/(1+t), f being that of the contact
///    function; and A - t²B has the sign of its slope, which leads to where f > 1.
#ifndef PW85_DISTANCE_HPP_INCLUDED
#define PW85_DISTANCE_HPP_INCLUDED

#include <pw85/overlap.hpp>

namespace pw85 {

/// How far the surfaces of two ellipsoids are apart. If they overlap, the distance is zero and the vectors are NaN.
template <class T, int D> struct Distance {
    T distance;
    Vector<T, D> point1, point2; ///< the closest points, relative to the centre of ellipsoid 1
    Vector<T, D> normal; ///< unit vector out of ellipsoid 1 and into ellipsoid 2: the derivative with respect to r12
    Status status;
};

/// Exponents of the units of a DistancePair: the caller's separation is 2^length, form i 4^form_i times the pair's.
struct DistanceUnits {
    int length, form1, form2;
};

/// A pair in units of its own: in the unit of r12 the forms are scale² Q.
template <class T, int D> struct DistancePair {
    Vector<T, D> r12;
    SymmetricMatrix<T, D> q1, q2;
    T scale1, scale2;
};

/// Brings a valid pair that is apart into range.
template <class T, int D>
PW85_FUNCTION inline DistancePair<T, D> scale_distance(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                                       SymmetricMatrix<T, D> const &q2, DistanceUnits &units) noexcept
{
    units = {binary_exponent(largest_coordinate(r12)), half_exponent(largest_diagonal(q1)),
             half_exponent(largest_diagonal(q2))};
    return {times_power_of_two(r12, -units.length), times_power_of_two(q1, -2 * units.form1),
            times_power_of_two(q2, -2 * units.form2), times_power_of_two(T(1), units.form1 - units.length),
            times_power_of_two(T(1), units.form2 - units.length)};
}

/// The unknowns t and s of item 2, or steps in them. In the units of a DistancePair M = scale1 Q1 + t scale2 Q2 + s I.
template <class T> struct Multipliers {
    T ratio, shift;
};

template <class T, int D> PW85_FUNCTION constexpr SymmetricMatrix<T, D> normal_matrix(DistancePair<T, D> const &pair,
                                                                                      Multipliers<T> const &x) noexcept
{
    SymmetricMatrix<T, D> m = blend(pair.scale1, pair.q1, T(x.ratio * pair.scale2), pair.q2);
    for (int i = 0; i < D; ++i) m(i, i) = m(i, i) + x.shift;
    return m;
}

/// What solves with M, by its adjugate: a solution is `scale` times M⁻¹x.
template <class T, int D> struct Adjugate {
    SymmetricMatrix<T, D> entries;
    T scale; ///< det M
};

template <class T, int D>
PW85_FUNCTION constexpr Vector<T, D> solve(Adjugate<T, D> const &a, Vector<T, D> const &x) noexcept
{
    return product(a.entries, x);
}

template <class T, int D> PW85_FUNCTION constexpr T scale_of(Adjugate<T, D> const &a) noexcept { return a.scale; }
template <class T, int D> PW85_FUNCTION constexpr T scale_of(Factorization<T, D> const &) noexcept { return T(1); }

/// u with A and B, and their derivatives in t and s; all with `scale` M⁻¹ in the place of M⁻¹.
template <class T, int D> struct NormalJet {
    T scale;
    Vector<T, D> u, u_ratio, u_shift; ///< u, -∂u/∂t, -∂u/∂s
    T a, a_ratio, a_shift;            ///< A, -½ ∂A/∂t, -½ ∂A/∂s
    T b, b_ratio, b_shift;            ///< B, -½ ∂B/∂t, -½ ∂B/∂s
};

template <class T, int D, class Solver>
PW85_FUNCTION inline NormalJet<T, D> evaluate_normal(DistancePair<T, D> const &pair, Solver const &solver) noexcept
{
    Vector<T, D> const u = solve(solver, pair.r12), p = product(pair.q1, u), q = product(pair.q2, u);
    Vector<T, D> const u_ratio = times(pair.scale2, solve(solver, q)), u_shift = solve(solver, u);
    return {scale_of(solver),
            u,
            u_ratio,
            u_shift,
            positive_form(pair.q1, u, p),
            dot(p, u_ratio),
            dot(p, u_shift),
            positive_form(pair.q2, u, q),
            dot(q, u_ratio),
            dot(q, u_shift)};
}

/// Newton's step of item 2, over the scale.
template <class T, int D>
PW85_FUNCTION inline Multipliers<T> newton_step(NormalJet<T, D> const &j, Multipliers<T> const &x) noexcept
{
    T const root_a = square_root(j.a), root_b = square_root(j.b), reciprocal = T(1) / j.scale;
    T const a = j.a * (reciprocal * root_a - T(1)), b = j.b * (reciprocal * x.ratio * root_b - T(1));
    T const b_ratio = j.b_ratio - j.b * root_b, factor = T(1) / (j.a_ratio * j.b_shift - j.a_shift * b_ratio);
    return {factor * (a * j.b_shift - b * j.a_shift), factor * (b * j.a_ratio - a * b_ratio)};
}

/// Whether a step is so small that its square is below rounding: relative to t, and to u in the norm of M, whose square counts
/// against n·r. (In this norm t changes u by less than by its own relative change.)
template <class T, int D>
PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask is_last(DistancePair<T, D> const &pair, NormalJet<T, D> const &j,
                                                               Multipliers<T> const &x,
                                                               Multipliers<T> const &step) noexcept
{
    constexpr int digits = mantissa_digits<T>() + 1;
    return absolute(T(j.scale * step.ratio)) <= negative_power_of_two<T>(digits / 2) * x.ratio &&
           step.shift * step.shift * dot(j.u, j.u_shift) <= negative_power_of_two<T>(digits) * dot(j.u, pair.r12);
}

/// u after a step.
template <class T, int D>
PW85_FUNCTION constexpr Vector<T, D> advance(NormalJet<T, D> const &j, Multipliers<T> const &step) noexcept
{
    Vector<T, D> u = j.u;
    for (int i = 0; i < D; ++i) u[i] = u[i] - (step.ratio * j.u_ratio[i] + step.shift * j.u_shift[i]);
    return u;
}

/// Where the iteration starts: exact for spheres.
template <class T, int D>
PW85_FUNCTION inline Multipliers<T> initial_multipliers(DistancePair<T, D> const &pair) noexcept
{
    auto const weights = outer_weights(pair.r12);
    T const a = square_root(positive_form(pair.q1, weights)), b = square_root(positive_form(pair.q2, weights));
    T const width = T(1) - (pair.scale1 * a + pair.scale2 * b) / dot(pair.r12, pair.r12);
    return {a / b, a * maximum(T(0), width)};
}

/// The number of evaluations after which the search by item 2 gives up, which is rare up to aspect ratios of 10.
inline constexpr int max_normal_steps = 6;

/// A search by item 2 under way. What becomes of a lane depends on nothing but its pair.
template <class T, int D> struct NormalSearch {
    Multipliers<T> x;
    Vector<T, D> u; ///< along the normal, where it is found
    typename ScalarTraits<T>::Mask active,
        found; ///< neither where a step goes far, or the error of the adjugate would count
};

template <class T, int D> PW85_FUNCTION inline NormalSearch<T, D> start_normal_search(Multipliers<T> const &x) noexcept
{
    return {x, {}, x.ratio == x.ratio, x.ratio < x.ratio};
}

template <class T, int D>
PW85_FUNCTION inline void take_step(NormalSearch<T, D> &search, DistancePair<T, D> const &pair) noexcept
{
    auto const m = normal_matrix(pair, search.x);
    Adjugate<T, D> inverse{adjugate(m), T(0)};
    inverse.scale = determinant(m, inverse.entries);
    auto const accurate = search.active && inverse.scale > adjugate_conditioning<T>() * diagonal_product(m);
    auto const jet = evaluate_normal(pair, inverse);
    Multipliers<T> const step = newton_step(jet, search.x);
    auto const last = accurate && is_last(pair, jet, search.x, step);
    Vector<T, D> const u = advance(jet, step);
    for (int i = 0; i < D; ++i) search.u[i] = select(last, u[i], search.u[i]);
    search.found = search.found || last;
    T const ratio = search.x.ratio + jet.scale * step.ratio;
    search.active = accurate && !last && T(8) * ratio > search.x.ratio && ratio < T(8) * search.x.ratio;
    search.x = {ratio, maximum(T(0), T(search.x.shift + jet.scale * step.shift))};
}

/// A vector along the normal by item 2; false if it is not found.
template <class T, int D>
PW85_FUNCTION inline bool find_normal(DistancePair<T, D> const &pair, Multipliers<T> const &x, Vector<T, D> &u) noexcept
{
    auto search = start_normal_search<T, D>(x);
    for (int i = 0; i < max_normal_steps && search.active; ++i) take_step(search, pair);
    u = search.u;
    return search.found;
}

/// What solves with M by factorisation, which serves any shape.
template <class T, int D> PW85_FUNCTION inline Factorization<T, D> factorize_normal(DistancePair<T, D> const &pair,
                                                                                    Multipliers<T> const &x) noexcept
{
    return factorize(normal_matrix(pair, x), T(unit_roundoff<T>()));
}

/// s of item 3, for some t. Residual times slope falls from step to step to a quarter: for aspect ratios up to 2^127 the slope
/// by 2^254 in all, the residual by 2^85 for 50 digits, which 170 steps exhaust.
template <class T, int D> PW85_FUNCTION inline T find_shift(DistancePair<T, D> const &pair, T const &ratio) noexcept
{
    T const weight = pair.scale2 * ratio, target = pair.scale1 + pair.scale2 / ratio;
    T shift = T(0);
    for (int i = 0; i < 170; ++i) {
        auto const jet = evaluate_normal(pair, factorize_normal(pair, {ratio, shift}));
        T const form = pair.scale1 * jet.a + weight * jet.b, slope = pair.scale1 * jet.a_shift + weight * jet.b_shift;
        T const step = form * (square_root(T(form / target)) - T(1)) / slope;
        if (!(step > T(0))) break;
        shift = shift + step;
        if (is_last(pair, jet, {ratio, shift}, {T(0), step})) break;
    }
    return shift;
}

/// The largest number of values of t that search_normal() tries: 13 of growing distance to enclose the one it looks for, which
/// is in the range of T, 15 and as many as there are digits to make the bracket as narrow as rounding allows, and Newton's
/// steps, which halve as often at most.
template <class T> PW85_FUNCTION constexpr int max_ratios() noexcept { return 2 * mantissa_digits<T>() + 28; }

/// A vector along the normal, by a search for t with s from find_shift(): Newton's steps where they stay in the bracket of
/// item 4 and halve; else bisection of log t, or a point far beyond the end that is known, the farther the more were tried.
template <class T, int D>
[[gnu::noinline]] PW85_FUNCTION inline Vector<T, D> search_normal(DistancePair<T, D> const &pair, T ratio) noexcept
{
    T const largest = largest_number<T>();
    T lower = T(0), upper = largest, reach = T(16), shortest = T(2);
    for (int i = 1;; ++i) {
        Multipliers<T> const x{ratio, find_shift(pair, ratio)};
        auto const jet = evaluate_normal(pair, factorize_normal(pair, x));
        Multipliers<T> const step = newton_step(jet, x);
        if (is_last(pair, jet, x, step)) return advance(jet, step);
        (ratio * ratio * jet.b > jet.a ? upper : lower) = ratio;
        if (i >= max_ratios<T>() || !(upper - lower > T(4) * unit_roundoff<T>() * upper)) return jet.u;
        T const size = absolute(step.ratio) / ratio, next = ratio + step.ratio;
        if (next > lower && next < upper && T(2) * size <= shortest) {
            shortest = size;
            ratio = next;
        } else if (lower > T(0) && upper < largest)
            ratio = lower * square_root(T(upper / lower));
        else {
            ratio = lower > T(0) ? T(lower * reach) : T(upper / reach);
            reach = reach * reach;
        }
    }
}

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
    return {times(T(T(1) / extent), point), extent};
}

/// The width of the slab normal to u between a pair, and the points that touch it, relative to their own centres.
template <class T, int D>
PW85_FUNCTION inline Distance<T, D> distance_along(DistancePair<T, D> const &pair, Vector<T, D> const &u) noexcept
{
    T const norm = T(1) / square_root(dot(u, u));
    Support<T, D> const s1 = support(pair.q1, u), s2 = support(pair.q2, u);
    T const width = norm * (dot(u, pair.r12) - pair.scale1 * s1.extent - pair.scale2 * s2.extent);
    return {maximum(T(0), width), s1.point, s2.point, times(norm, u), Status::success};
}

/// distance() of a pair that is in range and apart, with both points relative to their own centres. All callers share one
/// instance, so that products are fused alike and scaling changes no bit of the result.
template <class T, int D> PW85_FUNCTION inline Distance<T, D> distance_in_range(DistancePair<T, D> const &pair) noexcept
{
    Multipliers<T> const start = initial_multipliers(pair);
    Vector<T, D> u;
    // Semi-axes are below √12 of their units, so that n is within 7 scales of the direction of r12: rounding.
    if (maximum(pair.scale1, pair.scale2) <= T(0.125) * unit_roundoff<T>())
        u = pair.r12;
    else if (!find_normal(pair, start, u))
        u = search_normal(pair, start.ratio);
    return distance_along(pair, u);
}

/// distance() of a valid pair that is apart.
template <class T, int D> PW85_FUNCTION inline Distance<T, D>
distance_apart(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    Distance<T, D> result;
    if (is_in_range(sum_of_magnitudes(r12), largest_diagonal(q1), largest_diagonal(q2)))
        result = distance_in_range(DistancePair<T, D>{r12, q1, q2, T(1), T(1)});
    else {
        DistanceUnits units;
        result = distance_in_range(scale_distance(r12, q1, q2, units));
        result.distance = times_power_of_two(result.distance, units.length);
        result.point1 = times_power_of_two(result.point1, units.form1);
        result.point2 = times_power_of_two(result.point2, units.form2);
    }
    for (int i = 0; i < D; ++i) result.point2[i] = r12[i] - result.point2[i];
    return result;
}

/// The distance of a pair that overlaps or is invalid.
template <class T, int D> PW85_FUNCTION inline Distance<T, D> no_distance(Status status) noexcept
{
    Distance<T, D> result{status == Status::success ? T(0) : quiet_nan<T>(), {}, {}, {}, status};
    for (int i = 0; i < D; ++i) result.point1[i] = result.point2[i] = result.normal[i] = quiet_nan<T>();
    return result;
}

template <class T, int D> PW85_FUNCTION inline Distance<T, D>
distance(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    Overlap const decision = overlap(r12, q1, q2);
    if (decision.status != Status::success || decision.overlap) return no_distance<T, D>(decision.status);
    return distance_apart(r12, q1, q2);
}

} // namespace pw85

#endif

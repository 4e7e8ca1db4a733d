// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The distance of two ellipsoids in n dimensions, with the closest points and the normal. The
/// equations and their search are those of distance/normal_search.hpp. They use vectors of two or
/// three numbers; the functions here use arrays.
///
/// Any vector u gives a lower bound of the distance, φ = (u·r12 - √(uᵀQ1u) - √(uᵀQ2u))/|u|, and an
/// upper bound, the length of the vector w between the points of the surfaces with the normals u
/// and -u. Both bounds are computed with twice the digits of double. The search ends when they
/// agree to rounding.
///
/// Numbers with seven times the digits continue the search where twice the digits do not suffice
/// (refine_slab() of distance/distance.hpp says when).
#ifndef PW85_ANY_DIMENSION_DISTANCE_HPP_INCLUDED
#define PW85_ANY_DIMENSION_DISTANCE_HPP_INCLUDED

#include <pw85/any_dimension/overlap.hpp>
#include <pw85/distance/nested_search.hpp>

namespace pw85 {

/// The outputs of nd_distance() in addition to the distance, in arrays of the caller. An output
/// whose pointer is null is not written.
struct NdClosestPoints {
    double *point1, *point2, *normal;
};

/// The distance of nd_distance().
struct NdDistance {
    double distance; ///< 0 if the ellipsoids overlap
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail::any_dimension {

template <class T> struct NormalFactors {
    T m[max_packed_size];
};

/// A pair in one unit of length, with the factors that a DistancePair has.
template <class T> struct DistancePair {
    Pair<T> pair;
    T scale1, scale2;
    NormalFactors<T> *factors; ///< memory of factorize_normal()
};

template <class T> struct Direction {
    T x[max_dimension];
};

/// NormalVector in n dimensions.
template <class T> struct NormalVector {
    Direction<T> u, u_ratio, u_shift;
    NormalJet<T> jet;
};

/// Returns the factors of M = Q1 + t Q2 + s I, which the next call overwrites.
template <class T> PW85_FUNCTION inline NormalFactors<T> const &
factorize_normal(DistancePair<T> const &given, Multipliers<T> const &x) noexcept
{
    auto const &pair = given.pair;
    NormalFactors<T> &factors = *given.factors;
    for (int k = 0; k < packed_size(pair.n); ++k) factors.m[k] = pair.q1[k] + x.ratio * pair.q2[k];
    for (int i = 0; i < pair.n; ++i) {
        T &diagonal = factors.m[packed_index(pair.n, i, i)];
        diagonal = diagonal + x.shift;
    }
    factorize(pair.n, factors.m);
    return factors;
}

/// Solves the equations of solve_normal() in n dimensions.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline NormalVector<T>
solve_normal(DistancePair<T> const &given, NormalFactors<T> const &factors,
             Multipliers<T> const &x) noexcept
{
    auto const &pair = given.pair;
    int const n = pair.n;
    NormalVector<T> v{};
    T p[max_dimension]{}, q[max_dimension]{};
    solve(n, factors.m, pair.r12, v.u.x);
    product(n, pair.q1, v.u.x, p);
    product(n, pair.q2, v.u.x, q);
    solve(n, factors.m, q, v.u_ratio.x);
    solve(n, factors.m, v.u.x, v.u_shift.x);
    T const a = positive_form(n, pair.q1, v.u.x, p), b = positive_form(n, pair.q2, v.u.x, q);
    T const a_ratio = dot(n, p, v.u_ratio.x), a_shift = dot(n, p, v.u_shift.x),
            b_ratio = dot(n, q, v.u_ratio.x), b_shift = dot(n, q, v.u_shift.x);
    v.jet = {dot(n, v.u.x, pair.r12),
             dot(n, v.u.x, v.u_shift.x),
             a,
             b,
             b * a_ratio - a * b_ratio,
             b * a_shift - a * b_shift,
             a + x.ratio * b,
             a_ratio + x.ratio * b_ratio - T(0.5) * b,
             a_shift + x.ratio * b_shift};
    return v;
}

/// Returns u after a step. The array has max_dimension entries, of which n are used.
template <class T> PW85_FUNCTION inline Direction<T>
advance(NormalVector<T> const &v, Multipliers<T> const &x, NormalStep<T> const &step) noexcept
{
    T const ratio = x.ratio * rough_quotient(step.numerator, step.denominator);
    Direction<T> u = v.u;
    for (int i = 0; i < max_dimension; ++i)
        u.x[i] = u.x[i] - (ratio * v.u_ratio.x[i] + step.shift * v.u_shift.x[i]);
    return u;
}

/// A slab between the ellipsoids, and the points that touch it, in numbers with more digits than
/// double.
template <class W> struct NormalSlab {
    W normal[max_dimension], point1[max_dimension], point2[max_dimension];
    W extent1, extent2, width;
    bool accurate;
};

/// Returns the point Qn/√(nᵀQn), and the width √(nᵀQn).
template <class W>
PW85_FUNCTION inline W find_support(int n, W const *q, W const *normal, W *point) noexcept
{
    product(n, q, normal, point);
    W const extent = square_root(dot(n, normal, point));
    for (int i = 0; i < n; ++i) point[i] = point[i] / extent;
    return extent;
}

/// The largest component of w perpendicular to the normal, relative to n·r12 and in units of u, as
/// for distances in three dimensions.
inline constexpr double largest_off = 0x1p17;

/// Computes the slab of a direction. It is accurate if the part of w across the normal is below
/// largest_off and satisfies off² <= 2u (n·r12) max(φ, u n·r12): then |w| - φ is at most 2u n·r12.
template <class T, class W> [[gnu::noinline]] PW85_FUNCTION inline void
find_slab(Pair<W> const &pair, Direction<T> const &u, NormalSlab<W> &slab) noexcept
{
    int const n = pair.n;
    for (int i = 0; i < n; ++i) slab.normal[i] = W(u.x[i]);
    W const norm = square_root(dot(n, slab.normal, slab.normal));
    for (int i = 0; i < n; ++i) slab.normal[i] = slab.normal[i] / norm;
    slab.extent1 = find_support(n, pair.q1, slab.normal, slab.point1);
    slab.extent2 = find_support(n, pair.q2, slab.normal, slab.point2);
    W const along = dot(n, slab.normal, pair.r12);
    slab.width = along - slab.extent1 - slab.extent2;
    W off2(0.0);
    for (int i = 0; i < n; ++i) {
        W const off = pair.r12[i] - slab.point1[i] - slab.point2[i] - slab.width * slab.normal[i];
        off2 = off2 + off * off;
    }
    W const rounding = W(unit_roundoff<double>()) * along;
    W const largest = W(largest_off) * rounding;
    slab.accurate =
        off2 <= minimum(W(2.0) * rounding * maximum(slab.width, rounding), largest * largest);
}

/// Returns the t and s that belong to a slab: with the half-widths α and β they are α/β and αφ.
template <class T, class W>
PW85_FUNCTION inline Multipliers<T> multipliers(NormalSlab<W> const &slab) noexcept
{
    W const shift = maximum(W(0.0), slab.extent1 * slab.width);
    if constexpr (std::is_same_v<T, W>)
        return {slab.extent1 / slab.extent2, shift};
    else
        return {T(rounded(slab.extent1 / slab.extent2)), T(rounded(shift))};
}

/// Searches from t and s by Newton's method. Returns whether it converges; then the slab is that of
/// its normal.
template <class T, class W>
[[gnu::noinline]] PW85_FUNCTION inline bool follow_normal(DistancePair<T> const &given,
                                                          Multipliers<T> x, Pair<W> const &wide,
                                                          NormalSlab<W> &slab) noexcept
{
    for (int i = 0; i < max_normal_steps + max_last_steps; ++i) {
        auto const v = solve_normal(given, factorize_normal(given, x), x);
        auto const step = newton_step(given, v.jet, x);
        if (is_within(step, v.jet, last_digits<T>())) {
            find_slab(wide, advance(v, x, step), slab);
            return true;
        }
        x = advance(x, step);
    }
    return false;
}

/// Searches from the t and s of a slab by Newton's method, and by the nested search if this fails.
/// Returns whether the slab is accurate.
template <class T, class W>
PW85_FUNCTION inline bool find_normal(DistancePair<T> const &given, Multipliers<T> const &start,
                                      Pair<W> const &wide, NormalSlab<W> &slab) noexcept
{
    if (!follow_normal(given, start, wide, slab))
        find_slab(wide, search_normal(given, start.ratio), slab);
    return slab.accurate;
}

/// Converts a pair to one unit of length, with memory for its factors.
template <class T> PW85_FUNCTION inline void
prepare(Input const &in, Unit unit, NormalFactors<T> &factors, DistancePair<T> &given) noexcept
{
    scale(in, {unit, unit, unit, false, {}}, given.pair);
    given.scale1 = given.scale2 = T(1);
    given.factors = &factors;
}

/// Finds the slab of a pair that does not overlap, in one unit.
[[gnu::noinline]] PW85_FUNCTION inline bool
find_distance(Input const &in, Unit unit, NormalSlab<Doubled<double>> &slab) noexcept
{
    Pair<Doubled<double>> wide;
    scale(in, {unit, unit, unit, false, {}}, wide);
    NormalFactors<double> factors;
    DistancePair<double> given;
    prepare(in, unit, factors, given);
    Direction<double> along{};
    for (int i = 0; i < in.n; ++i) along.x[i] = given.pair.r12[i];
    find_slab(wide, along, slab);
    return slab.accurate || find_normal(given, multipliers<double>(slab), wide, slab);
}

/// Continues the search with twice the digits: a step from an accurate normal can still leave a
/// slab that is not accurate to rounding.
[[gnu::cold, gnu::noinline]] PW85_FUNCTION inline bool
find_distance_wider(Input const &in, Unit unit, NormalSlab<Doubled<double>> &slab) noexcept
{
    if constexpr (FLT_EVAL_METHOD != 0) return false;
    NormalFactors<Doubled<double>> factors;
    DistancePair<Doubled<double>> given;
    prepare(in, unit, factors, given);
    return find_normal(given, multipliers<Doubled<double>>(slab), given.pair, slab);
}

/// Rounds the outputs, and converts them to the units of the caller.
template <class W> [[gnu::noinline]] PW85_FUNCTION inline NdDistance
store(Input const &in, Unit unit, NormalSlab<W> const &slab, NdClosestPoints const &out) noexcept
{
    for (int i = 0; i < in.n; ++i) {
        auto const r12 = W(unit.to_local(in.r12[i]));
        double const point1 = rounded(slab.point1[i]), point2 = rounded(r12 - slab.point2[i]);
        if (out.point1 != nullptr) out.point1[i] = unit.to_caller(point1);
        if (out.point2 != nullptr) out.point2[i] = unit.to_caller(point2);
        if (out.normal != nullptr) out.normal[i] = rounded(slab.normal[i]);
    }
    return {unit.to_caller(maximum(0.0, rounded(slab.width))), StatusCode::success};
}

/// Memory of a search with seven times the digits of double, which is allocated.
struct ExtendedDistance {
    using Number = exact::Extended<double>;

    DistancePair<Number> pair;
    NormalFactors<Number> factors;
    NormalSlab<Number> slab;
};

/// Continues the search with seven times the digits. It starts at the t and s of the given slab if
/// these are in the range of double.
[[gnu::cold, gnu::noinline]] PW85_FUNCTION inline NdDistance
distance_extended(Input const &in, Unit unit, NormalSlab<Doubled<double>> const &given,
                  NdClosestPoints const &out) noexcept
{
    using Number = ExtendedDistance::Number;
    auto *const work = static_cast<ExtendedDistance *>(std::malloc(sizeof(ExtendedDistance)));
    if (work == nullptr) return {quiet_nan<double>(), StatusCode::out_of_memory};
    auto &[pair, factors, slab] = *work;
    prepare(in, unit, factors, pair);
    auto start = multipliers<Number>(given);
    if (!(start.ratio > Number(0) && start.shift >= Number(0))) start = {Number(1), Number(0)};
    NdDistance result{quiet_nan<double>(), StatusCode::no_convergence};
    if (find_normal(pair, start, pair.pair, slab)) result = store(in, unit, slab, out);
    std::free(work);
    return result;
}

/// Returns whether a form can be written in a unit: its half-widths along the axes are at least
/// 2^-400 and at most 2^500.
PW85_FUNCTION inline bool is_in_range(int n, double const *q, Unit unit) noexcept
{
    return keeps_digits(n, q, unit) && unit.to_local(largest_diagonal(n, q), 2) <= 0x1p1000;
}

} // namespace pw85::detail::any_dimension

namespace pw85 {

/// Returns the distance of two ellipsoids in n dimensions; see nd_contact(). The points, relative
/// to the centre of ellipsoid 1, and the normal, out of ellipsoid 1, are stored if the status is
/// success and the ellipsoids do not overlap.
PW85_FUNCTION inline NdDistance nd_distance(int n, double const *r12, double const *q1,
                                            double const *q2, NdClosestPoints const &out) noexcept
{
    using namespace detail;
    using namespace detail::any_dimension;
    Input const in{n, r12, q1, q2};
    NdOverlap const decision = nd_overlap(n, r12, q1, q2);
    if (decision.status != StatusCode::success) return {quiet_nan<double>(), decision.status};
    if (decision.overlap) return {0.0, StatusCode::success};
    Unit const unit = unit_of(largest_magnitude(n, r12));
    if (!any_dimension::is_in_range(n, q1, unit) || !any_dimension::is_in_range(n, q2, unit))
        return {quiet_nan<double>(), StatusCode::no_convergence};
    NormalSlab<Doubled<double>> slab;
    if (find_distance(in, unit, slab) || find_distance_wider(in, unit, slab))
        return store(in, unit, slab, out);
    return distance_extended(in, unit, slab, out);
}

} // namespace pw85

#endif

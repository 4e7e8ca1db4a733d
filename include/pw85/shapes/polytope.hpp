// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The contact function of an ellipsoid and a polytope, the intersection of half-spaces normal·x <=
/// offset.
///
/// Let c be the centre of the ellipsoid and x relative to it, g = -normal and d = -offset - g·c, so
/// that the half-spaces are g·x >= d. For a set of at most three planes whose multipliers λ are
/// positive, (GᵀQG) λ = d gives the point x = QGλ where the scaled ellipsoid touches their
/// intersection, and μ² = λ·d (nearest_point.hpp). This is at most the μ² of the polytope.
/// search_polytope() finds the set with the largest one.
///
/// Rounding errors of x are some u r, r = Σ λ_k |Q| |g_k|, and r can be the square of the aspect
/// ratio times |x|. So the result of the search counts only if its point is in all half-spaces up
/// to 32 u (max|g_i| Σ|x_i| + m), and if the bound on the error of μ² is below 2^-10 μ². A point
/// outside is moved onto the touched planes first. Such a point x = QGλ with λ > 0 is the exact
/// result for a polytope whose planes are moved by no more than this bound. Integers decide all
/// other polytopes, and all that seem empty (exact_polytope.hpp).
#ifndef PW85_SHAPES_POLYTOPE_HPP_INCLUDED
#define PW85_SHAPES_POLYTOPE_HPP_INCLUDED

#include <cstddef>

#include <pw85/shapes/exact_polytope.hpp>

namespace pw85::detail {

/// A half-space g·x >= d, and Qg.
template <class T> struct HalfSpace {
    Vector<T, 3> g, qg;
    T d, magnitude; ///< d and m
};

/// At most three planes that a scaled ellipsoid touches at a point.
template <class T> struct TouchedPlanes {
    HalfSpace<T> planes[3];
    int size;
    T mu2;
    Vector<T, 3> multipliers, point, magnitudes; ///< λ, x and r
};

/// The half-spaces in units in which normals and forms are of order one, and no d is larger.
template <class T> struct Polytope {
    std::size_t count;
    T const *normals, *offsets;
    SymmetricMatrix<T, 3> q;
    Vector<T, 3> center;
    Unit length; ///< of the centre and of d
    /// how far the planes are moved inwards, in half-widths √(gᵀQg) of the ellipsoid
    T inset;

    PW85_MEMBER Vector<T, 3> normal(std::size_t k) const noexcept
    {
        return {normals[3 * k], normals[3 * k + 1], normals[3 * k + 2]};
    }

    PW85_MEMBER HalfSpace<T> half_space(std::size_t k) const noexcept
    {
        Vector<T, 3> const n = normal(k);
        Unit const size = unit_of(n);
        Vector<T, 3> const g = -size.to_local(n), qg = product(q, g);
        T const offset = length.to_local(size.to_local(offsets[k]));
        T const d = -offset - dot(g, center),
                magnitude = absolute(offset) + magnitude_of_dot(g, center);
        if (!(inset > T(0))) return {g, qg, d, magnitude};
        return {g, qg, T(d + inset * square_root(dot(g, qg))), magnitude};
    }
};

/// Returns the distance from a point to a half-space minus a bound on rounding errors, in units of
/// the half-width √(gᵀQg) of the ellipsoid; negative if the point is in the half-space.
///
/// The coordinates of x err by some u r, r = Σ λ_k |Q| |g_k|. So a violation of g·x >= d is no
/// larger than rounding errors if it is below 8 u (|g|·r + m), where m = |offset| + |g|·|c| bounds
/// the terms of d.
template <class T> PW85_FUNCTION inline T violation(HalfSpace<T> const &h, Vector<T, 3> const &x,
                                                    Vector<T, 3> const &magnitudes) noexcept
{
    T const error =
        T(8) * T(unit_roundoff<T>()) * T(magnitude_of_dot(h.g, magnitudes) + h.magnitude);
    return T((h.d - dot(h.g, x)) - error) / square_root(dot(h.g, h.qg));
}

/// Returns whether the normals of planes are independent beyond rounding errors. A coordinate of a
/// cross product is rounded twice, and a triple product five times.
template <class T>
PW85_FUNCTION inline bool are_independent(HalfSpace<T> const *const (&)[1]) noexcept
{
    return true;
}

template <class T>
PW85_FUNCTION inline bool are_independent(HalfSpace<T> const *const (&planes)[2]) noexcept
{
    Vector<T, 3> const &a = planes[0]->g, &b = planes[1]->g, n = cross(a, b);
    bool independent = false;
    for (int i = 0; i < 3; ++i) {
        int const j = (i + 1) % 3, k = (i + 2) % 3;
        T const terms = absolute(T(a[j] * b[k])) + absolute(T(a[k] * b[j]));
        independent = independent || absolute(n[i]) > T(8 * unit_roundoff<T>()) * terms;
    }
    return independent;
}

template <class T>
PW85_FUNCTION inline bool are_independent(HalfSpace<T> const *const (&planes)[3]) noexcept
{
    Vector<T, 3> const &a = planes[0]->g, &b = planes[1]->g, &c = planes[2]->g;
    T terms = T(0);
    for (int i = 0; i < 3; ++i) {
        int const j = (i + 1) % 3, k = (i + 2) % 3;
        terms = terms + absolute(c[i]) * T(absolute(T(a[j] * b[k])) + absolute(T(a[k] * b[j])));
    }
    return absolute(dot(cross(a, b), c)) > T(8 * unit_roundoff<T>()) * terms;
}

/// Gram's matrix of the normals, GᵀQG, in factors.
template <std::size_t K, class T>
PW85_FUNCTION inline auto factorized_gram(HalfSpace<T> const *const (&planes)[K]) noexcept
{
    SymmetricMatrix<T, int(K)> gram{};
    for (int i = 0; i < int(K); ++i)
        for (int j = i; j < int(K); ++j) gram(i, j) = dot(planes[i]->g, planes[j]->qg);
    return factorize(gram, T(unit_roundoff<T>()));
}

/// Finds where the ellipsoid touches the intersection of some planes. `size` is 0 if a multiplier
/// is not positive, or if rounding errors decide whether the planes intersect.
template <int K, class T> PW85_FUNCTION inline TouchedPlanes<T>
touch(SymmetricMatrix<T, 3> const &q, HalfSpace<T> const *const (&planes)[std::size_t(K)]) noexcept
{
    Vector<T, K> d{};
    for (int i = 0; i < K; ++i) d[i] = planes[i]->d;
    auto const factors = factorized_gram(planes);
    Vector<T, K> const lambda = solve(factors, d);
    TouchedPlanes<T> touched{};
    touched.size = are_independent(planes) ? K : 0;
    touched.mu2 = inverse_form(factors, d);
    for (int k = 0; k < K; ++k) {
        if (!(lambda[k] > T(0))) touched.size = 0;
        touched.planes[k] = *planes[k];
        touched.multipliers[k] = lambda[k];
        touched.point = add_scaled(touched.point, lambda[k], planes[k]->qg);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                touched.magnitudes[i] =
                    touched.magnitudes[i] +
                    lambda[k] * T(absolute(q(i, j)) * absolute(planes[k]->g[j]));
    }
    return touched;
}

/// The set of planes with the larger μ².
template <class T>
PW85_FUNCTION inline void improve(TouchedPlanes<T> &best, TouchedPlanes<T> const &other) noexcept
{
    if (other.size > 0 && !(best.size > 0 && best.mu2 >= other.mu2)) best = other;
}

/// The planes that are touched after a half-space is added. Of all subsets of the old planes with
/// the new one, the one with positive multipliers and the largest μ² gives the nearest point for
/// all of these planes.
template <class T>
PW85_FUNCTION inline TouchedPlanes<T> touch_with(SymmetricMatrix<T, 3> const &q,
                                                 TouchedPlanes<T> const &old,
                                                 HalfSpace<T> const &added) noexcept
{
    TouchedPlanes<T> best{};
    improve(best, touch<1>(q, {&added}));
    for (int i = 0; i < old.size; ++i) {
        improve(best, touch<2>(q, {&added, &old.planes[i]}));
        for (int j = i + 1; j < old.size; ++j)
            improve(best, touch<3>(q, {&added, &old.planes[i], &old.planes[j]}));
    }
    return best;
}

/// Returns whether the planes that were found are touched at a point in the old half-spaces. If
/// not, the up to four half-spaces have no common point, and the polytope is empty.
template <class T> PW85_FUNCTION inline bool satisfies(TouchedPlanes<T> const &found,
                                                       TouchedPlanes<T> const &old) noexcept
{
    bool inside = found.size > 0;
    for (int k = 0; k < old.size; ++k)
        inside = inside && violation(old.planes[k], found.point, T(4) * found.magnitudes) <= T(0);
    return inside;
}

/// The half-space that a point violates most; `count` if it is in all.
template <class T> PW85_FUNCTION inline std::size_t
most_violated(Polytope<T> const &polytope, TouchedPlanes<T> const &at) noexcept
{
    std::size_t index = polytope.count;
    T largest = T(0);
    for (std::size_t k = 0; k < polytope.count; ++k) {
        T const distance = violation(polytope.half_space(k), at.point, at.magnitudes);
        if (!(distance > largest)) continue;
        largest = distance;
        index = k;
    }
    return index;
}

/// The number of steps after which the search gives up. No polytope is known that needs as many.
inline constexpr int max_polytope_steps = 1000;

/// Result of a search: a point of the polytope, a proof that it is empty, or neither.
template <class T> struct PolytopeSearch {
    enum class End { found, empty, none };

    TouchedPlanes<T> at;
    End end;
};

/// The search in the units of the polytope. The search ends early if μ² exceeds `limit`. It begins
/// with x = 0, and adds in each step the half-space that x violates most. μ² increases from step to
/// step, so no set of planes comes twice.
///
/// To first order, a violation that counts as rounding changes μ² by 2 λ times as much. With up to
/// three multipliers, and the errors of their equations, μ² errs by less than 32 u Σ λ_k (|g_k|·r +
/// m_k), the sum over the planes that are touched. If c is not 0, the rounding of d adds 8 u Σ λ_k
/// m_k.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline PolytopeSearch<T>
search_polytope(Polytope<T> const &polytope, T const &limit) noexcept
{
    using End = typename PolytopeSearch<T>::End;
    TouchedPlanes<T> at{};
    for (int step = 0; step < max_polytope_steps; ++step) {
        std::size_t const next = most_violated(polytope, at);
        if (next == polytope.count) return {at, End::found};
        auto const found = touch_with(polytope.q, at, polytope.half_space(next));
        if (!satisfies(found, at)) return {at, End::empty};
        at = found;
        if (at.mu2 > limit) return {at, End::none};
    }
    return {at, End::none};
}

/// x moved onto the planes along Qg_k, by one step of iterative refinement.
template <std::size_t K, class T> PW85_FUNCTION inline Vector<T, 3>
moved_onto(HalfSpace<T> const *const (&planes)[K], Vector<T, 3> x) noexcept
{
    Vector<T, int(K)> residual{};
    for (int k = 0; k < int(K); ++k) residual[k] = planes[k]->d - dot(planes[k]->g, x);
    Vector<T, int(K)> const lambda = solve(factorized_gram(planes), residual);
    for (int k = 0; k < int(K); ++k) x = add_scaled(x, lambda[k], planes[k]->qg);
    return x;
}

template <class T>
PW85_FUNCTION inline Vector<T, 3> moved_onto_planes(TouchedPlanes<T> const &at) noexcept
{
    auto const *const planes = at.planes;
    if (at.size == 3) return moved_onto<3>({&planes[0], &planes[1], &planes[2]}, at.point);
    return at.size == 2 ? moved_onto<2>({&planes[0], &planes[1]}, at.point)
                        : moved_onto<1>({&planes[0]}, at.point);
}

/// Returns whether a point is in all half-spaces up to 32 u (max|g_i| Σ|x_i| + m). The error of the
/// computed difference d - g·x is at most 8 u times the sum in parentheses.
template <class T>
PW85_FUNCTION inline bool has_point(Polytope<T> const &polytope, Vector<T, 3> const &x) noexcept
{
    T const size = sum_of_magnitudes(x), factor = T(24) * T(unit_roundoff<T>());
    for (std::size_t k = 0; k < polytope.count; ++k) {
        auto const h = polytope.half_space(k);
        T const bound = factor * T(largest_coordinate(h.g) * size + h.magnitude);
        if (!(h.d - dot(h.g, x) <= bound)) return false;
    }
    return true;
}

/// Returns whether the bound on the error of μ² is below 2^-10 μ². Terms of second order are then
/// negligible.
template <class T> PW85_FUNCTION inline bool is_accurate(TouchedPlanes<T> const &at) noexcept
{
    T sum = T(0);
    for (int k = 0; k < at.size; ++k)
        sum = sum + at.multipliers[k] *
                        T(magnitude_of_dot(at.planes[k].g, at.magnitudes) + at.planes[k].magnitude);
    return T(T(32) * T(unit_roundoff<T>())) * sum <= negative_power_of_two<T>(10) * at.mu2;
}

/// Returns whether the result of a search is accepted, after its point is moved if necessary.
///
/// The search has left no violation above 8 u (|g|·r + m). If the sum of r is at most three times
/// that of |x|, this is within the bound of has_point(), with the errors of its own.
template <class T> PW85_FUNCTION inline bool accept_point(Polytope<T> const &polytope,
                                                          PolytopeSearch<T> &search) noexcept
{
    auto &at = search.at;
    if (search.end != PolytopeSearch<T>::End::found || !is_accurate(at)) return false;
    if (sum_of_magnitudes(at.magnitudes) <= T(3) * sum_of_magnitudes(at.point)) return true;
    for (int step = 0; step < 3; ++step) {
        if (has_point(polytope, at.point)) return true;
        at.point = moved_onto_planes(at);
    }
    return has_point(polytope, at.point);
}

/// Status of the planes; if they are valid, also the largest positive d in units of their normals,
/// or 0.
template <class T> struct PlanesCheck {
    T largest;
    StatusCode status;
};

template <class T> [[gnu::noinline]] PW85_FUNCTION inline PlanesCheck<T>
check_planes(Polytope<T> const &polytope) noexcept
{
    T largest = T(0);
    if (!is_finite(polytope.center)) return {T(0), StatusCode::invalid_argument};
    for (std::size_t k = 0; k < polytope.count; ++k) {
        Vector<T, 3> const n = polytope.normal(k);
        T const offset = polytope.offsets[k];
        if (!(is_finite(n) && offset * T(0) == T(0) && largest_coordinate(n) > T(0)))
            return {T(0), StatusCode::invalid_argument};
        largest = maximum(largest, polytope.half_space(k).d);
    }
    return {largest, StatusCode::success};
}

/// The polytope in a unit of length, with the form in a unit of its own.
template <class T>
PW85_FUNCTION inline Polytope<T> scaled(Polytope<T> polytope, Unit length, Unit form) noexcept
{
    polytope.q = form.to_local(polytope.q);
    polytope.length = length;
    polytope.center = length.to_local(polytope.center);
    return polytope;
}

PW85_SHARED_BY_QUESTIONS_OF(search_polytope, double)
PW85_SHARED_BY_QUESTIONS_OF(check_planes, double)

} // namespace pw85::detail

namespace pw85 {

template <class T> PW85_FUNCTION inline ShapeContact<T, 3>
contact_polytope(std::size_t n, T const *normals, T const *offsets, SymmetricMatrix<T, 3> const &q,
                 Vector<T, 3> const &center) noexcept
{
    using namespace detail;
    using End = typename PolytopeSearch<T>::End;
    Polytope<T> polytope{n, normals, offsets, q, center, {}, T(0)};
    auto const [largest, status] = check_planes(polytope);
    StatusCode const both = status == StatusCode::success ? validate(q) : status;
    if (both != StatusCode::success) return all_nan<ShapeContact<T, 3>>(both);
    if (!(largest > T(0))) return {T(0), {T(0), T(0), T(0)}, StatusCode::success};
    Unit const form = unit_of(q);
    polytope = scaled(polytope, unit_of(largest), form);
    auto search = search_polytope(polytope, infinity<T>());
    if constexpr (exact::is_decidable<T>) {
        if (!accept_point(polytope, search))
            return contact_polytope_exactly(n, normals, offsets, q, center);
    }
    auto nowhere = all_nan<ShapeContact<T, 3>>(
        search.end == End::empty ? StatusCode::success : StatusCode::no_convergence);
    if (search.end == End::empty) nowhere.mu2 = infinity<T>();
    if (search.end != End::found) return nowhere;
    return to_caller(search.at.mu2, search.at.point, polytope.length, form);
}

} // namespace pw85

#endif

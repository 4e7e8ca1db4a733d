// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// An ellipsoid and a capsule: the points that are at most r away from a segment. The C API
/// (src/c_api/solids.cpp) and pw85.hpp use this file, which gives the capsule to overlap_of()
/// (overlap_shapes.hpp) and its segment to distance_of() (solids.hpp).
///
/// 1. A vector s has its least s·y at the end of the capsule that is least along s, minus r|s|. So
///    the signed distance of the capsule is that of the segment minus r.
/// 2. Let x be the point of the capsule with the least xᵀQ⁻¹x, c the point of the segment nearest
///    to x, and s = Q⁻¹x. Then x = c - r s/|s|. With M = Q + ρI and ρ = r/|s| this is Ms = c. If c
///    is an end, s = M⁻¹c. If c = b + t e is inside the segment, s·e = 0, which gives t =
///    -b·M⁻¹e/(e·M⁻¹e).
/// 3. It remains to find the root of ρ|s| = r. Let d > r be the distance of the centre from the end
///    or from the line of the segment. The root is at most r λ/(d - r), with the largest eigenvalue
///    λ of Q. 1/|s| is a concave function of ρ, as in nearest.hpp. So Newton's method for 1/|s| -
///    ρ/r is monotone from there. The derivative of 1/|s| is σ/|s|³ with σ = s·M⁻¹s, minus
///    (e·M⁻¹s)²/(e·M⁻¹e) on a line.
/// 4. The least xᵀQ⁻¹x of the balls about b + t e is a convex function of t. So if the least value
///    on the line is outside the segment, the least value on the segment is at the nearer end.
/// 5. (s·c - r|s|)²/(sᵀQs) is stationary at the solution, where it is μ². Errors of s and t change
///    it to second order only.
#ifndef PW85_DISTANCE_CAPSULE_HPP_INCLUDED
#define PW85_DISTANCE_CAPSULE_HPP_INCLUDED

#include <pw85/distance/solids.hpp>

namespace pw85::detail {

/// The ball about a point of a line: the part of a capsule that an ellipsoid touches.
template <class T> struct BallOnLine {
    Vector<T, 3> base, along; ///< b and e; e = 0 for one ball
    T radius;
    T clearance; ///< d - r > 0
};

/// The normal s of item 2 at some ρ, not yet for the radius of the capsule.
template <class T> struct BallNormal {
    Vector<T, 3> s;
    T t;
    T square; ///< |s|²
    T slope;  ///< σ, less the second term on a line
};

template <class T> PW85_FUNCTION inline SymmetricMatrix<T, 3> with_shift(SymmetricMatrix<T, 3> q,
                                                                         T const &rho) noexcept
{
    for (int i = 0; i < 3; ++i) q(i, i) = q(i, i) + rho;
    return q;
}

/// t is computed twice, as in segment.hpp.
template <class T> PW85_FUNCTION inline BallNormal<T>
normal_at(BallOnLine<T> const &ball, SymmetricMatrix<T, 3> const &m) noexcept
{
    auto const factors = factorize(m, T(unit_roundoff<T>()));
    BallNormal<T> at{solve(factors, ball.base), T(0), T(0), T(0)};
    bool const moves = largest_coordinate(ball.along) > T(0);
    Vector<T, 3> const w = moves ? solve(factors, ball.along) : ball.along;
    T const we = dot(ball.along, w);
    for (int k = 0; k < 2 && moves; ++k) {
        T const change = -dot(ball.along, at.s) / we;
        at.t = at.t + change;
        at.s = add_scaled(at.s, change, w);
    }
    at.square = dot(at.s, at.s);
    at.slope = inverse_form(factors, at.s);
    if (moves) {
        T const ws = dot(w, at.s);
        at.slope = at.slope - ws * ws / we;
    }
    return at;
}

/// Item 3. There are far fewer steps than 300 for any aspect ratio.
template <class T> PW85_FUNCTION inline T
find_shift_of_ball(BallOnLine<T> const &ball, SymmetricMatrix<T, 3> const &q) noexcept
{
    T const &r = ball.radius;
    T rho = r * (trace(q) / ball.clearance);
    for (int step = 0; step < 300; ++step) {
        auto const at = normal_at(ball, with_shift(q, rho));
        T const length = square_root(at.square);
        T const change = (rho * length - r) / (length - r * (at.slope / at.square));
        if (!(change > unit_roundoff<T>() * rho) || !(change < rho)) break;
        rho = rho - change;
    }
    return rho;
}

/// A solution of items 2 and 3, with the t of its ball.
template <bool with_normal, class T> struct NearestOfBall {
    Nearest<T, with_normal> nearest;
    Vector<T, 3> s;
    T t;
};

/// Errors of the factors of M are like errors of its entries by some u trace M. With those of c
/// they change s by M⁻¹ times a vector of the size u (trace M |s| + |c|). second_order() bounds
/// what this changes of μ² (item 5). s is the solution for the radius ρ|s|. If this differs from r
/// by δ, μ² changes by some δ²|s|²/μ², which must be below u r|s|.
template <bool with_normal, class T> PW85_FUNCTION inline NearestOfBall<with_normal, T>
nearest_of_ball(BallOnLine<T> const &ball, SymmetricMatrix<T, 3> const &q) noexcept
{
    T const &r = ball.radius, rho = find_shift_of_ball(ball, q);
    auto const m = with_shift(q, rho);
    auto const [s, t, square, slope] = normal_at(ball, m);
    T const length = square_root(square), delta = rho * length - r;
    Vector<T, 3> const c = add_scaled(ball.base, t, ball.along);
    T const reach = dot(s, c) - r * length, mu2 = reach * reach / quadratic_form(q, s);
    T const size = trace(m) * sum_of_magnitudes(s) + sum_of_magnitudes(ball.base);
    bool const converged = T(delta * delta) * length <= T(unit_roundoff<T>() * r) * mu2;
    bool const certified =
        reach > T(0) && converged && second_order(m, T(size * size), T(1)).is_small(mu2);
    Vector<T, 3> const x = add_scaled(c, T(-(r / length)), s);
    return {{mu2, x, Normal<T, 3, with_normal>{s}, certified}, s, t};
}

/// A capsule as a set of overlap_of().
template <class T> struct Capsule {
    Vector<T, 3> ends[2];
    T radius;

    PW85_MEMBER bool is_valid() const noexcept
    {
        return is_finite(ends) && radius >= T(0) && radius * T(0) == T(0);
    }

    PW85_MEMBER T least_projection(Vector<T, 3> const &s) const noexcept
    {
        return minimum(dot(s, ends[0]), dot(s, ends[1])) - radius * square_root(dot(s, s));
    }

    /// The radius counts twice, because the error of r|s| is up to 4.5 u r|s|.
    PW85_MEMBER Vector<T, 3> magnitudes(Vector<T, 3> const &) const noexcept
    {
        Vector<T, 3> m{};
        for (int i = 0; i < 3; ++i)
            m[i] = maximum(absolute(ends[0][i]), absolute(ends[1][i])) + T(2) * radius;
        return m;
    }

    PW85_MEMBER Capsule in_unit(Unit unit) const noexcept
    {
        return {{unit.to_local(ends[0]), unit.to_local(ends[1])}, unit.to_local(radius)};
    }

    template <class W> PW85_MEMBER Capsule<W> with_digits_of() const noexcept
    {
        return {{converted<W>(ends[0]), converted<W>(ends[1])}, W(radius)};
    }

    /// A bound on the distances of points of the capsule from the centre.
    PW85_MEMBER T size() const noexcept { return reach_of(ends) + radius; }

    PW85_MEMBER bool passes_checks(SymmetricMatrix<T, 3> const &q) const noexcept
    {
        T const length = size(), form = largest_diagonal(q);
        return is_in_range(length, form, form) && radius >= T(0) && is_clearly_definite(q);
    }

    template <bool with_normal> PW85_MEMBER NearestOfBall<with_normal, T>
    nearest_at_end(int k, SymmetricMatrix<T, 3> const &q) const noexcept
    {
        T const distance = square_root(dot(ends[k], ends[k]));
        return nearest_of_ball<with_normal>(
            BallOnLine<T>{ends[k], {T(0), T(0), T(0)}, radius, T(distance - radius)}, q);
    }

    /// The point of least xᵀQ⁻¹x, always refined. Points of the segment are computed from the
    /// nearer end, so the other end, which may be far away, causes no loss of digits.
    template <bool with_normal, bool = true>
    PW85_MEMBER Nearest<T, with_normal> nearest(SymmetricMatrix<T, 3> const &q) const noexcept
    {
        Vector<T, 3> const zero{T(0), T(0), T(0)}, e = ends[1] - ends[0];
        T const from_first = -dot(ends[0], e), to_second = dot(ends[1], e);
        int const nearer = from_first > to_second ? 1 : 0;
        bool const at_end = !(minimum(from_first, to_second) > T(0));
        T const start = at_end ? T(0) : T((nearer == 1 ? T(-to_second) : from_first) / dot(e, e));
        BallOnLine<T> ball{add_scaled(ends[nearer], start, e), e, radius, T(0)};
        T const distance = square_root(dot(ball.base, ball.base)), u = T(unit_roundoff<T>());
        ball.clearance = distance - radius;
        bool const clear = absolute(ball.clearance) > T(64) * u * size();
        if (!(ball.clearance > T(0))) return {T(0), zero, Normal<T, 3, with_normal>{zero}, clear};
        auto found = nearest_outside<with_normal>(ball, nearer, start, q);
        found.certified = found.certified && clear;
        return found;
    }

    /// Item 4. `ball` is about the point of the segment that is nearest to the centre, `start`
    /// times e from the end `nearer`: 0 for the end itself.
    template <bool with_normal> PW85_MEMBER Nearest<T, with_normal>
    nearest_outside(BallOnLine<T> ball, int nearer, T const &start,
                    SymmetricMatrix<T, 3> const &q) const noexcept
    {
        T const inward = nearer == 0 ? T(1) : T(-1); // the sense of e that leads to the other end
        if (start == T(0)) {
            auto const at_end = nearest_at_end<with_normal>(nearer, q);
            if (inward * dot(at_end.s, ball.along) >= T(0)) return at_end.nearest;
            Vector<T, 3> const across = cross(ball.base, ball.along);
            T const square = dot(across, across) / dot(ball.along, ball.along);
            ball.clearance = square_root(square) - radius;
            if (!(ball.clearance > T(0))) return at_end.nearest;
        }
        auto const on_line = nearest_of_ball<with_normal>(ball, q);
        T const t = inward * (start + on_line.t);
        if (t >= T(0) && t <= T(1)) return on_line.nearest;
        return nearest_at_end<with_normal>(t > T(0) ? 1 - nearer : nearer, q).nearest;
    }

    [[gnu::always_inline]] bool overlaps_exactly(SymmetricMatrix<T, 3> const &q) const noexcept
    {
        return overlaps_with_more_digits(*this, q);
    }
};

/// Finds the nearest point with numbers of type W, which have more digits.
template <class W, class T> PW85_FUNCTION inline Nearest<T, false>
find_with_digits(Capsule<T> const &capsule, SymmetricMatrix<T, 3> const &q) noexcept
{
    auto const found =
        capsule.template with_digits_of<W>().template nearest<false>(converted<W>(q));
    return {rounded(found.mu2), rounded(found.point), {}, found.certified};
}

template <class T> PW85_RARE Nearest<T, false>
find_capsule_finer(Capsule<T> const &capsule, SymmetricMatrix<T, 3> const &q) noexcept
{
    return find_with_digits<Finer<T>>(capsule, q);
}

template <class T> PW85_RARE Nearest<T, false>
find_with_all_digits(Capsule<T> const &capsule, SymmetricMatrix<T, 3> const &q) noexcept
{
    return find_with_digits<Widened<T>>(capsule, q);
}

/// S of pw85_contact_segment() plus 2 r|s|, from a multiple of s.
template <class T> PW85_FUNCTION inline T sensitivity(Capsule<T> const &capsule,
                                                      SymmetricMatrix<T, 3> const &q,
                                                      Nearest<T, true> const &nearest) noexcept
{
    Vector<T, 3> const &s = nearest.normal.direction;
    T const scale = square_root(T(nearest.mu2 / quadratic_form(q, s)));
    T const terms = magnitude_of_dot(capsule.magnitudes(s), s);
    return scale * (scale * magnitude_of_form(q, s) + T(2) * terms);
}

/// Decides by μ² in numbers of type W, if it differs from 1 by more than the bound 80 u S of its
/// error.
template <class W, class T, class U> PW85_FUNCTION inline Decision
decide_with_digits(Capsule<T> const &capsule, SymmetricMatrix<T, 3> const &q, U const &u) noexcept
{
    auto const wide = capsule.template with_digits_of<W>();
    auto const form = converted<W>(q);
    auto const nearest = wide.template nearest<true>(form);
    bool const certified = nearest.certified || std::is_same_v<W, Widened<T>>;
    if (!certified || !(nearest.mu2 > W(0))) return certified ? Decision::overlap : Decision::none;
    W const error = W(80) * W(u) * sensitivity(wide, form, nearest);
    return to_decision(nearest.mu2 > W(W(1) + error), W(nearest.mu2 + error) < W(1));
}

/// Decides with twice the digits, and then with all digits. If these do not decide, the ellipsoid
/// and the capsule count as touching. This is wrong only for an overlap with 1 - μ² below 160 u S,
/// with the u of all digits: below 2⁻³⁶⁰ S for double.
template <class T> PW85_RARE bool overlaps_with_more_digits(Capsule<T> const &capsule,
                                                            SymmetricMatrix<T, 3> const &q) noexcept
{
    Unit const unit = unit_of(q);
    auto decision =
        decide_with_digits<Finer<T>>(capsule.in_unit(unit), unit.to_local(q), unit_roundoff<T>());
    if (decision == Decision::none)
        decision = decide_with_digits<Widened<T>>(capsule, q, unit_roundoff<Widened<T>>());
    return decision == Decision::overlap;
}

PW85_RARE_TIER_OF(find_capsule_finer, double)
PW85_RARE_TIER_OF(find_with_all_digits, double)
PW85_RARE_TIER_OF(overlaps_with_more_digits, double)

/// contact_capsule() in units in which the capsule and the form are of order one, if necessary with
/// more digits.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline ShapeContact<T, 3>
contact_scaled(Capsule<T> const &capsule, SymmetricMatrix<T, 3> const &q) noexcept
{
    StatusCode const status = capsule.is_valid() ? validate(q) : StatusCode::invalid_argument;
    if (status != StatusCode::success) return all_nan<ShapeContact<T, 3>>(status);
    T const largest = maximum(capsule.radius, maximum(largest_coordinate(capsule.ends[0]),
                                                      largest_coordinate(capsule.ends[1])));
    Unit const length{largest > T(0) ? binary_exponent(largest) : 0}, size = unit_of(q);
    auto const scaled = capsule.in_unit(length);
    auto const form = size.to_local(q);
    auto found = scaled.template nearest<false>(form);
    if (!found.certified) found = find_capsule_finer(scaled, form);
    if (!found.certified) {
        auto const all = find_with_all_digits(capsule, q);
        return {all.mu2, all.point, StatusCode::success};
    }
    return to_caller(found.mu2, found.point, length, size);
}

} // namespace pw85::detail

namespace pw85 {

template <class T>
PW85_FUNCTION inline ShapeContact<T, 3> contact_capsule(Vector<T, 3> const &end1,
                                                        Vector<T, 3> const &end2, T const &radius,
                                                        SymmetricMatrix<T, 3> const &q) noexcept
{
    if (radius == T(0)) return contact_segment(end1, end2, q);
    detail::Capsule<T> const capsule{{end1, end2}, radius};
    if (capsule.passes_checks(q)) {
        auto const found = capsule.template nearest<false>(q);
        if (found.certified) return {found.mu2, found.point, StatusCode::success};
    }
    return detail::contact_scaled(capsule, q);
}

template <class T>
PW85_FUNCTION inline ShapeOverlap overlap_capsule(Vector<T, 3> const &end1,
                                                  Vector<T, 3> const &end2, T const &radius,
                                                  SymmetricMatrix<T, 3> const &q) noexcept
{
    if (radius == T(0)) return overlap_segment(end1, end2, q);
    return detail::overlap_of(detail::Capsule<T>{{end1, end2}, radius}, q);
}

/// Item 1. The sign is that of the decision.
template <class T>
PW85_FUNCTION inline ShapeDistance<T> distance_capsule(Vector<T, 3> const &end1,
                                                       Vector<T, 3> const &end2, T const &radius,
                                                       SymmetricMatrix<T, 3> const &q) noexcept
{
    ShapeOverlap const decision = overlap_capsule(end1, end2, radius, q);
    if (decision.status != StatusCode::success)
        return detail::all_nan<ShapeDistance<T>>(decision.status);
    ShapeDistance<T> result = distance_segment(end1, end2, q);
    T const distance = result.distance - radius;
    result.distance =
        decision.overlap ? detail::minimum(distance, T(0)) : detail::maximum(distance, T(0));
    result.point2 = detail::add_scaled(result.point2, T(-radius), result.normal);
    return result;
}

} // namespace pw85

#endif

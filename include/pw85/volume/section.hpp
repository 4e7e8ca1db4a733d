// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The intersection of two ellipses as a polygon with segments of ellipses, for overlap_volume.hpp
/// and overlap_area_derivatives.hpp, if the error of the chords of chord_area.hpp may exceed the
/// bound.
///
/// The vertices of the polygon are the crossings of the circle and the ellipse (crossings.hpp).
/// Between two neighbouring vertices the border of the intersection is the arc of the circle if
/// this arc is inside the ellipse, and the arc of the ellipse otherwise. So the area is the sum of
/// the polygon and of one segment of an ellipse on each of its sides. All terms are positive, so
/// nothing cancels.
///
/// This holds for every type of intersection, without a test for its type:
///
/// 1. Two or four proper crossings are changes of sign of F on the circle, one for each.
/// 2. Where the bodies touch from inside, F has an extremum 0. The sign of its rounding error
///    decides whether there are two neighbouring crossings or none. Between them the border is
///    within δ/|∇F| of both curves, where δ bounds the error of F. So the error of the area is at
///    most δ/|∇F| times the length of the two arcs, which is about √(δ/|F''|). If the bodies cross
///    elsewhere, those crossings are changes of sign, as in item 1.
/// 3. Without any crossing, the circle is inside the ellipse, or the ellipse, which is not smaller,
///    is inside the circle, or they are apart. In the second case both bodies are nearly the same,
///    and the centre of the ellipse is near 0; in the third case it is outside the circle.
#ifndef PW85_VOLUME_SECTION_HPP_INCLUDED
#define PW85_VOLUME_SECTION_HPP_INCLUDED

#include <pw85/volume/circular_segment.hpp>
#include <pw85/volume/crossings.hpp>

namespace pw85::detail {

/// The coordinates of a crossing: on the unit circle, and relative to the centre of the ellipse in
/// its metric.
template <class T> struct BorderVertex {
    PlanePoint<T> on_circle, on_ellipse;
};

/// The ellipse of a joint frame with its crossings.
template <class T> struct PlaneBorder {
    FlattenedEllipse<T> ellipse;
    Crossings<T> crossings;
    BorderVertex<T> vertices[std::size_t(Crossings<T>::most)];

    PW85_MEMBER bool has_center_of_ellipse_inside() const noexcept
    {
        T const x = T(ellipse.d0 / ellipse.ratio), y = ellipse.d1;
        return absolute(x) < T(0.5) && absolute(y) < T(0.5);
    }
};

template <class T>
PW85_FUNCTION inline PlaneBorder<T> plane_border(JointFrame<T, 2> const &frame) noexcept
{
    auto const ellipse = flattened_ellipse(frame);
    PlaneBorder<T> border{ellipse, crossings(ellipse), {}};
    for (int k = 0; k < border.crossings.size; ++k) {
        auto const p = point_at(border.crossings.places[k]);
        border.vertices[k] = {p, ellipse.from_center(p)};
    }
    return border;
}

/// An arc of the border in the metric in which its body is a circle: the radius, half of the length
/// of the chord, the outward normal of the chord, and the cosine of half of the angle of the arc. A
/// whole body has a chord of length 0 and the cosine -1.
template <class T> struct BorderArc {
    T radius, half_length;
    PlanePoint<T> normal;
    T cosine;
};

/// The arc from a counter-clockwise to b, which are points relative to the centre.
template <class T> PW85_FUNCTION inline BorderArc<ResultOf<T>>
arc_between(T const &radius, PlanePoint<T> const &a, PlanePoint<T> const &b) noexcept
{
    using Result = ResultOf<T>;
    Result const r = rounded(radius), dx = rounded(T(b.x - a.x)), dy = rounded(T(b.y - a.y)),
                 length = square_root(Result(dx * dx + dy * dy)), half = Result(0.5);
    if (!(length > Result(0))) return {r, Result(0), {Result(1), Result(0)}, Result(1)};
    Result const nx = Result(dy / length), ny = Result(-(dx / length));
    Result const middle =
        Result(Result(rounded(T(a.x + b.x)) * nx) + Result(rounded(T(a.y + b.y)) * ny));
    return {r, Result(half * length), {nx, ny}, Result(Result(half * middle) / r)};
}

template <class T> PW85_FUNCTION inline BorderArc<T> whole_body(T const &radius) noexcept
{
    return {radius, T(0), {T(1), T(0)}, T(-1)};
}

/// The area of the segment between an arc and its chord, in the metric.
template <class T> PW85_FUNCTION inline T segment_of(BorderArc<T> const &arc) noexcept
{
    if (!(arc.half_length > T(0)) && arc.cosine > T(0)) return T(0);
    return circular_segment(arc.half_length, arc.radius, arc.cosine);
}

/// Chords shorter than this may be rounding errors alone.
template <class T> PW85_FUNCTION constexpr T shortest_safe_chord() noexcept
{
    return negative_power_of_two<T>(mantissa_digits<T>() / 3);
}

/// The arc of the border from one crossing to the next one.
///
/// The sign of the cosine states whether the arc is short or nearly the whole body. If two
/// crossings are very close, their chord is a rounding error, and so is this sign. The function
/// then finds the sign from `span`, the angle along the circle between the crossings in quarters,
/// which is reliable because the crossings are ordered.
///
/// 1. Below one quarter, the arc of the circle is short. So is the arc of the ellipse: half of the
///    ellipse has at least the area π/2, but the segment of the circle has at most the area π/4 -
///    1/2.
/// 2. Above three quarters, the arc of the circle is more than half of it. That of the ellipse has
///    a short chord. If it is more than half of the ellipse, so that half of the ellipse is inside
///    the circle, both axes are between 1/2 and 2, and the short chord cuts off next to nothing, so
///    that both bodies are nearly the same. Otherwise the intersection is next to the short arc of
///    the circle, and the centre of the ellipse is not within 1/2 of the centre of the circle along
///    both coordinates.
template <class T> PW85_FUNCTION inline BorderArc<ResultOf<T>>
arc_of_border(PlaneBorder<T> const &border, int k, int next, bool of_ellipse) noexcept
{
    using Result = ResultOf<T>;
    auto const &from = border.crossings.places[k], &to = border.crossings.places[next];
    auto const &p = border.vertices[k], &q = border.vertices[next];
    T const span = T(to.t - from.t) + T(to.quarter - from.quarter + (next > k ? 0 : 4));
    auto arc = of_ellipse ? arc_between(border.ellipse.radius, p.on_ellipse, q.on_ellipse)
                          : arc_between(T(1), p.on_circle, q.on_circle);
    Result const size = absolute(arc.cosine);
    if (span < T(1)) arc.cosine = size;
    if (!(span > T(3))) return arc;
    if (!of_ellipse) {
        arc.cosine = -size;
        return arc;
    }
    T const chord = maximum(absolute(T(q.on_circle.x - p.on_circle.x)),
                            absolute(T(q.on_circle.y - p.on_circle.y)));
    if (chord < shortest_safe_chord<T>())
        arc.cosine = border.has_center_of_ellipse_inside() ? -size : size;
    return arc;
}

/// Calls function(of_ellipse, arc, k, next) for each arc of the border, from vertex k to the next
/// one; for a whole body both are 0.
template <class T, class Function> PW85_FUNCTION inline void
for_each_arc(PlaneBorder<T> const &border, Function const &function) noexcept
{
    auto const &found = border.crossings;
    for (int k = 0; k < found.size; ++k) {
        bool const of_ellipse = (k % 2 == 0) != found.first_inside;
        int const next = k + 1 < found.size ? k + 1 : 0;
        function(of_ellipse, arc_of_border(border, k, next, of_ellipse), k, next);
    }
    if (found.size > 0) return;
    if (found.first_inside)
        function(false, whole_body(ResultOf<T>(1)), 0, 0);
    else if (border.has_center_of_ellipse_inside())
        function(true, whole_body(rounded(border.ellipse.radius)), 0, 0);
}

/// The area of the polygon, by triangles from its first vertex.
template <class T>
PW85_FUNCTION inline ResultOf<T> area_of_polygon(PlaneBorder<T> const &border) noexcept
{
    using Result = ResultOf<T>;
    auto const side = [&](int k) {
        auto const &o = border.vertices[0].on_circle, &p = border.vertices[k].on_circle;
        return PlanePoint<Result>{rounded(T(p.x - o.x)), rounded(T(p.y - o.y))};
    };
    Result twice = Result(0);
    for (int k = 1; k + 1 < border.crossings.size; ++k) {
        auto const p = side(k), q = side(k + 1);
        twice = twice + (Result(p.x * q.y) - Result(p.y * q.x));
    }
    return Result(Result(0.5) * twice);
}

/// The area of the intersection.
template <class T>
PW85_FUNCTION inline ResultOf<T> area_inside(PlaneBorder<T> const &border) noexcept
{
    using Result = ResultOf<T>;
    Result circle = Result(0), ellipse = Result(0);
    for_each_arc(border, [&](bool of_ellipse, BorderArc<Result> const &arc, int, int) {
        Result &sum = of_ellipse ? ellipse : circle;
        sum = sum + segment_of(arc);
    });
    return Result(circle + Result(ellipse / rounded(border.ellipse.ratio))) +
           area_of_polygon(border);
}

} // namespace pw85::detail

#endif

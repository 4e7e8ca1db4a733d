// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The common part of two ellipses as a polygon with segments of ellipses, for overlap_volume.hpp
/// and overlap_area_derivatives.hpp, where the chords of chord_area.hpp have no margin.
///
/// The vertices of the polygon are the crossings of the circle and the ellipse (crossings.hpp).
/// Between two neighbouring ones the border of the common part is the arc of the circle if that is
/// inside the ellipse, and the arc of the ellipse otherwise. So the area is that of the polygon, and
/// of a segment of an ellipse on each of its sides. All parts are positive: nothing cancels.
///
/// This holds for every kind of intersection, and no kind is decided beforehand:
///
/// 1. Two or four proper crossings are changes of sign of F on the circle, one for each.
/// 2. Where the bodies touch from inside, F has an extremum 0. With the sign of its rounding error,
///    it has two crossings next to each other or none. The border between them is within δ/|∇F| of
///    both curves, where δ bounds the error of F. So the area errs by at most their length times
///    that, as by an error of any other crossing, and the two arcs are as short as √(δ/|F''|). If
///    the bodies cross elsewhere, those crossings are changes of sign, as in item 1.
/// 3. Without any crossing, the circle is inside the ellipse, or the ellipse, which is not smaller,
///    is inside the circle, or they are apart. In the second case both bodies are nearly the same,
///    and the centre of the ellipse is near 0; in the third case it is outside of the circle.
#ifndef PW85_VOLUME_SECTION_HPP_INCLUDED
#define PW85_VOLUME_SECTION_HPP_INCLUDED

#include <pw85/volume/circular_segment.hpp>
#include <pw85/volume/crossings.hpp>

namespace pw85::detail {

/// An arc of the border in the metric of its body, where it is one of a circle: half of the length
/// of its chord, the outward normal of the chord, and the cosine of half of the angle of the arc.
/// `chord` is the chord in the joint frame. A whole body has a chord of length 0 and the cosine -1.
template <class T> struct BorderArc {
    bool of_ellipse;
    T radius, half_length;
    PlanePoint<T> normal, chord;
    T cosine;
};

/// The arc from p counter-clockwise to q, whose points in the metric relative to the centre of the
/// body are a and b.
template <class T>
PW85_FUNCTION inline BorderArc<T> arc_between(bool of_ellipse, T const &radius,
                                              PlanePoint<T> const &a, PlanePoint<T> const &b,
                                              PlanePoint<T> const &chord) noexcept
{
    T const dx = T(b.x - a.x), dy = T(b.y - a.y), length = square_root(T(dx * dx + dy * dy));
    if (!(length > T(0))) return {of_ellipse, radius, T(0), {T(1), T(0)}, {T(0), T(0)}, T(1)};
    T const nx = T(dy / length), ny = T(-(dx / length)), half = T(0.5);
    T const middle = T(T(T(a.x + b.x) * nx) + T(T(a.y + b.y) * ny));
    return {of_ellipse, radius, T(half * length), {nx, ny}, chord, T(T(half * middle) / radius)};
}

template <class T>
PW85_FUNCTION inline BorderArc<T> whole_body(bool of_ellipse, T const &radius) noexcept
{
    return {of_ellipse, radius, T(0), {T(1), T(0)}, {T(0), T(0)}, T(-1)};
}

/// The area of the segment between an arc and its chord, in the metric. It has the relative accuracy
/// of a result, so that it needs no wider numbers.
template <class T> PW85_FUNCTION inline T segment_of(BorderArc<T> const &arc) noexcept
{
    if (!(arc.half_length > T(0)) && arc.cosine > T(0)) return T(0);
    return T(circular_segment(rounded(arc.half_length), rounded(arc.radius), rounded(arc.cosine)));
}

/// A joint frame with the crossings of its circle and ellipse.
template <class T> struct PlaneBorder {
    FlattenedEllipse<T> ellipse;
    Crossings<T> crossings;

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
    return {ellipse, crossings(ellipse)};
}

/// Chords shorter than this may be rounding errors alone.
template <class T> PW85_FUNCTION constexpr T shortest_safe_chord() noexcept
{
    return negative_power_of_two<T>(mantissa_digits<T>() / 3);
}

/// The arc of the border from one crossing to the next one.
///
/// The chord of two crossings next to each other is a rounding error, and so is the sign of the
/// cosine from it: it says whether the arc is short or nearly the whole body. `span` is the angle
/// along the circle in quarters, from the places, which have an order.
///
/// 1. Below one quarter, the arc of the circle is short. That of the ellipse is, too: half of the
///    ellipse, π/2 at least, has no room in the segment of the circle, π/4 - 1/2.
/// 2. Above three quarters, the arc of the circle is more than half of it. That of the ellipse has a
///    short chord. If it is more than half of the ellipse, so that half of the ellipse is inside the
///    circle, both axes are between 1/2 and 2, and the short chord cuts off next to nothing, so that
///    both bodies are nearly the same. Otherwise the common part is next to the short arc of the
///    circle, and the centre of the ellipse is not inside the circle by as much as a half.
template <class T> PW85_FUNCTION inline BorderArc<T> arc_of_border(PlaneBorder<T> const &border,
                                                                   int k, bool of_ellipse) noexcept
{
    auto const &found = border.crossings;
    int const next = (k + 1) % found.size;
    auto const &from = found.places[k], &to = found.places[next];
    T const span = T(to.t - from.t) + T(to.quarter - from.quarter + (next > k ? 0 : 4));
    auto const p = point_at(from), q = point_at(to);
    PlanePoint<T> const chord{T(q.x - p.x), T(q.y - p.y)};
    auto const &e = border.ellipse;
    auto arc = of_ellipse ? arc_between(true, e.radius, e.from_center(p), e.from_center(q), chord)
                          : arc_between(false, T(1), p, q, chord);
    T const size = absolute(arc.cosine);
    bool const is_short = maximum(absolute(chord.x), absolute(chord.y)) < shortest_safe_chord<T>();
    if (span < T(1)) arc.cosine = size;
    if (span > T(3) && !of_ellipse) arc.cosine = -size;
    if (span > T(3) && of_ellipse && is_short)
        arc.cosine = border.has_center_of_ellipse_inside() ? T(-size) : size;
    return arc;
}

/// Calls function(arc) for each arc of the border.
template <class T, class Function> PW85_FUNCTION inline void
for_each_arc(PlaneBorder<T> const &border, Function const &function) noexcept
{
    auto const &found = border.crossings;
    for (int k = 0; k < found.size; ++k)
        function(arc_of_border(border, k, (k % 2 == 0) != found.first_inside));
    if (found.size > 0) return;
    if (found.first_inside)
        function(whole_body(false, T(1)));
    else if (border.has_center_of_ellipse_inside())
        function(whole_body(true, border.ellipse.radius));
}

/// The area of the polygon, by triangles from its first vertex.
template <class T> PW85_FUNCTION inline T area_of_polygon(Crossings<T> const &found) noexcept
{
    T twice = T(0);
    for (int k = 1; k + 1 < found.size; ++k) {
        auto const o = point_at(found.places[0]), p = point_at(found.places[k]),
                   q = point_at(found.places[k + 1]);
        twice = twice + (T(T(p.x - o.x) * T(q.y - o.y)) - T(T(p.y - o.y) * T(q.x - o.x)));
    }
    return T(T(0.5) * twice);
}

/// The area of the common part.
template <class T> PW85_FUNCTION inline T area_inside(PlaneBorder<T> const &border) noexcept
{
    T circle = T(0), ellipse = T(0);
    for_each_arc(border, [&](BorderArc<T> const &arc) {
        T &sum = arc.of_ellipse ? ellipse : circle;
        sum = sum + segment_of(arc);
    });
    return T(circle + T(ellipse / border.ellipse.ratio)) + area_of_polygon(border.crossings);
}

} // namespace pw85::detail

#endif

// SPDX-License-Identifier: BSD-3-Clause
// The functions for one ellipsoid and a convex set (one_set.hpp). They are compiled for the
// instruction sets of the functions for one pair.
//
// The formulas are those of many rows (lanes/shapes.hpp), with the same numbers in both lanes. So
// select() is an instruction. It is not a branch, which the processor could not predict. Two faces
// of a box are computed side by side.
#define PW85_TWO_LANES // One row has no use for more.
#include "../one_set.hpp"
#include "../pack.hpp"

#include <pw85/shapes/overlap_shapes.hpp>

namespace pw85::detail::kernels {

namespace {

static_assert(lanes == 2);

PW85_INLINE Vector<Pack, 3> load_point(double const *x) noexcept
{
    return {Pack(x[0]), Pack(x[1]), Pack(x[2])};
}

PW85_INLINE SymmetricMatrix<Pack, 3> load_form(double const *q) noexcept
{
    return {{Pack(q[0]), Pack(q[1]), Pack(q[2]), Pack(q[3]), Pack(q[4]), Pack(q[5])}};
}

/// Returns the first lane of one pack, and the second lane of another.
PW85_INLINE Pack lanes_of(Pack const &first, Pack const &second) noexcept
{
    return Register{first.v[0], second.v[1]};
}

template <int N>
PW85_INLINE Vector<Pack, N> lanes_of(Vector<Pack, N> first, Vector<Pack, N> const &second) noexcept
{
    for (int i = 0; i < N; ++i) first[i] = lanes_of(first[i], second[i]);
    return first;
}

PW85_INLINE BoxProblem<Pack, 3> lanes_of(BoxProblem<Pack, 3> first,
                                         BoxProblem<Pack, 3> const &second) noexcept
{
    for (int k = 0; k < 6; ++k) first.q[k] = lanes_of(first.q[k], second.q[k]);
    return {lanes_of(first.lower, second.lower), lanes_of(first.upper, second.upper),
            lanes_of(first.center, second.center), first.q};
}

/// One lane of the numbers, in both lanes.
PW85_INLINE BoxMinimum<Pack, 3> lane_of(BoxMinimum<Pack, 3> minimum, std::size_t lane) noexcept
{
    for (Pack *x : {&minimum.value, &minimum.point[0], &minimum.point[1], &minimum.point[2]})
        *x = Pack((*x)[lane]);
    return minimum;
}

/// Returns the coordinates with that of axis i first.
PW85_INLINE Vector<Pack, 3> with_axis_first(Vector<Pack, 3> const &x, int i) noexcept
{
    return {x[i], x[other_axis(i, 0)], x[other_axis(i, 1)]};
}

PW85_INLINE BoxProblem<Pack, 3> with_axis_first(BoxProblem<Pack, 3> const &box, int i) noexcept
{
    int const j = other_axis(i, 0), k = other_axis(i, 1);
    return {with_axis_first(box.lower, i),
            with_axis_first(box.upper, i),
            with_axis_first(box.center, i),
            {{box.q(i, i), box.q(i, j), box.q(i, k), box.q(j, j), box.q(j, k), box.q(k, k)}}};
}

/// Returns the inverse, for the point of a minimum.
PW85_INLINE BoxMinimum<Pack, 3> with_axis_at(BoxMinimum<Pack, 3> const &minimum, int i) noexcept
{
    BoxMinimum<Pack, 3> turned = minimum;
    turned.point[i] = minimum.point[0];
    for (int k = 0; k < 2; ++k) turned.point[other_axis(i, k)] = minimum.point[k + 1];
    return turned;
}

/// Returns the minimum on the face that is orthogonal to the first axis. It is infinite if the face
/// does not face the centre.
PW85_INLINE BoxMinimum<Pack, 3> minimum_on_first_face(BoxProblem<Pack, 3> const &box) noexcept
{
    Pack const x = clamped(box.center[0], box.lower[0], box.upper[0]), offset = x - box.center[0];
    auto minimum = minimum_on_face(box, 0, x, offset);
    minimum.value = select(offset == Pack(0.0), infinity<Pack>(), minimum.value);
    return minimum;
}

/// minimum_in_box() for a box that is not around the centre, with two faces side by side.
PW85_INLINE BoxMinimum<Pack, 3> minimum_of_faces(BoxProblem<Pack, 3> const &box) noexcept
{
    auto const two =
        minimum_on_first_face(lanes_of(with_axis_first(box, 0), with_axis_first(box, 1)));
    BoxMinimum<Pack, 3> best = lane_of(two, 0);
    for (int i = 1; i < 3; ++i) {
        auto const one = i == 1 ? lane_of(two, 1) : minimum_on_first_face(with_axis_first(box, 2));
        best = choose(one.value < best.value, with_axis_at(one, i), best);
    }
    return best;
}

struct OneBox : SolidBox<Pack> {
    template <bool with_normal>
    PW85_INLINE Nearest<Pack, with_normal> nearest(SymmetricMatrix<Pack, 3> const &q) const noexcept
    {
        BoxProblem<Pack, 3> const box{lower, upper, {Pack(0.0), Pack(0.0), Pack(0.0)}, q};
        return nearest_at<with_normal>(minimum_of_faces(box), box);
    }
};

template <class... Points> PW85_INLINE auto load_hull(Points... points) noexcept
{
    return Hull<Pack, sizeof...(points)>{{load_point(points)...}};
}

PW85_INLINE OneBox load_box(double const *lower, double const *upper) noexcept
{
    return {{load_point(lower), load_point(upper)}};
}

template <class Shape> PW85_INLINE bool contact_of_one(Shape const &shape, double const *q,
                                                       double *mu2, double *point) noexcept
{
    auto const form = load_form(q);
    auto const nearest = shape.template nearest<false>(form);
    if (!all_of(nearest.certified && shape.passes_checks(form))) return false;
    if (mu2 != nullptr) *mu2 = first_lane(nearest.mu2);
    for (int i = 0; point != nullptr && i < 3; ++i) point[i] = first_lane(nearest.point[i]);
    return true;
}

template <class Shape>
PW85_INLINE bool overlap_of_one(Shape const &shape, double const *q, int *overlap) noexcept
{
    auto const form = load_form(q);
    auto const certainty = decide_at(shape, form, shape.template nearest<true>(form));
    if (!all_of((certainty.apart || certainty.overlap) && shape.passes_checks(form))) return false;
    *overlap = all_of(certainty.overlap) ? 1 : 0;
    return true;
}

} // namespace

namespace PW85_BUILDING {

[[gnu::flatten]] bool contact_segment(double const *first, double const *second, double const *q,
                                      double *mu2, double *point) noexcept
{
    return contact_of_one(load_hull(first, second), q, mu2, point);
}

[[gnu::flatten]] bool overlap_segment(double const *first, double const *second, double const *q,
                                      int *overlap) noexcept
{
    return overlap_of_one(load_hull(first, second), q, overlap);
}

[[gnu::flatten]] bool contact_box(double const *first, double const *second, double const *q,
                                  double *mu2, double *point) noexcept
{
    return contact_of_one(load_box(first, second), q, mu2, point);
}

[[gnu::flatten]] bool overlap_box(double const *first, double const *second, double const *q,
                                  int *overlap) noexcept
{
    return overlap_of_one(load_box(first, second), q, overlap);
}

[[gnu::flatten]] bool contact_triangle(double const *vertex1, double const *vertex2,
                                       double const *vertex3, double const *q, double *mu2,
                                       double *point) noexcept
{
    return contact_of_one(load_hull(vertex1, vertex2, vertex3), q, mu2, point);
}

[[gnu::flatten]] bool overlap_triangle(double const *vertex1, double const *vertex2,
                                       double const *vertex3, double const *q,
                                       int *overlap) noexcept
{
    return overlap_of_one(load_hull(vertex1, vertex2, vertex3), q, overlap);
}

} // namespace PW85_BUILDING

} // namespace pw85::detail::kernels

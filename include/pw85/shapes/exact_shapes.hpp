// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Decides in integers (integer_shapes.hpp) whether a convex set overlaps an ellipsoid with its
/// centre at 0. overlap_shapes.hpp calls these functions. A set that only touches the ellipsoid
/// does not overlap it.
///
/// 1. A point x overlaps if xᵀ adj(Q) x < det Q.
/// 2. The nearest point of the line through a and b is between them if a·f < 0 < b·f with e = b - a
///    and f = adj(Q) e. Then the segment overlaps if mᵀQm < e·f with m = a × b (segment.hpp).
///    Otherwise the nearer end decides.
/// 3. If no edge of a triangle overlaps, the ellipse in which its plane cuts the ellipsoid is
///    either inside the triangle or outside it. With n = (b - a) × (c - a), the ellipse exists if
///    (a·(b × c))² < nᵀQn. Its centre has the barycentric weights (b × c)·Qn, (c × a)·Qn and (a ×
///    b)·Qn, up to a positive factor.
/// 4. If no edge of a box overlaps, the same holds for its faces. The ellipse in the plane x_i = c
///    exists if c² < Q_ii, and its centre has the coordinates Q_ij c/Q_ii.
#ifndef PW85_SHAPES_EXACT_SHAPES_HPP_INCLUDED
#define PW85_SHAPES_EXACT_SHAPES_HPP_INCLUDED

#include <pw85/shapes/box.hpp>
#include <pw85/shapes/integer_shapes.hpp>

namespace pw85::detail {

namespace exact {

/// Returns the limbs of mᵀQm - e·f, for c limbs of a coordinate and f limbs of an entry of the
/// form. m has up to 2 c + 1 limbs, f 2 f + c + 1.
PW85_FUNCTION constexpr int limbs_of_line(int c, int f) noexcept
{
    return 2 * c + 3 + f + maximum(f, 2 * c);
}

/// Item 1.
template <class T, std::size_t N>
PW85_FUNCTION inline bool point_overlaps(Workspace space, ShapeNumbers<T, N> const &numbers,
                                         WideForm const &q, Corner<T> const &corner) noexcept
{
    WideVector const x = integers_of(space, numbers, corner),
                     f = product_with_adjugate(space, q, x);
    WideVector const row = row_of_adjugate(space, q, 0);
    return sign_of(space, {{x.x[0], f.x[0], 1},
                           {x.x[1], f.x[1], 1},
                           {x.x[2], f.x[2], 1},
                           {q(0, 0), row.x[0], -1},
                           {q(0, 1), row.x[1], -1},
                           {q(0, 2), row.x[2], -1}}) < 0;
}

/// The sign of a·f for a corner a.
template <class T, std::size_t N>
PW85_FUNCTION inline int sign_of_dot_with(Workspace space, ShapeNumbers<T, N> const &numbers,
                                          Corner<T> const &a, WideVector const &f) noexcept
{
    WideVector const x = integers_of(space, numbers, a);
    return sign_of_dot(space, x, f);
}

/// Locates the nearest point of the line through two corners: before the first one (-1), between
/// them, or after the second one (1). Subtracts e·f from the sum.
template <class T, std::size_t N>
PW85_FUNCTION inline int place_on_line(Workspace space, ShapeNumbers<T, N> const &numbers,
                                       WideForm const &q, Corner<T> const &first,
                                       Corner<T> const &second, WideSum sum) noexcept
{
    WideVector const e = difference(space, numbers, second, first),
                     f = product_with_adjugate(space, q, e);
    for (int i = 0; i < 3; ++i) add_product(sum, -1, e.x[i], f.x[i]);
    if (sign_of_dot_with(space, numbers, first, f) >= 0) return -1;
    return sign_of_dot_with(space, numbers, second, f) <= 0 ? 1 : 0;
}

/// Item 2.
template <class T, std::size_t N>
PW85_FUNCTION inline bool segment_overlaps(Workspace space, ShapeNumbers<T, N> const &numbers,
                                           WideForm const &q, Corner<T> const &first,
                                           Corner<T> const &second) noexcept
{
    Workspace rest = space;
    WideSum const sum = rest.take(limbs_of_line(numbers.coordinate_limbs, numbers.entry_limbs));
    int const place = place_on_line(rest, numbers, q, first, second, sum);
    if (place != 0) return point_overlaps(space, numbers, q, place < 0 ? first : second);
    WideVector const a = integers_of(rest, numbers, first),
                     m = cross(rest, a, integers_of(rest, numbers, second));
    WideVector const y = product(rest, q, m);
    for (int i = 0; i < 3; ++i) add_product(sum, 1, m.x[i], y.x[i]);
    return value(sum).sign < 0;
}

/// The cross product of two vectors with coordinates of this many limbs. The vectors do not stay in
/// memory.
template <class First, class Second> PW85_FUNCTION inline WideVector
cross_of(Workspace &space, int limbs, First const &first, Second const &second) noexcept
{
    WideSum sums[3];
    for (auto &sum : sums) sum = space.take(2 * limbs + 1);
    Workspace rest = space;
    WideVector const a = first(rest), b = second(rest);
    WideVector n;
    for (int i = 0; i < 3; ++i) {
        int const j = (i + 1) % 3, k = (i + 2) % 3;
        add_product(sums[i], 1, a.x[j], b.x[k]);
        add_product(sums[i], -1, a.x[k], b.x[j]);
        n.x[i] = value(sums[i]);
    }
    return n;
}

/// Item 3, for the inside of a triangle.
template <class T> PW85_FUNCTION inline bool
plane_overlaps(Workspace space, ShapeNumbers<T, 3> const &numbers, WideForm const &q) noexcept
{
    auto const from_first = [&](int k) {
        return [&numbers, k](Workspace &w) {
            return difference(w, numbers, numbers.corners[k], numbers.corners[0]);
        };
    };
    auto const vertex = [&](int k) {
        return [&numbers, k](Workspace &w) { return integers_of(w, numbers, numbers.corners[k]); };
    };
    int const limbs = numbers.coordinate_limbs;
    WideVector const n = cross_of(space, limbs, from_first(1), from_first(2)),
                     y = product(space, q, n);
    for (int k = 0; k < 3; ++k) {
        Workspace rest = space;
        WideVector const m = cross_of(rest, limbs, vertex((k + 1) % 3), vertex((k + 2) % 3));
        if (sign_of_dot(rest, m, y) < 0) return false;
    }
    WideVector const a = integers_of(space, numbers, numbers.corners[0]);
    WideInteger const offset =
        // a·n is a·(b × c)
        sum_of(space, {{a.x[0], n.x[0], 1}, {a.x[1], n.x[1], 1}, {a.x[2], n.x[2], 1}});
    return sign_of(space, {{offset, offset, 1},
                           {n.x[0], y.x[0], -1},
                           {n.x[1], y.x[1], -1},
                           {n.x[2], y.x[2], -1}}) < 0;
}

/// The limbs of all integers that are in use at one time, for any numbers: those of the form, and
/// the largest of those of items 1 to 3. A coordinate has up to c limbs, an entry of the form up to
/// f.
template <class T> PW85_FUNCTION constexpr int limbs_for_shapes() noexcept
{
    using Limits = std::numeric_limits<T>;
    constexpr int digits = Limits::digits - Limits::min_exponent;
    constexpr int c = limbs_for(Limits::max_exponent + digits + 2),
                  f = limbs_for(Limits::max_exponent + 2 * digits + 2);
    // x, adj(Q) x and a row of adj(Q)
    constexpr int adjugate = 3 * c + 3 * (2 * f + c + 2) + 3 * (2 * f + 1);
    constexpr int point = adjugate + maximum(3 * f + 1, 2 * f + 2 * c + 4);
    constexpr int line =
        limbs_of_line(c, f) +
        maximum(maximum(adjugate, 6 * c + 3 * (2 * f + c + 2) + (2 * f + 2 * c + 3)),
                6 * c + 3 * (2 * c + 1) + 3 * (f + 2 * c + 2));
    constexpr int plane = 3 * (2 * c + 1) + 3 * (f + 2 * c + 2) +
                          maximum(3 * (2 * c + 1) + maximum(6 * c, f + 4 * c + 6), 12 * c + 12);
    return 6 * f + maximum(point, maximum(line, plane));
}

/// Returns whether the plane x_i = c cuts the ellipsoid, and the centre of the ellipse is in the
/// box (item 4).
template <class T>
PW85_FUNCTION inline bool face_overlaps(Workspace space, ShapeNumbers<T, 2> const &numbers,
                                        WideForm const &q, int i, int side) noexcept
{
    WideVector const lower = integers_of(space, numbers, numbers.corners[0]),
                     upper = integers_of(space, numbers, numbers.corners[1]);
    WideInteger const c = side == 0 ? lower.x[i] : upper.x[i];
    for (int j = 0; j < 3; ++j) {
        if (j == i) continue;
        if (sign_of(space, {{q(i, j), c, 1}, {q(i, i), lower.x[j], -1}}) < 0) return false;
        if (sign_of(space, {{q(i, j), c, 1}, {q(i, i), upper.x[j], -1}}) > 0) return false;
    }
    Limb const unit[1] = {1};
    return sign_of(space, {{c, c, 1}, {q(i, i), {unit, 1, 1}, -1}}) < 0;
}

/// The corner of a box with upper coordinates where the bits of `code` are set.
template <class T>
PW85_FUNCTION inline Corner<T> corner_of_box(ShapeNumbers<T, 2> const &numbers, int code) noexcept
{
    Corner<T> corner;
    for (int i = 0; i < 3; ++i) corner.x[i] = numbers.corners[code >> i & 1].x[i];
    return corner;
}

} // namespace exact

/// Returns whether a segment or a triangle overlaps the ellipsoid, for the numbers exactly as
/// given; the function for a box follows. The functions use a fixed array on the stack: 10 KiB for
/// double.
template <class T, std::size_t N>
requires exact::is_decidable<T> PW85_RARE bool
overlaps_exactly(Vector<T, 3> const (&points)[N], SymmetricMatrix<T, 3> const &q) noexcept
{
    using namespace exact;
    static_assert(N == 2 || N == 3);
    Limb memory[limbs_for_shapes<T>()];
    Workspace space{memory};
    auto const numbers = to_shape_numbers(points, q);
    auto const form = integers_of_form(space, numbers);
    for (std::size_t k = 0; k < (N == 2 ? 1 : N); ++k)
        if (segment_overlaps(space, numbers, form, numbers.corners[k],
                             numbers.corners[(k + 1) % N]))
            return true;
    if constexpr (N == 3) return plane_overlaps(space, numbers, form);
    return false;
}

template <class T>
requires exact::is_decidable<T> PW85_RARE bool
box_overlaps_exactly(Vector<T, 3> const &lower, Vector<T, 3> const &upper,
                     SymmetricMatrix<T, 3> const &q) noexcept
{
    using namespace exact;
    if (largest_coordinate(nearest_corner(lower, upper)) == T(0)) return true;
    Limb memory[limbs_for_shapes<T>()];
    Workspace space{memory};
    auto const numbers = to_shape_numbers<T, 2>({lower, upper}, q);
    auto const form = integers_of_form(space, numbers);
    for (int i = 0; i < 3; ++i)
        for (int code = 0; code < 8; ++code)
            if ((code >> i & 1) == 0 &&
                segment_overlaps(space, numbers, form, corner_of_box(numbers, code),
                                 corner_of_box(numbers, code | 1 << i)))
                return true;
    for (int i = 0; i < 3; ++i)
        if (face_overlaps(space, numbers, form, i, 0) || face_overlaps(space, numbers, form, i, 1))
            return true;
    return false;
}

PW85_RARE_TIER_OF(overlaps_exactly, double, 2)
PW85_RARE_TIER_OF(overlaps_exactly, double, 3)
PW85_RARE_TIER_OF(box_overlaps_exactly, double)

} // namespace pw85::detail

#endif

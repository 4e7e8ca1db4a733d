// SPDX-License-Identifier: BSD-3-Clause
// Tests of an ellipse and points, segments and boxes of the plane against formulas of the plane in
// 50 digits, which share nothing with the functions in space.
#include <cmath>
#include <limits>
#include <string>

#include <glib.h>

#include <pw85.h>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

using Vector2 = pw85::Vector<double, 2>;
using Form2 = pw85::SymmetricMatrix<double, 2>;

constexpr double u = 0x1p-53;

/// Two points, the ends of a segment or the corners of a box, and an ellipse.
struct Case2 {
    Vector2 a, b;
    Form2 q;
};

std::string text(Case2 const &c)
{
    return "q = " + hex_text(c.q.entries, 3) + ", " + hex_text(c.a.coordinates, 2) + ", " +
           hex_text(c.b.coordinates, 2);
}

/// The least xᵀQ⁻¹x, the sum S of pw85_shapes.h, and what rounding the point changes to second
/// order: XᵀPX with X = Σ w_k |v_k| and P the magnitudes of Q⁻¹.
struct Least {
    Wide mu2 = -1, sensitivity = 0, square = 0;
};

/// Remembers the point (1 - t) a + t b, if it is nearer.
void take(Least &best, Case2 const &c, Wide const &t, Vector2 const &a, Vector2 const &b)
{
    Wide const xx(c.q[0]), xy(c.q[1]), yy(c.q[2]), det = xx * yy - xy * xy, rest = 1 - t;
    Wide const x = rest * Wide(a[0]) + t * Wide(b[0]), y = rest * Wide(a[1]) + t * Wide(b[1]);
    Wide const sx = (yy * x - xy * y) / det, sy = (xx * y - xy * x) / det, mu2 = x * sx + y * sy;
    if (best.mu2 >= 0 && best.mu2 <= mu2) return;
    Wide const width = rest * abs(Wide(a[0])) + t * abs(Wide(b[0])),
               height = rest * abs(Wide(a[1])) + t * abs(Wide(b[1]));
    best.mu2 = mu2;
    best.sensitivity = sx * sx * xx + 2 * abs(Wide(sx * sy * xy)) + sy * sy * yy +
                       2 * abs(sx) * width + 2 * abs(sy) * height;
    best.square = (yy * width * width + 2 * abs(xy) * width * height + xx * height * height) / det;
}

/// The ends, and the point between them where the derivative of the quadratic polynomial is 0.
void take_segment(Least &best, Case2 const &c, Vector2 const &a, Vector2 const &b)
{
    Wide const xx(c.q[0]), xy(c.q[1]), yy(c.q[2]);
    Wide const dx = Wide(b[0]) - Wide(a[0]), dy = Wide(b[1]) - Wide(a[1]);
    Wide const sx = yy * dx - xy * dy, sy = xx * dy - xy * dx, length = dx * sx + dy * sy;
    take(best, c, Wide(0), a, b);
    take(best, c, Wide(1), a, b);
    if (!(length > 0)) return;
    Wide const t = -(Wide(a[0]) * sx + Wide(a[1]) * sy) / length;
    if (t > 0 && t < 1) take(best, c, t, a, b);
}

struct Segment {
    static constexpr char const *name = "segment";

    static Least truth(Case2 const &c)
    {
        Least best;
        take_segment(best, c, c.a, c.b);
        return best;
    }
    static int contact(Case2 const &c, double *mu2, Vector2 &point)
    {
        return pw85_contact_segment_2d(c.a.coordinates, c.b.coordinates, c.q.entries, mu2,
                                       point.coordinates);
    }
    static int overlap(Case2 const &c, int *overlap)
    {
        return pw85_overlap_segment_2d(c.a.coordinates, c.b.coordinates, c.q.entries, overlap);
    }
};

struct Box {
    static constexpr char const *name = "box";

    static Least truth(Case2 const &c)
    {
        if (c.a[0] <= 0 && c.b[0] >= 0 && c.a[1] <= 0 && c.b[1] >= 0)
            return {Wide(0), Wide(0), Wide(0)};
        Vector2 const corners[] = {c.a, {c.b[0], c.a[1]}, c.b, {c.a[0], c.b[1]}, c.a};
        Least best;
        for (int k = 0; k < 4; ++k) take_segment(best, c, corners[k], corners[k + 1]);
        return best;
    }
    static int contact(Case2 const &c, double *mu2, Vector2 &point)
    {
        return pw85_contact_box_2d(c.a.coordinates, c.b.coordinates, c.q.entries, mu2,
                                   point.coordinates);
    }
    static int overlap(Case2 const &c, int *overlap)
    {
        return pw85_overlap_box_2d(c.a.coordinates, c.b.coordinates, c.q.entries, overlap);
    }
};

Form2 random_ellipse(Random &random)
{
    double const size = std::ldexp(1.0, static_cast<int>(random.uniform(-40.0, 41.0)));
    return random_form<2>(random, size, random.log_uniform(1.0, 1e6));
}

double size_of(Form2 const &q) { return std::sqrt(q[0] + q[2]); }

/// A point near the surface or at any distance.
Vector2 random_place(Random &random, Form2 const &q, int n)
{
    if (n % 2 == 0) return random.log_uniform(0.01, 10.0) * size_of(q) * random.direction<2>();
    return random.log_uniform(0.5, 2.0) * pw85::detail::support(q, random.direction<2>()).point;
}

template <class Shape> Case2 random_case(Random &random, int n)
{
    auto const q = random_ellipse(random);
    Vector2 const place = random_place(random, q, n);
    double const size = size_of(q) * random.log_uniform(1e-6, 1e4);
    Vector2 const to_a = size * random.direction<2>(), to_b = size * random.direction<2>();
    Case2 c{place + to_a, place + to_b, q};
    for (int i = 0; std::is_same_v<Shape, Box> && i < 2; ++i) {
        if (random.uniform(0.0, 1.0) < 0.1) c.b[i] = c.a[i];
        if (c.a[i] > c.b[i]) std::swap(c.a[i], c.b[i]);
    }
    return c;
}

Wide value_at(Form2 const &q, Vector2 const &point)
{
    Least least;
    take(least, {point, point, q}, Wide(0), point, point);
    return least.mu2;
}

template <class Shape> void test_contact()
{
    Failures failures;
    Random random(7401);
    for (int n = 0; n < draws(20000); ++n) {
        Case2 const c = random_case<Shape>(random, n);
        Least const truth = Shape::truth(c);
        double mu2;
        Vector2 point{};
        failures.check(Shape::contact(c, &mu2, point) == PW85_SUCCESS, "status", 1.0, 0.0,
                       [&] { return text(c); });
        Wide const bound = 80 * u * truth.sensitivity;
        failures.check(abs(Wide(mu2 - truth.mu2)) <= bound, Shape::name, mu2,
                       static_cast<double>(truth.mu2), [&] { return text(c); });
        // The point is as near, but for its rounding: to first order by S, then by the square.
        Wide const excess = value_at(c.q, point) - truth.mu2,
                   rounding = 80 * Wide(u) * 80 * Wide(u) * truth.square;
        failures.check(abs(excess) <= bound + rounding, "point", static_cast<double>(excess),
                       static_cast<double>(bound), [&] { return text(c); });
    }
}

/// μ² from 1 - 1/2 to 1 + 1/2, and as near to 1 as 1e-17.
template <class Shape> void test_overlap()
{
    Failures failures;
    Random random(7402);
    for (int n = 0; n < draws(20000); ++n) {
        Case2 c = random_case<Shape>(random, n);
        auto const mu2 = static_cast<double>(Shape::truth(c).mu2);
        if (!(mu2 > 1e-12)) continue;
        double const factor = std::sqrt((1 + random.sign() * random.log_uniform(1e-17, 0.5)) / mu2);
        c.a = factor * c.a;
        c.b = factor * c.b;
        Wide const excess = Shape::truth(c).mu2 - 1;
        if (abs(excess) < Wide("1e-30")) continue;
        int overlap = -1;
        Shape::overlap(c, &overlap);
        failures.check(overlap == (excess < 0 ? 1 : 0), Shape::name, overlap,
                       static_cast<double>(excess), [&] { return text(c); });
    }
}

/// A set that touches does not overlap, and does if the ellipse is wider by the last bit.
template <class Shape> void check_tie(Failures &failures, Case2 const &c)
{
    int overlap = -1;
    Shape::overlap(c, &overlap);
    failures.check(overlap == 0, "tangent", overlap, 0.0, [&] { return text(c); });
    Case2 wider = c;
    for (int k : {0, 2}) wider.q[k] = std::nextafter(wider.q[k], HUGE_VAL);
    Shape::overlap(wider, &overlap);
    failures.check(overlap == 1, "wider by one bit", overlap, 1.0, [&] { return text(wider); });
}

/// The ellipse 5 S(unit circle) with S = (p s; 0 q), a segment through S(4, 3) along S(-3, 4), and
/// a box above the highest point, S(0, 5). All numbers are integers, so that they touch exactly.
PW85_TEST("/shapes_in_plane/ties")
{
    Failures failures;
    Random random(7403);
    for (int n = 0; n < draws(2000); ++n) {
        double const p = std::floor(random.log_uniform(1.0, 1e5)),
                     s = std::floor(random.uniform(-1e5, 1e5)),
                     q = std::floor(random.log_uniform(1.0, 1e5));
        int const power = static_cast<int>(random.uniform(-40.0, 41.0));
        Form2 const form = pw85::detail::times_power_of_two(
            Form2{25 * (p * p + s * s), 25 * s * q, 25 * q * q}, 2 * power);
        Vector2 const touching{4 * p + 3 * s, 3 * q}, along{-3 * p + 4 * s, 4 * q};
        double const before = std::floor(random.log_uniform(1.0, 1e3)),
                     after = std::floor(random.log_uniform(1.0, 1e3));
        auto const scaled = [&](Vector2 const &x) {
            return pw85::detail::times_power_of_two(x, power);
        };
        check_tie<Segment>(
            failures, {scaled(touching - before * along), scaled(touching + after * along), form});
        check_tie<Box>(failures, {scaled({5 * (s - before), 5 * q}),
                                  scaled({5 * (s + after), 5 * (q + before)}), form});
    }
}

/// The distance of a point by the principal axes: x_i = a_i² y_i/(t + a_i²) is a point of the
/// ellipse, and the nearest one for the largest root t. Where the coordinate along the shorter
/// axis is 0, t may be minus the square of that semi-axis, and x_i is what is left.
struct PointTruth {
    Wide distance, x, y; ///< and the unit normal
};

/// A distance, and by how much that of double precision may differ.
struct DistanceBound {
    Wide distance, bound;
};

PointTruth nearest_by_axes(Wide const (&square)[2], Wide const (&y)[2])
{
    int const short_axis = square[0] < square[1] ? 0 : 1;
    Wide const least = square[short_axis];
    auto const sum = [&](Wide const &t) {
        Wide total = 0;
        for (int i = 0; i < 2; ++i)
            if (!(y[i] == Wide(0))) {
                Wide const part = y[i] / (t + square[i]);
                total += square[i] * part * part;
            }
        return total;
    };
    // With v = t + least: the sum exceeds 1 at a tiny v, unless the coordinate is 0.
    Wide high = least;
    while (sum(high - least) > 1) high *= 4;
    Wide low = high;
    for (int k = 0; k < 400 && !(sum(low - least) > 1); ++k) low /= 4;
    bool const inner = !(sum(low - least) > 1);
    for (int k = 0; k < 190 && !inner; ++k) {
        Wide const middle = (low + high) / 2;
        (sum(middle - least) > 1 ? low : high) = middle;
    }
    Wide const t = inner ? Wide(-least) : Wide(low - least);
    Wide x[2], rest = 1, distance2 = 0;
    for (int i = 1; i >= 0; --i) {
        int const k = i == 1 ? 1 - short_axis : short_axis;
        x[k] = inner && k == short_axis ? Wide(sqrt(least * rest))
                                        : Wide(square[k] * y[k] / (t + square[k]));
        rest -= x[k] * x[k] / square[k];
        distance2 += (x[k] - y[k]) * (x[k] - y[k]);
    }
    Wide const n0 = x[0] / square[0], n1 = x[1] / square[1], length = sqrt(n0 * n0 + n1 * n1);
    return {t < 0 ? Wide(-sqrt(distance2)) : Wide(sqrt(distance2)), n0 / length, n1 / length};
}

/// The same in the frame of the form, by its eigenvectors.
PointTruth distance_truth(Form2 const &q, Vector2 const &r)
{
    Wide const xx(q[0]), xy(q[1]), yy(q[2]), x(r[0]), y(r[1]), half = (xx - yy) / 2;
    Wide const root = sqrt(half * half + xy * xy), larger = (xx + yy) / 2 + root;
    Wide const square[2] = {larger, (xx * yy - xy * xy) / larger};
    Wide c = half >= 0 ? Wide(half + root) : abs(xy), s = half >= 0 ? xy : Wide(root - half);
    if (half < 0 && xy < 0) c = -c;
    Wide const length = sqrt(c * c + s * s);
    c = length > 0 ? Wide(c / length) : Wide(1);
    s = length > 0 ? Wide(s / length) : Wide(0);
    auto const found = nearest_by_axes(square, {c * x + s * y, c * y - s * x});
    return {found.distance, c * found.x - s * found.y, s * found.x + c * found.y};
}

/// The normal attains the largest value of n·r - α(n), which is stationary there, and the point is
/// Qn/α: an error of 8 u in each term moves it by at most 8 u X, with X_i = Σ|q_ij n_j|/α.
void check_support(Failures &failures, Form2 const &q, Vector2 const &r, Vector2 const &point,
                   Vector2 const &normal, DistanceBound const &exact)
{
    auto const describe = [&] { return text({r, r, q}); };
    Wide const xx(q[0]), xy(q[1]), yy(q[2]),
        length = sqrt(Wide(normal[0]) * Wide(normal[0]) + Wide(normal[1]) * Wide(normal[1]));
    Wide const x = Wide(normal[0]) / length, y = Wide(normal[1]) / length,
               width = sqrt(x * x * xx + 2 * x * y * xy + y * y * yy);
    Wide const value = x * Wide(r[0]) + y * Wide(r[1]) - width;
    failures.check(abs(Wide(value - exact.distance)) <= exact.bound, "value of the normal",
                   static_cast<double>(value), static_cast<double>(exact.distance), describe);
    Wide const size_x = (abs(Wide(x * xx)) + abs(Wide(y * xy))) / width,
               size_y = (abs(Wide(x * xy)) + abs(Wide(y * yy))) / width;
    Wide const square =
        (yy * size_x * size_x + 2 * abs(xy) * size_x * size_y + xx * size_y * size_y) /
        (xx * yy - xy * xy);
    Wide const error = 8 * u;
    failures.check(abs(Wide(value_at(q, point) - 1)) <= error * (2 + error) * square,
                   "on the surface", static_cast<double>(value_at(q, point)), 1.0, describe);
    failures.check(abs(Wide(x * Wide(point[0]) + y * Wide(point[1]) - width)) <=
                       error * (abs(x) * size_x + abs(y) * size_y),
                   "point", point[0], static_cast<double>(width), describe);
}

void check_point(Failures &failures, Form2 const &q, Vector2 const &r)
{
    auto const describe = [&] { return text({r, r, q}); };
    double distance;
    Vector2 point{}, normal{};
    failures.check(pw85_distance_point_2d(r.coordinates, q.entries, &distance, point.coordinates,
                                          normal.coordinates) == PW85_SUCCESS,
                   "status", 1.0, 0.0, describe);
    auto const exact = distance_truth(q, r);
    Wide const x = abs(exact.x), y = abs(exact.y), xx(q[0]), xy = abs(Wide(q[1])), yy(q[2]);
    Wide const width =
        sqrt(exact.x * exact.x * xx + 2 * exact.x * exact.y * Wide(q[1]) + exact.y * exact.y * yy);
    Wide const sum = abs(Wide(r[0])) * x + abs(Wide(r[1])) * y +
                     (x * x * xx + 2 * x * y * xy + y * y * yy) / (2 * width);
    failures.check(abs(Wide(distance - exact.distance)) <= 8 * u * sum, "distance", distance,
                   static_cast<double>(exact.distance), describe);
    failures.check(std::fabs(std::hypot(normal[0], normal[1]) - 1.0) <= 4 * u, "normal", normal[0],
                   1.0, describe);
    check_support(failures, q, r, point, normal, {exact.distance, 8 * u * sum});
}

PW85_TEST("/shapes_in_plane/point/distance")
{
    Failures failures;
    Random random(7404);
    for (int n = 0; n < draws(20000); ++n) {
        auto q = random_ellipse(random);
        if (n % 5 == 0) q[1] = 0.0; // points in planes of symmetry follow
        auto r = n % 4 == 3 ? random.uniform(0.0, 1.0) * random_place(random, q, 1)
                            : random_place(random, q, n);
        if (n % 3 == 0) r[n % 2] = 0.0;
        check_point(failures, q, r);
    }
}

/// Numbers that a reader can check, and the centre of a circle.
PW85_TEST("/shapes_in_plane/by_hand")
{
    double const q[3] = {9.0, 0.0, 4.0}, inside[2] = {0.0, 1.0}, center[2] = {0.0, 0.0};
    double distance, point[2], normal[2], mu2;
    g_assert_cmpint(pw85_distance_point_2d(inside, q, &distance, point, normal), ==, PW85_SUCCESS);
    g_assert_cmpfloat(std::fabs(distance + 1.0), <=, 8 * u);
    g_assert_cmpfloat(std::fabs(point[1] - 2.0), <=, 8 * u);
    g_assert_cmpfloat(normal[1], ==, 1.0);
    double const circle[3] = {4.0, 0.0, 4.0};
    g_assert_cmpint(pw85_distance_point_2d(center, circle, &distance, point, normal), ==,
                    PW85_SUCCESS);
    g_assert_cmpfloat(std::fabs(distance + 2.0), <=, 8 * u);
    double const lower[2] = {6.0, -1.0}, upper[2] = {7.0, 1.0};
    g_assert_cmpint(pw85_contact_box_2d(lower, upper, q, &mu2, point), ==, PW85_SUCCESS);
    g_assert_cmpfloat(std::fabs(mu2 - 4.0), <=, 80 * u * 4);
    g_assert_cmpfloat(point[0], ==, 6.0);
    double const around_lower[2] = {-1.0, -1.0};
    g_assert_cmpint(pw85_contact_box_2d(around_lower, upper, q, &mu2, point), ==, PW85_SUCCESS);
    g_assert_cmpfloat(mu2, ==, 0.0);
}

PW85_TEST("/shapes_in_plane/statuses")
{
    double const good[3] = {1.0, 0.5, 2.0}, a[2] = {1.0, 2.0}, b[2] = {3.0, 1.0};
    double mu2;
    int overlap;
    g_assert_cmpint(pw85_contact_box_2d(a, b, good, &mu2, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_overlap_box_2d(a, b, good, &overlap), ==, PW85_EINVAL);
}

PW85_ADD_TEST("/shapes_in_plane/segment/contact", test_contact<Segment>);
PW85_ADD_TEST("/shapes_in_plane/segment/overlap", test_overlap<Segment>);
PW85_ADD_TEST("/shapes_in_plane/box/contact", test_contact<Box>);
PW85_ADD_TEST("/shapes_in_plane/box/overlap", test_overlap<Box>);

} // namespace

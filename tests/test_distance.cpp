// SPDX-License-Identifier: BSD-3-Clause
// Tests of distances, closest points and derivatives.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85_batch.h>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "rotated.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

template <class T, int D>
pw85::Vector<T, D> difference(pw85::Vector<T, D> x, pw85::Vector<T, D> const &y)
{
    for (int i = 0; i < D; ++i) x[i] = x[i] - y[i];
    return x;
}

template <class T, int D>
double largest_difference(pw85::Vector<T, D> const &x, pw85::Vector<T, D> const &y)
{
    return static_cast<double>(pw85::detail::largest_coordinate(difference(x, y)));
}

/// Both functions of the C API, which give the same bits.
template <int D> pw85::Distance<double, D> c_distance(Sample<double, D> const &p)
{
    pw85::Distance<double, D> d{}, plain{};
    double const *r12 = p.r12.coordinates, *q1 = p.q1.entries, *q2 = p.q2.entries;
    double *point1 = d.point1.coordinates, *point2 = d.point2.coordinates,
           *normal = d.normal.coordinates;
    int const status =
        D == 3 ? pw85_distance_geometry(r12, q1, q2, &d.distance, point1, point2, normal)
               : pw85_distance_geometry_2d(r12, q1, q2, &d.distance, point1, point2, normal);
    d.status = static_cast<pw85::Status>(status);
    point1 = plain.point1.coordinates, point2 = plain.point2.coordinates;
    g_assert_cmpint(D == 3 ? pw85_distance(r12, q1, q2, &plain.distance, point1, point2)
                           : pw85_distance_2d(r12, q1, q2, &plain.distance, point1, point2),
                    ==, status);
    std::size_t const size = (1 + 2 * D) * sizeof(double);
    g_assert_true(std::memcmp(&d.distance, &plain.distance, size) == 0);
    return d;
}

template <class T, int D> pw85::Distance<T, D> distance(Sample<T, D> const &p)
{
    return pw85::distance(p.r12, p.q1, p.q2);
}

/// Σ of the contract of pw85_distance(): what relative errors of one in every number change the
/// distance by at most.
template <class T, int D> T sensitivity(Sample<T, D> const &p, pw85::Vector<T, D> const &n)
{
    T sum = absolute_form(p.q1, n) / (2 * pw85::detail::support(p.q1, n).extent) +
            absolute_form(p.q2, n) / (2 * pw85::detail::support(p.q2, n).extent);
    for (int i = 0; i < D; ++i) sum = sum + pw85::detail::absolute(T(n[i] * p.r12[i]));
    return sum;
}

/// Pairs that are apart, of all shapes, sizes and gaps.
template <int D> Sample<double, D> pair_apart(Random &random, double aspect)
{
    for (;;) {
        double const excess = random.log_uniform(1e-10, 1e6);
        auto const s = random_pair<D>(random, {.aspect = random.log_uniform(1.0, aspect),
                                               .size_ratio = random.log_uniform(1.0, 1e6),
                                               .mu2_min = 1.0 + excess,
                                               .mu2_max = 1.0 + excess * 1.001});
        if (!pw85::overlap(s.r12, s.q1, s.q2).overlap) return s;
    }
}

// Points on both surfaces, joined by the common normal, are the closest, since ellipsoids are
// convex. So the truth of all other tests needs no trust in how it was found.
template <int D> void test_optimality()
{
    Failures failures;
    Random random(300 + D);
    for (int n = 0; n < draws(2000); ++n) {
        auto const s = pair_apart<D>(random, 1e3);
        auto const p = convert<Wide>(s);
        auto const d = distance(p);
        auto const text = [&] { return hex_text(s); };
        auto const inverse_form = [](auto const &q, auto const &x) {
            return pw85::dot(x, pw85::detail::solve(pw85::detail::factorize(q, Wide(0)), x));
        };
        auto const check = [&](Wide const &x, Wide const &expected, char const *what) {
            double const error = static_cast<double>(pw85::detail::absolute(Wide(x - expected)));
            failures.check(error <= 1e-35, what, error, 1e-35, text);
        };
        check(inverse_form(p.q1, d.point1), 1, "point 1 on its surface");
        check(inverse_form(p.q2, difference(d.point2, p.r12)), 1, "point 2 on its surface");
        check(norm(d.normal), 1, "unit normal");
        auto const joint = difference(d.point2, d.point1);
        auto const outward1 = pw85::detail::solve(pw85::detail::factorize(p.q1, Wide(0)), d.point1);
        auto const outward2 = pw85::detail::solve(pw85::detail::factorize(p.q2, Wide(0)),
                                                  difference(d.point2, p.r12));
        check(pw85::dot(outward1, d.normal) / norm(outward1), 1, "normal 1");
        check(pw85::dot(outward2, d.normal) / norm(outward2), -1, "normal 2");
        check(norm(difference(joint, d.distance * d.normal)) / norm(p.r12), 0,
              "line of the points");
        failures.check(d.distance > 0, "distance", static_cast<double>(d.distance), 0.0, text);
    }
}

// The contract. Rounding adds up to at most 6uΣ: products and sums of three terms in n·r, twice
// that in the forms, whose roots halve it, and the normalisation; what n lacks counts only squared.
template <int D> void test_rounding_errors()
{
    Failures failures;
    Random random(310 + D);
    for (int n = 0; n < draws(5000); ++n) {
        auto const s = pair_apart<D>(random, 1e6);
        auto const p = convert<Wide>(s);
        auto const exact = distance(p);
        auto const d = c_distance(s);
        Wide const sigma = sensitivity(p, exact.normal);
        double const error = static_cast<double>(
            Wide(pw85::detail::absolute(Wide(d.distance - exact.distance)) / (u * sigma)));
        failures.check(error <= 8.0, "error in u Σ", error, 8.0, [&] { return hex_text(s); });
    }
}

// The points of a pair in double are those of a pair whose numbers differ by rounding, which moves
// the normal by that times the condition number of the forms, aspect² or less, and 32 for the
// roundings of a solution and its use.
template <int D> void test_points()
{
    Failures failures;
    Random random(320 + D);
    for (int n = 0; n < draws(5000); ++n) {
        double const aspect = random.log_uniform(1.0, 100.0), bound = 32 * u * aspect * aspect;
        auto const s =
            random_pair<D>(random, {.aspect = aspect, .mu2_min = 1.0 + 1e-6, .mu2_max = 100.0});
        auto const exact = distance(convert<Wide>(s));
        auto const d = c_distance(s);
        double const size = norm(s.r12) + 3.0,
                     error1 = largest_difference(convert<Wide>(d.point1), exact.point1),
                     error2 = largest_difference(convert<Wide>(d.point2), exact.point2);
        failures.check(error1 <= bound * size, "point 1", error1, bound * size,
                       [&] { return hex_text(s); });
        failures.check(error2 <= bound * size, "point 2", error2, bound * size,
                       [&] { return hex_text(s); });
    }
}

// The two bounds that need no trust, in double: that of the normal and that of the points enclose
// the distance, and leave a gap of the square of the error of the points over the distance.
PW85_TEST("/distance/certificate")
{
    Failures failures;
    Random random(330);
    for (int n = 0; n < draws(5000); ++n) {
        double const aspect = random.log_uniform(1.0, 100.0), error = 32 * u * aspect * aspect;
        auto const s =
            random_pair<3>(random, {.aspect = aspect, .mu2_min = 1.0 + 1e-6, .mu2_max = 100.0});
        auto const d = c_distance(s);
        double normal[3];
        pw85_distance_derivatives(s.r12.coordinates, s.q1.entries, s.q2.entries, normal, nullptr,
                                  nullptr, nullptr);
        g_assert_true(std::memcmp(normal, d.normal.coordinates, sizeof normal) == 0);
        auto const p = convert<Wide>(s);
        auto const unit = convert<Wide>(d.normal);
        Wide const lower = (pw85::dot(unit, p.r12) - pw85::detail::support(p.q1, unit).extent -
                            pw85::detail::support(p.q2, unit).extent) /
                           norm(unit);
        Wide const upper = norm(difference(convert<Wide>(d.point2), convert<Wide>(d.point1)));
        Wide const exact = distance(p).distance, rounding = 8 * u * sensitivity(p, unit);
        double const size = norm(s.r12) + 3.0, gap = static_cast<double>(Wide(upper - lower));
        double const bound = 3 * error * size * std::fmin(1.0, error * size / d.distance) +
                             static_cast<double>(rounding);
        auto const text = [&] { return hex_text(s); };
        failures.check(lower <= exact, "lower bound", static_cast<double>(lower),
                       static_cast<double>(exact), text);
        failures.check(pw85::detail::absolute(Wide(lower - d.distance)) <= rounding,
                       "distance is the lower bound", d.distance, static_cast<double>(lower), text);
        failures.check(gap <= bound, "duality gap", gap, bound, text);
    }
}

// The polynomials give the same as solutions, in a type in which neither loses digits that count.
// Sums of what may cancel are compared with their largest terms.
template <int D> void test_polynomials()
{
    Failures failures;
    Random random(335 + D);
    for (int n = 0; n < draws(1000); ++n) {
        auto const p = convert<Wide>(pair_apart<D>(random, 100.0));
        pw85::detail::DistancePair<Wide, D> const pair{p.r12, p.q1, p.q2, Wide(0.5), Wide(4)};
        pw85::detail::Multipliers<Wide> x = pw85::detail::initial_multipliers(pair);
        x.ratio *= random.log_uniform(0.1, 10.0);
        x.shift = pw85::detail::largest_diagonal(p.q1) *
                  (n % 4 == 0 ? 0.0 : random.log_uniform(1e-3, 1e3));
        auto const a =
            pw85::detail::evaluate_normal(pair, pw85::detail::start_search(pair, x).form, x);
        auto const b =
            pw85::detail::solve_normal(pair, pw85::detail::factorize_normal(pair, x), x).jet;
        auto const check = [&](Wide const &actual, Wide const &expected, Wide const &size,
                               char const *what) {
            double const error =
                static_cast<double>(Wide(pw85::detail::absolute(Wide(actual - expected)) / size));
            failures.check(error <= 1e-25, what, error, 1e-25, [&] {
                return hex_text(convert<double>(p)) + ", t, s = " + x.ratio.str() + ' ' +
                       x.shift.str();
            });
        };
        Wide const weight = b.a * b.b, t = x.ratio;
        check(a.r, b.r, b.r, "R");
        check(a.form_u, b.form_u, b.form_u, "form_u");
        check(a.a, b.a, b.a, "A");
        check(a.b, b.b, b.b, "B");
        check(a.sum, b.sum, b.sum, "S");
        check(a.log_ratio, b.log_ratio, weight / t, "log_ratio");
        check(a.log_shift, b.log_shift, weight * b.form_u / b.r, "log_shift");
        check(a.sum_ratio, b.sum_ratio, b.sum / t, "sum_ratio");
        check(a.sum_shift, b.sum_shift, b.sum_shift, "sum_shift");
    }
}

// The search alone, search_normal(), finds what Newton's method finds, and what it does not.
PW85_TEST("/distance/search")
{
    Failures failures;
    Random random(340);
    int given_up = 0;
    for (int n = 0; n < draws(5000); ++n) {
        auto const s = pair_apart<3>(random, 1e4);
        auto const p = convert<Wide>(s);
        pw85::detail::DistancePair<double, 3> const pair{s.r12, s.q1, s.q2, 1.0, 1.0};
        pw85::detail::Multipliers<double> const start = pw85::detail::initial_multipliers(pair);
        auto const exact = distance(p);
        Wide const sigma = sensitivity(p, exact.normal);
        auto const check = [&](pw85::Vector<double, 3> const &direction, char const *what) {
            auto const v = convert<Wide>(direction);
            Wide const width = (pw85::dot(v, p.r12) - pw85::detail::support(p.q1, v).extent -
                                pw85::detail::support(p.q2, v).extent) /
                               norm(v);
            double const error = static_cast<double>(Wide((exact.distance - width) / (u * sigma)));
            failures.check(error >= 0.0 && error <= 2.0, what, error, 2.0,
                           [&] { return hex_text(s); });
        };
        check(pw85::detail::search_normal(pair, start.ratio), "search");
        check(pw85::detail::search_normal(pair, 1e-3 * start.ratio), "search from below");
        check(pw85::detail::search_normal(pair, 1e3 * start.ratio), "search from above");
        auto const newton =
            pw85::detail::find_normal(pair, pw85::detail::start_search(pair, start));
        if (newton.found)
            check(newton.u, "Newton's method");
        else
            ++given_up;
        auto const again = pw85::detail::find_normal(
            pair, pw85::detail::start_search(pair, pw85::detail::touching_multipliers(pair)));
        if (again.found) check(again.u, "from contact");
    }
    if (eighths() == 8) g_assert_cmpint(given_up, >, 0); // less than one pair in 500
    g_assert_cmpint(given_up, <, 2500);
}

void assert_close(double actual, double expected, double tolerance)
{
    g_assert_cmpfloat(std::fabs(actual - expected), <=, tolerance);
}

// Spheres of radii 2 and 1: the gap on the line of the centres.
PW85_TEST("/distance/spheres")
{
    Sample<double, 3> const p{
        {3.0, 6.0, 6.0}, {4.0, 0.0, 0.0, 4.0, 0.0, 4.0}, {1.0, 0.0, 0.0, 1.0, 0.0, 1.0}};
    auto const d = c_distance(p);
    assert_close(d.distance, 6.0, 16 * u);
    for (int i = 0; i < 3; ++i) {
        assert_close(d.point1[i], p.r12[i] * 2.0 / 9.0, 8 * u);
        assert_close(d.point2[i], p.r12[i] * 8.0 / 9.0, 16 * u);
    }
    double normal[3], torque[3], hessian[81];
    g_assert_cmpint(pw85_distance_derivatives(p.r12.coordinates, p.q1.entries, p.q2.entries, normal,
                                              torque, nullptr, hessian),
                    ==, PW85_SUCCESS);
    for (int i = 0; i < 3; ++i) {
        assert_close(normal[i], p.r12[i] / 9.0, 4 * u);
        assert_close(torque[i], 0.0, 8 * u);
        for (int j = 0; j < 9; ++j) {
            double const expected =
                j < 3 ? ((i == j ? 1.0 : 0.0) - p.r12[i] * p.r12[j] / 81.0) / 9.0 : 0.0;
            assert_close(hessian[9 * i + j], expected, 16 * u);
            assert_close(hessian[9 * j + i], expected, 16 * u);
        }
    }
}

// Two spheroids on one axis, end to end; and side by side.
PW85_TEST("/distance/coaxial")
{
    double const q1[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 16.0}, q2[6] = {9.0, 0.0, 0.0, 9.0, 0.0, 4.0};
    auto const axial = c_distance<3>(
        {{0.0, 0.0, 8.0}, {1.0, 0.0, 0.0, 1.0, 0.0, 16.0}, {9.0, 0.0, 0.0, 9.0, 0.0, 4.0}});
    assert_close(axial.distance, 2.0, 8 * u);
    assert_close(axial.point1[2], 4.0, 8 * u);
    assert_close(axial.point2[2], 6.0, 8 * u);
    double const beside[3] = {-8.0, 0.0, 0.0};
    double distance, point1[3], point2[3];
    g_assert_cmpint(pw85_distance(beside, q1, q2, &distance, point1, point2), ==, PW85_SUCCESS);
    assert_close(distance, 4.0, 8 * u);
    assert_close(point1[0], -1.0, 8 * u);
    assert_close(point2[0], -5.0, 8 * u);
}

bool all_nan(double const *x, int count)
{
    for (int i = 0; i < count; ++i)
        if (!std::isnan(x[i])) return false;
    return true;
}

// Overlapping pairs: zero and NaN. The decision is that of pw85_overlap().
PW85_TEST("/distance/overlapping")
{
    Failures failures;
    Random random(350);
    for (int n = 0; n < draws(5000); ++n) {
        auto const s = random_pair<3>(random, {.aspect = random.log_uniform(1.0, 1e4),
                                               .mu2_min = n % 2 == 0 ? 1e-3 : 1.0 - 1e-15,
                                               .mu2_max = 1.0 + 1e-15});
        int overlap = -1;
        pw85_overlap(s.r12.coordinates, s.q1.entries, s.q2.entries, &overlap);
        auto const d = c_distance(s);
        double derivatives[90];
        int const status =
            pw85_distance_derivatives(s.r12.coordinates, s.q1.entries, s.q2.entries, derivatives,
                                      derivatives + 3, derivatives + 6, derivatives + 9);
        bool ok = d.status == pw85::Status::success && status == PW85_SUCCESS;
        double const points[6] = {d.point1[0], d.point1[1], d.point1[2],
                                  d.point2[0], d.point2[1], d.point2[2]};
        if (overlap == 1)
            ok = ok && d.distance == 0.0 && all_nan(points, 6) && all_nan(derivatives, 90);
        else {
            ok = ok && d.distance >= 0.0;
            for (double const x : points) ok = ok && std::isfinite(x);
            for (double const x : derivatives) ok = ok && std::isfinite(x);
        }
        failures.check(ok, "overlap", d.distance, overlap, [&] { return hex_text(s); });
    }
}

// Tangent spheres do not overlap.
PW85_TEST("/distance/tangent")
{
    auto const d = c_distance<3>(
        {{3.0, 0.0, 0.0}, {4.0, 0.0, 0.0, 4.0, 0.0, 4.0}, {1.0, 0.0, 0.0, 1.0, 0.0, 1.0}});
    assert_close(d.distance, 0.0, 8 * u);
    assert_close(d.point1[0], 2.0, 8 * u);
    assert_close(d.point2[0], 2.0, 8 * u);
}

// Exchanging the ellipsoids exchanges the points; a power of two on all lengths changes nothing but
// the unit.
PW85_TEST("/distance/invariance")
{
    Failures failures;
    Random random(360);
    for (int n = 0; n < draws(5000); ++n) {
        double const aspect = random.log_uniform(1.0, 100.0);
        auto const s =
            random_pair<3>(random, {.aspect = aspect, .mu2_min = 1.0 + 1e-6, .mu2_max = 100.0});
        auto const d = c_distance(s), e = c_distance<3>({-s.r12, s.q2, s.q1});
        double const bound = 16 * u * static_cast<double>(sensitivity(s, distance(s).normal));
        failures.check(std::fabs(d.distance - e.distance) <= bound, "exchange", d.distance,
                       e.distance, [&] { return hex_text(s); });
        for (double const exponent : {-480.0, -100.0, 100.0, 480.0}) {
            double const f = std::exp2(exponent);
            Sample<double, 3> const scaled{f * s.r12, f * f * s.q1, f * f * s.q2};
            auto const g = c_distance(scaled);
            failures.check(g.distance == f * d.distance, "unit", g.distance, f * d.distance,
                           [&] { return hex_text(scaled); });
            failures.check(largest_difference(g.point1, f * d.point1) == 0.0, "unit", g.point1[0],
                           f * d.point1[0], [&] { return hex_text(scaled); });
        }
    }
}

// Sizes and separations from 1e-150 to 1e150, in any combination that is apart: the contract holds.
PW85_TEST("/distance/extreme/sizes")
{
    Failures failures;
    Random random(370);
    for (int n = 0; n < draws(5000); ++n) {
        Sample<double, 3> s{
            {},
            random.form(random.log_uniform(1e-149, 1e149), random.log_uniform(1.0, 10.0)),
            random.form(random.log_uniform(1e-149, 1e149), random.log_uniform(1.0, 10.0))};
        auto const direction = random.direction<3>();
        double const contact =
            1.0 /
            std::sqrt(static_cast<double>(
                pw85::contact(convert<Wide>(direction), convert<Wide>(s.q1), convert<Wide>(s.q2))
                    .mu2));
        s.r12 = std::fmin(1e150, contact * (1.0 + random.log_uniform(1e-6, 1e100))) * direction;
        auto const p = convert<Wide>(s);
        auto const exact = distance(p);
        auto const d = c_distance(s);
        Wide const bound = 8 * u * sensitivity(p, exact.normal);
        failures.check(pw85::detail::absolute(Wide(d.distance - exact.distance)) <= bound,
                       "distance", d.distance, static_cast<double>(exact.distance),
                       [&] { return hex_text(s); });
        for (int i = 0; i < 3; ++i) {
            Wide const size1 = norm(exact.point1), size2 = norm(p.r12);
            failures.check(pw85::detail::absolute(Wide(d.point1[i] - exact.point1[i])) <=
                               3200 * u * size1,
                           "point 1", d.point1[i], static_cast<double>(exact.point1[i]),
                           [&] { return hex_text(s); });
            failures.check(pw85::detail::absolute(Wide(d.point2[i] - exact.point2[i])) <=
                               3200 * u * (size1 + size2),
                           "point 2", d.point2[i], static_cast<double>(exact.point2[i]),
                           [&] { return hex_text(s); });
        }
        double derivatives[90];
        pw85_distance_derivatives(s.r12.coordinates, s.q1.entries, s.q2.entries, derivatives,
                                  derivatives + 3, derivatives + 6, derivatives + 9);
        for (double const x : derivatives)
            failures.check(std::isfinite(x), "derivatives", x, 0.0, [&] { return hex_text(s); });
    }
}

// Shapes up to the limit of what counts as positive definite, aligned with the axes so that the
// forms are exact. The search must end, and its answer obey the contract.
PW85_TEST("/distance/extreme/shapes")
{
    Failures failures;
    Random random(380);
    for (int n = 0; n < draws(5000); ++n) {
        auto const axis = [&] { return random.log_uniform(1e-15, 1e15); };
        auto const square = [](double x) { return x * x; };
        Sample<double, 3> s{random.direction<3>(),
                            {square(axis()), 0.0, 0.0, square(axis()), 0.0, square(axis())},
                            {square(axis()), 0.0, 0.0, square(axis()), 0.0, square(axis())}};
        double const mu2 = static_cast<double>(
            pw85::contact(convert<Wide>(s.r12), convert<Wide>(s.q1), convert<Wide>(s.q2)).mu2);
        s.r12 = std::sqrt((1.0 + random.log_uniform(1e-10, 1e10)) / mu2) * s.r12;
        auto const p = convert<Wide>(s);
        auto const exact = distance(p);
        auto const d = c_distance(s);
        Wide const bound = 8 * u * sensitivity(p, exact.normal);
        failures.check(pw85::detail::absolute(Wide(d.distance - exact.distance)) <= bound,
                       "distance", d.distance, static_cast<double>(exact.distance),
                       [&] { return hex_text(s); });
    }
}

/// Solves m x = b by elimination, for a positive definite matrix.
template <class T, int D>
pw85::Vector<T, D> eliminate(pw85::SymmetricMatrix<T, D> const &matrix, pw85::Vector<T, D> x)
{
    T m[std::size_t(D)][std::size_t(D)];
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) m[i][j] = matrix(std::min(i, j), std::max(i, j));
    for (int k = 0; k < D; ++k)
        for (int i = k + 1; i < D; ++i) {
            T const factor = m[i][k] / m[k][k];
            for (int j = k; j < D; ++j) m[i][j] = m[i][j] - factor * m[k][j];
            x[i] = x[i] - factor * x[k];
        }
    for (int k = D - 1; k >= 0; --k) {
        for (int j = k + 1; j < D; ++j) x[k] = x[k] - m[k][j] * x[j];
        x[k] = x[k] / m[k][k];
    }
    return x;
}

/// A lower and an upper bound of a distance, and Σ (sensitivity()).
template <class T> struct Bracket {
    T lower, upper, sigma;
};

template <class T, int D>
pw85::Vector<T, D> times(pw85::SymmetricMatrix<T, D> const &q, pw85::Vector<T, D> const &x)
{
    pw85::Vector<T, D> y{};
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) y[i] = y[i] + q(std::min(i, j), std::max(i, j)) * x[j];
    return y;
}

/// Brackets the distance by the width of the slab along a vector and by the distance of the points
/// that touch the slab. These are bounds for any vector. From a vector with the half-widths α and β
/// follows the next one, (Q1 + α/β Q2 + αd I)⁻¹r.
template <class T, int D> Bracket<T> bracket(Sample<T, D> const &p, pw85::Vector<T, D> normal)
{
    for (int steps = 0;; ++steps) {
        normal = T(T(1) / norm(normal)) * normal;
        auto const p1 = times(p.q1, normal), p2 = times(p.q2, normal);
        T const a = sqrt(T(pw85::dot(normal, p1))), b = sqrt(T(pw85::dot(normal, p2)));
        auto const between = difference(difference(p.r12, T(T(1) / a) * p1), T(T(1) / b) * p2);
        T const lower = pw85::dot(normal, p.r12) - a - b, upper = norm(between);
        T const sigma = sensitivity(p, normal);
        if (upper - lower <= T(0x1p-5 * u) * sigma || steps == 100) return {lower, upper, sigma};
        auto m = pw85::detail::blend(p.q1, T(a / b), p.q2);
        for (int i = 0; i < D; ++i) m(i, i) = m(i, i) + pw85::detail::maximum(T(0), T(a * lower));
        normal = eliminate(m, p.r12);
    }
}

/// A form whose axes have lengths that differ by up to `binades` binades, along the coordinates or
/// nearly so.
template <int D> pw85::SymmetricMatrix<double, D> slender_form(Random &random, double binades)
{
    double factor[std::size_t(D)][std::size_t(D)] = {};
    bool const aligned = random.sign() < 0.0;
    for (int i = 0; i < D; ++i) factor[i][i] = std::exp2(random.uniform(-0.5, 0.5) * binades);
    for (int i = 0; i < D && !aligned; ++i)
        for (int j = i + 1; j < D; ++j) factor[i][j] = random.uniform(-0.5, 0.5) * factor[j][j];
    pw85::SymmetricMatrix<double, D> q{};
    for (int i = 0; i < D; ++i)
        for (int j = i; j < D; ++j)
            for (int k = 0; k <= i; ++k) q(i, j) += factor[k][i] * factor[k][j];
    return q;
}

/// Compares the distance of a pair with the bracket of the truth.
template <int D> void check_in_bracket(Sample<double, D> const &s, Failures &failures)
{
    using Truth = Multiprecision<100>;
    auto const d = c_distance(s);
    auto const text = [&] { return hex_text(s); };
    auto const check = [&](Truth const &error, Truth const &bound, char const *what) {
        failures.check(error <= bound, what, static_cast<double>(error), static_cast<double>(bound),
                       text);
    };
    failures.check(d.status == pw85::Status::success, "status", static_cast<int>(d.status), 0,
                   text);
    if (d.distance == 0.0 || d.status != pw85::Status::success) return;
    auto const p = convert<Truth>(s);
    auto const from1 = convert<Truth>(d.point1),
               from2 = difference(convert<Truth>(d.point2), p.r12);
    auto const found = bracket(p, convert<Truth>(distance(convert<Wide>(s)).normal));
    check(found.upper - found.lower, 0x1p-5 * u * found.sigma, "truth");
    Truth const above = found.upper - d.distance, below = d.distance - found.lower;
    check(pw85::detail::maximum(above, below), 8 * u * found.sigma, "distance");
    Truth const length = norm(p.r12) + norm(from1) + norm(from2);
    auto const joint = difference(convert<Truth>(d.point2), from1);
    check(pw85::detail::absolute(Truth(norm(joint) - d.distance)), 0x1p18 * u * length,
          "distance of the points");
}

// Aspect ratios from 10⁸ to 2¹⁰⁰, and gaps from 10⁻¹² of the lengths on. Beyond some 10¹¹ even
// twice the digits are not enough.
template <int D> void test_immense_aspects()
{
    Failures failures;
    Random random(385 + D);
    for (int n = 0; n < draws(400); ++n) {
        double const binades = random.uniform(27.0, 100.0);
        Sample<double, D> s{random.direction<D>(), slender_form<D>(random, binades),
                            slender_form<D>(random, binades)};
        for (int i = 0; i < D; ++i) s.r12[i] *= std::sqrt(s.q1(i, i)) + std::sqrt(s.q2(i, i));
        auto const contact = pw85::contact(s.r12, s.q1, s.q2);
        if (contact.status != pw85::Status::success) continue;
        s.r12 = std::sqrt((1.0 + random.log_uniform(1e-12, 1e2)) / contact.mu2) * s.r12;
        check_in_bracket(s, failures);
    }
}

PW85_TEST("/distance/extreme/immense_aspects") { test_immense_aspects<3>(); }
PW85_TEST("/distance/extreme/immense_aspects_2d") { test_immense_aspects<2>(); }

// One of the few pairs for which twice the digits are not enough.
PW85_TEST("/distance/extreme/beyond_twice_the_digits")
{
    Failures failures;
    check_in_bracket<3>({{0x1.e8ad91dbcbb38p+40, -0x1.09812ae62def1p+38, 0x1.fb8cb8909e71cp-29},
                         {0x1.5481589536ba8p+83, 0x0p+0, 0x0p+0, 0x1.5219b371568d7p+78, 0x0p+0,
                          0x1.166fa3ed64c97p-56},
                         {0x1.2b6ab4870fb66p-17, -0x1.c99e2132933bp+12, 0x1.82ab735bb0889p-40,
                          0x1.31fa4e142ce5p+45, 0x1.cec1f707b257cp-12, 0x1.55462e0da50acp-60}},
                        failures);
}

template <class T> void check_scalar(Failures &failures, Random &random)
{
    auto const s = pair_apart<3>(random, 10.0);
    auto const narrow = convert<T>(s);
    auto const p = convert<Wide>(narrow);
    auto const d = distance(narrow);
    if (d.distance == T(0)) return;
    auto const exact = distance(p);
    Wide const bound = 8 * Wide(pw85::detail::unit_roundoff<T>()) * sensitivity(p, exact.normal);
    failures.check(pw85::detail::absolute(Wide(Wide(d.distance) - exact.distance)) <= bound,
                   "distance", static_cast<double>(d.distance), static_cast<double>(exact.distance),
                   [&] { return hex_text(s); });
}

PW85_TEST("/distance/scalars")
{
    Failures failures;
    Random random(390);
    for (int n = 0; n < draws(2000); ++n) {
        check_scalar<float>(failures, random);
        check_scalar<long double>(failures, random);
    }
}

/// The distance after changes of r12 and rotations of both ellipsoids.
Wide moved_distance(Sample<Wide, 3> p, Wide const (&change)[9])
{
    for (int i = 0; i < 3; ++i) p.r12[i] += change[i];
    p.q1 = rotated(p.q1, {change[3], change[4], change[5]});
    p.q2 = rotated(p.q2, {change[6], change[7], change[8]});
    return distance(p).distance;
}

// Central differences, of second order in h: with h = 1e-10 truncation leaves 1e-20 times
// derivatives of third and fourth order, which are below 1e5 for aspect ratios up to 4, gaps above
// 1e-2 and sizes of one.
PW85_TEST("/distance/derivatives/differences")
{
    Failures failures;
    Random random(400);
    Wide const h("1e-10");
    for (int n = 0; n < 20; ++n) {
        auto const s = random_pair<3>(random, {.aspect = 4.0, .mu2_min = 1.1, .mu2_max = 10.0});
        auto const p = convert<Wide>(s);
        auto const d = pw85::distance_derivatives(p.r12, p.q1, p.q2);
        auto const at = [&](int i, int si, int j, int sj) {
            Wide change[9] = {};
            change[i] += si * h;
            change[j] += sj * h;
            return moved_distance(p, change);
        };
        auto const check = [&](Wide const &actual, Wide const &expected, char const *what) {
            double const error =
                static_cast<double>(pw85::detail::absolute(Wide(actual - expected)));
            failures.check(error <= 1e-15, what, error, 1e-15, [&] { return hex_text(s); });
        };
        for (int i = 0; i < 9; ++i) {
            Wide const gradient = i < 3   ? d.r12[i]
                                  : i < 6 ? d.rotation1[i - 3]
                                          : d.rotation2[i - 6];
            check(gradient, (at(i, 1, i, 0) - at(i, -1, i, 0)) / (2 * h), "gradient");
            for (int j = i; j < 9; ++j) {
                Wide const second =
                    (at(i, 1, j, 1) - at(i, 1, j, -1) - at(i, -1, j, 1) + at(i, -1, j, -1)) /
                    (4 * h * h);
                check(d.hessian[i][j], second, "hessian");
                check(d.hessian[j][i], second, "hessian, transposed");
            }
        }
    }
}

// The C functions in double against the templates in the wide type. The normal errs as in
// test_points(), and the curvatures (and with them the Hessian) by aspect² times as much, each
// relative to its largest entry of the same unit.
PW85_TEST("/distance/derivatives/double")
{
    Failures failures;
    Random random(410);
    for (int n = 0; n < draws(3000); ++n) {
        double const aspect = random.log_uniform(1.0, 30.0), bound = 256 * u * aspect * aspect;
        auto const s =
            random_pair<3>(random, {.aspect = aspect, .mu2_min = 1.01, .mu2_max = 100.0});
        auto const p = convert<Wide>(s);
        auto const exact = pw85::distance_derivatives(p.r12, p.q1, p.q2);
        pw85::DistanceDerivatives<double> d{};
        double hessian[81];
        pw85_distance_derivatives(s.r12.coordinates, s.q1.entries, s.q2.entries, d.r12.coordinates,
                                  d.rotation1.coordinates, d.rotation2.coordinates, hessian);
        auto const check = [&](double error, double tolerance, char const *what) {
            failures.check(error <= tolerance, what, error, tolerance, [&] { return hex_text(s); });
        };
        check(largest_difference(convert<Wide>(d.r12), exact.r12), bound, "d_r12");
        check(largest_difference(convert<Wide>(d.rotation1), exact.rotation1), 4 * bound, "d_rot1");
        check(largest_difference(convert<Wide>(d.rotation2), exact.rotation2), 4 * bound, "d_rot2");
        double largest = 0.0, error = 0.0;
        for (int i = 0; i < 9; ++i)
            for (int j = 0; j < 9; ++j) {
                largest = std::fmax(
                    largest, static_cast<double>(pw85::detail::absolute(exact.hessian[i][j])));
                error = std::fmax(error, static_cast<double>(pw85::detail::absolute(
                                             Wide(hessian[9 * i + j] - exact.hessian[i][j]))));
                check(std::fabs(hessian[9 * i + j] - hessian[9 * j + i]), 0.0, "symmetry");
            }
        check(error, bound * aspect * aspect * largest, "hessian");
    }
}

// So far apart that the ellipsoids are points, and out of the range of the contract: still no
// garbage.
PW85_TEST("/distance/extreme/far_apart")
{
    Sample<double, 3> const p{{0.0, 0x1p-508, 0x1p823},
                              {0x1p615, 0.0, 0x1p438, 0x1p438, 0.0, 0x1p438},
                              {0x1p438, 0.0, 0.0, 0x1.1p438, 0x1p438, 0x1p438}};
    auto const d = c_distance(p);
    g_assert_cmpfloat(d.distance, ==, 0x1p823);
    assert_close(d.point1[2], 0x1p219, 0x1p167);
    double normal[3], hessian[81];
    g_assert_cmpint(pw85_distance_derivatives(p.r12.coordinates, p.q1.entries, p.q2.entries, normal,
                                              nullptr, nullptr, hessian),
                    ==, PW85_SUCCESS);
    g_assert_cmpfloat(normal[2], ==, 1.0);
    for (double const x : hessian) g_assert_true(std::isfinite(x));
}

// Rows of a batch keep the contract, and a bad one is marked; as many as make threads share them.
PW85_TEST("/distance/batch")
{
    Failures failures;
    Random random(420);
    constexpr std::size_t n = 5000, bad = 777;
    std::vector<double> r12, q1, q2, distance(n), point1(3 * n), point2(3 * n);
    std::vector<Sample<double, 3>> pairs;
    for (std::size_t i = 0; i < n; ++i) {
        double const aspect = random.log_uniform(1.0, i % 8 == 0 ? 1e6 : 20.0);
        pairs.push_back(
            i % 5 == 0 ? random_pair<3>(random, {.aspect = aspect, .mu2_min = 0.1, .mu2_max = 1.1})
                       : pair_apart<3>(random, aspect));
        if (i % 100 == 1) pairs.back().r12 = 1e9 * pairs.back().r12;
        if (i == bad) pairs.back().q1[0] = -1.0;
        r12.insert(r12.end(), pairs.back().r12.coordinates, pairs.back().r12.coordinates + 3);
        q1.insert(q1.end(), pairs.back().q1.entries, pairs.back().q1.entries + 6);
        q2.insert(q2.end(), pairs.back().q2.entries, pairs.back().q2.entries + 6);
    }
    g_assert_cmpint(pw85_distance_batch(n, r12.data(), q1.data(), q2.data(), distance.data(),
                                        point1.data(), point2.data()),
                    ==, PW85_ENOTPD);
    for (std::size_t i = 0; i < n; ++i) {
        auto const text = [&] { return hex_text(pairs[i]); };
        if (i == bad) {
            g_assert_true(std::isnan(distance[i]) && all_nan(&point1[3 * i], 3) &&
                          all_nan(&point2[3 * i], 3));
            continue;
        }
        auto const one = c_distance(pairs[i]);
        failures.check((one.distance == 0.0) == (distance[i] == 0.0) &&
                           std::isnan(one.point1[0]) == all_nan(&point1[3 * i], 3) &&
                           std::isnan(one.point2[0]) == all_nan(&point2[3 * i], 3),
                       "overlap", distance[i], one.distance, text);
        if (std::isnan(one.point1[0])) continue;
        auto const p = convert<Wide>(pairs[i]);
        auto const exact = pw85::distance(p.r12, p.q1, p.q2);
        double const bound = 8 * u * static_cast<double>(sensitivity(p, exact.normal));
        double const error = std::fabs(static_cast<double>(Wide(distance[i] - exact.distance)));
        failures.check(error <= bound, "distance", error, bound, text);
        for (std::size_t d = 0; d < 3; ++d) {
            double const size =
                std::sqrt(pw85::detail::largest_diagonal(pairs[i].q1)) + norm(pairs[i].r12);
            double const gap = std::fabs(point1[3 * i + d] - one.point1[static_cast<int>(d)]) +
                               std::fabs(point2[3 * i + d] - one.point2[static_cast<int>(d)]);
            if (i % 8 != 0) failures.check(gap <= 1e-11 * size, "points", gap, 1e-11 * size, text);
        }
    }
    double alone = 7.0;
    g_assert_cmpint(pw85_distance_batch(1, r12.data() + 3, q1.data() + 6, q2.data() + 6, &alone,
                                        nullptr, nullptr),
                    ==, PW85_SUCCESS);
    g_assert_cmpfloat(alone, ==, distance[1]);
}

/// The semi-axes of a needle, a disc, a ribbon, or any ellipsoid.
pw85::Vector<double, 3> slender_axes(Random &random, double size, double aspect)
{
    switch (static_cast<int>(random.uniform(0.0, 4.0))) {
    case 0:
        return {size, size / aspect, size / aspect};
    case 1:
        return {size, size, size / aspect};
    case 2:
        return {size, size / std::sqrt(aspect), size / aspect};
    default:
        return random.semi_axes(size, aspect);
    }
}

/// Pairs that are apart with aspect ratios up to 10^7.9, sizes of 2^-40 to 2^40 whose ratio is
/// 2^-30 to 2^30, and gaps of 1e-12 to 1e3 sizes, along a normal that is anywhere or near a
/// principal axis; a third of them parallel or nearly so.
Sample<double, 3> slender_pair(Random &random)
{
    for (;;) {
        double const unit =
            random.uniform(0.0, 1.0) < 0.7 ? 1.0 : std::exp2(random.uniform(-40.0, 40.0));
        double const ratio =
            random.uniform(0.0, 1.0) < 0.6 ? 1.0 : std::exp2(random.uniform(-30.0, 30.0));
        auto const turn = random.direction<4>();
        auto other = random.direction<4>();
        double const spread =
            random.uniform(0.0, 1.0) < 0.67 ? 1.0 : random.log_uniform(1e-12, 1.0);
        for (int i = 0; i < 4; ++i) other[i] = turn[i] + spread * other[i];
        auto const form = [&](double size, pw85::Vector<double, 4> const &quaternion) {
            double const aspect = random.log_uniform(1.0, std::pow(10.0, 7.9));
            return pw85::ellipsoid_quaternion(slender_axes(random, size, aspect), quaternion).q;
        };
        Sample<double, 3> s{{}, form(unit, turn), form(unit * ratio, other)};
        auto normal = random.direction<3>();
        if (random.uniform(0.0, 1.0) < 0.3) normal = pw85::detail::support(s.q1, normal).point;
        auto n = convert<Wide>(normal);
        n = Wide(1 / norm(n)) * n;
        Wide const gap = unit * random.log_uniform(1e-12, 1e3);
        auto const p1 = pw85::detail::support(convert<Wide>(s.q1), n).point,
                   p2 = pw85::detail::support(convert<Wide>(s.q2), n).point;
        for (int i = 0; i < 3; ++i)
            s.r12[i] = static_cast<double>(Wide(p1[i] + p2[i] + gap * n[i]));
        auto const o = pw85::overlap(s.r12, s.q1, s.q2);
        if (o.status == pw85::Status::success && !o.overlap) return s;
    }
}

/// How far a point is from the surface of an ellipsoid.
double off_surface(pw85::Vector<Wide, 3> const &point, pw85::SymmetricMatrix<Wide, 3> const &q)
{
    return std::fabs(static_cast<double>(pw85::distance_point(point, q).distance));
}

/// The contract: of the distance, and 2^18 u of each point, relative to the ellipsoid, and of the
/// way between them, relative to all.
void check_points(Failures &failures, Sample<double, 3> const &s,
                  pw85::Distance<double, 3> const &d)
{
    auto const p = convert<Wide>(s);
    auto const exact = distance(p);
    auto const point1 = convert<Wide>(d.point1), point2 = convert<Wide>(d.point2),
               from2 = difference(point2, p.r12);
    auto const text = [&] { return hex_text(s); };
    auto const check = [&](double error, double bound, char const *what) {
        failures.check(error <= bound, what, error, bound, text);
    };
    check(static_cast<double>(pw85::detail::absolute(Wide(d.distance - exact.distance))),
          8 * u * static_cast<double>(sensitivity(p, exact.normal)), "distance");
    double const length = static_cast<double>(Wide(norm(p.r12) + norm(point1) + norm(from2)));
    auto const joint = difference(point2, point1);
    check(std::fabs(static_cast<double>(Wide(norm(joint) - d.distance))), 0x1p18 * u * length,
          "gap");
    auto const along = Wide(d.distance) * convert<Wide>(d.normal);
    check(static_cast<double>(norm(difference(joint, along))), 0x1p18 * u * length,
          "way between the points");
    double const size1 = std::sqrt(pw85::detail::trace(s.q1)),
                 size2 = std::sqrt(pw85::detail::trace(s.q2));
    check(off_surface(point1, p.q1), 0x1p18 * u * size1, "point 1 off its surface");
    check(off_surface(from2, p.q2), 0x1p18 * u * size2 + u * static_cast<double>(norm(point2)),
          "point 2 off its surface");
}

// Pairs for which the answer in double is not good enough, among others; and the same in lanes.
PW85_TEST("/distance/slender_points")
{
    Failures failures;
    Random random(430);
    std::size_t const n = static_cast<std::size_t>(draws(1000));
    std::vector<Sample<double, 3>> pairs;
    std::vector<double> r12, q1, q2, distances(n), point1(3 * n), point2(3 * n);
    for (std::size_t i = 0; i < n; ++i) {
        auto const s = i % 4 == 0 ? pair_apart<3>(random, 100.0) : slender_pair(random);
        pairs.push_back(s);
        r12.insert(r12.end(), s.r12.coordinates, s.r12.coordinates + 3);
        q1.insert(q1.end(), s.q1.entries, s.q1.entries + 6);
        q2.insert(q2.end(), s.q2.entries, s.q2.entries + 6);
    }
    g_assert_cmpint(pw85_distance_batch(n, r12.data(), q1.data(), q2.data(), distances.data(),
                                        point1.data(), point2.data()),
                    ==, PW85_SUCCESS);
    for (std::size_t i = 0; i < n; ++i) {
        auto d = c_distance(pairs[i]);
        g_assert_cmpint(pw85_distance_derivatives(pairs[i].r12.coordinates, pairs[i].q1.entries,
                                                  pairs[i].q2.entries, d.normal.coordinates,
                                                  nullptr, nullptr, nullptr),
                        ==, PW85_SUCCESS);
        check_points(failures, pairs[i], d);
        d.distance = distances[i];
        for (int k = 0; k < 3; ++k) {
            d.point1[k] = point1[3 * i + static_cast<std::size_t>(k)];
            d.point2[k] = point2[3 * i + static_cast<std::size_t>(k)];
        }
        check_points(failures, pairs[i], d);
    }
}

// Sums, products, quotients and roots of doubled numbers. With u = 2^-53, errors are below 4u²,
// 8u², 16u² and 16u² of the terms of a sum, and of the others themselves (M. Joldes, J.-M. Muller
// and V. Popescu, ACM Trans. Math. Softw. 44, 15 (2017): 3u², 7u², 15u²).
PW85_TEST("/distance/doubled")
{
    using Doubled = pw85::detail::Doubled<double>;
    Failures failures;
    Random random(440);
    auto const wide = [](Doubled const &x) { return Wide(x.high) + Wide(x.low); };
    for (int n = 0; n < draws(20000); ++n) {
        auto const number = [&] { return random.sign() * random.log_uniform(1e-30, 1e30); };
        auto const doubled = [&] {
            double const high = number();
            return pw85::detail::ordered_sum(high, random.uniform(-0.5, 0.5) * 0x1p-53 * high);
        };
        Doubled const x = doubled(), y = n % 2 == 0
                                             ? doubled()
                                             : -x + doubled() * Doubled(random.uniform(0.0, 1e-30));
        auto const check = [&](Doubled const &actual, Wide const &expected, Wide const &size,
                               double bound, char const *what) {
            double const error = static_cast<double>(
                Wide(pw85::detail::absolute(Wide(wide(actual) - expected)) / size));
            failures.check(error <= bound, what, error, bound, [&] {
                return hex_text(&x.high, 1) + hex_text(&x.low, 1) + hex_text(&y.high, 1);
            });
        };
        Wide const a = wide(x), b = wide(y),
                   both = pw85::detail::absolute(a) + pw85::detail::absolute(b);
        check(x + y, a + b, both, 0x1p-104, "sum");
        check(x - y, a - b, both, 0x1p-104, "difference");
        check(x * y, a * b, pw85::detail::absolute(Wide(a * b)), 0x1p-103, "product");
        check(x / y, a / b, pw85::detail::absolute(Wide(a / b)), 0x1p-102, "quotient");
        Wide const root = sqrt(Wide(a * a));
        check(sqrt(x * x), root, root, 0x1p-102, "root");
        failures.check((x < y) == (a < b) && (x >= y) == (a >= b), "order", x.high, y.high,
                       [&] { return hex_text(&x.low, 1); });
    }
}

PW85_TEST("/distance/statuses")
{
    double const r12[3] = {9.0, 0.0, 0.0}, zero[3] = {0.0, 0.0, 0.0};
    double const q[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0}, bad[6] = {1.0, 2.0, 0.0, 1.0, 0.0, 1.0};
    double const ones[2] = {1.0, 1.0};
    auto const expect = [](double const *r, double const *q1, double const *q2, int expected,
                           bool empty) {
        double out[90] = {}, distance = 1.0, point1[3] = {}, point2[3] = {};
        g_assert_cmpint(pw85_distance(r, q1, q2, &distance, point1, point2), ==, expected);
        g_assert_true(std::isnan(distance) == (expected != PW85_SUCCESS));
        g_assert_true(all_nan(point1, 3) == empty && all_nan(point2, 3) == empty);
        g_assert_cmpint(pw85_distance_derivatives(r, q1, q2, out, out + 3, out + 6, out + 9), ==,
                        expected);
        g_assert_true(all_nan(out, 90) == empty);
    };
    expect(r12, q, q, PW85_SUCCESS, false);
    expect(zero, q, q, PW85_SUCCESS, true);
    expect(zero, bad, q, PW85_ENOTPD, true);
    double distance = 1.0, points[4] = {};
    double const circle[3] = {1.0, 0.0, 1.0};
    g_assert_cmpint(pw85_distance_2d(ones, circle, circle, &distance, points, points + 2), ==,
                    PW85_SUCCESS);
    g_assert_true(distance == 0.0 && all_nan(points, 4));
}

PW85_ADD_TEST("/distance/optimality/3d", test_optimality<3>);
PW85_ADD_TEST("/distance/optimality/2d", test_optimality<2>);
PW85_ADD_TEST("/distance/rounding_errors/3d", test_rounding_errors<3>);
PW85_ADD_TEST("/distance/rounding_errors/2d", test_rounding_errors<2>);
PW85_ADD_TEST("/distance/points/3d", test_points<3>);
PW85_ADD_TEST("/distance/points/2d", test_points<2>);
PW85_ADD_TEST("/distance/polynomials/3d", test_polynomials<3>);
PW85_ADD_TEST("/distance/polynomials/2d", test_polynomials<2>);

} // namespace

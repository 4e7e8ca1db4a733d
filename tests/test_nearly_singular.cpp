// SPDX-License-Identifier: BSD-3-Clause
// Forms that are singular to working precision, or nearly so. All functions agree on which of them
// are positive definite, and for these the error of the contact function is within its bound.
#include <cstring>
#include <vector>

#include <glib.h>

#include "batch/batch_data.hpp"
#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "nearly_singular.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53, nan = std::numeric_limits<double>::quiet_NaN();

/// A pair that once had a contact function of 0.9959 with success. Its truth is 0.99999999999917,
/// and u cond is 4e-7.
Pair3 const recorded{{0x1.4b05f7d10107bp-1, 0x1.a1c6c56b4b979p-1, -0x1.c54cd963036e4p-2},
                     {0x1.4ed8510675d0ep-2, 0x1.a540544bd46eap-2, -0x1.cdc4a528b6e8cp-3,
                      0x1.08fa30dbcab4fp-1, -0x1.2276a140a76fdp-2, 0x1.3e669a83e98b4p-3},
                     {0x1.4b44dfe437f52p-2, 0x1.ac4caea2b6db6p-2, -0x1.ad234a8628f25p-3,
                      0x1.14e01a1fd0418p-1, -0x1.156ad62a0365dp-2, 0x1.15f5d7b84f10dp-3}};

/// Needles that cross: f is so flat that rounding took any λ for the maximiser.
Pair3 const crossed{{-0x1.2bf418ad9e2a4p+1, 0x1.b37324b03b3e4p+2, 0x1.1ead9093e64b3p+2},
                    {0x1.7fdf8ba117fc6p-1, 0x1.b5db37fd622bp-2, -0x1.06509defa9ddcp-4,
                     0x1.f8a9068962098p-3, -0x1.482c08d59843dp-5, 0x1.53b9293105476p-7},
                    {0x1.4b1066d62457fp+3, -0x1.44f66813bd72cp+4, -0x1.cfbb9532f2a78p+3,
                     0x1.3f1ec30546fafp+5, 0x1.c918c00c5ede2p+4, 0x1.5138d7ae38a27p+4}};

/// Pairs of aspect ratios in a range, and pairs that cross.
std::vector<Pair3> draw_pairs(std::uint64_t seed, int count, double aspect_min, double aspect_max)
{
    Random random(seed);
    std::vector<Pair3> pairs{recorded, crossed};
    for (int n = 0; n < count; ++n) {
        double const aspect = random.log_uniform(aspect_min, aspect_max);
        auto const pair =
            n % 4 == 0 ? crossed_pair(random, aspect) : nearly_singular_pair(random, aspect);
        if (std::isfinite(pair.r12[0])) pairs.push_back(pair);
    }
    return pairs;
}

/// Calls check(name, status) with the status of every function of a pair.
template <class Check> void for_each_status(Pair3 const &p, Check const &check)
{
    double const *r = p.r12.coordinates, *q1 = p.q1.entries, *q2 = p.q2.entries;
    double out[81], point[3], normal[3], gradient[6], hessian[81];
    int overlap;
    check("contact", pw85_contact(r, q1, q2, out));
    check("contact_function", pw85_contact_function(r, q1, q2, out));
    check("overlap", pw85_overlap(r, q1, q2, &overlap));
    check("closest_approach", pw85_closest_approach(r, q1, q2, out));
    check("contact_geometry", pw85_contact_geometry(r, q1, q2, 0.5, point, normal));
    check("contact_gradient", pw85_contact_gradient(r, q1, q2, 0.5, point, gradient, out));
    check("contact_torque", pw85_contact_torque(r, q1, q2, 0.5, point, normal));
    check("contact_hessian", pw85_contact_hessian(r, q1, q2, 0.5, hessian));
    check("distance", pw85_distance(r, q1, q2, out, point, normal));
    check("distance_derivatives",
          pw85_distance_derivatives(r, q1, q2, point, normal, gradient, hessian));
}

/// Calls check(name, status) with the status of every function of one form.
template <class Check>
void for_each_status(pw85::SymmetricMatrix<double, 3> const &form, Check const &check)
{
    double const axis[3] = {1.0, 0.5, 0.25}, far[3] = {9.0, 9.0, 9.0}, near[3] = {-9.0, -9.0, -9.0};
    double const *q = form.entries;
    double value[2], point[3], normal[3];
    check("bounding_boxes", pw85_bounding_boxes(1, q, point));
    check("contact_plane", pw85_contact_plane(axis, 1.0, q, value, point));
    check("distance_plane", pw85_distance_plane(axis, 1.0, q, value, point));
    check("distance_box", pw85_distance_box(near, far, q, value, point, normal));
    check("distance_segment", pw85_distance_segment(near, axis, q, value, point, normal, nullptr));
    check("distance_triangle",
          pw85_distance_triangle(near, axis, far, q, value, point, normal, nullptr));
    check("distance_solid_box",
          pw85_distance_solid_box(axis, far, q, value, point, normal, nullptr));
    check("distance_cylinder", pw85_distance_cylinder(axis, 9.0, axis, q, value, point, normal));
    check("distance_point", pw85_distance_point(far, q, value, point, normal));
    check("intersect_line", pw85_intersect_line(far, axis, q, value));
}

// All functions say the same of a form, and it is the truth: in either order, alone and in a batch.
PW85_TEST("/nearly_singular/definiteness")
{
    Failures failures;
    auto const pairs = draw_pairs(310, draws(1600), 2.5e7, 4e8);
    auto const batch = run_batch(pairs);
    long definite = 0, by_pivots = 0, unproved = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        Pair3 const &p = pairs[i], swapped{-p.r12, p.q2, p.q1};
        bool const is_definite = is_exactly_definite(p);
        definite += is_definite;
        by_pivots += !is_definite && !std::isnan(pw85::cholesky(p.q1)[0]) &&
                     !std::isnan(pw85::cholesky(p.q2)[0]);
        auto const describe = [&] { return hex_text(p); };
        auto const expect = [&](bool expected) {
            int const status = expected ? PW85_SUCCESS : PW85_ENOTPD;
            return [=, &failures, &unproved](char const *name, int actual) {
                // Distances may have no bound that can be proved.
                bool const is_open = expected && actual == PW85_ECONVERGENCE &&
                                     std::strncmp(name, "distance", 8) == 0;
                unproved += is_open;
                failures.check(is_open || actual == status, name, actual, status, describe);
            };
        };
        for_each_status(p, expect(is_definite));
        for_each_status(swapped, expect(is_definite));
        for_each_status(p.q1, expect(is_exactly_definite(p.q1)));
        failures.check(std::isnan(batch.mu2[i]) != is_definite, "batch", batch.mu2[i], is_definite,
                       describe);
        failures.check((batch.overlap[i] == 255) != is_definite, "overlap batch", batch.overlap[i],
                       is_definite, describe);
    }
    g_test_message("%zu pairs, %ld positive definite, %ld only by rounded pivots", pairs.size(),
                   definite, by_pivots);
    g_assert_cmpint(by_pivots, >, draws(8));
    g_assert_cmpint(unproved, <, static_cast<long>(pairs.size()) / 2); // of four for each pair
}

/// Σ of pw85_distance().
Wide sensitivity(Sample<Wide, 3> const &p, pw85::Vector<Wide, 3> const &n)
{
    Wide sum = 0;
    for (int i = 0; i < 3; ++i) sum += abs(n[i] * p.r12[i]);
    for (auto const *q : {&p.q1, &p.q2}) {
        Wide square = 0, magnitude = 0;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                Wide const term = n[i] * (*q)(i, j) * n[j];
                square += term;
                magnitude += abs(term);
            }
        sum += magnitude / (2 * sqrt(square));
    }
    return sum;
}

double length(pw85::Vector<double, 3> const &x) { return std::sqrt(dot(x, x)); }

// Distances and points are right to their bounds, or there is an error.
PW85_TEST("/nearly_singular/distances")
{
    Failures failures;
    int right = 0;
    for (auto const &p : draw_pairs(350, draws(900), 1e7, 4e8)) {
        double distance;
        pw85::Vector<double, 3> p1, p2;
        int const status = pw85_distance(p.r12.coordinates, p.q1.entries, p.q2.entries, &distance,
                                         p1.coordinates, p2.coordinates);
        if (status != PW85_SUCCESS || distance == 0.0) continue;
        ++right;
        auto const describe = [&] { return hex_text(p); };
        auto const wide = convert<Wide>(p);
        auto const exact = pw85::distance(wide.r12, wide.q1, wide.q2);
        double const bound = 8 * u * static_cast<double>(sensitivity(wide, exact.normal));
        double const error = std::fabs(static_cast<double>(Wide(Wide(distance) - exact.distance)));
        failures.check(error <= bound, "distance", error, bound, describe);
        double const gap = std::fabs(length(p2 - p1) - distance);
        double const widest = 0x1p18 * u * (length(p.r12) + length(p1) + length(p.r12 - p2));
        failures.check(gap <= widest, "gap of the points", gap, widest, describe);
    }
    g_assert_cmpint(right, >, draws(180));
}

/// The error of μ², in units of u cond.
double error_of(double mu2, Truth<Precise> const &exact)
{
    return std::isnan(mu2) ? HUGE_VAL : error_in_units(mu2, exact);
}

/// Checks all that contact functions say of a definite pair.
void check_contact(Pair3 const &p, double batch_mu2, int batch_overlap, Failures &failures)
{
    auto const exact = precise_truth(p);
    auto const describe = [&] { return hex_text(p); };
    auto const expect = [&](char const *name, double error) {
        failures.check(error <= 4.0, name, error, 4.0, describe);
    };
    double const *r = p.r12.coordinates, *q1 = p.q1.entries, *q2 = p.q2.entries;
    auto const opposite = -p.r12;
    double out[2] = {nan, nan}, distance = nan;
    int overlap = -1, swapped = -1;
    int const truly = exact.mu2 < 1;
    pw85_contact(r, q1, q2, out);
    expect("contact", error_of(out[0], exact));
    pw85_contact_function(r, q1, q2, out);
    expect("contact_function", error_of(out[0], exact));
    expect("contact_batch", error_of(batch_mu2, exact));
    pw85_overlap(r, q1, q2, &overlap);
    pw85_overlap(opposite.coordinates, q2, q1, &swapped);
    failures.check(overlap == truly && swapped == truly && batch_overlap == truly, "overlap",
                   overlap, truly, describe);
    // |r12|/μ: half the error of μ², and what the direction, the norm and the quotient are rounded
    // by.
    pw85_closest_approach(r, q1, q2, &distance);
    Precise const norm = sqrt(pw85::dot(convert<Precise>(p).r12, convert<Precise>(p).r12));
    Precise const relative = abs(Precise(distance * sqrt(exact.mu2) / norm - 1));
    expect("closest_approach", static_cast<double>(Precise(relative / (u * (exact.cond + 1)))));
}

PW85_TEST("/nearly_singular/accuracy")
{
    Failures failures;
    for (double aspect = 1e6; aspect < 1e8; aspect *= 20.0) {
        auto const pairs = draw_pairs(311, draws(160), aspect, 20.0 * aspect);
        auto const batch = run_batch(pairs);
        for (std::size_t i = 0; i < pairs.size(); ++i)
            if (is_exactly_definite(pairs[i]))
                check_contact(pairs[i], batch.mu2[i], batch.overlap[i], failures);
    }
}

// Ellipses, as sections of ellipsoids whose third semi-axis is 1.
PW85_TEST("/nearly_singular/two_dimensions")
{
    Failures failures;
    Random random(312);
    for (int n = 0; n < draws(400); ++n) {
        auto const p = random_pair<2>(
            random, {.aspect = 4e8, .mu2_min = 0.5, .mu2_max = 2.0, .aspect_min = 1e6});
        if (!std::isfinite(p.r12[0])) continue;
        auto const raised = [](pw85::SymmetricMatrix<double, 2> const &q) {
            return pw85::SymmetricMatrix<double, 3>{q[0], q[1], 0.0, q[2], 0.0, 1.0};
        };
        Pair3 const solid{{p.r12[0], p.r12[1], 0.0}, raised(p.q1), raised(p.q2)};
        auto const describe = [&] { return hex_text(p); };
        double out[2], distance, point[2], normal[2];
        int const expected = is_exactly_definite(solid) ? PW85_SUCCESS : PW85_ENOTPD;
        int overlap, status = pw85_contact_2d(p.r12.coordinates, p.q1.entries, p.q2.entries, out);
        auto const expect = [&](char const *name) {
            failures.check(status == expected, name, status, expected, describe);
        };
        expect("contact_2d");
        status = pw85_overlap_2d(p.r12.coordinates, p.q1.entries, p.q2.entries, &overlap);
        expect("overlap_2d");
        status = pw85_closest_approach_2d(p.r12.coordinates, p.q1.entries, p.q2.entries, &distance);
        expect("closest_approach_2d");
        status = pw85_contact_geometry_2d(p.r12.coordinates, p.q1.entries, p.q2.entries, 0.5, point,
                                          normal);
        expect("contact_geometry_2d");
        if (expected != PW85_SUCCESS) continue;
        auto const exact = precise_truth(solid);
        double const error = error_of(out[0], exact);
        failures.check(error <= 4.0, "contact_2d", error, 4.0, describe);
        failures.check(overlap == (exact.mu2 < 1), "overlap_2d", overlap, exact.mu2 < 1, describe);
    }
}

} // namespace

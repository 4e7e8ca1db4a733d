// SPDX-License-Identifier: BSD-3-Clause
// Tests of ellipsoids and polytopes: overlaps, emptiness and contacts against brute force in
// rational numbers, contacts with moved ellipsoids against 50 digits.
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85_batch.h>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "oracle/exact_numbers.hpp"
#include "random_pairs.hpp"
#include "shapes_truth.hpp"

using namespace pw85_tests;

namespace {

using RationalVector = std::vector<Rational>;

/// An ellipsoid and the planes of a polytope.
struct Case {
    Planes planes;
    Form3 q;
    Vector3 center{};

    std::size_t size() const { return planes.offsets.size(); }

    void add(Vector3 const &normal, double offset)
    {
        planes.normals.insert(planes.normals.end(), normal.coordinates, normal.coordinates + 3);
        planes.offsets.push_back(offset);
    }

    std::string text() const
    {
        return "q = " + hex_text(q.entries, 6) + ", center " + hex_text(center.coordinates, 3) +
               ", normals " + hex_text(planes.normals.data(), static_cast<int>(3 * size())) +
               ", offsets " + hex_text(planes.offsets.data(), static_cast<int>(size()));
    }
};

/// The same in other units of length, with normals of other lengths.
Case scaled(Case c, int length, int normals)
{
    for (double &x : c.planes.normals) x = std::ldexp(x, normals);
    for (double &x : c.planes.offsets) x = std::ldexp(x, normals + length);
    c.q = pw85::detail::times_power_of_two(c.q, 2 * length);
    c.center = pw85::detail::times_power_of_two(c.center, length);
    return c;
}

/// The half-spaces normal·x <= offset relative to the centre, in rational numbers.
struct RationalCase {
    std::vector<RationalVector> normals;
    RationalVector offsets;
    Rational q[3][3];

    explicit RationalCase(Case const &c)
    {
        for (std::size_t k = 0; k < c.size(); ++k) {
            RationalVector normal;
            Rational offset = c.planes.offsets[k];
            for (std::size_t i = 0; i < 3; ++i) {
                normal.push_back(Rational(c.planes.normals[3 * k + i]));
                offset -= normal[i] * Rational(c.center[static_cast<int>(i)]);
            }
            normals.push_back(normal);
            offsets.push_back(offset);
        }
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) q[i][j] = c.q(i, j);
    }

    RationalVector times_q(RationalVector const &v) const
    {
        RationalVector y(3);
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) y[i] += q[i][j] * v[j];
        return y;
    }

    bool contains(RationalVector const &x) const
    {
        for (std::size_t k = 0; k < offsets.size(); ++k)
            if (normals[k][0] * x[0] + normals[k][1] * x[1] + normals[k][2] * x[2] > offsets[k])
                return false;
        return true;
    }
};

/// Solves m x = b by elimination. Returns false if m is singular; the pivots of Gram's matrices are
/// positive otherwise.
bool solve(std::vector<RationalVector> m, RationalVector b, RationalVector &x)
{
    std::size_t const n = b.size();
    for (std::size_t c = 0; c < n; ++c) {
        if (m[c][c] == 0) return false;
        for (std::size_t r = 0; r < n; ++r) {
            if (r == c) continue;
            Rational const factor = m[r][c] / m[c][c];
            for (std::size_t j = 0; j < n; ++j) m[r][j] -= factor * m[c][j];
            b[r] -= factor * b[c];
        }
    }
    x.resize(n);
    for (std::size_t i = 0; i < n; ++i) x[i] = b[i] / m[i][i];
    return true;
}

/// Where the scaled ellipsoid touches a polytope, and the bound of pw85.h on the error of μ² in
/// units of u.
struct RationalContact {
    bool empty = true;
    Rational mu2, bound;
    RationalVector point = RationalVector(3);
};

/// The bound Σ λ_k (|n_k|·r + |o_k|), r = Σ λ_k |Q| |n_k|.
Rational bound_on_error(RationalCase const &c, std::vector<std::size_t> const &chosen,
                        RationalVector const &lambda)
{
    RationalVector r(3);
    Rational bound = 0;
    for (std::size_t i = 0; i < chosen.size(); ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k)
                r[j] += lambda[i] * abs(c.q[j][k]) * abs(c.normals[chosen[i]][k]);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        bound += lambda[i] * abs(c.offsets[chosen[i]]);
        for (std::size_t j = 0; j < 3; ++j)
            bound += lambda[i] * abs(c.normals[chosen[i]][j]) * r[j];
    }
    return bound;
}

/// Whether the point where the scaled ellipsoid touches these planes is that of the whole polytope.
/// On the planes n·x = o, with multipliers λ >= 0, x = -Q Σ λ n.
bool is_nearest(RationalCase const &c, std::vector<std::size_t> const &chosen,
                RationalContact &contact)
{
    std::vector<RationalVector> gram(chosen.size(), RationalVector(chosen.size()));
    RationalVector right, lambda, x(3);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        auto const y = c.times_q(c.normals[chosen[i]]);
        for (std::size_t j = 0; j < chosen.size(); ++j)
            for (std::size_t k = 0; k < 3; ++k) gram[i][j] += y[k] * c.normals[chosen[j]][k];
        right.push_back(-c.offsets[chosen[i]]);
    }
    if (!solve(gram, right, lambda)) return false;
    Rational mu2 = 0;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (lambda[i] < 0) return false;
        auto const y = c.times_q(c.normals[chosen[i]]);
        for (std::size_t k = 0; k < 3; ++k) x[k] -= lambda[i] * y[k];
        mu2 += lambda[i] * right[i];
    }
    if (!c.contains(x)) return false;
    contact = {false, mu2, bound_on_error(c, chosen, lambda), x};
    return true;
}

/// The only point that some set of up to three planes has in the polytope.
RationalContact contact_truth(Case const &given)
{
    RationalCase const c(given);
    std::size_t const n = given.size();
    RationalContact contact;
    contact.empty = !c.contains(contact.point);
    if (!contact.empty) return contact;
    for (std::size_t i = 0; i < n; ++i) {
        if (is_nearest(c, {i}, contact)) return contact;
        for (std::size_t j = i + 1; j < n; ++j) {
            if (is_nearest(c, {i, j}, contact)) return contact;
            for (std::size_t k = j + 1; k < n; ++k)
                if (is_nearest(c, {i, j, k}, contact)) return contact;
        }
    }
    return contact;
}

bool overlap_truth(Case const &given)
{
    auto const contact = contact_truth(given);
    return !contact.empty && contact.mu2 < 1;
}

int overlap_by_batch(Case const &c)
{
    unsigned char overlap = 7;
    int const status =
        pw85_overlap_polytope_batch(1, c.center.coordinates, c.q.entries, c.size(),
                                    c.planes.normals.data(), c.planes.offsets.data(), &overlap);
    return status == PW85_SUCCESS ? overlap : -1;
}

void check(Case const &c, bool truth, Failures &failures)
{
    auto const describe = [&] { return c.text(); };
    for (int const length : {0, 40, -40, 300, -300}) {
        int const found = overlap_by_batch(scaled(c, length, length == 300 ? 0 : 17 - length));
        failures.check(found == truth, "overlap", found, truth, describe);
    }
    auto const turned = pw85::detail::polytope_overlaps_exactly(
        c.size(), c.planes.normals.data(), c.planes.offsets.data(), c.q, c.center);
    failures.check(turned == truth, "exactly", turned, truth, describe);
    if (c.center[0] != 0 || c.center[1] != 0 || c.center[2] != 0) return;
    int overlap = 7;
    int const status = pw85_overlap_polytope(c.size(), c.planes.normals.data(),
                                             c.planes.offsets.data(), c.q.entries, &overlap);
    failures.check(status == PW85_SUCCESS && overlap == truth, "one", overlap, truth, describe);
}

int small(Random &random, int largest)
{
    return static_cast<int>(std::floor(random.uniform(-largest, largest + 1)));
}

Vector3 small_vector(Random &random, int largest)
{
    Vector3 v{};
    for (int i = 0; i < 3; ++i) v[i] = small(random, largest);
    return v;
}

/// A product of a matrix of integers and its transpose.
Form3 form_of(Vector3 const (&rows)[3])
{
    Form3 q{};
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) q(i, j) = pw85::dot(rows[i], rows[j]);
    return q;
}

bool is_definite(Form3 const &q) { return pw85::detail::validate(q) == pw85::Status::success; }

// Small integers: many polytopes touch exactly, are flat or empty, or have more than three planes
// at a vertex.
PW85_TEST("/polytopes/small_integers")
{
    Failures failures;
    Random random(701);
    int overlaps = 0, all = 0;
    for (int n = 0; n < draws(1000); ++n) {
        Case c;
        Vector3 const rows[3] = {small_vector(random, 2), small_vector(random, 2),
                                 small_vector(random, 3)};
        c.q = form_of(rows);
        if (!is_definite(c.q)) continue;
        if (n % 2 == 0) c.center = small_vector(random, 2);
        for (int k = 0; k <= n % 12; ++k) {
            Vector3 normal = small_vector(random, 2);
            if (pw85::dot(normal, normal) == 0) normal[n % 3] = 1;
            c.add(normal, small(random, 4) + (n % 5 == 0 ? 0 : 2));
        }
        bool const truth = overlap_truth(c);
        check(c, truth, failures);
        overlaps += truth;
        ++all;
    }
    g_test_message("%d of %d overlap", overlaps, all);
    g_assert_cmpint(overlaps, >, all / 10);
    g_assert_cmpint(overlaps, <, all - all / 10);
}

/// A polytope like those of random numbers, of which rounding errors decide μ² - 1.
Case nearly_touching(Random &random, int n)
{
    Case c;
    c.q = random.form(1.0, random.log_uniform(1.0, 1e6));
    Vector3 const place = random.log_uniform(0.1, 10.0) * random.direction<3>();
    for (int k = 0; k <= n % 12; ++k) {
        Vector3 const g = random.log_uniform(1e-3, 1e3) * random.direction<3>();
        c.add(g, pw85::dot(g, place) + std::sqrt(pw85::dot(g, g)) * random.uniform(-0.1, 1.0));
    }
    auto const contact =
        pw85::contact_polytope(c.size(), c.planes.normals.data(), c.planes.offsets.data(), c.q);
    if (!(contact.mu2 > 0 && contact.mu2 < 1e300)) return c;
    double const factor = (1 + (n % 4 - 1) * 0x1p-50) / std::sqrt(contact.mu2);
    for (double &offset : c.planes.offsets) offset *= factor;
    if (n % 2 == 0) return c;
    c.center = random.direction<3>();
    for (std::size_t k = 0; k < c.size(); ++k)
        for (int i = 0; i < 3; ++i)
            c.planes.offsets[k] +=
                c.planes.normals[3 * k + static_cast<std::size_t>(i)] * c.center[i];
    return c;
}

PW85_TEST("/polytopes/nearly_touching")
{
    Failures failures;
    Random random(702);
    int overlaps = 0, all = draws(160);
    for (int n = 0; n < all; ++n) {
        auto const c = nearly_touching(random, n);
        bool const truth = overlap_truth(c);
        check(c, truth, failures);
        overlaps += truth;
    }
    g_test_message("%d of %d overlap", overlaps, all);
    g_assert_cmpint(overlaps, >, all / 10);
    g_assert_cmpint(overlaps, <, all - all / 10);
}

/// A polytope that touches the ellipsoid of Q = AAᵀ at x = 7 A u for the unit vector u = (2, 3,
/// 6)/7, with one to three planes there. Their normals have the mean -s, s ~ A⁻ᵀu. A is the product
/// of 7, a diagonal matrix and shears, so that all numbers are integers.
Case touching(Random &random, int n)
{
    double const stretch = std::ldexp(1.0, static_cast<int>(random.uniform(0, 21)));
    int const a = small(random, 3), b = small(random, 3), d = small(random, 3);
    Vector3 const rows[3] = {{7 * stretch, 7.0 * a, 7.0 * b}, {0, 7, 7.0 * d}, {0, 0, 7}};
    Vector3 const u{2, 3, 6};
    Vector3 x{};
    for (int i = 0; i < 3; ++i) x[i] = pw85::dot(rows[i], u) / 7;
    // Aᵀs ~ u, times the stretch
    Vector3 s{2, 0, 0};
    s[1] = 3 * stretch - a * s[0];
    s[2] = 6 * stretch - b * s[0] - d * s[1];
    Case c;
    c.q = form_of(rows);
    for (int i = 0; i < 3; ++i) c.center[i] = n % 2 == 0 ? 0 : small(random, 9);
    Vector3 const v = small_vector(random, 5), w = small_vector(random, 5), nothing{};
    int const planes = n % 3;
    Vector3 const offsets[3] = {planes == 0 ? nothing : v, planes == 1 ? -v : w, -v - w};
    for (int k = 0; k <= planes; ++k) {
        Vector3 const normal = -s - offsets[k];
        c.add(normal, pw85::dot(normal, x + c.center));
    }
    for (int k = 0; k < n % 7; ++k) { // planes that do not matter
        Vector3 const normal = small_vector(random, 5);
        if (pw85::dot(normal, normal) > 0) c.add(normal, pw85::dot(normal, x + c.center) + (k % 2));
    }
    return c;
}

PW85_TEST("/polytopes/touching")
{
    Failures failures;
    Random random(703);
    for (int n = 0; n < draws(1000); ++n) {
        Case c = touching(random, n);
        check(c, false, failures);
        for (double &offset : c.planes.offsets)
            offset = std::nextafter(offset, std::numeric_limits<double>::infinity());
        auto const describe = [&] { return c.text(); };
        int const found = overlap_by_batch(c);
        failures.check(found == 1, "one step nearer", found, 1, describe);
        if (n % 50 == 0) failures.check(overlap_truth(c), "truth", 0, 1, describe);
    }
}

// Numbers from one end of the range of double to the other.
PW85_TEST("/polytopes/widest")
{
    Failures failures;
    double const tiny = std::numeric_limits<double>::denorm_min(), huge = 0x1p1000;
    Case c;
    c.q = {1, tiny, 0, 1, 0, 1};
    c.add({huge, tiny, 0}, -huge);
    g_assert_cmpint(overlap_by_batch(c), ==, overlap_truth(c));
    g_assert_cmpint(overlap_by_batch(c), ==, 1); // d² < gᵀQg by less than one part in 2^2000
    for (double const other : {tiny, -tiny, 1.0}) {
        Case two = c;
        two.add({tiny, -other, 0x1p-600}, 0);
        two.add({0, 0x1p-500, huge}, -tiny);
        int const found = overlap_by_batch(two);
        failures.check(found == overlap_truth(two), "overlap", found, !found,
                       [&] { return two.text(); });
    }
}

// 40 u Σ λ_k (|g_k|·r + m_k).
PW85_TEST("/polytopes/moved_contact")
{
    Failures failures;
    Random random(704);
    for (int n = 0; n < draws(500); ++n) {
        Case c = nearly_touching(random, 2 * n + 1);
        double const far = random.log_uniform(0.1, 1e3);
        for (int i = 0; i < 3; ++i) c.center[i] *= n % 2 == 0 ? 1 : far;
        auto const truth = nearest_in_polytope(MovedPlanes(c.planes, c.center), convert<Wide>(c.q));
        auto const describe = [&] { return c.text(); };
        for (int const length : {0, 40, -40}) {
            auto const s = scaled(c, length, -length / 2);
            double mu2 = -1, point[3];
            int const status = pw85_contact_polytope_batch(1, s.center.coordinates, s.q.entries,
                                                           s.size(), s.planes.normals.data(),
                                                           s.planes.offsets.data(), &mu2, point);
            if (c.q[0] < 1e-8) continue;
            failures.check(status == PW85_SUCCESS, "status", status, 0, describe);
            if (truth.mu2 < 0) {
                failures.check(std::isinf(mu2), "mu2 of an empty polytope", mu2, 0, describe);
                continue;
            }
            failures.check(abs(Wide(mu2 - truth.mu2)) <= 40 * Wide(0x1p-53) * truth.sensitivity,
                           "mu2", mu2, static_cast<double>(truth.mu2), describe);
        }
    }
}

/// Planes around a place that have no common point by a wide margin: a slab, a prism or a
/// tetrahedron inside out, a box of whole numbers that is thin, flat or inside out, or random ones,
/// of which most have a common point.
Case perhaps_empty(Random &random, int n)
{
    Case c;
    double const aspect = random.log_uniform(1.0, n / 5 % 2 == 0 ? 1e8 : 1e3);
    c.q = random.form(random.log_uniform(0.01, 1.0), aspect);
    Vector3 const place = random.log_uniform(0.1, 10.0) * random.direction<3>();
    double const margin = random.log_uniform(0.02, 1.0);
    if (n % 5 == 3) {
        for (int i = 0; i < 3; ++i) {
            Vector3 axis{};
            axis[i] = 1;
            double const lower = small(random, 3), widths[] = {0, 1, 2, 0x1p-20, -1, -0x1p-10};
            c.add(-axis, -lower);
            c.add(axis, lower + widths[static_cast<int>(random.uniform(0, 6))]);
        }
        return c;
    }
    if (n % 5 == 4) {
        for (int k = 0; k <= n % 8; ++k) {
            Vector3 const g = random.log_uniform(1e-3, 1e3) * random.direction<3>();
            c.add(g, pw85::dot(g, place) + std::sqrt(pw85::dot(g, g)) * random.uniform(-0.5, 1.0));
        }
        return c;
    }
    Vector3 last{};
    for (int k = 0; k <= n % 5; ++k) {
        Vector3 const g = random.direction<3>();
        last = last - random.uniform(0.2, 1.0) * g;
        c.add(g, pw85::dot(g, place) - margin);
    }
    c.add(last, pw85::dot(last, place) - margin);
    return c;
}

/// The contact of a case by a batch, in other units. The centre is at 0.
void check_contact(Case const &c, RationalContact const &truth, int length, Failures &failures)
{
    auto const s = scaled(c, length, -length / 2);
    auto const describe = [&] { return s.text(); };
    double mu2 = -1, point[3];
    int const status = pw85_contact_polytope(s.size(), s.planes.normals.data(),
                                             s.planes.offsets.data(), s.q.entries, &mu2, point);
    failures.check(status == PW85_SUCCESS, "status", status, 0, describe);
    failures.check(std::isinf(mu2) == truth.empty, "empty", mu2, truth.empty, describe);
    if (status != PW85_SUCCESS || std::isinf(mu2) || truth.empty) return;
    failures.check(abs(Rational(mu2) - truth.mu2) <= 32 * Rational(0x1p-53) * truth.bound, "mu2",
                   mu2, static_cast<double>(truth.mu2), describe);
    for (std::size_t k = 0; k < s.size(); ++k) {
        Rational excess = -Rational(s.planes.offsets[k]), sum = 0, normal = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            Rational const g = s.planes.normals[3 * k + i], x = point[i];
            excess += g * x;
            sum += abs(x);
            if (abs(g) > normal) normal = abs(g);
        }
        Rational const bound =
            32 * Rational(0x1p-53) * (normal * sum + abs(Rational(s.planes.offsets[k])));
        failures.check(excess <= bound, "excess", static_cast<double>(excess),
                       static_cast<double>(bound), describe);
    }
}

// Whether a polytope is empty, its μ² and the point do not depend on how slender the ellipsoid is.
PW85_TEST("/polytopes/empty")
{
    Failures failures;
    Random random(705);
    int empty = 0, all = draws(1600);
    for (int n = 0; n < all; ++n) {
        Case const c = perhaps_empty(random, n);
        if (pw85::detail::validate(c.q) != pw85::StatusCode::success) continue;
        auto const truth = contact_truth(c);
        for (int const length : {0, 40, -40}) check_contact(c, truth, length, failures);
        check(c, !truth.empty && truth.mu2 < 1, failures);
        empty += truth.empty;
    }
    g_test_message("%d of %d are empty", empty, all);
    g_assert_cmpint(empty, >, all / 3);
    g_assert_cmpint(empty, <, all - all / 5);
}

// Planes that are nearly parallel meet far away: μ² is large, but the polytope is not empty.
PW85_TEST("/polytopes/far_away")
{
    double const q[6] = {1, 0, 0, 1, 0, 1}, tilt = 0x1p-40;
    double const wedge[6] = {1, tilt, 0, -1, tilt, 0}, offsets[2] = {-1, -1};
    double mu2, point[3];
    g_assert_cmpint(pw85_contact_polytope(2, wedge, offsets, q, &mu2, point), ==, PW85_SUCCESS);
    g_assert_true(mu2 == 0x1p80 && point[0] == 0 && point[1] == -0x1p40 && point[2] == 0);
}

PW85_TEST("/polytopes/status")
{
    double const q[6] = {4, 0, 0, 1, 0, 16}, flat[6] = {1, 0, 0, 1, 0, 0},
                 nan = std::numeric_limits<double>::quiet_NaN();
    double const slab[6] = {1, 0, 0, -1, 0, 0}, apart[2] = {-1, -1}, zero[6] = {1, 0, 0, 0, 0, 0},
                 bad[2] = {1, nan};
    double mu2 = 7, point[3];
    int overlap = 7;
    g_assert_cmpint(pw85_contact_polytope(0, nullptr, nullptr, q, &mu2, point), ==, PW85_SUCCESS);
    g_assert_true(mu2 == 0 && point[0] == 0 && point[1] == 0 && point[2] == 0);
    g_assert_cmpint(pw85_overlap_polytope(0, nullptr, nullptr, q, &overlap), ==, PW85_SUCCESS);
    g_assert_cmpint(overlap, ==, 1);
    g_assert_cmpint(pw85_contact_polytope(2, slab, apart, q, &mu2, point), ==, PW85_SUCCESS);
    g_assert_true(std::isinf(mu2) && std::isnan(point[0]));
    g_assert_cmpint(pw85_overlap_polytope(2, slab, apart, q, &overlap), ==, PW85_SUCCESS);
    g_assert_cmpint(overlap, ==, 0);
    for (auto const &[normals, offsets, form, status] :
         {std::tuple{zero, apart, q, PW85_EINVAL}, std::tuple{slab, bad, q, PW85_EINVAL},
          std::tuple{slab, apart, flat, PW85_ENOTPD},
          std::tuple{static_cast<double const *>(nullptr), apart, q, PW85_EINVAL}}) {
        g_assert_cmpint(pw85_contact_polytope(2, normals, offsets, form, &mu2, point), ==, status);
        g_assert_true(std::isnan(mu2) && std::isnan(point[2]));
        g_assert_cmpint(pw85_overlap_polytope(2, normals, offsets, form, &overlap), ==, status);
        g_assert_cmpint(overlap, ==, -1);
    }
}

// A bad ellipsoid spoils its own row only.
PW85_TEST("/polytopes/bad_row")
{
    double const centers[9] = {0, 0, 0, 0, 0, 0, 9, 0, 0}, normal[3] = {1, 0, 0}, offset[1] = {2};
    double const q[18] = {1, 0, 0, 1, 0, 1, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 1};
    unsigned char overlap[3] = {7, 7, 7};
    double mu2[3], point[9];
    g_assert_cmpint(pw85_overlap_polytope_batch(3, centers, q, 1, normal, offset, overlap), ==,
                    PW85_ENOTPD);
    g_assert_true(overlap[0] == 1 && overlap[1] == 255 && overlap[2] == 0);
    g_assert_cmpint(pw85_contact_polytope_batch(3, centers, q, 1, normal, offset, mu2, point), ==,
                    PW85_ENOTPD);
    g_assert_true(mu2[0] == 0 && std::isnan(mu2[1]) && mu2[2] == 49 && point[6] == -7);
    g_assert_cmpint(pw85_overlap_polytope_batch(3, centers, q, 1, nullptr, offset, overlap), ==,
                    PW85_EINVAL);
    g_assert_cmpint(pw85_overlap_polytope_batch(0, nullptr, nullptr, 1, normal, offset, nullptr),
                    ==, PW85_SUCCESS);
}

} // namespace

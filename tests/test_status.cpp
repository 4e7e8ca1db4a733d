// SPDX-License-Identifier: BSD-3-Clause
// Statuses of values, of every function, with what happens to the outputs: forms that are not
// positive definite, zero vectors, λ. test_outputs.cpp has those of numbers that are not finite and
// of null pointers. Versions and texts.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85_any_dimension.h>
#include <pw85_batch.h>
#include <pw85_enclosing.h>
#include <pw85_simulation.h>
#include <pw85_systems.h>

#include <pw85/distance/bounding_box.hpp>

#include "call_checks.hpp"
#include "cases.hpp"
#include "causes.hpp"

using namespace pw85_tests;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool contains(std::string const &text, char const *part)
{
    return text.find(part) != std::string::npos;
}

/// Whether a parameter is a form, or an array of forms, in space or in the plane.
bool is_form(Parameter const &p) { return is_one_of(p.name, {"q", "q1", "q2", "second_moments"}); }

/// Calls each function with each of its forms replaced, in the first row, by one of two, in space
/// and in the plane, which is not positive definite.
void expect_not_definite(Failures &failures, double const *form, double const *flat)
{
    for_each_real_input([&](Function const &function, std::size_t k) {
        if (!is_form(function.parameters[k])) return;
        Call call(function, three_pairs);
        Numbers const x = numbers(call, k);
        double const *bad = x.size == 6 ? form : flat;
        std::copy(bad, bad + x.size, x.begin);
        expect_error(failures, call, k, std::string("bad ") + call.parameter(k).name, PW85_ENOTPD);
    });
}

// Negative, indefinite, singular and zero forms; also at magnitudes where products leave the range
// of double. Factors are powers of two, so that the pivots of singular forms are zero without a
// rounding error.
PW85_TEST("/status/enotpd")
{
    double const bad[][6] = {{-4.0, 0.0, 0.0, -3.0, 0.0, -2.0}, {1.0, 0.0, 0.0, 1.0, 0.0, -1.0},
                             {1.0, 2.0, 0.0, 1.0, 0.0, 1.0},    {1.0, 0.0, 0.0, 1.0, 1.0, 1.0},
                             {1.0, 0.0, 0.0, 0.0, 0.0, 1.0},    {0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
                             {1.0, 1.0, 1.0, 1.0, 1.0, 1.0}};
    double const flat[][3] = {
        {-1.0, 0.0, -1.0}, {1.0, 2.0, 1.0}, {1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};
    Failures failures;
    for (double const factor : {1.0, 0x1p-500, 0x1p-990, 0x1p990})
        for (std::size_t n = 0; n < std::size(bad); ++n) {
            double form[6], flat_form[3];
            for (int i = 0; i < 6; ++i) form[i] = factor * bad[n][i];
            for (int i = 0; i < 3; ++i) flat_form[i] = factor * flat[n % std::size(flat)][i];
            expect_not_definite(failures, form, flat_form);
        }
}

// Entries beside a small diagonal that overflow when the diagonal is scaled to order one.
PW85_TEST("/status/enotpd/overflow")
{
    constexpr int beside_diagonal[] = {1, 2, 4};
    Failures failures;
    for (double const diagonal : {0x1p-500, 0x1p-900, 0x1p-1020})
        for (double const large : {0x1p600, -0x1p600, 0x1p1000})
            for (unsigned which = 1; which < 8; ++which) {
                double form[6] = {diagonal, 0.0, 0.0, diagonal, 0.0, diagonal};
                for (unsigned i = 0; i < 3; ++i)
                    if (which >> i & 1) form[beside_diagonal[i]] = large;
                double const flat[3] = {diagonal, large, diagonal};
                expect_not_definite(failures, form, flat);
            }
}

template <class T> void expect_overflow_refused()
{
    T const small = T(4) * std::numeric_limits<T>::min(),
            large = std::numeric_limits<T>::max() / T(4), zero = T(0);
    pw85::SymmetricMatrix<T, 3> const forms[] = {{small, large, zero, small, zero, small},
                                                 {small, zero, large, small, zero, small},
                                                 {small, zero, zero, small, large, small}};
    for (auto const &q : forms)
        g_assert_true(pw85::bounding_box(q).status == pw85::Status::not_positive_definite);
    pw85::SymmetricMatrix<T, 2> const flat{small, large, small};
    g_assert_true(pw85::bounding_box(flat).status == pw85::Status::not_positive_definite);
}

PW85_TEST("/status/enotpd/overflow_in_headers")
{
    expect_overflow_refused<float>();
    expect_overflow_refused<double>();
    long double const volatile largest = std::numeric_limits<long double>::max();
    // valgrind has the range of double alone
    if (largest / 2.0L < largest) expect_overflow_refused<long double>();
}

/// Whether r12 = 0 is invalid for a function.
bool needs_direction(std::string const &function)
{
    return contains(function, "contact_geometry") || contains(function, "contact_hessian");
}

/// Whether a function takes a direction or a normal, for which valid arguments have r12.
bool takes_direction(Function const &function)
{
    return std::any_of(
        function.parameters.begin(), function.parameters.end(), [](Parameter const &p) {
            return !p.output && is_one_of(p.name, {"direction", "directions", "start", "starts",
                                                   "normal", "normals"});
        });
}

// Not even r12 = 0 hides a bad form.
PW85_TEST("/status/enotpd/concentric")
{
    double const bad[6] = {1.0, 2.0, 0.0, 1.0, 0.0, 1.0};
    Sample<double, 3> concentric = three_pairs.front();
    concentric.r12 = {0.0, 0.0, 0.0};
    std::vector<Sample<double, 3>> const pairs = {concentric};
    Failures failures;
    for_each_real_input([&](Function const &function, std::size_t k) {
        bool const of_pair = is_one_of(function.parameters[k].name, {"q1", "q2"});
        if (!of_pair || needs_direction(function.name) || takes_direction(function) ||
            contains(function.name, "closest_approach") || contains(function.name, "zheng"))
            return;
        Call call(function, pairs);
        Numbers const x = numbers(call, k);
        std::copy(bad, bad + x.size, x.begin);
        expect_error(failures, call, k, "bad and concentric", PW85_ENOTPD);
    });
}

// Directions may not be zero, and a separation only where the answer has none.
PW85_TEST("/status/einval/zero_vectors")
{
    Failures failures;
    for_each_real_input([&](Function const &function, std::size_t k) {
        char const *const name = function.parameters[k].name;
        bool const is_separation = is_one_of(name, {"r12"});
        if (!is_separation &&
            !is_one_of(name, {"direction", "directions", "start", "starts", "normal", "normals",
                              "axis", "quaternion", "quaternions", "n"}))
            return;
        Call call(function, three_pairs);
        Numbers const x = numbers(call, k);
        std::fill(x.begin, x.begin + x.size, 0.0);
        // concentric grains have no least overlap
        if (is_separation && contains(function.name, "grain"))
            expect_error(failures, call, k, "concentric grains", PW85_ECONVERGENCE);
        else if (is_separation && !needs_direction(function.name))
            expect(failures, call, "zero separation", PW85_SUCCESS);
        else
            expect_error(failures, call, k, std::string("zero ") + name, PW85_EINVAL);
    });
}

PW85_TEST("/status/einval/lambda")
{
    Failures failures;
    for_each_real_input([&](Function const &function, std::size_t k) {
        if (std::string(function.parameters[k].name) != "lambda") return;
        for (double const bad : {-1e-300, 1.0 + 0x1p-52, -1.0, 2.0}) {
            Call call(function, three_pairs);
            *numbers(call, k).begin = bad;
            expect_error(failures, call, k, "lambda out of range", PW85_EINVAL);
        }
        for (double const end : {0.0, 1.0}) {
            Call call(function, three_pairs);
            *numbers(call, k).begin = end;
            expect(failures, call, "lambda at an end", PW85_SUCCESS);
        }
    });
}

PW85_TEST("/status/building_blocks")
{
    double const r12[3] = {1.0, -2.0, 3.0}, bad[6] = {1.0, 2.0, 0.0, 1.0, 0.0, 1.0},
                 not_a_number[6] = {nan};
    double out[3], l[6],
        params[15] = {1.0, -2.0, 3.0, 4.0, 0.5, 0.0, 3.0, 0.0, 2.0, 1.0, 0.0, 0.25, 2.0, 0.0, 1.0};
    for (double const *a : {bad, not_a_number}) {
        pw85__cholesky_decomp(a, l);
        for (double const x : l) g_assert_true(std::isnan(x));
    }
    pw85__cholesky_solve(nullptr, r12, out);
    for (double const x : out) g_assert_true(std::isnan(x));
    g_assert_false(std::isnan(pw85_f_neg(0.5, params)));
    params[4] = 100.0;
    g_assert_true(std::isnan(pw85_f_neg(0.5, params)));
}

// One list makes the enumerations and the texts.
PW85_TEST("/status/texts")
{
    g_assert_cmpint(PW85_SUCCESS, ==, 0);
    g_assert_cmpint(PW85_EINVAL, ==, 1);
    g_assert_cmpint(PW85_ENOTPD, ==, 2);
    g_assert_cmpint(PW85_ECONVERGENCE, ==, 3);
    g_assert_cmpint(PW85_ENOMEM, ==, 4);
    g_assert_cmpint(PW85_EDEVICE, ==, 5);
    g_assert_cmpint(PW85_EOVERLAP, ==, 6);
    g_assert_cmpint(PW85_EPOTENTIAL, ==, 7);
#define CHECK_TEXT(c_name, cpp_name, value, text)                                                  \
    g_assert_cmpint(c_name, ==, value);                                                            \
    g_assert_cmpint(static_cast<int>(pw85::Status::cpp_name), ==, value);                          \
    g_assert_cmpstr(pw85_strerror(c_name), ==, text);
    PW85_STATUS_LIST(CHECK_TEXT)
#undef CHECK_TEXT
    char const *unknown = pw85_strerror(-1);
    g_assert_nonnull(unknown);
    for (int const status :
         {8, 1000, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()})
        g_assert_cmpstr(pw85_strerror(status), ==, unknown);
    for (int i = 0; i < 8; ++i)
        for (int j = i + 1; j < 8; ++j) g_assert_cmpstr(pw85_strerror(i), !=, pw85_strerror(j));
}

PW85_TEST("/status/version")
{
    gchar *expected =
        g_strdup_printf("%d.%d.%d", PW85_VERSION_MAJOR, PW85_VERSION_MINOR, PW85_VERSION_PATCH);
    g_assert_cmpstr(PW85_VERSION, ==, expected);
    g_assert_cmpstr(pw85_version(), ==, PW85_VERSION);
    g_free(expected);
}

// The reproducible mode is on or off, and nothing else.
PW85_TEST("/status/reproducible")
{
    int on = 7;
    g_assert_cmpint(pw85_set_reproducible(2), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_set_reproducible(-1), ==, PW85_EINVAL);
    for (int const wanted : {1, 0}) {
        g_assert_cmpint(pw85_set_reproducible(wanted), ==, PW85_SUCCESS);
        g_assert_cmpint(pw85_is_reproducible(&on), ==, PW85_SUCCESS);
        g_assert_cmpint(on, ==, wanted);
    }
    g_assert_cmpint(pw85_is_reproducible(nullptr), ==, PW85_EINVAL);
}

PW85_TEST("/status/last_error")
{
    double const r12[] = {3.0, nan, 0.0}, q[] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0}, zero[6] = {};
    double out[2];
    last_error();
    g_assert_cmpint(pw85_last_error(nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_contact(q, q, q, out), ==, PW85_SUCCESS);
    g_assert_null(last_error().function);
    g_assert_cmpint(pw85_contact(r12, q, q, out), ==, PW85_EINVAL);
    expect_cause("pw85_contact", "r12", "must be finite", 0, 1);
    g_assert_cmpint(pw85_contact(q, q, nullptr, out), ==, PW85_EINVAL);
    expect_cause("pw85_contact", "q2", "must not be null", 0, 0);
    // Beyond the limits of forms and factors, at sizes whose squares and cubes leave the range
    for (double const size : {0x1p-400, 1.0, 0x1p400}) {
        double const s[] = {size, 0, 0, 0, size, 0, 0, 0, size},
                     flat[] = {size, 0, 0, 0, 0, 0, 0, 0, size},
                     thin[] = {1.0, 0.0, 0.0, 1.0, 0.0, 1e-80};
        g_assert_cmpint(pw85_contact_factored(q, s, flat, out), ==, PW85_ENOTPD);
        expect_cause("pw85_contact_factored", "s2",
                     "must have columns that are not zero and not nearly dependent", 0, 0);
        g_assert_cmpint(pw85_contact(q, thin, q, out), ==, PW85_ENOTPD);
        expect_cause("pw85_contact", "q1", "must be positive definite", 0, 0, nan);
    }
    g_assert_cmpint(pw85_distance_plane(zero, 1.0, q, out, nullptr), ==, PW85_EINVAL);
    expect_cause("pw85_distance_plane", "normal", "must not be zero", 0, 0);
}

/// The first of two bad rows, in one block or in many, which threads share: with lanes, by a
/// function of one row, and of a list, with the record of the caller's thread.
PW85_TEST("/status/last_error/rows")
{
    for (std::size_t const n : {std::size_t{3}, std::size_t{50000}}) {
        std::vector<double> r12(3 * n, 2.0), q(6 * n), mu2(n), distance(n);
        std::vector<std::int32_t> pairs(2 * n);
        for (std::size_t i = 0; i < n; ++i) q[6 * i] = q[6 * i + 3] = q[6 * i + 5] = 1.0;
        std::size_t const bad = n / 2;
        q[6 * bad + 5] = q[6 * n - 1] = 0.0;
        g_assert_cmpint(pw85_contact_batch(n, r12.data(), q.data(), q.data(), mu2.data(), nullptr),
                        ==, PW85_ENOTPD);
        expect_cause("pw85_contact", "q1", "must be positive definite", bad, 0);
        g_assert_cmpint(pw85_distance_plane_batch(n, r12.data(), mu2.data(), q.data(),
                                                  distance.data(), nullptr),
                        ==, PW85_EINVAL); // offsets, of which that of the bad row is NaN
        expect_cause("pw85_distance_plane", "offset", "must be finite", bad, 0);
        pairs[2 * bad + 1] = static_cast<std::int32_t>(n);
        pw85_pair_list const list{n, pairs.data(), nullptr};
        pw85_system const system{n, r12.data(), q.data(), nullptr, {0, 0, 0}};
        g_assert_cmpint(pw85_contact_pairs(&list, &system, mu2.data(), nullptr), ==, PW85_EINVAL);
        expect_cause("pw85_contact_pairs", "pairs", "must be an index of a particle", bad, 1,
                     static_cast<double>(n));
        pairs[2 * bad + 1] = static_cast<std::int32_t>(bad);
        g_assert_cmpint(pw85_contact_pairs(&list, &system, mu2.data(), nullptr), ==, PW85_ENOTPD);
        expect_cause("pw85_contact", "q2", "must be positive definite", bad, 0);
    }
}

/// Neighbour lists and meshes: the first bad row, and causes that an array alone does not show.
PW85_TEST("/status/last_error/lists_and_meshes")
{
    double const q[] = {1, 0, 0, 1, 0, 1, 1, 0, 0, 1, 0, 0}, far[] = {0, 0, 0, 1e15, 0, 0},
                 flat[9] = {1, 0, 0, 0, 1, 0, 1, 1, 0};
    pw85_system system{2, far, q, flat, {1, 1, 1}};
    pw85_neighbors *list;
    g_assert_cmpint(pw85_neighbors_create(&system, 1.0, -1.0, &list), ==, PW85_EINVAL);
    expect_cause("pw85_neighbors_create", "skin", "must be >= 0", 0, 0);
    g_assert_cmpint(pw85_neighbors_create(&system, 1.0, 0.0, &list), ==, PW85_EINVAL);
    expect_cause("pw85_neighbors_create", "cell",
                 "must have finite, independent vectors, one of them periodic", 0, 0);
    system.periodic[2] = 0;
    g_assert_cmpint(pw85_neighbors_create(&system, 1.0, 0.0, &list), ==, PW85_ENOTPD);
    expect_cause("pw85_neighbors_create", "q", "must be positive definite", 1, 0);
    double const good[] = {1, 0, 0, 1, 0, 1, 1, 0, 0, 1, 0, 1};
    system.q = good;
    g_assert_cmpint(pw85_neighbors_create(&system, 1.0, 0.0, &list), ==, PW85_EINVAL);
    expect_cause("pw85_neighbors_create", "centers",
                 "must not be too far away from the cell for images", 1, 0);
    std::int32_t const triangles[] = {0, 1, 0, 0, 0, 2};
    pw85_mesh *mesh;
    g_assert_cmpint(pw85_mesh_create(2, far, 2, triangles, &mesh), ==, PW85_EINVAL);
    expect_cause("pw85_mesh_create", "triangles", "must have indices of vertices", 1, 2);
    g_assert_cmpint(pw85_mesh_create(2, far, 1, triangles, &mesh), ==, PW85_SUCCESS);
    double const centers[] = {0, 0, 0, 0, nan, 0};
    double mu2[2];
    g_assert_cmpint(pw85_mesh_contact_batch(mesh, 2, centers, good, mu2, nullptr, nullptr), ==,
                    PW85_EINVAL);
    expect_cause("pw85_mesh_contact_batch", "centers", "must be finite", 1, 1);
    pw85_mesh_destroy(mesh);
}

/// Simulations: causes by the declarations, and by the state.
PW85_TEST("/status/last_error/simulations")
{
    double const centers[] = {0, 0, 0, 3, 0, 0}, turns[] = {1, 0, 0, 0, 0, 0, 0, 0},
                 upright[] = {1, 0, 0, 0, 1, 0, 0, 0}, steps[] = {1.0, 2.0, 0.5},
                 axes[] = {1, 1, 1, 1, 1, 1};
    pw85_system const system{2, centers, nullptr, nullptr, {0, 0, 0}};
    pw85_hard_ellipsoids *made;
    g_assert_cmpint(pw85_hard_ellipsoids_create(&system, axes, turns, 1, nullptr, &made), ==,
                    PW85_EINVAL);
    expect_cause("pw85_hard_ellipsoids_create", "quaternions", "must not be zero", 1, 0);
    g_assert_cmpint(pw85_hard_ellipsoids_create(&system, axes, upright, 1, nullptr, nullptr), ==,
                    PW85_EINVAL);
    expect_cause("pw85_hard_ellipsoids_create", "simulation", "must not be null", 0, 0);
    g_assert_cmpint(pw85_hard_ellipsoids_create(&system, axes, upright, 1, nullptr, &made), ==,
                    PW85_SUCCESS);
    g_assert_cmpint(pw85_hard_ellipsoids_sweep(nullptr, 1), ==, PW85_EINVAL);
    expect_cause("pw85_hard_ellipsoids_sweep", "simulation", "must not be null", 0, 0);
    g_assert_cmpint(pw85_hard_ellipsoids_tune(made, 1, 1.5, 0.0, 0), ==, PW85_EINVAL);
    expect_cause("pw85_hard_ellipsoids_tune", "acceptance", "must be at most 1", 0, 0);
    g_assert_cmpint(pw85_hard_ellipsoids_volume_moves(made, 1, 1.0, 0), ==, PW85_EINVAL);
    expect_cause("pw85_hard_ellipsoids_volume_moves", "simulation",
                 "must have a cell that is periodic along its three vectors", 0, 0);
    g_assert_cmpint(pw85_hard_ellipsoids_set_steps(made, steps), ==, PW85_EINVAL);
    expect_cause("pw85_hard_ellipsoids_set_steps", "steps", "must be at most 1", 0, 1);
    g_assert_cmpint(pw85_hard_ellipsoids_remove(made, 2), ==, PW85_EINVAL);
    expect_cause("pw85_hard_ellipsoids_remove", "particle", "must be the index of a particle", 0,
                 0);
    pw85_hard_ellipsoids_destroy(made);
}

/// A call that is refused as a whole names the array that is null, or the size.
PW85_TEST("/status/last_error/whole_calls")
{
    double const x[] = {3.0, 0.0, 0.0, 1.0, 0.0, 1.0}, q[] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    double out[18];
    int on = 0;
    g_assert_cmpint(pw85_contact_batch(2, x, q, nullptr, out, nullptr), ==, PW85_EINVAL);
    expect_cause("pw85_contact_batch", "q2", "must not be null", 0, 0, nan);
    g_assert_cmpint(pw85_volume_batch(2, nullptr, out), ==, PW85_EINVAL);
    expect_cause("pw85_volume_batch", "q", "must not be null", 0, 0);
    g_assert_cmpint(pw85_overlap_segment_batch(1, x, nullptr, q, nullptr), ==, PW85_EINVAL);
    expect_cause("pw85_overlap_segment_batch", "end2", "must not be null", 0, 0);
    g_assert_cmpint(pw85_overlap_segment_batch(1, x, x, q, nullptr), ==, PW85_EINVAL);
    expect_cause("pw85_overlap_segment_batch", "overlap", "must not be null", 0, 0);
    g_assert_cmpint(pw85_contact_segment_batch(1, x, nullptr, q, out, nullptr), ==, PW85_EINVAL);
    expect_cause("pw85_contact_segment_batch", "end2", "must not be null", 0, 0);
    char const *const too_large =
        "must be small enough for the bytes of each array to fit ptrdiff_t";
    for (std::size_t const n : {SIZE_MAX, SIZE_MAX / 2 + 1}) {
        auto const size = static_cast<double>(n);
        g_assert_cmpint(pw85_contact_batch(n, x, q, q, out, nullptr), ==, PW85_EINVAL);
        expect_cause("pw85_contact_batch", "n", too_large, 0, 0, size);
        g_assert_cmpint(pw85_volume_batch(n, q, out), ==, PW85_EINVAL);
        expect_cause("pw85_volume_batch", "n", too_large, 0, 0, size);
        g_assert_cmpint(pw85_random_points(q, 0, 1, n, out), ==, PW85_EINVAL);
        expect_cause("pw85_random_points", "num_points", too_large, 0, 0, size);
    }
    g_assert_cmpint(pw85_random_points(out + 12, 0, 1, 1, nullptr), ==, PW85_EINVAL);
    expect_cause("pw85_random_points", "points", "must not be null", 0, 0);
    g_assert_cmpint(pw85_random_points(nullptr, 0, 1, 1, out), ==, PW85_EINVAL);
    expect_cause("pw85_random_points", "q", "must not be null", 0, 0);
    g_assert_cmpint(pw85_set_reproducible(7), ==, PW85_EINVAL);
    expect_cause("pw85_set_reproducible", "on", "must be 0 or 1", 0, 0, 7.0);
    g_assert_cmpint(pw85_is_reproducible(nullptr), ==, PW85_EINVAL);
    expect_cause("pw85_is_reproducible", "on", "must not be null", 0, 0);
    g_assert_cmpint(pw85_is_reproducible(&on), ==, PW85_SUCCESS);
}

PW85_TEST("/status/last_error/systems")
{
    double const centers[] = {0.0, 0.0, 0.0, 3.0, 0.0, 0.0},
                 q[] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    double cell[] = {9.0, 0.0, 0.0, 0.0, 9.0, 0.0, 0.0, 0.0, 9.0}, mu2, limit;
    std::int32_t const pairs[] = {0, 1};
    pw85_pair_list const list{1, pairs, nullptr};
    pw85_system system{2, centers, q, cell, {0, 0, 0}};
    char const *const name = "pw85_contact_pairs";
    g_assert_cmpint(pw85_contact_pairs(nullptr, &system, &mu2, nullptr), ==, PW85_EINVAL);
    expect_cause(name, "list", "must not be null", 0, 0);
    g_assert_cmpint(pw85_contact_pairs(&list, &system, &mu2, nullptr), ==, PW85_EINVAL);
    expect_cause(name, "periodic", "must be set along at least one vector of the cell", 0, 0);
    g_assert_cmpint(pw85_nearest_image_limit(&system, &limit), ==, PW85_EINVAL);
    expect_cause("pw85_nearest_image_limit", "periodic",
                 "must be set along at least one vector of the cell", 0, 0);
    std::fill_n(system.periodic, 3, 1);
    cell[4] = HUGE_VAL;
    g_assert_cmpint(pw85_contact_pairs(&list, &system, &mu2, nullptr), ==, PW85_EINVAL);
    expect_cause(name, "cell", "must be finite along the periodic vectors", 0, 4, HUGE_VAL);
    cell[4] = 0.0;
    g_assert_cmpint(pw85_contact_pairs(&list, &system, &mu2, nullptr), ==, PW85_EINVAL);
    expect_cause(name, "cell", "must have independent rows", 0, 0, nan);
    system.q = nullptr;
    g_assert_cmpint(pw85_contact_pairs(&list, &system, &mu2, nullptr), ==, PW85_EINVAL);
    expect_cause(name, "q", "must not be null", 0, 0);
}

/// Calls with one of the ways in which a law can be wrong.
PW85_TEST("/status/last_error/laws")
{
    double const centers[6] = {}, q[12] = {};
    pw85_pair_list const none{0, nullptr, nullptr};
    pw85_system const system{2, centers, q, nullptr, {0, 0, 0}};
    auto const expect = [&](int kind, std::size_t n, std::initializer_list<double> parameters,
                            char const *member, char const *text, std::size_t entry, double value) {
        pw85_law const law{kind, n, parameters.begin()};
        double energy;
        g_assert_cmpint(
            pw85_law_forces_pairs(&none, &system, &law, &energy, nullptr, nullptr, nullptr), ==,
            PW85_EINVAL);
        expect_cause("pw85_law_forces_pairs", member, text, 0, entry, value);
    };
    expect(9, 2, {1.0, 2.0}, "kind", "must be a constant PW85_LAW_...", 0, 9.0);
    expect(PW85_LAW_SOFT_REPULSION, 1, {1.0}, "num_parameters", "must be 2 for this kind", 0, 1.0);
    expect(PW85_LAW_SOFT_REPULSION, 2, {}, "parameters", "must not be null", 0, nan);
    expect(PW85_LAW_SOFT_REPULSION, 2, {1.0, nan}, "parameters", "must be finite", 1, nan);
    expect(PW85_LAW_SOFT_REPULSION, 2, {1.0, 0.5}, "parameters",
           "must have an exponent that is >= 1", 1, 0.5);
    expect(PW85_LAW_INVERSE_POWERS, 2, {4.0, 12.0}, "num_parameters", "must be 5 for this kind", 0,
           2.0);
    expect(PW85_LAW_INVERSE_POWERS, 5, {4.0, 12.0, 4.0, 0.0, 1.0}, "parameters",
           "must have exponents n > m > 0", 3, 0.0);
    expect(PW85_LAW_INVERSE_POWERS, 5, {4.0, 6.0, 4.0, 6.0, 1.0}, "parameters",
           "must have exponents n > m > 0", 1, 6.0);
    expect(PW85_LAW_INVERSE_POWERS, 5, {4.0, 12.0, 4.0, 6.0, -1.0}, "parameters",
           "must have a cutoff that is > 0", 4, -1.0);
    expect(PW85_LAW_TABLE, 7, {0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0}, "num_parameters",
           "must be even and at least 6 for this kind", 0, 7.0);
    expect(PW85_LAW_TABLE, 6, {1.0, 1.0, 1.0, 1.0, 1.0, 1.0}, "parameters",
           "must have a range whose end is above its begin", 1, 1.0);
}

/// Causes of functions in n dimensions, of one pair and of rows.
PW85_TEST("/status/last_error/any_dimension")
{
    double const r12[] = {3, 0, 0, 0}, zero[4] = {}, bad[] = {3, 0, nan, 0},
                 form[] = {1, 0, 0, 0, 1, 0, 0, 1, 0, 1}, flat[] = {1, 1, 0, 0, 1, 0, 0, 1, 0, 1};
    double out[2], numbers[4];
    int sign;
    g_assert_cmpint(pw85_nd_contact(17, r12, form, form, out), ==, PW85_EINVAL);
    expect_cause("pw85_nd_contact", "n", "must be from 1 to 16", 0, 0, 17);
    g_assert_cmpint(pw85_nd_contact(4, r12, form, form, nullptr), ==, PW85_EINVAL);
    expect_cause("pw85_nd_contact", "out", "must not be null", 0, 0);
    g_assert_cmpint(pw85_nd_contact(4, bad, form, form, out), ==, PW85_EINVAL);
    expect_cause("pw85_nd_contact", "r12", "must be finite", 0, 2, nan);
    g_assert_cmpint(pw85_nd_overlap(4, r12, form, flat, &sign), ==, PW85_ENOTPD);
    expect_cause("pw85_nd_overlap", "q2", "must be positive definite", 0, 0, nan);
    g_assert_cmpint(pw85_nd_contains(4, r12, flat, form, &sign), ==, PW85_ENOTPD);
    expect_cause("pw85_nd_contains", "q1", "must be positive definite", 0, 0, nan);
    g_assert_cmpint(pw85_nd_containment(4, nullptr, form, form, out, nullptr), ==, PW85_EINVAL);
    expect_cause("pw85_nd_containment", "r12", "must not be null", 0, 0);
    g_assert_cmpint(pw85_nd_distance(0, r12, form, form, out, nullptr, nullptr, nullptr), ==,
                    PW85_EINVAL);
    expect_cause("pw85_nd_distance", "n", "must be from 1 to 16", 0, 0, 0);
    g_assert_cmpint(pw85_nd_compare(4, r12, form, form, -1.0, &sign), ==, PW85_EINVAL);
    expect_cause("pw85_nd_compare", "mu2", "must be >= 0", 0, 0, -1.0);
    auto const geometry = [&](double const *r, double lambda) {
        return pw85_nd_contact_geometry(4, r, form, form, lambda, numbers, nullptr, nullptr,
                                        nullptr, nullptr);
    };
    g_assert_cmpint(geometry(r12, 1.5), ==, PW85_EINVAL);
    expect_cause("pw85_nd_contact_geometry", "lambda", "must be in [0, 1]", 0, 0, 1.5);
    g_assert_cmpint(geometry(zero, 0.5), ==, PW85_EINVAL);
    expect_cause("pw85_nd_contact_geometry", "r12", "must not be zero", 0, 0);
    double const two[] = {3, 0, 0, 0}, forms[] = {1, 0, 1, 1, 1, 1}, good[] = {1, 0, 1, 1, 0, 1};
    double mu2[2];
    g_assert_cmpint(pw85_nd_contact_batch(2, 2, two, good, forms, mu2, nullptr), ==, PW85_ENOTPD);
    expect_cause("pw85_nd_contact", "q2", "must be positive definite", 1, 0, nan);
    g_assert_cmpint(pw85_nd_contact_batch(2, 2, two, good, forms, nullptr, nullptr), ==,
                    PW85_EINVAL);
    expect_cause("pw85_nd_contact_batch", "mu2", "must not be null", 0, 0);
    g_assert_cmpint(pw85_nd_contact_batch(0, 17, two, good, forms, mu2, nullptr), ==, PW85_EINVAL);
    expect_cause("pw85_nd_contact_batch", "n", "must be from 1 to 16", 0, 0, 17);
}

/// Causes of the functions for ellipsoids around points and around ellipsoids.
PW85_TEST("/status/last_error/clouds")
{
    double const points[] = {0, 0, 1, 0, 0, 1, 1, HUGE_VAL}, line[] = {0, 0, 1, 1, 2, 2},
                 wide[] = {-1e300, 1e300, 0}, forms[] = {1, 0, 1, 1, 0, 1, 1, 1, 1, 1, 0, 1};
    auto const around = [&](int n, std::size_t m, double const *x, double tolerance) {
        return pw85_enclosing_ellipsoid(n, m, x, tolerance, nullptr, nullptr, nullptr);
    };
    auto const around_ellipsoids = [&](std::size_t m, double const *x, double const *q,
                                       double tolerance) {
        return pw85_enclosing_ellipsoid_of(2, m, x, q, tolerance, nullptr, nullptr, nullptr);
    };
    char const *const one = "pw85_enclosing_ellipsoid", *const other =
                                                            "pw85_enclosing_ellipsoid_of";
    g_assert_cmpint(around(0, 3, points, 1.0), ==, PW85_EINVAL);
    expect_cause(one, "n", "must be from 1 to 16", 0, 0, 0);
    g_assert_cmpint(around(2, 2, points, 1.0), ==, PW85_EINVAL);
    expect_cause(one, "m", "must be at least n + 1", 0, 0, 2);
    g_assert_cmpint(around(2, 3, nullptr, 1.0), ==, PW85_EINVAL);
    expect_cause(one, "points", "must not be null", 0, 0);
    g_assert_cmpint(around(2, 4, points, 1.0), ==, PW85_EINVAL);
    expect_cause(one, "points", "must be finite", 3, 1, HUGE_VAL);
    g_assert_cmpint(around(2, 3, points, -1.0), ==, PW85_EINVAL);
    expect_cause(one, "tolerance", "must be > 0", 0, 0, -1);
    g_assert_cmpint(around(1, 3, wide, 1.0), ==, PW85_EINVAL);
    expect_cause(one, "points",
                 "must have an extent between 2^-480 and 2^480 along each coordinate", 0, 0);
    g_assert_cmpint(around(2, 3, line, 1.0), ==, PW85_ENOTPD);
    expect_cause(one, "points", "must not be in a hyperplane, or too close to one", 0, 0);
    g_assert_cmpint(around_ellipsoids(0, points, forms, 1.0), ==, PW85_EINVAL);
    expect_cause(other, "m", "must be at least 1", 0, 0, 0);
    g_assert_cmpint(around_ellipsoids(4, points, forms, 1.0), ==, PW85_EINVAL);
    expect_cause(other, "centers", "must be finite", 3, 1, HUGE_VAL);
    g_assert_cmpint(around_ellipsoids(3, points, forms, 1.0), ==, PW85_ENOTPD);
    expect_cause(other, "forms", "must be positive definite", 2, 0);
    g_assert_cmpint(around_ellipsoids(2, points, nullptr, 1.0), ==, PW85_EINVAL);
    expect_cause(other, "forms", "must not be null", 0, 0);
    g_assert_cmpint(around_ellipsoids(2, points, forms, 1e-300), ==, PW85_ECONVERGENCE);
    expect_cause(other, nullptr, "the excess is above the tolerance", 0, 0);
}

} // namespace

// How much stack the library needs: every public function, in a thread with little of it, painted beforehand.
#include <climits>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iterator>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <glib.h>
#include <pthread.h>
#include <sys/mman.h>
#include <unistd.h>

#include <pw85_legacy.h>
#include <pw85_zheng.h>

#include <pw85/batch.hpp>

#include "declarations.hpp"
#include "random_pairs.hpp"
#include "reference_data.hpp"

using namespace pw85_tests;

namespace {

/// What pw85.h promises.
constexpr std::size_t bound = 16 * 1024;

/// Without optimisation, and with what sanitizers put around variables, frames are larger.
#if defined(__has_feature)
#define PW85_HAS_FEATURE(x) __has_feature(x)
#else
#define PW85_HAS_FEATURE(x) 0
#endif
#if !defined(__OPTIMIZE__) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) ||                         \
    PW85_HAS_FEATURE(address_sanitizer) || PW85_HAS_FEATURE(thread_sanitizer)
constexpr bool is_instrumented = true;
#else
constexpr bool is_instrumented = false;
#endif

/// The smallest stack that a thread may have, and as much again as the library and its caller may want.
std::size_t stack_size()
{
    long const least = sysconf(_SC_THREAD_STACK_MIN);
    return static_cast<std::size_t>(least > 0 ? least : PTHREAD_STACK_MIN) + 32 * 1024;
}

void *call(void *function)
{
    (*static_cast<std::function<void()> *>(function))();
    return nullptr;
}

/// Bytes of the stack that a thread touches that calls a function. Below the stack is a page that may not be touched.
std::size_t touched_by(std::function<void()> function)
{
    constexpr unsigned char paint = 0xa5;
    auto const page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE)), size = (stack_size() + page - 1) / page * page;
    void *const memory = mmap(nullptr, size + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    g_assert_true(memory != MAP_FAILED);
    g_assert_cmpint(mprotect(memory, page, PROT_NONE), ==, 0);
    auto *const stack = static_cast<unsigned char *>(memory) + page;
    std::memset(stack, paint, size);
    pthread_attr_t attributes;
    pthread_t thread;
    g_assert_cmpint(pthread_attr_init(&attributes), ==, 0);
    g_assert_cmpint(pthread_attr_setstack(&attributes, stack, size), ==, 0);
    g_assert_cmpint(pthread_create(&thread, &attributes, call, &function), ==, 0);
    g_assert_cmpint(pthread_join(thread, nullptr), ==, 0);
    pthread_attr_destroy(&attributes);
    std::size_t clean = 0;
    while (clean < size && stack[clean] == paint) ++clean;
    munmap(memory, size + page);
    return size - clean;
}

/// Pairs that every tier and every scalar kernel sees: ordinary ones, slender, of extreme sizes, as near to contact as can be,
/// concentric, and bad.
struct Inputs {
    std::vector<Sample<double, 3>> pairs;
    std::vector<double> r12, q1, q2, centers, forms;
    std::vector<std::int32_t> list;
    std::size_t n;

    Inputs()
    {
        Random random(140);
        for (int k = 0; k < 600; ++k)
            pairs.push_back(random_pair<3>(random, {.aspect = k % 2 == 0 ? 10.0 : 1e6, .size_ratio = 100.0}));
        for (auto const &p : contact_problems())
            if (pw85::absolute(p.mu2_minus_1) < 1e-12) pairs.push_back(p.pair);
        double const tiny = 0x1p-1074, radius2 = 0x1p1022;
        pairs.push_back(
            {{0x1p512, tiny, 0}, {radius2, tiny, 0, radius2, 0, radius2}, {radius2, 0, tiny, radius2, 0, radius2}});
        pairs.push_back({{0, 0, 0}, {1, 0, 0, 1, 0, 1}, {1, 0, 0, 1, 0, 1}});
        pairs.push_back({{1, 0, 0}, {-1, 0, 0, 1, 0, 1}, {1, 0, 0, 1, 0, 1}});
        n = 3 * pairs.size();
        for (std::size_t i = 0; i < n; ++i) {
            auto const &p = pairs[i % pairs.size()];
            r12.insert(r12.end(), p.r12.coordinates, p.r12.coordinates + 3);
            q1.insert(q1.end(), p.q1.entries, p.q1.entries + 6);
            q2.insert(q2.end(), p.q2.entries, p.q2.entries + 6);
            list.push_back(static_cast<std::int32_t>(2 * i));
            list.push_back(static_cast<std::int32_t>(2 * i + 1));
            centers.insert(centers.end(), 3, 0.0);
            centers.insert(centers.end(), p.r12.coordinates, p.r12.coordinates + 3);
            forms.insert(forms.end(), p.q1.entries, p.q1.entries + 6);
            forms.insert(forms.end(), p.q2.entries, p.q2.entries + 6);
        }
    }
};

Inputs const &inputs()
{
    static Inputs const all;
    return all;
}

/// A call for each pair, or for one in `step`.
template <class Call> std::function<void()> for_each_pair(Call call, std::size_t step = 1)
{
    return [call, step] {
        for (std::size_t i = 0; i < inputs().pairs.size(); i += step) {
            auto const &p = inputs().pairs[i];
            call(p.r12.coordinates, p.q1.entries, p.q2.entries);
        }
    };
}

/// For functions that take a thousand times as long as others.
constexpr std::size_t long_step = 16;

struct Case {
    char const *function;
    std::function<void()> call;
};

// What the functions return is the concern of other tests.
double out[96];
pw85_motion const motions[2] = {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.5}, {{0.0, -1.0, 0.0}, {0.0, 0.0, 0.0}, 0.0}};
int status, answer;

std::vector<Case> cases_of_pairs()
{
    using Numbers = double const *;
    return {
        {"pw85_contact", for_each_pair([](Numbers r, Numbers p, Numbers q) { status = pw85_contact(r, p, q, out); })},
        {"pw85_contact_function",
         for_each_pair([](Numbers r, Numbers p, Numbers q) { status = pw85_contact_function(r, p, q, out); })},
        {"pw85_contact_geometry", for_each_pair([](Numbers r, Numbers p, Numbers q) {
             status = pw85_contact_geometry(r, p, q, 0.3, out, out + 3);
         })},
        {"pw85_contact_gradient", for_each_pair([](Numbers r, Numbers p, Numbers q) {
             status = pw85_contact_gradient(r, p, q, 0.3, out, out + 3, out + 9);
         })},
        {"pw85_contact_torque", for_each_pair([](Numbers r, Numbers p, Numbers q) {
             status = pw85_contact_torque(r, p, q, 0.3, out, out + 3);
         })},
        {"pw85_contact_hessian",
         for_each_pair([](Numbers r, Numbers p, Numbers q) { status = pw85_contact_hessian(r, p, q, 0.3, out); })},
        {"pw85_overlap",
         for_each_pair([](Numbers r, Numbers p, Numbers q) { status = pw85_overlap(r, p, q, &answer); })},
        {"pw85_closest_approach",
         for_each_pair([](Numbers r, Numbers p, Numbers q) { status = pw85_closest_approach(r, p, q, out); })},
        {"pw85_contact_2d",
         for_each_pair([](Numbers r, Numbers p, Numbers q) { status = pw85_contact_2d(r, p + 3, q + 3, out); })},
        {"pw85_contact_geometry_2d", for_each_pair([](Numbers r, Numbers p, Numbers q) {
             status = pw85_contact_geometry_2d(r, p + 3, q + 3, 0.3, out, out + 2);
         })},
        {"pw85_contact_gradient_2d", for_each_pair([](Numbers r, Numbers p, Numbers q) {
             status = pw85_contact_gradient_2d(r, p + 3, q + 3, 0.3, out, out + 2, out + 4);
         })},
        {"pw85_contact_torque_2d", for_each_pair([](Numbers r, Numbers p, Numbers q) {
             status = pw85_contact_torque_2d(r, p + 3, q + 3, 0.3, out, out + 1);
         })},
        {"pw85_contact_hessian_2d", for_each_pair([](Numbers r, Numbers p, Numbers q) {
             status = pw85_contact_hessian_2d(r, p + 3, q + 3, 0.3, out);
         })},
        {"pw85_overlap_2d",
         for_each_pair([](Numbers r, Numbers p, Numbers q) { status = pw85_overlap_2d(r, p + 3, q + 3, &answer); })},
        {"pw85_closest_approach_2d", for_each_pair([](Numbers r, Numbers p, Numbers q) {
             status = pw85_closest_approach_2d(r, p + 3, q + 3, out);
         })},
        {"pw85__residual", for_each_pair([](Numbers r, Numbers p, Numbers q) { pw85__residual(0.3, r, p, q, out); })},
        {"pw85_f_neg", for_each_pair([](Numbers r, Numbers p, Numbers q) {
             double params[15];
             std::memcpy(params, r, 3 * sizeof(double));
             std::memcpy(params + 3, p, 6 * sizeof(double));
             std::memcpy(params + 9, q, 6 * sizeof(double));
             out[0] = pw85_f_neg(0.3, params);
         })},
        {"pw85_legacy_f1",
         for_each_pair([](Numbers r, Numbers p, Numbers q) { out[3] = pw85_legacy_f1(0.3, r, p, q, out); })},
        {"pw85_legacy_f2",
         for_each_pair([](Numbers r, Numbers p, Numbers q) { out[3] = pw85_legacy_f2(0.3, r, p, q, out); })},
        {"pw85_legacy_f2_derivatives",
         for_each_pair([](Numbers r, Numbers p, Numbers q) { pw85_legacy_f2_derivatives(0.3, r, p, q, out); })},
        {"pw85_legacy_contact_function1",
         for_each_pair([](Numbers r, Numbers p, Numbers q) { status = pw85_legacy_contact_function1(r, p, q, out); })},
        {"pw85_legacy_contact_function2",
         for_each_pair([](Numbers r, Numbers p, Numbers q) { status = pw85_legacy_contact_function2(r, p, q, out); })},
        {"pw85_zheng_ellipses",
         for_each_pair([](Numbers r, Numbers p, Numbers q) { status = pw85_zheng_ellipses(r, p + 3, q + 3, out); })},
        {"pw85_zheng_ellipsoids",
         for_each_pair([](Numbers r, Numbers p, Numbers q) { status = pw85_zheng_ellipsoids(r, p, q, out); })},
    };
}

/// Distances of pairs, and from one ellipsoid to walls and points.
std::vector<Case> cases_of_distances()
{
    using Numbers = double const *;
    return {
        {"pw85_distance", for_each_pair([](Numbers r, Numbers p, Numbers q) {
             status = pw85_distance(r, p, q, out, out + 1, out + 4);
         })},
        {"pw85_distance_derivatives", for_each_pair([](Numbers r, Numbers p, Numbers q) {
             status = pw85_distance_derivatives(r, p, q, out, out + 3, out + 6, out + 9);
         })},
        {"pw85_distance_2d", for_each_pair([](Numbers r, Numbers p, Numbers q) {
             status = pw85_distance_2d(r, p + 3, q + 3, out, out + 1, out + 3);
         })},
        {"pw85_penetration",
         for_each_pair([](Numbers r, Numbers p, Numbers q) { status = pw85_penetration(r, p, q, out, out + 1); },
                       long_step)},
        {"pw85_first_contact", for_each_pair(
                                   [](Numbers r, Numbers p, Numbers q) {
                                       status = pw85_first_contact(r, p, q, &motions[0], &motions[1], 1.0, out);
                                       status = pw85_first_contact(r, p, q, &motions[1], &motions[1], 1.0, out);
                                   },
                                   long_step)},
        {"pw85_distance_plane",
         for_each_pair([](Numbers r, Numbers p, Numbers) { status = pw85_distance_plane(r, 1.0, p, out, out + 1); })},
        {"pw85_distance_plane_derivatives", for_each_pair([](Numbers r, Numbers p, Numbers) {
             status = pw85_distance_plane_derivatives(r, p, out, out + 3);
         })},
        {"pw85_contact_plane",
         for_each_pair([](Numbers r, Numbers p, Numbers) { status = pw85_contact_plane(r, 1.0, p, out, out + 1); })},
        {"pw85_contact_plane_derivatives", for_each_pair([](Numbers r, Numbers p, Numbers) {
             status = pw85_contact_plane_derivatives(r, 1.0, p, out, out + 3);
         })},
        {"pw85_distance_box", for_each_pair([](Numbers r, Numbers p, Numbers) {
             double const lower[3] = {-pw85::absolute(r[0]), -pw85::absolute(r[1]), -pw85::absolute(r[2])};
             double const upper[3] = {-lower[0], -lower[1], -lower[2]};
             status = pw85_distance_box(lower, upper, p, out, out + 1, out + 4);
         })},
        {"pw85_distance_cylinder", for_each_pair([](Numbers r, Numbers p, Numbers q) {
             status = pw85_distance_cylinder(q, 4.0, r, p, out, out + 1, out + 4);
         })},
        {"pw85_distance_point", for_each_pair([](Numbers r, Numbers p, Numbers) {
             status = pw85_distance_point(r, p, out, out + 1, out + 4);
         })},
        {"pw85_intersect_line",
         for_each_pair([](Numbers r, Numbers p, Numbers q) { status = pw85_intersect_line(r, q, p, out); })},
    };
}

std::vector<Case> cases_of_forms()
{
    static double const axes[3] = {1.0, 2.0, 3.0}, rotation[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1},
                        quaternion[4] = {1, 2, 3, 4};
    return {
        {"pw85_version", [] { answer = *pw85_version(); }},
        {"pw85_strerror", [] { answer = *pw85_strerror(PW85_ENOTPD); }},
        {"pw85_spheroid", [] { pw85_spheroid(1.0, 2.0, axes, out); }},
        {"pw85_ellipsoid", [] { status = pw85_ellipsoid(axes, rotation, out); }},
        {"pw85_ellipsoid_quaternion", [] { status = pw85_ellipsoid_quaternion(axes, quaternion, out); }},
        {"pw85_ellipse", [] { status = pw85_ellipse(1.0, 2.0, 0.5, out); }},
        {"pw85__cholesky_decomp", [] { pw85__cholesky_decomp(inputs().q1.data(), out); }},
        {"pw85__cholesky_solve", [] { pw85__cholesky_solve(inputs().q1.data(), axes, out); }},
        {"pw85_legacy__det_sym", [] { out[0] = pw85_legacy__det_sym(inputs().q1.data()); }},
        {"pw85_legacy__xT_adjA_x", [] { out[0] = pw85_legacy__xT_adjA_x(axes, inputs().q1.data()); }},
        {"pw85_legacy__detQ_as_poly",
         [] {
             double const *q = inputs().q1.data();
             pw85_legacy__detQ_as_poly(q, q + 6, q + 12, q + 18, out);
         }},
        {"pw85_legacy__rT_adjQ_r_as_poly",
         [] {
             double const *q = inputs().q1.data();
             pw85_legacy__rT_adjQ_r_as_poly(axes, q, q + 6, q + 12, out);
         }},
    };
}

/// The threads that a batch starts have stacks of their own.
std::vector<Case> cases_of_batches()
{
    static std::vector<double> mu2(inputs().n), lambda(inputs().n);
    static std::vector<unsigned char> overlap(inputs().n);
    static double const cell[9] = {3, 1, 0, -1, 4, 1, 0.5, 1, 5};
    static pw85_neighbors *neighbors;
    static std::vector<double> vectors[6];
    for (auto &rows : vectors) rows.resize(6 * inputs().n);
    auto const v = [](int i) { return vectors[i].data(); };
    auto const n = inputs().n;
    auto const *r = inputs().r12.data(), *p = inputs().q1.data(), *q = inputs().q2.data();
    auto const *x = inputs().centers.data(), *forms = inputs().forms.data();
    auto const *list = inputs().list.data();
    return {
        {"pw85_contact_batch", [=] { status = pw85_contact_batch(n, r, p, q, mu2.data(), lambda.data()); }},
        {"pw85_overlap_batch", [=] { status = pw85_overlap_batch(n, r, p, q, overlap.data()); }},
        {"pw85_contact_batch_2d", [=] { status = pw85_contact_batch_2d(n, r, p, q, mu2.data(), lambda.data()); }},
        {"pw85_overlap_batch_2d", [=] { status = pw85_overlap_batch_2d(n, r, p, q, overlap.data()); }},
        {"pw85_contact_pairs",
         [=] { status = pw85_contact_pairs(n, list, nullptr, 2 * n, x, forms, nullptr, mu2.data(), lambda.data()); }},
        {"pw85_contact_pairs",
         [=] { status = pw85_contact_pairs(n, list, nullptr, 2 * n, x, forms, cell, mu2.data(), nullptr); }},
        {"pw85_overlap_pairs",
         [=] { status = pw85_overlap_pairs(n, list, nullptr, 2 * n, x, forms, nullptr, overlap.data()); }},
        {"pw85_overlap_pairs",
         [=] { status = pw85_overlap_pairs(n, list, nullptr, 2 * n, x, forms, cell, overlap.data()); }},
        {"pw85_contact_derivatives_batch",
         [=] { status = pw85_contact_derivatives_batch(n, r, p, q, mu2.data(), v(0), v(1), v(2), v(3), v(4), v(5)); }},
        {"pw85_contact_derivatives_pairs",
         [=] {
             status = pw85_contact_derivatives_pairs(n, list, nullptr, 2 * n, x, forms, cell, mu2.data(), v(0), v(1),
                                                     v(2), v(3), v(4), v(5));
         }},
        {"pw85_closest_approach_batch", [=] { status = pw85_closest_approach_batch(n, r, p, q, mu2.data()); }},
        {"pw85_distance_batch", [=] { status = pw85_distance_batch(n, r, p, q, v(0), v(1), v(2)); }},
        {"pw85_penetration_batch", [=] { status = pw85_penetration_batch(n / long_step, r, p, q, v(0), v(1)); }},
        {"pw85_distance_plane_batch", [=] { status = pw85_distance_plane_batch(n, r, r, p, v(0), v(1)); }},
        {"pw85_first_contact_batch",
         [=] {
             static std::vector<pw85_motion> const same(n, motions[0]);
             status = pw85_first_contact_batch(n / long_step, r, p, q, same.data(), same.data(), 1.0, mu2.data());
         }},
        {"pw85_first_contact_pairs",
         [=] {
             static std::vector<pw85_motion> const same(2 * n, motions[0]);
             static std::vector<std::int64_t> next_pair(2 * n);
             status = pw85_first_contact_pairs(n / long_step, list, nullptr, 2 * n, x, forms, cell, same.data(), 1.0,
                                               mu2.data(), v(0), next_pair.data());
         }},
        {"pw85_overlap_any", [=] { status = pw85_overlap_any(n, p, r, q, &answer); }},
        {"pw85_ellipsoid_quaternion_batch", [=] { status = pw85_ellipsoid_quaternion_batch(n, x, forms, v(0)); }},
        {"pw85_bounding_boxes", [=] { status = pw85_bounding_boxes(n, p, v(0)); }},
        {"pw85_overlap_any_indices",
         [=] { status = pw85_overlap_any_indices(x, forms, n, list, 2 * n, x, forms, cell, &answer); }},
        {"pw85_contact_forces_pairs",
         [=] { status = pw85_contact_forces_pairs(n, list, nullptr, 2 * n, x, cell, r, x, x, x, v(0), v(1), v(2)); }},
        {"pw85_neighbors_create",
         [=] { status = pw85_neighbors_create(2 * n, x, forms, cell, nullptr, 1.0, 0.5, &neighbors); }},
        {"pw85_neighbors_check",
         [=] {
             std::size_t particle;
             status = pw85_neighbors_check(2 * n, x, forms, cell, nullptr, 1.0, 0.5, &particle);
         }},
        {"pw85_neighbors_holds", [=] { status = pw85_neighbors_holds(neighbors, 2 * n, x, forms, &answer); }},
        {"pw85_neighbors_size", [=] { answer = static_cast<int>(pw85_neighbors_size(neighbors)); }},
        {"pw85_neighbors_pairs", [=] { answer = pw85_neighbors_pairs(neighbors) != nullptr; }},
        {"pw85_neighbors_images", [=] { answer = pw85_neighbors_images(neighbors) != nullptr; }},
        {"pw85_neighbors_destroy", [=] { pw85_neighbors_destroy(neighbors); }},
        {"pw85_cell_reduce", [=] { status = pw85_cell_reduce(cell, out); }},
        {"pw85_nearest_images", [=] { status = pw85_nearest_images(n, list, 2 * n, x, cell, v(0), nullptr); }},
        {"pw85_nearest_image_limit", [=] { status = pw85_nearest_image_limit(n, p, cell, out); }},
    };
}

/// The functions of C++ that have memory of their own.
std::vector<Case> cases_of_headers()
{
    static std::vector<pw85::Vector<float, 3>> r;
    static std::vector<pw85::SymmetricMatrix<float, 3>> p, q;
    for (auto const &pair : inputs().pairs) {
        r.push_back(convert<float>(pair.r12));
        p.push_back(convert<float>(pair.q1));
        q.push_back(convert<float>(pair.q2));
    }
    static std::vector<float> mu2(r.size()), lambda(r.size());
    using Vectors = std::span<pw85::Vector<float, 3> const>;
    return {
        {"pw85::contact_batch of float",
         [] { status = static_cast<int>(pw85::contact_batch(Vectors(r), p, q, mu2, lambda)); }},
        {"pw85::overlap in two dimensions", for_each_pair([](double const *x, double const *y, double const *z) {
             answer =
                 pw85::overlap(pw85::Vector<double, 2>{x[0], x[1]}, pw85::SymmetricMatrix<double, 2>{y[3], y[4], y[5]},
                               pw85::SymmetricMatrix<double, 2>{z[3], z[4], z[5]})
                     .overlap;
         })},
    };
}

// The first calls, which bind symbols and find out about the processor, have to fit in; those after are measured. A function
// that does nothing tells what the thread itself takes.
void test_cases(std::vector<Case> const &cases)
{
    if (is_instrumented) return g_test_skip("built for other ends than use");
    std::size_t const empty = touched_by([] {});
    for (auto const &[function, call] : cases) {
        g_test_message("%s", function); // the last words if the stack does not suffice
        std::size_t const first = touched_by(call) - empty, used = touched_by(call) - empty;
        g_test_message("    %zu bytes, %zu the first time", used, first);
        if (used > bound) g_test_fail_printf("%s uses %zu bytes of stack", function, used);
    }
}

void test_pairs() { test_cases(cases_of_pairs()); }
void test_distances() { test_cases(cases_of_distances()); }
void test_forms() { test_cases(cases_of_forms()); }
void test_batches() { test_cases(cases_of_batches()); }
void test_headers() { test_cases(cases_of_headers()); }

void test_all_are_here()
{
    std::set<std::string> tested;
    for (auto const &cases : {cases_of_pairs(), cases_of_distances(), cases_of_forms(), cases_of_batches()})
        for (auto const &c : cases) tested.insert(c.function);
    std::size_t declared = 0;
    for (char const *header : {"pw85.h", "pw85_legacy.h", "pw85_zheng.h"})
        for (auto const &name : declared_in(header)) {
            ++declared;
            if (tested.count(name) == 0) g_test_fail_printf("%s is not tested", name.c_str());
        }
    g_assert_cmpuint(declared, >, 30);
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    g_test_add_func("/stack/pairs", test_pairs);
    g_test_add_func("/stack/distances", test_distances);
    g_test_add_func("/stack/forms", test_forms);
    g_test_add_func("/stack/batches", test_batches);
    g_test_add_func("/stack/headers", test_headers);
    g_test_add_func("/stack/all_are_here", test_all_are_here);
    return g_test_run();
}

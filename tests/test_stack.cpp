// SPDX-License-Identifier: BSD-3-Clause
// Measures how much stack every public function needs. Each function is called in a thread with a
// small stack that is filled with a pattern.
#include <algorithm>
#include <climits>
#include <cstring>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glib.h>
#include <pthread.h>
#include <sys/mman.h>
#include <unistd.h>

#include <pw85/batch.hpp>
#include <pw85/systems.hpp>

#include "calls.hpp"
#include "cases.hpp"
#include "random_pairs.hpp"
#include "reference_data.hpp"

using namespace pw85_tests;

namespace {

/// What pw85.h promises.
constexpr std::size_t bound = 16 * 1024, bound_of_meshes = 24 * 1024;

/// Without optimisation, and with what sanitizers put around variables, frames are larger.
#if defined(__has_feature)
#define PW85_HAS_FEATURE(x) __has_feature(x)
#else
#define PW85_HAS_FEATURE(x) 0
#endif
#if !defined(__OPTIMIZE__) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) ||     \
    PW85_HAS_FEATURE(address_sanitizer) || PW85_HAS_FEATURE(thread_sanitizer)
constexpr bool is_instrumented = true;
#else
constexpr bool is_instrumented = false;
#endif

/// The smallest stack that a thread may have, and as much again as the library and its caller may
/// want.
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

/// Bytes of the stack that a thread touches that calls a function. Below the stack is a page that
/// may not be touched.
std::size_t touched_by(std::function<void()> function)
{
    constexpr unsigned char paint = 0xa5;
    auto const page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE)),
               size = (stack_size() + page - 1) / page * page;
    void *const memory =
        mmap(nullptr, size + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
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

/// Pairs that every tier and every scalar kernel sees: ordinary ones, slender, of extreme sizes, as
/// near to contact as can be, concentric, and bad.
std::vector<Sample<double, 3>> make_pairs()
{
    std::vector<Sample<double, 3>> pairs;
    Random random(140);
    for (int k = 0; k < 600; ++k)
        pairs.push_back(
            random_pair<3>(random, {.aspect = k % 2 == 0 ? 10.0 : 1e6, .size_ratio = 100.0}));
    for (auto const &p : contact_problems())
        if (pw85::detail::absolute(p.mu2_minus_1) < 1e-12) pairs.push_back(p.pair);
    double const tiny = 0x1p-1074, radius2 = 0x1p1022;
    pairs.push_back({{0x1p512, tiny, 0},
                     {radius2, tiny, 0, radius2, 0, radius2},
                     {radius2, 0, tiny, radius2, 0, radius2}});
    pairs.push_back({{0, 0, 0}, {1, 0, 0, 1, 0, 1}, {1, 0, 0, 1, 0, 1}});
    pairs.push_back({{1, 0, 0}, {-1, 0, 0, 1, 0, 1}, {1, 0, 0, 1, 0, 1}});
    return pairs;
}

std::vector<Sample<double, 3>> const &all_pairs()
{
    static auto const pairs = make_pairs();
    return pairs;
}

/// A function to be measured by its name. `first` calls it before, for what happens once.
struct Case {
    std::string function;
    std::function<void()> call, first = call;
};

/// For functions that take a thousand times as long as others.
constexpr std::size_t long_step = 16;

bool takes_long(std::string const &name)
{
    return name.rfind("pw85_penetration", 0) == 0 || name.rfind("pw85_signed_distance", 0) == 0 ||
           name.rfind("pw85_first_contact", 0) == 0 || name.rfind("pw85_mesh", 0) == 0;
}

/// One call with all pairs as rows; the threads that a batch starts have stacks of their own.
Case case_of_rows(Function const &function)
{
    static std::map<bool, std::vector<Sample<double, 3>>> rows;
    for (bool const slow : {false, true})
        for (std::size_t i = 0; rows[slow].size() < 3 * all_pairs().size() / (slow ? long_step : 1);
             ++i)
            rows[slow].push_back(all_pairs()[i % all_pairs().size()]);
    static std::vector<Sample<double, 3>> const one = {all_pairs().front()};
    auto const call = std::make_shared<Call>(function, rows[takes_long(function.name)]),
               first = std::make_shared<Call>(function, one);
    return {function.name, [call] { (*call)(); }, [first] { (*first)(); }};
}

/// A call for each pair.
Case case_of_pairs(Function const &function)
{
    static std::deque<std::vector<Sample<double, 3>>> one; // of each pair
    if (one.empty())
        for (auto const &pair : all_pairs()) one.push_back({pair});
    auto calls = std::make_shared<std::vector<std::unique_ptr<Call>>>();
    for (std::size_t i = 0; i < one.size(); i += takes_long(function.name) ? long_step : 1)
        calls->push_back(std::make_unique<Call>(function, one[i], 0.3));
    return {function.name,
            [calls] {
                for (auto const &call : *calls) (*call)();
            },
            [calls] { (*calls->front())(); }};
}

bool has_rows(Function const &function)
{
    auto const &all = function.parameters;
    return std::any_of(all.begin(), all.end(), [](Parameter const &p) {
        return p.type == Type::size || p.type == Type::handle;
    });
}

std::vector<Case> cases_of_functions()
{
    std::vector<Case> cases;
    for (auto const &function : declared_functions())
        cases.push_back(has_rows(function) ? case_of_rows(function) : case_of_pairs(function));
    return cases;
}

/// The functions of C++ that have memory of their own.
std::vector<Case> cases_of_headers()
{
    // what the functions return is the concern of other tests
    [[maybe_unused]] static int status, answer;
    static std::vector<pw85::Vector<float, 3>> r;
    static std::vector<pw85::SymmetricMatrix<float, 3>> p, q;
    for (auto const &pair : all_pairs()) {
        r.push_back(convert<float>(pair.r12));
        p.push_back(convert<float>(pair.q1));
        q.push_back(convert<float>(pair.q2));
    }
    static std::vector<float> mu2(r.size()), lambda(r.size());
    using Vectors = std::span<pw85::Vector<float, 3> const>;
    return {
        {"pw85::contact_batch of float",
         [] { status = static_cast<int>(pw85::contact_batch(Vectors(r), p, q, mu2, lambda)); }},
        {"pw85::overlap in two dimensions",
         [] {
             for (auto const &[r12, q1, q2] : all_pairs())
                 answer = pw85::overlap(pw85::Vector<double, 2>{r12[0], r12[1]},
                                        pw85::SymmetricMatrix<double, 2>{q1[3], q1[4], q1[5]},
                                        pw85::SymmetricMatrix<double, 2>{q2[3], q2[4], q2[5]})
                              .overlap;
         }},
    };
}

// The first calls, which bind symbols and find out about the processor, have to fit in; those after
// are measured. A function that does nothing tells what the thread itself takes.
void test_cases(std::vector<Case> const &cases)
{
    if (is_instrumented) return g_test_skip("built for other ends than use");
    std::size_t const empty = touched_by([] {});
    for (auto const &[function, call, begin] : cases) {
        g_test_message("%s", function.c_str()); // the last words if the stack does not suffice
        std::size_t const first = touched_by(begin) - empty, used = touched_by(call) - empty;
        g_test_message("    %zu bytes, %zu the first time", used, first);
        std::size_t const limit = function.rfind("pw85_mesh", 0) == 0 ? bound_of_meshes : bound;
        if (used > limit) g_test_fail_printf("%s uses %zu bytes of stack", function.c_str(), used);
    }
}

void test_functions() { test_cases(cases_of_functions()); }
void test_headers() { test_cases(cases_of_headers()); }

PW85_ADD_TEST("/stack/functions", test_functions);
PW85_ADD_TEST("/stack/headers", test_headers);

} // namespace

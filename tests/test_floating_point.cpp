// SPDX-License-Identifier: BSD-3-Clause
// The floating-point environment of the caller. For valid input no function raises FE_INVALID,
// FE_DIVBYZERO or FE_OVERFLOW, or traps if these are enabled. The caller's modes do not change
// results, and the functions do not change the modes.
#include <cfenv>
#include <csetjmp>
#include <csignal>
#include <cstring>
#include <vector>

#include <glib.h>

#ifdef __SSE2_MATH__
#include <xmmintrin.h>
#endif

#include "calls.hpp"
#include "draws.hpp"
#include "extreme_pairs.hpp"
#include "failures.hpp"

using namespace pw85_tests;

namespace {

constexpr int exceptions = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;

/// A pair with what is asked of it.
struct Question {
    std::vector<Sample<double, 3>> pair; // one
    double lambda;
};

/// The worst environment that a caller can have: exceptions trap, rounding is upwards, subnormal
/// numbers are zero.
class HostileEnvironment {
  public:
    HostileEnvironment()
    {
        std::fegetenv(&before_);
        std::feclearexcept(FE_ALL_EXCEPT);
        std::fesetround(FE_UPWARD);
#ifdef __SSE2_MATH__
        _mm_setcsr(_mm_getcsr() | 0x8040);
#endif
#ifdef __GLIBC__
        feenableexcept(exceptions);
#endif
    }
    ~HostileEnvironment() { std::fesetenv(&before_); }
    HostileEnvironment(HostileEnvironment const &) = delete;
    HostileEnvironment &operator=(HostileEnvironment const &) = delete;

  private:
    std::fenv_t before_;
};

sigjmp_buf trapped;
void on_trap(int) { siglongjmp(trapped, 1); }

/// An ordinary pair in any units, of any distance, or of any shape.
Question valid_question(Random &random)
{
    for (int kind = static_cast<int>(random.uniform(0.0, 5.0));;) {
        Question q{{Sample<double, 3>{}}, 0.0};
        auto &pair = q.pair.front();
        if (kind < 3) {
            pair = extreme_pair(random, kind);
        } else {
            double const unit = random.log_uniform(1e-140, 1e140);
            pair = random_pair<3>(random, {.aspect = 100.0, .size_ratio = kind == 3 ? 2.0 : 1e5});
            pair.r12 = (kind == 3 ? unit : random.log_uniform(1e-150, 1e150)) * pair.r12;
            pair.q1 = unit * (unit * pair.q1);
            pair.q2 = unit * (unit * pair.q2);
        }
        double out[2];
        if (pw85_contact(pair.r12.coordinates, pair.q1.entries, pair.q2.entries, out) !=
            PW85_SUCCESS)
            continue;
        q.lambda = out[1];
        return q;
    }
}

/// What an environment does to a call.
struct Trace {
    bool trap;
    int raised;
    int rounding; ///< afterwards
};

template <class Call> Trace in_hostile_environment(Call const &call)
{
    HostileEnvironment const environment;
    if (sigsetjmp(trapped, 1) != 0) return {true, 0, 0};
    call();
    return {false, std::fetestexcept(exceptions), std::fegetround()};
}

template <class Describe>
void check_trace(Failures &failures, Trace const &trace, Describe describe)
{
    failures.check(!trace.trap, "a trap", trace.trap, 0.0, describe);
    failures.check(trace.raised == 0, "exceptions", trace.raised, 0.0, describe);
    failures.check(trace.trap || trace.rounding == FE_UPWARD, "rounding", trace.rounding, FE_UPWARD,
                   describe);
}

// Neither sees the other's environment: nothing traps, no flag is raised, no mode is changed, no
// bit of the results is another.
void test_single(void const *data)
{
    auto const &function = *static_cast<Function const *>(data);
    Failures failures;
    Random random(120);
    for (int n = 0; n < draws(10000); ++n) {
        Question const q = valid_question(random);
        Call usual(function, q.pair, q.lambda), hostile(function, q.pair, q.lambda);
        auto const describe = [&] { return usual.text(); };
        Answer const expected = usual();
        Answer actual{};
        Trace const trace = in_hostile_environment([&] { actual = hostile(); });
        check_trace(failures, trace, describe);
        bool const same = expected.status == actual.status &&
                          std::memcmp(&expected.real, &actual.real, sizeof actual.real) == 0 &&
                          usual.outputs() == hostile.outputs();
        failures.check(same, "results", actual.status, expected.status, describe);
    }
}

#ifdef __SSE2_MATH__
/// An ordinary pair, some of whose entries are tiny, so that products underflow and operands may be
/// subnormal.
Sample<double, 3> pair_with_tiny_entries(Random &random)
{
    auto pair = random_pair<3>(random, {.aspect = 3.0});
    double *const entries[] = {&pair.q1[1], &pair.q1[2], &pair.q1[4],  &pair.q2[1],
                               &pair.q2[2], &pair.q2[4], &pair.r12[0], &pair.r12[1]};
    for (double *const entry : entries)
        if (random.sign() > 0.0) *entry *= random.log_uniform(1e-310, 1e-10);
    return pair;
}

// A caller with the default modes who has rounded a number sees no other flag, not even that of
// underflow or of a subnormal operand.
void test_flags(void const *data)
{
    auto const &function = *static_cast<Function const *>(data);
    constexpr unsigned usual = 0x1fa0;
    Failures failures;
    Random random(122);
    for (int n = 0; n < draws(10000); ++n) {
        Call call(function, {pair_with_tiny_entries(random)}, 0.5);
        _mm_setcsr(usual);
        call();
        unsigned const after = _mm_getcsr();
        failures.check(after == usual, "register", after, usual, [&] { return call.text(); });
    }
}
#endif

// Threads start with the environment of the one that starts them.
void test_threads()
{
    constexpr std::size_t n = 20000;
    Failures failures;
    Random random(121);
    std::vector<double> r12, q1, q2, mu2(n), expected(n);
    for (std::size_t i = 0; i < n; ++i) {
        Question const q = valid_question(random);
        auto const &pair = q.pair.front();
        r12.insert(r12.end(), pair.r12.coordinates, pair.r12.coordinates + 3);
        q1.insert(q1.end(), pair.q1.entries, pair.q1.entries + 6);
        q2.insert(q2.end(), pair.q2.entries, pair.q2.entries + 6);
    }
    Trace const trace = in_hostile_environment(
        [&] { pw85_contact_batch(n, r12.data(), q1.data(), q2.data(), mu2.data(), nullptr); });
    check_trace(failures, trace, [] { return std::string("a batch"); });
    pw85_contact_batch(n, r12.data(), q1.data(), q2.data(), expected.data(), nullptr);
    for (std::size_t i = 0; i < n; ++i)
        failures.check(mu2[i] == expected[i], "mu^2", mu2[i], expected[i], [&] {
            return "r12 = " + hex_text(&r12[3 * i], 3) + ", q1 = " + hex_text(&q1[6 * i], 6) +
                   ", q2 = " + hex_text(&q2[6 * i], 6);
        });
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    std::signal(SIGFPE, on_trap);
    for (auto const &function : declared_functions()) {
        g_test_add_data_func((std::string("/floating_point/") + function.name).c_str(), &function,
                             test_single);
#ifdef __SSE2_MATH__
        g_test_add_data_func((std::string("/floating_point/flags/") + function.name).c_str(),
                             &function, test_flags);
#endif
    }
    g_test_add_func("/floating_point/threads", test_threads);
    return g_test_run();
}

// The floating-point environment of the caller: no function raises FE_INVALID, FE_DIVBYZERO or FE_OVERFLOW on valid input, or
// traps where they do; none heeds the caller's modes, or changes them.
#include <array>
#include <cfenv>
#include <csetjmp>
#include <csignal>
#include <cstring>
#include <vector>

#include <glib.h>

#ifdef __SSE2_MATH__
#include <xmmintrin.h>
#endif

#include <pw85_legacy.h>
#include <pw85_zheng.h>

#include "draws.hpp"
#include "extreme_pairs.hpp"
#include "failures.hpp"

using namespace pw85_tests;

namespace {

constexpr int exceptions = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
using Results = std::array<double, 96>;

/// A pair with what is asked of it.
struct Question {
    Sample<double, 3> pair;
    double lambda;
};

struct Function {
    char const *name;
    void (*call)(Question const &question, double *out);
};

#define PW85_PAIR q.pair.r12.coordinates, q.pair.q1.entries, q.pair.q2.entries
#define PW85_CALL(name, ...)                                                                                           \
    {                                                                                                                  \
#name, [](Question const &q, double *out) { name(__VA_ARGS__); }                                               \
    }
#define PW85_VALUE(name, ...)                                                                                          \
    {                                                                                                                  \
#name, [](Question const &q, double *out) { *out = name(__VA_ARGS__); }                                        \
    }

void call_f_neg(Question const &q, double *out)
{
    double params[15];
    std::memcpy(params, q.pair.r12.coordinates, 3 * sizeof(double));
    std::memcpy(params + 3, q.pair.q1.entries, 6 * sizeof(double));
    std::memcpy(params + 9, q.pair.q2.entries, 6 * sizeof(double));
    *out = pw85_f_neg(q.lambda, params);
}

void call_distance_box(Question const &q, double *out)
{
    double lower[3], upper[3];
    for (int i = 0; i < 3; ++i) {
        upper[i] = pw85::absolute(q.pair.r12[i]);
        lower[i] = -upper[i];
    }
    pw85_distance_box(lower, upper, q.pair.q1.entries, out, out + 1, out + 4);
}

pw85_motion const motions[3] = {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.5},
                                {{0.0, -1.0, 0.0}, {2.0, 1.0, 0.0}, -0.5},
                                {{-1.0, 1.0, 0.5}, {0.0, 0.0, 0.0}, 0.0}};

void call_first_contact(Question const &q, double *out)
{
    pw85_first_contact(PW85_PAIR, &motions[0], &motions[1], 1.0, out);
    pw85_first_contact(PW85_PAIR, &motions[2], &motions[2], 1.0, out + 1);
    pw85_first_contact(PW85_PAIR, &motions[2], &motions[0], 1.0, out + 2);
}

Function const functions[] = {
    PW85_CALL(pw85_contact, PW85_PAIR, out),
    PW85_CALL(pw85_contact_function, PW85_PAIR, out),
    PW85_CALL(pw85_contact_2d, PW85_PAIR, out),
    PW85_CALL(pw85_contact_geometry, PW85_PAIR, q.lambda, out, out + 3),
    PW85_CALL(pw85_contact_gradient, PW85_PAIR, q.lambda, out, out + 3, out + 9),
    PW85_CALL(pw85_contact_torque, PW85_PAIR, q.lambda, out, out + 3),
    PW85_CALL(pw85_contact_hessian, PW85_PAIR, q.lambda, out),
    PW85_CALL(pw85_contact_geometry_2d, PW85_PAIR, q.lambda, out, out + 2),
    PW85_CALL(pw85_contact_gradient_2d, PW85_PAIR, q.lambda, out, out + 2, out + 4),
    PW85_CALL(pw85_contact_torque_2d, PW85_PAIR, q.lambda, out, out + 1),
    PW85_CALL(pw85_contact_hessian_2d, PW85_PAIR, q.lambda, out),
    PW85_CALL(pw85_overlap_2d, PW85_PAIR, reinterpret_cast<int *>(out)),
    PW85_CALL(pw85_overlap, PW85_PAIR, reinterpret_cast<int *>(out)),
    PW85_CALL(pw85_closest_approach, PW85_PAIR, out),
    PW85_CALL(pw85_closest_approach_2d, PW85_PAIR, out),
    PW85_CALL(pw85_distance, PW85_PAIR, out, out + 1, out + 4),
    PW85_CALL(pw85_distance_derivatives, PW85_PAIR, out, out + 3, out + 6, out + 9),
    PW85_CALL(pw85_distance_2d, PW85_PAIR, out, out + 1, out + 3),
    PW85_CALL(pw85_penetration, PW85_PAIR, out, out + 1),
    {"pw85_first_contact", call_first_contact},
    PW85_CALL(pw85_distance_plane, q.pair.r12.coordinates, q.lambda, q.pair.q1.entries, out, out + 1),
    PW85_CALL(pw85_distance_plane_derivatives, q.pair.r12.coordinates, q.pair.q1.entries, out, out + 3),
    PW85_CALL(pw85_contact_plane, q.pair.r12.coordinates, q.lambda, q.pair.q1.entries, out, out + 1),
    PW85_CALL(pw85_contact_plane_derivatives, q.pair.r12.coordinates, q.lambda, q.pair.q1.entries, out, out + 3),
    {"pw85_distance_box", call_distance_box},
    PW85_CALL(pw85_distance_cylinder, q.pair.q2.entries, 1.0, q.pair.r12.coordinates, q.pair.q1.entries, out, out + 1,
              out + 4),
    PW85_CALL(pw85_distance_point, q.pair.r12.coordinates, q.pair.q1.entries, out, out + 1, out + 4),
    PW85_CALL(pw85_intersect_line, q.pair.r12.coordinates, q.pair.q2.entries, q.pair.q1.entries, out),
    PW85_CALL(pw85__cholesky_decomp, q.pair.q1.entries, out),
    PW85_CALL(pw85__cholesky_solve, q.pair.q1.entries, q.pair.r12.coordinates, out),
    PW85_CALL(pw85__residual, q.lambda, PW85_PAIR, out),
    PW85_CALL(pw85_spheroid, 1.0, 3.0, q.pair.r12.coordinates, out),
    PW85_CALL(pw85_ellipsoid_quaternion, q.pair.q1.entries, q.pair.q2.entries, out),
    PW85_CALL(pw85_ellipse, 1.0, 3.0, q.lambda, out),
    PW85_CALL(pw85_contact_batch, 1, PW85_PAIR, out, out + 1),
    PW85_CALL(pw85_overlap_batch, 1, PW85_PAIR, reinterpret_cast<unsigned char *>(out)),
    PW85_CALL(pw85_contact_batch_2d, 1, PW85_PAIR, out, out + 1),
    PW85_CALL(pw85_overlap_batch_2d, 1, PW85_PAIR, reinterpret_cast<unsigned char *>(out)),
    PW85_CALL(pw85_legacy_f1, q.lambda, PW85_PAIR, out),
    PW85_CALL(pw85_legacy_f2, q.lambda, PW85_PAIR, out),
    PW85_CALL(pw85_legacy_contact_function1, PW85_PAIR, out),
    PW85_CALL(pw85_legacy_contact_function2, PW85_PAIR, out),
    PW85_VALUE(pw85_legacy__det_sym, q.pair.q1.entries),
    PW85_VALUE(pw85_legacy__xT_adjA_x, q.pair.r12.coordinates, q.pair.q1.entries),
    {"pw85_f_neg", call_f_neg},
    PW85_CALL(pw85_zheng_ellipsoids, PW85_PAIR, out),
    PW85_CALL(pw85_zheng_ellipses, PW85_PAIR, out),
};

/// The worst environment that a caller can have: exceptions trap, rounding is upwards, subnormal numbers are zero.
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
        Question q{};
        if (kind < 3) {
            q.pair = extreme_pair(random, kind);
        } else {
            double const unit = random.log_uniform(1e-140, 1e140);
            q.pair = random_pair<3>(random, {.aspect = 100.0, .size_ratio = kind == 3 ? 2.0 : 1e5});
            q.pair.r12 = pw85::times(kind == 3 ? unit : random.log_uniform(1e-150, 1e150), q.pair.r12);
            q.pair.q1 = pw85::times(unit, pw85::times(unit, q.pair.q1));
            q.pair.q2 = pw85::times(unit, pw85::times(unit, q.pair.q2));
        }
        double out[2];
        if (pw85_contact(PW85_PAIR, out) != PW85_SUCCESS) continue;
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

template <class Describe> void check_trace(Failures &failures, Trace const &trace, Describe describe)
{
    failures.check(!trace.trap, "a trap", trace.trap, 0.0, describe);
    failures.check(trace.raised == 0, "exceptions", trace.raised, 0.0, describe);
    failures.check(trace.trap || trace.rounding == FE_UPWARD, "rounding", trace.rounding, FE_UPWARD, describe);
}

// Neither sees the other's environment: nothing traps, no flag is raised, no mode is changed, no bit of the results is another.
void test_single(void const *data)
{
    auto const &function = *static_cast<Function const *>(data);
    Failures failures;
    Random random(120);
    for (int n = 0; n < draws(10000); ++n) {
        Question const q = valid_question(random);
        auto const describe = [&] { return hex_text(q.pair) + ", lambda = " + hex_text(&q.lambda, 1); };
        Results expected{}, actual{};
        function.call(q, expected.data());
        Trace const trace = in_hostile_environment([&] { function.call(q, actual.data()); });
        check_trace(failures, trace, describe);
        bool const same = std::memcmp(expected.data(), actual.data(), sizeof actual) == 0;
        failures.check(same, "first result", actual[0], expected[0], describe);
    }
}

// Threads start with the environment of the one that starts them.
void test_threads()
{
    constexpr std::size_t n = 20000;
    Failures failures;
    Random random(121);
    std::vector<double> r12, q1, q2, mu2(n), expected(n);
    for (std::size_t i = 0; i < n; ++i) {
        Question const q = valid_question(random);
        r12.insert(r12.end(), q.pair.r12.coordinates, q.pair.r12.coordinates + 3);
        q1.insert(q1.end(), q.pair.q1.entries, q.pair.q1.entries + 6);
        q2.insert(q2.end(), q.pair.q2.entries, q.pair.q2.entries + 6);
    }
    Trace const trace =
        in_hostile_environment([&] { pw85_contact_batch(n, r12.data(), q1.data(), q2.data(), mu2.data(), nullptr); });
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
    for (auto const &function : functions)
        g_test_add_data_func((std::string("/floating_point/") + function.name).c_str(), &function, test_single);
    g_test_add_func("/floating_point/threads", test_threads);
    return g_test_run();
}

// SPDX-License-Identifier: BSD-3-Clause
// The parts of pw85_contact_function(): units, iterations, shapes for which neither method
// converges, and the absence of side effects.
#include <algorithm>
#include <cerrno>
#include <cmath>

#include <brent.hpp>
#include <glib.h>
#ifdef PW85_HAVE_GSL
#include <gsl/gsl_errno.h>
#endif

#include <pw85.h>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "reference_data.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

constexpr pw85::detail::brent::Options options{PW85_LAMBDA_ATOL, PW85_MAX_ITER, PW85_NR_ITER};

/// Ellipsoids of one aspect ratio, of sizes within a factor of 2.
Sample<double, 3> pair_of_aspect(Random &random, double aspect)
{
    return {random.direction<3>(), random.form(1.0, aspect),
            random.form(random.log_uniform(0.5, 2.0), aspect)};
}

/// The pair in range; false where its forms as rounded are not positive definite.
bool in_range(Sample<double, 3> const &p, pw85::detail::Pair<double, 3> &pair)
{
    pw85::detail::ScaledPair<double, 3> scaled{};
    bool const valid = pw85::detail::validate_pair(pw85::detail::pair_of(p.r12, p.q1, p.q2),
                                                   scaled) == pw85::Status::success;
    pair = scaled.pair;
    return valid;
}

// The table of rounds in brent.cpp: what is stated is needed, and is enough.
PW85_TEST("/brent/rounds")
{
    struct Row {
        double aspect;
        int rounds;
    };
    for (auto const &[aspect, rounds] : {Row{10.0, 1}, Row{1e6, 2}, Row{1e9, 3}, Row{1e36, 3}}) {
        Random random(120);
        int most = 0;
        for (int n = 0; n < draws(20000); ++n) {
            pw85::detail::Pair<double, 3> pair;
            if (!in_range(pair_of_aspect(random, aspect), pair)) continue;
            auto const rough = pw85::detail::brent::maximizer_by_brent(pair, options);
            most = std::max(most, rough.rounds);
        }
        g_test_message("aspect %g: %d rounds", aspect, most);
        g_assert_cmpint(most, ==, rounds);
    }
}

bool settles(pw85::detail::Pair<double, 3> const &pair, pw85::detail::brent::Options const &with)
{
    pw85::detail::Candidate<double> candidate{
        pw85::detail::brent::maximizer_by_brent(pair, options).t, 1.0, 0.0};
    return pw85::detail::brent::refine(pair, candidate, with);
}

// Number of contact problems that so many Newton-Raphson iterations do not settle.
int unsettled(int halley_steps)
{
    auto with = options;
    with.halley_steps = halley_steps;
    int count = 0;
    for (auto const &p : contact_problems()) {
        pw85::detail::Pair<double, 3> pair;
        g_assert_true(in_range(p.pair, pair));
        count += !settles(pair, with);
    }
    g_test_message("%d iterations leave %d unsettled", halley_steps, count);
    return count;
}

// A step that is small settles a pair, and is taken: one is enough for most contact problems, and
// PW85_NR_ITER for all.
PW85_TEST("/brent/iterations")
{
    g_assert_cmpint(unsettled(PW85_NR_ITER), ==, 0);
    g_assert_cmpint(unsettled(1), >, 0);
}

// Shapes so slender that rounding hides a part of them: neither method settles, and the answer is
// right all the same.
PW85_TEST("/brent/slender")
{
    Failures failures;
    double worst = 0.0;
    int searched = 0;
    for (double const aspect : {1e6, 1e8, 1e9, 1e12, 1e20, 1e36}) {
        Random random(121);
        for (int n = 0; n < draws(4000); ++n) {
            auto const p = pair_of_aspect(random, aspect);
            pw85::detail::Pair<double, 3> pair;
            if (!in_range(p, pair)) continue;
            auto const wide = convert<Wide>(p);
            if (pw85::contact(wide.r12, wide.q1, wide.q2).status != pw85::Status::success) continue;
            searched += !settles(pair, options);
            double out[2];
            auto const describe = [&] { return hex_text(p); };
            int const status =
                pw85_contact_function(p.r12.coordinates, p.q1.entries, p.q2.entries, out);
            if (!failures.check(status == PW85_SUCCESS, "status", status, 0.0, describe)) continue;
            double const units = error_in_units(out[0], truth<Wide>(p));
            failures.check(units <= 4.0, "error of mu^2 in u cond", units, 4.0, describe);
            worst = std::fmax(worst, units);
        }
    }
    g_test_message("largest error %.2f u cond; %d of %ld pairs were left to the search", worst,
                   searched, failures.checked() / 2);
    g_assert_cmpint(searched, >,
                    // of an eighth of them, half of the share: so few scatter
                    eighths() == 8 ? 100 : 6);
}

// A thin disc on the axis of a huge sphere, 2^1047 times as thick: τ is beyond the range of double,
// λ is 0 or 1.
PW85_TEST("/brent/points")
{
    double const disc[6] = {0x1p-820, 0.0, 0.0, 0x1p-1072, 0.0, 0x1p-820},
                 r12[3] = {0.0, 0x3p511, 0.0};
    double const sphere[6] = {0x1p1022, 0.0, 0.0, 0x1p1022, 0.0, 0x1p1022};
    for (auto const solver : {pw85_contact, pw85_contact_function}) {
        double out[2];
        g_assert_cmpint(solver(r12, sphere, disc, out), ==, PW85_SUCCESS);
        g_assert_cmpfloat(std::fabs(out[0] - 9.0), <=, 0x1p-48);
        g_assert_cmpfloat(out[1], ==, 1.0);
        g_assert_cmpint(solver(r12, disc, sphere, out), ==, PW85_SUCCESS);
        g_assert_cmpfloat(std::fabs(out[0] - 9.0), <=, 0x1p-48);
        g_assert_true(out[1] >= 0.0 && out[1] <= 0x1p-1000);
    }
}

int handled = 0;

#ifdef PW85_HAVE_GSL
void count_error(char const *, char const *, int, int) { ++handled; }

/// Counts the errors that GSL handles in its life.
class CountErrors {
  public:
    CountErrors() : before_(gsl_set_error_handler(count_error)) {}
    ~CountErrors() { g_assert_true(gsl_set_error_handler(before_) == count_error); }

  private:
    gsl_error_handler_t *before_;
};
#else
struct CountErrors {};
#endif

PW85_TEST("/brent/no_side_effects")
{
    [[maybe_unused]] CountErrors const counting;
    Failures failures;
    errno = 0;
    auto const check = [&](Sample<double, 3> const &p) {
        double out[2];
        pw85_contact_function(p.r12.coordinates, p.q1.entries, p.q2.entries, out);
        failures.check(handled == 0 && errno == 0, "errors and errno", handled, errno,
                       [&] { return hex_text(p); });
    };
    for (auto const &p : contact_problems()) check(p.pair);
    Random random(122);
    for (double const aspect : {1.0, 1e9, 1e36})
        for (int n = 0; n < draws(1000); ++n) check(pair_of_aspect(random, aspect));
}

} // namespace

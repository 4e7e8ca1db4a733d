// SPDX-License-Identifier: BSD-3-Clause
// A scalar that fulfils the requirements of algebra/scalar.hpp and no more: numbers without
// implicit conversions, products that are not rounded until they are used, and for lanes a mask
// that is not bool and whose operators evaluate both sides. The templates compile with it, and give
// the same bits as with double.
#include <cmath>
#include <cstring>
#include <type_traits>

#include <glib.h>

#include <pw85/pw85.hpp>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"

namespace {

/// A truth value per lane; there is one lane.
struct LaneMask {
    bool lane;

    friend LaneMask operator&&(LaneMask x, LaneMask y) { return {x.lane && y.lane}; }
    [[maybe_unused]] friend LaneMask operator||(LaneMask x, LaneMask y)
    {
        return {x.lane || y.lane};
    }
    friend LaneMask operator!(LaneMask x) { return {!x.lane}; }
    friend bool any_of(LaneMask x) { return x.lane; }
    friend bool all_of(LaneMask x) { return x.lane; }
};

template <class Mask> Mask to_mask(bool x)
{
    if constexpr (std::is_same_v<Mask, bool>)
        return x;
    else
        return {x};
}

/// A number whose comparisons give a `Mask`.
template <class Mask> class Archetype {
  public:
    struct Product {
        double x, y;

        Product operator-() const { return {-x, y}; }
    };

    Archetype() = default;
    constexpr explicit Archetype(double x) : x_(x) {}
    constexpr Archetype(Product const &p) : x_(p.x * p.y) {}

    /// For tests only.
    friend double value(Archetype a) { return a.x_; }

    friend constexpr Product operator*(Archetype a, Archetype b) { return {a.x_, b.x_}; }
    friend constexpr Archetype operator/(Archetype a, Archetype b)
    {
        return Archetype(a.x_ / b.x_);
    }
    friend constexpr Archetype operator+(Archetype a, Archetype b)
    {
        return Archetype(a.x_ + b.x_);
    }
    friend constexpr Archetype operator-(Archetype a, Archetype b)
    {
        return Archetype(a.x_ - b.x_);
    }
    friend constexpr Archetype operator-(Archetype a) { return Archetype(-a.x_); }
    friend constexpr Mask operator<(Archetype a, Archetype b) { return to_mask<Mask>(a.x_ < b.x_); }
    friend constexpr Mask operator>(Archetype a, Archetype b) { return to_mask<Mask>(a.x_ > b.x_); }
    friend constexpr Mask operator<=(Archetype a, Archetype b)
    {
        return to_mask<Mask>(a.x_ <= b.x_);
    }
    friend constexpr Mask operator>=(Archetype a, Archetype b)
    {
        return to_mask<Mask>(a.x_ >= b.x_);
    }
    friend constexpr Mask operator==(Archetype a, Archetype b)
    {
        return to_mask<Mask>(a.x_ == b.x_);
    }
    friend Archetype select(LaneMask mask, Archetype yes, Archetype no)
    {
        return mask.lane ? yes : no;
    }
    friend Archetype abs(Archetype a) { return Archetype(std::fabs(a.x_)); }
    friend Archetype sqrt(Archetype a) { return Archetype(std::sqrt(a.x_)); }
    friend int ilogb(Archetype a) { return std::ilogb(a.x_); }
    friend Archetype ldexp(Archetype a, int n) { return Archetype(std::ldexp(a.x_, n)); }

  private:
    double x_;
};

using Number = Archetype<bool>;    // one pair
using Lanes = Archetype<LaneMask>; // a pack of one

} // namespace

template <class Mask_> struct pw85::ScalarTraits<Archetype<Mask_>> {
    using Lane = double;
    using Mask = Mask_;
    static constexpr int lanes = 1;
};

namespace {

using namespace pw85_tests;

template <class T, int D> pw85::Vector<T, D> to(pw85::Vector<double, D> const &x)
{
    pw85::Vector<T, D> y;
    for (int i = 0; i < D; ++i) y[i] = T(x[i]);
    return y;
}

template <class T, int D> pw85::SymmetricMatrix<T, D> to(pw85::SymmetricMatrix<double, D> const &a)
{
    pw85::SymmetricMatrix<T, D> b;
    for (int k = 0; k < a.size; ++k) b[k] = T(a[k]);
    return b;
}

/// Ordinary pairs and others: slender, of very different sizes, near contact.
template <int D> Sample<double, D> pair_of_any_kind(Random &random, int n)
{
    double const near = n % 3 == 0 ? 1e-13 : 0.5;
    return random_pair<D>(random, {.aspect = n % 2 == 0 ? 10.0 : 1e5,
                                   .size_ratio = n % 5 == 0 ? 1e20 : 2.0,
                                   .mu2_min = 1.0 - near,
                                   .mu2_max = 1.0 + near});
}

class Comparison {
  public:
    template <int D> Comparison(Failures &failures, Sample<double, D> const &pair)
        : failures_(failures), text_(hex_text(pair))
    {
    }

    template <class T> void check(char const *what, T const &x, double expected)
    {
        double const actual = value(x);
        bool const same = std::memcmp(&actual, &expected, sizeof actual) == 0 ||
                          (std::isnan(actual) && std::isnan(expected));
        failures_.check(same, what, actual, expected, [this] { return text_; });
    }
    template <class T, int D> void check(char const *what, pw85::Vector<T, D> const &x,
                                         pw85::Vector<double, D> const &expected)
    {
        for (int i = 0; i < D; ++i) check(what, x[i], expected[i]);
    }
    void check(char const *what, bool same)
    {
        failures_.check(same, what, same, true, [this] { return text_; });
    }

  private:
    Failures &failures_;
    std::string text_;
};

// The functions of one pair, whose masks are bool.
template <int D> void test_number()
{
    Failures failures;
    Random random(200 + D);
    int left_to_doubles = 0;
    for (int n = 0; n < draws(1000); ++n) {
        auto const s = pair_of_any_kind<D>(random, n);
        auto const r12 = to<Number>(s.r12);
        auto const q1 = to<Number>(s.q1), q2 = to<Number>(s.q2);
        Comparison comparison(failures, s);
        auto const contact = pw85::contact(r12, q1, q2);
        auto const expected = pw85::contact(s.r12, s.q1, s.q2);
        // Whether a nearly singular form is positive definite, and where its maximum is, doubles
        // decide with more digits.
        if (contact.status != pw85::Status::success && ++left_to_doubles) continue;
        comparison.check("status", contact.status == expected.status);
        comparison.check("mu2", contact.mu2, expected.mu2);
        comparison.check("lambda", contact.lambda, expected.lambda);
        auto const decision = pw85::decide_overlap(r12, q1, q2),
                   expected_decision = pw85::decide_overlap(s.r12, s.q1, s.q2);
        // Doubles take a coarse root from their bits, and so try other points: one of the two may
        // not be certain.
        auto const is_open = [](auto const &d) { return d.decision == pw85::Decision::none; };
        comparison.check("decision", is_open(decision) || is_open(expected_decision) ||
                                         decision.decision == expected_decision.decision);
        auto const geometry = pw85::contact_geometry(r12, q1, q2, contact.lambda);
        auto const expected_geometry = pw85::contact_geometry(s.r12, s.q1, s.q2, expected.lambda);
        comparison.check("point", geometry.point, expected_geometry.point);
        comparison.check("normal", geometry.normal, expected_geometry.normal);
        auto const gradient = pw85::contact_gradient(r12, q1, q2, contact.lambda);
        comparison.check("gradient", gradient.r12,
                         pw85::contact_gradient(s.r12, s.q1, s.q2, expected.lambda).r12);
        comparison.check("distance", pw85::closest_approach(r12, q1, q2).distance,
                         pw85::closest_approach(s.r12, s.q1, s.q2).distance);
    }
    g_assert_cmpint(left_to_doubles, <, draws(1000) / 20);
}

/// The search on the rational form, as its drivers loop.
template <class T, int D>
pw85::detail::LastEvaluation<T> search_by_steps(pw85::detail::Pair<T, D> const &pair)
{
    auto search = pw85::detail::start_search(pair);
    run(search, pair, pw85::detail::max_rational_steps);
    return pw85::detail::last_evaluation(pair, search.candidate);
}

// What lanes are made of: the search, the tests on the quartic, the formulas of the geometry.
template <int D> void test_lanes()
{
    Failures failures;
    Random random(210 + D);
    for (int n = 0; n < draws(1000); ++n) {
        auto const s = pair_of_any_kind<D>(random, n);
        pw85::detail::Pair<Lanes, D> const pair{to<Lanes>(s.r12), to<Lanes>(s.q1), to<Lanes>(s.q2),
                                                Lanes(1.0)};
        pw85::detail::Pair<double, D> const plain{s.r12, s.q1, s.q2, 1.0};
        Comparison comparison(failures, s);
        comparison.check("ordinary", pw85::detail::passes_fast_checks(pair).lane ==
                                         pw85::detail::passes_fast_checks(plain));
        auto const last = search_by_steps(pair);
        auto const expected = search_by_steps(plain);
        comparison.check("certain", last.certified.lane == expected.certified);
        comparison.check("mu2 by steps", last.value.mu2, expected.value.mu2);
        comparison.check("lambda by steps", last.value.lambda, expected.value.lambda);
        Lanes const t = pw85::detail::initial_guess(pair);
        double const plain_t = pw85::detail::initial_guess(plain);
        auto const certainty =
            pw85::detail::test_quartic(pw85::detail::evaluate_quartic(pair, t), t);
        auto const plain_certainty =
            pw85::detail::test_quartic(pw85::detail::evaluate_quartic(plain, plain_t), plain_t);
        comparison.check("apart", certainty.apart.lane == plain_certainty.apart);
        comparison.check("overlap", certainty.overlap.lane == plain_certainty.overlap);
        Lanes const half(0.5);
        auto const solution = pw85::detail::solve_by_adjugate(
            pw85::detail::blend(half, pair.q1, half, pair.q2), pair.r12);
        auto const plain_solution =
            pw85::detail::solve_by_adjugate(pw85::detail::blend(0.5, s.q1, 0.5, s.q2), s.r12);
        pw85::detail::Tangency<Lanes, D> const at{solution.s, half, half, half, half};
        pw85::detail::Tangency<double, D> const plain_at{plain_solution.s, 0.5, 0.5, 0.5, 0.5};
        comparison.check("point", pw85::detail::tangency_point(at, pair.q1),
                         pw85::detail::tangency_point(plain_at, s.q1));
        comparison.check("normal", pw85::detail::tangency_normal(at),
                         pw85::detail::tangency_normal(plain_at));
    }
}

PW85_ADD_TEST("/archetype/number/2d", test_number<2>);
PW85_ADD_TEST("/archetype/number/3d", test_number<3>);
PW85_ADD_TEST("/archetype/lanes/2d", test_lanes<2>);
PW85_ADD_TEST("/archetype/lanes/3d", test_lanes<3>);

} // namespace

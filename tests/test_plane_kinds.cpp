// SPDX-License-Identifier: BSD-3-Clause
// Common parts of ellipses of every kind: apart, inside, touching from inside with and without
// other crossings, two, three and four points in common. Areas, gradients and torques against
// Green's theorem in many digits (plane_truth.hpp), within the bounds of their contracts.
#include <cmath>
#include <map>

#include <glib.h>

#include <pw85_batch.h>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "plane_truth.hpp"
#include "random_pairs.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

using Pair2 = Sample<double, 2>;
using WidePair = Sample<Wide, 2>;

double to_double(Wide const &x) { return static_cast<double>(x); }

/// The entries of a pair: r12, q1 and q2.
constexpr int num_entries = 8;

template <class T> T &entry(Sample<T, 2> &p, int k)
{
    return k < 2 ? p.r12[k] : k < 5 ? p.q1[k - 2] : p.q2[k - 5];
}

/// Derivatives by the stored entries, and by the two angles.
using Derivatives = std::array<Wide, num_entries + 2>;

Derivatives derivatives_of(PlaneTruth const &truth)
{
    Derivatives d;
    for (std::size_t i = 0; i < 2; ++i) {
        d[i] = truth.r12[i];
        for (std::size_t k = 0; k < 3; ++k) d[2 + 3 * i + k] = (k == 1 ? 2 : 1) * truth.q[i][k];
        d[num_entries + i] = truth.rotation[i];
    }
    return d;
}

/// How far an entry counts as a unit in the sums s of the contracts.
Wide unit_of(WidePair p, int k)
{
    if (k < 2) return abs(p.r12[k]);
    auto const &q = k < 5 ? p.q1 : p.q2;
    int const j = (k - 2) % 3;
    return j == 1 ? Wide(sqrt(q[0] * q[2])) : q[j];
}

Wide area_of(pw85::SymmetricMatrix<Wide, 2> const &q)
{
    return 2 * WideEllipse::quarter() * sqrt(q[0] * q[2] - q[1] * q[1]);
}

double area_bound(WidePair const &p, PlaneTruth const &truth)
{
    auto const d = derivatives_of(truth);
    Wide s = 0;
    for (int k = 0; k < num_entries; ++k) s += unit_of(p, k) * abs(d[std::size_t(k)]);
    Wide const a = area_of(p.q1), b = area_of(p.q2);
    return u * to_double(64 * (a < b ? a : b) + 16 * s);
}

/// √(Q⁻¹)_ii.
Wide reach(pw85::SymmetricMatrix<Wide, 2> const &q, int i)
{
    return sqrt(q[i == 0 ? 2 : 0] / (q[0] * q[2] - q[1] * q[1]));
}

/// m_p of the manual for each entry.
Derivatives natural_sizes(WidePair const &p)
{
    Wide const a = area_of(p.q1), b = area_of(p.q2), v = a < b ? a : b;
    auto const &smaller = a < b ? p.q1 : p.q2;
    Derivatives m;
    for (int i = 0; i < 2; ++i) m[std::size_t(i)] = v * reach(smaller, i);
    for (int k = 2; k < num_entries; ++k) {
        auto const &q = k < 5 ? p.q1 : p.q2;
        int const j = (k - 2) % 3;
        m[std::size_t(k)] =
            j == 1 ? v * (reach(smaller, 0) * reach(q, 1) + reach(smaller, 1) * reach(q, 0))
                   : v * reach(smaller, j / 2) * reach(q, j / 2);
    }
    return m;
}

/// The bounds u (256 m + 64 s) on the derivatives by entries, and those on the torques that follow.
/// Where the bodies touch, second derivatives differ on both sides: the smaller one counts.
Derivatives derivative_bounds(WidePair const &p, PlaneTruth const &truth)
{
    auto bounds = natural_sizes(p);
    for (int k = 0; k < num_entries; ++k) bounds[std::size_t(k)] *= 256;
    auto const here = derivatives_of(truth);
    for (int k = 0; k < num_entries; ++k) {
        Wide const unit = unit_of(p, k), step = Wide("1e-24") * unit;
        if (!(unit > 0)) continue;
        Derivatives change[2];
        for (int side = 0; side < 2; ++side) {
            auto moved = p;
            entry(moved, k) += side == 0 ? step : Wide(-step);
            change[side] = derivatives_of(plane_truth(moved));
        }
        for (std::size_t j = 0; j < num_entries; ++j) {
            Wide const forward = abs(change[0][j] - here[j]), back = abs(change[1][j] - here[j]);
            bounds[j] += 64 * Wide("1e24") * (forward < back ? forward : back);
        }
    }
    for (std::size_t i = 0; i < 2; ++i) { // 2 (q01 (G11 - G00) + (q00 - q11) G01)
        auto const &q = i == 0 ? p.q1 : p.q2;
        auto const *b = &bounds[2 + 3 * i];
        bounds[num_entries + i] = 2 * (abs(q[1]) * (b[0] + b[2]) + (q[0] + q[2]) * b[1]);
    }
    for (auto &x : bounds) x *= u;
    return bounds;
}

/// What the library says, by entries as derivatives_of() has them.
struct Answer {
    double area, derivatives[num_entries + 2];
    int status;
};

Answer answer_to(Pair2 const &p)
{
    Answer a{};
    double const *r = p.r12.coordinates, *q1 = p.q1.entries, *q2 = p.q2.entries;
    a.status = pw85_overlap_area_2d(r, q1, q2, &a.area);
    double *const d = a.derivatives;
    int const gradient = pw85_overlap_area_gradient_2d(r, q1, q2, d, d + 2, d + 5);
    int const torque = pw85_overlap_area_torque_2d(r, q1, q2, d + num_entries, d + num_entries + 1);
    for (int const status : {gradient, torque})
        if (a.status == PW85_SUCCESS) a.status = status;
    return a;
}

/// Counts of pairs by what their ellipses have in common, of wrong numbers, and of refusals.
class Counts {
  public:
    void add(PlaneTruth const &truth) { ++kinds_[kind_of(truth)]; }
    void add_wrong() { ++wrong_; }
    void add_refused() { ++refused_; }

    void expect(std::initializer_list<char const *> kinds) const
    {
        for (auto const &[kind, count] : kinds_) g_test_message("%s: %ld", kind.c_str(), count);
        g_test_message("wrong %ld, refused %ld", wrong_, refused_);
        for (auto const *kind : kinds)
            if (kinds_.count(kind) == 0) g_test_fail_printf("no pair of the kind '%s'", kind);
    }

  private:
    std::map<std::string, long> kinds_;
    long wrong_ = 0, refused_ = 0;

    static std::string kind_of(PlaneTruth const &t)
    {
        if (t.identical) return "identical";
        std::string const touches = t.touches == 0   ? ""
                                    : t.touches == 1 ? ", touching once"
                                                     : ", touching twice";
        if (t.osculations > 0) return "osculating and crossing";
        if (t.crossings > 0) return std::to_string(t.crossings) + " crossings" + touches;
        return (t.inside[0] || t.inside[1] ? "inside" : "apart") + touches;
    }
};

/// Checks one pair against the truth, derivatives as well if they are asked for.
class Checks {
  public:
    void check(Pair2 const &p, bool with_derivatives)
    {
        auto const wide = convert<Wide>(p);
        auto const truth = plane_truth(wide);
        counts.add(truth);
        auto const answer = answer_to(p);
        auto const text = [&] { return hex_text(p); };
        if (!failures_.check(answer.status == PW85_SUCCESS, "status", answer.status, PW85_SUCCESS,
                             text))
            return counts.add_refused();
        bool good = is_within("area", answer.area, truth.area, area_bound(wide, truth), p);
        if (with_derivatives) good = has_good_derivatives(p, wide, truth, answer) && good;
        if (!good) counts.add_wrong();
    }

    Counts counts;

  private:
    Failures failures_;

    bool is_within(char const *what, double actual, Wide const &truth, double bound, Pair2 const &p)
    {
        double const error = std::abs(to_double(Wide(actual) - truth));
        return failures_.check(error <= bound, what, actual, bound,
                               [&] { return hex_text(p) + ", truth " + truth.str(); });
    }

    bool has_good_derivatives(Pair2 const &p, WidePair const &wide, PlaneTruth const &truth,
                              Answer const &answer)
    {
        static char const *const names[] = {"dr",  "dr",  "dq1", "dq1",      "dq1",
                                            "dq2", "dq2", "dq2", "torque 1", "torque 2"};
        auto const bounds = derivative_bounds(wide, truth);
        auto const exact = derivatives_of(truth);
        bool good = true;
        for (std::size_t k = 0; k < exact.size(); ++k)
            good = is_within(names[k], answer.derivatives[k], exact[k], to_double(bounds[k]), p) &&
                   good;
        return good;
    }
};

/// The form of semi-axes 5a and 5b along (c, s)/5 and across it, a whole number.
pw85::SymmetricMatrix<double, 2> form(double a, double b, double c, double s)
{
    double const aa = a * a, bb = b * b;
    return {{c * c * aa + s * s * bb, c * s * (aa - bb), s * s * aa + c * c * bb}};
}

/// All whole semi-axes from 1 to 5 and offsets from 0 to 4, the second ellipse along the axes or
/// turned by the angle of (3, 4). Lengths are in units of 1/5.
void check_whole_numbers(double c, double s, std::initializer_list<char const *> kinds)
{
    Checks checks;
    int const step = std::min(7, stride(1));
    int n = 0;
    for (int a = 1; a <= 5; ++a)
        for (int b = 1; b <= 5; ++b)
            for (int d = 1; d <= 5; ++d)
                for (int e = 1; e <= 5; ++e)
                    for (int x = 0; x <= 4; ++x)
                        for (int y = 0; y <= 4; ++y, ++n)
                            if (n % step == 0)
                                checks.check(
                                    {{{5.0 * x, 5.0 * y}}, form(a, b, 5, 0), form(d, e, c, s)},
                                    n % 70 == 0);
    checks.counts.expect(kinds);
}

PW85_TEST("/plane_kinds/along_axes")
{
    check_whole_numbers(5, 0,
                        {"apart", "apart, touching once", "inside", "inside, touching once",
                         "inside, touching twice", "identical", "2 crossings",
                         "2 crossings, touching once", "4 crossings"});
}

void test_turned() { check_whole_numbers(3, 4, {"apart", "inside", "2 crossings", "4 crossings"}); }

/// Pairs that touch from inside at a rational point, in whole numbers. With Pythagorean triples
/// (p, q, h), the points (i p²/h, j q²/h) of ellipses with the semi-axes i p and j q have normals
/// along (1/i, 1/j).
std::vector<Pair2> rational_tangencies()
{
    constexpr double triples[][3] = {{3, 4, 5}, {4, 3, 5}, {5, 12, 13}, {12, 5, 13}};
    std::vector<Pair2> pairs;
    for (auto const &[p, q, h] : triples)
        for (auto const &[p2, q2, h2] : triples)
            for (double const i : {1.0, 3.0})
                for (double const j : {1.0, 2.0})
                    for (double const m : {1.0, 2.0, 5.0}) {
                        double const f = h * h2;
                        pairs.push_back({{{i * p * p * h2 - m * i * p2 * p2 * h,
                                           j * q * q * h2 - m * j * q2 * q2 * h}},
                                         {{i * p * i * p * f * f, 0.0, j * q * j * q * f * f}},
                                         {{m * i * p2 * m * i * p2 * f * f, 0.0,
                                           m * j * q2 * m * j * q2 * f * f}}});
                    }
    return pairs;
}

/// x moved by so many units in the last place.
double moved(double x, int ulps)
{
    for (; ulps > 0; --ulps) x = std::nextafter(x, HUGE_VAL);
    for (; ulps < 0; ++ulps) x = std::nextafter(x, -HUGE_VAL);
    return x;
}

/// A pair under the map (a, b; c, d).
Pair2 mapped(Pair2 const &p, double a, double b, double c, double d)
{
    auto const map = [&](pw85::SymmetricMatrix<double, 2> const &q) {
        return pw85::SymmetricMatrix<double, 2>{
            {a * a * q[0] + 2 * a * b * q[1] + b * b * q[2],
             a * c * q[0] + (a * d + b * c) * q[1] + b * d * q[2],
             c * c * q[0] + 2 * c * d * q[1] + d * d * q[2]}};
    };
    return {{{a * p.r12[0] + b * p.r12[1], c * p.r12[0] + d * p.r12[1]}}, map(p.q1), map(p.q2)};
}

Pair2 scaled(Pair2 p, int exponent)
{
    for (int k = 0; k < num_entries; ++k)
        entry(p, k) = std::ldexp(entry(p, k), k < 2 ? exponent : 2 * exponent);
    return p;
}

/// Tangencies as they are, turned, sheared, exchanged, in other units, and with one entry moved by
/// units in the last place.
PW85_TEST("/plane_kinds/tangencies")
{
    Checks checks;
    Random random(6801);
    for (auto const &p : rational_tangencies())
        for (int n = 0; n < draws(16); ++n) {
            auto moved_pair = p;
            int const shape = int(random.uniform(0.0, 4.0));
            if (shape == 1) moved_pair = mapped(p, 3, -4, 4, 3);
            if (shape == 2) moved_pair = mapped(p, 1, 3, 0, 1);
            if (shape == 3) moved_pair = mapped(p, 2, 1, -1, 2);
            int const k = int(random.uniform(0.0, 8.0)), ulps = int(random.uniform(0.0, 5.0)) - 2;
            if (entry(moved_pair, k) != 0.0)
                entry(moved_pair, k) = moved(entry(moved_pair, k), ulps);
            if (n % 2 == 1) moved_pair = {-moved_pair.r12, moved_pair.q2, moved_pair.q1};
            if (n % 4 == 2) moved_pair = scaled(moved_pair, random.sign() > 0.0 ? 300 : -300);
            checks.check(moved_pair, true);
        }
    checks.counts.expect(
        {"inside, touching once", "2 crossings, touching once", "2 crossings", "inside"});
}

/// Slender ellipses, and ellipses of different sizes, that touch from inside but for rounding.
PW85_TEST("/plane_kinds/slender")
{
    Checks checks;
    Random random(6802);
    for (int n = 0; n < draws(4000); ++n) {
        PairOptions options{};
        options.aspect = n % 2 == 0 ? 1e2 : 1e5;
        options.size_ratio = n % 3 == 0 ? 1e3 : 2.0;
        auto p = random_pair<2>(random, options);
        auto const x = random.direction<2>();
        auto const point = [&](auto const &q) {
            return 1.0 / std::sqrt(pw85::detail::quadratic_form(q, x)) * pw85::product(q, x);
        };
        if (n % 4 != 0)
            p.r12 = point(p.q1) - point(p.q2) + random.sign() * random.log_uniform(1e-18, 1e-2) * x;
        checks.check(p, n % 8 == 1);
    }
    checks.counts.expect({"2 crossings", "4 crossings", "inside"});
}

/// Circles, equal forms, and equal centres.
PW85_TEST("/plane_kinds/equal")
{
    Checks checks;
    Random random(6803);
    auto const circle = [](double radius) {
        return pw85::SymmetricMatrix<double, 2>{{radius * radius, 0.0, radius * radius}};
    };
    for (int n = 0; n < draws(1600); ++n) {
        PairOptions options{};
        auto p = random_pair<2>(random, options);
        if (n % 4 == 0) p.q1 = circle(random.log_uniform(0.1, 10.0));
        if (n % 8 == 0) p.q2 = circle(random.log_uniform(0.1, 10.0));
        if (n % 4 == 1) p.q2 = p.q1;
        if (n % 4 == 2) p.q2 = random.log_uniform(0.25, 4.0) * p.q1;
        if (n % 5 == 0) p.r12 = {};
        if (n % 5 == 1) p.r12 = random.log_uniform(1e-40, 1.0) * p.r12;
        if (n % 5 == 2) p.q2[2] = moved(p.q2[2], int(random.uniform(0.0, 5.0)) - 2);
        checks.check(p, true);
    }
    checks.counts.expect({"identical", "inside", "2 crossings", "4 crossings"});
}

/// ∂A/∂r12 of an ellipse and its copy at a small distance r: -2 √det Q Q⁻¹r/√(rᵀQ⁻¹r), as two unit
/// circles have the area π - 2|r| + O(|r|³) in common. No distance is too small.
PW85_TEST("/plane_kinds/copies")
{
    Failures failures;
    Random random(6804);
    for (int n = 0; n < draws(1600); ++n) {
        auto const q = random_form<2>(random, 1.0, random.log_uniform(1.0, 10.0));
        auto const r = random.log_uniform(1e-80, 1e-8) * random.direction<2>();
        auto const answer = answer_to({r, q, q});
        WideEllipse const e({Wide(0), Wide(0)}, convert<Wide>(q));
        auto const x = e.inverse({Wide(r[0]), Wide(r[1])});
        Wide const f = -2 * e.determinant() / sqrt(x.x * x.x + x.y * x.y);
        // L⁻ᵀx
        Wide const y = x.y / e.d, truth[2] = {f * (x.x - e.b * y) / e.a, f * y};
        for (int i = 0; i < 2; ++i) {
            double const bound = u * 256.0 * to_double(area_of(convert<Wide>(q))) *
                                 to_double(reach(convert<Wide>(q), i)),
                         error = std::abs(answer.derivatives[i] - to_double(truth[i]));
            failures.check(answer.status == PW85_SUCCESS && error <= bound, "dr",
                           answer.derivatives[i], to_double(truth[i]), [&] {
                               return hex_text(Pair2{r, q, q});
                           });
        }
    }
}

/// Pairs for which the area was that of a whole body, 0, or wrong by 0.2 %.
constexpr Pair2 specimens[] = {
    {{{0.0, 1.0}}, {{4.0, 0.0, 4.0}}, {{9.0, 0.0, 1.0}}},
    {{{0.0, 0x1.8000000000001p-1}}, {{4.0, 0.0, 4.0}}, {{1.0, 0.0, 1.5625}}},
    {{{-0x1.e9ecdda0101bfp-2, -0x1.22dfe44338b6bp-3}},
     {{1.0, 0.0, 0x1.84edcde2e970fp-2}},
     {{0x1.1c764594d1bbfp+1, 0.0, 0x1.cbde6d636d756p+0}}},
    // Nearly a root of multiplicity three, where a value and its slope are rounding errors
    {{{35.0, -35.0}}, {{10000.0, 0.0, 5625.0}}, {{0x1.5f90000000002p+12, 0.0, 10000.0}}},
};

PW85_TEST("/plane_kinds/specimens")
{
    Checks checks;
    for (auto const &p : specimens) checks.check(p, true);
    double area = 0.0;
    auto const &p = specimens[0];
    pw85_overlap_area_2d(p.r12.coordinates, p.q1.entries, p.q2.entries, &area);
    g_assert_cmpfloat_with_epsilon(area, 5.965763, 1e-6);
}

/// Many rows at once give the same numbers.
PW85_TEST("/plane_kinds/rows")
{
    Failures failures;
    auto pairs = rational_tangencies();
    for (auto const &p : specimens) pairs.push_back(p);
    std::size_t const n = pairs.size();
    std::vector<double> r, q1, q2, areas(n), gradient(8 * n), torques(2 * n);
    for (auto const &p : pairs) {
        r.insert(r.end(), p.r12.coordinates, p.r12.coordinates + 2);
        q1.insert(q1.end(), p.q1.entries, p.q1.entries + 3);
        q2.insert(q2.end(), p.q2.entries, p.q2.entries + 3);
    }
    double *const d = gradient.data();
    g_assert_cmpint(pw85_overlap_area_batch_2d(n, r.data(), q1.data(), q2.data(), areas.data()), ==,
                    PW85_SUCCESS);
    g_assert_cmpint(pw85_overlap_area_gradient_batch_2d(n, r.data(), q1.data(), q2.data(), d,
                                                        d + 2 * n, d + 5 * n),
                    ==, PW85_SUCCESS);
    g_assert_cmpint(pw85_overlap_area_torque_batch_2d(n, r.data(), q1.data(), q2.data(),
                                                      torques.data(), torques.data() + n),
                    ==, PW85_SUCCESS);
    for (std::size_t i = 0; i < n; ++i) {
        auto const one = answer_to(pairs[i]);
        double const *x = one.derivatives;
        bool same = areas[i] == one.area && torques[i] == x[8] && torques[n + i] == x[9];
        for (std::size_t k = 0; k < 2; ++k) same = same && d[2 * i + k] == x[k];
        for (std::size_t k = 0; k < 3; ++k)
            same = same && d[2 * n + 3 * i + k] == x[2 + k] && d[5 * n + 3 * i + k] == x[5 + k];
        failures.check(same, "row", areas[i], one.area, [&] { return hex_text(pairs[i]); });
    }
}

PW85_ADD_TEST("/plane_kinds/turned", test_turned);

} // namespace

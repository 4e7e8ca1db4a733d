// SPDX-License-Identifier: BSD-3-Clause
// Two ellipsoids in n dimensions: contact, point, normal and derivatives, overlap and comparison.
#include <algorithm>
#include <limits>
#include <numeric>

#include <glib.h>

#include <pw85.h>
#include <pw85_any_dimension.h>

#include <pw85/any_dimension/containment.hpp>

#include "any_dimension_truth.hpp"
#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"

using namespace pw85_tests;
using nd::Case, nd::Number, nd::Size;

namespace {

constexpr double u = 0x1p-53, nan = std::numeric_limits<double>::quiet_NaN();

struct Found {
    double mu2, lambda;
    int status;
};

Found contact(Case const &c)
{
    double out[2];
    int const status = pw85_nd_contact(c.n, c.r12.data(), c.q1.data(), c.q2.data(), out);
    return {out[0], out[1], status};
}

int sign_of(Case const &c, double m)
{
    int sign = 7;
    int const status = pw85_nd_compare(c.n, c.r12.data(), c.q1.data(), c.q2.data(), m, &sign);
    if (status != PW85_SUCCESS) g_assert_cmpint(sign, ==, 2); // as of pw85_compare()
    return status == PW85_SUCCESS ? sign : 100 + status;
}

/// How many pairs of a dimension: the truth takes a time of n³.
int pairs_of(int n) { return draws(n <= 4 ? 400 : n <= 8 ? 120 : 24); }

constexpr double aspects[] = {4, 100, 1e4, 1e6};

// The bound of the header: 4 u cond, for both orders. λ is where f is stationary: f there is the
// maximum to the same bound.
PW85_TEST("/any_dimension/contact")
{
    Failures failures;
    Random random(75);
    for (int n = 1; n <= PW85_ND_MAX; ++n)
        for (int i = 0; i < pairs_of(n); ++i) {
            Case const c = i % 4 == 3 && n > 1 ? nd::thin_case(random, n, aspects[i / 4 % 4])
                                               : nd::random_case(random, n, aspects[i / 4 % 4]);
            auto const truth = nd::truth_of(c);
            Number const bound = Number(4 * u) * truth.cond * truth.mu2;
            for (auto const &one : {c, c.exchanged()}) {
                auto const describe = [&] { return one.text(); };
                Found const found = contact(one);
                failures.check(found.status == PW85_SUCCESS, "status", found.status, 0, describe);
                Number const error = abs(Number(found.mu2) - truth.mu2);
                failures.check(error <= bound, "mu2", double(error), double(bound), describe);
                auto const at = nd::evaluate(one, Number(found.lambda));
                // λ is rounded to u, which is more than 4 u cond of f where λ is near 1
                Number const loss = truth.mu2 - at.f,
                             rounding = Number(2 * u) * abs(at.mu1_squared - at.mu2_squared);
                failures.check(loss <= bound + rounding, "lambda", double(loss), double(bound),
                               describe);
            }
        }
}

/// The contact function with N known at compile time.
template <int N> Found contact_of(Case const &c)
{
    auto const found = pw85::nd_contact<N>(c.r12.data(), c.q1.data(), c.q2.data());
    return {found.mu2, found.lambda, static_cast<int>(found.status)};
}

/// Checks that a pair of N dimensions has the bits of the C function.
template <int N> void check_known(Failures &failures, Random &random)
{
    for (int i = 0; i < draws(160); ++i) {
        Case c = nd::random_case(random, N, aspects[i % 4]);
        double const unit = std::ldexp(1.0, i % 3 == 0 ? int(random.uniform(-400, 401)) : 0);
        for (double &x : c.r12) x *= unit;
        for (double &x : i % 2 ? c.q1 : c.q2) x *= i % 5 == 4 ? -unit : unit;
        Found const one = contact(c), other = contact_of<N>(c);
        auto const describe = [&] { return c.text(); };
        failures.check(one.status == other.status, "status", other.status, one.status, describe);
        if (one.status != PW85_SUCCESS) continue;
        failures.check(one.mu2 == other.mu2, "mu2", other.mu2, one.mu2, describe);
        failures.check(one.lambda == other.lambda, "lambda", other.lambda, one.lambda, describe);
    }
}

// Dimensions that are known at compile time change no bit, and no status.
PW85_TEST("/any_dimension/at_compile_time")
{
    Failures failures;
    Random random(88);
    check_known<1>(failures, random);
    check_known<2>(failures, random);
    check_known<4>(failures, random);
    check_known<6>(failures, random);
    check_known<16>(failures, random);
}

/// A pair of the plane as the section z = 0 of ellipsoids.
Case in_space(Case const &c)
{
    auto const &[n, r, a, b] = c;
    return {3, {r[0], r[1], 0}, {a[0], a[1], 0, a[2], 0, 1}, {b[0], b[1], 0, b[2], 0, 1}};
}

// In two and three dimensions the functions for these are the truth.
PW85_TEST("/any_dimension/known_dimensions")
{
    Failures failures;
    Random random(76);
    for (int i = 0; i < draws(2000); ++i) {
        int const n = 2 + i % 2;
        Case const c = nd::random_case(random, n, aspects[i / 2 % 4]);
        double known[2], cond = 0;
        int const status = n == 2 ? pw85_contact_2d(c.r12.data(), c.q1.data(), c.q2.data(), known)
                                  : pw85_contact(c.r12.data(), c.q1.data(), c.q2.data(), known);
        g_assert_cmpint(status, ==, PW85_SUCCESS);
        Found const found = contact(c);
        auto const at = nd::evaluate(c, Number(known[1]));
        cond = double(nd::condition(c, at, Number(known[1])));
        auto const describe = [&] { return c.text(); };
        failures.check(std::abs(found.mu2 - known[0]) <= 8.01 * u * cond * known[0], "mu2",
                       found.mu2, known[0], describe);
        int sign = 7;
        Case const space = n == 2 ? in_space(c) : c;
        for (double m : {found.mu2, std::nextafter(found.mu2, 0.0), 1.0}) {
            int const failed =
                pw85_compare(space.r12.data(), space.q1.data(), space.q2.data(), m, &sign);
            g_assert_cmpint(failed, ==, PW85_SUCCESS);
            failures.check(sign_of(c, m) == sign, "sign", sign_of(c, m), sign, describe);
        }
    }
}

/// The pair with further axes of length 1, in random places, in which the centres are equal.
Case padded(Random &random, Case const &c, int n)
{
    std::vector<int> axes;
    for (int i = 0; i < n; ++i) axes.push_back(i < c.n ? i : -1);
    for (int i = n - 1; i > 0; --i) std::swap(axes[Size(i)], axes[Size(random.uniform(0, i + 1))]);
    Case other{n, std::vector<double>(Size(n)), std::vector<double>(nd::packed_size(n)),
               std::vector<double>(nd::packed_size(n))};
    for (int i = 0; i < n; ++i) {
        int const from = axes[Size(i)];
        if (from >= 0) other.r12[Size(i)] = c.r12[Size(from)];
        for (int j = i; j < n; ++j) {
            int const from_j = axes[Size(j)];
            Size const k = nd::place(n, i, j);
            bool const inside = from >= 0 && from_j >= 0;
            other.q1[k] = inside ? c.q1[nd::place(c.n, from, from_j)] : i == j ? 1.0 : 0.0;
            other.q2[k] = inside ? c.q2[nd::place(c.n, from, from_j)] : i == j ? 1.0 : 0.0;
        }
    }
    return other;
}

// Axes without separation change nothing: neither μ² beyond its bound, nor any exact answer.
PW85_TEST("/any_dimension/padding")
{
    Failures failures;
    Random random(77);
    for (int i = 0; i < draws(16); ++i) {
        int const n = 1 + i % 4;
        Case const c = nd::random_case(random, n, aspects[i / 4 % 4]),
                   other = padded(random, c, n + 1 + i % (PW85_ND_MAX - n));
        Found const first = contact(c), second = contact(other);
        auto const at = nd::evaluate(c, Number(first.lambda));
        double const bound =
            8.01 * u * double(nd::condition(c, at, Number(first.lambda))) * first.mu2;
        auto const describe = [&] { return c.text() + " and " + other.text(); };
        failures.check(std::abs(first.mu2 - second.mu2) <= bound, "mu2", second.mu2, first.mu2,
                       describe);
        for (double m : {first.mu2, std::nextafter(first.mu2, 0.0)})
            failures.check(sign_of(c, m) == sign_of(other, m), "sign", sign_of(other, m),
                           sign_of(c, m), describe);
    }
}

/// The relative error of each number is at most `bound` times the largest of them: those of a
/// vector share the condition of s.
void check_vector(Failures &failures, char const *what, std::vector<double> const &found,
                  std::vector<Number> const &truth, Number const &bound, Case const &c)
{
    Number largest = 0;
    for (auto const &x : truth) largest = std::max(largest, abs(x));
    for (Size i = 0; i < truth.size(); ++i) {
        Number const error = abs(Number(found[i]) - truth[i]);
        failures.check(error <= bound * largest, what, found[i], double(truth[i]),
                       [&] { return c.text(); });
    }
}

// The formulas of the envelope theorem at the λ that was found, with s of 50 digits. Aspect ratios
// up to 100: s has the condition number of M, 1e4, and n² of the worst case.
PW85_TEST("/any_dimension/geometry")
{
    Failures failures;
    Random random(78);
    for (int n = 1; n <= PW85_ND_MAX; ++n)
        for (int i = 0; i < draws(40); ++i) {
            Case const c = nd::random_case(random, n, aspects[i % 2]);
            double const lambda = contact(c).lambda;
            Size const size = nd::packed_size(n);
            std::vector<double> point(Size(n), nan), normal(point), d_r12(point), d_q1(size, nan),
                d_q2(d_q1);
            int const status = pw85_nd_contact_geometry(n, c.r12.data(), c.q1.data(), c.q2.data(),
                                                        lambda, point.data(), normal.data(),
                                                        d_r12.data(), d_q1.data(), d_q2.data());
            g_assert_cmpint(status, ==, PW85_SUCCESS);
            Number const l = lambda, rest = Number(1) - l;
            auto const s = nd::evaluate(c, l).s;
            auto const q1s = nd::times(nd::blend(c, 1, 0), s);
            Number const norm = sqrt(nd::dot(s, s));
            std::vector<Number> x, y, z, w1, w2;
            for (int k = 0; k < n; ++k) {
                x.push_back(rest * q1s[Size(k)]);
                y.push_back(s[Size(k)] / norm);
                z.push_back(Number(2) * l * rest * s[Size(k)]);
                for (int j = k; j < n; ++j) {
                    Number const twice =
                        (j == k ? Number(-1) : Number(-2)) * s[Size(k)] * s[Size(j)];
                    w1.push_back(l * rest * rest * twice);
                    w2.push_back(l * l * rest * twice);
                }
            }
            Number const bound = Number(1e4 * n * n * u);
            check_vector(failures, "point", point, x, bound, c);
            check_vector(failures, "normal", normal, y, bound, c);
            check_vector(failures, "d_r12", d_r12, z, bound, c);
            check_vector(failures, "d_q1", d_q1, w1, Number(2) * bound, c);
            check_vector(failures, "d_q2", d_q2, w2, Number(2) * bound, c);
        }
}

// Forms of determinants near 1 with entries of 1e14: s is right to rounding in the norm of M, from
// numbers of seven times the digits.
PW85_TEST("/any_dimension/geometry_of_singular_forms")
{
    Failures failures;
    Random random(86);
    for (int n = 3; n <= 6; ++n)
        for (int i = 0; i < draws(16); ++i) {
            Case c{n, std::vector<double>(Size(n), 1.0), std::vector<double>(nd::packed_size(n)),
                   std::vector<double>(nd::packed_size(n))};
            // L Lᵀ with a unit diagonal in L, and integers below it that are large in two columns:
            // the condition number, of a unit diagonal, is up to 1e26. 50 digits leave 24.
            std::vector<std::vector<double>> lower(Size(n), std::vector<double>(Size(n), 0.0));
            for (Size a = 0; a < Size(n); ++a) {
                lower[a][a] = 1;
                for (Size b = 0; b < a; ++b)
                    lower[a][b] = std::floor(random.uniform(-1, 1) * (b == 0   ? 1e7
                                                                      : b == 1 ? 1e6
                                                                               : 3));
            }
            for (int a = 0; a < n; ++a)
                for (int b = a; b < n; ++b) {
                    double sum = 0;
                    for (Size k = 0; k <= Size(a); ++k)
                        sum += lower[Size(a)][k] * lower[Size(b)][k];
                    c.q1[nd::place(n, a, b)] = sum;
                }
            c.q2 = c.q1;
            c.q2[0] += 1;
            std::vector<double> point(Size(n), nan), d_r12(point);
            int const status =
                pw85_nd_contact_geometry(n, c.r12.data(), c.q1.data(), c.q2.data(), 0.25,
                                         point.data(), nullptr, d_r12.data(), nullptr, nullptr);
            failures.check(status == PW85_SUCCESS, "status", status, 0, [&] { return c.text(); });
            auto const s = nd::evaluate(c, Number(0.25)).s;
            auto const q1s = nd::times(nd::blend(c, 1, 0), s);
            std::vector<Number> x, z;
            for (Size k = 0; k < Size(n); ++k) {
                x.push_back(Number(0.75) * q1s[k]);
                z.push_back(Number(0.375) * s[k]);
            }
            // s errs by 2u of its norm in M, √(sᵀMs) = √(sᵀr12), plus rounding: the error of a
            // component is at most that times √((M⁻¹)_kk), and that of the point times a semi-axis.
            // Where double precision suffices, M⁻¹ρ with the rounding errors ρ of the residual
            // comes on top, n + 6 of each term; and n + 2 of each term of Q1 s.
            auto const q1 = nd::blend(c, 1, 0), m = nd::blend(c, 0.75, 0.25);
            double axis = 0;
            for (int k = 0; k < n; ++k) axis = std::max(axis, c.q1[nd::place(n, k, k)]);
            Number along = 0, condition = 0, rounding = 0, largest = 0, inverse = 0;
            std::vector<Number> terms(Size(n), Number(0));
            for (Size k = 0; k < Size(n); ++k) {
                along += s[k]; // r12 is (1, …, 1)
                largest = std::max(largest, Number(abs(z[k])));
                nd::Row unit(Size(n), Number(0));
                unit[k] = 1;
                Number const entry = nd::solve(m, unit)[k];
                inverse = std::max(inverse, entry);
                condition += m[k][k] * entry;
                Number residual = 1;
                for (Size j = 0; j < Size(n); ++j) {
                    terms[k] += abs(q1[k][j] * s[j]);
                    residual += abs(m[k][j] * s[j]);
                }
                rounding += Number((n + 6) * u) * residual * sqrt(entry);
            }
            // The limit of find_tangency(). Its own κ may be twice this one.
            bool const may_be_double = Number(2.0 * n * (3 * n + 4) * u) * condition <= 0x1p-26;
            if (!may_be_double) rounding = 0;
            Number const error = Number(4 * u) * sqrt(along) + rounding;
            for (Size k = 0; k < Size(n); ++k) {
                Number const bound = sqrt(Number(axis)) * error +
                                     (may_be_double ? Number((n + 2) * u) * terms[k] : Number(0));
                failures.check(abs(Number(point[k]) - x[k]) <= bound, "point", point[k],
                               double(x[k]), [&] { return c.text(); });
                failures.check(abs(Number(d_r12[k]) - z[k]) <=
                                   Number(0.375) * sqrt(inverse) * error + Number(4 * u) * largest,
                               "d_r12", d_r12[k], double(z[k]), [&] { return c.text(); });
            }
        }
}

// The sign of μ² - m from the truth, for m that differ from μ² by a part of 1e-3 to 1e-40: as r12
// is a double, the pair is compared at the double next to μ², and its neighbours.
PW85_TEST("/any_dimension/compare")
{
    Failures failures;
    Random random(79);
    for (int n = 1; n <= PW85_ND_MAX; ++n)
        for (int i = 0; i < pairs_of(n) / 2; ++i) {
            Case const c = nd::random_case(random, n, aspects[i % 4]);
            Number const mu2 = nd::truth_of(c).mu2;
            double const near = double(mu2);
            for (double m : {near, std::nextafter(near, 0.0), std::nextafter(near, 2 * near),
                             near * (1 + 1e-9), near * (1 - 1e-6)}) {
                int const sign = mu2 > m ? 1 : -1;
                for (auto const &one : {c, c.exchanged()})
                    failures.check(sign_of(one, m) == sign, "sign", sign_of(one, m), sign,
                                   [&] { return one.text() + ", m = " + hex_text(&m, 1); });
            }
        }
}

/// Two ellipsoids that touch: semi-axes 2 and 3 along the first axis, 5 apart, others any, in the
/// image of a random matrix of integers. All numbers are integers.
Case touching(Random &random, int n, int largest)
{
    Case c{n, std::vector<double>(Size(n)), std::vector<double>(nd::packed_size(n)),
           std::vector<double>(nd::packed_size(n))};
    std::vector<std::vector<double>> map;
    for (int i = 0; i < n; ++i) {
        map.emplace_back();
        for (int k = 0; k < n; ++k)
            map.back().push_back(std::floor(random.uniform(-largest, largest + 1)));
    }
    for (int k = 0; k < n; ++k) {
        double const d1 = k == 0 ? 4 : std::floor(random.uniform(1, 20)),
                     d2 = k == 0 ? 9 : std::floor(random.uniform(1, 20));
        for (int i = 0; i < n; ++i) {
            if (k == 0) c.r12[Size(i)] = 5 * map[Size(i)][0];
            for (int j = i; j < n; ++j) {
                double const product = map[Size(i)][Size(k)] * map[Size(j)][Size(k)];
                c.q1[nd::place(n, i, j)] += d1 * product;
                c.q2[nd::place(n, i, j)] += d2 * product;
            }
        }
    }
    return c;
}

// Ties, with units of 2^±40, and the pairs next to them: farther and nearer centres by one bit.
PW85_TEST("/any_dimension/ties")
{
    Failures failures;
    Random random(80);
    for (int n = 1; n <= PW85_ND_MAX; ++n)
        for (int i = 0; i < draws(n <= 8 ? 24 : 8); ++i) {
            Case c = touching(random, n, 1000);
            double const unit = std::ldexp(1.0, int(random.uniform(-40, 41)));
            for (double &x : c.r12) x *= unit;
            for (auto *q : {&c.q1, &c.q2})
                for (double &x : *q) x *= unit * unit;
            auto const expect = [&](double change, int sign) {
                Case other = c;
                for (double &x : other.r12) x *= change; // exact: the integers have 13 bits
                int answer = 7;
                pw85_nd_overlap(n, other.r12.data(), other.q1.data(), other.q2.data(), &answer);
                auto const describe = [&] { return other.text(); };
                failures.check(answer == (sign < 0), "overlap", answer, sign < 0, describe);
                failures.check(sign_of(other, 1.0) == sign, "sign", sign_of(other, 1.0), sign,
                               describe);
            };
            expect(1.0, 0);
            expect(1.0 + 0x1p-30, 1);
            expect(1.0 - 0x1p-30, -1);
        }
}

// A form is L Lᵀ of integers, of full rank or not; one unit off is definite or not for sure.
PW85_TEST("/any_dimension/definite")
{
    Failures failures;
    Random random(81);
    for (int n = 2; n <= PW85_ND_MAX; ++n)
        for (int i = 0; i < draws(24); ++i)
            for (int rank : {n - 1, n}) {
                Case c{n, std::vector<double>(Size(n), 1.0),
                       std::vector<double>(nd::packed_size(n)),
                       std::vector<double>(nd::packed_size(n))};
                for (int k = 0; k < rank; ++k) {
                    std::vector<double> x;
                    for (int j = 0; j < n; ++j) x.push_back(std::floor(random.uniform(-1e6, 1e6)));
                    if (rank == n) // the last column is nearly in the space of the others
                        for (int j = 0; j < n; ++j)
                            if (k == n - 1) x[Size(j)] = j == 0;
                    for (int a = 0; a < n; ++a)
                        for (int b = a; b < n; ++b)
                            c.q1[nd::place(n, a, b)] += x[Size(a)] * x[Size(b)];
                }
                for (int j = 0; j < n; ++j) c.q2[nd::place(n, j, j)] = 1;
                int const expected = rank == n ? PW85_SUCCESS : PW85_ENOTPD;
                for (auto const &one : {c, c.exchanged()}) {
                    Found const found = contact(one);
                    failures.check(found.status == expected, "status", found.status, expected,
                                   [&] { return one.text(); });
                    failures.check((expected == PW85_SUCCESS) == (found.mu2 == found.mu2), "NaN",
                                   found.mu2, 0, [&] { return one.text(); });
                }
            }
}

int contains(Case const &c)
{
    int answer = 7;
    int const status = pw85_nd_contains(c.n, c.r12.data(), c.q1.data(), c.q2.data(), &answer);
    return status == PW85_SUCCESS ? answer : 100 + status;
}

/// The decision in integers, which contains() asks for ties only.
int contains_exactly(Case const &c)
{
    return pw85::detail::any_dimension::contains_exactly(
        {c.n, c.r12.data(), c.q1.data(), c.q2.data()});
}

Found containment(Case const &c, std::vector<double> &point)
{
    point.assign(Size(c.n), nan);
    double mu2 = nan;
    int const status =
        pw85_nd_containment(c.n, c.r12.data(), c.q1.data(), c.q2.data(), &mu2, point.data());
    return {mu2, nan, status};
}

// κ², its bound (2n + 20) u c of the header, and the answer of the exact test: r12 and Q2 are
// scaled so that κ² is near 1. The point is on ellipsoid 2 and on the scaled ellipsoid 1.
PW85_TEST("/any_dimension/containment")
{
    Failures failures;
    Random random(83);
    std::vector<double> point;
    for (int n = 1; n <= PW85_ND_MAX; ++n)
        for (int i = 0; i < draws(n <= 4 ? 24 : n <= 8 ? 6 : 2); ++i) {
            Case c = nd::random_case(random, n, aspects[i % 4]);
            double const shorter = i % 3 == 0 ? 0x1p-6 : 1;
            for (double &x : c.r12) x *= shorter;
            for (double const change : {1 + 1e-13, 1 - 1e-13, 1.0}) {
                Found const found = containment(c, point);
                auto const truth = nd::containment_truth(c);
                auto const describe = [&] { return c.text(); };
                failures.check(found.status == PW85_SUCCESS, "status", found.status, 0, describe);
                Number const error = abs(Number(found.mu2) - truth.kappa2),
                             bound = Number((2 * n + 20) * u) * truth.sum;
                failures.check(error <= bound, "kappa2", double(error), double(bound), describe);
                failures.check(contains(c) == int(truth.kappa2 <= 1), "contains", contains(c),
                               double(truth.kappa2 - 1), describe);
                if (n <= 8)
                    failures.check(contains_exactly(c) == contains(c), "contains_exactly",
                                   contains_exactly(c), contains(c), describe);
                double const factor = change / std::sqrt(found.mu2);
                for (double &x : c.r12) x *= factor;
                for (double &x : c.q2) x *= factor * factor;
            }
        }
}

// A unit ball around thin ellipsoids along the axes, the longest one across a long separation:
// see /containment_factor/across_the_separation.
PW85_TEST("/any_dimension/across_the_separation")
{
    Failures failures;
    Random random(94);
    std::vector<double> point;
    // for this one the bound was below the other one by far
    constexpr double known[2][2] = {{2.2135873115422884e-06, 205.65692990696988},
                                    {671937.9735215104, 0.18853546468816945}};
    for (int i = 0; i < draws(16000); ++i) {
        int const n = 2 + i % 15;
        Case c{n, std::vector<double>(Size(n)), std::vector<double>(nd::packed_size(n)),
               std::vector<double>(nd::packed_size(n))};
        double square = 0;
        for (int k = 0; k < n; ++k) {
            double const axis = i == 0 ? known[0][k] : random.log_uniform(1e-8, 1e4);
            c.q1[nd::place(n, k, k)] = 1;
            c.q2[nd::place(n, k, k)] = axis * axis;
            c.r12[Size(k)] = i == 0 ? known[1][k] : random.log_uniform(1e-2, 1e6);
            square += c.r12[Size(k)] * c.r12[Size(k)];
        }
        Found const found = containment(c, point);
        auto const describe = [&] { return c.text(); };
        failures.check(found.status == PW85_SUCCESS, "status", found.status, 0, describe);
        failures.check(found.mu2 >= square * (1 - 1e-12), "kappa2", found.mu2, square, describe);
    }
}

using Full = std::vector<std::vector<double>>;

/// The image of a pair by a random matrix of integers. Its numbers must have few digits.
Case mapped(Random &random, std::vector<double> const &r, Full const &q1, Full const &q2)
{
    Size const n = r.size();
    Full map(n, std::vector<double>(n));
    for (auto &row : map)
        for (double &x : row) x = std::floor(random.uniform(-50, 51));
    Case c{int(n), std::vector<double>(n), std::vector<double>(nd::packed_size(int(n))),
           std::vector<double>(nd::packed_size(int(n)))};
    for (Size i = 0; i < n; ++i)
        for (Size k = 0; k < n; ++k) {
            c.r12[i] += map[i][k] * r[k];
            for (Size j = i; j < n; ++j)
                for (Size l = 0; l < n; ++l) {
                    Size const at = nd::place(int(n), int(i), int(j));
                    c.q1[at] += map[i][k] * q1[k][l] * map[j][l];
                    c.q2[at] += map[i][k] * q2[k][l] * map[j][l];
                }
        }
    return c;
}

/// Integers in n dimensions that touch from inside: ellipsoid 1 has the semi-axis 5 along the first
/// axis, and ellipsoid 2 has 2, with its centre at 3. In its other axes the form of ellipsoid 2 is
/// `less` below 2/5 of that of ellipsoid 1, with which the curvatures are equal. `mixed` adds a
/// block whose eigenvalues 3 ± √2 are irrational, and of which the larger one is the root that p/B
/// has.
Case touching_inside(Random &random, int n, bool mixed, double less, double change)
{
    Full q1(Size(n), std::vector<double>(Size(n), 0.0)), q2 = q1;
    std::vector<double> r(Size(n), 0.0);
    r[0] = mixed ? 47 : 3;
    q1[0][0] = mixed ? 4700 : 25;
    q2[0][0] = mixed ? 329 : 4;
    for (Size i = 1; i < Size(n); ++i) {
        double const c = mixed ? 2 : std::floor(random.uniform(1, 20));
        q1[i][i] = 5 * c;
        q2[i][i] = mixed ? 3 : 2 * c - less;
    }
    if (mixed) {
        q2[1][1] = 4;
        q2[2][2] = 2;
        q2[1][2] = q2[2][1] = 1;
    }
    if (n > 1) q2[1][1] += change;
    return mapped(random, r, q1, q2);
}

/// A pair that is inside without its second axis, where the separation is tiny: with c = 1/10 and d
/// = 1/10 of the first axis, (1 - ν)(ν - d) = νc at ν = 0.887. The eigenvalue of the second axis is
/// eigenvalue/10. All roots of p are real and positive in either case.
Case with_tiny_part(Random &random, int n, double eigenvalue)
{
    Full q1(Size(n), std::vector<double>(Size(n), 0.0)), q2 = q1;
    std::vector<double> r(Size(n), 0.0);
    for (Size i = 0; i < Size(n); ++i) q1[i][i] = 10, q2[i][i] = 1;
    q2[1][1] = eigenvalue;
    r[0] = 1;
    r[1] = 0x1p-20;
    return mapped(random, r, q1, q2);
}

// Ties of containment, and forms that differ from them by 2⁻²⁰ of one entry.
PW85_TEST("/any_dimension/inner_ties")
{
    Failures failures;
    Random random(84);
    for (int n = 1; n <= PW85_ND_MAX; ++n)
        for (int i = 0; i < draws(n <= 8 ? 8 : 2); ++i)
            for (bool mixed : {false, true}) {
                if (mixed && n < 3) continue;
                auto const expect = [&](double less, double change, double shift, int expected) {
                    Case c = touching_inside(random, n, mixed, less, change);
                    for (double &x : c.r12) x *= shift; // exact: 30 more bits
                    for (int answer : {contains(c), contains_exactly(c)})
                        failures.check(answer == expected, "contains", answer, expected,
                                       [&] { return c.text(); });
                };
                expect(0, 0, 1, 1);
                expect(1, 0, 1, 1);
                expect(0, 0, 1 + 0x1p-30, 0);
                if (n > 1) expect(0, 0x1p-20, 1, 0);
                if (n > 1) expect(0, -0x1p-20, 1, 1);
            }
    for (int n = 2; n <= PW85_ND_MAX; ++n)
        for (double eigenvalue : {8.0, 9.0}) {
            Case const c = with_tiny_part(random, n, eigenvalue);
            for (int answer : {contains(c), contains_exactly(c)})
                failures.check(answer == (eigenvalue < 8.87), "tiny part", answer, eigenvalue,
                               [&] { return c.text(); });
        }
    // An axis of the same length in both, and centres apart across it.
    for (int n = 2; n <= PW85_ND_MAX; ++n)
        for (double distance : {1.0, 0x1p-30}) {
            std::vector<double> r(Size(n), 0.0);
            r[Size(n) - 1] = distance;
            Full q1(Size(n), r), q2;
            for (Size k = 0; k < Size(n); ++k) q1[k].assign(Size(n), 0.0), q1[k][k] = 4;
            q2 = q1;
            for (Size k = 1; k < Size(n); ++k) q2[k][k] = double(1 + k % 2);
            Case const c = mapped(random, r, q1, q2);
            for (int answer : {contains(c), contains_exactly(c)})
                failures.check(answer == 0, "same axis", answer, 0, [&] { return c.text(); });
        }
    // Without separation: Q1 - Q2 is semidefinite or not.
    for (int n = 1; n <= PW85_ND_MAX; ++n) {
        Case c = touching_inside(random, n, false, 0, 0);
        c.r12.assign(Size(n), 0.0);
        c.q2 = c.q1;
        g_assert_cmpint(contains(c), ==, 1);
        c.q2[0] = std::nextafter(c.q2[0], HUGE_VAL);
        g_assert_cmpint(contains(c), ==, 0);
        c.q2[0] = std::nextafter(c.q1[0], 0);
        g_assert_cmpint(contains(c), ==, 1);
        c.q2 = c.q1; // the largest eigenvalue is 1
        c.r12[0] = 0x1p-300;
        g_assert_cmpint(contains(c), ==, 0);
        g_assert_cmpint(contains_exactly(c), ==, 0);
    }
}

/// Ellipsoid 2 has its longest semi-axis, b = 3, across r12, which is along a semi-axis c = 1: it
/// reaches farthest from the centre of a ball of radius 2 where the coordinate along r12 is y = ρ
/// c²/(b² - c²), so that 4 κ² = b² + ρ² b²/(b² - c²). For ρ = 0 ellipsoids are concentric. The
/// condition sum is at most 3 κ² for diagonal forms.
PW85_TEST("/any_dimension/across_the_longest_axis")
{
    Failures failures;
    std::vector<double> point;
    for (int n = 2; n <= PW85_ND_MAX; ++n)
        for (int longest = 0; longest < n; longest += 3)
            for (double rho : {0.0, 0x1p-30, 1.0, 2.0}) {
                Case c{n, std::vector<double>(Size(n), 0.0),
                       std::vector<double>(nd::packed_size(n), 0.0),
                       std::vector<double>(nd::packed_size(n), 0.0)};
                for (int k = 0; k < n; ++k) {
                    c.q1[nd::place(n, k, k)] = 4;
                    c.q2[nd::place(n, k, k)] = k == longest ? 9 : 1;
                }
                c.r12[Size((longest + 1) % n)] = rho;
                Found const found = containment(c, point);
                double const expected = (9 + rho * rho * 1.125) / 4;
                auto const describe = [&] { return c.text(); };
                failures.check(found.status == PW85_SUCCESS, "status", found.status, 0, describe);
                failures.check(std::abs(found.mu2 - expected) <= (2 * n + 21) * u * 3 * expected,
                               "kappa2", found.mu2, expected, describe);
            }
}

// The first direction of the search with twice the digits is far from the best one, and S there is
// 10¹⁷. The factor and S at the result, 6060.4, are from mpmath with 60 and 150 digits: the bound
// max over s of (√(sᵀQ2s) + s·r12)²/(sᵀQ1s), and the dual one.
PW85_TEST("/any_dimension/far_direction")
{
    Case const c{9,
                 {-0x1.a8e290d441b63p+25, 0x1.5bfe4a9c73011p+21, 0x1.027a1dec27be5p+23,
                  0x1.34dba4d8280dap+25, -0x1.36a478c7acc5ap+22, 0x1.049d4e340017ep+26,
                  -0x1.6f9fa4fc84eeap+22, -0x1.122af8bf037f8p+23, -0x1.2f8be0bbfab19p+23},
                 {0x1.6b903f80cf9fdp+57,  -0x1.9d28cc106aa2cp+49, 0x1.fe6a58bfa71fep+54,
                  -0x1.4ec3a1da361bdp+52, 0x1.0c03db94e2162p+54,  -0x1.e7e0193b1907dp+54,
                  -0x1.67405fe9f3255p+52, -0x1.b0c9a57cecd72p+53, 0x1.c730adb373c1dp+54,
                  0x1.5d2a3971f52bcp+55,  -0x1.4d948369ecbb3p+54, -0x1.2685c7da69e53p+55,
                  0x1.a8029e2e39754p+53,  0x1.2acffb9860edap+54,  0x1.4925b8f88c3a0p+55,
                  -0x1.2fc9701c9e9a0p+55, -0x1.5ff1503eb8088p+54, 0x1.b53ecd658061ap+57,
                  0x1.ffa72573999cep+53,  -0x1.bf264c9491f45p+56, -0x1.c6b509e95fc7fp+55,
                  0x1.5fcfce40bdd1ap+55,  -0x1.a18a456c3737fp+55, 0x1.1468e482e7f96p+55,
                  0x1.59e68b9cb8f16p+56,  -0x1.497882036613bp+54, -0x1.7d00857c269c3p+54,
                  -0x1.050f58a00bddap+55, 0x1.2d1b6ccf78b80p+55,  0x1.33c51e3982927p+56,
                  0x1.6d765d331f45dp+56,  0x1.0dbbb9a30a0f1p+55,  -0x1.10894b7f6ea7cp+55,
                  0x1.ba8b68edae492p+54,  -0x1.621d5da5758ecp+55, 0x1.e66d1142492c0p+55,
                  -0x1.6a7b3043e2f24p+54, -0x1.4da511a60df12p+52, -0x1.f879dad6ba20fp+55,
                  0x1.21ee35b49c8ecp+57,  -0x1.c69dca762cf3ep+55, 0x1.b40d9596df837p+55,
                  0x1.204fd746206e6p+56,  0x1.24067862deaddp+55,  0x1.64a9a4d2bf9bap+57},
                 {0x1.0070b990c01c1p+57,  0x1.cc7eae6afac73p+51,  -0x1.1cf3a37197b02p+51,
                  -0x1.78bb15ee6c808p+52, 0x1.11df3a46a9a30p+54,  0x1.a6e9dbe02f1bfp+47,
                  -0x1.6bfc45c582d58p+53, -0x1.3c49845ed2383p+54, -0x1.26f62d028931ep+52,
                  0x1.f09578758e12ap+55,  -0x1.965a93c1b111ap+52, 0x1.a0f61395e211cp+53,
                  0x1.44e6ae3c3f23dp+52,  0x1.718c1839fccc8p+54,  -0x1.de45589200c49p+53,
                  -0x1.ade3ebe4b35f8p+54, 0x1.b1226ae5fb56cp+54,  0x1.fa0f4b983352ep+55,
                  0x1.881919c8794d6p+52,  0x1.f7ffc1a4c29a6p+52,  -0x1.3e01859af37dep+53,
                  -0x1.53b8bc788245bp+53, 0x1.f00ac8359b238p+52,  -0x1.a90115ce5feb8p+51,
                  0x1.4583fcf68b373p+56,  -0x1.3616ecef0768ap+53, 0x1.c26cebbbce0f7p+55,
                  -0x1.09e3cb8c6c4f4p+52, -0x1.48fcbecbdcc61p+55, 0x1.9000adc1d4caep+52,
                  0x1.155c9f7e676d6p+56,  -0x1.5b7bdc7a1b660p+52, 0x1.77b91a853631fp+53,
                  0x1.3815b7768d4bbp+54,  -0x1.fb74baf61cd81p+52, 0x1.20b9931fb190ap+56,
                  -0x1.29c62c126f74fp+53, -0x1.28bf915ba7366p+55, -0x1.29e8fe7569408p+47,
                  0x1.0e716931e5962p+56,  0x1.00038a10f7380p+52,  0x1.1002a81a328e5p+54,
                  0x1.69a21efd44a66p+55,  -0x1.7329ce44c05fcp+52, 0x1.5f0497b1c5a6cp+55}};
    double const kappa2 = 7.1355773768117679241;
    std::vector<double> point;
    Found const found = containment(c, point);
    g_assert_cmpint(found.status, ==, PW85_SUCCESS);
    g_assert_cmpfloat(std::abs(found.mu2 - kappa2), <=, (2 * 9 + 20) * u * 6060.4);
}

/// Ellipsoids that touch from inside in the directions s with sᵀQ2s = (s·r12)²: Q1 = 2 Q2 + 2 r rᵀ.
/// No such direction proves that ellipsoid 2 is not inside, however its numbers are rounded.
PW85_TEST("/any_dimension/proof_of_outside")
{
    using namespace pw85::detail::any_dimension;
    Failures failures;
    Random random(87);
    for (int n = 2; n <= 8; ++n)
        for (int i = 0; i < draws(160); ++i) {
            Pair<double> pair{};
            pair.n = n;
            std::vector<Number> s(Size(n), 0), other(Size(n), 0);
            std::vector<std::vector<double>> l(Size(n), std::vector<double>(Size(n), 0.0));
            for (Size k = 0; k < Size(n); ++k) {
                pair.r12[k] = std::floor(random.uniform(-3000, 3000));
                s[k] = random.normal(), other[k] = random.normal();
                for (Size j = 0; j <= k; ++j) l[k][j] = std::floor(random.uniform(-900, 900));
                l[k][k] = std::floor(random.uniform(1, 900));
            }
            for (int k = 0; k < n; ++k)
                for (int j = k; j < n; ++j) {
                    double sum = 0;
                    for (Size m = 0; m <= Size(k); ++m) sum += l[Size(k)][m] * l[Size(j)][m];
                    pair.q2[packed_index(n, k, j)] = sum;
                    pair.q1[packed_index(n, k, j)] = 2 * sum + 2 * pair.r12[k] * pair.r12[j];
                }
            // s + a other on the cone, if there is one
            auto const form = [&](auto const &x, auto const &y) {
                Number sum = 0, along_x = 0, along_y = 0;
                for (int k = 0; k < n; ++k) {
                    along_x += x[Size(k)] * pair.r12[k], along_y += y[Size(k)] * pair.r12[k];
                    for (int j = 0; j < n; ++j)
                        sum += x[Size(k)] * y[Size(j)] * pair.q2[packed_index(n, k, j)];
                }
                return Number(sum - along_x * along_y);
            };
            Number const a = form(other, other), b = form(s, other), c = form(s, s);
            if (b * b < a * c) continue;
            Number const factor = (sqrt(Number(b * b - a * c)) - b) / a;
            double direction[max_dimension] = {};
            for (Size k = 0; k < Size(n); ++k)
                direction[k] = static_cast<double>(Number(s[k] + factor * other[k]));
            failures.check(!shows_outside(pair, direction), "shows_outside", 1, 0,
                           [&] { return hex_text(direction, n); });
        }
}

/// A distance and its vectors.
struct FoundDistance {
    double distance;
    std::vector<double> point1, point2, normal;
    int status;
};

FoundDistance distance(Case const &c)
{
    std::vector<double> const none(Size(c.n), nan);
    FoundDistance found{nan, none, none, none, 0};
    found.status = pw85_nd_distance(c.n, c.r12.data(), c.q1.data(), c.q2.data(), &found.distance,
                                    found.point1.data(), found.point2.data(), found.normal.data());
    return found;
}

/// Σ |n_i q_ij n_j| over 2α, and the point Qn/α with α = √(nᵀQn).
Number support(nd::Row const &normal, std::vector<nd::Row> const &q, nd::Row &point, Number &sum)
{
    point = nd::times(q, normal);
    Number const alpha = sqrt(nd::dot(normal, point));
    for (auto &x : point) x /= alpha;
    for (Size i = 0; i < q.size(); ++i)
        for (Size j = 0; j < q.size(); ++j)
            sum += abs(normal[i] * q[i][j] * normal[j]) / (2 * alpha);
    return alpha;
}

/// Checks a distance by the two bounds that its normal gives, in 50 digits: the width of the slab
/// and the distance of the points of the surfaces along it. Whatever the normal is, the distance is
/// between them; so 4 u Σ between both and the result proves the header's bound.
void check_distance(Failures &failures, Case const &c, FoundDistance const &found)
{
    auto const describe = [&] { return c.text(); };
    failures.check(found.status == PW85_SUCCESS, "status", found.status, 0, describe);
    if (found.status != PW85_SUCCESS) return;
    nd::Row normal(found.normal.begin(), found.normal.end()), p1, p2;
    nd::Row const r(c.r12.begin(), c.r12.end());
    Number const length = sqrt(nd::dot(normal, normal));
    failures.check(abs(length - 1) < 4 * u, "length", double(length), 1, describe);
    for (auto &x : normal) x /= length;
    Number sum = 0;
    for (Size i = 0; i < r.size(); ++i) sum += abs(normal[i] * r[i]);
    Number const alpha = support(normal, nd::blend(c, 1, 0), p1, sum),
                 beta = support(normal, nd::blend(c, 0, 1), p2, sum);
    Number const lower = nd::dot(normal, r) - alpha - beta, d = found.distance;
    Number upper = 0, error1 = 0, error2 = 0;
    for (Size i = 0; i < r.size(); ++i) {
        Number const w = r[i] - p1[i] - p2[i];
        upper += w * w;
        error1 += pow(Number(found.point1[i]) - p1[i], 2);
        error2 += pow(Number(found.point2[i]) - (r[i] - p2[i]), 2);
    }
    upper = sqrt(upper);
    Number const bound = Number(4 * u) * sum;
    failures.check(abs(d - lower) <= bound, "lower", double(lower), double(d), describe);
    failures.check(abs(d - upper) <= bound, "upper", double(upper), double(d), describe);
    // The normal is rounded by u of its length, which moves a point by u times a curvature radius:
    // at most the aspect ratio, 10³ here, times a semi-axis, and n of them.
    Number const size = Number(2000 * c.n * u) * sqrt(nd::dot(r, r));
    failures.check(sqrt(error1) <= size, "point1", double(sqrt(error1)), double(size), describe);
    failures.check(sqrt(error2) <= size, "point2", double(sqrt(error2)), double(size), describe);
}

// Pairs that are apart by 1e-9 to 10 of their size, and pairs that touch.
PW85_TEST("/any_dimension/distance")
{
    Failures failures;
    Random random(85);
    for (int n = 1; n <= PW85_ND_MAX; ++n)
        for (int i = 0; i < draws(n <= 8 ? 48 : 16); ++i) {
            double const aspect = i % 2 ? 30 : 1000;
            Case c = i % 4 == 3 && n > 1 ? nd::thin_case(random, n, aspect)
                                         : nd::random_case(random, n, aspect);
            double const apart = 1 + random.log_uniform(1e-9, 10),
                         scale = apart / std::sqrt(contact(c).mu2);
            for (double &x : c.r12) x *= scale;
            check_distance(failures, c, distance(c));
        }
    for (int n = 1; n <= PW85_ND_MAX; ++n) {
        Case c = touching(random, n, 100);
        FoundDistance found = distance(c);
        g_assert_cmpint(found.status, ==, PW85_SUCCESS);
        double size = 0;
        for (double x : c.r12) size += std::abs(x);
        g_assert_cmpfloat(found.distance, <=, 8 * u * size);
        g_assert_false(std::isnan(found.normal[0]));
        for (double &x : c.r12) x *= 1 - 0x1p-30;
        found = distance(c);
        g_assert_cmpfloat(found.distance, ==, 0);
        g_assert_true(std::isnan(found.normal[0]) && std::isnan(found.point2[0]));
    }
}

/// A pair with a known distance. Let m be a vector of integers. The form p pᵀ + k (mᵀm I - m mᵀ)
/// has the half-width p·m/|m| along m, at the point p. Let j be p1 + p2. With r12 = j + d m, the
/// slab between the ellipsoids that is normal to m has the width d |m|, and touches both on one
/// line along m. So this is the distance. p1 and p2 are integers up to 2^26, j and m are small
/// integers: all entries are exact, and the terms of p1·m cancel.
struct LongPair {
    Case c;
    std::vector<double> normal;
    double distance, half_widths;
};

LongPair long_pair(Random &random, int n, double d)
{
    auto const integer = [&](double low, double high) {
        return std::floor(random.uniform(low, high + 1));
    };
    auto const at = Size(integer(0, n - 1)), next = (at + 1) % Size(n), last = (at + 2) % Size(n);
    std::vector<double> const zero(Size(n), 0.0);
    auto m = zero, p1 = zero, j = zero;
    m[last] = 1, m[next] = 2 * integer(0, 1) - 1, m[at] = 1;
    if (n == 2) m[next] = 2;
    double const share1 = integer(1, 5), share2 = integer(1, 5); // p1·m and p2·m
    for (Size i = 0; i < Size(n); ++i) p1[i] = integer(-0x1p24, 0x1p24), j[i] = integer(-1, 1);
    auto const along = [&](std::vector<double> const &x) {
        return std::inner_product(x.begin(), x.end(), m.begin(), 0.0);
    };
    double const m2 = along(m), norm = std::sqrt(m2);
    p1[at] += share1 - along(p1);
    j[at] += share1 + share2 - along(j);
    double const unit = std::ldexp(1.0, int(integer(-40, 40)));
    LongPair pair{{n, j, {}, {}}, m, d * norm * unit, (share1 + share2) / norm * unit};
    for (Size i = 0; i < Size(n); ++i) {
        pair.c.r12[i] = (j[i] + d * m[i]) * unit;
        pair.normal[i] /= norm;
        for (Size k = i; k < Size(n); ++k) {
            double const rest = (i == k ? m2 : 0) - m[i] * m[k];
            pair.c.q1.push_back((p1[i] * p1[k] + rest) * unit * unit);
            pair.c.q2.push_back(((j[i] - p1[i]) * (j[k] - p1[k]) + 3 * rest) * unit * unit);
        }
    }
    return pair;
}

// Ellipsoids that are up to 10⁸ times as long as r12. Σ is at least the n·r12 of the exact normal
// and half of both half-widths. A normal that errs by δ moves the points apart across it by δ times
// the distance and the eigenvalues of Q/h, which exceed n·r12/2: δ is at most 2^18 u.
PW85_TEST("/any_dimension/distance_of_long_ellipsoids")
{
    Failures failures;
    Random random(91);
    for (int n = 2; n <= PW85_ND_MAX; ++n)
        for (double d : {0.0, 0x1p-40, 0x1p-20, 1.0, 0x1p12}) {
            LongPair const pair = long_pair(random, n, d);
            for (double side : {1.0, -1.0}) {
                Case const c = side > 0 ? pair.c : pair.c.exchanged();
                auto const describe = [&] { return c.text(); };
                FoundDistance const found = distance(c);
                failures.check(found.status == PW85_SUCCESS, "status", found.status, 0, describe);
                double const bound = 4 * u * (pair.distance + 1.5 * pair.half_widths),
                             error = std::abs(found.distance - pair.distance);
                failures.check(error <= bound, "distance", found.distance, pair.distance, describe);
                if (d == 0.0) continue; // they touch
                double off2 = 0, r2 = 0, points = 0;
                for (Size i = 0; i < Size(n); ++i) {
                    double const step = found.distance * found.normal[i];
                    off2 += std::pow(found.point2[i] - found.point1[i] - step, 2);
                    points += std::abs(found.point1[i]) + std::abs(found.point2[i]);
                    r2 += c.r12[i] * c.r12[i];
                    failures.check(std::abs(found.normal[i] - side * pair.normal[i]) <= 0x1p18 * u,
                                   "normal", found.normal[i], side * pair.normal[i], describe);
                }
                double const largest = 0x1p18 * u * std::sqrt(r2) + u * points;
                failures.check(std::sqrt(off2) <= largest, "points", std::sqrt(off2), largest,
                               describe);
            }
        }
}

// A tiny ellipsoid in a large one, and a large one around a tiny one.
PW85_TEST("/any_dimension/inner_range")
{
    std::vector<double> point;
    for (double a : {1e-75, 1.0, 1e75})
        for (double b : {1e-75, 1.0, 1e75})
            for (int n : {1, 5, 16}) {
                Case c{n, std::vector<double>(Size(n)), std::vector<double>(nd::packed_size(n)),
                       std::vector<double>(nd::packed_size(n))};
                for (int i = 0; i < n; ++i) {
                    c.q1[nd::place(n, i, i)] = a * a;
                    c.q2[nd::place(n, i, i)] = b * b;
                }
                c.r12[0] = a / 4;
                g_assert_cmpint(contains(c), ==, b < a);
                Found const found = containment(c, point);
                g_assert_cmpint(found.status, ==, PW85_SUCCESS);
                double const kappa = 0.25 + b / a;
                g_assert_cmpfloat_with_epsilon(found.mu2 / kappa / kappa, 1.0, 1e-14);
                g_assert_cmpfloat_with_epsilon(point[0] / (a / 4 + b), 1.0, 1e-14);
            }
}

PW85_TEST("/any_dimension/status")
{
    Case const c{2, {3, 4}, {1, 0, 1}, {4, 0, 4}};
    double out[2] = {0, 0};
    int answer = 7;
    for (int n : {0, -1, 17, 1 << 30}) {
        g_assert_cmpint(pw85_nd_contact(n, c.r12.data(), c.q1.data(), c.q2.data(), out), ==,
                        PW85_EINVAL);
        g_assert_true(std::isnan(out[0]) && std::isnan(out[1]));
        g_assert_cmpint(pw85_nd_overlap(n, c.r12.data(), c.q1.data(), c.q2.data(), &answer), ==,
                        PW85_EINVAL);
        g_assert_cmpint(answer, ==, -1);
    }
    for (double bad : {nan, HUGE_VAL, -HUGE_VAL}) {
        Case wrong = c;
        wrong.r12[1] = bad;
        g_assert_cmpint(contact(wrong).status, ==, PW85_EINVAL);
        wrong = c;
        wrong.q2[1] = bad;
        g_assert_cmpint(contact(wrong).status, ==, PW85_EINVAL);
    }
    Case const none{2, {0, 0}, {1, 0, 1}, {4, 0, 4}}, negative{2, {3, 4}, {1, 0, -1}, {4, 0, 4}};
    g_assert_cmpint(contact(negative).status, ==, PW85_ENOTPD);
    g_assert_cmpfloat(contact(none).mu2, ==, 0);
    g_assert_cmpfloat(contact(none).lambda, ==, 0.5);
    g_assert_cmpint(sign_of(none, 0), ==, 0);
    g_assert_cmpint(sign_of(none, 1), ==, -1);
    g_assert_cmpint(sign_of(c, 0), ==, 1);
    g_assert_cmpint(sign_of(c, HUGE_VAL), ==, -1);
    g_assert_cmpint(sign_of(c, 25.0 / 9), ==, 1); // rounded down
    g_assert_cmpint(sign_of(c, -1), ==, 100 + PW85_EINVAL);
    g_assert_cmpint(sign_of(c, nan), ==, 100 + PW85_EINVAL);
    g_assert_cmpint(pw85_nd_contact(2, nullptr, c.q1.data(), c.q2.data(), out), ==, PW85_EINVAL);
    double mu2 = 0;
    g_assert_cmpint(pw85_nd_contains(2, nullptr, c.q1.data(), c.q2.data(), &answer), ==,
                    PW85_EINVAL);
    g_assert_cmpint(answer, ==, -1);
    g_assert_cmpint(contains(negative), ==, 100 + PW85_ENOTPD);
    g_assert_cmpint(pw85_nd_containment(2, negative.r12.data(), negative.q1.data(),
                                        negative.q2.data(), &mu2, out),
                    ==, PW85_ENOTPD);
    g_assert_true(std::isnan(mu2) && std::isnan(out[0]) && std::isnan(out[1]));
    g_assert_cmpint(
        pw85_nd_containment(2, c.r12.data(), c.q1.data(), c.q2.data(), nullptr, nullptr), ==,
        PW85_SUCCESS);
    g_assert_cmpint(distance(negative).status, ==, PW85_ENOTPD);
    g_assert_true(std::isnan(distance(negative).distance));
    g_assert_cmpint(
        pw85_nd_distance(2, c.r12.data(), nullptr, c.q2.data(), &mu2, out, nullptr, nullptr), ==,
        PW85_EINVAL);
    g_assert_true(std::isnan(mu2) && std::isnan(out[0]));
    for (double lambda : {-0.1, 1.1, nan})
        g_assert_cmpint(pw85_nd_contact_geometry(2, c.r12.data(), c.q1.data(), c.q2.data(), lambda,
                                                 out, nullptr, nullptr, nullptr, nullptr),
                        ==, PW85_EINVAL);
    g_assert_true(std::isnan(out[0]));
}

// Sizes from 1e-150 to 1e150, of which one ellipsoid may have the one and the other the other.
PW85_TEST("/any_dimension/range")
{
    for (double a : {1e-150, 1e-75, 1.0, 1e150})
        for (double b : {1e-150, 1e-75, 1.0, 1e150})
            for (int n : {1, 4, 16}) {
                Case c{n, std::vector<double>(Size(n)), std::vector<double>(nd::packed_size(n)),
                       std::vector<double>(nd::packed_size(n))};
                for (int i = 0; i < n; ++i) {
                    c.q1[nd::place(n, i, i)] = a * a;
                    c.q2[nd::place(n, i, i)] = b * b;
                }
                c.r12[0] = 2 * (a + b);
                Found const found = contact(c);
                g_assert_cmpint(found.status, ==, PW85_SUCCESS);
                g_assert_cmpfloat_with_epsilon(found.mu2, 4.0, 1e-14);
                g_assert_cmpfloat_with_epsilon(found.lambda, a / (a + b), 1e-14);
                g_assert_cmpint(sign_of(c, 3.9), ==, 1);
                g_assert_cmpint(sign_of(c, 4.1), ==, -1);
            }
}

/// Forms of which some axes are below the smallest normal number if the others are of order one:
/// there is no number, comparisons and definiteness are still exact.
PW85_TEST("/any_dimension/axes_far_apart")
{
    Case c{2,
           {0x1.1c3a1628272aap+314, 0x1.33188b1c077c5p-222},
           {0x1p+630, 0, 0x1.71f6a08a256d2p-444},
           {0x1p+630, 0, 0x1.71f6a08a256d2p-444}};
    // For equal forms μ² is rᵀQ⁻¹r/4; 0x1.4dcd8b544a63ep-2 here, computed with 200 digits.
    g_assert_cmpint(contact(c).status, ==, PW85_ECONVERGENCE);
    g_assert_cmpint(sign_of(c, 0x1.4dcd8b544a63dp-2), ==, 1);
    g_assert_cmpint(sign_of(c, 0x1.4dcd8b544a640p-2), ==, -1);
    // xx yy - xy² < 0
    c = {3,
         {1, 0, 0},
         {0x1p+1000, 0, 0, 0x1.27793c873b748p-24, 0x1.3b356d056f6f2p-24, 0x1.50430ef6b2320p-24},
         {1, 0, 0, 1, 0, 1}};
    g_assert_cmpint(contact(c).status, ==, PW85_ENOTPD);
    g_assert_cmpint(sign_of(c, 1), ==, 100 + PW85_ENOTPD);
}

/// λ rounds to 1 if ellipsoid 1 is much larger; its complement is taken from λ as in three
/// dimensions.
PW85_TEST("/any_dimension/geometry_of_unlike_sizes")
{
    for (bool const exchanged : {false, true}) {
        double const large[] = {0x1p60, 0, 0, 3 * 0x1p60, 0, 5 * 0x1p60},
                     small[] = {0x1p-59, 0, 0, 0x1p-60, 0, 7 * 0x1p-60},
                     r12[] = {3 * 0x1p30, 0x1p30, 2 * 0x1p30};
        double const *const q1 = exchanged ? small : large, *const q2 = exchanged ? large : small;
        double out[2], point[3], normal[3], d_r12[3], expected[6], along = 0;
        g_assert_cmpint(pw85_nd_contact(3, r12, q1, q2, out), ==, PW85_SUCCESS);
        g_assert_cmpint(pw85_nd_contact_geometry(3, r12, q1, q2, out[1], point, normal, d_r12,
                                                 nullptr, nullptr),
                        ==, PW85_SUCCESS);
        g_assert_cmpint(pw85_contact_geometry(r12, q1, q2, out[1], expected, expected + 3), ==,
                        PW85_SUCCESS);
        for (int i = 0; i < 3; ++i) {
            // A few roundings of a well-conditioned pair; points have sizes of 2^30.
            g_assert_cmpfloat_with_epsilon(point[i], expected[i], 64 * u * 0x1p32);
            g_assert_cmpfloat_with_epsilon(normal[i], expected[3 + i], 64 * u);
            along += d_r12[i] * r12[i];
        }
        // μ² is of the second degree in r12.
        g_assert_cmpfloat_with_epsilon(along / out[0], 2.0, 64 * u);
    }
}

// Rows give the bits of single pairs, and a bad row keeps to itself.
PW85_TEST("/any_dimension/batch")
{
    Random random(82);
    for (int n : {1, 3, 6}) {
        std::vector<double> r12, q1, q2, mu2(5), lambda(5), normal(Size(5 * n));
        std::vector<unsigned char> overlap(5);
        std::vector<Case> cases;
        for (int k = 0; k < 5; ++k) {
            cases.push_back(nd::random_case(random, n, 10));
            if (k == 3) cases.back().q2[0] = -1;
            r12.insert(r12.end(), cases.back().r12.begin(), cases.back().r12.end());
            q1.insert(q1.end(), cases.back().q1.begin(), cases.back().q1.end());
            q2.insert(q2.end(), cases.back().q2.begin(), cases.back().q2.end());
        }
        g_assert_cmpint(pw85_nd_contact_batch(5, n, r12.data(), q1.data(), q2.data(), mu2.data(),
                                              lambda.data()),
                        ==, PW85_ENOTPD);
        g_assert_cmpint(
            pw85_nd_overlap_batch(5, n, r12.data(), q1.data(), q2.data(), overlap.data()), ==,
            PW85_ENOTPD);
        lambda[3] = 0.5;
        g_assert_cmpint(pw85_nd_contact_geometry_batch(5, n, r12.data(), q1.data(), q2.data(),
                                                       lambda.data(), nullptr, normal.data(),
                                                       nullptr, nullptr, nullptr),
                        ==, PW85_ENOTPD);
        std::vector<int> sign(5);
        std::vector<double> scale(5), point(Size(5 * n)), one;
        std::vector<unsigned char> inside(5);
        std::vector<double> const limits(5, 1.0);
        g_assert_cmpint(pw85_nd_compare_batch(5, n, r12.data(), q1.data(), q2.data(), limits.data(),
                                              sign.data()),
                        ==, PW85_ENOTPD);
        g_assert_cmpint(
            pw85_nd_contains_batch(5, n, r12.data(), q1.data(), q2.data(), inside.data()), ==,
            PW85_ENOTPD);
        g_assert_cmpint(pw85_nd_containment_batch(5, n, r12.data(), q1.data(), q2.data(),
                                                  scale.data(), point.data()),
                        ==, PW85_ENOTPD);
        std::vector<double> apart(5), normals(Size(5 * n));
        g_assert_cmpint(pw85_nd_distance_batch(5, n, r12.data(), q1.data(), q2.data(), apart.data(),
                                               nullptr, nullptr, normals.data()),
                        ==, PW85_ENOTPD);
        for (Size k = 0; k < 5; ++k) {
            auto const single = distance(cases[k]);
            g_assert_true(k == 3 ? std::isnan(apart[k]) : apart[k] == single.distance);
            double const normal0 = normals[k * Size(n)];
            g_assert_true(std::isnan(normal0) ? std::isnan(single.normal[0])
                                              : normal0 == single.normal[0]);
            g_assert_cmpint(sign[k], ==, k == 3 ? 2 : sign_of(cases[k], 1));
            g_assert_cmpint(inside[k], ==, k == 3 ? 255 : contains(cases[k]));
            g_assert_true(k == 3 ? std::isnan(scale[k])
                                 : scale[k] == containment(cases[k], one).mu2);
            g_assert_true(k == 3 ? std::isnan(point[k * Size(n)]) : point[k * Size(n)] == one[0]);
        }
        for (Size k = 0; k < 5; ++k) {
            Found const found = contact(cases[k]);
            g_assert_true(k == 3 ? std::isnan(mu2[k]) : mu2[k] == found.mu2);
            g_assert_cmpint(overlap[k], ==, k == 3 ? 255 : found.mu2 < 1);
            g_assert_true(std::isnan(normal[k * Size(n)]) == (k == 3));
        }
        g_assert_cmpint(pw85_nd_contact_batch(0, n, nullptr, nullptr, nullptr, nullptr, nullptr),
                        ==, PW85_SUCCESS);
        for (int wrong : {0, 17})
            g_assert_cmpint(
                pw85_nd_contact_batch(0, wrong, nullptr, nullptr, nullptr, nullptr, nullptr), ==,
                PW85_EINVAL);
        g_assert_cmpint(
            pw85_nd_contact_batch(1, n, r12.data(), q1.data(), q2.data(), nullptr, nullptr), ==,
            PW85_EINVAL);
        g_assert_cmpint(pw85_nd_contact_batch(SIZE_MAX, n, r12.data(), q1.data(), q2.data(),
                                              mu2.data(), nullptr),
                        ==, PW85_EINVAL);
    }
}

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
// The proofs of overlap/containment.hpp, each against rational numbers: what floating-point numbers
// prove is true of the numbers exactly as given. The cases are within some roundings of equality,
// where the proofs fail without their margins.
#include <cmath>
#include <limits>

#include <glib.h>

#include <pw85/pw85.hpp>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "oracle/exact_numbers.hpp"
#include "random_pairs.hpp"

using namespace pw85_tests;
using namespace pw85::detail;

namespace {

/// Whether √q2 + r > √q1, for q2, r >= 0.
bool is_longer(Rational const &q1, Rational const &q2, Rational const &r)
{
    Rational const g = q1 - q2 - r * r;
    return g < 0 || 4 * r * r * q2 > g * g;
}

template <int D>
Rational exact_form(pw85::SymmetricMatrix<double, D> const &q, pw85::Vector<double, D> const &n)
{
    Rational sum = 0;
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) sum += Rational(n[i]) * Rational(q(i, j)) * Rational(n[j]);
    return sum;
}

template <class T> T moved(T x, int steps)
{
    T const end = steps < 0 ? T(0) : std::numeric_limits<T>::max();
    for (int k = 0; k < std::abs(steps); ++k) x = std::nextafter(x, end);
    return x;
}

/// q1 within eight numbers of (√q2 + r)². Every third pair is so small that 4 r² q2 and g²
/// underflow.
template <class T> void test_exceeds()
{
    Failures failures;
    Random random(610);
    int const lowest = std::numeric_limits<T>::min_exponent - std::numeric_limits<T>::digits;
    T const smallest = std::numeric_limits<T>::min(), u = std::numeric_limits<T>::epsilon() / 2;
    int shown = 0;
    for (int n = 0; n < draws(24000); ++n) {
        int const unit = n % 3 == 0 ? static_cast<int>(lowest / 4 + random.uniform(-4.0, 16.0)) : 0;
        double const size2 = n % 4 == 0 ? random.log_uniform(1e-30, 1.0) : random.uniform(0.0, 1.0);
        T const q2 = std::ldexp(static_cast<T>(size2), 2 * unit);
        T const r = std::ldexp(static_cast<T>(random.log_uniform(1e-6, 1.0)), unit),
                reach = std::sqrt(q2) + r;
        int const steps = static_cast<int>(random.uniform(-8.0, 9.0));
        T const q1 = moved(T(reach * reach), steps);
        if (!(q1 >= smallest)) continue;
        auto const describe = [&] {
            return hex_text(Sample<T, 2>{{r, 0}, {q1, 0, 1}, {q2, 0, 1}});
        };
        bool const shows = exceeds(q1, q2, r);
        shown += shows;
        failures.check(!shows || is_longer(Rational(q1), Rational(q2), Rational(r)), "exceeds",
                       shows, 0, describe);
        T const clearly = T(reach * reach) * (1 - 40 * u);
        if (r * r * q2 > smallest / u)
            failures.check(exceeds(clearly, q2, r), "exceeds clearly", 0, 1, describe);
    }
    g_assert_cmpint(shown, >, 0);
}

/// Forms Q1 such that nᵀQ1n is near (√nᵀQ2n + |n·r|)². For every other pair the terms of the forms
/// cancel, since n is nearly in the null space, and for the rest those of n·r.
template <int D> void test_outside()
{
    Failures failures;
    Random random(620 + D);
    int shown = 0, count = draws(4000);
    for (int k = 0; k < count; ++k) {
        bool const flat = k % 2 == 0;
        auto const form = random_form<D>(random, 1.0, flat ? random.log_uniform(1.0, 1e6) : 1.0);
        auto const n = product(adjugate(form), random.direction<D>());
        Sample<double, D> s{random.direction<D>(), form,
                            random.log_uniform(flat ? 0.1 : 1e-20, 0.9) * form};
        if (!flat)
            s.r12 = s.r12 - ((1.0 - random.log_uniform(1e-6, 1.0)) * dot(n, s.r12) / dot(n, n)) * n;
        double const form1 = quadratic_form(s.q1, n),
                     form2 = std::fmax(quadratic_form(s.q2, n), 0.0);
        double const reach = std::sqrt(form2) + std::fabs(dot(n, s.r12));
        double const distance =
            random.sign() * random.log_uniform(1e-18, 1e-12) * magnitude_of_form(form, n) / form1;
        s.q1 = ((1.0 + distance) * reach * reach / form1) * s.q1;
        if (!(quadratic_form(s.q1, n) > 0.0)) continue;
        bool const shows = shows_outside(pair_of(s.r12, s.q1, s.q2), n);
        Rational along = 0;
        for (int i = 0; i < D; ++i) along += Rational(n[i]) * Rational(s.r12[i]);
        shown += shows;
        auto const outside = [&] {
            return is_longer(exact_form(s.q1, n), exact_form(s.q2, n), abs(along));
        };
        failures.check(!shows || outside(), "shows_outside", shows, 0, [&] { return hex_text(s); });
    }
    g_test_message("%d of %d shown", shown, count);
    g_assert_cmpint(shown, >, count / 10);
}

/// Whether Sylvester's criterion holds for K(w).
template <int D> bool is_inside(Sample<double, D> const &s, double weight)
{
    Rational k[std::size_t(D)][std::size_t(D)], w = weight;
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
            k[i][j] = Rational(s.q1(i, j)) - (1 + 1 / w) * Rational(s.q2(i, j)) -
                      (1 + w) * Rational(s.r12[i]) * Rational(s.r12[j]);
    for (int p = 0; p < D; ++p) {
        if (k[p][p] <= 0) return false;
        for (int i = p + 1; i < D; ++i)
            for (int j = p + 1; j < D; ++j) k[i][j] -= k[i][p] * k[p][j] / k[p][p];
    }
    return true;
}

/// Forms Q1 that leave a K(w) of 2^-53 to 2^-40 of Q1. The sizes are such that
/// is_clearly_definite() accepts such a matrix.
template <int D> void test_inside()
{
    Failures failures;
    Random random(630 + D);
    double const size = 0x1p10;
    int shown = 0, count = draws(4000);
    for (int n = 0; n < count; ++n) {
        double const w = random.log_uniform(0x1p-20, 0x1p20), share2 = 1.0 + 1.0 / w,
                     share_r = 1.0 + w;
        double const rest = size * std::sqrt(random.log_uniform(0x1p-53, 0x1p-40));
        Sample<double, D> s{
            size * std::sqrt(random.uniform(0.0, 1.0) / share_r) * random.direction<D>(),
            random_form<D>(random, rest, random.log_uniform(1.0, 10.0)),
            (1.0 / share2) * random_form<D>(random, size, random.log_uniform(1.0, 10.0))};
        for (int i = 0; i < D; ++i)
            for (int j = i; j < D; ++j)
                s.q1(i, j) += share2 * s.q2(i, j) + share_r * s.r12[i] * s.r12[j];
        auto const matrices = inner_matrices(pair_of(s.r12, s.q1, s.q2), w);
        pw85::SymmetricMatrix<double, D> k{};
        for (int i = 0; i < k.size; ++i) k[i] = first_of(matrices[i]);
        bool const shows = is_clearly_definite(k);
        shown += shows;
        failures.check(!shows || is_inside(s, w), "inner_matrices", shows, 0,
                       [&] { return hex_text(s); });
    }
    g_test_message("%d of %d shown", shown, count);
    g_assert_cmpint(shown, >, count / 10);
}

PW85_ADD_TEST("/nesting/exceeds/float", test_exceeds<float>);
PW85_ADD_TEST("/nesting/exceeds/double", test_exceeds<double>);
PW85_ADD_TEST("/nesting/outside/2d", test_outside<2>);
PW85_ADD_TEST("/nesting/outside/3d", test_outside<3>);
PW85_ADD_TEST("/nesting/inside/2d", test_inside<2>);
PW85_ADD_TEST("/nesting/inside/3d", test_inside<3>);

} // namespace

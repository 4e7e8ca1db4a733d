// SPDX-License-Identifier: BSD-3-Clause
// Tests of the second derivatives of the contact function. The items are those of
// include/pw85/contact/contact_hessian.hpp.
#include <cmath>

#include <glib.h>

#include <pw85.h>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "rotated.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

template <class T, int D> pw85::ContactHessian<T, D> hessian_of(Sample<T, D> const &p)
{
    return pw85::contact_hessian(p.r12, p.q1, p.q2, pw85::contact(p.r12, p.q1, p.q2).lambda);
}

template <int D> pw85::ContactHessian<double, D> c_hessian(Sample<double, D> const &p)
{
    pw85::ContactHessian<double, D> h{};
    double const *r12 = p.r12.coordinates, *q1 = p.q1.entries, *q2 = p.q2.entries;
    double out[2], *entries = h.entries[0];
    if constexpr (D == 3) {
        pw85_contact(r12, q1, q2, out);
        h.status = static_cast<pw85::Status>(pw85_contact_hessian(r12, q1, q2, out[1], entries));
    } else {
        pw85_contact_2d(r12, q1, q2, out);
        h.status = static_cast<pw85::Status>(pw85_contact_hessian_2d(r12, q1, q2, out[1], entries));
    }
    return h;
}

pw85::SymmetricMatrix<Wide, 3> turned_form(pw85::SymmetricMatrix<Wide, 3> const &q,
                                           Wide const *rotation)
{
    return rotated(q, {rotation[0], rotation[1], rotation[2]});
}

pw85::SymmetricMatrix<Wide, 2> turned_form(pw85::SymmetricMatrix<Wide, 2> const &q,
                                           Wide const *rotation)
{
    auto const turned = rotated({q[0], q[1], 0, q[2], 0, 1}, {0, 0, rotation[0]});
    return {turned[0], turned[1], turned[3]};
}

/// μ² after a change of r12 and both orientations.
template <int D> Wide moved_contact(Sample<Wide, D> p, Wide const *change)
{
    for (int d = 0; d < D; ++d) p.r12[d] += change[d];
    p.q1 = turned_form(p.q1, change + D);
    p.q2 = turned_form(p.q2, change + D + pw85::detail::rotation_axes<D>);
    return pw85::contact(p.r12, p.q1, p.q2).mu2;
}

// Central differences, of second order in h: with h = 1e-10 truncation leaves 1e-20 times
// derivatives of fourth order, which are below 1e5 for aspect ratios up to 4, μ² up to 10 and sizes
// of one; and rounding 1e-50/h².
template <int D> void test_differences()
{
    constexpr int size = pw85::ContactHessian<Wide, D>::size;
    Failures failures;
    Random random(700 + D);
    Wide const h("1e-10");
    for (int n = 0; n < (D == 3 ? 12 : 40); ++n) {
        auto const s = random_pair<D>(random, {.aspect = 4.0, .mu2_min = 0.1, .mu2_max = 10.0});
        auto const p = convert<Wide>(s);
        auto const exact = hessian_of(p);
        auto const at = [&](int i, int si, int j, int sj) {
            Wide change[std::size_t(size)] = {};
            change[i] += si * h;
            change[j] += sj * h;
            return moved_contact(p, change);
        };
        for (int i = 0; i < size; ++i)
            for (int j = i; j < size; ++j) {
                Wide const expected =
                    (at(i, 1, j, 1) - at(i, 1, j, -1) - at(i, -1, j, 1) + at(i, -1, j, -1)) /
                    (4 * h * h);
                double const error = static_cast<double>(
                    pw85::detail::absolute(Wide(exact.entries[i][j] - expected)));
                failures.check(error <= 1e-15, "second derivative", error, 1e-15,
                               [&] { return hex_text(s); });
                failures.check(exact.entries[i][j] == exact.entries[j][i], "symmetry", i, j,
                               [&] { return hex_text(s); });
            }
    }
}

/// The largest error of the entries whose rows and columns are so many rotations together, and the
/// largest true one.
struct BlockError {
    double error, largest;
};

template <int D> BlockError block_error(pw85::ContactHessian<double, D> const &actual,
                                        pw85::ContactHessian<Wide, D> const &exact, int rotations)
{
    BlockError block{0.0, 0.0};
    for (int i = 0; i < actual.size; ++i)
        for (int j = 0; j < actual.size; ++j) {
            if ((i >= D) + (j >= D) != rotations) continue;
            Wide const &expected = exact.entries[i][j];
            block.largest =
                std::fmax(block.largest, static_cast<double>(pw85::detail::absolute(expected)));
            block.error = std::fmax(block.error, static_cast<double>(pw85::detail::absolute(
                                                     Wide(actual.entries[i][j] - expected))));
        }
    return block;
}

/// The same pair in another unit of length.
template <int D> Sample<double, D> in_units(Sample<double, D> s, int exponent)
{
    for (int d = 0; d < D; ++d) s.r12[d] = std::ldexp(s.r12[d], exponent);
    for (int k = 0; k < s.q1.size; ++k) {
        s.q1[k] = std::ldexp(s.q1[k], 2 * exponent);
        s.q2[k] = std::ldexp(s.q2[k], 2 * exponent);
    }
    return s;
}

// λ is a root of f', whose terms cancel: it errs by some roundings over the conditioning of N,
// aspect², and the Hessian by a few times as much, since at fixed forms it depends on λ and 1-λ
// like their powers. Rotations of what is nearly a sphere are differences of terms of the order of
// μ². Half of the pairs are in units of up to 2^±400.
template <int D> void test_rounding_errors()
{
    Failures failures;
    Random random(710 + D);
    for (int n = 0; n < draws(3000); ++n) {
        double const aspect = random.log_uniform(1.0, 100.0), bound = 512 * u * aspect * aspect;
        int const exponent = n % 2 == 0 ? 0 : static_cast<int>(random.uniform(-400.0, 400.0));
        auto const s = in_units(
            random_pair<D>(random, {.aspect = aspect, .mu2_min = 0.1, .mu2_max = 10.0}), exponent);
        auto const exact = hessian_of(convert<Wide>(s));
        auto const actual = c_hessian(s);
        g_assert_true(actual.status == pw85::Status::success);
        double const mu2 = pw85::contact(s.r12, s.q1, s.q2).mu2, distance = norm(s.r12);
        for (int rotations = 0; rotations < 3; ++rotations) {
            auto const [error, largest] = block_error(actual, exact, rotations);
            double const scale = std::fmax(largest, mu2 * std::pow(distance, rotations - 2));
            failures.check(error <= bound * scale, "relative error", error / scale, bound,
                           [&] { return hex_text(s); });
        }
    }
}

/// A pair whose ellipsoid 2 is larger by about 2^exponent, and as far away.
Sample<double, 3> unlike_pair(Random &random, int exponent)
{
    auto s = random_pair<3>(random, {.aspect = 4.0, .mu2_min = 0.1, .mu2_max = 10.0});
    for (int k = 0; k < 6; ++k) s.q2[k] = std::ldexp(s.q2[k], 2 * exponent);
    for (int d = 0; d < 3; ++d) s.r12[d] = std::ldexp(s.r12[d], exponent);
    return s;
}

// An ellipsoid 2 that is much the larger: λ is small, and known as well as ever.
PW85_TEST("/hessian/unlike_sizes")
{
    Failures failures;
    Random random(730);
    for (int n = 0; n < draws(1000); ++n) {
        auto const s = unlike_pair(random, static_cast<int>(random.uniform(0.0, 450.0)));
        auto const exact = hessian_of(convert<Wide>(s));
        auto const actual = c_hessian(s);
        // By ellipsoids and units, since entries for the smaller are the smaller.
        for (int i = 0; i < 9; i += 3)
            for (int j = 0; j < 9; j += 3) {
                double error = 0.0, largest = 0.0;
                for (int k = 0; k < 9; ++k) {
                    Wide const &expected = exact.entries[i + k / 3][j + k % 3];
                    largest =
                        std::fmax(largest, static_cast<double>(pw85::detail::absolute(expected)));
                    error = std::fmax(error,
                                      static_cast<double>(pw85::detail::absolute(
                                          Wide(actual.entries[i + k / 3][j + k % 3] - expected))));
                }
                failures.check(error <= 1e-10 * largest, "block", error / largest, 1e-10,
                               [&] { return hex_text(s); });
            }
    }
}

// What follows from the scalings of μ² and from turning everything: with x = (r12, ω1, ω2), H r12 =
// ∂μ²/∂r12 and twice the torques, as these are of degree 1 and 2 in r12.
PW85_TEST("/hessian/homogeneity")
{
    Failures failures;
    Random random(740);
    for (int n = 0; n < draws(1000); ++n) {
        auto const p = convert<Wide>(random_pair<3>(random, {.aspect = 30.0, .size_ratio = 10.0}));
        Wide const lambda = pw85::contact(p.r12, p.q1, p.q2).lambda;
        auto const h = pw85::contact_hessian(p.r12, p.q1, p.q2, lambda);
        auto const d = pw85::contact_gradient(p.r12, p.q1, p.q2, lambda);
        auto const t = pw85::contact_torque(p.r12, p.q1, p.q2, lambda);
        for (int i = 0; i < 9; ++i) {
            Wide along = 0;
            for (int j = 0; j < 3; ++j) along += h.entries[i][j] * p.r12[j];
            Wide const expected =
                i < 3 ? d.r12[i] : 2 * (i < 6 ? t.rotation1[i - 3] : t.rotation2[i - 6]);
            double const error =
                static_cast<double>(pw85::detail::absolute(Wide(along - expected)));
            failures.check(error <= 1e-30, "along r12", error, 1e-30, [&] { return hex_text(p); });
        }
    }
}

// Spheres with radii a and b: μ² = r²/(a+b)², whatever their orientation.
PW85_TEST("/hessian/spheres")
{
    double const r12[3] = {1.0, 2.0, 2.0}, q1[6] = {4.0, 0.0, 0.0, 4.0, 0.0, 4.0},
                 q2[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    double h[81];
    g_assert_cmpint(pw85_contact_hessian(r12, q1, q2, 2.0 / 3.0, h), ==, PW85_SUCCESS);
    for (int i = 0; i < 9; ++i)
        for (int j = 0; j < 9; ++j)
            g_assert_cmpfloat(std::fabs(h[9 * i + j] - (i == j && i < 3 ? 2.0 / 9.0 : 0.0)), <=,
                              16 * u);
}

// Two like spheroids end to end, with semi-axes c along z and a across. Turning one by θ about x
// changes its half-width along z to √(c² cos²θ + a² sin²θ), and that of the pair along any other
// direction by symmetry: with both turned alike, μ² = r²/(4 h²), where 1/h² = cos²θ/c² + sin²θ/a²,
// the form's inverse along z.
PW85_TEST("/hessian/turned_alike")
{
    double const a = 1.0, c = 2.0, r = 6.0;
    double const r12[3] = {0.0, 0.0, r}, q[6] = {a * a, 0.0, 0.0, a * a, 0.0, c * c};
    double h[81];
    g_assert_cmpint(pw85_contact_hessian(r12, q, q, 0.5, h), ==, PW85_SUCCESS);
    double const both = h[9 * 3 + 3] + 2 * h[9 * 3 + 6] + h[9 * 6 + 6];
    g_assert_cmpfloat(std::fabs(both - r * r / 4 * 2 * (1 / (a * a) - 1 / (c * c))), <=,
                      64 * u * both);
    g_assert_cmpfloat(std::fabs(h[9 * 2 + 2] - 2 / (4 * c * c)), <=, 8 * u);
}

// λ at the ends, which no maximiser is; concentric ellipsoids have no second derivatives.
PW85_TEST("/hessian/ends")
{
    double const r12[3] = {1.0, -2.0, 2.0}, zero[3] = {0.0, 0.0, 0.0},
                 q[6] = {4.0, 0.5, 0.0, 3.0, 0.0, 2.0};
    double h[81];
    for (double const end : {0.0, 0x1p-1074, 1.0}) {
        g_assert_cmpint(pw85_contact_hessian(r12, q, q, end, h), ==, PW85_SUCCESS);
        for (double const x : h) g_assert_true(std::isfinite(x));
    }
    g_assert_cmpint(pw85_contact_hessian(zero, q, q, 0.5, h), ==, PW85_EINVAL);
    for (double const x : h) g_assert_true(std::isnan(x));
}

PW85_ADD_TEST("/hessian/differences/3d", test_differences<3>);
PW85_ADD_TEST("/hessian/differences/2d", test_differences<2>);
PW85_ADD_TEST("/hessian/rounding_errors/3d", test_rounding_errors<3>);
PW85_ADD_TEST("/hessian/rounding_errors/2d", test_rounding_errors<2>);

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
// Surfaces, second moments and tensors of inertia (include/pw85/bodies/), against Boost's R_G and
// R_D in 50 digits of eigenvalues that the cubic formula finds in 100 digits, against quadrature
// over the sphere, and against closed forms of spheroids.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85/pw85.hpp>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "wide.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rg.hpp>
#pragma GCC diagnostic pop

using namespace pw85_tests;

namespace {

using Widest = Multiprecision<100>;
using Form2 = pw85::SymmetricMatrix<double, 2>;
using Matrix = pw85::SymmetricMatrix<Widest, 3>;

double const u = 0x1p-53;

/// The largest of the numbers that it is told, such as errors in units of a bound.
class Largest {
  public:
    explicit Largest(char const *name) : name_(name) {}
    ~Largest() { g_test_message("largest %s: %.4f", name_, value_); }
    Largest(Largest const &) = delete;
    Largest &operator=(Largest const &) = delete;

    void include(double value) { value_ = std::max(value_, value); }

  private:
    char const *name_;
    double value_ = 0;
};

/// The eigenvalues of a matrix by the cubic formula, the largest one first.
std::vector<Widest> eigenvalues(Matrix const &a)
{
    Widest const mean = (a[0] + a[3] + a[5]) / 3;
    Matrix b = a;
    for (int i = 0; i < 3; ++i) b(i, i) -= mean;
    Widest const p = sqrt(
        (b[0] * b[0] + b[3] * b[3] + b[5] * b[5] + 2 * (b[1] * b[1] + b[2] * b[2] + b[4] * b[4])) /
        6);
    Widest const half = pw85::detail::determinant(b, pw85::detail::adjugate(b)) / (2 * p * p * p);
    Widest const rest = 1 - half * half;
    Widest const angle = atan2(sqrt(rest > 0 ? rest : Widest(0)), half) / 3,
                 third = 2 * atan2(Widest(0), Widest(-1)) / 3;
    return {mean + 2 * p * cos(angle), mean + 2 * p * cos(angle - third),
            mean + 2 * p * cos(angle + third)};
}

/// The area of the ellipsoid and the mean of x² over it along its axes, of squares of semi-axes.
struct SheetTruth {
    Wide area;
    std::vector<Wide> moments;
};

SheetTruth sheet_truth(std::vector<Widest> const &squares)
{
    Wide p[3], size = 1;
    for (int i = 0; i < 3; ++i) {
        Wide const square(squares[static_cast<std::size_t>(i)]);
        p[i] = 1 / square;
        size *= sqrt(square);
    }
    Wide const r_g = boost::math::ellint_rg(p[0], p[1], p[2]), pi = atan2(Wide(0), Wide(-1));
    SheetTruth truth{4 * pi * size * r_g, {}};
    Wide parts[3];
    for (int i = 0; i < 3; ++i)
        parts[i] = p[i] * boost::math::ellint_rd(p[(i + 1) % 3], p[(i + 2) % 3], p[i]);
    for (int i = 0; i < 3; ++i)
        truth.moments.push_back(1 / (4 * p[i]) +
                                (parts[(i + 1) % 3] + parts[(i + 2) % 3]) / (24 * r_g));
    return truth;
}

/// The matrix with the eigenvectors of another one, by Lagrange's polynomial.
Matrix function_of(Matrix const &a, std::vector<Widest> const &eigen,
                   std::vector<Wide> const &values)
{
    Matrix sum{};
    for (std::size_t k = 0; k < 3; ++k) {
        Widest const x = eigen[(k + 1) % 3], y = eigen[(k + 2) % 3],
                     weight = Widest(values[k]) / ((eigen[k] - x) * (eigen[k] - y));
        for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j) {
                Widest entry = i == j ? Widest(x * y) : Widest(0);
                for (int l = 0; l < 3; ++l) entry += a(i, l) * a(l, j);
                sum(i, j) += weight * (entry - (x + y) * a(i, j));
            }
    }
    return sum;
}

double relative_error(double found, Wide const &exact)
{
    return static_cast<double>(Wide(abs(Wide(found) / exact - 1)));
}

Widest volume_truth(Matrix const &q)
{
    Widest const det = pw85::detail::determinant(q, pw85::detail::adjugate(q));
    return 4 * atan2(Widest(0), Widest(-1)) * sqrt(det) / 3;
}

/// The volume times (tr(Q) I - Q)/5. The relative error is below `bound`. Returns the largest one.
double check_solid_inertia(Failures &failures, Form3 const &q, Matrix const &exact, double bound)
{
    double worst = 0;
    Widest const mass = volume_truth(exact), trace = exact[0] + exact[3] + exact[5];
    Form3 found;
    g_assert_cmpint(pw85_inertia(q.entries, 0, found.entries), ==, PW85_SUCCESS);
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) {
            Widest const wanted = mass * ((i == j ? trace : Widest(0)) - exact(i, j)) / 5;
            Widest const away = abs(Widest(found(i, j) - wanted)), size = abs(wanted);
            failures.check(away <= bound * size, "solid", found(i, j), static_cast<double>(wanted),
                           [&] { return "q = " + hex_text(q.entries, 6); });
            worst = std::max(worst, static_cast<double>(Widest(away / size)));
        }
    return worst;
}

/// Compares entries with their truth. The bound is `entry` times the entry, plus `rest`; `most`
/// receives the errors in units of it.
template <class Describe> void check_entries(Failures &failures, Largest &most, double const *found,
                                             Matrix const &wanted, double entry, double rest,
                                             Describe const &describe)
{
    for (int k = 0; k < 6; ++k) {
        double const bound = entry * std::abs(found[k]) + rest,
                     away = std::abs(static_cast<double>(Widest(found[k] - wanted[k])));
        failures.check(away <= bound, "entry", found[k], bound, describe);
        most.include(away / bound);
    }
}

/// Areas, moments and tensors of inertia of random shapes, sizes and directions.
PW85_TEST("/bodies/random")
{
    Failures failures;
    Random random(20261129);
    Largest areas("error of an area in u"), solids("relative error of solid inertia in u"),
        moments_of("error of second moments in their bound"),
        shells("error of moments of a shell in their bound"),
        inertias("error of the inertia of a shell in its bound");
    for (int n = 0; n < draws(100000); ++n) {
        double const aspect = random.log_uniform(1.0, 1e6),
                     size = std::exp2(std::floor(random.uniform(-40.0, 41.0)));
        Form3 const q = random.form(size * random.uniform(1.0, 2.0), aspect);
        auto const describe = [&] { return "q = " + hex_text(q.entries, 6); };
        Matrix const exact = convert<Widest>(q);
        auto const eigen = eigenvalues(exact);
        auto const truth = sheet_truth(eigen);
        // The bounds of pw85_grains.h.
        double const lost = std::ldexp(static_cast<double>(eigen[0] / eigen[2]), -98);
        double area, moments[6], inertia[6], solid[6];
        g_assert_cmpint(pw85_surface_area(q.entries, &area), ==, PW85_SUCCESS);
        double const error = relative_error(area, truth.area);
        failures.check(error <= u + lost, "area", error, u + lost, describe);
        areas.include(error / u);
        pw85_second_moments(q.entries, solid);
        check_entries(failures, moments_of, solid, (Widest(1) / 5) * exact, u, 0, describe);
        pw85_shell_moments(q.entries, moments);
        pw85_inertia(q.entries, 1, inertia);
        auto const wanted = function_of(exact, eigen, truth.moments);
        double const largest = static_cast<double>(truth.moments[0]);
        check_entries(failures, shells, moments, wanted, u, lost * largest, describe);
        Widest const trace = wanted[0] + wanted[3] + wanted[5], mass(truth.area);
        Matrix tensor{};
        for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j)
                tensor(i, j) = mass * ((i == j ? trace : Widest(0)) - wanted(i, j));
        check_entries(failures, inertias, inertia, tensor, 4 * u,
                      lost * static_cast<double>(mass * trace), describe);
        solids.include(check_solid_inertia(failures, q, exact, 4 * u + lost) / u);
    }
}

/// Volumes of needles, of discs and of shapes between them, with aspect ratios up to 10⁷.
PW85_TEST("/bodies/volumes")
{
    Failures failures;
    Random random(20261130);
    Largest volumes("relative error of a volume in u");
    for (int n = 0; n < draws(100000); ++n) {
        double const aspect = random.log_uniform(1.0, 1e7),
                     third = n % 3 == 0   ? aspect
                             : n % 3 == 1 ? 1.0
                                          : random.log_uniform(1.0, aspect);
        pw85::Vector<double, 3> const axes =
            std::exp2(40.0 * (n % 5 - 2)) * pw85::Vector<double, 3>{1 / third, 1, 1 / aspect};
        Form3 const q = pw85::ellipsoid_quaternion(axes, random.direction<4>()).q;
        double volume = 0;
        if (pw85_volume(q.entries, &volume) != PW85_SUCCESS) continue;
        Widest const wanted = volume_truth(convert<Widest>(q));
        Widest const away = abs(Widest(volume - wanted));
        failures.check(away <= 0x1p-52 * wanted, "volume", volume, static_cast<double>(wanted),
                       [&] { return "q = " + hex_text(q.entries, 6); });
        volumes.include(static_cast<double>(Widest(away / wanted)) / u);
    }
}

/// Nodes and weights of Gauss's rule on [-1, 1], by Newton's method on Legendre's polynomial.
void gauss_rule(int n, std::vector<Wide> &nodes, std::vector<Wide> &weights)
{
    for (int k = 0; k < n; ++k) {
        Wide x = std::cos(std::numbers::pi * (k + 0.75) / (n + 0.5)), slope = 0;
        for (int step = 0; step < 7; ++step) {
            Wide before = 1, at = x;
            for (int i = 2; i <= n; ++i) {
                Wide const next = ((2 * i - 1) * x * at - (i - 1) * before) / i;
                before = at;
                at = next;
            }
            slope = n * (x * at - before) / (x * x - 1);
            x -= at / slope;
        }
        nodes.push_back(x);
        weights.push_back(2 / ((1 - x * x) * slope * slope));
    }
}

/// The mean of x_i² over the surface by Gauss's rule in cos θ and the trapezoidal rule in φ.
std::vector<Wide> mean_squares(std::vector<Wide> const &axes, int count)
{
    std::vector<Wide> nodes, weights, sums(4, Wide(0));
    gauss_rule(count, nodes, weights);
    Wide const pi = atan2(Wide(0), Wide(-1));
    for (std::size_t k = 0; k < nodes.size(); ++k)
        for (int m = 0; m < 2 * count; ++m) {
            Wide const ring = sqrt(1 - nodes[k] * nodes[k]), angle = pi * m / count;
            Wide const n[] = {ring * cos(angle), ring * sin(angle), nodes[k]};
            Wide square = 0;
            for (std::size_t i = 0; i < 3; ++i) square += n[i] * n[i] / (axes[i] * axes[i]);
            Wide const weight = weights[k] * sqrt(square);
            sums[3] += weight;
            for (std::size_t i = 0; i < 3; ++i) sums[i] += weight * n[i] * n[i];
        }
    for (std::size_t i = 0; i < 3; ++i) sums[i] *= axes[i] * axes[i] / sums[3];
    return sums;
}

/// The rules converge like ρ^(-2·40) with ρ >= 3 for these axes, to far below u.
PW85_TEST("/bodies/quadrature")
{
    Failures failures;
    for (auto const &axes : {std::vector<Wide>{1.0, 0.875, 0.75},
                             {1.25, 1.0, 1.0},
                             {1.0, 1.0, 1.375},
                             {0.75, 1.0, 1.125}}) {
        auto const wanted = mean_squares(axes, 40);
        double const a[] = {static_cast<double>(axes[0]), static_cast<double>(axes[1]),
                            static_cast<double>(axes[2])};
        auto const describe = [&] { return "axes = " + hex_text(a, 3); };
        double const q[] = {a[0] * a[0], 0, 0, a[1] * a[1], 0, a[2] * a[2]};
        double moments[6];
        g_assert_cmpint(pw85_shell_moments(q, moments), ==, PW85_SUCCESS);
        for (std::size_t i = 0; i < 3; ++i) {
            double const found = moments[i == 0 ? 0 : 2 * i + 1];
            double const error = relative_error(found, wanted[i]);
            failures.check(error <= u, "mean square", found, u, describe);
        }
    }
}

/// Spheroids, whose areas are elementary, at any aspect ratio; axes along the coordinates.
PW85_TEST("/bodies/spheroids")
{
    Failures failures;
    Wide const pi = atan2(Wide(0), Wide(-1));
    for (int n = -60; n <= 60; ++n) {
        if (n == 0) continue;
        double const c = std::exp2(n), q[] = {1, 0, 0, 1, 0, c * c};
        Wide const e = sqrt(abs(Wide(1) - (n < 0 ? Wide(c) * c : 1 / (Wide(c) * c))));
        // Oblate: 2π (1 + c² artanh(e)/e); prolate: 2π (1 + c arcsin(e)/e).
        Wide const part = n < 0
                              ? Wide(Wide(c) * c * log((1 + e) / (Wide(c) / (1 + e) * c)) / (2 * e))
                              : Wide(c * atan2(e, Wide(1) / c) / e);
        double area;
        g_assert_cmpint(pw85_surface_area(q, &area), ==, PW85_SUCCESS);
        double const error = relative_error(area, 2 * pi * (1 + part)), bound = u + 0x1p-98;
        failures.check(error <= bound, "area", area, bound, [&] { return hex_text(q, 6); });
    }
}

/// Perimeters and moments of wires: Boost's complete integrals, and Σ ⟨x_i²⟩/a_i² = 1.
PW85_TEST("/bodies/plane")
{
    Failures failures;
    Random random(20261130);
    Largest perimeters("error of a perimeter in u"), areas("error of an area in the plane in u"),
        wires("error of the moments of a wire in their bound");
    for (int n = 0; n < draws(100000); ++n) {
        double const size = std::exp2(std::floor(random.uniform(-40.0, 41.0)));
        Form2 const q = random_form<2>(random, size, random.log_uniform(1.0, 1e6));
        auto const describe = [&] { return "q = " + hex_text(q.entries, 3); };
        Widest const xx = q[0], xy = q[1], yy = q[2], half = (xx - yy) / 2,
                     large = (xx + yy) / 2 + sqrt(half * half + xy * xy),
                     small = (xx * yy - xy * xy) / large;
        double const lost = std::ldexp(static_cast<double>(large / small), -98);
        double perimeter, moments[3], solid[3];
        g_assert_cmpint(pw85_perimeter_2d(q.entries, &perimeter), ==, PW85_SUCCESS);
        Wide const exact = 8 * boost::math::ellint_rg(Wide(0), Wide(large), Wide(small));
        double const error = relative_error(perimeter, exact);
        failures.check(error <= u + lost, "perimeter", error, u + lost, describe);
        perimeters.include(error / u);
        double area;
        g_assert_cmpint(pw85_area_2d(q.entries, &area), ==, PW85_SUCCESS);
        Widest const disc = atan2(Widest(0), Widest(-1)) * sqrt(large * small);
        double const wrong = static_cast<double>(Widest(abs(Widest(area - disc)) / disc));
        failures.check(wrong <= 2 * u, "area", area, static_cast<double>(disc), describe);
        areas.include(wrong / u);
        pw85_shell_moments_2d(q.entries, moments);
        pw85_second_moments_2d(q.entries, solid);
        // tr(Q⁻¹M), whose error is that of the entries by Q⁻¹.
        Widest const inverse[] = {yy, -xy, xx}, det = xx * yy - xy * xy;
        Widest sum = 0;
        double bound = 0;
        for (int k = 0; k < 3; ++k) {
            Widest const factor = (k == 1 ? 2 : 1) * inverse[k] / det;
            sum += factor * moments[k];
            bound += static_cast<double>(abs(factor)) *
                     (u * std::abs(moments[k]) + lost * static_cast<double>(large));
            failures.check(std::abs(4 * solid[k] - q[k]) <= 2 * u * std::abs(q[k]), "solid",
                           solid[k], q[k], describe);
        }
        double const away = std::abs(static_cast<double>(sum - 1));
        failures.check(away <= bound, "tr(Q⁻¹M) - 1", away, bound, describe);
        wires.include(away / bound);
    }
}

/// Solid bodies, at sizes near the ends of the range, and what is refused.
PW85_TEST("/bodies/limits")
{
    double const flat[] = {1, 0, 0, 1, 0, 0};
    double const nan_form[] = {1, 0, 0, std::nan(""), 0, 1};
    double area, inertia[6];
    g_assert_cmpint(pw85_surface_area(flat, &area), ==, PW85_ENOTPD);
    g_assert_true(std::isnan(area));
    g_assert_cmpint(pw85_inertia(nan_form, 1, inertia), ==, PW85_EINVAL);
    g_assert_true(std::isnan(inertia[0]) && std::isnan(inertia[5]));
    for (int e : {-490, -300, 300, 490}) {
        double const unit = std::ldexp(1.0, 2 * e);
        double const q[] = {unit, 0, 0, 4 * unit, 0, 9 * unit};
        double const one[] = {1, 0, 0, 4, 0, 9};
        double expected;
        g_assert_cmpint(pw85_surface_area(q, &area), ==, PW85_SUCCESS);
        pw85_surface_area(one, &expected);
        g_assert_true(area == std::ldexp(expected, 2 * e));
    }
    for (int e : {-190, -40, 0, 40, 190}) {
        double const unit = std::ldexp(1.0, 2 * e),
                     mass = 8 * std::numbers::pi * std::ldexp(1.0, 3 * e);
        double const q[] = {unit, 0, 0, 4 * unit, 0, 9 * unit};
        g_assert_cmpint(pw85_inertia(q, 0, inertia), ==, PW85_SUCCESS);
        g_assert_cmpfloat_with_epsilon(inertia[0] / mass / unit, 13.0 / 5, 13.0 / 5 * 8 * u);
        g_assert_cmpfloat_with_epsilon(inertia[3] / mass / unit, 2.0, 2.0 * 8 * u);
        g_assert_cmpfloat_with_epsilon(inertia[5] / mass / unit, 1.0, 8 * u);
        g_assert_true(inertia[1] == 0 && inertia[2] == 0 && inertia[4] == 0);
    }
}

/// Moments beyond the range of double are infinite or zero, and products that are zero stay so.
PW85_TEST("/bodies/out_of_range")
{
    for (int const shell : {0, 1})
        for (int const e : {-900, 900}) {
            double const unit = std::ldexp(1.0, e), q[] = {unit, 0, 0, unit, 0, unit};
            double inertia[6];
            g_assert_cmpint(pw85_inertia(q, shell, inertia), ==, PW85_SUCCESS);
            for (int k : {0, 3, 5}) g_assert_cmpfloat(inertia[k], ==, e > 0 ? HUGE_VAL : 0.0);
            for (int k : {1, 2, 4}) g_assert_cmpfloat(inertia[k], ==, 0.0);
        }
}

/// The form of given second moments: 5 or 4 times these, for sizes whose squares are near the ends
/// of the range, too. What is not definite has no form.
template <int D> void check_from_moments()
{
    Failures failures;
    Random random(20261130 + D);
    for (int n = 0; n < draws(4000); ++n) {
        double const size = std::exp2(std::floor(random.uniform(-480.0, 480.0)));
        auto const moments = random_form<D>(random, size, random.log_uniform(1.0, 1e4));
        auto const describe = [&] {
            return "moments = " + hex_text(moments.entries, moments.size);
        };
        auto q = moments;
        int const status =
            (D == 3 ? pw85_from_moments : pw85_from_moments_2d)(moments.entries, q.entries);
        failures.check(status == PW85_SUCCESS, "status", status, PW85_SUCCESS, describe);
        for (int k = 0; k < moments.size; ++k) {
            Wide const away = abs(Wide(Wide(q[k]) - (D + 2) * Wide(moments[k])));
            failures.check(away <= u * abs(Wide(q[k])), "entry", q[k], (D + 2) * moments[k],
                           describe);
        }
    }
}

PW85_TEST("/bodies/from_moments")
{
    check_from_moments<3>();
    check_from_moments<2>();
    double const flat[6] = {1, 0, 0, 1, 0, 0}, indefinite[3] = {1, 2, 1},
                 huge[6] = {1e308, 0, 0, 1e308, 0, 1e308};
    double q[6];
    g_assert_cmpint(pw85_from_moments(flat, q), ==, PW85_ENOTPD);
    g_assert_true(std::isnan(q[0]) && std::isnan(q[5]));
    g_assert_cmpint(pw85_from_moments_2d(indefinite, q), ==, PW85_ENOTPD);
    g_assert_cmpint(pw85_from_moments(huge, q), ==, PW85_EINVAL);
    g_assert_true(std::isnan(q[0]));
}

} // namespace

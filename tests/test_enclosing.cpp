// SPDX-License-Identifier: BSD-3-Clause
// Tests of the smallest ellipsoid around points against closed forms, and against an iteration that
// shares nothing with the library, in 100 digits.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <glib.h>

#include <pw85/enclosing.hpp>

#include "any_dimension_truth.hpp"
#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "oracle/multiprecision.hpp"
#include "sample.hpp"

using namespace pw85_tests;

namespace {

using Number = Multiprecision<100>;
using Numbers = std::vector<double>;
using Matrix = std::vector<std::vector<Number>>; // symmetric
constexpr double u = 0x1p-53;

/// Points in n dimensions, row by row.
struct Cloud {
    int n;
    Numbers points;

    std::size_t size() const { return points.size() / static_cast<std::size_t>(n); }
    double const *row(std::size_t i) const { return &points[i * static_cast<std::size_t>(n)]; }
    void add(Numbers const &point) { points.insert(points.end(), point.begin(), point.end()); }
    std::string text() const
    {
        int const shown = static_cast<int>(std::min<std::size_t>(points.size(), 96));
        return "n = " + std::to_string(n) + ", m = " + std::to_string(size()) + ", points " +
               hex_text(points.data(), shown);
    }
};

struct Found {
    int status;
    Numbers center, q;
    double excess;

    double entry(int i, int j) const { return q[nd::place(static_cast<int>(center.size()), i, j)]; }
    Matrix form() const
    {
        std::size_t const n = center.size();
        Matrix a(n, std::vector<Number>(n));
        for (std::size_t i = 0, k = 0; i < n; ++i)
            for (std::size_t j = i; j < n; ++j, ++k) a[i][j] = a[j][i] = Number(q[k]);
        return a;
    }
};

Found find(Cloud const &cloud, double tolerance)
{
    auto const n = static_cast<std::size_t>(cloud.n);
    Found found{0, Numbers(n), Numbers(n * (n + 1) / 2), 0.0};
    found.status = pw85_enclosing_ellipsoid(cloud.n, cloud.size(), cloud.points.data(), tolerance,
                                            found.center.data(), found.q.data(), &found.excess);
    return found;
}

/// Gaussian elimination of a definite matrix and of right-hand sides, which become L⁻¹ b. Returns
/// the pivots.
std::vector<Number> eliminate(Matrix &a, Matrix &rows)
{
    std::size_t const n = a.size();
    std::vector<Number> pivots;
    for (std::size_t k = 0; k < n; ++k) {
        pivots.push_back(a[k][k]);
        for (std::size_t i = k + 1; i < n; ++i) {
            Number const f = a[i][k] / a[k][k];
            for (std::size_t j = k; j < n; ++j) a[i][j] -= f * a[k][j];
            for (auto &b : rows) b[i] -= f * b[k];
        }
    }
    return pivots;
}

Number determinant(Matrix a)
{
    Matrix none;
    Number product(1);
    for (Number const &pivot : eliminate(a, none)) product *= pivot;
    return product;
}

/// (x - c)ᵀ Q⁻¹ (x - c) of each point.
std::vector<Number> squares(Cloud const &cloud, std::vector<Number> const &center, Matrix a)
{
    Matrix rows(cloud.size(), center);
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t k = 0; k < center.size(); ++k)
            rows[i][k] = Number(cloud.row(i)[k]) - center[k];
    auto const pivots = eliminate(a, rows);
    std::vector<Number> all;
    for (auto const &z : rows) {
        Number sum(0);
        for (std::size_t k = 0; k < z.size(); ++k) sum += z[k] * z[k] / pivots[k];
        all.push_back(sum);
    }
    return all;
}

/// Compares the sizes of two ellipsoids around the same bodies with what is proved about them.
template <class Text>
void check_excesses(Failures &failures, Found const &rough, Found const &fine, Text const &text)
{
    Number const ratio = sqrt(determinant(rough.form()) / determinant(fine.form()));
    failures.check(ratio <= Number(1 + rough.excess), "rough", static_cast<double>(ratio),
                   rough.excess, text);
    failures.check(1 <= ratio * Number(1 + fine.excess), "fine", static_cast<double>(ratio),
                   fine.excess, text);
}

/// Every point is inside, with no allowance: 100 digits decide it.
void check_inside(Failures &failures, Cloud const &cloud, Found const &found)
{
    std::vector<Number> const center(found.center.begin(), found.center.end());
    auto const all = squares(cloud, center, found.form());
    double const largest = static_cast<double>(*std::max_element(all.begin(), all.end()) - 1);
    failures.check(largest <= 0.0, "outside by", largest, 0.0, [&] { return cloud.text(); });
}

/// The volume is between the least and 1 + excess times that, where the least has a closed form.
void check_least(Failures &failures, Cloud const &cloud, Matrix const &least, double tolerance)
{
    Found const found = find(cloud, tolerance);
    auto const text = [&] { return cloud.text() + ", tolerance " + std::to_string(tolerance); };
    failures.check(found.status == PW85_SUCCESS, "status", found.status, 0.0, text);
    if (found.status != PW85_SUCCESS) return;
    check_inside(failures, cloud, found);
    using std::sqrt;
    Number const ratio = sqrt(determinant(found.form()) / determinant(least)) - 1;
    double const excess = static_cast<double>(ratio);
    failures.check(excess >= 0.0, "below the least", excess, 0.0, text);
    failures.check(ratio <= Number(found.excess), "above 1 + excess", excess, found.excess, text);
    failures.check(found.excess <= tolerance, "excess", found.excess, tolerance, text);
}

/// Σ of the rows of a lower triangle with a unit diagonal and small integers below it, times axes.
struct Map {
    std::vector<Numbers> l;
    Numbers center;

    Map(std::mt19937 &random, int n, bool with_shear)
    {
        auto const size = static_cast<std::size_t>(n);
        l.assign(size, Numbers(size, 0.0));
        for (std::size_t i = 0; i < size; ++i) {
            center.push_back(static_cast<double>(random() % 9) - 4.0);
            l[i][i] = std::ldexp(static_cast<double>(1 + random() % 3),
                                 static_cast<int>(random() % 80) - 40);
            for (std::size_t j = 0; with_shear && j < i; ++j)
                if (random() % size < 2) l[i][j] = l[i][i] * (random() % 2 == 0 ? 0.5 : -0.25);
        }
        for (std::size_t i = 0; i < size; ++i) center[i] *= l[i][i];
    }

    /// x = c + D L y, where D L has the rows of the triangle: exact for small integers y.
    Numbers apply(Numbers const &y) const
    {
        Numbers x = center;
        for (std::size_t i = 0; i < y.size(); ++i)
            for (std::size_t j = 0; j <= i; ++j) x[i] += l[i][j] * y[j];
        return x;
    }

    /// The image of the ball with this square of the radius.
    Matrix image(Number const &square) const
    {
        std::size_t const n = l.size();
        Matrix a(n, std::vector<Number>(n, Number(0)));
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j)
                for (std::size_t k = 0; k <= std::min(i, j); ++k)
                    a[i][j] += square * Number(l[i][k]) * Number(l[j][k]);
        return a;
    }
};

int random_dimension(std::mt19937 &random, int most = 16)
{
    return 1 + static_cast<int>(random() % static_cast<unsigned>(most));
}

constexpr double tolerances[] = {1.0, 1e-3, 1e-7, 1e-11};

/// Images of all vertices of the cube, whose ellipsoid is the image of the ball of radius √n.
PW85_TEST("/enclosing/boxes")
{
    Failures failures;
    std::mt19937 random(1);
    for (int draw = 0; draw < draws(60); ++draw) {
        int const n = random_dimension(random, 8);
        Map const map(random, n, true);
        Cloud cloud{n, {}};
        for (unsigned vertex = 0; vertex < 1u << n; ++vertex) {
            Numbers y;
            for (int k = 0; k < n; ++k) y.push_back(vertex >> k & 1 ? 1.0 : -1.0);
            cloud.add(map.apply(y));
        }
        check_least(failures, cloud, map.image(Number(n)), tolerances[draw % 4]);
    }
}

/// Images of the vertices of the cross-polytope, each several times, and of points within.
PW85_TEST("/enclosing/cross_polytopes")
{
    Failures failures;
    std::mt19937 random(2);
    for (int draw = 0; draw < draws(160); ++draw) {
        int const n = random_dimension(random);
        Map const map(random, n, true);
        Cloud cloud{n, {}};
        for (int k = 0; k < 2 * n; ++k)
            for (auto copies = 1 + random() % 3; copies-- > 0;) {
                Numbers y(static_cast<std::size_t>(n), 0.0);
                y[static_cast<std::size_t>(k / 2)] = k % 2 == 0 ? 1.0 : -1.0;
                cloud.add(map.apply(y));
                y[random() % y.size()] *= 0.5;
                cloud.add(map.apply(y));
            }
        check_least(failures, cloud, map.image(Number(1)), tolerances[draw % 4]);
    }
}

/// The smallest ellipsoid around n + 1 points: all weights are 1/(n + 1).
Matrix around_simplex(Cloud const &cloud)
{
    auto const size = static_cast<std::size_t>(cloud.n);
    int const n = cloud.n;
    std::vector<Number> mean(size, Number(0));
    Matrix form(size, mean);
    for (std::size_t i = 0; i <= size; ++i)
        for (std::size_t k = 0; k < size; ++k) mean[k] += Number(cloud.row(i)[k]) / (n + 1);
    for (std::size_t i = 0; i <= size; ++i)
        for (std::size_t k = 0; k < size; ++k)
            for (std::size_t l = 0; l < size; ++l)
                form[k][l] += (Number(cloud.row(i)[k]) - mean[k]) *
                              (Number(cloud.row(i)[l]) - mean[l]) * n / (n + 1);
    return form;
}

PW85_TEST("/enclosing/simplices")
{
    Failures failures;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int draw = 0; draw < draws(160); ++draw) {
        int const n = random_dimension(random);
        Cloud cloud{n, {}};
        for (int i = 0; i < n + 1; ++i)
            for (int k = 0; k < n; ++k)
                cloud.points.push_back(
                    std::ldexp(uniform(random) + (k == i ? 4.0 : 0.0), draw % 81 - 40));
        check_least(failures, cloud, around_simplex(cloud), tolerances[draw % 4]);
    }
}

/// D. M. Titterington's iteration u_i <- u_i κ_i/(n + 1) in long double: the mean and covariance of
/// the weights give a lower bound of the least volume, and after scaling an upper one.
struct Bounds {
    Number lower, upper;

    explicit Bounds(Cloud const &cloud, int steps)
    {
        std::size_t const n = static_cast<std::size_t>(cloud.n), m = cloud.size();
        std::vector<Number> weights(m, Number(1) / static_cast<int>(m)), mean;
        std::vector<double> w(m, 1.0 / static_cast<double>(m));
        for (int step = 0; step < steps; ++step) improve(cloud, w);
        double total = 0.0;
        for (double x : w) total += x;
        mean.assign(n, Number(0));
        for (std::size_t i = 0; i < m; ++i)
            for (std::size_t k = 0; k < n; ++k)
                mean[k] += Number(w[i]) * Number(cloud.row(i)[k]) / Number(total);
        Matrix s(n, std::vector<Number>(n, Number(0)));
        for (std::size_t i = 0; i < m; ++i)
            for (std::size_t k = 0; k < n; ++k)
                for (std::size_t l = 0; l < n; ++l)
                    s[k][l] += Number(w[i]) * (Number(cloud.row(i)[k]) - mean[k]) *
                               (Number(cloud.row(i)[l]) - mean[l]) / Number(total);
        auto const all = squares(cloud, mean, s);
        Number const largest = *std::max_element(all.begin(), all.end());
        using std::sqrt;
        lower = upper = determinant(s);
        for (std::size_t k = 0; k < n; ++k) lower *= Number(cloud.n), upper *= largest;
        lower = sqrt(lower), upper = sqrt(upper);
    }

    static void improve(Cloud const &cloud, std::vector<double> &w)
    {
        std::size_t const d = static_cast<std::size_t>(cloud.n) + 1;
        std::vector<long double> v(d * d, 0.0L);
        auto const y = [&](std::size_t i, std::size_t k) -> long double {
            return k + 1 < d ? cloud.row(i)[k] : 1.0L;
        };
        for (std::size_t i = 0; i < w.size(); ++i)
            for (std::size_t k = 0; k < d; ++k)
                for (std::size_t l = 0; l <= k; ++l) v[k * d + l] += w[i] * y(i, k) * y(i, l);
        for (std::size_t k = 0; k < d; ++k)
            for (std::size_t l = 0; l <= k; ++l) {
                for (std::size_t j = 0; j < l; ++j) v[k * d + l] -= v[k * d + j] * v[l * d + j];
                v[k * d + l] = k == l ? std::sqrt(v[k * d + l]) : v[k * d + l] / v[l * d + l];
            }
        for (std::size_t i = 0; i < w.size(); ++i) {
            std::vector<long double> g(d);
            long double kappa = 0.0L;
            for (std::size_t k = 0; k < d; ++k) {
                g[k] = y(i, k);
                for (std::size_t j = 0; j < k; ++j) g[k] -= v[k * d + j] * g[j];
                g[k] /= v[k * d + k];
                kappa += g[k] * g[k];
            }
            w[i] *= static_cast<double>(kappa / static_cast<long double>(d));
        }
    }
};

Cloud random_cloud(std::mt19937 &random, int n, int m)
{
    std::normal_distribution<double> normal;
    Cloud cloud{n, {}};
    for (int i = 0; i < m; ++i)
        for (int k = 0; k < n; ++k) cloud.points.push_back(normal(random));
    return cloud;
}

PW85_TEST("/enclosing/iteration")
{
    Failures failures;
    std::mt19937 random(4);
    for (int draw = 0; draw < draws(80); ++draw) {
        int const n = random_dimension(random, 6), m = n + 1 + static_cast<int>(random() % 30);
        Cloud const cloud = random_cloud(random, n, m);
        Found const found = find(cloud, 1e-11);
        failures.check(found.status == PW85_SUCCESS, "status", found.status, 0.0,
                       [&] { return cloud.text(); });
        if (found.status != PW85_SUCCESS) continue;
        check_inside(failures, cloud, found);
        Bounds const bounds(cloud, 2000);
        using std::sqrt;
        Number const volume = sqrt(determinant(found.form()));
        double const below = static_cast<double>(volume / bounds.lower - 1),
                     above = static_cast<double>(volume / bounds.upper - 1);
        auto const text = [&] { return cloud.text(); };
        failures.check(below >= 0.0, "below the dual bound", below, 0.0, text);
        failures.check(above <= found.excess, "above the primal bound", above, found.excess, text);
    }
}

/// Powers of two in each coordinate change the exponents alone; the order of the points changes the
/// volume by the excess.
PW85_TEST("/enclosing/units_and_order")
{
    Failures failures;
    std::mt19937 random(5);
    for (int draw = 0; draw < draws(160); ++draw) {
        int const n = random_dimension(random);
        Cloud const cloud = random_cloud(random, n, 3 * n + 20);
        Cloud scaled = cloud, turned = cloud;
        std::vector<int> exponents;
        for (int k = 0; k < n; ++k)
            exponents.push_back(draw % 2 == 0 ? (draw % 4 - 1) * 400
                                              : static_cast<int>(random() % 81) - 40);
        for (std::size_t i = 0; i < cloud.points.size(); ++i)
            scaled.points[i] = std::ldexp(cloud.points[i], exponents[i % exponents.size()]);
        for (std::size_t i = 0; i < cloud.size(); ++i)
            std::copy_n(cloud.row(cloud.size() - 1 - i), n,
                        turned.points.begin() + static_cast<std::ptrdiff_t>(i) * n);
        Found const found = find(cloud, 1e-9), other = find(scaled, 1e-9),
                    back = find(turned, 1e-9);
        auto const text = [&] { return cloud.text(); };
        bool same = found.status == PW85_SUCCESS && other.status == found.status &&
                    other.excess == found.excess;
        auto const size = static_cast<std::size_t>(n);
        for (std::size_t i = 0, k = 0; i < size; ++i) {
            same = same && other.center[i] == std::ldexp(found.center[i], exponents[i]);
            for (std::size_t j = i; j < size; ++j, ++k)
                same = same && other.q[k] == std::ldexp(found.q[k], exponents[i] + exponents[j]);
        }
        failures.check(same, "other units", 0.0, 1.0, text);
        if (found.status != PW85_SUCCESS || back.status != PW85_SUCCESS) continue;
        using std::sqrt;
        double const ratio =
            static_cast<double>(sqrt(determinant(back.form()) / determinant(found.form())) - 1);
        failures.check(std::abs(ratio) <= 1e-9 * (1.0 + 1e-8), "other order", ratio, 1e-9, text);
    }
}

/// Clouds that double precision limits: thin ones, and ones that are far from 0. The ellipsoid
/// holds them all the same.
PW85_TEST("/enclosing/limits")
{
    Failures failures;
    std::mt19937 random(6);
    int limited = 0;
    for (int draw = 0; draw < draws(160); ++draw) {
        int const n = 2 + static_cast<int>(random() % 6);
        Cloud cloud = random_cloud(random, n, 4 * n + 4);
        double const thin = std::ldexp(1.0, -static_cast<int>(random() % 22));
        double const shift = draw % 3 == 0 ? std::ldexp(1.0, static_cast<int>(random() % 40)) : 0.0;
        for (std::size_t i = 0; i < cloud.size(); ++i) {
            double *const x = &cloud.points[i * static_cast<std::size_t>(n)];
            x[1] = x[0] + thin * x[1]; // flat along a diagonal
            for (int k = 0; k < n; ++k) x[k] += shift;
        }
        Found const found = find(cloud, 1e-12);
        auto const text = [&] { return cloud.text(); };
        bool const is_limited = found.status == PW85_ECONVERGENCE;
        limited += is_limited;
        failures.check(found.status != PW85_EINVAL, "status", found.status, 0.0, text);
        if (found.status != PW85_SUCCESS && !is_limited) continue;
        failures.check(is_limited == (found.excess > 1e-12), "excess", found.excess, 1e-12, text);
        check_inside(failures, cloud, found);
        // n u κ, κ below 8 n (aspect ratio)² for these clouds, and 8 n u (shift/thickness).
        double const aspect = 16.0 * n / thin;
        double const bound = 1e-12 + n * u * aspect * aspect + 8.0 * n * u * shift * aspect;
        failures.check(found.excess <= bound, "excess", found.excess, bound, text);
    }
    g_assert_cmpint(limited, >, 0);
}

/// Thin simplices, whose least volume is known: the excess that the rounding of the form leaves is
/// never larger than what is said.
PW85_TEST("/enclosing/thin_simplices")
{
    Failures failures;
    std::mt19937 random(14);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int draw = 0; draw < draws(240); ++draw) {
        int const n = 2 + draw % 7;
        double const thin = std::ldexp(1.0, -static_cast<int>(random() % 22)),
                     shift = draw % 3 == 0 ? 64.0 : 0.0;
        Cloud cloud{n, {}};
        for (int i = 0; i < n + 1; ++i) {
            Numbers x;
            for (int k = 0; k < n; ++k) x.push_back(uniform(random) + (k == i ? 4.0 : 0.0));
            double sum = 0.0;
            for (int k = 1; k < n; ++k) sum += x[static_cast<std::size_t>(k)];
            x[0] = sum + thin * x[0]; // near the plane x0 = x1 + …
            for (double &y : x) y += shift;
            cloud.add(x);
        }
        Found const found = find(cloud, 1e-12);
        auto const text = [&] { return cloud.text(); };
        if (found.status != PW85_SUCCESS && found.status != PW85_ECONVERGENCE) {
            failures.check(found.status == PW85_ENOTPD && thin <= 0x1p-17, "status", found.status,
                           0.0, text);
            continue;
        }
        failures.check((found.status == PW85_SUCCESS) == (found.excess <= 1e-12), "excess",
                       found.excess, 1e-12, text);
        check_inside(failures, cloud, found);
        using std::sqrt;
        Number const ratio =
            sqrt(determinant(found.form()) / determinant(around_simplex(cloud))) - 1;
        double const excess = static_cast<double>(ratio);
        failures.check(excess >= 0.0, "below the least", excess, 0.0, text);
        failures.check(ratio <= Number(found.excess), "above 1 + excess", excess, found.excess,
                       text);
    }
}

/// The cloud without its first coordinate.
Cloud without_first(Cloud const &cloud)
{
    Cloud other{cloud.n - 1, {}};
    for (std::size_t k = 0; k < cloud.points.size(); ++k)
        if (k % static_cast<std::size_t>(cloud.n) != 0) other.points.push_back(cloud.points[k]);
    return other;
}

// Integers in the hyperplane x_1 = 0 or Σ x_k = 0. The ellipsoid of the affine hull is the image of
// the one around the other coordinates, which are coordinates of the hull. Both have an excess of
// at most ε = 1e-9. Where the smallest ellipsoid is the unit ball, its points of contact have
// weights with Σ u x xᵀ = 1/n, so that tr Q⁻¹/n + cᵀQ⁻¹c <= 1 for any other ellipsoid around them.
// With det Q <= (1 + ε)² the eigenvalues of Q are within 2 √ε of 1, to first order, and |c| is at
// most √(2ε/n). Two such ellipsoids differ by twice that: 1.3e-4 and 9e-5.
PW85_TEST("/enclosing/flat")
{
    Failures failures;
    std::mt19937 random(7);
    for (int draw = 0; draw < draws(160); ++draw) {
        int const n = random_dimension(random);
        bool const oblique = draw % 2 == 0;
        double const unit = std::ldexp(1.0, draw % 7 * 13 - 39);
        Cloud cloud = random_cloud(random, n, 4 * n + 4);
        for (std::size_t i = 0; i < cloud.size(); ++i) {
            double *const x = &cloud.points[i * static_cast<std::size_t>(n)];
            double sum = 0.0; // of integers: exact
            for (int k = 0; k < n; ++k) sum += x[k] = unit * std::round(8.0 * x[k]);
            x[0] -= oblique ? sum : x[0];
        }
        Found const found = find(cloud, 1e-9);
        auto const text = [&] { return cloud.text(); };
        failures.check(found.status == PW85_ENOTPD, "status", found.status, PW85_ENOTPD, text);
        failures.check(found.excess <= 1e-9, "excess", found.excess, 1e-9, text);
        if (n == 1) continue;
        Found const other = find(without_first(cloud), 1e-9);
        failures.check(other.status == PW85_SUCCESS, "of the hull", other.status, 0, text);
        double across = found.center[0];
        for (int i = 1; i < n; ++i) {
            auto const extent = std::sqrt(other.entry(i - 1, i - 1));
            across += oblique ? found.center[static_cast<std::size_t>(i)] : 0.0;
            double const shift = found.center[static_cast<std::size_t>(i)] -
                                 other.center[static_cast<std::size_t>(i - 1)];
            failures.check(std::abs(shift) < 2e-4 * extent, "center", shift, extent, text);
            double row = found.entry(0, i);
            for (int j = 1; j < n; ++j) {
                row += oblique ? found.entry(i, j) : 0.0;
                double const bound = 2e-4 * extent * std::sqrt(other.entry(j - 1, j - 1)),
                             change = found.entry(i, j) - other.entry(i - 1, j - 1);
                failures.check(std::abs(change) < bound, "form", change, bound, text);
            }
            failures.check(std::abs(row) < 1e-11 * other.entry(i - 1, i - 1) * n, "null vector",
                           row, 0.0, text);
        }
        failures.check(std::abs(across) < 1e-11 * unit, "in the plane", across, 0.0, text);
    }
}

// Equal points, and points on a line through three dimensions.
PW85_TEST("/enclosing/line")
{
    double const line[12] = {1, 2, 3, 2, 4, 3, 3, 6, 3, 1, 2, 3}, point[6] = {7, 8, 7, 8, 7, 8};
    double center[3], q[6], excess;
    int status = pw85_enclosing_ellipsoid(3, 4, line, 1e-9, center, q, &excess);
    g_assert_cmpint(status, ==, PW85_ENOTPD);
    double const expected[6] = {1, 2, 0, 4, 0, 0}; // from (1, 2, 3) to (3, 6, 3)
    for (int k = 0; k < 6; ++k) g_assert_cmpfloat(std::abs(q[k] - expected[k]), <, 1e-8);
    g_assert_cmpfloat(std::abs(center[0] - 2) + std::abs(center[1] - 4), <, 1e-8);
    g_assert_cmpfloat(center[2], ==, 3);
    status = pw85_enclosing_ellipsoid(2, 3, point, 1e-9, center, q, &excess);
    g_assert_cmpint(status, ==, PW85_ENOTPD);
    g_assert_true(center[0] == 7 && center[1] == 8 && q[0] == 0 && q[1] == 0 && q[2] == 0 &&
                  excess == 0);
}

PW85_TEST("/enclosing/status")
{
    double const nan = std::numeric_limits<double>::quiet_NaN();
    double const plane[8] = {0, 0, 1, 0, 0, 1, 1, 1}, line[2] = {-1, 3},
                 bad[6] = {0, 0, 1, nan, 0, 1};
    double const huge[2] = {-1e300, 1e300}, far_apart[6] = {0, 0, 0x1p470, 0, 0, 0x1p-470};
    double center[2] = {7, 7}, q[3] = {7, 7, 7}, excess = 7;
    auto const status = [&](int n, std::size_t m, double const *points, double tolerance) {
        return pw85_enclosing_ellipsoid(n, m, points, tolerance, center, q, &excess);
    };
    g_assert_cmpint(status(2, 4, plane, 1e-9), ==, PW85_SUCCESS);
    g_assert_true(std::abs(center[0] - 0.5) < 1e-9 && std::abs(q[0] - 0.5) < 1e-9 &&
                  excess <= 1e-9);
    g_assert_cmpint(status(1, 2, line, 1e-9), ==, PW85_SUCCESS);
    g_assert_true(std::abs(center[0] - 1.0) < 1e-9 && std::abs(q[0] - 4.0) < 1e-8);
    g_assert_cmpint(status(2, 3, far_apart, 1e-9), ==, PW85_SUCCESS);
    for (double const tolerance : {0.0, -1.0, nan, HUGE_VAL})
        g_assert_cmpint(status(2, 4, plane, tolerance), ==, PW85_EINVAL);
    g_assert_true(std::isnan(center[1]) && std::isnan(q[2]) && std::isnan(excess));
    g_assert_cmpint(status(2, 2, plane, 1.0), ==, PW85_EINVAL);
    g_assert_cmpint(status(2, 0, plane, 1.0), ==, PW85_EINVAL);
    g_assert_cmpint(status(2, static_cast<std::size_t>(-1), plane, 1.0), ==, PW85_EINVAL);
    g_assert_cmpint(status(2, 3, bad, 1.0), ==, PW85_EINVAL);
    g_assert_cmpint(status(2, 3, nullptr, 1.0), ==, PW85_EINVAL);
    g_assert_cmpint(status(0, 4, plane, 1.0), ==, PW85_EINVAL);
    g_assert_cmpint(status(17, 4, plane, 1.0), ==, PW85_EINVAL);
    g_assert_cmpint(status(-1, 4, plane, 1.0), ==, PW85_EINVAL);
    g_assert_cmpint(status(1, 2, huge, 1.0), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_enclosing_ellipsoid(2, 4, plane, 1.0, nullptr, nullptr, nullptr), ==,
                    PW85_SUCCESS);
}

/// The template calls the function of C.
PW85_TEST("/enclosing/template")
{
    Failures failures;
    std::mt19937 random(9);
    Cloud const cloud = random_cloud(random, 3, 40);
    std::vector<pw85::Vector<double, 3>> points(40);
    for (std::size_t i = 0; i < cloud.points.size(); ++i)
        points[i / 3][static_cast<int>(i % 3)] = cloud.points[i];
    auto const one = pw85::enclosing_ellipsoid<3>(points, 1e-9);
    Found const other = find(cloud, 1e-9);
    bool same = one.status == pw85::Status::success && one.excess == other.excess;
    for (int k = 0; k < 6; ++k) same = same && one.q[k] == other.q[static_cast<std::size_t>(k)];
    for (int k = 0; k < 3; ++k)
        same = same && one.center[k] == other.center[static_cast<std::size_t>(k)];
    failures.check(same, "the same", 0.0, 1.0, [&] { return cloud.text(); });
}

/// Many points on a sphere: dense candidates, all near the boundary.
PW85_TEST("/enclosing/dense")
{
    Failures failures;
    std::mt19937 random(8);
    for (int n : {2, 3, 5}) {
        Cloud cloud = random_cloud(random, n, 20000);
        for (std::size_t i = 0; i < cloud.size(); ++i) {
            double *const x = &cloud.points[i * static_cast<std::size_t>(n)], square = 0.0;
            for (int k = 0; k < n; ++k) square += x[k] * x[k];
            for (int k = 0; k < n; ++k) x[k] /= std::sqrt(square);
        }
        Found const found = find(cloud, 1e-7);
        auto const text = [&] { return cloud.text(); };
        failures.check(found.status == PW85_SUCCESS, "status", found.status, 0.0, text);
        // The unit ball holds the points, up to rounding errors of the coordinates.
        using std::sqrt;
        double const above = static_cast<double>(sqrt(determinant(found.form())) - 1);
        failures.check(above <= found.excess + 4.0 * n * u, "volume", above, found.excess, text);
    }
}

/// Ellipsoids, as the C API takes them.
struct Bodies {
    int n;
    Numbers centers, forms;

    std::size_t size() const { return centers.size() / static_cast<std::size_t>(n); }
    std::string text() const
    {
        int const shown = static_cast<int>(std::min<std::size_t>(centers.size(), 48));
        return "n = " + std::to_string(n) + ", m = " + std::to_string(size()) + ", centers " +
               hex_text(centers.data(), shown) + ", forms " +
               hex_text(forms.data(), std::min<int>(static_cast<int>(forms.size()), 96));
    }
};

Found find(Bodies const &bodies, double tolerance)
{
    auto const n = static_cast<std::size_t>(bodies.n);
    Found found{0, Numbers(n), Numbers(n * (n + 1) / 2), 0.0};
    found.status = pw85_enclosing_ellipsoid_of(bodies.n, bodies.size(), bodies.centers.data(),
                                               bodies.forms.data(), tolerance, found.center.data(),
                                               found.q.data(), &found.excess);
    return found;
}

/// Every ellipsoid is inside, with no allowance: κ² <= 1 in 50 digits. What is left of 45 right
/// digits is far below the enlargement of the ellipsoid, 2⁻⁴⁷ at least.
void check_inside(Failures &failures, Bodies const &bodies, Found const &found)
{
    std::size_t const n = found.center.size(), packed = found.q.size();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        nd::Case const pair{
            bodies.n,
            {},
            found.q,
            Numbers(bodies.forms.begin() + static_cast<std::ptrdiff_t>(i * packed),
                    bodies.forms.begin() + static_cast<std::ptrdiff_t>((i + 1) * packed))};
        nd::Row r;
        for (std::size_t k = 0; k < n; ++k)
            r.push_back(nd::Number(bodies.centers[i * n + k]) - nd::Number(found.center[k]));
        double const outside = static_cast<double>(nd::containment_truth(pair, r).kappa2 - 1);
        failures.check(outside <= 0.0, "outside by", outside, 0.0, [&] { return bodies.text(); });
    }
}

/// Balls at the vertices of a cross-polytope, mapped: their ellipsoid is the image of a ball,
/// because the symmetries of the vertices leave no other ellipsoid unchanged.
PW85_TEST("/enclosing/balls")
{
    Failures failures;
    std::mt19937 random(10);
    for (int draw = 0; draw < draws(40); ++draw) {
        int const n = random_dimension(random, draw % 4 == 0 ? 6 : 3);
        auto const size = static_cast<std::size_t>(n);
        Map const map(random, n, true);
        double const radius = 1 + static_cast<double>(random() % 3);
        Bodies bodies{n, {}, {}};
        Matrix const image = map.image(Number(radius * radius));
        for (int vertex = 0; vertex < 2 * n; ++vertex) {
            Numbers y(size, 0.0);
            y[static_cast<std::size_t>(vertex / 2)] = vertex % 2 ? -4.0 : 4.0;
            Numbers const x = map.apply(y);
            bodies.centers.insert(bodies.centers.end(), x.begin(), x.end());
            for (std::size_t i = 0; i < size; ++i)
                for (std::size_t j = i; j < size; ++j)
                    bodies.forms.push_back(static_cast<double>(image[i][j]));
        }
        double const tolerance = tolerances[draw % 3];
        Found const found = find(bodies, tolerance);
        auto const text = [&] { return bodies.text(); };
        failures.check(found.status == PW85_SUCCESS, "status", found.status, 0.0, text);
        if (found.status != PW85_SUCCESS) continue;
        check_inside(failures, bodies, found);
        Matrix const least = map.image(Number((4.0 + radius) * (4.0 + radius)));
        Number const ratio = sqrt(determinant(found.form()) / determinant(least)) - 1;
        failures.check(ratio >= 0, "below the least", static_cast<double>(ratio), 0.0, text);
        failures.check(ratio <= Number(found.excess), "above 1 + excess",
                       static_cast<double>(ratio), found.excess, text);
        failures.check(found.excess <= tolerance, "excess", found.excess, tolerance, text);
    }
}

/// Random ellipsoids of any size. Two results with different tolerances bound the least volume from
/// both sides: volume/(1 + excess) of one is not above the volume of the other.
PW85_TEST("/enclosing/random_ellipsoids")
{
    Failures failures;
    Random random(11);
    for (int draw = 0; draw < draws(24); ++draw) {
        int const n = 1 + draw % 6, m = draw % 5 == 0 ? 1 : 2 + draw % 7;
        double const unit = std::ldexp(1.0, static_cast<int>(random.uniform(-40, 41)));
        Bodies bodies{n, {}, {}};
        for (int i = 0; i < m; ++i) {
            double const size = unit * random.log_uniform(0.01, 1);
            auto const form = nd::random_form(random, n, size, draw % 2 ? 20 : 2);
            bodies.forms.insert(bodies.forms.end(), form.begin(), form.end());
            for (int k = 0; k < n; ++k) bodies.centers.push_back(unit * random.normal());
        }
        auto const text = [&] { return bodies.text(); };
        Found const rough = find(bodies, 1e-2), fine = find(bodies, 1e-8);
        failures.check(rough.status == PW85_SUCCESS, "status", rough.status, 0.0, text);
        failures.check(fine.status == PW85_SUCCESS, "status", fine.status, 0.0, text);
        if (rough.status != PW85_SUCCESS || fine.status != PW85_SUCCESS) continue;
        check_inside(failures, bodies, rough);
        check_inside(failures, bodies, fine);
        check_excesses(failures, rough, fine, text);
    }
}

/// The form H diag(squares) Hᵀ with H = n - 2 (1, ..., 1)(1, ..., 1)ᵀ, whose columns are orthogonal
/// and have the length n: integers, which are exact.
Numbers reflected(Numbers const &squares)
{
    std::size_t const n = squares.size();
    auto const h = [&](std::size_t i, std::size_t j) {
        return (i == j ? static_cast<double>(n) : 0.0) - 2.0;
    };
    Numbers form;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i; j < n; ++j) {
            double sum = 0.0;
            for (std::size_t k = 0; k < n; ++k) sum += h(i, k) * squares[k] * h(j, k);
            form.push_back(sum);
        }
    return form;
}

/// Few ellipsoids with one centre and the same directions of the axes, in many dimensions: each
/// touches the smallest ellipsoid, whose semi-axes are the longest ones, along several axes.
PW85_TEST("/enclosing/few_in_many_dimensions")
{
    Failures failures;
    std::mt19937 random(12);
    for (int draw = 0; draw < draws(24); ++draw) {
        int const n = 6 + draw % 11, m = 2 + static_cast<int>(random() % 4);
        auto const size = static_cast<std::size_t>(n);
        double const unit = std::ldexp(1.0, static_cast<int>(random() % 81) - 40);
        Numbers center(size), largest(size, 0.0), forms;
        for (double &x : center) x = unit * (static_cast<double>(random() % 9) - 4.0);
        for (int i = 0; i < m; ++i) {
            Numbers squares(size);
            for (std::size_t k = 0; k < size; ++k) {
                double const axis = unit * static_cast<double>(1 + random() % 12);
                squares[k] = axis * axis;
                largest[k] = std::max(largest[k], squares[k]);
            }
            auto const form = reflected(squares);
            forms.insert(forms.end(), form.begin(), form.end());
        }
        Bodies bodies{n, {}, forms};
        for (int i = 0; i < m; ++i)
            bodies.centers.insert(bodies.centers.end(), center.begin(), center.end());
        double const tolerance = draw % 3 == 0 ? 1e-6 : draw % 3 == 1 ? 1e-9 : 1e-12;
        Found const found = find(bodies, tolerance);
        auto const text = [&] { return bodies.text(); };
        failures.check(found.status == PW85_SUCCESS, "status", found.status, 0.0, text);
        Number least(1); // the square of its volume
        for (double const square : largest) least *= Number(square) * n * n;
        Number const ratio = sqrt(determinant(found.form()) / least) - 1;
        failures.check(ratio >= 0, "below the least", static_cast<double>(ratio), 0.0, text);
        failures.check(ratio <= Number(found.excess), "above 1 + excess",
                       static_cast<double>(ratio), found.excess, text);
        failures.check(found.excess <= tolerance, "excess", found.excess, tolerance, text);
        if (n <= 8) check_inside(failures, bodies, found);
    }
}

/// Ellipsoids with random axes: each touches at points in a subspace, which must be found.
PW85_TEST("/enclosing/few_of_any_directions")
{
    Failures failures;
    Random random(13);
    for (int draw = 0; draw < draws(11); ++draw) {
        int const n = 6 + draw, m = 2 + draw % 3;
        Bodies bodies{n, {}, {}};
        for (int i = 0; i < m; ++i) {
            auto const form = nd::random_form(random, n, 1.0, draw % 2 ? 3 : 100);
            bodies.forms.insert(bodies.forms.end(), form.begin(), form.end());
            for (int k = 0; k < n; ++k) bodies.centers.push_back(0.3 * random.normal());
        }
        auto const text = [&] { return bodies.text(); };
        Found const rough = find(bodies, 1e-3), fine = find(bodies, 1e-10);
        failures.check(rough.status == PW85_SUCCESS, "status", rough.status, 0.0, text);
        failures.check(fine.status == PW85_SUCCESS, "status", fine.status, 0.0, text);
        if (n <= 8) check_inside(failures, bodies, fine);
        check_excesses(failures, rough, fine, text);
    }
}

/// Powers of two in each coordinate change the exponents alone.
PW85_TEST("/enclosing/units_of_ellipsoids")
{
    Failures failures;
    Random random(14);
    for (int draw = 0; draw < draws(24); ++draw) {
        int const n = 2 + draw % 5, m = 1 + draw % 4;
        auto const size = static_cast<std::size_t>(n);
        Bodies bodies{n, {}, {}};
        for (int i = 0; i < m; ++i) {
            auto const form = nd::random_form(random, n, 1.0, 10);
            bodies.forms.insert(bodies.forms.end(), form.begin(), form.end());
            for (int k = 0; k < n; ++k) bodies.centers.push_back(random.normal());
        }
        std::vector<int> exponents;
        for (int k = 0; k < n; ++k)
            exponents.push_back(k % 2 ? 470 : -static_cast<int>(random.uniform(0, 470)));
        Bodies scaled = bodies;
        for (std::size_t i = 0; i < bodies.centers.size(); ++i)
            scaled.centers[i] = std::ldexp(bodies.centers[i], exponents[i % size]);
        for (std::size_t i = 0, at = 0; i < static_cast<std::size_t>(m); ++i)
            for (std::size_t k = 0; k < size; ++k)
                for (std::size_t l = k; l < size; ++l, ++at)
                    scaled.forms[at] = std::ldexp(bodies.forms[at], exponents[k] + exponents[l]);
        Found const found = find(bodies, 1e-9), other = find(scaled, 1e-9);
        bool same = found.status == PW85_SUCCESS && other.status == found.status &&
                    other.excess == found.excess;
        for (std::size_t k = 0, at = 0; k < size; ++k) {
            same = same && other.center[k] == std::ldexp(found.center[k], exponents[k]);
            for (std::size_t l = k; l < size; ++l, ++at)
                same = same && other.q[at] == std::ldexp(found.q[at], exponents[k] + exponents[l]);
        }
        failures.check(same, "other units", 0.0, 1.0, [&] { return bodies.text(); });
    }
}

/// Needles and discs: the ellipsoid holds them, with an excess of some n u (aspect ratio)², the
/// change of a form of double precision by rounding.
PW85_TEST("/enclosing/needles")
{
    Failures failures;
    Random random(15);
    for (int draw = 0; draw < draws(24); ++draw) {
        int const n = 2 + draw % 4, m = 1 + draw % 3;
        double const aspect = std::pow(10.0, random.uniform(4.0, 6.5));
        Bodies bodies{n, {}, {}};
        auto const form = nd::random_form(random, n, 1.0, aspect);
        for (int i = 0; i < m; ++i) {
            bodies.forms.insert(bodies.forms.end(), form.begin(), form.end());
            for (int k = 0; k < n; ++k) bodies.centers.push_back(i == 0 ? 0.0 : random.normal());
        }
        Found const found = find(bodies, 1e-6);
        auto const text = [&] { return bodies.text(); };
        bool const usual = found.status == PW85_SUCCESS || found.status == PW85_ECONVERGENCE;
        failures.check(usual, "status", found.status, 0.0, text);
        if (!usual) continue;
        double const bound = 1e-6 + 64.0 * n * u * aspect * aspect;
        failures.check(found.excess <= bound, "excess", found.excess, bound, text);
        check_inside(failures, bodies, found);
    }
}

PW85_TEST("/enclosing/status_of_ellipsoids")
{
    double const nan = std::numeric_limits<double>::quiet_NaN();
    double const centers[4] = {0, 0, 3, 0}, forms[6] = {1, 0, 1, 1, 0, 4},
                 flat[6] = {1, 0, 1, 1, 1, 1}, bad[4] = {0, nan, 3, 0};
    double center[2] = {7, 7}, q[3] = {7, 7, 7}, excess = 7;
    auto const status = [&](int n, std::size_t m, double const *c, double const *f, double t) {
        return pw85_enclosing_ellipsoid_of(n, m, c, f, t, center, q, &excess);
    };
    g_assert_cmpint(status(2, 2, centers, forms, 1e-9), ==, PW85_SUCCESS);
    g_assert_true(excess <= 1e-9 && std::abs(center[1]) < 1e-4);
    for (double const tolerance : {0.0, -1.0, nan, HUGE_VAL})
        g_assert_cmpint(status(2, 2, centers, forms, tolerance), ==, PW85_EINVAL);
    g_assert_true(std::isnan(center[1]) && std::isnan(q[2]) && std::isnan(excess));
    g_assert_cmpint(status(2, 2, bad, forms, 1.0), ==, PW85_EINVAL);
    g_assert_cmpint(status(2, 2, centers, flat, 1.0), ==, PW85_ENOTPD);
    g_assert_cmpint(status(2, 0, centers, forms, 1.0), ==, PW85_EINVAL);
    g_assert_cmpint(status(2, static_cast<std::size_t>(-1), centers, forms, 1.0), ==, PW85_EINVAL);
    g_assert_cmpint(status(2, 2, nullptr, forms, 1.0), ==, PW85_EINVAL);
    g_assert_cmpint(status(2, 2, centers, nullptr, 1.0), ==, PW85_EINVAL);
    for (int n : {-1, 0, 17}) g_assert_cmpint(status(n, 1, centers, forms, 1.0), ==, PW85_EINVAL);
    std::vector<pw85::Vector<double, 2>> const points{{0, 0}, {3, 0}};
    std::vector<pw85::SymmetricMatrix<double, 2>> const matrices{{1, 0, 1}, {1, 0, 4}};
    auto const found = pw85::enclosing_ellipsoid_of<2>(points, matrices, 1e-9);
    g_assert_cmpint(status(2, 2, centers, forms, 1e-9), ==, PW85_SUCCESS);
    g_assert_true(found.status == pw85::Status::success && found.q[2] == q[2] &&
                  found.center[0] == center[0] && found.excess == excess);
}

} // namespace

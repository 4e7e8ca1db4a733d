// SPDX-License-Identifier: BSD-3-Clause
// The proofs of enclosing ellipsoids, which no function exports: points that are outside by 2⁻¹⁰⁰
// are not proved to be inside, and the excess of any weights is at least that of exact arithmetic.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <glib.h>

#include "../src/enclosing/certificate.cpp"
#include "../src/enclosing/frame.cpp"

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "oracle/multiprecision.hpp"
#include "sample.hpp"

using namespace pw85_tests;
using namespace pw85::detail::enclosing;

namespace {

using Number = Multiprecision<100>;
using Size = std::size_t;
using Matrix = std::vector<std::vector<Number>>;

Cloud cloud_of(int n, std::vector<double> const &points)
{
    Cloud cloud{n, points.size() / static_cast<Size>(n), points.data(), {}, {}};
    std::fill_n(cloud.scale, n, 1.0);
    return cloud;
}

/// The determinant of a positive definite matrix.
Number determinant(Matrix a)
{
    Number product(1);
    for (Size k = 0; k < a.size(); ++k) {
        product *= a[k][k];
        for (Size i = k + 1; i < a.size(); ++i) {
            Number const f = a[i][k] / a[k][k];
            for (Size j = k; j < a.size(); ++j) a[i][j] -= f * a[k][j];
        }
    }
    return product;
}

/// z² - q = 1 for z = 2^k s + 1 and q = 2^(k + 1) s (2^(k - 1) s + 1), which has the 53 bits of a
/// double. The form is q L Lᵀ, with ones on the diagonal of L and 0, 1 or -1 next to it. The point
/// z L e is outside by 2⁻¹⁰⁰ or so, and (z - 1) L e is inside by 2⁻⁵¹: all numbers are exact.
PW85_TEST("/certificate/points_just_outside")
{
    Failures failures;
    std::mt19937 random(1);
    for (int draw = 0; draw < draws(4000); ++draw) {
        int const k = 49 + draw % 4, n = 1 + static_cast<int>(random() % 8),
                  place = static_cast<int>(random() % static_cast<unsigned>(n));
        double const s = k < 51 ? 1.0 + 2.0 * static_cast<double>(random() % 2) : 1.0,
                     z = std::ldexp(s, k) + 1.0, odd = s * (std::ldexp(s, k - 1) + 1.0);
        int const unit = -std::ilogb(z);
        double const q = std::ldexp(odd, k + 1 + 2 * unit);
        g_assert_true(z - 1.0 == std::ldexp(s, k) && odd < 0x1p53);
        std::vector<double> points(static_cast<Size>(2 * n), 0.0), center(points), below, form;
        for (int i = 0; i < n; ++i) below.push_back(static_cast<double>(random() % 3) - 1.0);
        for (int i = 0; i < n; ++i)
            for (int l = 0; l <= i; ++l) {
                double const b = below[static_cast<Size>(i > 0 ? i - 1 : 0)]; // entry (i, i - 1)
                form.push_back(l == i ? q * (i > 0 ? 1.0 + b * b : 1.0) : l == i - 1 ? q * b : 0.0);
            }
        for (int row = 0; row < 2; ++row) {
            double const length = std::ldexp(z - row, unit);
            auto const first = static_cast<Size>(row * n + place);
            points[first] = length;
            if (place + 1 < n) points[first + 1] = length * below[static_cast<Size>(place)];
        }
        Cloud const cloud = cloud_of(n, points);
        Certificate certificate;
        auto const text = [&] {
            return "n = " + std::to_string(n) + ", points " + hex_text(points.data(), 2 * n) +
                   ", form " + hex_text(form.data(), static_cast<int>(form.size()));
        };
        bool const definite = certificate.prepare(cloud, center.data(), form.data());
        failures.check(definite, "definite", definite, 1.0, text);
        failures.check(certificate.protrusion(0) > 0.0, "outside by 2^-100",
                       certificate.protrusion(0), 0.0, text);
        // 2⁻⁵¹ is the smallest relative change of z² for these z; the bound is rounded by 2⁻⁵²
        failures.check(certificate.protrusion(1) < -0x1p-52 / s, "inside by 2^-51",
                       certificate.protrusion(1), -0x1p-52 / s, text);
    }
}

/// A number in [1, 2) with 20 binary digits after the point: its square is exact.
double short_number(std::mt19937 &random)
{
    return std::ldexp(1.0 + static_cast<double>(random() % (1u << 20)), -20);
}

/// A random form L D Lᵀ, with thin ellipsoids among them: its lower triangle.
std::vector<double> random_form(int n, int thinness, std::mt19937 &random)
{
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    auto const size = static_cast<Size>(n);
    std::vector<double> l(size * size, 0.0), form;
    for (Size i = 0; i < size; ++i)
        for (Size j = 0; j <= i; ++j)
            l[i * size + j] =
                i == j ? std::ldexp(
                             1.0, -static_cast<int>(random() % static_cast<unsigned>(thinness + 1)))
                       : uniform(random);
    for (Size i = 0; i < size; ++i)
        for (Size j = 0; j <= i; ++j) {
            double sum = 0.0;
            for (Size k = 0; k <= j; ++k) sum += l[i * size + k] * l[j * size + k];
            form.push_back(sum);
        }
    return form;
}

/// zᵀQ⁻¹z by elimination.
Number inverse_form(int n, std::vector<double> const &form, std::vector<Number> z)
{
    auto const size = static_cast<Size>(n);
    Matrix a(size, std::vector<Number>(size, Number(0)));
    for (Size i = 0, k = 0; i < size; ++i)
        for (Size j = 0; j <= i; ++j, ++k) a[i][j] = a[j][i] = Number(form[k]);
    Number sum(0);
    for (Size k = 0; k < size; ++k) {
        sum += z[k] * z[k] / a[k][k];
        for (Size i = k + 1; i < size; ++i) {
            Number const f = a[i][k] / a[k][k];
            z[i] -= f * z[k];
            for (Size j = k; j < size; ++j) a[i][j] -= f * a[k][j];
        }
    }
    return sum;
}

/// A point relative to the centre that is anywhere, or within some 2⁻¹⁰⁶ of the surface.
struct NearPoint {
    std::vector<double> high, low; ///< the point, and the centre with the other sign
    Number excess;                 ///< zᵀQ⁻¹z - 1 of z = high + low

    NearPoint(int n, std::vector<double> const &form, bool is_close, std::mt19937 &random)
        : excess(0)
    {
        std::normal_distribution<double> normal;
        std::vector<Number> z;
        for (int k = 0; k < n; ++k) z.emplace_back(normal(random));
        using std::sqrt;
        Number const length = sqrt(inverse_form(n, form, z)) *
                              (is_close ? Number(1) : Number(0.5 + 0.1 * normal(random)));
        for (Number &x : z) {
            x /= length;
            high.push_back(static_cast<double>(x));
            low.push_back(static_cast<double>(x - Number(high.back())));
            x = Number(high.back()) + Number(low.back());
        }
        excess = inverse_form(n, form, z) - 1;
    }
};

/// The bound p of |A z|² - (1 - η) is at least (1 - η) (zᵀQ⁻¹z - 1), also where zᵀQ⁻¹z - 1 is as
/// small as the rounding errors of numbers with twice the digits: z then is a point minus a centre
/// that is 2⁻⁵³ of it. η is below 2⁻⁶⁰ for these forms.
PW85_TEST("/certificate/bounds_of_protrusions")
{
    Failures failures;
    std::mt19937 random(3);
    for (int draw = 0; draw < draws(6000); ++draw) {
        int const n = 1 + draw % 5;
        bool const is_close = draw % 4 != 0;
        auto const form = random_form(n, draw % 7, random);
        NearPoint const point(n, form, is_close, random);
        std::vector<double> center;
        for (double x : point.low) center.push_back(-x);
        Cloud const cloud = cloud_of(n, point.high);
        Certificate certificate;
        auto const text = [&] {
            return "n = " + std::to_string(n) + ", point " + hex_text(point.high.data(), n) +
                   ", centre " + hex_text(center.data(), n) + ", form " +
                   hex_text(form.data(), static_cast<int>(form.size()));
        };
        if (!certificate.prepare(cloud, center.data(), form.data())) continue;
        double const bound = certificate.protrusion(0), excess = static_cast<double>(point.excess);
        Number const least = point.excess > 0 ? point.excess * Number(1.0 - 0x1p-50)
                                              : point.excess * Number(1.0 + 0x1p-50);
        if (is_close) failures.check(Number(bound) >= least, "close", bound, excess, text);
        // the roundings of the bound are relative to it
        else
            failures.check(Number(bound) >= point.excess * Number(1.0 - 0x1p-60) ||
                               point.excess < 0,
                           "rounded", bound, excess, text);
    }
}

/// Of points close to the surface, none that is outside is passed over in double precision.
PW85_TEST("/certificate/largest_protrusion")
{
    Failures failures;
    std::mt19937 random(4);
    std::normal_distribution<double> normal;
    for (int draw = 0; draw < draws(4000); ++draw) {
        int const n = 2 + draw % 4, m = 1 + draw % 3;
        auto const form = random_form(n, 2 * (draw % 11), random);
        std::vector<double> points, center(static_cast<Size>(n), 0.0);
        for (int i = 0; i < m; ++i) {
            NearPoint const point(n, form, true, random);
            double const scale = 1.0 + std::ldexp(normal(random), -52 + draw % 8);
            for (double x : point.high) points.push_back(scale * x);
        }
        Cloud const cloud = cloud_of(n, points);
        Certificate certificate;
        if (!certificate.prepare(cloud, center.data(), form.data())) continue;
        double largest = -1.0;
        for (Size i = 0; i < static_cast<Size>(m); ++i)
            largest = std::fmax(largest, certificate.protrusion(i));
        double const found = certificate.largest_protrusion();
        auto const text = [&] {
            return "n = " + std::to_string(n) + ", form " +
                   hex_text(form.data(), static_cast<int>(form.size()));
        };
        failures.check(largest <= 0.0 ? found <= 0.0 : found == largest, "passed over", found,
                       largest, text);
    }
}

/// The covariance S of points with weights.
Matrix covariance_of(int n, std::vector<double> const &points, std::vector<double> const &weights,
                     std::vector<Number> &mean)
{
    auto const size = static_cast<Size>(n), count = weights.size();
    Number total(0);
    mean.assign(size, Number(0));
    for (double w : weights) total += Number(w);
    for (Size i = 0; i < count; ++i)
        for (Size k = 0; k < size; ++k)
            mean[k] += Number(weights[i]) * Number(points[i * size + k]) / total;
    Matrix s(size, std::vector<Number>(size, Number(0)));
    for (Size i = 0; i < count; ++i)
        for (Size k = 0; k < size; ++k)
            for (Size l = 0; l < size; ++l)
                s[k][l] += Number(weights[i]) * (Number(points[i * size + k]) - mean[k]) *
                           (Number(points[i * size + l]) - mean[l]) / total;
    return s;
}

/// √(det Q/(nⁿ det S)) - 1 for a form Q, a lower triangle.
Number excess_of(std::vector<double> const &form, Matrix const &s)
{
    Size const size = s.size();
    Matrix q = s;
    for (Size i = 0, k = 0; i < size; ++i)
        for (Size j = 0; j <= i; ++j, ++k) q[i][j] = q[j][i] = Number(form[k]);
    Number ratio = determinant(q) / determinant(s);
    for (Size k = 0; k < size; ++k) ratio /= static_cast<int>(size);
    using std::sqrt;
    return sqrt(ratio) - 1;
}

/// Points ±p_i on the axes with the weights 1 and 1 + δ_i, and Q = diag(p_i²). The excess is about
/// Σ δ_i²/8n, which is as small as the rounding errors of numbers with twice the digits.
PW85_TEST("/certificate/tiny_excess")
{
    Failures failures;
    std::mt19937 random(5);
    for (int draw = 0; draw < draws(3000); ++draw) {
        int const n = 1 + draw % 6;
        auto const size = static_cast<Size>(n);
        std::vector<double> points, weights, center(size, 0.0), form;
        std::vector<Size> indices;
        for (Size i = 0; i < 2 * size; ++i) {
            indices.push_back(i);
            weights.push_back(
                i % 2 == 0 ? 1.0 : 1.0 + std::ldexp(1.0, -44 - static_cast<int>(random() % 9)));
        }
        for (Size i = 0; i < size; ++i) {
            double const p = short_number(random);
            for (double x : {p, -p})
                for (Size k = 0; k < size; ++k) points.push_back(k == i ? x : 0.0);
            for (Size j = 0; j <= i; ++j) form.push_back(j == i ? p * p : 0.0);
        }
        Cloud const cloud = cloud_of(n, points);
        Certificate certificate;
        auto const text = [&] {
            return "n = " + std::to_string(n) + ", weights " +
                   hex_text(weights.data(), static_cast<int>(weights.size())) + ", form " +
                   hex_text(form.data(), static_cast<int>(form.size()));
        };
        bool const definite = certificate.prepare(cloud, center.data(), form.data());
        failures.check(definite, "definite", definite, 1.0, text);
        double const excess = certificate.excess(2 * size, indices.data(), weights.data());
        std::vector<Number> mean;
        Number const exact = excess_of(form, covariance_of(n, points, weights, mean));
        failures.check(Number(excess) >= exact, "tiny", excess, static_cast<double>(exact), text);
    }
}

/// For any weights and any form near n S, the excess is at least √(det Q/(nⁿ det S)) - 1 in exact
/// arithmetic, and close to that if the form has nearly the shape of S.
PW85_TEST("/certificate/excess_of_any_weights")
{
    Failures failures;
    std::mt19937 random(2);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int draw = 0; draw < draws(800); ++draw) {
        int const n = 1 + draw % 8, m = n + 2 + static_cast<int>(random() % 10);
        auto const size = static_cast<Size>(n), count = static_cast<Size>(m);
        std::vector<double> points, weights, center(size, 0.0), form;
        std::vector<Size> indices;
        for (Size i = 0; i < count; ++i) {
            indices.push_back(i);
            weights.push_back(uniform(random));
            for (int k = 0; k < n; ++k)
                points.push_back(normal(random) * std::ldexp(1.0, draw % 3 == 0 ? -k : 0));
        }
        // weights: any sum
        std::vector<Number> mean;
        Matrix const s = covariance_of(n, points, weights, mean);
        // Q = n S (1 + …), with a part that changes its shape
        double const change = std::ldexp(1.0, -static_cast<int>(random() % 40) - 3);
        for (Size k = 0; k < size; ++k) // any centre
            center[k] = static_cast<double>(mean[k]) +
                        0.5 * std::sqrt(static_cast<double>(s[k][k])) * normal(random);
        for (Size k = 0; k < size; ++k)
            for (Size l = 0; l <= k; ++l) {
                double const exact = static_cast<double>(s[k][l]) * n,
                             scale = std::sqrt(static_cast<double>(s[k][k] * s[l][l])) * n;
                form.push_back(exact + 0.2 * change / n * (uniform(random) - 0.5) * scale);
                if (k == l) form.back() += change * scale;
            }
        Cloud const cloud = cloud_of(n, points);
        Certificate certificate;
        if (!certificate.prepare(cloud, center.data(), form.data())) continue;
        double const excess = certificate.excess(count, indices.data(), weights.data());
        Number const ratio = excess_of(form, s);
        auto const text = [&] {
            return "n = " + std::to_string(n) + ", points " +
                   hex_text(points.data(), std::min(m * n, 96)) + ", change " +
                   hex_text(&change, 1);
        };
        double const least = static_cast<double>(ratio);
        failures.check(ratio <= Number(excess), "too small", excess, least, text);
        // F² of the certificate is below (10³ change)² for the correlations of these points
        if (change <= 0x1p-32)
            failures.check(excess <= 1.01 * least + 1e-13, "too large", excess, least, text);
    }
}

} // namespace

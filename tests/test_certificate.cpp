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
        // weights: any sum; the covariance in 100 digits
        Number total(0);
        std::vector<Number> mean(size, Number(0));
        for (Size i = 0; i < count; ++i) total += Number(weights[i]);
        for (Size i = 0; i < count; ++i)
            for (Size k = 0; k < size; ++k)
                mean[k] += Number(weights[i]) * Number(points[i * size + k]) / total;
        Matrix s(size, std::vector<Number>(size, Number(0))), q = s;
        for (Size i = 0; i < count; ++i)
            for (Size k = 0; k < size; ++k)
                for (Size l = 0; l < size; ++l)
                    s[k][l] += Number(weights[i]) * (Number(points[i * size + k]) - mean[k]) *
                               (Number(points[i * size + l]) - mean[l]) / total;
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
                q[k][l] = q[l][k] = Number(form.back());
            }
        Cloud const cloud = cloud_of(n, points);
        Certificate certificate;
        if (!certificate.prepare(cloud, center.data(), form.data())) continue;
        double const excess = certificate.excess(count, indices.data(), weights.data());
        using std::sqrt;
        Number ratio = determinant(q) / determinant(s);
        for (int k = 0; k < n; ++k) ratio /= n;
        ratio = sqrt(ratio) - 1;
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

// SPDX-License-Identifier: BSD-3-Clause
// Pairs in n dimensions, and what is right for them, in numbers of 50 digits: full matrices,
// Gaussian elimination with row exchanges, and the root of μ1² - μ2² in log(λ/(1-λ)) by the method
// of Illinois. Nothing is shared with the library.
#ifndef PW85_TESTS_ANY_DIMENSION_TRUTH_HPP_INCLUDED
#define PW85_TESTS_ANY_DIMENSION_TRUTH_HPP_INCLUDED

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "golden_section.hpp"
#include "oracle/multiprecision.hpp"
#include "random_pairs.hpp"
#include "sample.hpp"

namespace pw85_tests::nd {

using Number = Multiprecision<50>;
using Size = std::size_t;

/// A pair in n dimensions, as the C API takes it.
struct Case {
    int n = 0;
    std::vector<double> r12, q1, q2;

    std::string text() const
    {
        return "n = " + std::to_string(n) + ", r12 = " + hex_text(r12.data(), n) +
               ", q1 = " + hex_text(q1.data(), int(q1.size())) +
               ", q2 = " + hex_text(q2.data(), int(q2.size()));
    }
    Case exchanged() const
    {
        Case other{n, r12, q2, q1};
        for (double &x : other.r12) x = -x;
        return other;
    }
};

inline Size packed_size(int n) { return Size(n * (n + 1) / 2); }

/// The place of entry (i, j), counted row by row.
inline Size place(int n, int i, int j)
{
    if (i > j) std::swap(i, j);
    Size k = 0;
    for (int row = 0; row < i; ++row) k += Size(n - row);
    return k + Size(j - i);
}

/// Orthogonal unit vectors.
inline std::vector<std::vector<double>> random_axes(Random &random, int n)
{
    std::vector<std::vector<double>> axes;
    for (int k = 0; k < n; ++k) {
        std::vector<double> x;
        for (int i = 0; i < n; ++i) x.push_back(random.normal());
        for (auto const &other : axes) {
            double along = 0;
            for (int i = 0; i < n; ++i) along += x[Size(i)] * other[Size(i)];
            for (int i = 0; i < n; ++i) x[Size(i)] -= along * other[Size(i)];
        }
        double norm = 0;
        for (double y : x) norm += y * y;
        for (double &y : x) y /= std::sqrt(norm);
        axes.push_back(x);
    }
    return axes;
}

/// A form with one semi-axis of `size`, one of size/aspect, others between.
inline std::vector<double> form_along(Random &random, std::vector<std::vector<double>> const &axes,
                                      double size, double aspect)
{
    int const n = int(axes.size());
    std::vector<double> q(packed_size(n));
    for (int k = 0; k < n; ++k) {
        auto const &x = axes[Size(k)];
        double const length = k == 0   ? size
                              : k == 1 ? size / aspect
                                       : size / random.log_uniform(1.0, aspect);
        for (int i = 0; i < n; ++i)
            for (int j = i; j < n; ++j)
                q[place(n, i, j)] += length * length * x[Size(i)] * x[Size(j)];
    }
    return q;
}

inline std::vector<double> random_form(Random &random, int n, double size, double aspect)
{
    return form_along(random, random_axes(random, n), size, aspect);
}

/// Two ellipsoids that are thin along the same direction, with centres apart across it. Their
/// condition number is small, while equations with their forms are ill-conditioned.
inline Case thin_case(Random &random, int n, double aspect)
{
    auto const axes = random_axes(random, n);
    Case c{n, std::vector<double>(Size(n)), form_along(random, axes, 1, aspect),
           form_along(random, axes, random.log_uniform(0.1, 10), aspect)};
    for (int k = 0; k < n; ++k) {
        double const along = k == 1 ? 0.0 : random.normal();
        for (int i = 0; i < n; ++i) c.r12[Size(i)] += along * axes[Size(k)][Size(i)];
    }
    return c;
}

inline Case random_case(Random &random, int n, double aspect)
{
    Case c{n, {}, {}, {}};
    double const size = random.log_uniform(0x1p-40, 0x1p40), ratio = random.log_uniform(0.1, 10);
    c.q1 = random_form(random, n, size, random.log_uniform(1.0, aspect));
    c.q2 = random_form(random, n, size * ratio, random.log_uniform(1.0, aspect));
    double const scale = size * random.log_uniform(0.1, 10);
    for (int i = 0; i < n; ++i) c.r12.push_back(scale * random.normal());
    return c;
}

using Row = std::vector<Number>;

/// M = w1 Q1 + w2 Q2 in full.
inline std::vector<Row> blend(Case const &c, Number const &w1, Number const &w2)
{
    std::vector<Row> m(Size(c.n), Row(Size(c.n)));
    for (int i = 0; i < c.n; ++i)
        for (int j = 0; j < c.n; ++j) {
            Size const k = place(c.n, i, j);
            m[Size(i)][Size(j)] = w1 * Number(c.q1[k]) + w2 * Number(c.q2[k]);
        }
    return m;
}

inline Row solve(std::vector<Row> m, Row b)
{
    Size const n = b.size();
    for (Size k = 0; k < n; ++k) {
        Size pivot = k;
        for (Size i = k + 1; i < n; ++i)
            if (abs(m[i][k]) > abs(m[pivot][k])) pivot = i;
        std::swap(m[k], m[pivot]);
        std::swap(b[k], b[pivot]);
        for (Size i = k + 1; i < n; ++i) {
            Number const factor = m[i][k] / m[k][k];
            for (Size j = k; j < n; ++j) m[i][j] -= factor * m[k][j];
            b[i] -= factor * b[k];
        }
    }
    for (Size k = n; k-- > 0;) {
        for (Size j = k + 1; j < n; ++j) b[k] -= m[k][j] * b[j];
        b[k] /= m[k][k];
    }
    return b;
}

inline Row times(std::vector<Row> const &m, Row const &x)
{
    Row y(x.size());
    for (Size i = 0; i < x.size(); ++i)
        for (Size j = 0; j < x.size(); ++j) y[i] += m[i][j] * x[j];
    return y;
}

inline Number dot(Row const &x, Row const &y)
{
    Number sum = 0;
    for (Size i = 0; i < x.size(); ++i) sum += x[i] * y[i];
    return sum;
}

/// f and the scale factors at one λ, and s.
struct Evaluated {
    Row s;
    Number f, mu1_squared, mu2_squared;
};

inline Evaluated evaluate(Case const &c, Number const &lambda)
{
    Number const rest = Number(1) - lambda;
    Row r;
    for (double x : c.r12) r.emplace_back(x);
    Row const s = solve(blend(c, rest, lambda), r);
    return {s, lambda * rest * dot(r, s), rest * rest * dot(s, times(blend(c, 1, 0), s)),
            lambda * lambda * dot(s, times(blend(c, 0, 1), s))};
}

struct Truth {
    Evaluated at;
    Number mu2, lambda, cond;
};

/// The condition number that data/README.md defines, with sums over n coordinates.
inline Number condition(Case const &c, Evaluated const &at, Number const &lambda)
{
    auto const m = blend(c, Number(1) - lambda, lambda);
    auto const m1 = blend(c, Number(1) - lambda, 0), m2 = blend(c, 0, lambda);
    Number sum = 0;
    for (Size i = 0; i < m.size(); ++i) {
        sum += Number(2) * abs(Number(c.r12[i]) * at.s[i]);
        for (Size j = 0; j < m.size(); ++j)
            sum += (abs(m1[i][j]) + abs(m2[i][j])) * abs(at.s[i] * at.s[j]);
    }
    return lambda * (Number(1) - lambda) * sum / at.f;
}

/// The maximum of f, to some 45 digits: f is stationary, and the root is found to 24 digits at
/// least.
inline Truth truth_of(Case const &c)
{
    auto const lambda_at = [](Number const &x) {
        Number const e = exp(-abs(x));
        return x > 0 ? Number(1) / (Number(1) + e) : e / (Number(1) + e);
    };
    auto const h = [&](Number const &x) {
        auto const at = evaluate(c, lambda_at(x));
        return log(at.mu2_squared / at.mu1_squared);
    };
    Number low = -1, high = 1, h_low = h(low), h_high = h(high);
    while (h_low > 0) low = low * 2, h_low = h(low);
    while (h_high < 0) high = high * 2, h_high = h(high);
    Number x = low;
    for (int i = 0, side = 0; i < 200 && high - low > ldexp(Number(1), -90); ++i) {
        x = i % 3 == 2 ? (low + high) / 2 : (low * h_high - high * h_low) / (h_high - h_low);
        Number const y = h(x);
        if (abs(y) < ldexp(Number(1), -120)) break;
        if (y < 0) {
            low = x, h_low = y;
            if (side == -1) h_high = h_high / 2;
            side = -1;
        } else {
            high = x, h_high = y;
            if (side == 1) h_low = h_low / 2;
            side = 1;
        }
    }
    Number const lambda = lambda_at(x);
    Evaluated const at = evaluate(c, lambda);
    return {at, at.f, lambda, condition(c, at, lambda)};
}

/// κ², the least of ν + rᵀ(Q1 - Q2/ν)⁻¹r where the matrix is positive definite, and S, its change
/// by relative changes of all entries.
struct ContainmentTruth {
    Number kappa2, sum;
};

/// ν + xᵀM⁻¹x; infinity where M is not positive definite: pivots without row exchanges.
inline Number gauge(Case const &c, Row x, Number const &nu)
{
    auto m = blend(c, 1, Number(-1) / nu);
    Number value = nu;
    for (Size k = 0; k < x.size(); ++k) {
        if (m[k][k] <= 0) return std::numeric_limits<Number>::infinity();
        value += x[k] * x[k] / m[k][k];
        for (Size i = k + 1; i < x.size(); ++i) {
            Number const factor = m[i][k] / m[k][k];
            x[i] -= factor * x[k];
            for (Size j = k + 1; j < x.size(); ++j) m[i][j] -= factor * m[k][j];
        }
    }
    return value;
}

/// κ² for the separation r, by golden section: some 24 digits of ν and 45 of κ². The r12 of the
/// case does not matter.
inline ContainmentTruth containment_truth(Case const &c, Row const &r)
{
    auto const value = [&](Number const &nu) { return gauge(c, r, nu); };
    Number high = 1;
    while (isinf(value(high))) high *= 2;
    Number const nu = golden_section<Number>(value, {0, value(high)}, 130).high;
    Row const s = solve(blend(c, 1, Number(-1) / nu), r);
    Number sum = 0;
    auto const m1 = blend(c, 1, 0), m2 = blend(c, 0, Number(1) / nu);
    for (Size i = 0; i < s.size(); ++i) {
        sum += Number(2) * abs(r[i] * s[i]);
        for (Size j = 0; j < s.size(); ++j)
            sum += (abs(m1[i][j]) + abs(m2[i][j])) * abs(s[i] * s[j]);
    }
    return {value(nu), sum};
}

inline ContainmentTruth containment_truth(Case const &c)
{
    return containment_truth(c, Row(c.r12.begin(), c.r12.end()));
}

} // namespace pw85_tests::nd

#endif

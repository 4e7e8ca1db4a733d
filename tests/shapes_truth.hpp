// SPDX-License-Identifier: BSD-3-Clause
// The contact function of an ellipsoid and convex sets by brute force in 50 digits: every face of
// the set, by Q⁻¹ for hulls of points and by the equations of Karush, Kuhn and Tucker for sets of
// inequalities.
#ifndef PW85_TESTS_SHAPES_TRUTH_HPP_INCLUDED
#define PW85_TESTS_SHAPES_TRUTH_HPP_INCLUDED

#include <vector>

#include "wide.hpp"

namespace pw85_tests {

inline WideForm inverse(WideForm const &q)
{
    auto const adjugate = pw85::detail::adjugate(q);
    return Wide(1 / pw85::detail::determinant(q, adjugate)) * adjugate;
}

/// The least xᵀQ⁻¹x, where it is, and what relative errors of one in the entries of Q and in the
/// points change of it.
struct NearestTruth {
    Wide mu2 = -1;
    WideVector point{};
    Wide sensitivity = 0; ///< S of nearest.hpp
    /// the change to second order: XᵀPX with X = Σ w_k |v_k| and P the magnitudes of Q⁻¹
    Wide square = 0;
};

/// Remembers the mean of points with these weights, if it is nearer.
template <std::size_t N> void take(NearestTruth &best, WideForm const &q,
                                   WideForm const &inverse_of_q, WideVector const (&points)[N],
                                   Wide const (&weights)[N])
{
    WideVector x{}, size{};
    for (std::size_t k = 0; k < N; ++k)
        for (int i = 0; i < 3; ++i) {
            x[i] += weights[k] * points[k][i];
            size[i] += weights[k] * abs(points[k][i]);
        }
    auto const s = pw85::product(inverse_of_q, x);
    Wide const mu2 = pw85::dot(s, x);
    if (best.mu2 >= 0 && best.mu2 <= mu2) return;
    best = {mu2, x, absolute_form(q, s), 0};
    for (int i = 0; i < 3; ++i) {
        best.sensitivity += 2 * abs(s[i]) * size[i];
        for (int j = 0; j < 3; ++j) best.square += abs(inverse_of_q(i, j)) * size[i] * size[j];
    }
}

/// The hull of one to three points.
template <std::size_t N>
NearestTruth nearest_in_hull(WideVector const (&points)[N], WideForm const &q)
{
    NearestTruth best;
    auto const p = inverse(q);
    auto const form = [&](std::size_t i, std::size_t j) {
        return pw85::dot(points[i], pw85::product(p, points[j]));
    };
    for (std::size_t i = 0; i < N; ++i) {
        Wide vertex[N] = {};
        vertex[i] = 1;
        take(best, q, p, points, vertex);
        for (std::size_t j = i + 1; j < N; ++j) {
            Wide const length = form(i, i) - 2 * form(i, j) + form(j, j);
            Wide const t = length > 0 ? Wide((form(i, i) - form(i, j)) / length) : Wide(-1);
            Wide edge[N] = {};
            edge[i] = 1 - t;
            edge[j] = t;
            if (t > 0 && t < 1) take(best, q, p, points, edge);
        }
    }
    if constexpr (N == 3) {
        auto const e1 = points[1] - points[0], e2 = points[2] - points[0];
        auto const p1 = pw85::product(p, e1), p2 = pw85::product(p, e2);
        Wide const a = pw85::dot(e1, p1), b = pw85::dot(e1, p2), c = pw85::dot(e2, p2);
        Wide const f = -pw85::dot(points[0], p1), g = -pw85::dot(points[0], p2), d = a * c - b * b;
        if (!(d > 0)) return best;
        Wide const s = (f * c - g * b) / d, t = (g * a - f * b) / d, weights[3] = {1 - s - t, s, t};
        if (s >= 0 && t >= 0 && s + t <= 1) take(best, q, p, points, weights);
    }
    return best;
}

/// The box lower <= x <= upper: every choice of faces, edges and vertices, with s on their normals
/// and x = Qs.
inline NearestTruth nearest_in_box(WideVector const &lower, WideVector const &upper,
                                   WideForm const &q)
{
    NearestTruth best;
    auto const p = inverse(q);
    for (int code = 0; code < 27; ++code) {
        int const bound[3] = {code % 3, code / 3 % 3, code / 9}; // none, lower, upper
        WideForm system{};
        WideVector x{};
        for (int i = 0; i < 3; ++i) {
            if (bound[i] != 0) x[i] = bound[i] == 1 ? lower[i] : upper[i];
            for (int j = i; j < 3; ++j)
                system(i, j) = bound[i] != 0 && bound[j] != 0 ? q(i, j) : Wide(i == j ? 1 : 0);
        }
        auto const s = pw85::product(inverse(system), x);
        auto const free = pw85::product(q, s);
        bool inside = true;
        for (int i = 0; i < 3; ++i) {
            if (bound[i] == 0) x[i] = free[i];
            inside = inside && lower[i] <= x[i] && x[i] <= upper[i];
        }
        WideVector const points[1] = {x};
        Wide const weights[1] = {1};
        if (inside) take(best, q, p, points, weights);
    }
    return best;
}

/// A polytope: normals·x <= offsets.
struct Planes {
    std::vector<double> normals, offsets;

    WideVector inward(std::size_t k) const
    {
        return {-Wide(normals[3 * k]), -Wide(normals[3 * k + 1]), -Wide(normals[3 * k + 2])};
    }

    /// m of polytope.hpp.
    Wide magnitude(std::size_t k) const { return abs(Wide(offsets[k])); }
};

/// A polytope relative to the centre of an ellipsoid that is elsewhere.
struct MovedPlanes {
    Planes given;
    WideVector center;
    std::vector<Wide> offsets;

    MovedPlanes(Planes const &planes, pw85::Vector<double, 3> const &c) : given(planes)
    {
        for (int i = 0; i < 3; ++i) center[i] = c[i];
        for (std::size_t k = 0; k < given.offsets.size(); ++k)
            offsets.push_back(given.offsets[k] + pw85::dot(inward(k), center));
    }

    WideVector inward(std::size_t k) const { return given.inward(k); }

    Wide magnitude(std::size_t k) const
    {
        return given.magnitude(k) + pw85::detail::magnitude_of_dot(inward(k), center);
    }
};

/// Whether a point is in a polytope, up to a part in 1e22.
inline bool contains(auto const &planes, WideVector const &x)
{
    using pw85::detail::sum_of_magnitudes;
    for (std::size_t k = 0; k < planes.offsets.size(); ++k) {
        auto const g = planes.inward(k);
        Wide const d = -Wide(planes.offsets[k]),
                   size = sum_of_magnitudes(g) * sum_of_magnitudes(x) + abs(d);
        if (pw85::dot(g, x) < d - Wide("1e-22") * size) return false;
    }
    return true;
}

/// The multipliers of planes that the scaled ellipsoid touches, by elimination. Returns false if
/// the planes do not intersect.
template <std::size_t K> bool multipliers(auto const &planes, WideForm const &q,
                                          std::size_t const (&chosen)[K], Wide (&lambda)[K])
{
    Wide m[K][K + 1];
    for (std::size_t i = 0; i < K; ++i) {
        for (std::size_t j = 0; j < K; ++j)
            m[i][j] =
                pw85::dot(planes.inward(chosen[i]), pw85::product(q, planes.inward(chosen[j])));
        m[i][K] = -Wide(planes.offsets[chosen[i]]);
    }
    for (std::size_t c = 0; c < K; ++c) {
        if (!(m[c][c] > Wide("1e-40"))) return false;
        for (std::size_t r = 0; r < K; ++r) {
            Wide const factor = r == c ? Wide(0) : Wide(m[r][c] / m[c][c]);
            for (std::size_t j = 0; j <= K; ++j) m[r][j] -= factor * m[c][j];
        }
    }
    for (std::size_t i = 0; i < K; ++i) lambda[i] = m[i][K] / m[i][i];
    return true;
}

/// Takes the point where the scaled ellipsoid touches some planes, if it is in the polytope and the
/// multipliers are positive. The sensitivity is Σ λ_k (|g_k|·r + m_k), r = Σ λ_k |Q| |g_k|.
template <std::size_t K> void touch(NearestTruth &best, auto const &planes, WideForm const &q,
                                    std::size_t const (&chosen)[K])
{
    Wide lambda[K], sensitivity = 0;
    if (!multipliers(planes, q, chosen, lambda)) return;
    WideVector s{}, r{};
    for (std::size_t k = 0; k < K; ++k) {
        auto const g = planes.inward(chosen[k]);
        if (lambda[k] < 0) return;
        for (int i = 0; i < 3; ++i) {
            s[i] += lambda[k] * g[i];
            for (int j = 0; j < 3; ++j) r[i] += lambda[k] * abs(q(i, j) * g[j]);
        }
    }
    auto const x = pw85::product(q, s);
    if (!contains(planes, x)) return;
    for (std::size_t k = 0; k < K; ++k) {
        auto const g = planes.inward(chosen[k]);
        sensitivity += lambda[k] * planes.magnitude(chosen[k]);
        for (int i = 0; i < 3; ++i) sensitivity += lambda[k] * abs(g[i]) * r[i];
    }
    Wide const mu2 = pw85::dot(x, s);
    if (best.mu2 < 0 || mu2 < best.mu2) best = {mu2, x, sensitivity, 0};
}

/// The polytope: every set of up to three planes. μ² is negative if it is empty.
inline NearestTruth nearest_in_polytope(auto const &planes, WideForm const &q)
{
    NearestTruth best;
    std::size_t const n = planes.offsets.size();
    if (contains(planes, WideVector{})) best.mu2 = 0;
    for (std::size_t i = 0; i < n && best.mu2 != 0; ++i) {
        touch<1>(best, planes, q, {i});
        for (std::size_t j = i + 1; j < n; ++j) {
            touch<2>(best, planes, q, {i, j});
            for (std::size_t k = j + 1; k < n; ++k) touch<3>(best, planes, q, {i, j, k});
        }
    }
    return best;
}

} // namespace pw85_tests

#endif

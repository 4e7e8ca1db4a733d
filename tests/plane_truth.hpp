// SPDX-License-Identifier: BSD-3-Clause
// The common part of two ellipses in many digits, by Green's theorem with angles. It shares nothing
// with the library.
//
// An ellipse is x(θ) = c + L e(θ) with the Cholesky factor L of its form and e = (cos θ, sin θ).
// The places where it meets the other one are roots of a polynomial of degree 4 in tan(θ/2), with
// their multiplicities by the roots of its derivatives.
#ifndef PW85_TESTS_PLANE_TRUTH_HPP_INCLUDED
#define PW85_TESTS_PLANE_TRUTH_HPP_INCLUDED

#include <algorithm>
#include <array>
#include <vector>

#include "sample.hpp"
#include "wide.hpp"

namespace pw85_tests {

struct Root {
    Wide place;
    int multiplicity;
};

/// A polynomial on [-1, 1]. A value counts as 0 if it is below 1e-42 of the sum of the
/// coefficients' magnitudes: numbers have 57 digits.
class PolynomialOnInterval {
  public:
    explicit PolynomialOnInterval(std::vector<Wide> const &coefficients) : c_(coefficients)
    {
        static Wide const share("1e-42");
        Wide size = 0;
        for (auto const &x : c_) size += abs(x);
        least_ = share * size;
    }

    bool vanishes() const { return !(least_ > 0); }

    Wide at(Wide const &t) const
    {
        Wide sum = 0;
        for (auto k = c_.size(); k-- > 0;) sum = sum * t + c_[k];
        return sum;
    }

    int sign(Wide const &t) const
    {
        Wide const x = at(t);
        return abs(x) <= least_ ? 0 : x > 0 ? 1 : -1;
    }

    PolynomialOnInterval derivative() const
    {
        std::vector<Wide> d;
        for (std::size_t k = 1; k < c_.size(); ++k) d.push_back(Wide(int(k)) * c_[k]);
        return PolynomialOnInterval(d);
    }

    /// The roots in increasing order. Those of the derivative separate them.
    std::vector<Root> roots() const
    {
        std::vector<Root> found;
        if (c_.size() < 2 || vanishes()) return found;
        Root low{Wide(-1), 0};
        auto stations = derivative().roots();
        stations.push_back({Wide(1), 0});
        for (auto const &high : stations) {
            int const a = sign(low.place), b = sign(high.place);
            if (a * b < 0) found.push_back({between(low.place, high.place, a), 1});
            if (b == 0 && high.multiplicity > 0)
                found.push_back({high.place, high.multiplicity + 1});
            low = high;
        }
        return found;
    }

  private:
    std::vector<Wide> c_;
    Wide least_;

    Wide between(Wide low, Wide high, int sign_at_low) const
    {
        static Wide const smallest_step("1e-55");
        auto const slope = derivative();
        Wide t = (low + high) / 2;
        for (int n = 0; n < 400; ++n) {
            Wide const value = at(t);
            if (value == 0) return t;
            ((value > 0) == (sign_at_low > 0) ? low : high) = t;
            Wide next = t - value / slope.at(t);
            if (!(next > low && next < high)) next = (low + high) / 2;
            if (abs(next - t) <= smallest_step) return next;
            t = next;
        }
        return t;
    }
};

struct WidePoint {
    Wide x, y;
};

/// An ellipse by its centre and its Cholesky factor (a, 0; b, d). θ begins at an angle that is no
/// symmetry of any test.
class WideEllipse {
  public:
    WideEllipse(WidePoint const &center, pw85::SymmetricMatrix<Wide, 2> const &q) : c(center)
    {
        a = sqrt(q[0]);
        b = q[1] / a;
        d = sqrt((q[0] * q[2] - q[1] * q[1]) / q[0]);
    }

    Wide determinant() const { return a * d; }

    /// L⁻¹x.
    WidePoint inverse(WidePoint const &x) const
    {
        Wide const y = x.x / a;
        return {y, (x.y - b * y) / d};
    }

    WidePoint at(Wide const &theta) const
    {
        Wide const x = cos(theta), y = sin(theta);
        return {c.x + a * x, c.y + b * x + d * y};
    }

    /// Negative inside of the other ellipse.
    Wide excess(Wide const &theta, WideEllipse const &other) const
    {
        auto const p = at(theta);
        auto const y = other.inverse({p.x - other.c.x, p.y - other.c.y});
        return y.x * y.x + y.y * y.y - 1;
    }

    /// The angles in [start, start + 2π) where this ellipse meets the other one.
    std::vector<Root> meetings(WideEllipse const &other, bool &identical) const
    {
        std::vector<Root> found;
        Wide const start = start_angle();
        for (int half = 0; half < 2; ++half) {
            Wide const middle = start + Wide(2 * half + 1) * quarter();
            PolynomialOnInterval const p(coefficients(other, middle));
            identical = p.vanishes();
            for (auto const &root : p.roots())
                found.push_back({middle + 2 * atan(root.place), root.multiplicity});
        }
        return found;
    }

    static Wide start_angle() { return Wide("0.7391"); }
    static Wide quarter() { return 2 * atan(Wide(1)); }

    WidePoint c;
    Wide a, b, d;

  private:
    /// (1 + t²)² excess(middle + 2 arctan t).
    std::vector<Wide> coefficients(WideEllipse const &other, Wide const &middle) const
    {
        Wide const cosine = cos(middle), sine = sin(middle);
        auto const u = other.inverse({c.x - other.c.x, c.y - other.c.y});
        auto const v = other.inverse({a * cosine, b * cosine + d * sine}),
                   w = other.inverse({-(a * sine), d * cosine - b * sine});
        auto const times = [](WidePoint const &p, WidePoint const &q) {
            return p.x * q.x + p.y * q.y;
        };
        Wide const k0 = times(u, u) - 1, kc = 2 * times(u, v), ks = 2 * times(u, w);
        Wide const kcc = times(v, v), kss = times(w, w), kcs = 2 * times(v, w);
        if (abs(k0 + kcc) + abs(kcc - kss) + abs(kc) + abs(ks) + abs(kcs) < Wide("1e-45"))
            return std::vector<Wide>(5, Wide(0));
        return {k0 + kc + kcc, 2 * ks + 2 * kcs, 2 * k0 - 2 * kcc + 4 * kss, 2 * ks - 2 * kcs,
                k0 - kc + kcc};
    }
};

/// The common part: its area, ∂A/∂r12, the derivatives with respect to both forms as matrices, and
/// those with respect to both angles.
struct PlaneTruth {
    Wide area;
    std::array<Wide, 2> r12;
    std::array<std::array<Wide, 3>, 2> q;
    std::array<Wide, 2> rotation;
    int crossings, touches, osculations; ///< roots of odd and even multiplicity, and of 3
    bool inside[2], identical;           ///< whether an ellipse is inside the other one
};

/// Adds an arc of ellipse k that is inside the other one.
inline void add_arc(PlaneTruth &sum, int k, WideEllipse const &e, Wide const &from, Wide const &to)
{
    auto const p = e.at(from), q = e.at(to);
    Wide const dx = q.x - p.x, dy = q.y - p.y, det = e.determinant(), angle = to - from;
    sum.area += (det * angle + e.c.x * dy - e.c.y * dx) / 2;
    if (k == 1) {
        sum.r12[0] += dy;
        sum.r12[1] -= dx;
    }
    // ∫ e eᵀ dθ, then L⁻ᵀ(…)L⁻¹
    Wide const second = (sin(2 * to) - sin(2 * from)) / 4, xx = angle / 2 + second,
               yy = angle / 2 - second, xy = (cos(2 * from) - cos(2 * to)) / 4;
    Wide const i00 = 1 / e.a, i11 = 1 / e.d, i10 = -(e.b / (e.a * e.d)), half = det / 2;
    sum.q[std::size_t(k)][0] += half * (i00 * i00 * xx + 2 * i00 * i10 * xy + i10 * i10 * yy);
    sum.q[std::size_t(k)][1] += half * i11 * (i00 * xy + i10 * yy);
    sum.q[std::size_t(k)][2] += half * i11 * i11 * yy;
    // the velocity of a rotation is (-y, x): L⁻¹ of it, as a matrix in e
    Wide const m00 = -(i00 * e.b), m01 = -(i00 * e.d), m10 = i10 * -e.b + i11 * e.a,
               m11 = -(i10 * e.d);
    sum.rotation[std::size_t(k)] += det * (m00 * xx + (m01 + m10) * xy + m11 * yy);
}

/// The arcs of ellipse k that are inside the other one.
inline void add_arcs(PlaneTruth &sum, int k, WideEllipse const &e, WideEllipse const &other)
{
    auto const roots = e.meetings(other, sum.identical);
    Wide const start = WideEllipse::start_angle(), turn = 4 * WideEllipse::quarter();
    if (sum.identical) {
        if (k == 0) add_arc(sum, k, e, start, start + turn);
        return;
    }
    sum.inside[k] = true;
    for (std::size_t n = 0; n < roots.size(); ++n) {
        Wide const from = roots[n].place,
                   to = n + 1 < roots.size() ? roots[n + 1].place : roots[0].place + turn;
        bool const is_inside = e.excess((from + to) / 2, other) < 0;
        if (is_inside) add_arc(sum, k, e, from, to);
        sum.inside[k] = sum.inside[k] && is_inside;
        if (k == 1) continue;
        ++(roots[n].multiplicity % 2 == 1 ? sum.crossings : sum.touches);
        sum.osculations += roots[n].multiplicity == 3;
    }
    if (!roots.empty()) return;
    sum.inside[k] = e.excess(start, other) < 0;
    if (sum.inside[k]) add_arc(sum, k, e, start, start + turn);
}

inline PlaneTruth plane_truth(Sample<Wide, 2> const &p)
{
    WideEllipse const first({Wide(0), Wide(0)}, p.q1), second({p.r12[0], p.r12[1]}, p.q2);
    PlaneTruth truth{};
    add_arcs(truth, 0, first, second);
    add_arcs(truth, 1, second, first);
    return truth;
}

} // namespace pw85_tests

#endif

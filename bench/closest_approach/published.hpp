// The method of Zheng et al. as they describe and program it, for comparison: ellipses by their axes and angles, one of
// them mapped to the unit circle; the quartic for q solved by Ferrari's formulas in complex arithmetic, with the root
// that the principal branches give; planes by a golden-section search for one maximum beside one minimum.
#ifndef PW85_BENCH_CLOSEST_APPROACH_PUBLISHED_HPP_INCLUDED
#define PW85_BENCH_CLOSEST_APPROACH_PUBLISHED_HPP_INCLUDED

#include <cmath>
#include <complex>
#include <numbers>

#include <pw85/symmetric.hpp>

namespace pw85_bench::published {

struct Ellipse {
    double a, b;  ///< a >= b
    double angle; ///< of the first axis to the direction of the line of centres, or to the x axis
};

struct Ellipsoid {
    pw85::Vector<double, 3> semi_axes;
    pw85::Vector<double, 3> axes[3]; ///< unit vectors
};

/// The root of A q⁴ + B q³ + C q² + D q + E that Ferrari's formulas give with principal branches.
inline std::complex<double> ferrari(double a, double b, double c, double d, double e)
{
    using Complex = std::complex<double>;
    double const alpha = -3.0 * b * b / (8.0 * a * a) + c / a;
    double const beta = b * b * b / (8.0 * a * a * a) - b * c / (2.0 * a * a) + d / a;
    double const gamma =
        -3.0 * b * b * b * b / (256.0 * a * a * a * a) + c * b * b / (16.0 * a * a * a) - b * d / (4.0 * a * a) + e / a;
    Complex const shift = -b / (4.0 * a);
    if (beta == 0.0) return shift + std::sqrt(0.5 * (-alpha + std::sqrt(Complex(alpha * alpha - 4.0 * gamma))));
    double const p = -alpha * alpha / 12.0 - gamma;
    double const q = -alpha * alpha * alpha / 108.0 + alpha * gamma / 3.0 - beta * beta / 8.0;
    Complex const u = std::pow(-0.5 * q + std::sqrt(Complex(0.25 * q * q + p * p * p / 27.0)), 1.0 / 3.0);
    Complex const y = -5.0 / 6.0 * alpha + (u == 0.0 ? -std::pow(Complex(q), 1.0 / 3.0) : u - p / (3.0 * u));
    Complex const w = std::sqrt(alpha + 2.0 * y);
    return shift + 0.5 * (w + std::sqrt(-(3.0 * alpha + 2.0 * y + 2.0 * beta / w)));
}

/// Distance from the unit circle to the ellipse a >= b, whose minor axis has the direction cosine c to the line of
/// centres.
inline double circle_and_ellipse(double a, double b, double c)
{
    double const delta = a * a / (b * b) - 1.0;
    if (delta == 0.0 || c == 0.0) return 1.0 + a;
    double const t = 1.0 / (c * c) - 1.0;
    auto const q = ferrari(-(1.0 + t) / (b * b), -2.0 * (1.0 + t + delta) / b,
                           -t - (1.0 + delta) * (1.0 + delta) + (1.0 + (1.0 + delta) * t) / (b * b),
                           2.0 * (1.0 + t) * (1.0 + delta) / b, (1.0 + t + delta) * (1.0 + delta));
    auto const s = (q * q - 1.0) / delta, x = 1.0 + b * (1.0 + delta) / q, y = 1.0 + b / q;
    return std::sqrt(s * x * x + (1.0 - s) * y * y).real();
}

/// Distance along the direction from which the angles count.
inline double ellipses(Ellipse const &e1, Ellipse const &e2)
{
    // In the frame of the first axis of ellipse 1, divided by a1 and b1, it is the unit circle.
    double const c = std::cos(e2.angle - e1.angle), s = std::sin(e2.angle - e1.angle);
    double const i2 = 1.0 / (e2.a * e2.a), j2 = 1.0 / (e2.b * e2.b);
    double const xx = e1.a * e1.a * (c * c * i2 + s * s * j2), yy = e1.b * e1.b * (s * s * i2 + c * c * j2);
    double const xy = e1.a * e1.b * c * s * (i2 - j2);
    double const mean = 0.5 * (xx + yy), radius = std::sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy);
    double const greater = mean + radius, less = mean - radius;
    double const dx = std::cos(e1.angle) / e1.a, dy = -std::sin(e1.angle) / e1.b, norm = std::hypot(dx, dy);
    double const half = 0.5 * std::atan2(2.0 * xy, xx - yy);
    double const cosine = (dx * std::cos(half) + dy * std::sin(half)) / norm;
    return circle_and_ellipse(1.0 / std::sqrt(less), 1.0 / std::sqrt(greater), cosine) / norm;
}

/// The ellipse in the plane of the unit vectors d and s.
inline Ellipse section(Ellipsoid const &e, pw85::Vector<double, 3> const &d, pw85::Vector<double, 3> const &s)
{
    double alpha = 0.0, beta = 0.0, gamma = 0.0;
    for (int k = 0; k < 3; ++k) {
        double const x = pw85::dot(e.axes[k], d) / e.semi_axes[k], y = pw85::dot(e.axes[k], s) / e.semi_axes[k];
        alpha += x * x;
        beta += x * y;
        gamma += y * y;
    }
    double const v = std::sqrt(4.0 * beta * beta + (alpha - gamma) * (alpha - gamma));
    double const angle = 0.5 * std::atan2(-2.0 * beta, gamma - alpha), sine = std::sin(angle);
    double const u = gamma + v * sine * sine;
    return {1.0 / std::sqrt(u - v), 1.0 / std::sqrt(u), angle};
}

/// The distance in the plane at the angle theta.
struct DistanceInPlane {
    Ellipsoid const &e1, &e2;
    pw85::Vector<double, 3> d, p, q;

    double operator()(double theta) const
    {
        pw85::Vector<double, 3> s{};
        for (int i = 0; i < 3; ++i) s[i] = std::cos(theta) * p[i] + std::sin(theta) * q[i];
        return ellipses(section(e1, d, s), section(e2, d, s));
    }
};

/// The paper's search (section 2.2.2) on [0, π], to an interval of 1e-9.
inline double golden_section(DistanceInPlane const &f)
{
    double const golden = 2.0 - std::numbers::phi, step = 1e-5;
    double lower = 0.0, upper = std::numbers::pi, left = lower + golden * (upper - lower);
    double right = upper - golden * (upper - lower);
    double at_lower = f(lower), at_left = f(left), at_right = f(right);
    while (upper - lower > 1e-9) {
        if ((at_lower <= at_left && at_left <= at_right) || (at_left <= at_lower && at_lower <= at_right)) {
            lower = left;
            at_lower = at_left;
            left = right;
            at_left = at_right;
            right = upper - golden * (upper - lower);
            at_right = f(right);
        } else if ((at_lower <= at_right && at_right <= at_left) || (at_right <= at_lower && at_lower <= at_left)) {
            upper = right;
            right = left;
            at_right = at_left;
            left = lower + golden * (upper - lower);
            at_left = f(left);
        } else {
            bool const rising = f(lower + step) > at_lower || f(lower - step) < at_lower;
            (rising ? upper : lower) = rising ? left : right;
            at_lower = rising ? at_lower : at_right;
            left = lower + golden * (upper - lower);
            right = upper - golden * (upper - lower);
            at_left = f(left);
            at_right = f(right);
        }
    }
    return at_lower;
}

/// Distance along the unit vector d.
inline double ellipsoids(Ellipsoid const &e1, Ellipsoid const &e2, pw85::Vector<double, 3> const &d)
{
    auto const normalize = [](pw85::Vector<double, 3> const &x) {
        return pw85::times(1.0 / std::sqrt(pw85::dot(x, x)), x);
    };
    auto p = pw85::cross(d, e1.axes[0]);
    if (pw85::dot(p, p) < 1e-28) p = pw85::cross(d, e1.axes[1]);
    p = normalize(p);
    return golden_section({e1, e2, d, p, pw85::cross(p, d)});
}

} // namespace pw85_bench::published

#endif

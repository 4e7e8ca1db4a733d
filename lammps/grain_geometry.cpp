// SPDX-License-Identifier: GPL-2.0-only
// Newton's iteration for the common normal, and the equivalent radius from the curvatures there.
#include "grain_geometry.hpp"

#include <pw85.h>

#include <algorithm>
#include <cmath>

namespace pw85_lammps {

namespace {

/// The iteration converges quadratically. After a step of this length in radians, the error of the normal is some 1e-12. That of the
/// depth, which is stationary, is its square.
constexpr double last_step = 0x1p-20;
constexpr int max_steps = 30;

/// A symmetric matrix on the tangent plane.
struct PlaneMatrix {
    double xx, xy, yy;

    double determinant() const { return xx * yy - xy * xy; }
};

/// The highest point of an ellipsoid along a unit vector, and its height h = √(n·Qn).
struct Support {
    double height;
    Vector point;
};

Support support(double const *q, Vector const &normal)
{
    Vector const image = product(q, normal);
    double const height = std::sqrt(dot(normal, image));
    return {height, (1.0 / height) * image};
}

/// Two unit vectors that complete a unit vector n to an orthonormal basis (Duff and others, Journal of Computer Graphics Techniques
/// 6, 1, 2017).
struct Tangents {
    explicit Tangents(Vector const &n)
    {
        double const sign = std::copysign(1.0, n[2]), a = -1.0 / (sign + n[2]), b = n[0] * n[1] * a;
        first = {1.0 + sign * n[0] * n[0] * a, sign * b, -sign * n[0]};
        second = {b, sign + n[1] * n[1] * a, -n[1]};
    }

    Vector first, second;
};

/// The second derivatives of h on the tangent plane, Q/h - pp/h. Their eigenvalues are the radii of curvature.
PlaneMatrix radii_of_curvature(double const *q, Support const &s, Tangents const &t)
{
    Vector const u = product(q, t.first), v = product(q, t.second);
    double const x = dot(t.first, s.point), y = dot(t.second, s.point), scale = 1.0 / s.height;
    return {scale * (dot(t.first, u) - x * x), scale * (dot(t.first, v) - x * y), scale * (dot(t.second, v) - y * y)};
}

PlaneMatrix inverse(PlaneMatrix const &m)
{
    double const factor = 1.0 / m.determinant();
    return {factor * m.yy, -factor * m.xy, factor * m.xx};
}

/// The motion of a point of support if the normal turns by (x, y) in the basis of the tangent plane.
Vector moved(PlaneMatrix const &m, Tangents const &t, double x, double y)
{
    return (m.xx * x + m.xy * y) * t.first + (m.xy * x + m.yy * y) * t.second;
}

PlaneMatrix operator+(PlaneMatrix const &a, PlaneMatrix const &b) { return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy}; }

/// Hertz's equivalent radius for the sum of the curvatures of both surfaces. The smaller curvature is at least a fraction of 2⁻²⁰ of
/// the larger one, because two surfaces with a common line have no such radius: a grain can fit to the curvature of a cylinder.
double equivalent_radius(PlaneMatrix const &sum)
{
    double const mean = 0.5 * (sum.xx + sum.yy), half = 0.5 * (sum.xx - sum.yy);
    double const largest = mean + std::sqrt(half * half + sum.xy * sum.xy);
    double const curvatures[2] = {std::clamp(sum.determinant() / largest, 0x1p-20 * largest, largest), largest};
    double radius = 0.0;
    pw85_hertz(curvatures, &radius, nullptr);
    return radius;
}

} // namespace

bool find_geometry(Vector const &r12, double const *q1, double const *q2, Vector const &start, GrainGeometry &result)
{
    Vector n = start;
    for (int step = 0; step < max_steps; ++step) {
        Support const s1 = support(q1, n), s2 = support(q2, n);
        Tangents const t(n);
        PlaneMatrix const m1 = radii_of_curvature(q1, s1, t), m2 = radii_of_curvature(q2, s2, t);
        Vector const slope = s1.point + s2.point - r12;
        double const depth = dot(n, slope), gx = dot(t.first, slope), gy = dot(t.second, slope);
        PlaneMatrix const m = m1 + m2 + PlaneMatrix{-depth, 0.0, -depth};
        if (!(m.xx > 0.0 && m.determinant() > 0.0)) return false;
        PlaneMatrix const inverted = inverse(m);
        double const dx = -(inverted.xx * gx + inverted.xy * gy), dy = -(inverted.xy * gx + inverted.yy * gy);
        double const square = dx * dx + dy * dy;
        Vector const turn = dx * t.first + dy * t.second;
        n = (1.0 / std::sqrt(1.0 + square)) * (n + turn);
        if (square <= last_step * last_step) {
            // The depth is stationary. The points move by their derivatives.
            result = {n, depth, s1.point + moved(m1, t, dx, dy), -1.0 * (s2.point + moved(m2, t, dx, dy)),
                      equivalent_radius(inverse(m1) + inverse(m2))};
            return true;
        }
    }
    return false;
}

GrainGeometry wall_geometry(double const *q, Vector const &normal, double distance, Vector const &direction,
                            double curvature)
{
    Support const s = support(q, normal);
    Tangents const t(normal);
    double const depth = s.height - distance, x = dot(t.first, direction), y = dot(t.second, direction);
    PlaneMatrix const wall{curvature * x * x, curvature * x * y, curvature * y * y};
    return {normal, depth, s.point, s.point - depth * normal,
            equivalent_radius(inverse(radii_of_curvature(q, s, t)) + wall)};
}

} // namespace pw85_lammps

// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Vectors of three numbers, and the angular velocity of a solid ellipsoid.
#ifndef PW85_LAMMPS_VECTORS_HPP_INCLUDED
#define PW85_LAMMPS_VECTORS_HPP_INCLUDED

#include <array>

namespace pw85_lammps {

using Vector = std::array<double, 3>;

inline Vector vector(double const *x) { return {x[0], x[1], x[2]}; }
inline Vector operator+(Vector const &a, Vector const &b)
{
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vector operator-(Vector const &a, Vector const &b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector operator*(double s, Vector const &a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(Vector const &a, Vector const &b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector cross(Vector const &a, Vector const &b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Returns Qx, for a form (xx, xy, xz, yy, yz, zz).
inline Vector product(double const *q, Vector const &x)
{
    return {q[0] * x[0] + q[1] * x[1] + q[2] * x[2], q[1] * x[0] + q[3] * x[1] + q[4] * x[2],
            q[2] * x[0] + q[4] * x[1] + q[5] * x[2]};
}

/// Returns I⁻¹x, for the inertia I = (m/5) ((tr Q) 1 - Q) of a solid ellipsoid: the angular
/// velocity of an angular momentum x. pw85_inertia() has the same tensor of a form, from which this
/// needs the inverse for each contact; tests/test_vectors.cpp compares them.
inline Vector without_inertia(double mass, double const *q, Vector const &x)
{
    double const a = q[3] + q[5], b = q[0] + q[5], c = q[0] + q[3], d = -q[4], e = -q[2], f = -q[1];
    double const aa = b * c - d * d, bb = a * c - e * e, cc = a * b - f * f;
    double const dd = e * f - a * d, ee = d * f - b * e, ff = d * e - c * f;
    double const factor = 5.0 / (mass * (a * aa + f * ff + e * ee));
    return {factor * (aa * x[0] + ff * x[1] + ee * x[2]),
            factor * (ff * x[0] + bb * x[1] + dd * x[2]),
            factor * (ee * x[0] + dd * x[1] + cc * x[2])};
}

} // namespace pw85_lammps

#endif

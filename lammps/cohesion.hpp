// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Attraction of grains: the contact of Johnson, Kendall and Roberts, and liquid bridges.
#ifndef PW85_LAMMPS_COHESION_HPP_INCLUDED
#define PW85_LAMMPS_COHESION_HPP_INCLUDED

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace pw85_lammps {

/// The contact of two elastic bodies with surface energy, of K. L. Johnson, K. Kendall and A. D.
/// Roberts (Proc. R. Soc. A 324, 301, 1971), with the constants of LAMMPS's `jkr`: γ is half of the
/// work of adhesion.
///
/// With s = √(πγE), t = √(πγ/E) and the radius a of the contact, the depth is δ = a²/R - 2t√a and
/// the force F = 4E a³/(3R) - 4s a^(3/2). The contact ends where the tension -F is largest, at
/// a^(3/2) = 3Rt/2.
class JkrContact {
  public:
    /// @param modulus E of both bodies
    JkrContact(double modulus, double surface_energy)
        : modulus_(modulus), s_(std::sqrt(std::numbers::pi * surface_energy * modulus)),
          t_(std::sqrt(std::numbers::pi * surface_energy / modulus))
    {
    }

    /// Returns the distance of the surfaces at which the contact ends, if their equivalent radius
    /// is R.
    double largest_gap(double radius) const { return 0.5 * t_ * std::cbrt(1.5 * radius * t_); }

    /// Returns the largest tension, 3πγR.
    double pull_off_force(double radius) const { return 3.0 * s_ * t_ * radius; }

    /// Returns the radius of the contact at a depth, which may be negative down to the end of the
    /// contact.
    ///
    /// √a is the largest root of x⁴/R - 2tx - δ, which is convex. It is less than (4Rt)^(1/3) or
    /// (2Rδ)^(1/4), from where Newton's method descends to it.
    double size(double radius, double depth) const
    {
        double x = std::max(std::cbrt(4.0 * radius * t_),
                            std::sqrt(std::sqrt(2.0 * radius * std::max(0.0, depth))));
        for (int step = 0; step < most_steps; ++step) {
            double const cube = x * x * x / radius;
            double const change = ((cube - 2.0 * t_) * x - depth) / (4.0 * cube - 2.0 * t_);
            if (!(change > 0.0)) break;
            x -= change;
        }
        return x * x;
    }

    double force(double radius, double size) const
    {
        return size * std::sqrt(size) *
               (4.0 / 3.0 * modulus_ * size * std::sqrt(size) / radius - 4.0 * s_);
    }

    /// Returns ∫F dδ from a = 0 on.
    double energy(double radius, double size) const
    {
        double const root = std::sqrt(size), square = size * size;
        return 8.0 / 15.0 * modulus_ * square * square * size / (radius * radius) -
               8.0 / 3.0 * s_ * square * size * root / radius + 2.0 * s_ * t_ * square;
    }

    /// Returns dF/dδ.
    double slope(double radius, double size) const
    {
        double const root = std::sqrt(size);
        return (4.0 * modulus_ * size * size / radius - 6.0 * s_ * root) /
               (2.0 * size / radius - t_ / root);
    }

  private:
    static constexpr int most_steps = 100; ///< some 6 are enough

    double modulus_, s_, t_;
};

/// A liquid bridge between two bodies.
///
/// The force is the closed form that C. D. Willett, M. J. Adams, S. A. Johnson and J. P. K. Seville
/// (Langmuir 16, 9396, 2000) fitted to the Laplace-Young equation: 2π ρ γ cosθ/(1 + 1.05 S + 2.5
/// S²), with S = gap √(ρ/V), for spheres of radius ρ; two others have 2/ρ as the sum of their
/// curvatures. The bridge ends at the gap (1 + θ/2) V^(1/3) (G. Lian, C. Thornton and M. J. Adams,
/// J. Colloid Interface Sci. 161, 138, 1993).
///
/// Other surfaces have the curvatures κ1 and κ2 of the gap, and ρ/2 = 1/√(κ1 κ2). This is exact in
/// Derjaguin's approximation (Kolloid-Z. 69, 155, 1934): the liquid fills the gap a + (κ1 x² + κ2
/// y²)/2 up to the height H = 2γ cosθ/p for its pressure -p. So the wetted area is 2π (H - a)/√(κ1
/// κ2), the volume π (H² - a²)/√(κ1 κ2), and the force, p times the area, 4π γ cosθ (1 - a/H)/√(κ1
/// κ2).
class LiquidBridge {
  public:
    LiquidBridge() = default;

    /// @param angle of contact, in radians
    LiquidBridge(double tension, double volume, double angle)
        : tension_(tension), volume_(volume), cosine_(std::cos(angle)),
          largest_gap_((1.0 + 0.5 * angle) * std::cbrt(volume))
    {
    }

    double largest_gap() const { return largest_gap_; }

    /// Returns ρ/2 for the curvatures of the gap.
    static double radius(std::array<double, 2> const &curvatures)
    {
        return 1.0 / std::sqrt(curvatures[0] * curvatures[1]);
    }

    /// Returns the attraction of surfaces that are apart by a gap, or touch.
    ///
    /// @param radius ρ/2
    double force(double radius, double gap) const
    {
        double const scaled = gap * inverse_length(radius);
        return strength(radius) / (1.0 + scaled * (1.05 + 2.5 * scaled));
    }

    /// Returns the energy, which is zero at the end of the bridge. If surfaces overlap, the gap is
    /// negative, and the force is that of a gap of zero.
    double energy(double radius, double gap) const
    {
        double const open = std::max(0.0, gap);
        return strength(radius) * (integral(radius, open) - integral(radius, largest_gap_)) +
               std::min(0.0, gap) * strength(radius);
    }

  private:
    double strength(double radius) const
    {
        return 4.0 * std::numbers::pi * radius * tension_ * cosine_;
    }
    double inverse_length(double radius) const { return std::sqrt(2.0 * radius / volume_); }

    /// Returns an integral of 1/(1 + 1.05 S + 2.5 S²) by the gap.
    double integral(double radius, double gap) const
    {
        double const per_length = inverse_length(radius), root = std::sqrt(10.0 - 1.05 * 1.05);
        return 2.0 / (root * per_length) * std::atan((5.0 * gap * per_length + 1.05) / root);
    }

    double tension_ = 0.0, volume_ = 0.0, cosine_ = 0.0, largest_gap_ = 0.0;
};

} // namespace pw85_lammps

#endif

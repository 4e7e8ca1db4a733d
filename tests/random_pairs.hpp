// SPDX-License-Identifier: BSD-3-Clause
// Random pairs of ellipsoids. The seeds are fixed and the generator is that of the C++ standard, so
// that every run on every platform uses the same pairs, up to the rounding of the mathematical
// functions.
#ifndef PW85_TESTS_RANDOM_PAIRS_HPP_INCLUDED
#define PW85_TESTS_RANDOM_PAIRS_HPP_INCLUDED

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "sample.hpp"

namespace pw85_tests {

class Random {
  public:
    explicit Random(std::uint64_t seed) : bits_(seed) {}

    double uniform(double lower, double upper)
    {
        return lower + (upper - lower) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
    }

    double sign() { return uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0; }

    double log_uniform(double lower, double upper)
    {
        return std::exp(uniform(std::log(lower), std::log(upper)));
    }

    double normal()
    {
        double const radius = std::sqrt(-2.0 * std::log(1.0 - uniform(0.0, 1.0)));
        return radius * std::cos(2.0 * std::numbers::pi * uniform(0.0, 1.0));
    }

    /// Isotropic: a direction for D = 3, a rotation (as a quaternion) for D = 4.
    template <int D> pw85::Vector<double, D> direction()
    {
        pw85::Vector<double, D> x{};
        double norm2 = 0.0;
        for (int i = 0; i < D; ++i) {
            x[i] = normal();
            norm2 += x[i] * x[i];
        }
        return 1.0 / std::sqrt(norm2) * x;
    }

    /// Semi-axes whose largest is `size`, in any order; aspect ratio exactly `aspect`, the one
    /// between random.
    pw85::Vector<double, 3> semi_axes(double size, double aspect)
    {
        double const between = size / log_uniform(1.0, aspect);
        return {size, between, size / aspect};
    }

    pw85::SymmetricMatrix<double, 3> form(double size, double aspect)
    {
        return pw85::ellipsoid_quaternion(semi_axes(size, aspect), direction<4>()).q;
    }

  private:
    std::mt19937_64 bits_;
};

/// The form of a random ellipsoid or ellipse with the largest semi-axis `size`.
template <int D>
pw85::SymmetricMatrix<double, D> random_form(Random &random, double size, double aspect)
{
    if constexpr (D == 3)
        return random.form(size, aspect);
    else
        return pw85::ellipse(size, size / aspect, random.uniform(0.0, std::numbers::pi)).q;
}

/// What random pairs range over.
struct PairOptions {
    double aspect = 10.0;    ///< largest aspect ratio of either, log-uniform from the smallest
    double size_ratio = 2.0; ///< largest ratio of the sizes, either way
    double mu2_min = 0.01, mu2_max = 100.0;
    double aspect_min = 1.0; ///< smallest aspect ratio
};

/// The pair with r12 along a direction and such a length that μ² is as given, to rounding.
template <int D> Sample<double, D> placed(pw85::Vector<double, D> const &direction, double mu2,
                                          pw85::SymmetricMatrix<double, D> const &q1,
                                          pw85::SymmetricMatrix<double, D> const &q2)
{
    double const reached = pw85::contact(direction, q1, q2).mu2;
    return {std::sqrt(mu2 / reached) * direction, q1, q2};
}

/// A pair of general ellipsoids (D = 3) or ellipses (D = 2) with μ² log-uniform in the given range.
template <int D> Sample<double, D> random_pair(Random &random, PairOptions const &options)
{
    auto const q1 =
        random_form<D>(random, 1.0, random.log_uniform(options.aspect_min, options.aspect));
    auto const q2 =
        random_form<D>(random, random.log_uniform(1.0 / options.size_ratio, options.size_ratio),
                       random.log_uniform(options.aspect_min, options.aspect));
    auto const direction = random.direction<D>();
    return placed(direction, random.log_uniform(options.mu2_min, options.mu2_max), q1, q2);
}

/// Slender shapes at right angles, tip to tip, so that λ is on a plateau of f: those of the
/// category `crossed` of the reference data, whose generator explains them. |μ² - 1| is from 1e-14
/// to 1e-1.
template <int D = 3> Sample<double, D> crossed_pair(Random &random, double aspect)
{
    double const shortest = 1.0 / aspect;
    double const third = std::pow(shortest, random.sign() < 0.0 ? 0.5 : random.uniform(0.0, 1.0));
    double const size = random.sign() < 0.0 ? 1.0 : random.log_uniform(0.1, 10.0);
    double const tilt1 = random.sign() * random.log_uniform(1e-14, 1e-1);
    double const tilt2 =
        random.sign() < 0.0 ? tilt1 : random.sign() * random.log_uniform(1e-14, 1e-1);
    double const offset = random.sign() * third * random.log_uniform(1e-8, 1.0);
    double const excess = random.sign() * random.log_uniform(1e-14, 1e-1);
    double const x = random.sign() * (1.0 + tilt1), y = random.sign() * size * (1.0 + tilt2);
    if constexpr (D == 2) {
        double const angle = random.uniform(0.0, std::numbers::pi), c = std::cos(angle),
                     s = std::sin(angle);
        return placed<2>({c * x - s * y, s * x + c * y}, 1.0 + excess,
                         pw85::ellipse(1.0, shortest, angle).q,
                         pw85::ellipse(size * shortest, size, angle).q);
    } else {
        auto const turn = random.direction<4>();
        auto const rotation = pw85::detail::rotation_matrix(turn, pw85::dot(turn, turn));
        pw85::Vector<double, 3> r12{};
        for (int i = 0; i < 3; ++i)
            r12[i] = rotation.entries[3 * i] * x + rotation.entries[3 * i + 1] * y +
                     rotation.entries[3 * i + 2] * offset;
        return placed<3>(
            r12, 1.0 + excess, pw85::ellipsoid({1.0, shortest, third}, rotation.entries).q,
            pw85::ellipsoid({size * shortest, size, size * third}, rotation.entries).q);
    }
}

} // namespace pw85_tests

#endif

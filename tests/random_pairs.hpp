// Random pairs of ellipsoids. Seeds are fixed and the generator is that of the standard, so that every run and every
// platform sees the same pairs, up to the rounding of the mathematical functions.
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

    double log_uniform(double lower, double upper) { return std::exp(uniform(std::log(lower), std::log(upper))); }

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
        return pw85::times(1.0 / std::sqrt(norm2), x);
    }

    /// Semi-axes whose largest is `size`, in any order; aspect ratio exactly `aspect`, the one between random.
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
template <int D> pw85::SymmetricMatrix<double, D> random_form(Random &random, double size, double aspect)
{
    if constexpr (D == 3)
        return random.form(size, aspect);
    else
        return pw85::ellipse(size, size / aspect, random.uniform(0.0, std::numbers::pi)).q;
}

/// What random pairs range over.
struct PairOptions {
    double aspect = 10.0;    ///< largest aspect ratio of either, log-uniform from 1
    double size_ratio = 2.0; ///< largest ratio of the sizes, either way
    double mu2_min = 0.01, mu2_max = 100.0;
};

/// A pair of general ellipsoids (D = 3) or ellipses (D = 2) with μ² log-uniform in the given range.
template <int D> Sample<double, D> random_pair(Random &random, PairOptions const &options)
{
    Sample<double, D> s{};
    s.q1 = random_form<D>(random, 1.0, random.log_uniform(1.0, options.aspect));
    s.q2 = random_form<D>(random, random.log_uniform(1.0 / options.size_ratio, options.size_ratio),
                          random.log_uniform(1.0, options.aspect));
    auto const direction = random.direction<D>();
    double const mu2 = pw85::contact(direction, s.q1, s.q2).mu2;
    s.r12 = pw85::times(std::sqrt(random.log_uniform(options.mu2_min, options.mu2_max) / mu2), direction);
    return s;
}

} // namespace pw85_tests

#endif

// SPDX-License-Identifier: BSD-3-Clause
// Pairs of ellipsoids of every regime whose numbers are the same on all machines: they come from
// integers by sums, products with powers of two and the exact overlap test, without a mathematical
// function.
#ifndef PW85_TESTS_PORTABLE_EXACT_PAIRS_HPP_INCLUDED
#define PW85_TESTS_PORTABLE_EXACT_PAIRS_HPP_INCLUDED

#include <cstdint>
#include <limits>

#include <pw85.h>

#include "../sample.hpp"

namespace pw85_tests {

/// The generator of S. Vigna, splitmix64.
class Integers {
  public:
    explicit Integers(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next()
    {
        std::uint64_t x = state_ += 0x9e3779b97f4a7c15u;
        x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
        x = (x ^ x >> 27) * 0x94d049bb133111ebu;
        return x ^ x >> 31;
    }

    /// From least to most.
    int between(int least, int most)
    {
        return least + static_cast<int>(next() % static_cast<std::uint64_t>(most - least + 1));
    }

  private:
    std::uint64_t state_;
};

inline double power_of_two(int exponent) { return pw85::detail::times_power_of_two(1.0, exponent); }

/// L Lᵀ of a matrix L whose columns are integers up to 1000 times powers of two from 1 to 2^-range.
/// The products of integers are exact, so it makes no difference whether the compiler fuses them
/// with the sums.
inline pw85::SymmetricMatrix<double, 3> exact_form(Integers &integers, int range)
{
    pw85::SymmetricMatrix<double, 3> q{};
    for (int k = 0; k < 3; ++k) {
        double const scale = power_of_two(-2 * integers.between(0, range));
        int column[3];
        for (int &x : column) x = integers.between(-1000, 1000);
        for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j)
                q(i, j) = q(i, j) + scale * static_cast<double>(column[i] * column[j]);
    }
    return q;
}

using ExactPair = Sample<double, 3>;

inline ExactPair scaled(ExactPair pair, int exponent)
{
    return {pw85::detail::times_power_of_two(pair.r12, exponent),
            pw85::detail::times_power_of_two(pair.q1, 2 * exponent),
            pw85::detail::times_power_of_two(pair.q2, 2 * exponent)};
}

inline bool do_overlap(ExactPair const &pair)
{
    int overlap = -1;
    pw85_overlap(pair.r12.coordinates, pair.q1.entries, pair.q2.entries, &overlap);
    return overlap == 1;
}

/// The pair with r12 times a factor of so many bits, such that the ellipsoids nearly touch.
inline ExactPair near_contact(ExactPair pair, int bits)
{
    while (do_overlap(pair) && pw85::detail::largest_coordinate(pair.r12) < 0x1p40)
        pair.r12 = 2.0 * pair.r12;
    pw85::Vector<double, 3> const far = pair.r12;
    double factor = 1.0;
    for (int k = 1; k <= bits; ++k) {
        pair.r12 = (factor - power_of_two(-k)) * far;
        if (!do_overlap(pair)) factor -= power_of_two(-k);
    }
    pair.r12 = factor * far;
    return pair;
}

/// Unit balls in contact under a linear map of integers, with r12 at most some units in the last
/// place off.
inline ExactPair tangent_pair(Integers &integers)
{
    constexpr int quadruples[][4] = {
        {1, 2, 2, 3}, {2, 3, 6, 7}, {1, 4, 8, 9}, {6, 6, 7, 11}, {0, 3, 4, 5}};
    auto const &quadruple = quadruples[integers.between(0, 4)];
    ExactPair pair{};
    int map[3][3];
    for (auto &row : map)
        for (int &x : row) x = integers.between(-9, 9);
    double const a1 = 0.25 * quadruple[3], a2 = quadruple[3] - a1;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            pair.r12[i] += map[i][k] * quadruple[k];
            for (int j = i; j < 3; ++j) {
                pair.q1(i, j) += map[i][k] * map[j][k] * a1 * a1;
                pair.q2(i, j) += map[i][k] * map[j][k] * a2 * a2;
            }
        }
    double const change = integers.between(-2, 2) * power_of_two(-integers.between(30, 52));
    pair.r12 = (1.0 + change) * pair.r12;
    return pair;
}

/// Needles along x and y, tip to tip.
inline ExactPair crossed_pair(Integers &integers)
{
    double const thin = power_of_two(-2 * integers.between(1, 26)),
                 flat = power_of_two(-2 * integers.between(0, 26));
    double const off = power_of_two(-integers.between(10, 50));
    ExactPair pair{};
    pair.q1(0, 0) = pair.q2(1, 1) = 1.0;
    pair.q1(1, 1) = pair.q2(0, 0) = thin;
    pair.q1(2, 2) = pair.q2(2, 2) = flat;
    pair.r12 = {1.0 + integers.between(-3, 3) * off, 1.0 + integers.between(-3, 3) * off, 0.0};
    return pair;
}

/// Concentric, flat, infinite or no number: 3 of 4 are not valid.
inline ExactPair special_pair(Integers &integers, ExactPair pair)
{
    switch (integers.between(0, 3)) {
    case 0:
        pair.r12 = {};
        break;
    case 1:
        pair.q1(2, 2) = -pair.q1(2, 2);
        break;
    case 2:
        pair.q2(0, 1) = std::numeric_limits<double>::infinity();
        break;
    default:
        pair.r12[1] = std::numeric_limits<double>::quiet_NaN();
    }
    return pair;
}

/// Aspect ratios to about 10, 1e4 and 1e8, relative sizes to 2^±40, sizes to 2^±500, near contact
/// or not.
inline ExactPair exact_pair(Integers &integers)
{
    int const regime = integers.between(0, 15), range = regime < 6    ? 2
                                                        : regime < 9  ? 13
                                                        : regime < 11 ? 26
                                                                      : 4;
    if (regime == 13) return tangent_pair(integers);
    if (regime == 14) return crossed_pair(integers);
    ExactPair pair{{}, exact_form(integers, range), exact_form(integers, range)};
    for (int i = 0; i < 3; ++i) pair.r12[i] = integers.between(-2500, 2500);
    if (regime == 11) {
        int const exponent = integers.between(-40, 40);
        pair.q2 = pw85::detail::times_power_of_two(pair.q2, 2 * exponent);
        if (exponent > 0) pair.r12 = pw85::detail::times_power_of_two(pair.r12, exponent);
    }
    if (regime == 15 && integers.between(0, 7) == 0) return special_pair(integers, pair);
    if (integers.between(0, 1) == 0)
        pair = near_contact(pair, integers.between(4, integers.between(8, 40)));
    return regime == 12 ? scaled(pair, integers.between(-500, 480)) : pair;
}

} // namespace pw85_tests

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Simulations of hard particles for tests: how they start, their states, and means with errors.
#ifndef PW85_TESTS_HARD_PARTICLES_HPP_INCLUDED
#define PW85_TESTS_HARD_PARTICLES_HPP_INCLUDED

#include <array>
#include <cmath>
#include <vector>

#include <glib.h>

#include <pw85/pw85.hpp>
#include <pw85/simulation.hpp>

#include "failures.hpp"

namespace pw85_tests {

using pw85::CellChange;
using pw85::HardEllipsoids;
using pw85::Status;
using Vector3 = pw85::Vector<double, 3>;
using Quaternion = pw85::Vector<double, 4>;

/// The arguments of a simulation.
struct Start {
    std::vector<Vector3> centers, semi_axes;
    std::vector<Quaternion> quaternions;
    pw85::Cell cell{};
    std::array<int, 3> periodic = {1, 1, 1};

    void add(Vector3 const &center, Vector3 const &axes,
             Quaternion const &quaternion = {1.0, 0.0, 0.0, 0.0})
    {
        centers.push_back(center);
        semi_axes.push_back(axes);
        quaternions.push_back(quaternion);
    }

    Status create(HardEllipsoids &simulation, pw85::IndexPair &pair, std::size_t seed = 1) const
    {
        return hard_ellipsoids_create({centers, {}, &cell, periodic}, semi_axes, quaternions, seed,
                                      simulation, pair);
    }

    HardEllipsoids simulation(std::size_t seed = 1) const
    {
        HardEllipsoids simulation;
        pw85::IndexPair pair;
        g_assert_true(create(simulation, pair, seed) == Status::success);
        return simulation;
    }
};

inline pw85::Cell box(double x, double y, double z)
{
    return {{{x, 0.0, 0.0}, {0.0, y, 0.0}, {0.0, 0.0, z}}};
}

inline std::vector<unsigned char> bytes_of(HardEllipsoids const &simulation)
{
    std::vector<unsigned char> bytes(simulation.num_bytes());
    g_assert_true(simulation.save(bytes) == Status::success);
    return bytes;
}

inline void expect_no_overlap(HardEllipsoids const &simulation)
{
    pw85::IndexPair pair;
    g_assert_true(simulation.check(pair) == Status::success);
    g_assert_true(pair[0] == -1 && pair[1] == -1);
}

/// Means over blocks, and the error of their mean.
class Blocks {
  public:
    explicit Blocks(int length) : length_(length) {}

    void add(double x)
    {
        sum_ += x;
        if (++count_ % length_ != 0) return;
        double const mean = sum_ / length_;
        total_ += mean;
        squares_ += mean * mean;
        sum_ = 0.0;
    }

    double mean() const { return total_ / blocks(); }
    double error() const
    {
        return std::sqrt(std::max(0.0, squares_ / blocks() - mean() * mean()) / (blocks() - 1.0));
    }

    /// Checks that the mean differs from a value by at most four errors and a systematic error.
    void expect(char const *what, double expected, double systematic = 0.0) const
    {
        double const most = 4.0 * error() + systematic;
        g_test_message("%s: %.5f +- %.5f, expected %.5f", what, mean(), error(), expected);
        if (!(std::fabs(mean() - expected) <= most))
            g_test_fail_printf("%s: %a instead of %a, error %a", what, mean(), expected, error());
    }

  private:
    double blocks() const { return count_ / length_; }

    int length_, count_ = 0;
    double sum_ = 0.0, total_ = 0.0, squares_ = 0.0;
};

/// Counts of changes from one state to another. In detailed balance the change back is as frequent.
class Changes {
  public:
    explicit Changes(std::size_t num_states) : n_(num_states), counts_(num_states * num_states) {}

    /// The states of all particles before and after a sweep.
    void add(std::vector<std::size_t> const &before, std::vector<std::size_t> const &after)
    {
        for (std::size_t i = 0; i < after.size(); ++i) counts_[n_ * before[i] + after[i]] += 1.0;
    }

    /// Changes that follow each other tend to cancel, so that the variance of a difference is at
    /// most the number of changes.
    void expect_balance(double least_pairs) const
    {
        double sum = 0.0, expected = 0.0;
        for (std::size_t i = 0; i < n_; ++i)
            for (std::size_t j = 0; j < i; ++j) {
                double const there = counts_[n_ * i + j], back = counts_[n_ * j + i];
                if (there + back < 10.0) continue;
                sum += (there - back) * (there - back) / (there + back);
                expected += 1.0;
            }
        g_test_message("chi^2 %.1f of %.0f pairs of states", sum, expected);
        g_assert_cmpfloat(expected, >, least_pairs);
        if (!(sum < expected + 4.0 * std::sqrt(2.0 * expected)))
            g_test_fail_printf("chi^2 %a of %a", sum, expected);
    }

  private:
    std::size_t n_;
    std::vector<double> counts_;
};

} // namespace pw85_tests

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The energy of pairs in addition to the hard core, a law of μ². sweep.cpp and volume_moves.cpp
/// compute it after the overlap test.
///
/// 1. A trial that changes the sum of the energies by ΔU is accepted with the probability
///    min(1, e^-ΔU), beside the other conditions. The product of such probabilities is in detailed
///    balance with the product of the densities. The random number is drawn only if ΔU > 0.
/// 2. Energies are rounded to multiples of 2⁻³² k_B T, and added as integers. So the sum depends
///    neither on the order of the rows nor on the number of threads.
/// 3. The energy is 0 from some μ on, the reach. Rows, rough boxes and domains are those of
///    ellipsoids that are enlarged by the reach: Verlet lists have all pairs with an energy.
#ifndef PW85_SIMULATION_PAIR_ENERGY_HPP_INCLUDED
#define PW85_SIMULATION_PAIR_ENERGY_HPP_INCLUDED

#include <pw85_systems.h>

#include <algorithm>
#include <cstdint>
#include <limits>

#include "../simd/lanes/laws.hpp"
#include "configuration.hpp"

namespace pw85::detail::simulation {

/// A sum of energies of pairs, in halves of a unit: an image of a particle and the opposite one are
/// one pair.
struct EnergySum {
    static constexpr double half_unit = 0x1p-33;

    std::int64_t halves = 0;
    bool is_bad = false; ///< true if the energy of a pair was NaN

    /// In the unit of k_B T.
    double energy() const noexcept { return half_unit * static_cast<double>(halves); }

    void add(EnergySum const &other) noexcept
    {
        halves += other.halves;
        is_bad |= other.is_bad;
    }
};

class PairEnergy {
  public:
    /// The largest energy of a pair, in the unit of k_B T. The sum over 10³ such pairs does not
    /// overflow.
    static constexpr double largest = 0x1p20;

    /// The largest reach. No list of neighbours would have memory for a longer one.
    static constexpr double farthest = 1000.0;

    /// Pairs whose energies are computed together.
    static constexpr std::size_t most_at_once = 16;

    /// Takes the law of another array, or none for null and for the kind 0. Returns a status. On
    /// error nothing changes.
    int set(pw85_law const *law) noexcept;

    bool exists() const noexcept { return parameters_.size() > 0; }

    /// Returns the factor of ellipsoids that touch where the energy of the pair begins; 1 without a
    /// law.
    double reach() const noexcept { return reach_; }

    /// Returns the law. It points to the array of this object.
    pw85_law law() const noexcept { return {kind_, parameters_.size(), parameters_.data()}; }

    /// Returns the energy of a pair, which counts once or twice.
    EnergySum of(double mu2, int count) const noexcept;

    /// Returns the energies of at most most_at_once pairs by their separations and forms, in lanes.
    EnergySum of_pairs(double const *r12, double const *q1, double const *q2, int const *counts,
                       std::size_t n) const noexcept;

    /// Computes the energy of all pairs of a configuration, by a list of neighbours of its own.
    /// Returns a status.
    int of_all(Configuration const &all, EnergySum &sum) const noexcept;

    /// Computes the virial -2 Σ μ² dβU/dμ² of the same pairs: the trace of Σ r12 ⊗ force on the
    /// second particle, because r12·∂μ²/∂r12 = 2 μ². Returns a status.
    int virial_of_all(Configuration const &all, double &virial) const noexcept;

  private:
    Array<double> parameters_;
    int kind_ = 0;
    kernels::InversePowers powers_{}; ///< for this kind
    double reach_ = 1.0;
};

/// Collects pairs, and adds their energies, many at a time.
class EnergyCollector {
  public:
    [[gnu::always_inline]] explicit EnergyCollector(PairEnergy const &energies) noexcept
        : energies_(energies)
    {
    }

    /// Adds a pair, which counts once or twice.
    [[gnu::always_inline]] void add(Vector3 const &r12, Form3 const &q1, Form3 const &q2,
                                    int count) noexcept
    {
        std::copy_n(r12.coordinates, 3, r12_ + 3 * size_);
        std::copy_n(q1.entries, 6, q1_ + 6 * size_);
        std::copy_n(q2.entries, 6, q2_ + 6 * size_);
        counts_[size_++] = count;
        if (size_ == most) finish();
    }

    [[gnu::always_inline]] EnergySum sum() noexcept
    {
        finish();
        return sum_;
    }

  private:
    static constexpr std::size_t most = PairEnergy::most_at_once;

    [[gnu::always_inline]] void finish() noexcept
    {
        if (size_ > 0) sum_.add(energies_.of_pairs(r12_, q1_, q2_, counts_, size_));
        size_ = 0;
    }

    PairEnergy const &energies_;
    EnergySum sum_;
    std::size_t size_ = 0;
    double r12_[3 * most], q1_[6 * most], q2_[6 * most];
    int counts_[most];
};

} // namespace pw85::detail::simulation

#endif

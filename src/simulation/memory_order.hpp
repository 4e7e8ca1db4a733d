// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The order of the particles in the memory of the engine. MemoryOrder follow Morton's curve, so
/// that particles that are near each other in the cell are near in memory. The results of a
/// simulation do not depend on it.
#ifndef PW85_SIMULATION_MEMORY_ORDER_HPP_INCLUDED
#define PW85_SIMULATION_MEMORY_ORDER_HPP_INCLUDED

#include <span>

#include "configuration.hpp"

namespace pw85::detail::simulation {

class MemoryOrder {
  public:
    /// Orders the particles of a configuration. Returns a status; on error the places stay as they
    /// are.
    int prepare(Configuration const &configuration) noexcept;

    /// Returns the places of all particles.
    std::span<std::int32_t const> all() const noexcept { return {places_.data(), places_.size()}; }

    std::size_t of(std::size_t particle) const noexcept
    {
        return static_cast<std::size_t>(places_[particle]);
    }

    std::int32_t particle(std::size_t place) const noexcept { return particles_[place]; }

  private:
    Array<std::int32_t> places_, particles_;
};

} // namespace pw85::detail::simulation

#endif

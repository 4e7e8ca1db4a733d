/// @file
/// Divides the cell into domains in which particles can be moved at the same time. engine.cpp makes them anew for each sweep.
///
/// 1. Vector k of the cell is divided into an even number of equal parts, from a random origin on, or is not divided. A domain is a
///    parallelepiped of parts. Its colour says which of its parts have odd numbers, so that there are 1, 2, 4 or 8 colours.
/// 2. Between two domains of a colour there is a part of some vector. A part is wider than the reach of the particles, so that no
///    particle of one domain can touch a particle of the other.
/// 3. A particle belongs to the domain of its centre. While a domain is worked on, its particles do not leave it. So the division
///    stays as it is. No thread reads a particle of another domain of its colour (is_apart()). So neither the order of domains of a
///    colour nor the number of threads matters.
#ifndef PW85_SIMULATION_DOMAINS_HPP_INCLUDED
#define PW85_SIMULATION_DOMAINS_HPP_INCLUDED

#include <algorithm>
#include <cmath>
#include <span>

#include "configuration.hpp"
#include "random.hpp"

namespace pw85::detail::simulation {

class Domains {
  public:
    /// Chooses the division and its origin, and assigns the particles.
    ///
    /// @param places of the particles in the configuration: members() are in this order
    /// @param reach more than the distance of the centres of any particles that touch, by some per cent for rounding errors
    /// @return a status
    int prepare(Configuration const &configuration, std::span<std::int32_t const> places, double reach,
                Stream &stream) noexcept;

    /// The number of parts of vector k.
    std::uint32_t num_parts(int k) const noexcept { return parts_[k]; }

    std::uint32_t num_colors() const noexcept { return 1u << (is_divided(0) + is_divided(1) + is_divided(2)); }

    /// The number of domains of each colour.
    std::uint32_t num_domains() const noexcept { return parts_[0] * parts_[1] * parts_[2] / num_colors(); }

    /// The domain with number `place` of a colour.
    std::uint32_t domain(std::uint32_t color, std::uint32_t place) const noexcept;

    std::span<std::int32_t const> members(std::uint32_t domain) const noexcept
    {
        return {members_.data() + begin_[domain], begin_[domain + 1] - begin_[domain]};
    }

    /// The label of the domain of a centre: its number and the parity of its parts.
    [[gnu::always_inline]] std::uint32_t label_of(Vector3 const &center) const noexcept
    {
        std::uint32_t domain = 0, parity = 0;
        for (int k = 0; k < 3; ++k) {
            double const x = dot(dual_[k], center) + origin_[k];
            auto const part = std::min(static_cast<std::uint32_t>((x - std::floor(x)) * parts_[k]), parts_[k] - 1);
            domain = domain * parts_[k] + part;
            parity = 2 * parity + (part & 1);
        }
        return 8 * domain + parity;
    }

    /// The label of the domain of a particle in its place.
    std::uint32_t label(std::size_t place) const noexcept { return labels_[place]; }

    /// Whether two labels are those of different domains of a colour.
    [[gnu::always_inline]] static bool is_apart(std::uint32_t label1, std::uint32_t label2) noexcept
    {
        return label1 != label2 && ((label1 ^ label2) & 7) == 0;
    }

  private:
    bool is_divided(int k) const noexcept { return parts_[k] > 1; }
    bool assign(Configuration const &configuration, std::span<std::int32_t const> places) noexcept;

    std::uint32_t parts_[3] = {1, 1, 1};
    Vector3 dual_[3] = {};
    double origin_[3] = {};
    Array<std::uint32_t> labels_;
    Array<std::size_t> begin_;
    Array<std::int32_t> members_;
};

} // namespace pw85::detail::simulation

#endif

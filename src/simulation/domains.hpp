// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Divides the cell into domains in which particles can be moved at the same time. sweep.cpp makes
/// new ones for each sweep.
///
/// 1. Vector k of the cell is divided into an even number of equal parts, from a random origin on,
///    or is not divided. A domain is a parallelepiped of parts. Its colour says which of its parts
///    have odd numbers: there are 1, 2, 4 or 8 colours.
/// 2. Between two domains of a colour there is a part of some vector. A part is wider than the
///    reach of the particles: no particle of one domain can touch a particle of the other.
/// 3. A particle belongs to the domain of its centre. While a thread works on a domain, its
///    particles do not leave it. So the division stays valid. A thread reads only particles of its
///    domain and of the domains next to it (ReadableDomains). So the order of two domains matters
///    only if they are next to each other. domain_scheduler.hpp keeps this order for any number of
///    threads.
#ifndef PW85_SIMULATION_DOMAINS_HPP_INCLUDED
#define PW85_SIMULATION_DOMAINS_HPP_INCLUDED

#include <cstdint>
#include <span>

#include <pw85/algebra/philox.hpp>

#include "../base/list.hpp"
#include "configuration.hpp"

namespace pw85::detail::simulation {

/// A domain: the numbers of its parts, six bits for each vector.
class Label {
  public:
    static constexpr std::uint32_t most_parts = 64;

    Label() noexcept = default;
    [[gnu::always_inline]] explicit Label(std::uint32_t const *parts) noexcept
        : bits_(parts[0] << 12 | parts[1] << 6 | parts[2])
    {
    }

    [[gnu::always_inline]] std::uint32_t part(int k) const noexcept
    {
        return bits_ >> (12 - 6 * k) & 63u;
    }

    [[gnu::always_inline]] bool operator==(Label const &) const noexcept = default;

  private:
    std::uint32_t bits_;
};

/// Domains that a thread may read while it works on a domain: this one and those next to it.
/// They are marked, by their numbers. A single thread uses no marks, and reads all domains.
struct ReadableDomains {
    std::uint8_t const *marks = nullptr;

    [[gnu::always_inline]] bool are_all() const noexcept { return marks == nullptr; }

    [[gnu::always_inline]] bool contain(std::uint32_t number) const noexcept
    {
        return are_all() || marks[number] != 0;
    }
};

class Domains {
  public:
    /// Chooses the division and its origin, and assigns the particles.
    ///
    /// @param places of the particles in the configuration: members() are in this order
    /// @param reach more than the distance of the centres of any particles that touch, by some per
    /// cent for rounding errors
    /// @return a status
    int prepare(Configuration const &configuration, std::span<std::int32_t const> places,
                double reach, Stream &stream) noexcept;

    /// Returns the number of parts of vector k.
    std::uint32_t num_parts(int k) const noexcept { return parts_[k]; }

    std::uint32_t num_colors() const noexcept
    {
        return 1u << (is_divided(0) + is_divided(1) + is_divided(2));
    }

    /// Returns the number of all domains.
    std::uint32_t size() const noexcept { return parts_[0] * parts_[1] * parts_[2]; }

    /// Returns the number of domains of each colour.
    std::uint32_t num_domains() const noexcept { return size() / num_colors(); }

    /// Returns the domain with number `place` of a colour.
    Label domain(std::uint32_t color, std::uint32_t place) const noexcept;

    /// Returns a number for each domain, from 0 on.
    [[gnu::always_inline]] std::uint32_t number(Label label) const noexcept
    {
        return (label.part(0) * parts_[1] + label.part(1)) * parts_[2] + label.part(2);
    }

    std::span<std::int32_t const> members(Label label) const noexcept
    {
        std::size_t const begin = begin_[number(label)];
        return {members_.data() + begin, begin_[number(label) + 1] - begin};
    }

    /// Lists the places of the particles of which an image may be within `range` of a centre along
    /// each axis, and of others. Returns false if there is no memory.
    [[nodiscard]] bool list_near(Vector3 const &center, double range,
                                 List<std::int32_t> &found) const noexcept;

    /// Sets the marks of a domain and of those next to it.
    void mark_readable(Label label, std::uint8_t mark, std::uint8_t *marks) const noexcept;

    /// Returns the domain of a centre.
    [[gnu::always_inline]] Label label_of(Vector3 const &center) const noexcept
    {
        std::uint32_t part[3];
        for (int k = 0; k < 3; ++k) {
            double const x = dot(dual_[k], center) + origin_[k];
            part[k] = minimum(static_cast<std::uint32_t>((x - elementary::floor(x)) * parts_[k]),
                              parts_[k] - 1);
        }
        return Label(part);
    }

    /// Returns the number of the domain of a particle in its place.
    [[gnu::always_inline]] std::uint32_t number_at(std::size_t place) const noexcept
    {
        return numbers_[place];
    }

  private:
    /// Some consecutive parts of a vector, which may continue from the last part to the first one.
    struct Parts {
        std::uint32_t first, count;
    };

    Parts parts_near(int k, Vector3 const &center, double range) const noexcept;
    bool is_divided(int k) const noexcept { return parts_[k] > 1; }
    bool assign(Configuration const &configuration, std::span<std::int32_t const> places) noexcept;

    std::uint32_t parts_[3] = {1, 1, 1};
    Vector3 dual_[3] = {};
    double origin_[3] = {};
    Array<std::uint32_t> numbers_; ///< of the domains of the places
    Array<std::size_t> begin_;
    Array<std::int32_t> members_;
};

} // namespace pw85::detail::simulation

#endif

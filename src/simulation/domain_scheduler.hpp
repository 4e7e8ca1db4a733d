// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The order in which threads work on the domains of a sweep (domains.hpp). sweep.cpp calls this.
///
/// 1. The colours have a random order. A domain comes after those domains next to it whose colours
///    come before its own. Domains that are not next to each other may be worked on in any order
///    and at the same time, whatever their colours are. So the result is that of one domain after
///    the other, colour by colour.
/// 2. The order of the domains follows a curve through the cell as closely as (1) allows: each is
///    preceded by those that it has to wait for. So all the work on a region is done while its
///    particles are in the cache. Colour by colour, each particle would be read from memory up to
///    eight times in a sweep.
/// 3. Each thread begins in its own part of the order, takes the next domain that is ready, and
///    begins again at the end. If there is none, it waits a little. So no thread waits for the end
///    of a colour.
/// 4. Work that stops leaves its domain to be taken up again by the next call of for_all(). Until
///    then, the domains after it wait.
#ifndef PW85_SIMULATION_DOMAIN_SCHEDULER_HPP_INCLUDED
#define PW85_SIMULATION_DOMAIN_SCHEDULER_HPP_INCLUDED

#include <atomic>

#include "../base/parallel.hpp"
#include "domains.hpp"

namespace pw85::detail::simulation {

class DomainScheduler {
  public:
    /// Draws the order of the colours. Returns false if there is no memory.
    [[nodiscard]] bool prepare(Domains const &domains, Stream &stream) noexcept;

    std::size_t size() const noexcept { return order_.size(); }

    /// Returns a domain by its position in the order.
    Label domain(std::size_t position) const noexcept { return order_[position]; }

    /// Calls work(position) for all domains that are not finished, in parallel. It returns whether
    /// it finishes the domain.
    ///
    /// @return whether all domains are finished
    template <class Work> bool for_all(Domains const &domains, Work const &work) noexcept
    {
        restart(domains);
        in_each_thread(threads_if(domains.num_domains() > 1), [&] {
            for (std::size_t position = first_of_thread(); take(domains, position); ++position)
                leave(domains, position, work(position));
        });
        return unfinished_.load() == 0;
    }

  private:
    enum State : std::uint8_t { waiting, taken, stopped, finished, not_in_order };

    /// The domains of some consecutive parts of each vector.
    struct Region {
        std::uint32_t first[3], count[3];
    };

    void restart(Domains const &domains) noexcept;
    bool take(Domains const &domains, std::size_t &position) noexcept;
    bool take_next(Domains const &domains, std::size_t &position) noexcept;
    void leave(Domains const &domains, std::size_t position, bool is_finished) noexcept;
    bool is_ready(Domains const &domains, Label label) const noexcept;
    template <class Visit>
    bool for_those_before(Domains const &domains, Label label, Visit const &visit) const noexcept;
    std::size_t first_of_thread() const noexcept;
    void append(Domains const &domains, Label label) noexcept;
    void append_region(Domains const &domains, Region const &region) noexcept;

    [[gnu::always_inline]] std::uint8_t &state(Domains const &domains, Label label) noexcept
    {
        return states_[domains.number(label)];
    }

    [[gnu::always_inline]] static unsigned color_of(Label label) noexcept
    {
        return (label.part(0) & 1) << 2 | (label.part(1) & 1) << 1 | (label.part(2) & 1);
    }

    Array<Label> order_;
    std::size_t length_ = 0;      ///< of the order while it is made
    Array<std::uint8_t> states_;  ///< by numbers of domains; read and written as atomic variables
    std::uint32_t ranks_[8] = {}; ///< of the colours in the order
    std::atomic<std::size_t> unfinished_{0}, stopped_{0}, working_{0}; ///< numbers of domains
};

} // namespace pw85::detail::simulation

#endif

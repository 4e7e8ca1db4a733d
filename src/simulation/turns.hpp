/// @file
/// The order in which threads work on the domains of a sweep (domains.hpp). engine.cpp calls this.
///
/// 1. The colours have a random order. A domain comes after those domains next to it whose colours come before its own. Two domains
///    that are not next to each other may be worked on at the same time, whatever their colours are. So the result is that of one
///    domain after the other, colour by colour.
/// 2. A thread takes the first domain that is ready. If there is none, it waits a little. So no thread waits for the end of a colour.
/// 3. Work that stops leaves its domain to be taken up again by the next call of for_all(). Until then, the domains after it wait.
#ifndef PW85_SIMULATION_TURNS_HPP_INCLUDED
#define PW85_SIMULATION_TURNS_HPP_INCLUDED

#include <atomic>

#include "../floating_point_environment.hpp"
#include "domains.hpp"

namespace pw85::detail::simulation {

class Turns {
  public:
    /// Draws the order of the colours. Returns false if there is no memory.
    [[nodiscard]] bool prepare(Domains const &domains, Stream &stream) noexcept;

    std::size_t size() const noexcept { return order_.size(); }

    /// A domain by its position in the order.
    Label domain(std::size_t position) const noexcept { return order_[position]; }

    /// Calls work(position) for all domains that are not finished, in parallel. It returns whether it finishes the domain.
    ///
    /// @return whether all domains are finished
    template <class Work> bool for_all(Domains const &domains, Work const &work) noexcept
    {
        restart(domains);
#pragma omp parallel if (domains.num_domains() > 1)
        {
            DefaultEnvironment const environment; // each thread has its own environment
            for (std::size_t position; take(domains, position);) leave(domains, position, work(position));
        }
        return unfinished_.load() == 0;
    }

  private:
    enum State : std::uint8_t { waiting, taken, stopped, finished };

    void restart(Domains const &domains) noexcept;
    bool take(Domains const &domains, std::size_t &position) noexcept;
    bool take_first(Domains const &domains, std::size_t &position) noexcept;
    void leave(Domains const &domains, std::size_t position, bool is_finished) noexcept;
    bool is_ready(Domains const &domains, Label label) const noexcept;

    [[gnu::always_inline]] std::uint8_t &state(Domains const &domains, Label label) noexcept
    {
        return states_[domains.number(label)];
    }

    [[gnu::always_inline]] static unsigned color_of(Label label) noexcept
    {
        return (label.part(0) & 1) << 2 | (label.part(1) & 1) << 1 | (label.part(2) & 1);
    }

    Array<Label> order_;
    Array<std::uint8_t> states_;        ///< by numbers of domains; read and written as atomic variables
    std::uint32_t ranks_[8] = {};       ///< of the colours in the order
    std::atomic<std::size_t> first_{0}; ///< no domain before this position waits
    std::atomic<std::size_t> unfinished_{0}, stopped_{0};
};

} // namespace pw85::detail::simulation

#endif

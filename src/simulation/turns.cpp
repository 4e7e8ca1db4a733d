// Tells threads which domain is next: see turns.hpp.
#include "turns.hpp"

#include <algorithm>
#include <thread>

namespace pw85::detail::simulation {

namespace {

/// How often a thread looks for a domain before it lets other threads run. That takes less time than the work on a domain.
constexpr int most_looks = 100;

} // namespace

bool Turns::prepare(Domains const &domains, Stream &stream) noexcept
{
    std::uint32_t const num_colors = domains.num_colors(), num_domains = domains.num_domains();
    if (!order_.resize(std::size_t{num_colors} * num_domains) || !states_.resize(order_.size())) return false;
    std::uint32_t colors[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    for (std::uint32_t k = num_colors; k > 1; --k) std::swap(colors[k - 1], colors[stream.below(k)]);
    for (std::uint32_t k = 0; k < num_colors; ++k) {
        for (std::uint32_t place = 0; place < num_domains; ++place)
            order_[k * num_domains + place] = domains.domain(colors[k], place);
        ranks_[color_of(order_[k * num_domains])] = k;
    }
    std::fill_n(states_.data(), states_.size(), std::uint8_t{waiting});
    unfinished_ = order_.size();
    return true;
}

void Turns::restart(Domains const &domains) noexcept
{
    first_ = stopped_ = 0;
    for (Label const label : std::span(order_.data(), order_.size()))
        if (state(domains, label) == stopped) state(domains, label) = waiting;
}

/// Whether all domains are finished that come before one and are next to it.
bool Turns::is_ready(Domains const &domains, Label label) const noexcept
{
    std::uint32_t const rank = ranks_[color_of(label)];
    for (unsigned k = 0; k < 27; ++k) {
        unsigned const steps[3] = {k / 9, k / 3 % 3, k % 3};
        std::uint32_t parts[3];
        for (int d = 0; d < 3; ++d)
            parts[d] = (label.part(d) + domains.num_parts(d) + steps[d] - 1) % domains.num_parts(d);
        Label const other(parts);
        if (ranks_[color_of(other)] >= rank) continue;
        if (__atomic_load_n(&states_[domains.number(other)], __ATOMIC_ACQUIRE) != finished) return false;
    }
    return true;
}

bool Turns::take_first(Domains const &domains, std::size_t &position) noexcept
{
    bool is_first = true;
    for (position = first_.load(std::memory_order_relaxed); position < size(); ++position) {
        std::uint8_t &state = this->state(domains, order_[position]), expected = waiting;
        if (__atomic_load_n(&state, __ATOMIC_RELAXED) != waiting) continue;
        if (is_first) first_.store(position, std::memory_order_relaxed);
        is_first = false;
        if (is_ready(domains, order_[position]) &&
            __atomic_compare_exchange_n(&state, &expected, taken, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED))
            return true;
    }
    return false;
}

/// Finds the next domain, and waits for it. Returns false if there is none, or if the rest may wait for a domain that is stopped.
bool Turns::take(Domains const &domains, std::size_t &position) noexcept
{
    for (int looks = 1;; ++looks) {
        if (take_first(domains, position)) return true;
        if (unfinished_.load(std::memory_order_acquire) == 0 || stopped_.load(std::memory_order_relaxed) > 0)
            return false;
        if (looks % most_looks == 0) std::this_thread::yield();
    }
}

void Turns::leave(Domains const &domains, std::size_t position, bool is_finished) noexcept
{
    __atomic_store_n(&state(domains, order_[position]), is_finished ? finished : stopped, __ATOMIC_RELEASE);
    if (is_finished)
        unfinished_.fetch_sub(1, std::memory_order_release);
    else
        stopped_.fetch_add(1, std::memory_order_relaxed);
}

} // namespace pw85::detail::simulation

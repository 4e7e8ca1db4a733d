// SPDX-License-Identifier: BSD-3-Clause
// Tells threads which domain is next: see domain_scheduler.hpp.
#include "domain_scheduler.hpp"

#include <algorithm>
#include <thread>

namespace pw85::detail::simulation {

namespace {

/// Maximum number of times that a thread looks for a domain before it lets other threads run. That
/// takes less time than the work on a domain.
constexpr int most_looks = 100;

} // namespace

bool DomainScheduler::prepare(Domains const &domains, Stream &stream) noexcept
{
    std::uint32_t const num_colors = domains.num_colors(), num_domains = domains.num_domains();
    if (!order_.resize(std::size_t{num_colors} * num_domains) || !states_.resize(order_.size()))
        return false;
    std::uint32_t colors[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    for (std::uint32_t k = num_colors; k > 1; --k)
        std::swap(colors[k - 1], colors[stream.below(k)]);
    for (std::uint32_t k = 0; k < num_colors; ++k)
        ranks_[color_of(domains.domain(colors[k], 0))] = k;
    std::fill_n(states_.data(), states_.size(), std::uint8_t{not_in_order});
    length_ = 0;
    append_region(domains,
                  {{0, 0, 0}, {domains.num_parts(0), domains.num_parts(1), domains.num_parts(2)}});
    unfinished_ = order_.size();
    return true;
}

/// Calls visit(other) for the adjacent domains that come before a domain, as long as it returns
/// true. Returns whether it always did.
template <class Visit> bool DomainScheduler::for_those_before(Domains const &domains, Label label,
                                                              Visit const &visit) const noexcept
{
    std::uint32_t around[3][3];
    for (int d = 0; d < 3; ++d) {
        std::uint32_t const part = label.part(d), last = domains.num_parts(d) - 1;
        around[d][0] = part > 0 ? part - 1 : last;
        around[d][1] = part;
        around[d][2] = part < last ? part + 1 : 0;
    }
    std::uint32_t const rank = ranks_[color_of(label)];
    for (std::uint32_t const x : around[0])
        for (std::uint32_t const y : around[1])
            for (std::uint32_t const z : around[2]) {
                std::uint32_t const parts[3] = {x, y, z};
                Label const other(parts);
                if (ranks_[color_of(other)] < rank && !visit(other)) return false;
            }
    return true;
}

/// Appends a domain to the order, after those that come before it. The ranks fall, so at most eight
/// calls are open.
void DomainScheduler::append(Domains const &domains, Label label) noexcept
{
    if (state(domains, label) == waiting) return;
    for_those_before(domains, label, [&](Label other) {
        append(domains, other);
        return true;
    });
    state(domains, label) = waiting;
    order_[length_++] = label;
}

/// Appends the domains of a region, first those of one half. So successive domains are near each
/// other, along all vectors.
void DomainScheduler::append_region(Domains const &domains, Region const &region) noexcept
{
    auto const &[first, count] = region;
    auto const k = std::max_element(count, count + 3) - count;
    if (count[k] == 1) return append(domains, Label(first));
    Region lower = region, upper = region;
    lower.count[k] = count[k] / 2;
    upper.first[k] += lower.count[k];
    upper.count[k] -= lower.count[k];
    append_region(domains, lower);
    append_region(domains, upper);
}

void DomainScheduler::restart(Domains const &domains) noexcept
{
    stopped_ = 0;
    for (Label const label : std::span(order_.data(), order_.size()))
        if (state(domains, label) == stopped) state(domains, label) = waiting;
}

/// Returns the position in the order at which the calling thread begins: threads begin at equal
/// distances.
std::size_t DomainScheduler::first_of_thread() const noexcept
{
    auto const [thread, threads] = this_thread();
    return size() * thread / threads;
}

/// Returns whether all adjacent domains that come before a domain are finished.
bool DomainScheduler::is_ready(Domains const &domains, Label label) const noexcept
{
    return for_those_before(domains, label, [&](Label other) {
        return __atomic_load_n(&states_[domains.number(other)], __ATOMIC_ACQUIRE) == finished;
    });
}

/// Takes the first domain that is ready, from a position on or from the first one on.
bool DomainScheduler::take_next(Domains const &domains, std::size_t &position) noexcept
{
    for (std::size_t k = 0; k < size(); ++k, ++position) {
        if (position >= size()) position = 0;
        std::uint8_t &state = this->state(domains, order_[position]), expected = waiting;
        if (__atomic_load_n(&state, __ATOMIC_RELAXED) == waiting &&
            is_ready(domains, order_[position]) &&
            __atomic_compare_exchange_n(&state, &expected, taken, false, __ATOMIC_RELAXED,
                                        __ATOMIC_RELAXED)) {
            working_.fetch_add(1, std::memory_order_relaxed);
            return true;
        }
    }
    return false;
}

/// Finds the next domain, and waits until it is ready. Returns false if there is none, or if a
/// domain is stopped and no thread is working, after whose work another domain could be ready. So
/// as few domains as possible remain for the next call of for_all().
bool DomainScheduler::take(Domains const &domains, std::size_t &position) noexcept
{
    for (int looks = 1;; ++looks) {
        if (take_next(domains, position)) return true;
        bool const none_is_left = unfinished_.load(std::memory_order_acquire) == 0;
        if (none_is_left || (stopped_.load(std::memory_order_relaxed) > 0 &&
                             working_.load(std::memory_order_acquire) == 0))
            return false;
        if (looks % most_looks == 0) std::this_thread::yield();
    }
}

void DomainScheduler::leave(Domains const &domains, std::size_t position, bool is_finished) noexcept
{
    __atomic_store_n(&state(domains, order_[position]), is_finished ? finished : stopped,
                     __ATOMIC_RELEASE);
    if (is_finished)
        unfinished_.fetch_sub(1, std::memory_order_release);
    else
        stopped_.fetch_add(1, std::memory_order_relaxed);
    working_.fetch_sub(1, std::memory_order_release);
}

} // namespace pw85::detail::simulation

/// @file
/// The contact function of many pairs, one per lane: a driver of the search on the rational form.
///
/// Each stage runs over all packs of a chunk before the next one begins: stages are short and packs independent, so that the
/// processor works on several at a time. Pairs that are out of the ordinary, and those for which the search is not certain, go to
/// the scalar solver.
#ifndef PW85_KERNELS_LANE_CONTACT_HPP_INCLUDED
#define PW85_KERNELS_LANE_CONTACT_HPP_INCLUDED

#include <pw85/contact.hpp>

#include "rows.hpp"

namespace pw85 {
namespace {

/// Packs per chunk: their searches, 0.75 kB each with 8 lanes, leave the rest of 16 kB of stack to what else is on it.
inline constexpr std::size_t packs_per_chunk = 8;
inline constexpr std::size_t contact_chunk_size = packs_per_chunk * lanes;

/// Steps until no lane of up to packs_per_chunk packs is active.
PW85_INLINE void run(RationalSearch<Pack> *searches, std::size_t packs) noexcept
{
    std::uint8_t active[packs_per_chunk];
    for (std::size_t k = 0; k < packs && k < packs_per_chunk; ++k) active[k] = static_cast<std::uint8_t>(k);
    std::size_t num_active = packs;
    for (int step = 0; step < max_rational_steps && num_active > 0; ++step) {
        std::size_t num_left = 0;
        for (std::size_t k = 0; k < num_active; ++k) {
            RationalSearch<Pack> &search = searches[active[k]];
            take_step(search, Pack(1.0));
            active[num_left] = active[k];
            num_left += any_of(search.active);
        }
        num_active = num_left;
    }
}

/// Stores neighbouring results; those that are not certain will be overwritten.
PW85_INLINE void store(Pack const &x, std::size_t count, double *out) noexcept
{
    if (count >= lanes)
        std::memcpy(out, &x.v, sizeof x.v);
    else
        for (std::size_t i = 0; i < count; ++i) out[i] = x[i];
}

/// The contact function of up to contact_chunk_size neighbouring pairs; those left to the scalar solver go to `rejected`.
template <class Rows>
[[gnu::noinline, gnu::flatten]] inline void contact_chunk(Rows const &rows, std::size_t count,
                                                          kernels::ContactArrays const &out,
                                                          OffsetList<contact_chunk_size> &rejected) noexcept
{
    RationalSearch<Pack> searches[packs_per_chunk];
    std::size_t const begin = rejected.begin(), packs = (count + lanes - 1) / lanes;
    for (std::size_t k = 0; k < packs; ++k) {
        LanePair const pair = load_neighbors(rows, begin + k * lanes, count - k * lanes);
        searches[k] = start_search(pair, initial_guess(pair));
    }
    run(searches, packs);
    for (std::size_t k = 0; k < packs; ++k) {
        LanePair const pair = load_neighbors(rows, begin + k * lanes, count - k * lanes);
        auto const last = last_evaluation(pair, searches[k].candidate);
        std::size_t const first = k * lanes, left = count - first;
        store(last.value.mu2, left, out.mu2 + begin + first);
        if (out.lambda != nullptr) store(last.value.lambda, left, out.lambda + begin + first);
        unsigned const done = (last.certain && is_ordinary(pair.r12, pair.q1, pair.q2)).to_bits();
        for (unsigned bits = live_lanes(left) & ~done; bits != 0; bits &= bits - 1)
            rejected.push(first + static_cast<unsigned>(__builtin_ctz(bits)));
    }
}

/// The contact function of a list of pairs by the scalar solver.
template <class Rows> inline kernels::Failure contact_one_by_one(Rows const &rows, OffsetList<contact_chunk_size> &list,
                                                                 kernels::ContactArrays const &out,
                                                                 kernels::ScalarKernels const &scalar) noexcept
{
    kernels::Failure first{0, 0};
    visit_pairs(rows, list, [&](std::size_t index, double const *r12, double const *q1, double const *q2) {
        double contact[2];
        first.update({index, scalar.contact(r12, q1, q2, contact)});
        out.mu2[index] = contact[0];
        if (out.lambda != nullptr) out.lambda[index] = contact[1];
    });
    return first;
}

/// The contact function of a range of pairs.
template <class Rows> inline kernels::Failure contact_rows(Rows const &rows, kernels::Range range,
                                                           kernels::ContactArrays const &out,
                                                           kernels::ScalarKernels const &scalar) noexcept
{
    kernels::Failure first{0, 0};
    for (std::size_t begin = range.begin; begin < range.end; begin += contact_chunk_size) {
        std::size_t const left = range.end - begin, count = left < contact_chunk_size ? left : contact_chunk_size;
        rows.prefetch(begin + count, range.end);
        OffsetList<contact_chunk_size> rejected(begin);
        contact_chunk(rows, count, out, rejected);
        if (rejected.size() > 0) first.update(contact_one_by_one(rows, rejected, out, scalar));
    }
    return first;
}

} // namespace
} // namespace pw85

#endif

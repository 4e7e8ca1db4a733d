/// @file
/// The contact function, one pair per lane.
///
/// The start and the steps are those of the scalar solver on the rational form. Each stage runs over all packs of a chunk before the next
/// one begins: stages are short and packs independent, so that the processor works on several at a time. A lane that has
/// converged is left alone, so that what happens to a pair depends on nothing but the pair. Pairs that are out of the
/// ordinary, ill-conditioned, or slow go to the scalar solver.
#ifndef PW85_BATCH_LANE_CONTACT_HPP_INCLUDED
#define PW85_BATCH_LANE_CONTACT_HPP_INCLUDED

#include <pw85/contact.hpp>

#include "rows.hpp"

namespace pw85 {
namespace {

/// Packs per chunk: their states, 1.6 kB each with 8 lanes, fit into a first-level cache of 32 kB.
inline constexpr std::size_t packs_per_chunk = 16;
inline constexpr std::size_t contact_chunk_size = packs_per_chunk * lanes;

/// What is known of the pairs of a pack.
struct LaneState {
    LanePair pair;
    RationalForm<Pack> form;
    Candidate<Pack> candidate;
    unsigned ordinary; ///< lanes of ordinary pairs
    unsigned active;   ///< lanes that have not converged
};

PW85_INLINE void start(LaneState &state, LanePair const &pair) noexcept
{
    state.pair = pair;
    state.form = rational_form(pair);
    state.candidate = {initial_guess(pair), Pack(1.0), Pack(0.0)};
    state.ordinary = is_ordinary(pair.r12, pair.q1, pair.q2).to_bits();
    state.active = all_lanes;
}

/// The first step, which is never the last.
PW85_INLINE void first_step(LaneState &state) noexcept
{
    Pack const ratio = Pack(1.0), t = state.candidate.t;
    Jet<Pack> const jet = evaluate_jet(state.form, t);
    Slope<Pack> const s = slope(jet, ratio, t);
    PackMask const near = is_near(s);
    Pack factor = exponential(halley_step(s));
    if (!all_of(near)) factor = select(near, factor, secular_factor(jet, ratio, t));
    state.candidate.t = t * factor;
}

/// Another step of the active lanes.
PW85_INLINE void next_step(LaneState &state) noexcept
{
    Pack const ratio = Pack(1.0), t = state.candidate.t;
    PackMask const active = PackMask::from_bits(state.active);
    Jet<Pack> const jet = evaluate_jet(state.form, t);
    Slope<Pack> const s = slope(jet, ratio, t);
    Step<Pack> const step = halley_step(s);
    PackMask const near = is_near(s);
    Candidate<Pack> candidate = advance(t, s, step);
    if (!all_of(near)) candidate.t = select(near, candidate.t, t * secular_factor(jet, ratio, t));
    state.candidate = {select(active, candidate.t, t), select(active, candidate.k, state.candidate.k),
                       select(active, candidate.k2, state.candidate.k2)};
    state.active = (active && !(near && is_within(step, penultimate_step<Pack>()))).to_bits();
}

/// Steps until all lanes of up to packs_per_chunk packs have converged, five at most as in the scalar solver.
PW85_INLINE void search(LaneState *states, std::size_t packs) noexcept
{
    std::uint8_t active[packs_per_chunk];
    for (std::size_t k = 0; k < packs && k < packs_per_chunk; ++k) { // the compiler cannot know it
        first_step(states[k]);
        active[k] = static_cast<std::uint8_t>(k);
    }
    std::size_t num_active = packs;
    for (int step = 2; step <= 5 && num_active > 0; ++step) {
        std::size_t num_left = 0;
        for (std::size_t k = 0; k < num_active; ++k) {
            next_step(states[active[k]]);
            active[num_left] = active[k];
            num_left += states[active[k]].active != 0;
        }
        num_active = num_left;
    }
}

/// The contact function of a pack.
struct LaneContact {
    Pack mu2, lambda;
    unsigned done; ///< lanes where it is right
};

/// The last evaluation, by the adjugate of M at t, under the conditions of the scalar solver.
PW85_INLINE LaneContact finish(LaneState const &state) noexcept
{
    LanePair const &pair = state.pair;
    auto const solution = solve_by_adjugate(blend(pair.q1, state.candidate.t, pair.q2), pair.r12);
    auto const weights = outer_weights(solution.s);
    Finish<Pack> const last = finish(state.candidate, Pack(1.0), quadratic_form(pair.q1, weights),
                                     quadratic_form(pair.q2, weights), dot(pair.r12, solution.s));
    PackMask const done = is_accurate(solution) && absolute(last.step) <= final_step<Pack>();
    return {last.mu2, last.lambda, done.to_bits() & state.ordinary & ~state.active};
}

/// Stores neighbouring results; those that are not done will be overwritten.
PW85_INLINE void store(Pack const &x, std::size_t count, double *out) noexcept
{
    if (count >= lanes)
        std::memcpy(out, &x.v, sizeof x.v);
    else
        for (std::size_t i = 0; i < count; ++i) out[i] = x[i];
}

/// The contact function of up to contact_chunk_size neighbouring pairs; those left to the scalar solver go to `rejected`.
template <class Rows> PW85_INLINE void contact_chunk(Rows const &rows, std::size_t count,
                                                     batch::ContactArrays const &out,
                                                     OffsetList<contact_chunk_size> &rejected) noexcept
{
    LaneState states[packs_per_chunk];
    std::size_t const begin = rejected.begin(), packs = (count + lanes - 1) / lanes;
    for (std::size_t k = 0; k < packs; ++k)
        start(states[k], load_neighbors(rows, begin + k * lanes, count - k * lanes));
    search(states, packs);
    for (std::size_t k = 0; k < packs; ++k) {
        LaneContact const contact = finish(states[k]);
        std::size_t const first = k * lanes, left = count - first;
        store(contact.mu2, left, out.mu2 + begin + first);
        if (out.lambda != nullptr) store(contact.lambda, left, out.lambda + begin + first);
        for (unsigned bits = live_lanes(left) & ~contact.done; bits != 0; bits &= bits - 1)
            rejected.push(first + static_cast<unsigned>(__builtin_ctz(bits)));
    }
}

/// The contact function of a list of pairs by the scalar solver.
template <class Rows> inline batch::Failure contact_one_by_one(Rows const &rows, OffsetList<contact_chunk_size> &list,
                                                               batch::ContactArrays const &out,
                                                               batch::ScalarKernels const &scalar) noexcept
{
    batch::Failure first{0, 0};
    visit_pairs(rows, list, [&](std::size_t index, double const *r12, double const *q1, double const *q2) {
        double contact[2];
        first.update({index, scalar.contact(r12, q1, q2, contact)});
        out.mu2[index] = contact[0];
        if (out.lambda != nullptr) out.lambda[index] = contact[1];
    });
    return first;
}

/// The contact function of a range of pairs.
template <class Rows> [[gnu::flatten]] inline batch::Failure contact_rows(Rows const &rows, batch::Range range,
                                                                          batch::ContactArrays const &out,
                                                                          batch::ScalarKernels const &scalar) noexcept
{
    batch::Failure first{0, 0};
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

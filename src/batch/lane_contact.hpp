/// @file
/// The contact function of one pair per lane.
///
/// The steps are those of the scalar solver on the rational form. Each stage runs over all packs of a chunk before the next
/// begins: stages are short and packs independent, so that the processor works on several at a time.
#ifndef PW85_BATCH_LANE_CONTACT_HPP_INCLUDED
#define PW85_BATCH_LANE_CONTACT_HPP_INCLUDED

#include <pw85/contact.hpp>

#include "rows.hpp"

namespace pw85::inline PW85_TARGET {

#ifndef PACKS
#define PACKS 16
#endif
inline constexpr std::size_t packs_per_chunk = PACKS;
inline constexpr std::size_t chunk = packs_per_chunk * lanes;

/// What is known of the pairs of a pack.
struct LaneState {
    LanePair pair;
    Pack a[3], b[4]; ///< of the rational form
    Candidate<Pack> candidate;
    unsigned ordinary;
    unsigned active;
};

PW85_INLINE void start(LaneState &state, LanePair const &pair) noexcept
{
    auto const weights = outer_weights(pair.r12);
    auto const adj1 = adjugate(pair.q1), adj2 = adjugate(pair.q2);
    state.pair = pair;
    state.a[0] = quadratic_form(adj1, weights);
    state.a[1] = quadratic_form(mixed_adjugate(pair.q1, pair.q2), weights);
    state.a[2] = quadratic_form(adj2, weights);
    state.b[0] = determinant(pair.q1, adj1);
    state.b[1] = contraction(adj1, pair.q2);
    state.b[2] = contraction(adj2, pair.q1);
    state.b[3] = determinant(pair.q2, adj2);
    state.candidate.t = initial_guess(pair);
    state.ordinary = is_ordinary(pair.r12, pair.q1, pair.q2).to_bits();
}

PW85_INLINE RationalForm<Pack, 3> form_of(LaneState const &state) noexcept
{
    RationalForm<Pack, 3> form;
    for (int i = 0; i < 3; ++i) form.a[i] = state.a[i];
    for (int i = 0; i < 4; ++i) form.b[i] = state.b[i];
    return form;
}

/// The first step, which never is the last.
PW85_INLINE void first_step(LaneState &state) noexcept
{
    Pack const t = state.candidate.t;
    Jet<Pack> const jet = evaluate_jet(form_of(state), t);
    Slope<Pack> const s = slope(jet, Pack(1.0), t);
    PackMask const near = is_near(s);
    Pack factor = exponential(halley_step(s));
    if (!all_of(near)) factor = select(near, factor, secular_factor(jet, Pack(1.0), t));
    state.candidate.t = t * factor;
    state.active = (1u << lanes) - 1u;
}

/// Another step of those lanes that need it.
PW85_INLINE void next_step(LaneState &state, PackMask active) noexcept
{
    Pack const t = state.candidate.t;
    Jet<Pack> const jet = evaluate_jet(form_of(state), t);
    Slope<Pack> const s = slope(jet, Pack(1.0), t);
    PackMask const near = is_near(s);
    Step<Pack> const step = halley_step(s);
    PackMask const within = near && is_within(step, penultimate_step<Pack>());
    Candidate<Pack> const candidate = advance(t, s, step);
    Pack next = candidate.t;
    if (!all_of(near)) next = select(near, next, t * secular_factor(jet, Pack(1.0), t));
    state.candidate.t = select(active, next, t);
    state.candidate.slope = select(active, candidate.slope, state.candidate.slope);
    state.active = (active & !within).to_bits();
}

struct LaneContact {
    Pack mu2, lambda;
    unsigned done;
};

PW85_INLINE LaneContact finish(LaneState const &state) noexcept
{
    Pair<Pack, 3> const &pair = state.pair;
    auto const m = blend(Pack(1.0), pair.q1, state.candidate.t, pair.q2);
    auto const adj = adjugate(m);
    auto const s = product(adj, pair.r12);
    auto const weights = outer_weights(s);
    Finish<Pack> const last = finish(state.candidate, Pack(1.0), quadratic_form(pair.q1, weights),
                                     quadratic_form(pair.q2, weights), dot(pair.r12, s));
    PackMask const accurate = determinant(m, adj) >= fine_conditioning<Pack>() * (m[0] * m[3] * m[5]);
    PackMask const done = absolute(last.step) <= final_step<Pack>() && accurate;
    return {last.mu2, last.tau / (Pack(1.0) + last.tau), done.to_bits() & state.ordinary & ~state.active};
}

PW85_INLINE void store_lanes(Pack const &x, std::size_t first, unsigned mask, double *out) noexcept
{
    for (int i = 0; i < lanes; ++i)
        if (mask >> i & 1u) out[first + static_cast<std::size_t>(i)] = x[i];
}

PW85_INLINE PackMask to_mask(unsigned bits) noexcept
{
#if defined(__AVX512F__)
    return {static_cast<__mmask8>(bits)};
#else
    RegisterOf<lanes>::Integers m;
    for (int i = 0; i < lanes; ++i) m[i] = -static_cast<std::int64_t>(bits >> i & 1u);
    return {m};
#endif
}

/// Contact of `count` <= chunk pairs from `begin` on; returns the number of those left to the scalar path, whose indices go to
/// `rejected`.
template <class Rows>
[[gnu::flatten]] inline std::size_t contact_chunk(Rows const &rows, std::size_t begin, std::size_t count, double *mu2,
                                                  double *lambda, std::size_t *rejected) noexcept
{
    LaneState states[packs_per_chunk];
    std::size_t const packs = (count + lanes - 1) / lanes;
    for (std::size_t k = 0; k < packs; ++k) {
        std::size_t indices[lanes];
        for (std::size_t i = 0; i < lanes; ++i)
            indices[i] = begin + (k * lanes + i < count ? k * lanes + i : count - 1);
        start(states[k], rows.load(indices));
    }
    for (std::size_t k = 0; k < packs; ++k) first_step(states[k]);
    unsigned short active[packs_per_chunk];
    std::size_t num_active = packs;
    for (std::size_t k = 0; k < packs; ++k) active[k] = static_cast<unsigned short>(k);
    for (int step = 2; step <= 5 && num_active > 0; ++step) {
        std::size_t const waiting = num_active;
        num_active = 0;
        for (std::size_t k = 0; k < waiting; ++k) {
            LaneState &state = states[active[k]];
            next_step(state, to_mask(state.active));
            active[num_active] = active[k];
            num_active += state.active != 0;
        }
    }
    std::size_t num_rejected = 0;
    for (std::size_t k = 0; k < packs; ++k) {
        LaneContact const c = finish(states[k]);
        std::size_t const first = begin + k * lanes;
        if (c.done == (1u << lanes) - 1u && k * lanes + lanes <= count) {
            std::memcpy(mu2 + first, &c.mu2, sizeof(Pack));
            if (lambda) std::memcpy(lambda + first, &c.lambda, sizeof(Pack));
            continue;
        }
        unsigned const live = k * lanes + lanes <= count ? (1u << lanes) - 1u : (1u << (count - k * lanes)) - 1u;
        store_lanes(c.mu2, first, c.done & live, mu2);
        if (lambda) store_lanes(c.lambda, first, c.done & live, lambda);
        for (unsigned i = 0; i < lanes; ++i)
            if ((live & ~c.done) >> i & 1u) rejected[num_rejected++] = first + i;
    }
    return num_rejected;
}

} // namespace pw85::inline PW85_TARGET

#endif

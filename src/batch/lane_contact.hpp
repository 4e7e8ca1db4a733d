/// @file
/// The contact function of one pair per lane.
///
/// The steps are those of the scalar solver on the rational form. Every lane makes the same number of them in a round,
/// wanted or not; pairs that need another round are collected and go on together, so that lanes stay full, and what
/// happens to a pair depends on nothing but the pair.
#ifndef PW85_BATCH_LANE_CONTACT_HPP_INCLUDED
#define PW85_BATCH_LANE_CONTACT_HPP_INCLUDED

#include <pw85/contact.hpp>

#include "rows.hpp"

namespace pw85::inline PW85_TARGET {

/// The outcome of a round.
struct LaneRound {
    Pack mu2, lambda;
    Pack t;         ///< where the next round would go on
    PackMask done;  ///< μ² and λ are right
    PackMask again; ///< another round may help
};

/// Steps of a round: enough for most pairs of moderate aspect.
inline constexpr int steps_per_round = 2;

PW85_INLINE LaneRound contact_round(LanePair const &pair, RationalForm<Pack, 3> const &form, Pack t) noexcept
{
    Candidate<Pack> candidate{};
    PackMask within{};
    for (int i = 0; i < steps_per_round; ++i) {
        Jet<Pack> const jet = evaluate_jet(form, t);
        Slope<Pack> const s = slope(jet, pair.ratio, t);
        Step<Pack> const step = halley_step(s);
        PackMask const near = is_near(s);
        Pack factor = exponential(step);
        if (!all_of(near)) factor = select(near, factor, secular_factor(jet, pair.ratio, t));
        if (i == steps_per_round - 1) {
            candidate = advance(t, s, step);
            within = near && is_within(step, penultimate_step<Pack>());
        }
        t = t * factor;
    }
    candidate.t = t;
    PackMask const positive = t > Pack(0) && t < Pack(std::numeric_limits<double>::max());
    Vector<Pack, 3> const s = evaluate_s(form, t);
    auto const weights = outer_weights(s);
    Finish<Pack> const last = finish(candidate, pair.ratio, quadratic_form(pair.q1, weights),
                                     quadratic_form(pair.q2, weights), dot(pair.r12, s));
    Pack const condition = conditioning(form, pair, t);
    PackMask const done = within && absolute(last.step) <= final_step<Pack>() && condition >= fine_conditioning<Pack>();
    PackMask const again = positive && !within && condition >= rough_conditioning<Pack>();
    return {last.mu2, last.tau / (Pack(1) + last.tau), t, done, again};
}

/// Pairs per chunk: their indices and the state of those that go on fit into the first-level cache.
inline constexpr std::size_t chunk = 256;
inline constexpr int max_rounds = 3;

/// A pair that goes on.
struct Straggler {
    std::size_t index;
    double t;
};

PW85_INLINE void store_lanes(Pack const &x, std::size_t const *indices, unsigned mask, double *out) noexcept
{
    for (int i = 0; i < lanes; ++i)
        if (mask >> i & 1u) out[indices[i]] = x[i];
}

/// Contact of `count` <= chunk pairs from `begin` on; returns the number of those left to the scalar path, whose indices go to
/// `rejected`.
template <class Rows>
[[gnu::flatten]] inline std::size_t contact_chunk(Rows const &rows, std::size_t begin, std::size_t count, double *mu2,
                                                  double *lambda, std::size_t *rejected) noexcept
{
    Straggler stragglers[chunk + lanes];
    std::size_t num_rejected = 0, num_stragglers = 0;
    for (std::size_t k = 0; k < count; k += lanes) {
        std::size_t indices[lanes];
        unsigned live = 0;
        for (int i = 0; i < lanes; ++i) {
            bool const inside = k + static_cast<std::size_t>(i) < count;
            indices[i] = begin + (inside ? k + static_cast<std::size_t>(i) : count - 1);
            live |= static_cast<unsigned>(inside) << i;
        }
        LanePair const pair = rows.load(indices);
        PackMask const ordinary = is_ordinary(pair.r12, pair.q1, pair.q2);
        LaneRound const round = contact_round(pair, rational_form(pair), initial_guess(pair));
        unsigned const done = (round.done && ordinary).to_bits() & live;
        unsigned const again = (round.again && ordinary).to_bits() & live;
        if (done == (1u << lanes) - 1u) {
            std::memcpy(mu2 + begin + k, &round.mu2, sizeof(Pack));
            if (lambda) std::memcpy(lambda + begin + k, &round.lambda, sizeof(Pack));
            continue;
        }
        store_lanes(round.mu2, indices, done, mu2);
        if (lambda) store_lanes(round.lambda, indices, done, lambda);
        for (int i = 0; i < lanes; ++i) {
            if (again >> i & 1u)
                stragglers[num_stragglers++] = {indices[i], round.t[i]};
            else if ((live & ~done) >> i & 1u)
                rejected[num_rejected++] = indices[i];
        }
    }
    for (int r = 1; r < max_rounds; ++r) {
        std::size_t const waiting = num_stragglers;
        num_stragglers = 0;
        for (std::size_t k = 0; k < waiting; k += lanes) {
            std::size_t indices[lanes];
            Register t{};
            unsigned live = 0;
            for (int i = 0; i < lanes; ++i) {
                std::size_t const j = k + static_cast<std::size_t>(i) < waiting ? k + static_cast<std::size_t>(i) : waiting - 1;
                indices[i] = stragglers[j].index;
                t[i] = stragglers[j].t;
                live |= static_cast<unsigned>(k + static_cast<std::size_t>(i) < waiting) << i;
            }
            LanePair const pair = rows.load(indices);
            LaneRound const round = contact_round(pair, rational_form(pair), t);
            unsigned const done = round.done.to_bits() & live, again = round.again.to_bits() & live;
            store_lanes(round.mu2, indices, done, mu2);
            if (lambda) store_lanes(round.lambda, indices, done, lambda);
            for (int i = 0; i < lanes; ++i) {
                if (again >> i & 1u)
                    stragglers[num_stragglers++] = {indices[i], round.t[i]};
                else if ((live & ~done) >> i & 1u)
                    rejected[num_rejected++] = indices[i];
            }
        }
    }
    for (std::size_t j = 0; j < num_stragglers; ++j) rejected[num_rejected++] = stragglers[j].index;
    return num_rejected;
}

} // namespace pw85::inline PW85_TARGET

#endif

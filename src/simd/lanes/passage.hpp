// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The closest passages of many pairs, one pair per lane: the search of the contact function
/// (contact.hpp) on the rational form of the least f over the range of t.
///
/// With M = Q1 + τ Q2, adj its adjugate, b its determinant and w = r × v:
///
/// 1. The best t on the whole line is -rᵀadj v/(vᵀadj v). There (r + t v)ᵀM⁻¹(r + t v) =
///    wᵀMw/(vᵀadj v), because the minors of the adjugate are b times the entries of M.
/// 2. Where that t is not in the range, t is the nearer end, and the form is (r + t v)ᵀadj(r + t
///    v)/b.
/// 3. By the envelope theorem the derivative of f in τ is the same in both cases. So the search
///    takes each step on the form that belongs to its τ. If the last evaluation is on another form
///    than the step before, the pair is left over.
#ifndef PW85_SIMD_LANES_PASSAGE_HPP_INCLUDED
#define PW85_SIMD_LANES_PASSAGE_HPP_INCLUDED

#include "../pairs.hpp"

namespace pw85::detail::kernels {

/// Closest passages, and the paths: the velocities, three numbers per pair, and the end of the time
/// are input. `t` may be null.
struct PassageArrays {
    double const *velocities;
    double t_max;
    double *mu2, *t;

    [[gnu::always_inline]] PassageArrays from(std::size_t begin) const noexcept
    {
        return {row_of(velocities, 3, begin), t_max, mu2 + begin, row_or_null(t, 1, begin)};
    }
};

} // namespace pw85::detail::kernels

#ifdef PW85_KERNEL
#include "contact.hpp"

namespace pw85::detail {
namespace {

/// A polynomial of degree two in τ.
struct Parabola {
    Pack c[3];

    PW85_INLINE Pack at(Pack const &tau) const noexcept { return (c[2] * tau + c[1]) * tau + c[0]; }
};

/// The forms of a pair as polynomials of the time.
struct PassageForms {
    Parabola rr, rv, vv; ///< rᵀadj r, rᵀadj v, vᵀadj v
    Pack b[4];           ///< det M
    Pack w[2];           ///< wᵀQ1w, wᵀQ2w
};

/// A search, and the place of its last step: -1 and 1 for the ends of the range of t, 0 between
/// them. The forms are not kept, to save stack.
struct PassageSearch {
    Parabola rv, vv; ///< of the forms
    Pack end;        ///< of the range of t
    RationalSearch<Pack> search;
    Pack place;
    PackMask active, valid; ///< valid: the pair, the velocity and the range pass the fast checks
};

/// Returns the place of the time -rv/vv, with vv > 0.
PW85_INLINE Pack place_of(Pack const &end, Pack const &rv, Pack const &vv) noexcept
{
    return select(rv < Pack(0.0), select(-rv < end * vv, Pack(0.0), Pack(1.0)), Pack(-1.0));
}

PW85_INLINE PassageForms passage_forms(LanePair<3> const &pair, Vector<Pack, 3> const &v) noexcept
{
    auto const vv = outer_weights(v), ww = outer_weights(cross(pair.r12, v));
    auto const adj1 = adjugate(pair.q1), mixed = mixed_adjugate(pair.q1, pair.q2),
               adj2 = adjugate(pair.q2);
    auto const r1 = product(adj1, pair.r12), rm = product(mixed, pair.r12),
               r2 = product(adj2, pair.r12);
    return {{{dot(pair.r12, r1), dot(pair.r12, rm), dot(pair.r12, r2)}},
            {{dot(v, r1), dot(v, rm), dot(v, r2)}},
            {{quadratic_form(adj1, vv), quadratic_form(mixed, vv), quadratic_form(adj2, vv)}},
            {determinant(pair.q1, adj1), contraction(adj1, pair.q2), contraction(adj2, pair.q1),
             determinant(pair.q2, adj2)},
            {quadratic_form(pair.q1, ww), quadratic_form(pair.q2, ww)}};
}

/// Returns the form at the end of the range where a place is not 0.
PW85_INLINE RationalForm<Pack> form_at_end(PassageForms const &forms, Pack const &place,
                                           Pack const &end) noexcept
{
    RationalForm<Pack> form{{}, {forms.b[0], forms.b[1], forms.b[2], forms.b[3]}};
    Pack const t = select(place > Pack(0.0), end, Pack(0.0)), twice = t + t, square = t * t;
    for (int k = 0; k < 3; ++k)
        form.a[k] = forms.rr.c[k] + twice * forms.rv.c[k] + square * forms.vv.c[k];
    return form;
}

/// Returns the form for τ.
PW85_INLINE RationalForm<Pack> form_for(PassageForms const &forms, Pack const &place,
                                        Pack const &end) noexcept
{
    RationalForm<Pack> form{{forms.w[0], forms.w[1], Pack(0.0)},
                            {forms.vv.c[0], forms.vv.c[1], forms.vv.c[2], Pack(0.0)}};
    auto const between = place == Pack(0.0);
    if (all_of(between)) return form;
    auto const other = form_at_end(forms, place, end);
    for (int k = 0; k < 3; ++k) form.a[k] = select(between, form.a[k], other.a[k]);
    for (int k = 0; k < 4; ++k) form.b[k] = select(between, form.b[k], other.b[k]);
    return form;
}

/// A search that begins with the τ that two spheres would have at their closest passage.
PW85_INLINE void start(PassageSearch &state, LanePair<3> const &pair, Vector<Pack, 3> const &v,
                       Pack const &end) noexcept
{
    Pack const t =
        minimum(maximum(rough_quotient(Pack(-dot(pair.r12, v)), Pack(dot(v, v))), Pack(0.0)), end);
    Pack const tau = initial_guess(pair_of(add_scaled(pair.r12, t, v), pair.q1, pair.q2));
    auto const forms = passage_forms(pair, v);
    state.rv = forms.rv;
    state.vv = forms.vv;
    state.end = end;
    state.search.candidate = {tau, Pack(0.0), Pack(0.0)};
    state.search.active = tau == tau;
    state.active = state.search.active;
    state.valid = passes_fast_checks(pair) &&
                  is_in_range(sum_of_magnitudes(v), Pack(1.0), Pack(1.0)) && end >= Pack(0.0);
    state.place = place_of(end, forms.rv.at(tau), forms.vv.at(tau));
    state.search.form = form_for(forms, state.place, end);
}

/// Takes a step. The form is recomputed only where the position changes, which is rare.
PW85_INLINE void take_passage_step(PassageSearch &state, LanePair<3> const &pair,
                                   Vector<Pack, 3> const &v) noexcept
{
    Pack const tau = state.search.candidate.t;
    Pack const place = place_of(state.end, state.rv.at(tau), state.vv.at(tau));
    if (any_of(state.active && !(place == state.place))) {
        state.place = select(state.active, place, state.place);
        state.search.form = form_for(passage_forms(pair, v), state.place, state.end);
    }
    take_step(state.search, pair);
    state.active = state.search.active;
}

/// The result of a search for a pack.
struct LanePassage {
    Pack mu2, t;
    PackMask certified;
};

/// Returns whether the rounding of t, of t v and of r + t v is harmless: the condition of
/// is_rounding_harmless() (motion/closest_passage.hpp), with everything times det M. `form` is (r +
/// t v)ᵀadj(r + t v), of which S is at least three times. The factor 16 leaves room for the
/// roundings of the two dot products that give t. So t is best for τ, up to an error of u S in μ².
PW85_INLINE PackMask is_rounding_harmless(LanePair<3> const &pair, Vector<Pack, 3> const &v,
                                          Pack const &t, SymmetricMatrix<Pack, 3> const &adj,
                                          Pack const &form) noexcept
{
    Pack second = Pack(0.0);
    for (int i = 0; i < 3; ++i) {
        Pack const x = absolute(pair.r12[i]) + Pack(t + t) * absolute(v[i]);
        second = second + Pack(x * x) * adj(i, i);
    }
    return Pack(16.0 * unit_roundoff<Pack>()) * second <= form;
}

/// Returns the difference of the best times at τ' and at τ, from the divided differences of its
/// numerator and denominator.
PW85_INLINE Pack delay_of(PassageSearch const &state, Pack const &tau, Pack const &next) noexcept
{
    auto const &rv = state.rv, &vv = state.vv;
    Pack const sum = tau + next, at = rv.at(tau), norm = vv.at(tau);
    Pack const slope = at * (vv.c[2] * sum + vv.c[1]) - norm * (rv.c[2] * sum + rv.c[1]);
    return Pack(Pack(next - tau) * slope) / Pack(norm * vv.at(next));
}

/// Returns the value at the last τ, by the quadratic forms. The time includes the last step.
PW85_INLINE LanePassage finish(PassageSearch const &state, LanePair<3> const &pair,
                               Vector<Pack, 3> const &v) noexcept
{
    Pack const tau = state.search.candidate.t;
    auto const adj = adjugate(blend(pair.q1, tau, pair.q2));
    auto const p = product(adj, v);
    Pack const rv = dot(pair.r12, p), vv = dot(v, p), best = -rv / vv;
    Pack const t = minimum(maximum(best, Pack(0.0)), state.end);
    auto const at_t = pair_of(add_scaled(pair.r12, t, v), pair.q1, pair.q2);
    auto const last = last_evaluation(at_t, state.search.candidate);
    auto const between = state.place == Pack(0.0);
    Pack const moved = best + delay_of(state, tau, Pack(tau + tau * last.value.step));
    Pack const time = select(between, minimum(maximum(moved, Pack(0.0)), state.end), t);
    return {last.value.mu2, time,
            last.certified && place_of(state.end, rv, vv) == state.place &&
                is_rounding_harmless(pair, v, t, adj, dot(at_t.r12, product(adj, at_t.r12))) &&
                state.valid};
}

/// Stores the closest passages of a chunk.
PW85_INLINE void compute_chunk(kernels::PairArrays<3> const &rows, Chunk const &chunk,
                               kernels::PassageArrays const &out,
                               kernels::Worklist &rejected_lanes) noexcept
{
    LanePair<3> pairs[packs_per_chunk];
    Vector<Pack, 3> velocities[packs_per_chunk];
    PassageSearch searches[packs_per_chunk];
    auto const [begin, count, chunk_end] = chunk;
    std::size_t const packs = (count + lanes - 1) / lanes;
    for (std::size_t k = 0; k < packs && k < packs_per_chunk; ++k) {
        std::size_t const first = begin + k * lanes, left = count - k * lanes;
        double const *velocity[lanes];
        for (std::size_t i = 0; i < lanes; ++i)
            velocity[i] = kernels::row_of(out.velocities, 3, first + (i < left ? i : left - 1));
        pairs[k] = load_consecutive(rows, first, left);
        velocities[k] = load_vectors<Pack, 3>(velocity);
        start(searches[k], pairs[k], velocities[k], Pack(out.t_max));
    }
    run(searches, packs, max_rational_steps, [&](std::size_t k) {
        take_passage_step(searches[k], pair_of(pairs[k].r12, pairs[k].q1, pairs[k].q2),
                          velocities[k]);
    });
    for (std::size_t k = 0; k < packs && k < packs_per_chunk; ++k) {
        std::size_t const first = begin + k * lanes, left = count - k * lanes;
        auto const passage = finish(searches[k], pairs[k], velocities[k]);
        store_lanes(passage.mu2, left, out.mu2 + first);
        if (out.t != nullptr) store_lanes(passage.t, left, out.t + first);
        for_lanes(live_lanes(left) & ~passage.certified.to_bits(),
                  [&](unsigned i) { rejected_lanes.push(first + i); });
    }
}

} // namespace
} // namespace pw85::detail

#else
#include <pw85.h>

#include "../targets.hpp"

namespace pw85::detail::kernels {

static inline int scalar_fallback(Target const &, PairRow<3> const &pair,
                                  PassageArrays const &out) noexcept
{
    double t;
    int const status =
        pw85_closest_passage(pair.r12, pair.q1, pair.q2, out.velocities, out.t_max, out.mu2, &t);
    if (out.t != nullptr) *out.t = t;
    return status;
}

} // namespace pw85::detail::kernels

#endif
#endif

/// @file
/// The kernel for closest passages, one pair per lane: the search of the contact function (lane_contact.hpp) on the rational form of the
/// least f over the range of t. lanes.cpp puts it into its table.
///
/// With M = Q1 + τ Q2, adj its adjugate, b its determinant and w = r × v:
///
/// 1. The best t on the whole line is -rᵀadj v/(vᵀadj v). There (r + tv)ᵀM⁻¹(r + tv) = wᵀMw/(vᵀadj v), because the minors of the adjugate
///    are b times the entries of M.
/// 2. Where that t is not in the range, t is the nearer end, and the form is (r + tv)ᵀadj(r + tv)/b.
/// 3. By the envelope theorem the derivative of f in τ is the same in both cases. So the search takes each step on the form that belongs to
///    its τ. If the last evaluation is on another form than the step before, the pair is left over.
#ifndef PW85_KERNELS_LANE_CLOSEST_PASSAGE_HPP_INCLUDED
#define PW85_KERNELS_LANE_CLOSEST_PASSAGE_HPP_INCLUDED

#include "lane_contact.hpp"

namespace pw85::detail {
namespace {

/// A polynomial of degree two in τ.
struct Parabola {
    Pack c[3];

    PW85_INLINE Pack at(Pack const &tau) const noexcept { return (c[2] * tau + c[1]) * tau + c[0]; }
};

/// The forms of a pair on its way.
struct PassageForms {
    Parabola rr, rv, vv; ///< rᵀadj r, rᵀadj v, vᵀadj v
    Pack b[4];           ///< det M
    Pack w[2];           ///< wᵀQ1w, wᵀQ2w
    Pack end;            ///< of the range of t
};

/// A search, and the form of its last step: -1 and 1 for the ends of the range, 0 between them.
struct PassageSearch {
    PassageForms forms;
    RationalSearch<Pack> search;
    Pack place;
    PackMask active;
};

PW85_INLINE Pack place_of(PassageForms const &forms, Pack const &t) noexcept
{
    return select(t > Pack(0.0), select(t < forms.end, Pack(0.0), Pack(1.0)), Pack(-1.0));
}

PW85_INLINE PassageForms passage_forms(LanePair<3> const &pair, Vector<Pack, 3> const &v, Pack const &end) noexcept
{
    auto const rr = outer_weights(pair.r12), vv = outer_weights(v), ww = outer_weights(cross(pair.r12, v));
    auto const adj1 = adjugate(pair.q1), mixed = mixed_adjugate(pair.q1, pair.q2), adj2 = adjugate(pair.q2);
    return {{{quadratic_form(adj1, rr), quadratic_form(mixed, rr), quadratic_form(adj2, rr)}},
            {{dot(pair.r12, product(adj1, v)), dot(pair.r12, product(mixed, v)), dot(pair.r12, product(adj2, v))}},
            {{quadratic_form(adj1, vv), quadratic_form(mixed, vv), quadratic_form(adj2, vv)}},
            {determinant(pair.q1, adj1), contraction(adj1, pair.q2), contraction(adj2, pair.q1),
             determinant(pair.q2, adj2)},
            {quadratic_form(pair.q1, ww), quadratic_form(pair.q2, ww)},
            end};
}

/// The form at the end of the range where a place is not 0.
PW85_INLINE RationalForm<Pack> form_at_end(PassageForms const &forms, Pack const &place) noexcept
{
    RationalForm<Pack> form{{}, {forms.b[0], forms.b[1], forms.b[2], forms.b[3]}};
    Pack const t = select(place > Pack(0.0), forms.end, Pack(0.0)), twice = t + t, square = t * t;
    for (int k = 0; k < 3; ++k) form.a[k] = forms.rr.c[k] + twice * forms.rv.c[k] + square * forms.vv.c[k];
    return form;
}

/// The form for τ.
PW85_INLINE RationalForm<Pack> form_for(PassageForms const &forms, Pack const &place) noexcept
{
    RationalForm<Pack> form{{forms.w[0], forms.w[1], Pack(0.0)},
                            {forms.vv.c[0], forms.vv.c[1], forms.vv.c[2], Pack(0.0)}};
    auto const between = place == Pack(0.0);
    if (all_of(between)) return form;
    auto const other = form_at_end(forms, place);
    for (int k = 0; k < 3; ++k) form.a[k] = select(between, form.a[k], other.a[k]);
    for (int k = 0; k < 4; ++k) form.b[k] = select(between, form.b[k], other.b[k]);
    return form;
}

/// A search that begins with the τ that two spheres would have at their closest passage.
PW85_INLINE void start(PassageSearch &state, LanePair<3> const &pair, Vector<Pack, 3> const &v,
                       Pack const &end) noexcept
{
    Pack const t = minimum(maximum(rough_quotient(Pack(-dot(pair.r12, v)), Pack(dot(v, v))), Pack(0.0)), end);
    Pack const tau = initial_guess(pair_of(add_scaled(pair.r12, t, v), pair.q1, pair.q2));
    state.forms = passage_forms(pair, v, end);
    state.search.candidate = {tau, Pack(0.0), Pack(0.0)};
    state.search.active = tau == tau;
    state.active = state.search.active;
    state.place = Pack(0.0);
}

PW85_INLINE void take_passage_step(PassageSearch &state, LanePair<3> const &pair) noexcept
{
    Pack const tau = state.search.candidate.t;
    Pack const place = place_of(state.forms, rough_quotient(Pack(-state.forms.rv.at(tau)), state.forms.vv.at(tau)));
    state.place = select(state.active, place, state.place);
    state.search.form = form_for(state.forms, state.place);
    take_step(state.search, pair);
    state.active = state.search.active;
}

/// The result of a search for a pack.
struct LanePassage {
    Pack mu2, t;
    PackMask certain;
};

/// Whether t is best for τ, and the rounding of r + tv harmless: the conditions of step_at() (motion/closest_passage.hpp), with S >= 3
/// (r + tv)ᵀM⁻¹(r + tv) and everything times det M. `p` is adj v.
PW85_INLINE PackMask is_best(LanePair<3> const &pair, Vector<Pack, 3> const &v, Pack const &t,
                             SymmetricMatrix<Pack, 3> const &adj, Vector<Pack, 3> const &r, PackMask between) noexcept
{
    auto const p = product(adj, v);
    Pack const u = Pack(unit_roundoff<Pack>()), form = quadratic_form(adj, r), along = dot(r, p);
    Pack second = Pack(0.0);
    for (int i = 0; i < 3; ++i) {
        Pack const x = absolute(pair.r12[i]) + Pack(t + t) * absolute(v[i]);
        second = second + Pack(x * x) * adj(i, i);
    }
    return u * second <= form && (along * along <= Pack(u * form) * dot(v, p) || !between);
}

/// The value at the last τ, by the quadratic forms. The time includes the last step.
PW85_INLINE LanePassage finish(PassageSearch const &state, LanePair<3> const &pair, Vector<Pack, 3> const &v) noexcept
{
    auto const &forms = state.forms;
    Pack const tau = state.search.candidate.t;
    auto const adj = adjugate(blend(pair.q1, tau, pair.q2));
    auto const p = product(adj, v);
    Pack const best = Pack(-dot(pair.r12, p)) / Pack(dot(v, p)), place = place_of(forms, best);
    Pack const t = minimum(maximum(best, Pack(0.0)), forms.end);
    auto const at_t = pair_of(add_scaled(pair.r12, t, v), pair.q1, pair.q2);
    auto const last = last_evaluation(at_t, state.search.candidate);
    auto const between = place == Pack(0.0);
    Pack const next = tau + tau * last.value.step;
    Pack const delay = forms.rv.at(tau) / forms.vv.at(tau) - forms.rv.at(next) / forms.vv.at(next);
    Pack const time = select(between, minimum(maximum(Pack(best + delay), Pack(0.0)), forms.end), t);
    return {last.value.mu2, time,
            last.certain && place == state.place && is_best(pair, v, t, adj, at_t.r12, between) &&
                passes_fast_checks(pair) && is_in_range(sum_of_magnitudes(v), Pack(1.0), Pack(1.0)) &&
                forms.end >= Pack(0.0)};
}

/// Stores the closest passages of a chunk.
PW85_INLINE void compute_chunk(kernels::PairArrays<3> const &rows, Chunk const &chunk,
                               kernels::PassageArrays const &out, kernels::Worklist &left_over) noexcept
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
    run(searches, packs, max_rational_steps,
        [&](std::size_t k) { take_passage_step(searches[k], pair_of(pairs[k].r12, pairs[k].q1, pairs[k].q2)); });
    for (std::size_t k = 0; k < packs && k < packs_per_chunk; ++k) {
        std::size_t const first = begin + k * lanes, left = count - k * lanes;
        auto const passage = finish(searches[k], pairs[k], velocities[k]);
        store_lanes(passage.mu2, left, out.mu2 + first);
        if (out.t != nullptr) store_lanes(passage.t, left, out.t + first);
        for_lanes(live_lanes(left) & ~passage.certain.to_bits(), [&](unsigned i) { left_over.push(first + i); });
    }
}

} // namespace
} // namespace pw85::detail

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The third tier of the overlap test (overlap.hpp lists the tiers). It computes μ² by the solver,
/// and compares μ² with 1, with a bound on the error of μ². overlap.hpp and compare.hpp call it.
#ifndef PW85_OVERLAP_CERTIFIED_VALUE_HPP_INCLUDED
#define PW85_OVERLAP_CERTIFIED_VALUE_HPP_INCLUDED

#include <pw85/contact/condition.hpp>
#include <pw85/contact/contact.hpp>
#include <pw85/overlap/decision.hpp>

namespace pw85::detail {

/// The condition number at the maximum. It is needed to a few digits only, so s comes from the
/// factorisation.
template <class T, int D>
PW85_FUNCTION inline T condition_number(Pair<T, D> const &pair, Maximum<T> const &m) noexcept
{
    T const t = m.lambda / pair.ratio / m.complement / pair.ratio;
    return m.lambda *
           condition_sum(pair, t, solve(factorize_blend(T(1), pair.q1, t, pair.q2), pair.r12)) /
           m.mu2;
}

/// A bound on the relative error of μ², in units of u cond. It has three parts: the rounding errors
/// of stationary_value(); the error that is_certified() admits, which is at most 2u where cond >=
/// 3, or u cond/8 where s is refined; and u for the comparison. This is theorem `value` of
/// tests/bounds/proofs.cpp.
inline constexpr int value_margin = 8;

/// The tier for a pair in range. `tangent` is the μ² of tangent ellipsoids in the units of the
/// pair.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Decision
decide_by_certified_value(Pair<T, D> const &pair, T const &tangent) noexcept
{
    Maximum<T> const m = maximize(pair);
    if (!m.certified) return Decision::none;
    T const error = T(value_margin * unit_roundoff<T>()) * condition_number(pair, m) * m.mu2;
    return to_decision(m.mu2 - error > tangent, m.mu2 + error < tangent);
}

PW85_SHARED_BY_QUESTIONS(decide_by_certified_value)

} // namespace pw85::detail

#endif

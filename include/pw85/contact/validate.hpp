// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The status of a form and of a pair. Every function checks its input here before it computes
/// anything. If a pair is valid, scaling.hpp brings it into range.
#ifndef PW85_CONTACT_VALIDATE_HPP_INCLUDED
#define PW85_CONTACT_VALIDATE_HPP_INCLUDED

#include <pw85/algebra/definite.hpp>
#include <pw85/algebra/two_lanes.hpp>
#include <pw85/contact/scaling.hpp>
#include <pw85/status.hpp>

namespace pw85::detail {

/// validate() for a form of any size that may be nearly singular.
template <class T, int D>
PW85_RARE StatusCode validate_scaled(SymmetricMatrix<T, D> const &q) noexcept
{
    if (!is_finite(q)) return StatusCode::invalid_argument;
    if (!has_positive_diagonal(q)) return StatusCode::not_positive_definite;
    bool const definite = is_positive_definite(unit_of(q).to_local(q));
    return definite ? StatusCode::success : StatusCode::not_positive_definite;
}

#define PW85_RARE_FORM_VALIDATION(rare, T, D)                                                      \
    rare(validate_scaled, (SymmetricMatrix<T, D> const &q), (q))
PW85_RARE_TIER(PW85_RARE_FORM_VALIDATION)

/// The status of one form.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline StatusCode
validate(SymmetricMatrix<T, D> const &q) noexcept
{
    T const largest = largest_diagonal(q);
    bool const clear = is_in_range(largest, largest, largest) && is_clearly_definite(q);
    return clear ? StatusCode::success : validate_scaled(q);
}

/// The status of a pair. If it is success, `scaled` becomes the pair in range.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline StatusCode
validate(Pair<T, D> const &pair, ScaledPair<T, D> &scaled) noexcept
{
    auto const &[r12, q1, q2, ratio] = pair;
    if (!(is_finite(r12) && is_finite(q1) && is_finite(q2))) return StatusCode::invalid_argument;
    if (!(has_positive_diagonal(q1) && has_positive_diagonal(q2)))
        return StatusCode::not_positive_definite;
    scaled = scale(pair);
    bool const definite =
        is_positive_definite(scaled.pair.q1) && is_positive_definite(scaled.pair.q2);
    return definite ? StatusCode::success : StatusCode::not_positive_definite;
}

#define PW85_SHARED_VALIDATION(shared, T, D)                                                       \
    shared(validate, (Pair<T, D> const &pair, ScaledPair<T, D> &scaled), (pair, scaled))
PW85_SHARED_BY_QUESTIONS(PW85_SHARED_VALIDATION)

/// Returns whether λ is in [0, 1] and a pair is valid.
template <class T, int D>
PW85_FUNCTION inline bool is_valid(T const &lambda, Pair<T, D> const &pair) noexcept
{
    ScaledPair<T, D> scaled;
    return lambda >= T(0) && lambda <= T(1) && validate(pair, scaled) == StatusCode::success;
}

/// Returns whether a pair is valid and in range and has r12 != 0, tested with products only. The
/// result is true for almost all such pairs. The function is always inlined to keep the pair in
/// registers.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline typename ScalarTraits<T>::Mask
passes_fast_checks(Pair<T, D> const &pair) noexcept
{
    return is_in_range(sum_of_magnitudes(pair.r12), largest_diagonal(pair.q1),
                       largest_diagonal(pair.q2)) &&
           is_clearly_definite(pair.q1) && is_clearly_definite(pair.q2);
}

/// Tests one pair in this way, from both forms side by side and their adjugates.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline bool
passes_fast_checks(Vector<T, D> const &r12, SymmetricMatrix<TwoLanes<T>, D> const &q,
                   SymmetricMatrix<TwoLanes<T>, D> const &adjugate_of_q) noexcept
{
    auto const largest = largest_diagonal(q);
    return all_of(is_in_range(TwoLanes<T>(sum_of_magnitudes(r12)), largest, largest) &&
                  is_clearly_definite(q, adjugate_of_q));
}

} // namespace pw85::detail

#endif

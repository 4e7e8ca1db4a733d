/// @file
/// The rational form of one pair, computed from both forms side by side (two_lanes.hpp). solver.hpp and overlap/quartic.hpp call it.
/// Packs of lanes, which have one pair per lane, use the rational_form() of rational.hpp.
#ifndef PW85_CONTACT_BOTH_FORMS_HPP_INCLUDED
#define PW85_CONTACT_BOTH_FORMS_HPP_INCLUDED

#include <pw85/algebra/two_lanes.hpp>
#include <pw85/contact/rational.hpp>

namespace pw85::detail {

/// A matrix of products of an entry of P with one of Q. The coefficient of t in adj(P + t Q) is the sum of those of (P, Q) and (Q, P).
template <class T> [[gnu::always_inline]] PW85_FUNCTION constexpr SymmetricMatrix<T, 3>
polar_adjugate(SymmetricMatrix<T, 3> const &p, SymmetricMatrix<T, 3> const &q) noexcept
{
    return {p[3] * q[5] - p[4] * q[4], p[2] * q[4] - p[1] * q[5], p[1] * q[4] - p[2] * q[3],
            p[0] * q[5] - p[2] * q[2], p[1] * q[2] - p[0] * q[4], p[0] * q[3] - p[1] * q[1]};
}

// The arguments are, in both lanes: q, which is Q1 and Q2; other, which is Q2 and Q1; the adjugate of q; the outer weights of r12.
// They are no structure, because compilers would keep it in memory.

template <class T> [[gnu::always_inline]] PW85_FUNCTION constexpr RationalForm<T>
rational_form(SymmetricMatrix<TwoLanes<T>, 2> const &q, SymmetricMatrix<TwoLanes<T>, 2> const &other,
              SymmetricMatrix<TwoLanes<T>, 2> const &adjugate_of_q,
              SymmetricMatrix<TwoLanes<T>, 2> const &weights) noexcept
{
    auto const a = quadratic_form(adjugate_of_q, weights), b = determinant(q, adjugate_of_q);
    return {{first_of(a), second_of(a), T(0)},
            {first_of(b), first_of(contraction(adjugate_of_q, other)), second_of(b), T(0)}};
}

template <class T> [[gnu::always_inline]] PW85_FUNCTION constexpr RationalForm<T>
rational_form(SymmetricMatrix<TwoLanes<T>, 3> const &q, SymmetricMatrix<TwoLanes<T>, 3> const &other,
              SymmetricMatrix<TwoLanes<T>, 3> const &adjugate_of_q,
              SymmetricMatrix<TwoLanes<T>, 3> const &weights) noexcept
{
    auto const a = quadratic_form(adjugate_of_q, weights), b = determinant(q, adjugate_of_q);
    auto const mixed_a = quadratic_form(polar_adjugate(q, other), weights);
    auto const mixed_b = contraction(adjugate_of_q, other);
    return {{first_of(a), first_of(mixed_a) + second_of(mixed_a), second_of(a)},
            {first_of(b), first_of(mixed_b), second_of(mixed_b), second_of(b)}};
}

} // namespace pw85::detail

#endif

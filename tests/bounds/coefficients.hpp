// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The proof of the margins of test_by_coefficients().
///
/// The units are such that M has a unit diagonal, and that t = 1. There |q1_ij| + |q2_ij| <= 1,
/// since both forms are positive definite. The quantities a and b are sums of products: replace
/// each rounded result z by z (1 + δ), and each product gets as many factors 1 + δ as there are
/// roundings on its way. So b errs by at most n s u P, where n is the largest number of roundings
/// of a product, and s the sum of the magnitudes of all products. The latter depends on |q1_ij| +
/// |q2_ij| alone, as these are the products of det M: it is D!, 2 or 6. Likewise a errs by n s |r|²
/// u, where s is D (D - 1)!, 2 or 6, since (Σ|r_i|)² <= D |r|². As a >= (d/D) |r|², with d = b/P,
/// this is at most D n s u/d of a.
///
/// The derivatives t a' and t b' weight the products by their powers of t, which are at most D - 1
/// and D. With t a' <= (D - 1) a and t b' <= D b the errors of b²A = ab - t (ab' - a'b) and of
/// b²t²B follow. They are compared with b², whose error is 2 b times that of b; b <= a where A >=
/// 1, and b <= t a where t²B >= 1.
#ifndef PW85_TESTS_BOUNDS_COEFFICIENTS_HPP_INCLUDED
#define PW85_TESTS_BOUNDS_COEFFICIENTS_HPP_INCLUDED

#include "second_order.hpp"

namespace pw85_bounds {

template <int D> QuarticEvaluation<Recorded> evaluate_recorded()
{
    Inputs<D> const in;
    auto const q = side_by_side(in.pair.q1, in.pair.q2),
               other = side_by_side(in.pair.q2, in.pair.q1);
    auto const weights = outer_weights(converted<TwoLanes<Recorded>>(in.pair.r12));
    QuarticCoefficients<Recorded> const quartic{rational_form(q, other, adjugate(q), weights),
                                                diagonal_coefficients(q, other)};
    return evaluate_quartic(quartic, in.t);
}

/// a, b, and ab' - a'b.
template <int D> std::vector<int> from_coefficients()
{
    auto const e = evaluate_recorded<D>();
    return {e.a.node(), e.b.node(), e.form.node()};
}

/// What the errors of a and b are made of.
struct CoefficientRoundings {
    double a, b, a_slope, b_slope; ///< roundings of a product
    /// whether the sums of magnitudes are those of the comment above
    bool magnitudes;
};

template <int D> CoefficientRoundings count_coefficient_roundings()
{
    Formula const formula = record(from_coefficients<D>);
    auto const found = monomials(formula.graph, 1.0);
    auto const node = [&](int k) { return formula.graph[static_cast<std::size_t>(k)]; };
    auto const count = [&](int k) { return found[static_cast<std::size_t>(k)]; };
    auto const difference = node(formula.results[2]);
    auto const minuend = node(difference.left), subtrahend = node(difference.right);
    Monomials const a = count(formula.results[0]), b = count(formula.results[1]);
    // monomials() counts entries of the forms half, so that those of M are 1. |r_i| is 1 here, so
    // that (Σ|r_i|)² is D².
    double const factorial = D == 2 ? 2.0 : 6.0;
    bool const magnitudes = b.magnitude == factorial && a.magnitude == factorial * D;
    bool const product = difference.operation == Operation::difference &&
                         minuend.left == formula.results[0] &&
                         subtrahend.right == formula.results[1];
    return {double(a.roundings), double(b.roundings), double(count(subtrahend.left).roundings),
            double(count(minuend.right).roundings), magnitudes && product};
}

/// Whether the margins suffice. The errors in units of u: of a, over a P/b; of b, over P; of t a'
/// and t b' likewise. The roundings after these are at most 5 for shows_apart() and 2D + 5 for the
/// others, as is seen in the templates. The margins inside contain the computed a, and products of
/// two errors: 6 % serve for both, where a errs by less than 3 %.
template <int D> bool coefficients_hold()
{
    auto const n = count_coefficient_roundings<D>();
    double const s = D == 2 ? 2.0 : 6.0;
    double const a = D * s * n.a, b = s * n.b, a_slope = (D - 1) * D * s * n.a_slope,
                 b_slope = D * s * n.b_slope;
    double const apart = (a + b + 5.0) * (1.0 + 0x1p-10);
    double const inside =
        1.06 * ((1.0 + D) * a + (1.0 + (D - 1) + 2.0) * b + a_slope + b_slope + 2 * D + 5);
    double const conditioning = a / 0.03 + b + 5.0;
    bool const proved = n.magnitudes && apart <= coefficients_apart_margin &&
                        inside <= coefficients_inside_margin &&
                        conditioning <= coefficients_least_conditioning;
    std::printf(
        "coefficients, D = %d: %s; apart %.1f of %d, inside %.1f of %d, conditioning %.1f of %d\n",
        D, proved ? "proved" : "NOT PROVED", apart, coefficients_apart_margin, inside,
        coefficients_inside_margin, conditioning, coefficients_least_conditioning);
    return proved;
}

inline bool prove_coefficients()
{
    bool const two = coefficients_hold<2>();
    return coefficients_hold<3>() && two;
}

} // namespace pw85_bounds

#endif

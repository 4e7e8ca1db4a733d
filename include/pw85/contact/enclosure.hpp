// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Bounds on μ² and λ from one evaluation with residuals of twice the digits.
/// overlap/contact_rounded.hpp calls enclose() and prove_step(). enclose() is for the types of the
/// processor, prove_step() also for extended numbers.
///
/// With M = Q1 + t Q2, τ = ratio² t, λ = τ/(1+τ), any vector s and its residual ρ = r12 - M s, let
/// R = sᵀMs, A = sᵀQ1s, B = sᵀQ2s and C = τ t B. For s = M⁻¹r12, f = λR. f is concave in λ. So μ²
/// is between f and f + |df/dλ| |λ* - λ|, where λ* is the maximiser and df/dλ = A - C.
#ifndef PW85_CONTACT_ENCLOSURE_HPP_INCLUDED
#define PW85_CONTACT_ENCLOSURE_HPP_INCLUDED

#include <pw85/algebra/doubled.hpp>
#include <pw85/contact/rational.hpp>

namespace pw85::detail {

/// Bounds of an evaluation on the distance to the maximiser, with z = (1-λ)(A - C) and S = t
/// sᵀQ2 M⁻¹ Q1 s.
template <class T> struct Stationarity {
    T slope;           ///< z
    T slope_error;     ///< bound on the error of z
    T curvature;       ///< S
    T curvature_error; ///< bound on the error of S
};

/// A proved step to the maximiser.
template <class T> struct ProvedStep {
    T step;    ///< z/(2S)
    T longest; ///< χ
    T error;   ///< bound on the relative error of λ after the step
    bool proved;
};

/// The step is not proved if χ > 2^-12 or a number is NaN. The error of the quotient z/(2S) is the
/// sum of those of z, of S, and of four roundings.
///
/// In the eigenbasis of the pencil, with the eigenvalues p_i in [0, 1] of Q1 relative to M, S = Σ
/// p_i (1 - p_i) s_i², so that h' = S R/(A tB) (h and h' are those of iteration.hpp). Let κ = |A -
/// C|/(A + C)/h' and χ >= |z|/(2S). Then κ <= 2χ, and κ <= 1.002 χ if χ <= 2^-12. Since |h''| <=
/// 2h', the root of h is within 1.005 χ in log t, and at z/(2S) with an error of at most 6χ². Hence
/// μ² - f <= 1.01 λ χ |z|, and λ* = λ + λ(1-λ) z/(2S) with a relative error of at most 7χ².
template <class T> PW85_FUNCTION inline ProvedStep<T> prove_step(Stationarity<T> const &at) noexcept
{
    T const least = at.curvature - at.curvature_error, half = T(0.5) / least;
    T const longest = (absolute(at.slope) + at.slope_error) * half;
    T const relative = at.curvature_error * (half + half) + T(4) * T(unit_roundoff<T>());
    T const error = T(8) * longest * longest + T(T(1.125) * at.slope_error) * half +
                    T(T(1.125) * relative) * longest;
    return {T(0.5) * at.slope / at.curvature, longest, error,
            least > T(0) && longest >= T(0) && longest <= negative_power_of_two<T>(12)};
}

/// The inverse of M by its adjugate.
template <class T, int D> struct AdjugateInverse {
    SymmetricMatrix<T, D> adjugate;
    T reciprocal; ///< 1/det M
    T error;      ///< η: solutions err by η of themselves in the norm of M
};

/// The error η of solutions by the adjugate, in units of u/d. Let M have a unit diagonal, which
/// does not restrict the argument, and let d be its determinant. Its eigenvalues are between 4d/9
/// and 3. The entries of |Q1| + t |Q2| are at most 1, and so are those of adj M.
///
/// To first order an entry of M errs by 2u, one of the adjugate by 12u, the product of the adjugate
/// and x by 45u |x|, and the determinant by 51u. The norm of M is at most √3 times the length of
/// the solution, and |x| is at most √3 times the norm of M⁻¹. So η is 190 u/d to first order. The
/// rest is for terms of higher order, for right-hand sides that are rounded, and for dot products
/// with a solution, which add less than 30 u/√d.
inline constexpr int solution_error = 512;

template <class T, int D> PW85_FUNCTION inline AdjugateInverse<T, D>
invert_by_adjugate(SymmetricMatrix<T, D> const &m) noexcept
{
    auto const adj = adjugate(m);
    T const reciprocal = T(1) / determinant(m, adj);
    return {adj, reciprocal,
            T(T(solution_error) * T(unit_roundoff<T>())) * diagonal_product(m) * reciprocal};
}

template <class T, int D> PW85_FUNCTION inline Vector<T, D>
solve(AdjugateInverse<T, D> const &inverse, Vector<T, D> const &x) noexcept
{
    return inverse.reciprocal * product(inverse.adjugate, x);
}

/// A point near the maximiser: t, and an approximation of s = M⁻¹r12.
template <class T, int D> struct NearMaximum {
    T t;
    Vector<T, D> s;
};

/// Bounds on μ² and λ, in the units of a Pair: value - below <= μ² <= value + above.
template <class T, int D> struct EnclosedMaximum {
    Doubled<T> value;
    T below, above;
    Doubled<T> lambda, complement; ///< λ and 1-λ at t
    ProvedStep<T> step;
    NearMaximum<T, D> next; ///< nearer to the maximiser
};

/// A vector as the sum of two.
template <class T, int D> struct DoubledVector {
    Vector<T, D> high, low;
};

/// A x. Coordinate i errs by at most 16u² Σ|A_ij x_j|: the low part is the sum of terms that add up
/// to 3u times these magnitudes, in four roundings (T. Ogita, S. M. Rump and S. Oishi, SIAM J. Sci.
/// Comput. 26, 1955, 2005), and products err by 2u² (exact_product()).
template <class T, int D> PW85_FUNCTION inline DoubledVector<T, D>
doubled_product(SymmetricMatrix<T, D> const &a, Vector<T, D> const &x) noexcept
{
    DoubledVector<T, D> y{};
    for (int i = 0; i < D; ++i) {
        Parts<T> const first = exact_product(a(i, 0), x[0]);
        CompensatedSum<T> sum{first.high, first.low};
        for (int j = 1; j < D; ++j) add_product(sum, a(i, j), x[j]);
        y.high[i] = sum.sum;
        y.low[i] = sum.rest;
    }
    return y;
}

/// x·(y.high + y.low), with an error of at most 24u² Σ|x_i y_i|, or 16u² if y.low = 0.
template <class T, int D> PW85_FUNCTION inline Doubled<T>
doubled_dot(Vector<T, D> const &x, DoubledVector<T, D> const &y) noexcept
{
    Parts<T> const first = exact_product(x[0], y.high[0]);
    CompensatedSum<T> sum{first.high, first.low};
    for (int i = 1; i < D; ++i) add_product(sum, x[i], y.high[i]);
    for (int i = 0; i < D; ++i) sum.rest = sum.rest + x[i] * y.low[i];
    return ordered_sum(sum.sum, sum.rest);
}

/// r - y1 - t y2.
template <class T, int D>
PW85_FUNCTION inline Vector<T, D> doubled_residual(Vector<T, D> const &r,
                                                   DoubledVector<T, D> const &y1, T const &t,
                                                   DoubledVector<T, D> const &y2) noexcept
{
    Vector<T, D> rho{};
    for (int i = 0; i < D; ++i) {
        CompensatedSum<T> sum{r[i], T(-y1.low[i])};
        add(sum, T(-y1.high[i]));
        add_product(sum, T(-t), y2.high[i]);
        rho[i] = sum.sum + (sum.rest - t * y2.low[i]);
    }
    return rho;
}

/// 1/(1 + x), with a relative error of at most 8u².
template <class T> PW85_FUNCTION inline Doubled<T> reciprocal_of_one_plus(T const &x) noexcept
{
    CompensatedSum<T> sum{T(1), T(0)};
    add(sum, x);
    T const first = T(1) / sum.sum;
    Parts<T> const product = exact_product(first, sum.sum);
    return ordered_sum(first,
                       T(first * (((T(1) - product.high) - product.low) - first * sum.rest)));
}

/// x y for a number of the type itself, with a relative error of at most 4u².
template <class T> PW85_FUNCTION inline Doubled<T> times(T const &x, Doubled<T> const &y) noexcept
{
    Parts<T> const product = exact_product(x, y.high);
    return ordered_sum(product.high, T(product.low + x * y.low));
}

/// The sums that bound the rounding errors.
template <class T> struct ErrorSums {
    T terms;    ///< >= Σ |s_i| (|Q1_ij| + t |Q2_ij|) |s_j| + 2 Σ |r_i s_i|
    T residual; ///< Σ |ρ_i s_i|
};

/// Entries of a positive definite matrix are at most the geometric means of diagonal entries. So
/// the sum over i, j is at most D times the sum over the diagonal.
template <class T, int D>
PW85_FUNCTION inline ErrorSums<T> error_sums(SymmetricMatrix<T, D> const &m, Vector<T, D> const &r,
                                             Vector<T, D> const &s,
                                             Vector<T, D> const &rho) noexcept
{
    T diagonal = T(0);
    for (int i = 0; i < D; ++i) diagonal = diagonal + m(i, i) * (s[i] * s[i]);
    return {T(D) * diagonal + T(2) * magnitude_of_dot(r, s), magnitude_of_dot(rho, s)};
}

/// A bound on the errors of f/λ and z, without those of s and w, in units of u² ErrorSums::terms
/// and of u ErrorSums::residual. With K = Σ |s_i| (|Q1_ij| + t |Q2_ij|) |s_j|:
///
/// - A coordinate of ρ errs by u of itself and by 128u² Σ (|Q1_ij| + t |Q2_ij|) |s_j|: 34 come from
///   the products, and the others from five roundings of terms that add up to 16u times these
///   magnitudes. So ρᵀs errs by 128u² K and by 4u ErrorSums::residual.
/// - rᵀs errs by 16u² Σ |r_i s_i|, tB by 44u² K.
/// - Sums and products of doubled numbers, λ and 1-λ among them, add 28u² K.
/// - In the norm of M⁻¹ the second part of the error of ρ is 864 u²/d √R, which is at most 0.11 u
///   √R as η <= 1/16. It enters ρᵀM⁻¹ρ squared, with 0.05u² R.
///
/// These are at most 209u² K and 4u. The rest of 256 and 16 is for the rounding errors of the
/// bounds themselves.
inline constexpr int accurate_error = 256, residual_error = 16;

template <class T> PW85_FUNCTION inline T error_of_values(ErrorSums<T> const &sums) noexcept
{
    T const u = T(unit_roundoff<T>());
    return u * (T(accurate_error) * u * sums.terms + T(residual_error) * sums.residual);
}

/// Bounds on μ² and λ from t and an s near M⁻¹r12. They hold if `step` is proved and η <= 1/16. Let
/// ω = |M⁻¹ρ|/|s| in the norm of M.
///
/// - rᵀM⁻¹r = rᵀs + ρᵀs + ρᵀM⁻¹ρ. The last term is of second order in the error M⁻¹ρ of s. It is at
///   most 2.3 ρᵀw, in addition to what error_of_values() contains. It raises f, and 4 ρᵀw are
///   allowed for it.
/// - z is that of s + w to first order. The terms of second order are below ρᵀM⁻¹ρ. The error of w,
///   which is ηω + 1.7 ηu in units of |s|, enters z twice, and rounding of the product with w adds
///   less than ηω.
/// - S errs by η/2 R, and by ω/2 R because s is not exact.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline EnclosedMaximum<T, D>
enclose(Pair<T, D> const &pair, NearMaximum<T, D> const &at, SymmetricMatrix<T, D> const &m,
        AdjugateInverse<T, D> const &inverse) noexcept
{
    auto const &[t, s] = at;
    T const tau = t * pair.ratio * pair.ratio, u = T(unit_roundoff<T>());
    auto const y1 = doubled_product(pair.q1, s), y2 = doubled_product(pair.q2, s);
    auto const rho = doubled_residual(pair.r12, y1, t, y2);
    auto const w = solve(inverse, rho), v = solve(inverse, y2.high);
    auto const complement = reciprocal_of_one_plus(tau), lambda = times(tau, complement);
    auto const rs = doubled_dot(s, DoubledVector<T, D>{pair.r12, {}}),
               b = times(t, doubled_dot(s, y2));
    T const correction = dot(rho, s), rest = absolute(dot(rho, w)), c = complement.high;

    // The error of w enters z by η times the norms of w and s, and squared.
    auto const sums = error_sums(m, pair.r12, s, rho);
    T const error = error_of_values(sums), scale = rs.high;
    T const cross = square_root(T(rest * scale)), mixed = inverse.error * (cross + u * scale);
    T change = T(0);
    for (int i = 0; i < D; ++i)
        change = change + w[i] * (c * y1.high[i] - (lambda.high * t) * y2.high[i]);
    auto const difference = complement * (rs - Doubled<T>(correction)) - b;
    Stationarity<T> const stationarity{T((difference.high + T(2) * change) + difference.low),
                                       error + T(4) * (rest + mixed), t * dot(v, y1.high),
                                       inverse.error * scale + T(1.125) * cross};
    auto const step = prove_step(stationarity);
    T const gain =
        T(1.0625) * step.longest * (absolute(stationarity.slope) + stationarity.slope_error);
    T const forward = t * step.step;
    return {lambda * (rs + Doubled<T>(correction)),
            T(T(1.125) * lambda.high) * error,
            T(T(1.125) * lambda.high) * (error + T(4) * rest + gain),
            lambda,
            complement,
            step,
            {t + forward, add_scaled(Vector<T, D>(s + w), T(-forward), v)}};
}

} // namespace pw85::detail

#endif

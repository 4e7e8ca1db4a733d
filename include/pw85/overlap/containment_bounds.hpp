// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Bounds on the factor κ by which ellipsoid 1 must be scaled to contain ellipsoid 2.
/// containment_factor.hpp searches for the best ones.
///
/// κ² is the largest xᵀQ1⁻¹x over ellipsoid 2. For ν > 0 let M = Q1 - Q2/ν and n = M⁻¹r. Each n
/// gives a lower bound on κ² (support_ratio()), and each ν with M positive definite the upper bound
/// g(ν) = ν + rᵀM⁻¹r (take_dual_step()). The best n and the best ν have the value κ².
#ifndef PW85_OVERLAP_CONTAINMENT_BOUNDS_HPP_INCLUDED
#define PW85_OVERLAP_CONTAINMENT_BOUNDS_HPP_INCLUDED

#include <pw85/contact/condition.hpp>
#include <pw85/contact/contact.hpp>

namespace pw85::detail {

/// κ² from below by a direction n.
template <class T, int D> struct SupportRatio {
    Vector<T, D> n; ///< with n·r >= 0
    T mu2;          ///< 0 if n is not a direction
    T root2;        ///< √(nᵀQ2n)
    T nu;           ///< the ν that belongs to n: κ√(nᵀQ2n)/√(nᵀQ1n)
};

/// For each n, κ is at least (√(nᵀQ2n) + |n·r|)/√(nᵀQ1n): ellipsoid 2 reaches that far along n. The
/// best n has this value.
template <class T, int D> PW85_FUNCTION inline SupportRatio<T, D>
support_ratio(Pair<T, D> const &pair, Vector<T, D> n) noexcept
{
    T const along = dot(n, pair.r12), q1 = quadratic_form(pair.q1, n),
            q2 = quadratic_form(pair.q2, n);
    if (!(q1 > T(0) && q2 > T(0) && q1 < largest_number<T>())) return {n, T(0), T(0), T(0)};
    T const root2 = square_root(q2), sum = root2 + absolute(along);
    return {along < T(0) ? -n : n, T(sum * sum) / q1, root2, T(sum * root2) / q1};
}

/// S, for which relative errors u of the data, entry by entry, change κ² by u S:
///     S = Σ|n_i|(|Q1_ij| + |Q2_ij|/ν)|n_j| + 2 Σ|r_i n_i|.
/// κ² is stationary in n and in ν. By the envelope theorem ∂κ²/∂r = 2n, ∂κ²/∂Q1 = -n nᵀ and ∂κ²/∂Q2
/// = n nᵀ/ν, with nᵀQ1n = κ² and nᵀQ2n = ν². The rounding of M is like relative errors u of the
/// data, which S counts. The scale of the given n does not enter.
template <class T, int D> PW85_FUNCTION inline T
ratio_condition_sum(Pair<T, D> const &pair, SupportRatio<T, D> const &reach) noexcept
{
    T const q1 = quadratic_form(pair.q1, reach.n), factor = square_root(T(reach.mu2 / q1));
    T const magnitude1 = magnitude_of_form(pair.q1, reach.n),
            magnitude2 = magnitude_of_form(pair.q2, reach.n);
    return T(reach.mu2 * (magnitude1 / q1)) +
           factor * (magnitude2 / reach.root2 + T(2) * magnitude_of_dot(pair.r12, reach.n));
}

/// Result of the search at ν.
template <class T, int D> struct DualStep {
    Vector<T, D> n;
    T upper; ///< g
    T e, next;
};

/// Computes n, and g from its residual ρ = r - Mn: rᵀM⁻¹r = 2rᵀn - nᵀMn + ρᵀM⁻¹ρ.
///
/// Proof of κ² <= g(ν): if x - r = y with yᵀQ2⁻¹y <= 1, then xᵀQ1⁻¹x <= ν + rᵀM⁻¹r + (xᵀQ1⁻¹x - ν
/// yᵀQ2⁻¹y - rᵀM⁻¹r), and the bracket is a concave function of x, whose largest value is 0. The
/// S-lemma says that the least g is κ².
///
/// g is convex, with g' = 1 - e and e = nᵀQ2n/ν². In the eigenbasis of the pencil, √e is the norm
/// of the vector of √ci/(ν - di), with the eigenvalues di of Q1⁻¹Q2 and the coordinates √ci of the
/// separation. 1/√e is a concave function that increases, as a mean of order -2 of linear
/// functions. So Newton's method for 1/√e = 1 increases ν monotonically after its first step, as
/// long as M is positive definite. Its step follows from e' = -2e (c/q + ν)/ν², where q = nᵀQ2n and
/// c = nᵀQ2M⁻¹Q2n.
template <class T, int D> PW85_FUNCTION inline DualStep<T, D>
take_dual_step(Pair<T, D> const &pair, SymmetricMatrix<T, D> const &m,
               Factorization<T, D> const &factors, T const &nu) noexcept
{
    Vector<T, D> const n = solve(factors, pair.r12), q2n = product(pair.q2, n);
    Vector<T, D> const rest = pair.r12 - product(m, n);
    T const q = dot(n, q2n), root = square_root(maximum(q, T(0))) / nu;
    T const form = quadratic_form(pair.q1, n) - T(q / nu);
    T const upper = nu + (T(T(2) * dot(pair.r12, n)) - form) + inverse_form(factors, rest);
    T const c = q > T(0) ? T(inverse_form(factors, q2n) / q) : T(0);
    return {n, upper, root, T(nu + T(T(nu * (root - T(1))) / (T(1) + c / nu)))};
}

/// A vector z that makes zᵀMz small: inverse iteration on M z = x Q2 z, which begins with the pivot
/// that is smallest relative to Q2.
template <class T, int D> PW85_FUNCTION inline Vector<T, D>
near_null_vector(SymmetricMatrix<T, D> const &q2, Factorization<T, D> const &factors) noexcept
{
    int smallest = 0;
    for (int i = 1; i < D; ++i)
        if (T(factors.pivots[i] * q2(smallest, smallest)) < T(factors.pivots[smallest] * q2(i, i)))
            smallest = i;
    Vector<T, D> z{};
    z[smallest] = T(1);
    z = solve(factors, z);
    z = solve(factors, product(q2, T(T(1) / largest_coordinate(z)) * z));
    return T(T(1) / largest_coordinate(z)) * z;
}

/// The best of n and of the two vectors n + αz with e = 1.
///
/// If r is orthogonal to the eigenvectors of the largest eigenvalue ν1 of Q1⁻¹Q2, e may be below 1
/// for all ν > ν1. Then ν = ν1. M is singular there, and n is the limit of M⁻¹r plus an eigenvector
/// z of such a length that e = 1. The ellipsoids touch at two points or more, which differ by the
/// sign of z, or by its direction in the eigenspace. This is the case for r = 0.
template <class T, int D>
PW85_FUNCTION inline SupportRatio<T, D> reach_beyond(Pair<T, D> const &pair, Vector<T, D> const &n,
                                                     Vector<T, D> const &z, T const &nu) noexcept
{
    SupportRatio<T, D> best = support_ratio(pair, n);
    T const a = quadratic_form(pair.q2, z), b = dot(n, product(pair.q2, z)),
            c = quadratic_form(pair.q2, n) - nu * nu;
    T const discriminant = b * b - T(a * c);
    if (!(discriminant >= T(0) && a > T(0))) return best;
    T const sum = b < T(0) ? T(b - square_root(discriminant)) : T(b + square_root(discriminant));
    T const alphas[2] = {T(-c / sum), T(-sum / a)};
    for (T const &alpha : alphas) {
        auto const other = support_ratio(pair, add_scaled(n, alpha, z));
        if (other.mu2 > best.mu2) best = other;
    }
    return best;
}

/// Returns whether a matrix is positive definite, if its factorisation is subject to rounding
/// errors. The factors are exact for a matrix that differs from M by at most 6 u √(M_ii M_jj) in
/// each entry (N. J. Higham, Accuracy and Stability of Numerical Algorithms, SIAM 2002, section
/// 10.1, with one more rounding for the reciprocal pivots). With M scaled to a unit diagonal, its
/// eigenvalues change by 18 u. The smallest one is at least 4/9 of the determinant, and at least
/// 1/inverse_eigenvalue_bound().
template <class T, int D> PW85_FUNCTION inline bool
exceeds_rounding(SymmetricMatrix<T, D> const &m, Factorization<T, D> const &factors) noexcept
{
    T const u = T(unit_roundoff<T>());
    T determinant = T(1);
    for (int i = 0; i < D; ++i) {
        if (!(m(i, i) > T(0) && factors.pivots[i] > T(0))) return false;
        determinant = determinant * T(factors.pivots[i] / m(i, i));
    }
    return determinant > T(T(64) * u) || T(T(32) * u) * inverse_eigenvalue_bound(factors, m) < T(1);
}

} // namespace pw85::detail

#endif

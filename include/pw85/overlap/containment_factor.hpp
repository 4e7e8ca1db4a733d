// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The factor by which ellipsoid 1 must be scaled to contain ellipsoid 2. pw85.hpp and the C API
/// use this file.
///
/// κ² is the largest xᵀQ1⁻¹x over ellipsoid 2. For ν > 0 let M = Q1 - Q2/ν and n = M⁻¹r. Each n
/// gives a lower bound on κ² (support_ratio()), and each ν with M positive definite the upper bound
/// g(ν) = ν + rᵀM⁻¹r (take_gauge_step()). The best n and the best ν have the value κ². Newton's
/// method finds them (search_gauge()).
///
/// The search stops where the bounds differ by 4 u S, with the S of ratio_condition_sum(). If
/// rounding errors prevent this, wider numbers repeat the search. The lower bound errs by 8 u S + 6
/// u κ² (see shows_outside() in containment.hpp), where S >= 2 κ². So the result errs by less than
/// 16 u S.
#ifndef PW85_OVERLAP_CONTAINMENT_FACTOR_HPP_INCLUDED
#define PW85_OVERLAP_CONTAINMENT_FACTOR_HPP_INCLUDED

#include <pw85/algebra/doubled.hpp>
#include <pw85/contact/condition.hpp>
#include <pw85/overlap/containment.hpp>

namespace pw85 {

/// How much ellipsoid 1 must be scaled to contain ellipsoid 2.
template <class T, int D> struct ContainmentScale {
    T mu2; ///< square of the factor of ellipsoid 1, about its centre
    /// where they touch then, on ellipsoid 2; relative to the centre of ellipsoid 1
    Vector<T, D> point;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// A pair in which Q1 is of order one, and so is the larger of r and Q2.
template <class T, int D> struct ContainedPair {
    Vector<T, D> r12;
    SymmetricMatrix<T, D> q1, q2;
};

/// A ContainedPair, and the exponents that lead back to the units of the caller.
template <class T, int D> struct ScaledContainedPair {
    ContainedPair<T, D> pair;
    int length; ///< r12 is that of the pair times 2^length
    int form;   ///< Q1 is that of the pair times 4^form
};

/// Scales a valid pair by powers of two. A form Q2 that is much smaller than r is enlarged to a
/// fixed small size. The forms that T can hold are flat by so little that this changes nothing in
/// κ² beyond rounding.
template <class T, int D>
PW85_FUNCTION inline ScaledContainedPair<T, D> scale_contained(Pair<T, D> const &pair) noexcept
{
    constexpr int smallest =
        -std::numeric_limits<typename ScalarTraits<T>::Lane>::max_exponent / 8 * 3;
    T const r = largest_coordinate(pair.r12);
    int const e1 = half_exponent(largest_diagonal(pair.q1)),
              e2 = half_exponent(largest_diagonal(pair.q2));
    int const er = r > T(0) ? binary_exponent(r) : e2, length = er > e2 ? er : e2;
    int const size = e2 - length > smallest ? e2 - length : smallest;
    return {{times_power_of_two(pair.r12, -length), times_power_of_two(pair.q1, -2 * e1),
             times_power_of_two(pair.q2, 2 * (size - e2))},
            length,
            e1};
}

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
support_ratio(ContainedPair<T, D> const &pair, Vector<T, D> n) noexcept
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
ratio_condition_sum(ContainedPair<T, D> const &pair, SupportRatio<T, D> const &reach) noexcept
{
    T const q1 = quadratic_form(pair.q1, reach.n), factor = square_root(T(reach.mu2 / q1));
    T const magnitude1 = magnitude_of_form(pair.q1, reach.n),
            magnitude2 = magnitude_of_form(pair.q2, reach.n);
    return T(reach.mu2 * (magnitude1 / q1)) +
           factor * (magnitude2 / reach.root2 + T(2) * magnitude_of_dot(pair.r12, reach.n));
}

/// What the search computes at ν.
template <class T, int D> struct GaugeStep {
    Vector<T, D> n;
    T upper; ///< g
    T e, next;
};

/// Computes n, and g from its residual ρ = r - Mn: rᵀM⁻¹r = 2rᵀn - nᵀMn + ρᵀM⁻¹ρ.
///
/// κ² <= g(ν). For, if x - r = y with yᵀQ2⁻¹y <= 1, then xᵀQ1⁻¹x <= ν + rᵀM⁻¹r + (xᵀQ1⁻¹x - ν
/// yᵀQ2⁻¹y - rᵀM⁻¹r), and the bracket is a concave function of x, whose largest value is 0. The
/// S-lemma says that the least g is κ².
///
/// g is convex, with g' = 1 - e and e = nᵀQ2n/ν². In the eigenbasis of the pencil, √e is the norm
/// of the vector of √ci/(ν - di), with the eigenvalues di of Q1⁻¹Q2 and the coordinates √ci of the
/// separation. 1/√e is a concave function that increases, as a mean of order -2 of linear
/// functions. So Newton's method on 1/√e = 1 increases monotonically after its first step, if M
/// stays positive definite. Its step follows from e' = -2e (c/q + ν)/ν², where q = nᵀQ2n and c =
/// nᵀQ2M⁻¹Q2n.
template <class T, int D> PW85_FUNCTION inline GaugeStep<T, D>
take_gauge_step(ContainedPair<T, D> const &pair, SymmetricMatrix<T, D> const &m,
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
/// sign of z, or by its direction in the eigenspace. This is so for r = 0.
template <class T, int D>
PW85_FUNCTION inline SupportRatio<T, D> reach_beyond(ContainedPair<T, D> const &pair,
                                                     Vector<T, D> const &n, Vector<T, D> const &z,
                                                     T const &nu) noexcept
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

/// The state of the search: a bracket of ν, the best reach, and the least g.
template <class T, int D> struct GaugeSearch {
    T lower, upper; ///< of ν
    SupportRatio<T, D> best;
    T bound; ///< κ² from above
    T width; ///< of the bracket when next_in_bracket() was last called
};

/// Whether the bounds on κ² differ by no more than `tolerance` S.
template <class T, int D> PW85_FUNCTION inline bool is_settled(ContainedPair<T, D> const &pair,
                                                               GaugeSearch<T, D> const &search,
                                                               T const &tolerance) noexcept
{
    T const mu2 = search.best.mu2, gap = search.bound - mu2;
    return mu2 > T(0) &&
           (gap <= tolerance * mu2 || gap <= T(tolerance * ratio_condition_sum(pair, search.best)));
}

/// Whether a matrix is positive definite, if its factorisation is subject to rounding errors. The
/// factors are exact for a matrix that differs from M by at most 6 u √(M_ii M_jj) in each entry (N.
/// J. Higham, Accuracy and Stability of Numerical Algorithms, SIAM 2002, section 10.1, with one
/// more rounding for the reciprocal pivots). With M scaled to a unit diagonal, its eigenvalues
/// change by 18 u. The smallest one is at least 4/9 of the determinant, and at least 1/condition().
template <class T, int D> PW85_FUNCTION inline bool
exceeds_rounding(SymmetricMatrix<T, D> const &m, Factorization<T, D> const &factors) noexcept
{
    T const u = T(unit_roundoff<T>());
    T determinant = T(1);
    for (int i = 0; i < D; ++i) {
        if (!(m(i, i) > T(0) && factors.pivots[i] > T(0))) return false;
        determinant = determinant * T(factors.pivots[i] / m(i, i));
    }
    return determinant > T(T(64) * u) || T(T(32) * u) * condition(factors, m) < T(1);
}

/// Evaluates at ν, and returns the ν that Newton's method suggests. It is no suggestion if M is not
/// positive definite.
template <class T, int D> PW85_FUNCTION inline T
evaluate_at(ContainedPair<T, D> const &pair, GaugeSearch<T, D> &search, T const &nu) noexcept
{
    SymmetricMatrix<T, D> m = pair.q1;
    for (int k = 0; k < m.size; ++k) m[k] = m[k] - T(pair.q2[k] / nu);
    auto const factors = factorize(m, T(0));
    if (!exceeds_rounding(m, factors)) {
        search.lower = nu;
        return nu;
    }
    auto const step = take_gauge_step(pair, m, factors, nu);
    auto const reach = step.e < T(1)
                           ? reach_beyond(pair, step.n, near_null_vector(pair.q2, factors), nu)
                           : support_ratio(pair, step.n);
    if (reach.mu2 > search.best.mu2) search.best = reach;
    search.bound = minimum(search.bound, step.upper);
    (step.e > T(1) ? search.lower : search.upper) = nu;
    return step.next;
}

/// The number of steps. Bisection of a factor of two to the last digit takes as many steps as there
/// are digits. Between two of them there may be one of each other kind.
template <class T> PW85_FUNCTION constexpr int max_gauge_steps() noexcept
{
    return 3 * mantissa_digits<T>() + 40;
}

/// The next ν where Newton's method leaves the bracket, as it does for a minimum at ν1. Near the
/// minimum the ν of the best reach errs by the square of the error of n. So the next one is above
/// it by the square of its distance from the upper end, as long as this halves the bracket.
/// Otherwise it is in the middle of the bracket.
template <class T, int D> PW85_FUNCTION inline T next_in_bracket(GaugeSearch<T, D> &search) noexcept
{
    if (!(search.upper < largest_number<T>())) return T(2) * search.lower;
    T const excess = search.upper - search.best.nu,
            next = search.best.nu + excess * T(excess / search.upper);
    T const width = search.upper - search.lower;
    bool const halves = width <= T(T(0.5) * search.width);
    search.width = width;
    return halves && next > search.lower && next < search.upper
               ? next
               : T(T(0.5) * (search.lower + search.upper));
}

/// Searches from ν on for bounds that differ by no more than `tolerance` S.
template <class T, int D> PW85_FUNCTION inline bool search_gauge(ContainedPair<T, D> const &pair,
                                                                 GaugeSearch<T, D> &search, T nu,
                                                                 T const &tolerance) noexcept
{
    for (int step = 0; step < max_gauge_steps<T>(); ++step) {
        T next = evaluate_at(pair, search, nu);
        if (is_settled(pair, search, tolerance)) return true;
        if (!(next > search.lower && next < search.upper)) next = next_in_bracket(search);
        if (!(next > search.lower && next < search.upper)) return false;
        nu = next;
    }
    return false;
}

/// A ν at which M is positive definite: the larger of the trace of Q1⁻¹Q2 and of the ν that balls
/// with the extents along r would have.
template <class T, int D>
PW85_FUNCTION inline T initial_nu(ContainedPair<T, D> const &pair) noexcept
{
    auto const factors = factorize(pair.q1, T(unit_roundoff<T>()));
    T sum = T(0);
    for (int i = 0; i < D; ++i) {
        Vector<T, D> column{};
        for (int j = 0; j < D; ++j) column[j] = pair.q2(i, j);
        sum = sum + solve(factors, column)[i];
    }
    Vector<T, D> const n = solve(factors, pair.r12);
    T const q1 = quadratic_form(pair.q1, n), q2 = quadratic_form(pair.q2, n);
    T const ball =
        q2 > T(0) ? T(square_root(support_ratio(pair, n).mu2) * square_root(T(q2 / q1))) : T(0);
    return maximum(sum, ball);
}

/// The result of a search.
template <class T, int D> struct GaugeMinimum {
    T mu2;
    Vector<T, D> point;
    bool settled;
};

/// Searches with numbers of type W, which may be wider than those of the pair. The point is r +
/// Q2n/√(nᵀQ2n), on the surface of ellipsoid 2. The largest Q2ii/Q1ii is a lower bound on
/// λmax(Q1⁻¹Q2), and hence on ν.
template <class W, class T, int D> [[gnu::noinline]] PW85_FUNCTION inline GaugeMinimum<T, D>
find_gauge_with(ContainedPair<T, D> const &pair, W const &tolerance) noexcept
{
    ContainedPair<W, D> const wide{converted<W>(pair.r12), converted<W>(pair.q1),
                                   converted<W>(pair.q2)};
    GaugeSearch<W, D> search{W(0),
                             largest_number<W>(),
                             {{}, W(0), W(0), W(0)},
                             largest_number<W>(),
                             largest_number<W>()};
    for (int i = 0; i < D; ++i)
        search.lower = maximum(search.lower, W(wide.q2(i, i) / wide.q1(i, i)));
    search.lower = W(T(0.5)) * search.lower;
    bool const settled = search_gauge(wide, search, initial_nu(wide), tolerance);
    auto const point =
        add_scaled(wide.r12, W(W(1) / search.best.root2), product(wide.q2, search.best.n));
    GaugeMinimum<T, D> gauge{rounded(search.best.mu2), {}, settled};
    for (int i = 0; i < D; ++i) gauge.point[i] = rounded(point[i]);
    return gauge;
}

/// Searches with wider numbers.
template <class T, int D>
PW85_RARE GaugeMinimum<T, D> find_gauge_wider(ContainedPair<T, D> const &pair) noexcept
{
    T const u = T(unit_roundoff<T>());
    auto const finer = find_gauge_with(pair, Doubled<T>(u));
    return finer.settled ? finer : find_gauge_with(pair, exact::Extended<T>(u));
}

#define PW85_RARE_GAUGE(rare, T, D)                                                                \
    rare(find_gauge_wider, (ContainedPair<T, D> const &pair), (pair))
PW85_RARE_TIER(PW85_RARE_GAUGE)

/// Searches with T, then with wider numbers if T has them.
template <class T, int D>
PW85_FUNCTION inline GaugeMinimum<T, D> find_gauge(ContainedPair<T, D> const &pair) noexcept
{
    auto const gauge = find_gauge_with(pair, T(T(4) * T(unit_roundoff<T>())));
    if constexpr (has_extended_numbers<T>)
        if (!gauge.settled) return find_gauge_wider(pair);
    return gauge;
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D>
PW85_FUNCTION inline ContainmentScale<T, D> containment(Vector<T, D> const &r12,
                                                        SymmetricMatrix<T, D> const &q1,
                                                        SymmetricMatrix<T, D> const &q2) noexcept
{
    using namespace detail;
    auto const pair = pair_of(r12, q1, q2);
    StatusCode const status = passes_fast_checks(pair) ? StatusCode::success : validate_apart(pair);
    if (status != StatusCode::success) return all_nan<ContainmentScale<T, D>>(status);
    auto const scaled = scale_contained(pair);
    auto const gauge = find_gauge(scaled.pair);
    if (!gauge.settled) return all_nan<ContainmentScale<T, D>>(StatusCode::no_convergence);
    return {times_power_of_two(gauge.mu2, 2 * (scaled.length - scaled.form)),
            times_power_of_two(gauge.point, scaled.length), StatusCode::success};
}

} // namespace pw85

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The search for the common normal of the closest points of two ellipsoids. distance.hpp and
/// src/simd/lanes/distance.hpp call find_normal() and take_step(). These functions call the solvers
/// of symmetric.hpp and accurate_product(). nested_search.hpp has the search that never fails.
///
/// Let α(n) = √(nᵀQ1n), β(n) = √(nᵀQ2n) and r = r12. The distance of ellipsoids that are apart is
/// the largest value over unit vectors n of φ(n) = n·r - α - β, the width of the slab between them
/// that is normal to n. φ is concave in the unit ball. For any n, Q1n/α and r - Q2n/β are points of
/// the surfaces. The vector w from the first to the second has n·w = φ(n). So φ(n) <= distance <=
/// |w|. Both are equalities where w = φ n, that is, r = (Q1/α + Q2/β + φ I) n.
///
/// Let u = n/α, t = α/β and s = αφ. Then M u = r with M = Q1 + t Q2 + s I, A = uᵀQ1u = 1 and t²B =
/// t²uᵀQ2u = 1. The last two are equations for t and s, which Newton's method solves.
#ifndef PW85_DISTANCE_NORMAL_SEARCH_HPP_INCLUDED
#define PW85_DISTANCE_NORMAL_SEARCH_HPP_INCLUDED

#include <pw85/algebra/doubled.hpp>
#include <pw85/contact/geometry.hpp>
#include <pw85/contact/solver.hpp>
#include <pw85/distance/support.hpp>

namespace pw85::detail {

/// The unknowns t and s. In the units of a DistancePair M = P1 + t P2 + s I with P = scale Q. The
/// statements on A + tB and 1 + 1/t then hold for scale1 A + scale2 tB and scale1 + scale2/t.
template <class T> struct Multipliers {
    T ratio, shift;
};

/// The numbers at some t and s from which the equations are formed. S = A + tB.
template <class T> struct NormalJet {
    T r, form_u;                 ///< rᵀu, uᵀM⁻¹u
    T a, b;                      ///< A and B
    T log_ratio, log_shift;      ///< ½ AB ∂(log B/A)/∂t, ½ AB ∂(log B/A)/∂s
    T sum, sum_ratio, sum_shift; ///< S, -½ ∂S/∂t, -½ ∂S/∂s
};

/// R = rᵀM⁻¹r as a quotient a/b of polynomials in t and s, which have positive coefficients. The
/// coefficients are those of 1, t, t² ..., and of these times s and s².
template <class T> struct ShiftedForm {
    T a[3], a_s[2], a_ss;
    T b[4], b_s[3], b_ss[2], b_sss;
};

template <class T>
PW85_FUNCTION constexpr ShiftedForm<T> shifted_form(Vector<T, 2> const &r12,
                                                    SymmetricMatrix<T, 2> const &p1,
                                                    SymmetricMatrix<T, 2> const &p2) noexcept
{
    auto const rational = rational_form(Pair<T, 2>{r12, p1, p2, T(1)});
    return {{rational.a[0], rational.a[1], T(0)},
            {dot(r12, r12), T(0)},
            T(0),
            {rational.b[0], rational.b[1], rational.b[2], T(0)},
            {trace(p1), trace(p2), T(0)},
            {T(1), T(0)},
            T(0)};
}

template <class T>
PW85_FUNCTION constexpr ShiftedForm<T> shifted_form(Vector<T, 3> const &r12,
                                                    SymmetricMatrix<T, 3> const &p1,
                                                    SymmetricMatrix<T, 3> const &p2) noexcept
{
    auto const weights = outer_weights(r12);
    auto const adj1 = adjugate(p1), adj2 = adjugate(p2), mixed = mixed_adjugate(p1, p2);
    T const r2 = dot(r12, r12), trace1 = trace(p1), trace2 = trace(p2);
    return {{quadratic_form(adj1, weights), quadratic_form(mixed, weights),
             quadratic_form(adj2, weights)},
            {trace1 * r2 - quadratic_form(p1, weights), trace2 * r2 - quadratic_form(p2, weights)},
            r2,
            {determinant(p1, adj1), contraction(adj1, p2), contraction(adj2, p1),
             determinant(p2, adj2)},
            {trace(adj1), trace(mixed), trace(adj2)},
            {trace1, trace2},
            T(1)};
}

/// Evaluates the equations by the polynomials. With C = uᵀu, B = -∂R/∂t, C = -∂R/∂s and A = R -
/// tB - sC. So no step except the last needs to solve linear equations. The coefficients lose
/// digits as the aspect ratio grows, so the result only guides the search. Here the forms are P, n
/// is b²B, and S is R - sC.
template <class T, int D>
PW85_FUNCTION constexpr NormalJet<T> evaluate_normal(DistancePair<T, D> const &pair,
                                                     ShiftedForm<T> const &f,
                                                     Multipliers<T> const &x) noexcept
{
    T const t = x.ratio, s = x.shift, t2 = t + t, s2 = s + s;
    T const a1 = f.a_s[0] + t * f.a_s[1], b1 = f.b_s[0] + t * (f.b_s[1] + t * f.b_s[2]);
    T const b2 = f.b_ss[0] + t * f.b_ss[1], b3 = s * f.b_sss, third = T(3) * (t * f.b[3]);
    T const a = (f.a[0] + t * (f.a[1] + t * f.a[2])) + s * (a1 + s * f.a_ss);
    T const a_t = f.a[1] + t2 * f.a[2] + s * f.a_s[1], a_s = a1 + s2 * f.a_ss;
    T const b = (f.b[0] + t * f.b[1]) + (t * t) * (f.b[2] + t * f.b[3]) + s * (b1 + s * (b2 + b3));
    T const half = f.b_s[1] + t2 * f.b_s[2], b_s = b1 + s * (T(2) * b2 + T(3) * b3);
    T const b_t = (f.b[1] + t * (T(2) * f.b[2] + third)) + s * (half + s * f.b_ss[1]);
    T const half_tt = f.b[2] + third + s * f.b_s[2], b_ts = half + s2 * f.b_ss[1],
            half_ss = b2 + T(3) * b3;
    T const n = a * b_t - a_t * b, c = a * b_s - a_s * b, half_n_t = a * half_tt - f.a[2] * b;
    T const half_n_s = T(0.5) * ((a * b_ts - f.a_s[1] * b) + (a_s * b_t - a_t * b_s));
    T const half_c_s = a * half_ss - f.a_ss * b;
    T const q = rough_quotient(T(1), b), q2 = q * q, log_t = b_t * q, log_s = b_s * q;
    T const form_b = n * q2, form_c = c * q2, sum = (a * b - s * c) * q2;
    T const b_ratio = log_t * form_b - half_n_t * q2, b_shift = log_s * form_b - half_n_s * q2;
    T const form_u = log_s * form_c - half_c_s * q2, sum_shift = form_c - s * form_u;
    T const unit1 = T(1) / pair.scale1, unit2 = T(1) / pair.scale2, unit = unit1 * unit2;
    return {a * q,
            form_u,
            unit1 * (sum - t * form_b),
            unit2 * form_b,
            unit * (form_b * (form_b - s * b_shift) - sum * b_ratio),
            unit * (form_b * sum_shift - sum * b_shift),
            sum,
            T(0.5) * form_b - s * b_shift,
            sum_shift};
}

/// A step in log t, as a fraction, and a step in s.
template <class T> struct NormalStep {
    T numerator, denominator;
    T shift;
};

/// Newton's step. The method converges from afar if the equations are written as t²B = A, solved
/// for log t, and 1/√(A + tB) = 1/√(1 + 1/t), which is nearly affine in s. With v = t(A + tB) and w
/// = 1 + t, the fraction (w + 3v)/(3w + v) takes the place of √(v/w). Both are one, and their
/// derivatives agree, where v = w. `Pair` is a DistancePair, or one in n dimensions.
template <class Pair, class T> PW85_FUNCTION constexpr NormalStep<T>
newton_step(Pair const &pair, NormalJet<T> const &j, Multipliers<T> const &x) noexcept
{
    T const t = x.ratio, c = t * t * j.b, weight = j.a * j.b, both = j.a + c;
    T const h = weight * (c - j.a), h_ratio = both * (weight + t * j.log_ratio),
            h_shift = both * j.log_shift;
    T const v = t * j.sum, w = pair.scale1 * t + pair.scale2, below = t * w * (T(3) * w + v);
    T const k = T(4) * v * w * (v - w), k_shift = T(-2) * below * j.sum_shift;
    T const k_ratio = pair.scale2 * v * (w + T(3) * v) - T(2) * t * below * j.sum_ratio;
    T const determinant = h_shift * k_ratio - h_ratio * k_shift;
    NormalStep<T> step{h * k_shift - h_shift * k, determinant,
                       rough_quotient(T(h_ratio * k - h * k_ratio), determinant)};
    auto const alone = x.shift + step.shift < T(0);
    // If a step would make s negative, each equation is solved alone, the second one first. With s
    // = 0 the first equation leads to the maximum of the contact function, where the second one has
    // a root.
    if (any_of(alone)) {
        T const shift = maximum(T(-x.shift), T(-rough_quotient(k, k_shift)));
        step.shift = select(alone, shift, step.shift);
        step.numerator = select(alone, T(-(h + h_shift * shift)), step.numerator);
        step.denominator = select(alone, h_ratio, step.denominator);
    }
    return step;
}

/// Returns whether a step is at most 2^-digits, relative to t, and relative to u in the norm of M.
/// In this norm a change of t causes a smaller relative change of u than of t.
template <class T> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
is_within(NormalStep<T> const &step, NormalJet<T> const &j, int digits) noexcept
{
    T const bound = negative_power_of_two<T>(digits);
    return absolute(step.numerator) <= bound * absolute(step.denominator) &&
           step.shift * step.shift * j.form_u <= bound * bound * j.r;
}

/// t and s after a step, with e^x to third order. A step in log t is at most 1.5, by which t
/// changes by a factor of 7. This is a choice (docs/implementation.rst).
template <class T> PW85_FUNCTION constexpr Multipliers<T>
advance(Multipliers<T> const &x, NormalStep<T> const &step) noexcept
{
    T const n = step.numerator, d = step.denominator, twice = d + d, bound = T(1.5);
    T const largest = (T(2) + bound) / (T(2) - bound), smallest = T(1) / largest;
    auto const distant = absolute(n) > bound * absolute(d), up = n * d > T(0);
    T const factor =
        select(distant, select(up, largest, smallest), rough_quotient(T(twice + n), T(twice - n)));
    return {x.ratio * factor, maximum(T(0), T(x.shift + step.shift))};
}

/// The point where the search starts. It is exact for spheres.
template <class T, int D>
PW85_FUNCTION inline Multipliers<T> initial_multipliers(DistancePair<T, D> const &pair) noexcept
{
    auto const weights = outer_weights(pair.r12);
    T const a = square_root(positive_form(pair.q1, weights)),
            b = square_root(positive_form(pair.q2, weights));
    T const width = T(1) - (pair.scale1 * a + pair.scale2 * b) / dot(pair.r12, pair.r12);
    return {a / b, a * maximum(T(0), width)};
}

/// The point where the search restarts if it does not converge. It is exact for ellipsoids that
/// touch.
template <class T, int D>
PW85_FUNCTION inline Multipliers<T> touching_multipliers(DistancePair<T, D> const &pair) noexcept
{
    T const ratio = pair.scale1 / pair.scale2;
    Maximum<T> const m = maximize(Pair<T, D>{pair.r12, pair.q1, pair.q2, ratio});
    return {m.lambda / m.complement / ratio, T(0)};
}

/// The state of a search by the polynomials. The result of a lane depends only on its own pair.
template <class T> struct NormalSearch {
    ShiftedForm<T> form;
    Multipliers<T> x;
    typename ScalarTraits<T>::Mask active; ///< not converged
};

template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline NormalSearch<T>
start_search(DistancePair<T, D> const &pair, Multipliers<T> const &x) noexcept
{
    return {shifted_form(pair.r12, pair.scale1 * pair.q1, pair.scale2 * pair.q2), x,
            x.ratio == x.ratio};
}

template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline NormalSearch<T>
start_search(DistancePair<T, D> const &pair) noexcept
{
    return start_search(pair, initial_multipliers(pair));
}

/// The numbers of steps after which a search gives up: steps by the polynomials, and last steps by
/// factorisation. They are choices (docs/implementation.rst).
inline constexpr int max_normal_steps = 16, max_last_steps = 6;

/// Takes one step. A lane has converged after a step below 2^-(digits/4). The error that remains is
/// about the square of the step, and a last step squares it once more, which is rounding. This
/// limit is a choice, too.
template <class T, int D> PW85_FUNCTION inline void
take_step(NormalSearch<T> &search, DistancePair<T, D> const &pair) noexcept
{
    auto const jet = evaluate_normal(pair, search.form, search.x);
    auto const step = newton_step(pair, jet, search.x);
    auto const next = advance(search.x, step);
    search.x.ratio = select(search.active, next.ratio, search.x.ratio);
    search.x.shift = select(search.active, next.shift, search.x.shift);
    search.active = search.active && !is_within(step, jet, mantissa_digits<T>() / 4);
}

template <class T, int D> PW85_FUNCTION constexpr SymmetricMatrix<T, D>
normal_matrix(DistancePair<T, D> const &pair, Multipliers<T> const &x) noexcept
{
    SymmetricMatrix<T, D> m = blend(pair.scale1, pair.q1, T(x.ratio * pair.scale2), pair.q2);
    for (int i = 0; i < D; ++i) m(i, i) = m(i, i) + x.shift;
    return m;
}

/// Solves with M by the adjugate.
template <class T, int D> struct Inverse {
    SymmetricMatrix<T, D> adjugate;
    T factor; ///< 1/det M
};

template <class T, int D> PW85_FUNCTION constexpr Vector<T, D> solve(Inverse<T, D> const &inverse,
                                                                     Vector<T, D> const &x) noexcept
{
    return inverse.factor * product(inverse.adjugate, x);
}

/// The product of a form with a vector that comes from a solution with M. It is plain for a
/// solution by the adjugate and accurate for a solution by factorisation. Types with digits to
/// spare need only the plain product.
template <class T, int D> PW85_FUNCTION constexpr Vector<T, D>
form_product(Inverse<T, D> const &, SymmetricMatrix<T, D> const &q, Vector<T, D> const &u) noexcept
{
    return product(q, u);
}

template <class T, int D>
PW85_FUNCTION inline Vector<T, D> form_product(Factorization<T, D> const &,
                                               SymmetricMatrix<T, D> const &q,
                                               Vector<T, D> const &u) noexcept
{
    if constexpr (std::is_same_v<Finer<T>, T>)
        return product(q, u);
    else
        return accurate_product(q, u);
}

/// The vector u with its derivatives.
template <class T, int D> struct NormalVector {
    Vector<T, D> u, u_ratio, u_shift; ///< u, -∂u/∂t, -∂u/∂s
    NormalJet<T> jet;
};

/// Computes u and its derivatives by solutions with M.
template <class T, int D, class Solver>
[[gnu::always_inline]] PW85_FUNCTION inline NormalVector<T, D>
solve_normal(DistancePair<T, D> const &pair, Solver const &solver, Multipliers<T> const &x) noexcept
{
    Vector<T, D> const u = solve(solver, pair.r12);
    Vector<T, D> const p = form_product(solver, pair.q1, u), q = form_product(solver, pair.q2, u);
    Vector<T, D> const u_ratio = pair.scale2 * solve(solver, q), u_shift = solve(solver, u);
    T const a = positive_form(pair.q1, u, p), b = positive_form(pair.q2, u, q),
            weighted = pair.scale2 * x.ratio;
    T const a_ratio = dot(p, u_ratio), a_shift = dot(p, u_shift), b_ratio = dot(q, u_ratio),
            b_shift = dot(q, u_shift);
    return {u,
            u_ratio,
            u_shift,
            {dot(u, pair.r12), dot(u, u_shift), a, b, b * a_ratio - a * b_ratio,
             b * a_shift - a * b_shift, pair.scale1 * a + weighted * b,
             pair.scale1 * a_ratio + weighted * b_ratio - T(0.5) * (pair.scale2 * b),
             pair.scale1 * a_shift + weighted * b_shift}};
}

/// Returns u after a step.
template <class T, int D> PW85_FUNCTION constexpr Vector<T, D>
advance(NormalVector<T, D> const &v, Multipliers<T> const &x, NormalStep<T> const &step) noexcept
{
    T const ratio = x.ratio * rough_quotient(step.numerator, step.denominator);
    Vector<T, D> u = v.u;
    for (int i = 0; i < D; ++i) u[i] = u[i] - (ratio * v.u_ratio[i] + step.shift * v.u_shift[i]);
    return u;
}

/// A step that is below 2^-last_digits() is the last one, because its square is below rounding.
template <class T> PW85_FUNCTION constexpr int last_digits() noexcept
{
    return (mantissa_digits<T>() + 1) / 2;
}

/// The result of a last step, which ends at u.
template <class T, int D> struct LastStep {
    Vector<T, D> u; ///< along the normal, if it is found
    Multipliers<T> next;
    typename ScalarTraits<T>::Mask found;
};

template <class T, int D, class Solver> [[gnu::always_inline]] PW85_FUNCTION inline LastStep<T, D>
take_last_step(DistancePair<T, D> const &pair, Solver const &solver,
               Multipliers<T> const &x) noexcept
{
    auto const v = solve_normal(pair, solver, x);
    auto const step = newton_step(pair, v.jet, x);
    return {advance(v, x, step), advance(x, step), is_within(step, v.jet, last_digits<T>())};
}

/// Takes a last step by the adjugate. Where the errors of the adjugate matter, the slab that u
/// gives is not accurate (distance.hpp).
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline LastStep<T, D>
take_last_step(DistancePair<T, D> const &pair, Multipliers<T> const &x) noexcept
{
    auto const m = normal_matrix(pair, x);
    auto const adj = adjugate(m);
    return take_last_step(pair, Inverse<T, D>{adj, T(1) / determinant(m, adj)}, x);
}

/// Factorises M, which serves any shape.
template <class T, int D> PW85_FUNCTION inline Factorization<T, D>
factorize_normal(DistancePair<T, D> const &pair, Multipliers<T> const &x) noexcept
{
    return factorize(normal_matrix(pair, x), T(unit_roundoff<T>()));
}

/// Finds a vector along the normal by Newton's method with factorisation, starting at t and s.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline LastStep<T, D>
follow_normal(DistancePair<T, D> const &pair, Multipliers<T> x) noexcept
{
    auto last = take_last_step(pair, factorize_normal(pair, x), x);
    for (int i = 1; i < max_last_steps && !last.found; ++i)
        last = take_last_step(pair, factorize_normal(pair, last.next), last.next);
    return last;
}

/// Finds a vector along the normal by Newton's method, starting from the state of a search. Returns
/// also the last t and s.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline LastStep<T, D>
find_normal(DistancePair<T, D> const &pair, NormalSearch<T> search) noexcept
{
    for (int i = 0; i < max_normal_steps && search.active; ++i) take_step(search, pair);
    if (search.active) return {{}, search.x, false};
    auto const last = take_last_step(pair, search.x);
    return last.found ? last : follow_normal(pair, last.next);
}

} // namespace pw85::detail

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Lower bounds of the path of a particle to its neighbours. The event chains (contact_search.cpp)
/// use this file.
///
/// The particle moves by x d; the separation is r - x d. With M = Q1 + t Q2, rᵀadj(M)r - (1 + 1/t)
/// det M is positive where f > 1 at this t (item 1 of motion/translation.hpp). On the path it is a
/// polynomial of degree two. So its first root is a lower bound of the path, and there is no
/// contact if it has no root ahead. Each t gives a bound; the largest of all bounds is the path to
/// the contact.
///
/// Two obstacles are in the lanes of a pack. All formulas hold for one number as well.
#ifndef PW85_SIMULATION_PATH_BOUNDS_HPP_INCLUDED
#define PW85_SIMULATION_PATH_BOUNDS_HPP_INCLUDED

#include <pw85/motion/translation.hpp>

#include "../simd/pack.hpp"
#include "configuration.hpp"

namespace pw85::detail::simulation {

/// A moving particle and an obstacle, or two such pairs in lanes.
template <class T> struct MovingPair {
    Vector<T, 3> r12, direction;
    SymmetricMatrix<T, 3> q1, q2;
    T size; ///< Σ|r_i| + x with the addition of evaluate_path()
};

/// The polynomial rᵀadj(M)r - (1 + 1/t) det M on the path, excess - 2 approach x + speed x², and
/// the margin for its rounding errors (evaluate_path()).
template <class T> struct PathPolynomial {
    T excess, approach, speed, margin;

    [[gnu::always_inline]] T root_of_discriminant() const noexcept
    {
        return square_root(maximum(T(0.0), T(approach * approach - excess * speed)));
    }

    /// Returns the first root ahead, or the position of the least value if there is no root; zero
    /// if the polynomial begins at zero or below, or grows.
    [[gnu::always_inline]] T position(T const &root) const noexcept
    {
        T const x = minimum(T(excess / (approach + root)), T(approach / speed));
        return select(approach > T(0.0) && excess > T(0.0), x, T(0.0));
    }

    /// Returns the bound from the position and the root, or infinity if no path up to a length has
    /// a contact. The polynomial is convex, so its root becomes less by no more than margin/(2
    /// root) if the margin is subtracted: `root` is that of the discriminant, half of the slope at
    /// the first root.
    [[gnu::always_inline]] T bound(T const &position, T const &root, T const &length) const noexcept
    {
        T const lowest = maximum(T(0.0), minimum(T(approach / speed), length));
        T const least = excess - (T(2.0) * approach - speed * lowest) * lowest;
        T const before = maximum(T(0.0), T(position - T(0.5) * margin / root));
        return select(least > margin, T(infinity<double>()), before);
    }
};

/// Everything at one t.
template <class T> struct PathEvaluation {
    SymmetricMatrix<T, 3> adjugate;
    T determinant;
    Vector<T, 3> s, s_direction; ///< adj(M) times r and d
    PathPolynomial<T> polynomial;
};

/// Computes the polynomial at t. `level` is 1 + 1/t.
///
/// The sum of the magnitudes of all terms of the polynomial is below 8 (Σ|r_i| + x)² (tr M)² + 16
/// (1 + 1/t) (tr M)³. The margin, 2⁻³² times that, is above the rounding errors by far. It also
/// covers the rounding of positions, which is some u of the coordinates of centres and
/// translations, because 2⁻¹⁶ times these coordinates is added to Σ|r_i| + x. If the polynomial
/// exceeds the margin at a bound, no earlier position touches, however positions are rounded.
template <class T> [[gnu::always_inline]] inline PathEvaluation<T>
evaluate_path(MovingPair<T> const &e, T const &t, T const &level) noexcept
{
    auto const m = blend(e.q1, t, e.q2), adj = adjugate(m);
    T const det = determinant(m, adj), size = trace(m);
    Vector<T, 3> const s = product(adj, e.r12), s_direction = product(adj, e.direction);
    T const margin = T(0x1p-32) * size * size * (T(8.0) * e.size * e.size + T(16.0) * level * size);
    return {
        adj,
        det,
        s,
        s_direction,
        {dot(e.r12, s) - level * det, dot(e.direction, s), dot(e.direction, s_direction), margin}};
}

/// A bound, and the state of the search for a larger one.
template <class T> struct PathBound {
    T bound;
    T t;    ///< after Newton's step
    T step; ///< its magnitude in log t
};

/// Newton's step, no longer than 1, for the root of h (contact/iteration.hpp) at the position x of
/// a view. Steps at the x of the present bound lead to the t of the contact. After a step δ, log t
/// errs by about δ², and x by the square of that.
template <class T>
[[gnu::always_inline]] inline PathBound<T> step_towards_contact(MovingPair<T> const &e,
                                                                PathEvaluation<T> const &view,
                                                                T const &x, T const &t) noexcept
{
    Vector<T, 3> const s = add_scaled(view.s, T(-x), view.s_direction), bent = product(e.q2, s);
    auto const weights = outer_weights(s);
    T const a = quadratic_form(e.q1, weights), b = quadratic_form(e.q2, weights);
    T const c = dot(bent, product(view.adjugate, bent)) / view.determinant;
    Step<T> step = newton_step(slope(first_jet(a, b, c, t), T(1.0), t));
    step.numerator = maximum(T(-step.denominator), minimum(step.denominator, step.numerator));
    return {T(0.0), t * exponential(step), absolute(step.numerator) / step.denominator};
}

/// The bound for paths up to a length from some t, and a step to a better one.
template <class T> [[gnu::always_inline]] inline PathBound<T>
improve_bound(MovingPair<T> const &e, T const &t, T const &length) noexcept
{
    auto const view = evaluate_path(e, t, T(T(1.0) + T(1.0) / t));
    T const root = view.polynomial.root_of_discriminant(),
            position = view.polynomial.position(root);
    PathBound<T> improved = step_towards_contact(e, view, minimum(position, length), t);
    improved.bound = view.polynomial.bound(position, root, length);
    return improved;
}

} // namespace pw85::detail::simulation

#endif

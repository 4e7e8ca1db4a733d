/// @file
/// The contact function of an ellipsoid and a segment. triangle.hpp uses it for the edges of a triangle. The items are those of
/// nearest_point.hpp.
///
/// The segment is a + t e, 0 <= t <= 1, with e = b - a. Let f = adj(Q) e and m = a × e. Then the nearest point of the line is at
/// t = -a·f/(e·f), μ² = mᵀQm/(e·f), and s = e × Qm/(e·f). (The cross product of Q⁻¹a and Q⁻¹e is Qm/det Q.) These formulas need one
/// division. Their rounding errors in units of u are, to first order:
///
/// - in mᵀQm: 4 Σ|(Qm)_i| (|a_j e_k| + |a_k e_j|) for those of m and e, and 6 Σ|m_i Q_ij m_j|, which is at most 18 Σ m_i² Q_ii;
/// - in e·f: with D_i = Q_jj Q_kk, the error of adj(Q)_ij is at most 4 √(D_i D_j), and 3 + 3 roundings follow. That is at most
///   30 Σ e_i² D_i.
///
/// is_accurate() compares them with S, which is at least Σ s_i² Q_ii + 2 Σ|s_i| min(|a_i|, |b_i|). Where adj(Q) has lost too many
/// digits, the careful formulas solve the equations of item 2 by pivots:
///
/// The axes are numbered such that e_2 is the coordinate with the largest e_i²/Q_ii, and N has the columns (e_2, 0, -e_0) and (0,
/// e_2, -e_1). Then λ_i is s_i/e_2, so that the rounding errors of NᵀQN, times λ, are some u Σ s_i² Q_ii. Nᵀx is the same for all
/// points x of the line. It is computed from the end that is nearer to the centre, and again from the nearest point, which errs by u
/// times the weighted magnitudes of both ends.
#ifndef PW85_SHAPES_SEGMENT_HPP_INCLUDED
#define PW85_SHAPES_SEGMENT_HPP_INCLUDED

#include <pw85/shapes/nearest_point.hpp>

namespace pw85::detail {

/// Which axis comes last: axis 0 or 1, or else axis 2.
template <class T> struct LastAxis {
    using Mask = typename ScalarTraits<T>::Mask;

    Mask is_0, is_1;
};

/// The number for axis i after a cyclic exchange of the axes.
template <class T> PW85_FUNCTION constexpr T turned(LastAxis<T> const &last, Vector<T, 3> const &x, int i) noexcept
{
    return select(last.is_0, x[(i + 1) % 3], select(last.is_1, x[(i + 2) % 3], x[i]));
}

template <class T> PW85_FUNCTION constexpr Vector<T, 3> turned(LastAxis<T> const &last, Vector<T, 3> const &x) noexcept
{
    return {turned(last, x, 0), turned(last, x, 1), turned(last, x, 2)};
}

template <class T>
PW85_FUNCTION constexpr SymmetricMatrix<T, 3> turned(LastAxis<T> const &last, SymmetricMatrix<T, 3> const &q) noexcept
{
    Vector<T, 3> const diagonal = turned(last, Vector<T, 3>{q[0], q[3], q[5]});
    Vector<T, 3> const rest = turned(last, Vector<T, 3>{q[4], q[2], q[1]}); // the entry without that axis
    return {diagonal[0], rest[2], rest[1], diagonal[1], rest[0], diagonal[2]};
}

/// Squares of lengths along the axes divided by those of the bounding box of the ellipsoid, up to a common factor.
template <class T>
PW85_FUNCTION constexpr Vector<T, 3> relative_squares(Vector<T, 3> const &weights, Vector<T, 3> const &x) noexcept
{
    return {weights[0] * T(x[0] * x[0]), weights[1] * T(x[1] * x[1]), weights[2] * T(x[2] * x[2])};
}

template <class T> PW85_FUNCTION constexpr Vector<T, 3> weights_of_axes(SymmetricMatrix<T, 3> const &q) noexcept
{
    return {q[3] * q[5], q[0] * q[5], q[0] * q[3]};
}

template <class T> PW85_FUNCTION constexpr LastAxis<T> longest_axis(Vector<T, 3> const &squares) noexcept
{
    auto const is_2 = squares[2] >= squares[0] && squares[2] >= squares[1];
    auto const is_0 = !is_2 && squares[0] >= squares[1];
    return {is_0, !is_2 && !is_0};
}

/// The equations of item 2 and the solution of their first part.
template <class T> struct LineEquations {
    Vector<T, 3> e;
    Vector<T, 3> last_row; ///< the last row of Q, times N in the first two coordinates
    T m11, m12, reciprocal, reciprocal_of_determinant;
};

template <class T>
PW85_FUNCTION constexpr LineEquations<T> line_equations(Vector<T, 3> const &e, SymmetricMatrix<T, 3> const &q) noexcept
{
    T const across1 = e[2] * q(0, 0) - e[0] * q(0, 2), last1 = e[2] * q(0, 2) - e[0] * q(2, 2);
    T const across12 = e[2] * q(0, 1) - e[0] * q(1, 2);
    T const across2 = e[2] * q(1, 1) - e[1] * q(1, 2), last2 = e[2] * q(1, 2) - e[1] * q(2, 2);
    T const m11 = e[2] * across1 - e[0] * last1, m12 = e[2] * across12 - e[1] * last1;
    T const m22 = e[2] * across2 - e[1] * last2, product = m11 * m22;
    T const determinant = maximum(T(product - m12 * m12), T(T(unit_roundoff<T>()) * product));
    return {e, {last1, last2, T(0)}, m11, m12, T(1) / m11, T(1) / determinant};
}

/// The right-hand side of item 2, reduced: its first number, and what remains of the second, times m11.
template <class T> struct LineValues {
    T first, second;
};

template <class T>
PW85_FUNCTION constexpr LineValues<T> line_values(LineEquations<T> const &m, Vector<T, 3> const &x) noexcept
{
    T const d1 = m.e[2] * x[0] - m.e[0] * x[2], d2 = m.e[2] * x[1] - m.e[1] * x[2];
    return {d1, m.m11 * d2 - m.m12 * d1};
}

template <class T> PW85_FUNCTION constexpr T sum_of(Vector<T, 3> const &x) noexcept { return x[0] + x[1] + x[2]; }

/// The nearest point of a segment by careful formulas. `near` is the end that is nearer to the centre, roughly; `edge` leads from it
/// to `far`.
template <bool with_normal, class T> PW85_FUNCTION constexpr Nearest<T, with_normal>
nearest_from(Vector<T, 3> const &near, Vector<T, 3> const &far, Vector<T, 3> const &weights,
             SymmetricMatrix<T, 3> const &q, Factorization<T, 3> const &factors) noexcept
{
    Vector<T, 3> const edge = far - near;
    auto const axis = longest_axis(relative_squares(weights, edge));
    auto const m = line_equations(turned(axis, edge), turned(axis, q));
    auto const d = line_values(m, turned(axis, near));
    T const lambda2 = d.second * m.reciprocal_of_determinant;
    T const lambda1 = T(d.first - m.m12 * lambda2) * m.reciprocal;
    T const last = m.last_row[0] * lambda1 + m.last_row[1] * lambda2, step = T(1) / m.e[2];
    T const from_near = T(last - turned(axis, near, 2)) * step, from_far = T(last - turned(axis, far, 2)) * step;
    auto const inside = from_near > T(0) && from_far < T(0), is_near = !(from_near > T(0.5));
    Vector<T, 3> const end = choose(is_near, near, far);
    Vector<T, 3> const point = add_scaled(end, T(select(is_near, from_near, from_far)), edge);
    auto const values = line_values(m, turned(axis, point));
    T const rest = T(values.second * values.second) * m.reciprocal_of_determinant;
    T const mu2 = T(values.first * values.first + rest) * m.reciprocal;
    Nearest<T, with_normal> const on_line{mu2, point, Normal<T, 3, with_normal>{solve(factors, point)}, mu2 == mu2};
    return choose(inside, on_line, nearest_on<with_normal>(end, factors));
}

/// How many times u S the rounding errors of the fast formulas may be.
inline constexpr int fast_margin = 64;

/// Whether the fast formulas err by less than `fast_margin` u S.
template <class T> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
is_accurate(Vector<T, 3> const &a, Vector<T, 3> const &b, Vector<T, 3> const &e, T const &ef, Vector<T, 3> const &m,
            Vector<T, 3> const &qm, T const &mqm, Vector<T, 3> const &s, SymmetricMatrix<T, 3> const &q) noexcept
{
    T form = T(0), ends = T(0), terms = T(0), form_of_m = T(0), form_of_e = T(0);
    for (int i = 0; i < 3; ++i) {
        int const j = (i + 1) % 3, k = (i + 2) % 3;
        form = form + T(s[i] * s[i]) * q(i, i);
        ends = ends + absolute(s[i]) * minimum(absolute(a[i]), absolute(b[i]));
        terms = terms + absolute(qm[i]) * T(absolute(T(a[j] * e[k])) + absolute(T(a[k] * e[j])));
        form_of_m = form_of_m + T(m[i] * m[i]) * q(i, i);
        form_of_e = form_of_e + T(e[i] * e[i]) * T(q(j, j) * q(k, k));
    }
    T const error = ef * T(T(4) * terms + T(18) * form_of_m) + T(T(30) * mqm) * form_of_e;
    return error <= T(T(fast_margin) * T(form + T(T(2) * ef) * ends));
}

/// The nearest point of a segment by fast formulas.
template <bool with_normal, class T> [[gnu::always_inline]] PW85_FUNCTION constexpr Nearest<T, with_normal>
nearest_on_segment(Vector<T, 3> const &a, Vector<T, 3> const &b, SymmetricMatrix<T, 3> const &q,
                   SymmetricMatrix<T, 3> const &adjugate, Factorization<T, 3> const &factors) noexcept
{
    Vector<T, 3> const e = b - a, f = product(adjugate, e), m = cross(a, e), qm = product(q, m);
    T const ef = dot(e, f), from_a = -dot(a, f), to_b = dot(b, f), mqm = dot(m, qm), reciprocal = T(1) / ef;
    auto const inside = from_a > T(0) && to_b > T(0), is_near = !(from_a > to_b);
    Vector<T, 3> const end = choose(is_near, a, b);
    T const t = T(select(is_near, from_a, T(-to_b))) * reciprocal;
    Vector<T, 3> const normal = cross(e, qm);
    Nearest<T, with_normal> const on_line{T(mqm * reciprocal), add_scaled(end, t, e), Normal<T, 3, with_normal>{normal},
                                          is_accurate(a, b, e, ef, m, qm, mqm, normal, q)};
    if (all_of(inside)) return on_line;
    return choose(inside, on_line, nearest_on<with_normal>(end, factors));
}

/// The nearest points of segments with ends a and b, for one form.
template <class T, bool with_normal> struct FastSegments {
    SymmetricMatrix<T, 3> q, adjugate;
    Factorization<T, 3> factors;

    PW85_MEMBER constexpr explicit FastSegments(SymmetricMatrix<T, 3> const &form) noexcept
        : q(form), adjugate(detail::adjugate(form)), factors(factorize(form, T(unit_roundoff<T>())))
    {
    }

    PW85_MEMBER constexpr Nearest<T, with_normal> operator()(Vector<T, 3> const &a,
                                                             Vector<T, 3> const &b) const noexcept
    {
        return nearest_on_segment<with_normal>(a, b, q, adjugate, factors);
    }
};

/// The same by careful formulas.
template <class T, bool with_normal> struct CarefulSegments {
    SymmetricMatrix<T, 3> q;
    Vector<T, 3> weights;
    Factorization<T, 3> factors;

    PW85_MEMBER constexpr explicit CarefulSegments(SymmetricMatrix<T, 3> const &form) noexcept
        : q(form), weights(weights_of_axes(form)), factors(factorize(form, T(unit_roundoff<T>())))
    {
    }

    PW85_MEMBER constexpr Nearest<T, with_normal> operator()(Vector<T, 3> const &a,
                                                             Vector<T, 3> const &b) const noexcept
    {
        auto const swap = sum_of(relative_squares(weights, b)) < sum_of(relative_squares(weights, a));
        return nearest_from<with_normal>(choose(swap, b, a), choose(swap, a, b), weights, q, factors);
    }
};

/// The nearest point of a segment in units of order one.
template <template <class, bool> class Segments, bool with_normal = false> struct FindOnSegment {
    template <class T> PW85_MEMBER constexpr Nearest<T, with_normal>
    operator()(Vector<T, 3> const (&ends)[2], SymmetricMatrix<T, 3> const &q) const noexcept
    {
        return Segments<T, with_normal>(q)(ends[0], ends[1]);
    }
};

} // namespace pw85::detail

namespace pw85 {

template <class T> PW85_FUNCTION inline ShapeContact<T> contact_segment(Vector<T, 3> const &a, Vector<T, 3> const &b,
                                                                        SymmetricMatrix<T, 3> const &q) noexcept
{
    Vector<T, 3> const ends[2] = {a, b};
    return detail::contact_of(ends, q, detail::FindOnSegment<detail::FastSegments>{},
                              detail::FindOnSegment<detail::CarefulSegments>{});
}

} // namespace pw85

#endif

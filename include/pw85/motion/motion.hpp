// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Ellipsoids that rotate about their centres and grow.
#ifndef PW85_MOTION_MOTION_HPP_INCLUDED
#define PW85_MOTION_MOTION_HPP_INCLUDED

#include <pw85/algebra/sine_cosine.hpp>
#include <pw85/algebra/two_lanes.hpp>
#include <pw85/algebra/units.hpp>

namespace pw85 {

/// Motion of an ellipsoid: its size is 1 + growth·time times that at time 0. In two dimensions the
/// angular velocity has one coordinate.
template <class T, int D> struct Motion {
    Vector<T, D> velocity;
    Vector<T, detail::rotation_axes<D>> angular_velocity;
    T growth;
};

} // namespace pw85

namespace pw85::detail {

/// ω × x.
template <class T> PW85_FUNCTION constexpr Vector<T, 3> turning(Vector<T, 3> const &omega,
                                                                Vector<T, 3> const &x) noexcept
{
    return cross(omega, x);
}

template <class T> PW85_FUNCTION constexpr Vector<T, 2> turning(Vector<T, 1> const &omega,
                                                                Vector<T, 2> const &x) noexcept
{
    return {-omega[0] * x[1], omega[0] * x[0]};
}

/// The derivative WA - AW of RARᵀ with respect to the angle of a rotation R about an axis, W x =
/// axis × x.
template <class T, int D> PW85_FUNCTION constexpr SymmetricMatrix<T, D>
change_by_turning(Vector<T, rotation_axes<D>> const &axis, SymmetricMatrix<T, D> const &a) noexcept
{
    SymmetricMatrix<T, D> change{};
    for (int i = 0; i < D; ++i) {
        Vector<T, D> row{};
        for (int k = 0; k < D; ++k) row[k] = a(i, k);
        Vector<T, D> const turned = turning(axis, row);
        for (int k = 0; k < D; ++k)
            change(i, k) = change(i, k) + (i == k ? T(turned[k] + turned[k]) : turned[k]);
    }
    return change;
}

/// A form that rotates by θ about a unit vector e: RARᵀ = A + (cos θ - 1) C1 + sin θ S1 + (cos 2θ -
/// 1) C2 + sin 2θ S2. With the part p of Ae across e, C1 = epᵀ + peᵀ and S1 = e(e × p)ᵀ + (e ×
/// p)eᵀ. C2 is the part of A in the plane across e, less its mean, and 2 S2 is its derivative.
template <class T, int D> struct TurningForm {
    SymmetricMatrix<T, D> form, c1, s1, c2, s2;
};

/// xyᵀ + yxᵀ.
template <class T, int D> PW85_FUNCTION constexpr SymmetricMatrix<T, D>
symmetric_product(Vector<T, D> const &x, Vector<T, D> const &y) noexcept
{
    SymmetricMatrix<T, D> result{};
    for (int i = 0; i < D; ++i)
        for (int k = i; k < D; ++k) result(i, k) = x[i] * y[k] + y[i] * x[k];
    return result;
}

template <class T> PW85_FUNCTION constexpr TurningForm<T, 3>
turning_form(Vector<T, 3> const &axis, SymmetricMatrix<T, 3> const &a) noexcept
{
    Vector<T, 3> const y = product(a, axis);
    T const along = dot(axis, y), mean = T(0.5) * (a(0, 0) + a(1, 1) + a(2, 2) - along);
    Vector<T, 3> const across = add_scaled(y, -along, axis);
    auto const c1 = symmetric_product(axis, across);
    auto const in_plane = blend(blend(a, T(-1), c1), T(T(0.5) * (mean - along)),
                                symmetric_product(axis, axis)),
               c2 = plus_multiple_of_identity(in_plane, T(-mean));
    return {a, c1, symmetric_product(axis, cross(axis, across)), c2,
            T(0.5) * change_by_turning(axis, c2)};
}

template <class T> PW85_FUNCTION constexpr TurningForm<T, 2>
turning_form(Vector<T, 1> const &axis, SymmetricMatrix<T, 2> const &a) noexcept
{
    auto const c2 = plus_multiple_of_identity(a, T(T(-0.5) * (a(0, 0) + a(1, 1))));
    return {a, {}, {}, c2, T(0.5) * change_by_turning(axis, c2)};
}

template <class T, int D> PW85_FUNCTION inline SymmetricMatrix<T, D>
turned(TurningForm<T, D> const &x, T const &angle) noexcept
{
    auto const [s, c] = sine_cosine(T(T(0.5) * angle));
    T const sine = T(2) * s * c, less = T(-2) * s * s;
    T const sine2 = T(2) * sine * (T(1) + less), less2 = T(-2) * sine * sine;
    SymmetricMatrix<T, D> a = x.form;
    for (int k = 0; k < a.size; ++k)
        a[k] = a[k] + ((less * x.c1[k] + sine * x.s1[k]) + (less2 * x.c2[k] + sine2 * x.s2[k]));
    return a;
}

/// An ellipsoid that moves. Its form is κI, which rotation does not change, plus a rest. If the
/// scalar is TwoLanes, the struct has two ellipsoids.
template <class T, int D> struct Body {
    SymmetricMatrix<T, D> rest; ///< the form less κI
    T least, most;              ///< bounds on the eigenvalues of the form; the lower one is κ
    Vector<T, rotation_axes<D>> omega;
    T rate, growth; ///< |omega|, and the relative rate of growth
};

/// The body of a form that moves. Eigenvalues differ from their mean, tr Q/D, by at most √((D -
/// 1)/D) |Q - (tr Q/D) I| in the norm of Frobenius; the margin covers the rounding errors of both.
template <class T, int D>
PW85_FUNCTION inline Body<T, D> to_body(SymmetricMatrix<T, D> const &q,
                                        Vector<T, rotation_axes<D>> const &omega,
                                        T const &growth) noexcept
{
    T mean = q(0, 0);
    for (int i = 1; i < D; ++i) mean = mean + q(i, i);
    mean = mean / T(D);
    auto const deviator = plus_multiple_of_identity(q, T(-mean));
    T const spread = square_root(T(T(T(D - 1) / T(D)) * contraction(deviator, deviator))) +
                     T(16 * unit_roundoff<T>()) * mean;
    T const least = maximum(T(0), T(mean - spread));
    return {plus_multiple_of_identity(q, T(-least)),
            least,
            mean + spread,
            omega,
            magnitude(omega),
            growth};
}

/// The body of a form and a motion, in a unit of time.
template <class T, int D> PW85_FUNCTION inline Body<T, D>
to_body(SymmetricMatrix<T, D> const &q, Motion<T, D> const &motion, Unit time) noexcept
{
    return to_body(q, time.to_local(motion.angular_velocity, -1), time.to_local(motion.growth, -1));
}

template <class T, int D>
PW85_FUNCTION constexpr SymmetricMatrix<T, D> form_of(Body<T, D> const &body) noexcept
{
    return plus_multiple_of_identity(body.rest, body.least);
}

/// The parts of a form that rotate with a body. They are not used for a body that does not rotate.
template <class T, int D>
PW85_FUNCTION constexpr TurningForm<T, D> turning_form(Body<T, D> const &body) noexcept
{
    auto const turns = body.rate > T(0);
    if (!any_of(turns)) return {body.rest, {}, {}, {}, {}};
    return turning_form(T(T(1) / select(turns, body.rate, T(1))) * body.omega, body.rest);
}

/// The body after some time.
template <class T, int D> PW85_FUNCTION inline Body<T, D>
body_at(Body<T, D> const &start, TurningForm<T, D> const &form, T const &time) noexcept
{
    T const size = T(1) + start.growth * time, square = size * size;
    return {square * (any_of(start.rate > T(0)) ? turned(form, T(start.rate * time)) : start.rest),
            square * start.least,
            square * start.most,
            start.omega,
            start.rate,
            start.growth / size};
}

} // namespace pw85::detail

#endif

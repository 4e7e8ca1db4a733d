// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The frame in which one ellipsoid is the unit ball and the principal axes of the other one are
/// the coordinate axes. rim_axis.hpp and overlap_volume.hpp use it. A linear map multiplies every
/// volume by its determinant, so the volume of the intersection follows from that in this frame.
#ifndef PW85_VOLUME_JOINT_FRAME_HPP_INCLUDED
#define PW85_VOLUME_JOINT_FRAME_HPP_INCLUDED

#include <pw85/algebra/doubled.hpp>
#include <pw85/algebra/powers_of_two.hpp>
#include <pw85/algebra/units.hpp>

namespace pw85::detail {

/// The exponent of a number with twice the digits, and its product with a power of two.
template <class T> PW85_FUNCTION inline int binary_exponent(Doubled<T> const &x) noexcept
{
    return binary_exponent(x.high);
}

template <class T>
PW85_FUNCTION inline Doubled<T> times_power_of_two(Doubled<T> const &x, int exponent) noexcept
{
    return {times_power_of_two(x.high, exponent), times_power_of_two(x.low, exponent)};
}

/// The type of the results. Integrals are sums of positive terms, so they need only these digits,
/// also if the vertices are computed in a wider type.
template <class T> using ResultOf = decltype(rounded(T()));

/// A square matrix by its columns.
template <class T, int D> struct MatrixColumns {
    Vector<T, D> vectors[std::size_t(D)];

    PW85_MEMBER constexpr Vector<T, D> &operator[](int j) noexcept { return vectors[j]; }
    PW85_MEMBER constexpr Vector<T, D> const &operator[](int j) const noexcept
    {
        return vectors[j];
    }
};

/// A pair in its joint frame. The ellipsoid with the smaller volume is the unit ball about 0.
template <class T, int D> struct JointFrame {
    Vector<T, D> axes; ///< semi-axes of the other ellipsoid, the longest first
    /// S⁻¹c: the centre c of the other ellipsoid, each coordinate over its semi-axis
    Vector<T, D> center;
    MatrixColumns<T, D>
        lower; ///< the ball is taken to space by lower·turn, in the unit of the frame
    MatrixColumns<T, D> turn; ///< the principal directions of the other ellipsoid
    T determinant;            ///< of `lower`
    Unit unit;                ///< of the frame
    /// true if the ball is ellipsoid 2; then the frame is that of the pair (-r12, Q2, Q1)
    typename ScalarTraits<T>::Mask swapped;
    T displacement; ///< of the surfaces by rounded forms: displacement_of()
};

/// The largest coordinate of the centre of the other ellipsoid.
template <class T, int D>
PW85_FUNCTION inline T distance_of_centers(JointFrame<T, D> const &frame) noexcept
{
    T distance = T(0);
    for (int i = 0; i < D; ++i)
        distance = maximum(distance, absolute(T(frame.axes[i] * frame.center[i])));
    return distance;
}

/// The Cholesky factor.
template <class T, int D>
PW85_FUNCTION inline MatrixColumns<T, D> cholesky_columns(SymmetricMatrix<T, D> const &q) noexcept
{
    auto const f = factorize(q, T(unit_roundoff<T>()));
    MatrixColumns<T, D> l{};
    for (int j = 0; j < D; ++j) {
        T const root = square_root(f.pivots[j]);
        for (int i = 0; i < D; ++i)
            l[j][i] = i < j ? T(0) : i == j ? root : T(f.lower[i][j] * root);
    }
    return l;
}

/// L⁻¹x for a lower triangular L.
template <class T, int D>
PW85_FUNCTION inline Vector<T, D> solve_lower(MatrixColumns<T, D> const &l, Vector<T, D> x) noexcept
{
    for (int j = 0; j < D; ++j) {
        x[j] = x[j] / l[j][j];
        for (int i = j + 1; i < D; ++i) x[i] = x[i] - l[j][i] * x[j];
    }
    return x;
}

/// Stores vectors in the lanes of a mask.
template <class Mask, class T, int D> PW85_FUNCTION inline void
store_where(Mask const &mask, Vector<T, D> const &from, Vector<T, D> &to) noexcept
{
    for (int i = 0; i < D; ++i) to[i] = select(mask, from[i], to[i]);
}

/// Rotates two columns so that they become orthogonal (a Jacobi rotation), with the longer one
/// first, in the lanes of a mask. Returns the lanes in which they were not orthogonal. The error of
/// the dot product of two columns is at most 3u times the product of their lengths, so a dot
/// product below 4u times this product counts as zero. The columns belong to a valid pair, each
/// form in its own unit, so fourth powers of their lengths neither overflow nor underflow.
template <class Mask, class T, int D> PW85_FUNCTION inline Mask
make_orthogonal(Mask const &active, Vector<T, D> &x, Vector<T, D> &y) noexcept
{
    T const xx = dot(x, x), yy = dot(y, y), xy = dot(x, y), u = T(unit_roundoff<T>());
    auto const is_shorter = both_true(active, Mask(xx < yy));
    if (any_of(is_shorter)) { // the rotation by less than π/4 leaves the longer one in its place
        Vector<T, D> const old = x;
        store_where(is_shorter, y, x);
        store_where(is_shorter, old, y);
    }
    auto const moves = both_true(active, Mask(T(xy * xy) > T(T(T(16) * T(u * u)) * T(xx * yy))));
    if (!any_of(moves)) return moves;
    T const difference = absolute(T(xx - yy)), twice = T(xy + xy);
    T const tangent =
        twice / T(difference + square_root(T(difference * difference + twice * twice)));
    T const cosine = T(1) / square_root(T(T(1) + tangent * tangent)), sine = T(cosine * tangent);
    Vector<T, D> const old = x;
    store_where(moves, cosine * x + sine * y, x);
    store_where(moves, cosine * y - sine * old, y);
    return moves;
}

/// Makes the columns of G orthogonal by Jacobi's method from the right (Hestenes), the longest
/// first. So G = U diag(axes) Vᵀ becomes U diag(axes). The relative errors of the axes are those
/// for columns that are scaled to length one, so they do not grow with the aspect ratio.
template <class T, int D> PW85_FUNCTION inline void make_orthogonal(MatrixColumns<T, D> &g) noexcept
{
    constexpr int most_sweeps = 30; // four or five are usual; the limit is for NaN
    auto active = g[0][0] == g[0][0];
    for (int sweep = 0; any_of(active) && sweep < most_sweeps; ++sweep) {
        auto moved = !(g[0][0] == g[0][0]);
        for (int i = 0; i < D; ++i)
            for (int j = i + 1; j < D; ++j) moved = make_orthogonal(active, g[i], g[j]) || moved;
        active = moved;
    }
}

/// Axes that are longer than this limit, in units of the ball, are set to it. In the ball, x/axis -
/// center changes by less than the inverse of the limit, far below the rounding errors of the
/// centre.
template <class T> PW85_FUNCTION constexpr T longest_axis() noexcept
{
    constexpr int exponent = std::numeric_limits<typename ScalarTraits<T>::Lane>::max_exponent / 8;
    return T(1) / negative_power_of_two<T>(exponent < 128 ? exponent : 128);
}

/// The product of the pivots of the Cholesky factor: the volume in units of that of the unit ball.
template <class T, int D>
PW85_FUNCTION inline T determinant_of_lower(MatrixColumns<T, D> const &l) noexcept
{
    T product = l[0][0];
    for (int i = 1; i < D; ++i) product = product * l[i][i];
    return product;
}

/// κ = Σ q_ii (Q⁻¹)_ii, from the form and the determinant of its Cholesky factor.
template <class T> PW85_FUNCTION inline T scaled_condition(SymmetricMatrix<T, 3> const &q,
                                                           T const &determinant_of_factor) noexcept
{
    T const xy = T(q(0, 0) * q(1, 1)), xz = T(q(0, 0) * q(2, 2)), yz = T(q(1, 1) * q(2, 2));
    T const minors = q(2, 2) * T(xy - T(q(0, 1) * q(0, 1))) +
                     q(1, 1) * T(xz - T(q(0, 2) * q(0, 2))) +
                     q(0, 0) * T(yz - T(q(1, 2) * q(1, 2)));
    return T(minors / T(determinant_of_factor * determinant_of_factor));
}

template <class T> PW85_FUNCTION inline T scaled_condition(SymmetricMatrix<T, 2> const &q,
                                                           T const &determinant_of_factor) noexcept
{
    return T(T(T(2) * T(q(0, 0) * q(1, 1))) / T(determinant_of_factor * determinant_of_factor));
}

/// An ellipsoid as the Cholesky factor of its form, in its own unit.
template <class T, int D> struct LowerFactor {
    MatrixColumns<T, D> columns;
    T determinant, condition; ///< of the factor, and κ of the form
    Unit unit;
};

template <class T, int D>
PW85_FUNCTION inline LowerFactor<T, D> lower_factor(SymmetricMatrix<T, D> const &q) noexcept
{
    Unit const unit = unit_of(q);
    auto const scaled = unit.to_local(q);
    auto const l = cholesky_columns(scaled);
    T const determinant = determinant_of_lower(l);
    return {l, determinant, scaled_condition(scaled, determinant), unit};
}

/// Tests whether the first of two ellipsoids has the larger volume. Determinants must be in
/// (2^-130, 8).
template <class T, int D> PW85_FUNCTION inline bool
has_larger_volume(LowerFactor<T, D> const &a, LowerFactor<T, D> const &b) noexcept
{
    int const difference = D * (a.unit / b.unit).exponent, limit = 512;
    if (difference > limit || difference < -limit) return difference > 0;
    T const power = negative_power_of_two<T>(difference < 0 ? -difference : difference);
    return difference >= 0 ? a.determinant > T(b.determinant * power)
                           : T(a.determinant * power) > b.determinant;
}

/// A bound on the displacement of the surfaces by rounding errors of the forms, in units of 7Du/2
/// times the radius of the ball.
///
/// The factors are those of forms whose entries differ by up to 7u √(q_ii q_jj). The square of the
/// support nᵀQn then changes by 7u (Σ √q_ii |n_i|)² <= 7Du Σ q_ii n_i² <= 7Du κ nᵀQn. Where the
/// surfaces intersect, the support of the other body is at most the distance of its centre plus the
/// radius of the ball.
template <class T, int D> PW85_FUNCTION inline T
displacement_of(JointFrame<T, D> const &frame, T const &of_ball, T const &of_other) noexcept
{
    return T(of_ball + of_other * T(T(1) + distance_of_centers(frame)));
}

/// Sets the axes, the centre and the principal directions of a frame from the columns of G and r,
/// in their units.
template <class T, int D> PW85_FUNCTION inline void
set_principal_axes(JointFrame<T, D> &frame, MatrixColumns<T, D> &g, Vector<T, D> const &r) noexcept
{
    make_orthogonal(g);
    for (int j = 0; j < D; ++j) {
        frame.axes[j] = magnitude(g[j]);
        frame.turn[j] = g[j] / frame.axes[j];
        frame.center[j] = dot(frame.turn[j], r) / frame.axes[j];
    }
}

/// The joint frame of a valid pair.
template <class T, int D>
PW85_FUNCTION inline JointFrame<T, D> joint_frame(Vector<T, D> const &r12,
                                                  SymmetricMatrix<T, D> const &q1,
                                                  SymmetricMatrix<T, D> const &q2) noexcept
{
    auto const f1 = lower_factor(q1), f2 = lower_factor(q2);
    bool const swapped = has_larger_volume(f1, f2);
    auto const &ball = swapped ? f2 : f1, &other = swapped ? f1 : f2;
    Unit const length = unit_of(r12);
    Vector<T, D> const r = solve_lower(ball.columns, length.to_local(swapped ? -r12 : r12));
    MatrixColumns<T, D> g{};
    for (int j = 0; j < D; ++j) g[j] = solve_lower(ball.columns, other.columns[j]);

    JointFrame<T, D> frame{{}, {}, ball.columns, {}, ball.determinant, ball.unit, swapped, T(0)};
    set_principal_axes(frame, g, r);
    for (int j = 0; j < D; ++j) {
        frame.center[j] = (length / other.unit).to_caller(frame.center[j]);
        frame.axes[j] =
            minimum((other.unit / ball.unit).to_caller(frame.axes[j]), longest_axis<T>());
    }
    frame.displacement = displacement_of(frame, ball.condition, other.condition);
    return frame;
}

template <class T, int D> PW85_FUNCTION inline auto rounded(MatrixColumns<T, D> const &x) noexcept
{
    MatrixColumns<decltype(rounded(x[0][0])), D> y{};
    for (int j = 0; j < D; ++j) y[j] = rounded(x[j]);
    return y;
}

/// The frame, rounded to the type with fewer digits.
template <class T, int D> PW85_FUNCTION inline auto rounded(JointFrame<T, D> const &x) noexcept
{
    return JointFrame<decltype(rounded(x.determinant)), D>{
        rounded(x.axes), rounded(x.center),      rounded(x.lower),
        rounded(x.turn), rounded(x.determinant), x.unit,
        x.swapped,       rounded(x.displacement)};
}

/// The frame, converted to numbers with twice the digits.
template <class T, int D>
PW85_FUNCTION inline JointFrame<Finer<T>, D> widened(JointFrame<T, D> const &frame) noexcept
{
    JointFrame<Finer<T>, D> wide{};
    for (int i = 0; i < D; ++i) {
        wide.axes[i] = Finer<T>(frame.axes[i]);
        wide.center[i] = Finer<T>(frame.center[i]);
    }
    return wide;
}

} // namespace pw85::detail

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The axis of the rim: a line about which the rim of the intersection, where both surfaces
/// intersect, is a curve of one or two points per half-plane. rim_frame.hpp calls rim_axis(), and
/// pencil_roots.hpp finds the roots of h.
///
/// The pair is in its joint frame (joint_frame.hpp). With homogeneous coordinates X = (x, x0), the
/// unit ball is B(X, X) <= 0 with B = diag(1, ..., 1, -1), and the other ellipsoid is A(X, X) <= 0
/// with A = [P, -b; -bᵀ, γ]. The members A - tB of the pencil that are singular are at the roots of
/// h(t) = t + γ - Σ b_i²/(p_i - t), with vertices x = (P - t)⁻¹b. With the weights w_i = b_i²/p_i
/// and the shortest axis s, γ is Σ w_i - s and h(t) = t - s - t Σ w_i/(p_i - t). Two of these
/// vertices determine the axis (RimAxis).
#ifndef PW85_VOLUME_RIM_AXIS_HPP_INCLUDED
#define PW85_VOLUME_RIM_AXIS_HPP_INCLUDED

#include <pw85/volume/joint_frame.hpp>
#include <pw85/volume/pencil_roots.hpp>

namespace pw85::detail {

/// The axis o + z ℓ, with |ℓ| = 1 and o ⟂ ℓ, and the vertices (a_i, height_i) conjugate to it, for
/// which B is the identity.
///
/// Let w1, w2 be the vertices of the roots that are nearest to the middle pole of h, on its two
/// sides. Both are outside of the ball, and A(w1, w2) = B(w1, w2) = 0. The points that are
/// conjugate to both are a line through the ball: the axis. It meets the sphere at n1 and n2, and
/// A(w, n) = B(w, n) = 0 for each w of w1, w2 and n of n1, n2. So a projective map takes the pair
/// to a ball and an ellipsoid that are symmetric about two planes through their common axis. A
/// point of the rim is X = p n1 + q n2 + cos ψ w1 + sin ψ w2, for which B(X, X) = 0 gives p q, and
/// A(X, X) = 0 a quadratic equation in p².
template <class T> struct RimAxis {
    Vector<T, 3> origin, direction;
    Vector<T, 3> vertices[2];
    T heights[2];
    T roots[2];          ///< t of each vertex: A(w_i, w_i), in units of the pencil
    T half_chord;        ///< half of the length of the axis inside the ball
    bool touches_at_end; ///< true if a vertex was moved (give_pole_to_touching_vertex())
};

/// The pencil in the coordinates of the joint frame, A times the shortest axis, and the poles in
/// increasing order.
template <class T> struct Pencil {
    Vector<T, 3> poles, b, weights; ///< p_i, b_i and w_i
    T shortest;                     ///< s
};

template <class T> PW85_FUNCTION inline Pencil<T> pencil(JointFrame<T, 3> const &frame) noexcept
{
    T const shortest = frame.axes[2];
    Pencil<T> pencil{{}, {}, {}, shortest};
    T const least = T(1) / longest_axis<T>();
    for (int i = 0; i < 3; ++i) {
        T const ratio = shortest / frame.axes[i];
        pencil.poles[i] = ratio / frame.axes[i];
        T const b = T(ratio * frame.center[i]);
        auto const is_zero = absolute(b) < least;
        pencil.b[i] = select(is_zero, T(0), b);
        pencil.weights[i] =
            select(is_zero, T(0), T(shortest * T(frame.center[i] * frame.center[i])));
    }
    return pencil;
}

/// The vertex of the root, as a homogeneous vector whose last coordinate is the height. `lower` and
/// `upper` are the axes of the two poles, `third` is the other axis, whose pole is at distance
/// `far_gap` beyond the upper or the lower pole.
template <class T> struct Vertex {
    Vector<T, 3> x;
    T height, root;
};

/// B(v, w).
template <class T> PW85_FUNCTION inline T lorentz(Vertex<T> const &v, Vertex<T> const &w) noexcept
{
    return dot(v.x, w.x) - v.height * w.height;
}

/// v/√B(v, v). v is first divided by its largest coordinate.
template <class T> PW85_FUNCTION inline Vertex<T> normalized(Vertex<T> v) noexcept
{
    T const size = T(1) / maximum(largest_coordinate(v.x), absolute(v.height));
    v = {size * v.x, size * v.height, v.root};
    T const floor = T(T(unit_roundoff<T>()) * T(unit_roundoff<T>()));
    T const scale = T(1) / square_root(maximum(lorentz(v, v), floor));
    return {scale * v.x, scale * v.height, v.root};
}

/// The indices of the axes of the two poles that bound an interval, and of the third pole. `sign`
/// is the sign of p_upper - p_lower.
template <class T> struct PoleAxes {
    int lower, upper, beyond;
    T sign;
};

/// The interval between two poles. If sign = -1, t is replaced by -t, so the "upper" pole is then
/// the smaller one.
template <class T> PW85_FUNCTION inline PoleInterval<T>
pole_interval(Pencil<T> const &p, PoleAxes<T> const &axes) noexcept
{
    auto const [lower, upper, beyond, sign] = axes;
    return {T(sign * T(p.poles[upper] - p.poles[lower])),
            T(sign * T(p.poles[beyond] - p.poles[upper])),
            T(p.b[lower] * p.b[lower]),
            T(p.b[upper] * p.b[upper]),
            T(p.b[beyond] * p.b[beyond]),
            {p.weights[lower], p.weights[upper], p.weights[beyond]},
            p.poles[lower],
            p.poles[upper],
            p.shortest,
            sign};
}

/// The vertex of a root between poles.
template <class T> PW85_FUNCTION inline Vertex<T>
inner_vertex(Pencil<T> const &p, PoleAxes<T> const &axes, PoleRoot<T> const &root) noexcept
{
    auto const [lower, upper, beyond, sign] = axes;
    T const t = select(root.delta <= root.epsilon, T(p.poles[upper] - sign * root.delta),
                       T(p.poles[lower] + sign * root.epsilon));
    Vertex<T> v{{}, T(1), t};
    // p_i - t, times sign: -ε, δ and far_gap + δ.
    v.x[lower] = -(T(sign * p.b[lower]) / root.epsilon);
    if (any_of(root.delta > T(0))) v.x[upper] = T(sign * p.b[upper]) / root.delta;
    T const far_gap = T(sign * T(p.poles[beyond] - p.poles[upper]));
    if (any_of(!(p.b[beyond] == T(0))))
        v.x[beyond] = T(sign * p.b[beyond]) / T(far_gap + root.delta);
    return normalized(v);
}

/// The vertex of a root.
template <class T> PW85_FUNCTION inline Vertex<T>
vertex_of(Pencil<T> const &p, PoleAxes<T> const &axes, PoleRoot<T> const &root) noexcept
{
    using Place = typename PoleRoot<T>::Place;
    if (root.place == Place::between) return inner_vertex(p, axes, root);
    int const pole = root.place == Place::upper ? axes.upper : axes.lower;
    Vertex<T> v{{}, T(0), p.poles[pole]};
    v.x[pole] = T(1);
    return v;
}

/// The vertex at the root that is nearest to the upper pole of an interval.
template <class T> PW85_FUNCTION inline Vertex<T>
vertex_between(Pencil<T> const &p, PoleAxes<T> const &axes, bool upper_counts) noexcept
{
    return vertex_of(p, axes, highest_root(pole_interval(p, axes), upper_counts));
}

/// The height of a vertex beyond which the ellipsoids count as touching there.
template <class T> PW85_FUNCTION constexpr T highest_vertex() noexcept
{
    return T(1) / negative_power_of_two<T>(mantissa_digits<T>() / 5);
}

/// Where the ellipsoids touch from inside, two roots of the pencil coincide, and their vertex is
/// the point that they touch at. If these two roots are the roots nearest to the middle pole in
/// their interval, the third root of the interval replaces them. Its vertex is also outside the
/// ball. The axis then passes through the point of tangency, because this point is conjugate to
/// both vertices.
///
/// Let H be the height of the vertex, and Δ the distance between its root and the next one. B(v, v)
/// is 1 for the normalized vertex, and h' is near 1/H². So Δ is near 1/H², and the relative
/// distance of α or γ from zero is near 1/H⁴, which is below common_end().
template <class T> PW85_FUNCTION inline void
replace_touching_vertex(Pencil<T> const &p, PoleAxes<T> const &axes, Vertex<T> &v) noexcept
{
    if (!(absolute(v.height) > highest_vertex<T>())) return;
    PoleRoot<T> root{};
    if (!find_lowest_root(pole_interval(p, axes), root)) return;
    auto const other = vertex_of(p, axes, root);
    if (absolute(other.height) < absolute(v.height)) v = other;
}

/// The height of a vertex beyond which the vertex at the middle pole may take its place.
///
/// As for highest_vertex(), α or γ is η = 1/H⁴ = 2^-44 times its usual size if the vertex is at the
/// point of tangency. An end of the axis within η counts as common to both bodies. Near that
/// point the distance of the surfaces is z² - y⁴ + η, to leading order. The rims that are wrong
/// there have y up to η^(1/4) and z up to η^(1/2). The volume changes by η^(7/4), which is below u,
/// and the derivatives by η^(3/4). This is of the order of the bound of the derivatives, because
/// second derivatives are near η^(-1/4).
inline constexpr double highest_vertex_beside_pole = 2048.0;

/// The largest b of the middle pole that can result from rounding of the forms and of r12 alone.
///
/// Let the bodies touch at an end of the axis a², with equal curvatures in the direction of the
/// middle axis a, so that the centre is at a² - 1. The entries of Q1, Q2 and r are rounded by u,
/// and a form by √3 u κ in the metric of the ball, κ the condition number of Q1. To first order the
/// centre moves across by at most u κ times
///
///     (a² - 1) + √3 (a² - 1)/2 + √3 (a² - 1) (a⁴ + (a⁴ + a²)/2)/(a⁴ - a²) = (1 + 2√3) a² - 1,
///
/// where the last term comes from the rotation of the axes. b is this times the pole, s/a² with the
/// shortest axis s: up to 4.5 u κ s, or 8 u s for κ up to 1.8. With a < 1 the pole exceeds s, and 8
/// u times the pole moves the centre by 8 u. The term 2 b y is below η everywhere.
template <class T> PW85_FUNCTION inline T rounding_of_middle_b(Pencil<T> const &p) noexcept
{
    T const shortest = T(T(1) / p.poles[2]);
    return T(T(T(8) * negative_power_of_two<T>(result_digits<T>())) *
             maximum(p.poles[1], shortest));
}

/// Where the ellipsoids touch from inside with equal curvatures in the direction of the middle
/// axis, the middle pole is a third root next to the two that coincide, within a few 1/H². Its term
/// is zero, or so small that it moves the centre by no more than rounding. The vertex of this pole
/// then replaces a vertex at the point of tangency. Rounding decides to which interval the pole
/// counts; this does not matter: the vertices are those of the limit of equal roots, and the axis
/// passes through the point of tangency.
template <class T>
PW85_FUNCTION inline bool give_pole_to_touching_vertex(Pencil<T> p, PoleAxes<T> const (&axes)[2],
                                                       bool counts, Vertex<T> (&v)[2]) noexcept
{
    auto const height = [](Vertex<T> const(&x)[2]) {
        return maximum(absolute(x[0].height), absolute(x[1].height));
    };
    T const limit = T(highest_vertex_beside_pole);
    int const touching = absolute(v[0].height) > absolute(v[1].height) ? 0 : 1;
    T const pole = p.poles[1], distance = absolute(T(v[touching].root - pole));
    bool const is_at_pole = T(distance * T(limit * limit)) <= T(T(4) * pole) &&
                            absolute(p.b[1]) <= rounding_of_middle_b(p);
    if (!(height(v) > limit) || !is_at_pole) return false;
    p.b[1] = p.weights[1] = T(0);
    for (int k = 0; k < 2; ++k) {
        bool const first_counts = (k == 0) == counts;
        Vertex<T> const other[2] = {vertex_between(p, axes[0], first_counts),
                                    vertex_between(p, axes[1], !first_counts)};
        if (height(other) > limit) continue;
        v[0] = other[0];
        v[1] = other[1];
        return true;
    }
    return false;
}

/// Rotates the coordinates of two axes with the same pole so that b of the first is zero. Returns
/// the rotation.
template <class T> struct PlaneRotation {
    T cosine, sine;
};

template <class T>
PW85_FUNCTION inline PlaneRotation<T> make_zero(Pencil<T> &p, int zero, int other) noexcept
{
    T const length = square_root(T(p.b[zero] * p.b[zero] + p.b[other] * p.b[other]));
    if (!(length > T(0))) return {T(1), T(0)};
    PlaneRotation<T> const turn{p.b[other] / length, p.b[zero] / length};
    p.b[zero] = T(0);
    p.b[other] = length;
    p.weights[other] = p.weights[other] + p.weights[zero];
    p.weights[zero] = T(0);
    return turn;
}

/// Applies the inverse rotation to a vector.
template <class T> PW85_FUNCTION inline void turn_back(Vector<T, 3> &x, int zero, int other,
                                                       PlaneRotation<T> const &turn) noexcept
{
    T const a = x[zero], b = x[other];
    x[zero] = turn.cosine * a + turn.sine * b;
    x[other] = turn.cosine * b - turn.sine * a;
}

/// Makes two vertices orthogonal with respect to B.
template <class T> PW85_FUNCTION inline void make_orthogonal(Vertex<T> (&v)[2]) noexcept
{
    T const along = lorentz(v[0], v[1]);
    v[1] = normalized(
        Vertex<T>{v[1].x - along * v[0].x, T(v[1].height - along * v[0].height), v[1].root});
}

/// The axis of two vertices that are orthogonal with respect to B. a_i·x = height_i are the planes
/// that contain it, and a_i·a_j = δ_ij + height_i height_j. So its point nearest to the centre of
/// the ball is Σ height_i a_i/(1 + Σ height_i²).
template <class T>
PW85_FUNCTION inline RimAxis<T> axis_of_vertices(Vertex<T> const (&v)[2]) noexcept
{
    RimAxis<T> axis{};
    T sum = T(1);
    for (int i = 0; i < 2; ++i) {
        axis.vertices[i] = v[i].x;
        axis.heights[i] = v[i].height;
        axis.roots[i] = v[i].root;
        sum = sum + v[i].height * v[i].height;
    }
    for (Vertex<T> const &vertex : v) axis.origin = axis.origin + T(vertex.height / sum) * vertex.x;
    Vector<T, 3> const normal = cross(v[0].x, v[1].x);
    axis.direction = normal / magnitude(normal);
    axis.half_chord = T(1) / square_root(sum);
    return axis;
}

/// The axis of the rim, by the vertices w1 and w2 of RimAxis, made orthogonal with respect to B.
template <class T> PW85_FUNCTION inline RimAxis<T> rim_axis(JointFrame<T, 3> const &frame) noexcept
{
    auto p = pencil(frame);
    bool const first = p.poles[0] == p.poles[1], second = p.poles[1] == p.poles[2];
    PlaneRotation<T> turn1{T(1), T(0)}, turn2{T(1), T(0)};
    if (first) turn1 = make_zero(p, 0, 1);
    if (second) turn2 = make_zero(p, 2, 1);
    PoleAxes<T> const axes[2] = {{0, 1, 2, T(1)}, {2, 1, 0, T(-1)}};
    auto const [roots, counts] =
        middle_roots<T>({pole_interval(p, axes[0]), pole_interval(p, axes[1])});
    Vertex<T> v[2] = {vertex_of(p, axes[0], roots[0]), vertex_of(p, axes[1], roots[1])};
    bool touches_at_end = false;
    if constexpr (!std::is_floating_point_v<T>) { // other rims are computed by more digits
        if (!first) replace_touching_vertex(p, axes[0], v[0]);
        if (!second) replace_touching_vertex(p, axes[1], v[1]);
        if (!first && !second) touches_at_end = give_pole_to_touching_vertex(p, axes, counts, v);
    }
    make_orthogonal(v);
    for (int i = 0; i < 2; ++i) {
        if (second) turn_back(v[i].x, 2, 1, turn2);
        if (first) turn_back(v[i].x, 0, 1, turn1);
    }
    auto axis = axis_of_vertices(v);
    axis.touches_at_end = touches_at_end;
    return axis;
}

} // namespace pw85::detail

#endif

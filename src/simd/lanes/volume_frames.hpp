// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The joint frames and the rims of pairs for volumes.hpp, one pair per lane, by the formulas of
/// the function for one pair (volume/joint_frame.hpp, volume/rim_frame.hpp), and the lanes for
/// which they hold.
#ifndef PW85_SIMD_LANES_VOLUME_FRAMES_HPP_INCLUDED
#define PW85_SIMD_LANES_VOLUME_FRAMES_HPP_INCLUDED

#include <pw85/volume/overlap_volume.hpp>

#include "gather.hpp"

namespace pw85::detail {
namespace {

/// The shape of a joint frame, and the lanes for which the formulas of a pack hold.
struct LaneFrame {
    Vector<Pack, 3> axes, center;
    Pack determinant;
    PackMask clear;

    PW85_INLINE JointFrame<Pack, 3> frame() const noexcept
    {
        JointFrame<Pack, 3> frame{};
        frame.axes = axes;
        frame.center = center;
        return frame;
    }
};

/// The rim of pairs in a frame.
struct LaneRim {
    RimIntegration<Pack> integration;
    EllipticRule<Pack> rule;
};

/// The joint frame of pairs in range: no power of two changes a digit there.
PW85_INLINE JointFrame<Pack, 3> joint_frame_of(LanePair<3> const &pair) noexcept
{
    auto const l1 = cholesky_columns(pair.q1), l2 = cholesky_columns(pair.q2);
    Pack const det1 = determinant_of_lower(l1), det2 = determinant_of_lower(l2);
    PackMask const swapped = det1 > det2;
    JointFrame<Pack, 3> frame{};
    frame.swapped = swapped;
    frame.determinant = select(swapped, det2, det1);
    MatrixColumns<Pack, 3> other;
    SymmetricMatrix<Pack, 3> of_ball, of_other;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) {
            frame.lower[j][i] = select(swapped, l2[j][i], l1[j][i]);
            other[j][i] = select(swapped, l1[j][i], l2[j][i]);
        }
    for (int k = 0; k < 6; ++k) {
        of_ball[k] = select(swapped, pair.q2[k], pair.q1[k]);
        of_other[k] = select(swapped, pair.q1[k], pair.q2[k]);
    }
    Vector<Pack, 3> r;
    for (int i = 0; i < 3; ++i) r[i] = select(swapped, -pair.r12[i], pair.r12[i]);
    MatrixColumns<Pack, 3> g;
    for (int j = 0; j < 3; ++j) g[j] = solve_lower(frame.lower, other[j]);
    set_principal_axes(frame, g, solve_lower(frame.lower, r));
    frame.displacement = displacement_of(frame, scaled_condition(of_ball, frame.determinant),
                                         scaled_condition(of_other, select(swapped, det1, det2)));
    return frame;
}

/// highest_root() between two poles whose terms are not zero. Lanes without one become NaN.
PW85_INLINE PoleRoot<Pack> highest_root_between(PoleInterval<Pack> const &f) noexcept
{
    Pack const least = Pack(unit_roundoff<Pack>()) * Pack(Pack(0.5) * f.gap);
    Pack delta = start_of_descent(f);
    delta = select(delta == Pack(0.0), least, delta);
    PackMask const descended = descend(f.gap > Pack(0.0), f, delta);
    auto root = root_after_descent(f, delta);
    if (all_of(descended)) return root;
    Pack epsilon = start_of_ascent(f);
    epsilon = select(epsilon > Pack(0.0), epsilon, quiet_nan<Pack>());
    ascend(!descended, f, epsilon);
    root.epsilon = select(descended, root.epsilon, epsilon);
    root.delta = select(descended, root.delta, Pack(f.gap - epsilon));
    return root;
}

/// The axis of the rim, by rim_axis() for three different poles.
PW85_INLINE RimAxis<Pack> rim_axis_of(Pencil<Pack> const &p) noexcept
{
    PoleAxes<Pack> const axes[2] = {{0, 1, 2, Pack(1.0)}, {2, 1, 0, Pack(-1.0)}};
    Vertex<Pack> v[2];
    for (int k = 0; k < 2; ++k)
        v[k] = inner_vertex(p, axes[k], highest_root_between(pole_interval(p, axes[k])));
    make_orthogonal(v);
    return axis_of_vertices(v);
}

/// Tests if all coordinates are zero, or none of their products underflows.
template <class... Numbers> PW85_INLINE PackMask are_clear_of_zero(Numbers const &...x) noexcept
{
    return ((x == Pack(0.0) || absolute(x) > negative_power_of_two<Pack>(200)) && ...);
}

PW85_INLINE PackMask is_in_range_of_lanes(LanePair<3> const &pair) noexcept
{
    auto const &[r, q1, q2, ratio] = pair;
    auto const has_axes = [](SymmetricMatrix<Pack, 3> const &q) {
        return minimum(q[0], minimum(q[3], q[5])) > negative_power_of_two<Pack>(60);
    };
    return has_axes(q1) && has_axes(q2) &&
           are_clear_of_zero(r[0], r[1], r[2], q1[1], q1[2], q1[4], q2[1], q2[2], q2[4]);
}

/// Computes the frame of pairs. This function and the next one are not inlined: their numbers are
/// on the stack only before those of the sum are.
[[gnu::noinline, gnu::flatten]] inline void find_frame(LanePair<3> const &pair,
                                                       LaneFrame &lane) noexcept
{
    auto const frame = joint_frame_of(pair);
    lane.axes = frame.axes;
    lane.center = frame.center;
    lane.determinant = frame.determinant;
    lane.clear = is_in_range_of_lanes(pair) && exceed_each_other(pair.r12, pair.q1, pair.q2) &&
                 frame.displacement <= largest_displacement<Pack, 3>() &&
                 frame.axes[2] >= thinnest_axis<Pack>() && frame.axes[0] < longest_axis<Pack>();
}

/// Computes the rim of pairs, without the sum along it.
[[gnu::noinline, gnu::flatten]] inline void find_rim(LaneFrame &lane, LaneRim &out) noexcept
{
    auto const frame = lane.frame();
    auto const p = pencil(frame);
    PackMask clear = lane.clear && p.poles[0] < p.poles[1] && p.poles[1] < p.poles[2];
    for (int i = 0; i < 3; ++i) clear = clear && !(p.b[i] == Pack(0.0));
    auto const axis = rim_axis_of(p);
    auto &rim = out.integration.rim;
    rim = rim_frame(frame, axis);
    for (int k = 0; k < 2; ++k) out.integration.rules[k] = area_rule(rim.ends, k);
    out.rule = elliptic_rule(rim);
    auto const form = quartic_form(rim);
    Pack const stretch2 = square_root(square_root(Pack(form.a / form.c)));
    lane.clear = clear && is_rim_accurate(frame, axis.half_chord) && is_rim_apart_from_ends(rim) &&
                 !has_common_end(rim.bodies[1]) && !out.integration.is_of_one_body() &&
                 !(rim.least > Pack(0.0)) && are_integrals_accurate(frame, out.integration) &&
                 !may_miss_half_planes(rim, form, stretch2) &&
                 out.rule.own_steps < Pack(double(out.rule.most_steps));
}

} // namespace
} // namespace pw85::detail

#endif

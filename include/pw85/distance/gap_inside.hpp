// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The least gap between an ellipsoid and one that contains it. pw85.hpp and the C
/// API use this file.
///
/// contains() decides exactly whether ellipsoid 2 is inside. A search over directions finds local
/// minima (gap_search.hpp), and a division of the sphere proves that no direction has a smaller gap
/// (gap_proof.hpp). A gap below rounding needs no proof, because contains() proves that no gap is
/// negative.
#ifndef PW85_DISTANCE_GAP_INSIDE_HPP_INCLUDED
#define PW85_DISTANCE_GAP_INSIDE_HPP_INCLUDED

#include <pw85/distance/gap_proof.hpp>
#include <pw85/overlap/containment.hpp>

namespace pw85 {

/// The least distance between the surface of ellipsoid 2 and that of ellipsoid 1, which contains
/// it. If ellipsoid 2 is not inside ellipsoid 1, the gap is zero and the vectors are NaN.
template <class T, int D> struct GapInside {
    T gap;
    Vector<T, D> point1, point2; ///< relative to the centre of ellipsoid 1
    Vector<T, D> normal;         ///< unit vector out of both ellipsoids at these points
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

template <class T, int D> PW85_FUNCTION inline GapInside<T, D> no_gap(StatusCode status) noexcept
{
    auto result = all_nan<GapInside<T, D>>(status);
    if (status == StatusCode::success) result.gap = T(0);
    return result;
}

/// The gap along n = S⁻ᵀm, in the original coordinates. Finer numbers leave one rounding. The
/// points are relative to their own centres.
template <class T, int D> PW85_FUNCTION inline GapInside<T, D>
gap_along(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2,
          PrincipalAxes<Finer<T>, D> const &axes, Vector<T, D> const &m) noexcept
{
    using W = Finer<T>;
    Vector<W, D> n{};
    for (int i = 0; i < D; ++i)
        for (int k = 0; k < D; ++k)
            n[i] = n[i] + axes.axes[i][k] * W(W(m[k]) / W(sqrt(axes.squares[k])));
    n = W(W(1) / W(sqrt(dot(n, n)))) * n;
    Vector<W, D> const product1 = product(converted<W>(q1), n),
                       product2 = product(converted<W>(q2), n);
    W const a = W(sqrt(dot(n, product1))), b = W(sqrt(dot(n, product2)));
    W const gap = W(a - b) - dot(n, converted<W>(r12));
    return {maximum(T(0), rounded(gap)), rounded(W(W(1) / a) * product1),
            rounded(W(W(1) / b) * product2), rounded(n), StatusCode::success};
}

/// The best of the minima next to the axes of ellipsoid 1 and next to the direction of r.
template <class T, int D>
PW85_FUNCTION inline void find_first_minimum(GapProof<T, D> &proof) noexcept
{
    auto const &frame = proof.frame;
    T const size = magnitude(frame.separation);
    Vector<T, D> axis{};
    axis[0] = T(1);
    proof.best = gap_state(frame, size > T(0) ? T(T(1) / size) * frame.separation : axis);
    for (int k = 0; k < 2 * D; ++k) {
        axis = {};
        axis[k / 2] = k % 2 == 0 ? T(1) : T(-1);
        auto const state = gap_state(frame, axis);
        if (state.gap < proof.best.gap) proof.best = state;
    }
    proof.best = descend_gap(frame, proof.best);
}

/// Computes gap_inside() of a pair with ellipsoid 2 inside ellipsoid 1, whose size is of order one.
/// The points are relative to their own centres.
template <class T, int D>
PW85_RARE GapInside<T, D> gap_contained(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                        SymmetricMatrix<T, D> const &q2) noexcept
{
    auto const axes = principal_axes(converted<Finer<T>>(q1));
    GapProof<T, D> proof{gap_frame(r12, q2, axes), {}, T(0), {}, {}, 0, 0};
    find_first_minimum(proof);
    proof.rounding = gap_rounding(proof.frame, proof.best);
    add_cap(proof, proof.best);
    if (!prove_gap(proof)) return no_gap<T, D>(StatusCode::no_convergence);
    return gap_along(r12, q1, q2, axes, proof.best.m);
}

PW85_RARE_TIER(gap_contained)

} // namespace pw85::detail

namespace pw85 {

/// Scales a pair to the size of ellipsoid 1. An ellipsoid 2 that is smaller by 2^(limit/4) is made
/// larger. This change is far below rounding.
template <class T, int D>
PW85_FUNCTION inline GapInside<T, D> gap_inside(Vector<T, D> const &r12,
                                                SymmetricMatrix<T, D> const &q1,
                                                SymmetricMatrix<T, D> const &q2) noexcept
{
    using namespace detail;
    Containment const decision = call_contains(r12, q1, q2);
    if (decision.status != StatusCode::success || !decision.contains)
        return no_gap<T, D>(decision.status);
    constexpr int limit = std::numeric_limits<T>::max_exponent / 4;
    Unit const unit1 = unit_of(q1), unit2 = smaller_of(unit1, unit_of(q2) * Unit{limit});
    auto result = gap_contained(unit1.to_local(r12), unit1.to_local(q1), unit2.to_local(q2));
    result.gap = unit1.to_caller(result.gap);
    result.point1 = unit1.to_caller(result.point1);
    result.point2 = r12 + unit2.to_caller(result.point2);
    return result;
}

} // namespace pw85

#endif

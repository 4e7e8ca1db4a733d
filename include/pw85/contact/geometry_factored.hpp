// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The contact point, the normal and the first derivatives of μ² of ellipsoids that are given by
/// factors, Qi = Si Siᵀ. pw85.hpp and the C API use this file. at_tangency() (geometry.hpp) solves
/// the equations by conjugate directions (gram_schmidt.hpp), which give S1ᵀn and S2ᵀn with n =
/// [(1-λ) Q1 + λ Q2]⁻¹ r12. The formulas use them, because Sᵀn loses digits if it is computed from
/// n.
///
/// 1. x0 - c1 = (1-λ) S1 (S1ᵀn) and x0 - c2 = -λ S2 (S2ᵀn). The error of the first expression is a
///    few u (1-λ) |S1|²|n|, that of the second a few u λ |S2|²|n|. So the point is computed from
///    the expression with the smaller error.
/// 2. ∂μ²/∂Si is 2 (∂μ²/∂Qi) Si: ∂μ²/∂S1 = -2λ(1-λ)² n (S1ᵀn)ᵀ and ∂μ²/∂S2 = -2λ²(1-λ) n (S2ᵀn)ᵀ.
#ifndef PW85_CONTACT_GEOMETRY_FACTORED_HPP_INCLUDED
#define PW85_CONTACT_GEOMETRY_FACTORED_HPP_INCLUDED

#include <pw85/contact/factor.hpp>
#include <pw85/contact/geometry.hpp>

namespace pw85 {

/// Derivatives of μ² with respect to the separation and the entries of the factors.
template <class T, int D> struct FactorGradient {
    Vector<T, D> r12;
    Factor<T, D> s1, s2;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// A pair of factors at one λ. The images in v are S1ᵀv and S2ᵀv.
template <class T, int D> using FactoredTangency = Tangency<T, D, ImagedVector<T, D>>;

/// v with the ellipsoids exchanged.
template <class T, int D>
PW85_FUNCTION constexpr ImagedVector<T, D> operator-(ImagedVector<T, D> const &v) noexcept
{
    return {-v.w, -v.second, -v.first};
}

/// x yᵀ.
template <class T, int D> PW85_FUNCTION constexpr Factor<T, D>
outer_product(Vector<T, D> const &x, Vector<T, D> const &y) noexcept
{
    Factor<T, D> xy{};
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) xy(i, j) = x[i] * y[j];
    return xy;
}

template <class T, int D>
PW85_FUNCTION inline void rescale(FactorGradient<T, D> &g, TangencyUnits const &units) noexcept
{
    Unit const unit = units.normal * units.lambda;
    g.r12 = unit.to_caller(g.r12);
    g.s1 = (unit * units.normal * units.first).to_caller(g.s1);
    g.s2 = (unit * unit * units.second).to_caller(g.s2);
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D> PW85_FUNCTION inline ContactGeometry<T, D>
contact_geometry_factored(Vector<T, D> const &r12, Factor<T, D> const &s1, Factor<T, D> const &s2,
                          T const &lambda) noexcept
{
    using namespace detail;
    bool from_second = false;
    auto geometry = at_tangency(
        [&](FactoredTangency<T, D> const &at, Factor<T, D> const &p1, Factor<T, D> const &p2) {
            T const length = magnitude(at.v.w);
            if (!(length > T(0)))
                return all_nan<ContactGeometry<T, D>>(StatusCode::invalid_argument);
            from_second = at.weight1 * squared_size(p1) > at.weight2 * squared_size(p2);
            Vector<T, D> const point = from_second ? times(p2, T(-at.weight2) * at.v.second)
                                                   : times(p1, at.weight1 * at.v.first);
            return ContactGeometry<T, D>{point, T(T(1) / length) * at.v.w, StatusCode::success};
        },
        r12, s1, s2, lambda);
    if (from_second) geometry.point = r12 + geometry.point;
    return geometry;
}

template <class T, int D> PW85_FUNCTION inline FactorGradient<T, D>
contact_gradient_factored(Vector<T, D> const &r12, Factor<T, D> const &s1, Factor<T, D> const &s2,
                          T const &lambda) noexcept
{
    using namespace detail;
    return at_tangency(
        [](FactoredTangency<T, D> const &at, Factor<T, D> const &, Factor<T, D> const &) {
            Vector<T, D> const n = T(T(2) * at.lambda1 * at.lambda2) * at.v.w;
            return FactorGradient<T, D>{n, outer_product(n, T(-at.lambda1) * at.v.first),
                                        outer_product(n, T(-at.lambda2) * at.v.second),
                                        StatusCode::success};
        },
        r12, s1, s2, lambda);
}

} // namespace pw85

#endif

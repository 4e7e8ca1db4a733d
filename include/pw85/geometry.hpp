/// @file
/// Contact point, normal and derivatives, from the maximiser λ.
///
/// With τ = λ/(1-λ) and s = (Q1 + τ Q2)⁻¹ r12 (envelope theorem: λ may be held fixed, f being stationary there):
///
/// 1. x0 - c1 = Q1 s, x0 - c2 = -τ Q2 s; the common normal is along s.
/// 2. ∂μ²/∂r12 = 2λ s; ∂μ²/∂Q1 = -λ s sᵀ; ∂μ²/∂Q2 = -λτ s sᵀ.
/// 3. Rotations about the own centres: ∂μ²/∂ω1 = 2λ s × Q1s, ∂μ²/∂ω2 = 2λτ s × Q2s. With 2 and r12 = Q1s + τQ2s their
/// sum
///    plus r12 × ∂μ²/∂r12 vanishes: no net torque.
#ifndef PW85_GEOMETRY_HPP_INCLUDED
#define PW85_GEOMETRY_HPP_INCLUDED

#include <pw85/contact.hpp>

namespace pw85::inline PW85_TARGET {

/// Where and how the ellipsoids, scaled by μ, touch.
template <class T, int D> struct ContactGeometry {
    Vector<T, D> point;  ///< relative to the centre of ellipsoid 1
    Vector<T, D> normal; ///< unit vector, out of ellipsoid 1 and into ellipsoid 2
    Status status;
};

/// Derivatives of μ² with respect to the separation and the stored entries of the forms.
template <class T, int D> struct ContactGradient {
    Vector<T, D> r12;
    SymmetricMatrix<T, D> q1, q2;
    Status status;
};

/// Derivatives of μ² with respect to the rotation vectors of the ellipsoids, each about its own centre.
template <class T> struct ContactTorque {
    Vector<T, 3> rotation1, rotation2;
    Status status;
};

/// The pair at a given λ, in the order of the caller: s, the arms Q1s and τQ2s, λ and τ, in units of the scaled pair.
template <class T, int D> struct Tangency {
    Vector<T, D> s, arm1, arm2;
    T lambda, tau;
    int length, form; ///< true s: times 2^(length - 2 form); true arms: times 2^length
    Status status;
};

template <class T, int D> inline Tangency<T, D> tangency(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                                         SymmetricMatrix<T, D> const &q2, T const &lambda) noexcept
{
    Tangency<T, D> result{};
    ScaledPair<T, D> scaled;
    bool const in_range = lambda >= T(0) && lambda <= T(1);
    result.status = in_range ? validate(r12, q1, q2, scaled) : Status::invalid_argument;
    if (result.status != Status::success || largest_coordinate(r12) == T(0)) return result;
    // A maximiser that rounds to an end is that of a pair of very different sizes, not the end.
    T const least = T(0.5) * unit_roundoff<T>();
    T const complement = maximum(T(T(1) - lambda), least);
    T const tau = maximum(lambda, std::numeric_limits<T>::min()) / complement;
    T const ratio = scaled.pair.ratio, t = (scaled.swapped ? T(1) / tau : tau) / ratio / ratio;

    Vector<T, D> const s = solve(factorize_blend(T(1), scaled.pair.q1, t, scaled.pair.q2), scaled.pair.r12);
    Vector<T, D> const arm1 = product(scaled.pair.q1, s), arm2 = times(t, product(scaled.pair.q2, s));
    // Exchanging the ellipsoids multiplies s = (Q1 + τQ2)⁻¹r by -1/τ.
    T const sign = scaled.swapped ? T(-1) : T(1);
    result.s = times(scaled.swapped ? T(-1) / tau : T(1), s);
    result.arm1 = times(sign, scaled.swapped ? arm2 : arm1);
    result.arm2 = times(sign, scaled.swapped ? arm1 : arm2);
    result.lambda = tau / (T(1) + tau);
    result.tau = tau;
    result.length = scaled.length;
    result.form = scaled.form;
    return result;
}

template <class T, int D>
inline ContactGeometry<T, D> contact_geometry(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                              SymmetricMatrix<T, D> const &q2, T const &lambda) noexcept
{
    auto const at = tangency(r12, q1, q2, lambda);
    ContactGeometry<T, D> result{{}, {}, at.status};
    T const largest = largest_coordinate(at.s);
    if (at.status == Status::success && !(largest > T(0))) result.status = Status::invalid_argument;
    if (result.status != Status::success) {
        for (int i = 0; i < D; ++i) result.point[i] = result.normal[i] = quiet_nan<T>();
        return result;
    }
    Vector<T, D> const direction = times(T(1) / largest, at.s);
    result.point = times_power_of_two(at.arm1, at.length);
    result.normal = times(T(T(1) / square_root(dot(direction, direction))), direction);
    return result;
}

/// -weight·s sᵀ by stored entries.
template <class T, int D>
constexpr SymmetricMatrix<T, D> negative_outer(T const &weight, Vector<T, D> const &s) noexcept
{
    SymmetricMatrix<T, D> a = outer_weights(s);
    for (int k = 0; k < a.size; ++k) a[k] = -weight * a[k];
    return a;
}

template <class T, int D>
inline ContactGradient<T, D> contact_gradient(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                              SymmetricMatrix<T, D> const &q2, T const &lambda) noexcept
{
    auto const at = tangency(r12, q1, q2, lambda);
    T const factor = at.status == Status::success ? T(1) : quiet_nan<T>();
    int const exponent = at.length - 2 * at.form;
    return {times_power_of_two(times(T(T(2) * at.lambda * factor), at.s), exponent),
            times_power_of_two(negative_outer(T(at.lambda * factor), at.s), 2 * exponent),
            times_power_of_two(negative_outer(T(at.lambda * at.tau * factor), at.s), 2 * exponent), at.status};
}

template <class T> inline ContactTorque<T> contact_torque(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
                                                          SymmetricMatrix<T, 3> const &q2, T const &lambda) noexcept
{
    auto const at = tangency(r12, q1, q2, lambda);
    T const factor = at.status == Status::success ? T(2) * at.lambda : quiet_nan<T>();
    int const exponent = 2 * (at.length - at.form);
    return {times_power_of_two(times(factor, cross(at.s, at.arm1)), exponent),
            times_power_of_two(times(factor, cross(at.s, at.arm2)), exponent), at.status};
}

} // namespace pw85::inline PW85_TARGET

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Point of contact, normal and derivatives of μ² in n dimensions. With s = [(1-λ) Q1 + λ Q2]⁻¹ r12
/// the point is (1-λ) Q1 s and the normal is along s. By the envelope theorem ∂μ²/∂r12 = 2λ(1-λ) s,
/// ∂μ²/∂Q1 = -λ(1-λ)² s sᵀ and ∂μ²/∂Q2 = -λ²(1-λ) s sᵀ.
#ifndef PW85_ANY_DIMENSION_GEOMETRY_HPP_INCLUDED
#define PW85_ANY_DIMENSION_GEOMETRY_HPP_INCLUDED

#include <pw85/any_dimension/contact.hpp>
#include <pw85/contact/geometry.hpp>

namespace pw85 {

/// The outputs of nd_contact_geometry(), in arrays of the caller. An output whose pointer is null
/// is not written.
struct NdGeometry {
    double *point, *normal, *d_r12, *d_q1, *d_q2;
};

} // namespace pw85

namespace pw85::detail::any_dimension {

/// s 2^exponent, and Q1 s in the units of the forms.
struct TangencySolution {
    double s[max_dimension], q1s[max_dimension];
    Unit length, form; ///< of r12, and of both forms
};

/// Solves for s with numbers of type T. Returns false if the error could exceed 2^-26 of s in the
/// norm of M in double precision, or 2^-53 with wider numbers. One correction follows.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline bool
find_tangency(Input const &in, double lambda, TangencySolution &result, Workspace<T> &work) noexcept
{
    auto &pair = work.pair;
    auto &at = work.at;
    int const n = in.n;
    scale(in, {result.length, result.form, result.form, false, {}}, pair);
    // Q1 + t Q2 with the larger of both weights set to 1
    T const weight1 = maximum(T(T(1) - T(lambda)), T(complement_of(lambda))), weight2 = T(lambda);
    bool const first = weight1 >= weight2;
    T const t = first ? weight2 / weight1 : weight1 / weight2;
    if (!first) {
        for (int k = 0; k < packed_size(n); ++k) std::swap(pair.q1[k], pair.q2[k]);
    }
    if (!evaluate(pair, t, at)) return false;
    T const error = T(solution_error(n)) * inverse_bound(pair, t, at) * operation_error<T>();
    // With wider numbers the solution must be accurate to rounding without the correction, because
    // the residual of the correction is rounded, too.
    int const digits = std::is_same_v<T, double> ? result_digits<T>() / 2 : result_digits<T>();
    if (!(error <= negative_power_of_two<T>(digits))) return false;
    T rest[max_dimension]{};
    for (int i = 0; i < n; ++i) rest[i] = pair.r12[i] - at.p[i] - t * at.q[i];
    solve(n, at.factors, rest, at.v);
    T const larger = first ? weight1 : weight2;
    for (int i = 0; i < n; ++i) at.s[i] = (at.s[i] + at.v[i]) / larger;
    product(n, first ? pair.q1 : pair.q2, at.s, at.p);
    for (int i = 0; i < n; ++i) {
        if constexpr (std::is_same_v<T, double>)
            result.s[i] = at.s[i], result.q1s[i] = at.p[i];
        else
            result.s[i] = rounded(at.s[i]), result.q1s[i] = rounded(at.p[i]);
    }
    return true;
}

/// Solves for s with numbers of twice, and then of seven times, the digits.
[[gnu::cold, gnu::noinline]] PW85_FUNCTION inline StatusCode
find_tangency_wider(Input const &in, double lambda, TangencySolution &result) noexcept
{
    if constexpr (FLT_EVAL_METHOD == 0)
        if (with_wide_workspace(
                [&](auto &work) { return find_tangency(in, lambda, result, work); }))
            return StatusCode::success;
    using Memory = Workspace<exact::Extended<double>>;
    auto *const work = static_cast<Memory *>(std::malloc(sizeof(Memory)));
    if (work == nullptr) return StatusCode::out_of_memory;
    bool const found = find_tangency(in, lambda, result, *work);
    std::free(work);
    return found ? StatusCode::success : StatusCode::no_convergence;
}

/// Stores -weight s sᵀ in packed form. An off-diagonal entry stands for two entries of the matrix.
PW85_FUNCTION inline void store_outer(int n, double weight, double const *s, Unit unit,
                                      double *d) noexcept
{
    for (int i = 0; i < n; ++i)
        for (int j = i; j < n; ++j)
            d[packed_index(n, i, j)] =
                unit.to_caller(-(i == j ? weight : 2.0 * weight) * s[i] * s[j], 2);
}

PW85_FUNCTION inline void store(int n, double lambda, TangencySolution const &at,
                                NdGeometry const &out) noexcept
{
    double const rest = complement_of(lambda), norm = square_root(dot(n, at.s, at.s));
    Unit const of_s = at.length / at.form / at.form;
    for (int i = 0; i < n; ++i) {
        if (out.point != nullptr) out.point[i] = at.length.to_caller(rest * at.q1s[i]);
        if (out.normal != nullptr) out.normal[i] = at.s[i] / norm;
        if (out.d_r12 != nullptr) out.d_r12[i] = of_s.to_caller(2.0 * lambda * rest * at.s[i]);
    }
    if (out.d_q1 != nullptr) store_outer(n, lambda * rest * rest, at.s, of_s, out.d_q1);
    if (out.d_q2 != nullptr) store_outer(n, lambda * lambda * rest, at.s, of_s, out.d_q2);
}

} // namespace pw85::detail::any_dimension

namespace pw85 {

/// Computes the point of contact, the normal and the derivatives at λ; see nd_contact(). Nothing is
/// stored if the status is not success. r12 must not be zero.
PW85_FUNCTION inline StatusCode nd_contact_geometry(int n, double const *r12, double const *q1,
                                                    double const *q2, double lambda,
                                                    NdGeometry const &out) noexcept
{
    using namespace detail::any_dimension;
    Input const in{n, r12, q1, q2};
    StatusCode const status = status_of(in);
    if (status != StatusCode::success) return status;
    double const r = largest_magnitude(n, r12);
    if (!(lambda >= 0.0 && lambda <= 1.0) || r == 0.0) return StatusCode::invalid_argument;
    double const size = detail::maximum(largest_diagonal(n, q1), largest_diagonal(n, q2));
    TangencySolution at{{}, {}, detail::unit_of(r), {detail::half_exponent(size)}};
    auto const find = [&](auto &work) { return find_tangency(in, lambda, at, work); };
    if (!with_workspace(find)) {
        StatusCode const wider = find_tangency_wider(in, lambda, at);
        if (wider != StatusCode::success) return wider;
    }
    store(n, lambda, at, out);
    return StatusCode::success;
}

} // namespace pw85

#endif

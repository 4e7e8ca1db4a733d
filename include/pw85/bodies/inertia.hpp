// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Second moments and tensors of inertia of uniform ellipsoids and of sheets of their shape.
///
/// The mean of x xᵀ over a uniform ellipsoid is Q/5, over a uniform ellipse Q/4. With the moments M
/// and the mass m the tensor of inertia is m (tr(M) I - M).
#ifndef PW85_BODIES_INERTIA_HPP_INCLUDED
#define PW85_BODIES_INERTIA_HPP_INCLUDED

#include <pw85/bodies/surface.hpp>
#include <pw85/contact/forms.hpp>

namespace pw85 {

/// A tensor of inertia of unit density. It is NaN if the status is not success.
template <class T> struct Inertia {
    SymmetricMatrix<T, 3> inertia;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// The second moments of a uniform body.
template <class T, int D>
PW85_FUNCTION constexpr SymmetricMatrix<T, D> body_moments(SymmetricMatrix<T, D> q) noexcept
{
    for (int k = 0; k < q.size; ++k) q[k] = q[k] / T(D + 2);
    return q;
}

/// tr(M) I - M. Each diagonal entry is the sum of two moments, so small entries lose no digits by
/// cancellation.
template <class T>
PW85_FUNCTION constexpr SymmetricMatrix<T, 3> inertia_of(SymmetricMatrix<T, 3> const &m) noexcept
{
    return {m[3] + m[5], -m[1], -m[2], m[0] + m[5], -m[4], m[0] + m[3]};
}

/// The tensor of inertia of a mass with given second moments.
template <class T> PW85_FUNCTION inline SymmetricMatrix<T, 3>
inertia_of_mass(T const &mass, SymmetricMatrix<T, 3> const &moments) noexcept
{
    auto inertia = inertia_of(moments);
    for (int k = 0; k < inertia.size; ++k) inertia[k] = mass * inertia[k];
    return inertia;
}

/// The tensor of inertia of a shell of a valid form.
template <class T>
PW85_FUNCTION inline SymmetricMatrix<T, 3> shell_inertia(SymmetricMatrix<T, 3> const &q) noexcept
{
    auto const sheet = sheet_moments(q);
    return inertia_of_mass(sheet.area, sheet.moments);
}

/// The tensor of inertia of a valid form. It is computed in the unit in which the largest diagonal
/// entry of the form is in [1, 4). So the mass alone cannot leave the range, and zero entries
/// remain zero if other entries overflow.
template <class T> PW85_FUNCTION inline SymmetricMatrix<T, 3>
inertia_of_valid(SymmetricMatrix<T, 3> const &q, bool is_shell) noexcept
{
    Unit const unit = unit_of(q);
    auto const scaled = unit.to_local(q);
    auto const inertia = is_shell ? shell_inertia(scaled)
                                  : inertia_of_mass(measure_of(scaled), body_moments(scaled));
    return unit.to_caller(inertia, is_shell ? 4 : 5);
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D>
PW85_FUNCTION inline Moments<T, D> second_moments(SymmetricMatrix<T, D> const &q) noexcept
{
    StatusCode const status = detail::validate(q);
    if (status != StatusCode::success) return detail::all_nan<Moments<T, D>>(status);
    return {detail::body_moments(q), status};
}

template <class T, int D>
PW85_FUNCTION inline Form<T, D> from_moments(SymmetricMatrix<T, D> const &second_moments) noexcept
{
    StatusCode const status = detail::validate(second_moments);
    if (status != StatusCode::success) return detail::all_nan<Form<T, D>>(status);
    return detail::checked_form(T(D + 2) * second_moments);
}

template <class T>
PW85_FUNCTION inline Inertia<T> inertia(SymmetricMatrix<T, 3> const &q, int shell) noexcept
{
    StatusCode const status = detail::validate(q);
    if (status != StatusCode::success) return detail::all_nan<Inertia<T>>(status);
    return {detail::inertia_of_valid(q, shell != 0), status};
}

} // namespace pw85

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The form of an ellipsoid whose rotation is a 3×3 matrix of any type (matrix_entries.hpp).
#ifndef PW85_CONTACT_ROTATIONS_HPP_INCLUDED
#define PW85_CONTACT_ROTATIONS_HPP_INCLUDED

#include <pw85/algebra/matrix_entries.hpp>
#include <pw85/contact/forms.hpp>

namespace pw85 {

template <class T, class Matrix>
requires detail::IsRotationOf<T, Matrix> PW85_FUNCTION constexpr Form<T, 3>
ellipsoid(Vector<T, 3> const &semi_axes, Matrix const &rotation) noexcept
{
    T entries[9]{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) entries[3 * i + j] = detail::matrix_entry<T>(rotation, i, j);
    return ellipsoid(semi_axes, entries);
}

} // namespace pw85

#endif

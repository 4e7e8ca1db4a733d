// SPDX-License-Identifier: BSD-3-Clause
// Rotates forms in the wide type, for numerical derivatives.
#ifndef PW85_TESTS_ROTATED_HPP_INCLUDED
#define PW85_TESTS_ROTATED_HPP_INCLUDED

#include "wide.hpp"

namespace pw85_tests {

template <class T, int D> T norm(pw85::Vector<T, D> const &x)
{
    return pw85::detail::square_root(pw85::dot(x, x));
}

/// A form after rotation by |ω| about ω.
inline pw85::SymmetricMatrix<Wide, 3> rotated(pw85::SymmetricMatrix<Wide, 3> const &q,
                                              pw85::Vector<Wide, 3> const &omega)
{
    Wide const angle = norm(omega);
    if (angle == 0) return q;
    auto const axis = Wide(sin(angle / 2) / angle) * omega;
    auto const r = pw85::detail::rotation_matrix(
        pw85::Vector<Wide, 4>{cos(angle / 2), axis[0], axis[1], axis[2]}, Wide(1));
    pw85::SymmetricMatrix<Wide, 3> result{};
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                for (int l = 0; l < 3; ++l)
                    result(i, j) += r.entries[3 * i + k] * q(k, l) * r.entries[3 * j + l];
    return result;
}

} // namespace pw85_tests

#endif

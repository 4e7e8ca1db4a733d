// SPDX-License-Identifier: BSD-3-Clause
module;
#include <pw85/linked.hpp>
export module grains;

/// Whether two equal balls overlap whose centres are at this distance.
export inline bool balls_overlap(double radius, double distance) noexcept
{
    double const square = radius * radius;
    pw85::SymmetricMatrix<double, 3> const ball{square, 0.0, 0.0, square, 0.0, square};
    pw85::Vector<double, 3> const r12{distance, 0.0, 0.0};
    return pw85::overlap(r12, ball, ball).overlap;
}

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Random changes of the cell of a simulation. volume_moves.cpp draws and applies them.
#ifndef PW85_SIMULATION_CHANGE_HPP_INCLUDED
#define PW85_SIMULATION_CHANGE_HPP_INCLUDED

#include <pw85/algebra/philox.hpp>

#include "configuration.hpp"

namespace pw85::detail::simulation {

/// Types of changes, with the numbers of the C API.
enum class ChangeType { isotropic, axis, triclinic, aspect };

/// The matrix by which row vectors are multiplied from the right: an isotropic scaling, a scaling
/// along one axis, a change of the aspect, or a shear. It differs from the identity by its diagonal
/// or by one entry.
class Change {
  public:
    /// Draws a change. A change and its inverse are equally probable: (1 + x/2)/(1 - x/2) becomes
    /// its inverse for -x, and so does a shear. The triclinic type draws one of the axes or one of
    /// the shears x_d += x x_e with e > d, each with the same probability: 1/6, or 1/3 in two
    /// dimensions. These shears leave the vectors of a cell a lower triangular matrix if they are
    /// one. In two dimensions z stays as it is, to the last bit. The aspect changes by a factor
    /// along one axis, and its inverse square root along the two others, or its inverse along the
    /// other: the determinant is one.
    [[gnu::always_inline]] Change(ChangeType type, double largest, int dimensions,
                                  Stream &stream) noexcept
    {
        constexpr int sheared[3][2] = {{0, 1}, {0, 2}, {1, 2}};
        auto const num_axes = static_cast<std::uint32_t>(dimensions),
                   num_shears = num_axes * (num_axes - 1) / 2;
        double const x = largest * stream.symmetric();
        std::uint32_t const num_choices =
            num_axes + (type == ChangeType::triclinic ? num_shears : 0);
        std::uint32_t const choice = type == ChangeType::isotropic ? 0 : stream.below(num_choices);
        if (choice >= num_axes) {
            to_ = sheared[choice - num_axes][0];
            from_ = sheared[choice - num_axes][1];
            shear_ = x;
            return;
        }
        double const factor = (1.0 + 0.5 * x) / (1.0 - 0.5 * x);
        if (type == ChangeType::aspect) {
            double const other = 1.0 / (dimensions == 2 ? factor : elementary::sqrt(factor));
            for (int d = 0; d < dimensions; ++d)
                scales_[d] = static_cast<int>(choice) == d ? factor : other;
            return;
        }
        for (int d = 0; d < dimensions; ++d) {
            if (type != ChangeType::isotropic && static_cast<int>(choice) != d) continue;
            scales_[d] = factor;
            determinant_ *= factor;
        }
    }

    /// An isotropic scaling.
    [[gnu::always_inline]] Change(double factor, int dimensions) noexcept
    {
        for (int d = 0; d < dimensions; ++d) {
            scales_[d] = factor;
            determinant_ *= factor;
        }
    }

    double determinant() const noexcept { return determinant_; }

    [[gnu::always_inline]] Vector3 apply(Vector3 x) const noexcept
    {
        for (int d = 0; d < 3; ++d) x[d] *= scales_[d];
        x[to_] += shear_ * x[from_];
        return x;
    }

  private:
    double scales_[3] = {1.0, 1.0, 1.0}, determinant_ = 1.0, shear_ = 0.0;
    int to_ = 0, from_ = 1;
};

} // namespace pw85::detail::simulation

#endif

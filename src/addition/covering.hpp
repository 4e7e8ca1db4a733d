// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Tests whether a particle of the packing covers a voxel: it overlaps everything that can be put
/// there.
///
/// The inner form of the voxel (inner_forms.hpp) decides, at each of its corners: the positions at
/// which two ellipsoids overlap are a convex set. In space the inner form is a ball.
#ifndef PW85_ADDITION_COVERING_HPP_INCLUDED
#define PW85_ADDITION_COVERING_HPP_INCLUDED

#include <algorithm>

#include "attempts.hpp"

namespace pw85::detail::sequential_addition {
namespace {

/// The test for all voxels with the same divisions.
template <int D> class Covering {
  public:
    /// @param packing,all_species live as long as this object
    Covering(Packing<D> const &packing, Array<Species<D>> const &all_species,
             Divisions<D> const &divisions) noexcept
        : packing_(packing), all_species_(all_species), divisions_(divisions)
    {
        for (std::size_t c = 0; c < num_corners; ++c) {
            Vector<double, D> half;
            for (int i = 0; i < D; ++i)
                half[i] = (static_cast<double>(c >> i & 1) - 0.5) /
                          static_cast<double>(divisions.places[i]);
            corners_[c] = packing.cell().point(half);
            reach_ = maximum(reach_, magnitude(corners_[c]));
        }
        error_ = position_error * packing.cell().edges();
    }

    /// Computes the squares of the semi-axes of the inner forms. Returns false if there is no
    /// memory.
    [[nodiscard]] bool prepare() noexcept
    {
        if (!squares_.resize(all_species_.size())) return false;
        for (std::size_t k = 0; k < all_species_.size(); ++k) {
            double const inner = all_species_[k].inner(), outer = all_species_[k].outer();
            Axes2 const within =
                D == 2 ? inside_rotated(outer, inner, half_angle_range(divisions_.angles))
                       : Axes2{inner, inner};
            squares_[k] = reduced_squares(within, rounding_loss(outer, packing_.cell().edges()));
        }
        return true;
    }

    bool covers(Voxel<D> const &voxel) const noexcept
    {
        if (!is_certainly_definite(squares_[voxel.species])) return false;
        Body<D> const body = inner_body(voxel);
        Vector<double, D> place;
        for (int i = 0; i < D; ++i)
            place[i] = (static_cast<double>(voxel.corner[i]) + 0.5) /
                       static_cast<double>(divisions_.places[i]);
        auto const covered_by = [&](Vector<double, D> const &r, Body<D> const &other) noexcept {
            double const distance = magnitude(r);
            if (distance > body.outer + other.outer) return false;
            if (distance + reach_ + error_ < (body.inner + other.inner) * (1 - margin)) return true;
            return std::all_of(corners_, corners_ + num_corners, [&](auto const &corner) noexcept {
                return overlaps(r - corner, body.q, other.q);
            });
        };
        return packing_.any_near(place, packing_.cell().point(place), covered_by);
    }

  private:
    static constexpr std::size_t num_corners = 1 << D;

    Body<D> inner_body(Voxel<D> const &voxel) const noexcept
    {
        Axes2 const &squares = squares_[voxel.species];
        Body<D> body{{}, elementary::sqrt(squares[0]), elementary::sqrt(squares[1])};
        if constexpr (D == 2) {
            Vector<double, 3> const &axes = all_species_[voxel.species].axes;
            double const turn = axes[0] < axes[1] ? pi : 0.0;
            body.q =
                rotated_form(squares, double_middle_angle(voxel.angle, divisions_.angles) + turn);
        } else {
            body.q = {squares[0], 0.0, 0.0, squares[0], 0.0, squares[0]};
        }
        return body;
    }

    Packing<D> const &packing_;
    Array<Species<D>> const &all_species_;
    Divisions<D> divisions_;
    Array<Axes2> squares_;                   ///< of each species
    Vector<double, D> corners_[num_corners]; ///< from the middle of a voxel
    double reach_ = 0.0, error_;             ///< largest distance of a corner; error of positions
};

} // namespace
} // namespace pw85::detail::sequential_addition

#endif

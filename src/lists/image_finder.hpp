// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Finds the nearest images of the pairs of a neighbour list, and their multiples of the cell's
/// vectors. pw85_nearest_images() (lists.cpp) calls it.
#ifndef PW85_LISTS_IMAGE_FINDER_HPP_INCLUDED
#define PW85_LISTS_IMAGE_FINDER_HPP_INCLUDED

#include <pw85.h>
#include <pw85/contact/scaling.hpp>

#include "../periodic/nearest_image.hpp"
#include "../simd/pairs.hpp"

namespace pw85::detail::kernels {
namespace {

/// Finds the nearest images of the pairs of a list.
class ImageFinder {
  public:
    /// @param list with the lattice of its cell; must outlive this object
    explicit ImageFinder(NeighborList const &list) noexcept : list_(list)
    {
        double reduced[9];
        reduce(list.cell, reduced, multiples_);
    }

    /// Finds the nearest image of a pair, and returns a status. It writes the separation and the
    /// multiples of the cell's vectors, each if its pointer is not null.
    int find(std::size_t pair, double *r12, std::int32_t *image) const noexcept
    {
        std::int32_t const *const ij = row_of(list_.pairs, 2, pair);
        double const *const x = row_of(list_.centers, 3, static_cast<std::size_t>(ij[0]));
        double const *const y = row_of(list_.centers, 3, static_cast<std::size_t>(ij[1]));
        Vector<double, 3> const apart{y[0] - x[0], y[1] - x[1], y[2] - x[2]};
        Vector<double, 3> const nearest = nearest_image(*list_.lattice, apart);
        Vector<double, 3> multiple{0.0, 0.0, 0.0};
        for (int i = 0; i < 3; ++i) {
            double const n = nearest_integer(coordinate(i, nearest) - coordinate(i, apart));
            for (int d = 0; d < 3; ++d) multiple[d] = multiple[d] + n * multiples_[i][d];
        }
        bool const fits = largest_coordinate(multiple) <= INT32_MAX,
                   good = is_finite(nearest) && (fits || !image);
        for (int d = 0; d < 3; ++d) {
            if (r12 != nullptr) r12[d] = good ? nearest[d] : quiet_nan<double>();
            if (image != nullptr)
                image[d] = good ? static_cast<std::int32_t>(multiple[d]) : INT32_MIN;
        }
        return good ? PW85_SUCCESS : PW85_EINVAL;
    }

  private:
    /// Coordinate i of r in the reduced basis.
    double coordinate(int i, Vector<double, 3> const &r) const noexcept
    {
        double const *const dual = list_.lattice->dual[i];
        return dual[0] * r[0] + dual[1] * r[1] + dual[2] * r[2];
    }

    NeighborList const &list_;
    double multiples_[3][3]; ///< each reduced vector in multiples of the cell's vectors
};

} // namespace
} // namespace pw85::detail::kernels

#endif

// SPDX-License-Identifier: BSD-3-Clause
// Random points of an ellipsoid: uniform points of the unit ball or of its
// sphere, stretched by the semi-axes.
//
// Stretching keeps points of a body uniform. It multiplies the element of area at the direction n
// by a b c √(Σ n_i²/a_i²). A point is kept with the ratio of this to its largest value, a b for the
// shortest semi-axis c. The share that is kept is S/(4π a b), with the area S. It is at least one
// half, because the area of a convex body is at least twice that of its shadow π a b.
#define PW85_SHORT_OPERATIONS // before doubled.hpp: calls take no longer here
#include <cstdint>

#include <pw85/algebra/doubled.hpp>
#include <pw85/algebra/philox.hpp>
#include <pw85/contact/scaling.hpp>
#include <pw85/distance/nearest.hpp>

#include "../base/c_arrays.hpp"
#include "functions.hpp"

namespace pw85::detail::enclosing {
namespace {

using Vector3 = Vector<double, 3>;

/// An ellipsoid in a unit in which the largest diagonal entry of its form is in [1, 4). The axes
/// are found with twice the digits, which thin ellipsoids need.
class StretchedBall {
  public:
    explicit StretchedBall(SymmetricMatrix<double, 3> const &q) noexcept : unit_(unit_of(q))
    {
        auto const found = principal_axes(converted<Finer<double>>(unit_.to_local(q)));
        for (int i = 0; i < 3; ++i) {
            semi_axes_[i] = elementary::sqrt(rounded(found.squares[i]));
            for (int k = 0; k < 3; ++k) axes_[k][i] = rounded(found.axes[k][i]);
        }
        shortest_ = minimum(semi_axes_[0], minimum(semi_axes_[1], semi_axes_[2]));
    }

    Vector3 inside(Stream &random) const noexcept { return stretched(random.in_ball()); }

    Vector3 on_surface(Stream &random) const noexcept
    {
        for (;;) {
            Vector3 const x = random.in_ball();
            Vector3 const n = (1.0 / elementary::sqrt(dot(x, x))) * x;
            Vector3 kept;
            for (int i = 0; i < 3; ++i) kept[i] = n[i] * (shortest_ / semi_axes_[i]);
            double const height = random.uniform();
            if (height * height < dot(kept, kept)) return stretched(n);
        }
    }

  private:
    Vector3 stretched(Vector3 const &n) const noexcept
    {
        Vector3 x{};
        for (int k = 0; k < 3; ++k)
            for (int i = 0; i < 3; ++i) x[k] += axes_[k][i] * (semi_axes_[i] * n[i]);
        return unit_.to_caller(x);
    }

    Unit unit_;
    double semi_axes_[3], axes_[3][3], shortest_;
};

} // namespace

/// Steps of simulations count from 0 upward. Points count from 2⁶⁴ - 1 downward: a simulation with
/// the same seed draws other numbers.
void draw_points(SymmetricMatrix<double, 3> const &q, bool surface, std::uint64_t seed,
                 std::size_t num_points, double *points) noexcept
{
    StretchedBall const ball(q);
    for (std::size_t k = 0; k < num_points; ++k) {
        Stream random(seed, ~std::uint64_t{k}, 0);
        c_api::store(surface ? ball.on_surface(random) : ball.inside(random), points + 3 * k);
    }
}

} // namespace pw85::detail::enclosing

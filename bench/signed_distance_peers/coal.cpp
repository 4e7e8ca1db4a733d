// SPDX-License-Identifier: BSD-3-Clause
// coal (formerly hpp-fcl) with its default settings.
#include <coal/narrowphase/narrowphase.h>
#include <coal/shape/geometric_shapes.h>

#include "bodies.hpp"

namespace {

using namespace pw85_bench;

struct Shape {
    coal::Ellipsoid shape;
    coal::Transform3s place;

    Shape(PrincipalAxes const &axes, Eigen::Vector3d const &center)
        : shape(axes.lengths), place(axes.turn, center)
    {
    }
};

class Coal final : public DistancePeer {
  public:
    void take(std::vector<Forms> const &pairs) override
    {
        shapes_.clear();
        for_each_body(pairs, [&](PrincipalAxes const &axes, Eigen::Vector3d const &center) {
            shapes_.emplace_back(axes, center);
        });
    }
    Answer measure(std::size_t i) override
    {
        Shape const &a = shapes_[2 * i], &b = shapes_[2 * i + 1];
        coal::Vec3s point1, point2, normal;
        double const d =
            solver_.shapeDistance(a.shape, a.place, b.shape, b.place, true, point1, point2, normal);
        return {d, {normal[0], normal[1], normal[2]}};
    }

  private:
    std::vector<Shape> shapes_;
    coal::GJKSolver solver_{coal::DistanceRequest(true, true)};
};

} // namespace

std::unique_ptr<DistancePeer> pw85_bench::make_coal() { return std::make_unique<Coal>(); }

// SPDX-License-Identifier: BSD-3-Clause
// GJK and EPA of Jolt with the default tolerances. Jolt has no ellipsoids, but these algorithms
// take any body with a support function. They compute in float.
#include <Jolt/Jolt.h>

#include <Jolt/Geometry/EPAPenetrationDepth.h>
#include <Jolt/Physics/PhysicsSettings.h>

#include "bodies.hpp"

namespace {

using namespace pw85_bench;

struct Shape {
    JPH::Mat44 place;
    JPH::Vec3 semi_axes;

    Shape(PrincipalAxes const &axes, Eigen::Vector3d const &center)
        : place(JPH::Vec4(vector(axes.turn.col(0)), 0.0f),
                JPH::Vec4(vector(axes.turn.col(1)), 0.0f),
                JPH::Vec4(vector(axes.turn.col(2)), 0.0f), JPH::Vec4(vector(center), 1.0f)),
          semi_axes(vector(axes.lengths))
    {
    }

    static JPH::Vec3 vector(Eigen::Vector3d const &x)
    {
        auto const y = x.cast<float>();
        return {y[0], y[1], y[2]};
    }

    JPH::Vec3 GetSupport(JPH::Vec3Arg direction) const
    {
        JPH::Vec3 const scaled = semi_axes * place.Multiply3x3Transposed(direction);
        float const length = scaled.Length();
        if (length == 0.0f) return place.GetTranslation();
        return place * (semi_axes * scaled / length);
    }
};

class Jolt final : public DistancePeer {
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
        JPH::Vec3 axis = JPH::Vec3::sAxisX(), point1, point2;
        JPH::GJKClosestPoint gjk;
        float const squared = gjk.GetClosestPoints(a, b, JPH::cDefaultCollisionTolerance, FLT_MAX,
                                                   axis, point1, point2);
        if (squared > 0.0f) return answer(std::sqrt(squared), axis);
        JPH::EPAPenetrationDepth epa;
        axis = JPH::Vec3::sAxisX();
        if (!epa.GetPenetrationDepth(a, a, 0.0f, b, b, 0.0f, JPH::cDefaultCollisionTolerance,
                                     JPH::cDefaultPenetrationTolerance, axis, point1, point2))
            return {};
        return answer(-(point2 - point1).Length(), axis);
    }

  private:
    static Answer answer(float distance, JPH::Vec3Arg axis)
    {
        return {distance, {axis.GetX(), axis.GetY(), axis.GetZ()}};
    }

    std::vector<Shape> shapes_;
};

} // namespace

std::unique_ptr<DistancePeer> pw85_bench::make_jolt() { return std::make_unique<Jolt>(); }

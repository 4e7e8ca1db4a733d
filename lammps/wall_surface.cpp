// SPDX-License-Identifier: GPL-2.0-only
// Half-spaces and cylinders as walls, and the words of all shapes.
#include "wall_surface.hpp"

#include "wall_mesh.hpp"

#include <pw85.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pw85_lammps {

namespace {

char const too_deep[] = "is too deep in the wall for the law of force: use a larger stiffness or a "
                        "smaller time step, or "
                        "move it out of the wall before the run";

/// The relative margin in comparisons with bounding radii, far above the rounding errors of forms
/// and of sums of distances and radii.
constexpr double bounding_margin = 0x1p-40;

Vector unit(int axis)
{
    Vector e{};
    e[static_cast<std::size_t>(axis)] = 1.0;
    return e;
}

/// Half-spaces as walls: n·x <= offset is free, for several unit vectors n along the axes of space.
class HalfSpaces final : public WallSurface {
  public:
    void add(int axis, double side, double place)
    {
        crosses_[static_cast<std::size_t>(axis)] = true;
        faces_.push_back({side * unit(axis), side * place});
    }

    std::string touch(Grain const &grain, double gap,
                      std::vector<GrainGeometry> &contacts) const override
    {
        for (Face const &face : faces_) {
            double const distance = face.offset - dot(face.normal, grain.center);
            if (distance >= grain.radius + gap) continue;
            if (distance <= 0.0) return too_deep;
            GrainGeometry const g = wall_geometry(grain.form, face.normal, distance);
            if (g.depth > -gap) contacts.push_back(g);
        }
        return {};
    }

    bool cuts(Grain const &grain) const override
    {
        return std::any_of(faces_.begin(), faces_.end(), [&](Face const &face) {
            double const distance = face.offset - dot(face.normal, grain.center);
            if (distance > grain.radius * (1.0 + bounding_margin)) return false;
            Vector const outwards = -1.0 * face.normal;
            double const offset = -distance;
            int overlap = 0;
            pw85_overlap_polytope(1, outwards.data(), &offset, grain.form, &overlap);
            return overlap != 0;
        });
    }

    bool slides_along(int axis) const override { return !crosses(axis); }
    bool crosses(int axis) const override { return crosses_[static_cast<std::size_t>(axis)]; }

  private:
    struct Face {
        Vector normal; ///< into the wall
        double offset;
    };

    std::vector<Face> faces_;
    std::array<bool, 3> crosses_{};
};

/// A cylinder around an axis that is parallel to an axis of space.
///
/// The depth of a grain along a unit vector n across the axis is δ(n) = n·c + h(n) - R, with its
/// centre c relative to the axis and h(n) = √(n·Qn). Each local maximum above minus the gap is a
/// contact: a grain across the axis can touch the wall with both ends.
class InsideOfCylinder : public WallSurface {
  public:
    InsideOfCylinder(int axis, double radius, std::array<double, 2> const &place)
        : axis_(axis), radius_(radius)
    {
        origin_[first()] = place[0];
        origin_[second()] = place[1];
    }

    std::string touch(Grain const &grain, double gap,
                      std::vector<GrainGeometry> &contacts) const override
    {
        Vector const c = across(grain.center - origin_);
        if (std::sqrt(dot(c, c)) + grain.radius + gap <= radius_) return {};
        Vector n{};
        pw85_distance_cylinder(unit(axis_).data(), radius_, c.data(), grain.form, nullptr, nullptr,
                               n.data());
        if (dot(n, c) >= radius_) return too_deep;
        if (add(grain, c, n, gap, contacts) && find_second_end(grain.form, c, n))
            add(grain, c, n, gap, contacts);
        return {};
    }

    // R is at most the reciprocal of the smaller curvature κ1, because in R = 2 agm(1, k)²/(κ1 + κ2
    // k²) the numerator is at most 1 + k². pw85_grain_contact_wall() keeps κ1 above 2⁻²⁰ κ2, and κ2
    // is at least the curvature of the grain along the axis.
    double largest_radius(double radius) const override
    {
        return radius / std::max(1.0 - radius / radius_, 0x1p-20);
    }

    // Returns whether the projection of the grain along the axis is not inside of the disc.
    bool cuts(Grain const &grain) const override
    {
        Vector const c = across(grain.center - origin_);
        double const reach = std::sqrt(dot(c, c)) + grain.radius;
        if (reach * (1.0 + bounding_margin) <= radius_) return false;
        int contains = 0;
        pw85_contains_2d(shadow(c).data(), disc().data(), shadow_form(grain.form).data(),
                         &contains);
        return contains == 0;
    }

    bool slides_along(int axis) const override { return axis == axis_; }
    bool crosses(int axis) const override { return axis != axis_; }

  protected:
    std::size_t first() const { return static_cast<std::size_t>((axis_ + 1) % 3); }
    std::size_t second() const { return static_cast<std::size_t>((axis_ + 2) % 3); }

    /// Returns the part of a vector across the axis.
    Vector across(Vector x) const
    {
        x[static_cast<std::size_t>(axis_)] = 0.0;
        return x;
    }

    /// Returns the coordinates of a point in the plane across the axis.
    std::array<double, 2> shadow(Vector const &x) const { return {x[first()], x[second()]}; }

    /// Returns the form of the ellipse that a grain is in this plane, seen along the axis.
    std::array<double, 3> shadow_form(double const *q) const
    {
        Vector const e1 = unit(static_cast<int>(first())), e2 = unit(static_cast<int>(second()));
        return {dot(e1, product(q, e1)), dot(e1, product(q, e2)), dot(e2, product(q, e2))};
    }

    /// Returns the form of the cylinder in this plane.
    std::array<double, 3> disc() const { return {radius_ * radius_, 0.0, radius_ * radius_}; }

    /// Adds the contact with the plane that touches the cylinder, whose curvature comes on top of
    /// that of the grain.
    /// @param curvature of the wall: positive if its material is inside
    /// @return whether there is a contact
    bool add_tangent(Grain const &grain, Vector const &n, double distance, double curvature,
                     double gap, std::vector<GrainGeometry> &contacts) const
    {
        GrainGeometry const g =
            wall_geometry(grain.form, n, distance, cross(unit(axis_), n), curvature);
        if (g.depth > -gap) contacts.push_back(g);
        return g.depth > -gap;
    }

    int axis_;
    double radius_;
    Vector origin_{};

  private:
    bool add(Grain const &grain, Vector const &c, Vector const &n, double gap,
             std::vector<GrainGeometry> &contacts) const
    {
        return add_tangent(grain, n, radius_ - dot(n, c), -1.0 / radius_, gap, contacts);
    }

    bool find_second_end(double const *q, Vector const &c, Vector &n) const;
};

/// Finds the second local maximum of n·c + h(n), if there is one. The global one is known to pw85.
///
/// Across the axis the grain is an ellipse with semi-axes a > b. In the basis of its axes, with
/// signs for which the centre (x, y) has no negative coordinate, the stationary points are n = h v
/// with v = (x/s, y/(g + s)), g = a² - b², where F(s) = a² x²/s² + b² y²/(g + s)² = 1 (see
/// pw85/distance/nearest.hpp). The second maximum has n with the signs (-, +); there -g < s < 0. F
/// is convex there, and infinite at both ends; of its two roots, if there are any, the maximum is
/// the larger one. At s = -a x, F is at least 1, and its larger root is below. So Newton's method
/// descends to it monotonically.
bool InsideOfCylinder::find_second_end(double const *q, Vector const &c, Vector &n) const
{
    Vector const e1 = unit(static_cast<int>(first())), e2 = unit(static_cast<int>(second()));
    auto const [xx, xy, yy] = shadow_form(q);
    double const half = 0.5 * (xx - yy), spread = std::sqrt(half * half + xy * xy),
                 gap = 2.0 * spread;
    double const major = 0.5 * (xx + yy) + spread, minor = (xx * yy - xy * xy) / major;
    double const angle = 0.5 * std::atan2(xy, half);
    Vector f1 = std::cos(angle) * e1 + std::sin(angle) * e2,
           f2 = std::cos(angle) * e2 - std::sin(angle) * e1;
    if (dot(f1, c) < 0.0) f1 = -1.0 * f1;
    if (dot(f2, c) < 0.0) f2 = -1.0 * f2;
    double const ax = std::sqrt(major) * dot(f1, c), by = std::sqrt(minor) * dot(f2, c);
    double s = -ax;
    for (int step = 0; step < 100; ++step) {
        if (!(gap + s > 0.0)) return false;
        double const u = s < 0.0 ? ax / s : -1.0, v = by / (gap + s); // F = u² + v²
        if (s == 0.0 && v > 1.0) return false;
        double const excess = s < 0.0 ? u * u + v * v - 1.0 : 0.0;
        double const slope = s < 0.0 ? -2.0 * (u * u / s + v * v / (gap + s)) : 1.0;
        if (!(slope > 0.0)) return false;
        double const change = excess / slope;
        s -= change;
        // Relative to s, which is as small as the component x: F is 1 at a root alone.
        if (change > -0x1p-50 * s) continue;
        double const along = -std::sqrt(std::max(0.0, 1.0 - v * v) / major),
                     beside = v / std::sqrt(minor);
        n = along * f1 + beside * f2;
        n = (1.0 / std::sqrt(dot(n, n))) * n;
        return true;
    }
    return false;
}

/// The outside of such a cylinder. Its distance from a grain is that of its axis from the ellipse
/// that the grain is across the axis.
class OutsideOfCylinder final : public InsideOfCylinder {
  public:
    using InsideOfCylinder::InsideOfCylinder;

    bool cuts(Grain const &grain) const override
    {
        Vector const r = across(origin_ - grain.center);
        double const reach = (radius_ + grain.radius) * (1.0 + bounding_margin);
        if (std::sqrt(dot(r, r)) > reach) return false;
        int overlap = 0;
        pw85_overlap_2d(shadow(r).data(), shadow_form(grain.form).data(), disc().data(), &overlap);
        return overlap != 0;
    }

    double largest_radius(double radius) const override { return radius; }

    std::string touch(Grain const &grain, double gap,
                      std::vector<GrainGeometry> &contacts) const override
    {
        Vector const r = across(origin_ - grain.center);
        double const reach = grain.radius + radius_ + gap;
        if (dot(r, r) >= reach * reach) return {};
        // Without the products with the axis, the form is that of an ellipsoid whose cross-section
        // is the ellipse.
        double q[6] = {grain.form[0], grain.form[1], grain.form[2],
                       grain.form[3], grain.form[4], grain.form[5]};
        constexpr int products[3][2] = {{1, 2}, {1, 4}, {2, 4}};
        for (int k : products[axis_]) q[k] = 0.0;
        double distance = 0.0;
        Vector n{};
        pw85_distance_point(r.data(), q, &distance, nullptr, n.data());
        if (!(distance > 0.0 && dot(n, r) > radius_)) return too_deep;
        add_tangent(grain, n, dot(n, r) - radius_, 1.0 / radius_, gap, contacts);
        return {};
    }
};

enum class Side { in, out };

/// Reads on which side of the wall the grains are; inside, if the command does not say it.
Side parse_side(Words &words)
{
    return words.skip("side") ? words.choice<Side>("side", {{"in", Side::in}, {"out", Side::out}})
                              : Side::in;
}

std::unique_ptr<WallSurface> parse_planes(Words &words, int axis)
{
    auto planes = std::make_unique<HalfSpaces>();
    auto const lower = words.number_or_null("coordinate", -HUGE_VAL),
               upper = words.number_or_null("coordinate", -HUGE_VAL);
    if (!lower && !upper)
        words.refuse("has no plane: write one coordinate or two, and NULL for the other");
    if (lower && upper && !(*lower < *upper))
        words.refuse(
            "has its planes in the wrong order: write the lower coordinate before the upper one");
    if (lower) planes->add(axis, -1.0, *lower);
    if (upper) planes->add(axis, 1.0, *upper);
    return planes;
}

std::unique_ptr<WallSurface> parse_cylinder(Words &words, int axis)
{
    double const radius = words.positive("radius");
    std::array<double, 2> place{};
    if (words.skip("at"))
        for (double &x : place) x = words.coordinate("place");
    Side const side = parse_side(words);
    // The place is given in the order of the axes x, y, z; the cylinder needs that of a
    // right-handed basis.
    if (axis == 1) std::swap(place[0], place[1]);
    if (side == Side::in) return std::make_unique<InsideOfCylinder>(axis, radius, place);
    return std::make_unique<OutsideOfCylinder>(axis, radius, place);
}

std::unique_ptr<WallSurface> parse_box(Words &words)
{
    std::array<Vector, 2> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
        for (Vector &corner : corners) corner[k] = words.coordinate("place");
        if (!(corners[0][k] < corners[1][k]))
            words.refuse("has an empty box: write each lower coordinate before the upper one");
    }
    if (parse_side(words) == Side::out) return WallMesh::box(corners[0], corners[1]);
    auto faces = std::make_unique<HalfSpaces>();
    for (int axis = 0; axis < 3; ++axis)
        for (std::size_t k = 0; k < 2; ++k)
            faces->add(axis, k == 0 ? -1.0 : 1.0, corners[k][static_cast<std::size_t>(axis)]);
    return faces;
}

} // namespace

std::unique_ptr<WallSurface> WallSurface::parse(Words &words)
{
    enum class Shape { plane, cylinder, box, mesh };
    using Choice = std::pair<Shape, int>;
    auto const [shape, axis] = words.choice<Choice>("shape", {{"xplane", {Shape::plane, 0}},
                                                              {"yplane", {Shape::plane, 1}},
                                                              {"zplane", {Shape::plane, 2}},
                                                              {"xcylinder", {Shape::cylinder, 0}},
                                                              {"ycylinder", {Shape::cylinder, 1}},
                                                              {"zcylinder", {Shape::cylinder, 2}},
                                                              {"box", {Shape::box, 0}},
                                                              {"mesh", {Shape::mesh, 0}}});
    switch (shape) {
    case Shape::plane:
        return parse_planes(words, axis);
    case Shape::cylinder:
        return parse_cylinder(words, axis);
    case Shape::box:
        return parse_box(words);
    case Shape::mesh:
        return WallMesh::parse(words);
    }
    return {};
}

} // namespace pw85_lammps

// SPDX-License-Identifier: BSD-3-Clause
// Decides whether walls cut particles: see walls.hpp.
#include "walls.hpp"

#include <limits>

#include <pw85/overlap/containment.hpp>
#include <pw85/shapes/overlap_polytope.hpp>

#include "../base/c_arrays.hpp"

namespace pw85::detail::simulation {

namespace {

using c_api::load_vector;

/// The bound, relative to lengths, below which a component of a cell vector across a wall counts as
/// zero: some hundred times the rounding errors of rotated vectors.
constexpr double perpendicular = 0x1p-44;

/// The part by which a bounding box is enlarged before it decides. It covers some ten rounding
/// errors.
constexpr double enlargement = 1.0 + 0x1p-40;

/// Returns the direction scaled to a largest coordinate of one: no product overflows or vanishes.
Vector3 scaled(Vector3 const &direction) noexcept
{
    double const largest = largest_coordinate(direction);
    return largest > 0.0 ? direction / largest : direction;
}

bool is_along_z(Vector3 const &axis) noexcept { return axis[0] == 0.0 && axis[1] == 0.0; }

/// Returns whether the periodic vectors of a cell are along an axis.
bool is_repeated_along(Vector3 const &direction, Cell const &cell) noexcept
{
    Vector3 const axis = scaled(direction);
    bool along = true;
    for (int k = 0; k < 3 && cell.exists; ++k) {
        Vector3 const a = cell.vector(k);
        double const limit = perpendicular * sum_of_magnitudes(a) * sum_of_magnitudes(axis);
        along = along && (!cell.periodic[k] || largest_coordinate(cross(a, axis)) <= limit);
    }
    return along;
}

bool is_not_repeated(Cell const &cell) noexcept
{
    return !cell.exists || (!cell.periodic[0] && !cell.periodic[1] && !cell.periodic[2]);
}

bool is_positive(double x) noexcept { return x > 0.0 && elementary::isfinite(x); }

bool is_ordered(Vector3 const &lower, Vector3 const &upper, bool is_flat) noexcept
{
    bool ordered = true;
    for (int d = 0; d < (is_flat ? 2 : 3); ++d) ordered = ordered && lower[d] <= upper[d];
    return ordered;
}

/// Returns whether a particle has inner points in the half-space normal·x >= offset.
bool half_space_cuts(Vector3 const &normal, double offset, Particle const &particle) noexcept
{
    double const along = dot(normal, particle.center),
                 width = magnitude_of_dot(normal, particle.half_widths);
    // The least normal number is for products that underflow.
    double const rounding =
        0x1p-40 * (magnitude_of_dot(normal, particle.center) + elementary::abs(offset)) +
        std::numeric_limits<double>::min();
    if (offset - along > enlargement * width + rounding) return false;
    Vector3 const outward = -normal;
    double const least = -offset;
    auto const answer =
        overlap_polytope(1, outward.coordinates, &least, particle.q, particle.center);
    return answer.status != Status::success || answer.overlap;
}

/// Returns whether an ellipsoid or an ellipse has points outside of a ball or disc around 0. Its
/// centre and the diagonal of its bounding box decide where it is well inside.
template <int D> bool leaves_ball(double radius, Vector<double, D> const &center,
                                  SymmetricMatrix<double, D> const &q) noexcept
{
    double diagonal = 0.0;
    SymmetricMatrix<double, D> ball{};
    for (int d = 0; d < D; ++d) {
        diagonal += q(d, d);
        ball(d, d) = radius * radius;
    }
    if (enlargement * (magnitude(center) + elementary::sqrt(diagonal)) < radius) return false;
    auto const answer = contains(center, ball, q);
    return answer.status != Status::success || !answer.contains;
}

/// Two unit vectors across an axis: coordinate axes if the axis is one.
struct Across {
    Vector3 first, second;
};

Across vectors_across(Vector3 const &direction) noexcept
{
    Vector3 const axis = scaled(direction);
    int longest = 0;
    for (int d = 1; d < 3; ++d)
        if (elementary::abs(axis[d]) > elementary::abs(axis[longest])) longest = d;
    Vector3 first{}, along = axis / magnitude(axis);
    first[(longest + 1) % 3] = 1.0;
    first = add_scaled(first, -dot(first, along), along);
    first = first / magnitude(first);
    return {first, cross(along, first)};
}

bool cylinder_cuts(Vector3 const &axis, double radius, Vector3 const &center,
                   Form3 const &q) noexcept
{
    auto const [first, second] = vectors_across(axis);
    Vector3 const by_first = product(q, first), by_second = product(q, second);
    SymmetricMatrix<double, 2> shadow{};
    shadow(0, 0) = dot(first, by_first);
    shadow(0, 1) = dot(first, by_second);
    shadow(1, 1) = dot(second, by_second);
    return leaves_ball<2>(radius, {dot(first, center), dot(second, center)}, shadow);
}

bool disc_cuts(double radius, Vector3 const &center, Form3 const &q) noexcept
{
    return cylinder_cuts({0.0, 0.0, 1.0}, radius, center, q);
}

bool box_cuts(Vector3 const &lower, Vector3 const &upper, Particle const &particle,
              int dimensions) noexcept
{
    bool cut = false;
    for (int d = 0; d < (dimensions == 2 ? 2 : 3); ++d) {
        Vector3 outward{};
        outward[d] = 1.0;
        cut = cut || half_space_cuts(outward, upper[d], particle) ||
              half_space_cuts(-outward, -lower[d], particle);
    }
    return cut;
}

} // namespace

bool is_repeated_across(Vector3 const &direction, Cell const &cell) noexcept
{
    Vector3 const normal = scaled(direction);
    bool across = true;
    for (int k = 0; k < 3 && cell.exists; ++k) {
        Vector3 const a = cell.vector(k);
        across = across && (!cell.periodic[k] ||
                            elementary::abs(dot(a, normal)) <=
                                perpendicular * sum_of_magnitudes(a) * sum_of_magnitudes(normal));
    }
    return across;
}

namespace {

/// Requirements on the members of a wall, null where they are not read, and on the centres of
/// particles.
struct Requirements {
    char const *point, *vector, *size, *center;
};

constexpr char radius[] = "must be a radius > 0 whose square is finite and not 0";
constexpr char within_radius[] =
    "must not have a particle in them, beyond the radius: correct the numbers of the wall, "
    "or move the particle";

/// By the kind of the wall.
constexpr Requirements requirements[] = {
    {nullptr, "must be a normal that is finite and not zero", "must be an offset that is finite",
     "must not have a particle in them, where normal·x >= offset: correct the numbers of "
     "the wall, or move the particle"},
    {"must be a center that is finite", nullptr, radius, within_radius},
    {"must be a point that is finite", "must be an axis that is finite and not zero", radius,
     within_radius},
    {"must be a lower corner that is finite", "must be an upper corner that is finite", nullptr,
     "must not have a particle in them, outside of the box: correct the numbers of the "
     "wall, or move the particle"}};

/// Checks that the numbers that are read are finite.
MemberComplaint unless_all_finite(pw85_wall const &wall) noexcept
{
    auto const [point, vector, size, center] = requirements[wall.kind];
    MemberComplaint found{};
    if (point != nullptr) found = unless_finite("point", point, wall.point, 3);
    if (vector != nullptr && found.text == nullptr)
        found = unless_finite("vector", vector, wall.vector, 3);
    if (size != nullptr && found.text == nullptr)
        found = unless_finite("size", size, &wall.size, 1);
    return found;
}

/// Checks the numbers of a wall, which are finite.
MemberComplaint of_finite_numbers(pw85_wall const &wall, bool is_flat) noexcept
{
    Vector3 const point = load_vector<3>(wall.point), vector = load_vector<3>(wall.vector);
    Requirements const &required = requirements[wall.kind];
    if (wall.kind == PW85_WALL_BOX)
        return is_ordered(point, vector, is_flat)
                   ? MemberComplaint{}
                   : MemberComplaint{"walls", "must have lower <= upper corners"};
    if (required.size == radius && !(wall.size > 0.0 && is_positive(wall.size * wall.size)))
        return {"size", radius, wall.size};
    if (required.vector != nullptr && largest_coordinate(vector) == 0.0)
        return {"vector", required.vector};
    if (is_flat && wall.kind == PW85_WALL_PLANE && vector[2] != 0.0)
        return {"vector", "must be a normal without z in two dimensions", vector[2], 2};
    if (is_flat && wall.kind == PW85_WALL_CYLINDER && !is_along_z(vector))
        return {"vector", "must be an axis along z in two dimensions"};
    return {};
}

bool is_repeated(pw85_wall const &wall, Cell const &cell) noexcept
{
    Vector3 const vector = load_vector<3>(wall.vector);
    if (wall.kind == PW85_WALL_PLANE) return is_repeated_across(vector, cell);
    if (wall.kind == PW85_WALL_CYLINDER) return is_repeated_along(vector, cell);
    return is_not_repeated(cell);
}

} // namespace

MemberComplaint complaint_of(pw85_wall const &wall, Configuration const &configuration) noexcept
{
    if (wall.kind < PW85_WALL_PLANE || wall.kind > PW85_WALL_BOX)
        return {"kind", "must be from 0 to 3, PW85_WALL_...", static_cast<double>(wall.kind)};
    MemberComplaint found = unless_all_finite(wall);
    if (found.text == nullptr) found = of_finite_numbers(wall, configuration.dimensions == 2);
    if (found.text != nullptr || is_repeated(wall, configuration.cell)) return found;
    return {"walls", "must be the same in all images of the cell"};
}

namespace {

/// Returns whether a wall has a point, up to rounding errors.
bool has_point(pw85_wall const &wall, Vector3 const &x, int dimensions) noexcept
{
    Vector3 const point = load_vector<3>(wall.point), from_point = x - point,
                  vector = dimensions == 2 && wall.kind == PW85_WALL_SPHERE
                               ? Vector3{0.0, 0.0, 1.0}
                               : load_vector<3>(wall.vector);
    if (wall.kind == PW85_WALL_PLANE) return dot(vector, x) >= wall.size;
    if (wall.kind == PW85_WALL_SPHERE && dimensions == 3) return magnitude(from_point) >= wall.size;
    if (wall.kind != PW85_WALL_BOX)
        return magnitude(cross(from_point, vector)) >= wall.size * magnitude(vector);
    bool outside = false;
    for (int d = 0; d < dimensions; ++d) outside = outside || x[d] < point[d] || x[d] > vector[d];
    return outside;
}

} // namespace

MemberComplaint complaint_of_cut(pw85_wall const &wall, Vector3 const &center,
                                 int dimensions) noexcept
{
    if (has_point(wall, center, dimensions)) return {"walls", requirements[wall.kind].center};
    return {"walls", "must not cut a particle: move one of them"};
}

bool cuts(pw85_wall const &wall, Particle const &particle, int dimensions) noexcept
{
    Vector3 const point = load_vector<3>(wall.point), vector = load_vector<3>(wall.vector),
                  center = particle.center - point;
    switch (wall.kind) {
    case PW85_WALL_PLANE:
        return half_space_cuts(vector, wall.size, particle);
    case PW85_WALL_SPHERE:
        if (dimensions == 2) return disc_cuts(wall.size, center, particle.q);
        return leaves_ball<3>(wall.size, center, particle.q);
    case PW85_WALL_CYLINDER:
        return cylinder_cuts(vector, wall.size, center, particle.q);
    default:
        return box_cuts(point, vector, particle, dimensions);
    }
}

} // namespace pw85::detail::simulation

// SPDX-License-Identifier: BSD-3-Clause
// Walls and energies of particles: see external_potential.hpp.
#include "external_potential.hpp"

#include <span>

#include <pw85/volume/volume.hpp>

#include "../base/c_arrays.hpp"
#include "walls.hpp"

namespace pw85::detail::simulation {

namespace {

using c_api::load_vector;

/// Returns a principal axis, of length one: a column of the matrix of the rotation.
Vector3 principal_axis(Quaternion const &quaternion, int axis) noexcept
{
    auto const [m] = rotation_matrix(quaternion, 1.0);
    return {m[axis], m[3 + axis], m[6 + axis]};
}

/// Returns the volume of an ellipsoid, or the area of an ellipse.
double volume_of(Vector3 const &semi_axes, int dimensions) noexcept
{
    double const rectangle = semi_axes[0] * semi_axes[1];
    return dimensions == 2 ? unit_measure<double, 2>() * rectangle
                           : unit_measure<double, 3>() * (rectangle * semi_axes[2]);
}

double energy_of(pw85_field const &field, Particle const &particle, int dimensions) noexcept
{
    Vector3 const vector = load_vector<3>(field.vector);
    switch (field.kind) {
    case PW85_FIELD_LINEAR:
        return field.strength * dot(vector, particle.center);
    case PW85_FIELD_WEIGHT:
        return field.strength *
               (volume_of(particle.semi_axes, dimensions) * dot(vector, particle.center));
    case PW85_FIELD_HARMONIC: {
        double sum = 0.0;
        for (int d = 0; d < 3; ++d) {
            double const x = particle.center[d] - field.point[d];
            sum += vector[d] * (x * x);
        }
        return field.strength * (0.5 * sum);
    }
    default: {
        double const along = dot(principal_axis(particle.quaternion, field.axis), vector);
        return field.strength * (0.5 - 1.5 * (along * along / dot(vector, vector)));
    }
    }
}

/// Returns whether a field is the same in all images of the cell.
bool is_repeated(pw85_field const &field, Cell const &cell) noexcept
{
    if (field.kind == PW85_FIELD_ALIGNING || field.strength == 0.0) return true;
    if (field.kind != PW85_FIELD_HARMONIC)
        return is_repeated_across(load_vector<3>(field.vector), cell);
    bool repeated = true;
    for (int d = 0; d < 3; ++d) {
        Vector3 axis{};
        axis[d] = 1.0;
        repeated = repeated && (field.vector[d] == 0.0 || is_repeated_across(axis, cell));
    }
    return repeated;
}

/// Requirements on the vector of a field, by its kind.
constexpr char const *requirements_on_vector[] = {
    "must be a gradient that is finite", "must be a gradient that is finite",
    "must be a stiffness that is finite", "must be a direction whose square is finite and not 0"};

/// Checks the numbers of a field, whose kind is right.
MemberComplaint of_numbers(pw85_field const &field) noexcept
{
    if (field.axis < 0 || field.axis > 2)
        return {"axis", "must be from 0 to 2", static_cast<double>(field.axis)};
    if (field.kind == PW85_FIELD_HARMONIC)
        if (MemberComplaint const found =
                unless_finite("point", "must be a center that is finite", field.point, 3);
            found.text != nullptr)
            return found;
    char const *const text = requirements_on_vector[field.kind];
    MemberComplaint const found = unless_finite("vector", text, field.vector, 3);
    if (found.text != nullptr) return found;
    Vector3 const vector = load_vector<3>(field.vector);
    double const square = dot(vector, vector);
    if (field.kind == PW85_FIELD_ALIGNING && !(square > 0.0 && elementary::isfinite(square)))
        return {"vector", text};
    return unless_finite("strength", "must be finite", &field.strength, 1);
}

/// Checks a field in a cell.
MemberComplaint complaint_of(pw85_field const &field, Cell const &cell) noexcept
{
    if (field.kind < PW85_FIELD_LINEAR || field.kind > PW85_FIELD_ALIGNING)
        return {"kind", "must be from 0 to 3, PW85_FIELD_...", static_cast<double>(field.kind)};
    MemberComplaint const found = of_numbers(field);
    if (found.text != nullptr || is_repeated(field, cell)) return found;
    return {"fields", "must be the same in all images of the cell"};
}

double without_minus_infinity(double energy) noexcept
{
    return energy > -infinity<double>() ? energy : quiet_nan<double>();
}

} // namespace

/// Notes the cause for a particle that a wall or the mesh cuts. Returns the first wall that cuts
/// it, or the triangle that is nearest to it.
std::int32_t ExternalPotential::refuse_cut(Particle const &particle, int dimensions) const noexcept
{
    for (std::size_t k = 0; k < walls.size(); ++k) {
        if (!simulation::cuts(walls[k], particle, dimensions)) continue;
        auto const found = complaint_of_cut(walls[k], particle.center, dimensions);
        note_cause(PW85_EOVERLAP, found.member, found.text, k);
        return static_cast<std::int32_t>(k);
    }
    std::int32_t const nearest = mesh.nearest(particle);
    note_cause(PW85_EOVERLAP, "triangles", "must not cut a particle: move one of them",
               static_cast<std::size_t>(nearest));
    return nearest;
}

bool ExternalPotential::cuts(Particle const &particle, int dimensions) const noexcept
{
    for (pw85_wall const &wall : std::span(walls.data(), walls.size()))
        if (simulation::cuts(wall, particle, dimensions)) return true;
    return mesh.cuts(particle);
}

double ExternalPotential::energy_of_fields(Particle const &particle, int dimensions) const noexcept
{
    double sum = 0.0;
    for (pw85_field const &field : std::span(fields.data(), fields.size()))
        sum += energy_of(field, particle, dimensions);
    return sum;
}

double ExternalPotential::energy_of_potential(std::size_t i,
                                              Particle const &particle) const noexcept
{
    if (potential == nullptr) return 0.0;
    return without_minus_infinity(
        potential(context, static_cast<std::int32_t>(i), particle.center.coordinates,
                  particle.quaternion.coordinates, particle.semi_axes.coordinates));
}

double ExternalPotential::energy(std::size_t i, Particle const &particle,
                                 int dimensions) const noexcept
{
    return without_minus_infinity(energy_of_fields(particle, dimensions) +
                                  energy_of_potential(i, particle));
}

double ExternalPotential::energy(Configuration const &configuration) const noexcept
{
    double sum = 0.0;
    for (std::size_t i = 0; i < configuration.size(); ++i)
        sum += energy(i, configuration.get(i), configuration.dimensions);
    return sum;
}

int ExternalPotential::check_energies(Configuration const &configuration) const noexcept
{
    for (std::size_t i = 0; i < configuration.size() && has_energy(); ++i) {
        double const found = energy(i, configuration.get(i), configuration.dimensions);
        if (!elementary::isfinite(found))
            return note_cause(PW85_EPOTENTIAL, nullptr,
                              "the energy of each particle must be finite", i, 0, found);
    }
    return PW85_SUCCESS;
}

int ExternalPotential::check_suited(Configuration const &configuration) const noexcept
{
    if (mesh.exists() && configuration.dimensions != 3)
        return note_cause(PW85_EINVAL, "triangles", "must not be set in two dimensions");
    for (std::size_t k = 0; k < walls.size(); ++k)
        if (MemberComplaint const found = complaint_of(walls[k], configuration);
            found.text != nullptr)
            return note_complaint(found, k);
    for (std::size_t k = 0; k < fields.size(); ++k)
        if (MemberComplaint const found = complaint_of(fields[k], configuration.cell);
            found.text != nullptr)
            return note_complaint(found, k);
    return PW85_SUCCESS;
}

int ExternalPotential::refuse_energy() noexcept
{
    return note_cause(PW85_EPOTENTIAL, "potential", "must not return NaN or -infinity");
}

int ExternalPotential::check_potential() const noexcept
{
    if (!lacks_potential) return PW85_SUCCESS;
    return note_cause(PW85_EPOTENTIAL, "potential",
                      "must be set again after the state is restored");
}

int ExternalPotential::check(Configuration const &configuration,
                             std::int32_t *overlap) const noexcept
{
    if (int const status = check_suited(configuration)) return status;
    for (std::size_t i = 0; i < configuration.size(); ++i) {
        Particle const particle = configuration.get(i);
        if (!mesh.is_testable(particle))
            return note_cause(PW85_EINVAL, nullptr,
                              "particles must not be so long or so far away that more than 2¹⁴ of "
                              "their images may meet the mesh",
                              i);
        if (!cuts(particle, configuration.dimensions)) continue;
        std::int32_t const other = refuse_cut(particle, configuration.dimensions);
        if (overlap != nullptr) overlap[0] = static_cast<std::int32_t>(i);
        if (overlap != nullptr) overlap[1] = other;
        return PW85_EOVERLAP;
    }
    return check_energies(configuration);
}

} // namespace pw85::detail::simulation

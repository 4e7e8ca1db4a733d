// SPDX-License-Identifier: BSD-3-Clause
// Walls and energies of particles: see external_potential.hpp.
#include "external_potential.hpp"

#include <cmath>
#include <span>

#include <pw85/volume/volume.hpp>

#include "../base/c_arrays.hpp"
#include "walls.hpp"

namespace pw85::detail::simulation {

namespace {

using c_api::load_vector;

/// A principal axis, of length one: a column of the matrix of the rotation.
Vector3 principal_axis(Quaternion const &quaternion, int axis) noexcept
{
    auto const [m] = rotation_matrix(quaternion, 1.0);
    return {m[axis], m[3 + axis], m[6 + axis]};
}

/// The volume of an ellipsoid, or the area of an ellipse.
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

bool is_suited(pw85_field const &field, Cell const &cell) noexcept
{
    if (field.kind < PW85_FIELD_LINEAR || field.kind > PW85_FIELD_ALIGNING || field.axis < 0 ||
        field.axis > 2)
        return false;
    Vector3 const point = load_vector<3>(field.point), vector = load_vector<3>(field.vector);
    if (!is_finite(vector) || !std::isfinite(field.strength)) return false;
    if (field.kind == PW85_FIELD_HARMONIC && !is_finite(point)) return false;
    double const square = dot(vector, vector);
    if (field.kind == PW85_FIELD_ALIGNING && !(square > 0.0 && std::isfinite(square))) return false;
    return is_repeated(field, cell);
}

double without_minus_infinity(double energy) noexcept
{
    return energy > -HUGE_VAL ? energy : quiet_nan<double>();
}

} // namespace

/// The first wall that cuts a particle, or the triangle of the mesh that is nearest to a particle
/// which the mesh cuts; -1 if there is none.
std::int32_t ExternalPotential::first_cut(Particle const &particle, int dimensions) const noexcept
{
    for (std::size_t k = 0; k < walls.size(); ++k)
        if (simulation::cuts(walls[k], particle, dimensions)) return static_cast<std::int32_t>(k);
    return mesh.cuts(particle) ? mesh.nearest(particle) : -1;
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

bool ExternalPotential::has_finite_energies(Configuration const &configuration) const noexcept
{
    for (std::size_t i = 0; i < configuration.size() && has_energy(); ++i)
        if (!std::isfinite(energy(i, configuration.get(i), configuration.dimensions))) return false;
    return true;
}

bool ExternalPotential::suits(Configuration const &configuration) const noexcept
{
    bool suited = !mesh.exists() || configuration.dimensions == 3;
    for (pw85_wall const &wall : std::span(walls.data(), walls.size()))
        suited = suited && is_suited(wall, configuration);
    for (pw85_field const &field : std::span(fields.data(), fields.size()))
        suited = suited && is_suited(field, configuration.cell);
    return suited;
}

int ExternalPotential::check(Configuration const &configuration,
                             std::int32_t *overlap) const noexcept
{
    if (!suits(configuration)) return PW85_EINVAL;
    for (std::size_t i = 0; i < configuration.size(); ++i) {
        Particle const particle = configuration.get(i);
        if (!cuts(particle, configuration.dimensions)) continue;
        if (overlap != nullptr) overlap[0] = static_cast<std::int32_t>(i);
        if (overlap != nullptr) overlap[1] = first_cut(particle, configuration.dimensions);
        return PW85_EOVERLAP;
    }
    return has_finite_energies(configuration) ? PW85_SUCCESS : PW85_EPOTENTIAL;
}

} // namespace pw85::detail::simulation

// SPDX-License-Identifier: BSD-3-Clause
// The C API of walls, fields and potentials of simulations: see external_potential.hpp.
#include <algorithm>
#include <tuple>
#include <utility>

#include "../base/c_arrays.hpp"
#include "hard_ellipsoids.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::simulation;

namespace {

/// Replaces a member of the external potential, and restores it if the configuration does not allow
/// the new one. Returns a status.
template <class Member> int replace(Engine &engine, Member ExternalPotential::*member, Member made,
                                    std::int32_t *overlap = nullptr) noexcept
{
    Member before = std::move(engine.hamiltonian.external.*member);
    engine.hamiltonian.external.*member = std::move(made);
    int const status = engine.hamiltonian.external.check(engine.particles.all(), overlap);
    if (status != PW85_SUCCESS) engine.hamiltonian.external.*member = std::move(before);
    return status;
}

template <class Element>
int copy_of(std::size_t n, Element const *elements, Array<Element> &copy) noexcept
{
    if (!copy.resize(n)) return PW85_ENOMEM;
    std::copy_n(elements, n, copy.data());
    return PW85_SUCCESS;
}

template <class Element> int set(Engine &engine, std::size_t n, Element const *elements,
                                 Array<Element> ExternalPotential::*member,
                                 std::int32_t *overlap = nullptr) noexcept
{
    Array<Element> copy;
    if (int const status = copy_of(n, elements, copy)) return status;
    return replace(engine, member, std::move(copy), overlap);
}

int set_mesh(Engine &engine, std::size_t num_vertices, double const *vertices,
             std::size_t num_triangles, std::int32_t const *triangles,
             std::int32_t *overlap) noexcept
{
    if (num_vertices > INT32_MAX || num_triangles > INT32_MAX)
        return note_cause(PW85_EINVAL, num_vertices > INT32_MAX ? "num_vertices" : "num_triangles",
                          "must be below 2³¹");
    MeshWall made;
    if (int const status = copy_of(3 * num_vertices, vertices, made.vertices)) return status;
    if (int const status = copy_of(3 * num_triangles, triangles, made.triangles)) return status;
    if (int const status = made.prepare(engine.particles.all().cell)) return status;
    return replace(engine, &ExternalPotential::mesh, std::move(made), overlap);
}

/// Sets the potential. After a restore it must give the saved energy, to the last bit.
int set_potential(Engine &engine, pw85_potential *potential, void *context) noexcept
{
    ExternalPotential &external = engine.hamiltonian.external;
    auto const old = std::pair(external.potential, external.context);
    external.potential = potential;
    external.context = context;
    int status = external.check(engine.particles.all(), nullptr);
    if (status == PW85_SUCCESS && external.lacks_potential && potential != nullptr &&
        external.energy_of_potential(engine.particles.all()) != external.saved_energy)
        status = note_cause(PW85_EINVAL, "potential",
                            "must be that of the restored state: their energies differ");
    if (status == PW85_SUCCESS)
        external.lacks_potential = false;
    else
        std::tie(external.potential, external.context) = old;
    return status;
}

} // namespace

int pw85::detail::hard_ellipsoids_set_walls(pw85_hard_ellipsoids &simulation, size_t num_walls,
                                            pw85_wall const *walls, int32_t overlap[2]) noexcept
{
    return set(simulation.engine, num_walls, walls, &ExternalPotential::walls, overlap);
}

int pw85::detail::hard_ellipsoids_set_mesh(pw85_hard_ellipsoids &simulation, size_t num_vertices,
                                           double const *vertices, size_t num_triangles,
                                           int32_t const *triangles, int32_t overlap[2]) noexcept
{
    return set_mesh(simulation.engine, num_vertices, vertices, num_triangles, triangles, overlap);
}

int pw85::detail::hard_ellipsoids_set_fields(pw85_hard_ellipsoids &simulation, size_t num_fields,
                                             pw85_field const *fields) noexcept
{
    return set(simulation.engine, num_fields, fields, &ExternalPotential::fields);
}

int pw85::detail::hard_ellipsoids_set_potential(pw85_hard_ellipsoids &simulation,
                                                pw85_potential *potential, void *context) noexcept
{
    return set_potential(simulation.engine, potential, context);
}

int pw85::detail::hard_ellipsoids_set_law(pw85_hard_ellipsoids &simulation,
                                          pw85_law const *law) noexcept
{
    return simulation.engine.hamiltonian.pairs.set(law);
}

int pw85::detail::hard_ellipsoids_energy(pw85_hard_ellipsoids const &simulation,
                                         double *energy) noexcept
{
    Engine const &engine = simulation.engine;
    double sum;
    int const status = engine.hamiltonian.energy(engine.particles.all(), sum);
    if (status == PW85_SUCCESS) *energy = sum;
    return status;
}

int pw85::detail::hard_ellipsoids_law_virial(pw85_hard_ellipsoids const &simulation,
                                             double *virial) noexcept
{
    Engine const &engine = simulation.engine;
    double sum = 0.0;
    if (engine.hamiltonian.pairs.exists())
        if (int const status = engine.hamiltonian.pairs.virial_of_all(engine.particles.all(), sum))
            return status;
    *virial = sum;
    return PW85_SUCCESS;
}

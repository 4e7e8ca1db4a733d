// SPDX-License-Identifier: BSD-3-Clause
// The causes of refusals that belong to single functions: cells, lists, meshes, and simulations.
// test_status.cpp has those that a declaration states. docs/tests/check_messages.py compares both
// with the sources: each requirement that a function can name is provoked.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85_batch.h>
#include <pw85_simulation.h>
#include <pw85_systems.h>

#include "cases.hpp"
#include "causes.hpp"

using namespace pw85_tests;

namespace {

constexpr double cube[] = {9, 0, 0, 0, 9, 0, 0, 0, 9}, unit_form[] = {1, 0, 0, 1, 0, 1},
                 upright[] = {1, 0, 0, 0}, axes[] = {1, 1, 1}, origin[] = {0, 0, 0};
constexpr std::size_t too_many = std::size_t{1} << 31;

/// What the next refusal must say.
struct Expected {
    char const *function, *argument, *requirement;
    std::size_t row = 0, entry = 0;

    void operator()(int status, int wanted = PW85_EINVAL) const
    {
        if (status != wanted) g_error("%s: %s %s", function, argument, requirement);
        expect_cause(function, argument, requirement, row, entry);
    }
};

/// A simulation of spheres with the radius 1 in a cube with the edge 9, or in open space.
class Simulation {
  public:
    explicit Simulation(std::vector<double> centers, double const *cell = cube,
                        std::initializer_list<int> periodic = {1, 1, 1}, int dimensions = 3)
    {
        std::vector<double> turns, all_axes;
        for (std::size_t i = 0; i < centers.size() / 3; ++i) {
            turns.insert(turns.end(), upright, upright + 4);
            all_axes.insert(all_axes.end(), axes, axes + 3);
        }
        int const *const p = periodic.begin();
        pw85_system const system{
            centers.size() / 3, centers.data(), nullptr, cell, {p[0], p[1], p[2]}};
        g_assert_cmpint(
            pw85_hard_ellipsoids_create(&system, all_axes.data(), turns.data(), 1, nullptr, &made_),
            ==, PW85_SUCCESS);
        g_assert_cmpint(pw85_hard_ellipsoids_set_dimensions(made_, dimensions), ==, PW85_SUCCESS);
    }

    Simulation(Simulation const &) = delete;
    Simulation &operator=(Simulation const &) = delete;
    ~Simulation() { pw85_hard_ellipsoids_destroy(made_); }

    operator pw85_hard_ellipsoids *() const { return made_; }

  private:
    pw85_hard_ellipsoids *made_ = nullptr;
};

/// Two circles, in a plane without a cell.
Simulation in_plane() { return Simulation({0, 0, 0, 4, 0, 0}, nullptr, {0, 0, 0}, 2); }

PW85_TEST("/causes/numbers")
{
    double q[6];
    double const small[] = {1, 1e-200, 1}, flat[] = {1, 0, 0, 0, 1, 0, 0, 0, 0},
                 identity[] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    Expected{"pw85_ellipsoid", "semi_axes", "must have a finite square that is not 0", 0,
             1}(pw85_ellipsoid(small, identity, q));
    Expected{"pw85_ellipsoid", "rotation",
             "must be a rotation matrix, whose columns are orthonormal"}(
        pw85_ellipsoid(axes, flat, q));
    double const negative[] = {1, 1, -1}, r12[] = {3, 0, 0}, low[] = {-1, 2, -1};
    int found = 0;
    Expected{"pw85_ellipsoid", "semi_axes", "must be > 0", 0,
             2}(pw85_ellipsoid(negative, identity, q));
    Expected{"pw85_compare", "mu2",
             "must not be NaN"}(pw85_compare(r12, unit_form, unit_form, NAN, &found));
    Expected{"pw85_contact_gradient", "lambda", "must be in [0, 1]"}(
        pw85_contact_gradient(r12, unit_form, unit_form, 2.0, q, nullptr, nullptr));
    Expected{"pw85_overlap_box", "lower", "must be at most upper", 0,
             1}(pw85_overlap_box(low, axes, unit_form, &found));
    pw85_motion const rest{}, shrinking{{}, {}, -1.0};
    Expected{"pw85_first_contact", "motion2", "must not shrink to nothing before t_max", 0,
             6}(pw85_first_contact(r12, unit_form, unit_form, &rest, &shrinking, 2.0, q));
}

/// A cause that is not one entry has no value.
PW85_TEST("/causes/no_number")
{
    double const r12[] = {3, 0, 0}, larger[] = {1 + 0x1p-52, 0, 0, 1, 0, 1},
                 twice[] = {4, 0, 0, 4, 0, 4};
    int overlap = 0;
    pw85_error error;
    // No common point was found among the doubles, because 1 - μ² is about 1e-16.
    g_assert_cmpint(pw85_overlap_witness(r12, larger, twice, &overlap, nullptr, nullptr), ==,
                    PW85_ECONVERGENCE);
    g_assert_cmpint(pw85_last_error(&error), ==, PW85_SUCCESS);
    g_assert_cmpstr(error.requirement, ==, "the iterations did not converge");
    if (error.argument != nullptr || !std::isnan(error.value)) g_error("%a", error.value);
    unsigned char overlaps = 0;
    g_assert_cmpint(pw85_overlap_witness_batch(1, r12, larger, twice, &overlaps, nullptr, nullptr),
                    ==, PW85_ECONVERGENCE);
    g_assert_cmpint(pw85_last_error(&error), ==, PW85_SUCCESS);
    if (error.argument != nullptr || !std::isnan(error.value)) g_error("%a", error.value);
}

PW85_TEST("/causes/lists")
{
    double const centers[] = {0, 0, 0, 3, 0, 0}, far[] = {0, 0, 0, 1e300, 0, 0},
                 two[] = {1, 0, 0, 1, 0, 1, 1, 0, 0, 1, 0, 1}, long_form[] = {90, 0, 0, 1, 0, 1};
    std::int32_t const pairs[] = {0, 1}, image[] = {1, 0, 0}, other[] = {1};
    double mu2, r12[3];
    int any = 0;
    pw85_pair_list const list{1, pairs, image};
    pw85_system system{2, centers, two, nullptr, {0, 0, 0}};
    Expected{"pw85_contact_pairs", "cell", "must not be null, because there are images"}(
        pw85_contact_pairs(&list, &system, &mu2, nullptr));
    system = {2, centers, two, cube, {1, 1, 1}};
    double const beside[] = {4.5, 4.5, 4.5};
    Expected{"pw85_overlap_any_indices", "images",
             "must be given, because farther images of the neighbors could overlap"}(
        pw85_overlap_any_indices(beside, long_form, &system, 1, other, nullptr, &any));
    system.centers = far;
    Expected{"pw85_nearest_images", "centers", "must be finite and near the cell"}(
        pw85_nearest_images(1, pairs, &system, r12, nullptr));
    system = {too_many, centers, two, cube, {1, 1, 1}};
    pw85_neighbors *neighbors = nullptr;
    Expected{"pw85_neighbors_create", "num_particles",
             "must be below 2³¹"}(pw85_neighbors_create(&system, 1.0, 0.0, &neighbors));
    system.num_particles = 2;
    g_assert_cmpint(pw85_neighbors_create(&system, 1.0, 0.0, &neighbors), ==, PW85_SUCCESS);
    system.num_particles = 1;
    Expected{"pw85_neighbors_holds", "system",
             "must have as many particles as the list, and a cell that is periodic along the same "
             "vectors, or none if the list has none"}(
        pw85_neighbors_holds(neighbors, &system, &any));
    pw85_neighbors_destroy(neighbors);
}

PW85_TEST("/causes/meshes")
{
    double const corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    unsigned char overlap = 0;
    std::int32_t const triangle[] = {0, 1, 2};
    pw85_mesh *mesh = nullptr;
    Expected{"pw85_mesh_create", "num_vertices",
             "must be below 2³¹"}(pw85_mesh_create(too_many, corners, 1, triangle, &mesh));
    Expected{"pw85_mesh_create", "num_triangles",
             "must be below 2³¹"}(pw85_mesh_create(3, corners, too_many, triangle, &mesh));
    g_assert_cmpint(pw85_mesh_create(3, corners, 1, triangle, &mesh), ==, PW85_SUCCESS);
    Expected{"pw85_mesh_overlap_batch", "n",
             "must be small enough for the bytes of each array to fit ptrdiff_t"}(
        pw85_mesh_overlap_batch(mesh, SIZE_MAX, corners, unit_form, &overlap));
    pw85_mesh_destroy(mesh);
    Simulation const one({4, 4, 4});
    double const wide[] = {0, 0, 0, 999, 0, 0, 0, 1, 0};
    Expected const set{"pw85_hard_ellipsoids_set_mesh", "vertices",
                       "must be within 16 periods of the cell"};
    set(pw85_hard_ellipsoids_set_mesh(one, 3, wide, 1, triangle, nullptr));
    Expected{"pw85_hard_ellipsoids_set_mesh", "num_vertices", "must be below 2³¹"}(
        pw85_hard_ellipsoids_set_mesh(one, too_many, wide, 1, triangle, nullptr));
    Expected{"pw85_hard_ellipsoids_set_mesh", "num_triangles", "must be below 2³¹"}(
        pw85_hard_ellipsoids_set_mesh(one, 3, wide, too_many, triangle, nullptr));
    Expected{"pw85_hard_ellipsoids_set_mesh", "triangles", "must not be set in two dimensions"}(
        pw85_hard_ellipsoids_set_mesh(in_plane(), 3, corners, 1, triangle, nullptr));
    g_assert_cmpint(pw85_hard_ellipsoids_set_mesh(one, 3, corners, 1, triangle, nullptr), ==,
                    PW85_SUCCESS);
    Expected{"pw85_hard_ellipsoids_volume_moves", "simulation", "must have no mesh"}(
        pw85_hard_ellipsoids_volume_moves(one, 1, 1.0, PW85_CHANGE_ISOTROPIC));
}

/// A member of a wall or field that is refused: what the record must say of it.
template <class Row> struct RefusedMember {
    Row row;
    char const *member, *requirement;
    std::size_t entry = 0;
    double value = NAN; ///< NaN also if the cause is not one entry
};

/// Expects that set(one), which sets a good row and then the bad one, names the bad one.
template <class Row, class Set>
void expect_member(char const *function, RefusedMember<Row> const &one, Set const &set)
{
    if (set(one.row) != PW85_EINVAL) g_error("%s: %s %s", function, one.member, one.requirement);
    expect_cause(function, one.member, one.requirement, 1, one.entry, one.value);
}

PW85_TEST("/causes/walls")
{
    Simulation const open({0, 0, 0}, nullptr, {0, 0, 0}), flat = in_plane(), periodic({4, 4, 4});
    auto const refuse = [](pw85_hard_ellipsoids *simulation, RefusedMember<pw85_wall> const &one,
                           pw85_wall const &good) {
        expect_member("pw85_hard_ellipsoids_set_walls", one, [&](pw85_wall const &bad) {
            pw85_wall const both[] = {good, bad};
            return pw85_hard_ellipsoids_set_walls(simulation, 2, both, nullptr);
        });
    };
    constexpr double inf = INFINITY;
    constexpr char radius[] = "must be a radius > 0 whose square is finite and not 0";
    RefusedMember<pw85_wall> const in_space[] = {
        {{9, {}, {}, 1}, "kind", "must be from 0 to 3, PW85_WALL_...", 0, 9},
        {{-1, {}, {}, 1}, "kind", "must be from 0 to 3, PW85_WALL_...", 0, -1},
        {{PW85_WALL_PLANE, {}, {0, 0, inf}, 9},
         "vector",
         "must be a normal that is finite and not zero",
         2,
         inf},
        {{PW85_WALL_PLANE, {}, {0, 0, 0}, 9},
         "vector",
         "must be a normal that is finite and not zero"},
        {{PW85_WALL_PLANE, {}, {0, 0, 1}, -inf},
         "size",
         "must be an offset that is finite",
         0,
         -inf},
        {{PW85_WALL_SPHERE, {0, NAN, 0}, {}, 9}, "point", "must be a center that is finite", 1},
        {{PW85_WALL_SPHERE, {}, {}, 0}, "size", radius, 0, 0},
        {{PW85_WALL_SPHERE, {}, {}, 1e-200}, "size", radius, 0, 1e-200},
        {{PW85_WALL_CYLINDER, {inf, 0, 0}, {0, 0, 1}, 9},
         "point",
         "must be a point that is finite",
         0,
         inf},
        {{PW85_WALL_CYLINDER, {}, {0, 0, 0}, 9},
         "vector",
         "must be an axis that is finite and not zero"},
        {{PW85_WALL_CYLINDER, {}, {0, 0, 1}, -9}, "size", radius, 0, -9},
        {{PW85_WALL_BOX, {0, 0, -inf}, {1, 1, 1}, 0},
         "point",
         "must be a lower corner that is finite",
         2,
         -inf},
        {{PW85_WALL_BOX, {}, {1, inf, 1}, 0},
         "vector",
         "must be an upper corner that is finite",
         1,
         inf},
        {{PW85_WALL_BOX, {1, 1, 1}, {-1, 2, 2}, 0}, "walls", "must have lower <= upper corners"}};
    for (auto const &one : in_space) refuse(open, one, {PW85_WALL_SPHERE, {}, {}, 9});
    RefusedMember<pw85_wall> const in_the_plane[] = {
        {{PW85_WALL_PLANE, {}, {0, 1, 1}, 9},
         "vector",
         "must be a normal without z in two dimensions",
         2,
         1},
        {{PW85_WALL_CYLINDER, {}, {1, 0, 1}, 9},
         "vector",
         "must be an axis along z in two dimensions"}};
    for (auto const &one : in_the_plane) refuse(flat, one, {PW85_WALL_CYLINDER, {}, {0, 0, 1}, 9});
    pw85_wall const across{PW85_WALL_PLANE, {}, {0, 0, 1}, 9};
    Expected{"pw85_hard_ellipsoids_set_walls", "walls",
             "must be the same in all images of the cell"}(
        pw85_hard_ellipsoids_set_walls(periodic, 1, &across, nullptr));
}

/// Walls that cut the first particle: with its centre in the wall, the wall's numbers are told.
PW85_TEST("/causes/cuts")
{
    Simulation const open({5, 6, 7}, nullptr, {0, 0, 0}), flat = in_plane();
    constexpr char cut[] = "must not cut a particle: move one of them",
                   plane[] = "must not have a particle in them, where normal·x >= offset: correct "
                             "the numbers of the wall, or move the particle",
                   round[] = "must not have a particle in them, beyond the radius: correct the "
                             "numbers of the wall, or move the particle",
                   box[] = "must not have a particle in them, outside of the box: correct the "
                           "numbers of the wall, or move the particle";
    struct {
        pw85_hard_ellipsoids *simulation;
        pw85_wall wall;
        char const *requirement;
    } const cases[] = {
        {open, {PW85_WALL_PLANE, {}, {0, 0, 2}, 15}, cut},
        {open, {PW85_WALL_PLANE, {}, {0, 0, 2}, 14}, plane},
        {open, {PW85_WALL_PLANE, {}, {0, 0, -2}, -15}, plane},
        {open, {PW85_WALL_SPHERE, {5, 6, 7.25}, {}, 0.5}, cut},
        {open, {PW85_WALL_SPHERE, {5, 6, 9}, {}, 2}, round},
        {open, {PW85_WALL_CYLINDER, {5, 6.25, -99}, {0, 0, 3}, 0.5}, cut},
        {open, {PW85_WALL_CYLINDER, {5, 9, -99}, {0, 0, 3}, 2}, round},
        {open, {PW85_WALL_BOX, {4.5, 0, 0}, {99, 99, 99}, 0}, cut},
        {open, {PW85_WALL_BOX, {0, 0, 0}, {99, 5, 99}, 0}, box},
        {open, {PW85_WALL_BOX, {0, 0, 8}, {99, 99, 99}, 0}, box},
        {flat, {PW85_WALL_SPHERE, {0, 0, 99}, {}, 0.5}, cut},
        {flat, {PW85_WALL_SPHERE, {99, 0, 0}, {}, 9}, round},
        {flat, {PW85_WALL_BOX, {-0.5, -9, 99}, {9, 9, 99}, 0}, cut},
    };
    for (auto const &[simulation, wall, requirement] : cases) {
        pw85_wall const both[] = {{PW85_WALL_BOX, {-1e3, -1e3, -1e3}, {1e3, 1e3, 1e3}, 0}, wall};
        int32_t overlap[2];
        Expected{"pw85_hard_ellipsoids_set_walls", "walls", requirement,
                 1}(pw85_hard_ellipsoids_set_walls(simulation, 2, both, overlap), PW85_EOVERLAP);
        g_assert_cmpint(overlap[0], ==, 0);
        g_assert_cmpint(overlap[1], ==, 1);
    }
    constexpr double corners[] = {4, 6, 7, 6, 6, 7, 5, 7, 7};
    constexpr int32_t triangles[] = {0, 1, 2};
    Expected{"pw85_hard_ellipsoids_set_mesh", "triangles", cut}(
        pw85_hard_ellipsoids_set_mesh(open, 3, corners, 1, triangles, nullptr), PW85_EOVERLAP);
}

PW85_TEST("/causes/fields")
{
    Simulation const one({4, 4, 4});
    constexpr char direction[] = "must be a direction whose square is finite and not 0";
    RefusedMember<pw85_field> const refused[] = {
        {{9, 0, {}, {1, 0, 0}, 1}, "kind", "must be from 0 to 3, PW85_FIELD_...", 0, 9},
        {{PW85_FIELD_ALIGNING, 3, {}, {1, 0, 0}, 1}, "axis", "must be from 0 to 2", 0, 3},
        {{PW85_FIELD_LINEAR, 0, {}, {0, NAN, 0}, 1},
         "vector",
         "must be a gradient that is finite",
         1},
        {{PW85_FIELD_WEIGHT, 0, {}, {0, 0, INFINITY}, 1},
         "vector",
         "must be a gradient that is finite",
         2,
         INFINITY},
        {{PW85_FIELD_HARMONIC, 0, {INFINITY, 0, 0}, {1, 0, 0}, 1},
         "point",
         "must be a center that is finite",
         0,
         INFINITY},
        {{PW85_FIELD_HARMONIC, 0, {}, {NAN, 0, 0}, 1},
         "vector",
         "must be a stiffness that is finite"},
        {{PW85_FIELD_ALIGNING, 0, {}, {0, 0, 0}, 1}, "vector", direction},
        {{PW85_FIELD_ALIGNING, 0, {}, {1e200, 0, 0}, 1}, "vector", direction},
        {{PW85_FIELD_ALIGNING, 0, {}, {1, 0, 0}, NAN}, "strength", "must be finite"},
        {{PW85_FIELD_LINEAR, 0, {}, {1, 0, 0}, 1},
         "fields",
         "must be the same in all images of the cell"}};
    for (auto const &field : refused)
        expect_member("pw85_hard_ellipsoids_set_fields", field, [&](pw85_field const &bad) {
            pw85_field const both[] = {{PW85_FIELD_ALIGNING, 0, {}, {1, 0, 0}, 1}, bad};
            return pw85_hard_ellipsoids_set_fields(one, 2, both);
        });
}

double constant(void *context, int32_t, double const *, double const *, double const *)
{
    return *static_cast<double *>(context);
}

PW85_TEST("/causes/potentials")
{
    double energy = 1.0;
    auto const set = [&](pw85_hard_ellipsoids *one) {
        return pw85_hard_ellipsoids_set_potential(one, constant, &energy);
    };
    Simulation const one({4, 4, 4});
    g_assert_cmpint(set(one), ==, PW85_SUCCESS);
    Expected const sweep{"pw85_hard_ellipsoids_sweep", "potential",
                         "must not return NaN or -infinity"};
    energy = NAN;
    sweep(pw85_hard_ellipsoids_sweep(one, 1), PW85_EPOTENTIAL);
    std::vector<unsigned char> bytes(pw85_hard_ellipsoids_num_bytes(one));
    Expected{"pw85_hard_ellipsoids_save", "num_bytes", "must be pw85_hard_ellipsoids_num_bytes()"}(
        pw85_hard_ellipsoids_save(one, 1, bytes.data()));
    Expected{"pw85_hard_ellipsoids_save", "potential",
             "must give an energy that is finite, because it is saved"}(
        pw85_hard_ellipsoids_save(one, bytes.size(), bytes.data()), PW85_EPOTENTIAL);
    energy = 1.0;
    g_assert_cmpint(pw85_hard_ellipsoids_save(one, bytes.size(), bytes.data()), ==, PW85_SUCCESS);
    pw85_hard_ellipsoids *restored = nullptr;
    Expected{"pw85_hard_ellipsoids_restore", "bytes",
             "must be complete: num_bytes differs from the number in the state"}(
        pw85_hard_ellipsoids_restore(bytes.size() - 1, bytes.data(), &restored));
    g_assert_cmpint(pw85_hard_ellipsoids_restore(bytes.size(), bytes.data(), &restored), ==,
                    PW85_SUCCESS);
    Expected{"pw85_hard_ellipsoids_sweep", "potential",
             "must be set again after the state is restored"}(
        pw85_hard_ellipsoids_sweep(restored, 1), PW85_EPOTENTIAL);
    energy = 2.0;
    Expected{"pw85_hard_ellipsoids_set_potential", "potential",
             "must be that of the restored state: their energies differ"}(set(restored));
    pw85_hard_ellipsoids_destroy(restored);
}

PW85_TEST("/causes/laws")
{
    Simulation const one({4, 4, 4});
    auto const refuse = [&](std::initializer_list<double> x, char const *argument, char const *text,
                            std::size_t entry = 0) {
        pw85_law const law{PW85_LAW_INVERSE_POWERS, x.size(), x.begin()};
        Expected{"pw85_hard_ellipsoids_set_law", argument, text, 0,
                 entry}(pw85_hard_ellipsoids_set_law(one, &law));
    };
    refuse({4, 6, 4, 12, 2}, "parameters", "must have exponents n > m > 0", 1);
    refuse({4, 12, 4, 6, 1}, "parameters",
           "must have a cutoff above μ² = 1, where hard cores touch", 4);
    double const soft[] = {1, 2};
    pw85_law const repulsion{PW85_LAW_SOFT_REPULSION, 2, soft};
    Expected{"pw85_hard_ellipsoids_set_law", "law",
             "must not be a soft repulsion, which ends where the hard cores begin: use inverse "
             "powers or a table"}(pw85_hard_ellipsoids_set_law(one, &repulsion));
    refuse({4, 12, 4, 6, 0x1.e848000000001p19}, "law", "must have a cutoff of at most 10⁶ in μ²");
    double const longest[] = {4, 12, 4, 6, 1e6};
    pw85_law const far_reaching{PW85_LAW_INVERSE_POWERS, 5, longest};
    g_assert_cmpint(pw85_hard_ellipsoids_set_law(one, &far_reaching), ==, PW85_SUCCESS);
    g_assert_cmpint(pw85_hard_ellipsoids_set_law(one, nullptr), ==, PW85_SUCCESS);
    refuse({1e30, 12, 4, 6, 2}, "law", "must have energies of pairs of at most 2²⁰ k_B T");
}

PW85_TEST("/causes/trials")
{
    Simulation const one({4, 4, 4}), flat = in_plane();
    double const far[] = {1e300, 0, 0}, above[] = {0, 0, 1}, lying[] = {1, 1, 0, 0},
                 no_moves[4] = {};
    int is_free = 0;
    double factor = 0.0;
    Expected{"pw85_hard_ellipsoids_volume_moves", "change", "must be a constant PW85_CHANGE_..."}(
        pw85_hard_ellipsoids_volume_moves(one, 1, 1.0, 9));
    Expected{"pw85_hard_ellipsoids_volume_moves", "pressure",
             "must be > 0"}(pw85_hard_ellipsoids_volume_moves(one, 1, 0.0, PW85_CHANGE_ISOTROPIC));
    Expected{"pw85_hard_ellipsoids_volume_moves", "simulation",
             "must have a cell that is periodic along its first two vectors"}(
        pw85_hard_ellipsoids_volume_moves(flat, 1, 1.0, PW85_CHANGE_ISOTROPIC));
    Expected{"pw85_hard_ellipsoids_set_fractions", "fractions",
             "must have a sum that is > 0 and finite"}(
        pw85_hard_ellipsoids_set_fractions(one, no_moves));
    Expected{"pw85_hard_ellipsoids_set_dimensions", "dimensions",
             "must be 2 or 3"}(pw85_hard_ellipsoids_set_dimensions(one, 4));
    Expected{"pw85_hard_ellipsoids_try", "center",
             "must not be too far away from the cell for its images"}(
        pw85_hard_ellipsoids_try(one, 0, far, nullptr, 0, &is_free));
    Expected{"pw85_hard_ellipsoids_try", "center", "must be in the plane of the ellipses", 0,
             2}(pw85_hard_ellipsoids_try(flat, 0, above, nullptr, 0, &is_free));
    Expected{"pw85_hard_ellipsoids_try", "quaternion",
             "must be a rotation about z, which keeps the ellipse in its plane"}(
        pw85_hard_ellipsoids_try(flat, 0, nullptr, lying, 0, &is_free));
    Expected{"pw85_hard_ellipsoids_chain", "direction", "must be in the plane", 0,
             2}(pw85_hard_ellipsoids_chain(flat, 1, 1.0, above, nullptr));
    pw85_field const field{PW85_FIELD_ALIGNING, 0, {}, {1, 0, 0}, 1};
    g_assert_cmpint(pw85_hard_ellipsoids_set_fields(one, 1, &field), ==, PW85_SUCCESS);
    Expected{"pw85_hard_ellipsoids_chain", "simulation",
             "must have no walls, mesh, fields, potential or law: use sweeps"}(
        pw85_hard_ellipsoids_chain(one, 1, 1.0, nullptr, nullptr));
    Expected{"pw85_hard_ellipsoids_compress", "simulation",
             "must have no walls, mesh, fields or potential"}(
        pw85_hard_ellipsoids_compress(one, 0, &factor));
    Simulation const two({0, 0, 0, 4, 0, 0});
    Expected{"pw85_hard_ellipsoids_chain", "length",
             "must let chains advance: particles block each other within rounding errors, or the "
             "length is too long"}(pw85_hard_ellipsoids_chain(two, 1, 1e300, nullptr, nullptr),
                                   PW85_ECONVERGENCE);
}

PW85_TEST("/causes/kinds")
{
    Simulation const one({4, 4, 4});
    double const same[] = {1, 1, 1, 1, 1, 1}, steps[] = {0.1, 0.1, 0.1, 0.1},
                 long_steps[] = {99, 0.1};
    std::vector<double> const many(17 * 3, 1.0);
    Expected{"pw85_hard_ellipsoids_set_kind_steps", "num_kinds", "must be at most 16"}(
        pw85_hard_ellipsoids_set_kind_steps(one, 17, many.data(), many.data()));
    Expected{"pw85_hard_ellipsoids_set_kind_steps", "semi_axes", "must differ from those before",
             1}(pw85_hard_ellipsoids_set_kind_steps(one, 2, same, steps));
    Expected{"pw85_hard_ellipsoids_set_kind_steps", "steps",
             "must be at most the longest vector of the cell"}(
        pw85_hard_ellipsoids_set_kind_steps(one, 1, same, long_steps));
    double const activities[] = {1, 1};
    Expected{"pw85_hard_ellipsoids_insertion_moves", "semi_axes", "must differ from those before",
             1}(pw85_hard_ellipsoids_insertion_moves(one, 1, 2, same, activities, nullptr));
    Expected{"pw85_hard_ellipsoids_insertion_moves", "num_kinds", "must be > 0 and below 2³¹"}(
        pw85_hard_ellipsoids_insertion_moves(one, 1, 0, same, activities, nullptr));
}

PW85_TEST("/causes/random_addition")
{
    char const *const create = "pw85_random_addition_create";
    double const none = std::nan(""), ball[] = {1, 1, 1}, two[] = {1, 1, 1, 1, 0, 1},
                 needle[] = {1, 1, 1, 1, 0x1p-23, 1}, small[] = {1, 1, 1, 0x1p-481, 1, 1};
    pw85_random_addition *made = nullptr;
    auto const make = [&](int dimensions, double const *rows, std::size_t num_kinds,
                          double const *all) {
        made = reinterpret_cast<pw85_random_addition *>(&made);
        int const status = pw85_random_addition_create(dimensions, rows, num_kinds, all, 1, &made);
        g_assert_true((made == nullptr) == (status != PW85_SUCCESS));
        return status;
    };
    double wide[] = {9, 0, 0, 0, 9, 0, 0, 0, 9};
    Expected{create, "dimensions", "must be 2 or 3"}(make(4, wide, 1, ball));
    Expected{create, "num_kinds", "must be > 0 and below 2³¹"}(make(3, wide, 0, ball));
    Expected{create, "num_kinds", "must be > 0 and below 2³¹"}(make(3, wide, too_many, ball));
    Expected{create, "cell", "must not be null"}(make(3, nullptr, 1, ball));
    Expected{create, "semi_axes", "must not be null"}(make(3, wide, 1, nullptr));
    Expected{create, "semi_axes", "must be > 0", 1, 1}(make(3, wide, 2, two));
    Expected{create, "semi_axes", "must be at least 2⁻⁴⁸⁰ times the longest semi-axis",
             1}(make(3, wide, 2, small));
    Expected{create, "semi_axes",
             "must have a ratio below 2²³, or rounding may make the form indefinite",
             1}(make(2, wide, 2, needle), PW85_ENOTPD);
    for (int const i : {2, 5, 6, 7}) {
        wide[i] = 0.25;
        Expected{create, "cell",
                 "must have two vectors in the plane of x and y and one along z, in two dimensions",
                 0, static_cast<std::size_t>(i)}(make(2, wide, 1, ball));
        wide[i] = 0;
    }
    for (double const edge : {1.99, 2 + 1e-9, 0.0}) {
        wide[4] = edge;
        for (int const dimensions : {2, 3})
            Expected{create, "cell",
                     "must have opposite faces that are farther apart than the longest diameter of "
                     "a particle"}(make(dimensions, wide, 1, ball));
    }
    wide[4] = 0x1p302;
    Expected{create, "cell", "must have no coordinate above 2²⁵⁰ times the longest semi-axis", 0,
             3}(make(3, wide, 1, ball));
    wide[4] = none;
    Expected{create, "cell", "must be finite", 0, 4}(make(3, wide, 1, ball));
    wide[4] = 2.00001;
    g_assert_cmpint(make(2, wide, 1, ball), ==, PW85_SUCCESS);

    char const *const advance = "pw85_random_addition_advance";
    int end = 0;
    Expected{advance, "attempts", "must be > 0"}(pw85_random_addition_advance(made, 0, 1, &end));
    g_assert_cmpint(end, ==, -1);
    Expected{advance, "attempts",
             "must not be NaN"}(pw85_random_addition_advance(made, none, 1, &end));
    Expected{advance, "attempts",
             "must be > 0"}(pw85_random_addition_advance(made, -INFINITY, 1, &end));
    Expected{advance, "num_particles",
             "must be > 0 and below 2³¹"}(pw85_random_addition_advance(made, INFINITY, 0, &end));
    Expected{advance, "num_particles", "must be > 0 and below 2³¹"}(
        pw85_random_addition_advance(made, INFINITY, too_many, &end));
    Expected{advance, "addition",
             "must not be null"}(pw85_random_addition_advance(nullptr, INFINITY, 1, &end));
    g_assert_cmpint(pw85_random_addition_advance(made, INFINITY, 1, &end), ==, PW85_SUCCESS);
    double centers[6];
    Expected{
        "pw85_random_addition_particles",
        "num_particles",
        "must be the number of particles of the addition",
        0,
        0,
    }(pw85_random_addition_particles(made, 2, centers, nullptr, nullptr));
    Expected{"pw85_random_addition_particles", "centers", "must not be null"}(
        pw85_random_addition_particles(made, 1, nullptr, nullptr, nullptr));
    Expected{"pw85_random_addition_state", "num_particles",
             "must not be null"}(pw85_random_addition_state(made, nullptr, nullptr, nullptr));
    g_assert_cmpint(pw85_random_addition_particles(made, 1, centers, nullptr, nullptr), ==,
                    PW85_SUCCESS);
    g_assert_true(centers[2] == 0);
    pw85_random_addition_destroy(made);
    pw85_random_addition_destroy(nullptr);
}

PW85_TEST("/causes/insertions")
{
    Simulation const one({4, 4, 4}), open({0, 0, 0}, nullptr, {0, 0, 0});
    double const large[] = {1, 1, 999}, far[] = {1e300, 0, 0}, lying[] = {1, 1, 0, 0},
                 flat_axes[] = {1, 1, 1e-12}, turned[] = {1, 2, 2, 0}, away[] = {0, 4, 0};
    double weight = 0.0;
    int is_free = 0;
    Expected{"pw85_hard_ellipsoids_insertion_weight", "simulation",
             "must have a cell with independent vectors"}(
        pw85_hard_ellipsoids_insertion_weight(open, 1, axes, &weight));
    Expected{"pw85_hard_ellipsoids_insertion_weight", "semi_axes",
             "must be at most 32 times the shortest vector of the lattice, with a law of pairs "
             "also if enlarged by its reach"}(
        pw85_hard_ellipsoids_insertion_weight(one, 1, large, &weight));
    Expected{"pw85_hard_ellipsoids_insert", "center",
             "must not be too far away from the cell for its images"}(
        pw85_hard_ellipsoids_insert(one, far, upright, axes, 0, &is_free));
    Expected{"pw85_hard_ellipsoids_insert", "semi_axes",
             "must give a form that is positive definite"}(
        pw85_hard_ellipsoids_insert(one, origin, turned, flat_axes, 0, &is_free), PW85_ENOTPD);
    Expected{"pw85_hard_ellipsoids_insert", "quaternion", "must be a rotation about z"}(
        pw85_hard_ellipsoids_insert(in_plane(), away, lying, axes, 0, &is_free));
}

PW85_TEST("/causes/states")
{
    pw85_hard_ellipsoids *made = nullptr;
    pw85_system const many{too_many, origin, nullptr, cube, {1, 1, 1}};
    Expected{"pw85_hard_ellipsoids_create", "num_particles", "must be below 2³¹"}(
        pw85_hard_ellipsoids_create(&many, axes, upright, 1, nullptr, &made));
    auto const refuse = [](pw85_hard_ellipsoids *one, char const *argument, char const *text,
                           std::size_t row, std::size_t entry) {
        Expected{"pw85_hard_ellipsoids_set_dimensions", argument, text, row,
                 entry}(pw85_hard_ellipsoids_set_dimensions(one, 2));
    };
    Simulation const high({0, 0, 0, 4, 0, 1}), one({4, 4, 4}), open({0, 0, 0}, nullptr, {0, 0, 0});
    double const lying[] = {1, 1, 0, 0};
    int is_free = 0;
    refuse(high, "centers", "must all have the same z in two dimensions", 1, 2);
    refuse(one, "cell",
           "must have its first two vectors in the plane, and the third along z and not periodic",
           0, 0);
    g_assert_cmpint(pw85_hard_ellipsoids_try(open, 0, nullptr, lying, 1, &is_free), ==,
                    PW85_SUCCESS);
    refuse(open, "quaternions", "must be rotations about z in two dimensions", 0, 1);
}

} // namespace

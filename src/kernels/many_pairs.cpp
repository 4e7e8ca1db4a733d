// SPDX-License-Identifier: BSD-3-Clause
// The functions of many pairs of the C API that use lanes. They check the arguments of a call, choose the images, and call the
// driver (many_pairs.hpp).
#include <pw85.h>
#include <pw85_batch.h>
#include <pw85_systems.h>

#include <cmath>

#include "../c_arrays.hpp"
#include "each_row.hpp"
#include "forces.hpp"
#include "image_finder.hpp"
#include "image_limit.hpp"
#include "law_forces.hpp"
#include "many_pairs.hpp"
#include "periodic_cell.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::kernels;
using pw85::detail::c_api::any_null;

namespace {

/// The smallest number that is not an index of a particle.
std::uint32_t end_of(std::size_t num_particles) noexcept
{
    return static_cast<std::uint32_t>(std::min<std::size_t>(num_particles, INT32_MAX + std::size_t{1}));
}

/// Whether n indices are at least 0 and below `end`. `end` is at most 2³¹, so the test is that neither an index nor `end` - 1 -
/// index has the sign bit. The baseline instructions have no comparison of packed unsigned numbers.
bool are_below(std::uint32_t end, std::int32_t const *indices, std::size_t n) noexcept
{
    std::uint32_t signs = 0;
    for (std::size_t k = 0; k < n; ++k) {
        auto const index = static_cast<std::uint32_t>(indices[k]);
        signs |= index | (end - 1 - index);
    }
    return signs >> 31 == 0;
}

/// Whether all indices of the pairs are in range.
bool are_valid(std::size_t num_pairs, std::int32_t const *pairs, std::size_t num_particles) noexcept
{
    auto const end = end_of(num_particles);
    return for_all(num_pairs, [=](Range range) {
               bool const valid = are_below(end, pairs + 2 * range.begin, 2 * (range.end - range.begin));
               return Failure{range.begin, valid ? PW85_SUCCESS : PW85_EINVAL};
           }) == PW85_SUCCESS;
}

/// Finds the earliest time among the pairs of each particle, and the pair.
void find_next(std::size_t num_pairs, std::int32_t const *pairs, double const *t, std::size_t num_particles,
               double *next, std::int64_t *next_pair) noexcept
{
    if (next == nullptr) return;
    std::fill_n(next, num_particles, HUGE_VAL);
    if (next_pair != nullptr) std::fill_n(next_pair, num_particles, -1);
    for (std::size_t k = 0; k < 2 * num_pairs; ++k) {
        double &least = next[pairs[k]];
        if (!(t[k / 2] < least)) continue;
        least = t[k / 2];
        if (next_pair != nullptr) next_pair[pairs[k]] = static_cast<std::int64_t>(k / 2);
    }
}

/// Prepares the images of a system's particles: those that the caller gives, or else the nearest ones.
int prepare_images(pw85_system const &system, bool given, Images &images) noexcept
{
    bool const prepared = in_default_environment([&] { return prepare(system.cell, system.periodic, given, images); });
    return prepared ? PW85_SUCCESS : PW85_EINVAL;
}

/// Checks the arguments that the functions of lists share, and converts them for the kernels. `made` points into `images`.
int prepare_list(pw85_pair_list const &list, pw85_system const &system, Images &images, NeighborList &made) noexcept
{
    if (list.num_pairs > max_rows || system.num_particles > max_rows) return PW85_EINVAL;
    if (any_null(list.pairs) || any_null(system.centers, system.q)) return PW85_EINVAL;
    if (int const status = prepare_images(system, list.images != nullptr, images)) return status;
    made = {list.pairs, system.centers, system.q, list.images, images.cell, images.nearest ? &images.lattice : nullptr};
    return are_valid(list.num_pairs, list.pairs, system.num_particles) ? PW85_SUCCESS : PW85_EINVAL;
}

/// A system for functions that read no forms. Its pointer to the forms is that to the centres, so that it is not null.
pw85_system without_forms(pw85_system const &system) noexcept
{
    pw85_system rest = system;
    rest.q = system.centers;
    return rest;
}

/// Computes the pairs of a neighbour list that is not empty.
template <class Arrays>
int compute_list(pw85_pair_list const &list, pw85_system const &system, Arrays const &out) noexcept
{
    Images images;
    NeighborList rows;
    if (int const status = prepare_list(list, system, images, rows)) return status;
    return compute_all(list.num_pairs, rows, out);
}

/// Whether a law has the parameters of its kind, with values that the kind allows.
bool is_valid(pw85_law const &law) noexcept
{
    std::size_t const n = law.num_parameters;
    double const *const x = law.parameters;
    if (any_null(x) || n > max_rows || !std::all_of(x, x + n, [](double number) { return std::isfinite(number); }))
        return false;
    switch (law.kind) {
    case PW85_LAW_SOFT_REPULSION:
        return n == 2 && x[1] >= 1.0;
    case PW85_LAW_INVERSE_POWERS:
        return n == 5 && x[1] > x[3] && x[3] > 0.0 && x[4] > 0.0;
    case PW85_LAW_TABLE:
        return n >= 6 && n % 2 == 0 && x[1] > x[0];
    default:
        return false;
    }
}

/// The law with the shift by which its energy at the cutoff is 0.
InversePowers shifted(InversePowers law) noexcept
{
    double d_u;
    InversePowers everywhere = law;
    everywhere.mu2_max = HUGE_VAL;
    LawKernel<InversePowers> const &kernel = *chosen().lanes;
    in_default_environment([&] { law.shift = kernel.evaluate(everywhere, 1, &law.mu2_max, &d_u).energy; });
    return law;
}

/// find_overlap() for one ellipsoid and n others of a system, with the images that the caller gives, or else the nearest ones. If no
/// nearest image overlaps but a farther one could, it returns an error.
int overlap_any_images(OneToIndexed rows, pw85_system const &system, std::size_t n, int &any) noexcept
{
    Images images;
    if (int const status = prepare_images(system, rows.images != nullptr, images)) return status;
    rows.cell = images.cell;
    rows.lattice = images.nearest ? &images.lattice : nullptr;
    return in_default_environment([&] {
        int const status = find_overlap(rows, n, any);
        if (any != 0 || rows.lattice == nullptr || nearest_images_suffice(rows, n)) return status;
        any = -1;
        return int{PW85_EINVAL};
    });
}

} // namespace

int pw85_contact_batch(size_t n, double const *r12, double const *q1, double const *q2, double *mu2, double *lambda)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(r12, q1, q2, mu2)) return PW85_EINVAL;
    return compute_all(n, PairArrays<3>{r12, q1, q2}, ContactArrays{mu2, lambda});
}

int pw85_overlap_batch(size_t n, double const *r12, double const *q1, double const *q2, unsigned char *overlap)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(r12, q1, q2, overlap)) return PW85_EINVAL;
    return compute_all(n, PairArrays<3>{r12, q1, q2}, OverlapArray{overlap});
}

int pw85_contact_batch_2d(size_t n, double const *r12, double const *q1, double const *q2, double *mu2, double *lambda)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(r12, q1, q2, mu2)) return PW85_EINVAL;
    return compute_all(n, PairArrays<2>{r12, q1, q2}, ContactArrays{mu2, lambda});
}

int pw85_overlap_batch_2d(size_t n, double const *r12, double const *q1, double const *q2, unsigned char *overlap)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(r12, q1, q2, overlap)) return PW85_EINVAL;
    return compute_all(n, PairArrays<2>{r12, q1, q2}, OverlapArray{overlap});
}

int pw85_closest_passage_batch(size_t n, double const *r12, double const *q1, double const *q2, double const *velocity,
                               double t_max, double *mu2, double *t)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(r12, q1, q2, velocity, mu2)) return PW85_EINVAL;
    return compute_all(n, PairArrays<3>{r12, q1, q2}, PassageArrays{mu2, t, velocity, t_max});
}

int pw85_closest_approach_batch(size_t n, double const *directions, double const *q1, double const *q2,
                                double *distance)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(directions, q1, q2, distance)) return PW85_EINVAL;
    return compute_all(n, Directions{{directions, q1, q2}}, ApproachArray{distance});
}

int pw85_contact_derivatives_batch(size_t n, double const *r12, double const *q1, double const *q2, double *mu2,
                                   double *lambda, double *point, double *normal, double *d_r12, double *d_rot1,
                                   double *d_rot2)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(r12, q1, q2)) return PW85_EINVAL;
    return compute_all(n, PairArrays<3>{r12, q1, q2},
                       DerivativeArrays{mu2, lambda, point, normal, d_r12, d_rot1, d_rot2});
}

int pw85_distance_batch(size_t n, double const *r12, double const *q1, double const *q2, double *distance,
                        double *point1, double *point2)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(r12, q1, q2)) return PW85_EINVAL;
    return compute_all(n, PairArrays<3>{r12, q1, q2}, DistanceArrays{distance, point1, point2});
}

int pw85_overlap_any(double const q1[PW85_SYM], size_t n, double const *r12, double const *q2, int *any)
{
    if (any_null(any)) return PW85_EINVAL;
    *any = 0;
    if (n == 0) return PW85_SUCCESS;
    *any = -1;
    if (n > max_rows || any_null(q1, r12, q2)) return PW85_EINVAL;
    return in_default_environment([&] { return find_overlap(OneToMany{q1, r12, q2}, n, *any); });
}

int pw85_overlap_any_indices(double const center[PW85_DIM], double const q1[PW85_SYM], pw85_system const *system,
                             size_t n, int32_t const *indices, int32_t const *images, int *any)
{
    if (any_null(any)) return PW85_EINVAL;
    bool const none = n == 0 && !any_null(system) && any_null(system->cell);
    *any = none ? 0 : -1;
    if (none) return PW85_SUCCESS;
    if (any_null(system)) return PW85_EINVAL;
    if (n > max_rows || system->num_particles > max_rows || any_null(center, q1)) return PW85_EINVAL;
    if (n > 0 && (any_null(indices) || any_null(system->centers, system->q))) return PW85_EINVAL;
    if (!are_below(end_of(system->num_particles), indices, n)) return PW85_EINVAL;
    return overlap_any_images({center, q1, indices, system->centers, system->q, images, nullptr, nullptr}, *system, n,
                              *any);
}

int pw85_contact_pairs(pw85_pair_list const *list, pw85_system const *system, double *mu2, double *lambda)
{
    if (any_null(list) || any_null(system)) return PW85_EINVAL;
    if (list->num_pairs == 0) return PW85_SUCCESS;
    if (any_null(mu2)) return PW85_EINVAL;
    return compute_list(*list, *system, ContactArrays{mu2, lambda});
}

int pw85_overlap_pairs(pw85_pair_list const *list, pw85_system const *system, unsigned char *overlap)
{
    if (any_null(list) || any_null(system)) return PW85_EINVAL;
    if (list->num_pairs == 0) return PW85_SUCCESS;
    if (any_null(overlap)) return PW85_EINVAL;
    return compute_list(*list, *system, OverlapArray{overlap});
}

int pw85_contact_derivatives_pairs(pw85_pair_list const *list, pw85_system const *system, double *mu2, double *lambda,
                                   double *point, double *normal, double *d_r12, double *d_rot1, double *d_rot2)
{
    if (any_null(list) || any_null(system)) return PW85_EINVAL;
    if (list->num_pairs == 0) return PW85_SUCCESS;
    return compute_list(*list, *system, DerivativeArrays{mu2, lambda, point, normal, d_r12, d_rot1, d_rot2});
}

int pw85_first_contact_pairs(pw85_pair_list const *list, pw85_system const *system, pw85_motion const *motions,
                             double t_max, double *t, double *next, int64_t *next_pair)
{
    if (any_null(list) || any_null(system)) return PW85_EINVAL;
    if (system->num_particles > max_rows || (any_null(next) && !any_null(next_pair))) return PW85_EINVAL;
    Images images;
    NeighborList rows{};
    if (list->num_pairs > 0) {
        if (any_null(t) || any_null(motions)) return PW85_EINVAL;
        if (int const status = prepare_list(*list, *system, images, rows)) return status;
    }
    OnePairKernels const &k = *chosen().one_pair;
    LaneKernel<NeighborList, ContactArrays> const &lanes = *chosen().lanes;
    int const status = for_all(list->num_pairs, [&](Range range) {
        return for_rows(range, [&](std::size_t n) {
            constexpr std::uint16_t first = 0;
            PairRow<3> pair;
            lanes.gather(rows.from(n), &first, 1, &pair);
            return k.first_contact(pair.r12, pair.q1, pair.q2, motions + list->pairs[2 * n],
                                   motions + list->pairs[2 * n + 1], t_max, t + n);
        });
    });
    // Comparing the NaN of bad pairs raises an exception.
    in_default_environment([&] { find_next(list->num_pairs, list->pairs, t, system->num_particles, next, next_pair); });
    return status;
}

int pw85_overlap_volume_pairs(pw85_pair_list const *list, pw85_system const *system, double *volume)
{
    if (any_null(list) || any_null(system)) return PW85_EINVAL;
    if (list->num_pairs == 0) return PW85_SUCCESS;
    if (any_null(volume)) return PW85_EINVAL;
    Images images;
    NeighborList rows;
    if (int const status = prepare_list(*list, *system, images, rows)) return status;
    LaneKernel<NeighborList, ContactArrays> const &lanes = *chosen().lanes;
    auto const measure = [&](std::size_t n) {
        constexpr std::uint16_t first = 0;
        PairRow<3> pair;
        lanes.gather(rows.from(n), &first, 1, &pair);
        return pw85_overlap_volume(pair.r12, pair.q1, pair.q2, volume + n);
    };
    return for_all(
        list->num_pairs, [&](Range range) { return for_rows(range, measure); }, block_of_calls);
}

int pw85_nearest_images(size_t num_pairs, int32_t const *pairs, pw85_system const *system, double *r12, int32_t *images)
{
    if (any_null(system)) return PW85_EINVAL;
    if (num_pairs == 0) return PW85_SUCCESS;
    if (any_null(system->cell)) return PW85_EINVAL;
    Images nearest;
    NeighborList rows;
    if (int const status = prepare_list({num_pairs, pairs, nullptr}, without_forms(*system), nearest, rows))
        return status;
    return for_all(num_pairs, [&](Range range) {
        ImageFinder const finder(rows);
        return for_rows(range, [&](std::size_t pair) {
            return finder.find(pair, row_or_null(r12, 3, pair), row_or_null(images, 3, pair));
        });
    });
}

int pw85_contact_forces_pairs(pw85_pair_list const *list, pw85_system const *system, double const *d_u,
                              double const *d_r12, double const *d_rot1, double const *d_rot2, double *forces,
                              double *torques, double *virial)
{
    if (any_null(list) || any_null(system) || system->num_particles > max_rows) return PW85_EINVAL;
    Images images;
    NeighborList rows{};
    if (list->num_pairs > 0) {
        if (any_null(d_u) || (forces != nullptr && any_null(d_r12)) ||
            (torques != nullptr && any_null(d_rot1, d_rot2)) || (virial != nullptr && any_null(d_r12)))
            return PW85_EINVAL;
        if (int const status = prepare_list(*list, without_forms(*system), images, rows)) return status;
    }
    sum_forces({list->num_pairs, rows, d_u, d_r12, d_rot1, d_rot2}, system->num_particles, {forces, torques, virial});
    return PW85_SUCCESS;
}

int pw85_law_forces_pairs(pw85_pair_list const *list, pw85_system const *system, pw85_law const *law, double *energy,
                          double *forces, double *torques, double *virial)
{
    if (any_null(list) || any_null(system) || any_null(law) || system->num_particles > max_rows) return PW85_EINVAL;
    if (!is_valid(*law)) return PW85_EINVAL;
    Images images;
    NeighborList rows{};
    if (list->num_pairs > 0)
        if (int const status = prepare_list(*list, *system, images, rows)) return status;
    auto const sum = [&](auto const &one) {
        return sum_law(
            LawProblem<std::decay_t<decltype(one)>>{
                list->num_pairs, system->num_particles, rows, one, {forces, torques, virial}},
            energy);
    };
    double const *const x = law->parameters;
    switch (law->kind) {
    case PW85_LAW_SOFT_REPULSION:
        return sum(SoftRepulsion{x[0], x[1]});
    case PW85_LAW_INVERSE_POWERS:
        return sum(shifted({x[0], x[1], x[2], x[3], x[4], 0.0}));
    default:
        return sum(LawTable{x[0], x[1], law->num_parameters / 2 - 2, x + 2});
    }
}

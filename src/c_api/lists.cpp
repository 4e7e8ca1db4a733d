// SPDX-License-Identifier: BSD-3-Clause
// The functions of lists of pairs of the C API, and of one ellipsoid and its neighbours. They check
// the arguments of a call, choose the images, and call the driver (rows/many_pairs.hpp).
#include <pw85.h>
#include <pw85_systems.h>

#include <algorithm>

#include "../base/c_arrays.hpp"
#include "../lists/arguments.hpp"
#include "../lists/image_finder.hpp"
#include "../lists/image_limit.hpp"
#include "../rows/each_row.hpp"
#include "../rows/many_pairs.hpp"
#include "../simd/lanes/derivatives.hpp"
#include "../simd/lanes/overlap.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::kernels;
using pw85::detail::c_api::any_null;

namespace {

/// Finds the earliest time among the pairs of each particle, and the pair.
void find_next(std::size_t num_pairs, std::int32_t const *pairs, double const *t,
               std::size_t num_particles, double *next, std::int64_t *next_pair) noexcept
{
    if (next == nullptr) return;
    std::fill_n(next, num_particles, infinity<double>());
    if (next_pair != nullptr) std::fill_n(next_pair, num_particles, -1);
    for (std::size_t k = 0; k < 2 * num_pairs; ++k) {
        double &least = next[pairs[k]];
        if (!(t[k / 2] < least)) continue;
        least = t[k / 2];
        if (next_pair != nullptr) next_pair[pairs[k]] = static_cast<std::int64_t>(k / 2);
    }
}

/// Computes the pairs of a neighbour list that is not empty.
template <class Arrays> int compute_list(char const *name, pw85_pair_list const &list,
                                         pw85_system const &system, Arrays const &out) noexcept
{
    Images images;
    NeighborList rows{};
    if (int const status = prepare_list(name, list, system, images, rows)) return status;
    return compute_all(list.num_pairs, rows, out);
}

/// find_overlap() for one ellipsoid and n others of a system, with the images that the caller
/// gives, or else the nearest ones. If no nearest image overlaps but a farther one could, it
/// returns an error.
int overlap_any_images(char const *name, OneToIndexed rows, pw85_system const &system,
                       std::size_t n, int &any) noexcept
{
    Images images;
    if (int const status = prepare_images(name, system, rows.images != nullptr, images))
        return status;
    rows.cell = images.cell;
    rows.lattice = images.nearest ? &images.lattice : nullptr;
    return in_default_environment([&] {
        int const status = find_overlap(rows, n, any);
        if (any != 0 || rows.lattice == nullptr || nearest_images_suffice(rows, n)) return status;
        any = -1;
        return refuse(PW85_EINVAL, {0, name, "images",
                                    "must be given, because farther images of "
                                    "the neighbors could overlap",
                                    0, 0, quiet_nan<double>()});
    });
}

} // namespace

int pw85_overlap_any_indices(double const center[PW85_DIM], double const q1[PW85_SYM],
                             pw85_system const *system, size_t n, int32_t const *indices,
                             int32_t const *images, int *any)
{
    if (any_null(any))
        return refuse_arrays("pw85_overlap_any_indices", "n", n, NamedArray{"any", any});
    bool const none = n == 0 && !any_null(system) && any_null(system->cell);
    *any = none ? 0 : -1;
    if (none) return PW85_SUCCESS;
    if (any_null(system))
        return refuse_arrays("pw85_overlap_any_indices", "n", n, NamedArray{"system", system});
    if (system->num_particles > max_rows) return refuse_size("pw85_overlap_any_indices", *system);
    if (n > max_rows || any_null(center, q1))
        return refuse_arrays("pw85_overlap_any_indices", "n", n, NamedArray{"center", center},
                             NamedArray{"q1", q1});
    if (n > 0 && (any_null(indices) || any_null(system->centers, system->q)))
        return refuse_arrays("pw85_overlap_any_indices", "n", n, NamedArray{"indices", indices},
                             NamedArray{"centers", system->centers}, NamedArray{"q", system->q});
    if (!are_below(end_of(system->num_particles), indices, n))
        return refuse_index("pw85_overlap_any_indices", "indices", *system, indices, n, 1);
    return overlap_any_images(
        "pw85_overlap_any_indices",
        {center, q1, indices, system->centers, system->q, images, nullptr, nullptr}, *system, n,
        *any);
}

int pw85_contact_pairs(pw85_pair_list const *list, pw85_system const *system, double *mu2,
                       double *lambda)
{
    if (any_null(list) || any_null(system))
        return refuse_structs("pw85_contact_pairs", list, system);
    if (list->num_pairs == 0) return PW85_SUCCESS;
    if (any_null(mu2))
        return refuse_arrays("pw85_contact_pairs", "num_pairs", list->num_pairs,
                             NamedArray{"mu2", mu2});
    return compute_list("pw85_contact_pairs", *list, *system, ContactArrays{mu2, lambda});
}

int pw85_overlap_pairs(pw85_pair_list const *list, pw85_system const *system,
                       unsigned char *overlap)
{
    if (any_null(list) || any_null(system))
        return refuse_structs("pw85_overlap_pairs", list, system);
    if (list->num_pairs == 0) return PW85_SUCCESS;
    if (any_null(overlap))
        return refuse_arrays("pw85_overlap_pairs", "num_pairs", list->num_pairs,
                             NamedArray{"overlap", overlap});
    return compute_list("pw85_overlap_pairs", *list, *system, OverlapArray{overlap});
}

int pw85_contact_derivatives_pairs(pw85_pair_list const *list, pw85_system const *system,
                                   double *mu2, double *lambda, double *point, double *normal,
                                   double *d_r12, double *d_rot1, double *d_rot2)
{
    if (any_null(list) || any_null(system))
        return refuse_structs("pw85_contact_derivatives_pairs", list, system);
    if (list->num_pairs == 0) return PW85_SUCCESS;
    return compute_list("pw85_contact_derivatives_pairs", *list, *system,
                        DerivativeArrays{mu2, lambda, point, normal, d_r12, d_rot1, d_rot2});
}

int pw85_first_contact_pairs(pw85_pair_list const *list, pw85_system const *system,
                             pw85_motion const *motions, double t_max, double *t, double *next,
                             int64_t *next_pair)
{
    if (any_null(list) || any_null(system))
        return refuse_structs("pw85_first_contact_pairs", list, system);
    if (system->num_particles > max_rows || (any_null(next) && !any_null(next_pair)))
        return refuse_arrays(
            "pw85_first_contact_pairs", "num_particles", system->num_particles,
            NamedArray{"next", any_null(next_pair) ? static_cast<void const *>(system) : next});
    Images images;
    NeighborList rows{};
    if (list->num_pairs > 0) {
        if (any_null(t) || any_null(motions))
            return refuse_arrays("pw85_first_contact_pairs", "num_pairs", list->num_pairs,
                                 NamedArray{"t", t}, NamedArray{"motions", motions});
        if (int const status =
                prepare_list("pw85_first_contact_pairs", *list, *system, images, rows))
            return status;
    }
    Target const &target = chosen();
    auto const gather = gather_of<NeighborList>(target);
    auto const first_contact = PW85_OF_PAIR(target, first_contact);
    auto const compute_row = [&](auto const &function, std::size_t n) {
        constexpr std::uint16_t first = 0;
        PairRow<3> pair;
        gather(rows.from(n), &first, 1, &pair);
        return function(pair.r12, pair.q1, pair.q2, motions + list->pairs[2 * n],
                        motions + list->pairs[2 * n + 1], t_max, t + n);
    };
    Failure const failure = for_blocks(list->num_pairs, [&](Range range) {
        return for_rows(range, [&](std::size_t n) { return compute_row(first_contact, n); });
    });
    // Comparing the NaN of bad pairs raises an exception.
    in_default_environment([&] {
        find_next(list->num_pairs, list->pairs, t, system->num_particles, next, next_pair);
    });
    return refuse_first(failure, [&](std::size_t n) { return compute_row(pw85_first_contact, n); });
}

int pw85_overlap_volume_pairs(pw85_pair_list const *list, pw85_system const *system, double *volume)
{
    if (any_null(list) || any_null(system))
        return refuse_structs("pw85_overlap_volume_pairs", list, system);
    if (list->num_pairs == 0) return PW85_SUCCESS;
    if (any_null(volume))
        return refuse_arrays("pw85_overlap_volume_pairs", "num_pairs", list->num_pairs,
                             NamedArray{"volume", volume});
    Images images;
    NeighborList rows{};
    if (int const status = prepare_list("pw85_overlap_volume_pairs", *list, *system, images, rows))
        return status;
    auto const gather = gather_of<NeighborList>(chosen());
    auto const measure = [&](std::size_t n) {
        constexpr std::uint16_t first = 0;
        PairRow<3> pair;
        gather(rows.from(n), &first, 1, &pair);
        return pw85_overlap_volume(pair.r12, pair.q1, pair.q2, volume + n);
    };
    Failure const failure = for_blocks(
        list->num_pairs, [&](Range range) { return for_rows(range, measure); }, block_of_calls);
    return refuse_first(failure, measure);
}

int pw85_nearest_images(size_t num_pairs, int32_t const *pairs, pw85_system const *system,
                        double *r12, int32_t *images)
{
    if (any_null(system))
        return refuse_arrays("pw85_nearest_images", "num_pairs", num_pairs,
                             NamedArray{"system", system});
    if (num_pairs == 0) return PW85_SUCCESS;
    if (any_null(system->cell))
        return refuse_arrays("pw85_nearest_images", "num_pairs", num_pairs,
                             NamedArray{"cell", system->cell});
    Images nearest;
    NeighborList rows{};
    if (int const status = prepare_list("pw85_nearest_images", {num_pairs, pairs, nullptr},
                                        without_forms(*system), nearest, rows))
        return status;
    Failure const failure = for_blocks(num_pairs, [&](Range range) {
        ImageFinder const finder(rows);
        return for_rows(range, [&](std::size_t pair) {
            return finder.find(pair, row_or_null(r12, 3, pair), row_or_null(images, 3, pair));
        });
    });
    return refuse_first(failure, [](std::size_t) {
        return refuse(PW85_EINVAL, {0, "pw85_nearest_images", "centers",
                                    "must be finite and near the cell", 0, 0, quiet_nan<double>()});
    });
}

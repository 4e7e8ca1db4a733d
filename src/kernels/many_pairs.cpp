// The functions of many pairs of the C API: what concerns a call as a whole.
#include <pw85.h>

#include <cmath>

#include <pw85/walls.hpp>

#include "../c_arrays.hpp"
#include "forces.hpp"
#include "image_finder.hpp"
#include "many_pairs.hpp"

using namespace pw85;
using namespace pw85::kernels;
using pw85::c_api::any_null;

namespace {

/// The first number that is no index of a particle.
std::uint32_t end_of(std::size_t num_particles) noexcept
{
    return static_cast<std::uint32_t>(std::min<std::size_t>(num_particles, INT32_MAX + std::size_t{1}));
}

/// Whether n indices are below `end`, which is at most 2³¹: neither they nor `end` - 1 less them have the sign bit. No comparison, which
/// baseline instructions lack for unsigned numbers.
bool are_below(std::uint32_t end, std::int32_t const *indices, std::size_t n) noexcept
{
    std::uint32_t signs = 0;
    for (std::size_t k = 0; k < n; ++k) {
        auto const index = static_cast<std::uint32_t>(indices[k]);
        signs |= index | (end - 1 - index);
    }
    return signs >> 31 == 0;
}

/// Whether all indices are in range.
bool are_valid(std::size_t num_pairs, std::int32_t const *pairs, std::size_t num_particles) noexcept
{
    auto const end = end_of(num_particles);
    return for_all(num_pairs, [=](Range range) {
               bool const valid = are_below(end, pairs + 2 * range.begin, 2 * (range.end - range.begin));
               return Failure{range.begin, valid ? PW85_SUCCESS : PW85_EINVAL};
           }) == PW85_SUCCESS;
}

/// Calls row(i) for a range of rows, and returns the first failure.
template <class Row> Failure for_rows(Range range, Row const &row) noexcept
{
    Failure first{0, 0};
    for (std::size_t i = range.begin; i < range.end; ++i) first.update(Failure{i, row(i)});
    return first;
}

/// Distances of a range of ellipsoids to their half-spaces. Not inlined: no arithmetic may leave the environment of the caller.
[[gnu::noinline]] Failure distance_planes(Range range, double const *normals, double const *offsets, double const *q,
                                          double *distance, double *point) noexcept
{
    return for_rows(range, [=](std::size_t i) {
        auto const d =
            distance_plane(c_api::load_vector<3>(normals + 3 * i), offsets[i], c_api::load_matrix<3>(q + 6 * i));
        if (distance != nullptr) distance[i] = d.distance;
        c_api::store(d.point, row_or_null(point, 3, i));
        return static_cast<int>(d.status);
    });
}

/// The least time of each particle's pairs, and the pair.
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

/// Checks the arguments that the functions for neighbour lists share, and prepares the lattice.
int prepare_list(std::size_t num_pairs, std::size_t num_particles, NeighborList &list, Lattice &lattice) noexcept
{
    if (num_pairs > max_rows || num_particles > max_rows) return PW85_EINVAL;
    if (any_null(list.pairs, list.centers, list.q)) return PW85_EINVAL;
    if (list.images != nullptr && (list.cell == nullptr || !is_finite_cell(list.cell))) return PW85_EINVAL;
    if (!are_valid(num_pairs, list.pairs, num_particles)) return PW85_EINVAL;
    if (list.cell == nullptr || list.images != nullptr) return PW85_SUCCESS;
    list.lattice = &lattice;
    DefaultEnvironment const environment;
    return prepare(list.cell, lattice) ? PW85_SUCCESS : PW85_EINVAL;
}

/// Computes the pairs of a neighbour list.
template <class Arrays>
int compute_list(std::size_t num_pairs, std::size_t num_particles, NeighborList list, Arrays const &out) noexcept
{
    Lattice lattice;
    if (int const status = prepare_list(num_pairs, num_particles, list, lattice)) return status;
    return compute_all(num_pairs, list, out);
}

/// Pairs that are tested before the answers are looked at: some more than the neighbours of a particle in a dense system.
constexpr std::size_t any_chunk_size = 32;

/// Looks for the first pair, by its index, that overlaps or is bad. Returns the status of a bad one, with `any` = -1.
template <class Rows> int find_overlap(Rows const &rows, std::size_t n, int &any) noexcept
{
    Kernels const &kernels = chosen();
    unsigned char answers[any_chunk_size];
    for (std::size_t begin = 0; begin < n; begin += any_chunk_size) {
        std::size_t const count = std::min(any_chunk_size, n - begin);
        Failure const bad = compute(kernels, rows.from(begin), count, OverlapArray{answers});
        unsigned char const *const found = std::find_if(answers, answers + count, [](int x) { return x != 0; });
        if (found == answers + count) continue;
        any = *found == 1 ? 1 : -1;
        return any == 1 ? PW85_SUCCESS : bad.status;
    }
    any = 0;
    return PW85_SUCCESS;
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

int pw85_penetration_batch(size_t n, double const *r12, double const *q1, double const *q2, double *depth,
                           double *direction)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(r12, q1, q2)) return PW85_EINVAL;
    return for_all(n, [&](Range range) {
        return for_rows(range, [&](std::size_t i) {
            return pw85_penetration(r12 + 3 * i, q1 + 6 * i, q2 + 6 * i, row_or_null(depth, 1, i),
                                    row_or_null(direction, 3, i));
        });
    });
}

int pw85_distance_plane_batch(size_t n, double const *normals, double const *offsets, double const *q, double *distance,
                              double *point)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(normals, offsets, q)) return PW85_EINVAL;
    return for_all(n, [&](Range range) { return distance_planes(range, normals, offsets, q, distance, point); });
}

int pw85_first_contact_batch(size_t n, double const *r12, double const *q1, double const *q2,
                             pw85_motion const *motion1, pw85_motion const *motion2, double t_max, double *t)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(r12, q1, q2, t) || any_null(motion1, motion2)) return PW85_EINVAL;
    OnePairKernels const &k = *chosen().one_pair;
    return for_all(n, [&](Range range) {
        return for_rows(range, [&](std::size_t i) {
            return k.first_contact(r12 + 3 * i, q1 + 6 * i, q2 + 6 * i, motion1 + i, motion2 + i, t_max, t + i);
        });
    });
}

int pw85_overlap_any(size_t n, double const q1[PW85_SYM], double const *r12, double const *q2, int *any)
{
    if (any_null(any)) return PW85_EINVAL;
    *any = 0;
    if (n == 0) return PW85_SUCCESS;
    *any = -1;
    if (n > max_rows || any_null(q1, r12, q2)) return PW85_EINVAL;
    DefaultEnvironment const environment;
    return find_overlap(OneToMany{q1, r12, q2}, n, *any);
}

int pw85_overlap_any_indices(double const center[3], double const q1[PW85_SYM], size_t n, int32_t const *indices,
                             size_t num_particles, double const *centers, double const *q, double const *cell, int *any)
{
    if (any_null(any)) return PW85_EINVAL;
    *any = 0;
    if (n == 0) return PW85_SUCCESS;
    *any = -1;
    if (n > max_rows || num_particles > max_rows || any_null(center, q1, indices, centers, q)) return PW85_EINVAL;
    if (!are_below(end_of(num_particles), indices, n)) return PW85_EINVAL;
    Lattice lattice;
    DefaultEnvironment const environment;
    if (cell != nullptr && !prepare(cell, lattice)) return PW85_EINVAL;
    return find_overlap(OneToSome{center, q1, indices, centers, q, cell != nullptr ? &lattice : nullptr}, n, *any);
}

int pw85_contact_pairs(size_t num_pairs, int32_t const *pairs, int32_t const *images, size_t num_particles,
                       double const *centers, double const *q, double const *cell, double *mu2, double *lambda)
{
    if (num_pairs == 0) return PW85_SUCCESS;
    if (any_null(mu2)) return PW85_EINVAL;
    return compute_list(num_pairs, num_particles, {pairs, centers, q, images, cell, nullptr},
                        ContactArrays{mu2, lambda});
}

int pw85_overlap_pairs(size_t num_pairs, int32_t const *pairs, int32_t const *images, size_t num_particles,
                       double const *centers, double const *q, double const *cell, unsigned char *overlap)
{
    if (num_pairs == 0) return PW85_SUCCESS;
    if (any_null(overlap)) return PW85_EINVAL;
    return compute_list(num_pairs, num_particles, {pairs, centers, q, images, cell, nullptr}, OverlapArray{overlap});
}

int pw85_contact_derivatives_pairs(size_t num_pairs, int32_t const *pairs, int32_t const *images, size_t num_particles,
                                   double const *centers, double const *q, double const *cell, double *mu2,
                                   double *lambda, double *point, double *normal, double *d_r12, double *d_rot1,
                                   double *d_rot2)
{
    if (num_pairs == 0) return PW85_SUCCESS;
    return compute_list(num_pairs, num_particles, {pairs, centers, q, images, cell, nullptr},
                        DerivativeArrays{mu2, lambda, point, normal, d_r12, d_rot1, d_rot2});
}

int pw85_first_contact_pairs(size_t num_pairs, int32_t const *pairs, int32_t const *images, size_t num_particles,
                             double const *centers, double const *q, double const *cell, pw85_motion const *motions,
                             double t_max, double *t, double *next, int64_t *next_pair)
{
    if (num_particles > max_rows || (any_null(next) && !any_null(next_pair))) return PW85_EINVAL;
    Lattice lattice;
    NeighborList list{pairs, centers, q, images, cell, nullptr};
    if (num_pairs > 0) {
        if (any_null(t, motions)) return PW85_EINVAL;
        if (int const status = prepare_list(num_pairs, num_particles, list, lattice)) return status;
    }
    OnePairKernels const &k = *chosen().one_pair;
    LaneKernel<NeighborList, ContactArrays> const &lanes = *chosen().lanes;
    int const status = for_all(num_pairs, [&](Range range) {
        return for_rows(range, [&](std::size_t n) {
            constexpr std::uint16_t first = 0;
            PairRow<3> pair;
            lanes.gather(list.from(n), &first, 1, &pair);
            return k.first_contact(pair.r12, pair.q1, pair.q2, motions + pairs[2 * n], motions + pairs[2 * n + 1],
                                   t_max, t + n);
        });
    });
    find_next(num_pairs, pairs, t, num_particles, next, next_pair);
    return status;
}

int pw85_nearest_images(size_t num_pairs, int32_t const *pairs, size_t num_particles, double const *centers,
                        double const *cell, double *r12, int32_t *images)
{
    if (num_pairs == 0) return PW85_SUCCESS;
    if (any_null(cell)) return PW85_EINVAL;
    Lattice lattice;
    NeighborList list{pairs, centers, centers, nullptr, cell, nullptr};
    if (int const status = prepare_list(num_pairs, num_particles, list, lattice)) return status;
    return for_all(num_pairs, [&](Range range) {
        ImageFinder const finder(list);
        return for_rows(range, [&](std::size_t pair) {
            return finder.find(pair, row_or_null(r12, 3, pair), row_or_null(images, 3, pair));
        });
    });
}

int pw85_contact_forces_pairs(size_t num_pairs, int32_t const *pairs, int32_t const *images, size_t num_particles,
                              double const *centers, double const *cell, double const *d_u, double const *d_r12,
                              double const *d_rot1, double const *d_rot2, double *forces, double *torques,
                              double *virial)
{
    if (num_particles > max_rows) return PW85_EINVAL;
    if (num_pairs > 0) {
        if (any_null(d_u, centers) || (forces != nullptr && any_null(d_r12)) ||
            (torques != nullptr && any_null(d_rot1, d_rot2)) || (virial != nullptr && any_null(d_r12)))
            return PW85_EINVAL;
    }
    Lattice lattice;
    NeighborList list{pairs, centers, centers, images, cell, nullptr}; // no forms
    if (num_pairs > 0)
        if (int const status = prepare_list(num_pairs, num_particles, list, lattice)) return status;
    sum_forces({num_pairs, list, d_u, d_r12, d_rot1, d_rot2}, num_particles, {forces, torques, virial});
    return PW85_SUCCESS;
}

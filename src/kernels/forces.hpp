/// @file
/// Sums over the pairs of a neighbour list, with the same bits from any number of threads.
#ifndef PW85_KERNELS_FORCES_HPP_INCLUDED
#define PW85_KERNELS_FORCES_HPP_INCLUDED

#ifdef _OPENMP
#include <omp.h>
#endif

#include "../tasks.hpp"
#include "parallel.hpp"
#include "rows.hpp"

namespace pw85::kernels {
namespace {

/// An energy U(μ²) of pairs: dU/dμ², and the derivatives of μ², three numbers per pair.
struct PairGradients {
    std::size_t num_pairs;
    std::int32_t const *pairs;
    double const *d_u, *d_r12, *d_rot1, *d_rot2;
};

/// Adds a multiple of one row to another.
inline void add_row(double factor, double const *row, double *sum) noexcept
{
    for (int d = 0; d < 3; ++d) sum[d] += factor * row[d];
}

/// The same where there is a sum.
inline void add_row_to(double *sum, double factor, double const *row) noexcept
{
    if (sum != nullptr) add_row(factor, row, sum);
}

/// Forces and torques of the particles in a range, in the order of the pairs, so that no sum depends on the range. The forces on both
/// particles of a pair are opposite.
inline void sum_range(PairGradients const &pairs, Range range, double *forces, double *torques) noexcept
{
    for (double *const sums : {forces, torques})
        if (sums != nullptr) std::fill(sums + 3 * range.begin, sums + 3 * range.end, 0.0);
    std::size_t const size = range.end - range.begin;
    for (std::size_t k = 0; k < pairs.num_pairs; ++k) {
        double const d_u = pairs.d_u[k];
        auto const i = static_cast<std::size_t>(pairs.pairs[2 * k]),
                   j = static_cast<std::size_t>(pairs.pairs[2 * k + 1]);
        if (d_u == 0.0) continue;
        if (i - range.begin < size) {
            add_row_to(row_or_null(forces, 3, i), d_u, row_or_null(pairs.d_r12, 3, k));
            add_row_to(row_or_null(torques, 3, i), -d_u, row_or_null(pairs.d_rot1, 3, k));
        }
        if (j - range.begin < size) {
            add_row_to(row_or_null(forces, 3, j), -d_u, row_or_null(pairs.d_r12, 3, k));
            add_row_to(row_or_null(torques, 3, j), -d_u, row_or_null(pairs.d_rot2, 3, k));
        }
    }
}

/// Each thread sums up for its own particles, and goes through all pairs for that.
inline void sum_forces(PairGradients const &pairs, std::size_t num_particles, double *forces, double *torques) noexcept
{
#pragma omp parallel if (pairs.num_pairs > block)
    {
        DefaultEnvironment const environment; // threads have their own
        std::size_t thread = 0, threads = 1;
#ifdef _OPENMP
        thread = static_cast<std::size_t>(omp_get_thread_num());
        threads = static_cast<std::size_t>(omp_get_num_threads());
#endif
        std::size_t const share = (num_particles + threads - 1) / threads;
        std::size_t const begin = std::min(num_particles, thread * share);
        sum_range(pairs, {begin, std::min(num_particles, begin + share)}, forces, torques);
    }
}

/// The virial of the pairs in a range: r12 times the force on the second particle.
inline void sum_virial(PairGradients const &pairs, NeighborList const &list, Range range, double (&sum)[9]) noexcept
{
    for (std::size_t k = range.begin; k < range.end; ++k) {
        if (pairs.d_u[k] == 0.0) continue;
        auto const r12 = load_separations<double>(list, &k);
        for (int d = 0; d < 3; ++d) add_row(-pairs.d_u[k] * r12[d], pairs.d_r12 + 3 * k, sum + 3 * d);
    }
}

/// The sum of parts whose number does not depend on that of the threads.
inline void sum_virial(PairGradients const &pairs, NeighborList const &list, double *virial) noexcept
{
    constexpr std::size_t num_parts = 64;
    double parts[num_parts][9] = {};
    std::size_t const share = (pairs.num_pairs + num_parts - 1) / num_parts;
    for_tasks(num_parts, pairs.num_pairs > block, [&](std::size_t part) {
        std::size_t const begin = std::min(pairs.num_pairs, part * share);
        sum_virial(pairs, list, {begin, std::min(pairs.num_pairs, begin + share)}, parts[part]);
    });
    DefaultEnvironment const environment;
    std::fill_n(virial, 9, 0.0);
    for (auto const &part : parts)
        for (int k = 0; k < 9; ++k) virial[k] += part[k];
}

} // namespace
} // namespace pw85::kernels

#endif

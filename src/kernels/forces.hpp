/// @file
/// Sums forces, torques and virial over the pairs of a neighbour list. The result has the same bits for any number of threads.
/// pw85_contact_forces_pairs() (many_pairs.cpp) and law_forces.hpp use this file.
#ifndef PW85_KERNELS_FORCES_HPP_INCLUDED
#define PW85_KERNELS_FORCES_HPP_INCLUDED

#include <cstring>

#ifdef _OPENMP
#include <omp.h>
#endif

#include "../floating_point_environment.hpp"
#include "parallel.hpp"
#include "rows.hpp"

namespace pw85::detail::kernels {
namespace {

/// The derivatives of an energy U(μ²) of pairs.
struct PairGradients {
    std::size_t num_pairs;
    NeighborList list;                     ///< its forms are not read
    double const *d_u;                     ///< dU/dμ², one number per pair
    double const *d_r12, *d_rot1, *d_rot2; ///< derivatives of μ², three numbers per pair
    double const *r12 = nullptr; ///< separations, three numbers per pair; null if they are to be computed from the list
};

/// The output arrays, any of which may be null.
struct PairSums {
    double *forces, *torques; ///< three numbers per particle
    double *virial;           ///< nine numbers
};

/// Three numbers, two of which share a register.
struct Row {
    typedef double Two __attribute__((vector_size(2 * sizeof(double))));
    Two xy;
    double z;
};

inline Row load_row(double const *rows, std::size_t index) noexcept
{
    double const *const numbers = row_of(rows, 3, index);
    Row row;
    std::memcpy(&row.xy, numbers, sizeof row.xy);
    row.z = numbers[2];
    return row;
}

inline void store_row(Row const &row, double *rows, std::size_t index) noexcept
{
    double *const numbers = row_of(rows, 3, index);
    std::memcpy(numbers, &row.xy, sizeof row.xy);
    numbers[2] = row.z;
}

inline Row times(double factor, Row const &row) noexcept { return {factor * row.xy, factor * row.z}; }

inline Row plus(Row const &a, Row const &b) noexcept { return {a.xy + b.xy, a.z + b.z}; }

inline void add_row(Row const &row, double *sums, std::size_t index) noexcept
{
    store_row(plus(load_row(sums, index), row), sums, index);
}

/// The rows of a matrix. This is not an array, because compilers would keep an array in memory.
struct Rows3 {
    Row x, y, z;
};

/// The number of parts in which the virial is summed. It does not depend on the number of threads, so the order of additions is
/// always the same.
constexpr std::size_t num_parts = 64;

/// The number of pairs by which particles are prefetched ahead. The particles of consecutive pairs may be anywhere in memory.
constexpr std::size_t prefetch_distance = 16;

/// The number of the calling thread in its parallel region, and the number of threads.
struct ThreadNumber {
    std::size_t thread, threads;
};

inline ThreadNumber this_thread() noexcept
{
#ifdef _OPENMP
    return {static_cast<std::size_t>(omp_get_thread_num()), static_cast<std::size_t>(omp_get_num_threads())};
#else
    return {0, 1};
#endif
}

/// Part k of n rows that are divided into `count` parts.
inline Range share(std::size_t n, std::size_t count, std::size_t k) noexcept
{
    std::size_t const size = (n + count - 1) / count;
    return Range{std::min(n, k * size), std::min(n, (k + 1) * size)};
}

/// The sums of one thread: the forces and torques on its own particles, in the order of all pairs, and the virial of its own parts.
class ForceSum {
  public:
    ForceSum(PairSums const &sums, Range own) noexcept : sums_(sums), begin_(own.begin), size_(own.end - own.begin)
    {
        for (double *const rows : {sums.forces, sums.torques})
            if (rows != nullptr) std::fill(rows + 3 * own.begin, rows + 3 * own.end, 0.0);
    }

    /// Adds the forces and torques of a part of the pairs, and writes the virial of this part if `virial` is not null.
    void add_part(PairGradients const &pairs, Range part, double *virial) const noexcept
    {
        Rows3 sum = {};
        for (std::size_t k = part.begin; k < part.end; ++k) {
            fetch(pairs, std::min(k + prefetch_distance, pairs.num_pairs - 1));
            if (pairs.d_u[k] == 0.0) continue;
            if (virial != nullptr) add_virial(pairs, k, sum);
            add_pair(pairs, k);
        }
        if (virial == nullptr) return;
        store_row(sum.x, virial, 0);
        store_row(sum.y, virial, 1);
        store_row(sum.z, virial, 2);
    }

  private:
    static std::size_t particle(NeighborList const &list, std::size_t k, int which) noexcept
    {
        return static_cast<std::size_t>(list.pairs[2 * k + static_cast<std::size_t>(which)]);
    }

    bool is_own(std::size_t particle) const noexcept { return particle - begin_ < size_; }

    /// Prefetches what add_pair() and add_virial() read, except for the sums of other threads.
    void fetch(PairGradients const &pairs, std::size_t k) const noexcept
    {
        for (int const which : {0, 1}) {
            std::size_t const i = particle(pairs.list, k, which), own = is_own(i) ? i : begin_;
            if (pairs.r12 == nullptr) __builtin_prefetch(row_of(pairs.list.centers, 3, i));
            if (sums_.forces != nullptr) __builtin_prefetch(row_of(sums_.forces, 3, own), 1);
            if (sums_.torques != nullptr) __builtin_prefetch(row_of(sums_.torques, 3, own), 1);
        }
    }

    /// Adds pair k to the sums of its particles. The forces on the two particles are opposite.
    void add_pair(PairGradients const &pairs, std::size_t k) const noexcept
    {
        double const d_u = pairs.d_u[k];
        std::size_t const i = particle(pairs.list, k, 0), j = particle(pairs.list, k, 1);
        Row const force = sums_.forces != nullptr ? times(d_u, load_row(pairs.d_r12, k)) : Row{};
        if (is_own(i)) add(i, force, -d_u, pairs.d_rot1, k);
        if (is_own(j)) add(j, times(-1.0, force), -d_u, pairs.d_rot2, k);
    }

    /// Adds a force and a torque on a particle. The torque is `factor` times row k of d_rot.
    void add(std::size_t particle, Row const &force, double factor, double const *d_rot, std::size_t k) const noexcept
    {
        if (sums_.forces != nullptr) add_row(force, sums_.forces, particle);
        if (sums_.torques != nullptr) add_row(times(factor, load_row(d_rot, k)), sums_.torques, particle);
    }

    /// Adds the virial of pair k, r12 times the force on the second particle.
    static void add_virial(PairGradients const &pairs, std::size_t k, Rows3 &sum) noexcept
    {
        double const *const given = row_or_null(pairs.r12, 3, k);
        auto const r12 = given != nullptr ? Vector<double, 3>{given[0], given[1], given[2]}
                                          : load_separations<double>(pairs.list, &k);
        Row const force = times(-pairs.d_u[k], load_row(pairs.d_r12, k));
        sum = {plus(sum.x, times(r12[0], force)), plus(sum.y, times(r12[1], force)), plus(sum.z, times(r12[2], force))};
    }

    PairSums const sums_;
    std::size_t begin_, size_;
};

/// The work of one of `threads` threads: the sums for its share of the particles, and the virial of every `threads`-th part.
inline void sum_forces(PairGradients const &pairs, std::size_t num_particles, PairSums const &sums, std::size_t thread,
                       std::size_t threads, double (&parts)[num_parts][9]) noexcept
{
    ForceSum const own(sums, share(num_particles, threads, thread));
    for (std::size_t part = 0; part < num_parts; ++part)
        own.add_part(pairs, share(pairs.num_pairs, num_parts, part),
                     sums.virial != nullptr && part % threads == thread ? parts[part] : nullptr);
}

/// Sums in parallel. Each thread goes through all pairs and adds only to its own particles, so that no thread waits for another.
inline void sum_forces(PairGradients const &pairs, std::size_t num_particles, PairSums const &sums) noexcept
{
    double parts[num_parts][9] = {};
#pragma omp parallel if (pairs.num_pairs > block)
    {
        DefaultEnvironment const environment; // threads have their own
        auto const [thread, threads] = this_thread();
        sum_forces(pairs, num_particles, sums, thread, threads, parts);
    }
    if (sums.virial == nullptr) return;
    in_default_environment([&] {
        std::fill_n(sums.virial, 9, 0.0);
        for (auto const &part : parts)
            for (int k = 0; k < 9; ++k) sums.virial[k] += part[k];
    });
}

} // namespace
} // namespace pw85::detail::kernels

#endif

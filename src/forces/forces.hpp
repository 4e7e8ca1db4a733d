// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sums forces, torques and virial over the pairs of a neighbour list. The result has the same bits
/// for any number of threads. pw85_contact_forces_pairs() (sums.cpp) and law_forces.hpp use this
/// file.
#ifndef PW85_FORCES_FORCES_HPP_INCLUDED
#define PW85_FORCES_FORCES_HPP_INCLUDED

#include <algorithm>
#include <cstring>

#include "../base/floating_point_environment.hpp"
#include "../base/parallel.hpp"
#include "../simd/rows.hpp"

namespace pw85::detail::kernels {
namespace {

/// The derivatives of an energy U(μ²) of pairs.
struct PairGradients {
    std::size_t num_pairs;
    NeighborList list;                     ///< its forms are not read
    double const *d_u;                     ///< dU/dμ², one number per pair
    double const *d_r12, *d_rot1, *d_rot2; ///< derivatives of μ², three numbers per pair
    /// separations, three numbers per pair; null if they are to be computed from the list
    double const *r12 = nullptr;
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

inline Row times(double factor, Row const &row) noexcept
{
    return {factor * row.xy, factor * row.z};
}

inline Row plus(Row const &a, Row const &b) noexcept { return {a.xy + b.xy, a.z + b.z}; }

inline void add_row(Row const &row, double *sums, std::size_t index) noexcept
{
    store_row(plus(load_row(sums, index), row), sums, index);
}

/// The rows of a matrix. This is not an array, because compilers would keep an array in memory.
struct Rows3 {
    Row x, y, z;
};

/// The number of parts in which the virial is summed. It does not depend on the number of threads,
/// so the order of additions is always the same.
constexpr std::size_t num_parts = 64;

/// The number of pairs by which particles are prefetched ahead. The particles of consecutive pairs
/// may be anywhere in memory.
constexpr std::size_t prefetch_distance = 16;

/// The number of pairs that are listed at a time.
constexpr std::size_t most_listed = 512;

/// The pairs of a range that have a force. A branch on this could not be predicted, so they are
/// listed beforehand.
struct PairsWithForce {
    std::size_t begin, size;
    bool all; ///< all pairs from `begin` on; the list is then empty
    std::uint16_t numbers[most_listed];
};

/// Lists the pairs of a range of at most most_listed pairs whose U' is not zero. There are `count`.
inline void list_pairs(double const *d_u, Range range, std::size_t count,
                       PairsWithForce &listed) noexcept
{
    listed.begin = range.begin;
    listed.size = count;
    listed.all = count == range.end - range.begin;
    for (std::size_t k = range.begin, size = 0; size < count && !listed.all; ++k) {
        listed.numbers[size] = static_cast<std::uint16_t>(k - range.begin);
        size += d_u[k] != 0.0;
    }
}

/// Part k of n rows that are divided into `count` parts.
inline Range share(std::size_t n, std::size_t count, std::size_t k) noexcept
{
    std::size_t const size = (n + count - 1) / count;
    return Range{minimum(n, k * size), minimum(n, (k + 1) * size)};
}

/// Calls visit(pairs, pair, later) for the pairs of a list, where `later` is a pair some places
/// behind. The compiler sees that no store of visit() changes the copy of `pairs`, and keeps its
/// pointers in registers.
template <class Visit> [[gnu::always_inline]] inline void
for_pairs(PairGradients const &given, PairsWithForce const &listed, Visit const &visit) noexcept
{
    PairGradients const pairs = given;
    std::size_t const begin = listed.begin, size = listed.size;
    std::uint16_t const *const numbers = listed.numbers;
    auto const later = [=](std::size_t k) { return minimum(k + prefetch_distance, size - 1); };
    if (listed.all)
        for (std::size_t k = 0; k < size; ++k) visit(pairs, begin + k, begin + later(k));
    else
        for (std::size_t k = 0; k < size; ++k)
            visit(pairs, begin + numbers[k], begin + numbers[later(k)]);
}

inline std::size_t particle(NeighborList const &list, std::size_t pair, int which) noexcept
{
    return static_cast<std::size_t>(list.pairs[2 * pair + static_cast<std::size_t>(which)]);
}

/// Adds the virial of the pairs of a list: r12 times the force on the second particle.
inline void add_virial(PairGradients const &given, PairsWithForce const &listed,
                       double *virial) noexcept
{
    Rows3 sum = {};
    for_pairs(given, listed, [&](PairGradients const &pairs, std::size_t pair, std::size_t later) {
        for (int const which : {0, 1})
            if (pairs.r12 == nullptr)
                __builtin_prefetch(
                    row_of(pairs.list.centers, 3, particle(pairs.list, later, which)));
        double const *const known = row_or_null(pairs.r12, 3, pair);
        auto const r12 = known != nullptr ? Vector<double, 3>{known[0], known[1], known[2]}
                                          : load_separations<double>(pairs.list, &pair);
        Row const force = times(-pairs.d_u[pair], load_row(pairs.d_r12, pair));
        sum = {plus(sum.x, times(r12[0], force)), plus(sum.y, times(r12[1], force)),
               plus(sum.z, times(r12[2], force))};
    });
    add_row(sum.x, virial, 0);
    add_row(sum.y, virial, 1);
    add_row(sum.z, virial, 2);
}

/// The sums of one thread: the forces and torques on its own particles, in the order of all pairs.
class ForceSum {
  public:
    ForceSum(PairSums const &sums, Range own) noexcept
        : sums_(sums), begin_(own.begin), size_(own.end - own.begin)
    {
        for (double *const rows : {sums.forces, sums.torques})
            if (rows != nullptr) std::fill(rows + 3 * own.begin, rows + 3 * own.end, 0.0);
    }

    /// Returns whether some particle of a range belongs to the thread.
    bool meets(Range particles) const noexcept
    {
        return particles.begin < begin_ + size_ && begin_ < particles.end;
    }

    /// Adds the forces and torques of the pairs of a list.
    void add(PairGradients const &given, PairsWithForce const &listed) const noexcept
    {
        ForceSum const own = *this; // a copy, for the reason at for_pairs()
        for_pairs(given, listed,
                  [own](PairGradients const &pairs, std::size_t pair, std::size_t later) {
                      own.fetch(pairs.list, later);
                      own.add_pair(pairs, pair);
                  });
    }

  private:
    bool is_own(std::size_t particle) const noexcept { return particle - begin_ < size_; }

    /// Prefetches what add_pair() reads, except for the sums of other threads.
    void fetch(NeighborList const &list, std::size_t pair) const noexcept
    {
        for (int const which : {0, 1}) {
            std::size_t const i = particle(list, pair, which), own = is_own(i) ? i : begin_;
            if (sums_.forces != nullptr) __builtin_prefetch(row_of(sums_.forces, 3, own), 1);
            if (sums_.torques != nullptr) __builtin_prefetch(row_of(sums_.torques, 3, own), 1);
        }
    }

    /// Adds a pair to the sums of its particles. The forces on the two particles are opposite.
    void add_pair(PairGradients const &pairs, std::size_t pair) const noexcept
    {
        double const d_u = pairs.d_u[pair];
        std::size_t const i = particle(pairs.list, pair, 0), j = particle(pairs.list, pair, 1);
        Row const force = sums_.forces != nullptr ? times(d_u, load_row(pairs.d_r12, pair)) : Row{};
        if (is_own(i)) add(i, force, -d_u, pairs.d_rot1, pair);
        if (is_own(j)) add(j, times(-1.0, force), -d_u, pairs.d_rot2, pair);
    }

    /// Adds a force and a torque on a particle. The torque is `factor` times a row of d_rot.
    void add(std::size_t particle, Row const &force, double factor, double const *d_rot,
             std::size_t pair) const noexcept
    {
        if (sums_.forces != nullptr) add_row(force, sums_.forces, particle);
        if (sums_.torques != nullptr)
            add_row(times(factor, load_row(d_rot, pair)), sums_.torques, particle);
    }

    PairSums const sums_;
    std::size_t begin_, size_;
};

/// Lists the pairs of a range.
inline void list_pairs(double const *d_u, Range range, PairsWithForce &listed) noexcept
{
    auto const count =
        std::count_if(d_u + range.begin, d_u + range.end, [](double x) { return x != 0.0; });
    list_pairs(d_u, range, static_cast<std::size_t>(count), listed);
}

/// The work of one of `threads` threads: the sums for its share of the particles, and the virial of
/// every `threads`-th part.
inline void sum_forces(PairGradients const &pairs, std::size_t num_particles, PairSums const &sums,
                       std::size_t thread, std::size_t threads,
                       double (&parts)[num_parts][9]) noexcept
{
    ForceSum const own(sums, share(num_particles, threads, thread));
    PairsWithForce listed;
    for (std::size_t part = 0; part < num_parts; ++part) {
        auto const [first, end] = share(pairs.num_pairs, num_parts, part);
        for (std::size_t begin = first; begin < end; begin += most_listed) {
            list_pairs(pairs.d_u, {begin, minimum(end, begin + most_listed)}, listed);
            own.add(pairs, listed);
            if (sums.virial != nullptr && part % threads == thread)
                add_virial(pairs, listed, parts[part]);
        }
    }
}

/// Sums in parallel. Each thread goes through all pairs and adds only to its own particles; no
/// thread waits for another.
inline void sum_forces(PairGradients const &pairs, std::size_t num_particles,
                       PairSums const &sums) noexcept
{
    double parts[num_parts][9] = {};
    in_each_thread(threads_if(pairs.num_pairs > block), [&] {
        auto const [thread, threads] = this_thread();
        sum_forces(pairs, num_particles, sums, thread, threads, parts);
    });
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

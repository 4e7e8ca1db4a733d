// The batch functions of the C API: what concerns a call as a whole, and the distribution of pairs to threads.
#include <pw85.h>

#include <algorithm>

#include "../c_arrays.hpp"
#include "../floating_point_environment.hpp"
#include "kernels.hpp"
#include "lattice.hpp"

using namespace pw85;
using namespace pw85::batch;
using pw85::c_api::any_null;

namespace {

/// The largest number of rows that an array of up to 6 doubles per row can have.
constexpr std::size_t max_rows = PTRDIFF_MAX / (PW85_SYM * sizeof(double));

/// Pairs that a thread takes at a time: some tens of microseconds of work.
constexpr std::size_t block = 4096;

/// Calls kernel(range) for blocks of n pairs, in parallel, and returns the status of the first bad pair.
template <class Kernel> int for_all_pairs(std::size_t n, Kernel const &kernel) noexcept
{
    Failure first{0, 0};
    auto const blocks = static_cast<std::ptrdiff_t>((n + block - 1) / block);
#pragma omp parallel if (blocks > 1)
    {
        DefaultEnvironment const environment; // threads have their own
        Failure own{0, 0};
#pragma omp for schedule(static) nowait
        for (std::ptrdiff_t b = 0; b < blocks; ++b) {
            std::size_t const begin = static_cast<std::size_t>(b) * block;
            own.update(kernel(Range{begin, std::min(n, begin + block)}));
        }
#pragma omp critical(pw85_batch)
        first.update(own);
    }
    return first.status;
}

/// Whether all indices are in range.
bool are_valid(std::size_t num_indices, std::int32_t const *indices, std::size_t num_particles) noexcept
{
    auto const end = static_cast<std::uint32_t>(std::min<std::size_t>(num_particles, INT32_MAX + std::size_t{1}));
    auto const count = static_cast<std::ptrdiff_t>(num_indices);
    int outside = 0;
#pragma omp parallel for schedule(static) reduction(| : outside) if (count > 65536)
    for (std::ptrdiff_t k = 0; k < count; ++k) outside |= static_cast<std::uint32_t>(indices[k]) >= end;
    return outside == 0;
}

/// Checks the arguments that both functions for neighbour lists share, and prepares the lattice.
int prepare_list(std::size_t num_pairs, std::size_t num_particles, double const *cell, NeighborList &list,
                 Lattice &lattice) noexcept
{
    if (num_pairs > max_rows || num_particles > max_rows) return PW85_EINVAL;
    if (any_null(list.pairs, list.centers, list.q)) return PW85_EINVAL;
    if (!are_valid(2 * num_pairs, list.pairs, num_particles)) return PW85_EINVAL;
    if (cell == nullptr) return PW85_SUCCESS;
    list.lattice = &lattice;
    DefaultEnvironment const environment;
    return prepare(cell, lattice) ? PW85_SUCCESS : PW85_EINVAL;
}

} // namespace

int pw85_contact_batch(size_t n, double const *r12, double const *q1, double const *q2, double *mu2, double *lambda)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(r12, q1, q2, mu2)) return PW85_EINVAL;
    Kernels const &k = kernels();
    PairArrays const pairs{r12, q1, q2};
    ContactArrays const out{mu2, lambda};
    return for_all_pairs(n, [&](Range range) { return k.lanes->contact_batch(pairs, range, out, *k.scalar); });
}

int pw85_overlap_batch(size_t n, double const *r12, double const *q1, double const *q2, unsigned char *overlap)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(r12, q1, q2, overlap)) return PW85_EINVAL;
    Kernels const &k = kernels();
    PairArrays const pairs{r12, q1, q2};
    return for_all_pairs(n, [&](Range range) { return k.lanes->overlap_batch(pairs, range, overlap, *k.scalar); });
}

int pw85_contact_pairs(size_t num_pairs, int32_t const *pairs, size_t num_particles, double const *centers,
                       double const *q, double const *cell, double *mu2, double *lambda)
{
    if (num_pairs == 0) return PW85_SUCCESS;
    if (any_null(mu2)) return PW85_EINVAL;
    Lattice lattice;
    NeighborList list{pairs, centers, q, nullptr};
    if (int const status = prepare_list(num_pairs, num_particles, cell, list, lattice)) return status;
    Kernels const &k = kernels();
    ContactArrays const out{mu2, lambda};
    return for_all_pairs(num_pairs, [&](Range range) { return k.lanes->contact_pairs(list, range, out, *k.scalar); });
}

int pw85_overlap_pairs(size_t num_pairs, int32_t const *pairs, size_t num_particles, double const *centers,
                       double const *q, double const *cell, unsigned char *overlap)
{
    if (num_pairs == 0) return PW85_SUCCESS;
    if (any_null(overlap)) return PW85_EINVAL;
    Lattice lattice;
    NeighborList list{pairs, centers, q, nullptr};
    if (int const status = prepare_list(num_pairs, num_particles, cell, list, lattice)) return status;
    Kernels const &k = kernels();
    return for_all_pairs(num_pairs,
                         [&](Range range) { return k.lanes->overlap_pairs(list, range, overlap, *k.scalar); });
}

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The functions for many pairs, one per lane, that are compiled once per instruction set. The
/// files lanes_*.cpp define them, and many_pairs.hpp calls them. A kernel has two types: the rows
/// that it reads, and the arrays that it writes. To add one:
/// 1. list its types here, and define them in kernels.hpp if they are new;
/// 2. write compute_chunk() for its arrays, and define the function in a file lanes_*.cpp;
/// 3. write scalar_fallback() for a pair that lanes leave over (many_pairs.hpp).
#ifndef PW85_SIMD_LANES_HPP_INCLUDED
#define PW85_SIMD_LANES_HPP_INCLUDED

#include "kernels.hpp"
#include "targets.hpp"
#include "worklist.hpp"

/// Calls X(rows, arrays) for each kernel.
#define PW85_LANE_KERNELS(X)                                                                       \
    X(PairArrays<2>, ContactArrays)                                                                \
    X(PairArrays<2>, OverlapArray)                                                                 \
    X(PairArrays<2>, AreaArray)                                                                    \
    X(PairArrays<3>, ContactArrays)                                                                \
    X(PairArrays<3>, OverlapArray)                                                                 \
    X(PairArrays<3>, DerivativeArrays)                                                             \
    X(PairArrays<3>, DistanceArrays)                                                               \
    X(PairArrays<3>, PassageArrays)                                                                \
    X(PairArrays<3>, GrainArrays)                                                                  \
    X(Directions, ApproachArray)                                                                   \
    X(OneToMany, OverlapArray)                                                                     \
    X(SetRows<Segments>, SetContactArrays)                                                         \
    X(SetRows<Triangles>, SetContactArrays)                                                        \
    X(SetRows<Boxes>, SetContactArrays)                                                            \
    X(SetRows<Segments>, OverlapArray)                                                             \
    X(SetRows<Triangles>, OverlapArray)                                                            \
    X(SetRows<Boxes>, OverlapArray)                                                                \
    X(SetRows<Lines>, ChordArrays)                                                                 \
    X(PointRows, SurfaceArrays)                                                                    \
    X(CylinderRows, SurfaceArrays)                                                                 \
    X(NeighborList, ContactArrays)                                                                 \
    X(NeighborList, OverlapArray)                                                                  \
    X(NeighborList, DerivativeArrays)                                                              \
    X(OneToIndexed, OverlapArray)

/// Calls X(rows) for all rows that can be gathered.
#define PW85_GATHERED_ROWS(X)                                                                      \
    X(PairArrays<2>) X(PairArrays<3>) X(Directions) X(OneToMany) X(NeighborList) X(OneToIndexed)

namespace pw85::detail::kernels {

/// Computes pairs from the first of n on, and returns their number. It writes to `rejected_lanes`
/// the indices of the computed pairs that need the function for one pair.
template <class Rows, class Arrays>
using ComputeLanes = std::size_t(Rows const &, std::size_t n, Arrays const &,
                                 Worklist &rejected_lanes) noexcept;

/// Copies the pairs with the given indices, with the separations and images that lanes compute.
template <class Rows> using GatherPairs = void(Rows const &, std::uint16_t const *indices,
                                               std::size_t count,
                                               PairRow<Rows::dimension> *pairs) noexcept;

/// Writes the derivatives of U at n numbers μ².
template <class Law>
using EvaluateLaw = LawSums(Law const &, std::size_t n, double const *mu2, double *d_u) noexcept;

#define PW85_DECLARE_COMPUTE(...) ComputeLanes<__VA_ARGS__> compute;
#define PW85_DECLARE_GATHER(...) GatherPairs<__VA_ARGS__> gather;
#define PW85_DECLARE_LANES(target, one_pair, available)                                            \
    namespace target {                                                                             \
    PW85_LANE_KERNELS(PW85_DECLARE_COMPUTE)                                                        \
    PW85_GATHERED_ROWS(PW85_DECLARE_GATHER)                                                        \
    EvaluateLaw<SoftRepulsion> evaluate;                                                           \
    EvaluateLaw<InversePowers> evaluate;                                                           \
    EvaluateLaw<LawTable> evaluate;                                                                \
    }
PW85_EACH_TARGET(PW85_DECLARE_LANES)
#undef PW85_DECLARE_LANES
#undef PW85_DECLARE_GATHER
#undef PW85_DECLARE_COMPUTE

namespace {

// The functions of a target.

template <class Rows, class Arrays> auto compute_of(Target const &target) noexcept
{
    using Compute = ComputeLanes<Rows, Arrays>;
    return PW85_OF_LANES(target, Compute, compute);
}

template <class Rows> auto gather_of(Target const &target) noexcept
{
    return PW85_OF_LANES(target, GatherPairs<Rows>, gather);
}

template <class Law> auto evaluate_of(Target const &target) noexcept
{
    return PW85_OF_LANES(target, EvaluateLaw<Law>, evaluate);
}

} // namespace
} // namespace pw85::detail::kernels

#endif

// The functions for many pairs, compiled once per instruction set.
#include "kernels.hpp"
#include "lane_closest_approach.hpp"
#include "lane_contact.hpp"
#include "lane_derivatives.hpp"
#include "lane_overlap.hpp"
#include "lane_overlap_any.hpp"

namespace pw85::kernels {

namespace {

Failure contact_batch(PairArrays const &pairs, Range range, ContactArrays const &out,
                      ScalarKernels const &scalar) noexcept
{
    return contact_rows(BatchRows{pairs}, range, out, scalar);
}

Failure contact_pairs(NeighborList const &list, Range range, ContactArrays const &out,
                      ScalarKernels const &scalar) noexcept
{
    return contact_rows(ParticleRows{list}, range, out, scalar);
}

Failure overlap_batch(PairArrays const &pairs, Range range, unsigned char *out, ScalarKernels const &scalar) noexcept
{
    return overlap_rows(BatchRows{pairs}, range, out, scalar);
}

Failure overlap_pairs(NeighborList const &list, Range range, unsigned char *out, ScalarKernels const &scalar) noexcept
{
    return overlap_rows(ParticleRows{list}, range, out, scalar);
}

Failure derivatives_batch(PairArrays const &pairs, Range range, DerivativeArrays const &out,
                          ScalarKernels const &scalar) noexcept
{
    return derivatives_rows(BatchRows{pairs}, range, out, scalar);
}

Failure derivatives_pairs(NeighborList const &list, Range range, DerivativeArrays const &out,
                          ScalarKernels const &scalar) noexcept
{
    return derivatives_rows(ParticleRows{list}, range, out, scalar);
}

Failure closest_approach_batch(PairArrays const &pairs, Range range, double *distance,
                               ScalarKernels const &scalar) noexcept
{
    return closest_approach_rows(DirectionRows{pairs}, range, distance, scalar);
}

int overlap_any(OneToMany const &others, std::size_t n, int *any, ScalarKernels const &scalar) noexcept
{
    return overlap_any_rows(OneToManyRows{others}, n, any, scalar);
}

} // namespace

extern LaneKernels const PW85_LANE_KERNELS;
LaneKernels const PW85_LANE_KERNELS = {contact_batch,     contact_pairs,     overlap_batch,          overlap_pairs,
                                       derivatives_batch, derivatives_pairs, closest_approach_batch, overlap_any};

} // namespace pw85::kernels

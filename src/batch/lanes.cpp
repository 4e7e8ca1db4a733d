// The functions for many pairs, compiled once per instruction set.
#include "kernels.hpp"
#include "lane_contact.hpp"
#include "lane_overlap.hpp"

namespace pw85::batch {

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

} // namespace

extern LaneKernels const PW85_LANE_KERNELS;
LaneKernels const PW85_LANE_KERNELS = {contact_batch, contact_pairs, overlap_batch, overlap_pairs};

} // namespace pw85::batch

// SPDX-License-Identifier: BSD-3-Clause
// The entry points of the program for a device. They call the functions of work.hpp. The file is
// compiled as CUDA, by a compiler that need not have the CUDA headers, so it includes none of them.
#include "work.hpp"

namespace {

using std::size_t;

#define PW85_DEVICE __attribute__((device)) inline

#if defined(__NVCC__)
PW85_DEVICE unsigned thread() { return threadIdx.x; }
PW85_DEVICE unsigned block() { return blockIdx.x; }
PW85_DEVICE unsigned blocks() { return gridDim.x; }
PW85_DEVICE void synchronize() { __syncthreads(); }
#else
PW85_DEVICE unsigned thread() { return static_cast<unsigned>(__nvvm_read_ptx_sreg_tid_x()); }
PW85_DEVICE unsigned block() { return static_cast<unsigned>(__nvvm_read_ptx_sreg_ctaid_x()); }
PW85_DEVICE unsigned blocks() { return static_cast<unsigned>(__nvvm_read_ptx_sreg_nctaid_x()); }
PW85_DEVICE void synchronize() { __nvvm_bar_sync(0); }
#endif

PW85_DEVICE size_t thread_of_all()
{
    return size_t{block()} * pw85::detail::gpu::block_size + thread();
}
PW85_DEVICE size_t all_threads() { return size_t{blocks()} * pw85::detail::gpu::block_size; }

} // namespace

// Blocks are small: each thread can have as many registers as the compiler wants to use.
static_assert(pw85::detail::gpu::block_size == 128);
#define PW85_KERNEL(name)                                                                          \
    extern "C" __attribute__((global)) __attribute__((launch_bounds(128))) void name

#define PW85_ENTRIES(Rows, Out, name)                                                              \
    PW85_KERNEL(pw85_##name##_attempt)                                                             \
    (pw85::detail::gpu::Attempt<pw85::detail::gpu::Rows, pw85::detail::gpu::Out> const work)       \
    {                                                                                              \
        __attribute__((shared)) static pw85::detail::gpu::Tile tile;                               \
        load_tile(work, tile, block(), thread());                                                  \
        synchronize();                                                                             \
        attempt(work, tile, block(), thread());                                                    \
        if (pw85::detail::gpu::is_staged<pw85::detail::gpu::Out>) synchronize();                   \
        store_tile(work, tile, block(), thread());                                                 \
    }                                                                                              \
    PW85_KERNEL(pw85_##name##_fallback)                                                            \
    (pw85::detail::gpu::Fallback<pw85::detail::gpu::Rows, pw85::detail::gpu::Out> const work)      \
    {                                                                                              \
        fallback(work, thread_of_all(), all_threads());                                            \
    }

PW85_GPU_KERNELS(PW85_ENTRIES)

PW85_KERNEL(pw85_deliver)(pw85::detail::gpu::Deliver const work)
{
    deliver(work, thread_of_all(), all_threads());
}

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The vector length of SVE, the vector extension of 64-bit ARM. It differs between processors;
/// code is compiled for one length. dispatch.cpp compares both.
#ifndef PW85_SIMD_VECTOR_LENGTH_HPP_INCLUDED
#define PW85_SIMD_VECTOR_LENGTH_HPP_INCLUDED

#if defined(__aarch64__) && defined(__linux__)
#include <sys/prctl.h>
#endif

namespace pw85::detail::kernels {

/// Returns the length of a vector of SVE in bits. It is 0 if the processor or its operating system
/// has no SVE.
[[gnu::always_inline]] inline int vector_bits_of_sve() noexcept
{
#if defined(PR_SVE_GET_VL)
    int const answer = prctl(PR_SVE_GET_VL);
    return answer < 0 ? 0 : 8 * (answer & PR_SVE_VL_LEN_MASK);
#else
    return 0;
#endif
}

} // namespace pw85::detail::kernels

#endif

/// @file
/// How long the vectors of SVE are, which differs from processor to processor and is what code for it is compiled for.
#ifndef PW85_KERNELS_VECTOR_LENGTH_HPP_INCLUDED
#define PW85_KERNELS_VECTOR_LENGTH_HPP_INCLUDED

#if defined(__aarch64__) && defined(__linux__)
#include <sys/prctl.h>
#endif

namespace pw85::detail::kernels {

/// Bits of a vector of SVE, 0 where the processor or its system has none.
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

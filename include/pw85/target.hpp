/// @file
/// The namespace of the instruction set that the translation unit is compiled for.
///
/// Everything in the headers lives in `pw85`, inside an inline namespace named after the instruction set. Inline
/// functions compiled for a newer processor are then other functions than those compiled for an older one, and the
/// linker cannot put one in the place of the other.
#ifndef PW85_TARGET_HPP_INCLUDED
#define PW85_TARGET_HPP_INCLUDED

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#define PW85_TARGET avx512
#elif defined(__AVX2__) && defined(__FMA__)
#define PW85_TARGET avx2
#else
#define PW85_TARGET baseline
#endif

#endif

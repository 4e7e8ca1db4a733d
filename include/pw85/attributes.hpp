/// @file
/// What the declarations of the headers say to the compiler besides what they are.
#ifndef PW85_ATTRIBUTES_HPP_INCLUDED
#define PW85_ATTRIBUTES_HPP_INCLUDED

/// Before every function of the templates: it belongs to its unit alone, which runs what it was compiled to, with its own flags;
/// and a thread of a device can call it where it is compiled for one.
#if defined(__CUDACC__) || defined(__CUDA__) || defined(__HIP__)
#define PW85_FUNCTION __attribute__((host)) __attribute__((device)) static
#else
#define PW85_FUNCTION static
#endif

#endif

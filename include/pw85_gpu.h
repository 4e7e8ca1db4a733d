/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * Many pairs on a graphics processor: the functions of pw85.h for arrays in the memory of an NVIDIA
 * GPU, and for arrays of the host that the functions copy to the GPU. Link with pw85_gpu and pw85.
 *
 * Device and host run the same templates. This library and programs that use it do not need the
 * CUDA toolkit. The library contains the code for the GPU, and loads the driver (libcuda.so.1, of
 * CUDA 12 or newer) at the first call. Without a driver, a device or enough memory, the functions
 * of this header return #PW85_EDEVICE; the functions of other headers need no GPU. */
#ifndef PW85_GPU_H_INCLUDED
#define PW85_GPU_H_INCLUDED

#include <pw85_systems.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Returns the number of devices.
 *
 * @param[out] count at least 1 on success, otherwise 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_EDEVICE */
PW85_API int pw85_gpu_count(int *count);

/** @name Arrays on the device
 *
 * Pointers are to memory that the device of the current context can address: from cudaMalloc or
 * cudaMallocManaged, or pinned memory. If the calling thread has no context, the functions use the
 * first device. Functions queue the work on `stream` (a CUstream or cudaStream_t; null is the
 * default stream), and return without waiting for the device. Results are valid when the stream has
 * completed all work that was queued up to this call. Until then arrays must stay allocated and
 * unchanged. A call allocates 4 bytes per pair, at most 32 MiB, from the memory pool of the stream,
 * and frees them in the order of the stream.
 *
 * The status states only whether the work was queued. As on the host, the results of a bad pair are
 * NaN, or 255 for overlaps; a pair with an index out of range is also bad. Answers about overlap
 * are the same as on the host. The stream sends bad pairs, and the few pairs that the arithmetic of
 * the device cannot decide, to the host. A thread of the driver decides these pairs there by
 * pw85_overlap_batch(), and the stream sends the answers back.
 *
 * A device computes in double precision only. At aspect ratios above 10⁵, double precision may not
 * suffice to prove the error bounds of μ² and λ. The result is then the best one in double
 * precision. Rounding errors then also decide whether a nearly singular form is positive definite.
 * At aspect ratios above 10⁷ use the functions for the host.
 *
 * If a call returns #PW85_EDEVICE, part of the work may have been queued: the outputs are
 * undefined.
 * @{ */

/** Computes pw85_contact_batch() on the device. The relative error of μ² is below 4 u cond as on
 * the host; the bits may differ.
 *
 * @param stream CUstream
 * @param n [number of pairs] 0 is allowed
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] mu2 [n]
 * @param[out] lambda [n; optional]
 * @return #PW85_SUCCESS: the work was queued; #PW85_EINVAL, also for a pointer that the device
 *        cannot address and for a size that overflows; #PW85_EDEVICE */
PW85_API int pw85_gpu_contact_batch(void *stream, size_t n, double const *r12, double const *q1,
                                    double const *q2, double *mu2, double *lambda);

/** Computes pw85_overlap_batch() on the device.
 *
 * @param stream,n,r12,q1,q2 [as pw85_gpu_contact_batch()]
 * @param[out] overlap [n] 1, 0, or 255 for a bad pair
 * @return as for pw85_gpu_contact_batch() */
PW85_API int pw85_gpu_overlap_batch(void *stream, size_t n, double const *r12, double const *q1,
                                    double const *q2, unsigned char *overlap);

/** Computes pw85_contact_derivatives_batch() on the device.
 *
 * @param stream,n,r12,q1,q2 [as pw85_gpu_contact_batch()]
 * @param[out] mu2,lambda [n; optional]
 * @param[out] point [n×3; length; optional]
 * @param[out] normal,d_rot1,d_rot2 [n×3; optional]
 * @param[out] d_r12 [n×3; 1/length; optional]
 * @return as for pw85_gpu_contact_batch() */
PW85_API int pw85_gpu_contact_derivatives_batch(void *stream, size_t n, double const *r12,
                                                double const *q1, double const *q2, double *mu2,
                                                double *lambda, double *point, double *normal,
                                                double *d_r12, double *d_rot1, double *d_rot2);

/** Computes pw85_contact_pairs() on the device.
 *
 * @param stream CUstream
 * @param list the pairs: arrays of the device
 * @param system the particles: arrays of the device, except the cell, which is in the memory of the
 *        host. The function reads the structs and the cell before it returns.
 * @param[out] mu2 [num_pairs]
 * @param[out] lambda [num_pairs; optional]
 * @return as for pw85_gpu_contact_batch(); #PW85_EINVAL also for a bad cell, as for
 *        pw85_contact_pairs() */
PW85_API int pw85_gpu_contact_pairs(void *stream, pw85_pair_list const *list,
                                    pw85_system const *system, double *mu2, double *lambda);

/** Computes pw85_overlap_pairs() on the device; arguments as for pw85_gpu_contact_pairs().
 *
 * @param stream,list,system [as pw85_gpu_contact_pairs()]
 * @param[out] overlap [num_pairs] 1, 0, or 255 for a bad pair */
PW85_API int pw85_gpu_overlap_pairs(void *stream, pw85_pair_list const *list,
                                    pw85_system const *system, unsigned char *overlap);

/** Computes pw85_contact_derivatives_pairs() on the device; arguments as for
 * pw85_gpu_contact_pairs(), outputs as for pw85_gpu_contact_derivatives_batch().
 *
 * @param stream,list,system [as pw85_gpu_contact_pairs()]
 * @param[out] mu2,lambda [num_pairs; optional]
 * @param[out] point [num_pairs×3; length; optional]
 * @param[out] normal,d_rot1,d_rot2 [num_pairs×3; optional]
 * @param[out] d_r12 [num_pairs×3; 1/length; optional] */
PW85_API int pw85_gpu_contact_derivatives_pairs(void *stream, pw85_pair_list const *list,
                                                pw85_system const *system, double *mu2,
                                                double *lambda, double *point, double *normal,
                                                double *d_r12, double *d_rot1, double *d_rot2);

/** @}
 * @name Arrays of the host
 *
 * The functions send the pairs to the device, and the results back, in pieces: they copy one piece
 * while the device computes another one. They return when all results have arrived, with the status
 * of the first bad pair, as the functions for the host do. Most of the time is spent on the
 * transfer of 120 bytes per pair. Use these functions if the processor is busy with other work.
 * @{ */

/** Computes pw85_contact_batch() on the device, for arrays of the host.
 *
 * @param n [number of pairs] 0 is allowed
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] mu2 [n]
 * @param[out] lambda [n; optional]
 * @return #PW85_SUCCESS, #PW85_EINVAL, or the status of the first bad pair; #PW85_EDEVICE: all
 *        outputs are NaN */
PW85_API int pw85_gpu_contact_host(size_t n, double const *r12, double const *q1, double const *q2,
                                   double *mu2, double *lambda);

/** Computes pw85_overlap_batch() on the device, for arrays of the host.
 *
 * @param n,r12,q1,q2 [as pw85_gpu_contact_host()]
 * @param[out] overlap [as pw85_gpu_overlap_batch()]
 * @return as for pw85_gpu_contact_host(); #PW85_EDEVICE: all overlaps are 255 */
PW85_API int pw85_gpu_overlap_host(size_t n, double const *r12, double const *q1, double const *q2,
                                   unsigned char *overlap);

/** Computes pw85_contact_derivatives_batch() on the device, for arrays of the host; arguments as
 * for pw85_gpu_contact_host(), outputs as for pw85_gpu_contact_derivatives_batch().
 *
 * @param n,r12,q1,q2 [as pw85_gpu_contact_host()]
 * @param[out] mu2 [as pw85_gpu_contact_host(); optional]
 * @param[out] lambda [as pw85_gpu_contact_host()]
 * @param[out] point,normal,d_r12,d_rot1,d_rot2 [as pw85_gpu_contact_derivatives_batch()] */
PW85_API int pw85_gpu_contact_derivatives_host(size_t n, double const *r12, double const *q1,
                                               double const *q2, double *mu2, double *lambda,
                                               double *point, double *normal, double *d_r12,
                                               double *d_rot1, double *d_rot2);

/** @} */

#ifdef __cplusplus
}
#endif

#endif

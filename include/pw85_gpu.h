/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * Many pairs on a graphics processor: the functions of pw85.h for arrays in the memory of an NVIDIA
 * GPU, and for arrays of the host that are sent there. Link with pw85_gpu and pw85.
 *
 * The code is that of the functions for the host. Neither this library nor a program that uses
 * it needs the CUDA toolkit: what a GPU runs is in the library, and the driver (libcuda.so.1, of
 * CUDA 12 or newer) is looked for at the first call. Where there is no driver, no device, or not
 * enough memory, functions return #PW85_EDEVICE, and everything else works as ever. */
#ifndef PW85_GPU_H_INCLUDED
#define PW85_GPU_H_INCLUDED

#include <pw85_systems.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Number of devices.
 *
 * @param[out] count at least 1 on success, otherwise 0
 * @return #PW85_SUCCESS, #PW85_EINVAL (a null pointer), #PW85_EDEVICE */
PW85_API int pw85_gpu_count(int *count);

/** @name Arrays on the device
 *
 * Pointers are to memory that the device of the current context can address (of cudaMalloc,
 * cudaMallocManaged, pinned memory); where the calling thread has no context, that is the first
 * device. Work is queued on `stream` (a CUstream or cudaStream_t; null is the default stream), and
 * the functions return at once: nothing waits for the device, and results are valid once the work
 * that was queued on the stream up to this call is complete. Arrays must stay allocated and
 * unchanged until then. The calls allocate from the stream's memory pool, 4 bytes per pair up to 32
 * MiB, and give it back to the stream.
 *
 * A bad pair, also one with an index that is out of range, is marked with NaN, or 255 for overlaps,
 * as by the functions for the host; but as nothing waits, the status says no more than that the
 * work was queued. Overlaps are the same as on the host: the few that the device's arithmetic
 * cannot decide, and bad pairs, are sent to the host in the order of the stream, decided there by
 * pw85_overlap_batch() in a thread of the driver, and sent back.
 *
 * A device has no more digits than double. Where it cannot prove μ² or λ, which happens for aspect
 * ratios beyond 10⁵, the result is the best that double gives, and whether a nearly singular form
 * is positive definite is decided to rounding: beyond aspect ratios of 10⁷ use the functions for
 * the host.
 *
 * Where a call returns #PW85_EDEVICE, part of the work may have been queued: outputs have no
 * meaning.
 * @{ */

/** pw85_contact_batch() on the device. The relative error of μ² is below 4 u cond, as there; the
 * bits may differ.
 *
 * @param stream CUstream
 * @param n [number of pairs] 0 is fine
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] mu2 [n]
 * @param[out] lambda [n; optional]
 * @return #PW85_SUCCESS: the work was queued; #PW85_EINVAL (a null pointer, one that is not the
 *         device's, a size that overflows), #PW85_EDEVICE */
PW85_API int pw85_gpu_contact_batch(void *stream, size_t n, double const *r12, double const *q1,
                                    double const *q2, double *mu2, double *lambda);

/** pw85_overlap_batch() on the device; arguments as for pw85_gpu_contact_batch().
 *
 * @param stream,n,r12,q1,q2 [as pw85_gpu_contact_batch()]
 * @param[out] overlap [n] 1, 0, or 255 for a bad pair
 * @return as for pw85_gpu_contact_batch() */
PW85_API int pw85_gpu_overlap_batch(void *stream, size_t n, double const *r12, double const *q1,
                                    double const *q2, unsigned char *overlap);

/** pw85_contact_derivatives_batch() on the device; arguments as for pw85_gpu_contact_batch().
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

/** pw85_contact_pairs() on the device.
 *
 * @param stream CUstream
 * @param list the pairs: arrays of the device
 * @param system the particles: arrays of the device, except the cell, which is in the memory of
 *        the host. The structs and the cell are read before the call returns.
 * @param[out] mu2 [num_pairs]
 * @param[out] lambda [num_pairs; optional]
 * @return as for pw85_gpu_contact_batch(); #PW85_EINVAL also for a bad cell, as for
 *        pw85_contact_pairs() */
PW85_API int pw85_gpu_contact_pairs(void *stream, pw85_pair_list const *list,
                                    pw85_system const *system, double *mu2, double *lambda);

/** pw85_overlap_pairs() on the device; arguments as for pw85_gpu_contact_pairs().
 *
 * @param stream,list,system [as pw85_gpu_contact_pairs()]
 * @param[out] overlap [num_pairs] 1, 0, or 255 for a bad pair */
PW85_API int pw85_gpu_overlap_pairs(void *stream, pw85_pair_list const *list,
                                    pw85_system const *system, unsigned char *overlap);

/** pw85_contact_derivatives_pairs() on the device; arguments as for pw85_gpu_contact_pairs(),
 * outputs as for pw85_gpu_contact_derivatives_batch().
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
 * Pairs are sent to the device, and results back, in pieces: one piece is copied while another one
 * is computed. The functions return when all is done, with the status of the first bad pair, as the
 * functions for the host do. The transfer to the device dominates the time, 120 bytes per pair:
 * these functions are for programs that have no better use for their processor. @{ */

/** pw85_contact_batch() by the device; arguments as there.
 *
 * @param n [number of pairs] 0 is fine
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] mu2 [n]
 * @param[out] lambda [n; optional]
 * @return #PW85_SUCCESS, #PW85_EINVAL, or the status of the first bad pair; #PW85_EDEVICE, with
 *        all outputs NaN */
PW85_API int pw85_gpu_contact_host(size_t n, double const *r12, double const *q1, double const *q2,
                                   double *mu2, double *lambda);

/** pw85_overlap_batch() by the device; arguments as for pw85_gpu_contact_host(), overlap as for
 * pw85_gpu_overlap_batch().
 *
 * @param n,r12,q1,q2 [as pw85_gpu_contact_host()]
 * @param[out] overlap [as pw85_gpu_overlap_batch()]
 * @return as for pw85_gpu_contact_host(); #PW85_EDEVICE with all overlaps 255 */
PW85_API int pw85_gpu_overlap_host(size_t n, double const *r12, double const *q1, double const *q2,
                                   unsigned char *overlap);

/** pw85_contact_derivatives_batch() by the device; arguments as for pw85_gpu_contact_host(),
 * outputs as for pw85_gpu_contact_derivatives_batch().
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

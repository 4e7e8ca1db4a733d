/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85_zheng.h
 * @brief Distance of closest approach by the algorithms of Zheng and Palffy-Muhoray (library
 * pw85_legacy).
 *
 * These functions are an independent check of pw85_closest_approach() and
 * pw85_closest_approach_2d(). In three dimensions pw85_closest_approach() is several times faster.
 * The error of pw85_zheng_ellipses() is that of the contact function (2 u cond). The error of
 * pw85_zheng_ellipsoids() is below u (κ1 + κ2) with κ = tr Q tr Q⁻¹, about the square of the aspect
 * ratio: 1e-13 at aspect ratio 100, 1e-9 at 10⁴. Conventions are those of pw85.h.
 *
 * X. Zheng and P. Palffy-Muhoray, Phys. Rev. E 75, 061709 (2007); X. Zheng, W. Iglesias and P.
 * Palffy-Muhoray, Phys. Rev. E 79, 057702 (2009).
 */
#ifndef PW85_ZHENG_H_INCLUDED
#define PW85_ZHENG_H_INCLUDED

#include <pw85.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Computes the distance of closest approach of two ellipses, in closed form (the root of a
 * quartic).
 *
 * @param direction,q1,q2 [as pw85_closest_approach_2d()]
 * @param[out] distance [length] of the centres at external tangency
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_zheng_ellipses(double const direction[2], double const q1[3], double const q2[3],
                                 double *distance);

/** Computes the distance of closest approach of two ellipsoids.
 *
 * A plane through the line of centres cuts out two ellipses. The result is the largest distance of
 * closest approach of the two, as the plane rotates about the line.
 *
 * @param direction,q1,q2 [as pw85_closest_approach()]
 * @param[out] distance [length] of the centres at external tangency
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_zheng_ellipsoids(double const direction[3], double const q1[6],
                                   double const q2[6], double *distance);

#ifdef __cplusplus
}
#endif

#endif

/* SPDX-License-Identifier: BSD-3-Clause */
/* What Python is measured against: the same calls from C. */
#include <stddef.h>

#include <pw85.h>

/** pw85_contact() n times for the same pair. */
PW85_API void c_contact_again(size_t n, double const *r12, double const *q1, double const *q2,
                              double out[2]);

/** pw85_contact_function() n times for the same pair. */
PW85_API void c_contact_function_again(size_t n, double const *r12, double const *q1,
                                       double const *q2, double out[2]);

void c_contact_again(size_t n, double const *r12, double const *q1, double const *q2, double out[2])
{
    for (size_t i = 0; i < n; ++i) pw85_contact(r12, q1, q2, out);
}

void c_contact_function_again(size_t n, double const *r12, double const *q1, double const *q2,
                              double out[2])
{
    for (size_t i = 0; i < n; ++i) pw85_contact_function(r12, q1, q2, out);
}

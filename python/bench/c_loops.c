/* What Python is measured against: the same calls from C. */
#include <stddef.h>

#include <pw85.h>

/** pw85_contact_function() for n pairs; arrays as for pw85_contact_batch(). */
PW85_API void c_contact_function(size_t n, double const *r12, double const *q1, double const *q2, double *mu2,
                                 double *lambda);

/** pw85_contact_batch(). */
PW85_API void c_contact(size_t n, double const *r12, double const *q1, double const *q2, double *mu2, double *lambda);

/** pw85_contact() n times for the same pair. */
PW85_API void c_contact_again(size_t n, double const *r12, double const *q1, double const *q2, double out[2]);

/** pw85_contact_function() n times for the same pair. */
PW85_API void c_contact_function_again(size_t n, double const *r12, double const *q1, double const *q2, double out[2]);

void c_contact_function(size_t n, double const *r12, double const *q1, double const *q2, double *mu2, double *lambda)
{
    for (size_t i = 0; i < n; ++i) {
        double out[2];
        pw85_contact_function(r12 + i * PW85_DIM, q1 + i * PW85_SYM, q2 + i * PW85_SYM, out);
        mu2[i] = out[0];
        lambda[i] = out[1];
    }
}

void c_contact(size_t n, double const *r12, double const *q1, double const *q2, double *mu2, double *lambda)
{
    pw85_contact_batch(n, r12, q1, q2, mu2, lambda);
}

void c_contact_again(size_t n, double const *r12, double const *q1, double const *q2, double out[2])
{
    for (size_t i = 0; i < n; ++i) pw85_contact(r12, q1, q2, out);
}

void c_contact_function_again(size_t n, double const *r12, double const *q1, double const *q2, double out[2])
{
    for (size_t i = 0; i < n; ++i) pw85_contact_function(r12, q1, q2, out);
}

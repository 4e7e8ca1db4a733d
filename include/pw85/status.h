/* SPDX-License-Identifier: BSD-3-Clause */
/* The status codes of pw85: the one list behind the C enum, the C++ enum, the texts of
   pw85_strerror() and the table in the documentation. Append only: the numbers are compiled into
   programs. */
#ifndef PW85_STATUS_H_INCLUDED
#define PW85_STATUS_H_INCLUDED

/* X(C name, C++ name, value, text). The errors are a separate list, so that the enum in pw85.h can
   put a comma before each of them: C89 allows no comma after the last enumerator. */
#define PW85_STATUS_LIST(X)                                                                        \
    X(PW85_SUCCESS, success, 0, "success")                                                         \
    PW85_ERROR_LIST(X)
#define PW85_ERROR_LIST(X)                                                                         \
    X(PW85_EINVAL, invalid_argument, 1, "invalid argument; see pw85_last_error()")                 \
    X(PW85_ENOTPD, not_positive_definite, 2, "a quadratic form is not positive definite")          \
    X(PW85_ECONVERGENCE, no_convergence, 3, "the iterations did not converge")                     \
    X(PW85_ENOMEM, out_of_memory, 4, "not enough memory")                                          \
    X(PW85_EDEVICE, no_device, 5, "no usable GPU, or not enough GPU memory")                       \
    X(PW85_EOVERLAP, overlap, 6, "two particles overlap, or a wall cuts a particle")               \
    X(PW85_EPOTENTIAL, bad_potential, 7,                                                           \
      "the energy of a particle is NaN or infinite where it must be finite, or the potential of "  \
      "a restored simulation is not set")

#endif

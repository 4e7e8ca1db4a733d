// SPDX-License-Identifier: BSD-3-Clause
// The pair of the tutorial, by the headers and the libraries that were installed, from C++20:
// headers.cpp has all headers once.
#include <pw85.h>
#include <pw85/contact/contact.hpp>
#include <pw85/contact/forms.hpp>
#include <pw85_legacy.h>
#ifndef WITHOUT_SYSTEMS
#include <pw85_gpu.h>
#endif

#include <cstdio>

int main()
{
    pw85::Vector const r12{0.7, -0.7, 1.1};
    auto const [q1, status1] = pw85::spheroid(10.0, 0.1, pw85::Vector{0.0, 0.0, 1.0});
    auto const [q2, status2] = pw85::spheroid(0.5, 5.0, pw85::Vector{1.0, 0.0, 0.0});
    auto const [mu2, lambda, status] = pw85::contact(r12, q1, q2);
    double out[2], legacy[2];
    if (pw85_contact_function(r12.coordinates, q1.entries, q2.entries, out) != PW85_SUCCESS)
        return 1;
    if (pw85_legacy_contact_function2(r12.coordinates, q1.entries, q2.entries, legacy) !=
        PW85_SUCCESS)
        return 2;
#ifndef WITHOUT_SYSTEMS
    int devices;
    if (pw85_gpu_count(&devices) != (devices > 0 ? PW85_SUCCESS : PW85_EDEVICE)) return 4;
#endif
    std::printf("mu^2 = %g\nlambda = %g\n", mu2, lambda);
    return status == pw85::Status::success ? 0 : 3;
}

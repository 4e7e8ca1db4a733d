// SPDX-License-Identifier: BSD-3-Clause
// The pair of the tutorial, by the headers alone. One way of building it has all headers: the
// others compile less.
#ifdef ALL_HEADERS
#include <pw85/pw85.hpp>
#else
#include <pw85/contact/contact.hpp>
#include <pw85/contact/forms.hpp>
#endif

#include <cstdio>

int main()
{
    auto const q1 = pw85::spheroid(10.0, 0.1, pw85::Vector{0.0, 0.0, 1.0}).q;
    auto const q2 = pw85::spheroid(0.5, 5.0, pw85::Vector{1.0, 0.0, 0.0}).q;
    auto const c = pw85::contact(pw85::Vector{0.7, -0.7, 1.1}, q1, q2);
    std::printf("mu^2 = %g\nlambda = %g\n", c.mu2, c.lambda);
    return c.status == pw85::Status::success ? 0 : 1;
}

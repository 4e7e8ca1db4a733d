// SPDX-License-Identifier: BSD-3-Clause
#include "every_header_backwards.hpp"

double contact_in_the_other_unit();

double contact_in_the_other_unit()
{
    pw85::Vector<double, 3> const r12{3.0, 0.0, 0.0};
    pw85::SymmetricMatrix<double, 3> const q{1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    return pw85::contact(r12, q, q).mu2;
}

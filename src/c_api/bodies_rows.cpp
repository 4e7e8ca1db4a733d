// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows without lanes: surface and inertia of bodies.
//
// Made from pw85.h, pw85_grains.h, pw85_shapes.h and api/pw85_batch.h.in by api/committed.py.
#include <pw85_batch.h>

#include "../rows/each_row.hpp"

using namespace pw85::detail::kernels;

int pw85_surface_area_batch(size_t n, double const *q, double *area)
{
    return each_row("pw85_surface_area_batch", n, pw85_surface_area, RowsOf<6>{"q", q},
                    RowsOf<1, double>{"area", area});
}

int pw85_second_moments_batch(size_t n, double const *q, double *moments)
{
    return each_row("pw85_second_moments_batch", n, pw85_second_moments, RowsOf<6>{"q", q},
                    RowsOf<6, double>{"moments", moments});
}

int pw85_from_moments_batch(size_t n, double const *second_moments, double *q)
{
    return each_row("pw85_from_moments_batch", n, pw85_from_moments,
                    RowsOf<6>{"second_moments", second_moments}, RowsOf<6, double>{"q", q});
}

int pw85_shell_moments_batch(size_t n, double const *q, double *moments)
{
    return each_row("pw85_shell_moments_batch", n, pw85_shell_moments, RowsOf<6>{"q", q},
                    RowsOf<6, double>{"moments", moments});
}

int pw85_inertia_batch(size_t n, double const *q, int shell, double *inertia)
{
    return each_row("pw85_inertia_batch", n, pw85_inertia, RowsOf<6>{"q", q}, SameNumber{shell},
                    RowsOf<6, double>{"inertia", inertia});
}

// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows without lanes: surface and inertia of bodies.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/each_row.hpp"

using namespace pw85::detail::kernels;

int pw85_surface_area_batch(size_t n, double const *q, double *area)
{
    static constexpr char const *names[] = {"pw85_surface_area_batch", "q", "area"};
    return each_row(names, n, pw85_surface_area, RowsOf<6>{q}, RowsOf<1, double>{area});
}

int pw85_second_moments_batch(size_t n, double const *q, double *moments)
{
    static constexpr char const *names[] = {"pw85_second_moments_batch", "q", "moments"};
    return each_row(names, n, pw85_second_moments, RowsOf<6>{q}, RowsOf<6, double>{moments});
}

int pw85_from_moments_batch(size_t n, double const *second_moments, double *q)
{
    static constexpr char const *names[] = {"pw85_from_moments_batch", "second_moments", "q"};
    return each_row(names, n, pw85_from_moments, RowsOf<6>{second_moments}, RowsOf<6, double>{q});
}

int pw85_shell_moments_batch(size_t n, double const *q, double *moments)
{
    static constexpr char const *names[] = {"pw85_shell_moments_batch", "q", "moments"};
    return each_row(names, n, pw85_shell_moments, RowsOf<6>{q}, RowsOf<6, double>{moments});
}

int pw85_inertia_batch(size_t n, double const *q, int shell, double *inertia)
{
    static constexpr char const *names[] = {"pw85_inertia_batch", "q", "shell", "inertia"};
    return each_row(names, n, pw85_inertia, RowsOf<6>{q}, SameNumber{shell},
                    RowsOf<6, double>{inertia});
}

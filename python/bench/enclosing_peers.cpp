// SPDX-License-Identifier: BSD-3-Clause
// Ellipsoids around points by CGAL, for compare_enclosing.py. Each function returns 1, or 0 where
// CGAL is not available, and times the algorithm alone.
#include <chrono>
#include <cstddef>
#include <vector>

#if __has_include(<CGAL/Approximate_min_ellipsoid_d.h>)
#define HAS_CGAL 1
#include <CGAL/Approximate_min_ellipsoid_d.h>
#include <CGAL/Approximate_min_ellipsoid_d_traits_d.h>
#include <CGAL/Cartesian_d.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/MP_Float.h>
#include <CGAL/Min_ellipse_2.h>
#include <CGAL/Min_ellipse_2_traits_2.h>
#include <CGAL/Simple_cartesian.h>
#else
#define HAS_CGAL 0
#endif

namespace {

using Clock = std::chrono::steady_clock;

[[maybe_unused]] double seconds_since(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace

extern "C" {

/// Approximate_min_ellipsoid_d: the ellipsoid xᵀEx + eᵀx + eta <= 0 around m points in n
/// dimensions. The rows of the result are E, then e, then eta.
[[gnu::visibility("default")]] int
cgal_ellipsoid([[maybe_unused]] int n, [[maybe_unused]] std::size_t m,
               [[maybe_unused]] double const *points, [[maybe_unused]] double epsilon,
               [[maybe_unused]] double *result, [[maybe_unused]] double *seconds)
{
#if HAS_CGAL
    using Kernel = CGAL::Cartesian_d<double>;
    using Traits = CGAL::Approximate_min_ellipsoid_d_traits_d<Kernel, CGAL::MP_Float>;
    std::vector<Kernel::Point_d> all;
    for (std::size_t i = 0; i < m; ++i) {
        double const *const x = points + i * static_cast<std::size_t>(n);
        all.emplace_back(n, x, x + n);
    }
    auto const start = Clock::now();
    Traits traits;
    CGAL::Approximate_min_ellipsoid_d<Traits> found(epsilon, all.begin(), all.end(), traits);
    *seconds = seconds_since(start);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) *result++ = CGAL::to_double(found.defining_matrix(i, j));
    for (int i = 0; i < n; ++i) *result++ = CGAL::to_double(found.defining_vector(i));
    // CGAL scales all by the same factor, and adds it to the scalar.
    double const scale = (1.0 + found.achieved_epsilon()) * (n + 1);
    *result = CGAL::to_double(found.defining_scalar()) - scale;
    return 1;
#else
    return 0;
#endif
}

/// Min_ellipse_2 with rational numbers: the coefficients of r x² + s y² + t x y + u x + v y + w.
[[gnu::visibility("default")]] int cgal_ellipse([[maybe_unused]] std::size_t m,
                                                [[maybe_unused]] double const *points,
                                                [[maybe_unused]] double *result,
                                                [[maybe_unused]] double *seconds)
{
#if HAS_CGAL
    using Kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
    std::vector<Kernel::Point_2> all;
    for (std::size_t i = 0; i < m; ++i) all.emplace_back(points[2 * i], points[2 * i + 1]);
    auto const start = Clock::now();
    CGAL::Min_ellipse_2<CGAL::Min_ellipse_2_traits_2<Kernel>> found(all.begin(), all.end(), true);
    *seconds = seconds_since(start);
    found.ellipse().double_coefficients(result[0], result[1], result[2], result[3], result[4],
                                        result[5]);
    return 1;
#else
    return 0;
#endif
}
}

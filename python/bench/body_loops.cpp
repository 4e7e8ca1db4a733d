// SPDX-License-Identifier: BSD-3-Clause
// Loops over ellipsoids for compare_bodies.py: the C functions of this library, and what a user of
// Boost writes for the same numbers. Boost has no ellipsoids, so its loops get semi-axes, the
// longest one first, and their results belong to the principal axes.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include <pw85.h>
#include <pw85_enclosing.h>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rg.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>
#include <boost/random/uniform_on_sphere.hpp>
#pragma GCC diagnostic pop

namespace {

double boost_area(double const *a)
{
    using std::numbers::pi;
    double const p[] = {1 / (a[0] * a[0]), 1 / (a[1] * a[1]), 1 / (a[2] * a[2])};
    return 4 * pi * a[0] * a[1] * a[2] * boost::math::ellint_rg(p[0], p[1], p[2]);
}

/// Legendre's formula, for a > b > c.
double boost_legendre_area(double const *axes)
{
    double const a = axes[0], b = axes[1], c = axes[2], cosine = c / a,
                 sine = std::sqrt((1 - cosine) * (1 + cosine)), phi = std::acos(cosine),
                 k = a * std::sqrt((b - c) * (b + c)) / (b * std::sqrt((a - c) * (a + c)));
    return 2 * std::numbers::pi *
           (c * c + a * b / sine *
                        (sine * sine * boost::math::ellint_2(k, phi) +
                         cosine * cosine * boost::math::ellint_1(k, phi)));
}

/// The principal moments of inertia of a shell of unit mass per area.
void boost_shell(double const *a, double *inertia)
{
    double p[3], parts[3], moments[3];
    for (int i = 0; i < 3; ++i) p[i] = 1 / (a[i] * a[i]);
    double const r_g = boost::math::ellint_rg(p[0], p[1], p[2]),
                 area = 4 * std::numbers::pi * a[0] * a[1] * a[2] * r_g;
    for (int i = 0; i < 3; ++i)
        parts[i] = p[i] * boost::math::ellint_rd(p[(i + 1) % 3], p[(i + 2) % 3], p[i]);
    for (int i = 0; i < 3; ++i)
        moments[i] = a[i] * a[i] / 4 + (parts[(i + 1) % 3] + parts[(i + 2) % 3]) / (24 * r_g);
    for (int i = 0; i < 3; ++i) inertia[i] = area * (moments[(i + 1) % 3] + moments[(i + 2) % 3]);
}

using Generator = boost::random::mt19937_64;

void boost_inside(Generator &random, double const *a, double *x)
{
    boost::random::uniform_on_sphere<double> sphere(3);
    auto const n = sphere(random);
    double const r = std::cbrt(boost::random::uniform_01<double>()(random));
    for (std::size_t i = 0; i < 3; ++i) x[i] = r * a[i] * n[i];
}

/// The same rejection as in pw85_random_points().
void boost_on_surface(Generator &random, double const *a, double *x)
{
    boost::random::uniform_on_sphere<double> sphere(3);
    boost::random::uniform_01<double> uniform;
    for (;;) {
        auto const n = sphere(random);
        double square = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            double const kept = n[i] * a[2] / a[i];
            square += kept * kept;
            x[i] = a[i] * n[i];
        }
        double const height = uniform(random);
        if (height * height < square) return;
    }
}

} // namespace

#define PW85_LOOP(name, in, in_size, out_size, call)                                               \
    extern "C" PW85_API void name(std::size_t n, double const *in, double *out);                   \
    void name(std::size_t n, double const *in, double *out)                                        \
    {                                                                                              \
        for (std::size_t i = 0; i < n; ++i, in += in_size, out += out_size) call;                  \
    }

PW85_LOOP(pw85_loop_area, q, 6, 1, pw85_surface_area(q, out))
PW85_LOOP(pw85_loop_perimeter, q, 3, 1, pw85_perimeter_2d(q, out))
PW85_LOOP(pw85_loop_solid, q, 6, 6, pw85_inertia(q, 0, out))
PW85_LOOP(pw85_loop_shell, q, 6, 6, pw85_inertia(q, 1, out))
PW85_LOOP(boost_loop_area, a, 3, 1, *out = boost_area(a))
PW85_LOOP(boost_loop_legendre_area, a, 3, 1, *out = boost_legendre_area(a))
PW85_LOOP(boost_loop_perimeter, a, 2, 1,
          *out = 4 * a[0] * boost::math::ellint_2(std::sqrt(1 - a[1] * a[1] / (a[0] * a[0]))))
PW85_LOOP(boost_loop_shell, a, 3, 3, boost_shell(a, out))

// Points of one ellipsoid.

#define PW85_POINTS(name, in, call)                                                                \
    extern "C" PW85_API void name(std::size_t n, double const *in, double *out);                   \
    void name(std::size_t n, double const *in, double *out) { call; }

PW85_POINTS(pw85_loop_inside, q, pw85_random_points(q, 0, 1, n, out))
PW85_POINTS(pw85_loop_on_surface, q, pw85_random_points(q, 1, 1, n, out))
PW85_POINTS(boost_loop_inside, a, Generator random(1);
            for (std::size_t i = 0; i < n; ++i) boost_inside(random, a, out + 3 * i))
PW85_POINTS(boost_loop_on_surface, a, Generator random(1);
            for (std::size_t i = 0; i < n; ++i) boost_on_surface(random, a, out + 3 * i))

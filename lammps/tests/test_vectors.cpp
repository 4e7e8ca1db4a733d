// SPDX-License-Identifier: GPL-2.0-only
// The angular velocity that without_inertia() finds from an angular momentum, beside the tensor of
// inertia of pw85_inertia().
#include <algorithm>
#include <cmath>
#include <random>

#include <glib.h>

#include <pw85.h>

#include "vectors.hpp"

using namespace pw85_lammps;

namespace {

/// Prints what random case failed.
void check(bool holds, char const *what, double const *axes, double found, double bound)
{
    if (holds) return;
    g_test_message("%s: %a, bound %a; semi-axes %a %a %a", what, found, bound, axes[0], axes[1],
                   axes[2]);
    g_test_fail();
}

/// I⁻¹ I ω = ω for bodies of random shapes, sizes and densities.
///
/// Let L >= M >= S be the principal moments, and κ = L/S. M is at least L/2, because L <= M + S.
/// The entries of I err by 4 u, so I ω errs by 7 √3 u L |ω| and ω by 12 u κ. The entries of the
/// adjugate err by 8 u L², the determinant by 30 u L³; divided by the determinant LMS, this is 48
/// u κ and 60 u κ.
void test_inertia()
{
    std::mt19937_64 random(20261129);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::normal_distribution<double> normal;
    for (int n = 0; n < 2000; ++n) {
        double const size = std::exp2(std::floor(-40.0 + 81.0 * uniform(random)));
        double axes[3], quaternion[4], q[6], volume, inertia[6];
        for (double &axis : axes) axis = size * std::exp2(6.0 * uniform(random));
        for (double &part : quaternion) part = normal(random);
        g_assert_cmpint(pw85_ellipsoid_quaternion(axes, quaternion, q), ==, PW85_SUCCESS);
        g_assert_cmpint(pw85_volume(q, &volume), ==, PW85_SUCCESS);
        g_assert_cmpint(pw85_inertia(q, 0, inertia), ==, PW85_SUCCESS);
        double const density = std::exp2(20.0 * normal(random));
        Vector const spin{normal(random), normal(random), normal(random)};
        Vector const found = without_inertia(density * volume, q, density * product(inertia, spin));
        std::sort(axes, axes + 3);
        double const kappa =
            (axes[2] * axes[2] + axes[1] * axes[1]) / (axes[1] * axes[1] + axes[0] * axes[0]);
        Vector const difference = found - spin;
        double const away = std::sqrt(dot(difference, difference) / dot(spin, spin)),
                     bound = 128.0 * 0x1p-53 * kappa;
        check(away <= bound, "relative error of the spin", axes, away, bound);
    }
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    g_test_add_func("/lammps/vectors/inertia", test_inertia);
    return g_test_run();
}

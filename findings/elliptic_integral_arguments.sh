#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Libraries define the arguments of elliptic integrals in four ways, and no function detects arguments of another convention.
#
# Debian 12: GSL 2.7.1, the C++17 library of GCC 12.2, Boost 1.74, SciPy 1.10.1, mpmath 1.2.1. For k = 1/2, m = k² = 1/4, n = 0.3, phi = 1,
# seen on 29 November 2026:
#
#   K = 1.685750     GSL, std, Boost take the modulus k; SciPy and mpmath the parameter m. ellipk(0.5) is 1.854075
#   F = 1.037356     std and Boost: (k, phi); GSL: (phi, k); SciPy and mpmath: (phi, m)
#   Pi(n) = 2.027792 std (k, n), Boost (k, n), mpmath (n, m)
#         = 1.471568 GSL (k, n): its n has the opposite sign (1 + n sin²)
#   Pi(n, phi) =     std (k, n, phi), Boost (k, n, phi), GSL (phi, k, n), mpmath (n, phi, m)
#
# Carlson's symmetric integrals (R_F, R_D, R_G, R_J) have no such choice: SciPy and mpmath agree on elliprg and elliprd.
# Needs g++, libgsl-dev, python3-scipy, python3-mpmath (these three are taken from the system) and apt-get, for Boost's headers.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -qq libboost1.74-dev=1.74.0+ds1-21 2>/dev/null
dpkg -x libboost1.74-dev*.deb .
cat >check.cpp <<'EOF'
#include <gsl/gsl_sf_ellint.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <cmath>
#include <cstdio>

int main() {
  double const k = 0.5, n = 0.3, phi = 1;
  std::printf("%.9f %.9f %.9f\n", std::comp_ellint_1(k), boost::math::ellint_1(k), gsl_sf_ellint_Kcomp(k, 0));
  std::printf("%.9f %.9f %.9f\n", std::ellint_1(k, phi), boost::math::ellint_1(k, phi), gsl_sf_ellint_F(phi, k, 0));
  std::printf("%.9f %.9f %.9f\n", std::comp_ellint_3(k, n), boost::math::ellint_3(k, n), gsl_sf_ellint_Pcomp(k, n, 0));
  std::printf("%.9f %.9f %.9f\n", std::ellint_3(k, n, phi), boost::math::ellint_3(k, n, phi), gsl_sf_ellint_P(phi, k, n, 0));
}
EOF
g++ -w -std=c++17 -O0 -I usr/include check.cpp -o check -lgsl -lgslcblas -lm
./check >numbers
cat numbers
/usr/bin/python3 - <<'EOF'
import mpmath
from scipy import special

k, m, n, phi = 0.5, 0.25, 0.3, 1.0
(std_K, boost_K, gsl_K), (std_F, boost_F, gsl_F), (std_P, boost_P, gsl_P), (std_Pi, boost_Pi, gsl_Pi) = (
    [float(x) for x in line.split()] for line in open("numbers"))


def same(*values):
    return max(values) - min(values) < 1e-8


assert same(std_K, boost_K, gsl_K, special.ellipk(m), float(mpmath.ellipk(m)), 1.685750355)
assert same(special.ellipk(k), float(mpmath.ellipk(k)), 1.854074677)  # the modulus, taken for the parameter
assert same(std_F, boost_F, gsl_F, special.ellipkinc(phi, m), float(mpmath.ellipf(phi, m)))
assert same(std_P, boost_P, float(mpmath.ellippi(n, m)), 2.027792446)
assert same(gsl_P, float(mpmath.ellippi(-n, m)), 1.471568194)  # the other sign
assert same(std_Pi, boost_Pi, float(mpmath.ellippi(n, phi, m))) and same(gsl_Pi, float(mpmath.ellippi(-n, phi, m)))
assert same(special.elliprg(1, 4, 9), float(mpmath.elliprg(1, 4, 9))) and same(special.elliprd(1, 4, 9), float(mpmath.elliprd(1, 4, 9)))
EOF

#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The angles phi, theta, psi of matGeom's ellipsoids are those of z-y-x, in degrees, not Euler's z-x-z.
#
# matGeom (Debian 12, octave-matgeom 1.2.3-3): eulerAnglesToRotation3d(40, 20, 50), by which drawEllipsoid turns the row
# [xc yc zc a b c phi theta psi], is Rz(40) Ry(20) Rx(50). The names phi theta psi stand for z-x-z in mechanics and
# crystallography: Rz(40) Rx(20) Rz(50) differs from it by up to 0.76 in an entry. MorphoLibJ and Fiji's tables use the same names in
# matGeom's sense.
# Needs octave, apt-get and dpkg.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -q octave-matgeom=1.2.3-3 >/dev/null
dpkg -x octave-matgeom_*.deb .
folder=$(dirname "$(find "$dir" -name eulerAnglesToRotation3d.m)")
cat >check.m <<EOF
addpath(genpath("$(dirname "$folder")"));
x = @(t) [1 0 0; 0 cosd(t) -sind(t); 0 sind(t) cosd(t)];
y = @(t) [cosd(t) 0 sind(t); 0 1 0; -sind(t) 0 cosd(t)];
z = @(t) [cosd(t) -sind(t) 0; sind(t) cosd(t) 0; 0 0 1];
r = eulerAnglesToRotation3d(40, 20, 50)(1:3, 1:3);
printf("from z-y-x %.1e, from z-x-z %.2f\n", max(max(abs(r - z(40)*y(20)*x(50)))), max(max(abs(r - z(40)*x(20)*z(50)))));
assert(max(max(abs(r - z(40)*y(20)*x(50)))) < 1e-12);
assert(max(max(abs(r - z(40)*x(20)*z(50)))) > 0.5);
EOF
octave-cli --quiet --no-init-file check.m

#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# In regionprops of Octave and MATLAB, the angle Orientation is counterclockwise on the screen, but the y of Centroid grows downward.
#
# Octave's package image (Debian 12, octave-image 2.14.0-4) on an ellipse of semi-axes 24 and 8 whose longer axis is turned by 30
# degrees from x (columns) towards y (rows, downward), with its centre in column 70 and row 60, counted from 1:
#   Centroid 70 60, MajorAxisLength 47.7 (the whole axis), Orientation -29.99 degrees
# The documentation says "the angle between the x-axis and the major axis". The points Centroid + (cos, sin) of that angle are those of
# the mirror image: the second coordinate of Centroid grows downward and the angle grows upward. scikit-image has the same names in
# its tables (axis_major_length, orientation), but radians, from the axis of rows, and centres counted from 0.
# Needs octave, apt-get and dpkg.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -q octave-image=2.14.0-4 >/dev/null
dpkg -x octave-image_*.deb .
cat >check.m <<EOF
addpath(genpath("$dir/usr"));
[x, y] = meshgrid(1:150, 1:130);
for degrees = [30 -30 60 -75]
  c = cosd(degrees); s = sind(degrees);
  u = c * (x - 70) + s * (y - 60); v = -s * (x - 70) + c * (y - 60);
  one = regionprops((u / 24).^2 + (v / 8).^2 <= 1, "Centroid", "MajorAxisLength", "Orientation")(1);
  printf("%g from x towards y: Centroid %g %g, MajorAxisLength %.1f, Orientation %.2f\\n", degrees, one.Centroid, one.MajorAxisLength, ...
         one.Orientation);
  assert(abs(one.Orientation + degrees) < 0.5);
  assert(abs(one.MajorAxisLength - 48) < 0.6);
  assert(norm(one.Centroid - [70 60]) < 0.01);
end
EOF
octave-cli --quiet --no-init-file check.m

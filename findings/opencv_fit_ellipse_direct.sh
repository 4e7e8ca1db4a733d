#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# fitEllipseDirect returns a wrong ellipse for points that lie exactly on an ellipse, and the more points there are, the sooner: the
# lengths for 100 points of a quarter are a fifth too short, those for 20 points of it are right. fitEllipse is right for both.
#
# OpenCV 4.6.0 (Debian 12, libopencv-imgproc406 4.6.0+dfsg-12). Points at equal steps of the parameter along a part of the ellipse with the
# whole axes 48 and 16 around (70, 60), turned by 30 degrees; whole axes and angle of the result, seen on 30 November 2026:
#
#   part   points   fitEllipse           fitEllipseAMS        fitEllipseDirect
#   360°   100      48.00  16.00  120°   48.00  16.00  120°   47.99  16.01  120.0°
#   180°   100      48.00  16.00  120°   48.00  16.00  120°   47.85  15.79  120.0°
#   120°   20       48.00  16.00  120°   48.00  16.00  120°   45.06  14.43  118.6°
#   90°    20       48.00  16.00  120°   48.00  16.00  120°   48.00  16.00  120.0°
#   90°    100      48.00  16.00  120°   48.00  16.00  120°   38.25  12.49  115.9°
#   60°    100      48.00  16.00  120°   48.00  16.00  120°   25.33   9.47  110.1°
#
# The function takes a determinant below 1e-10 for a degenerate set and moves the points on purpose by about a hundredth of their spread.
# The determinant of exact points is rounding, and that of any points falls with their number (issue 28627 of OpenCV). A measuring error
# of 0.001 makes no difference for 100 points of a quarter. The angle is that of the shorter axis, in all three functions.
# Needs g++ and apt-get.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
version=4.6.0+dfsg-12
missing=$(apt-get install -s --no-install-recommends libopencv-imgproc406=$version 2>/dev/null | awk '/^Inst/ && !/opencv/ { print $2 }')
# shellcheck disable=SC2086 # a list of words
apt-get download -qq libopencv-core-dev=$version libopencv-core406=$version libopencv-imgproc-dev=$version libopencv-imgproc406=$version \
  $missing 2>/dev/null
for package in *.deb; do dpkg -x "$package" .; done
cat >check.cpp <<'END'
#include <cmath>
#include <cstdio>
#include <opencv2/imgproc.hpp>

using Points = std::vector<cv::Point2f>;

static double const degree = std::acos(-1.0) / 180;

static Points on_ellipse(double part, int n) {
  double const c = std::cos(30 * degree), s = std::sin(30 * degree);
  Points points;
  for (int i = 0; i < n; i++) {
    double const t = part * degree * i / n, x = 24 * std::cos(t), y = 8 * std::sin(t);
    points.emplace_back(static_cast<float>(70 + x * c - y * s), static_cast<float>(60 + x * s + y * c));
  }
  return points;
}

static bool is(cv::RotatedRect const &ellipse, double longer, double shorter, double angle) {
  printf("  %.2f %.2f %.1f", ellipse.size.height, ellipse.size.width, ellipse.angle);
  return std::fabs(ellipse.size.height - longer) < 0.02 && std::fabs(ellipse.size.width - shorter) < 0.02 &&
         std::fabs(ellipse.angle - angle) < 0.1;
}

static int wrong(double part, int n, double longer, double shorter, double angle) {
  Points const points = on_ellipse(part, n);
  printf("part %g, points %d", part, n);
  bool const right = is(cv::fitEllipse(points), 48, 16, 120) & is(cv::fitEllipseAMS(points), 48, 16, 120) &
                     is(cv::fitEllipseDirect(points), longer, shorter, angle);
  printf("\n");
  return !right;
}

int main() {
  return wrong(360, 100, 47.99, 16.01, 120) + wrong(180, 100, 47.85, 15.79, 120) + wrong(120, 20, 45.065, 14.43, 118.61) +
         wrong(90, 20, 48, 16, 120) + wrong(90, 100, 38.254, 12.49, 115.88) + wrong(60, 100, 25.333, 9.474, 110.1);
}
END
libraries=$dir/usr/lib/x86_64-linux-gnu
g++ -std=c++17 -O1 -w -Iusr/include/opencv4 -Iusr/include/x86_64-linux-gnu/opencv4 check.cpp -o check \
  "$libraries/libopencv_imgproc.so.406" "$libraries/libopencv_core.so.406" -Wl,-rpath-link,"$libraries"
LD_LIBRARY_PATH=$libraries ./check

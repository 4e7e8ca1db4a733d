#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Particles that are measured by their contour are a pixel too short and too narrow: an ellipse with the axes 10 and 4 gets 9.0 and 3.3 by
# fitEllipse, and contourArea has 68 % of its area. The moments of the picture are right.
#
# OpenCV 4.6.0 (Debian 12, libopencv-imgproc406 4.6.0+dfsg-12). Pictures in which a pixel is set if its centre is within an ellipse; means of
# 180 directions with random centres, and areas divided by the true one, seen on 1 December 2026:
#
#   whole axes   fitEllipse(contour)   moments(contour)   moments(picture)   contourArea   pixels
#   10    4      8.98     3.31         8.83    3.17       10.00    3.98      0.678         1.004
#   20    8      18.95    7.19         18.91   7.11       20.00    7.99      0.835         0.999
#   40   16      38.97   15.14         38.96   15.10      39.99   16.01      0.918         1.000
#   160  64     158.99   63.10        159.01   63.08     160.01   64.00      0.979         1.000
#
# findContours returns the centres of the outermost pixels, half a pixel within the edge of the body. By the theorem of Pick, contourArea is
# the number of pixels less half of those of the contour less 1, exactly. Small bodies come out more slender than they are, 2.7 instead
# of 2.5 in the first row. Axes of moments are four times the roots of the eigenvalues of mu20,
# mu11, mu02 divided by m00; moments(picture, true) has the whole pixels.
# opencv_fit_ellipse_direct.sh is about the fit itself.
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
#include <random>

static double const pi = std::acos(-1.0);

struct Axes {
  double longer = 0, shorter = 0;
  void add(double one, double other) { longer += std::fmax(one, other), shorter += std::fmin(one, other); }
  void add(cv::Moments const &m) {
    double const mean = (m.mu20 + m.mu02) / 2, half = std::hypot((m.mu20 - m.mu02) / 2, m.mu11);
    add(4 * std::sqrt((mean + half) / m.m00), 4 * std::sqrt((mean - half) / m.m00));
  }
};

static cv::Mat picture(double a, double b, double angle, double x0, double y0) {
  cv::Mat made = cv::Mat::zeros(200, 200, CV_8U);
  double const c = std::cos(angle), s = std::sin(angle);
  for (int y = 0; y < made.rows; y++)
    for (int x = 0; x < made.cols; x++)
      made.at<uchar>(y, x) = std::hypot((c * (x - x0) + s * (y - y0)) / a, (c * (y - y0) - s * (x - x0)) / b) <= 1 ? 255 : 0;
  return made;
}

static bool near(char const *what, double found, double expected, double tolerance) {
  printf("  %s %.3f", what, found);
  return std::fabs(found - expected) < tolerance;
}

static int wrong(double a, double b) {
  int const n = 180;
  std::mt19937 random(1);
  std::uniform_real_distribution<> fraction(-0.5, 0.5);
  Axes fitted, of_contour, of_picture;
  double area = 0, pixels = 0;
  bool right = true;
  for (int i = 0; i < n; i++) {
    double const x0 = 100 + fraction(random), y0 = 100 + fraction(random);
    cv::Mat const image = picture(a, b, i * pi / n, x0, y0);
    std::vector<std::vector<cv::Point>> contours;
    cv::findContours(image, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    std::vector<cv::Point> const &contour = contours[0];
    cv::Size2f const axes = cv::fitEllipse(contour).size;
    fitted.add(axes.width, axes.height);
    of_contour.add(cv::moments(contour));
    of_picture.add(cv::moments(image, true));
    area += cv::contourArea(contour);
    pixels += cv::countNonZero(image);
    right &= cv::contourArea(contour) == cv::countNonZero(image) - static_cast<double>(contour.size()) / 2 - 1; // Pick
  }
  printf("%g %g", 2 * a, 2 * b);
  right &= near("fit", fitted.longer / n, 2 * a - 1, 0.1) & near("", fitted.shorter / n, 2 * b - 0.85, 0.2);
  right &= near("contour", of_contour.longer / n, 2 * a - 1.1, 0.2) & near("", of_contour.shorter / n, 2 * b - 0.9, 0.1);
  right &= near("picture", of_picture.longer / n, 2 * a, 0.05) & near("", of_picture.shorter / n, 2 * b, 0.05);
  double const slices = (2 * a - 1) * (2 * b - 1) / (4 * a * b); // of an ellipse whose axes are 1 shorter
  right &= near("area", area / n / (pi * a * b), slices, 0.01) & near("pixels", pixels / n / (pi * a * b), 1, 0.01);
  printf(right ? "\n" : " unexpected\n");
  return !right;
}

int main() { return wrong(5, 2) + wrong(10, 4) + wrong(20, 8) + wrong(80, 32); }
END
libraries=$dir/usr/lib/x86_64-linux-gnu
g++ -std=c++17 -O1 -w -Iusr/include/opencv4 -Iusr/include/x86_64-linux-gnu/opencv4 check.cpp -o check \
  "$libraries/libopencv_imgproc.so.406" "$libraries/libopencv_core.so.406" -Wl,-rpath-link,"$libraries"
LD_LIBRARY_PATH=$libraries ./check

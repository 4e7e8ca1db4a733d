#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The default "95 %" ellipse of ggplot2 contains 90 % of a normal population, for any number of points. Other functions of R draw other
# ellipses of this level for the same points.
#
# Debian 12: R 4.2.2, r-cran-ggplot2 3.4.1+dfsg-1, r-cran-ellipse 0.4.3-1. Areas divided by pi sqrt(det S), where S is the covariance of the
# points, and the share of a normal population within, seen on 30 November 2026:
#
#                                        20000 normal points     10 given points
#   ellipse::ellipse(S)                  5.99     0.951          5.99
#   stat_ellipse(type = "norm")          5.98     0.951          8.49
#   stat_ellipse(), that is type = "t"   4.55     0.899          7.14
#
# The default fits a t distribution with 5 degrees of freedom (MASS::cov.trob) and takes its matrix, which is 0.761 of the covariance for
# normal points, with the radius sqrt(2 qf(0.95, 2, n - 1)) that belongs to a covariance. The radius of "norm" is the same; that of
# ellipse::ellipse is sqrt(qchisq(0.95, 2)) = 2.448. ggplot2 draws 51 chords, whose polygon has 0.997 of the area. The documentation of this
# version says that type "t" assumes a multivariate t distribution; later ones name cov.trob. Who reads semi-axes off such a picture has
# those of another level.
# Needs the libraries of R (libblas3, liblapack3, libtre5, libtirpc3, libgomp1), apt-get and dpkg.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
missing=$(apt-get install -s --no-install-recommends r-cran-ggplot2=3.4.1+dfsg-1 2>/dev/null | awk '/^Inst r-cran/ { print $2 }' |
  grep -v -x r-cran-ggplot2 || true)
# shellcheck disable=SC2086 # a list of words
apt-get download -qq r-base-core=4.2.2.20221110-2 r-cran-ellipse=0.4.3-1 r-cran-ggplot2=3.4.1+dfsg-1 $missing 2>/dev/null
for package in ./*.deb; do dpkg -x "$package" .; done
cat >check.R <<'EOR'
suppressPackageStartupMessages(library(ggplot2))

# The area of a closed polygon, divided by that of the ellipse x' S^-1 x = 1.
area <- function(points, S) {
  following <- points[c(seq_len(nrow(points))[-1], 1), ]
  abs(sum(points[, 1] * following[, 2] - following[, 1] * points[, 2])) / 2 / (pi * sqrt(det(S)))
}
drawn <- function(points, ...) {
  layer <- ggplot_build(ggplot(points, aes(x, y)) + stat_ellipse(...))$data[[1]]
  cbind(layer$x, layer$y)
}
outlines <- function(points)
  list(ellipse = ellipse::ellipse(cov(points), centre = colMeans(points), npoints = 2000),
       norm = drawn(points, type = "norm"), default = drawn(points))
areas <- function(points) sapply(outlines(points), area, S = cov(points))

# The share of a standard normal population in a polygon that is nearly a circle around its mean: over directions, 1 - exp(-r^2 / 2).
share <- function(outline) mean(1 - exp(-rowSums(outline[-1, ]^2) / 2))

# The matrix of a t distribution with 5 degrees of freedom that fits a normal population, in units of its covariance: where the mean
# of the weights (5 + 2) / (5 + r^2 / v) times r^2 / (2 v) is 1; r^2 / 2 has an exponential distribution.
weights <- function(v) integrate(function(t) exp(-t) * 7 / (5 + 2 * t / v) * t / v, 0, Inf)$value
v <- uniroot(function(v) weights(v) - 1, c(0.3, 1), tol = 1e-10)$root

set.seed(1)
many <- data.frame(x = rnorm(20000), y = rnorm(20000))
ten <- data.frame(x = c(-1, 1, -1, 1, 2, 0.3, 0.5, -0.7, -1.5, 0.2), y = c(-1, -0.5, 1, 1, 0.5, 1.7, -1.2, 0.2, 0.4, -0.6))
of_many <- areas(many)
shares <- sapply(outlines(many), share)
of_ten <- areas(ten)
radii <- sqrt(mahalanobis(drawn(ten, type = "norm"), colMeans(ten), cov(ten)))
print(of_many); print(shares); print(of_ten)
cat("matrix of the t distribution", v, "expected area", v * qchisq(0.95, 2), "and share", 1 - 0.05^v, "\n")
stopifnot(abs(of_many / qchisq(0.95, 2) - c(1, 1, v)) < 0.01, abs(shares - c(0.95, 0.95, 1 - 0.05^v)) < 0.005,
          shares["default"] < 0.91, abs(of_ten - c(5.99, 8.49, 7.14)) < 0.02, abs(radii - sqrt(2 * qf(0.95, 2, 9))) < 1e-6)
EOR
home=$dir/usr/lib/R
EDITOR=vi PAGER=cat R_HOME=$home LD_LIBRARY_PATH=$home/lib \
  R_LIBS=$dir/usr/lib/R/site-library:$home/library:/usr/lib/R/site-library:/usr/lib/R/library \
  "$home/bin/exec/R" --vanilla --no-echo -f check.R

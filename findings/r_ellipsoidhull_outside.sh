#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The "spanning ellipsoid" of R's cluster::ellipsoidhull does not contain the points that determine it.
#
# cluster 2.1.4 (Debian 12, r-cran-cluster 2.1.4-1 with R 4.2.2). Its manual says: "the ellipsoid of minimal volume such that all given
# points lie just inside or on the boundary". Here are six points in the plane, and their squares (x - c)' cov^-1 (x - c)/d2, which are
# at most 1 inside:
#   1.0012902 0.9969731 0.9945101 0.3799212 1.0006155 1.0043796, convergence TRUE, tol 0.01
# So three of the six are outside, one by 0.4 % of the square, and two that should be on the boundary are inside. The iteration stops when
# no square exceeds 1 + tol, and the ellipsoid is not enlarged after that. With tol = 1e-6 the points are outside by less than 1e-6, but
# still outside. For an enclosing ellipsoid, multiply d2 by the largest square. The same holds for other clouds: 5 of 1,000 normal points
# in two dimensions, 9 in six.
# Needs the libraries of R (libblas3, liblapack3, libtre5, libtirpc3, libgomp1), apt-get and dpkg.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -q r-base-core=4.2.2.20221110-2 r-cran-cluster=2.1.4-1 >/dev/null
for package in ./*.deb; do dpkg -x "$package" .; done
cat >check.R <<'EOR'
library(cluster)
x <- rbind(c(-1, -1), c(1, -1), c(-1, 1), c(1, 1), c(2, 0.5), c(0.3, 1.7))
for (tol in c(0.01, 1e-6)) {
  e <- ellipsoidhull(x, tol = tol, maxit = 1000000)
  squares <- mahalanobis(x, e$loc, e$cov) / e$d2
  cat("tol", tol, "convergence", e$conv, "squares", format(squares, digits = 8), "\n")
  stopifnot(e$conv, max(squares) > 1 + tol / 100, max(squares) < 1 + tol)
}
EOR
home=$dir/usr/lib/R
EDITOR=vi PAGER=cat R_HOME=$home LD_LIBRARY_PATH=$home/lib R_LIBS=$dir/usr/lib/R/site-library:$home/library \
  "$home/bin/exec/R" --vanilla --no-echo -f check.R

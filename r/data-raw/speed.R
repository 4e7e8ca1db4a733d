# SPDX-License-Identifier: BSD-3-Clause
# Nanoseconds per row, and per call of one row, in one thread; writes the pairs for speed.c. Usage: speed.R FILE N

library(pw85)
arguments <- commandArgs(TRUE)
n <- as.integer(arguments[2])
set.seed(85)
solid <- function(shift) {
  turns <- matrix(rnorm(4 * n), n)
  ellipsoids(shift * rnorm(n), shift * rnorm(n), shift * rnorm(n), runif(n, 0.5, 2), runif(n, 0.5, 2), runif(n, 0.5, 2), turns)
}
flat <- function(shift) ellipses(shift * rnorm(n), shift * rnorm(n), runif(n, 0.5, 2), runif(n, 0.5, 2), runif(n, 0, 3))
x <- solid(0)
y <- solid(1.5)
x2 <- flat(0)
y2 <- flat(1.2)
by_rows <- function(frame, columns) as.vector(t(as.matrix(frame[columns])))
writeBin(c(
  by_rows(y, 1:3), by_rows(x, 4:9), by_rows(y, 4:9), by_rows(y2, 1:2), by_rows(x2, 3:5), by_rows(y2, 3:5)
), arguments[1])

best <- function(times, expression) {
  call <- substitute(expression)
  run <- eval(bquote(function() for (k in seq_len(times)) .(call)), parent.frame())
  environment(run)$times <- times
  1e9 * min(vapply(1:200, function(k) {
    start <- as.numeric(Sys.time())
    run()
    as.numeric(Sys.time()) - start
  }, 0)) / times
}
functions <- list(overlaps = overlaps, contains = contains, contact = contact, distance = distance, overlap_volume = overlap_volume)
functions$overlap_area <- overlap_area
for (name in names(functions)) {
  f <- functions[[name]]
  one <- if (name == "overlap_area") list(x2, y2) else list(x, y)
  a <- one[[1]]
  b <- one[[2]]
  rows <- best(1, f(a, b)) / n
  a <- a[1, ]
  b <- b[1, ]
  cat(sprintf("%s %.2f, one row %.0f\n", name, rows, best(100, f(a, b))))
}

# SPDX-License-Identifier: BSD-3-Clause
# The program of bench/languages.py in R: see there.

library(pw85)
arguments <- commandArgs(TRUE)
pairs <- 1000
copies <- c(overlaps = 16, contact = 16, distance = 4, overlap_volume = 1) # of the pairs, that are computed as rows
file <- file(arguments[1], "rb")
matrix_of <- function(size) matrix(readBin(file, "double", size * pairs), pairs, byrow = TRUE)
r12 <- matrix_of(3)
q1 <- matrix_of(6)
q2 <- matrix_of(6)
close(file)
frame <- function(center, form) {
  setNames(as.data.frame(cbind(center, form)), c("x", "y", "z", "xx", "xy", "xz", "yy", "yz", "zz"))
}
x <- frame(0 * r12, q1)
y <- frame(r12, q2)
rows_of <- function(x) lapply(seq_len(pairs), function(i) x[i, ])
xs <- rep(rows_of(x), 2)
ys <- rows_of(y)

# The least nanoseconds of several runs, from run(1) on.
nanoseconds <- function(rounds, run) {
  1e9 * min(vapply(seq_len(rounds), function(k) {
    start <- as.numeric(Sys.time())
    run(k)
    as.numeric(Sys.time()) - start
  }, 0))
}


# The numbers of a result, column by column, and points row by row.
numbers_of <- function(found) {
  found <- as.matrix(as.data.frame(found))[seq_len(pairs), , drop = FALSE]
  points <- startsWith(colnames(found), "point")
  c(found[, !points], t(found[, startsWith(colnames(found), "point1")]), t(found[, startsWith(colnames(found), "point2")]))
}

out <- file(arguments[2], "wb")
rounds <- as.integer(arguments[3])
for (name in names(copies)) {
  f <- get(name)
  again <- rep(seq_len(pairs), copies[name])
  many_x <- x[again, ]
  many_y <- y[again, ]
  # The first form of the pair that is k places behind
  call <- nanoseconds(rounds, function(k) for (i in seq_len(pairs)) f(xs[[i + k - 1]], ys[[i]]))
  row <- nanoseconds(rounds, function(k) f(many_x, many_y))
  writeBin(as.double(numbers_of(f(many_x, many_y))), out)
  alone <- lapply(seq_len(pairs), function(i) as.data.frame(f(xs[[i]], ys[[i]])))
  writeBin(as.double(numbers_of(do.call(rbind, alone))), out)
  cat(sprintf("%s,%.17g,%.17g\n", if (name == "overlaps") "overlap" else name, call / pairs, row / length(again)))
}
close(out)

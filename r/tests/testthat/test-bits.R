# The bits that the C API gives for 1,000 pairs: data-raw/pairs.c.

state <- 1
uniform <- function() {
  state <<- (state * 16807) %% 2147483647
  (state %% 65536) / 65536
}

bits <- function(value) {
  # rev: the first byte is the last one of a number of this machine, unless it has the other order.
  bytes <- as.character(writeBin(value, raw(), endian = "big"))
  paste(bytes, collapse = "")
}

test_that("1,000 pairs have the bits of C", {
  before <- reproducible(TRUE)
  on.exit(reproducible(before))
  numbers <- t(vapply(1:1000, function(i) vapply(1:17, function(k) uniform(), 0), numeric(17)))
  center <- 5 * numbers[, 1:3] - 2
  body <- function(columns, x, y, z) {
    axes <- 0.25 + 2 * numbers[, columns[1:3]]
    turn <- sweep(numbers[, columns[4:7]] - 0.5, 2, c(1, 0, 0, 0), "+")
    ellipsoids(x, y, z, axes[, 1], axes[, 2], axes[, 3], quaternion = turn)
  }
  x <- body(4:10, 0, 0, 0)
  y <- body(11:17, center[, 1], center[, 2], center[, 3])
  pair <- contact(x, y)
  found <- cbind(pair$mu2, pair$lambda, distance(x, y)$distance, overlap_volume(x, y))
  truth <- as.matrix(read.table(test_path("pairs.txt"), colClasses = "character"))
  found <- matrix(vapply(found, bits, ""), 1000)
  different <- which(found != truth, arr.ind = TRUE)
  expect_identical(nrow(different), 0L, info = paste(found[different], truth[different])[1])
  # One by one they are the same, and in any order.
  expect_identical(contact(x[7, ], y[7, ])$mu2, pair$mu2[7])
  expect_identical(distance(x[1000:1, ], y[1000:1, ])$distance, rev(distance(x, y)$distance))
})

test_that("the example of README prints what those of the other languages print", {
  x <- ellipsoids(0, 0, 0, a = 3, b = 2, c = 1, quaternion = c(1, 0, 0, 0))
  y <- ellipsoids(3, 2, 1, a = 4, b = 1, c = 1, quaternion = c(0.9, 0.1, 0.3, 0.2))
  pair <- distance(x, y)
  expect_identical(sprintf("mu^2 = %.5f", contact(x, y)$mu2), "mu^2 = 1.13027")
  expect_identical(
    sprintf("distance = %.5f, from (%.4f, %.4f, %.4f)", pair$distance, pair$point1_x, pair$point1_y, pair$point1_z),
    "distance = 0.16852, from (2.0126, 1.1233, 0.4843)"
  )
})

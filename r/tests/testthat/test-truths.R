# Areas, volumes and distances against closed forms, polygons and brute force. Nothing of these is computed by the package.

u <- 2^-53

lens <- function(r1, r2, d) {
  a1 <- acos((d^2 + r1^2 - r2^2) / (2 * d * r1))
  a2 <- acos((d^2 + r2^2 - r1^2) / (2 * d * r2))
  r1^2 * (a1 - sin(2 * a1) / 2) + r2^2 * (a2 - sin(2 * a2) / 2)
}

test_that("circles share the area of a lens, in all units", {
  for (unit in 2^c(-40, 0, 40)) {
    for (turn in c(0, 0.7, 2)) {
      d <- 1.75
      x <- ellipses(0, 0, unit)
      y <- ellipses(unit * d * cos(turn), unit * d * sin(turn), 1.5 * unit)
      # acos loses some digits here: the condition number of the lens is below 10.
      expect_equal(overlap_area(x, y) / unit^2, lens(1, 1.5, d), tolerance = 64 * u)
      expect_equal(distance(x, ellipses(unit * 4 * cos(turn), unit * 4 * sin(turn), 1.5 * unit))$distance / unit, 1.5, tolerance = 64 * u)
    }
  }
})

test_that("balls share the volume of a lens", {
  for (unit in 2^c(-40, 0, 40)) {
    r1 <- 1
    r2 <- 1.5
    d <- 1.75
    truth <- pi * (r1 + r2 - d)^2 * (d^2 + 2 * d * (r1 + r2) - 3 * (r1 - r2)^2) / (12 * d)
    x <- ellipsoids(0, 0, 0, r1 * unit)
    y <- ellipsoids(0, d * unit, 0, r2 * unit)
    expect_equal(overlap_volume(x, y) / unit^3, truth, tolerance = 64 * u)
    expect_equal(overlap_volume(y, x) / unit^3, truth, tolerance = 64 * u)
  }
})

polygon_of <- function(x, y, a, b, angle, n) {
  turn <- 2 * pi * seq_len(n) / n
  cbind(
    x + a * cos(turn) * cos(angle) - b * sin(turn) * sin(angle),
    y + a * cos(turn) * sin(angle) + b * sin(turn) * cos(angle)
  )
}

area_of <- function(p) {
  q <- p[c(seq_len(nrow(p))[-1], 1), , drop = FALSE]
  sum(p[, 1] * q[, 2] - p[, 2] * q[, 1]) / 2
}

# The part of a convex polygon on the left of the line from a to b.
clipped <- function(p, a, b) {
  side <- (b[1] - a[1]) * (p[, 2] - a[2]) - (b[2] - a[2]) * (p[, 1] - a[1])
  if (all(side >= 0)) return(p)
  n <- nrow(p)
  found <- matrix(0, 0, 2)
  after <- c(seq_len(n)[-1], 1)
  pieces <- lapply(seq_len(n), function(k) {
    l <- after[k]
    cut <- if (side[k] * side[l] < 0) p[k, ] + side[k] / (side[k] - side[l]) * (p[l, ] - p[k, ])
    rbind(if (side[k] >= 0) p[k, ], cut)
  })
  do.call(rbind, c(list(found), pieces))
}

common_area <- function(p, q) {
  for (k in seq_len(nrow(q))) {
    if (nrow(p) < 3) return(0)
    p <- clipped(p, q[k, ], q[k %% nrow(q) + 1, ])
  }
  if (nrow(p) < 3) 0 else area_of(p)
}

test_that("areas are those of polygons with many vertices", {
  set.seed(85)
  n <- 400
  for (case in 1:8) {
    one <- c(0, 0, 1 + runif(1), 0.5 + runif(1) / 2, runif(1, 0, 3))
    two <- c(runif(2, -1, 1.5), 1 + runif(1), 0.5 + runif(1) / 2, runif(1, 0, 3))
    truth <- common_area(do.call(polygon_of, c(as.list(one), n)), do.call(polygon_of, c(as.list(two), n)))
    found <- overlap_area(do.call(ellipses, as.list(one)), do.call(ellipses, as.list(two)))
    # A polygon with n vertices lacks a share of at most 2 pi^2/(3 n^2) of the area of its ellipse.
    margin <- 2 * pi^2 / (3 * n^2) * pi * (one[3] * one[4] + two[3] * two[4])
    expect_true(found >= truth - 1e-12 && found <= truth + margin, info = paste(sprintf("%a", c(one, two)), collapse = " "))
  }
})

test_that("contained ellipses share all of the smaller one", {
  x <- ellipses(0, 0, 4, 3, 0.3)
  y <- ellipses(0.5, -0.5, 1, 0.5, 1)
  expect_true(contains(x, y))
  expect_false(contains(y, x))
  expect_equal(overlap_area(x, y), pi / 2, tolerance = 16 * u)
  expect_equal(overlap_area(y, x), pi / 2, tolerance = 16 * u)
  expect_true(contains(x, x))
})

test_that("overlaps are decided exactly at contact", {
  # Circles of radii 1 and 2 whose centres are 3 apart touch: they overlap if the first one grows by a unit in the last place of its form.
  x <- data.frame(x = 0, y = 0, xx = 1 + c(0, 2, -1) * u, xy = 0, yy = 1)
  y <- data.frame(x = 3, y = 0, xx = 4, xy = 0, yy = 4)
  expect_equal(overlaps(x, y)[2:3], c(TRUE, FALSE))
  expect_equal(contact(x[1, ], y)$mu2, 1)
})

test_that("distances are those of the closest points on fine outlines", {
  x <- ellipses(0, 0, 3, 1, 0.4)
  y <- ellipses(5, 2, 2, 0.5, -0.8)
  p <- polygon_of(0, 0, 3, 1, 0.4, 2000)
  q <- polygon_of(5, 2, 2, 0.5, -0.8, 2000)
  gaps <- sqrt(outer(p[, 1], q[, 1], "-")^2 + outer(p[, 2], q[, 2], "-")^2)
  # The closest points are at most half a step of 3 (2 pi/2000) from vertices, which adds less than the step's square here.
  found <- distance(x, y)$distance
  expect_lte(found, min(gaps) + 1e-12)
  expect_gte(found, min(gaps) - 1e-4)
})

test_that("outlines are on their ellipses", {
  x <- ellipses(c(0, 3), c(1, -1), c(2, 1), c(1, 0.5), c(0.3, 2))
  tiny <- outline(ellipses(0, 0, 2^-300 * 2, 2^-300, 0.3), 7) # squares of its form are not numbers
  expect_equal(tiny$y * 2^300, outline(ellipses(0, 0, 2, 1, 0.3), 7)$y)
  points <- outline(x, 7)
  for (k in 1:2) {
    own <- points[points$ellipse == k, ]
    form <- matrix(c(x$xx[k], x$xy[k], x$xy[k], x$yy[k]), 2)
    from <- rbind(own$x - x$x[k], own$y - x$y[k])
    expect_equal(colSums(from * solve(form, from)), rep(1, 7))
  }
})

test_that("semi-axes and covariances make the same forms", {
  turn <- 0.6
  axes <- matrix(c(cos(turn), sin(turn), -sin(turn), cos(turn)), 2)
  covariance <- axes %*% diag(c(4, 0.25)) %*% t(axes)
  x <- ellipses(1, 2, 2, 0.5, turn)
  y <- covariance_ellipsoids(c(1, 2), covariance)
  expect_equal(x, y)
  expect_equal(area(covariance_ellipsoids(c(1, 2), covariance, level = 0.95)), -2 * log(0.05) * pi)
  rotation <- diag(3)
  rotation[1:2, 1:2] <- axes
  expect_equal(
    ellipsoids(0, 0, 0, 3, 2, 1, rotation = rotation),
    ellipsoids(0, 0, 0, 3, 2, 1, quaternion = c(cos(turn / 2), 0, 0, sin(turn / 2)))
  )
  expect_equal(covariance_ellipsoids(1:3, diag(3:1)^2), ellipsoids(1, 2, 3, 3, 2, 1))
})

test_that("standard ellipses have the areas of SIBER", {
  points <- cbind(c(-26.1, -25.2, -24.8, -26.9, -25.5), c(8.2, 9.1, 9.6, 7.4, 8.0))
  truth <- pi * sqrt(det(cov(points)))
  expect_equal(area(standard_ellipsoids(points)), truth)
  expect_equal(area(standard_ellipsoids(points, corrected = TRUE)), truth * 4 / 3)
  both <- standard_ellipsoids(rbind(points, points + 2), rep(c("b", "a"), each = 5))
  expect_equal(both$group, c("a", "b"))
  expect_equal(both$x, unname(c(mean(points[, 1]) + 2, mean(points[, 1]))))
})

test_that("smallest ellipsoids are those of regular bodies", {
  square <- rbind(c(1, 1), c(1, -1), c(-1, 1), c(-1, -1))
  found <- enclosing_ellipsoid(square, tolerance = 1e-9)
  expect_equal(unlist(found[1:5]), c(x = 0, y = 0, xx = 2, xy = 0, yy = 2), tolerance = 1e-8)
  expect_lte(found$excess, 1e-9)
  grid <- as.matrix(expand.grid(rep(list(c(-1, 1)), 4)))
  found <- enclosing_ellipsoid(grid)
  expect_equal(unlist(found[c("x1", "x4", "q1_1", "q1_2", "q4_4")], use.names = FALSE), c(0, 0, 4, 0, 4), tolerance = 1e-5)
  expect_named(found, c(paste0("x", 1:4), "q1_1", "q1_2", "q1_3", "q1_4", "q2_2", "q2_3", "q2_4", "q3_3", "q3_4", "q4_4", "excess"))
  x <- ellipses(c(-1, 1), 0, 0.5, 0.25)
  around <- enclosing_ellipsoid_of(x)
  expect_true(all(contains(around, x)))
  expect_equal(enclosing_ellipsoid(rbind(square, 3 * square), rep(c("in", "out"), each = 4))$yy, c(2, 18), tolerance = 1e-5)
})

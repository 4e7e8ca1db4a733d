# What users of R pass: results as they expect them, or errors that name argument and row.

x <- ellipses(0:2, 0, 2, 1, c(0, 0.5, 1))
y <- ellipses(1, 1, 1)
solid <- ellipsoids(c(0, 3), 0, 0, 2, 1, 1)

refused <- function(expression, message, argument = NULL, row = NULL, column = NULL) {
  condition <- tryCatch(expression, error = identity)
  expect_s3_class(condition, "pw85_error")
  expect_identical(conditionMessage(condition), message)
  expect_identical(condition[c("argument", "row", "column")], list(argument = argument, row = row, column = column))
  condition
}

test_that("rows are recycled", {
  one_by_one <- vapply(1:3, function(k) overlap_area(x[k, ], y), 0)
  expect_identical(overlap_area(x, y), one_by_one)
  expect_identical(overlap_area(y, x), vapply(1:3, function(k) overlap_area(y, x[k, ]), 0))
  twice <- rbind(x, x)
  expect_identical(overlap_area(twice, x), overlap_area(twice, twice))
  refused(overlap_area(x, x[1:2, ]), "y: has 2 rows, of which 3 rows are not a multiple", "y")
  expect_identical(nrow(ellipses(0, 0, 1, angle = 1:4)), 4L)
  refused(ellipses(1:2, 1:3, 1), "x: has 2 numbers, of which 3 rows are not a multiple", "x")
  many <- x[rep(1:3, 3000), ]
  expect_identical(overlap_area(many, x), rep(overlap_area(x, x), 3000))
  expect_identical(overlap_area(y, many), rep(overlap_area(y, x), 3000))
})

test_that("no rows give no rows", {
  none <- x[0, ]
  expect_identical(overlap_area(none, y), numeric(0))
  expect_identical(overlaps(y, none), logical(0))
  expect_identical(dim(distance(none, none)), c(0L, 5L))
  expect_identical(dim(bounding_boxes(solid[0, ])), c(0L, 3L))
  expect_identical(nrow(ellipses(numeric(0), 0, 1)), 0L)
  expect_identical(nrow(ellipsoids(numeric(0), 0, 0, 1)), 0L)
  expect_identical(covariance_ellipsoids(matrix(0, 0, 2), diag(2)), ellipses(numeric(0), 0, 1))
  expect_identical(covariance_ellipsoids(iris[0, 1:2], diag(2)), ellipses(numeric(0), 0, 1))
  expect_identical(covariance_ellipsoids(c(0, 0), list()), ellipses(numeric(0), 0, 1))
  expect_named(standard_ellipsoids(iris[0, 1:2], iris$Species[0]), c("group", names(x)))
  expect_named(enclosing_ellipsoid(iris[0, 1:2], iris$Species[0]), c("group", names(x), "excess"))
})

test_that("quaternions are ordered by their names", {
  truth <- ellipsoids(0, 0, 0, 3, 2, 1, quaternion = c(0.9, 0.1, 0.3, 0.2))
  made <- function(quaternion) ellipsoids(0, 0, 0, 3, 2, 1, quaternion = quaternion)
  turned <- c(x = 0.1, y = 0.3, z = 0.2, w = 0.9)
  for (same in list(turned, t(turned), as.data.frame(t(turned)), c(a = 0.9, 0.1, 0.3, 0.2))) expect_identical(made(same), truth)
})

test_that("a column z of ellipses is another column", {
  expect_identical(overlap_area(cbind(x, z = 9), y), overlap_area(x, y))
  expect_identical(outline(cbind(x, z = 9), 3), outline(x, 3))
  expect_identical(enclosing_ellipsoid_of(cbind(x, z = 9)), enclosing_ellipsoid_of(x))
  refused(
    volume(solid[-3]), "x, column z: is missing: ellipsoids have columns x, y, z, xx, xy, xz, yy, yz, zz", "x",
    column = "z"
  )
})

test_that("covariances may be arrays and data frames", {
  covariances <- list(diag(2), matrix(c(4, 1, 1, 2), 2))
  truth <- covariance_ellipsoids(c(1, 2), covariances)
  expect_identical(covariance_ellipsoids(c(1, 2), array(unlist(covariances), c(2, 2, 2))), truth)
  expect_identical(covariance_ellipsoids(c(1, 2), as.data.frame(covariances[[2]])), covariance_ellipsoids(c(1, 2), covariances[[2]]))
  expect_identical(standard_ellipsoids(iris[1:2], iris["Species"]), standard_ellipsoids(iris[1:2], iris$Species))
})

test_that("integers, matrices and other columns are as good", {
  whole <- data.frame(x = 0L, y = 0L, xx = 4L, xy = 0L, yy = 1L, name = "a")
  expect_identical(area(whole), area(ellipses(0, 0, 2, 1)))
  expect_identical(overlap_area(as.matrix(x), as.matrix(y)), overlap_area(x, y))
  expect_identical(area(x[c(5, 4, 3, 2, 1)]), area(x))
  expect_identical(contact_geometry(x, y, 1L)$point_x, contact_geometry(x, y, 1)$point_x)
})

test_that("vectors may be rows, columns, matrices and data frames", {
  path <- function(direction, t_max = Inf) free_path(solid, ellipsoids(9, 0, 0, 1), direction, t_max)
  truth <- path(c(1, 0, 0))
  expect_equal(truth, c(6, 3))
  expect_identical(path(matrix(c(1, 0, 0), 1)), truth)
  expect_identical(path(matrix(c(1, 0, 0), 3)), truth)
  expect_identical(path(rbind(c(1L, 0L, 0L), c(1L, 0L, 0L))), truth)
  expect_identical(path(data.frame(a = c(1, 1), b = 0, c = 0)), truth)
  expect_identical(path(c(1, 0, 0), t(c(9, 9))), truth)
  expect_identical(path(c(1, 0, 0), c(1, 9)), c(Inf, truth[2]))
  refused(path(c(1, 0)), "direction: must have 3 columns", "direction")
  refused(path(list(1, 0, 0)), "direction: must be numbers, not a list", "direction")
  refused(path(c(1, 0, NA)), "direction, row 1: must be finite", "direction", 1)
  refused(path(rbind(c(1, 0, 0), 0)), "direction, row 2: must not be zero", "direction", 2)
  refused(path("1"), "direction: must have 3 columns", "direction")
  refused(path(c("1", "0", "0")), "direction: must be numeric, not character", "direction")
  refused(path(c(1, 0, 0), factor(1)), "t_max: must be numeric, not a factor", "t_max")
  refused(path(c(1, 0, 0), data.frame(a = 1, b = 2)), "t_max: must have 1 column", "t_max")
})

test_that("ellipsoids that are none are refused", {
  frame <- "must be a data frame of ellipses or ellipsoids: see ellipses(), ellipsoids()"
  numbers <- structure(1:5, class = "data.frame", names = names(x)) # not a list
  for (bad in list(1, "a", NULL, list(1), as.list(x), TRUE, mean, matrix(0, 2, 2), numbers)) {
    refused(area(bad), paste0("x: ", frame), "x")
    refused(overlaps(x, bad), paste0("y: ", frame), "y")
  }
  refused(area(x[-4]), "x, column xy: is missing: ellipses have columns x, y, xx, xy, yy", "x", column = "xy")
  refused(area(data.frame()), "x, column x: is missing: ellipses have columns x, y, xx, xy, yy", "x", column = "x")
  refused(
    volume(solid[-9]), "x, column zz: is missing: ellipsoids have columns x, y, z, xx, xy, xz, yy, yz, zz", "x",
    column = "zz"
  )
  refused(overlaps(x, solid), "y: must be ellipses, as x", "y")
  refused(overlaps(solid, x), "y: must be ellipsoids, as x", "y")
  refused(overlap_area(solid, solid), "x: must be ellipses", "x")
  refused(overlap_volume(x, x), "x: must be ellipsoids, in three dimensions", "x")
  refused(area(transform(x, xx = factor(xx))), "x, column xx: must be numeric, not a factor", "x", column = "xx")
  refused(area(transform(x, xx = "4")), "x, column xx: must be numeric, not character", "x", column = "xx")
  refused(area(transform(x, xx = NA)), "x, column xx: must be numeric, not logical", "x", column = "xx")
  odd <- x
  class(odd$xx) <- "integer64"
  refused(area(odd), "x, column xx: must be numeric, not integer64: see as.double()", "x", column = "xx")
  refused(ellipses(0, 0, structure(1, class = "integer64")), "a: must be numeric, not integer64: see as.double()", "a")
  odd$xx <- cbind(odd$xx, odd$xx)
  refused(area(odd), "x, column xx: must be a vector with a number for each row", "x", column = "xx")
  odd$xx <- as.list(x$xx)
  refused(area(odd), "x, column xx: must be numeric, not list", "x", column = "xx")
})

test_that("errors name argument, row and column", {
  for (bad in c(NA, NaN, Inf)) {
    frame <- x
    frame$yy[3] <- bad
    refused(area(frame), "x, row 3, column yy: must be finite", "x", 3, "yy")
    refused(overlaps(y, frame), "y, row 3, column yy: must be finite", "y", 3, "yy")
    frame <- x
    frame$y[2] <- bad
    refused(overlaps(frame, y), "x, row 2, column y: must be finite", "x", 2, "y")
    refused(distance(y, frame), "y, row 2, column y: must be finite", "y", 2, "y")
  }
  whole <- data.frame(x = 0L, y = 0L, xx = c(4L, NA), xy = 0L, yy = 1L)
  refused(area(whole), "x, row 2, column xx: must be finite", "x", 2, "xx")
  flat <- x
  flat$yy[2] <- -1
  refused(overlaps(y, flat), "y, row 2: must be positive definite", "y", 2)
  # The row of an argument that is recycled is its own.
  refused(overlaps(x[rep(1:3, 2), ], flat), "y, row 2: must be positive definite", "y", 2)
  # What the centres of both are to blame for has the row of the pair.
  both <- "must have another centre than x, at a finite distance"
  refused(contact_geometry(x, ellipses(2, 0, 1), 0.5), paste0("y, row 3: ", both), "y", 3)
  refused(overlaps(transform(x, x = -1e308), transform(y, x = 1e308)), paste0("y, row 1: ", both), "y", 1)
  # Behind the first block, and where rows are computed one by one.
  many <- x[rep(1, 5000), ]
  many$xx[4321] <- 0
  refused(area(many), "x, row 4321: must be positive definite", "x", 4321)
  refused(contains(many, y), "x, row 4321: must be positive definite", "x", 4321)
  many$xx[4321] <- NA
  refused(containment(y, many), "y, row 4321, column xx: must be finite", "y", 4321, "xx")
  condition <- refused(contact_geometry(x, y, c(0.5, 2, 0.5)), "lambda, row 2: must be in [0, 1]", "lambda", 2)
  expect_identical(deparse(conditionCall(condition)), "contact_geometry(x, y, c(0.5, 2, 0.5))")
  expect_error(area(flat), "must be positive definite")
})

test_that("constructors refuse what makes no ellipsoid", {
  refused(ellipses(0, 0, c(1, -1)), "a, row 2: must be > 0", "a", 2)
  refused(ellipses(0, 0, 1, 0), "b, row 1: must be > 0", "b", 1)
  refused(ellipses(0, 0, 1, 1, c(0, NA)), "angle, row 2: must be finite", "angle", 2)
  refused(ellipses("0", 0, 1), "x: must be numeric, not character", "x")
  refused(ellipses(factor(1), 0, 1), "x: must be numeric, not a factor", "x")
  refused(ellipses(0, list(0), 1), "y: must be numbers, not a list", "y")
  refused(ellipses(as.Date("2020-01-01"), 0, 1), "x: must be numeric, not Date", "x")
  # Each semi-axis by its own name; the square of 1e-170 is 0.
  refused(ellipsoids(0, 0, 0, -1), "a, row 1: must be > 0", "a", 1)
  refused(ellipsoids(0, 0, 0, 1, c(1, -1)), "b, row 2: must be > 0", "b", 2)
  refused(ellipsoids(0, 0, 0, 1, 1, 1e-170), "c, row 1: must have a finite square that is not 0", "c", 1)
  condition <- refused(ellipsoids(0, 0, 0, 1, 1, 0, rotation = diag(3)), "c, row 1: must be > 0", "c", 1)
  expect_identical(as.character(conditionCall(condition)[[1]]), "ellipsoids")
  refused(ellipsoids(0, 0, 0, 1, quaternion = c(0, 0, 0, 0)), "quaternion, row 1: must not be zero", "quaternion", 1)
  refused(ellipsoids(0, 0, 0, 1, quaternion = 1:3), "quaternion: must have 4 columns", "quaternion")
  refused(ellipsoids(0, 0, 0, 1, rotation = matrix(1, 3, 3)), "rotation, row 1: must be a rotation matrix, whose columns are orthonormal", "rotation", 1)
  refused(
    ellipsoids(0, 0, 0, 1, quaternion = c(1, 0, 0, 0), rotation = diag(3)), "rotation: must be NULL if there is a quaternion",
    "rotation"
  )
  condition <- refused(ellipses(0, 0, -1), "a, row 1: must be > 0", "a", 1)
  expect_identical(deparse(conditionCall(condition)), "ellipses(0, 0, -1)")
})

test_that("covariances and points that make no ellipsoid are refused", {
  square <- "must be a numeric matrix, 2 x 2 or 3 x 3, all of the same size"
  refused(covariance_ellipsoids(c(0, 0), 1:4), paste0("covariance, row 1: ", square), "covariance", 1)
  refused(covariance_ellipsoids(c(0, 0), list(diag(2), diag(3))), paste0("covariance, row 2: ", square), "covariance", 2)
  refused(covariance_ellipsoids(0, diag(2)), "mean: must have 2 columns, as covariance", "mean")
  refused(covariance_ellipsoids(rbind(0:1, c(0, NA)), diag(2)), "mean, row 2: must be finite", "mean", 2)
  refused(covariance_ellipsoids(c("a", "b"), diag(2)), "mean: must be numeric, not character", "mean")
  broken <- list(diag(2), matrix(c(1, 0, 0, Inf), 2))
  refused(covariance_ellipsoids(c(0, 0), broken), "covariance, row 2: must be finite", "covariance", 2)
  for (bad in list(-diag(2), matrix(c(1, 2, 2, 1), 2), diag(c(1, 0)))) {
    condition <- refused(
      covariance_ellipsoids(matrix(0, 4, 2), list(diag(2), bad)), "covariance, row 2: must be positive definite", "covariance", 2
    )
    expect_identical(as.character(conditionCall(condition)[[1]]), "covariance_ellipsoids")
  }
  refused(covariance_ellipsoids(c(0, 0), matrix(1:4, 2)), "covariance, row 1: must be symmetric", "covariance", 1)
  refused(covariance_ellipsoids(c(0, 0), diag(2), 95), "level: must be one number between 0 and 1", "level")
  points <- cbind(c(0, 1, 2, 5), c(0, 3, 1, 1))
  refused(standard_ellipsoids(points[1:2, ]), "points: must have more than 2 rows in each group, not 2", "points")
  refused(
    standard_ellipsoids(points, c("a", "a", "a", "b")), "points: must have more than 2 rows in each group, not 1, as in group b", "points"
  )
  refused(standard_ellipsoids(cbind(1:5, 1:5)), "points: must not be in a line or plane", "points")
  flat <- cbind(points[rep(1:4, 2), ], c(0, 1, 0, 1, 0, 0, 0, 0))
  condition <- refused(
    standard_ellipsoids(flat, rep(c("a", "b"), each = 4)), "points: must not be in a line or plane, as in group b", "points"
  )
  expect_identical(as.character(conditionCall(condition)[[1]]), "standard_ellipsoids")
  refused(standard_ellipsoids(points, corrected = NA), "corrected: must be TRUE or FALSE", "corrected")
  refused(standard_ellipsoids(points, 1:3), "group: must have a value for each row of points", "group")
  refused(standard_ellipsoids(points, c("a", NA, "a", "a")), "group, row 2: must not be NA", "group", 2)
  refused(standard_ellipsoids(iris, iris$Species), "points, column Species: must be numeric, not factor", "points", column = "Species")
  refused(standard_ellipsoids(iris[1]), "points: must have 2 or 3 columns", "points")
  refused(standard_ellipsoids(1:3), "points: must be a data frame or matrix of numbers", "points")
  points[3, 2] <- NA
  refused(standard_ellipsoids(points), "points, row 3: must be finite", "points", 3)
  refused(enclosing_ellipsoid(points), "points, row 3: must be finite", "points", 3)
  refused(enclosing_ellipsoid(points[1:2, ]), "points: must have more rows than columns", "points")
  refused(enclosing_ellipsoid(cbind(1:5, 1:5)), "points: must not be in a plane or nearly so", "points")
  refused(enclosing_ellipsoid(matrix(0, 3, 0)), "points: must have 1 to 16 columns", "points")
  refused(enclosing_ellipsoid(iris[1:2], tolerance = 0), "tolerance: must be one positive number", "tolerance")
  flat <- transform(x, yy = -1)
  refused(enclosing_ellipsoid_of(flat), "x, row 1: must be positive definite", "x", 1)
  refused(enclosing_ellipsoid_of(transform(x, x = NA_real_)), "x, row 1, column x: must be finite", "x", 1, "x")
  refused(outline(solid), "x: must be ellipses", "x")
  for (bad in list(NA, 0, 2.5, 1:2)) refused(outline(x, bad), "points: must be one whole number, at least 1", "points")
  refused(outline(transform(x, y = c(0, NA, 0))), "x, row 2, column y: must be finite", "x", 2, "y")
  refused(enclosing_ellipsoid_of(x[0, ]), "x: must have at least one row", "x")
  refused(reproducible(NA), "on: must be TRUE, FALSE or NULL", "on")
})

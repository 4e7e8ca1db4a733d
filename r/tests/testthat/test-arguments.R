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
  refused(path(c(1, 0, Inf)), "direction, row 1: must be finite", "direction", 1)
  expect_identical(path(rbind(c(1, 0, NA), c(1, 0, 0))), c(NA, truth[2]))
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
  refused(area(transform(x, xx = c(NA, TRUE, NA))), "x, column xx: must be numeric, not logical", "x", column = "xx")
  refused(area(cbind(x, xx = 9)), "x, column xx: is there twice", "x", column = "xx")
  refused(overlaps(x, cbind(x = 9, as.matrix(x))), "y, column x: is there twice", "y", column = "x")
  odd <- x
  for (day in list(as.Date("2020-01-01"), Sys.time(), as.difftime(1, units = "secs"))) {
    odd$y <- day
    refused(overlaps(odd, y), "x, column y: must be numeric, not a date or time", "x", column = "y")
  }
  cells <- matrix(as.list(1:10), 2, dimnames = list(NULL, names(x)))
  refused(area(cells), paste0("x: ", frame), "x")
  odd <- x
  class(odd$xx) <- "integer64"
  refused(area(odd), "x, column xx: must be numeric, not integer64: see as.double()", "x", column = "xx")
  refused(ellipses(0, 0, structure(1, class = "integer64")), "a: must be numeric, not integer64: see as.double()", "a")
  odd$xx <- cbind(odd$xx, odd$xx)
  refused(area(odd), "x, column xx: must be a vector with a number for each row", "x", column = "xx")
  odd$xx <- as.list(x$xx)
  refused(area(odd), "x, column xx: must be numeric, not list", "x", column = "xx")
})

# Functions of the package that take ellipsoids, with arguments that each of them accepts, and the names of these.
questions <- function() {
  values <- list(
    lambda = 0.5, mu2 = 1, t_max = 9, direction = c(1, 2, 3), velocity = c(1, 2, 3), normal = c(1, 2, 3), start = c(1, 2, 3),
    motion1 = numeric(7), motion2 = c(-1, numeric(6))
  )
  solids <- list(x = ellipsoids(c(0, 1, 0), 0, 0, 3, 2, 1), y = ellipsoids(c(5.5, 9, 6), 0.5, 1, 3, 2, 1))
  flat <- list(x = ellipses(c(0, 1, 0), 0, 3, 1), y = ellipses(c(5.5, 9, 6), 0.5, 3, 1))
  names <- Filter(function(name) identical(body(get(name))[[1]], quote(.External)), ls("package:pw85"))
  found <- list()
  for (name in names) {
    for (given in list(solids, flat)) {
      d <- if (identical(given, flat)) 2 else 3
      needed <- names(formals(get(name)))
      cut <- function(value) if (length(value) == 3) value[1:d] else value
      all <- c(given, lapply(values, function(value) matrix(rep(cut(value), each = 3), 3)))[needed]
      works <- tryCatch(!is.null(do.call(name, all)), pw85_error = function(error) FALSE)
      if (works) found <- c(found, list(list(name = name, given = all)))
    }
  }
  found
}

test_that("a row with NA has the result NA, and the others what they have without it", {
  all <- questions()
  expect_gt(length(all), 50)
  for (one in all) {
    results <- function(given) unname(as.matrix(do.call(one$name, given)))
    truth <- results(one$given)
    for (argument in names(one$given)) {
      wrong <- Filter(function(column) {
        found <- lapply(c(NA, NaN), function(missing) {
          given <- one$given
          given[[argument]][2, column] <- missing
          results(given)
        })
        # The centres of ellipsoids alone, or that touch in a given direction, play no part.
        has_centers <- "y" %in% names(one$given) && one$name != "closest_approach"
        d <- if (ncol(one$given$x) == 5) 2 else 3
        expected <- truth
        if (has_centers || column > d || argument == "direction") expected[2, ] <- NA
        !identical(found, list(expected, expected))
      }, seq_len(ncol(one$given[[argument]])))
      expect_identical(wrong, integer(0), info = paste(one$name, argument))
    }
  }
})

test_that("NA is missing, whatever vector has it", {
  # In several blocks, in a row that is recycled, and with other rows around.
  many <- x[rep(1:3, 1000), ]
  truth <- overlap_area(many, y)
  lost <- c(1, 2, 255:258, 1500, 3000)
  for (name in names(x)) {
    given <- many
    given[[name]][lost] <- NA
    expect_identical(overlap_area(given, y), replace(truth, lost, NA))
    expect_identical(overlaps(given, y), replace(overlaps(many, y), lost, NA))
    expect_identical(distance(given, y), replace(distance(many, y), cbind(rep(lost, 5), rep(1:5, each = length(lost))), NA))
  }
  given <- x
  given$yy[2] <- NA
  expect_identical(overlap_area(many, given), replace(overlap_area(many, x), seq(2, 3000, 3), NA))
  whole <- data.frame(x = 0L, y = 0L, xx = c(4L, NA), xy = 0L, yy = 1L)
  expect_identical(area(whole), c(area(ellipses(0, 0, 2, 1)), NA))
  expect_identical(area(transform(x, xx = NA)), rep(NA_real_, 3))
  expect_identical(area(transform(x, xx = NA)[0, ]), numeric(0))
  expect_error(overlaps(na.fail(given), y), "missing values in object")
  # A row that is refused is so beside rows with NA, by its own number.
  given <- many
  given$xx[c(3, 700, 800)] <- c(NA, NA, -1)
  refused(overlaps(y, given), "y, row 800: must be positive definite", "y", 800)
  refused(contains(y, given), "y, row 800: must be positive definite", "y", 800)
  # An infinite centre is not missing, though the difference of two of them is NaN.
  refused(overlaps(transform(x, x = Inf), transform(y, x = Inf)), "x, row 1, column x: must be finite", "x", 1, "x")
})

test_that("NA makes ellipses that are NA", {
  expect_identical(ellipses(c(0, NA), 0, 1)$x, c(0, NA))
  expect_identical(is.na(ellipses(0, 0, c(2, NA), 1)$xx), c(FALSE, TRUE))
  expect_identical(is.na(ellipses(0, 0, 2, 1, c(NaN, 0))$xy), c(TRUE, FALSE))
  expect_identical(area(ellipses(0, 0, c(NA, 2), 1)), c(NA, area(ellipses(0, 0, 2, 1))))
  expect_identical(volume(ellipsoids(0, 0, 0, NA, 2, 1)), NA_real_)
  expect_identical(volume(ellipsoids(0, 0, 0, 3, 2, 1, quaternion = rbind(c(1, 0, NA, 0), c(1, 0, 0, 0)))), c(NA, volume(ellipsoids(0, 0, 0, 3, 2, 1))))
  lost <- matrix(c(1, NA, NA, 1), 2)
  expect_identical(area(covariance_ellipsoids(c(0, 0), list(lost, diag(2)))), c(NA, area(ellipses(0, 0, 1))))
  expect_identical(overlaps(covariance_ellipsoids(rbind(c(0, NA), 0), diag(2)), y), c(NA, TRUE))
  expect_identical(is.na(outline(ellipses(c(0, NA), 0, 1), 3)$x), rep(c(FALSE, TRUE), each = 3))
  refused(enclosing_ellipsoid_of(ellipses(c(0, 1), 0, c(1, NA))), "x, row 2, column xx: must be finite", "x", 2, "xx")
})

test_that("a row that is taken out of a matrix is an ellipse", {
  rows <- as.matrix(x)
  expect_identical(area(rows[2, ]), area(x[2, ]))
  expect_identical(apply(rows, 1, overlap_area, y), overlap_area(x, y))
  expect_identical(outline(rows[2, ], 3), outline(x[2, ], 3))
  expect_identical(enclosing_ellipsoid_of(rows[2, ]), enclosing_ellipsoid_of(x[2, ]))
  expect_identical(area(c(x = 0L, y = 0L, xx = 4L, xy = 0L, yy = 1L)), area(ellipses(0, 0, 2, 1)))
  refused(area(rows[2, -4]), "x, column xy: is missing: ellipses have columns x, y, xx, xy, yy", "x", column = "xy")
})

test_that("means are rows of arrays, as SIBER has them, or elements of lists", {
  means <- array(c(1, 2, 3, 4), c(1, 2, 2))
  covariances <- array(c(diag(2), 4, 1, 1, 2), c(2, 2, 2))
  truth <- covariance_ellipsoids(rbind(1:2, 3:4), covariances)
  expect_identical(covariance_ellipsoids(means, covariances), truth)
  expect_identical(covariance_ellipsoids(list(1:2, 3:4), covariances), truth)
  refused(covariance_ellipsoids(list(1, 2), diag(2)), "mean: must be numbers, not a list", "mean")
  draws <- rbind(c(4, 1, 1, 2, 0, 0), c(3, 1, 1, 2, 0.1, 0))
  made <- covariance_ellipsoids(draws[, 5:6], array(t(draws[, 1:4]), c(2, 2, 2)))
  expect_identical(unname(as.matrix(made)), draws[, c(5, 6, 1, 2, 4)])
})

test_that("errors name argument, row and column", {
  for (bad in c(-Inf, Inf)) {
    frame <- x
    frame$yy[3] <- bad
    refused(area(frame), "x, row 3, column yy: must be finite", "x", 3, "yy")
    refused(overlaps(y, frame), "y, row 3, column yy: must be finite", "y", 3, "yy")
    frame <- x
    frame$y[2] <- bad
    refused(overlaps(frame, y), "x, row 2, column y: must be finite", "x", 2, "y")
    refused(distance(y, frame), "y, row 2, column y: must be finite", "y", 2, "y")
  }
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
  many$xx[4321] <- Inf
  refused(containment(y, many), "y, row 4321, column xx: must be finite", "y", 4321, "xx")
  condition <- refused(contact_geometry(x, y, c(0.5, 2, 0.5)), "lambda, row 2: must be in [0, 1]", "lambda", 2)
  expect_identical(deparse(conditionCall(condition)), "contact_geometry(x, y, c(0.5, 2, 0.5))")
  expect_error(area(flat), "must be positive definite")
})

test_that("constructors refuse what makes no ellipsoid", {
  refused(ellipses(0, 0, c(1, -1)), "a, row 2: must be > 0", "a", 2)
  refused(ellipses(0, 0, 1, 0), "b, row 1: must be > 0", "b", 1)
  refused(ellipses(0, 0, 1, 1, c(0, Inf)), "angle, row 2: must be finite", "angle", 2)
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
  refused(covariance_ellipsoids(rbind(0:1, c(0, -Inf)), diag(2)), "mean, row 2: must be finite", "mean", 2)
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
  refused(outline(transform(x, y = c(0, Inf, 0))), "x, row 2, column y: must be finite", "x", 2, "y")
  refused(enclosing_ellipsoid_of(x[0, ]), "x: must have at least one row", "x")
  refused(reproducible(NA), "on: must be TRUE, FALSE or NULL", "on")
})

test_that("threads give the same, and the first row that is refused", {
  n <- 70000 # more than what a thread computes before the call can be interrupted
  turns <- seq_len(n)
  many <- ellipses(sin(turns), cos(turns), 2 + sin(2 * turns), 1, turns)
  truth <- list(overlap_area(many, y), distance(many, y), overlaps(many, y))
  before <- threads(2)
  on.exit(threads(before))
  expect_identical(before, 1L)
  expect_identical(list(overlap_area(many, y), distance(many, y), overlaps(many, y)), truth)
  bad <- many
  bad$xx[c(40000, 20001, 69999)] <- -1
  bad$xx[c(7, 19999, 40001)] <- NA
  refused(overlap_area(y, bad), "y, row 20001: must be positive definite", "y", 20001)
  bad$xx[c(40000, 20001, 69999)] <- NA
  expect_identical(which(is.na(overlap_area(y, bad))), c(7L, 19999L, 20001L, 40000L, 40001L, 69999L))
  if (.Platform$OS.type == "unix") { # a process that is forked
    child <- parallel::mcparallel(list(threads(), overlap_area(many, y)))
    expect_identical(parallel::mccollect(child)[[1]], list(1L, truth[[1]]))
  }
  for (wrong in list(0, 1.5, NA, "2", 1:2, Inf)) refused(threads(wrong), "n: must be NULL or one whole number from 1 to 1024", "n")
})

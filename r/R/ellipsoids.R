# SPDX-License-Identifier: BSD-3-Clause
# Data frames of ellipses and ellipsoids: centres and forms.

.form_names <- function(d) if (d == 2) c("xx", "xy", "yy") else c("xx", "xy", "xz", "yy", "yz", "zz")

.names <- function(d) c(c("x", "y", "z")[seq_len(d)], .form_names(d))

# Numbers without dimensions, whatever vector they are, of which some may be NA. An error is one of the function that the user called.
.numbers <- function(values, name) {
  call <- sys.call(sys.parent())
  if (is.logical(values) && all(is.na(values))) values <- as.double(values)
  if (is.factor(values)) .refuse(name, NULL, NULL, "must be numeric, not a factor", call)
  if (inherits(values, "integer64")) .refuse(name, NULL, NULL, "must be numeric, not integer64: see as.double()", call)
  if (is.list(values)) .refuse(name, NULL, NULL, "must be numbers, not a list", call)
  if (!is.numeric(values)) .refuse(name, NULL, NULL, paste("must be numeric, not", if (is.object(values)) class(values)[1] else typeof(values)), call)
  bad <- which(is.infinite(values))
  if (length(bad)) .refuse(name, bad[1], NULL, "must be finite", call)
  as.vector(values, "double")
}

# A data frame as a matrix. as.matrix() makes truth values of no rows.
.matrix_of <- function(frame) {
  found <- as.matrix(frame)
  if (!nrow(found)) storage.mode(found) <- "double"
  found
}

# A matrix of numbers without names, of which some may be NA; errors name its rows.
.number_rows <- function(rows, name, call = sys.call(sys.parent())) {
  bad <- if (is.numeric(rows)) which(rowSums(is.infinite(rows)) > 0)
  if (length(bad)) .refuse(name, bad[1], NULL, "must be finite", call)
  matrix(.made(.numbers(rows, name), call), ncol = ncol(rows))
}

# Columns of the same length: each one is recycled, as data.frame() does it.
.recycled <- function(columns, call = sys.call(sys.parent())) {
  lengths <- vapply(columns, length, 0)
  most <- if (any(lengths == 0)) 0 else max(lengths)
  bad <- which(lengths > 0 & most %% pmax(lengths, 1) != 0)
  if (length(bad)) {
    text <- sprintf("has %.0f numbers, of which %.0f rows are not a multiple", lengths[bad[1]], most)
    .refuse(names(columns)[bad[1]], NULL, NULL, text, call)
  }
  lapply(columns, rep_len, most)
}

.frame <- function(centers, forms) {
  d <- length(centers)
  names(centers) <- .names(d)[seq_len(d)]
  colnames(forms) <- .form_names(d)
  cbind(as.data.frame(centers), as.data.frame(forms))
}

# The value of an expression, whose errors are those of the function that the user called.
.made <- function(expression, call = sys.call(sys.parent())) {
  force(call)
  tryCatch(expression, pw85_error = function(condition) {
    condition$call <- call
    stop(condition)
  })
}

ellipses <- function(x, y, a, b = a, angle = 0) {
  given <- .recycled(list(
    x = .numbers(x, "x"), y = .numbers(y, "y"), a = .numbers(a, "a"), b = .numbers(b, "b"), angle = .numbers(angle, "angle")
  ))
  forms <- .made(.ellipse(given$a, given$b, given$angle))
  .frame(given[c("x", "y")], forms)
}

# Quaternions in the order w, x, y, z: columns that have these names may come in another one.
.quaternions <- function(given) {
  names <- if (is.data.frame(given) || is.matrix(given)) colnames(given) else names(given)
  order <- c("w", "x", "y", "z")
  if (!setequal(names, order) || length(names) != 4) return(given)
  if (is.data.frame(given) || is.matrix(given)) given[, order, drop = FALSE] else given[order]
}

# The value of an expression, whose errors of semi-axes are those of a, b or c.
.with_axes <- function(expression, axes) {
  tryCatch(expression, pw85_error = function(condition) {
    if (!identical(condition$argument, "semi_axes")) stop(condition)
    squares <- axes[condition$row, ]^2
    bad <- which(axes[condition$row, ] <= 0 | squares == 0 | squares == Inf)
    .refuse(c("a", "b", "c")[bad[1]], condition$row, NULL, condition$requirement)
  })
}

ellipsoids <- function(x, y, z, a, b = a, c = a, quaternion = NULL, rotation = NULL) {
  given <- .recycled(list(
    x = .numbers(x, "x"), y = .numbers(y, "y"), z = .numbers(z, "z"), a = .numbers(a, "a"), b = .numbers(b, "b"), c = .numbers(c, "c")
  ))
  axes <- cbind(given$a, given$b, given$c, deparse.level = 0)
  if (!is.null(quaternion) && !is.null(rotation)) .refuse("rotation", NULL, NULL, "must be NULL if there is a quaternion")
  if (is.null(quaternion)) quaternion <- c(1, 0, 0, 0)
  # The library has matrices by rows.
  if (is.matrix(rotation) && all(dim(rotation) == 3)) rotation <- as.vector(t(rotation))
  quaternion <- .quaternions(quaternion)
  forms <- .made(.with_axes(if (is.null(rotation)) .ellipsoid_quaternion(axes, quaternion) else .ellipsoid(axes, rotation), axes))
  centers <- .recycled(c(given[c("x", "y", "z")], list(quaternion = seq_len(nrow(forms)))))[1:3]
  .frame(centers, forms)
}

# The scale of a covariance whose ellipse holds a share of a normal distribution.
.scale <- function(level, d, call = sys.call(sys.parent())) {
  if (is.null(level)) return(1)
  if (!is.numeric(level) || length(level) != 1 || !is.finite(level) || level <= 0 || level >= 1) {
    .refuse("level", NULL, NULL, "must be one number between 0 and 1", call)
  }
  qchisq(level, d)
}

# A list of matrices, from such a list, one matrix, or an array with a matrix for each last index.
.covariances <- function(given) {
  if (is.data.frame(given)) return(list(as.matrix(given)))
  if (is.list(given)) return(given)
  if (length(dim(given)) != 3) return(list(given))
  lapply(seq_len(dim(given)[3]), function(k) given[, , k])
}

covariance_ellipsoids <- function(mean, covariance, level = NULL) {
  call <- sys.call()
  covariances <- .covariances(covariance)
  sizes <- vapply(covariances, function(one) if (is.matrix(one) && is.numeric(one) && nrow(one) == ncol(one)) nrow(one) else 0L, 0L)
  bad <- which(!sizes %in% 2:3 | sizes != sizes[1])
  if (length(bad)) .refuse("covariance", bad[1], NULL, "must be a numeric matrix, 2 x 2 or 3 x 3, all of the same size")
  d <- if (length(sizes)) sizes[1] else 2L
  if (is.data.frame(mean)) mean <- .matrix_of(mean)
  if (is.list(mean) && length(mean) && all(vapply(mean, is.numeric, TRUE) & lengths(mean) == d)) mean <- do.call(rbind, mean)
  if (identical(dim(mean)[1:2], c(1L, d))) mean <- matrix(mean, ncol = d, byrow = TRUE) # a row for each last index, as in SIBER
  if (!is.matrix(mean) && length(mean) == d) mean <- matrix(mean, 1)
  if (!is.matrix(mean) || ncol(mean) != d) .refuse("mean", NULL, NULL, sprintf("must have %d columns, as covariance", d))
  asymmetric <- which(!vapply(covariances, isSymmetric, TRUE, check.attributes = FALSE))
  if (length(asymmetric)) .refuse("covariance", asymmetric[1], NULL, "must be symmetric")
  rows <- vapply(covariances, function(one) one[lower.tri(one, diag = TRUE)], numeric(d * (d + 1) / 2))
  made <- .recycled(list(mean = seq_len(nrow(mean)), covariance = seq_along(covariances)))
  centers <- .number_rows(mean, "mean")[made$mean, , drop = FALSE]
  rows <- .number_rows(matrix(rows, ncol = d * (d + 1) / 2, byrow = TRUE), "covariance")
  ellipsoids <- .frame(lapply(seq_len(d), function(k) centers[, k]), .scale(level, d) * rows[made$covariance, , drop = FALSE])
  tryCatch(second_moments(ellipsoids), pw85_error = function(condition) {
    .refuse("covariance", made$covariance[condition$row], NULL, condition$requirement, call)
  })
  ellipsoids
}

# Points as a matrix with a row for each point.
.points <- function(points, call = sys.call(sys.parent())) {
  if (is.data.frame(points)) {
    bad <- which(!vapply(points, is.numeric, TRUE))
    if (length(bad)) .refuse("points", NULL, names(points)[bad[1]], paste("must be numeric, not", class(points[[bad[1]]])[1]), call)
    points <- .matrix_of(points)
  }
  if (!is.matrix(points) || !is.numeric(points)) .refuse("points", NULL, NULL, "must be a data frame or matrix of numbers", call)
  bad <- which(!is.finite(points), arr.ind = TRUE)
  if (length(bad)) .refuse("points", min(bad[, 1]), NULL, "must be finite", call)
  storage.mode(points) <- "double"
  unname(points)
}

# The row numbers of each group, in the order of its levels; all rows if there are no groups.
.groups <- function(points, group, call = sys.call(sys.parent())) {
  if (is.null(group)) return(list(seq_len(nrow(points))))
  if (is.data.frame(group) && ncol(group) == 1) group <- group[[1]]
  if (length(group) != nrow(points)) .refuse("group", NULL, NULL, "must have a value for each row of points", call)
  if (anyNA(group)) .refuse("group", which(is.na(group))[1], NULL, "must not be NA", call)
  split(seq_len(nrow(points)), group, drop = TRUE)
}

# One row for each group; the column `group` has their names. `columns` are those of a row.
.bound <- function(found, columns) {
  rows <- if (length(found)) do.call(rbind, found) else as.data.frame(sapply(columns, function(name) numeric(0), simplify = FALSE))
  if (is.null(names(found))) rows else cbind(group = names(found), rows, row.names = NULL)
}

# The end of a message about one group.
.as_in <- function(members, k) if (is.null(names(members))) "" else paste(", as in group", names(members)[k])

standard_ellipsoids <- function(points, group = NULL, level = NULL, corrected = FALSE) {
  points <- .points(points)
  d <- ncol(points)
  if (!d %in% 2:3) .refuse("points", NULL, NULL, "must have 2 or 3 columns")
  members <- .groups(points, group)
  scale <- .scale(level, d)
  if (!isTRUE(corrected) && !isFALSE(corrected)) .refuse("corrected", NULL, NULL, "must be TRUE or FALSE")
  bad <- which(lengths(members) <= d)[1]
  if (!is.na(bad)) {
    text <- sprintf("must have more than %d rows in each group, not %d%s", d, length(members[[bad]]), .as_in(members, bad))
    .refuse("points", NULL, NULL, text)
  }
  call <- sys.call()
  found <- lapply(seq_along(members), function(k) {
    own <- points[members[[k]], , drop = FALSE]
    n <- nrow(own)
    factor <- if (corrected) scale * (n - 1) / (n - d) else scale
    tryCatch(covariance_ellipsoids(colMeans(own), factor * cov(own)), pw85_error = function(condition) {
      .refuse("points", NULL, NULL, paste0("must not be in a line or plane", .as_in(members, k)), call)
    })
  })
  .bound(structure(found, names = names(members)), .names(d))
}

# Names of the columns of an ellipsoid in any number of dimensions.
.enclosing_names <- function(d) {
  if (d %in% 2:3) return(c(.names(d), "excess"))
  pairs <- which(lower.tri(diag(d), diag = TRUE), arr.ind = TRUE)
  c(paste0("x", seq_len(d)), sprintf("q%d_%d", pairs[, 2], pairs[, 1]), "excess")
}

.enclosing <- function(points, forms, tolerance, call = sys.call(sys.parent())) {
  if (!is.numeric(tolerance) || length(tolerance) != 1 || !is.finite(tolerance) || tolerance <= 0) {
    .refuse("tolerance", NULL, NULL, "must be one positive number", call)
  }
  numbers <- .made(.Call(C_enclosing, t(points), forms, tolerance), call)
  names(numbers) <- .enclosing_names(ncol(points))
  as.data.frame(as.list(numbers))
}

enclosing_ellipsoid <- function(points, group = NULL, tolerance = 1e-6) {
  call <- sys.call()
  points <- .points(points)
  if (!ncol(points) %in% 1:16) .refuse("points", NULL, NULL, "must have 1 to 16 columns")
  found <- lapply(.groups(points, group), function(rows) .enclosing(points[rows, , drop = FALSE], NULL, tolerance, call))
  .bound(found, .enclosing_names(ncol(points)))
}

# The centres and forms of ellipses or ellipsoids as a matrix, of which some may be NA. `question` is one that refuses other rows.
.rows <- function(x, question, call = sys.call(sys.parent())) {
  force(x)
  .made(question(x), call)
  if (is.null(dim(x))) x <- t(x)
  names <- .names(if (any(c("xz", "yz", "zz") %in% colnames(x))) 3 else 2)
  numbers <- matrix(as.double(as.matrix(x[, names])), ncol = length(names), dimnames = list(NULL, names))
  .refuse_cells(numbers, is.infinite(numbers), call)
  numbers
}

# Refuses cells of a matrix of ellipses or ellipsoids.
.refuse_cells <- function(numbers, is_bad, call = sys.call(sys.parent())) {
  bad <- which(is_bad, arr.ind = TRUE)
  if (length(bad)) .refuse("x", bad[1, 1], colnames(numbers)[bad[1, 2]], "must be finite", call)
}

enclosing_ellipsoid_of <- function(x, tolerance = 1e-6) {
  numbers <- .rows(x, second_moments)
  .refuse_cells(numbers, is.na(numbers))
  if (!nrow(numbers)) .refuse("x", NULL, NULL, "must have at least one row")
  centers <- seq_len(if (ncol(numbers) == 5) 2 else 3)
  .enclosing(numbers[, centers, drop = FALSE], t(numbers[, -centers, drop = FALSE]), tolerance)
}

outline <- function(x, points = 100) {
  if (!is.numeric(points) || length(points) != 1 || !is.finite(points) || points < 1 || points %% 1 != 0) {
    .refuse("points", NULL, NULL, "must be one whole number, at least 1")
  }
  x <- as.data.frame(.rows(x, area))
  turn <- 2 * pi * (seq_len(points) - 1) / points
  # By Cholesky's factor of the form.
  first <- sqrt(x$xx)
  second <- sqrt(pmax(0, x$yy - (x$xy / first)^2))
  data.frame(
    ellipse = rep(seq_len(nrow(x)), each = points),
    x = as.vector(outer(cos(turn), first)) + rep(x$x, each = points),
    y = as.vector(outer(cos(turn), x$xy / first) + outer(sin(turn), second)) + rep(x$y, each = points)
  )
}

reproducible <- function(on = NULL) {
  if (!is.null(on) && !isTRUE(on) && !isFALSE(on)) .refuse("on", NULL, NULL, "must be TRUE, FALSE or NULL")
  before <- .Call(C_reproducible, on)
  if (is.null(on)) before else invisible(before)
}

threads <- function(n = NULL) {
  if (!is.null(n) && (!is.numeric(n) || length(n) != 1 || !is.finite(n) || n < 1 || n > 1024 || n %% 1 != 0)) {
    .refuse("n", NULL, NULL, "must be NULL or one whole number from 1 to 1024")
  }
  before <- .Call(C_threads, n)
  if (is.null(n)) before else invisible(before)
}

library_version <- function() .Call(C_version)

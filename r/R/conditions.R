# SPDX-License-Identifier: BSD-3-Clause

# Ends the call of a function of the package with a condition of class pw85_error. The C code calls it, too.
.refuse <- function(argument, row, column, requirement, call = sys.call(-1)) {
  if (!is.null(row)) row <- as.double(unname(row))
  places <- c(argument, if (!is.null(row)) paste("row", format(row, scientific = FALSE)), if (!is.null(column)) paste("column", column))
  message <- if (length(places)) paste0(paste(places, collapse = ", "), ": ", requirement) else requirement
  stop(structure(
    class = c("pw85_error", "error", "condition"),
    list(message = message, call = call, argument = argument, row = row, column = column, requirement = requirement)
  ))
}

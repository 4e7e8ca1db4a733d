library(testthat)
library(pw85)

test_check("pw85")

// SPDX-License-Identifier: BSD-3-Clause
// The program for the API before pw85 1.0, as C++.
#include "test_pre1.c"

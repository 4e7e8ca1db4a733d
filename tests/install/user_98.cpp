// SPDX-License-Identifier: BSD-3-Clause
// A program in C++98 that uses the C API of a pw85 in the tree of its project.
#include <pw85.h>

#if __cplusplus != 199711L
#error "not compiled as C++98"
#endif

int main() { return pw85_strerror(PW85_SUCCESS) == 0; }

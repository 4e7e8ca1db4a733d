// SPDX-License-Identifier: BSD-3-Clause
// What the program needs of the header that the build of coal makes.
#pragma once
#define COAL_DLLAPI
#define COAL_LOCAL

// SPDX-License-Identifier: BSD-3-Clause
// What the program needs of the header that the build of coal makes.
#pragma once
#define COAL_DEPRECATED
#define COAL_DEPRECATED_MESSAGE(message)
#define COAL_DEPRECATED_HEADER(message)

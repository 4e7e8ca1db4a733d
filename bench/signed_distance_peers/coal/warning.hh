// SPDX-License-Identifier: BSD-3-Clause
// The program needs nothing of this header, which the build of coal makes.
#pragma once

// SPDX-License-Identifier: BSD-3-Clause
// An empty program for the device. The build uses this file in place of the output of embed.py if
// no compiler for devices is available.
#include "device_code.hpp"

char const pw85::detail::gpu::device_code[] = "";

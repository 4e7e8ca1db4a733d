// SPDX-License-Identifier: BSD-3-Clause
// The C API: version and errors.
#include <pw85.h>

#include <pw85/status.hpp>

char const *pw85_version(void) { return PW85_VERSION; }

char const *pw85_strerror(int status) { return pw85::strerror(static_cast<pw85::Status>(status)); }

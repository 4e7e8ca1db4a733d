// SPDX-License-Identifier: BSD-3-Clause
#include "../../src/rare/define.hpp"
#include "compiled_once.hpp"

PW85_ONCE_SCALAR(PW85_RARE_DEFINED, long double)

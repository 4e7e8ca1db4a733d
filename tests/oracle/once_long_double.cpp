// SPDX-License-Identifier: BSD-3-Clause
#include "define_once.hpp"

PW85_ONCE_SCALAR(PW85_ONCE_DEFINED, long double)

// SPDX-License-Identifier: BSD-3-Clause
#include "../../src/rare/define.hpp"
#include "compiled_once.hpp"

PW85_ONCE_WIDE(PW85_RARE_DEFINED, pw85_tests::Wide)

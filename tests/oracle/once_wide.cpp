// SPDX-License-Identifier: BSD-3-Clause
#include "define_once.hpp"

PW85_ONCE_WIDE(PW85_ONCE_DEFINED, pw85_tests::Wide)

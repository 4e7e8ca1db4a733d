// SPDX-License-Identifier: BSD-3-Clause
/// What most tests of answers include, precompiled unless -Db_pch=false. Each source still includes
/// what it uses.
#ifndef PW85_TESTS_PCH_ANSWERS_HPP_INCLUDED
#define PW85_TESTS_PCH_ANSWERS_HPP_INCLUDED

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85_batch.h>

#include "../draws.hpp"
#include "../failures.hpp"
#include "../random_pairs.hpp"
#include "../wide.hpp"

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>

#include <pw85_batch.h>
#include <pw85_enclosing.h>
#include <pw85_legacy.h>
#include <pw85_systems.h>
#include <pw85_zheng.h>

#include "functions.hpp"

namespace pw85_tests {

std::vector<Function> const &declared_functions()
{
    static std::vector<Function> const all = {
#include "functions_table.inc"
    };
    return all;
}

} // namespace pw85_tests

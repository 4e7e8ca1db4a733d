/* SPDX-License-Identifier: BSD-3-Clause */
/* The headers of C, after those of others. */
#include <stddef.h>
#include <stdint.h>

#include "others.h"

#include <pw85.h>
#include <pw85_enclosing.h>
#include <pw85_gpu.h>
#include <pw85_legacy.h>
#include <pw85_zheng.h>

int success_of_c(void);

int success_of_c(void) { return PW85_SUCCESS; }

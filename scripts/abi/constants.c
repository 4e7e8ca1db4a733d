/* SPDX-License-Identifier: BSD-3-Clause */
/* What programs take from the headers when they are compiled and no function has in its type: as
   variables of a library, for abidiff to compare. */
#include <pw85.h>

enum pw85_status pw85_statuses;
char pw85_dim[PW85_DIM];
char pw85_sym[PW85_SYM];

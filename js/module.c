/* SPDX-License-Identifier: BSD-3-Clause */
/* What pw85.wasm has in the place of a function of the C library, so that it imports nothing: there
 * is no environment. */

char *getenv(char const *name);

char *getenv(char const *name)
{
    (void)name;
    return 0;
}

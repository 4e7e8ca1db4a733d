// SPDX-License-Identifier: BSD-3-Clause
// What pw85.wasm has in the place of a function of the C library, so that it imports nothing: there
// is no environment.

extern "C" char *getenv(char const *) { return nullptr; }

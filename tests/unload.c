/* SPDX-License-Identifier: BSD-3-Clause */
/* A program that loads the library (its only argument), runs a batch on many threads, and unloads
   it: the threads wait for more work, and must not find their code gone. */
#include <dlfcn.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

typedef int batch_function(size_t, double const *, double const *, double const *, double *,
                           double *);

enum { num_pairs = 100000 };

static int run(batch_function *batch)
{
    double *const rows = calloc(16 * (size_t)num_pairs, sizeof(double));
    int i, status = 1;
    if (rows == NULL) return status;
    for (i = 0; i < num_pairs; ++i) {
        double *const r12 = rows + 3 * i, *const q = rows + 3 * num_pairs + 6 * i;
        r12[0] = 3.0;
        q[0] = q[3] = q[5] = 1.0;
    }
    status = batch(num_pairs, rows, rows + 3 * num_pairs, rows + 3 * num_pairs,
                   rows + 9 * num_pairs, NULL);
    free(rows);
    return status;
}

int main(int argc, char **argv)
{
    struct timespec const while_threads_wait = {0, 200000000};
    void *const library = argc == 2 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : NULL;
    /* ISO C has no conversion from void * to a function: POSIX asks for this. */
    batch_function *batch = NULL;
    if (library == NULL) {
        fprintf(stderr, "%s\n", argc == 2 ? dlerror() : "usage: unload LIBRARY");
        return 1;
    }
    *(void **)&batch = dlsym(library, "pw85_contact_batch");
    if (batch == NULL || run(batch) != 0) return 2;
    if (dlclose(library) != 0) return 3;
    nanosleep(&while_threads_wait, NULL);
    return 0;
}

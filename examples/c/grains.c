/* Which of a thousand grains in a periodic cell overlap, and the normals of contacts:
 * a neighbour list, exact overlap tests, and the contact function of its pairs. */
#include <pw85.h>
#include <pw85_systems.h>

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum { num_grains = 1000 };

static double centers[num_grains][3], q[num_grains][6];
static double const cell[3][3] = {{20, 0, 0}, {0, 20, 0}, {0, 0, 20}};

/* Ends the program if a call failed, and says why. */
static void check(int status)
{
    pw85_error error;
    if (status == PW85_SUCCESS) return;
    pw85_last_error(&error);
    fprintf(stderr, "%s: %s %s\n", pw85_strerror(status),
            error.argument ? error.argument : "",
            error.requirement ? error.requirement : "");
    exit(EXIT_FAILURE);
}

/* Numbers in [0, 1) that are the same everywhere. */
static double uniform(void)
{
    static uint32_t state = 1;
    state = 1664525u * state + 1013904223u;
    return state / 4294967296.0;
}

static void make_grains(void)
{
    double const semi_axes[3] = {0.5, 0.7, 1.1};
    for (int i = 0; i < num_grains; i++) {
        double quaternion[4];
        for (int k = 0; k < 3; k++) centers[i][k] = 20 * uniform();
        for (int k = 0; k < 4; k++) quaternion[k] = uniform() - 0.5;
        check(pw85_ellipsoid_quaternion(semi_axes, quaternion, q[i]));
    }
}

int main(void)
{
    pw85_system const grains = {
        .num_particles = num_grains,
        .centers = centers[0],
        .q = q[0],
        .cell = cell[0],
        .periodic = {1, 1, 1},
    };
    pw85_neighbors *neighbors;

    make_grains();
    check(pw85_neighbors_create(&grains, 1.0, 0.0, &neighbors));
    /* The arrays of the list are valid until pw85_neighbors_destroy(). */
    pw85_pair_list const list = pw85_neighbors_list(neighbors);
    size_t const n = list.num_pairs;
    unsigned char *const overlap = malloc(n);
    double *const mu2 = malloc(n * sizeof *mu2), *const normals =
                                                     malloc(n * sizeof *normals * 3);
    if (!overlap || !mu2 || !normals) return EXIT_FAILURE;
    check(pw85_overlap_pairs(&list, &grains, overlap));
    check(pw85_contact_derivatives_pairs(&list, &grains, mu2, NULL, NULL, normals, NULL,
                                         NULL, NULL));

    size_t overlaps = 0, deepest = 0;
    for (size_t p = 0; p < n; p++) {
        overlaps += overlap[p];
        if (mu2[p] < mu2[deepest]) deepest = p;
    }
    printf("%zu pairs of boxes intersect, %zu pairs of grains overlap\n", n, overlaps);
    int32_t const *const pair = list.pairs + 2 * deepest;
    double const *const normal = normals + 3 * deepest;
    printf("smallest mu^2 = %.6f, grains %d and %d\n", mu2[deepest], (int)pair[0],
           (int)pair[1]);
    printf("normal there: (%.4f, %.4f, %.4f)\n", normal[0], normal[1], normal[2]);

    free(normals);
    free(mu2);
    free(overlap);
    pw85_neighbors_destroy(neighbors);
    return EXIT_SUCCESS;
}

/* Ellipsoids in a periodic cell: which of them overlap, and the energy and forces of a
 * soft repulsion that pushes them apart, for a few steps. */
#include <pw85.h>
#include <pw85_systems.h>

#include <math.h>
#include <stdio.h>

enum { num_particles = 64, max_pairs = num_particles * (num_particles - 1) / 2 };

static double centers[num_particles][3], q[num_particles][6], forces[num_particles][3];
static int32_t pairs[max_pairs][2];
static double mu2[max_pairs], d_r12[max_pairs][3];
static double const cell[3][3] = {{10, 0, 0}, {0, 10, 0}, {0, 0, 10}};

/* start of system */
static pw85_system const particles = {
    .num_particles = num_particles,
    .centers = centers[0],
    .q = q[0],
    .cell = cell[0],
    .periodic = {1, 1, 1},
};
/* end of system */

/* Numbers in [0, 1) that are the same everywhere. */
static double uniform(void)
{
    static uint32_t state = 1;
    state = 1664525u * state + 1013904223u;
    return state / 4294967296.0;
}

static int make_particles(void)
{
    for (int i = 0; i < num_particles; i++) {
        double const semi_axes[3] = {0.7, 0.7, 2.1};
        double quaternion[4];
        for (int k = 0; k < 3; k++) centers[i][k] = 10 * uniform();
        for (int k = 0; k < 4; k++) quaternion[k] = uniform() - 0.5;
        int const status = pw85_ellipsoid_quaternion(semi_axes, quaternion, q[i]);
        if (status != PW85_SUCCESS) return status;
    }
    return PW85_SUCCESS;
}

/* start of list: all pairs, as there are few. */
static size_t list_pairs(void)
{
    size_t n = 0;
    for (int32_t i = 0; i < num_particles; i++)
        for (int32_t j = i + 1; j < num_particles; j++, n++) {
            pairs[n][0] = i;
            pairs[n][1] = j;
        }
    return n;
}
/* end of list */

/* start of forces: U = 1/2 (1 - mu^2)^2 of pairs that overlap. */
static int push(size_t n, double *energy)
{
    pw85_pair_list const list = {.num_pairs = n, .pairs = pairs[0]};
    int const status = pw85_contact_derivatives_pairs(&list, &particles, mu2, NULL,
                                                      NULL, NULL, d_r12[0], NULL, NULL);
    if (status != PW85_SUCCESS) return status;
    *energy = 0;
    for (int i = 0; i < num_particles; i++)
        for (int k = 0; k < 3; k++) forces[i][k] = 0;
    for (size_t p = 0; p < n; p++) {
        double const depth = mu2[p] < 1 ? 1 - mu2[p] : 0;
        *energy += 0.5 * depth * depth;
        for (int k = 0; k < 3; k++) {
            forces[pairs[p][1]][k] += depth * d_r12[p][k];
            forces[pairs[p][0]][k] -= depth * d_r12[p][k];
        }
    }
    return PW85_SUCCESS;
}
/* end of forces */

int main(void)
{
    double limit, energy = 0;
    int status = make_particles();
    size_t const n = list_pairs();
    if (status == PW85_SUCCESS) status = pw85_nearest_image_limit(&particles, &limit);
    if (status == PW85_SUCCESS)
        printf("nearest images are enough: %s\n", limit >= 1 ? "yes" : "no");
    for (int step = 0; step <= 4 && status == PW85_SUCCESS; step++) {
        status = push(n, &energy);
        printf("step %d: energy %.4f\n", step, energy);
        for (int i = 0; i < num_particles; i++)
            for (int k = 0; k < 3; k++) centers[i][k] += 0.1 * forces[i][k];
    }
    if (status != PW85_SUCCESS) fprintf(stderr, "%s\n", pw85_strerror(status));
    return status;
}

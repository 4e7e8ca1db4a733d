/* Ellipses are added at random to a periodic cell until no further one fits. */
#include <pw85_simulation.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

int main(void)
{
    double const cell[9] = {30, 0, 0, 0, 30, 0, 0, 0, 1};
    /* The third semi-axis is not used in two dimensions. */
    double const semi_axes[3] = {1, 0.5, 0.5};
    pw85_random_addition *addition = NULL;
    int status = pw85_random_addition_create(2, cell, 1, semi_axes, 1, &addition);
    int end = PW85_ADDITION_CONTINUES;
    while (status == PW85_SUCCESS && end == PW85_ADDITION_CONTINUES)
        status = pw85_random_addition_advance(addition, INFINITY, 100000, &end);

    size_t n = 0;
    double attempts, free_share;
    if (status == PW85_SUCCESS)
        status = pw85_random_addition_state(addition, &n, &attempts, &free_share);
    double *centers = malloc(3 * n * sizeof(double));
    double *quaternions = malloc(4 * n * sizeof(double));
    if (status == PW85_SUCCESS && (centers == NULL || quaternions == NULL))
        status = PW85_ENOMEM;
    if (status == PW85_SUCCESS)
        status =
            pw85_random_addition_particles(addition, n, centers, quaternions, NULL);
    if (status == PW85_SUCCESS)
        printf("%s, area fraction %.1f\n",
               end == PW85_ADDITION_SATURATED ? "saturated" : "not saturated",
               (double)n * 3.14159265358979 * 1 * 0.5 / (30 * 30));

    free(centers), free(quaternions);
    pw85_random_addition_destroy(addition);
    return status;
}

/* An ellipsoid and a solid box that have poses: their signed distance, and its
 * derivatives with respect to the pose of the ellipsoid. A pose takes x of the body to
 * R x + t in the world. */
#include <pw85.h>
#include <stdio.h>

struct pose {
    double r[9], t[3]; /* rows of the rotation matrix, and the translation */
};

/* The entries i, j of R2ᵀ R1. */
static void relative_rotation(double const r2[9], double const r1[9], double r[9])
{
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            r[3 * i + j] =
                r2[i] * r1[j] + r2[3 + i] * r1[3 + j] + r2[6 + i] * r1[6 + j];
}

/* From the frame of a body to that of the world. */
static void turn(double const r[9], double const x[3], double y[3])
{
    for (int i = 0; i < 3; ++i)
        y[i] = r[3 * i] * x[0] + r[3 * i + 1] * x[1] + r[3 * i + 2] * x[2];
}

/* The points are relative to the centre of the ellipsoid, along the world's axes. */
static int distance_of_poses(double const axes[3], struct pose const *one,
                             double const half[3], struct pose const *box,
                             double *distance, double p1[3], double p2[3], double n[3])
{
    /* In the frame of the box: the rotation of the ellipsoid, and the box about it. */
    double r[9], q[6], lower[3], upper[3], point1[3], point2[3], normal[3];
    relative_rotation(box->r, one->r, r);
    for (int i = 0; i < 3; ++i) {
        double center = 0;
        for (int k = 0; k < 3; ++k)
            center += box->r[3 * k + i] * (one->t[k] - box->t[k]);
        lower[i] = -half[i] - center;
        upper[i] = half[i] - center;
    }
    int status = pw85_ellipsoid(axes, r, q);
    if (status == PW85_SUCCESS)
        status =
            pw85_distance_solid_box(lower, upper, q, distance, point1, point2, normal);
    if (status != PW85_SUCCESS) return status;
    turn(box->r, point1, p1);
    turn(box->r, point2, p2);
    turn(box->r, normal, n);
    return status;
}

int main(void)
{
    double const axes[3] = {3, 2, 1}, half[3] = {1, 2, 0.5};
    struct pose const one = {{0.8, 0, 0.6, 0, 1, 0, -0.6, 0, 0.8}, {1, 6, 2}};
    struct pose const box = {{0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1}, {0, 0.5, 0}};
    double d, p1[3], p2[3], n[3];
    int const status = distance_of_poses(axes, &one, half, &box, &d, p1, p2, n);
    if (status != PW85_SUCCESS) {
        fprintf(stderr, "%s\n", pw85_strerror(status));
        return 1;
    }
    printf("distance %.5f\n", d);
    printf("derivative, translation (%.4f, %.4f, %.4f)\n", -n[0], -n[1], -n[2]);
    printf("derivative, rotation (%.4f, %.4f, %.4f)\n", n[1] * p1[2] - n[2] * p1[1],
           n[2] * p1[0] - n[0] * p1[2], n[0] * p1[1] - n[1] * p1[0]);
}

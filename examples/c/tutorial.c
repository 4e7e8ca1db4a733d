/* Do a thin disk and a rod overlap? Prints the contact function of the two, then checks
 * it: with the factor μ the two touch, in one point and with one tangent plane. */
#include <pw85.h>

#include <math.h>
#include <stdio.h>

/* (m - c)ᵀ Q⁻¹ (m - c) for x = m - c: 1 on the surface of the ellipsoid. The gradient
 * of this is 2 Q⁻¹ x. */
static double surface_value(double const q[PW85_SYM], double const x[PW85_DIM],
                            double gradient[PW85_DIM])
{
    double l[PW85_SYM], value = 0.0;
    pw85__cholesky_decomp(q, l);
    pw85__cholesky_solve(l, x, gradient);
    for (int i = 0; i < PW85_DIM; i++) value += x[i] * gradient[i];
    return value;
}

static void normalize(double x[PW85_DIM])
{
    double const norm = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    for (int i = 0; i < PW85_DIM; i++) x[i] /= norm;
}

int main(void)
{
    /* An oblate spheroid: equatorial radius 10, polar radius 0.1, axis z. */
    double const x1[PW85_DIM] = {-0.5, 0.4, -0.7}, n1[PW85_DIM] = {0.0, 0.0, 1.0};
    double const a1 = 10.0, c1 = 0.1;

    /* A prolate spheroid: equatorial radius 0.5, polar radius 5, axis x. */
    double const x2[PW85_DIM] = {0.2, -0.3, 0.4}, n2[PW85_DIM] = {1.0, 0.0, 0.0};
    double const a2 = 0.5, c2 = 5.0;

    double r12[PW85_DIM], q1[PW85_SYM], q2[PW85_SYM], out[2];
    for (int i = 0; i < PW85_DIM; i++) r12[i] = x2[i] - x1[i];
    pw85_spheroid(a1, c1, n1, q1);
    pw85_spheroid(a2, c2, n2, q2);

    int status = pw85_contact_function(r12, q1, q2, out);
    if (status != PW85_SUCCESS) {
        fprintf(stderr, "%s\n", pw85_strerror(status));
        return 1;
    }
    double const mu2 = out[0], lambda = out[1];
    printf("mu^2 = %g\n", mu2);
    printf("lambda = %g\n", lambda);
    printf("The spheroids %s.\n\n", mu2 < 1.0 ? "overlap" : "do not overlap");

    /* The point where the spheroids touch when they are scaled by mu, from the centre
     * of either. */
    double point[PW85_DIM], from1[PW85_DIM], from2[PW85_DIM], normal1[PW85_DIM],
        normal2[PW85_DIM];
    status = pw85_contact_geometry(r12, q1, q2, lambda, point, NULL);
    if (status != PW85_SUCCESS) {
        fprintf(stderr, "%s\n", pw85_strerror(status));
        return 1;
    }
    for (int i = 0; i < PW85_DIM; i++) {
        from1[i] = point[i];
        from2[i] = point[i] - r12[i];
    }

    /* Scaling by mu multiplies the forms by mu². */
    for (int i = 0; i < PW85_SYM; i++) {
        q1[i] *= mu2;
        q2[i] *= mu2;
    }
    double const value1 = surface_value(q1, from1, normal1),
                 value2 = surface_value(q2, from2, normal2);
    normalize(normal1);
    normalize(normal2);
    printf("contact point = (%.6f, %.6f, %.6f)\n", x1[0] + point[0], x1[1] + point[1],
           x1[2] + point[2]);
    printf("on spheroid 1, scaled: %.10f\n", value1);
    printf("on spheroid 2, scaled: %.10f\n", value2);
    printf("normal to spheroid 1 = (%.6f, %.6f, %.6f)\n", normal1[0], normal1[1],
           normal1[2]);
    printf("normal to spheroid 2 = (%.6f, %.6f, %.6f)\n", normal2[0], normal2[1],
           normal2[2]);
    return 0;
}

/* Two ellipsoids: the contact function, the distance, and where they are closest. */
#include <pw85.h>
#include <stdio.h>

int main(void)
{
    double const r12[3] = {3, 2, 1}; /* from the first centre to the second */
    double const axes1[3] = {3, 2, 1}, turn1[4] = {1, 0, 0, 0};
    double const axes2[3] = {4, 1, 1}, turn2[4] = {0.9, 0.1, 0.3, 0.2}; /* w, x, y, z */
    double q1[6], q2[6], out[2], distance, p1[3], p2[3];
    pw85_ellipsoid_quaternion(axes1, turn1, q1);
    pw85_ellipsoid_quaternion(axes2, turn2, q2);
    int status = pw85_contact(r12, q1, q2, out);
    if (status == PW85_SUCCESS) status = pw85_distance(r12, q1, q2, &distance, p1, p2);
    if (status != PW85_SUCCESS) {
        fprintf(stderr, "%s\n", pw85_strerror(status));
        return 1;
    }
    printf("mu^2 = %.5f: %s\n", out[0], out[0] < 1 ? "overlap" : "apart");
    printf("distance = %.5f, from (%.4f, %.4f, %.4f)\n", distance, p1[0], p1[1], p1[2]);
}

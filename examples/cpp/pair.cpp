// Two ellipsoids: the contact function, the distance, and where they are closest.
#include <cstdio>
#include <pw85/pw85.hpp>

int main()
{
    using namespace pw85;
    Vector const r12{3.0, 2.0, 1.0}; // from the first centre to the second
    Vector const axes1{3.0, 2.0, 1.0}, axes2{4.0, 1.0, 1.0};
    Vector const turn1{1.0, 0.0, 0.0, 0.0}, turn2{0.9, 0.1, 0.3, 0.2}; // w, x, y, z
    auto const q1 = ellipsoid_quaternion(axes1, turn1).q;
    auto const q2 = ellipsoid_quaternion(axes2, turn2).q;
    auto const [mu2, lambda, status] = contact(r12, q1, q2);
    if (status != Status::success) {
        std::fprintf(stderr, "%s\n", strerror(status));
        return 1;
    }
    auto const gap = distance(r12, q1, q2);
    auto const &p = gap.point1;
    std::printf("mu^2 = %.5f: %s\n", mu2, mu2 < 1 ? "overlap" : "apart");
    std::printf("distance = %.5f, from (%.4f, %.4f, %.4f)\n", gap.distance, p[0], p[1],
                p[2]);
}

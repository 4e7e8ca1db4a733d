// Two soft ellipsoids that overlap push each other apart and turn, by steepest descent
// on the energy
//
//     U = ½ (1 - μ²)²  where μ² < 1,  0 elsewhere,
//
// with force and torques from the derivatives of μ². The centre of mass stays, since
// the forces are equal and opposite.
#include <pw85/pw85.hpp>

#include <cmath>
#include <cstdio>

using Vector3 = pw85::Vector<double, 3>;
using Quaternion = pw85::Vector<double, 4>;

struct Body {
    Vector3 semi_axes, center;
    Quaternion orientation; // (w, x, y, z)
};

// Derivatives of the energy: with respect to the centre of body 2 (minus that for body
// 1), and to rotations.
struct Energy {
    double value;
    Vector3 center2, rotation1, rotation2;
};

static Energy energy(Body const &body1, Body const &body2)
{
    auto const q1 = pw85::ellipsoid_quaternion(body1.semi_axes, body1.orientation).q;
    auto const q2 = pw85::ellipsoid_quaternion(body2.semi_axes, body2.orientation).q;
    Vector3 r12{};
    for (int i = 0; i < 3; ++i) r12[i] = body2.center[i] - body1.center[i];
    auto const [mu2, lambda, status] = pw85::contact(r12, q1, q2);
    if (!(mu2 < 1.0)) return {};
    auto const gradient = pw85::contact_gradient(r12, q1, q2, lambda);
    auto const torque = pw85::contact_torque(r12, q1, q2, lambda);
    double const slope = mu2 - 1.0; // dU/dμ²
    return {0.5 * slope * slope, slope * gradient.r12, slope * torque.rotation1,
            slope * torque.rotation2};
}

// The orientation after a rotation by the small vector omega: q + ½ (0, ω) q, of which
// only the direction matters.
static Quaternion rotated(Quaternion const &q, Vector3 const &omega)
{
    Vector3 const h = 0.5 * omega;
    Quaternion const r{q[0] - h[0] * q[1] - h[1] * q[2] - h[2] * q[3],
                       q[1] + h[0] * q[0] + h[1] * q[3] - h[2] * q[2],
                       q[2] + h[1] * q[0] + h[2] * q[1] - h[0] * q[3],
                       q[3] + h[2] * q[0] + h[0] * q[2] - h[1] * q[1]};
    return 1.0 / std::sqrt(pw85::dot(r, r)) * r;
}

// A step down the gradient.
static void relax(Body &body1, Body &body2, Energy const &e, double step)
{
    for (int i = 0; i < 3; ++i) {
        body1.center[i] += step * e.center2[i];
        body2.center[i] -= step * e.center2[i];
    }
    body1.orientation = rotated(body1.orientation, -step * e.rotation1);
    body2.orientation = rotated(body2.orientation, -step * e.rotation2);
}

int main()
{
    Body body1{{3.0, 1.0, 0.8}, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}};
    Body body2{{2.0, 1.2, 0.9}, {0.8, 0.9, 0.4}, {0.9, 0.1, 0.3, 0.2}};
    double const tolerance = 1e-12;
    double step = 0.5;
    int steps = 0;
    Energy e = energy(body1, body2);
    std::printf("energy at the start: %.6f\n", e.value);
    for (; e.value > tolerance && steps < 1000; ++steps) {
        Body trial1 = body1, trial2 = body2;
        relax(trial1, trial2, e, step);
        Energy const next = energy(trial1, trial2);
        if (next.value >= e.value) {
            step *= 0.5;
            continue;
        }
        body1 = trial1;
        body2 = trial2;
        e = next;
        step *= 1.5;
    }
    bool const relaxed = e.value <= tolerance;
    std::printf("energy at the end: %s 1e-12\n", relaxed ? "below" : "above");
    double drift = 0.0;
    for (int i = 0; i < 3; ++i)
        drift = std::fmax(drift, std::fabs(body1.center[i] + body2.center[i] -
                                           (i == 0   ? 0.8
                                            : i == 1 ? 0.9
                                                     : 0.4)));
    std::printf("drift of the centre of mass: %s 1e-14\n",
                drift < 1e-14 ? "below" : "above");
    return relaxed && drift < 1e-14 ? 0 : 1;
}

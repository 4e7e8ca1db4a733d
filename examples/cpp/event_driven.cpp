// Event-driven dynamics of hard ellipsoids in a periodic cube, and their compression until they
// jam, by the algorithm of Lubachevsky and Stillinger (J. Stat. Phys. 60, 561, 1990): particles
// grow while they fly, turn and collide.
//
// Moments of inertia are equal, so that angular velocities are constant between collisions. Each
// event is the first contact of a pair, none of which can be missed. Usage: event_driven [PARTICLES
// [COLLISIONS [COLLISIONS_OF_JAMMED]]]
#include <pw85/pw85.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <queue>
#include <random>
#include <tuple>
#include <vector>

using Vector = pw85::Vector<double, 3>;
using Quaternion = pw85::Vector<double, 4>;
using pw85::contact, pw85::contact_geometry, pw85::cross, pw85::dot;
constexpr Vector semi_axes{0.5, 0.5, 1.0}; // at time 0
constexpr double inertia = 0.2;            // where the mass is 1

struct Particle {
    Vector center;
    Quaternion orientation;
    pw85::Motion<double, 3> motion;
    pw85::SymmetricMatrix<double, 3> form;
    long collisions; // so far
};

// Time, particles, and how often they had collided when it was predicted.
using Event = std::tuple<double, std::size_t, std::size_t, long>;

double square(Vector const &x) { return dot(x, x); }

Vector sum(Vector const &x, double factor, Vector const &y)
{
    return {x[0] + factor * y[0], x[1] + factor * y[1], x[2] + factor * y[2]};
}

// The orientation after a rotation by |omega| about omega.
Quaternion rotated(Quaternion const &q, Vector const &omega)
{
    double const angle = std::sqrt(square(omega)), c = std::cos(0.5 * angle);
    double const s = angle > 0.0 ? std::sin(0.5 * angle) / angle : 0.0;
    Vector const w = s * omega, v{q[1], q[2], q[3]};
    Vector const x = sum(sum(c * v, q[0], w), 1.0, cross(w, v));
    Quaternion const r{c * q[0] - dot(w, v), x[0], x[1], x[2]};
    return 1.0 / std::sqrt(dot(r, r)) * r;
}

struct Simulation {
    double growth, side, time = 0.0, horizon = 0.0;
    std::vector<Particle> particles;
    std::priority_queue<Event, std::vector<Event>, std::greater<>> events;

    Simulation(int n, double growthrate) : growth(growthrate)
    {
        std::mt19937_64 random(2026);
        std::normal_distribution<double> normal;
        auto const vector = [&](double size) {
            return size * Vector{normal(random), normal(random), normal(random)};
        };
        int const m = static_cast<int>(std::ceil(std::cbrt(n) - 1e-9));
        side = 2.02 * m;
        for (int k = 0; k < n; ++k) {
            Vector const site{2.02 * (k % m), 2.02 * (k / m % m), 2.02 * (k / m / m)};
            particles.push_back(
                {site,
                 rotated({1.0, 0.0, 0.0, 0.0}, vector(1.0)),
                 {vector(1.0), vector(1.0 / std::sqrt(inertia)), growth},
                 {},
                 0});
        }
        fly(0.0);
        predict_all();
    }

    double energy() const
    {
        double sum = 0.0;
        for (auto const &[x, q, motion, form, n] : particles)
            sum += square(motion.velocity) + inertia * square(motion.angular_velocity);
        return 0.5 * sum;
    }

    double packing_fraction() const
    {
        double const n = static_cast<double>(particles.size());
        auto const form =
            pw85::ellipsoid_quaternion(size() * semi_axes, {1, 0, 0, 0}).q;
        return n * pw85::volume(form).volume / std::pow(side, 3.0);
    }

    // Up to and with the next collision.
    void collide_next()
    {
        for (;;) {
            for (; events.empty(); predict_all()) fly(horizon - time);
            auto const [next, i, j, collisions] = events.top();
            events.pop();
            if (particles[i].collisions + particles[j].collisions != collisions)
                continue;
            fly(next - time);
            collide(particles[i], particles[j]);
            for (std::size_t k = 0; k < particles.size(); ++k) {
                if (k != i) predict(i, k);
                if (k != j) predict(j, k);
            }
            return;
        }
    }

    // Whether ellipsoids overlap by more than rounding.
    bool overlap() const
    {
        for (auto const &p : particles)
            for (auto const &q : particles) {
                double const mu2 = contact(separation(p, q), p.form, q.form).mu2;
                if (&p != &q && mu2 < 1.0 - 1e-10) return true;
            }
        return false;
    }

    // Whether no ellipsoid is longer than half the side: else other images than the nearest
    // ones can touch.
    bool cell_is_large() const { return 2.0 * (2.0 * semi_axes[2] * size()) <= side; }

    double size() const { return 1.0 + growth * time; }

    Vector separation(Particle const &p, Particle const &q) const
    {
        Vector r = sum(q.center, -1.0, p.center);
        for (int d = 0; d < 3; ++d) r[d] -= side * std::round(r[d] / side);
        return r;
    }

    void fly(double duration)
    {
        time += duration;
        for (auto &[center, orientation, motion, form, collisions] : particles) {
            center = sum(center, duration, motion.velocity);
            orientation = rotated(orientation, duration * motion.angular_velocity);
            motion.growth = growth / size();
            form = pw85::ellipsoid_quaternion(size() * semi_axes, orientation).q;
        }
    }

    // The contact of two particles, up to the horizon.
    void predict(std::size_t i, std::size_t j)
    {
        Particle const &p = particles[i], &q = particles[j];
        double const left = horizon - time;
        auto const [wait, status] = pw85::first_contact(
            separation(p, q), p.form, q.form, p.motion, q.motion, left);
        if (wait <= left) events.push({time + wait, i, j, p.collisions + q.collisions});
    }

    // All contacts up to a new horizon, before which no other image of a particle comes near.
    void predict_all()
    {
        double fastest = 0.0;
        for (auto const &p : particles)
            fastest = std::fmax(fastest, square(p.motion.velocity));
        horizon = time + 0.01 * side / std::sqrt(fastest);
        for (std::size_t i = 0; i < particles.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) predict(i, j);
    }

    // Elastic, without friction: the surfaces, which grow, part as fast as they met.
    void collide(Particle &p, Particle &q)
    {
        auto &[v1, w1, growth1] = p.motion;
        auto &[v2, w2, growth2] = q.motion;
        Vector const r12 = separation(p, q);
        double const lambda = contact(r12, p.form, q.form).lambda;
        auto const [arm1, n, status] = contact_geometry(r12, p.form, q.form, lambda);
        Vector const lever1 = cross(arm1, n), lever2 = cross(sum(arm1, -1.0, r12), n);
        double const parting = dot(n, sum(sum(v2, -1.0, v1), -growth1, r12)) +
                               dot(lever2, w2) - dot(lever1, w1);
        double const turning = square(lever1) + square(lever2);
        double const impulse = -2.0 * parting / (2.0 + turning / inertia);
        v1 = sum(v1, -impulse, n);
        v2 = sum(v2, impulse, n);
        w1 = sum(w1, -impulse / inertia, lever1);
        w2 = sum(w2, impulse / inertia, lever2);
        ++p.collisions;
        ++q.collisions;
    }
};

int main(int argc, char **argv)
{
    int const n = argc > 1 ? std::atoi(argv[1]) : 500;
    int const collisions = argc > 2 ? std::atoi(argv[2]) : 5000;
    int const jammed = n * (argc > 3 ? std::atoi(argv[3]) : 100);

    bool good = true;
    auto const report = [&](char const *what, bool yes, bool expected) {
        std::printf("%s: %s\n", what, yes ? "yes" : "no");
        good = good && yes == expected;
    };

    Simulation dynamics(n, 0.0);
    double change = 0.0;
    for (int k = 0; k < collisions; ++k) {
        double const before = dynamics.energy();
        dynamics.collide_next();
        change = std::fmax(change, std::fabs(dynamics.energy() / before - 1.0));
    }
    report("energy conserved to rounding in each collision", change < 1e-13, true);
    report("ellipsoids overlap", dynamics.overlap(), false);

    // Jammed: so many collisions add less than a hundredth to the volume.
    Simulation packing(n, 0.3);
    for (double before = 0.0; packing.packing_fraction() > 1.01 * before;) {
        before = packing.packing_fraction();
        for (int k = 0; k < jammed; ++k) packing.collide_next();
    }
    report("jammed, more than 55 % full", packing.packing_fraction() > 0.55, true);
    report("ellipsoids overlap", packing.overlap(), false);
    report("the nearest images are all that can touch", packing.cell_is_large(), true);
    return good ? 0 : 1;
}

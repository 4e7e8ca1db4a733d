// Event-driven dynamics of hard ellipsoids in a periodic cube, and their compression until they jam, by the algorithm of
// Lubachevsky and Stillinger (J. Stat. Phys. 60, 561, 1990): particles grow while they fly, turn and collide.
//
// Moments of inertia are equal, so that angular velocities are constant between collisions. Each event is the first contact of
// a pair, none of which can be missed. Usage: event_driven [PARTICLES [COLLISIONS [COLLISIONS_OF_JAMMED]]]
#include <pw85/pw85.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <queue>
#include <random>
#include <tuple>
#include <vector>

using Vector = pw85::Vector<double, 3>;
using Quaternion = pw85::Vector<double, 4>;
using pw85::cross, pw85::dot, pw85::times;
constexpr Vector semi_axes{0.5, 0.5, 1.0}; // at time 0: the volume is π/3
constexpr double inertia = 0.2;            // where the mass is 1

struct Particle {
    Vector center, velocity, spin;
    Quaternion orientation;
    double time;     // to which it has been brought
    long collisions; // so far
};

// Time, particles, and how often they had collided when it was predicted.
using Event = std::tuple<double, std::size_t, std::size_t, long>;

Vector sum(Vector const &x, double factor, Vector const &y)
{
    return {x[0] + factor * y[0], x[1] + factor * y[1], x[2] + factor * y[2]};
}

double length(Vector const &x) { return std::sqrt(dot(x, x)); }

// The orientation after a rotation by |omega| about omega.
Quaternion rotated(Quaternion const &q, Vector const &omega)
{
    double const angle = length(omega), c = std::cos(0.5 * angle);
    double const s = angle > 0.0 ? std::sin(0.5 * angle) / angle : 0.0;
    Vector const w = times(s, omega), v{q[1], q[2], q[3]};
    Vector const x = sum(sum(times(c, v), q[0], w), 1.0, cross(w, v));
    Quaternion const r{c * q[0] - dot(w, v), x[0], x[1], x[2]};
    return times(1.0 / std::sqrt(dot(r, r)), r);
}

class Simulation {
  public:
    Simulation(int n, double growth) : growth_(growth)
    {
        std::mt19937_64 random(2026);
        std::normal_distribution<double> normal;
        auto const vector = [&] {
            return Vector{normal(random), normal(random), normal(random)};
        };
        int const m = static_cast<int>(std::ceil(std::cbrt(n) - 1e-9));
        side_ = 2.02 * m;
        for (int k = 0; k < n; ++k) {
            Vector const site{1.0 * (k % m), 1.0 * (k / m % m), 1.0 * (k / m / m)};
            Vector const spin = times(1.0 / std::sqrt(inertia), vector());
            Quaternion const orientation = rotated({1.0, 0.0, 0.0, 0.0}, vector());
            particles_.push_back(
                {times(2.02, site), vector(), spin, orientation, 0.0, 0});
        }
        predict_all();
    }

    double energy() const
    {
        double sum = 0.0;
        for (auto const &[x, v, w, q, time, collisions] : particles_)
            sum += 0.5 * (dot(v, v) + inertia * dot(w, w));
        return sum;
    }

    double packing_fraction() const
    {
        double const ratio = size(time_) / side_,
                     n = static_cast<double>(particles_.size());
        return n * std::numbers::pi / 3.0 * ratio * ratio * ratio;
    }

    // Up to and with the next collision.
    void collide_next()
    {
        for (;;) {
            for (; events_.empty(); predict_all()) time_ = horizon_;
            auto const [time, i, j, collisions] = events_.top();
            events_.pop();
            Particle &p = particles_[i], &q = particles_[j];
            if (p.collisions + q.collisions != collisions) continue;
            time_ = time;
            collide(p, q);
            predict(i, 0);
            return predict(j, 0);
        }
    }

    // Whether ellipsoids overlap by more than rounding.
    bool overlap()
    {
        bool found = false;
        for (auto &p : particles_)
            for (auto &q : particles_) {
                bring(p);
                bring(q);
                double const mu2 =
                    pw85::contact(separation(p, q), form(p), form(q)).mu2;
                found = found || (&p != &q && mu2 < 1.0 - 1e-10);
            }
        return found;
    }

  private:
    double size(double time) const { return 1.0 + growth_ * time; }

    pw85::SymmetricMatrix<double, 3> form(Particle const &p) const
    {
        Vector const axes = times(size(p.time), semi_axes);
        return pw85::ellipsoid_quaternion(axes, p.orientation).q;
    }

    pw85::Motion<double, 3> motion(Particle const &p) const
    {
        return {p.velocity, p.spin, growth_ / size(p.time)};
    }

    Vector separation(Particle const &p, Particle const &q) const
    {
        Vector r = sum(q.center, -1.0, p.center);
        for (int d = 0; d < 3; ++d) r[d] -= side_ * std::round(r[d] / side_);
        return r;
    }

    void bring(Particle &p) const
    {
        if (p.time == time_) return;
        p.center = sum(p.center, time_ - p.time, p.velocity);
        p.orientation = rotated(p.orientation, times(time_ - p.time, p.spin));
        p.time = time_;
    }

    // Contacts of particle i with those from `first` on, up to the horizon.
    void predict(std::size_t i, std::size_t first)
    {
        Particle &p = particles_[i];
        bring(p);
        double const left = horizon_ - time_;
        for (std::size_t j = first; j < particles_.size(); ++j) {
            Particle &q = particles_[j];
            bring(q);
            Vector const r12 = separation(p, q);
            double const flight = left * (length(p.velocity) + length(q.velocity));
            if (i == j || length(r12) > 2.0 * size(horizon_) + flight) continue;
            auto const [wait, status] =
                pw85::first_contact(r12, form(p), form(q), motion(p), motion(q), left);
            if (wait <= left)
                events_.push({time_ + wait, i, j, p.collisions + q.collisions});
        }
    }

    // All contacts up to a new horizon, before which no other image of a particle comes near.
    void predict_all()
    {
        double fastest = 0.0;
        for (auto const &p : particles_)
            fastest = std::fmax(fastest, length(p.velocity));
        horizon_ = time_ + 0.01 * side_ / fastest;
        for (std::size_t i = 0; i < particles_.size(); ++i) predict(i, i + 1);
    }

    // Elastic, without friction: the surfaces, which grow, part as fast as they met.
    void collide(Particle &p, Particle &q)
    {
        bring(p);
        bring(q);
        Vector const r12 = separation(p, q);
        double const lambda = pw85::contact(r12, form(p), form(q)).lambda;
        auto const [arm1, n, status] =
            pw85::contact_geometry(r12, form(p), form(q), lambda);
        Vector const lever1 = cross(arm1, n), lever2 = cross(sum(arm1, -1.0, r12), n);
        double const parting = dot(n, sum(q.velocity, -1.0, p.velocity)) +
                               dot(lever2, q.spin) - dot(lever1, p.spin) -
                               growth_ / size(time_) * dot(n, r12);
        double const turning = dot(lever1, lever1) + dot(lever2, lever2);
        double const impulse = -2.0 * parting / (2.0 + turning / inertia);
        p.velocity = sum(p.velocity, -impulse, n);
        q.velocity = sum(q.velocity, impulse, n);
        p.spin = sum(p.spin, -impulse / inertia, lever1);
        q.spin = sum(q.spin, impulse / inertia, lever2);
        ++p.collisions;
        ++q.collisions;
    }

    double growth_, side_, time_ = 0.0, horizon_ = 0.0;
    std::vector<Particle> particles_;
    std::priority_queue<Event, std::vector<Event>, std::greater<>> events_;
};

bool report(char const *what, bool yes)
{
    std::printf("%s: %s\n", what, yes ? "yes" : "no");
    return yes;
}

int main(int argc, char **argv)
{
    int const n = argc > 1 ? std::atoi(argv[1]) : 500;
    int const collisions = argc > 2 ? std::atoi(argv[2]) : 5000;
    int const jammed = n * (argc > 3 ? std::atoi(argv[3]) : 100);

    Simulation dynamics(n, 0.0);
    double change = 0.0;
    for (int k = 0; k < collisions; ++k) {
        double const before = dynamics.energy();
        dynamics.collide_next();
        change = std::fmax(change, std::fabs(dynamics.energy() / before - 1.0));
    }
    bool good =
        report("energy conserved to rounding in each collision", change < 1e-13);
    good = !report("ellipsoids overlap", dynamics.overlap()) && good;

    // Jammed: so many collisions add less than a hundredth to the volume.
    Simulation packing(n, 0.3);
    for (double before = 0.0; packing.packing_fraction() > 1.01 * before;) {
        before = packing.packing_fraction();
        for (int k = 0; k < jammed; ++k) packing.collide_next();
    }
    good = report("jammed, more than 55 % full", packing.packing_fraction() > 0.55) &&
           good;
    return !report("ellipsoids overlap", packing.overlap()) && good ? 0 : 1;
}

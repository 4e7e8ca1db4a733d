// Random ellipsoids in a periodic box, moved and turned until none overlap: GSL's BFGS on the soft
// repulsion Σ ½(1-μ)² of the pairs that overlap.
// Usage: relax [number [packing fraction [seed]]]
#include <gsl/gsl_multimin.h>
#include <pw85/batch.hpp>
#include <pw85/pw85.hpp>
#include <pw85/systems.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

using Vector3 = pw85::Vector<double, 3>;
using Quaternion = pw85::Vector<double, 4>;

struct Packing {
    double edge;
    std::vector<Vector3> semi_axes, centers;
    std::vector<Quaternion> orientations;
    pw85::Neighbors neighbors;
};

// The pairs that overlap, with derivatives of μ².
struct Contacts {
    std::vector<pw85::IndexPair> pairs;
    std::vector<double> mu2;
    std::vector<Vector3> d_r12, d_rot1, d_rot2;
};

static Quaternion turned(Quaternion const &q, Vector3 const &omega)
{
    double const angle = std::sqrt(pw85::dot(omega, omega));
    double const c = std::cos(0.5 * angle),
                 s = angle > 0.0 ? std::sin(0.5 * angle) / angle : 0.5;
    Vector3 const h = s * omega;
    return {c * q[0] - h[0] * q[1] - h[1] * q[2] - h[2] * q[3],
            c * q[1] + h[0] * q[0] + h[1] * q[3] - h[2] * q[2],
            c * q[2] + h[1] * q[0] + h[2] * q[1] - h[0] * q[3],
            c * q[3] + h[2] * q[0] + h[0] * q[2] - h[1] * q[1]};
}

// Jᵀ torque, with exp(ω + dω) = exp(J dω) exp(ω).
static Vector3 along_rotation_vector(Vector3 const &omega, Vector3 const &torque)
{
    double const angle = std::sqrt(pw85::dot(omega, omega));
    double const a = angle < 1e-3 ? 0.5 : (1.0 - std::cos(angle)) / (angle * angle);
    double const b =
        angle < 1e-3 ? 1.0 / 6.0 : (angle - std::sin(angle)) / (angle * angle * angle);
    Vector3 const once = pw85::cross(omega, torque), twice = pw85::cross(omega, once);
    Vector3 sum = torque;
    for (int d = 0; d < 3; ++d) sum[d] += b * twice[d] - a * once[d];
    return sum;
}

static Vector3 row(gsl_vector const *x, std::size_t i)
{
    return {gsl_vector_get(x, 3 * i), gsl_vector_get(x, 3 * i + 1),
            gsl_vector_get(x, 3 * i + 2)};
}

// The pairs that overlap after displacements and rotation vectors x, or as they are.
static Contacts contacts(Packing &packing, gsl_vector const *x)
{
    std::size_t const n = packing.centers.size();
    std::vector<Vector3> centers = packing.centers;
    std::vector<Quaternion> orientations = packing.orientations;
    for (std::size_t i = 0; x != nullptr && i < n; ++i) {
        for (int d = 0; d < 3; ++d) centers[i][d] += row(x, i)[d];
        orientations[i] = turned(orientations[i], row(x, n + i));
    }
    std::vector<pw85::SymmetricMatrix<double, 3>> q(n);
    pw85::ellipsoid_quaternion_batch(packing.semi_axes, orientations, q);
    double const e = packing.edge;
    pw85::Cell const rows{Vector3{e, 0, 0}, Vector3{0, e, 0}, Vector3{0, 0, e}};
    pw85::Particles const particles{centers, q, &rows};
    int holds = 0; // an empty list, of no particles, is refused
    pw85::neighbors_holds(packing.neighbors, particles, holds);
    if (holds != 1) {
        auto const options = pw85::NeighborOptions{.skin = 0.3};
        if (pw85::neighbors_create(particles, options, packing.neighbors) !=
            pw85::Status::success)
            std::exit(1);
    }
    auto const list = packing.neighbors.list();
    std::vector<unsigned char> overlap(list.pairs.size());
    pw85::overlap_pairs(list, particles, overlap);
    Contacts found;
    std::vector<pw85::Image> found_images;
    for (std::size_t k = 0; k < list.pairs.size(); ++k) {
        if (overlap[k] == 0) continue;
        found.pairs.push_back(list.pairs[k]);
        found_images.push_back(list.images[k]);
    }
    found.mu2.resize(found.pairs.size());
    for (auto *const v : {&found.d_r12, &found.d_rot1, &found.d_rot2})
        v->resize(found.pairs.size());
    pw85::contact_derivatives_pairs(
        {found.pairs, found_images}, particles,
        {found.mu2, {}, {}, {}, found.d_r12, found.d_rot1, found.d_rot2});
    return found;
}

// The energy and its gradient, in the form that GSL calls.
static void energy_and_gradient(gsl_vector const *x, void *params, double *energy,
                                gsl_vector *gradient)
{
    auto &packing = *static_cast<Packing *>(params);
    std::size_t const n = packing.centers.size();
    Contacts const found = contacts(packing, x);
    std::vector<Vector3> force(n), torque(n);
    *energy = 0.0;
    for (std::size_t k = 0; k < found.pairs.size(); ++k) {
        double const mu = std::sqrt(found.mu2[k]),
                     slope = mu > 0.0 ? (mu - 1.0) / (2.0 * mu) : 0.0; // dU/dμ²
        auto const i = static_cast<std::size_t>(found.pairs[k][0]),
                   j = static_cast<std::size_t>(found.pairs[k][1]);
        *energy += 0.5 * (1.0 - mu) * (1.0 - mu);
        for (int d = 0; d < 3; ++d) {
            force[i][d] -= slope * found.d_r12[k][d];
            force[j][d] += slope * found.d_r12[k][d];
            torque[i][d] += slope * found.d_rot1[k][d];
            torque[j][d] += slope * found.d_rot2[k][d];
        }
    }
    for (std::size_t i = 0; gradient != nullptr && i < n; ++i) {
        Vector3 const along = along_rotation_vector(row(x, n + i), torque[i]);
        for (int d = 0; d < 3; ++d) {
            auto const k = 3 * i + static_cast<std::size_t>(d);
            gsl_vector_set(gradient, k, force[i][d]);
            gsl_vector_set(gradient, 3 * n + k, along[d]);
        }
    }
}

// Minimises, until no energy is left or the steps are over.
static void relax(Packing &packing, int steps)
{
    std::size_t const n = packing.centers.size();
    auto const value = [](gsl_vector const *x, void *params) {
        double energy;
        energy_and_gradient(x, params, &energy, nullptr);
        return energy;
    };
    auto const derivative = [](gsl_vector const *x, void *params,
                               gsl_vector *gradient) {
        double energy;
        energy_and_gradient(x, params, &energy, gradient);
    };
    gsl_multimin_function_fdf function{value, derivative, energy_and_gradient, 6 * n,
                                       &packing};
    gsl_vector *const start = gsl_vector_calloc(6 * n);
    auto *const minimizer =
        gsl_multimin_fdfminimizer_alloc(gsl_multimin_fdfminimizer_vector_bfgs2, 6 * n);
    gsl_multimin_fdfminimizer_set(minimizer, &function, start, 0.1, 0.1);
    for (int step = 0; step < steps && minimizer->f > 0.0; ++step)
        if (gsl_multimin_fdfminimizer_iterate(minimizer) != 0) break;
    for (std::size_t i = 0; i < n; ++i) {
        for (int d = 0; d < 3; ++d) packing.centers[i][d] += row(minimizer->x, i)[d];
        packing.orientations[i] =
            turned(packing.orientations[i], row(minimizer->x, n + i));
    }
    gsl_multimin_fdfminimizer_free(minimizer);
    gsl_vector_free(start);
}

int main(int argc, char **argv)
{
    int const count = argc > 1 ? std::atoi(argv[1]) : 10000;
    double const fraction = argc > 2 ? std::atof(argv[2]) : 0.6;
    std::mt19937_64 random(argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
    auto const uniform = [&](double a, double b) {
        return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    Packing packing{};
    double volume = 0.0;
    for (int i = 0; i < count; ++i) {
        Vector3 const a{uniform(1, 2), uniform(1, 2), uniform(1, 2)};
        volume += pw85::volume(pw85::ellipsoid_quaternion(a, {1, 0, 0, 0}).q).volume;
        packing.semi_axes.push_back(1.001 * a); // minima touch: a little room
        packing.orientations.push_back(
            {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)});
    }
    packing.edge = std::cbrt(volume / fraction);
    for (int i = 0; i < count; ++i)
        packing.centers.push_back({uniform(0, packing.edge), uniform(0, packing.edge),
                                   uniform(0, packing.edge)});
    std::fprintf(stderr, "overlaps: %zu\n", contacts(packing, nullptr).pairs.size());
    for (int part = 0; part < 20 && !contacts(packing, nullptr).pairs.empty(); ++part)
        relax(packing, 200);
    for (auto &a : packing.semi_axes) a = 1.0 / 1.001 * a;
    packing.neighbors = {};
    std::printf("overlaps when relaxed: %zu\n",
                contacts(packing, nullptr).pairs.size());
}

// Monte Carlo of hard ellipsoids against exact distributions, counting, and itself: other numbers of threads, and saved states.
#include <cmath>
#include <random>

#include <glib.h>

#include <pw85/pw85.hpp>
#include <pw85/simulation.hpp>

#include "../src/simulation/random.hpp"
#include "failures.hpp"

#ifdef _OPENMP
#include <omp.h>
#endif

using namespace pw85_tests;
using pw85::CellChange;
using pw85::HardEllipsoids;
using pw85::Status;
using Vector3 = pw85::Vector<double, 3>;
using Quaternion = pw85::Vector<double, 4>;

namespace {

constexpr double pi = 3.14159265358979323846;

/// The arguments of a simulation.
struct Start {
    std::vector<Vector3> centers, semi_axes;
    std::vector<Quaternion> quaternions;
    pw85::Cell cell{};
    std::array<int, 3> periodic = {1, 1, 1};

    void add(Vector3 const &center, Vector3 const &axes, Quaternion const &quaternion = {1.0, 0.0, 0.0, 0.0})
    {
        centers.push_back(center);
        semi_axes.push_back(axes);
        quaternions.push_back(quaternion);
    }

    Status create(HardEllipsoids &simulation, pw85::IndexPair &pair, std::size_t seed = 1) const
    {
        return hard_ellipsoids_create({centers, {}, &cell, periodic}, semi_axes, quaternions, seed, simulation, pair);
    }

    HardEllipsoids simulation(std::size_t seed = 1) const
    {
        HardEllipsoids simulation;
        pw85::IndexPair pair;
        g_assert_true(create(simulation, pair, seed) == Status::success);
        return simulation;
    }
};

pw85::Cell box(double x, double y, double z) { return {{{x, 0.0, 0.0}, {0.0, y, 0.0}, {0.0, 0.0, z}}}; }

/// Particles of two kinds on a lattice of n³ places, in a cell that is sheared.
Start mixture(int n)
{
    Start start;
    double const a = 1.25, c = 2.6;
    for (int k = 0; k < n * n * n; ++k) {
        int const x = k % n, y = k / n % n, z = k / n / n;
        start.add({a * x + 0.3 * a * y, a * y, c * z}, k % 3 == 0 ? Vector3{0.45, 0.5, 0.9} : Vector3{0.5, 0.5, 1.2});
    }
    start.cell = {{{a * n, 0.0, 0.0}, {0.3 * a * n, a * n, 0.0}, {0.0, 0.0, c * n}}};
    return start;
}

double volume_of(HardEllipsoids const &simulation)
{
    double const *const c = simulation.system().cell;
    return dot(Vector3{c[0], c[1], c[2]}, cross(Vector3{c[3], c[4], c[5]}, Vector3{c[6], c[7], c[8]}));
}

std::vector<unsigned char> bytes_of(HardEllipsoids const &simulation)
{
    std::vector<unsigned char> bytes(simulation.num_bytes());
    g_assert_true(simulation.save(bytes) == Status::success);
    return bytes;
}

void expect_no_overlap(HardEllipsoids const &simulation)
{
    pw85::IndexPair pair;
    g_assert_true(simulation.check(pair) == Status::success);
    g_assert_true(pair[0] == -1 && pair[1] == -1);
}

/// Means over blocks, and the error of their mean.
class Blocks {
  public:
    explicit Blocks(int length) : length_(length) {}

    void add(double x)
    {
        sum_ += x;
        if (++count_ % length_ != 0) return;
        double const mean = sum_ / length_;
        total_ += mean;
        squares_ += mean * mean;
        sum_ = 0.0;
    }

    double mean() const { return total_ / blocks(); }
    double error() const { return std::sqrt(std::max(0.0, squares_ / blocks() - mean() * mean()) / (blocks() - 1.0)); }

    /// Checks that the mean differs from a value by at most four errors and a systematic error.
    void expect(char const *what, double expected, double systematic = 0.0) const
    {
        double const most = 4.0 * error() + systematic;
        g_test_message("%s: %.5f +- %.5f, expected %.5f", what, mean(), error(), expected);
        if (!(std::fabs(mean() - expected) <= most))
            g_test_fail_printf("%s: %a instead of %a, error %a", what, mean(), expected, error());
    }

  private:
    double blocks() const { return count_ / length_; }

    int length_, count_ = 0;
    double sum_ = 0.0, total_ = 0.0, squares_ = 0.0;
};

// The vectors of Random123's file kat_vectors, which Salmon and others publish with their paper.
void test_philox()
{
    struct {
        pw85::detail::simulation::PhiloxWords counter;
        std::uint64_t key;
        std::uint32_t expected[4];
    } const known[] = {
        {{{0, 0, 0, 0}}, 0, {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}},
        {{{0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}},
         0xffffffffffffffff,
         {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}},
        {{{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}},
         0x299f31d0a4093822,
         {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}},
    };
    for (auto const &one : known) {
        auto const found = pw85::detail::simulation::philox(one.counter, one.key);
        for (int k = 0; k < 4; ++k) g_assert_cmphex(found.word[k], ==, one.expected[k]);
    }
}

// N points at constant pressure: V has the density V^N e^-βPV, so its mean and variance are (N + 1)/βP and (N + 1)/βP². The cell is made
// anew now and then, since nothing limits its shears.
void test_ideal_gas()
{
    constexpr double pressure = 5.0, n = 8.0;
    for (CellChange const change : {CellChange::isotropic, CellChange::axis, CellChange::triclinic}) {
        Blocks mean(2000), square(2000);
        double side = 1.2;
        for (int round = 0; round < 200; ++round) {
            Start gas;
            for (int k = 0; k < 8; ++k)
                gas.add(0.5 * side * Vector3{double(k & 1), double(k >> 1 & 1), double(k >> 2)}, {1e-9, 2e-9, 1e-9});
            gas.cell = box(side, side, side);
            HardEllipsoids simulation = gas.simulation(static_cast<std::size_t>(round));
            g_assert_true(simulation.set_steps({0.1, 0.1, 0.7}) == Status::success);
            for (int k = 0; k < 300; ++k) {
                g_assert_true(simulation.volume_moves(1, pressure, change) == Status::success);
                double const v = volume_of(simulation);
                mean.add(v);
                square.add((v - (n + 1) / pressure) * (v - (n + 1) / pressure));
            }
            side = std::cbrt(volume_of(simulation));
        }
        mean.expect("mean volume", (n + 1) / pressure);
        square.expect("variance of the volume", (n + 1) / (pressure * pressure));
    }
}

// Carnahan and Starling's equation of state, J. Chem. Phys. 51, 635 (1969): it errs by less than 0.3 % here. The density of 64 spheres at
// this pressure differs from that of infinitely many by some tenths of a per cent.
void test_hard_spheres()
{
    constexpr double eta = 0.3, z = (1 + eta + eta * eta - eta * eta * eta) / ((1 - eta) * (1 - eta) * (1 - eta));
    constexpr double density = 6.0 * eta / pi;
    Start start;
    for (int k = 0; k < 64; ++k)
        start.add(1.3 * Vector3{double(k % 4), double(k / 4 % 4), double(k / 16)}, {0.5, 0.5, 0.5});
    start.cell = box(5.2, 5.2, 5.2);
    HardEllipsoids simulation = start.simulation();
    g_assert_true(simulation.set_fractions({1, 0, 0, 0}) == Status::success);
    g_assert_true(simulation.tune(300, 0.5, z * density) == Status::success);
    int const sweeps = g_test_perf() ? 20000 : 3000;
    Blocks densities(sweeps / 20);
    for (int k = 0; k < sweeps; ++k) {
        g_assert_true(simulation.sweep(1) == Status::success);
        g_assert_true(simulation.volume_moves(1, z * density) == Status::success);
        densities.add(64.0 / volume_of(simulation));
    }
    densities.expect("density", density, 0.005 * density);
    expect_no_overlap(simulation);
}

/// Two unlike ellipsoids in a cell.
struct TwoEllipsoids {
    static constexpr Vector3 axes[2] = {{0.3, 0.5, 0.9}, {0.6, 0.4, 0.2}};
    static constexpr double side = 2.0;

    /// The least μ² of all images that can be near, and the squared cosine between the third axes.
    static std::array<double, 2> measure(Vector3 const &r, Quaternion const &a, Quaternion const &b,
                                         Vector3 const &axes_a, Vector3 const &axes_b)
    {
        auto const qa = pw85::ellipsoid_quaternion(axes_a, a).q, qb = pw85::ellipsoid_quaternion(axes_b, b).q;
        double least = HUGE_VAL;
        for (int k = 0; k < 27; ++k) {
            Vector3 image = r;
            int const n[3] = {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
            for (int d = 0; d < 3; ++d) image[d] += side * (n[d] - std::nearbyint(r[d] / side));
            least = std::min(least, pw85::contact(image, qa, qb).mu2);
        }
        auto const third = [](Quaternion const &q) {
            return Vector3{2 * (q[1] * q[3] + q[0] * q[2]), 2 * (q[2] * q[3] - q[0] * q[1]),
                           1 - 2 * (q[1] * q[1] + q[2] * q[2])};
        };
        double const cosine = dot(third(a), third(b));
        return {least, cosine * cosine};
    }
};

// All kinds of trials, against independent configurations of which those with overlaps are left out.
void test_two_ellipsoids()
{
    int const samples = g_test_perf() ? 200000 : 20000;
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform(0.0, TwoEllipsoids::side);
    auto const turn = [&] {
        Quaternion const q = {normal(random), normal(random), normal(random), normal(random)};
        return q / std::sqrt(dot(q, q));
    };
    Blocks near(samples / 50), aligned(samples / 50), near_mc(samples / 50), aligned_mc(samples / 50);
    for (int k = 0; k < samples;) {
        Vector3 const r = {uniform(random), uniform(random), uniform(random)};
        auto const [mu2, cosine] =
            TwoEllipsoids::measure(r, turn(), turn(), TwoEllipsoids::axes[0], TwoEllipsoids::axes[1]);
        if (mu2 < 1.0) continue;
        near.add(mu2 < 1.5);
        aligned.add(cosine);
        ++k;
    }
    Start start;
    start.add({0, 0, 0}, TwoEllipsoids::axes[0]);
    start.add({1, 1, 1}, TwoEllipsoids::axes[1]);
    start.cell = box(TwoEllipsoids::side, TwoEllipsoids::side, TwoEllipsoids::side);
    HardEllipsoids simulation = start.simulation();
    g_assert_true(simulation.set_steps({0.7, 0.6, 0.1}) == Status::success);
    g_assert_true(simulation.set_fractions({0.3, 0.3, 0.2, 0.2}) == Status::success);
    for (int k = 0; k < samples; ++k) {
        g_assert_true(simulation.sweep(4) == Status::success);
        auto const *const centers = reinterpret_cast<Vector3 const *>(simulation.system().centers);
        auto const q = simulation.quaternions();
        auto const axes = simulation.semi_axes();
        auto const [mu2, cosine] = TwoEllipsoids::measure(centers[1] - centers[0], q[0], q[1], axes[0], axes[1]);
        if (mu2 < 1.0) g_test_fail_printf("overlap, mu2 = %a", mu2);
        near_mc.add(mu2 < 1.5);
        aligned_mc.add(cosine);
    }
    near_mc.expect("near", near.mean(), 4.0 * near.error());
    aligned_mc.expect("aligned", aligned.mean(), 4.0 * aligned.error());
    auto const counts = simulation.counts();
    for (std::size_t k = 0; k < 4; ++k) g_assert_true(0 < counts.accepted[k] && counts.accepted[k] < counts.trials[k]);
}

// A particle alone turns by (1, v), in which v and -v are equally probable: the mean of v is 0. The parts of the quaternion after a turn,
// multiplied by the conjugate of the one before, are in the ratio 1 : v.
void test_turns()
{
    constexpr double largest = 0.25;
    Start start;
    start.add({0, 0, 0}, {0.3, 0.5, 0.9});
    start.cell = box(5, 5, 5);
    HardEllipsoids simulation = start.simulation();
    g_assert_true(simulation.set_fractions({0, 1, 0, 0}) == Status::success);
    g_assert_true(simulation.set_steps({0.1, largest, 0.1}) == Status::success);
    Blocks means[3] = {Blocks(200), Blocks(200), Blocks(200)}, square(200);
    for (int k = 0; k < 10000; ++k) {
        auto const [w, x, y, z] = simulation.quaternions()[0].coordinates;
        g_assert_true(simulation.sweep(1) == Status::success);
        auto const [a, b, c, d] = simulation.quaternions()[0].coordinates;
        double const scalar = a * w + b * x + c * y + d * z;
        Vector3 const v =
            Vector3{b * w - a * x - c * z + d * y, c * w - a * y - d * x + b * z, d * w - a * z - b * y + c * x} /
            (scalar * largest);
        for (int i = 0; i < 3; ++i) means[i].add(v[i]);
        square.add(dot(v, v));
    }
    for (Blocks const &mean : means) mean.expect("mean turn", 0.0);
    square.expect("mean square of a point of a ball", 0.6);
}

/// Some of everything.
void run(HardEllipsoids &simulation, int steps)
{
    for (int k = 0; k < steps; ++k) {
        g_assert_true(simulation.sweep(2) == Status::success);
        CellChange const change = static_cast<CellChange>(k % 3);
        g_assert_true(simulation.volume_moves(2, 2.0, change) == Status::success);
    }
}

// Threads do not read particles in other domains of the colour that they work on. Here these are little more than a diameter apart along the
// first axis, and trials are as long. Particles that left their domains would meet unseen, and overlap after a few sweeps.
void test_long_trials()
{
    Start start;
    constexpr int n = 27;
    constexpr double a = 1.5, b = 1.2;
    for (int k = 0; k < 3 * n * n; ++k) start.add({a * (k % 3), b * (k / 3 % n), b * (k / 3 / n)}, {0.5, 0.5, 0.5});
    start.cell = box(3 * a, b * n, b * n);
    HardEllipsoids simulation = start.simulation();
    g_assert_true(simulation.set_fractions({1, 0, 0, 0}) == Status::success);
    g_assert_true(simulation.set_steps({1.0, 0.1, 0.1}) == Status::success);
    g_assert_true(simulation.sweep(20) == Status::success);
    g_assert_cmpint(simulation.counts().accepted[0], >, 1000);
    expect_no_overlap(simulation);
}

// There are many domains. The particles diffuse out of the boxes of their neighbour lists.
void test_threads_and_restart()
{
    auto const begin = [] {
        HardEllipsoids simulation = mixture(13).simulation(42);
        g_assert_true(simulation.set_fractions({3, 3, 2, 1}) == Status::success);
        g_assert_true(simulation.set_steps({0.2, 0.1, 0.002}) == Status::success);
        return simulation;
    };
#ifdef _OPENMP
    omp_set_num_threads(1);
#endif
    HardEllipsoids simulation = begin();
    run(simulation, 3);
    auto const middle = bytes_of(simulation);
    run(simulation, 3);
    auto const expected = bytes_of(simulation);
    expect_no_overlap(simulation);
    g_assert_cmpint(simulation.counts().accepted[4], >, 0);
    HardEllipsoids resumed;
    g_assert_true(hard_ellipsoids_restore(middle, resumed) == Status::success);
    run(resumed, 3);
    g_assert_true(bytes_of(resumed) == expected);
#ifdef _OPENMP
    omp_set_num_threads(3);
    HardEllipsoids parallel = begin();
    run(parallel, 6);
    g_assert_true(bytes_of(parallel) == expected);
#endif
    HardEllipsoids other = mixture(13).simulation(43);
    run(other, 1);
    g_assert_true(bytes_of(other) != middle);
}

// A rod that is longer than two sides of its cell meets its own images. Periodic along two vectors, it is on its own along the third.
void test_small_cell()
{
    Start start;
    start.add({0, 0, 0}, {0.2, 0.2, 2.0});
    start.cell = box(1, 1, 5);
    HardEllipsoids simulation = start.simulation();
    g_assert_true(simulation.sweep(20000) == Status::success);
    expect_no_overlap(simulation);
    auto const counts = simulation.counts();
    g_assert_true(0 < counts.accepted[1] && counts.accepted[1] < counts.trials[1]);
    start.cell = box(1, 1, 3);
    pw85::IndexPair pair;
    g_assert_true(start.create(simulation, pair) == Status::overlap);
    g_assert_true(pair[0] == 0 && pair[1] == 0);
    start.periodic = {1, 1, 0};
    simulation = start.simulation();
    g_assert_true(simulation.sweep(2000) == Status::success);
    expect_no_overlap(simulation);
    g_assert_true(simulation.volume_moves(1, 1.0) == Status::invalid_argument);
}

void test_bad_input()
{
    Start start = mixture(2);
    HardEllipsoids simulation;
    pw85::IndexPair pair;
    start.centers[5] = start.centers[2] + Vector3{0.1, 0, 0};
    g_assert_true(start.create(simulation, pair) == Status::overlap);
    g_assert_true(pair[0] == 2 && pair[1] == 5);
    g_assert_true(simulation.sweep(1) == Status::invalid_argument && simulation.num_bytes() == 0);
    start.centers[5][1] = NAN;
    g_assert_true(start.create(simulation, pair) == Status::invalid_argument);
    simulation = mixture(2).simulation();
    for (double const pressure : {0.0, -1.0, double{NAN}, HUGE_VAL})
        g_assert_true(simulation.volume_moves(1, pressure) == Status::invalid_argument);
    g_assert_true(simulation.set_fractions({0, 0, 0, 0}) == Status::invalid_argument);
    g_assert_true(simulation.set_steps({0.1, NAN, 0.1}) == Status::invalid_argument);
    g_assert_true(simulation.tune(1, 1.5) == Status::invalid_argument);
    auto bytes = bytes_of(simulation);
    bytes.pop_back();
    g_assert_true(hard_ellipsoids_restore(bytes, simulation) == Status::invalid_argument);
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    g_test_add_func("/hard_ellipsoids/philox", test_philox);
    g_test_add_func("/hard_ellipsoids/ideal_gas", test_ideal_gas);
    g_test_add_func("/hard_ellipsoids/hard_spheres", test_hard_spheres);
    g_test_add_func("/hard_ellipsoids/two_ellipsoids", test_two_ellipsoids);
    g_test_add_func("/hard_ellipsoids/turns", test_turns);
    g_test_add_func("/hard_ellipsoids/long_trials", test_long_trials);
    g_test_add_func("/hard_ellipsoids/threads_and_restart", test_threads_and_restart);
    g_test_add_func("/hard_ellipsoids/small_cell", test_small_cell);
    g_test_add_func("/hard_ellipsoids/bad_input", test_bad_input);
    return g_test_run();
}

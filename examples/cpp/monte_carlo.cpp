// Monte Carlo of hard ellipsoids in a periodic cell by the engine of the library.
//
//     monte_carlo [SWEEPS [SIDE [FRACTION [STEP [TURN]]]]]
//
// SIDE³ ellipsoids fill a FRACTION of the cell. A trial moves one by up to STEP, and
// turns it by a quaternion (1, v) with |v| up to TURN. Prints the moves per second,
// too, if there are arguments; fails if ellipsoids overlap after any sweep.
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <span>
#include <vector>

#include <pw85/pw85.hpp>
#include <pw85/simulation.hpp>

namespace {

using Vector3 = pw85::Vector<double, 3>;
using Quaternion = pw85::Vector<double, 4>;
using Form = pw85::SymmetricMatrix<double, 3>;

constexpr Vector3 semi_axes = {0.5, 0.5, 1.5};
constexpr double longest = 1.5;

struct Constants {
    int sweeps = 100, side = 10;
    double fraction = 0.4, step = 0.1, turn = 0.04;
};

Constants read_constants(int argc, char **argv)
{
    Constants constants;
    if (argc > 1) constants.sweeps = std::atoi(argv[1]);
    if (argc > 2) constants.side = std::atoi(argv[2]);
    double *const others[] = {&constants.fraction, &constants.step, &constants.turn};
    for (int k = 3; k < argc && k < 6; ++k) *others[k - 3] = std::atof(argv[k]);
    return constants;
}

void require(pw85::Status status)
{
    if (status == pw85::Status::success) return;
    std::cerr << pw85_strerror(static_cast<int>(status)) << '\n';
    std::exit(1);
}

/// Parallel ellipsoids on a lattice that is stretched as they are.
pw85::HardEllipsoids make_simulation(Constants const &constants)
{
    double const sphere = std::acos(-1.0) / 6.0; // of the cube around it
    Vector3 const spacing = 2.0 * std::cbrt(sphere / constants.fraction) * semi_axes;
    int const side = constants.side;
    std::vector<Vector3> centers;
    for (int n = 0; n < side * side * side; ++n)
        centers.push_back({spacing[0] * (n % side), spacing[1] * (n / side % side),
                           spacing[2] * (n / side / side)});
    std::vector<Vector3> const all_axes(centers.size(), semi_axes);
    std::vector<Quaternion> const upright(centers.size(), {1.0, 0.0, 0.0, 0.0});
    pw85::Cell cell{};
    for (int d = 0; d < 3; ++d)
        cell[static_cast<std::size_t>(d)][d] = spacing[d] * side;
    pw85::HardEllipsoids simulation;
    pw85::IndexPair pair;
    require(hard_ellipsoids_create({centers, {}, &cell}, all_axes, upright, 1,
                                   simulation, pair));
    require(simulation.set_steps({constants.step, constants.turn, 0.01}));
    require(simulation.set_fractions({0.0, 0.0, 1.0, 0.0})); // moves and turns at once
    return simulation;
}

/// The present state of a simulation. The views follow it from sweep to sweep.
struct System {
    std::span<Vector3 const> centers;
    std::span<Form const> q;
    double const *cell;

    explicit System(pw85_system const &view)
        : centers(reinterpret_cast<Vector3 const *>(view.centers), view.num_particles),
          q(reinterpret_cast<Form const *>(view.q), view.num_particles), cell(view.cell)
    {
    }

    std::size_t size() const { return centers.size(); }
    double side(int d) const { return cell[4 * d]; }
};

/// Overlaps of two ellipsoids, of any images, without a list: images whose centres are
/// too far away along an axis are passed over. An image of itself counts twice.
long count_overlaps(System const &system, std::size_t i, std::size_t j)
{
    Vector3 apart{};
    int first[3], last[3];
    for (int d = 0; d < 3; ++d) {
        apart[d] = system.centers[j][d] - system.centers[i][d];
        first[d] =
            static_cast<int>(std::ceil((-2.0 * longest - apart[d]) / system.side(d)));
        last[d] =
            static_cast<int>(std::floor((2.0 * longest - apart[d]) / system.side(d)));
        if (first[d] > last[d]) return 0;
    }
    long count = 0;
    for (int x = first[0]; x <= last[0]; ++x)
        for (int y = first[1]; y <= last[1]; ++y)
            for (int z = first[2]; z <= last[2]; ++z) {
                if (i == j && x == 0 && y == 0 && z == 0) continue;
                Vector3 const r12 = {apart[0] + x * system.side(0),
                                     apart[1] + y * system.side(1),
                                     apart[2] + z * system.side(2)};
                count += pw85::overlap(r12, system.q[i], system.q[j]).overlap;
            }
    return count;
}

/// All overlaps.
long count_overlaps(System const &system)
{
    long count = 0;
    for (std::size_t i = 0; i < system.size(); ++i)
        for (std::size_t j = i; j < system.size(); ++j)
            count += count_overlaps(system, i, j);
    return count;
}

/// How parallel the ellipsoids are to the third axis: 1 at the start, 0 at random.
double order(System const &system)
{
    double sum = 0.0;
    double const a = semi_axes[2] * semi_axes[2], b = semi_axes[0] * semi_axes[0];
    for (Form const &q : system.q) sum += 1.5 * (q(2, 2) - b) / (a - b) - 0.5;
    return sum / static_cast<double>(system.size());
}

} // namespace

int main(int argc, char **argv)
{
    using Clock = std::chrono::steady_clock;
    Constants const constants = read_constants(argc, argv);
    pw85::HardEllipsoids simulation = make_simulation(constants);
    System const system(simulation.system());
    long overlaps = count_overlaps(system);
    Clock::duration time{};
    for (int n = 0; n < constants.sweeps; ++n) {
        Clock::time_point const start = Clock::now();
        require(simulation.sweep(1));
        time += Clock::now() - start;
        overlaps += count_overlaps(system);
    }
    std::cout << system.size() << " ellipsoids, " << constants.sweeps
              << " sweeps: " << overlaps << " overlaps, order " << std::fixed
              << std::setprecision(1) << order(system) << '\n';
    auto const counts = simulation.counts();
    auto const trials = static_cast<double>(counts.trials[2]);
    if (argc > 1)
        std::cout << trials / std::chrono::duration<double>(time).count()
                  << " moves per second, "
                  << 100.0 * static_cast<double>(counts.accepted[2]) / trials
                  << " % accepted\n";
    return overlaps == 0 ? 0 : 1;
}

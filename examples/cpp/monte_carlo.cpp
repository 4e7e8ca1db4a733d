// Monte Carlo of hard ellipsoids in a periodic cell: moves to an overlap are rejected.
//
//     monte_carlo [SWEEPS [SIDE [FRACTION [STEP [TURN [SKIN]]]]]]
//
// SIDE³ ellipsoids fill a FRACTION of the cell. A trial moves one by up to STEP along
// each axis, and adds a vector of up to TURN to its quaternion. Prints the moves per
// second, too, if there are arguments; fails if ellipsoids overlap after any sweep.
//
// A neighbour list with a skin serves for many sweeps. It lists the ellipsoids whose
// bounding boxes can meet. A trial takes its place in the system before it is judged.
// If that takes its box out of the one for which the list was made, which the skin has
// grown, the list is made anew. The same goes for the way back of a trial that is
// rejected. So the list holds at each moment, whatever the numbers above.
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <random>
#include <vector>

#include <pw85/neighbors.hpp>
#include <pw85/pw85.hpp>

namespace {

using Vector3 = pw85::Vector<double, 3>;
using Quaternion = pw85::Vector<double, 4>;
using Form = pw85::SymmetricMatrix<double, 3>;

constexpr Vector3 semi_axes = {0.5, 0.5, 1.5};
constexpr double longest = 1.5;

struct Constants {
    int sweeps = 100, side = 10;
    double fraction = 0.4, step = 0.1, turn = 0.04, skin = 0.8;
};

Constants read_constants(int argc, char **argv)
{
    Constants constants;
    if (argc > 1) constants.sweeps = std::atoi(argv[1]);
    if (argc > 2) constants.side = std::atoi(argv[2]);
    double *const others[] = {&constants.fraction, &constants.step, &constants.turn,
                              &constants.skin};
    for (int k = 3; k < argc && k < 7; ++k) *others[k - 3] = std::atof(argv[k]);
    return constants;
}

/// Ellipsoids in a cell with sides along the axes.
struct System {
    std::vector<Vector3> centers;
    std::vector<Quaternion> orientations;
    std::vector<Form> q;
    pw85::Cell cell{};

    std::size_t size() const { return centers.size(); }
    double side(int d) const { return cell[static_cast<std::size_t>(d)][d]; }
    pw85::Particles particles() const { return {centers, q, &cell}; }
};

/// Parallel ellipsoids on a lattice that is stretched as they are.
System make_system(int per_side, double fraction)
{
    System system;
    double const sphere = std::acos(-1.0) / 6.0; // of the cube around it
    double const stretch = std::cbrt(sphere / fraction);
    Quaternion const upright = {1.0, 0.0, 0.0, 0.0};
    for (int n = 0; n < per_side * per_side * per_side; ++n) {
        int const place[3] = {n % per_side, n / per_side % per_side,
                              n / per_side / per_side};
        Vector3 center;
        for (int d = 0; d < 3; ++d) center[d] = 2.0 * semi_axes[d] * stretch * place[d];
        system.centers.push_back(center);
        system.orientations.push_back(upright);
        system.q.push_back(pw85::ellipsoid_quaternion(semi_axes, upright).q);
    }
    for (int d = 0; d < 3; ++d)
        system.cell[static_cast<std::size_t>(d)][d] =
            2.0 * semi_axes[d] * stretch * per_side;
    return system;
}

/// The neighbours of each ellipsoid, and the boxes for which they were found.
class Neighborhood {
  public:
    Neighborhood(System const &system, double skin) : skin_(skin) { update(system); }

    void update(System const &system)
    {
        pw85::Neighbors list;
        if (neighbors_create(system.particles(), {1.0, skin_}, list) !=
            pw85::Status::success)
            std::abort();
        centers_ = system.centers;
        half_widths_.resize(system.size());
        pw85::bounding_boxes(system.q, half_widths_);
        begin_.assign(system.size() + 1, 0);
        for (auto const &pair : list.pairs())
            for (auto const i : pair) ++begin_[static_cast<std::size_t>(i) + 1];
        for (std::size_t i = 0; i < system.size(); ++i) begin_[i + 1] += begin_[i];
        neighbors_.resize(2 * list.pairs().size());
        images_.resize(neighbors_.size());
        std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
        for (std::size_t k = 0; k < list.pairs().size(); ++k) {
            auto const [i, j] = list.pairs()[k];
            auto const [x, y, z] = list.images()[k];
            add(next[static_cast<std::size_t>(i)]++, j, {x, y, z});
            add(next[static_cast<std::size_t>(j)]++, i, {-x, -y, -z});
        }
        ++updates_;
    }

    /// Whether an ellipsoid of the system, in which it has its place, overlaps any
    /// other, or an image of its own.
    bool overlaps(System const &system, std::size_t i) const
    {
        std::size_t const begin = begin_[i], count = begin_[i + 1] - begin;
        int any = 1;
        if (pw85::overlap_any_indices(system.centers[i], system.q[i],
                                      std::span(neighbors_).subspan(begin, count),
                                      std::span(images_).subspan(begin, count),
                                      system.particles(), any) != pw85::Status::success)
            std::abort();
        return any == 1;
    }

    /// Whether ellipsoid i is still in the box for which its neighbours were found.
    bool holds(System const &system, std::size_t i) const
    {
        bool inside = true;
        for (int d = 0; d < 3; ++d)
            inside = inside && std::abs(system.centers[i][d] - centers_[i][d]) +
                                       std::sqrt(system.q[i](d, d)) <=
                                   half_widths_[i][d] + 0.5 * skin_;
        return inside;
    }

    long updates() const { return updates_; }

  private:
    void add(std::size_t place, std::int32_t neighbor, pw85::Image const &image)
    {
        neighbors_[place] = neighbor;
        images_[place] = image;
    }

    double skin_;
    std::vector<Vector3> centers_, half_widths_;
    std::vector<std::size_t> begin_;
    std::vector<std::int32_t> neighbors_;
    std::vector<pw85::Image> images_;
    long updates_ = 0;
};

class MonteCarlo {
  public:
    MonteCarlo(System &system, Constants const &constants)
        : system_(system), constants_(constants), neighborhood_(system, constants.skin)
    {
    }

    void sweep()
    {
        for (std::size_t n = 0; n < system_.size(); ++n)
            try_move(static_cast<std::size_t>(random_() % system_.size()));
    }

    long trials() const { return trials_; }
    long accepted() const { return accepted_; }
    long updates() const { return neighborhood_.updates(); }

  private:
    double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-52 - 1.0; }

    /// In a ball: then the way back is as likely as the way there.
    Quaternion turn()
    {
        Quaternion x;
        do {
            for (int k = 0; k < 4; ++k) x[k] = uniform();
        } while (pw85::dot(x, x) > 1.0);
        return constants_.turn * x;
    }

    void place(std::size_t i, Vector3 const &center, Quaternion const &orientation)
    {
        system_.centers[i] = center;
        system_.orientations[i] = orientation;
        system_.q[i] = pw85::ellipsoid_quaternion(semi_axes, orientation).q;
        if (!neighborhood_.holds(system_, i)) neighborhood_.update(system_);
    }

    /// Moves and turns one ellipsoid, and back if that leads to an overlap.
    void try_move(std::size_t i)
    {
        Vector3 const old_center = system_.centers[i];
        Quaternion const old_orientation = system_.orientations[i];
        Vector3 center = old_center;
        Quaternion orientation = old_orientation;
        Quaternion const change = turn();
        for (int d = 0; d < 3; ++d) center[d] += constants_.step * uniform();
        for (int k = 0; k < 4; ++k) orientation[k] += change[k];
        orientation =
            1.0 / std::sqrt(pw85::dot(orientation, orientation)) * orientation;
        place(i, center, orientation);
        ++trials_;
        if (neighborhood_.overlaps(system_, i))
            place(i, old_center, old_orientation);
        else
            ++accepted_;
    }

    System &system_;
    Constants constants_;
    Neighborhood neighborhood_;
    std::mt19937_64 random_{1};
    long trials_ = 0, accepted_ = 0;
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
    System system = make_system(constants.side, constants.fraction);
    MonteCarlo simulation(system, constants);
    long overlaps = count_overlaps(system);
    Clock::duration time{};
    for (int n = 0; n < constants.sweeps; ++n) {
        Clock::time_point const start = Clock::now();
        simulation.sweep();
        time += Clock::now() - start;
        overlaps += count_overlaps(system);
    }
    std::cout << system.size() << " ellipsoids, " << constants.sweeps
              << " sweeps: " << overlaps << " overlaps, order " << std::fixed
              << std::setprecision(1) << order(system) << '\n';
    if (argc > 1)
        std::cout << static_cast<double>(simulation.trials()) /
                         std::chrono::duration<double>(time).count()
                  << " moves per second, "
                  << 100.0 * static_cast<double>(simulation.accepted()) /
                         static_cast<double>(simulation.trials())
                  << " % accepted, " << simulation.updates() << " lists\n";
    return overlaps == 0 ? 0 : 1;
}

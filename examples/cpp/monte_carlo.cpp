// Monte Carlo of hard ellipsoids in a periodic cell: moves to an overlap are rejected.
//
//     monte_carlo [SWEEPS]     prints the moves per second, too, if SWEEPS is given
//
// A neighbour list with a skin serves for many sweeps. It lists the ellipsoids whose
// bounding boxes can meet; a trial that takes an ellipsoid out of its box, which the
// skin has made larger, asks for a new list.
#include <cmath>
#include <cstdlib>
#include <ctime>
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
constexpr double packing_fraction = 0.4;
constexpr int per_side = 10;
constexpr double largest_step = 0.1, largest_turn = 0.04, skin = 0.8;

/// Ellipsoids without overlaps.
struct System {
    std::vector<Vector3> centers;
    std::vector<Quaternion> orientations;
    std::vector<Form> q;
    pw85::Cell cell{};

    std::size_t size() const { return centers.size(); }
    pw85::Particles particles() const { return {centers, q, &cell}; }
};

/// Parallel ellipsoids on a lattice that is stretched as they are.
System make_system()
{
    System system;
    double const volume =
        4.0 / 3.0 * std::acos(-1.0) * semi_axes[0] * semi_axes[1] * semi_axes[2];
    double const stretch = std::cbrt(
        volume / packing_fraction / (8.0 * semi_axes[0] * semi_axes[1] * semi_axes[2]));
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
    explicit Neighborhood(System const &system) { update(system); }

    void update(System const &system)
    {
        pw85::Neighbors list;
        if (neighbors_create(system.particles(), {{1, 1, 1}, 1.0, skin}, list) !=
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
        std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
        for (auto const &[i, j] : list.pairs()) {
            neighbors_[next[static_cast<std::size_t>(i)]++] = j;
            neighbors_[next[static_cast<std::size_t>(j)]++] = i;
        }
        ++updates_;
    }

    std::span<std::int32_t const> of(std::size_t i) const
    {
        return {neighbors_.data() + begin_[i], begin_[i + 1] - begin_[i]};
    }

    /// Whether ellipsoid i is still in the box for which its neighbours were found.
    bool holds(std::size_t i, Vector3 const &center, Form const &q) const
    {
        bool inside = true;
        for (int d = 0; d < 3; ++d)
            inside =
                inside && std::abs(center[d] - centers_[i][d]) + std::sqrt(q(d, d)) <=
                              half_widths_[i][d] + 0.5 * skin;
        return inside;
    }

    long updates() const { return updates_; }

  private:
    std::vector<Vector3> centers_, half_widths_;
    std::vector<std::size_t> begin_;
    std::vector<std::int32_t> neighbors_;
    long updates_ = 0;
};

class MonteCarlo {
  public:
    explicit MonteCarlo(System &system) : system_(system), neighborhood_(system) {}

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

    /// Moves and turns one ellipsoid, unless that leads to an overlap.
    void try_move(std::size_t i)
    {
        Vector3 center = system_.centers[i];
        Quaternion orientation = system_.orientations[i];
        for (int d = 0; d < 3; ++d) center[d] += largest_step * uniform();
        for (int k = 0; k < 4; ++k) orientation[k] += largest_turn * uniform();
        orientation = pw85::times(1.0 / std::sqrt(pw85::dot(orientation, orientation)),
                                  orientation);
        Form const q = pw85::ellipsoid_quaternion(semi_axes, orientation).q;
        if (!neighborhood_.holds(i, center, q)) neighborhood_.update(system_);
        int overlap = 1;
        pw85::overlap_any_indices(center, q, neighborhood_.of(i), system_.particles(),
                                  overlap);
        ++trials_;
        if (overlap != 0) return;
        ++accepted_;
        system_.centers[i] = center;
        system_.orientations[i] = orientation;
        system_.q[i] = q;
    }

    System &system_;
    Neighborhood neighborhood_;
    std::mt19937_64 random_{1};
    long trials_ = 0, accepted_ = 0;
};

/// All overlaps, of any images.
long count_overlaps(System const &system)
{
    pw85::Neighbors list;
    if (neighbors_create(system.particles(), {}, list) != pw85::Status::success)
        std::abort();
    std::vector<unsigned char> overlap(list.pairs().size());
    if (overlap_pairs(list.list(), system.particles(), overlap) !=
        pw85::Status::success)
        std::abort();
    long count = 0;
    for (int const answer : overlap) count += answer;
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
    int const sweeps = argc > 1 ? std::atoi(argv[1]) : 100;
    System system = make_system();
    MonteCarlo simulation(system);
    std::clock_t const start = std::clock();
    for (int n = 0; n < sweeps; ++n) simulation.sweep();
    double const time = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    std::cout << system.size() << " ellipsoids, " << sweeps
              << " sweeps: " << count_overlaps(system) << " overlaps, order "
              << std::fixed << std::setprecision(1) << order(system) << '\n';
    if (argc <= 1) return 0;
    std::cout << static_cast<double>(simulation.trials()) / time
              << " moves per second, "
              << 100.0 * static_cast<double>(simulation.accepted()) /
                     static_cast<double>(simulation.trials())
              << " % accepted, " << simulation.updates() << " lists\n";
    return 0;
}

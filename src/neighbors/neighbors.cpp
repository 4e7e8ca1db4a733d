// SPDX-License-Identifier: BSD-3-Clause
// The neighbour lists of the C API. To make a list takes three steps: measure the particles, build
// the tree of their bounding boxes (build_tree.hpp), and find the pairs of boxes that intersect
// (search.hpp).
#include <pw85.h>
#include <pw85_systems.h>

#include <algorithm>
#include <new>

#include <pw85/distance/bounding_box.hpp>

#include "../base/c_arrays.hpp"
#include "../base/last_error.hpp"
#include "../base/objects.hpp"
#include "../base/owner.hpp"
#include "../base/parallel.hpp"
#include "bounded_list.hpp"
#include "build_tree.hpp"
#include "deformation.hpp"
#include "search.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::neighbors;
using pw85::detail::c_api::any_null;

namespace {

struct IndexPair {
    std::int32_t i, j;
};

/// The particles of a system, with the parameters that define their bounding boxes.
struct Particles {
    pw85_system const &system;
    double scale, skin;

    bool are_valid() const noexcept
    {
        std::size_t const n = system.num_particles;
        return n <= INT32_MAX && (n == 0 || !any_null(system.centers, system.q)) && scale > 0.0 &&
               elementary::isfinite(scale) && skin >= 0.0 && elementary::isfinite(skin);
    }

    /// Finds the centre of the box of particle i, and its half-widths, which are increased by
    /// `half_skin`.
    Status measure(std::size_t i, double half_skin, BoxExtent &extent) const noexcept
    {
        extent.center = c_api::load_vector<3>(system.centers + 3 * i);
        if (!is_finite(extent.center)) return Status::invalid_argument;
        auto const box = bounding_box(c_api::load_matrix<3>(system.q + 6 * i));
        for (int d = 0; d < 3; ++d) extent.half_widths[d] = scale * box.half_widths[d] + half_skin;
        if (box.status != Status::success) return box.status;
        return is_finite(extent.half_widths) ? Status::success : Status::invalid_argument;
    }
};

/// Finds the extent of a particle with half of the skin, and the lattice vector to subtract so that
/// the particle is near the origin.
Failure measure(Particles const &particles, Periodicity const &lattice, std::size_t i,
                BoxExtent &extent, LatticeVector &vector) noexcept
{
    Status status = particles.measure(i, 0.5 * particles.skin, extent);
    if (status == Status::success && !lattice.reduce(extent.center, vector))
        status = Status::invalid_argument;
    return {i, static_cast<int>(status)};
}

/// Prepares the lattice of a system whose particles are measured. Returns a status.
int prepare(Particles const &particles, Periodicity &lattice) noexcept
{
    if (particles.system.num_particles > INT32_MAX)
        return note_cause(PW85_EINVAL, "num_particles", "must be below 2³¹");
    if (!particles.are_valid()) return PW85_EINVAL;
    if (lattice.prepare(particles.system.cell, particles.system.periodic)) return PW85_SUCCESS;
    return note_cause(PW85_EINVAL, "cell",
                      "must have finite, independent vectors, one of them periodic");
}

/// Notes that a particle is too far away, if its centre and form are good. Returns the status.
[[gnu::cold, gnu::noinline]] int refuse_particle(Particles const &particles,
                                                 Failure const &bad) noexcept
{
    BoxExtent extent;
    if (bad.status != PW85_EINVAL || particles.measure(bad.index, 0.0, extent) != Status::success)
        return bad.status;
    return note_cause(bad.status, "centers", "must not be too far away from the cell for images",
                      bad.index);
}

/// The first failure to measure particles, and the smallest box around their centres.
struct Measured {
    Failure bad{0, PW85_SUCCESS};
    Box around = empty_box;

    void add(Measured const &other) noexcept
    {
        bad.update(other.bad);
        around = enclose(around, other.around);
    }
};

/// The number of tasks per thread that run before their pairs are added to the list. It is large
/// enough to balance the work of the threads.
constexpr std::size_t tasks_per_thread = 64;

/// The pairs that one task has found.
struct Task {
    FoundPairs found;
    std::size_t begin = 0; ///< index of its first pair in the list
    bool complete = false; ///< false if there was no memory for its pairs, or if they are too many
};

} // namespace

struct pw85_neighbors {
    double scale = 1.0, skin = 0.0;
    bool has_cell = false;
    double cell[9] = {};
    int periodic[3] = {1, 1, 1};
    Array<BoxExtent> extents;
    Array<IndexPair> pairs;
    Array<Multiples> images;
};

namespace {

/// Fills a list with its pairs.
class ListBuilder {
  public:
    ListBuilder(Particles const &particles, Periodicity const &lattice, ListLimits const &limits,
                pw85_neighbors &list) noexcept
        : particles_(particles), lattice_(lattice), limits_(limits), list_(list)
    {
    }

    int run() noexcept
    {
        Box around = empty_box;
        if (int const status = measure_all(around)) return status;
        if (particles_.system.num_particles == 0) return PW85_SUCCESS;
        if (!build_tree(list_.extents, lattice_, around, tree_, placed_)) return PW85_ENOMEM;
        if (int const status = list_images(lattice_, tree_.root(), limits_.images, images_))
            return status;
        return find_all() ? PW85_SUCCESS : PW85_ENOMEM;
    }

  private:
    /// Measures the particles and finds the smallest box around their centres, after they are moved
    /// near the origin.
    int measure_all(Box &around) noexcept
    {
        if (!list_.extents.resize(particles_.system.num_particles)) return PW85_ENOMEM;
        Measured const all = of_all_parts<Measured>(particles_.system.num_particles,
                                                    [&](std::size_t begin, std::size_t end) {
                                                        return measure_range({begin, end});
                                                    });
        around = all.around;
        return refuse_particle(particles_, all.bad);
    }

    Measured measure_range(Range range) noexcept
    {
        Measured all;
        for (std::size_t i = range.begin; i < range.end; ++i) {
            BoxExtent &extent = list_.extents[i];
            LatticeVector vector;
            Failure const failure = measure(particles_, lattice_, i, extent, vector);
            Vector<double, 3> const point = lattice_.wrapped(extent.center);
            all.add({failure, {{point[0], point[1], point[2]}, {point[0], point[1], point[2]}}});
        }
        return all;
    }

    /// Runs the tasks in groups. Each group reuses the memory of the one before.
    bool find_all() noexcept
    {
        std::size_t const num_tasks = (tree_.num_groups() + groups_per_task - 1) / groups_per_task;
        std::size_t const most = minimum(num_tasks, tasks_per_thread * most_threads());
        Owner<Task[]> const tasks(new (std::nothrow) Task[most]);
        if (tasks == nullptr) return false;
        std::size_t size = 0;
        for (std::size_t first = 0; first < num_tasks; first += most)
            if (!add_pairs(tasks.get(), first, minimum(most, num_tasks - first), size))
                return false;
        return resize_list(size);
    }

    /// Runs `count` tasks, starting with number `first`, and adds their pairs to the list. The list
    /// has `size` pairs.
    bool add_pairs(Task *tasks, std::size_t first, std::size_t count, std::size_t &size) noexcept
    {
        for_tasks(count, count > 1, [&](std::size_t k) {
            tasks[k].complete =
                find_pairs(tree_, lattice_, images_, first + k, limits_.pairs, tasks[k].found);
        });
        for (std::size_t k = 0; k < count; ++k) {
            if (!tasks[k].complete) return false;
            tasks[k].begin = std::exchange(size, size + tasks[k].found.size());
        }
        if (size > list_.pairs.size() && !resize_list(2 * size)) return false;
        for_tasks(count, count > 1,
                  [&](std::size_t k) { write_pairs(tasks[k].found, tasks[k].begin); });
        return true;
    }

    bool resize_list(std::size_t size) noexcept
    {
        return list_.pairs.resize(size) && (!list_.has_cell || list_.images.resize(size));
    }

    /// Writes pairs from pair `begin` on.
    void write_pairs(FoundPairs const &found, std::size_t begin) noexcept
    {
        std::size_t k = 0;
        for (FoundPairs::Run const &run : found.runs()) {
            PlacedParticle first = placed_[static_cast<std::size_t>(run.first)];
            Multiples const &moved = images_[static_cast<std::size_t>(run.image)].of_cell;
            for (int d = 0; d < 3; ++d) first.subtracted.n[d] -= moved.n[d];
            for (; k < run.end; ++k)
                write_pair(first, placed_[static_cast<std::size_t>(found.second(k))], begin + k);
        }
    }

    /// Writes pair k with the caller's numbers of particles, and in multiples of the vectors of the
    /// cell: the difference of those that were subtracted. The first particle has the lower number.
    /// For two images of one particle, the multiples come after zero in lexicographic order.
    /// Particles are exchanged without a branch: processors would not predict it.
    void write_pair(PlacedParticle const &first, PlacedParticle const &second,
                    std::size_t k) noexcept
    {
        Multiples image;
        for (int d = 0; d < 3; ++d) image.n[d] = first.subtracted.n[d] - second.subtracted.n[d];
        bool exchanged = first.index > second.index;
        if (first.index == second.index) exchanged = precedes_zero(image);
        std::int32_t const sign = exchanged ? -1 : 0;
        for (std::int32_t &n : image.n) n = (n ^ sign) - sign;
        list_.pairs[k] = {minimum(first.index, second.index), maximum(first.index, second.index)};
        if (list_.has_cell) list_.images[k] = image;
    }

    /// Returns whether multiples come before zero in lexicographic order.
    static bool precedes_zero(Multiples const &image) noexcept
    {
        constexpr std::int32_t zero[3] = {};
        return std::lexicographical_compare(image.n, image.n + 3, zero, zero + 3);
    }

    Particles const &particles_;
    Periodicity const &lattice_;
    ListLimits const limits_;
    pw85_neighbors &list_;
    Array<PlacedParticle> placed_;
    Tree tree_;
    Array<LatticeVector> images_;
};

/// The motions that some particles share (Deformation::shared_motions()), or the first failure.
struct SharedMotions {
    Failure bad{0, PW85_SUCCESS};
    Box box{{-infinity<double>(), -infinity<double>(), -infinity<double>()},
            {infinity<double>(), infinity<double>(), infinity<double>()}};

    void add(SharedMotions const &other) noexcept
    {
        bad.update(other.bad);
        for (int d = 0; d < 3; ++d) {
            box.lower[d] = maximum(box.lower[d], other.box.lower[d]);
            box.upper[d] = minimum(box.upper[d], other.box.upper[d]);
        }
    }

    /// Returns whether such a motion exists. An empty box does not intersect itself.
    bool exist() const noexcept { return intersect(box, box); }
};

/// Returns whether a system has as many particles as a list, and either both have no cell, or both
/// have a cell that is periodic along the same vectors.
bool matches(pw85_neighbors const &list, pw85_system const &system) noexcept
{
    bool alike =
        system.num_particles == list.extents.size() && list.has_cell == (system.cell != nullptr);
    for (int k = 0; k < 3 && list.has_cell; ++k)
        alike = alike && (list.periodic[k] != 0) == (system.periodic[k] != 0);
    return alike;
}

SharedMotions shared_motions(pw85_neighbors const &list, Particles const &particles,
                             Deformation const &deformation, Range range) noexcept
{
    SharedMotions shared;
    for (std::size_t i = range.begin; i < range.end; ++i) {
        BoxExtent now{};
        Status const status = particles.measure(i, 0.0, now);
        shared.add(
            {{i, static_cast<int>(status)}, deformation.shared_motions(now, list.extents[i])});
    }
    return shared;
}

int create(pw85_system const &system, double scale, double skin, ListLimits const &limits,
           pw85_neighbors *&list) noexcept
{
    Particles const particles{system, scale, skin};
    Periodicity lattice;
    if (int const status = prepare(particles, lattice)) return status;
    Owner<pw85_neighbors> made(new (std::nothrow) pw85_neighbors);
    if (made == nullptr) return PW85_ENOMEM;
    made->scale = scale;
    made->skin = skin;
    made->has_cell = system.cell != nullptr;
    if (made->has_cell) std::copy_n(system.cell, 9, made->cell);
    if (made->has_cell) std::copy_n(system.periodic, 3, made->periodic);
    int const status = ListBuilder(particles, lattice, limits, *made).run();
    if (status == PW85_SUCCESS) list = made.release();
    return status;
}

int compare(pw85_neighbors const &list, pw85_system const &system, int &holds) noexcept
{
    Particles const particles{system, list.scale, list.skin};
    Periodicity lattice;
    if (int const status = prepare(particles, lattice)) return status;
    Deformation const deformation(lattice, system.cell, list.cell);
    auto const shared =
        of_all_parts<SharedMotions>(system.num_particles, [&](std::size_t begin, std::size_t end) {
            return shared_motions(list, particles, deformation, {begin, end});
        });
    if (shared.bad.status != PW85_SUCCESS) return shared.bad.status;
    holds = shared.exist();
    return PW85_SUCCESS;
}

} // namespace

int pw85::detail::neighbors_create(pw85_system const &system, double scale, double skin,
                                   pw85_neighbors *&list) noexcept
{
    return create(system, scale, skin, {}, list);
}

int BoundedList::make(pw85_system const &system, double scale, double skin) noexcept
{
    int const status = create(system, scale, skin, bounded, list_);
    if (status != PW85_ENOMEM) return status;
    return note_cause(
        status, nullptr,
        "particles, steps and the cutoff must not be so long that lists of neighbours "
        "exceed the memory or have more than 2¹⁵ images of the cell");
}

int pw85::detail::neighbors_check(pw85_system const &system, double scale, double skin,
                                  size_t *particle) noexcept
{
    Particles const particles{system, scale, skin};
    Periodicity lattice;
    if (int const status = prepare(particles, lattice)) return status;
    Failure const first = for_blocks(system.num_particles, [&](Range range) {
        Failure failure{0, PW85_SUCCESS};
        for (std::size_t i = range.begin; i < range.end && failure.status == PW85_SUCCESS; ++i) {
            BoxExtent extent;
            LatticeVector vector;
            failure = measure(particles, lattice, i, extent, vector);
        }
        return failure;
    });
    if (first.status != PW85_SUCCESS) *particle = first.index;
    return first.status;
}

int pw85::detail::neighbors_holds(pw85_neighbors const &list, pw85_system const &system,
                                  int *holds) noexcept
{
    if (matches(list, system)) return compare(list, system, *holds);
    return note_cause(PW85_EINVAL, "system",
                      "must have as many particles as the list, and a cell that is periodic along "
                      "the same vectors, or none if the list has none");
}

pw85_pair_list pw85_neighbors_list(pw85_neighbors const *list)
{
    if (list == nullptr) return {0, nullptr, nullptr};
    return {list->pairs.size(), reinterpret_cast<std::int32_t const *>(list->pairs.data()),
            reinterpret_cast<std::int32_t const *>(list->images.data())};
}

void pw85_neighbors_destroy(pw85_neighbors *list) { delete list; }

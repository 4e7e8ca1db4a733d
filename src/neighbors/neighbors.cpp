// Neighbour lists of the C API.
#include <pw85.h>

#include <cmath>
#include <memory>
#include <new>

#include <pw85/bounding_box.hpp>

#include "../c_arrays.hpp"
#include "../kernels/parallel.hpp"
#include "order.hpp"
#include "search.hpp"

using namespace pw85;
using namespace pw85::neighbors;
using pw85::c_api::any_null;
using pw85::kernels::Failure;
using pw85::kernels::Range;

namespace {

/// A particle's centre, and the half-widths of its box with its share of the skin.
struct Extent {
    Vector<double, 3> center, half_widths;
};

struct IndexPair {
    std::int32_t i, j;
};

/// Whose neighbours are asked for.
struct Particles {
    std::size_t n;
    double const *centers, *q;
    double scale, skin;

    bool are_valid() const noexcept
    {
        return n <= INT32_MAX && (n == 0 || !any_null(centers, q)) && scale > 0.0 && std::isfinite(scale) &&
               skin >= 0.0 && std::isfinite(skin);
    }

    Status measure(std::size_t i, double share, Extent &extent) const noexcept
    {
        extent.center = c_api::load_vector<3>(centers + 3 * i);
        if (!is_finite(extent.center)) return Status::invalid_argument;
        auto const box = bounding_box(c_api::load_matrix<3>(q + 6 * i));
        for (int d = 0; d < 3; ++d) extent.half_widths[d] = scale * box.half_widths[d] + share;
        if (box.status != Status::success) return box.status;
        return is_finite(extent.half_widths) ? Status::success : Status::invalid_argument;
    }
};

/// The extent of a particle with its skin, and what takes it near the origin.
Failure measure(Particles const &particles, Periodicity const &lattice, std::size_t i, Extent &extent,
                Move &move) noexcept
{
    Status status = particles.measure(i, 0.5 * particles.skin, extent);
    if (status == Status::success && !lattice.reduce(extent.center, move)) status = Status::invalid_argument;
    return {i, static_cast<int>(status)};
}

/// Calls visit(i), which returns a Failure, for n rows, and returns the first one.
template <class Visit> Failure first_failure(std::size_t n, Visit const &visit) noexcept
{
    return kernels::for_blocks(n, [&](Range range) {
        Failure first{0, 0};
        for (std::size_t i = range.begin; i < range.end; ++i) first.update(visit(i));
        return first;
    });
}

/// The particle at a place of the tree: its number, and the multiples of the cell's vectors that were subtracted.
struct Occupant {
    std::int32_t index;
    Multiples subtracted;
};

/// The pairs of a task.
struct Task {
    FoundPairs found;
    std::size_t begin = 0; ///< of its pairs among all
    bool complete = false;
};

} // namespace

struct pw85_neighbors {
    double scale = 1.0, skin = 0.0;
    bool has_cell = false;
    Array<Extent> extents;
    Array<IndexPair> pairs;
    Array<Multiples> images;
};

namespace {

/// A list in the making.
class Search {
  public:
    Search(Particles const &particles, Periodicity const &lattice, pw85_neighbors &list) noexcept
        : particles_(particles), lattice_(lattice), list_(list)
    {
    }

    int run() noexcept
    {
        if (int const status = measure_all()) return status;
        if (particles_.n == 0) return PW85_SUCCESS;
        if (!plant()) return PW85_ENOMEM;
        if (int const status = list_images(lattice_, tree_.root(), images_)) return status;
        return find() && translate() ? PW85_SUCCESS : PW85_ENOMEM;
    }

  private:
    int measure_all() noexcept
    {
        std::size_t const n = particles_.n;
        if (!list_.extents.resize(n) || !boxes_.resize(n) || !subtracted_.resize(n)) return PW85_ENOMEM;
        return first_failure(n,
                             [&](std::size_t i) {
                                 Extent &extent = list_.extents[i];
                                 Move move;
                                 Failure const failure = measure(particles_, lattice_, i, extent, move);
                                 subtracted_[i] = move.own;
                                 boxes_[i] = lattice_.wrapped(extent.center, extent.half_widths, move.reduced);
                                 return failure;
                             })
            .status;
    }

    /// The box around all.
    bool enclose_all(Box &around) const noexcept
    {
        Array<Box> parts;
        if (!parts.resize((particles_.n + rows_per_task - 1) / rows_per_task)) return false;
        for_parts(particles_.n, [&](std::size_t begin, std::size_t end) {
            Box part = no_box;
            for (std::size_t i = begin; i < end; ++i) part = enclose(part, boxes_[i]);
            parts[begin / rows_per_task] = part;
        });
        around = no_box;
        for (std::size_t k = 0; k < parts.size(); ++k) around = enclose(around, parts[k]);
        return true;
    }

    /// Puts the boxes into a tree, in the order of space.
    bool plant() noexcept
    {
        Array<Place> places;
        Box around;
        if (!places.resize(particles_.n) || !occupants_.resize(particles_.n) || !enclose_all(around)) return false;
        for_parts(particles_.n, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                places[i] = {key_of(boxes_[i], around), static_cast<std::int32_t>(i)};
        });
        if (!sort(places) || !tree_.resize(particles_.n)) return false;
        for_parts(particles_.n, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                auto const i = static_cast<std::size_t>(places[k].index);
                occupants_[k] = {places[k].index, subtracted_[i]};
                tree_.set(k, boxes_[i]);
            }
        });
        tree_.enclose_levels();
        boxes_.free();
        subtracted_.free();
        return true;
    }

    bool find() noexcept
    {
        num_tasks_ = (tree_.num_groups() + groups_per_task - 1) / groups_per_task;
        tasks_.reset(new (std::nothrow) Task[num_tasks_]);
        if (tasks_ == nullptr) return false;
        for_tasks(num_tasks_, num_tasks_ > 1, [&](std::size_t k) {
            tasks_[k].complete = find_pairs(tree_, lattice_, images_, k, tasks_[k].found);
        });
        return std::all_of(tasks_.get(), tasks_.get() + num_tasks_, [](Task const &task) { return task.complete; });
    }

    /// Writes the pairs in the caller's numbers and multiples.
    bool translate() noexcept
    {
        std::size_t total = 0;
        for (std::size_t k = 0; k < num_tasks_; ++k)
            tasks_[k].begin = std::exchange(total, total + tasks_[k].found.size());
        if (!list_.pairs.resize(total) || (list_.has_cell && !list_.images.resize(total))) return false;
        for_tasks(num_tasks_, num_tasks_ > 1, [&](std::size_t k) {
            Task &task = tasks_[k];
            for (std::size_t l = 0; l < task.found.size(); ++l) translate(task.found[l], task.begin + l);
            task.found.free();
        });
        return true;
    }

    /// The first particle of a pair gets the lower number, or the image comes after zero in lexicographic order.
    void translate(Found const &found, std::size_t k) noexcept
    {
        Occupant first = occupants_[static_cast<std::size_t>(found.first)],
                 second = occupants_[static_cast<std::size_t>(found.second)];
        Multiples const &moved = images_[static_cast<std::size_t>(found.image)].own;
        Multiples image;
        for (int d = 0; d < 3; ++d) image.n[d] = first.subtracted.n[d] - second.subtracted.n[d] - moved.n[d];
        if (first.index > second.index || (first.index == second.index && is_behind(image))) {
            std::swap(first, second);
            for (std::int32_t &n : image.n) n = -n;
        }
        list_.pairs[k] = {first.index, second.index};
        if (list_.has_cell) list_.images[k] = image;
    }

    /// Whether multiples come before zero in lexicographic order.
    static bool is_behind(Multiples const &image) noexcept
    {
        constexpr std::int32_t zero[3] = {};
        return std::lexicographical_compare(image.n, image.n + 3, zero, zero + 3);
    }

    Particles const &particles_;
    Periodicity const &lattice_;
    pw85_neighbors &list_;
    Array<Box> boxes_;            ///< of the particles, near the origin
    Array<Multiples> subtracted_; ///< to take them there
    Array<Occupant> occupants_;
    Tree tree_;
    Array<Move> images_;
    std::unique_ptr<Task[]> tasks_;
    std::size_t num_tasks_ = 0;
};

/// Whether a box with its new half-widths is within the old one, up to half the margin of that (item "Roundings" of periodicity.hpp).
bool is_within(Extent const &now, Extent const &then) noexcept
{
    bool within = true;
    for (int d = 0; d < 3; ++d) {
        double const reach = std::fabs(now.center[d] - then.center[d]) + now.half_widths[d];
        within = within && reach <= then.half_widths[d];
    }
    return within;
}

} // namespace

int pw85_neighbors_create(size_t n, double const *centers, double const *q, double const *cell, int const periodic[3],
                          double scale, double skin, pw85_neighbors **list)
{
    if (any_null(list)) return PW85_EINVAL;
    *list = nullptr;
    DefaultEnvironment const environment;
    Particles const particles{n, centers, q, scale, skin};
    Periodicity lattice;
    if (!particles.are_valid() || !lattice.prepare(cell, periodic)) return PW85_EINVAL;
    std::unique_ptr<pw85_neighbors> made(new (std::nothrow) pw85_neighbors);
    if (made == nullptr) return PW85_ENOMEM;
    made->scale = scale;
    made->skin = skin;
    made->has_cell = cell != nullptr;
    int const status = Search(particles, lattice, *made).run();
    if (status == PW85_SUCCESS) *list = made.release();
    return status;
}

int pw85_neighbors_check(size_t n, double const *centers, double const *q, double const *cell, int const periodic[3],
                         double scale, double skin, size_t *particle)
{
    if (any_null(particle)) return PW85_EINVAL;
    *particle = n;
    DefaultEnvironment const environment;
    Particles const particles{n, centers, q, scale, skin};
    Periodicity lattice;
    if (!particles.are_valid() || !lattice.prepare(cell, periodic)) return PW85_EINVAL;
    Failure const first = first_failure(n, [&](std::size_t i) {
        Extent extent;
        Move move;
        return measure(particles, lattice, i, extent, move);
    });
    if (first.status != PW85_SUCCESS) *particle = first.index;
    return first.status;
}

int pw85_neighbors_holds(pw85_neighbors const *list, size_t n, double const *centers, double const *q, int *holds)
{
    if (any_null(holds)) return PW85_EINVAL;
    *holds = -1;
    if (any_null(list) || n != list->extents.size() || (n > 0 && any_null(centers, q))) return PW85_EINVAL;
    DefaultEnvironment const environment;
    Particles const particles{n, centers, q, list->scale, list->skin};
    constexpr int moved = -1; // no status
    Failure const first = first_failure(n, [&](std::size_t i) {
        Extent now;
        Status const status = particles.measure(i, 0.0, now);
        if (status != Status::success) return Failure{i, static_cast<int>(status)};
        return Failure{i, is_within(now, list->extents[i]) ? PW85_SUCCESS : moved};
    });
    if (first.status > PW85_SUCCESS) return first.status;
    *holds = first.status == PW85_SUCCESS;
    return PW85_SUCCESS;
}

size_t pw85_neighbors_size(pw85_neighbors const *list) { return list != nullptr ? list->pairs.size() : 0; }

int32_t const *pw85_neighbors_pairs(pw85_neighbors const *list)
{
    return list != nullptr ? reinterpret_cast<std::int32_t const *>(list->pairs.data()) : nullptr;
}

int32_t const *pw85_neighbors_images(pw85_neighbors const *list)
{
    return list != nullptr ? reinterpret_cast<std::int32_t const *>(list->images.data()) : nullptr;
}

void pw85_neighbors_destroy(pw85_neighbors *list) { delete list; }

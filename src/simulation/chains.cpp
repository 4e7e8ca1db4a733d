// SPDX-License-Identifier: BSD-3-Clause
// Event chains: see chains.hpp.
#include "chains.hpp"

#include <pw85/motion/free_path.hpp>
#include <pw85/overlap/overlap.hpp>

#include "path_bounds.hpp"

namespace pw85::detail::simulation {

namespace {

/// The longest path without contact, over the longest semi-axis of all particles. It is a
/// compromise: contacts on longer paths are found in several stages, and more particles are near a
/// longer stage. In dense fluids paths are a few tenths of the shorter semi-axes.
constexpr double stage_size = 0.25;

/// The side of a bin, over the same length.
constexpr double bin_size = 1.0;

/// In 1000 displacements a chain must advance by at least a fraction of its remaining length. Only
/// particles that block each other, up to rounding errors, advance less. Such a chain would need
/// 2^34 displacements, which take hours.
constexpr int displacements_of_a_check = 1000;
constexpr double least_part = 0x1p-24;

/// A step in log t below which the path to the contact is accurate to rounding: its relative error
/// is about the fourth power of the step.
constexpr double last_step = 0x1p-13;

/// Maximum number of steps of the search for a contact.
constexpr int most_steps = 60;

/// If the error of a path over the size of the pair exceeds this, the plane that gives the path is
/// not the tangent plane of the contact.
constexpr double tolerance = 0x1p-40;

/// Rounds a path down to a multiple of `digit`, a power of two. The path must be below 2⁵³ digit.
double rounded_down(double path, double digit) noexcept { return std::floor(path / digit) * digit; }

static_assert(lanes == 2);

/// A body that moves and two obstacles, in lanes.
template <class Body, class Obstacle> [[gnu::always_inline]] inline MovingPair<Pack>
moving_pair_of(Body const &moving, Vector3 const &direction, Obstacle const &first,
               Obstacle const &second, Array<Body> const &bodies) noexcept
{
    Form3 const &q1 = bodies[first.image.index].q, &q2 = bodies[second.image.index].q;
    MovingPair<Pack> e;
    for (int d = 0; d < 3; ++d) e.r12[d] = Register{first.r12[d], second.r12[d]};
    for (int d = 0; d < 3; ++d) e.direction[d] = Pack(direction[d]);
    for (int k = 0; k < Form3::size; ++k) e.q1[k] = Pack(moving.q[k]);
    for (int k = 0; k < Form3::size; ++k) e.q2[k] = Register{q1[k], q2[k]};
    e.size = Register{first.size, second.size};
    return e;
}

} // namespace

int Chains::prepare() noexcept
{
    std::size_t const n = configuration_.size();
    longest_ = configuration_.longest_semi_axis();
    unit_ = n > 0 ? unit_of(longest_) : Unit{};
    Cell const &cell = configuration_.cell;
    neighbors::Periodicity periodicity;
    own_images_may_touch_ = cell.exists && periodicity.prepare(cell.vectors, cell.periodic) &&
                            periodicity.shortest() <= (1.0 + 0x1p-40) * 2.0 * longest_;
    if (!bodies_.resize(n) || !numbers_.resize(n)) return PW85_ENOMEM;
    if (int const status = bins_.prepare(configuration_, bin_size * longest_)) return status;
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t const i = bins_.number_in_configuration(k);
        Form3 q = unit_.to_local(configuration_.q[i]);
        // In two dimensions directions are in the plane of the centres. The forms are block
        // diagonal, and so is M of path_bounds.hpp. So the bounds, the contact and its plane are
        // those of the ellipses, whatever the entry of z is, and z has no part in the normal. An
        // entry like the others makes the bounds narrow.
        if (configuration_.dimensions == 2) q[5] = 0.5 * (q[0] + q[3]);
        double const root = std::sqrt(trace(q));
        bodies_[k] = {configuration_.centers[i], configuration_.half_widths[i], q, root,
                      1.0 / root};
        numbers_[i] = static_cast<std::int32_t>(k);
    }
    return PW85_SUCCESS;
}

/// Finds the images whose boxes meet that of particle i on a path. They may be anywhere in memory,
/// so they are prefetched.
bool Chains::find_near(std::size_t i, Vector3 const &direction, double stage) noexcept
{
    Vector3 const half = 0.5 * stage * direction;
    Vector3 own = bodies_[i].half_widths;
    for (int d = 0; d < 3; ++d) own[d] += absolute(half[d]);
    near_.clear();
    bool has_room = true;
    bins_.visit(bodies_[i].center + half, own, [&](std::size_t j, Multiples const &cell) {
        has_room = has_room && near_.reserve(near_.size() + 1);
        if (!has_room || j == i) return;
        prefetch(&bodies_[j], 1);
        bins_.prefetch(j);
        near_.push({cell, j});
    });
    return has_room && obstacles_.reserve(near_.size());
}

/// Lists the obstacles among the images that are near, two at a time. The image that touched
/// particle i is not among them: particle i moves away from the plane between the two, so it cannot
/// touch the other one again.
void Chains::list_obstacles(std::size_t i, Vector3 const &direction, double stage) noexcept
{
    Vector3 const center = bodies_[i].center;
    double const scale = unit_.to_local(1.0),
                 reach = stage + 0x1p-16 * scale * sum_of_magnitudes(center);
    obstacles_.clear();
    Obstacle pair[2];
    std::size_t count = 0;
    for (auto const &[cell, j] : near_) {
        Image const image = {configuration_.cell.translation(bins_.image_in(cell, j)), j};
        if (last_plane_ && image == last_plane_->image) continue;
        Vector3 const r12 = scale * separation(center, bodies_[j].center, image.translation);
        double const size =
            sum_of_magnitudes(r12) + reach + 0x1p-16 * scale * sum_of_magnitudes(image.translation);
        pair[count++] = {image, r12, size, 0.0, 0.0, infinity<double>(), false, {}};
        if (count == 2) insert_touched(i, direction, stage, pair, std::exchange(count, 0));
    }
    if (count == 0) return;
    pair[1] = pair[0];
    insert_touched(i, direction, stage, pair, count);
}

/// Inserts one or two obstacles unless their bounds exclude contact. The bounds are those at the t
/// of spheres with the same traces.
void Chains::insert_touched(std::size_t i, Vector3 const &direction, double stage,
                            Obstacle (&pair)[2], std::size_t count) noexcept
{
    Body const &moving = bodies_[i], &first = bodies_[pair[0].image.index],
               &second = bodies_[pair[1].image.index];
    Pack const t = Pack(moving.root) * Pack(Register{first.inverse_root, second.inverse_root});
    Pack const level =
        Pack(1.0) + Pack(moving.inverse_root) * Pack(Register{first.root, second.root});
    auto const e = moving_pair_of(moving, direction, pair[0], pair[1], bodies_);
    auto const polynomial = evaluate_path(e, t, level).polynomial;
    Pack const discriminant = polynomial.root_of_discriminant();
    Pack const bound = polynomial.bound(polynomial.position(discriminant), discriminant, stage);
    for (std::size_t lane = 0; lane < count; ++lane) {
        if (!(bound[lane] < stage)) continue;
        pair[lane].bound = bound[lane];
        pair[lane].t = t[lane];
        insert(pair[lane]);
    }
}

/// Inserts an obstacle in the order of bounds.
void Chains::insert(Obstacle const &obstacle) noexcept
{
    std::size_t place = obstacles_.size();
    while (place > 0 && obstacles_[place - 1].bound <= obstacle.bound) --place;
    obstacles_.insert(place, obstacle);
}

/// Improves the two least bounds. Removes obstacles that cannot be touched on the path.
void Chains::improve(std::size_t i, Vector3 const &direction, double stage) noexcept
{
    std::size_t const count = std::min(obstacles_.size(), std::size_t{2});
    Obstacle pair[2];
    pair[0] = obstacles_.pop();
    pair[1] = count == 2 ? obstacles_.pop() : pair[0];
    auto const e = moving_pair_of(bodies_[i], direction, pair[0], pair[1], bodies_);
    auto const better = improve_bound(e, Pack(Register{pair[0].t, pair[1].t}), Pack(stage));
    for (std::size_t lane = 0; lane < count; ++lane) {
        Obstacle &obstacle = pair[lane];
        if (!obstacle.is_exact) {
            obstacle.bound = std::max(obstacle.bound, better.bound[lane]);
            obstacle.t = better.t[lane];
            obstacle.step = better.step[lane];
        }
        if (obstacle.is_exact || obstacle.bound < stage) insert(obstacle);
    }
}

/// Finds the path to the contact with the last obstacle. The plane at the last t gives it, or else
/// free_path(). If that fails, too, the obstacle no longer ends the path. It stays among the
/// obstacles, without a plane, and the exact test decides about it at the end of the path. So a
/// failure cannot lead to an overlap.
void Chains::find_contact(std::size_t i, Vector3 const &direction, double stage) noexcept
{
    Obstacle obstacle = obstacles_.pop();
    Vector3 const &r12 = obstacle.r12;
    Form3 const &q1 = bodies_[i].q, &q2 = bodies_[obstacle.image.index].q;
    auto const view = evaluate_path<double>({r12, direction, q1, q2, obstacle.size}, obstacle.t,
                                            1.0 + 1.0 / obstacle.t);
    double const position = view.polynomial.position(view.polynomial.root_of_discriminant());
    obstacle.is_exact = true;
    obstacle.normal = add_scaled(view.s, -position, view.s_direction);
    obstacle.bound = free_by_normal({pair_of(r12, q1, q2), {}}, -direction, obstacle.normal);
    if (!(obstacle.bound >= position - tolerance * obstacle.size &&
          obstacle.bound < infinity<double>())) {
        auto const path = free_path(r12, q1, q2, direction, stage);
        obstacle.bound = path.status == Status::success ? path.length : infinity<double>();
        obstacle.normal = {};
    }
    insert(obstacle);
}

/// Returns the longest path without contact. The last obstacle is then the one at its end, if it is
/// less than the stage.
///
/// path_bounds.hpp gives lower bounds of the paths to all particles that are near. The search
/// improves the least bound until it is that of the contact. There a tangent plane between the two
/// ellipsoids gives a free path with bounds on the rounding errors (motion/free_path.hpp).
double Chains::free_path_length(std::size_t i, Vector3 const &direction, double stage) noexcept
{
    list_obstacles(i, direction, stage);
    for (int steps = 0; !obstacles_.is_empty() && !obstacles_.last().is_exact; ++steps)
        if (obstacles_.last().step > last_step && steps < most_steps)
            improve(i, direction, stage);
        else
            find_contact(i, direction, stage);
    return obstacles_.is_empty() ? stage : std::min(stage, obstacles_.last().bound);
}

/// Returns whether a plane certainly separates particle i from an image.
bool Chains::plane_separates(std::size_t i, Image const &image,
                             Vector3 const &normal) const noexcept
{
    double const scale = unit_.to_local(1.0);
    Vector3 const r12 =
        scale * separation(bodies_[i].center, bodies_[image.index].center, image.translation);
    auto const pair = pair_of(r12, bodies_[i].q, bodies_[image.index].q);
    double const gap = free_by_normal({pair, {}}, -normal, normal);
    return gap > 0.0 && gap < infinity<double>(); // infinity if the square of the normal vanishes
}

/// Returns whether particle i does not overlap an image, by a plane if there is one, or else by the
/// exact test. If a plane does not separate the two, its normal becomes zero, and it is not used
/// again.
bool Chains::is_free_of(std::size_t i, Image const &image, Vector3 &normal) const noexcept
{
    if (plane_separates(i, image, normal)) return true;
    normal = {};
    Vector3 const r12 =
        separation(bodies_[i].center, bodies_[image.index].center, image.translation);
    Form3 const &q1 = configuration_.q[bins_.number_in_configuration(i)],
                &q2 = configuration_.q[bins_.number_in_configuration(image.index)];
    return !call_overlap(r12, q1, q2).overlap;
}

/// Returns whether particle i is free at its position on the path. The bounds of all other images
/// are longer than the path.
bool Chains::is_free(std::size_t i) noexcept
{
    if (last_plane_ && !is_free_of(i, last_plane_->image, last_plane_->normal)) return false;
    return std::all_of(obstacles_.begin(), obstacles_.end(), [&](Obstacle &o) {
        return !o.is_exact || is_free_of(i, o.image, o.normal);
    });
}

/// Moves particle i along its path, as far as rounding allows, and returns how far. The separations
/// are rounded by some u of the coordinates, which may cost more where a contact grazes. So the
/// path to a contact ends some u before it.
///
/// The end of a path is free for separations that are rounded as in the engine: by a
/// plane between the ellipsoids, or by the exact overlap test. If rounding leads to an overlap, the
/// path becomes shorter. So no chain leads to an overlap.
double Chains::advance(std::size_t i, Vector3 const &direction, double path, bool touches,
                       double digit) noexcept
{
    Vector3 &center = bodies_[i].center;
    Vector3 const start = center;
    double back = std::max(digit, 0x1p-50 * (largest_coordinate(start) + longest_));
    for (double moved = rounded_down(touches ? path - back : path, digit); moved > 0.0;
         back *= 4.0) {
        center = start + moved * direction;
        if (is_free(i)) {
            bins_.move(i, center);
            configuration_.centers[bins_.number_in_configuration(i)] = center;
            return moved;
        }
        moved = rounded_down(moved - back, digit);
    }
    center = start;
    return 0.0;
}

int Chains::run(std::size_t first, Vector3 const &direction, double length,
                ChainSums &sums) noexcept
{
    // All paths are multiples of the last digit of the length: their sum is the length, without
    // rounding.
    double const digit = (unit_of(length) / Unit{52}).as<double>();
    double remaining = length, at_last_check = length;
    int displacements = 0;
    sums.length += length;
    last_plane_.reset();
    for (auto i = static_cast<std::size_t>(numbers_[first]); remaining > 0.0;) {
        // A stage depends on the largest particle alone. A particle that touches nothing on a stage
        // continues with the next one.
        double const stage = std::min(remaining, stage_size * longest_);
        if (!find_near(i, direction, stage)) return PW85_ENOMEM;
        double const path = unit_.to_caller(free_path_length(i, direction, unit_.to_local(stage)));
        bool const touches = path < stage;
        double const moved = advance(i, direction, path, touches, digit);
        remaining -= moved;
        if (++displacements == displacements_of_a_check) {
            if (at_last_check - remaining <= least_part * remaining) return PW85_ECONVERGENCE;
            at_last_check = remaining;
            displacements = 0;
        }
        if (!touches) continue;
        Obstacle const &touched = obstacles_.last();
        auto const &[translation, j] = touched.image;
        sums.transfers += unit_.to_caller(dot(touched.r12, direction)) - moved;
        ++sums.contacts;
        // If nothing moved, no test has shown that the plane separates the two. Then particle j may
        // touch this one.
        last_plane_.reset();
        if (touched.has_plane() && moved > 0.0) last_plane_ = {{-translation, i}, -touched.normal};
        i = j;
    }
    return PW85_SUCCESS;
}

} // namespace pw85::detail::simulation

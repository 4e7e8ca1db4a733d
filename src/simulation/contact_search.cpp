// SPDX-License-Identifier: BSD-3-Clause
// The search for the next event of a chain: see contact_search.hpp.
#include "contact_search.hpp"

#include <algorithm>

#include <pw85/motion/free_path.hpp>

#include "path_bounds.hpp"

namespace pw85::detail::simulation {

namespace {

/// A step in log t below which the path to the contact is accurate to rounding: its relative error
/// is about the fourth power of the step.
constexpr double last_step = 0x1p-13;

/// Maximum number of steps of the search for a contact.
constexpr int most_steps = 60;

/// If the error of a path over the size of the pair exceeds this, the plane that gives the path is
/// not the tangent plane of the contact.
constexpr double tolerance = 0x1p-40;

static_assert(lanes == 2);

/// A body that moves and two obstacles, in lanes.
[[gnu::always_inline]] inline MovingPair<Pack>
moving_pair_of(Stage const &stage, Obstacle const (&pair)[2], ChainBodies const &bodies) noexcept
{
    auto const &[first, second] = pair;
    Form3 const &q = bodies[stage.body].q, &q1 = bodies[first.plane.image.body].q,
                &q2 = bodies[second.plane.image.body].q;
    MovingPair<Pack> e;
    for (int d = 0; d < 3; ++d) e.r12[d] = Register{first.r12[d], second.r12[d]};
    for (int d = 0; d < 3; ++d) e.direction[d] = Pack(stage.direction[d]);
    for (int k = 0; k < Form3::size; ++k) e.q1[k] = Pack(q[k]);
    for (int k = 0; k < Form3::size; ++k) e.q2[k] = Register{q1[k], q2[k]};
    e.size = Register{first.size, second.size};
    return e;
}

} // namespace

bool ContactSearch::run(Stage const &stage) noexcept
{
    stage_ = stage;
    length_ = bodies_.length_unit().to_local(stage.length);
    if (!find_near()) return false;
    list_obstacles();
    for (int steps = 0; !obstacles_.is_empty() && !obstacles_.last().is_exact; ++steps)
        if (obstacles_.last().step > last_step && steps < most_steps)
            improve();
        else
            find_contact();
    double const path = obstacles_.is_empty() ? length_ : minimum(length_, obstacles_.last().bound);
    path_ = bodies_.length_unit().to_caller(path);
    return true;
}

bool ContactSearch::is_free(Vector3 const &center) noexcept
{
    std::size_t const i = stage_.body;
    if (passed_ && !bodies_.is_free_of(*passed_, i, center)) return false;
    return std::all_of(obstacles_.begin(), obstacles_.end(), [&](Obstacle &obstacle) {
        return !obstacle.is_exact || bodies_.is_free_of(obstacle.plane, i, center);
    });
}

std::size_t ContactSearch::pass_on(bool has_moved) noexcept
{
    auto const &[image, normal] = touched().plane;
    // If nothing moved, no test has shown that the plane separates the two. Then the next body may
    // touch this one.
    passed_.reset();
    if (touched().plane.exists() && has_moved)
        passed_ = {{-image.translation, stage_.body}, -normal};
    return image.body;
}

/// Finds the images whose boxes meet that of the body on the stage.
bool ContactSearch::find_near() noexcept
{
    ChainBody const &moving = bodies_[stage_.body];
    Vector3 const half = 0.5 * stage_.length * stage_.direction;
    Vector3 own = moving.half_widths;
    for (int d = 0; d < 3; ++d) own[d] += absolute(half[d]);
    near_.clear();
    bool has_room = true;
    bodies_.visit(moving.center + half, own, [&](std::size_t j, Multiples const &cell) {
        has_room = has_room && near_.reserve(near_.size() + 1);
        if (!has_room || j == stage_.body) return false;
        near_.push({cell, j});
        return true;
    });
    return has_room && obstacles_.reserve(near_.size());
}

/// Lists the obstacles among the images that are near, two at a time.
void ContactSearch::list_obstacles() noexcept
{
    Vector3 const center = bodies_[stage_.body].center;
    double const scale = bodies_.length_unit().to_local(1.0),
                 reach = length_ + 0x1p-16 * scale * sum_of_magnitudes(center);
    obstacles_.clear();
    Obstacle pair[2];
    std::size_t count = 0;
    for (auto const &[cell, j] : near_) {
        BodyImage const image = bodies_.image_in(cell, j);
        if (passed_ && image == passed_->image) continue;
        Vector3 const r12 = scale * separation(center, bodies_[j].center, image.translation);
        double const size =
            sum_of_magnitudes(r12) + reach + 0x1p-16 * scale * sum_of_magnitudes(image.translation);
        pair[count++] = {{image, {}}, r12, size, 0.0, 0.0, infinity<double>(), false};
        if (count == 2) insert_touched(pair, std::exchange(count, 0));
    }
    if (count == 0) return;
    pair[1] = pair[0];
    insert_touched(pair, count);
}

/// Inserts one or two obstacles unless their bounds exclude contact. The bounds are those at the t
/// of spheres with the same traces.
void ContactSearch::insert_touched(Obstacle (&pair)[2], std::size_t count) noexcept
{
    ChainBody const &moving = bodies_[stage_.body], &first = bodies_[pair[0].plane.image.body],
                    &second = bodies_[pair[1].plane.image.body];
    Pack const t = Pack(moving.root) * Pack(Register{first.inverse_root, second.inverse_root});
    Pack const level =
        Pack(1.0) + Pack(moving.inverse_root) * Pack(Register{first.root, second.root});
    auto const polynomial =
        evaluate_path(moving_pair_of(stage_, pair, bodies_), t, level).polynomial;
    Pack const discriminant = polynomial.root_of_discriminant();
    Pack const bound = polynomial.bound(polynomial.position(discriminant), discriminant, length_);
    for (std::size_t lane = 0; lane < count; ++lane) {
        if (!(bound[lane] < length_)) continue;
        pair[lane].bound = bound[lane];
        pair[lane].t = t[lane];
        insert(pair[lane]);
    }
}

/// Inserts an obstacle in the order of bounds.
void ContactSearch::insert(Obstacle const &obstacle) noexcept
{
    std::size_t place = obstacles_.size();
    while (place > 0 && obstacles_[place - 1].bound <= obstacle.bound) --place;
    obstacles_.insert(place, obstacle);
}

/// Improves the two least bounds. Removes obstacles that cannot be touched on the stage.
void ContactSearch::improve() noexcept
{
    std::size_t const count = minimum(obstacles_.size(), std::size_t{2});
    Obstacle pair[2];
    pair[0] = obstacles_.pop();
    pair[1] = count == 2 ? obstacles_.pop() : pair[0];
    auto const better = improve_bound(moving_pair_of(stage_, pair, bodies_),
                                      Pack(Register{pair[0].t, pair[1].t}), Pack(length_));
    for (std::size_t lane = 0; lane < count; ++lane) {
        Obstacle &obstacle = pair[lane];
        if (!obstacle.is_exact) {
            obstacle.bound = maximum(obstacle.bound, better.bound[lane]);
            obstacle.t = better.t[lane];
            obstacle.step = better.step[lane];
        }
        if (obstacle.is_exact || obstacle.bound < length_) insert(obstacle);
    }
}

/// Finds the path to the contact with the last obstacle. The plane at the last t gives it, or else
/// free_path(). If that fails, too, the obstacle no longer ends the path. It stays among the
/// obstacles, without a plane, and the exact test decides about it at the end of the path. So a
/// failure cannot lead to an overlap.
void ContactSearch::find_contact() noexcept
{
    Obstacle obstacle = obstacles_.pop();
    Vector3 const &r12 = obstacle.r12, &direction = stage_.direction;
    Form3 const &q1 = bodies_[stage_.body].q, &q2 = bodies_[obstacle.plane.image.body].q;
    auto const view = evaluate_path<double>({r12, direction, q1, q2, obstacle.size}, obstacle.t,
                                            1.0 + 1.0 / obstacle.t);
    double const position = view.polynomial.position(view.polynomial.root_of_discriminant());
    Vector3 &normal = obstacle.plane.normal;
    normal = add_scaled(view.s, -position, view.s_direction);
    obstacle.is_exact = true;
    obstacle.bound = free_by_normal({pair_of(r12, q1, q2), {}}, -direction, normal);
    if (!(obstacle.bound >= position - tolerance * obstacle.size &&
          obstacle.bound < infinity<double>())) {
        auto const path = free_path(r12, q1, q2, direction, length_);
        obstacle.bound = path.status == Status::success ? path.length : infinity<double>();
        normal = {};
    }
    insert(obstacle);
}

} // namespace pw85::detail::simulation

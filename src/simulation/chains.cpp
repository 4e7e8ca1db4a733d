// SPDX-License-Identifier: BSD-3-Clause
// Event chains: see chains.hpp.
#include "chains.hpp"

namespace pw85::detail::simulation {

namespace {

/// The longest path without contact, over the longest semi-axis of all particles. It is a
/// compromise: contacts on longer paths are found in several stages, and more particles are near a
/// longer stage. In dense fluids paths are a few tenths of the shorter semi-axes.
constexpr double stage_size = 0.25;

/// Tests whether a chain advances: in 1000 displacements by at least a fraction of its remaining
/// length. Only particles that block each other, up to rounding errors, advance less. Such a chain
/// would need 2^34 displacements, which take hours.
class StallCheck {
  public:
    explicit StallCheck(double length) noexcept : at_last_check_(length) {}

    /// Counts a displacement. Returns whether the chain does not advance.
    bool has_stalled(double remaining) noexcept
    {
        if (++displacements_ < displacements_of_a_check) return false;
        displacements_ = 0;
        return std::exchange(at_last_check_, remaining) - remaining <= least_part * remaining;
    }

  private:
    static constexpr int displacements_of_a_check = 1000;
    static constexpr double least_part = 0x1p-24;

    double at_last_check_; ///< the remaining length
    int displacements_ = 0;
};

/// Rounds a path down to a multiple of `digit`, a power of two. The path must be below 2⁵³ digit.
double rounded_down(double path, double digit) noexcept
{
    return elementary::floor(path / digit) * digit;
}

} // namespace

/// Moves a body along its path, as far as rounding allows, and returns how far. The separations are
/// rounded by some u of the coordinates, which may cost more where a contact grazes. So the path to
/// a contact ends some u before it.
///
/// The end of a path is free for separations that are rounded as in the engine: by a
/// plane between the ellipsoids, or by the exact overlap test. If rounding leads to an overlap, the
/// path becomes shorter. So no chain leads to an overlap.
double Chains::advance(Stage const &stage, double digit) noexcept
{
    Vector3 const start = bodies_[stage.body].center;
    double const path = search_.path();
    double back =
        maximum(digit, 0x1p-50 * (largest_coordinate(start) + bodies_.longest_semi_axis()));
    for (double moved = rounded_down(search_.ends_at_contact() ? path - back : path, digit);
         moved > 0.0; back *= 4.0) {
        Vector3 const center = start + moved * stage.direction;
        if (search_.is_free(center)) {
            bodies_.move(stage.body, center);
            return moved;
        }
        moved = rounded_down(moved - back, digit);
    }
    return 0.0;
}

int Chains::run(EventChain const &chain, PressureSample &sample) noexcept
{
    // All paths are multiples of the last digit of the length: their sum is the length, without
    // rounding.
    double const digit = (unit_of(chain.length) / Unit{52}).as<double>();
    double remaining = chain.length;
    StallCheck check(chain.length);
    sample.length += chain.length;
    search_.begin();
    for (std::size_t i = bodies_.body_of(chain.first); remaining > 0.0;) {
        // A stage depends on the largest particle alone. A particle that touches nothing on a stage
        // continues with the next one.
        Stage const stage = {i, chain.direction,
                             minimum(remaining, stage_size * bodies_.longest_semi_axis())};
        if (!search_.run(stage)) return PW85_ENOMEM;
        double const moved = advance(stage, digit);
        remaining -= moved;
        if (check.has_stalled(remaining)) return PW85_ECONVERGENCE;
        if (!search_.ends_at_contact()) continue;
        double const along = dot(search_.touched().r12, chain.direction);
        sample.transfers += bodies_.length_unit().to_caller(along) - moved;
        i = search_.pass_on(moved > 0.0);
    }
    return PW85_SUCCESS;
}

} // namespace pw85::detail::simulation

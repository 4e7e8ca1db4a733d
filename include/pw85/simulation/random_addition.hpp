// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Random sequential addition, for C++. The members call the functions of the compiled library
/// (link with pw85), and their contracts are those of pw85_simulation_addition.h.
#ifndef PW85_SIMULATION_RANDOM_ADDITION_HPP_INCLUDED
#define PW85_SIMULATION_RANDOM_ADDITION_HPP_INCLUDED

#include <pw85_simulation_addition.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include <pw85/simulation/addition.hpp>
#include <pw85/systems/calls.hpp>

namespace pw85 {

/// An addition and its memory; it can be moved, not copied.
class RandomAddition {
  public:
    /// An empty addition, which functions refuse with Status::invalid_argument.
    RandomAddition() noexcept = default;
    /// Takes ownership of an addition of the C API, which may be null.
    [[gnu::always_inline]] explicit RandomAddition(pw85_random_addition *addition) noexcept
        : object_(addition)
    {
    }

    /// Makes some attempts: see pw85_random_addition_advance().
    ///
    /// @param[out] end AdditionEnd::none on error, too
    [[gnu::always_inline]] StatusCode advance(double attempts, std::size_t num_particles,
                                              AdditionEnd &end) noexcept
    {
        int found = PW85_ADDITION_CONTINUES;
        int const status = pw85_random_addition_advance(get(), attempts, num_particles, &found);
        end = status == PW85_SUCCESS ? static_cast<AdditionEnd>(found) : AdditionEnd::none;
        return static_cast<StatusCode>(status);
    }

    [[gnu::always_inline]] pw85_random_addition *get() const noexcept { return object_.get(); }

    // Made by api/committed.py: members of pw85_random_addition
    // clang-format off
    /// Returns the progress of an addition: see pw85_random_addition_state().
    [[gnu::always_inline]] AdditionState state() const noexcept
    {
        AdditionState found{};
        static_cast<void>(pw85_random_addition_state(get(), &found.num_particles, &found.attempts,
                                                     &found.free_share));
        return found;
    }

    /// Copies the particles of an addition, in the order in which they were added: see
    /// pw85_random_addition_particles().
    [[gnu::always_inline]] StatusCode particles(std::span<Vector<double, 3>> centers,
                                                std::span<Vector<double, 4>> quaternions = {},
                                                std::span<std::int32_t> kinds = {}) const noexcept
    {
        if (!detail::have_rows(centers.size(), quaternions, kinds))
            return StatusCode::invalid_argument;
        return static_cast<StatusCode>(pw85_random_addition_particles(get(), centers.size(),
                                                                      detail::in_c(centers),
                                                                      detail::in_c(quaternions),
                                                                      detail::in_c(kinds)));
    }
    // clang-format on

  private:
    struct Destroy {
        [[gnu::always_inline]] void operator()(pw85_random_addition *object) const noexcept
        {
            pw85_random_addition_destroy(object);
        }
    };
    std::unique_ptr<pw85_random_addition, Destroy> object_;
};

// Made by api/committed.py: functions of pw85_simulation_addition.h
// clang-format off
/// Makes an empty periodic cell for random sequential addition (RSA): see
/// pw85_random_addition_create().
///
/// @param dimensions 2 or 3
/// @param cell vectors of the cell as rows, all of them periodic, in two dimensions the first two.
/// Opposite faces must be farther apart than 1 + 10⁻⁹ times the longest diameter of a particle. No
/// coordinate may be larger than 2²⁵⁰ times the longest semi-axis. In two dimensions x and y of the
/// third vector and z of the others must be 0
/// @param semi_axes one for each kind: none shorter than 2⁻⁴⁸⁰ times the longest one; in two
/// dimensions the function does not use the third; > 0
/// @param seed selects the random numbers
/// @param[out] addition empty on error
/// @return Status::success, Status::invalid_argument, Status::out_of_memory;
/// Status::not_positive_definite if rounding could make the form of a species indefinite: its
/// longest semi-axis is 2²³ times its shortest one or longer
static inline StatusCode random_addition_create(int dimensions, Cell const &cell, Vectors semi_axes,
                                                std::size_t seed, RandomAddition &addition) noexcept
{
    addition = RandomAddition();
    pw85_random_addition *made = nullptr;
    int const status = pw85_random_addition_create(dimensions, cell.front().coordinates,
                                                   semi_axes.size(), detail::in_c(semi_axes), seed,
                                                   &made);
    addition = RandomAddition(made);
    return static_cast<StatusCode>(status);
}
// clang-format on

} // namespace pw85

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The instruction sets for which functions are compiled, and the choice among them. Each
/// instruction set has a namespace of its name (baseline, avx2, ...) with its copies of these
/// functions. Each caller chooses among the functions that it calls, by PW85_OF_PAIR() or
/// PW85_OF_LANES(). No list names all functions: programs with the static library get only what
/// they call.
#ifndef PW85_SIMD_TARGETS_HPP_INCLUDED
#define PW85_SIMD_TARGETS_HPP_INCLUDED

#include "instruction_sets.h"

/// Calls X(name, the name of its functions for one pair, that of its lanes of at most 256 bits,
/// condition, ...) for each target, from the newest to the oldest.
#define PW85_EACH_TARGET(X, ...)                                                                   \
    PW85_INSTRUCTION_SETS(X __VA_OPT__(, ) __VA_ARGS__)                                            \
    X(baseline, baseline, baseline, true __VA_OPT__(, ) __VA_ARGS__)

namespace pw85::detail::kernels {

/// An instruction set. Its number is its place among the functions of one_of(): 0 for the baseline.
struct Target {
    char const *name;
    int number;
};

/// Returns the target for this processor. If the environment variable PW85_TARGET names another
/// that the processor can run, it is that one. In the reproducible mode it is the baseline. The
/// first call decides for the whole process, until set_reproducible().
Target const &chosen() noexcept;

/// Switches the reproducible mode on or off, for all threads.
void set_reproducible(bool on) noexcept;

bool is_reproducible() noexcept;

namespace {

/// Returns the function of a target, of the list of one function for all targets.
template <auto baseline, auto... others> auto one_of(Target const &target) noexcept
{
    static constexpr decltype(baseline) functions[] = {baseline, others...};
    return functions[target.number];
}

} // namespace
} // namespace pw85::detail::kernels

/// A target's function for one pair or one set (one_pair.hpp, one_set.hpp).
#define PW85_OF_PAIR(target, function)                                                             \
    pw85::detail::kernels::one_of<pw85::detail::kernels::baseline::function PW85_INSTRUCTION_SETS( \
        PW85_AND_OF_PAIR, function)>(target)
#define PW85_AND_OF_PAIR(name, one_pair, lanes256, available, function)                            \
    , pw85::detail::kernels::one_pair::function

/// A target's function for lanes (lanes.hpp), of a type.
#define PW85_OF_LANES(target, type, function)                                                      \
    one_of<static_cast<type *>(baseline::function)                                                 \
               PW85_INSTRUCTION_SETS(PW85_AND_OF_LANES, type, function)>(target)
#define PW85_AND_OF_LANES(name, one_pair, lanes256, available, type, function)                     \
    , static_cast<type *>(name::function)

/// A target's function for lanes of at most 256 bits (lanes256/), of a type.
#define PW85_OF_LANES256(target, type, function)                                                   \
    one_of<static_cast<type *>(baseline::function)                                                 \
               PW85_INSTRUCTION_SETS(PW85_AND_OF_LANES256, type, function)>(target)
#define PW85_AND_OF_LANES256(name, one_pair, lanes256, available, type, function)                  \
    , static_cast<type *>(lanes256::function)

#endif

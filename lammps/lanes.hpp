// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Rows of numbers for SIMD.
#ifndef PW85_LAMMPS_LANES_HPP_INCLUDED
#define PW85_LAMMPS_LANES_HPP_INCLUDED

#include <array>
#include <cstddef>
#include <cstdlib>
#include <string_view>

// Functions that work on several rows at a time are compiled for several instruction sets, each
// together with the functions that it calls (flatten, which Clang has not). All sets give the same
// bits, because arithmetic is not contracted.
#if defined(__x86_64__) && !defined(__clang__)
#define PW85_GRAIN_SETS
#endif

namespace pw85_lammps {

#ifdef PW85_GRAIN_SETS
enum class InstructionSet { baseline, avx2, avx512 };

/// Returns the newest instruction set of the processor that is not newer than the one that the
/// environment variable PW85_TARGET names, as the library does. The first call chooses.
inline InstructionSet chosen_set()
{
    static InstructionSet const chosen = [] {
        char const *const name = std::getenv("PW85_TARGET");
        std::string_view const newest = name ? name : "";
        bool const has_avx2 = __builtin_cpu_supports("avx2") && newest != "baseline";
        if (!has_avx2) return InstructionSet::baseline;
        bool const has_avx512 = __builtin_cpu_supports("avx512f") && newest != "avx2";
        return has_avx512 ? InstructionSet::avx512 : InstructionSet::avx2;
    }();
    return chosen;
}
#endif

/// Maximum number of pairs in arrays of rows, so small that their data stay in a
/// cache.
inline constexpr std::size_t row_capacity = 32;

/// Vectors of `width` numbers, for each pair. Each component of all of them is a row.
template <std::size_t width> using Row = double[width][row_capacity];

/// Returns the vector of pair l.
template <std::size_t width>
std::array<double, width> load(double const (&row)[width][row_capacity], std::size_t l)
{
    std::array<double, width> numbers;
    for (std::size_t k = 0; k < width; ++k) numbers[k] = row[k][l];
    return numbers;
}

template <std::size_t width> void store(std::array<double, width> const &numbers,
                                        double (&row)[width][row_capacity], std::size_t l)
{
    for (std::size_t k = 0; k < width; ++k) row[k][l] = numbers[k];
}

} // namespace pw85_lammps

#endif

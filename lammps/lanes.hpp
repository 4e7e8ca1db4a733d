// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Rows of numbers for SIMD.
#ifndef PW85_LAMMPS_LANES_HPP_INCLUDED
#define PW85_LAMMPS_LANES_HPP_INCLUDED

#include <array>
#include <cstddef>

// GCC compiles a function with this attribute for several instruction sets, together with the
// functions that it calls. It works on several rows at a time. All sets give the same bits, because
// arithmetic is not contracted. Clang does not combine the attributes.
#if defined(__x86_64__) && defined(__GLIBC__) && !defined(__clang__)
#define PW85_GRAIN_LANES [[gnu::flatten, gnu::target_clones("default", "avx2", "avx512f")]]
#else
#define PW85_GRAIN_LANES [[gnu::flatten]]
#endif

namespace pw85_lammps {

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

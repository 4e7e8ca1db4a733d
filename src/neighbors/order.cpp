// SPDX-License-Identifier: BSD-3-Clause
// Computes the positions on Morton's curve and makes the two passes that sort along the curve
// (order.hpp).
#include "order.hpp"

#include <algorithm>
#include <bit>

namespace pw85::detail::neighbors {

namespace {

constexpr int coordinate_bits = 21; // the key has 63

/// Puts two zeros between neighbouring bits of a number.
constexpr std::uint64_t spread(std::uint64_t x) noexcept
{
    x = (x | x << 32) & 0x001f00000000ffff;
    x = (x | x << 16) & 0x001f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
}

// A part of about this many points fits into the cache. There are at most 2^most_bits parts,
// because the points are written to all parts at once, and the processor caches the address
// translations of only a limited number of pages.
constexpr std::size_t points_per_part = 4096;
constexpr int most_bits = 10;
constexpr std::size_t most_shares = 64;

// Within a part, keys are first sorted by two digits of nine bits. Few keys have equal digits
// unless the points form clusters.
constexpr int digit_bits = 9, digits = 2;
constexpr std::size_t radix = std::size_t{1} << digit_bits;

/// Returns the lowest bit of the digits. It is chosen so that the digits contain the highest bit in
/// which the keys differ.
int first_bit(Array<KeyedIndex> const &points) noexcept
{
    std::uint64_t different = 0;
    for (std::size_t i = 0; i < points.size(); ++i) different |= points[i].key ^ points[0].key;
    return maximum(0, static_cast<int>(std::bit_width(different)) - digits * digit_bits);
}

/// Makes one pass of a radix sort. Points with the same digit keep their order.
void sort_by_digit(Array<KeyedIndex> const &points, int shift, Array<KeyedIndex> &sorted) noexcept
{
    std::uint32_t starts[radix] = {}, sum = 0;
    auto const digit = [=](KeyedIndex const &x) {
        return static_cast<std::size_t>(x.key >> shift) & (radix - 1);
    };
    for (std::size_t i = 0; i < points.size(); ++i) ++starts[digit(points[i])];
    for (std::uint32_t &start : starts) sum += std::exchange(start, sum);
    for (std::size_t i = 0; i < points.size(); ++i) sorted[starts[digit(points[i])]++] = points[i];
}

/// Sorts each run of points whose digits are equal.
void sort_equal_digits(Array<KeyedIndex> &points, int shift) noexcept
{
    auto const before = [](KeyedIndex const &a, KeyedIndex const &b) {
        return a.key < b.key || (a.key == b.key && a.index < b.index);
    };
    for (std::size_t begin = 0, end; begin < points.size(); begin = end) {
        for (end = begin + 1;
             end < points.size() && points[end].key >> shift == points[begin].key >> shift;)
            ++end;
        if (end - begin > 1) std::sort(points.data() + begin, points.data() + end, before);
    }
}

} // namespace

std::uint64_t key_of(Vector<double, 3> const &point, Box const &around) noexcept
{
    constexpr double parts = 1 << coordinate_bits;
    std::uint64_t key = 0;
    for (int d = 0; d < 3; ++d) {
        double const part =
            (point[d] - around.lower[d]) / (around.upper[d] - around.lower[d]) * parts;
        // In a box without width the result is NaN, and the point goes to the last part.
        key |= spread(part < parts - 1.0 ? static_cast<std::uint64_t>(maximum(part, 0.0))
                                         : (1u << coordinate_bits) - 1u)
               << d;
    }
    return key;
}

bool Partition::prepare(Array<std::uint64_t> const &keys) noexcept
{
    std::size_t const n = keys.size();
    bits_ = minimum(most_bits, static_cast<int>(std::bit_width(n / points_per_part)));
    num_shares_ = minimum(most_shares, n / points_per_part + 1);
    if (!ends_.resize(num_shares_ * num_parts())) return false;
    std::fill_n(ends_.data(), ends_.size(), 0u);
    for_shares(n, [&](std::uint32_t *counts, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++counts[part_of(keys[i])];
    });
    std::uint32_t sum = 0;
    for (std::size_t part = 0; part < num_parts(); ++part)
        for (std::size_t k = 0; k < num_shares_; ++k)
            sum += std::exchange(ends_[k * num_parts() + part], sum);
    return true;
}

bool sort(Array<KeyedIndex> &points) noexcept
{
    Array<KeyedIndex> sorted;
    if (!sorted.resize(points.size())) return false;
    int const shift = first_bit(points);
    for (int d = 0; d < digits; ++d) {
        sort_by_digit(points, shift + d * digit_bits, sorted);
        std::swap(points, sorted);
    }
    sort_equal_digits(points, shift);
    return true;
}

} // namespace pw85::detail::neighbors

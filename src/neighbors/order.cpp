// Morton's curve, and the order along it.
#include "order.hpp"

#include <algorithm>
#include <bit>

namespace pw85::detail::neighbors {

namespace {

constexpr int bits = 21; // per coordinate, of 63

/// Takes the bits of a number apart, with two zeros between them.
constexpr std::uint64_t spread(std::uint64_t x) noexcept
{
    x = (x | x << 32) & 0x001f00000000ffff;
    x = (x | x << 16) & 0x001f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
}

// Parts of about this many points fit into the cache; but there are no more parts than pages that a processor remembers.
constexpr std::size_t points_per_part = 4096;
constexpr int most_bits = 10;
constexpr std::size_t most_shares = 64;

// The keys of a part are sorted by digits at once; few have these in common unless points cluster.
constexpr int digit_bits = 9, digits = 2;
constexpr std::size_t radix = std::size_t{1} << digit_bits;

/// The first bit of the digits: below those in which keys differ.
int first_bit(Array<Place> const &places) noexcept
{
    std::uint64_t different = 0;
    for (std::size_t i = 0; i < places.size(); ++i) different |= places[i].key ^ places[0].key;
    return std::max(0, static_cast<int>(std::bit_width(different)) - digits * digit_bits);
}

/// Moves places to where those with their digit begin.
void sort_by_digit(Array<Place> const &places, int shift, Array<Place> &sorted) noexcept
{
    std::uint32_t starts[radix] = {}, sum = 0;
    auto const digit = [=](Place const &place) { return static_cast<std::size_t>(place.key >> shift) & (radix - 1); };
    for (std::size_t i = 0; i < places.size(); ++i) ++starts[digit(places[i])];
    for (std::uint32_t &start : starts) sum += std::exchange(start, sum);
    for (std::size_t i = 0; i < places.size(); ++i) sorted[starts[digit(places[i])]++] = places[i];
}

/// Sorts those that have the digits in common.
void sort_the_same(Array<Place> &places, int shift) noexcept
{
    auto const before = [](Place const &a, Place const &b) {
        return a.key < b.key || (a.key == b.key && a.index < b.index);
    };
    for (std::size_t begin = 0, end; begin < places.size(); begin = end) {
        for (end = begin + 1; end < places.size() && places[end].key >> shift == places[begin].key >> shift;) ++end;
        if (end - begin > 1) std::sort(places.data() + begin, places.data() + end, before);
    }
}

} // namespace

std::uint64_t key_of(Vector<double, 3> const &point, Box const &around) noexcept
{
    constexpr double parts = 1 << bits;
    std::uint64_t key = 0;
    for (int d = 0; d < 3; ++d) {
        double const part = (point[d] - around.lower[d]) / (around.upper[d] - around.lower[d]) * parts;
        // NaN, of a box without width, goes with the last part.
        key |= spread(part < parts - 1.0 ? static_cast<std::uint64_t>(std::max(part, 0.0)) : (1u << bits) - 1u) << d;
    }
    return key;
}

bool Partition::prepare(Array<std::uint64_t> const &keys) noexcept
{
    std::size_t const n = keys.size();
    bits_ = std::min(most_bits, static_cast<int>(std::bit_width(n / points_per_part)));
    num_shares_ = std::min(most_shares, n / points_per_part + 1);
    if (!ends_.resize(num_shares_ * num_parts())) return false;
    std::fill_n(ends_.data(), ends_.size(), 0u);
    for_shares(n, [&](std::uint32_t *counts, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++counts[part_of(keys[i])];
    });
    std::uint32_t sum = 0;
    for (std::size_t part = 0; part < num_parts(); ++part)
        for (std::size_t k = 0; k < num_shares_; ++k) sum += std::exchange(ends_[k * num_parts() + part], sum);
    return true;
}

bool sort(Array<Place> &places) noexcept
{
    Array<Place> sorted;
    if (!sorted.resize(places.size())) return false;
    int const shift = first_bit(places);
    for (int d = 0; d < digits; ++d) {
        sort_by_digit(places, shift + d * digit_bits, sorted);
        std::swap(places, sorted);
    }
    sort_the_same(places, shift);
    return true;
}

} // namespace pw85::detail::neighbors

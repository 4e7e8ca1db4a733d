// Morton's curve, and the order along it.
#include "order.hpp"

#include <algorithm>

namespace pw85::neighbors {

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

// The keys are sorted by their first digits at once; few have these in common unless points cluster.
constexpr int digit_bits = 11, digits = 3, first_bit = 3 * bits - digits * digit_bits;
constexpr std::size_t radix = std::size_t{1} << digit_bits;

std::size_t digit(std::uint64_t key, int d) noexcept
{
    return static_cast<std::size_t>(key >> (first_bit + d * digit_bits)) & (radix - 1);
}

/// Where the places with each digit begin.
struct Starts {
    std::size_t of[digits][radix];
};

void count(Array<Place> const &places, Starts &starts) noexcept
{
    std::fill_n(&starts.of[0][0], digits * radix, std::size_t{0});
    for (std::size_t i = 0; i < places.size(); ++i)
        for (int d = 0; d < digits; ++d) ++starts.of[d][digit(places[i].key, d)];
    for (auto &starts_of_digit : starts.of) {
        std::size_t sum = 0;
        for (std::size_t &start : starts_of_digit) sum += std::exchange(start, sum);
    }
}

/// Sorts those that have the first digits in common.
void sort_the_same(Array<Place> &places) noexcept
{
    auto const before = [](Place const &a, Place const &b) {
        return a.key < b.key || (a.key == b.key && a.index < b.index);
    };
    for (std::size_t begin = 0, end; begin < places.size(); begin = end) {
        for (end = begin + 1; end < places.size() && places[end].key >> first_bit == places[begin].key >> first_bit;)
            ++end;
        if (end - begin > 1) std::sort(places.data() + begin, places.data() + end, before);
    }
}

} // namespace

std::uint64_t key_of(Box const &box, Box const &around) noexcept
{
    constexpr double parts = 1 << bits;
    std::uint64_t key = 0;
    for (int d = 0; d < 3; ++d) {
        double const part =
            (0.5 * box.lower[d] + 0.5 * box.upper[d] - around.lower[d]) / (around.upper[d] - around.lower[d]) * parts;
        // NaN, of a box without width, goes with the last part.
        key |= spread(part < parts - 1.0 ? static_cast<std::uint64_t>(std::max(part, 0.0)) : (1u << bits) - 1u) << d;
    }
    return key;
}

bool sort(Array<Place> &places) noexcept
{
    Array<Place> sorted;
    Array<Starts> starts;
    if (!sorted.resize(places.size()) || !starts.resize(1)) return false;
    count(places, starts[0]);
    for (int d = 0; d < digits; ++d) {
        for (std::size_t i = 0; i < places.size(); ++i) sorted[starts[0].of[d][digit(places[i].key, d)]++] = places[i];
        std::swap(places, sorted);
    }
    sort_the_same(places);
    return true;
}

} // namespace pw85::neighbors

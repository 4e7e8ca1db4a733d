// SPDX-License-Identifier: BSD-3-Clause
// Numbers of random, overlapping spheroids at which clusters first wrap around a periodic cube.
// thresholds.py runs it.
//
// Usage: wrapping ASPECT BOX SEED FIRST COUNT
//
// The spheroids have the semi-axes 1, 1 and ASPECT; the edge of the cube is BOX times their longest
// axis. The program writes a line for each of the COUNT realisations from number FIRST on: the
// numbers of particles for wrapping along x, y and z. A line depends on nothing but ASPECT, BOX,
// SEED and its own number, so several processes may share the work.
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "wrapping.hpp"

using namespace pw85_reference;

namespace {

template <class T> bool read(char const *text, T &number)
{
    char const *const end = text + std::strlen(text);
    auto const [rest, error] = std::from_chars(text, end, number);
    return error == std::errc() && rest == end;
}

/// A number of particles at which clusters may wrap: about right for spheres and plates, some twice
/// too many for needles.
double first_guess(Spheroids const &spheroids)
{
    double const elongation = std::max(spheroids.aspect, 1.0 / spheroids.aspect);
    double const volume = 4.0 * spheroids.aspect;
    return 8.0 + std::pow(spheroids.side, 3) / volume / (2.0 + elongation);
}

/// Why a realisation cannot be made, or null. The comparisons are false for NaN.
char const *refusal(Spheroids const &spheroids, double box)
{
    if (!(spheroids.aspect >= 1e-4 && spheroids.aspect <= 1e4))
        return "ASPECT must be between 1e-4 and 1e4";
    if (!(box >= 0.1))
        return "BOX must be at least 0.1, so that an ellipsoid overlaps a moderate number of "
               "images";
    if (!(first_guess(spheroids) <= 1e8))
        return "BOX is too large: the cube would hold more than 1e8 particles";
    return nullptr;
}

int write_numbers(Spheroids const &spheroids, std::uint64_t seed, std::uint64_t first,
                  std::uint64_t count)
{
    auto guess = static_cast<std::size_t>(first_guess(spheroids));
    std::size_t most = 0;
    for (std::uint64_t i = first; i - first < count; ++i) {
        WrappingNumbers numbers;
        auto const status = insert_until_wrapped(Realization(spheroids, seed, i), guess, numbers);
        if (status != pw85::Status::success) {
            std::fprintf(stderr, "wrapping: realisation %llu: %s\n",
                         static_cast<unsigned long long>(i), pw85::strerror(status));
            return 1;
        }
        guess = most = std::max(most, std::ranges::max(numbers));
        if (std::printf("%zu %zu %zu\n", numbers[0], numbers[1], numbers[2]) < 0) return 1;
    }
    return std::fflush(stdout) == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char **argv)
{
    double aspect = 0.0, box = 0.0;
    std::uint64_t seed = 0, first = 0, count = 0;
    if (argc != 6 || !read(argv[1], aspect) || !read(argv[2], box) || !read(argv[3], seed) ||
        !read(argv[4], first) || !read(argv[5], count)) {
        std::fprintf(stderr, "usage: wrapping ASPECT BOX SEED FIRST COUNT\n");
        return 2;
    }
    Spheroids const spheroids = {aspect, box * 2.0 * std::max(1.0, aspect)};
    if (char const *const why = refusal(spheroids, box)) {
        std::fprintf(stderr, "wrapping: %s\n", why);
        return 2;
    }
    return write_numbers(spheroids, seed, first, count);
}

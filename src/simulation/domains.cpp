// SPDX-License-Identifier: BSD-3-Clause
// Divides the cell as domains.hpp says.
#include "domains.hpp"

#include <algorithm>

#include "../base/parallel.hpp"

namespace pw85::detail::simulation {

namespace {

/// The particles of a domain, unless there are fewer than eight domains. In larger domains fewer
/// trials leave them, but the threads have less to share.
constexpr double particles_per_domain = 32.0;

/// Bounds the rounding errors of a coordinate in the cell, over that coordinate.
constexpr double rounding_of_parts = 0x1p-40;

/// Returns the largest number of parts of a vector if all vectors have the same number.
double most_parts_of(std::size_t num_particles, int dimensions) noexcept
{
    double const domains = static_cast<double>(num_particles) / particles_per_domain;
    return maximum(2.0, elementary::floor(dimensions == 2 ? elementary::sqrt(domains)
                                                          : elementary::cbrt(domains)));
}

/// Returns the largest even number of parts of a vector, or 1.
///
/// @param reach the least width of a part, over that of the cell
std::uint32_t parts_of(double reach, double most) noexcept
{
    double const parts =
        minimum(minimum(most, elementary::floor(1.0 / reach)), double{Label::most_parts});
    return parts >= 2.0 ? static_cast<std::uint32_t>(parts) & ~1u : 1;
}

} // namespace

int Domains::prepare(Configuration const &configuration, std::span<std::int32_t const> places,
                     double reach, Stream &stream) noexcept
{
    neighbors::Periodicity periodicity;
    if (!configuration.cell.find_lattice(periodicity)) return PW85_EINVAL;
    double const most = most_parts_of(configuration.size(), configuration.dimensions);
    for (int k = 0; k < 3; ++k) {
        origin_[k] = stream.uniform();
        bool const periodic = periodicity.is_periodic(k);
        dual_[k] = periodic ? periodicity.dual_of_cell(k) : Vector3{0.0, 0.0, 0.0};
        parts_[k] = periodic ? parts_of(reach * magnitude(dual_[k]), most) : 1;
    }
    return assign(configuration, places) ? PW85_SUCCESS : PW85_ENOMEM;
}

bool Domains::assign(Configuration const &configuration,
                     std::span<std::int32_t const> places) noexcept
{
    std::size_t const n = configuration.size(), count = size();
    if (!numbers_.resize(n) || !members_.resize(n) || !begin_.resize(count + 2)) return false;
    prefer_huge_pages(numbers_);
    prefer_huge_pages(members_);
    for_all(n, [&](Range range) {
        for (std::size_t i = range.begin; i < range.end; ++i)
            numbers_[i] = number(label_of(configuration.centers[i]));
        return Failure{0, PW85_SUCCESS};
    });
    std::fill_n(begin_.data(), count + 2, 0);
    for (std::size_t i = 0; i < n; ++i) ++begin_[numbers_[i] + 2];
    for (std::size_t k = 2; k < count + 2; ++k) begin_[k] += begin_[k - 1];
    for (std::int32_t const place : places)
        members_[begin_[numbers_[static_cast<std::size_t>(place)] + 1]++] = place;
    return true;
}

Label Domains::domain(std::uint32_t color, std::uint32_t place) const noexcept
{
    std::uint32_t part[3];
    for (int k = 2; k >= 0; --k) {
        std::uint32_t const step = is_divided(k) ? 2 : 1, count = parts_[k] / step;
        // NOLINTNEXTLINE(clang-analyzer-core.DivideZero): a vector has parts
        part[k] = place % count * step + (is_divided(k) ? color & 1u : 0u);
        place /= count;
        if (is_divided(k)) color >>= 1;
    }
    return Label(part);
}

/// Returns the parts of vector k that have the centres within `range` of a centre along each axis.
Domains::Parts Domains::parts_near(int k, Vector3 const &center, double range) const noexcept
{
    double const x = dot(dual_[k], center) + origin_[k], all = parts_[k];
    double const reach =
        sum_of_magnitudes(dual_[k]) * range + rounding_of_parts * (1.0 + absolute(x));
    double const first = elementary::floor((x - reach) * all),
                 count = elementary::floor((x + reach) * all) - first + 1.0;
    if (!(count < all)) return {0, parts_[k]};
    return {static_cast<std::uint32_t>(first - all * elementary::floor(first / all)) % parts_[k],
            static_cast<std::uint32_t>(count)};
}

bool Domains::list_near(Vector3 const &center, double range,
                        List<std::int32_t> &found) const noexcept
{
    Parts parts[3];
    for (int k = 0; k < 3; ++k) parts[k] = parts_near(k, center, range);
    std::uint32_t const count = parts[0].count * parts[1].count * parts[2].count;
    found.clear();
    for (std::uint32_t step = 0; step < count; ++step) {
        std::uint32_t part[3], rest = step;
        for (int k = 0; k < 3; ++k) {
            part[k] = (parts[k].first + rest % parts[k].count) % parts_[k];
            rest /= parts[k].count;
        }
        auto const places = members(Label(part));
        if (!found.reserve(found.size() + places.size())) return false;
        for (std::int32_t const place : places) found.push(place);
    }
    return true;
}

void Domains::mark_readable(Label label, std::uint8_t mark, std::uint8_t *marks) const noexcept
{
    for (std::uint32_t step = 0; step < 27; ++step) {
        std::uint32_t part[3], rest = step;
        for (int k = 0; k < 3; ++k, rest /= 3)
            part[k] = (label.part(k) + parts_[k] - 1 + rest % 3) % parts_[k];
        marks[number(Label(part))] = mark;
    }
}

} // namespace pw85::detail::simulation

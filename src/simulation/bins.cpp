// Sorts the particles of a simulation into bins.
#include "bins.hpp"

namespace pw85::detail::simulation {

namespace {

/// There are at most so many times as many bins as particles.
constexpr double most_bins = 4.0;

} // namespace

int Bins::prepare(Configuration const &configuration, double side) noexcept
{
    cell_ = configuration.cell;
    neighbors::Periodicity periodicity;
    if (!periodicity.prepare(cell_.exists ? cell_.vectors : nullptr, cell_.periodic)) return PW85_EINVAL;
    std::size_t const n = configuration.size();
    double fit[3], all = 1.0;
    for (int k = 0; k < 3; ++k) {
        bool const periodic = periodicity.is_periodic(k);
        dual_[k] = periodic ? periodicity.dual_of_cell(k) : Vector3{0.0, 0.0, 0.0};
        fit[k] = periodic ? std::max(1.0, 1.0 / (side * magnitude(dual_[k]))) : 1.0;
        all *= fit[k];
    }
    double const fewer = std::min(1.0, std::cbrt(most_bins * static_cast<double>(n) / all));
    std::size_t num_bins = 1;
    for (int k = 0; k < 3; ++k) {
        parts_[k] = static_cast<std::int32_t>(std::max(1.0, fewer * fit[k]));
        num_bins *= static_cast<std::size_t>(parts_[k]);
    }
    if (!first_.resize(num_bins) || !entries_.resize(n)) return PW85_ENOMEM;
    std::fill_n(first_.data(), num_bins, -1);
    return fill(configuration) ? PW85_SUCCESS : PW85_EINVAL;
}

bool Bins::fill(Configuration const &configuration) noexcept
{
    largest_ = {0.0, 0.0, 0.0};
    double farthest = 0.0;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        Entry &entry = entries_[i];
        insert(i, locate(configuration.centers[i], entry));
        for (int d = 0; d < 3; ++d) {
            double const half_width = configuration.half_widths[i][d];
            entry.half_widths[d] = static_cast<float>(half_width);
            largest_[d] = std::max(largest_[d], half_width);
            farthest = std::max(farthest, std::abs(double{entry.center[d]}));
        }
    }
    for (double const x : cell_.vectors) farthest = std::max(farthest, cell_.exists ? 2.0 * std::abs(x) : 0.0);
    margin_ = static_cast<float>(0x1p-20 * (farthest + largest_coordinate(largest_)));
    return margin_ < std::numeric_limits<float>::infinity();
}

std::int32_t Bins::locate(Vector3 const &center, Entry &entry) const noexcept
{
    std::int32_t part[3];
    for (int k = 0; k < 3; ++k) {
        double const x = dot(dual_[k], center), cell = std::floor(x);
        entry.cell.n[k] = static_cast<std::int32_t>(cell);
        part[k] = std::min(parts_[k] - 1, static_cast<std::int32_t>((x - cell) * parts_[k]));
    }
    Vector3 const inside = center - cell_.translation(entry.cell);
    for (int d = 0; d < 3; ++d) entry.center[d] = static_cast<float>(inside[d]);
    return static_cast<std::int32_t>(bin_of(part[0], part[1], part[2]));
}

std::int32_t Bins::find_range(int k, Vector3 const &center, Vector3 const &half_widths, Part &part) const noexcept
{
    double const x = dot(dual_[k], center), home = std::floor(x);
    double const reach = magnitude_of_dot(dual_[k], half_widths + largest_) + 0x1p-40 * (1.0 + std::abs(x));
    auto const first = static_cast<std::int32_t>(std::floor((x - home - reach) * parts_[k]));
    auto const last = static_cast<std::int32_t>(std::floor((x - home + reach) * parts_[k]));
    std::int32_t cell = first / parts_[k];
    cell -= first < cell * parts_[k];
    part = {first - cell * parts_[k], cell, last - first + 1};
    return static_cast<std::int32_t>(home);
}

void Bins::insert(std::size_t i, std::int32_t bin) noexcept
{
    std::int32_t &first = first_[static_cast<std::size_t>(bin)];
    Entry &entry = entries_[i];
    entry.next = first;
    entry.previous = -1;
    entry.bin = bin;
    if (first >= 0) entries_[static_cast<std::size_t>(first)].previous = static_cast<std::int32_t>(i);
    first = static_cast<std::int32_t>(i);
}

void Bins::remove(std::size_t i) noexcept
{
    Entry const &entry = entries_[i];
    if (entry.next >= 0) entries_[static_cast<std::size_t>(entry.next)].previous = entry.previous;
    if (entry.previous >= 0)
        entries_[static_cast<std::size_t>(entry.previous)].next = entry.next;
    else
        first_[static_cast<std::size_t>(entry.bin)] = entry.next;
}

void Bins::move(std::size_t i, Vector3 const &center) noexcept
{
    std::int32_t const bin = locate(center, entries_[i]);
    if (bin == entries_[i].bin) return;
    remove(i);
    insert(i, bin);
}

} // namespace pw85::detail::simulation

// SPDX-License-Identifier: BSD-3-Clause
// Sorts the particles of a simulation into bins.
#include "bins.hpp"

#include <algorithm>
#include <numeric>

#include "../base/last_error.hpp"

namespace pw85::detail::simulation {

namespace {

/// Upper bound of the number of bins per particle. With two particles in a bin, few
/// blocks are empty, and few bins have more than one block.
constexpr double most_bins = 0.5;

/// A search visits each bin that a particle spans, which takes some nanoseconds.
constexpr double most_spanned_bins = 0x1p20;

} // namespace

int Bins::prepare(Configuration const &configuration, double side, std::size_t more) noexcept
{
    cell_ = configuration.cell;
    neighbors::Periodicity periodicity;
    if (!cell_.find_lattice(periodicity)) return PW85_EINVAL;
    std::size_t const n = configuration.size();
    if (double const longest = maximum(n > 0 ? side : 0.0, largest_of_cell()); longest > 0.0)
        per_unit_ = unit_of(longest).to_local(1.0);
    for (int k = 0; k < 3; ++k)
        dual_[k] =
            periodicity.is_periodic(k) ? periodicity.dual_of_cell(k) : Vector3{0.0, 0.0, 0.0};
    divide(side, most_bins * static_cast<double>(n));
    std::size_t num_bins = 1;
    for (std::int32_t const parts : parts_) num_bins *= static_cast<std::size_t>(parts);
    if (!blocks_.resize(num_bins + (n + more) / 4) || !places_.resize(n + more) ||
        !sort(configuration, num_bins) || !order_.resize(n + more))
        return PW85_ENOMEM;
    clear(num_bins);
    if (!fill(configuration))
        return note_cause(PW85_EINVAL, nullptr,
                          "centers must be below 2¹²⁷ times the longest semi-axis or vector of the "
                          "cell");
    if (spanned_bins() <= most_spanned_bins) return PW85_SUCCESS;
    return note_cause(PW85_EINVAL, nullptr,
                      "the cell must not be so skewed or so small that a particle spans more than "
                      "2²⁰ bins of it");
}

/// Returns the largest coordinate of the periodic vectors; 0 without a cell.
double Bins::largest_of_cell() const noexcept
{
    double largest = 0.0;
    for (int k = 0; k < 3 && cell_.exists; ++k)
        if (cell_.periodic[k]) largest = maximum(largest, largest_coordinate(cell_.vector(k)));
    return largest;
}

/// Divides the vectors of the cell into parts not much smaller than `side`, but into no more than
/// `most` bins. Vectors that would have less than one part are not divided, and the others share
/// the number.
void Bins::divide(double side, double most) noexcept
{
    double fit[3];
    bool divided[3], all_fit = false;
    for (int k = 0; k < 3; ++k) {
        divided[k] = largest_coordinate(dual_[k]) > 0.0;
        parts_[k] = 1;
        fit[k] = divided[k] ? maximum(1.0, 1.0 / (side * magnitude(dual_[k]))) : 1.0;
    }
    while (!all_fit) {
        double all = 1.0;
        int num_divided = 0;
        for (int k = 0; k < 3; ++k) {
            num_divided += divided[k];
            if (divided[k]) all *= fit[k];
        }
        double const share = most / all;
        double const fewer = minimum(1.0, num_divided == 3   ? elementary::cbrt(share)
                                          : num_divided == 2 ? elementary::sqrt(share)
                                                             : share);
        all_fit = true;
        for (int k = 0; k < 3; ++k) {
            if (!divided[k]) continue;
            divided[k] = fewer * fit[k] >= 1.0;
            all_fit = all_fit && divided[k];
            parts_[k] = divided[k] ? static_cast<std::int32_t>(fewer * fit[k]) : 1;
        }
    }
}

/// Returns how many bins the largest particle spans at most, for any place of it.
double Bins::spanned_bins() const noexcept
{
    double count = 1.0;
    for (int k = 0; k < 3; ++k)
        count *= 1.0 + 4.0 * parts_[k] * magnitude_of_dot(dual_[k], largest_);
    return count;
}

Bins::Block Bins::empty_block(std::int32_t next) noexcept
{
    Block block{};
    for (Float4 &half_widths : block.half_widths)
        half_widths -= std::numeric_limits<float>::infinity();
    block.next = next;
    return block;
}

/// Empties all bins. All blocks of a bin but its first are full, so n/4 further blocks are enough.
void Bins::clear(std::size_t num_bins) noexcept
{
    std::fill_n(blocks_.data(), blocks_.size(), empty_block(-1));
    unused_ = -1;
    for (std::size_t k = num_bins; k < blocks_.size(); ++k)
        blocks_[k].next = std::exchange(unused_, static_cast<std::int32_t>(k));
}

/// Orders the particles by their bins.
bool Bins::sort(Configuration const &configuration, std::size_t num_bins) noexcept
{
    std::size_t const n = configuration.size();
    Array<std::int32_t> bins, ends;
    if (!bins.resize(n) || !ends.resize(num_bins) || !order_.resize(n)) return false;
    std::fill_n(ends.data(), num_bins, 0);
    for (std::size_t i = 0; i < n; ++i) {
        Multiples home;
        Box box;
        bins[i] = locate(configuration.centers[i], home, box);
        ++ends[static_cast<std::size_t>(bins[i])];
    }
    std::partial_sum(ends.data(), ends.data() + num_bins, ends.data());
    for (std::size_t i = n; i-- > 0;)
        order_[static_cast<std::size_t>(--ends[static_cast<std::size_t>(bins[i])])] =
            static_cast<std::int32_t>(i);
    return true;
}

bool Bins::fill(Configuration const &configuration) noexcept
{
    largest_ = {0.0, 0.0, 0.0};
    farthest_ = 0.0;
    for (std::size_t i = 0; i < configuration.size(); ++i) {
        std::size_t const number = number_in_configuration(i);
        insert(i, configuration.centers[number], configuration.half_widths[number]);
    }
    widen_margin(2.0 * per_unit_ * largest_of_cell());
    return margin_ < std::numeric_limits<float>::infinity();
}

void Bins::insert(std::size_t i, Vector3 const &center, Vector3 const &half_widths) noexcept
{
    Box box;
    std::int32_t const bin = locate(center, places_[i].cell, box);
    for (int d = 0; d < 3; ++d) {
        box.half_widths[d] = to_local(half_widths[d]);
        largest_[d] = maximum(largest_[d], half_widths[d]);
    }
    insert(i, bin, box);
    widen_margin(magnitude_of(center, box));
}

void Bins::add(std::size_t i, std::size_t in_configuration, Vector3 const &center,
               Vector3 const &half_widths) noexcept
{
    insert(i, center, half_widths);
    rename(i, in_configuration);
}

/// Enlarges the margin to cover this magnitude, too: a particle may move farther away along a
/// vector that is not periodic. The margin is 2⁻²⁰ times the largest sum of the magnitudes in a
/// coordinate, 16 times the unit roundoff. This bounds the rounding errors of the eight operations
/// from the centres on.
void Bins::widen_margin(double magnitude) noexcept
{
    farthest_ = maximum(farthest_, magnitude);
    margin_ = static_cast<float>(0x1p-20 * (farthest_ + per_unit_ * largest_coordinate(largest_)));
}

/// Returns the largest magnitude that the margin must cover for a particle. One such magnitude is
/// 2⁻²⁸ times the centre before it is moved into the cell, because its coordinates are rounded as
/// doubles.
double Bins::magnitude_of(Vector3 const &center, Box const &box) const noexcept
{
    double largest = 0x1p-28 * (per_unit_ * largest_coordinate(center));
    for (float const x : box.center) largest = maximum(largest, elementary::abs(double{x}));
    return largest;
}

std::int32_t Bins::locate(Vector3 const &center, Multiples &home, Box &box) const noexcept
{
    std::int32_t part[3];
    for (int k = 0; k < 3; ++k) {
        double const x = dot(dual_[k], center), cell = elementary::floor(x);
        home.n[k] = static_cast<std::int32_t>(cell);
        part[k] = minimum(parts_[k] - 1, static_cast<std::int32_t>((x - cell) * parts_[k]));
    }
    Vector3 const inside = center - cell_.translation(home);
    for (int d = 0; d < 3; ++d) box.center[d] = to_local(inside[d]);
    return static_cast<std::int32_t>(bin_of(part[0], part[1], part[2]));
}

std::int32_t Bins::find_range(int k, Vector3 const &center, Vector3 const &half_widths,
                              Part &part) const noexcept
{
    double const x = dot(dual_[k], center), home = elementary::floor(x);
    double const reach =
        magnitude_of_dot(dual_[k], half_widths + largest_) + 0x1p-40 * (1.0 + elementary::abs(x));
    auto const first = static_cast<std::int32_t>(elementary::floor((x - home - reach) * parts_[k]));
    auto const last = static_cast<std::int32_t>(elementary::floor((x - home + reach) * parts_[k]));
    std::int32_t cell = first / parts_[k];
    cell -= first < cell * parts_[k];
    part = {first - cell * parts_[k], cell, last - first + 1};
    return static_cast<std::int32_t>(home);
}

void Bins::set(Place const &place, std::int32_t particle, Box const &box) noexcept
{
    Block &own = block(place.block);
    own.particle[place.lane] = particle;
    for (int d = 0; d < 3; ++d) own.center[d][place.lane] = box.center[d];
    for (int d = 0; d < 3; ++d) own.half_widths[d][place.lane] = box.half_widths[d];
}

Bins::Box Bins::get(Place const &place) const noexcept
{
    Block const &own = blocks_[static_cast<std::size_t>(place.block)];
    Box box;
    for (int d = 0; d < 3; ++d) box.center[d] = own.center[d][place.lane];
    for (int d = 0; d < 3; ++d) box.half_widths[d] = own.half_widths[d][place.lane];
    return box;
}

void Bins::copy_full_block(std::int32_t from, std::int32_t to) noexcept
{
    block(to) = block(from);
    for (std::int32_t const j : block(to).particle) places_[static_cast<std::size_t>(j)].block = to;
}

void Bins::insert(std::size_t i, std::int32_t bin, Box const &box) noexcept
{
    if (block(bin).count == 4) {
        std::int32_t const other = std::exchange(unused_, block(unused_).next);
        copy_full_block(bin, other);
        block(bin) = empty_block(other);
    }
    Place &place = places_[i];
    place.block = place.bin = bin;
    place.lane = block(bin).count++;
    set(place, static_cast<std::int32_t>(i), box);
}

/// Fills the gap with the last particle of the bin's first block.
void Bins::remove(std::size_t i) noexcept
{
    std::int32_t const bin = places_[i].bin;
    if (block(bin).count == 0) {
        std::int32_t const other = block(bin).next;
        copy_full_block(other, bin);
        block(other).next = std::exchange(unused_, other);
    }
    Place const gap = places_[i], end{bin, --block(bin).count, bin, {}};
    std::int32_t const moved = block(bin).particle[end.lane];
    set(gap, moved, get(end));
    places_[static_cast<std::size_t>(moved)].block = gap.block;
    places_[static_cast<std::size_t>(moved)].lane = gap.lane;
    for (Float4 &half_widths : block(bin).half_widths)
        half_widths[end.lane] = -std::numeric_limits<float>::infinity();
}

void Bins::move(std::size_t i, Vector3 const &center) noexcept
{
    Place &place = places_[i];
    Box box = get(place);
    std::int32_t const bin = locate(center, place.cell, box);
    if (double const magnitude = magnitude_of(center, box); magnitude > farthest_)
        widen_margin(magnitude);
    if (bin == place.bin) {
        set(place, static_cast<std::int32_t>(i), box);
    } else {
        remove(i);
        insert(i, bin, box);
    }
}

} // namespace pw85::detail::simulation

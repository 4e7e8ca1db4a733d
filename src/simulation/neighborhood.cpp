// SPDX-License-Identifier: BSD-3-Clause
// Makes the rows of neighborhood.hpp from the pairs of a neighbour list.
#include "neighborhood.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "../base/parallel.hpp"
#include "../neighbors/bounded_list.hpp"

namespace pw85::detail::simulation {

namespace {

/// Shorter lists are not worth the start of threads; more shares are not worth their memory.
constexpr std::size_t pairs_per_share = 16384, most_shares = 16;

bool is_same(Multiples const &x, Multiples const &y) noexcept
{
    // memcmp() would take 5 % of a sweep
    return x.n[0] == y.n[0] && x.n[1] == y.n[1] && x.n[2] == y.n[2];
}

Multiples negative(Multiples const &image) noexcept
{
    return {{-image.n[0], -image.n[1], -image.n[2]}};
}

/// Assigns numbers from 0 on to different multiples, by a hash table with open addressing.
class ImageTable {
  public:
    explicit ImageTable(Array<Multiples> &images) noexcept : images_(images) {}

    /// Returns the number of an image; -1 if there is no memory.
    std::int32_t number_of(Multiples const &image) noexcept
    {
        if (2 * count_ >= slots_.size() && !grow()) return -1;
        std::int32_t &slot = slots_[find(image)];
        if (slot < 0) {
            slot = static_cast<std::int32_t>(count_);
            images_[count_++] = image;
        }
        return slot;
    }

    std::size_t size() const noexcept { return count_; }

    /// Frees memory that is not used.
    bool finish() noexcept { return images_.resize(count_); }

    /// Returns the number of an image that has one.
    std::int32_t known(Multiples const &image) const noexcept { return slots_[find(image)]; }

  private:
    std::size_t find(Multiples const &image) const noexcept
    {
        auto const word = [&](int k) {
            return std::uint64_t{static_cast<std::uint32_t>(image.n[k])};
        };
        std::uint64_t const mixed =
            (word(0) * 0x9e3779b97f4a7c15u ^ word(1)) * 0xbf58476d1ce4e5b9u ^ word(2);
        std::size_t slot =
            static_cast<std::size_t>(mixed * 0x94d049bb133111ebu >> 32) & (slots_.size() - 1);
        while (slots_[slot] >= 0 &&
               !is_same(images_[static_cast<std::size_t>(slots_[slot])], image))
            slot = (slot + 1) & (slots_.size() - 1);
        return slot;
    }

    /// The slots are the last to be resized: number_of() may be called after an error, and looks at
    /// all of them.
    bool grow() noexcept
    {
        std::size_t const size = std::max<std::size_t>(64, 2 * slots_.size());
        if (!images_.resize(size) || !slots_.resize(size)) return false;
        std::fill_n(slots_.data(), size, -1);
        for (std::size_t k = 0; k < count_; ++k)
            slots_[find(images_[k])] = static_cast<std::int32_t>(k);
        return true;
    }

    Array<Multiples> &images_;
    Array<std::int32_t> slots_;
    std::size_t count_ = 0;
};

constexpr Multiples no_image{{0, 0, 0}};

/// Positions of the next neighbours of a particle in its list, for those that are not moved and
/// those that are; in the first pass, their numbers.
struct Places {
    std::size_t of[2] = {};

    void count(bool is_moved) noexcept { of[is_moved] += is_moved ? 2 : 1; }
};

/// The images of some pairs.
struct ImagesOfShare {
    Array<Multiples> images;
    ImageTable table{images};
    bool complete = true; ///< false if there was no memory

    void add(Multiples const &image) noexcept
    {
        if (table.number_of(image) < 0) complete = false;
    }
};

/// Numbers the images of all shares and their negatives.
bool number_images(std::span<ImagesOfShare const> shares, ImageTable &table) noexcept
{
    if (table.number_of(no_image) < 0) return false;
    for (ImagesOfShare const &share : shares) {
        if (!share.complete) return false;
        for (std::size_t k = 0; k < share.table.size(); ++k)
            if (table.number_of(share.images[k]) < 0 ||
                table.number_of(negative(share.images[k])) < 0)
                return false;
    }
    return table.finish();
}

/// Replaces the numbers of neighbours, by share and particle, by the positions of the first ones.
/// Returns the size of all rows.
std::size_t begin_rows(std::size_t n, std::size_t num_shares, Places *next,
                       std::size_t *begin) noexcept
{
    std::size_t sum = 0;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t part = 0; part < 2; ++part) {
            begin[2 * i + part] = sum;
            for (std::size_t share = 0; share < num_shares; ++share)
                sum += std::exchange(next[share * n + i].of[part], sum);
        }
    return begin[2 * n] = sum;
}

} // namespace

Neighborhood::Neighborhood() noexcept = default;

int Neighborhood::update(Configuration const &configuration, double reach, double skin) noexcept
{
    int const status = rebuild_list(configuration, reach, skin);
    if (status != PW85_SUCCESS) *this = Neighborhood();
    return status;
}

int Neighborhood::rebuild_list(Configuration const &configuration, double reach,
                               double skin) noexcept
{
    neighbors::BoundedList list;
    if (int const status = list.make(configuration.system(), reach, skin)) return status;
    std::copy_n(configuration.cell.vectors, 9, cell_);
    if (!store_extents(configuration, reach, skin) ||
        !fill_rows(configuration.size(), list.pairs()) || !translations_.resize(images_.size()))
        return PW85_ENOMEM;
    return set_cell(configuration.cell) ? PW85_SUCCESS : PW85_EINVAL;
}

bool Neighborhood::store_extents(Configuration const &configuration, double reach,
                                 double skin) noexcept
{
    std::size_t const n = configuration.size();
    if (!extents_.resize(n)) return false;
    return for_all(n, [&](Range range) {
               for (std::size_t i = range.begin; i < range.end; ++i) {
                   Vector3 half_widths = reach * configuration.half_widths[i];
                   for (int d = 0; d < 3; ++d) half_widths[d] += 0.5 * skin;
                   // All particles of a plane are at the same height: rows do not depend on their
                   // boxes along z.
                   if (configuration.dimensions == 2) half_widths[2] = HUGE_VAL;
                   extents_[i] = {configuration.centers[i], half_widths};
               }
               return Failure{0, PW85_SUCCESS};
           }) == PW85_SUCCESS;
}

// The pairs are divided into shares. In its row, a particle has first the partners of the first
// share, and so on, once for those that are not moved and once for the others. So the rows do not
// depend on the number of shares.
bool Neighborhood::fill_rows(std::size_t n, pw85_pair_list const &list) noexcept
{
    std::size_t const num_shares =
        list.num_pairs < pairs_per_share ? 1 : std::min(most_threads(), most_shares);
    Array<Places> next; // by share and particle
    if (!next.resize(num_shares * n) || !begin_.resize(2 * n + 1)) return false;
    auto const for_shares = [&](auto const &visit) {
        for_tasks(num_shares, num_shares > 1, [&](std::size_t share) {
            std::size_t const end = list.num_pairs * (share + 1) / num_shares;
            for (std::size_t k = list.num_pairs * share / num_shares; k < end; ++k)
                visit(share, image_of(list, k), list.pairs[2 * k], list.pairs[2 * k + 1]);
        });
    };
    std::fill_n(next.data(), next.size(), Places{});
    ImagesOfShare of_shares[most_shares];
    for_shares([&](std::size_t share, Multiples const &image, std::int32_t i, std::int32_t j) {
        Places *const counts = next.data() + share * n;
        bool const is_moved = !is_same(image, no_image);
        counts[i].count(is_moved), counts[j].count(is_moved);
        if (is_moved) of_shares[share].add(image);
    });
    ImageTable table(images_);
    if (!number_images({of_shares, num_shares}, table)) return false;
    if (!rows_.resize(begin_rows(n, num_shares, next.data(), begin_.data()))) return false;
    for_shares([&](std::size_t share, Multiples const &image, std::int32_t i, std::int32_t j) {
        Places *const places = next.data() + share * n;
        if (is_same(image, no_image)) {
            rows_[places[i].of[0]++] = j;
            rows_[places[j].of[0]++] = i;
        } else {
            put(places[i].of[1], {j, table.known(image)});
            put(places[j].of[1], {i, table.known(negative(image))});
        }
    });
    return true;
}

void Neighborhood::put(std::size_t &place, Neighbor const &moved) noexcept
{
    rows_[place++] = moved.index;
    rows_[place++] = moved.image;
}

bool Neighborhood::set_cell(Cell const &cell) noexcept
{
    neighbors::Periodicity now;
    if (!cell.find_lattice(now)) return false;
    deformation_ = neighbors::Deformation(now, cell.given(), cell_);
    for (std::size_t k = 0; k < images_.size(); ++k)
        translations_[k] = cell.translation(images_[k]);
    return true;
}

} // namespace pw85::detail::simulation

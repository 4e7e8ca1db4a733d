// SPDX-License-Identifier: BSD-3-Clause
// Makes the rows of neighborhood.hpp from the pairs of a neighbour list.
#include "neighborhood.hpp"

#include <algorithm>
#include <bit>
#include <span>

#include "../base/parallel.hpp"
#include "../neighbors/bounded_list.hpp"

namespace pw85::detail::simulation {

namespace {

/// Shorter lists are not worth the start of threads; more shares are not worth their memory.
constexpr std::size_t pairs_per_share = 16384, most_shares = 16;

/// Memory for the rows of recenter(): one word for eight words of the rows that are made. More
/// would cost memory, and less another list after fewer sweeps.
constexpr std::size_t words_per_spare = 8;

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
        std::size_t const size = maximum<std::size_t>(64, 2 * slots_.size());
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

/// Bounds the rounding errors of distances of boxes, over the magnitudes of their terms.
constexpr double rounding_of_boxes = 0x1p-40;

/// The largest difference of coordinates in the cell for which rounding finds the image.
constexpr double largest_part = 0.49;

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

/// Enlarges the half-widths of a box by half of the skin.
void enlarge(Vector3 &half_widths, double skin, int dimensions) noexcept
{
    for (int d = 0; d < 3; ++d) half_widths[d] += 0.5 * skin;
    // All particles of a plane are at the same height: rows do not depend on their boxes along z.
    if (dimensions == 2) half_widths[2] = infinity<double>();
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
    neighbors::Periodicity lattice;
    if (!configuration.cell.find_lattice(lattice)) return PW85_EINVAL;
    for (int k = 0; k < 3; ++k)
        dual_[k] = lattice.is_periodic(k) ? lattice.dual_of_cell(k) : Vector3{0.0, 0.0, 0.0};
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
    prefer_huge_pages(extents_);
    return for_all(n, [&](Range range) {
               for (std::size_t i = range.begin; i < range.end; ++i) {
                   Vector3 half_widths = reach * configuration.half_widths[i];
                   enlarge(half_widths, skin, configuration.dimensions);
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
        list.num_pairs < pairs_per_share ? 1 : minimum(most_threads(), most_shares);
    Array<Places> next; // by share and particle
    if (!next.resize(num_shares * n) || !ends_.resize(n)) return false;
    prefer_huge_pages(ends_);
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
    used_ = begin_rows(n, num_shares, next.data());
    if (!rows_.resize(used_ + used_ / words_per_spare)) return false;
    prefer_huge_pages(rows_);
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

/// Replaces the numbers of neighbours, by share and particle, by the positions of the first ones.
/// Returns the size of all rows.
std::size_t Neighborhood::begin_rows(std::size_t n, std::size_t num_shares, Places *next) noexcept
{
    std::size_t sum = 0;
    auto const begin_part = [&](std::size_t i, std::size_t part) {
        std::size_t const begin = sum;
        for (std::size_t share = 0; share < num_shares; ++share)
            sum += std::exchange(next[share * n + i].of[part], sum);
        return begin;
    };
    for (std::size_t i = 0; i < n; ++i) {
        ends_[i].begin = begin_part(i, 0);
        ends_[i].others = begin_part(i, 1);
        ends_[i].end = sum;
    }
    return sum;
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

// Two fixed boxes, with half-widths H, meet if the centres are at most 2 H apart along each axis.
// Each particle is within H of the centre of its fixed box, and particle i is at that of the new
// one. So the centres of the particles, mapped back, are at most 3 H apart. The inverse of I + K
// lengthens a coordinate by at most 1 + 4 max|K_ed| if max|K_ed| is at most 1/12. The
// coordinates in the cell of centres that are 2 H apart differ by less than 1/2, so only the
// nearest image can meet.
double Neighborhood::reach_of_recentered(double half_width) const noexcept
{
    double const gradient = deformation_.largest_gradient();
    bool is_unique = gradient <= 1.0 / 12.0;
    for (Vector3 const &dual : dual_)
        is_unique = is_unique && 2.0 * half_width * sum_of_magnitudes(dual) < largest_part;
    return is_unique ? 3.0 * half_width * (1.0 + 4.0 * gradient) : infinity<double>();
}

/// Returns the image of `to` whose coordinates in the cell are nearest to those of `from`.
Multiples Neighborhood::nearest_image(Vector3 const &from, Vector3 const &to) const noexcept
{
    Multiples image;
    for (int k = 0; k < 3; ++k)
        image.n[k] = static_cast<std::int32_t>(elementary::floor(dot(dual_[k], from - to) + 0.5));
    return image;
}

std::size_t Neighborhood::room() const noexcept
{
    // About a third of the images are new. Each makes a row of mean length longer.
    std::size_t const mean = used_ / maximum<std::size_t>(1, size()) + 1;
    return 3 * (rows_.size() - used_) / (mean * mean);
}

int Neighborhood::recenter(std::size_t i, Configuration const &configuration, double reach,
                           double skin, std::span<std::int32_t const> near) noexcept
{
    neighbors::BoxExtent box =
        deformation_.taken_back({configuration.centers[i], reach * configuration.half_widths[i]});
    enlarge(box.half_widths, skin, configuration.dimensions);
    std::size_t size = 0;
    if (int const status = find_meetings(i, box, near, size)) return status;
    if (size > rows_.size() - used_) return PW85_EINVAL;
    extents_[i] = box;
    RowEnds &own = ends_[i];
    own.begin = used_;
    for (Meeting const &one : meetings_)
        if (one.image.image == 0) rows_[used_++] = one.image.index;
    own.others = used_;
    for (Meeting const &one : meetings_)
        if (one.image.image != 0) put(used_, one.image);
    own.end = used_;
    for (Meeting const &one : meetings_)
        if (one.is_new)
            append(static_cast<std::size_t>(one.image.index),
                   {static_cast<std::int32_t>(i), one.back});
    return PW85_SUCCESS;
}

/// Lists the images that a fixed box meets, and finds the memory that their rows need. Returns a
/// status, PW85_EINVAL if an image is not in the table.
int Neighborhood::find_meetings(std::size_t i, neighbors::BoxExtent const &box,
                                std::span<std::int32_t const> near, std::size_t &size) noexcept
{
    meetings_.clear();
    if (!meetings_.reserve(near.size())) return PW85_ENOMEM;
    for (std::int32_t const place : near) {
        auto const j = static_cast<std::size_t>(place);
        Multiples const multiples = nearest_image(box.center, extents_[j].center);
        if (j == i || !meets(box, j, multiples)) continue;
        std::int32_t const image = number_of(multiples), back = number_of(negative(multiples));
        if (image < 0 || back < 0) return PW85_EINVAL;
        bool const is_new = !has(j, {static_cast<std::int32_t>(i), back});
        meetings_.push({{place, image}, back, is_new});
        size += 2 + (is_new ? ends_[j].end - ends_[j].begin + 2 : 0);
    }
    return PW85_SUCCESS;
}

/// Returns whether a fixed box meets the fixed box of an image of particle j, up to rounding.
bool Neighborhood::meets(neighbors::BoxExtent const &box, std::size_t j,
                         Multiples const &image) const noexcept
{
    neighbors::BoxExtent const &other = extents_[j];
    bool meets = true;
    for (int d = 0; d < 3; ++d) {
        double apart = other.center[d] - box.center[d],
               size = absolute(other.center[d]) + absolute(box.center[d]);
        for (int k = 0; k < 3; ++k) {
            if (image.n[k] == 0) continue; // other vectors need not be finite
            double const part = image.n[k] * cell_[3 * k + d];
            apart += part;
            size += absolute(part);
        }
        meets &=
            absolute(apart) <= box.half_widths[d] + other.half_widths[d] + rounding_of_boxes * size;
    }
    return meets;
}

/// Returns the number of an image; -1 if it has none.
std::int32_t Neighborhood::number_of(Multiples const &image) const noexcept
{
    for (std::size_t k = 0; k < images_.size(); ++k)
        if (is_same(images_[k], image)) return static_cast<std::int32_t>(k);
    return -1;
}

/// Returns whether an image is in the row of particle i.
bool Neighborhood::has(std::size_t i, Neighbor const &image) const noexcept
{
    Row const own = row(i);
    if (image.image == 0) {
        auto const unmoved = own.unmoved();
        return std::find(unmoved.begin(), unmoved.end(), image.index) != unmoved.end();
    }
    bool found = false;
    for (std::size_t k = 0; k < own.num_moved(); ++k) {
        Neighbor const other = own.moved(k);
        found |= other.index == image.index && other.image == image.image;
    }
    return found;
}

/// Moves the row of particle i behind all others, with one more image.
void Neighborhood::append(std::size_t i, Neighbor const &image) noexcept
{
    RowEnds const old = std::exchange(ends_[i], {used_, 0, 0});
    std::int32_t const *const all = rows_.data();
    auto const copy = [&](std::size_t begin, std::size_t end) {
        std::copy(all + begin, all + end, rows_.data() + used_);
        used_ += end - begin;
    };
    copy(old.begin, old.others);
    if (image.image == 0) rows_[used_++] = image.index;
    ends_[i].others = used_;
    copy(old.others, old.end);
    if (image.image != 0) put(used_, image);
    ends_[i].end = used_;
}

} // namespace pw85::detail::simulation

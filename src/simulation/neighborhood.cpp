// Makes the rows of neighborhood.hpp from the pairs of a neighbour list.
#include "neighborhood.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>

namespace pw85::detail::simulation {

namespace {

/// Numbers different multiples from 0 on, by a hash table with open addressing.
class ImageTable {
  public:
    explicit ImageTable(Array<Multiples> &images) noexcept : images_(images) {}

    /// The number of an image; -1 if there is no memory.
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

    /// Gives back memory that is not used.
    bool finish() noexcept { return images_.resize(count_); }

  private:
    static bool is_same(Multiples const &x, Multiples const &y) noexcept
    {
        return x.n[0] == y.n[0] && x.n[1] == y.n[1] && x.n[2] == y.n[2]; // memcmp() would take 5 % of a sweep
    }

    std::size_t find(Multiples const &image) const noexcept
    {
        auto const word = [&](int k) { return std::uint64_t{static_cast<std::uint32_t>(image.n[k])}; };
        std::uint64_t const mixed = (word(0) * 0x9e3779b97f4a7c15u ^ word(1)) * 0xbf58476d1ce4e5b9u ^ word(2);
        std::size_t slot = static_cast<std::size_t>(mixed * 0x94d049bb133111ebu >> 32) & (slots_.size() - 1);
        while (slots_[slot] >= 0 && !is_same(images_[static_cast<std::size_t>(slots_[slot])], image))
            slot = (slot + 1) & (slots_.size() - 1);
        return slot;
    }

    /// The slots are the last to be resized: number_of() may be called after an error, and looks at all of them.
    bool grow() noexcept
    {
        std::size_t const size = std::max<std::size_t>(64, 2 * slots_.size());
        if (!images_.resize(size) || !slots_.resize(size)) return false;
        std::fill_n(slots_.data(), size, -1);
        for (std::size_t k = 0; k < count_; ++k) slots_[find(images_[k])] = static_cast<std::int32_t>(k);
        return true;
    }

    Array<Multiples> &images_;
    Array<std::int32_t> slots_;
    std::size_t count_ = 0;
};

} // namespace

int Neighborhood::update(Configuration const &configuration, double skin) noexcept
{
    int const status = make_rows(configuration, skin);
    if (status != PW85_SUCCESS) *this = Neighborhood();
    return status;
}

int Neighborhood::make_rows(Configuration const &configuration, double skin) noexcept
{
    pw85_system const system = configuration.system();
    pw85_neighbors *made = nullptr;
    int const status = pw85_neighbors_create(&system, 1.0, skin, &made);
    std::unique_ptr<pw85_neighbors, DestroyList> const list(made);
    if (status != PW85_SUCCESS) return status;
    std::copy_n(configuration.cell.vectors, 9, cell_);
    pw85_pair_list const pairs = pw85_neighbors_list(list.get());
    if (!store_extents(configuration, skin) || !count_rows(configuration.size(), pairs) || !fill_rows(pairs) ||
        !translations_.resize(images_.size()))
        return PW85_ENOMEM;
    return set_cell(configuration.cell) ? PW85_SUCCESS : PW85_EINVAL;
}

bool Neighborhood::store_extents(Configuration const &configuration, double skin) noexcept
{
    std::size_t const n = configuration.size();
    if (!extents_.resize(n)) return false;
    for (std::size_t i = 0; i < n; ++i) {
        Vector3 half_widths = configuration.half_widths[i];
        for (int d = 0; d < 3; ++d) half_widths[d] += 0.5 * skin;
        extents_[i] = {configuration.centers[i], half_widths};
    }
    return true;
}

// The row of particle i begins at begin_[i + 1] until fill_rows() has filled it, and at begin_[i] afterwards.
bool Neighborhood::count_rows(std::size_t n, pw85_pair_list const &list) noexcept
{
    if (!begin_.resize(n + 2) || !rows_.resize(2 * list.num_pairs)) return false;
    std::fill_n(begin_.data(), n + 2, 0);
    for (std::size_t k = 0; k < 2 * list.num_pairs; ++k) ++begin_[static_cast<std::size_t>(list.pairs[k]) + 2];
    for (std::size_t i = 2; i < n + 2; ++i) begin_[i] += begin_[i - 1];
    return true;
}

bool Neighborhood::fill_rows(pw85_pair_list const &list) noexcept
{
    ImageTable table(images_);
    for (std::size_t k = 0; k < list.num_pairs; ++k) {
        std::int32_t const i = list.pairs[2 * k], j = list.pairs[2 * k + 1];
        Multiples const image = image_of(list, k), back = {{-image.n[0], -image.n[1], -image.n[2]}};
        std::int32_t const number = table.number_of(image), number_back = table.number_of(back);
        if (number < 0 || number_back < 0) return false;
        rows_[begin_[static_cast<std::size_t>(i) + 1]++] = {j, number};
        rows_[begin_[static_cast<std::size_t>(j) + 1]++] = {i, number_back};
    }
    return table.finish();
}

bool Neighborhood::set_cell(Cell const &cell) noexcept
{
    neighbors::Periodicity now;
    double const *const vectors = cell.exists ? cell.vectors : nullptr;
    if (!now.prepare(vectors, cell.periodic)) return false;
    deformation_ = neighbors::Deformation(now, vectors, cell_);
    for (std::size_t k = 0; k < images_.size(); ++k) translations_[k] = cell.translation(images_[k]);
    return true;
}

} // namespace pw85::detail::simulation

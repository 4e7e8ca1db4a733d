// SPDX-License-Identifier: BSD-3-Clause
// Copies of particles, and their number: see particles.hpp.
#include "particles.hpp"

#include <algorithm>
#include <new>

#include "../base/owner.hpp"
#include "../base/parallel.hpp"
#include "../neighbors/order.hpp"

namespace pw85::detail::simulation {

namespace {

/// Moves arrays into `old`, and makes larger ones with the same first n elements.
template <class T>
bool grow(Array<T> &array, std::size_t n, std::size_t capacity, Array<T> &old) noexcept
{
    if (!old.resize(capacity)) return false;
    std::copy_n(array.data(), n, old.data());
    std::swap(array, old);
    return true;
}

/// Number of particles by which commit() prefetches ahead: their copies take about as long as to
/// load one.
constexpr std::size_t prefetched = 16;

} // namespace

int MemoryOrder::prepare(Configuration const &configuration) noexcept
{
    std::size_t const n = configuration.size();
    neighbors::Periodicity periodicity;
    if (!configuration.cell.find_lattice(periodicity)) return PW85_EINVAL;
    Array<neighbors::KeyedIndex> keys;
    if (!keys.resize(n) || !numbers_.resize(2 * n)) return PW85_ENOMEM;
    neighbors::Box around = neighbors::empty_box;
    for (std::size_t i = 0; i < n; ++i) {
        auto const [x, y, z] = periodicity.wrapped(configuration.centers[i]).coordinates;
        around = enclose(around, {{x, y, z}, {x, y, z}});
    }
    for (std::size_t i = 0; i < n; ++i)
        keys[i] = {key_of(periodicity.wrapped(configuration.centers[i]), around),
                   static_cast<std::int32_t>(i)};
    std::sort(keys.data(), keys.data() + n,
              [](auto const &a, auto const &b) { return a.key < b.key; });
    for (std::size_t k = 0; k < n; ++k) {
        numbers_[n + k] = keys[k].index;
        numbers_[static_cast<std::size_t>(keys[k].index)] = static_cast<std::int32_t>(k);
    }
    return PW85_SUCCESS;
}

RetiredArrays::~RetiredArrays() = default;

Particles::Particles() noexcept = default;

Particles::~Particles() = default;

void Particles::measure() noexcept
{
    sizes_ = {all_.longest_semi_axis()};
    std::span const all(all_.semi_axes.data(), all_.size());
    for (Vector3 const &axes : all) {
        auto const [least, most] =
            std::minmax_element(axes.coordinates, axes.coordinates + all_.dimensions);
        sizes_.anisotropy = maximum(sizes_.anisotropy, *most - *least);
    }
    for (int d = 0; d < all_.dimensions && !all.empty(); ++d) {
        auto const is_less = [&](Vector3 const &x, Vector3 const &y) { return x[d] < y[d]; };
        auto const [least, most] = std::minmax_element(all.begin(), all.end(), is_less);
        sizes_.spread = maximum(sizes_.spread, (*most)[d] - (*least)[d]);
    }
}

int Particles::begin_session() noexcept
{
    if (is_copied_) return PW85_SUCCESS;
    std::size_t const n = all_.size();
    if (!copy_.resize(n) || !is_moved_.resize(n)) return PW85_ENOMEM;
    if (order_.size() != n)
        if (int const status = order_.prepare(all_)) return status;
    measure();
    copy_.cell = all_.cell;
    copy_.dimensions = all_.dimensions;
    for (std::size_t i = 0; i < n; ++i) copy_.set(order_.of(i), all_.get(i));
    std::fill_n(is_moved_.data(), n, std::uint8_t{false});
    ++generation_;
    is_copied_ = true;
    return PW85_SUCCESS;
}

void Particles::commit() noexcept
{
    if (!is_copied_) return;
    all_.cell = copy_.cell;
    for_all(all_.size(), [&](Range range) {
        for (std::size_t i = range.begin; i < range.end; ++i) {
            std::size_t const place = order_.of(i),
                              later = order_.of(minimum(i + prefetched, range.end - 1));
            if (is_moved_[later]) copy_.prefetch(later);
            if (std::exchange(is_moved_[place], std::uint8_t{false})) all_.set(i, copy_.get(place));
        }
        return Failure{0, PW85_SUCCESS};
    });
}

void Particles::commit(std::size_t place) noexcept
{
    all_.set(static_cast<std::size_t>(order_.particle(place)), copy_.get(place));
    is_moved_[place] = false;
}

int Particles::reorder() noexcept
{
    commit();
    if (int const status = order_.prepare(all_)) return status;
    is_copied_ = false;
    return begin_session();
}

// The capacity doubles: all outgrown arrays together have no more elements than the present ones.
int Particles::add(Particle const &particle) noexcept
{
    std::size_t const n = all_.size();
    if (n >= INT32_MAX) return PW85_ENOMEM;
    if (n == all_.capacity()) {
        std::size_t const more = maximum<std::size_t>(16, 2 * n);
        Owner<RetiredArrays> old(new (std::nothrow) RetiredArrays);
        if (old == nullptr) return PW85_ENOMEM;
        // half_widths come first and centers last, because the capacity is that of the centres.
        bool const is_larger =
            all_.half_widths.resize(more) && grow(all_.semi_axes, n, more, old->semi_axes) &&
            grow(all_.quaternions, n, more, old->quaternions) && grow(all_.q, n, more, old->q) &&
            grow(all_.centers, n, more, old->centers);
        old->older = std::move(retired_);
        retired_ = std::move(old);
        if (!is_larger) return PW85_ENOMEM;
    }
    all_.set_size(n + 1);
    all_.set(n, particle);
    is_copied_ = false;
    return PW85_SUCCESS;
}

void Particles::remove(std::size_t particle) noexcept
{
    std::size_t const last = all_.size() - 1;
    all_.set(particle, all_.get(last));
    all_.set_size(last);
    is_copied_ = false;
}

} // namespace pw85::detail::simulation

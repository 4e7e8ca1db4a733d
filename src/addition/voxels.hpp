// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The voxels of a random sequential addition: boxes of positions, and in the plane of angles, that
/// contain everything that may be free (Zhang, Phys. Rev. E 97, 043311, 2018).
///
/// 1. divide() halves each voxel along all of its directions, and keeps the parts that no particle
///    covers (covering.hpp).
/// 2. The packing is saturated if no voxel is left, or after 30 halvings (max_halvings). Voxels are
///    then shorter than 2⁻²⁹ of the shortest semi-axis, unless the number of the first ones was
///    limited.
#ifndef PW85_ADDITION_VOXELS_HPP_INCLUDED
#define PW85_ADDITION_VOXELS_HPP_INCLUDED

#include <algorithm>

#include "../base/list.hpp"
#include "../base/parallel.hpp"
#include "covering.hpp"

namespace pw85::detail::sequential_addition {
namespace {

/// The maximum number of voxels that are divided.
constexpr std::size_t max_voxels = 10'000'000;
/// The maximum number of halvings of a voxel.
constexpr int max_halvings = 30;

/// The result of a division of all voxels.
enum class Division { done, too_many, no_memory };

template <int D> class Voxels {
  public:
    /// @param all_species not empty; lives as long as this object
    explicit Voxels(Array<Species<D>> const &all_species, Cell<D> const &cell) noexcept
        : all_species_(all_species), smallest_(all_species[0].inner())
    {
        double longest = 0.0;
        are_balls_ = true;
        for (std::size_t k = 0; k < all_species.size(); ++k) {
            double const inner = all_species[k].inner(), outer = all_species[k].outer();
            smallest_ = minimum(smallest_, inner);
            longest = maximum(longest, outer / inner);
            are_balls_ = are_balls_ && inner == outer;
        }
        has_angles_ = D == 2 && !are_balls_;
        // Coarse voxels at first: with half as long ones, 15,000 ellipses of aspect ratio 4 take
        // 14 s of a processor instead of 5 s.
        for (int i = 0; i < D; ++i) divisions_.places[i] = count_of(cell.edge(i) / (2 * smallest_));
        divisions_.angles = has_angles_ ? count_of(2 * longest) : 1;
        limit_voxels(divisions_, static_cast<double>(all_species.size()));
    }

    bool exist() const noexcept { return exist_; }
    std::size_t size() const noexcept { return voxels_.size(); }
    bool is_saturated() const noexcept
    {
        return exist_ && (voxels_.size() == 0 || halvings_ == max_halvings);
    }

    /// The number of all voxels, covered or not.
    double total() const noexcept
    {
        return static_cast<double>(all_species_.size()) * divisions_.count();
    }

    /// The fraction of all species, positions and angles that may be free.
    double share() const noexcept
    {
        return exist_ ? static_cast<double>(voxels_.size()) / total() : 1.0;
    }

    /// Draws a particle in a random voxel.
    Particle<D> draw_any(Stream random, Cell<D> const &cell) const noexcept
    {
        double const choice = random.uniform();
        if (exist_) {
            Voxel<D> const &voxel = voxels_[index_of(choice, voxels_.size())];
            return draw(random, voxel, divisions_, all_species_[voxel.species], cell);
        }
        Divisions<D> whole;
        std::fill_n(whole.places, D, 1);
        whole.angles = 1;
        auto const species = static_cast<std::uint32_t>(index_of(choice, all_species_.size()));
        return draw(random, {{}, 0, species}, whole, all_species_[species], cell);
    }

    /// Makes the voxels, or halves them, and keeps those that no particle covers. The voxels stay
    /// as they are if halves would be too many, or without memory.
    Division divide(Packing<D> const &packing) noexcept
    {
        bool const can_be_covered =
            has_angles_ || are_balls_ ||
            packing.cell().edge(0) / static_cast<double>(divisions_.places[0]) >
                all_species_[0].inner() / 8;
        if (exist_ && !can_be_covered) return Division::done;
        Divisions<D> const before = divisions_;
        if (exist_) {
            for (auto &one : divisions_.places) one *= 2;
            if (has_angles_) divisions_.angles *= 2;
        }
        Division const result = keep_free(packing);
        if (result == Division::done) {
            halvings_ += exist_;
            exist_ = true;
        } else {
            divisions_ = before;
        }
        return result;
    }

  private:
    static std::uint64_t count_of(double x) noexcept
    {
        return static_cast<std::uint64_t>(std::clamp(elementary::ceil(x), 1.0, 8192.0));
    }

    /// The number from 0 to size - 1 that a random number in [0, 1) chooses.
    static std::size_t index_of(double choice, std::size_t size) noexcept
    {
        return minimum(static_cast<std::size_t>(choice * static_cast<double>(size)), size - 1);
    }

    /// Number of parts of a voxel that is halved; 1 before there are voxels.
    unsigned num_parts() const noexcept { return exist_ ? 1u << (D + has_angles_) : 1u; }

    /// A part of voxel k, or voxel k of all before there is a list of them.
    Voxel<D> part_of(std::size_t k, unsigned part) const noexcept
    {
        if (!exist_) return numbered(k);
        Voxel<D> voxel = voxels_[k];
        for (int i = 0; i < D; ++i) voxel.corner[i] = 2 * voxel.corner[i] + (part >> i & 1);
        if (has_angles_) voxel.angle = 2 * voxel.angle + (part >> D & 1);
        return voxel;
    }

    Voxel<D> numbered(std::size_t number) const noexcept
    {
        Voxel<D> voxel{};
        voxel.angle = number % divisions_.angles;
        number /= divisions_.angles;
        for (int i = 0; i < D; ++i) {
            voxel.corner[i] = number % divisions_.places[i];
            number /= divisions_.places[i];
        }
        voxel.species = static_cast<std::uint32_t>(number);
        return voxel;
    }

    /// Keeps the parts that are free. Threads mark them in blocks of voxels, so that the order is
    /// that of the voxels.
    Division keep_free(Packing<D> const &packing) noexcept
    {
        constexpr std::size_t block = std::size_t{1} << 18;
        std::size_t const number = exist_ ? voxels_.size() : static_cast<std::size_t>(total());
        Array<unsigned char> free_parts;
        List<Voxel<D>> kept;
        Covering<D> covering(packing, all_species_, divisions_);
        if (!free_parts.resize(minimum(block, number)) || !covering.prepare())
            return Division::no_memory;
        for (std::size_t begin = 0; begin < number; begin += block) {
            std::size_t const count = minimum(block, number - begin);
            for_parts(count, [&](std::size_t first, std::size_t end) {
                for (std::size_t k = first; k < end; ++k)
                    free_parts[k] = free_parts_of(begin + k, covering);
            });
            for (std::size_t k = 0; k < count; ++k)
                if (!append(begin + k, free_parts[k], kept)) return Division::no_memory;
            if (exist_ && kept.size() > max_voxels) return Division::too_many;
        }
        std::swap(voxels_, kept);
        return Division::done;
    }

    /// Bits of the parts of voxel k that are free.
    unsigned char free_parts_of(std::size_t k, Covering<D> const &covering) const noexcept
    {
        unsigned parts = 0;
        for (unsigned part = 0; part < num_parts(); ++part)
            if (!covering.covers(part_of(k, part))) parts |= 1u << part;
        return static_cast<unsigned char>(parts);
    }

    /// Adds the parts of voxel k that are free to a list. Returns false if there is no memory.
    bool append(std::size_t k, unsigned parts, List<Voxel<D>> &kept) const noexcept
    {
        if (!kept.reserve(kept.size() + num_parts())) return false;
        for (unsigned part = 0; part < num_parts(); ++part)
            if (parts >> part & 1) kept.push(part_of(k, part));
        return true;
    }

    Array<Species<D>> const &all_species_;
    double smallest_;
    List<Voxel<D>> voxels_;
    Divisions<D> divisions_{};
    int halvings_ = 0;
    bool are_balls_ = false, has_angles_ = false, exist_ = false;
};

} // namespace
} // namespace pw85::detail::sequential_addition

#endif

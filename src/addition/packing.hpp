// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The particles that a random sequential addition has placed, in boxes of the cell.
#ifndef PW85_ADDITION_PACKING_HPP_INCLUDED
#define PW85_ADDITION_PACKING_HPP_INCLUDED

#include <algorithm>
#include <cstdint>

#include <pw85.h>

#include "../base/array.hpp"
#include "../simd/one_pair.hpp"
#include "cell.hpp"
#include "inner_forms.hpp"

namespace pw85::detail::sequential_addition {
namespace {

template <int D> using Form = SymmetricMatrix<double, D>;

/// An ellipsoid about its centre. Its form is inside a ball with its longest semi-axis, `outer`, up
/// to rounding, and around a ball with the radius `inner` for certain.
template <int D> struct Body {
    Form<D> q;
    double outer, inner;
};

template <int D> struct Particle {
    Vector<double, D> center, place; ///< place: in units of the vectors of the cell, in [0, 1)
    Body<D> body;
    Vector<double, 4> quaternion;
    std::uint32_t species;
};

/// Returns whether two ellipsoids, whose forms are positive definite, overlap.
inline bool overlaps(Vector<double, 2> const &r, Form<2> const &q1, Form<2> const &q2) noexcept
{
    int overlap = 0;
    pw85_overlap_2d(r.coordinates, q1.entries, q2.entries, &overlap);
    return overlap == 1;
}

inline bool overlaps(Vector<double, 3> const &r, Form<3> const &q1, Form<3> const &q2) noexcept
{
    int overlap = 0;
    PW85_OF_PAIR(kernels::chosen(), overlap)(r.coordinates, q1.entries, q2.entries, &overlap);
    return overlap == 1;
}

/// Particles by boxes of the cell. Particles that overlap are in the same box or in adjacent ones:
/// a box is wider than two particles by more than the errors of positions (rounding_loss()). A cell
/// of one box is at least as wide as two particles.
template <int D> class Packing {
  public:
    explicit Packing(Cell<D> const &cell) noexcept : cell_(cell) {}

    /// Divides the empty cell into boxes for particles with this longest semi-axis. Returns false
    /// if there is no memory.
    [[nodiscard]] bool divide(double outer) noexcept
    {
        std::size_t total = 1;
        double const width = 2 * outer * (1 + margin) + position_error * cell_.edges();
        for (int i = 0; i < D; ++i) {
            boxes_[i] = static_cast<std::int64_t>(
                minimum(maximum(1.0, cell_.height(i) / width), D == 2 ? 1024.0 : 256.0));
            total *= static_cast<std::size_t>(boxes_[i]);
        }
        if (!first_.resize(total)) return false;
        std::fill_n(first_.data(), total, -1);
        return true;
    }

    Cell<D> const &cell() const noexcept { return cell_; }
    std::size_t size() const noexcept { return size_; }
    Particle<D> const &operator[](std::size_t k) const noexcept { return particles_[k]; }

    /// Adds a particle. Returns false and changes nothing if there is no memory.
    [[nodiscard]] bool add(Particle<D> const &particle) noexcept
    {
        if (size_ == next_.size()) {
            std::size_t const capacity = 2 * size_ + 64;
            if (!particles_.resize(capacity) || !next_.resize(capacity)) return false;
        }
        std::int32_t &first = first_[index(boxes_of(particle.place))];
        next_[size_] = first;
        first = static_cast<std::int32_t>(size_);
        particles_[size_++] = particle;
        return true;
    }

    /// Returns whether function(separation, body) is true for an image of a particle near a
    /// position, which is given in units of the vectors of the cell and as a point.
    template <class Function> bool any_near(Vector<double, D> const &place,
                                            Vector<double, D> const &point,
                                            Function const &function) const noexcept
    {
        constexpr int count = D == 2 ? 9 : 27;
        Boxes const home = boxes_of(place);
        for (int code = 0; code < count; ++code) {
            Boxes box = home;
            Vector<double, D> from = point;
            for (int i = 0, rest = code; i < D; ++i, rest /= 3) {
                box[i] += rest % 3 == 2 ? -1 : rest % 3; // first the own box: most attempts fail
                double const turns = box[i] < 0 ? -1 : box[i] >= boxes_[i] ? 1 : 0;
                box[i] -= static_cast<std::int64_t>(turns) * boxes_[i];
                if (turns != 0) from = add_scaled(from, -turns, cell_[i]);
            }
            if (any_in(box, from, function)) return true;
        }
        return false;
    }

    /// Returns whether a particle overlaps none of the packing, by the exact test.
    bool is_free(Particle<D> const &one) const noexcept
    {
        auto const meets = [&one](Vector<double, D> const &r, Body<D> const &other) noexcept {
            double const distance = magnitude(r);
            if (distance > (one.body.outer + other.outer) * (1 + margin)) return false;
            return distance < (one.body.inner + other.inner) * (1 - margin) ||
                   overlaps(r, one.body.q, other.q);
        };
        return !any_near(one.place, one.center, meets);
    }

  private:
    /// The numbers of a box along the vectors of the cell.
    struct Boxes {
        std::int64_t n[std::size_t(D)];
        std::int64_t &operator[](int i) noexcept { return n[i]; }
        std::int64_t operator[](int i) const noexcept { return n[i]; }
    };

    template <class Function> bool any_in(Boxes const &box, Vector<double, D> const &from,
                                          Function const &function) const noexcept
    {
        for (std::int32_t j = first_[index(box)]; j >= 0; j = next_[static_cast<std::size_t>(j)]) {
            Particle<D> const &other = particles_[static_cast<std::size_t>(j)];
            if (function(other.center - from, other.body)) return true;
        }
        return false;
    }

    Boxes boxes_of(Vector<double, D> const &place) const noexcept
    {
        Boxes box;
        for (int i = 0; i < D; ++i)
            box[i] = minimum(static_cast<std::int64_t>(place[i] * static_cast<double>(boxes_[i])),
                             boxes_[i] - 1);
        return box;
    }

    std::size_t index(Boxes const &box) const noexcept
    {
        std::int64_t number = 0;
        for (int i = 0; i < D; ++i) number = number * boxes_[i] + box[i];
        return static_cast<std::size_t>(number);
    }

    Cell<D> cell_;
    Boxes boxes_{};
    Array<std::int32_t> first_, next_; ///< linked lists: of each box, and behind each particle
    Array<Particle<D>> particles_;
    std::size_t size_ = 0;
};

} // namespace
} // namespace pw85::detail::sequential_addition

#endif

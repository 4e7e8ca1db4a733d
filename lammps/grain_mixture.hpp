// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Mixtures of grains, from which fix pw85/pour draws: shapes, sizes, orientations and velocities.
#ifndef PW85_LAMMPS_GRAIN_MIXTURE_HPP_INCLUDED
#define PW85_LAMMPS_GRAIN_MIXTURE_HPP_INCLUDED

#include "random.hpp"
#include "vectors.hpp"
#include "words.hpp"

#include <array>
#include <optional>
#include <vector>

namespace pw85_lammps {

using Quaternion = std::array<double, 4>; ///< (w, i, j, k)

/// A grain that is to be inserted.
struct NewGrain {
    int type;
    Vector semi_axes;
    double density;
    Quaternion quaternion;
    Vector velocity;

    double mass() const;
    double radius() const; ///< of a sphere around it
};

/// The distribution of a positive factor.
class SizeDistribution {
  public:
    /// Reads `uniform LO HI | normal MEAN SD LO HI | lognormal MEDIAN SIGMA LO HI`.
    static SizeDistribution parse(Words &words);

    double draw(Stream &stream) const;
    double largest() const { return upper_; }

  private:
    enum class Kind { one, uniform, normal, lognormal };

    double share_between(double lower, double upper) const;

    Kind kind_ = Kind::one;
    /// of the normal distribution, which may be that of the logarithm
    double middle_ = 1.0, width_ = 0.0;
    double lower_ = 1.0, upper_ = 1.0;
};

/// Species of grains, each with its fraction of the number of grains.
class GrainMixture {
  public:
    /// Reads `TYPE DX DY DZ [share W] [density D] [size ...]`, which follow the word `grain`.
    void parse_grain(Words &words, int num_types);

    /// Reads `quat W I J K`. Without these words orientations are random.
    void parse_orientation(Words &words);

    /// Reads `VX VY VZ [spread DX DY DZ]`, which follow the word `velocity`.
    void parse_velocity(Words &words);

    bool empty() const { return kinds_.empty(); }

    /// Returns the largest radius of a sphere around a grain of a type, or of any type; 0 if there
    /// is none.
    double largest_radius(std::optional<int> type = {}) const;

    /// Returns the largest radius of curvature of the grains of a type.
    double largest_curvature_radius(int type) const;

    /// @param in_plane whether grains turn around z alone
    NewGrain draw(Stream &stream, bool in_plane) const;

  private:
    struct Kind {
        int type;
        Vector semi_axes;
        double share = 1.0, density = 1.0;
        SizeDistribution size{};
    };

    Kind const &draw_kind(Stream &stream) const;
    Quaternion draw_orientation(Stream &stream, bool in_plane) const;

    std::vector<Kind> kinds_;
    std::optional<Quaternion> orientation_;
    Vector velocity_{}, spread_{};
};

} // namespace pw85_lammps

#endif

// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The quadratic forms and bounding radii of the ellipsoids that a processor owns or has as ghosts.
/// All styles use it.
#ifndef PW85_LAMMPS_ELLIPSOIDS_HPP_INCLUDED
#define PW85_LAMMPS_ELLIPSOIDS_HPP_INCLUDED

#include "host.hpp"

#include <pw85.h>
#include <pw85_systems.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pw85_lammps {

/// The ellipsoids by local index, owned ones first, as everywhere in LAMMPS.
///
/// Shapes and orientations are read through `compute property/atom`, because LAMMPS does not
/// install the header of atom_style ellipsoid. The style that owns this object sends the forms to
/// the ghosts.
class Ellipsoids : protected LAMMPS_NS::Pointers {
  public:
    /// Number of values per atom in forward communication.
    static constexpr int comm_size = 7;

    /// The relative margin in comparisons of distances with sums of radii. Distances, radii and
    /// forms have rounding errors of some 1e-15. 2⁻⁴⁰ is far above them, and so small that it adds
    /// hardly any pairs.
    static constexpr double margin = 0x1p-40;

    /// @param style name of the style that owns this object, for error messages
    /// @param otherwise advice for atoms that are to have no shape, for error messages
    Ellipsoids(LAMMPS_NS::LAMMPS *lammps, std::string style, std::string otherwise);

    /// Forgets all shapes. Call this at the start of a run, because shapes may have changed before
    /// it.
    void forget() { tags_.clear(); }

    /// Reads the owned ellipsoids that are selected. Other atoms get a radius of zero. A selected
    /// atom without a shape is an error. Ghosts are out of date until the style communicates.
    /// Orientations are always read; shapes are read only if the atoms have other indices than
    /// before.
    void read(std::function<bool(int)> const &selected);

    /// Announces that ellipsoids of a type will be inserted, with bounding spheres up to `radius`
    /// and radii of curvature up to `curvature_radius`.
    void expect(int type, double radius, double curvature_radius);

    /// Returns the largest radius of curvature of the ellipsoids of each type on all processors; 0
    /// for types without ellipsoids.
    std::vector<double> largest_curvature_radii() const;

    int pack(int count, int const *atoms, double *buffer) const;
    void unpack(int count, int first, double const *buffer);

    /// Calls use(t, u, distance) for all types t <= u of which there are ellipsoids, with the
    /// largest distance at which two of them can touch. All processors call this together.
    void for_each_reach(std::function<void(int, int, double)> const &use) const;

    /// Stops the run if the cutoff of the pair style for two types is less than a distance. All
    /// processors call this together.
    void require_cutoff(int t, int u, double cutoff, double distance) const;

    /// Returns the forms by local index, n×6.
    double const *forms() const { return forms_.data(); }

    /// Returns the system of owned atoms and ghosts. It has no cell, because the ghosts are the
    /// periodic images.
    pw85_system system() const
    {
        return {static_cast<std::size_t>(atom->nlocal + atom->nghost),
                atom->x[0],
                forms_.data(),
                nullptr,
                {}};
    }

    double const *form(int i) const { return &forms_[PW85_SYM * static_cast<std::size_t>(i)]; }

    /// Returns the radius of the bounding sphere, of owned ellipsoids and ghosts; 0 for atoms that
    /// are not selected.
    double radius(int i) const { return radii_[static_cast<std::size_t>(i)]; }

    /// Returns the quaternion (w, i, j, k) of an owned ellipsoid, as last read or set by turn().
    double const *quaternion(int i) const { return quaternions_->array_atom[i]; }

    /// Returns the form that an owned ellipsoid has with another quaternion.
    std::array<double, PW85_SYM> form_with(int i, double const *quaternion) const;

    /// Sets the quaternion and the form of an owned ellipsoid. write_quaternions() passes them to
    /// LAMMPS.
    void turn(int i, double const *quaternion, std::array<double, PW85_SYM> const &form);

    /// Writes the quaternions of all owned ellipsoids to LAMMPS.
    void write_quaternions();

    // Returns a semi-axis of an owned ellipsoid.
    double semi_axis(int i, std::size_t k) const
    {
        return semi_axes_[PW85_DIM * static_cast<std::size_t>(i) + k];
    }
    double smallest_semi_axis(int i) const
    {
        return std::min({semi_axis(i, 0), semi_axis(i, 1), semi_axis(i, 2)});
    }
    double largest_semi_axis(int i) const
    {
        return std::max({semi_axis(i, 0), semi_axis(i, 1), semi_axis(i, 2)});
    }

    /// A test whether two atoms are selected and their bounding spheres, scaled by the square root
    /// of scale2, are closer than a gap.
    class Reach {
      public:
        Reach(double const *centers, double const *radii, double scale2, double gap)
            : centers_(centers), radii_(radii), scale2_(scale2 * (1.0 + margin)), gap_(gap)
        {
        }

        bool operator()(int i, int j) const
        {
            double const *a = centers_ + 3 * static_cast<std::ptrdiff_t>(i);
            double const *b = centers_ + 3 * static_cast<std::ptrdiff_t>(j);
            double const dx = b[0] - a[0], dy = b[1] - a[1], dz = b[2] - a[2],
                         reach = radii_[i] + radii_[j] + gap_;
            bool const near = dx * dx + dy * dy + dz * dz <= scale2_ * reach * reach;
            return near & (radii_[i] > 0.0) & (radii_[j] > 0.0);
        }

      private:
        double const *centers_, *radii_;
        double scale2_, gap_;
    };

    /// Returns a test of pairs, which is valid until atoms move.
    Reach reach(double scale2, double gap = 0.0) const
    {
        return {atom->x[0], radii_.data(), scale2, gap};
    }

    bool selected(int i) const { return radii_[static_cast<std::size_t>(i)] > 0.0; }

    /// Returns selected(i), or false for an index out of range.
    bool has(int i) const { return static_cast<std::size_t>(i) < radii_.size() && selected(i); }

    /// Returns the name of an atom in messages.
    std::string name(int i) const;

    /// Stops the run because of an atom for the given reason, which follows its name.
    [[noreturn]] void refuse(int i, std::string const &reason) const;

    /// Stops the run because of the pair that the library has just refused.
    [[noreturn]] void refuse_pair(int i, int j) const;

    /// Stops the run because of a pair for the given reason, which follows the names of both atoms.
    [[noreturn]] void refuse_pair(int i, int j, std::string const &reason) const;

    double bytes() const;

  private:
    void reserve();
    void read_shapes();
    bool is_superellipsoid(int i) const;
    bool has_all_shapes() const;
    [[noreturn]] void refuse_shape(int i) const;
    std::vector<double> largest_radii() const;

    std::string style_, otherwise_;
    std::unique_ptr<LAMMPS_NS::Compute> shapes_, quaternions_;
    std::unique_ptr<LAMMPS_NS::Compute> exponents_; ///< null if LAMMPS has no superellipsoids
    /// tags of the atoms whose semi-axes are stored
    std::vector<LAMMPS_NS::tagint> tags_;
    std::vector<double> semi_axes_, forms_, radii_;
    /// by type, if ellipsoids will be inserted
    std::vector<double> expected_radii_, expected_curvature_radii_;
};

} // namespace pw85_lammps

#endif

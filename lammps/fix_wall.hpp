// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The style `fix ID group wall/pw85`: planes with the laws of force of pair_style pw85/granular.
#ifndef PW85_LAMMPS_FIX_WALL_HPP_INCLUDED
#define PW85_LAMMPS_FIX_WALL_HPP_INCLUDED

#include "contact_law.hpp"
#include "ellipsoids.hpp"
#include "grain_geometry.hpp"

#include <array>
#include <optional>
#include <vector>

namespace pw85_lammps {

/// One or two planes across an axis of space, which may move.
class FixWall final : public LAMMPS_NS::Fix {
  public:
    FixWall(LAMMPS_NS::LAMMPS *lammps, int narg, char **arg);
    ~FixWall() override;

    int setmask() override;
    void init() override;
    void setup(int vflag) override { post_force(vflag); }
    void post_force(int vflag) override;
    void reset_dt() override {}

    /// The energy of the normal springs.
    double compute_scalar() override;

    void write_restart(FILE *file) override;
    void restart(char *state) override;
    void grow_arrays(int nmax) override { springs_.resize(static_cast<std::size_t>(nmax)); }
    void copy_arrays(int from, int to, int) override { springs(to) = springs(from); }
    void set_arrays(int i) override { springs(i) = {}; }
    int pack_exchange(int i, double *buffer) override;
    int unpack_exchange(int i, double *buffer) override;
    int pack_restart(int i, double *buffer) override;
    void unpack_restart(int i, int which) override;
    int size_restart(int) override { return restart_size; }
    int maxsize_restart() override { return restart_size; }
    double memory_usage() override
    {
        return ellipsoids_->bytes() + static_cast<double>(springs_.capacity() * sizeof(Springs));
    }

  private:
    /// A plane; `side` is +1 if the material is behind it along the axis, and -1 if it is before it.
    struct Plane {
        double place, side;
        bool exists;
    };

    using Springs = std::array<Vector, 2>; ///< for the lower and the upper plane
    static constexpr int exchange_size = 6, restart_size = exchange_size + 1;

    Springs &springs(int i) { return springs_[static_cast<std::size_t>(i)]; }
    int parse_planes(char **arg);
    int parse_motion(int k, int narg, char **arg);
    double place(char const *word) const;
    int axis_of(char const *word) const;
    double shift() const;
    Vector wall_velocity() const;
    void push(int i, Plane const &plane, Vector &spring);

    int axis_ = 0;
    std::array<Plane, 2> planes_{};
    bool wiggles_ = false;
    int moving_axis_ = 0;
    double amplitude_ = 0.0, period_ = 1.0, speed_ = 0.0; ///< of a sine, or of a constant motion
    LAMMPS_NS::bigint first_step_;
    bool arms_at_surface_ = false;
    ContactLaw law_;
    std::optional<Ellipsoids> ellipsoids_;
    std::vector<Springs> springs_; ///< by owned atom
    double timestep_ = 0.0, energy_ = 0.0;
};

} // namespace pw85_lammps

#endif

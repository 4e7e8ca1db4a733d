// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The style `fix ID group wall/pw85`: walls with the laws of force of pair_style pw85/granular.
#ifndef PW85_LAMMPS_FIX_WALL_HPP_INCLUDED
#define PW85_LAMMPS_FIX_WALL_HPP_INCLUDED

#include "body_masses.hpp"
#include "contact_law.hpp"
#include "ellipsoids.hpp"
#include "equal_value.hpp"
#include "fix_heat.hpp"
#include "grain_geometry.hpp"
#include "local_rows.hpp"
#include "time_step_check.hpp"
#include "wall_motion.hpp"
#include "wall_surface.hpp"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace pw85_lammps {

/// A wall of any shape, which may move.
class FixWall final : public LAMMPS_NS::Fix {
  public:
    FixWall(LAMMPS_NS::LAMMPS *lammps, int narg, char **arg);
    ~FixWall() override;

    int setmask() override;
    void init() override;
    void setup_pre_exchange() override { pre_exchange(); }
    void setup(int vflag) override { post_force(vflag); }
    void pre_exchange() override;
    void post_force(int vflag) override;
    void reset_dt() override {}

    /// Returns whether a grain would touch the wall in the next step, or be behind its surface.
    bool meets(Vector const &center, double const *form, double radius) const;

    /// Returns why the wall cannot be a wall for hard ellipsoids, or an empty string.
    std::string why_not_hard() const;

    /// Returns whether a hard ellipsoid cuts the wall, by an exact decision.
    bool cuts(Vector const &center, double const *form, double radius) const;

    /// Returns the energy of the normal springs.
    double compute_scalar() override;

    /// Returns the force and the torque of the grains on the wall, its number of contacts, its
    /// displacement, its velocity, and the heat that flows into it.
    double compute_vector(int k) override;

    /// A contact of an owned atom.
    struct Touch {
        int i;
        /// arm: from the centre to the place where the force acts; force: on the grain
        Vector arm, normal, force;
        double depth;
        Vector spring;
        double heat; ///< that flows into the grain in a unit of time
    };

    /// Keeps the contacts of each step from now on, for computes.
    void keep_touches() { keeps_touches_ = true; }
    LAMMPS_NS::bigint step_of_touches() const { return step_of_touches_; }
    std::vector<Touch> const &touches() const { return touches_; }

    void write_restart(FILE *file) override;
    void restart(char *buffer) override;
    void grow_arrays(int nmax) override { contacts_.resize(static_cast<std::size_t>(nmax)); }
    void copy_arrays(int from, int to, int) override { contacts(to) = contacts(from); }
    void set_arrays(int i) override { contacts(i).clear(); }
    int pack_exchange(int i, double *buffer) override;
    int unpack_exchange(int i, double *buffer) override;
    int pack_restart(int i, double *buffer) override;
    void unpack_restart(int i, int which) override;
    int size_restart(int i) override
    {
        return 2 + contact_size * static_cast<int>(contacts(i).size());
    }
    int maxsize_restart() override { return 1 + maxexchange; }
    double memory_usage() override;

  private:
    /// Contact that is kept for the next step. The contact of that step with the nearest normal
    /// gets the springs.
    struct Contact {
        Vector normal;
        Springs springs;
    };

    /// Load of the grains on the wall.
    struct Load {
        Vector force{}, torque{};
        double num_contacts = 0.0, heat = 0.0; ///< heat: of a unit of time
    };

    /// State that a restart file stores.
    struct State {
        double marker;
        WallClock clock;
        WallMotion::ServoState servo;
    };

    /// Number of a triangle, its corners, the force on it, and its normal and shear stress.
    using LoadRows = LocalRows<15>;
    using LoadRow = LoadRows::Row;

    /// The first number of the state. The clock, with which the states of version 3.0.0 begin, does
    /// not start before time 0.
    static constexpr double state_marker = -1.0;

    static constexpr int contact_size = 3 + Springs::size; ///< numbers of a contact in messages

    std::vector<Contact> &contacts(int i) { return contacts_[static_cast<std::size_t>(i)]; }
    void parse(int narg, char **arg);
    void check_heat(Words const &words) const;
    void require_monte_carlo() const;
    void pass_time();
    void move_wall();
    Load const &total_load();
    void add_load(int i, GrainGeometry const &contact, Reaction const &reaction);
    void tabulate_loads();
    std::vector<bool> inherit_springs(std::vector<Contact> &before,
                                      std::vector<Contact> &now) const;
    double largest_gap(int i) const;
    void touch(int i);
    void push(int i, GrainGeometry const &contact, Springs &springs);
    double conduct(int i, GrainGeometry const &contact);
    void find_maxexchange();

    std::unique_ptr<WallSurface> surface_;
    WallMotion motion_;
    WallClock clock_;
    LAMMPS_NS::bigint step_; ///< up to which time has passed
    Arms arms_ = Arms::contact;
    bool is_hard_ = false; ///< for Monte Carlo: no forces
    std::optional<EqualValue> temperature_;
    double present_temperature_ = 0.0;
    FixHeat *heat_ = nullptr; ///< if the law conducts heat
    ContactLaw law_;
    std::optional<Ellipsoids> ellipsoids_;
    BodyMasses masses_;
    std::vector<std::vector<Contact>> contacts_; ///< by owned atom
    std::vector<GrainGeometry> touching_;        ///< memory for touch()
    double timestep_ = 0.0, energy_ = 0.0;
    Load load_, total_load_;               ///< of this processor, and of all
    LAMMPS_NS::bigint step_of_total_ = -1; ///< of total_load_
    /// forces on triangles, if they are tabulated in this step
    std::vector<double> loads_;
    LoadRows load_rows_;
    bool keeps_touches_ = false;
    LAMMPS_NS::bigint step_of_touches_ = -1;
    std::vector<Touch> touches_;
    TimeStepCheck time_step_check_;
    double fastest_ = 0.0; ///< the largest stiffness over mass of the contacts of this step
};

} // namespace pw85_lammps

#endif

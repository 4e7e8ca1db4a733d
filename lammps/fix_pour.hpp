// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The style `fix ID group pw85/pour`: inserts grains during a run.
#ifndef PW85_LAMMPS_FIX_POUR_HPP_INCLUDED
#define PW85_LAMMPS_FIX_POUR_HPP_INCLUDED

#include "ellipsoids.hpp"
#include "grain_mixture.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pw85_lammps {

/// Inserts grains at random positions in a region, where they overlap nothing.
///
/// Grain number k has a type, a size, an orientation and a velocity that follow from the seed and k
/// alone; its places follow from the seed, k, and how many places were refused before. All
/// processors draw the same grains and know all atoms near the region, and decide alike; the owner
/// of the place creates the atom.
class FixPour final : public LAMMPS_NS::Fix {
  public:
    FixPour(LAMMPS_NS::LAMMPS *lammps, int narg, char **arg);

    int setmask() override;
    void init() override;
    void pre_exchange() override;

    /// Returns the number of inserted grains.
    double compute_scalar() override { return static_cast<double>(state_.inserted); }

    /// Returns the number and the mass of the inserted grains, the number of grains that wait, and
    /// the number of refused positions.
    double compute_vector(int k) override;

    GrainMixture const &mixture() const { return mixture_; }

    void write_restart(FILE *file) override;
    void restart(char *state) override;
    double memory_usage() override;

  private:
    /// State that a restart file stores.
    struct State {
        LAMMPS_NS::bigint inserted = 0, next_step = 0, refused = 0;
        LAMMPS_NS::tagint last_tag = 0; ///< the largest tag that any atom has had
        double wanted = 0.0;            ///< number of grains at the present time
        double mass = 0.0;              ///< of the inserted grains
    };

    /// The ellipsoids near the region, as three arrays.
    struct Others {
        std::vector<double> centers, forms, radii;
    };

    void read_keyword(Words &words);
    void check_words(Words &words) const;
    void read_region();
    void check_box() const;
    void find_others();
    bool is_beside_region(int i) const;
    bool place(NewGrain const &grain, Vector &center, std::array<double, PW85_SYM> &form);
    Vector draw_place(Stream &stream) const;
    bool is_in_box(Vector const &x) const;
    bool meets_others(Vector const &center, double const *form, double radius);
    bool meets_walls(Vector const &center, double const *form, double radius) const;
    void create(NewGrain const &grain, Vector const &center, LAMMPS_NS::tagint tag);
    bool owns(Vector const &x) const;
    void find_last_tag();
    void announce(LAMMPS_NS::bigint count);
    void warn_of_full_region();
    [[noreturn]] void refuse(std::string const &reason) const;

    LAMMPS_NS::bigint number_ = 0; ///< of grains in the end
    std::uint32_t seed_ = 0;
    std::string region_id_;
    LAMMPS_NS::Region *region_ = nullptr;
    GrainMixture mixture_;
    LAMMPS_NS::bigint every_ = 100;
    /// grains of an insertion, or of a unit of time; one of them is zero
    double count_ = 1.0, rate_ = 0.0;
    LAMMPS_NS::bigint attempts_ = 100;
    State state_;
    Ellipsoids ellipsoids_;
    Others others_;
    std::vector<double> near_r12_, near_forms_; ///< memory for meets_others()
    bool warned_ = false;
};

} // namespace pw85_lammps

#endif

// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The style `pair_style pw85/granular`: grains that are ellipsoids, with friction.
#ifndef PW85_LAMMPS_PAIR_GRANULAR_HPP_INCLUDED
#define PW85_LAMMPS_PAIR_GRANULAR_HPP_INCLUDED

#include "body_masses.hpp"
#include "contact_history.hpp"
#include "contact_law.hpp"
#include "ellipsoids.hpp"
#include "fix_heat.hpp"
#include "grain_geometry.hpp"
#include "neighbours.hpp"
#include "time_step_check.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pw85_lammps {

/// Springs, damping and friction at the contacts of ellipsoids that overlap.
class PairGranular final : public LAMMPS_NS::Pair {
  public:
    explicit PairGranular(LAMMPS_NS::LAMMPS *lammps);
    ~PairGranular() override;

    void compute(int eflag, int vflag) override;
    void settings(int narg, char **arg) override;
    void coeff(int narg, char **arg) override;
    void init_style() override;
    double init_one(int i, int j) override;
    int pack_forward_comm(int count, int *atoms, double *buffer, int pbc_flag, int *pbc) override;
    void unpack_forward_comm(int count, int first, double *buffer) override;
    double memory_usage() override;

    /// A contact, seen from atom i.
    struct Touch {
        int i, j;
        Vector arm, normal, force; ///< arm: from the centre to the place where the force acts
        double depth;
        Vector spring; ///< tangential
        double heat;   ///< that flows into atom i in a unit of time
    };

    /// From now on keeps the contacts of each step, for computes.
    void keep_touches() { keeps_touches_ = true; }
    LAMMPS_NS::bigint step_of_touches() const { return step_of_touches_; }
    std::vector<Touch> const &touches() const { return touches_; }

  private:
    static constexpr char granular_style[] = "Pair pw85/granular";

    struct Material {
        ContactLaw law;
        /// true if the force is minus the gradient of the energy, of which R is a part
        bool conserves = false;
        bool is_set = false;
    };

    /// Data of an atom in a step, in two cache lines.
    struct alignas(64) Body {
        Vector x, v, spin; ///< spin: angular velocity
        GrainSearch::Form form;
        /// of the atom, or of the rigid body of which it is a part; of a frozen atom: negative
        double mass;
    };

    /// A pair of ellipsoids that overlap.
    struct Overlap {
        int i, j;
        std::uint32_t entry; ///< of the neighbour list
        std::size_t law;     ///< index in materials_
        bool is_known;       ///< true if the search starts from the normal of the step before
        bool has_touched;    ///< true if they were in contact in the step before
    };

    void allocate();
    void add_history();
    void read_reaches();
    void expect_new_grains();
    void find_gaps();
    double largest_gap(int t, int u) const { return gaps_[material_index(t, u)]; }
    double least_depth(std::size_t l) const;
    void mix(int i, int j);
    [[noreturn]] void refuse_type(int t) const;
    std::size_t material_index(int t, int u) const;
    Material &material(int t, int u) { return materials_[material_index(t, u)]; }
    void add_batch(int eflag);
    void add_pairs(std::size_t count, int eflag);
    void sort_by_law(std::size_t count);
    void start_at_contact_function(std::span<std::size_t const> rows);
    bool nothing_moves() const;
    void read_masses();
    void read_bodies();
    Body const &body(int i) const { return bodies_[static_cast<std::size_t>(i)]; }
    void add_row(std::size_t l);
    bool is_certified(std::size_t l) const;
    void search_anew(std::size_t l);
    void react(std::size_t count);
    void add_pair(std::size_t l, int eflag);
    void add_gradient(std::size_t l, Vector &f, Vector &torque1, Vector &torque2) const;
    void keep_touch(std::size_t l, Vector const &f, double heat);
    /// Not inlined, to leave the code of pairs without heat as it is.
    [[gnu::noinline]] double conduct(std::size_t l);
    void apply(int i, Vector const &push, Vector const &torque);
    [[noreturn]] void refuse_depth(int i, int j) const;

    double cutoff_ = 0.0; ///< of the command; 0: the cutoffs follow from the shapes
    Arms arms_ = Arms::contact;
    std::vector<Material> materials_;
    std::vector<double> reaches_;
    std::vector<double> gaps_; ///< by two types: the largest gap of surfaces in a contact
    double largest_gap_ = 0.0;
    std::vector<bool> used_types_;
    std::optional<Ellipsoids> ellipsoids_;
    BodyMasses masses_;
    bool sends_masses_ = false; ///< true if ghosts get masses, not forms
    std::string history_id_;
    ContactHistory *history_ = nullptr;
    bool turns_ = false;      ///< true if a law resists rolling or twisting
    FixHeat *heat_ = nullptr; ///< if a law conducts heat
    PairBatch batch_;
    std::size_t first_ = 0; ///< the pair of the batch that is the first one of those that have rows

    // The pairs have rows, in which those with the same law follow each other.
    std::array<Overlap, row_capacity> overlaps_{};
    std::array<std::size_t, row_capacity> rows_of_pairs_{}; ///< in the order of the batch
    GrainSearch search_;
    ContactRows rows_{};
    /// owned atoms and ghosts; of those without ellipsoids nothing is known
    std::vector<Body> bodies_;
    double timestep_ = 0.0; ///< for springs: zero while a run is set up
    TimeStepCheck time_step_check_;
    double fastest_ = 0.0; ///< the largest stiffness over mass of the contacts of this step
    bool keeps_touches_ = false;
    LAMMPS_NS::bigint step_of_touches_ = -1;
    std::vector<Touch> touches_;
    int frozen_ = 0; ///< bit of the group of fix freeze
};

} // namespace pw85_lammps

#endif

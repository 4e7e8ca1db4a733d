// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The style `fix ID group pw85/hpmc`: Monte Carlo of hard ellipsoids at constant volume or
/// pressure.
#ifndef PW85_LAMMPS_FIX_HPMC_HPP_INCLUDED
#define PW85_LAMMPS_FIX_HPMC_HPP_INCLUDED

#include "bins.hpp"
#include "checkerboard.hpp"
#include "ellipsoids.hpp"
#include "random.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace pw85_lammps {

class FixWall;
class Words;

/// Moves the ellipsoids of its group by the Metropolis method on a checkerboard (Anderson,
/// Jankowski, Grubb, Engel and Glotzer, J. Comput. Phys. 254, 27, 2013). A sweep shifts all atoms
/// by a random vector, takes the colours of the cells in random order, and moves the atoms of the
/// cells of each colour in the order of their tags. An atom stays in its cell. Atoms of different
/// cells of a colour therefore cannot overlap, and no atom changes its processor. Then it shifts
/// all atoms back. Along a direction that is not periodic, the box is longer by a cell during a
/// sweep: no atom is shifted out of it (Checkerboard::lengthened()).
///
/// The results have the same bits for any number of processors: positions are multiples of a power
/// of two (ExactBox), overlaps are decided exactly, and the random numbers of an atom depend on
/// the seed, the step and its tag.
class FixHpmc final : public LAMMPS_NS::Fix {
  public:
    FixHpmc(LAMMPS_NS::LAMMPS *lammps, int narg, char **arg);

    int setmask() override
    {
        return LAMMPS_NS::FixConst::PRE_EXCHANGE | LAMMPS_NS::FixConst::PRE_NEIGHBOR;
    }
    void init() override;
    void setup_pre_exchange() override;
    void pre_exchange() override;
    void setup_pre_neighbor() override { recover_positions(atom->nlocal + atom->nghost); }
    void pre_neighbor() override { recover_positions(atom->nlocal + atom->nghost); }

    /// Returns values for translations, rotations and changes of the volume: 0, 1, 2: the accepted
    /// fractions of the trials of this run; 3, 4, 5: the numbers of trials; 6, 7, 8: the largest
    /// steps.
    double compute_vector(int k) override;

    void write_restart(FILE *file) override;
    void restart(char *buffer) override;

    int pack_forward_comm(int count, int *atoms, double *buffer, int pbc_flag, int *pbc) override;
    void unpack_forward_comm(int count, int first, double *buffer) override;
    double memory_usage() override;

  private:
    enum Kind { translation, rotation, expansion, num_kinds };
    enum class Scaled { none, all, x, y, z, one_of_three };

    /// An atom that may move in this sweep, in the order of its moves.
    struct Mover {
        std::int64_t cell_index;
        LAMMPS_NS::tagint tag;
        int atom;
        Checkerboard::Cell cell;
    };

    using Counts = std::array<LAMMPS_NS::bigint, num_kinds>;

    void read_keyword(Words &words);
    void find_walls();
    void refuse_other_motion() const;
    void refuse_box() const;
    void refuse_pressure() const;
    bool scales(int k) const;
    bool is_periodic(std::size_t k) const { return domain->periodicity[k] != 0; }
    ExactBox present_box() const;
    void make_positions_exact();
    void recover_positions(int count);
    void make_cells();
    int largest_count(int k) const;
    void require_cells(int k, int largest) const;
    double ghost_distance() const;
    void ensure_ghosts();
    void set_domain(ExactBox const &box);
    ExactBox lengthened(ExactBox box) const;

    void sweep();
    Vector random_shift(Stream &random) const;
    void shift_all(Vector const &shift);
    void lengthen_domain();
    void restore_domain();
    void receive_atoms();
    void find_movers();
    void move_colour(int colour);
    void move(Mover const &mover);
    bool try_translation(Mover const &mover, Stream &random);
    bool try_rotation(Mover const &mover, Stream &random);
    void gather(int i, double distance);
    bool overlaps(int i, double const *center, double const *form);
    bool is_outside(Vector const &center) const;
    bool cuts_walls(int i, double const *center, double const *form) const;
    bool try_volume(Stream &random);
    Vector random_factors(Stream &random) const;
    ExactBox scaled(ExactBox const &box, Vector const &factors) const;
    Vector scale_all(ExactBox const &old);
    bool has_overlaps();
    void build_bins();
    void bound_positions(int count, Vector &lower, Vector &upper) const;
    Vector image_shift(int const *pbc) const;
    void require_no_overlaps();
    void require_room_for(int i) const;
    void require_quaternions();
    void tune(Counts const &tried, Counts const &accepted);
    bool is_sphere(int i) const
    {
        return ellipsoids_.smallest_semi_axis(i) == ellipsoids_.largest_semi_axis(i);
    }
    [[noreturn]] void refuse(std::string const &reason) const;

    int every_ = 1, num_trials_ = 4;
    std::uint32_t seed_ = 0;
    LAMMPS_NS::bigint tuned_until_ = -1;
    std::array<double, num_kinds> largest_step_{0.1, 0.1, 0.01};
    Scaled scaled_ = Scaled::none;
    double pressure_ = 0.0; ///< divided by kT
    Checkerboard::Counts wanted_cells_{};
    std::vector<std::string> wall_ids_;

    Ellipsoids ellipsoids_;
    std::vector<FixWall const *> walls_;
    ExactBox box_{};
    Checkerboard cells_;
    Vector shift_{};        ///< of all atoms, in this sweep
    double diameter_ = 0.0; ///< of the largest bounding sphere
    bool first_sweep_ = true;
    Bins bins_;
    std::array<std::vector<Mover>, Checkerboard::num_colours> movers_;
    std::vector<int> candidates_; ///< atoms that a mover may meet
    /// those of which the bounding spheres intersect that of a trial
    std::vector<std::int32_t> neighbors_;
    Counts tried_{}, accepted_{}; ///< in this run, on this processor
};

} // namespace pw85_lammps

#endif

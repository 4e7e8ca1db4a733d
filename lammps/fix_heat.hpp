// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The style `fix ID group pw85/heat`: the temperatures of grains, which change by the heat that
/// flows through contacts.
#ifndef PW85_LAMMPS_FIX_HEAT_HPP_INCLUDED
#define PW85_LAMMPS_FIX_HEAT_HPP_INCLUDED

#include "host.hpp"
#include "time_step_check.hpp"
#include "words.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace pw85_lammps {

/// Temperatures of all atoms. In each step, contacts add the heat that flows through them, and
/// those of the group change by m c dT/dt = Σ flow, with Euler's method, as with LAMMPS's `fix
/// heat/flow`. Other atoms keep their temperatures.
class FixHeat final : public LAMMPS_NS::Fix {
  public:
    FixHeat(LAMMPS_NS::LAMMPS *lammps, int narg, char **arg);
    ~FixHeat() override;

    /// Returns the fix of a running LAMMPS. If there is none, the run stops with an error of a
    /// style whose law conducts heat. All processors call this together.
    static FixHeat &require(LAMMPS_NS::LAMMPS &lammps, std::string const &style);

    /// Returns the temperature of an owned atom or a ghost, while forces are computed.
    double temperature(int i) const { return temperatures_[index(i)]; }

    /// Adds the heat that flows into an owned atom, or into a ghost if newton is on.
    ///
    /// @param conductance the flow over the difference of temperatures
    void add(int i, double flow, double conductance)
    {
        flows_[index(i)].heat += flow;
        flows_[index(i)].conductance += conductance;
    }

    int setmask() override;
    void init() override;
    void setup_pre_force(int vflag) override { pre_force(vflag); }
    void min_pre_force(int vflag) override { pre_force(vflag); }
    void pre_force(int vflag) override;
    void final_integrate() override;
    void reset_dt() override {}

    /// Returns the heat of the group, Σ m c T.
    double compute_scalar() override;

    void grow_arrays(int nmax) override;
    void copy_arrays(int from, int to, int) override
    {
        temperatures_[index(to)] = temperatures_[index(from)];
    }
    void set_arrays(int i) override { temperatures_[index(i)] = initial_; }
    int pack_exchange(int i, double *buffer) override;
    int unpack_exchange(int i, double *buffer) override;
    int pack_restart(int i, double *buffer) override;
    void unpack_restart(int i, int which) override;
    int size_restart(int) override { return 2; }
    int maxsize_restart() override { return 2; }
    int pack_forward_comm(int count, int *atoms, double *buffer, int pbc_flag, int *pbc) override;
    void unpack_forward_comm(int count, int first, double *buffer) override;
    int pack_reverse_comm(int count, int first, double *buffer) override;
    void unpack_reverse_comm(int count, int *atoms, double *buffer) override;
    double memory_usage() override;

  private:
    struct Flow {
        double heat, conductance;
    };

    static std::size_t index(int i) { return static_cast<std::size_t>(i); }
    void parse_capacities(Words &words);
    void start_from(Words &words);
    double heat_capacity(int i) const
    {
        return capacities_[index(atom->type[i]) - 1] * atom->rmass[i];
    }

    std::vector<double> capacities_; ///< by type, of a unit of mass
    double initial_ = 0.0;           ///< temperature of atoms that are added
    std::vector<double> temperatures_;
    std::vector<Flow> flows_; ///< of a step
    TimeStepCheck time_step_check_;
};

} // namespace pw85_lammps

#endif

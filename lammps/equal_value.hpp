// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Numbers of a command that may be variables.
#ifndef PW85_LAMMPS_EQUAL_VALUE_HPP_INCLUDED
#define PW85_LAMMPS_EQUAL_VALUE_HPP_INCLUDED

#include "words.hpp"

#include <lammps/variable.h>

#include <string>

namespace pw85_lammps {

/// A number, or an equal-style variable `v_NAME`, whose value may change from step to step. NULL is
/// the number zero.
class EqualValue {
  public:
    static EqualValue parse(Words &words, std::string const &what)
    {
        EqualValue value;
        if (words.starts_with("v_")) {
            value.name_ = words.word(what).substr(2);
        } else if (!words.skip("NULL")) {
            value.number_ = words.coordinate(what);
        }
        return value;
    }

    /// Returns the number, if this is not a variable.
    double number() const { return number_; }

    bool is_variable() const { return !name_.empty(); }

    /// Returns the present value. All processors call this together.
    double read(LAMMPS_NS::LAMMPS &lammps, std::string const &style) const
    {
        if (!is_variable()) return number_;
        LAMMPS_NS::Variable &variables = *lammps.input->variable;
        int const index = variables.find(name_.c_str());
        if (index < 0 || !variables.equalstyle(index))
            stop_all(*lammps.error, style + ": there is no equal-style variable " + name_ +
                                        ": define it before the run (variable " + name_ +
                                        " equal ...)");
        return variables.compute_equal(index);
    }

  private:
    std::string name_;
    double number_ = 0.0;
};

} // namespace pw85_lammps

#endif

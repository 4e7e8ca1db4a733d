// SPDX-License-Identifier: BSD-3-Clause
// A unit that includes the headers and calls nothing does not compile the solver: only templates
// call it. So this unit compiles although the solver for doubles is deleted. (The functions of
// pw85/linked.hpp would call the library instead.)
#include <pw85/contact/solver.hpp>

namespace pw85::detail {

template <> Maximum<double> maximize(Pair<double, 2> const &) noexcept = delete;
template <> Maximum<double> maximize(Pair<double, 3> const &) noexcept = delete;

} // namespace pw85::detail

#include <pw85/batch.hpp>
#include <pw85/enclosing.hpp>
#include <pw85/pw85.hpp>
#include <pw85/simulation.hpp>
#include <pw85/systems.hpp>

// SPDX-License-Identifier: BSD-3-Clause
// Reads the reference data (data/README.md). Only reference_data.cpp uses HDF5.
#ifndef PW85_TESTS_REFERENCE_DATA_HPP_INCLUDED
#define PW85_TESTS_REFERENCE_DATA_HPP_INCLUDED

#include <cstddef>
#include <string>
#include <vector>

#include "sample.hpp"

namespace pw85_tests {

/// f on the grid of spheroids × spheroids × directions × lambdas.
struct SpheroidGrid {
    std::vector<double> radii, lambdas;
    std::vector<Vector3> directions;
    std::vector<Form3> spheroids;
    std::vector<double> f;

    double f_at(std::size_t spheroid1, std::size_t spheroid2, std::size_t direction,
                std::size_t lambda) const
    {
        return f[((spheroid1 * spheroids.size() + spheroid2) * directions.size() + direction) *
                     lambdas.size() +
                 lambda];
    }
};

/// A pair with its contact function.
struct ContactProblem {
    Sample<double, 3> pair;
    double mu2, mu2_minus_1, lambda, cond;
    std::string const *category;
};

/// Path of the file.
char const *reference_data_path();

/// Read at the first call, which must come from one thread; the process ends if the file cannot be
/// read.
SpheroidGrid const &spheroid_grid();

/// Calls visit(sample, λ, f) for all of /F, without so many λ at each end.
template <class Visit> void for_all_of_f(Visit const &visit, std::size_t ends = 0)
{
    auto const &grid = spheroid_grid();
    for (std::size_t i = 0; i < grid.spheroids.size(); ++i)
        for (std::size_t j = 0; j < grid.spheroids.size(); ++j)
            for (std::size_t k = 0; k < grid.directions.size(); ++k)
                for (std::size_t l = ends; l + ends < grid.lambdas.size(); ++l)
                    visit(
                        Sample<double, 3>{grid.directions[k], grid.spheroids[i], grid.spheroids[j]},
                        grid.lambdas[l], grid.f_at(i, j, k, l));
}

std::vector<ContactProblem> const &contact_problems();

} // namespace pw85_tests

#endif

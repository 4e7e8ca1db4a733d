// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What rounding errors change beyond first order.
#ifndef PW85_TESTS_BOUNDS_SECOND_ORDER_HPP_INCLUDED
#define PW85_TESTS_BOUNDS_SECOND_ORDER_HPP_INCLUDED

#include <algorithm>

#include "formulas.hpp"

namespace pw85_bounds {

/// A formula without quotients is a sum of products of inputs and of factors (1 + δ_k).
struct Monomials {
    double magnitude; ///< a bound on the sum of their magnitudes
    int roundings;    ///< the largest number of factors of one
};

inline Monomials monomials(Node const &node, Monomials const &left, Monomials const &right)
{
    int const one = node.rounded ? 1 : 0;
    switch (node.operation) {
    case Operation::product:
        return {left.magnitude * right.magnitude, left.roundings + right.roundings + one};
    case Operation::negation:
        return left;
    default:
        return {left.magnitude + right.magnitude, std::max(left.roundings, right.roundings) + one};
    }
}

/// Those of each node, where no coordinate of r exceeds `length`, and no other input one. Entries
/// of the forms count half: of Q1 and Q2 only the sums |Q1_ij| + t |Q2_ij| occur, which are at
/// most 1.
inline std::vector<Monomials> monomials(Graph const &graph, double length)
{
    std::vector<Monomials> found;
    for (auto const &node : graph) {
        if (node.operation == Operation::input)
            found.push_back({node.name[0] == 'r' ? length : node.name[0] == 'q' ? 0.5 : 1.0, 0});
        else if (node.operation == Operation::constant)
            found.push_back({std::fabs(node.value), 0});
        else
            found.push_back(monomials(
                node, found[static_cast<std::size_t>(node.left)],
                found[static_cast<std::size_t>(node.right < 0 ? node.left : node.right)]));
    }
    return found;
}

/// A bound on the change beyond first order, in units of u. A product of n factors changes by (1 +
/// u)^n - 1 - n u at most, which is below (n u)² for n u < 1.
inline double beyond_first_order(Formula const &formula, double length, double u)
{
    auto const found = monomials(formula.graph, length);
    double sum = 0.0;
    for (int const result : formula.results) {
        auto const &m = found[static_cast<std::size_t>(result)];
        sum += m.magnitude * m.roundings * m.roundings * u;
    }
    return sum;
}

} // namespace pw85_bounds

#endif

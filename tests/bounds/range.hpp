// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The range of the numbers of a formula, for doubles that pass the fast checks of the overlap
/// test.
#ifndef PW85_TESTS_BOUNDS_RANGE_HPP_INCLUDED
#define PW85_TESTS_BOUNDS_RANGE_HPP_INCLUDED

#include <algorithm>

#include "formulas.hpp"

namespace pw85_bounds {

/// What a formula makes of bounds on its inputs.
struct Range {
    double largest; ///< a bound on all results
    double
        /// how much the results that underflow change the formula, if each errs by half of the
        /// smallest number
        underflow;
};

/// Bounds on the magnitudes of all nodes, for entries of forms and of r below `entry`, and t up to
/// `t`.
inline std::vector<double> magnitudes(Graph const &graph, double entry, double t)
{
    std::vector<double> found;
    for (auto const &node : graph) {
        double const x = node.left < 0 ? 0.0 : found[static_cast<std::size_t>(node.left)];
        double const y = node.right < 0 ? 0.0 : found[static_cast<std::size_t>(node.right)];
        if (node.operation == Operation::input)
            found.push_back(node.name == "t" ? t : node.name == "ratio" ? 1.0 : entry);
        else if (node.operation == Operation::constant)
            found.push_back(std::fabs(node.value));
        else
            found.push_back(node.operation == Operation::product ? x * y : x + y);
    }
    return found;
}

/// The range of a formula without quotients. Sums do not underflow.
inline Range range_of(Formula const &formula, double entry, double t)
{
    auto const &graph = formula.graph;
    auto const sizes = magnitudes(graph, entry, t);
    std::vector<double> slopes(graph.size(), 0.0);
    slopes[static_cast<std::size_t>(formula.results[0])] = 1.0;
    Range range{*std::max_element(sizes.begin(), sizes.end()), 0.0};
    for (std::size_t k = graph.size(); k-- > 0;) {
        Node const &node = graph[k];
        bool const product = node.operation == Operation::product;
        if (product) range.underflow += slopes[k] * 0x1p-1074;
        if (node.left < 0) continue;
        auto const left = static_cast<std::size_t>(node.left);
        auto const right = static_cast<std::size_t>(node.right < 0 ? node.left : node.right);
        slopes[left] += slopes[k] * (product ? sizes[right] : 1.0);
        if (node.right >= 0) slopes[right] += slopes[k] * (product ? sizes[left] : 1.0);
    }
    return range;
}

} // namespace pw85_bounds

#endif

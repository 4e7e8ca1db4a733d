// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The graphs of the virial coefficients. All of them are enumerated, so that no table of diagrams
/// is typed.
#ifndef PW85_REFERENCE_GRAPHS_HPP_INCLUDED
#define PW85_REFERENCE_GRAPHS_HPP_INCLUDED

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace virial {

/// A graph of labelled vertices: the set of its edges, one bit each.
using Graph = std::uint32_t;

/// The edge between two different vertices.
constexpr Graph edge(int i, int j)
{
    return i < j ? Graph{1} << (j * (j - 1) / 2 + i) : edge(j, i);
}

constexpr std::size_t number_of_graphs(int vertices)
{
    return std::size_t{1} << (vertices * (vertices - 1) / 2);
}

/// Whether a set of vertices, one bit each, is connected by the edges between them.
constexpr bool is_connected(Graph graph, unsigned vertices)
{
    unsigned reached = vertices & (~vertices + 1), before = 0; // the first vertex
    while (reached != before) {
        before = reached;
        for (int j = 1; vertices >> j != 0; ++j)
            for (int i = 0; i < j; ++i)
                if (unsigned const pair = 1u << i | 1u << j;
                    (graph & edge(i, j)) && (reached & pair) && (vertices & pair) == pair)
                    reached |= pair;
    }
    return reached == vertices;
}

/// Whether a graph of n vertices is connected, and stays so without any one of them.
constexpr bool is_biconnected(Graph graph, int n)
{
    unsigned const all = (1u << n) - 1;
    bool connected = is_connected(graph, all);
    for (int i = 0; i < n; ++i) connected = connected && is_connected(graph, all & ~(1u << i));
    return connected;
}

constexpr bool is_tree(Graph graph, int n)
{
    return std::popcount(graph) == n - 1 && is_connected(graph, (1u << n) - 1);
}

/// For each graph of n vertices, the sum of the `number` of all graphs that have no other edges
/// than it.
template <class Number> std::vector<int> sums_over_subgraphs(int n, Number number)
{
    std::vector<int> sums(number_of_graphs(n));
    for (Graph graph = 0; graph < sums.size(); ++graph) sums[graph] = number(graph);
    for (Graph bit = 1; bit < sums.size(); bit *= 2)
        for (Graph graph = 0; graph < sums.size(); ++graph)
            if (graph & bit) sums[graph] += sums[graph & ~bit];
    return sums;
}

/// The sum of ∏ f over all biconnected graphs, for n hard particles whose overlaps are a graph: f
/// is -1 for two particles that overlap and 0 for others. Ree and Hoover's diagrams are the graphs
/// for which this is not 0.
inline std::vector<int> mayer_sums(int n)
{
    return sums_over_subgraphs(n, [n](Graph graph) {
        int const product = std::popcount(graph) % 2 == 0 ? 1 : -1;
        return is_biconnected(graph, n) ? product : 0;
    });
}

/// How often a graph is sampled, relative to other trees: 0 unless it is a tree. Most biconnected
/// graphs contain chains, and samples of chains alone have half the variance for six particles. The
/// other trees are there for the graphs without a chain: six particles have such a graph, in which
/// each of two vertices has edges to the four others.
constexpr int weight_of_tree(Graph graph, int n)
{
    if (!is_tree(graph, n)) return 0;
    for (int i = 0; i < n; ++i) {
        int degree = 0;
        for (int j = 0; j < n; ++j) degree += i != j && (graph & edge(i, j));
        if (degree > 2) return 1;
    }
    return 50;
}

/// The sum of the weights of all trees that each graph contains.
inline std::vector<int> tree_sums(int n)
{
    return sums_over_subgraphs(n, [n](Graph graph) { return weight_of_tree(graph, n); });
}

/// The edges of a tree, from a vertex that is reached to a new one, beginning with vertex 0.
using Branches = std::vector<std::pair<int, int>>;

/// The branches of a tree of n vertices.
inline Branches branches_of(Graph tree, int n)
{
    Branches branches;
    std::vector<int> reached = {0};
    unsigned seen = 1;
    for (std::size_t k = 0; k < reached.size(); ++k)
        for (int i = reached[k], j = 1; j < n; ++j)
            if (!(seen >> j & 1) && (tree & edge(i, j))) {
                seen |= 1u << j;
                branches.emplace_back(i, j);
                reached.push_back(j);
            }
    return branches;
}

/// All trees of n labelled vertices, each as many times as its weight.
inline std::vector<Branches> weighted_trees(int n)
{
    std::vector<Branches> trees;
    for (Graph graph = 0; graph < number_of_graphs(n); ++graph)
        trees.insert(trees.end(), static_cast<std::size_t>(weight_of_tree(graph, n)),
                     branches_of(graph, n));
    return trees;
}

} // namespace virial

#endif

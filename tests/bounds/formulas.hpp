// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The formulas whose rounding errors the library bounds, as graphs: the templates of the library
/// on recorded numbers.
#ifndef PW85_TESTS_BOUNDS_FORMULAS_HPP_INCLUDED
#define PW85_TESTS_BOUNDS_FORMULAS_HPP_INCLUDED

#include "recorded.hpp"

namespace pw85_bounds {

using namespace pw85::detail;

/// The name of a vector or matrix, with indices.
inline std::string entry_name(std::string name, std::initializer_list<int> indices)
{
    for (int const index : indices) name.push_back(static_cast<char>('0' + index));
    return name;
}

/// The inputs of a formula, by their names in the order of the entries. The values are those of an
/// ordinary pair.
template <int D> struct Inputs {
    static pw85::Vector<Recorded, D> vector(char const *name)
    {
        pw85::Vector<Recorded, D> x;
        for (int i = 0; i < D; ++i) x[i] = Recorded::input(entry_name(name, {i}), 1.0 + 0.25 * i);
        return x;
    }

    static pw85::SymmetricMatrix<Recorded, D> matrix(char const *name)
    {
        pw85::SymmetricMatrix<Recorded, D> a;
        for (int i = 0; i < D; ++i)
            for (int j = i; j < D; ++j)
                a(i, j) = Recorded::input(entry_name(name, {i, j}), i == j ? 1.0 : 0.1);
        return a;
    }

    Pair<Recorded, D> pair{vector("r"), matrix("q1"), matrix("q2"),
                           Recorded::input("ratio", 1.0, true)};
    Recorded t = Recorded::input("t", 0.75);
};

/// The exact difference of the two sides of a comparison, the last one where several are joined.
inline int difference_of_sides(Comparison const &c)
{
    return append({Operation::difference,
                   c.sides.back().first,
                   c.sides.back().second,
                   0.0,
                   false,
                   false,
                   {}});
}

template <std::size_t D> std::vector<int> nodes_of(Recorded const (&x)[D])
{
    std::vector<int> nodes;
    for (auto const &coordinate : x) nodes.push_back(coordinate.node());
    return nodes;
}

template <int D> std::vector<int> apart()
{
    Inputs<D> const in;
    return {difference_of_sides(shows_apart(evaluate_quartic(in.pair, in.t), in.t))};
}

template <int D> std::vector<int> inside1()
{
    Inputs<D> const in;
    return {difference_of_sides(shows_inside1(evaluate_quartic(in.pair, in.t), in.t))};
}

template <int D> std::vector<int> inside2()
{
    Inputs<D> const in;
    return {difference_of_sides(shows_inside2(evaluate_quartic(in.pair, in.t), in.t))};
}

/// What evaluate_quartic() computes before the form: adj(M) r, and det M.
template <int D> std::vector<int> solution()
{
    Inputs<D> const in;
    auto const found = solve_by_adjugate(blend(in.pair.q1, in.t, in.pair.q2), in.pair.r12);
    auto nodes = nodes_of(found.s.coordinates);
    nodes.push_back(found.determinant.node());
    return nodes;
}

template <int D> std::vector<int> determinant_of_blend() { return {solution<D>().back()}; }

/// a of the quartic.
template <int D> std::vector<int> separation()
{
    Inputs<D> const in;
    return {evaluate_quartic(in.pair, in.t).a.node()};
}

/// a of the quartic, from an exact adj(M) r.
template <int D> std::vector<int> product_with_separation()
{
    Inputs<D> const in;
    return {dot(in.pair.r12, Inputs<D>::vector("s")).node()};
}

/// The form of the quartic, from an exact adj(M) r.
template <int D> std::vector<int> form_of_solution()
{
    Inputs<D> const in;
    return {quadratic_form(in.pair.q2, Inputs<D>::vector("s")).node()};
}

/// The exact values of a quartic.
inline QuarticEvaluation<Recorded> exact_quartic()
{
    return {Recorded::input("b", 1.0), Recorded::input("a", 1.0), Recorded::input("form", 1.0),
            Recorded::input("diagonal", 1.0)};
}

inline std::vector<int> last_steps_inside1()
{
    return {difference_of_sides(shows_inside1(exact_quartic(), Recorded::input("t", 0.75)))};
}

inline std::vector<int> last_steps_inside2()
{
    return {difference_of_sides(shows_inside2(exact_quartic(), Recorded::input("t", 0.75)))};
}

template <int D> std::vector<int> adjugate_solution()
{
    Inputs<D> const in;
    return nodes_of(
        solve_by_adjugate(blend(in.pair.q1, in.t, in.pair.q2), in.pair.r12).s.coordinates);
}

/// a and b from the coefficients of the rational form.
template <int D> std::vector<int> rational_a()
{
    Inputs<D> const in;
    return {evaluate_a(rational_form(in.pair), in.t).node()};
}

template <int D> std::vector<int> rational_b()
{
    Inputs<D> const in;
    return {evaluate_b(rational_form(in.pair), in.t).node()};
}

template <int D> auto factorized(Inputs<D> const &in)
{
    return factorize(blend(in.pair.q1, in.t, in.pair.q2), Recorded(unit_roundoff<Recorded>()));
}

template <int D> std::vector<int> factorized_solution()
{
    Inputs<D> const in;
    return nodes_of(solve(factorized(in), in.pair.r12).coordinates);
}

/// What refine() adds to a solution, from a residual that is rounded once: here the sum of r and
/// `rest`, which is 0.
template <int D> std::vector<int> correction()
{
    Inputs<D> const in;
    pw85::Vector<Recorded, D> const rest = Inputs<D>::vector("rest");
    return nodes_of(solve(factorized(in), in.pair.r12 + rest).coordinates);
}

/// μ² of an exact s, as both last_evaluation() compute it: `k` and `k2` guide the step, which is 0
/// at the maximum.
template <int D> std::vector<int> value()
{
    Inputs<D> const in;
    pw85::Vector<Recorded, D> const s = Inputs<D>::vector("s");
    auto const weights = outer_weights(s);
    Candidate<Recorded> const candidate{in.t, Recorded::input("k", 1.0),
                                        Recorded::input("k2", 0.0)};
    return {stationary_value(candidate, in.pair.ratio, quadratic_form(in.pair.q1, weights),
                             quadratic_form(in.pair.q2, weights), dot(in.pair.r12, s))
                .mu2.node()};
}

/// The determinant that is_clearly_definite() compares with its margin.
template <int D> std::vector<int> definite()
{
    return {difference_of_sides(is_clearly_definite(Inputs<D>::matrix("m")))};
}

template <int D> std::vector<int> pivots()
{
    auto const f = factorize(Inputs<D>::matrix("m"), Recorded(unit_roundoff<Recorded>()));
    return nodes_of(f.pivots);
}

/// The difference g, and both sides of the other comparison of exceeds().
inline std::vector<int> exceeded()
{
    auto const input = [](char const *name) { return Recorded::input(name, 1.0); };
    auto const sides = exceeds(input("q1"), input("q2"), input("r")).sides;
    return {sides[0].second, sides[1].first, sides[1].second};
}

/// The bounds on nᵀQ1n, nᵀQ2n and n·r that shows_outside() gives to exceeds(). Each is a value with
/// its margin.
template <int D> std::vector<int> bounds_of_outside()
{
    auto const sides = shows_outside(Inputs<D>().pair, Inputs<D>::vector("n")).sides;
    auto const node = [](int k) -> Node const & {
        return (*recording)[static_cast<std::size_t>(k)];
    };
    Node const &g = node(sides[0].second), &reach = node(g.right);
    return {node(g.left).right, reach.left, node(reach.right).left};
}

/// An entry of K(w) on the diagonal, and another one.
template <int D> std::vector<int> inner_entries()
{
    auto const k = inner_matrices(Inputs<D>().pair, Recorded::input("w", 0.75));
    return {first_of(k(0, 0)).node(), first_of(k(0, 1)).node()};
}

/// A formula, and the nodes of its results.
struct Formula {
    Graph graph;
    std::vector<int> results;
};

/// Without the nodes that no result depends on.
inline Formula pruned(Formula const &formula)
{
    auto const size = formula.graph.size();
    std::vector<bool> used(size, false);
    for (int const result : formula.results) used[static_cast<std::size_t>(result)] = true;
    for (auto k = size; k-- > 0;)
        for (int const operand : {formula.graph[k].left, formula.graph[k].right})
            if (used[k] && operand >= 0) used[static_cast<std::size_t>(operand)] = true;
    std::vector<int> place(size, -1);
    auto const moved = [&](int k) { return k < 0 ? -1 : place[static_cast<std::size_t>(k)]; };
    Formula kept;
    for (std::size_t k = 0; k < size; ++k)
        if (used[k]) {
            Node node = formula.graph[k];
            node.left = moved(node.left), node.right = moved(node.right);
            place[k] = static_cast<int>(kept.graph.size());
            kept.graph.push_back(node);
        }
    for (int const result : formula.results) kept.results.push_back(moved(result));
    return kept;
}

inline Formula record(std::vector<int> (*run)())
{
    Formula formula;
    recording = &formula.graph;
    formula.results = run();
    recording = nullptr;
    return pruned(formula);
}

} // namespace pw85_bounds

#endif

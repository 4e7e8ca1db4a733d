// SPDX-License-Identifier: BSD-3-Clause
// Prints the formulas of formulas.hpp as graphs, for scripts/rounding_bounds.py: a line for each
// node, with the numbers of its operands, in the order of the arithmetic. A line "= name dimensions
// constant" begins a formula, with the constant of the headers that bounds its errors; a line ">"
// names its results.
#include <cstdio>

#include "formulas.hpp"

namespace {

using namespace pw85_bounds;

void print(Node const &node)
{
    char const *mark = node.rounded ? "rounded" : "exact";
    switch (node.operation) {
    case Operation::input:
        std::printf("input %s\n", node.name.c_str());
        break;
    case Operation::constant:
        std::printf("constant %.17g\n", node.value);
        break;
    case Operation::sum:
        std::printf("+ %d %d %s\n", node.left, node.right, mark);
        break;
    case Operation::difference:
        std::printf("- %d %d %s\n", node.left, node.right, mark);
        break;
    case Operation::product:
        std::printf("* %d %d %s\n", node.left, node.right, mark);
        break;
    case Operation::quotient:
        std::printf("/ %d %d %s\n", node.left, node.right, mark);
        break;
    case Operation::negation:
        std::printf("negation %d\n", node.left);
        break;
    }
}

void print(char const *name, int dimensions, int constant, std::vector<int> (*run)())
{
    Formula const formula = record(run);
    std::printf("= %s %d %d\n", name, dimensions, constant);
    for (auto const &node : formula.graph) print(node);
    std::printf(">");
    for (int const result : formula.results) std::printf(" %d", result);
    std::printf("\n");
}

template <int D> void print_all()
{
    namespace d = pw85::detail;
    print("apart", D, d::apart_margin, apart<D>);
    print("inside1", D, d::inside1_margin, inside1<D>);
    print("inside2", D, d::inside2_margin, inside2<D>);
    print("separation", D, d::least_conditioning, separation<D>);
    print("adjugate_solution", D, d::adjugate_error, adjugate_solution<D>);
    print("factorized_solution", D, d::factorization_error, factorized_solution<D>);
    print("correction", D, d::correction_error, correction<D>);
    print("value", D, d::value_margin, value<D>);
    print("definite", D, d::definite_margin<D>, definite<D>);
    print("pivots", D, d::definite_margin<D>, pivots<D>);
}

} // namespace

int main()
{
    print_all<2>();
    print_all<3>();
}

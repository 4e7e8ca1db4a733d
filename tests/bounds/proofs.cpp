// Proves bounds on rounding errors that the comments of the headers name as theorems. An argument names one of them:
//
//     proofs apart
//
// Each proof is for all pairs, with and without fused operations, and for every type with u <= 2^-24, float included. The
// hypothesis is that each rounded result errs by a fraction of at most u, so that nothing over- or underflows
// (docs/implementation.rst). The bound on terms of first order comes from branch_and_bound.hpp, that on the others from
// second_order.hpp. A share of 2^-10 of each constant is left for terms beyond first order. One quarter of it is for those of the
// formula. The others are smaller: the rounding errors of the products with the constant, 25 u of it, and in `adjugate` the error
// of d, at most 20 u where d > 13 √u (is_certain()).
#include <cstdio>
#include <cstring>

#include "branch_and_bound.hpp"
#include "coefficients.hpp"
#include "second_order.hpp"
#include "worst_case.hpp"

namespace {

using namespace pw85_bounds;

constexpr double largest_u = 0x1p-24, share_beyond = 0x1p-10;

/// Whether a formula errs by less than constant·u.
template <int D, int N>
bool holds(char const *what, std::vector<int> (*run)(), Question const &question, double constant)
{
    Formula const formula = record(run);
    double const beyond = question.factor * beyond_first_order(formula, std::sqrt(question.square), largest_u);
    WorstCase<D, N> worst(formula, question);
    auto const proof = prove<N>(worst, UnitPair<D, N>::ranges, constant * (1.0 - share_beyond), 40000000);
    bool const small = beyond <= 0.25 * share_beyond * constant;
    std::printf("%s, D = %d: %s %g u; %ld boxes, largest value seen %.2f; beyond first order %.1e\n", what, D,
                proof.proved && small ? "proved" : "NOT PROVED", constant, proof.boxes, proof.largest, beyond);
    return proof.proved && small;
}

/// shows_apart(): (t a - (1 + t) b)/((1 + t) P) errs by less than apart_margin u if f <= 1. For pairs that differ in the length of
/// r alone, the error is at most (1 - f) times that at r = 0 and f times that at f = 1, since each of its terms is affine in f.
/// With t = 1, f = |w|²/2.
bool prove_apart()
{
    bool const two = holds<2, 1>("apart, f = 0", apart<2>, {0.0, 0.5}, apart_margin) &&
                     holds<2, 2>("apart, f = 1", apart<2>, {2.0, 0.5}, apart_margin);
    return two && holds<3, 3>("apart, f = 0", apart<3>, {0.0, 0.5}, apart_margin) &&
           holds<3, 5>("apart, f = 1", apart<3>, {2.0, 0.5}, apart_margin);
}

/// is_well_conditioned(): a errs by less than 5 % where det M = least_conditioning u P, since a = det M |w|².
bool prove_separation()
{
    double const bound = 0.05 * least_conditioning;
    return holds<2, 2>("separation", separation<2>, {1.0, 1.0}, bound) &&
           holds<3, 5>("separation", separation<3>, {1.0, 1.0}, bound);
}

/// last_evaluation() by the adjugate: s errs across its direction, in the norm of M, by less than adjugate_error u/d of itself.
bool prove_adjugate()
{
    return holds<2, 2>("adjugate", adjugate_solution<2>, {1.0, 1.0}, adjugate_error) &&
           holds<3, 5>("adjugate", adjugate_solution<3>, {1.0, 1.0}, adjugate_error);
}

/// is_clearly_definite(): the determinant errs by less than definite_margin u P.
bool prove_definite()
{
    return holds<2, 1>("definite", definite<2>, {0.0, 1.0}, definite_margin<2>) &&
           holds<3, 3>("definite", definite<3>, {0.0, 1.0}, definite_margin<3>);
}

/// The number of rounded results that a node depends on, without those that its operands `stops` depend on.
int roundings_from(Graph const &graph, int from, std::vector<int> const &stops)
{
    std::vector<bool> reached(graph.size(), false);
    reached[static_cast<std::size_t>(from)] = true;
    int count = 0;
    for (int k = from; k >= 0; --k) {
        Node const &node = graph[static_cast<std::size_t>(k)];
        bool const stop = std::find(stops.begin(), stops.end(), k) != stops.end();
        if (!reached[static_cast<std::size_t>(k)] || stop) continue;
        count += node.rounded ? 1 : 0;
        for (int const operand : {node.left, node.right})
            if (operand >= 0) reached[static_cast<std::size_t>(operand)] = true;
    }
    return count;
}

/// The error of μ² = λ (rᵀs)²/(A + tB), in units of u μ²: with F the sum of magnitudes of the terms of A + tB and G that of rᵀs,
/// both over rᵀs, cond = F + 2G. The error is at most n F + 2 m G + k, with n and m the roundings of a term and k those of what
/// follows, each of which counts once. To k come 2 that is_certain() admits and 1 for the comparison. As F and G are at least 1,
/// the error over cond is largest where both are 1, or where one of them is large. The share of the last step, ½ f' x, errs by x
/// times n F at most, where x <= 2^-8 (final_step()).
template <int D> bool value_holds()
{
    Formula const formula = record(value<D>);
    Graph const &graph = formula.graph;
    Node const &sum = graph[static_cast<std::size_t>(formula.results[0])]; // with the share of the last step
    Node const &product = graph[static_cast<std::size_t>(sum.left)];
    Node const &quotient = graph[static_cast<std::size_t>(product.right)];
    auto const found = monomials(graph, 1.0);
    double const n = found[static_cast<std::size_t>(quotient.right)].roundings;
    double const m = found[static_cast<std::size_t>(quotient.left)].roundings;
    double const k = 1 + roundings_from(graph, sum.left, {quotient.left, quotient.right}) + 3;
    double const worst = std::max({(n + 2.0 * m + k) / 3.0, n, m}) + n * 0x1p-8;
    bool const proved = quotient.operation == Operation::quotient && worst <= value_margin * (1.0 - share_beyond);
    std::printf("value, D = %d: %s %d u cond; %.2f\n", D, proved ? "proved" : "NOT PROVED", value_margin, worst);
    return proved;
}

bool prove_value()
{
    bool const two = value_holds<2>();
    return value_holds<3>() && two;
}

struct Theorem {
    char const *name;
    bool (*prove)();
};

constexpr Theorem theorems[] = {
    {"apart", prove_apart},       {"separation", prove_separation}, {"adjugate", prove_adjugate},
    {"definite", prove_definite}, {"value", prove_value},           {"coefficients", prove_coefficients},
};

} // namespace

int main(int argc, char **argv)
{
    bool all = true;
    int tried = 0;
    for (auto const &theorem : theorems)
        if (argc < 2 || std::strcmp(argv[1], theorem.name) == 0) {
            all = theorem.prove() && all;
            ++tried;
        }
    return all && tried > 0 ? 0 : 1;
}

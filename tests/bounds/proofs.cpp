// SPDX-License-Identifier: BSD-3-Clause
// Proves bounds on rounding errors that the comments of the headers name as theorems. Arguments may
// name some of them:
//
//     proofs prove [apart ...]      proves them
//     proofs recall [apart ...]     the same, but looks up long proofs in PW85_PROOFS, the record
//                                   of what was proved
//
// Each proof is for all pairs, with and without fused operations, and for every type with u <=
// 2^-24, float included. The hypothesis is that each rounded result errs by a fraction of at most
// u, so that nothing over- or underflows. For doubles the theorem `range` shows it from the
// conditions of passes_fast_checks(). The bound on terms of first order comes from
// branch_and_bound.hpp, that on the others from second_order.hpp. A share of 2^-10 of each constant
// is left for terms beyond first order. One quarter of it is for those of the formula. The others
// are smaller: the rounding errors of the products with the constant, 25 u of it, and in `adjugate`
// the error of d, at most 20 u where d > 13 √u (is_certified()). Where terms of second order are
// divided by d, they are bounded apart.
#include <cstdio>
#include <cstring>

#include "backward.hpp"
#include "branch_and_bound.hpp"
#include "coefficients.hpp"
#include "inside.hpp"
#include "range.hpp"
#include "record.hpp"

namespace {

using namespace pw85_bounds;

constexpr double largest_u = 0x1p-24, share_beyond = 0x1p-10;

/// The record of the proofs, and how main() is asked to use it.
Record &on_record(Record::Use use = Record::Use::recall)
{
    static Record record(use, PW85_PROOFS);
    return record;
}

std::string name_of(char const *what, int dimensions)
{
    return what + (", D = " + std::to_string(dimensions));
}

/// Whether a formula errs by less than constant·u.
template <int D, int N>
bool holds(char const *what, std::vector<int> (*run)(), Question const &question, double constant)
{
    Formula const formula = record(run);
    double const beyond =
        question.factor * beyond_first_order(formula, std::sqrt(question.square), largest_u);
    WorstCase<D, N> worst(formula, question);
    auto const proof = on_record().settle<N>(name_of(what, D), worst, UnitPair<D, N>::ranges,
                                             constant * (1.0 - share_beyond), 40000000);
    bool const small = beyond <= 0.25 * share_beyond * constant;
    std::printf(
        "%s, D = %d: %s %g u; %ld boxes, largest value seen %.2f; beyond first order %.1e\n", what,
        D, proof.proved && small ? "proved" : "NOT PROVED", constant, proof.boxes, proof.largest,
        beyond);
    return proof.proved && small;
}

/// shows_apart(): (t a - (1 + t) b)/((1 + t) P) errs by less than apart_margin u if f <= 1. For
/// pairs that differ in the length of r alone, the error is at most (1 - f) times that at r = 0 and
/// f times that at f = 1, since each of its terms is affine in f. With t = 1, f = |w|²/2.
bool prove_apart()
{
    bool const two = holds<2, 1>("apart, f = 0", apart<2>, {0.0, 0.5}, apart_margin) &&
                     holds<2, 2>("apart, f = 1", apart<2>, {2.0, 0.5}, apart_margin);
    return two && holds<3, 3>("apart, f = 0", apart<3>, {0.0, 0.5}, apart_margin) &&
           holds<3, 5>("apart, f = 1", apart<3>, {2.0, 0.5}, apart_margin);
}

/// is_well_conditioned(): a errs by less than 5 % where det M = least_conditioning u P, since a =
/// det M |w|².
bool prove_separation()
{
    double const bound = 0.05 * least_conditioning;
    return holds<2, 2>("separation", separation<2>, {1.0, 1.0}, bound) &&
           holds<3, 5>("separation", separation<3>, {1.0, 1.0}, bound);
}

/// last_evaluation() by the adjugate: s errs across its direction, in the norm of M, by less than
/// adjugate_error u/d of itself.
bool prove_adjugate()
{
    return holds<2, 2>("adjugate", adjugate_solution<2>, {1.0, 1.0}, adjugate_error) &&
           holds<3, 5>("adjugate", adjugate_solution<3>, {1.0, 1.0}, adjugate_error);
}

/// is_clearly_definite() in two dimensions, with a unit diagonal and c = definite_margin: the
/// second pivot is positive. With x the square of the other entry, the test shows that (1 + u -
/// (1 - u) x)(1 + u) > c u (1 + u)(1 - u)². The pivot is positive if x times n roundings is
/// below 1. To first order, x n < 1 - (c - 2 - n) u; for c = 2 + n the terms u² decide, and their
/// sum is negative.
bool definite_holds_in_a_plane()
{
    auto const counts = count_roundings<2>();
    int const n = 2 * counts.factors[0][1][0] + counts.factors[1][1][0];
    double const u = largest_u, c = definite_margin<2>;
    double const x = ((1.0 + u) - c * u * (1.0 - u) * (1.0 - u)) / (1.0 - u),
                 grown = x * std::pow(1.0 + u, n);
    bool const proved = c >= 2 + n && grown < 1.0 - u * u;
    std::printf("definite, D = 2: %s %g u; %d\n", proved ? "proved" : "NOT PROVED", c, 2 + n);
    return proved;
}

/// The same in three dimensions, with P = 1. Let e u be the error of the determinant, L > det M >
/// (c - e) u the leading minor, and suppose that the last computed pivot is -x <= 0.
///
/// With x added to the last entry of M, the pivots are those of a singular matrix M', whose P is 1
/// + x. Let p u be the error of the product of its pivots. Then c u - e u < det M <= p u (1 + x) -
/// x L. The bound on e is larger by at most 10 x for M than for M', as it changes with the last
/// entry by the roundings of two products. With e + p <= c for M' it follows that L < (c + 10) u.
///
/// But with such an L, and e <= 7.1, the pivot is positive: L errs by at most 6u, so that the pivot
/// is at least (det M - 6u)/(L - 6u) > 1/8, less some 10 √u for the other errors.
bool definite_holds_in_space()
{
    DefiniteErrors errors;
    double const limit = definite_margin<3> * (1.0 - share_beyond);
    auto const proof = on_record().settle<3>(name_of("definite", 3), errors, DefiniteErrors::ranges,
                                             limit, 100000);
    std::printf("definite, D = 3: %s %d u; %ld boxes, largest value seen %.2f\n",
                proof.proved ? "proved" : "NOT PROVED", definite_margin<3>, proof.boxes,
                proof.largest);
    return holds<3, 3>("definite, determinant", definite<3>, {0.0, 1.0}, 7.1) && proof.proved;
}

bool prove_definite()
{
    bool const two = definite_holds_in_a_plane();
    return definite_holds_in_space() && two;
}

/// Bounds for shows_inside1() and shows_inside2(), in units of u. a errs by u/d times `a` of
/// itself. The computed d is above least_conditioning u, and the true one above `least` u.
struct InsideBounds {
    static constexpr double a = 0.05 * least_conditioning; ///< theorem `separation`
    static constexpr double across = adjugate_error;       ///< of s; theorem `adjugate`
    static constexpr double b = 17.0;                      ///< of det M
    static constexpr double form = 16.9;                   ///< part 3 of inside.hpp
    static constexpr double share = 6.0;                   ///< of d, in part 3
    static constexpr double least = least_conditioning - b;
};

/// The products of the errors of s with each other and with those of the form. A coordinate of s is
/// at most √d, and errs by `coordinates`/D. Each term of the form has `roundings`.
template <int D> double inside_products()
{
    Formula const formula = record(solution<D>), form = record(form_of_solution<D>);
    auto const found = monomials(formula.graph, 1.0);
    double coordinates = 0.0;
    for (int j = 0; j < D; ++j) {
        auto const &m =
            found[static_cast<std::size_t>(formula.results[static_cast<std::size_t>(j)])];
        coordinates += m.magnitude * m.roundings * 1.01;
    }
    double const roundings =
        monomials(form.graph, 1.0)[static_cast<std::size_t>(form.results[0])].roundings;
    double const c = coordinates * std::sqrt(largest_u / InsideBounds::least);
    double const square =
        InsideBounds::a * InsideBounds::a + InsideBounds::across * InsideBounds::across;
    return square / InsideBounds::least + roundings * c * (2.0 * D + c);
}

/// What of a margin is left for parts 1 and 2 of inside.hpp. The margin is proportional to the
/// computed a.
double left_of(int margin, double products)
{
    return margin * (1.0 - InsideBounds::a / InsideBounds::least - share_beyond) - products -
           InsideBounds::form;
}

template <int D, int N> bool proved_below(char const *what, FormBound<D, N> errors, double limit)
{
    auto const proof =
        on_record().settle<N>(name_of(what, D), errors, UnitPair<D, N>::ranges, limit, 4000000);
    std::printf("%s, D = %d: %s %g u; %ld boxes, largest value seen %.2f\n", what, D,
                proof.proved ? "proved" : "NOT PROVED", limit, proof.boxes, proof.largest);
    return proof.proved;
}

int roundings_in(std::vector<int> (*run)())
{
    auto const graph = record(run).graph;
    return static_cast<int>(
        std::count_if(graph.begin(), graph.end(), [](Node const &node) { return node.rounded; }));
}

/// Whether a test inside has no other roundings than the formulas that are bounded apart, and D - 1
/// of the product of the diagonal.
template <int D> bool is_complete(std::vector<int> (*test)(), std::vector<int> (*last_steps)())
{
    int const parts = roundings_in(solution<D>) + roundings_in(product_with_separation<D>) +
                      roundings_in(form_of_solution<D>) + roundings_in(last_steps);
    bool const complete = roundings_in(test) == parts + D - 1;
    if (!complete)
        std::printf("inside, D = %d: NOT PROVED; the parts do not make up the test\n", D);
    return complete;
}

/// Both tests inside err by less than their margins u a P.
template <int D, int N, int M> bool inside_holds()
{
    using Bounds = InsideBounds;
    bool const complete = is_complete<D>(inside1<D>, last_steps_inside1) &&
                          is_complete<D>(inside2<D>, last_steps_inside2);
    bool const b = holds<D, M>("determinant", determinant_of_blend<D>, {0.0, 1.0}, Bounds::b);
    bool const form = proved_below("inside, form", FormBound<D, N>(Bounds::share), Bounds::form);
    double const b2 = Bounds::b * Bounds::b / Bounds::least, products = inside_products<D>() + b2;
    double const left1 = left_of(inside1_margin, products + Bounds::a * Bounds::b / Bounds::least);
    double const left2 = left_of(inside2_margin, products);
    SolutionErrors<D, N> errors({left1, left2}, Bounds::across, Bounds::share);
    auto const proof =
        on_record().settle<N>(name_of("inside", D), errors, UnitPair<D, N>::ranges, 1.0, 2000000);
    std::printf("inside, D = %d: %s %d u and %d u; rest below %.2f and %.2f, %ld boxes, largest "
                "value seen %.3f of it\n",
                D, proof.proved ? "proved" : "NOT PROVED", inside1_margin, inside2_margin, left1,
                left2, proof.boxes, proof.largest);
    return complete && b && form && proof.proved;
}

bool prove_inside()
{
    bool const two = inside_holds<2, 2, 1>();
    return inside_holds<3, 5, 3>() && two;
}

/// Prints whether the eigenvalues of a matrix, and `rest`, are below a constant. Where these bounds
/// count, they are below 2^-10, and so is the error of κ. A share of 2^-6 covers terms of higher
/// order. A pivot that factorize() raises makes κ at least 1/u.
template <int D>
bool eigenvalues_below(char const *what, Exact<D> const &c, double rest, int constant)
{
    bool const proved = is_at_most(c, constant * (1.0 - 0x1p-6) - rest);
    double least = 0.0;
    while (!is_at_most(c, least)) least += 0x1p-8;
    std::printf("%s, D = %d: %s %d u κ; %.2f\n", what, D, proved ? "proved" : "NOT PROVED",
                constant, (least + rest) / (1.0 - 0x1p-6));
    return proved;
}

/// last_evaluation() by factorisation: s errs across its direction, in the norm of M, by less than
/// factorization_error u κ of itself. As x_i >= 1, w·x is at most Σ w_i x_i².
template <int D> bool factorization_holds()
{
    auto const counts = count_solution<D>();
    Exact<D> c = 0.5 * counts.c;
    for (int i = 0; i < D; ++i) c(i, i) += counts.w[i];
    return eigenvalues_below("factorization", c, 0.0, factorization_error);
}

bool prove_factorization()
{
    bool const two = factorization_holds<2>();
    return factorization_holds<3>() && two;
}

/// refine(): a correction errs by less than correction_error u κ of itself, where κ >= 2^12: w·x is
/// at most |w| √κ, and the residual has errors u |r_i|, which add √(3κ) u at most. For smaller κ,
/// with √κ <= κ/√3, it is below 19 u κ, and four such factors are below u/100.
template <int D> bool correction_holds()
{
    auto const counts = count_solution<D>();
    double square = 0.0;
    for (double const w : counts.w) square += w * w;
    return eigenvalues_below("correction", counts.c, (std::sqrt(square) + std::sqrt(3.0)) / 64.0,
                             correction_error);
}

bool prove_correction()
{
    bool const two = correction_holds<2>();
    return correction_holds<3>() && two;
}

/// The number of rounded results that a node depends on, without those that its operands `stops`
/// depend on.
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

/// The error of μ² = λ (rᵀs)²/(A + tB), in units of u μ²: with F the sum of magnitudes of the terms
/// of A + tB and G that of rᵀs, both over rᵀs, cond = F + 2G. The error is at most n F + 2 m G + k,
/// with n and m the roundings of a term and k those of what follows, each of which counts once. To
/// k come 2 that is_certified() admits and 1 for the comparison. As F and G are at least 1, the
/// error over cond is largest where both are 1, or where one of them is large. The share of the
/// last step, ½ f' x, errs by x times n F at most, where x <= 2^-8 (final_step()).
template <int D> bool value_holds()
{
    Formula const formula = record(value<D>);
    Graph const &graph = formula.graph;
    // with the share of the last step
    Node const &sum = graph[static_cast<std::size_t>(formula.results[0])];
    Node const &product = graph[static_cast<std::size_t>(sum.left)];
    Node const &quotient = graph[static_cast<std::size_t>(product.right)];
    auto const found = monomials(graph, 1.0);
    double const n = found[static_cast<std::size_t>(quotient.right)].roundings;
    double const m = found[static_cast<std::size_t>(quotient.left)].roundings;
    double const k = 1 + roundings_from(graph, sum.left, {quotient.left, quotient.right}) + 3;
    double const worst = std::max({(n + 2.0 * m + k) / 3.0, n, m}) + n * 0x1p-8;
    bool const proved =
        quotient.operation == Operation::quotient && worst <= value_margin * (1.0 - share_beyond);
    std::printf("value, D = %d: %s %d u cond; %.2f\n", D, proved ? "proved" : "NOT PROVED",
                value_margin, worst);
    return proved;
}

bool prove_value()
{
    bool const two = value_holds<2>();
    return value_holds<3>() && two;
}

/// Counts that the comments of the headers rely on: the roundings of a term, and a bound on the sum
/// of the magnitudes of all terms.
bool counts_at_most(char const *what, int dimensions, std::vector<int> (*run)(), int roundings,
                    double magnitude)
{
    Formula const formula = record(run);
    auto const found = monomials(formula.graph, 1.0)[static_cast<std::size_t>(formula.results[0])];
    bool const proved = found.roundings <= roundings && found.magnitude <= magnitude;
    std::printf("counts, %s, D = %d: %s %d roundings; %d\n", what, dimensions,
                proved ? "proved" : "NOT PROVED", roundings, found.roundings);
    return proved;
}

/// Forms and products of vectors (noise_of_slope()), and the rational form (rough_conditioning())
/// for r with coordinates of 1.
template <int D> bool counts_hold()
{
    double const any = std::numeric_limits<double>::infinity();
    bool const form = counts_at_most("form", D, form_of_solution<D>, 5, any);
    bool const product = counts_at_most("product", D, product_with_separation<D>, 3, any);
    bool const a = counts_at_most("a", D, rational_a<D>, 11, 6.0 * D);
    bool const b = counts_at_most("b", D, rational_b<D>, 10, 6.0);
    return form && product && a && b;
}

bool prove_counts()
{
    bool const two = counts_hold<2>();
    return counts_hold<3>() && two;
}

/// Whether a count of roundings, each with an error of at most u, is below a margin. One is left
/// for terms of second order: with a and b roundings, (1 + c u)(1 - u)^a >= (1 + u)^b for c > a + b
/// and u <= 2^-24.
bool below_margin(char const *what, int dimensions, int count, int margin)
{
    bool const proved = count < margin;
    std::printf("nesting, %s, D = %d: %s %d u; %d\n", what, dimensions,
                proved ? "proved" : "NOT PROVED", margin, count);
    return proved;
}

/// exceeds(): all roundings, those of `grow` included.
bool exceeds_holds()
{
    Formula const formula = record(exceeded);
    auto const count = [&](int from, std::vector<int> const &stops) {
        return roundings_from(formula.graph, formula.results[static_cast<std::size_t>(from)],
                              stops);
    };
    bool const difference = below_margin("difference", 1, count(0, {}), exceeds_margin);
    return below_margin("squares", 1, count(1, {}) + count(2, {formula.results[0]}),
                        exceeds_margin) &&
           difference;
}

/// shows_outside(): a margin, at the sample, covers the roundings of a term and the one of the sum
/// with the margin. All diagonal entries of the sample are 1, so that the magnitudes of the terms
/// of nᵀQn may add up to (Σ ni)².
template <int D> bool outside_holds()
{
    Formula const formula = record(bounds_of_outside<D>);
    auto const counts = monomials(formula.graph, 1.0);
    double sum = 0.0, product = 0.0;
    for (auto const &node : formula.graph)
        // n and r are equal
        if (node.name[0] == 'n') sum += node.value, product += node.value * node.value;
    bool all = true;
    for (int const result : formula.results) {
        Node const &bound = formula.graph[static_cast<std::size_t>(result)];
        bool const form = result != formula.results[2];
        double const margin = formula.graph[static_cast<std::size_t>(bound.right)].value;
        double const unit = unit_roundoff<double>() * (form ? sum * sum : product);
        int const count = counts[static_cast<std::size_t>(bound.left)].roundings + 1;
        all = below_margin(form ? "form" : "product", D, count, static_cast<int>(margin / unit)) &&
              all;
    }
    return all;
}

/// inner_matrices(): an entry of K errs by the roundings of a term of C and of Q1, and by one more
/// for the difference, or two off the diagonal, where the difference is up to twice √(Q1ii Q1jj). A
/// matrix of such errors is at most D times their bound.
template <int D> bool inner_holds()
{
    Formula const formula = record(inner_entries<D>);
    auto const counts = monomials(formula.graph, 1.0);
    auto const count = [&](int node) { return counts[static_cast<std::size_t>(node)].roundings; };
    Node const &diagonal = formula.graph[static_cast<std::size_t>(formula.results[0])];
    Node const &other = formula.graph[static_cast<std::size_t>(formula.results[1])];
    int const worst =
        std::max(count(diagonal.left) + count(diagonal.right) + 1, count(other.right) + 2);
    return below_margin("inside", D, D * worst, inside_margin);
}

bool prove_nesting()
{
    bool const exceeds = exceeds_holds(), two = outside_holds<2>() && inner_holds<2>();
    return outside_holds<3>() && inner_holds<3>() && exceeds && two;
}

/// The hypothesis of the other theorems, for doubles that passes_fast_checks() accepts and t up to
/// 2^128: nothing overflows, and what underflow adds is far below the share. P is at least
/// least_diagonal_product().
///
/// The bound on underflow suffices for shows_apart(), whose margin is at least that of P. For the
/// tests inside units decide. The roots of m_ii are between 2^-88 and 2^76, and their product is
/// above 2^-64. |r| is above its unit where A = 1, and above 1/√t of it where t²B = 1. So the units
/// of all results are above 2^-540, and underflow adds less than 2^-500 in these units, where the
/// margin is at least u (least_conditioning u).
bool range_holds(char const *what, int dimensions, std::vector<int> (*run)(), double least_margin)
{
    double const u = unit_roundoff<double>();
    Range const range = range_of(record(run), unscaled_limit<double>(), 0x1p128);
    bool const proved =
        range.largest < 0x1p1023 && range.underflow < 0.25 * share_beyond * u * least_margin;
    std::printf("range, %s, D = %d: %s; all results are below 2^%.0f\n", what, dimensions,
                proved ? "proved" : "NOT PROVED", std::ceil(std::log2(range.largest)));
    return proved;
}

template <int D> bool ranges_hold()
{
    double const any = std::numeric_limits<double>::infinity();
    bool const apart_in_range =
        range_holds("apart", D, apart<D>, apart_margin * least_diagonal_product<double>());
    bool const inside1_in_range = range_holds("inside1", D, inside1<D>, any);
    return range_holds("inside2", D, inside2<D>, any) && apart_in_range && inside1_in_range;
}

bool prove_range()
{
    bool const two = ranges_hold<2>();
    return ranges_hold<3>() && two;
}

struct Theorem {
    char const *name;
    bool (*prove)();
};

constexpr Theorem theorems[] = {
    {"apart", prove_apart},
    {"separation", prove_separation},
    {"adjugate", prove_adjugate},
    {"definite", prove_definite},
    {"value", prove_value},
    {"inside", prove_inside},
    {"factorization", prove_factorization},
    {"correction", prove_correction},
    {"counts", prove_counts},
    {"nesting", prove_nesting},
    {"range", prove_range},
    {"coefficients", prove_coefficients},
};

} // namespace

int main(int argc, char **argv)
{
    bool const proves = argc > 1 && std::strcmp(argv[1], "prove") == 0;
    if (!proves && (argc < 2 || std::strcmp(argv[1], "recall") != 0)) return 2;
    on_record(proves ? Record::Use::prove : Record::Use::recall);
    bool all = true;
    int proved = 0;
    for (auto const &theorem : theorems) {
        bool const wanted = std::any_of(argv + 2, argv + argc, [&](char const *a) {
            return std::strcmp(a, theorem.name) == 0;
        });
        if (argc > 2 && !wanted) continue;
        all = theorem.prove() && all;
        ++proved;
    }
    return all && proved > 0 && on_record().is_complete() ? 0 : 1;
}

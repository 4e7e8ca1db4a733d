// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The rounding errors of a factorisation and of a solution by it, as changes of the matrix and of
/// its factors: bounds of all orders.
///
/// Let l and d be the computed factors, K = √diag(d) lᵀ, and N = KᵀK. The factors are exact for a
/// matrix whose entry ij is Σ_k K_ki K_kj (1 + θ_ijk), and the substitutions for factors l_ik (1 +
/// θ_ik). Each |θ| is at most n u/(1 - n u), where n counts the roundings of a term, and those of
/// the sums that the term does not share with the first one (N. J. Higham, Accuracy and Stability
/// of Numerical Algorithms, 2nd ed., Chapters 8 and 10). The graph of the code gives n.
#ifndef PW85_TESTS_BOUNDS_BACKWARD_HPP_INCLUDED
#define PW85_TESTS_BOUNDS_BACKWARD_HPP_INCLUDED

#include "exact_matrix.hpp"
#include "second_order.hpp"
#include "worst_case.hpp"

namespace pw85_bounds {

/// The graph of a solution by factorisation, and the nodes of its parts.
template <int D> struct RecordedSolution {
    Graph graph;
    int lower[std::size_t(D)][std::size_t(D)], pivots[std::size_t(D)], forward[std::size_t(D)],
        back[std::size_t(D)];
    int entry; ///< an entry of the matrix
};

template <int D> RecordedSolution<D> record_solution()
{
    RecordedSolution<D> found{};
    recording = &found.graph;
    Inputs<D> const in;
    auto const m = blend(in.pair.q1, in.t, in.pair.q2);
    auto const f = factorize(m, Recorded(unit_roundoff<Recorded>()));
    auto const x = substitute_forward(f, in.pair.r12), s = substitute_back(f, x);
    found.entry = m(0, 1).node();
    for (int i = 0; i < D; ++i) {
        found.pivots[i] = f.pivots[i].node(), found.forward[i] = x[i].node(),
        found.back[i] = s[i].node();
        for (int j = 0; j < i; ++j) found.lower[i][j] = f.lower[i][j].node();
    }
    recording = nullptr;
    return found;
}

/// An entry less some terms, subtracted one after another: ((e - t_0) - t_1) - … It means e = t_0 +
/// (t_1 + (… + result)/(1 + δ_1))/(1 + δ_0).
struct Chain {
    int first;
    std::vector<int> terms;
};

inline Chain chain_of(Graph const &graph, int node)
{
    Chain chain{node, {}};
    for (; graph[static_cast<std::size_t>(chain.first)].operation == Operation::difference;
         chain.first = graph[static_cast<std::size_t>(chain.first)].left)
        chain.terms.insert(chain.terms.begin(), graph[static_cast<std::size_t>(chain.first)].right);
    return chain;
}

/// The counts: those of θ_ijk, for i and k and for k and j those of the substitutions, and of an
/// entry of the matrix.
template <int D> struct Counts {
    int factors[std::size_t(D)][std::size_t(D)][std::size_t(D)],
        forward[std::size_t(D)][std::size_t(D)], back[std::size_t(D)][std::size_t(D)], entry;
};

/// The number of rounded products in a term of factors, down to the factors.
template <int D> int products_in(RecordedSolution<D> const &found, int node)
{
    for (int i = 0; i < D; ++i) {
        if (node == found.pivots[i] || node == found.forward[i] || node == found.back[i]) return 0;
        for (int j = 0; j < i; ++j)
            if (node == found.lower[i][j]) return 0;
    }
    Node const &n = found.graph[static_cast<std::size_t>(node)];
    if (n.operation == Operation::input || n.operation == Operation::constant) return 0;
    int const below = products_in(found, n.left) + (n.right < 0 ? 0 : products_in(found, n.right));
    return below + (n.rounded ? 1 : 0);
}

/// Moves from a product to its first factor, down to a sum. Returns the roundings of the products
/// and of the other factors.
template <int D> int strip_factors(RecordedSolution<D> const &found, int &node)
{
    int count = 0;
    while (found.graph[static_cast<std::size_t>(node)].operation == Operation::product) {
        Node const &product = found.graph[static_cast<std::size_t>(node)];
        count += (product.rounded ? 1 : 0) + products_in(found, product.right);
        node = product.left;
    }
    return count;
}

/// Counts of term k of row j, column i >= j.
template <int D> int factor_count(RecordedSolution<D> const &found, int j, int i, int k)
{
    int node = i == j ? found.pivots[j] : found.lower[i][j];
    int const factors = strip_factors(found, node);
    Chain const chain = chain_of(found.graph, node);
    if (k == j) return static_cast<int>(chain.terms.size()) + factors;
    return k + products_in(found, chain.terms.at(static_cast<std::size_t>(k)));
}

template <int D> int forward_count(RecordedSolution<D> const &found, int i, int k)
{
    Chain const chain = chain_of(found.graph, found.forward[i]);
    return k == i ? i : k + products_in(found, chain.terms.at(static_cast<std::size_t>(k)));
}

/// The quotient by the pivot counts for all terms, since it comes first.
template <int D> int back_count(RecordedSolution<D> const &found, int k, int j)
{
    Chain const chain = chain_of(found.graph, found.back[k]);
    int const place = j - k - 1, quotient = products_in(found, chain.first);
    if (j == k) return D - 1 - k + quotient;
    return place + products_in(found, chain.terms.at(static_cast<std::size_t>(place))) + quotient;
}

template <int D> Counts<D> count_roundings()
{
    auto const found = record_solution<D>();
    Counts<D> counts{};
    counts.entry = products_in(found, found.entry);
    for (int i = 0; i < D; ++i)
        for (int k = 0; k <= i; ++k) {
            counts.forward[i][k] = forward_count(found, i, k);
            counts.back[k][i] = back_count(found, k, i);
            for (int j = 0; j <= i; ++j)
                if (k <= j)
                    counts.factors[i][j][k] = counts.factors[j][i][k] =
                        factor_count(found, j, i, k);
        }
    return counts;
}

/// The errors, over u P, of the determinant that is_clearly_definite() computes and of the product
/// of the pivots of factorize(), for singular matrices in three dimensions. The product is the
/// determinant of a changed matrix, so that it errs by Σ |adj(N)_ij K_ki K_kj| n_ijk to first
/// order. v_0, v_1 and v_2 are in a plane.
class DefiniteErrors {
  public:
    static constexpr int D = 3, angles = 3;
    using Number = Affine<angles>;
    static constexpr double ranges[] = {pi / 2, pi, 0.0};

    DefiniteErrors() : determinant_(record(definite<D>), 0.0) {}

    double bound(Box<angles> const &box, double, double (&variation)[angles])
    {
        UnitPair<D, angles> const pair(box);
        determinant_.evaluate(pair);
        determinant_.adjoint_of_result(0, 0) = Number(1.0);
        determinant_.errors().propagate(0);
        Number const sum =
            determinant_.errors().sum_errors(1.0, 0.0, variation) + error_of_pivots(pair);
        for (int i = 0; i < angles; ++i) variation[i] = std::fabs(sum.slopes[i]) + box.width[i];
        return sum.largest();
    }

  private:
    Number error_of_pivots(UnitPair<D, angles> const &pair) const
    {
        pw85::SymmetricMatrix<Number, D> m{};
        for (int i = 0; i < D; ++i)
            for (int j = i; j < D; ++j) m(i, j) = pair.entry(i, j);
        auto const adj = pw85::detail::adjugate(m);
        Number sum(0.0);
        for (int i = 0; i < D; ++i)
            for (int j = 0; j < D; ++j)
                for (int k = 0; k <= std::min(i, j); ++k)
                    sum = sum + magnitude(adj(i, j) * pair.v[i][k] * pair.v[j][k]) *
                                    counts_.factors[i][j][k];
        return sum;
    }

    PairErrors<D, angles> determinant_;
    Counts<D> counts_ = count_roundings<D>();
};

/// Bounds on |gᵀe|, where e is the error of M s, for g of length 1 in the norm of N, over the
/// length of s. With x_i² = (N⁻¹)_ii, |g_i| and |s_i| are at most x_i. The change of the matrix
/// adds u xᵀCx at most, where C_ij is the largest n_ijk, and half of it if g is normal to s, since
/// g_i² + s_i² <= x_i² then. A substitution adds Σ_k n_ik |g_i K_ki| |(Ks)_k|, or the like for s_i.
/// Both add u w·x at most, as |Ks| = 1 and Σ_k K_ki² = 1.
template <int D> struct SolutionCounts {
    Exact<D> c{};
    double w[std::size_t(D)] = {};
};

template <int D> SolutionCounts<D> count_solution()
{
    auto const counts = count_roundings<D>();
    SolutionCounts<D> found;
    for (int i = 0; i < D; ++i) {
        int forward = 0, back = 0;
        for (int k = 0; k <= i; ++k)
            forward = std::max(forward, counts.forward[i][k]),
            back = std::max(back, counts.back[k][i]);
        found.w[i] = forward + back;
        for (int j = i; j < D; ++j)
            for (int k = 0; k <= i; ++k)
                found.c(i, j) = std::max(
                    found.c(i, j), static_cast<double>(counts.factors[i][j][k] + counts.entry));
    }
    return found;
}

/// Whether the eigenvalues of C are below a limit, rounded to a multiple of 2^-8.
template <int D> bool is_at_most(Exact<D> const &c, double limit)
{
    Exact<D> const rest = plus_multiple_of_identity(-1.0 * c, std::floor(limit * 256.0) / 256.0);
    return is_positive(rest);
}

} // namespace pw85_bounds

#endif

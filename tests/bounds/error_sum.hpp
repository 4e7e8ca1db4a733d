// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The rounding errors of a formula to first order. With z_k(1 + δ_k) for each rounded result,
/// |δ_k| <= u, a result errs by Σ δ_k z_k ∂f/∂z_k, which is at most u Σ |z_k ∂f/∂z_k|.
#ifndef PW85_TESTS_BOUNDS_ERROR_SUM_HPP_INCLUDED
#define PW85_TESTS_BOUNDS_ERROR_SUM_HPP_INCLUDED

#include "affine.hpp"
#include "formulas.hpp"

namespace pw85_bounds {

/// The graph of a formula with values of its nodes, and adjoints for up to two weightings of its
/// results. Write the values of the inputs and call evaluate(); write the adjoints of the results
/// and call propagate(); then call sum_errors().
template <int N> class ErrorSum {
  public:
    using Number = Affine<N>;

    explicit ErrorSum(Formula formula)
        : formula_(std::move(formula)), values_(size()),
          bounds_(size()), adjoints_{std::vector<Number>(size()), std::vector<Number>(size())}
    {
    }

    Formula const &formula() const { return formula_; }
    Number &value(std::size_t k) { return values_[k]; }
    Number &adjoint(int weighting, std::size_t k) { return adjoints_[weighting][k]; }

    /// A bound on the magnitude of a node whose value the theorem does not know; center < 0 where
    /// there is none.
    Number &bound(std::size_t k) { return bounds_[k]; }

    void evaluate()
    {
        for (std::size_t k = 0; k < size(); ++k) {
            if (!is_input(k)) values_[k] = result(formula_.graph[k]);
            adjoints_[0][k] = adjoints_[1][k] = Number(0.0);
        }
    }

    /// Leaves z_k ∂f/∂z_k in place of the adjoints, or ∂f/∂z_k where z_k has a bound alone.
    void propagate(int weighting)
    {
        auto &adjoints = adjoints_[weighting];
        for (std::size_t k = size(); k-- > 0;) {
            Node const &node = formula_.graph[k];
            if (is_input(k) || node.operation == Operation::constant) continue;
            propagate(adjoints, node, adjoints[k]);
            if (node.rounded && bounds_[k].center < 0.0) adjoints[k] = adjoints[k] * values_[k];
        }
    }

    /// Σ |z_k ∂f/∂z_k| for f with the first weighting times x and the second times y, and in
    /// `variation` how much the variables move its terms.
    Number sum_errors(double x, double y, double (&variation)[std::size_t(N)]) const
    {
        Number sum(0.0);
        double magnitudes = 0.0;
        for (double &v : variation) v = 0.0;
        for (std::size_t k = 0; k < size(); ++k) {
            if (!formula_.graph[k].rounded) continue;
            Number const slope =
                y == 0.0 ? adjoints_[0][k] : combination(adjoints_[0][k], x, adjoints_[1][k], y);
            Number const term =
                bounds_[k].center < 0.0 ? magnitude(slope) : magnitude(slope) * bounds_[k];
            for (int i = 0; i < N; ++i) variation[i] += std::fabs(term.slopes[i]);
            sum.add(term);
            magnitudes += term.most();
        }
        return sum.roundings(static_cast<double>(size()) * magnitudes);
    }

  private:
    std::size_t size() const { return formula_.graph.size(); }
    bool is_input(std::size_t k) const { return formula_.graph[k].operation == Operation::input; }
    Number &left(std::vector<Number> &numbers, Node const &node)
    {
        return numbers[static_cast<std::size_t>(node.left)];
    }
    Number &right(std::vector<Number> &numbers, Node const &node)
    {
        return numbers[static_cast<std::size_t>(node.right)];
    }

    /// Margins are of the order u: they count for the terms of second order.
    static double first_order(double constant)
    {
        return std::fabs(constant) < 0x1p-30 ? 0.0 : constant;
    }

    Number result(Node const &node)
    {
        switch (node.operation) {
        case Operation::constant:
            return Number(first_order(node.value));
        case Operation::sum:
            return left(values_, node) + right(values_, node);
        case Operation::difference:
            return left(values_, node) - right(values_, node);
        case Operation::product:
            return left(values_, node) * right(values_, node);
        case Operation::negation:
            return -left(values_, node);
        default:
            return Number(std::nan("")); // no theorem has quotients
        }
    }

    void propagate(std::vector<Number> &adjoints, Node const &node, Number const &adjoint)
    {
        switch (node.operation) {
        case Operation::sum:
            left(adjoints, node) += adjoint;
            right(adjoints, node) += adjoint;
            break;
        case Operation::difference:
            left(adjoints, node) += adjoint;
            right(adjoints, node) += -adjoint;
            break;
        case Operation::product:
            left(adjoints, node) += adjoint * right(values_, node);
            right(adjoints, node) += adjoint * left(values_, node);
            break;
        default:
            left(adjoints, node) += -adjoint;
        }
    }

    Formula formula_;
    std::vector<Number> values_, bounds_;
    std::vector<Number> adjoints_[2];
};

} // namespace pw85_bounds

#endif

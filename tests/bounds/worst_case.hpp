// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The rounding errors of a formula in M = Q1 + t Q2, to first order, for all pairs in a box of
/// unit_pair.hpp.
#ifndef PW85_TESTS_BOUNDS_WORST_CASE_HPP_INCLUDED
#define PW85_TESTS_BOUNDS_WORST_CASE_HPP_INCLUDED

#include <algorithm>

#include "error_sum.hpp"
#include "unit_pair.hpp"

namespace pw85_bounds {

/// A formula, with the values of its inputs for the pairs in a box.
template <int D, int N> class PairErrors {
  public:
    using Number = Affine<N>;

    /// `length` is the root of rᵀM⁻¹r.
    PairErrors(Formula formula, Number const &length) : errors_(std::move(formula)), length_(length)
    {
        auto const &graph = errors_.formula().graph;
        for (auto const &node : graph) roles_.push_back(role(graph, node));
    }

    Formula const &formula() const { return errors_.formula(); }
    ErrorSum<N> &errors() { return errors_; }
    Number &adjoint_of_result(int weighting, int i)
    {
        return errors_.adjoint(
            weighting, static_cast<std::size_t>(formula().results[static_cast<std::size_t>(i)]));
    }

    /// Computes the values of all nodes.
    void evaluate(UnitPair<D, N> const &pair)
    {
        for (std::size_t k = 0; k < roles_.size(); ++k) write_node(k, pair);
        errors_.evaluate();
    }

  private:
    /// What a node stands for: an entry of M or of a vector, or a product t Q2ij.
    enum class Kind { computed, one, zero, matrix, separation, solution, share };
    struct Role {
        Kind kind;
        int i, j;
    };

    static int digit(char c) { return c - '0'; }

    static Role role(Graph const &graph, Node const &node)
    {
        if (node.operation == Operation::product) {
            auto const &left = graph[static_cast<std::size_t>(node.left)].name;
            auto const &right = graph[static_cast<std::size_t>(node.right)].name;
            if (left == "t" && right[0] == 'q')
                return {Kind::share, digit(right[2]), digit(right[3])};
        }
        if (node.operation != Operation::input) return {Kind::computed, 0, 0};
        auto const &name = node.name;
        if (name[0] == 'm') return {Kind::matrix, digit(name[1]), digit(name[2])};
        if (name[0] == 'q')
            return {name[1] == '1' ? Kind::matrix : Kind::zero, digit(name[2]), digit(name[3])};
        if (name.size() == 2 && name[0] == 'r') return {Kind::separation, digit(name[1]), 0};
        if (name.size() == 2 && name[0] == 's') return {Kind::solution, digit(name[1]), 0};
        return {Kind::one, 0, 0};
    }

    /// An input; or a bound on |t Q2ij|: as 0 <= t Q2 <= M, it is v_iᵀX v_j with 0 <= X <= 1, so
    /// that it lies between (v_i·v_j ± 1)/2. M is written to Q1 and zero to Q2, because t Q2 counts
    /// in these formulas by M and this bound only.
    void write_node(std::size_t k, UnitPair<D, N> const &pair)
    {
        auto const [kind, i, j] = roles_[k];
        errors_.bound(k) = Number(-1.0);
        if (kind == Kind::share)
            errors_.bound(k) = (Number(1.0) + magnitude(pair.entry(i, j))) * 0.5;
        else if (kind != Kind::computed)
            errors_.value(k) = input(roles_[k], pair);
    }

    Number input(Role const &role, UnitPair<D, N> const &pair) const
    {
        switch (role.kind) {
        case Kind::matrix:
            return pair.entry(role.i, role.j);
        case Kind::separation:
            return length_ * inner(pair.v[role.i], pair.w);
        case Kind::solution: // adj(M) r
            return length_ * pair.root_of_determinant() * pair.scaled_solution(role.i);
        default:
            return Number(role.kind == Kind::one ? 1.0 : 0.0);
        }
    }

    ErrorSum<N> errors_;
    Number length_;
    std::vector<Role> roles_;
};

/// What a formula is asked for: rᵀM⁻¹r, and the factor of its result.
struct Question {
    double square;
    double factor;
};

template <int D, int N> class WorstCase {
  public:
    using Number = Affine<N>;

    WorstCase(Formula formula, Question const &question)
        : errors_(std::move(formula),
                  Number(std::sqrt(question.square)).roundings(question.square + 1.0)),
          factor_(question.factor)
    {
    }

    /// A bound on the sum of the errors in a box, and in `variation` how much each angle moves it.
    /// It need not be a bound if it is above the limit.
    double bound(Box<N> const &box, double limit, double (&variation)[std::size_t(N)])
    {
        UnitPair<D, N> const pair(box);
        errors_.evaluate(pair);
        if (errors_.formula().results.size() == 1) {
            errors_.adjoint_of_result(0, 0) = Number(factor_);
            errors_.errors().propagate(0);
            return errors_.errors().sum_errors(1.0, 0.0, variation).largest();
        }
        for (int i = 0; i < D - 1; ++i) propagate_across(i, pair);
        if (D == 2) return errors_.errors().sum_errors(1.0, 0.0, variation).largest();
        return box.width[0] > 0.0 ? bound_across(limit, variation) : value_across(variation);
    }

  private:
    /// Of a vector M⁻¹r counts the error across: its products with M v = Vᵀy, for vectors v of
    /// length 1 in the norm of M that are normal to M⁻¹r, which means that y is normal to w.
    void propagate_across(int i, UnitPair<D, N> const &pair)
    {
        for (int j = 0; j < D; ++j)
            errors_.adjoint_of_result(i, j) = inner(pair.v[j], pair.normals[i]);
        errors_.errors().propagate(i);
    }

    /// The largest error across, for any y = x_0 n_0 + x_1 n_1 of length 1. It is a norm of x, so
    /// it is at most that at the corners of a regular polygon around the circle: on directions 2h
    /// apart, over cos h. A few directions are enough for most boxes.
    double bound_across(double limit, double (&variation)[std::size_t(N)])
    {
        double const few = largest_across(true, limit, variation),
                     bound = few * circumscribed(coarse);
        if (few > limit || bound <= limit) return bound;
        return std::max(few, largest_across(false, limit, variation)) * circumscribed(1);
    }

    /// The same for one pair, without the share of the polygon.
    double value_across(double (&variation)[std::size_t(N)])
    {
        double const most = std::numeric_limits<double>::infinity();
        return std::max(largest_across(true, most, variation),
                        largest_across(false, most, variation));
    }

    static double circumscribed(int stride)
    {
        return (1.0 + 0x1p-40) / std::cos(pi * stride / (2 * directions));
    }

    /// The largest error in the directions of the coarse polygon, or in the others, up to one that
    /// is above the limit. That one comes first the next time.
    double largest_across(bool few, double limit, double (&variation)[std::size_t(N)])
    {
        double largest = 0.0;
        for (int n = 0; n < directions && largest <= limit; ++n) {
            if ((n % coarse == 0) != few) continue;
            int const direction = (first_ + n) % directions;
            double const angle = pi / directions * direction;
            double const bound =
                errors_.errors().sum_errors(std::cos(angle), std::sin(angle), variation).largest();
            largest = std::max(largest, bound);
            if (bound > limit) first_ = direction;
        }
        return largest;
    }

    static constexpr int directions = 16, coarse = 4;

    int first_ = 0;
    PairErrors<D, N> errors_;
    double factor_;
};

} // namespace pw85_bounds

#endif

/// @file
/// The rounding errors of a formula in M = Q1 + t Q2, to first order, for all pairs in a box of unit_pair.hpp.
#ifndef PW85_TESTS_BOUNDS_WORST_CASE_HPP_INCLUDED
#define PW85_TESTS_BOUNDS_WORST_CASE_HPP_INCLUDED

#include <algorithm>

#include "error_sum.hpp"
#include "unit_pair.hpp"

namespace pw85_bounds {

/// What a formula is asked for: rᵀM⁻¹r, and the factor of its result.
struct Question {
    double square;
    double factor;
};

template <int D, int N> class WorstCase {
  public:
    using Number = Affine<N>;

    WorstCase(Formula formula, Question const &question)
        : errors_(std::move(formula)), length_(std::sqrt(question.square)), factor_(question.factor)
    {
        length_.roundings(question.square + 1.0);
    }

    Formula const &formula() const { return errors_.formula(); }

    /// A bound on the sum of the errors in a box, and in `variation` how much each angle moves it. It need not be a bound if it is
    /// above the limit.
    double bound(Box<N> const &box, double limit, double (&variation)[N])
    {
        UnitPair<D, N> const pair(box);
        for (std::size_t k = 0; k < formula().graph.size(); ++k) write_node(k, pair);
        errors_.evaluate();
        if (formula().results.size() == 1) {
            errors_.adjoint(0, static_cast<std::size_t>(formula().results[0])) = Number(factor_);
            errors_.propagate(0);
            return errors_.sum_errors(1.0, 0.0, variation).largest();
        }
        for (int i = 0; i < D - 1; ++i) propagate_across(i, pair);
        return D == 2 ? errors_.sum_errors(1.0, 0.0, variation).largest() : bound_across(limit, variation);
    }

  private:
    static int digit(char c) { return c - '0'; }
    Node const &node(int k) const { return formula().graph[static_cast<std::size_t>(k)]; }

    /// The entry that a name ends with. The diagonal is 1.
    static Number entry(UnitPair<D, N> const &pair, std::string const &name)
    {
        int const i = digit(name[name.size() - 2]), j = digit(name.back());
        return i == j ? Number(1.0) : inner(pair.v[i], pair.v[j]);
    }

    /// An input; or a bound on |t Q2ij|: as 0 <= t Q2 <= M, it is v_iᵀX v_j with 0 <= X <= 1, so that it lies between (v_i·v_j ±
    /// 1)/2. M is written to Q1 and zero to Q2, because t Q2 counts in these formulas by M and this bound only.
    void write_node(std::size_t k, UnitPair<D, N> const &pair)
    {
        Node const &n = formula().graph[k];
        errors_.bound(k) = Number(-1.0);
        if (n.operation == Operation::input)
            errors_.value(k) = input(n.name, pair);
        else if (n.operation == Operation::product && node(n.left).name == "t" && node(n.right).name[0] == 'q')
            errors_.bound(k) = (Number(1.0) + magnitude(entry(pair, node(n.right).name))) * 0.5;
    }

    Number input(std::string const &name, UnitPair<D, N> const &pair) const
    {
        if (name[0] == 'm' || name.substr(0, 2) == "q1") return entry(pair, name);
        if (name[0] == 'q') return Number(0.0);
        return name[0] == 'r' && name.size() == 2 ? length_ * inner(pair.v[digit(name[1])], pair.w) : Number(1.0);
    }

    /// Of a vector M⁻¹r counts the error across: its products with M v = Vᵀy, for vectors v of length 1 in the norm of M that are
    /// normal to M⁻¹r, which means that y is normal to w.
    void propagate_across(int i, UnitPair<D, N> const &pair)
    {
        for (int j = 0; j < D; ++j)
            errors_.adjoint(i, static_cast<std::size_t>(formula().results[static_cast<std::size_t>(j)])) =
                inner(pair.v[j], pair.normals[i]);
        errors_.propagate(i);
    }

    /// The largest error across, for any y = x_0 n_0 + x_1 n_1 of length 1. It is a norm of x, so it is at most that at the corners
    /// of a regular polygon around the circle: on directions 2h apart, over cos h. One that is above the limit comes first the next
    /// time.
    double bound_across(double limit, double (&variation)[N])
    {
        double const h = pi / (2 * directions);
        double largest = 0.0;
        for (int n = 0; n < directions && largest <= limit; ++n) {
            int const direction = (first_ + n) % directions;
            double const angle = 2.0 * h * direction;
            double const bound =
                errors_.sum_errors(std::cos(angle), std::sin(angle), variation).largest() / std::cos(h);
            largest = std::max(largest, bound * (1.0 + 0x1p-40));
            if (largest > limit) first_ = direction;
        }
        return largest;
    }

    static constexpr int directions = 12;

    int first_ = 0;
    ErrorSum<N> errors_;
    Number length_;
    double factor_;
};

} // namespace pw85_bounds

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The rounding errors of shows_inside1() and shows_inside2(), to first order, for all pairs in a
/// box of unit_pair.hpp.
///
/// Let t Q2 = VᵀXV, with 0 <= X <= 1, p = w·Xw and d = det M. r has any length. Over a P, the
/// errors of b²A where A = 1, and of b² t²B where t²B = 1, have three parts.
///
/// 1. Errors σ of s = adj(M) r, over the length of r, and β of b. They count by L(h) and by L(h +
///    w), with h = 2Xw - w, |h| <= 1 and L(c) = (Vᵀc)·σ - (w·c) β. L(c) is a norm of c. L(w) is at
///    most n, and L(c) at most m = adjugate_error for c across w. As the part of Xw across w has a
///    square of at most p (1 - p), L(h) is at most √(n² + m²), and L(h + w) at most n + √(n² + m²).
/// 2. Errors of a from s, and of the last steps. Each of the last steps is a multiple of d.
/// 3. Errors of sᵀQ2s from s (FormErrors).
///
/// Parts 1 and 2 less a multiple of d, and part 3 with it added, are bounded apart.
#ifndef PW85_TESTS_BOUNDS_INSIDE_HPP_INCLUDED
#define PW85_TESTS_BOUNDS_INSIDE_HPP_INCLUDED

#include <map>

#include "exact_matrix.hpp"
#include "worst_case.hpp"

namespace pw85_bounds {

/// The error of the last steps of a test, over d, from exact values. Those at p = 0 for
/// shows_inside1(), and at p = 1 for shows_inside2(), are largest.
inline double error_of_last_steps(std::vector<int> (*run)(), double p)
{
    ErrorSum<1> errors(record(run));
    auto const &graph = errors.formula().graph;
    for (std::size_t k = 0; k < graph.size(); ++k) {
        errors.bound(k) = -1.0;
        errors.value(k) = graph[k].name == "form" ? p : 1.0;
    }
    errors.evaluate();
    errors.adjoint(0, static_cast<std::size_t>(errors.formula().results[0])) = 1.0;
    errors.propagate(0);
    double variation[1];
    return errors.sum_errors(1.0, 0.0, variation).largest();
}

/// √(x² + y²) for x >= 0, from above, by a chord.
template <int N> Affine<N> hypotenuse(Affine<N> const &x, double y)
{
    double const low = std::max(0.0, x.smallest()), high = x.largest();
    double const at_low = std::hypot(low, y), at_high = std::hypot(high, y);
    double const slope = (low + high) / (at_low + at_high); // (at_high - at_low)/(high - low)
    return (x * slope + Affine<N>(at_low - slope * low)).roundings(8.0 * at_high);
}

/// Limits for both tests.
struct InsideLimits {
    double inside1, inside2;
};

/// Parts 1 and 2 less `share` d, over the limits.
template <int D, int N> class SolutionErrors {
  public:
    using Number = Affine<N>;

    SolutionErrors(InsideLimits const &limits, double across, double share)
        : solution_(record(solution<D>), 1.0), product_(record(product_with_separation<D>), 1.0),
          limits_(limits), across_(across),
          last1_(error_of_last_steps(last_steps_inside1, 0.0) - share),
          last2_(error_of_last_steps(last_steps_inside2, 1.0) - share)
    {
    }

    double bound(Box<N> const &box, double, double (&variation)[std::size_t(N)])
    {
        UnitPair<D, N> const pair(box);
        Number const root = pair.root_of_determinant(), d = root * root;
        double less[std::size_t(N)];
        Number const a = error_of_product(pair, less), along = error_along(pair, variation);
        for (int i = 0; i < N; ++i) variation[i] += less[i];
        Number const both = hypotenuse(along, across_);
        double const inside1 = (both + a + d * last1_).largest(),
                     inside2 = (both + along + d * last2_).largest();
        return std::max(inside1 / limits_.inside1, inside2 / limits_.inside2);
    }

  private:
    Number error_along(UnitPair<D, N> const &pair, double (&variation)[std::size_t(N)])
    {
        solution_.evaluate(pair);
        for (int j = 0; j < D; ++j) solution_.adjoint_of_result(0, j) = inner(pair.v[j], pair.w);
        solution_.adjoint_of_result(0, D) = Number(-1.0);
        solution_.errors().propagate(0);
        return solution_.errors().sum_errors(1.0, 0.0, variation);
    }

    Number error_of_product(UnitPair<D, N> const &pair, double (&variation)[std::size_t(N)])
    {
        product_.evaluate(pair);
        product_.adjoint_of_result(0, 0) = Number(1.0);
        product_.errors().propagate(0);
        return product_.errors().sum_errors(1.0, 0.0, variation);
    }

    PairErrors<D, N> solution_, product_;
    InsideLimits limits_;
    double across_, last1_, last2_;
};

/// The errors of sᵀQ2s from s, to first order. With Y_ij = s_i tQ2ij s_j/(d R), the errors are a
/// sum of magnitudes of linear functions of Y. For Z_ij = s_i M_ij s_j/(d R), 0 <= Y <= Z, and the
/// sum of all Z_ij is d. Each sum of magnitudes is the largest of some linear functions tr(C Y). If
/// a matrix Λ is at least C and at least 0, then tr(C Y) <= tr(Λ Y) <= tr(Λ Z).
template <int D> class FormErrors {
  public:
    FormErrors()
    {
        for (auto const &slope : slopes()) add(slope);
        std::vector<Exact<D>> kept;
        for (auto const &[entries, count] : folded_) kept.push_back(times(entries, count));
        for (unsigned signs = 0; signs < 1u << kept.size(); ++signs) {
            Exact<D> c = certain_;
            for (std::size_t n = 0; n < kept.size(); ++n)
                for (int k = 0; k < c.size; ++k)
                    c[k] += (signs >> n & 1u) != 0 ? -kept[n][k] : kept[n][k];
            covers_.push_back(cover(c));
        }
    }

    /// A bound on the errors: a multiple of d, and the trace of Λ Z, for the largest Λ.
    static constexpr double ones = 0.25; ///< of the matrix of ones, in Λ - C
    double of_determinant() const { return of_determinant_ + ones; }
    std::vector<Exact<D>> const &covers() const { return covers_; }

  private:
    static Exact<D> times(std::vector<double> const &entries, double factor)
    {
        Exact<D> a{};
        for (int k = 0; k < a.size; ++k) a[k] = factor * entries[static_cast<std::size_t>(k)];
        return a;
    }

    /// For each rounded result the factors of Y_ij, i <= j.
    static std::vector<std::vector<double>> slopes()
    {
        ErrorSum<1> errors(record(form_of_solution<D>));
        auto const &graph = errors.formula().graph;
        std::vector<std::vector<double>> slopes(graph.size(), std::vector<double>(Exact<D>::size));
        for (int i = 0; i < D; ++i)
            for (int j = i; j < D; ++j) {
                auto const name = entry_name("q2", {i, j});
                for (std::size_t k = 0; k < graph.size(); ++k) {
                    errors.bound(k) = -1.0;
                    errors.value(k) = graph[k].name[0] == 'q' && graph[k].name != name ? 0.0 : 1.0;
                }
                errors.evaluate();
                errors.adjoint(0, static_cast<std::size_t>(errors.formula().results[0])) = 1.0;
                errors.propagate(0);
                for (std::size_t k = 0; k < graph.size(); ++k)
                    if (graph[k].rounded)
                        slopes[k][static_cast<std::size_t>(Exact<D>::index(i, j))] =
                            errors.adjoint(0, k).center;
            }
        return slopes;
    }

    /// Adds the magnitude of a linear function. If all factors beside the diagonal are equal, a
    /// part of the sum of all Y_ij, which is at most d, leaves only the diagonal of Y, which is
    /// positive.
    void add(std::vector<double> const &slope)
    {
        auto const at = [&](int i, int j) {
            return slope[static_cast<std::size_t>(Exact<D>::index(i, j))];
        };
        double const part = 0.5 * at(0, 1);
        bool equal = true;
        for (int i = 0; i < D; ++i)
            for (int j = i + 1; j < D; ++j) equal = equal && at(i, j) == 2.0 * part;
        if (!equal) {
            folded_[slope] += 1.0;
            return;
        }
        of_determinant_ += std::fabs(part);
        for (int i = 0; i < D; ++i) certain_(i, i) += std::fabs(at(i, i) - part);
    }

    /// Λ less the multiple of ones, whose trace with Z is the multiple of d. The factor beside the
    /// diagonal counts for two entries.
    static Exact<D> cover(Exact<D> c)
    {
        for (int i = 0; i < D; ++i)
            for (int j = i + 1; j < D; ++j) c(i, j) *= 0.5;
        Exact<D> shifted = c;
        for (double &entry : shifted.entries) entry += ones;
        while (!is_positive(shifted)) {
            shifted = plus_multiple_of_identity(shifted, 0x1p-4);
            c = plus_multiple_of_identity(c, 0x1p-4);
        }
        return c;
    }

    Exact<D> certain_{};
    double of_determinant_ = 0.0;
    std::map<std::vector<double>, double> folded_;
    std::vector<Exact<D>> covers_;
};

/// Part 3, and `share` d.
template <int D, int N> class FormBound {
  public:
    using Number = Affine<N>;

    explicit FormBound(double share) : of_determinant_(form_.of_determinant() + share) {}

    double bound(Box<N> const &box, double limit, double (&variation)[std::size_t(N)])
    {
        UnitPair<D, N> const pair(box);
        Number const root = pair.root_of_determinant(), rest = root * root * of_determinant_;
        Number z[std::size_t(Exact<D>::size)], s[std::size_t(D)];
        for (int i = 0; i < D; ++i) s[i] = pair.scaled_solution(i);
        for (int i = 0; i < D; ++i)
            for (int j = i; j < D; ++j) z[Exact<D>::index(i, j)] = s[i] * s[j] * pair.entry(i, j);
        double largest = 0.0;
        for (double &v : variation) v = 0.0;
        auto const &covers = form_.covers();
        for (std::size_t n = 0; n < covers.size() && largest <= limit; ++n) {
            auto const place = (first_ + n) % covers.size();
            Number const sum = rest + trace_with(covers[place], z);
            largest = std::max(largest, sum.largest());
            if (largest > limit) first_ = place;
            for (int i = 0; i < N; ++i)
                variation[i] = std::max(variation[i], std::fabs(sum.slopes[i]));
        }
        return largest;
    }

  private:
    static Number trace_with(Exact<D> const &cover, Number const (&z)[Exact<D>::size])
    {
        Number sum(0.0);
        for (int i = 0; i < D; ++i)
            for (int j = i; j < D; ++j)
                sum = sum + z[Exact<D>::index(i, j)] * (i == j ? cover(i, j) : 2.0 * cover(i, j));
        return sum;
    }

    FormErrors<D> form_;
    double of_determinant_;
    std::size_t first_ = 0;
};

} // namespace pw85_bounds

#endif

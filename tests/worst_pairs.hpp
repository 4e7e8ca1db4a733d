// SPDX-License-Identifier: BSD-3-Clause
// A random search for the pairs with the largest errors of the library. The reference is the core
// in a wide type. For each function some climbers step from the worst pair that they have found to
// similar pairs with larger errors. Random crossed and general pairs replace climbers with small
// errors. The seed and the results of the library determine a search.
#ifndef PW85_TESTS_WORST_PAIRS_HPP_INCLUDED
#define PW85_TESTS_WORST_PAIRS_HPP_INCLUDED

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "batch/batch_data.hpp"
#include "wide.hpp"

namespace pw85_tests {

/// The functions that are searched; the last two are judged by their answer alone.
inline constexpr int num_searched = 5;
inline constexpr char const *searched[num_searched] = {"contact", "contact_function",
                                                       "contact_batch", "overlap", "overlap_batch"};

/// The errors of all functions for one pair, in units of u·cond: that of μ², infinity for a
/// failure; for a wrong overlap, that of the μ² which would explain it, 0 for a right one.
using Errors = std::array<double, num_searched>;

/// The bound promised for each error.
inline constexpr Errors bounds = {4.0, 4.0, 4.0, 0.0, 0.0};

/// The errors of a generation of pairs.
inline std::vector<Errors> judge(std::vector<Pair3> const &pairs)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    auto const batch = run_batch(pairs);
    std::vector<Errors> all;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        double const *r12 = pairs[i].r12.coordinates, *q1 = pairs[i].q1.entries,
                     *q2 = pairs[i].q2.entries;
        auto const exact = truth<Wide>(pairs[i]);
        auto const error_of = [&](int status, double mu2) {
            return status == PW85_SUCCESS && !std::isnan(mu2) ? error_in_units(mu2, exact)
                                                              : infinity;
        };
        auto const error_of_overlap = [&](int status, int overlap) {
            if (status != PW85_SUCCESS) return infinity;
            return overlap == static_cast<int>(exact.mu2 < 1) ? 0.0 : error_in_units(1.0, exact);
        };
        double contact[2], by_brent[2];
        int overlap;
        int const status = pw85_contact(r12, q1, q2, contact);
        int const brent_status = pw85_contact_function(r12, q1, q2, by_brent);
        int const overlap_status = pw85_overlap(r12, q1, q2, &overlap);
        all.push_back({error_of(status, contact[0]), error_of(brent_status, by_brent[0]),
                       error_of(PW85_SUCCESS, batch.mu2[i]),
                       error_of_overlap(overlap_status, overlap),
                       error_of_overlap(PW85_SUCCESS, batch.overlap[i])});
    }
    return all;
}

/// (1 + εX) Q (1 + εX)ᵀ for random X: definite if Q is, to rounding.
inline pw85::SymmetricMatrix<double, 3> deformed(Random &random, double epsilon,
                                                 pw85::SymmetricMatrix<double, 3> const &q)
{
    double map[3][3];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) map[i][j] = (i == j ? 1.0 : 0.0) + epsilon * random.normal();
    pw85::SymmetricMatrix<double, 3> image{};
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                for (int l = 0; l < 3; ++l) image(i, j) += map[i][k] * q(k, l) * map[j][l];
    return image;
}

/// A pair close to another one: from a unit in the last place to a hundredth away.
inline Pair3 neighbour(Random &random, Pair3 pair)
{
    double const epsilon = random.log_uniform(1e-17, 1e-2), kind = random.uniform(0.0, 3.0);
    if (kind < 2.0)
        for (int i = 0; i < 3; ++i) pair.r12[i] *= 1.0 + epsilon * random.normal();
    if (kind > 1.0 && kind < 2.5) pair.q1 = deformed(random, epsilon, pair.q1);
    if (kind > 1.5) pair.q2 = deformed(random, epsilon, pair.q2);
    return pair;
}

inline bool is_definite(Pair3 const &p)
{
    return pw85::detail::is_positive_definite(p.q1) && pw85::detail::is_positive_definite(p.q2);
}

/// The worst pairs of each function among pairs of aspect ratios in a range.
class WorstPairs {
  public:
    struct Climber {
        Pair3 pair;
        double error;
    };

    WorstPairs(double aspect_min, double aspect_max)
        : aspect_min_(aspect_min), aspect_max_(aspect_max),
          random_(static_cast<std::uint64_t>(aspect_min))
    {
        for (auto &climbers : climbers_)
            for (std::size_t i = 0; i < num_climbers; ++i) climbers.push_back({fresh(), 0.0});
    }

    /// Judges so many pairs more, or a few more than that.
    void search(long pairs)
    {
        for (long const end = judged_ + pairs; judged_ < end;) step();
    }

    long judged() const { return judged_; }

    /// The number of pairs on which a function broke its bound.
    long broken(int function) const { return broken_[static_cast<std::size_t>(function)]; }

    /// The worst pairs of a function, each of another origin, the worst first; if it never errs,
    /// some pair.
    std::vector<Climber> worst(int function) const
    {
        auto climbers = climbers_[static_cast<std::size_t>(function)];
        std::sort(climbers.begin(), climbers.end(),
                  [](auto const &a, auto const &b) { return a.error > b.error; });
        while (climbers.size() > 1 && climbers.back().error == 0.0) climbers.pop_back();
        return climbers;
    }

  private:
    static constexpr std::size_t num_climbers = 8;

    Pair3 fresh()
    {
        double const aspect = random_.log_uniform(aspect_min_, aspect_max_);
        if (random_.sign() < 0.0) return crossed_pair(random_, aspect);
        double const mu2 = 1.0 + random_.sign() * random_.log_uniform(1e-14, 1e-1);
        return random_pair<3>(random_, {.aspect = aspect,
                                        .size_ratio = 10.0,
                                        .mu2_min = mu2,
                                        .mu2_max = mu2,
                                        .aspect_min = aspect_min_});
    }

    /// A pair to judge, and whose neighbour it is: a climber of a function, or nobody's.
    struct Candidate {
        Pair3 pair;
        std::size_t function = 0;
        Climber *parent = nullptr;
    };

    /// One neighbour of each climber that has erred, and fresh pairs, one for each climber.
    void step()
    {
        std::vector<Candidate> candidates;
        for (std::size_t f = 0; f < num_searched; ++f)
            for (Climber &climber : climbers_[f]) {
                if (climber.error > 0.0)
                    candidates.push_back({neighbour(random_, climber.pair), f, &climber});
                candidates.push_back({fresh()});
            }
        std::erase_if(candidates, [](Candidate const &c) { return !is_definite(c.pair); });
        std::vector<Pair3> pairs;
        for (auto const &c : candidates) pairs.push_back(c.pair);
        auto const errors = judge(pairs);
        for (std::size_t i = 0; i < candidates.size(); ++i)
            for (std::size_t f = 0; f < num_searched; ++f) consider(f, candidates[i], errors[i][f]);
        judged_ += static_cast<long>(candidates.size());
    }

    /// A neighbour takes the place of its parent if it is worse; any other pair that of the lowest
    /// climber. The neighbours of another function's climber must top all, lest all climbers be on
    /// one hill.
    void consider(std::size_t function, Candidate const &candidate, double error)
    {
        broken_[function] += error > bounds[function];
        auto const less = [](Climber const &a, Climber const &b) { return a.error < b.error; };
        auto const [lowest, highest] =
            std::minmax_element(climbers_[function].begin(), climbers_[function].end(), less);
        bool const own = candidate.parent != nullptr && candidate.function == function;
        if (candidate.parent != nullptr && !own && error <= highest->error) return;
        Climber &place = own ? *candidate.parent : *lowest;
        if (error > place.error) place = {candidate.pair, error};
    }

    double aspect_min_, aspect_max_;
    Random random_;
    std::array<std::vector<Climber>, num_searched> climbers_;
    std::array<long, num_searched> broken_{};
    long judged_ = 0;
};

} // namespace pw85_tests

#endif

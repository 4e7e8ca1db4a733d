// SPDX-License-Identifier: BSD-3-Clause
// The contact problems of the reference data, for platforms that have no more than a standard
// library: what export_problems.py writes. Programs print what is wrong, and end with a summary.
#ifndef PW85_TESTS_PROBLEMS_HPP_INCLUDED
#define PW85_TESTS_PROBLEMS_HPP_INCLUDED

#include <cmath>
#include <cstdio>
#include <vector>

namespace pw85_tests {

struct Problem {
    double r12[3], q1[6], q2[6];
    double mu2, mu2_minus_1, lambda, cond;
};

/// Empty if the file cannot be read.
inline std::vector<Problem> read_problems(char const *path)
{
    std::vector<Problem> problems;
    if (std::FILE *const file = std::fopen(path, "rb")) {
        for (Problem p; std::fread(&p, sizeof p, 1, file) == 1;) problems.push_back(p);
        std::fclose(file);
    }
    return problems;
}

/// Answers of one function over the problems.
class Answers {
  public:
    explicit Answers(char const *function) : function_(function) {}

    /// No answer may be off by more than 4 u cond, as the functions promise.
    void add_contact(Problem const &p, int status, double mu2)
    {
        double const units = std::fabs(mu2 - p.mu2) / (0x1p-53 * p.cond * p.mu2);
        if (units > worst_) worst_ = units;
        add(p, status == 0 && units <= 4.0, mu2);
    }

    /// Two ellipsoids that touch do not overlap.
    void add_overlap(Problem const &p, int status, int overlap)
    {
        add(p, status == 0 && overlap == (p.mu2_minus_1 < 0.0 ? 1 : 0), overlap);
    }

    /// Prints the summary; whether all answers are right.
    bool summarize() const
    {
        std::printf("%s: %ld answers, %ld wrong", function_, answers_, wrong_);
        if (worst_ >= 0.0) std::printf(", largest error %.2f u cond", worst_);
        std::printf("\n");
        return answers_ > 0 && wrong_ == 0;
    }

  private:
    void add(Problem const &p, bool right, double answer)
    {
        ++answers_;
        if (right) return;
        ++wrong_;
        if (wrong_ > 10) return;
        std::printf("%s: %a for", function_, answer);
        for (double const *x = p.r12; x < p.r12 + 15; ++x) std::printf(" %a", *x);
        std::printf("\n");
    }

    char const *function_;
    long answers_ = 0, wrong_ = 0;
    double worst_ = -1.0;
};

} // namespace pw85_tests

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Proofs on record. A proof by branch and bound takes up to two minutes, and it says the same as
/// long as its function and its limit are the same. So the record has, for each, the limit and the
/// mean of the bounds on a few boxes. Any change of a formula, of a constant, or of the arithmetic
/// on boxes moves one of them. Proofs of one or two angles are fast, and are always made anew.
#ifndef PW85_TESTS_BOUNDS_RECORD_HPP_INCLUDED
#define PW85_TESTS_BOUNDS_RECORD_HPP_INCLUDED

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>

#include "branch_and_bound.hpp"

namespace pw85_bounds {

class Record {
  public:
    enum class Use {
        prove, ///< all proofs are made anew, and must be those on record
        recall ///< long proofs are looked up
    };

    Record(Use use, char const *file) : use_(use)
    {
        std::ifstream lines(file);
        for (std::string line; std::getline(lines, line);) text_ += line + '\n';
    }

    /// Proves that a function is nowhere above a limit, or recalls that this was proved.
    template <int N, class Function> Proof settle(std::string const &what, Function &function,
                                                  double const *ranges, double limit,
                                                  long most_boxes)
    {
        if (N <= 2) return prove<N>(function, ranges, limit, most_boxes);
        std::string const entry =
            what + ": " + text_of(limit) + ", " + text_of(mean_bound<N>(function, ranges)) + '\n';
        bool const known = text_.find(entry) != std::string::npos;
        is_complete_ = is_complete_ && known;
        if (!known) std::printf("NOT ON RECORD: %s", entry.c_str());
        return use_ == Use::recall ? Proof{known, 0, 0.0}
                                   : prove<N>(function, ranges, limit, most_boxes);
    }

    /// Whether all that was settled is on record as it is now.
    bool is_complete() const { return is_complete_; }

  private:
    /// As many digits as sines and cosines of all C libraries agree on.
    static std::string text_of(double x)
    {
        char text[32];
        std::snprintf(text, sizeof text, "%.9g", x);
        return text;
    }

    template <int N, class Function>
    static double mean_bound(Function &function, double const *ranges)
    {
        constexpr int boxes = 16;
        std::uint64_t state = 1;
        auto const uniform = [&state] {
            state = state * 6364136223846793005u + 1442695040888963407u; // Knuth's generator
            return static_cast<double>(state >> 11) * 0x1p-53;
        };
        double sum = 0.0;
        for (int n = 0; n < boxes; ++n) {
            Box<N> box;
            for (int k = 0; k < N; ++k) {
                box.center[k] = ranges[k] * uniform();
                box.width[k] = std::ldexp(uniform(), -4 - n % 4);
            }
            double variation[std::size_t(N)] = {};
            sum += function.bound(box, std::numeric_limits<double>::infinity(), variation);
        }
        return sum / boxes;
    }

    Use use_;
    std::string text_;
    bool is_complete_ = true;
};

} // namespace pw85_bounds

#endif

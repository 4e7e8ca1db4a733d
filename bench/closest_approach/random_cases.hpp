// Random pairs for the distance of closest approach, with axes and angles as well as forms.
#ifndef PW85_BENCH_CLOSEST_APPROACH_RANDOM_CASES_HPP_INCLUDED
#define PW85_BENCH_CLOSEST_APPROACH_RANDOM_CASES_HPP_INCLUDED

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <pw85/pw85.hpp>

#include "published.hpp"

namespace pw85_bench {

/// Two ellipses of the given aspect ratio, and sizes that differ by a factor of up to 2, in random orientations.
struct EllipseCase {
    published::Ellipse ellipse1, ellipse2;
    pw85::Vector<double, 2> direction;
    pw85::SymmetricMatrix<double, 2> q1, q2;
};

/// Two general ellipsoids likewise; the middle semi-axis is random.
struct EllipsoidCase {
    published::Ellipsoid ellipsoid1, ellipsoid2;
    pw85::Vector<double, 3> direction;
    pw85::SymmetricMatrix<double, 3> q1, q2;
};

class RandomCases {
  public:
    std::vector<EllipseCase> ellipses(int count, double aspect)
    {
        std::vector<EllipseCase> cases;
        for (int i = 0; i < count; ++i) {
            auto const e1 = ellipse(1.0, aspect), e2 = ellipse(1.0 + uniform_(bits_), aspect);
            double const angle = 2.0 * std::numbers::pi * uniform_(bits_);
            cases.push_back({e1,
                             e2,
                             {std::cos(angle), std::sin(angle)},
                             pw85::ellipse(e1.a, e1.b, e1.angle).q,
                             pw85::ellipse(e2.a, e2.b, e2.angle).q});
        }
        return cases;
    }

    std::vector<EllipsoidCase> ellipsoids(int count, double aspect)
    {
        std::vector<EllipsoidCase> cases;
        for (int i = 0; i < count; ++i) {
            EllipsoidCase c{};
            place(c.ellipsoid1, c.q1, 1.0, aspect);
            place(c.ellipsoid2, c.q2, 1.0 + uniform_(bits_), aspect);
            c.direction = {normal_(bits_), normal_(bits_), normal_(bits_)};
            c.direction = pw85::times(1.0 / std::sqrt(pw85::dot(c.direction, c.direction)), c.direction);
            cases.push_back(c);
        }
        return cases;
    }

  private:
    published::Ellipse ellipse(double size, double aspect)
    {
        return {size, size / aspect, std::numbers::pi * uniform_(bits_)};
    }

    void place(published::Ellipsoid &e, pw85::SymmetricMatrix<double, 3> &q, double size, double aspect)
    {
        pw85::Vector<double, 4> const turn{normal_(bits_), normal_(bits_), normal_(bits_), normal_(bits_)};
        auto const rotation = pw85::rotation_matrix(turn, pw85::dot(turn, turn));
        e.semi_axes = {size, size / std::pow(aspect, uniform_(bits_)), size / aspect};
        for (int k = 0; k < 3; ++k) e.axes[k] = {rotation.entries[k], rotation.entries[3 + k], rotation.entries[6 + k]};
        q = pw85::ellipsoid(e.semi_axes, rotation.entries).q;
    }

    std::mt19937_64 bits_{2008};
    std::normal_distribution<double> normal_;
    std::uniform_real_distribution<double> uniform_;
};

} // namespace pw85_bench

#endif

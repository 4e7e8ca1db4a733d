// Slender ellipsoids at right angles, nearly tangent: where t is nearly free, so that nothing but the margins decides.
#ifndef PW85_TESTS_CROSSED_PAIRS_HPP_INCLUDED
#define PW85_TESTS_CROSSED_PAIRS_HPP_INCLUDED

#include "random_pairs.hpp"

namespace pw85_tests {

/// A vector turned by a unit quaternion (w, x, y, z).
inline pw85::Vector<double, 3> turn(pw85::Vector<double, 4> const &q, pw85::Vector<double, 3> const &x)
{
    pw85::Vector<double, 3> const axis{q[1], q[2], q[3]};
    auto const once = pw85::cross(axis, x), twice = pw85::cross(axis, once);
    return {x[0] + 2 * (q[0] * once[0] + twice[0]), x[1] + 2 * (q[0] * once[1] + twice[1]),
            x[2] + 2 * (q[0] * once[2] + twice[2])};
}

/// Needles or ribbons of the given aspect ratio, the second of any size up to four times the first's, either way.
template <int D> Sample<double, D> crossed_pair(Random &random, double aspect)
{
    double const size = random.log_uniform(0.25, 4.0);
    auto const offset = [&] { return std::copysign(random.log_uniform(1e-15, 0.3), random.uniform(-1.0, 1.0)); };
    double const x = 1.0 + offset(), y = size * (1.0 + offset());
    if constexpr (D == 2) {
        double const angle = random.uniform(0.0, std::numbers::pi), c = std::cos(angle), s = std::sin(angle);
        return {{c * x - s * y, s * x + c * y},
                pw85::ellipse(1.0, 1.0 / aspect, angle).q,
                pw85::ellipse(size / aspect, size, angle).q};
    } else {
        auto const q = random.direction<4>();
        double const third1 = 1.0 / random.log_uniform(1.0, aspect), third2 = size / random.log_uniform(1.0, aspect);
        pw85::Vector<double, 3> const axes1{1.0, 1.0 / aspect, third1}, axes2{size / aspect, size, third2};
        return {turn(q, {x, y, offset() * (third1 + third2)}), pw85::ellipsoid_quaternion(axes1, q).q,
                pw85::ellipsoid_quaternion(axes2, q).q};
    }
}

} // namespace pw85_tests

#endif

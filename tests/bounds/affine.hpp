// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Affine arithmetic with N variables ε_i in [-1, 1]: a number is center + Σ slopes_i ε_i ± rest,
/// where `rest` bounds everything else, terms of higher order and the rounding errors of this
/// arithmetic included. Unlike intervals, such numbers know that x - x is 0, so that bounds on a
/// small box err by the square of its size.
#ifndef PW85_TESTS_BOUNDS_AFFINE_HPP_INCLUDED
#define PW85_TESTS_BOUNDS_AFFINE_HPP_INCLUDED

#include <cmath>

namespace pw85_bounds {

template <int N> struct Affine {
    double center = 0.0;
    double slopes[std::size_t(N)] = {};
    double rest = 0.0;

    Affine() = default;
    Affine(double x) : center(x) {}

    /// The largest deviation from the center, rounded up.
    double radius() const
    {
        double sum = rest;
        for (double const slope : slopes) sum += std::fabs(slope);
        return sum * (1.0 + (N + 2) * 0x1p-52);
    }
    /// The largest magnitude.
    double most() const { return std::fabs(center) + radius(); }
    /// Bounds, rounded outwards.
    double largest() const { return center + radius() + std::fabs(center) * 0x1p-52; }
    double smallest() const { return center - radius() - std::fabs(center) * 0x1p-52; }

    /// Adds a bound on the rounding errors of one operation below. Its numbers take fewer than N² +
    /// 4N + 16 operations, cosines and sines by 1 ulp included, and none of their results exceeds
    /// `magnitude`.
    Affine &roundings(double magnitude)
    {
        rest += (N * N + 4 * N + 16) * 0x1p-53 * magnitude;
        return *this;
    }

    Affine &operator+=(Affine const &y)
    {
        double const magnitude = most() + y.most();
        add(y);
        return roundings(magnitude);
    }
    friend Affine operator+(Affine x, Affine const &y) { return x += y; }

    /// Adds y without the roundings, which are for the caller to add: those of a long sum all at
    /// once.
    void add(Affine const &y)
    {
        center += y.center;
        for (int i = 0; i < N; ++i) slopes[i] += y.slopes[i];
        rest += y.rest;
    }

    /// a x + b y, by three operations for each of its numbers.
    friend Affine combination(Affine const &x, double a, Affine const &y, double b)
    {
        Affine z(x.center * a + y.center * b);
        for (int i = 0; i < N; ++i) z.slopes[i] = x.slopes[i] * a + y.slopes[i] * b;
        z.rest = x.rest * std::fabs(a) + y.rest * std::fabs(b);
        return z.roundings(x.most() * std::fabs(a) + y.most() * std::fabs(b));
    }

    friend Affine operator-(Affine x)
    {
        x.center = -x.center;
        for (double &slope : x.slopes) slope = -slope;
        return x;
    }

    friend Affine operator-(Affine const &x, Affine const &y) { return x + -y; }

    /// Products of two slopes are c ε_i², which is in c/2 ± c/2, or c ε_i ε_j, which is in ± c.
    friend Affine operator*(Affine const &x, Affine const &y)
    {
        double const mx = x.most(), my = y.most();
        Affine z(x.center * y.center);
        for (int i = 0; i < N; ++i) {
            z.slopes[i] = x.center * y.slopes[i] + y.center * x.slopes[i];
            double const half = 0.5 * x.slopes[i] * y.slopes[i];
            z.center += half;
            z.rest += std::fabs(half);
            for (int j = 0; j < i; ++j)
                z.rest += std::fabs(x.slopes[i] * y.slopes[j] + x.slopes[j] * y.slopes[i]);
        }
        z.rest += mx * y.rest + my * x.rest;
        return z.roundings(mx * my);
    }

    friend Affine operator*(Affine x, double factor)
    {
        double const magnitude = x.most() * std::fabs(factor);
        x.center *= factor;
        for (double &slope : x.slopes) slope *= factor;
        x.rest *= std::fabs(factor);
        return x.roundings(magnitude);
    }

    /// An upper bound on |x|, x or -x where the sign is known. On [-l, u] it is the chord ((u - l)
    /// x + 2 l u)/(u + l).
    friend Affine magnitude(Affine const &x)
    {
        double const u = x.largest(), l = -x.smallest();
        if (l <= 0.0) return x;
        if (u <= 0.0) return -x;
        return x * ((u - l) / (u + l)) + Affine(2.0 * (l / (u + l)) * u).roundings(u + l);
    }

    /// cos(angle) for angle in center ± width, ε_k its deviation over the width. The remainder of
    /// Taylor's series is below width²/2; it is centred.
    static Affine cosine(int k, double center, double width)
    {
        Affine z(std::cos(center));
        z.slopes[k] = -std::sin(center) * width;
        z.rest = 0.5 * width * width;
        return z.roundings(1.0 + width);
    }
    static Affine sine(int k, double center, double width)
    {
        Affine z(std::sin(center));
        z.slopes[k] = std::cos(center) * width;
        z.rest = 0.5 * width * width;
        return z.roundings(1.0 + width);
    }
};

} // namespace pw85_bounds

#endif

// SPDX-License-Identifier: BSD-3-Clause
// The least value of a function of one number by golden section.
#ifndef PW85_TESTS_GOLDEN_SECTION_HPP_INCLUDED
#define PW85_TESTS_GOLDEN_SECTION_HPP_INCLUDED

namespace pw85_tests {

template <class T> struct Interval {
    T low, high;
};

/// Narrows an interval around the least value of f. Each step leaves 0.618 of it. f has one
/// minimum, and falls or is infinite to the left of it.
template <class T, class Function>
Interval<T> golden_section(Function const &f, Interval<T> x, int steps)
{
    T const golden = (sqrt(T(5)) - 1) / 2;
    T left = x.high - golden * (x.high - x.low), right = x.low + golden * (x.high - x.low);
    T at_left = f(left), at_right = f(right);
    for (int n = 0; n < steps; ++n)
        if (at_left >= at_right) {
            x.low = left;
            left = right;
            at_left = at_right;
            right = x.low + golden * (x.high - x.low);
            at_right = f(right);
        } else {
            x.high = right;
            right = left;
            at_right = at_left;
            left = x.high - golden * (x.high - x.low);
            at_left = f(left);
        }
    return x;
}

} // namespace pw85_tests

#endif

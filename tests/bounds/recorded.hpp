// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A scalar that records the arithmetic that is done with it. The templates of the library run on
/// it, so that the bounds of this folder are bounds for the code itself.
#ifndef PW85_TESTS_BOUNDS_RECORDED_HPP_INCLUDED
#define PW85_TESTS_BOUNDS_RECORDED_HPP_INCLUDED

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <pw85/pw85.hpp>

namespace pw85_bounds {

enum class Operation { input, constant, sum, difference, product, quotient, negation };

/// One result of arithmetic. Operands come before results.
struct Node {
    Operation operation;
    int left, right; ///< operands; -1 where there is none
    double value;    ///< for the sample at which the graph is recorded
    /// false where the result is exact: a change of sign, a double, a product with a power of two
    bool rounded;
    bool power;       ///< whether the value is a power of two
    std::string name; ///< of an input
};

using Graph = std::vector<Node>;

/// The graph that is being recorded.
inline Graph *recording = nullptr;

inline int append(Node node)
{
    recording->push_back(std::move(node));
    return static_cast<int>(recording->size()) - 1;
}

inline bool is_power_of_two(double x)
{
    int exponent;
    return x != 0.0 && std::fabs(std::frexp(x, &exponent)) == 0.5;
}

/// A comparison `more` > `less`, or several of them that were joined.
struct Comparison {
    bool value;
    std::vector<std::pair<int, int>> sides; ///< more, less

    friend Comparison joined(bool both, Comparison x, Comparison const &y)
    {
        x.value = both;
        x.sides.insert(x.sides.end(), y.sides.begin(), y.sides.end());
        return x;
    }
    friend Comparison operator&&(Comparison const &x, Comparison const &y)
    {
        return joined(x.value && y.value, x, y);
    }
    friend Comparison operator||(Comparison const &x, Comparison const &y)
    {
        return joined(x.value || y.value, x, y);
    }
    friend Comparison operator!(Comparison x)
    {
        x.value = !x.value;
        return x;
    }
    friend bool any_of(Comparison const &x) { return x.value; }
    friend bool all_of(Comparison const &x) { return x.value; }
};

/// A number. A choice between two numbers takes the branch that the sample takes.
class Recorded {
  public:
    Recorded() = default;
    explicit Recorded(double x)
        : node_(append({Operation::constant, -1, -1, x, false, is_power_of_two(x), {}}))
    {
    }

    static Recorded input(std::string name, double x, bool power = false)
    {
        return from({Operation::input, -1, -1, x, false, power, std::move(name)});
    }

    int node() const { return node_; }
    double value() const { return at(node_).value; }

    friend Recorded operator+(Recorded x, Recorded y)
    {
        return from({Operation::sum,
                     x.node_,
                     y.node_,
                     x.value() + y.value(),
                     x.node_ != y.node_,
                     false,
                     {}});
    }
    friend Recorded operator-(Recorded x, Recorded y)
    {
        return from(
            {Operation::difference, x.node_, y.node_, x.value() - y.value(), true, false, {}});
    }
    friend Recorded operator*(Recorded x, Recorded y)
    {
        bool const exact = at(x.node_).power || at(y.node_).power;
        return from(
            {Operation::product, x.node_, y.node_, x.value() * y.value(), !exact, false, {}});
    }
    friend Recorded operator/(Recorded x, Recorded y)
    {
        return from({Operation::quotient,
                     x.node_,
                     y.node_,
                     x.value() / y.value(),
                     !at(y.node_).power,
                     false,
                     {}});
    }
    friend Recorded operator-(Recorded x)
    {
        return from({Operation::negation, x.node_, -1, -x.value(), false, at(x.node_).power, {}});
    }
    friend Comparison operator>(Recorded x, Recorded y)
    {
        return {x.value() > y.value(), {{x.node_, y.node_}}};
    }
    friend Comparison operator<(Recorded x, Recorded y) { return y > x; }
    friend Comparison operator>=(Recorded x, Recorded y)
    {
        return {x.value() >= y.value(), {{x.node_, y.node_}}};
    }
    friend Comparison operator<=(Recorded x, Recorded y) { return y >= x; }
    friend Recorded abs(Recorded x) { return x.value() < 0.0 ? -x : x; }
    friend Recorded select(Comparison const &c, Recorded yes, Recorded no)
    {
        return c.value ? yes : no;
    }

  private:
    static Node const &at(int node) { return (*recording)[static_cast<std::size_t>(node)]; }
    static Recorded from(Node node)
    {
        Recorded x;
        x.node_ = append(std::move(node));
        return x;
    }

    int node_;
};

} // namespace pw85_bounds

template <> struct pw85::ScalarTraits<pw85_bounds::Recorded> {
    using Lane = double;
    using Mask = pw85_bounds::Comparison;
    static constexpr int lanes = 1;
};

#endif

// Relative error of the distance of closest approach against the aspect ratio, for each method; the truth is the
// contact function with 50 digits. Comma-separated values on standard output.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <pw85_zheng.h>

#include "random_cases.hpp"

using namespace pw85_bench;

namespace {

using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

template <int D> Wide truth(pw85::Vector<double, D> const &direction, pw85::SymmetricMatrix<double, D> const &q1,
                            pw85::SymmetricMatrix<double, D> const &q2)
{
    pw85::Vector<Wide, D> d;
    pw85::SymmetricMatrix<Wide, D> w1, w2;
    for (int i = 0; i < D; ++i) d[i] = direction[i];
    for (int k = 0; k < q1.size; ++k) {
        w1[k] = q1[k];
        w2[k] = q2[k];
    }
    return pw85::closest_approach(d, w1, w2).distance;
}

/// Errors of one method, with one row of the table at the end. What is not a number counts as an error of 1.
class Errors {
  public:
    void add(double actual, Wide const &exact)
    {
        double const error = static_cast<double>(Wide(abs(Wide(actual - exact)) / exact));
        errors_.push_back(error <= 1.0 ? error : 1.0);
    }

    void print(double aspect, char const *method)
    {
        std::sort(errors_.begin(), errors_.end());
        std::printf("%g,%s,%.2g,%.2g,%.2g\n", aspect, method, errors_[errors_.size() / 2],
                    errors_[errors_.size() * 99 / 100], errors_.back());
    }

  private:
    std::vector<double> errors_;
};

template <class Function, class Case> double call(Function function, Case const &c)
{
    double distance;
    function(c.direction.coordinates, c.q1.entries, c.q2.entries, &distance);
    return distance;
}

void ellipses(int count, double aspect)
{
    Errors contact, zheng, original;
    for (auto const &c : RandomCases().ellipses(count, aspect)) {
        Wide const exact = truth(c.direction, c.q1, c.q2);
        contact.add(call(pw85_closest_approach_2d, c), exact);
        zheng.add(call(pw85_zheng_ellipses, c), exact);
        double const angle = std::atan2(c.direction[1], c.direction[0]);
        auto e1 = c.ellipse1, e2 = c.ellipse2;
        e1.angle -= angle;
        e2.angle -= angle;
        original.add(published::ellipses(e1, e2), exact);
    }
    contact.print(aspect, "closest_approach_2d");
    zheng.print(aspect, "zheng_ellipses");
    original.print(aspect, "published_ellipses");
}

void ellipsoids(int count, double aspect)
{
    Errors contact, zheng, original;
    for (auto const &c : RandomCases().ellipsoids(count, aspect)) {
        Wide const exact = truth(c.direction, c.q1, c.q2);
        contact.add(call(pw85_closest_approach, c), exact);
        zheng.add(call(pw85_zheng_ellipsoids, c), exact);
        original.add(published::ellipsoids(c.ellipsoid1, c.ellipsoid2, c.direction), exact);
    }
    contact.print(aspect, "closest_approach");
    zheng.print(aspect, "zheng_ellipsoids");
    original.print(aspect, "published_ellipsoids");
}

} // namespace

int main(int argc, char **argv)
{
    int const count = argc > 1 ? std::max(1, std::atoi(argv[1])) : 1000;
    std::puts("aspect,method,median_error,percentile_99_error,largest_error");
    for (double const aspect : {1.0, 2.0, 4.0, 10.0, 30.0, 100.0, 300.0, 1e3, 3e3, 1e4}) {
        ellipses(count, aspect);
        ellipsoids(count, aspect);
    }
}

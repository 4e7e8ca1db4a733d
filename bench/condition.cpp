// SPDX-License-Identifier: BSD-3-Clause
// Prints how many digits of the contact function random pairs have by their aspect ratio, as CSV.
// The truth is the contact function for the semi-axes and quaternions exactly as given, in 200
// digits. A row has the median and the largest condition number (pw85_condition); the digits of the
// result from forms and from factors, -log10(relative error), the median and the least; and the per
// cent of pairs whose rounded forms are not positive definite, which the other numbers of forms
// leave out.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <pw85.h>

#include <factors.hpp>

using namespace pw85_tests;

namespace {

/// Of each aspect ratio.
constexpr int num_pairs = 1000;

struct Results {
    std::vector<double> conditions, by_forms, by_factors;
    int refused = 0;
};

TruthOfFactors exact_mu2(pw85::Vector<double, 3> const &r12,
                         pw85::Vector<double, 3> const (&axes)[2],
                         pw85::Vector<double, 4> const (&turns)[2])
{
    using pw85::detail::converted;
    auto const form = [&](int i) {
        return pw85::ellipsoid_quaternion(converted<TruthOfFactors>(axes[i]),
                                          converted<TruthOfFactors>(turns[i]))
            .q;
    };
    return pw85::contact(converted<TruthOfFactors>(r12), form(0), form(1)).mu2;
}

/// The correct digits of a result. A result without error has those of a double.
double digits(double mu2, TruthOfFactors const &exact)
{
    double const error = std::fabs(static_cast<double>(TruthOfFactors(mu2 / exact - 1)));
    return -std::log10(std::max(error, 0x1p-53));
}

void add_pair(Random &random, double aspect, Results &results)
{
    pw85::Vector<double, 3> const axes[2] = {
        random.semi_axes(1.0, aspect), random.semi_axes(random.log_uniform(0.5, 2.0), aspect)};
    pw85::Vector<double, 4> const turns[2] = {random.direction<4>(), random.direction<4>()};
    auto const r12 = random.direction<3>();
    auto const exact = exact_mu2(r12, axes, turns);
    double s[2][9], q[2][6], out[2], condition;
    for (int i = 0; i < 2; ++i) {
        pw85_ellipsoid_factor(axes[i].coordinates, turns[i].coordinates, s[i]);
        pw85_ellipsoid_quaternion(axes[i].coordinates, turns[i].coordinates, q[i]);
    }
    if (pw85_contact_factored(r12.coordinates, s[0], s[1], out) == PW85_SUCCESS)
        results.by_factors.push_back(digits(out[0], exact));
    if (pw85_contact(r12.coordinates, q[0], q[1], out) != PW85_SUCCESS) {
        ++results.refused;
        return;
    }
    results.by_forms.push_back(digits(out[0], exact));
    pw85_condition(r12.coordinates, q[0], q[1], out[1], &condition);
    results.conditions.push_back(condition);
}

double median(std::vector<double> &values)
{
    auto const middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double least(std::vector<double> const &values)
{
    return *std::min_element(values.begin(), values.end());
}

} // namespace

int main()
{
    std::puts("aspect,condition_median,condition_largest,forms_median,forms_least,factors_median,"
              "factors_least,refused");
    for (double const aspect : {1.0, 10.0, 100.0, 1e4, 1e6, 1e8}) {
        Random random(90);
        Results r;
        for (int n = 0; n < num_pairs; ++n) add_pair(random, aspect, r);
        std::printf("%g,%.2g,%.2g,%.1f,%.1f,%.1f,%.1f,%.1f\n", aspect, median(r.conditions),
                    *std::max_element(r.conditions.begin(), r.conditions.end()), median(r.by_forms),
                    least(r.by_forms), median(r.by_factors), least(r.by_factors),
                    100.0 * r.refused / num_pairs);
    }
    return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
// What the C functions promise for invalid and extreme input.
#include <limits>

#include "../cases.hpp"
#include "distances.hpp"

using namespace pw85_tests;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();

Sample<double, 2> const ellipses{{1.0, 2.0}, {4.0, 1.0, 3.0}, {1.0, -0.5, 2.0}};
Sample<double, 3> const ellipsoids{
    {1.0, 2.0, -1.0}, {4.0, 1.0, 0.5, 3.0, 0.0, 2.0}, {1.0, -0.5, 0.2, 2.0, 0.1, 5.0}};

template <int D> void expect_failure(Sample<double, D> const &p, int expected)
{
    double distance = 1.0;
    g_assert_cmpint(zheng(p, distance), ==, expected);
    g_assert_true(std::isnan(distance));
}

template <int D> void check_not_finite(Sample<double, D> const &valid)
{
    for (double const bad : {nan, infinity, -infinity}) {
        for (int i = 0; i < D; ++i) {
            auto p = valid;
            p.r12[i] = bad;
            expect_failure(p, PW85_EINVAL);
        }
        for (int k = 0; k < valid.q1.size; ++k) {
            auto p = valid, r = valid;
            p.q1[k] = bad;
            r.q2[k] = bad;
            expect_failure(p, PW85_EINVAL);
            expect_failure(r, PW85_EINVAL);
        }
    }
}

template <int D> void check_zero_direction(Sample<double, D> p)
{
    for (int i = 0; i < D; ++i) p.r12[i] = i % 2 == 0 ? 0.0 : -0.0;
    expect_failure(p, PW85_EINVAL);
}

template <int D> void check_not_definite(Sample<double, D> const &valid)
{
    for (int i = 0; i < D; ++i) {
        auto p = valid, r = valid;
        p.q1(i, i) = 0.0;
        r.q2(i, i) = -r.q2(i, i);
        expect_failure(p, PW85_ENOTPD);
        expect_failure(r, PW85_ENOTPD);
    }
    auto p = valid; // all ones: semi-definite
    for (int k = 0; k < p.q2.size; ++k) p.q2[k] = 1.0;
    expect_failure(p, PW85_ENOTPD);
}

PW85_TEST("/zheng_contract/not_finite")
{
    check_not_finite(ellipses);
    check_not_finite(ellipsoids);
}

PW85_TEST("/zheng_contract/zero_direction")
{
    check_zero_direction(ellipses);
    check_zero_direction(ellipsoids);
}

PW85_TEST("/zheng_contract/not_definite")
{
    check_not_definite(ellipses);
    check_not_definite(ellipsoids);
}

template <class Function, int D> void check_null(Function function, Sample<double, D> const &p)
{
    double const *const d = p.r12.coordinates, *const q1 = p.q1.entries, *const q2 = p.q2.entries;
    g_assert_cmpint(function(d, q1, q2, nullptr), ==, PW85_EINVAL);
    for (int which = 0; which < 3; ++which) {
        double distance = 1.0;
        int const status = function(which == 0 ? nullptr : d, which == 1 ? nullptr : q1,
                                    which == 2 ? nullptr : q2, &distance);
        g_assert_cmpint(status, ==, PW85_EINVAL);
        g_assert_true(std::isnan(distance));
    }
}

PW85_TEST("/zheng_contract/null")
{
    check_null(pw85_zheng_ellipses, ellipses);
    check_null(pw85_zheng_ellipsoids, ellipsoids);
}

/// Semi-axes times `length`, the direction times `stretch`, both powers of two.
template <int D> double scaled_distance(Sample<double, D> const &p, double length, double stretch)
{
    auto const grown = [&](pw85::SymmetricMatrix<double, D> q) {
        for (int k = 0; k < q.size; ++k) q[k] = length * length * q[k];
        return q;
    };
    double distance;
    int const status = zheng({stretch * p.r12, grown(p.q1), grown(p.q2)}, distance);
    g_assert_cmpint(status, ==, PW85_SUCCESS);
    return distance;
}

// 2^±498 is 1e±150. Scaling by powers of two changes no bit once the numbers are in other units
// than the caller's, and no more than the rounding of the norm and of the forms in different units
// before.
template <int D> void check_extreme_scales(Sample<double, D> const &p)
{
    double const plain = scaled_distance(p, 1.0, 1.0);
    for (double const length : {0x1p-498, 0x1p-20, 0x1p20, 0x1p498})
        for (double const stretch : {0x1p-1074, 0x1p-1000, 1.0, 0x1p1000}) {
            double const distance = scaled_distance(p, length, stretch);
            g_assert_cmpfloat(std::fabs(distance / length - plain), <=, 16.0 * u * plain);
        }
}

PW85_TEST("/zheng_contract/extreme_scales")
{
    check_extreme_scales(ellipses);
    check_extreme_scales(ellipsoids);
}

// An ellipsoid 1e300 times as large as the other leaves only its own half-chord.
template <int D> void check_extreme_ratio(Sample<double, D> p)
{
    double distance, swapped;
    for (int k = 0; k < p.q1.size; ++k) {
        p.q1[k] *= 0x1p996;
        p.q2[k] *= 0x1p-996;
    }
    g_assert_cmpint(zheng(p, distance), ==, PW85_SUCCESS);
    g_assert_cmpint(zheng({p.r12, p.q2, p.q1}, swapped), ==, PW85_SUCCESS);
    double const norm = std::sqrt(pw85::dot(p.r12, p.r12));
    double const half_chord =
        norm /
        std::sqrt(pw85::dot(p.r12, pw85::detail::solve(pw85::detail::factorize(p.q1, 0.0), p.r12)));
    g_assert_cmpfloat(std::fabs(distance - half_chord), <=, 64.0 * u * half_chord);
    g_assert_cmpfloat(std::fabs(swapped - half_chord), <=, 64.0 * u * half_chord);
}

PW85_TEST("/zheng_contract/extreme_ratio")
{
    check_extreme_ratio(ellipses);
    check_extreme_ratio(ellipsoids);
}

} // namespace

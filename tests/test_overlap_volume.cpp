// SPDX-License-Identifier: BSD-3-Clause
// Tests of the volume of the common part (include/pw85/volume/).
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <numbers>

#include <glib.h>

#include <pw85.h>
#include <pw85_systems.h>

#include "cases.hpp"
#include "common_part_cases.hpp"
#include "draws.hpp"
#include "rotated.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

using Fine = FineMeasure;

/// Two balls, q = radius², by the formula of two caps in twice as many digits, or two circles by
/// that of two segments. The radii are roots of doubles, and both bodies are given as doubles
/// exactly.
template <int D> void test_balls()
{
    Failures failures;
    Random random(900);
    for (int n = 0; n < draws(4000); ++n) {
        Sample<double, D> p{};
        double const a2 = random.log_uniform(0.1, 10.0), b2 = random.log_uniform(0.1, 10.0);
        for (int i = 0; i < D; ++i) p.q1(i, i) = a2, p.q2(i, i) = b2;
        Wide const a = sqrt(Wide(a2)), b = sqrt(Wide(b2)), inner = abs(a - b);
        double const share =
            n % 2 == 0 ? random.uniform(0.0, 1.0) : 1.0 - random.log_uniform(1e-8, 0.5);
        p.r12 = static_cast<double>(inner + (a + b - inner) * Wide(share)) * random.direction<D>();
        auto const r = convert<Wide>(p.r12);
        Wide const d = sqrt(pw85::dot(r, r)), h = a + b - d;
        if (!(h > 0) || d <= inner) continue;
        Wide const x = (d * d + a * a - b * b) / (2 * d), y = sqrt(Wide(a * a - x * x)),
                   pi = 4 * atan(Wide(1));
        Wide const truth =
            D == 3 ? Wide(pi * h * h * (d * d + 2 * d * (a + b) - 3 * inner * inner) / (12 * d))
                   : Wide(a * a * atan2(y, x) + b * b * atan2(y, Wide(d - x)) - d * y);
        double const actual = measured(p),
                     error = std::abs(static_cast<double>(Wide((Wide(actual) - truth) / truth)));
        // dV/V of a lens is 2 dh/h, and h errs by the roundings of the data, up to (2a + 2b + d) u.
        double const bound = u * (64.0 + 40.0 * static_cast<double>(Wide((a + b + d) / h)));
        failures.check(error <= bound, "relative error of a lens", error, bound,
                       [&] { return hex_text(p); });
    }
}

struct VolumeTruth {
    double r12[3], q1[6], q2[6];
    char const *volume;
    int digits;
    char const *derivatives[15];
};

struct AreaTruth {
    double r12[2], q1[3], q2[3];
    char const *area;
    int digits;
};

constexpr VolumeTruth volume_truths[] = {
#include "volume_truths.inc"
};

constexpr AreaTruth area_truths[] = {
#include "area_truths.inc"
};

template <class Truth, int D> Sample<double, D> sample_of(Truth const &t)
{
    Sample<double, D> p{};
    std::memcpy(p.r12.coordinates, t.r12, sizeof t.r12);
    std::memcpy(p.q1.entries, t.q1, sizeof t.q1);
    std::memcpy(p.q2.entries, t.q2, sizeof t.q2);
    return p;
}

/// Checks the C function against the contract, and the template of 38 digits against 19 of them.
template <int D>
void check_record(Failures &failures, Sample<double, D> const &p, char const *text, int digits)
{
    Fine const truth(text);
    g_assert_cmpint(digits, ==, 30);
    check_bound(failures, p, measured(p), truth);
    double const error = std::abs(static_cast<double>(Fine(measure(convert<Fine>(p)) / truth - 1)));
    failures.check(error < 1e-19, "error in 38 digits", error, 1e-19, [&] { return hex_text(p); });
}

/// Values to 30 digits by two other ways (scripts/volume_truths.py).
PW85_TEST("/overlap_volume/record")
{
    Failures failures;
    for (auto const &t : volume_truths)
        check_record(failures, sample_of<VolumeTruth, 3>(t), t.volume, t.digits);
    for (auto const &t : area_truths)
        check_record(failures, sample_of<AreaTruth, 2>(t), t.area, t.digits);
}

/// Values that others have published.
PW85_TEST("/overlap_volume/published")
{
    double volume = 0.0;
    double const axes[2][3] = {{1.0, 1.0, 0.2}, {0.5, 1.0, 2.0}},
                 quaternions[2][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}};
    double q[2][6];
    for (int i = 0; i < 2; ++i) pw85_ellipsoid_quaternion(axes[i], quaternions[i], q[i]);
    double const r12[3] = {0.3, 0.2, 0.9};
    pw85_overlap_volume(r12, q[0], q[1], &volume);
    g_assert_cmpfloat(std::abs(volume - 0.165834501903), <, 1e-12);
    double e[2][3], area = 0.0;
    pw85_ellipse(43.28271488, 22.83392139, 3.120439222, e[0]);
    pw85_ellipse(32.64211672, 27.84469155, 3.093992268, e[1]);
    double const r[2] = {53.92619514 - 41.94107253, 45.62883047 - 39.78655647};
    pw85_overlap_area_2d(r, e[0], e[1], &area);
    g_assert_cmpfloat(std::abs(area - 2227.351908629), <, 1e-9);
}

/// Random pairs of all kinds against the same templates with 38 digits: the bound on rounding
/// errors, and on the error of the rule, which is refined to other numbers of half-planes there.
template <int D> void test_bound()
{
    Failures failures;
    Random random(901);
    for (int n = 0; n < draws(D == 3 ? 240 : 2000); ++n) {
        PairOptions options{};
        options.aspect = n % 4 == 0 ? 1.1 : n % 4 == 1 ? 3.0 : n % 4 == 2 ? 30.0 : 1000.0;
        options.mu2_min = 1e-3;
        options.mu2_max = 1.0;
        auto const p = random_pair<D>(random, options);
        check_bound(failures, p, measured(p), measure(convert<Fine>(p)));
    }
}

/// Pairs whose errors are 1.8 to 26 times the bound by the digits of the result alone. One more has
/// an error of 4 times the bound if the rim alone is computed by more.
constexpr Sample<double, 3> far_ends[] = {
    {{{-0x1.5a2f14df815d1p-1, -0x1.e3ecc026a3ad1p-2, -0x1.6852fb95d9e07p+0}},
     {{0x1.ebd65e412af93p-9, -0x1.ede0fa738d77ap-7, -0x1.f70d1a194e482p-7, 0x1.2a99bdb6fa76cp-1,
       0x1.f7d52f9ee689ep-2, 0x1.ac19801b702d1p-2}},
     {{0x1.14c3a4fe7f0d7p-1, -0x1.3e73028398cddp-4, 0x1.487ce229425bbp-1, 0x1.7a1c1b3ceaedbp-7,
       -0x1.7e551dfbf4cfep-4, 0x1.9fe4769295a3fp-1}}},
    {{{-0x1.c4028b9e594bp+3, -0x1.18f0dac40131cp-2, 0x1.5a7580b7c8e8ap+2}},
     {{0x1.22388fb4368efp-2, -0x1.71a39b64f2a1ap-5, 0x1.c2ecd278adfe8p-6, 0x1.a9608b9f5aba8p-1,
       0x1.2d71f0020406fp-2, 0x1.efb61247074f8p-2}},
     {{0x1.a9f418ed761ddp+7, 0x1.5f37018190b81p+3, -0x1.2860c38dceeafp+6, 0x1.6f29a0fc04e2dp-1,
       -0x1.16811b3307391p+2, 0x1.bbb485e01028cp+4}}},
    {{{-0x1.26b04e4594d85p+3, 0x1.0eb4ca6b212e8p+3, -0x1.f9c01ec34129p+5}},
     {{0x1.685b564ef2334p-1, 0x1.e9dd114b3d5b6p-5, -0x1.21c1f82a11f88p-2, 0x1.08ef4146361d5p-1,
       0x1.bc40c23fc320ap-3, 0x1.59cc25e2c3b29p-1}},
     {{0x1.739ae05b39942p+6, -0x1.a607991624664p+5, 0x1.1dfd192352391p+9, 0x1.78a125330ee7ep+6,
       -0x1.025969c7f2a68p+9, 0x1.00356b310da5bp+12}}},
    {{{0x1.4f7a4ef984b8cp+5, 0x1.7b5a2aebebad2p+1, 0x1.2052045b695eap+6}},
     {{0x1.8e829cb50a558p-1, 0x1.238c55e4d4b5ep-2, 0x1.7b447e6c74e4ep-3, 0x1.eab83b2b33a26p-2,
       0x1.0687c68ce6d4ep-5, 0x1.807baf85f642cp-2}},
     {{0x1.021160798183ap+11, 0x1.067b556a0a2bcp+7, 0x1.79cb865de9518p+11, 0x1.0c99ee528e9bcp+3,
       0x1.766e3b801c143p+7, 0x1.49ec197f0bb74p+12}}},
    {{{-0x1.8024070820d86p+2, 0x1.473585e2498cdp+4, 0x1.2d0cf22a44e36p-1}},
     {{0x1.939ec2a4fed3cp-2, 0x1.a9177a3516968p-5, 0x1.c45885eea9499p-3, 0x1.47ebd67f3e811p-1,
       -0x1.b044195f710c8p-3, 0x1.a188d7327021bp-1}},
     {{0x1.cc046081490c2p+7, -0x1.fdb369e742b2p+5, -0x1.c2377957d11cp-5, 0x1.d6c1306347268p+8,
       0x1.92621f7964af2p+3, 0x1.72cb420702538p-2}}},
    {{{0x1.d13dfd73e3c11p-1, -0x1.7aa8a91749ca2p-3, -0x1.6d996c872349ep-3}},
     {{0x1.e675e74bb32f8p-2, 0x1.9c21f7d69bf72p-4, -0x1.f2399c36b2f38p-2, 0x1.af75d4b4da892p-6,
       -0x1.aa66b5f768cf9p-4, 0x1.0435e70b18714p-1}},
     {{0x1.ddf8e8e5f4275p-2, 0x1.8854d96e15acbp-2, 0x1.82873eeb25059p-1, 0x1.ec1f3fa55be1p-1,
       0x1.b2e7c659fb4b2p-1, 0x1.50ee2025a80a4p+0}}},
};

/// The end of a long needle, or the edge of a large disc, in a small body. The numbers of the rim
/// are then small differences of those of the joint frame.
PW85_TEST("/overlap_volume/ends")
{
    Failures failures;
    auto const check = [&](Sample<double, 3> const &p) {
        double const volume = pw85::overlap_volume(p.r12, p.q1, p.q2).volume;
        check_bound(failures, p, volume, measure(convert<Fine>(p)));
    };
    for (auto const &p : far_ends) check(p);
    Random random(914);
    for (int n = 0; n < draws(240); ++n) {
        double const length = random.log_uniform(4.0, 120.0);
        Sample<double, 3> p{
            {}, random.form(1.0, 2.0), random.form(length, length / random.log_uniform(0.05, 0.5))};
        Vector3 const normal = random.direction<3>();
        Vector3 const end = 1.0 / std::sqrt(pw85::detail::quadratic_form(p.q2, normal)) *
                            pw85::product(p.q2, normal);
        p.r12 = random.uniform(0.0, 0.7) * random.direction<3>() - random.uniform(0.9, 1.0) * end;
        check(p);
    }
}

/// A pair, and the share of the smaller body that both have in common, by an integral over sections
/// across the direction of contact which shares nothing with the library.
struct ThinLens {
    Sample<double, 3> pair;
    double share;
};

/// Errors were 266 times the bound where rounded forms of turned bodies moved the surfaces by more
/// than these overlap, and 393 and 38 times where a disc of aspect 10⁶ and more cuts off a cap. The
/// last one had an error of 866 times the bound, as the rule ended by the larger one of both areas.
constexpr ThinLens thin_lenses[] = {
    {{{{0x1.41182682e79e7p+9, -0x1.7d3f9a3339331p+11, -0x1.2aacaece9cb7bp+10}},
      {{0x1.0922074953011p+19, -0x1.dd954ac8b62e5p+19, 0x1.e6ea8c03f1698p+19, 0x1.3f0d567a66923p+21,
        -0x1.637f2080cebd6p+19, 0x1.83121a1b71f08p+21}},
      {{0x1.d65eb21c3bf06p+14, -0x1.0d1f0434c8ddbp+18, -0x1.b229936ff675ep+17,
        0x1.33f4477c3cbe5p+21, 0x1.f0cf6af5e8763p+20, 0x1.90bdf63f17841p+20}}},
     2.0181541578210373e-22},
    {{{{-0x1.64bf3fcd7240dp-6, 0x1.6d8ebcfdbaadap-4, 0x1.fff25c163d50bp-8}},
      {{0x1.85bd102540637p-57, 0.0, 0.0, 0x1.9c20f342a20b6p-57, 0.0, 0x1p-14}},
      {{0x1.2fcf1d4fdd89bp-9, 0.0, 0.0, 0x1.481d7c9e72d5ap-7, 0.0, 0x1.0f98b296e4ca9p-45}}},
     2.337784746709338e-13},
    {{{{-0x1.ffdfa2717bfefp+23, -0x1.94ac36a56106cp+20, 0x1.ed7f797f8beebp+23}},
      {{0x1p+48, 0.0, 0.0, 0x1.0e9a7af298fcap+15, 0.0, 0x1.34a70c9d7781ap+12}},
      {{0x1.917549bbfe81ap+6, 0.0, 0.0, 0x1.19ae99bf3b949p+45, 0.0, 0x1p+48}}},
     2.6762581521382907e-13},
    {{{{-0x1.270e99ac36a3fp-18, -0x1.9d6c12e037c44p-7, -0x1.3055c32dac464p-20}},
      {{0x1.1d2f8d38a6a99p-81, 0.0, 0.0, 0x1.066f0f1ec7014p-80, 0.0, 0x1p-38}},
      {{0x1.6d083228d4841p-13, 0.0, 0.0, 0x1.4dd2f3b258af5p-13, 0.0, 0x1.99ff30c614596p-13}}},
     0.07368835804718895},
};

/// Parts of needles of aspect 10⁶ in bodies that are 10⁵ times smaller: 32 digits gave 0.0110 for
/// 0.0113, and an error of 3 times the bound.
constexpr ThinLens needles_in_small_bodies[] = {
    {{{{0x1.2045645e5399ep-20, 0x1.65864bbba252ap-42, 0x1.ede8add25d32bp-56}},
      {{0x1.c7b4db98af593p-109, 0.0, 0.0, 0x1p-74, 0.0, 0x1.4041f2a4e6f56p-110}},
      {{0x1.449c34a3c3147p-40, 0.0, 0.0, 0x1.7a9c08bbb94cep-42, 0.0, 0x1.f662381e1c95bp-86}}},
     0.011266868091824431},
    {{{{-0x1.e5e2ded297afdp+18, -0x1.1b1ddb26882d9p+19, 0x1.2546293e0ba6ep+39}},
      {{0x1.596dfde17bd37p+38, 0.0, 0.0, 0x1.eedc71590ea12p+39, 0.0, 0x1p+40}},
      {{0x1.333104b0169e9p+44, 0.0, 0.0, 0x1.c76de063bb248p+46, 0.0, 0x1.4ff9c13fe369ap+78}}},
     1.3455455087746366e-05},
};

/// Balls that touch large bodies from inside but for 10⁻²¹ of their size, and cross them elsewhere.
/// Errors were 5·10⁵ and 10⁶ times the bound. The shares are means of those of pairs that are moved
/// to both sides by 10⁻¹³ to 10⁻¹⁰ of their distance, which agree to 10⁻¹⁴.
constexpr ThinLens nearly_touching_balls[] = {
    {{{{-0x1.0cf6cca3e2d67p+9, 0x1.11cc3ba9af2ffp-8, -0x1.56dbd2fa2df6p-8}},
      {{1.0, 0.0, 0.0, 1.0, 0.0, 1.0}},
      {{0x1.1ba2e07173076p+18, 0.0, 0.0, 0x1.0e301e7781b17p+11, 0.0, 0x1.f78d6eca12d7bp+1}}},
     0.16980906334412818},
    {{{{-0x1.cd2c7b3ac9db1p+4, 0x1.b930d46ddb3adp-14, -0x1.967153cbc2be1p-3}},
      {{1.0, 0.0, 0.0, 1.0, 0.0, 1.0}},
      {{0x1.bcce379472b62p+9, 0.0, 0.0, 0x1.286b249e76453p+2, 0.0, 0x1.c4b242201258ap+7}}},
     0.697418026335251},
};

/// Two discs of which one is inside the other one but for 10⁻¹⁴ of its size at one end, and crosses
/// it elsewhere. Types without exact decisions took it as wholly inside after 16 steps.
constexpr ThinLens nearly_nested_discs = {
    {{{-0x1.1d139f9a98a54p+16, -0x1.1eb589e555ef8p+14, -0x1.4345c84039b89p-29}},
     {{0x1.27f919f6a8c11p+31, 0.0, 0.0, 0x1p+34, 0.0, 0x1.c2ad37a1b1795p-2}},
     {{0x1.d617da9b6d56bp+33, 0.0, 0.0, 0x1.6c078b0546abdp+35, 0.0, 0x1.9f8877a421febp-1}}},
    0.99450404231842526};

/// A number within the bound, or the status that there is none.
void check_bound_or_status(Failures &failures, ThinLens const &lens)
{
    auto const &[p, share] = lens;
    double volume = 0.0;
    int const status = pw85_overlap_volume(p.r12.coordinates, p.q1.entries, p.q2.entries, &volume);
    if (status == PW85_ECONVERGENCE) return;
    g_assert_cmpint(status, ==, PW85_SUCCESS);
    check_bound(failures, p, volume, Fine(share) * Fine(smaller_of(p)));
}

/// Where a body reaches farthest along a normal, and how far, for its form exactly as given.
Fine support(Form3 const &q, Vector3 const &normal, pw85::Vector<Fine, 3> &point)
{
    auto const wide = convert<Fine>(q);
    auto const n = convert<Fine>(normal);
    Fine const reach = sqrt(pw85::detail::quadratic_form(wide, n));
    point = Fine(1 / reach) * pw85::product(wide, n);
    return reach;
}

/// Turned needles and discs of aspect ratios to 10⁷ that overlap by 10⁻¹² to 10⁻² of the thinner
/// one along a normal, beside each other and beside round bodies.
PW85_TEST("/overlap_volume/thin_lenses")
{
    Failures failures;
    for (auto const &[p, share] : thin_lenses) {
        double const smaller = smaller_of(p);
        check_bound(failures, p, measured(p), Fine(share) * Fine(smaller));
    }
    for (auto const &[p, share] : nearly_touching_balls)
        check_bound(failures, p, measured(p), Fine(share) * Fine(smaller_of(p)));
    for (auto const &lens : needles_in_small_bodies) check_bound_or_status(failures, lens);
    check_bound_or_status(failures, nearly_nested_discs);
    auto const &[discs, share_of_discs] = nearly_nested_discs;
    check_bound(failures, discs, static_cast<double>(measure(convert<Fine>(discs))),
                Fine(share_of_discs) * Fine(smaller_of(discs)));
    Random random(915);
    long compared = 0, solved = 0, lenses = 0;
    for (int n = 0; n < draws(400); ++n) {
        Sample<double, 3> p{{},
                            random.form(1.0, random.log_uniform(1e5, 1e7)),
                            random.form(random.log_uniform(1e-3, 1e3),
                                        n % 3 == 0 ? 3.0 : random.log_uniform(1e5, 1e7))};
        Vector3 const normal = random.direction<3>();
        pw85::Vector<Fine, 3> point1{}, point2{};
        Fine const reach1 = support(p.q1, normal, point1), reach2 = support(p.q2, normal, point2);
        Fine const depth =
            Fine(random.log_uniform(1e-12, 1e-2)) * (reach1 < reach2 ? reach1 : reach2);
        p.r12 = convert<double>(point1 + point2 - depth * convert<Fine>(normal));
        int overlaps = 0;
        pw85_overlap(p.r12.coordinates, p.q1.entries, p.q2.entries, &overlaps);
        if (overlaps == 0) continue; // by the roundings of r12
        ++lenses;
        double volume = 0.0;
        int const status =
            pw85_overlap_volume(p.r12.coordinates, p.q1.entries, p.q2.entries, &volume);
        if (status == PW85_ECONVERGENCE) continue; // a disc too thin for the other body
        g_assert_cmpint(status, ==, PW85_SUCCESS);
        ++solved;
        Fine const truth = measure(convert<Fine>(p));
        if (!(truth >= 0)) continue; // its rule has too few nodes for 38 digits
        ++compared;
        check_bound(failures, p, volume, truth);
    }
    g_test_message("%ld of %ld lenses have a volume, %ld a truth", solved, lenses, compared);
    g_assert_cmpint(10 * compared, >=, 9 * lenses);
}

/// Surfaces that touch from inside at a point, or nearly. Many of their rims cross themselves
/// there, or would.
PW85_TEST("/overlap_volume/touching")
{
    Failures failures;
    Random random(913);
    for (int n = 0; n < draws(80); ++n) {
        Sample<double, 3> p{
            {}, random.form(1.0, 3.0), random.form(random.log_uniform(0.7, 1.4), 3.0)};
        Vector3 const normal = random.direction<3>();
        Vector3 const point1 = 1.0 / std::sqrt(pw85::detail::quadratic_form(p.q1, normal)) *
                               pw85::product(p.q1, normal);
        Vector3 const point2 = 1.0 / std::sqrt(pw85::detail::quadratic_form(p.q2, normal)) *
                               pw85::product(p.q2, normal);
        p.r12 = point1 - point2 + random.sign() * random.log_uniform(1e-12, 1e-3) * normal;
        check_bound(failures, p, measured(p), measure(convert<Fine>(p)));
    }
}

/// Needles and discs with aspect ratios to 10⁶ whose axes are the coordinate axes, so that the data
/// lose nothing.
PW85_TEST("/overlap_volume/slender")
{
    Failures failures;
    Random random(902);
    for (int n = 0; n < draws(200); ++n) {
        Sample<double, 3> p{};
        for (int i = 0; i < 3; ++i) {
            p.q1(i, i) = random.log_uniform(1e-12, 1.0);
            p.q2(i, i) = random.log_uniform(1e-12, 1.0);
            p.r12[i] = random.uniform(-0.5, 0.5) * (std::sqrt(p.q1(i, i)) + std::sqrt(p.q2(i, i)));
        }
        double actual = 0.0;
        int const status =
            pw85_overlap_volume(p.r12.coordinates, p.q1.entries, p.q2.entries, &actual);
        if (status == PW85_ECONVERGENCE) continue; // a disc too thin
        g_assert_cmpint(status, ==, PW85_SUCCESS);
        Fine const truth = measure(convert<Fine>(p));
        double const error = std::abs(static_cast<double>(Fine(Fine(actual) - truth)));
        double const smaller = smaller_of(p), bound = 1e-12 * smaller;
        failures.check(error <= bound, "error", error, bound, [&] { return hex_text(p); });
    }
}

/// Integrands of which only the first number is not 0: the values of a function of the number of
/// half-planes so far.
template <class Value> struct Values {
    Value const &value;
    int &count;
};

template <class Value> void add_integrands(Values<Value> const &values,
                                           pw85::detail::RimDirection<double> const &,
                                           bool has_image, pw85::detail::RimSums<double, 3> &sums)
{
    for (int k = 0; k < (has_image ? 2 : 1); ++k) sums.numbers[0] += values.value(++values.count);
}

/// A mean whose rule does not converge says so: the nodes of each rule give another value. A
/// constant converges at once, and a change below rounding counts as none.
PW85_TEST("/overlap_volume/convergence")
{
    pw85::detail::EllipticRule<double> rule{{},  {}, 0,   0.0, 0.0,   1.0,   1.0, 1.0,
                                            1.0, {}, 0.0, 0.0, false, false, 0.0, 0.0};
    auto const run = [&](auto const &value) {
        int count = 0;
        double const units[3] = {1.0, 1.0, 1.0};
        return pw85::detail::mean_over_half_planes<3>(rule, Values{value, count}, units);
    };
    auto const rough = run([](int n) { return 1.0 + n; });
    g_assert_false(rough.converged);
    g_assert_cmpint(rough.means.pairs, ==, 1 << pw85::detail::finest_rule);
    auto const smooth = run([](int) { return 1.0; });
    g_assert_true(smooth.converged);
    g_assert_cmpint(smooth.means.pairs, ==, 8);
    auto const noise = run([](int n) { return 1e-15 * (n % 2); });
    g_assert_true(noise.converged);
}

PW85_TEST("/overlap_volume/decisions") { check_decisions<3>(903, draws(8000)); }

/// Tangent ellipsoids by exact numbers, and one inside the other by one unit in the last place.
PW85_TEST("/overlap_volume/tangency")
{
    double const ball[6] = {1, 0, 0, 1, 0, 1}, quarter[6] = {0.25, 0, 0, 0.25, 0, 0.25};
    double const apart[3] = {1.5, 0, 0}, inside[3] = {0.5, 0, 0};
    double const less[3] = {std::nextafter(1.5, 0), 0, 0}, more[3] = {std::nextafter(0.5, 1), 0, 0};
    double volume = -1.0, small = 0.0;
    pw85_volume(quarter, &small);
    pw85_overlap_volume(apart, ball, quarter, &volume);
    g_assert_cmpfloat(volume, ==, 0.0);
    pw85_overlap_volume(less, ball, quarter, &volume);
    g_assert_true(volume > 0.0 && volume < 1e-30);
    pw85_overlap_volume(inside, ball, quarter, &volume);
    g_assert_cmpfloat(volume, ==, small);
    pw85_overlap_volume(more, ball, quarter, &volume);
    g_assert_true(volume > 0.999999 * small && volume <= small);
    double const zero[3] = {0, 0, 0};
    pw85_overlap_volume(zero, ball, ball, &volume);
    g_assert_cmpfloat(volume, ==, 0x1.0c152382d7366p+2); // 4π/3
}

/// The image of a pair under x + y/4, y - z/8, 2z or, in the plane, x + y/4, 2y: the determinant is
/// 2. The data are rounded.
template <int D> Sample<double, D> mapped(Sample<double, D> const &p)
{
    auto const before = convert<Wide>(p);
    Sample<Wide, D> image{};
    Wide map[3][3] = {};
    for (int i = 0; i < D; ++i) map[i][i] = i == D - 1 ? 2 : 1;
    map[0][1] = 0.25;
    if (D == 3) map[1][D - 1] = -0.125;
    for (int i = 0; i < D; ++i) {
        for (int k = 0; k < D; ++k) image.r12[i] += map[i][k] * before.r12[k];
        for (int j = i; j < D; ++j)
            for (int k = 0; k < D; ++k)
                for (int l = 0; l < D; ++l) {
                    image.q1(i, j) += map[i][k] * before.q1(k, l) * map[j][l];
                    image.q2(i, j) += map[i][k] * before.q2(k, l) * map[j][l];
                }
    }
    return convert<double>(image);
}

/// Other units that are powers of two change no bit of a volume; areas of very large and very small
/// ellipses are computed by the rim. A joint linear map multiplies by its determinant.
template <int D> void test_invariance()
{
    Failures failures;
    Random random(904);
    for (int n = 0; n < draws(400); ++n) {
        PairOptions options{};
        options.mu2_max = 1.0;
        auto const p = random_pair<D>(random, options);
        double const volume = measured(p), smaller = smaller_of(p);
        for (int const e : {-200, -40, 40, 200}) {
            Sample<double, D> const scaled{std::ldexp(1.0, e) * p.r12,
                                           std::ldexp(1.0, 2 * e) * p.q1,
                                           std::ldexp(1.0, 2 * e) * p.q2};
            double const back = std::ldexp(measured(scaled), -D * e);
            double const most = D == 3 ? 0.0 : 1e-12 * smaller;
            failures.check(std::abs(back - volume) <= most, "scaled", back, volume,
                           [&] { return hex_text(p); });
        }
        double const image = measured(mapped(p)), bound = 1e-11 * smaller;
        failures.check(std::abs(image - 2.0 * volume) <= bound, "mapped", image, 2.0 * volume,
                       [&] { return hex_text(p); });
    }
}

/// The D-th root of the volume is concave along a line of positions (Brunn and Minkowski), so that
/// the volume falls from the middle on.
template <int D> void test_concave()
{
    Failures failures;
    Random random(905);
    auto const root = [](double x) { return D == 3 ? std::cbrt(x) : std::sqrt(x); };
    for (int n = 0; n < draws(400); ++n) {
        PairOptions options{};
        options.mu2_min = options.mu2_max = 1.0;
        auto const p = random_pair<D>(random, options);
        double const smaller = root(smaller_of(p));
        double roots[33], last = std::numeric_limits<double>::infinity();
        for (int k = 0; k <= 32; ++k) {
            roots[k] = root(measured(Sample<double, D>{k / 32.0 * p.r12, p.q1, p.q2}));
            failures.check(roots[k] <= last + 1e-13 * smaller, "falls", roots[k], last,
                           [&] { return hex_text(p); });
            last = roots[k];
        }
        for (int k = 1; k < 32; ++k)
            failures.check(2.0 * roots[k] >= roots[k - 1] + roots[k + 1] - 1e-12 * smaller,
                           "concave", roots[k], 0.5 * (roots[k - 1] + roots[k + 1]),
                           [&] { return hex_text(p); });
    }
}

/// The share of random points of the smaller body's box that are in both, within 5 σ.
PW85_TEST("/overlap_volume/monte_carlo")
{
    Failures failures;
    Random random(906);
    for (int n = 0; n < draws(16); ++n) {
        PairOptions options{};
        options.mu2_max = 0.9;
        auto const p = random_pair<3>(random, options);
        auto const f1 = pw85::detail::factorize(p.q1, 0.0), f2 = pw85::detail::factorize(p.q2, 0.0);
        int const samples = 200000;
        int hits = 0;
        Vector3 half{};
        for (int i = 0; i < 3; ++i) half[i] = std::sqrt(p.q1(i, i));
        for (int k = 0; k < samples; ++k) {
            Vector3 x{};
            for (int i = 0; i < 3; ++i) x[i] = random.uniform(-half[i], half[i]);
            hits += pw85::detail::inverse_form(f1, x) <= 1.0 &&
                    pw85::detail::inverse_form(f2, x - p.r12) <= 1.0;
        }
        double const box = 8.0 * half[0] * half[1] * half[2], share = measured(p) / box;
        double const sigma = std::sqrt(samples * share * (1.0 - share)),
                     deviation = hits - samples * share;
        failures.check(std::abs(deviation) <= 5.0 * sigma + 1.0, "deviation", deviation,
                       5.0 * sigma, [&] { return hex_text(p); });
    }
}

/// Derivatives against difference quotients of order four in 38 digits.
PW85_TEST("/overlap_volume/gradient")
{
    Failures failures;
    Random random(907);
    for (int n = 0; n < draws(40); ++n) {
        PairOptions options{};
        options.aspect = 4.0;
        options.mu2_min = 0.05;
        options.mu2_max = 0.9;
        auto const p = random_pair<3>(random, options);
        auto const exact = convert<Fine>(p);
        double d_r12[3], d_q[2][6];
        pw85_overlap_volume_gradient(p.r12.coordinates, p.q1.entries, p.q2.entries, d_r12, d_q[0],
                                     d_q[1]);
        if (measured(p) == smaller_of(p)) continue;
        double const size =
            std::sqrt(std::fmin(p.q1[0] + p.q1[3] + p.q1[5], p.q2[0] + p.q2[3] + p.q2[5]));
        Fine const h = Fine(1e-5 * size);
        auto const check = [&](double actual, double scale, auto &&shifted) {
            auto const at = [&](int k) { return measure(shifted(Fine(h * k * scale))); };
            Fine const quotient = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h * scale);
            double const expected = static_cast<double>(quotient),
                         bound = 1e-9 * size * size / scale;
            failures.check(std::abs(actual - expected) <= bound, "derivative", actual, expected,
                           [&] { return hex_text(p); });
        };
        for (int i = 0; i < 3; ++i)
            check(d_r12[i], 1.0, [&](Fine const &d) {
                auto s = exact;
                s.r12[i] += d;
                return s;
            });
        for (int k = 0; k < 6; ++k) {
            check(d_q[0][k], size, [&](Fine const &d) {
                auto s = exact;
                s.q1[k] += d;
                return s;
            });
            check(d_q[1][k], size, [&](Fine const &d) {
                auto s = exact;
                s.q2[k] += d;
                return s;
            });
        }
    }
}

/// A joint linear map I + ε changes the volume by tr ε times itself: r12 Fᵀ + 2(Q1 G1 + Q2 G2) = V
/// I. Its antisymmetric part says that torques and the moment of the force add up to zero.
PW85_TEST("/overlap_volume/balance")
{
    Failures failures;
    Random random(908);
    for (int n = 0; n < draws(2000); ++n) {
        PairOptions options{};
        options.aspect = 10.0;
        options.mu2_max = 1.0;
        auto const p = random_pair<3>(random, options);
        Vector3 force{}, torque1{}, torque2{};
        Form3 g1{}, g2{};
        pw85_overlap_volume_gradient(p.r12.coordinates, p.q1.entries, p.q2.entries,
                                     force.coordinates, g1.entries, g2.entries);
        pw85_overlap_volume_torque(p.r12.coordinates, p.q1.entries, p.q2.entries,
                                   torque1.coordinates, torque2.coordinates);
        double const volume = measured(p), bound = 1e-11 * smaller_of(p);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                double sum = p.r12[i] * force[j];
                for (int k = 0; k < 3; ++k)
                    sum += (k == j ? 2.0 : 1.0) * (p.q1(i, k) * g1(k, j) + p.q2(i, k) * g2(k, j));
                double const expected = i == j ? volume : 0.0;
                failures.check(std::abs(sum - expected) <= bound, "balance", sum, expected,
                               [&] { return hex_text(p); });
            }
        Vector3 const rest = torque1 + torque2 + pw85::cross(p.r12, force);
        for (int i = 0; i < 3; ++i)
            failures.check(std::abs(rest[i]) <= bound, "reaction", rest[i], bound,
                           [&] { return hex_text(p); });
    }
}

/// The share h²(3 - h)/4, the whole and nothing, and both sides together.
PW85_TEST("/overlap_volume/plane")
{
    Failures failures;
    Random random(910);
    for (int n = 0; n < draws(4000); ++n) {
        auto const q = random.form(1.0, random.log_uniform(1.0, 100.0));
        Vector3 const normal = random.log_uniform(1e-100, 1e100) * random.direction<3>();
        auto const wide = convert<Wide>(q);
        auto const n2 = convert<Wide>(normal);
        Wide const reach = sqrt(pw85::detail::quadratic_form(wide, n2));
        double const offset = random.uniform(-1.2, 1.2) * static_cast<double>(reach);
        Wide h = 1 + Wide(offset) / reach;
        h = h < 0 ? Wide(0) : h > 2 ? Wide(2) : h;
        double const volume = whole(q),
                     expected = static_cast<double>(Wide(h * h * (3 - h) / 4)) * volume;
        double part = -1.0, rest = -1.0;
        Vector3 const opposite = -normal;
        pw85_overlap_volume_plane(normal.coordinates, offset, q.entries, &part);
        pw85_overlap_volume_plane(opposite.coordinates, -offset, q.entries, &rest);
        double const bound = 1e-12 * volume; // aspect 100: n q n loses up to four digits
        failures.check(std::abs(part - expected) <= bound, "part", part, expected,
                       [&] { return hex_text(q.entries, 6); });
        failures.check(std::abs(part + rest - volume) <= bound, "sum", part + rest, volume,
                       [&] { return hex_text(q.entries, 6); });
    }
    double const q[6] = {1, 0, 0, 1, 0, 1}, zero[3] = {0, 0, 0};
    double volume = 0.0;
    g_assert_cmpint(pw85_overlap_volume_plane(zero, 1.0, q, &volume), ==, PW85_EINVAL);
    g_assert_true(std::isnan(volume));
}

/// Where volumes leave the range of double, what is zero stays zero: a half-space without the
/// ellipsoid, and torques of a pair that a mirror maps to itself.
PW85_TEST("/overlap_volume/out_of_range")
{
    double const ball[6] = {0x1p1000, 0, 0, 0x1p1000, 0, 0x1p1000},
                 other[6] = {0x1p1002, 0, 0, 0x1p1000, 0, 0x1p1000}, axis[3] = {1, 0, 0},
                 r12[3] = {0x1p500, 0, 0};
    double outside, half, torques[6];
    g_assert_cmpint(pw85_overlap_volume_plane(axis, -0x1p501, ball, &outside), ==, PW85_SUCCESS);
    g_assert_cmpint(pw85_overlap_volume_plane(axis, 0, ball, &half), ==, PW85_SUCCESS);
    g_assert_true(outside == 0 && std::isinf(half));
    g_assert_cmpint(pw85_overlap_volume_torque(r12, ball, other, torques, torques + 3), ==,
                    PW85_SUCCESS);
    for (double const torque : torques) g_assert_cmpfloat(torque, ==, 0.0);
}

/// Volumes of ellipsoids by products of semi-axes.
PW85_TEST("/overlap_volume/whole")
{
    Failures failures;
    Random random(911);
    for (int n = 0; n < draws(4000); ++n) {
        auto const q = random.form(random.log_uniform(1e-90, 1e90), random.log_uniform(1.0, 1e4));
        auto const w = convert<Wide>(q);
        Wide const det = pw85::detail::determinant(w, pw85::detail::adjugate(w));
        Wide const truth = 16 * atan(Wide(1)) / 3 * sqrt(det);
        double const volume = whole(q),
                     error = std::abs(static_cast<double>(Wide(Wide(volume) / truth - 1)));
        failures.check(error <= 2.0 * u, "volume", error, 2.0 * u,
                       [&] { return hex_text(q.entries, 6); });
    }
}

/// The functions of many pairs give the bits of those of one.
PW85_TEST("/overlap_volume/many")
{
    Random random(912);
    constexpr int n = 8;
    double centers[2 * n][3], q[2 * n][6], volumes[n];
    std::int32_t pairs[n][2];
    for (int k = 0; k < n; ++k) {
        PairOptions options{};
        auto const p = random_pair<3>(random, options);
        for (int i = 0; i < 3; ++i) centers[2 * k][i] = 0.0;
        std::memcpy(centers[2 * k + 1], p.r12.coordinates, sizeof centers[0]);
        std::memcpy(q[2 * k], p.q1.entries, sizeof q[0]);
        std::memcpy(q[2 * k + 1], p.q2.entries, sizeof q[0]);
        pairs[k][0] = 2 * k;
        pairs[k][1] = 2 * k + 1;
    }
    pw85_system const system{2 * n, centers[0], q[0], nullptr, {0, 0, 0}};
    pw85_pair_list const list{n, pairs[0], nullptr};
    g_assert_cmpint(pw85_overlap_volume_pairs(&list, &system, volumes), ==, PW85_SUCCESS);
    for (int k = 0; k < n; ++k) {
        double one = -1.0;
        pw85_overlap_volume(centers[2 * k + 1], q[2 * k], q[2 * k + 1], &one);
        g_assert_cmpfloat(one, ==, volumes[k]);
    }
    g_assert_cmpint(pw85_overlap_volume_pairs(&list, &system, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_overlap_volume_pairs(nullptr, &system, volumes), ==, PW85_EINVAL);
}

PW85_ADD_TEST("/overlap_volume/balls", test_balls<3>);
PW85_ADD_TEST("/overlap_volume/circles", test_balls<2>);
PW85_ADD_TEST("/overlap_volume/bound", test_bound<3>);
PW85_ADD_TEST("/overlap_volume/invariance", test_invariance<3>);
PW85_ADD_TEST("/overlap_volume/invariance_2d", test_invariance<2>);
PW85_ADD_TEST("/overlap_volume/concave", test_concave<3>);
PW85_ADD_TEST("/overlap_volume/concave_2d", test_concave<2>);
PW85_ADD_TEST("/overlap_volume/bound_2d", test_bound<2>);

} // namespace

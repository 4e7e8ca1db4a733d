// SPDX-License-Identifier: BSD-3-Clause
// Random sequential addition, by brute force and by known fractions; and the forms that decide
// whether a voxel is covered (src/addition/inner_forms.hpp), in exact arithmetic.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <glib.h>

#include <pw85/pw85.hpp>
#include <pw85/simulation/random_addition.hpp>

#include "../src/addition/divisions.hpp"
#include "../src/addition/inner_forms.hpp"

#include "cases.hpp"
#include "failures.hpp"
#include "oracle/multiprecision.hpp"

using namespace pw85_tests;
using namespace pw85::detail::sequential_addition;
using pw85::AdditionEnd, pw85::RandomAddition, pw85::StatusCode;

namespace {

using Vector3 = pw85::Vector<double, 3>;
using Vector4 = pw85::Vector<double, 4>;
/// Sums and products of the doubles of these tests, which span 2¹⁶⁰, are exact.
using Number = Multiprecision<200>;
using Random = std::mt19937_64;

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr std::size_t any_number = 0x7fffffff;

double uniform(Random &random, double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// A length of any size.
double some_length(Random &random)
{
    return std::ldexp(uniform(random, 1, 2), static_cast<int>(random() % 81) - 40);
}

Number pi_exactly() { return Number(4) * atan(Number(1)); }

/// Returns whether an ellipse is inside another one with the same centre: the difference of the
/// forms is positive semidefinite.
bool is_inside(pw85::SymmetricMatrix<double, 2> const &inner, Number const (&outer)[3])
{
    Number const xx = outer[0] - Number(inner[0]), xy = outer[1] - Number(inner[1]),
                 yy = outer[2] - Number(inner[2]);
    return xx + yy >= 0 && xx * yy >= xy * xy;
}

/// The form of all ellipses of a voxel.
pw85::SymmetricMatrix<double, 2> inner_form(double a, double b, double edges, std::uint64_t part,
                                            std::uint64_t angles)
{
    Axes2 const squares =
        reduced_squares(inside_rotated(a, b, half_angle_range(angles)), rounding_loss(a, edges));
    g_assert_true(is_certainly_definite(squares));
    return rotated_form(squares, double_middle_angle(part, angles));
}

/// Half-widths along t are √(m + d cos 2(t - φ)): nowhere larger than those of the ellipse at any
/// angle. The loss of area is of the first order in the angle, with a factor of the order of the
/// square of the ratio.
PW85_TEST("/random_addition/inside_rotated")
{
    Failures failures;
    Random random(1);
    auto const square = [](double a, double b, double t) {
        double const x = a * std::cos(t), y = b * std::sin(t);
        return x * x + y * y;
    };
    for (int draw = 0; draw < 100; ++draw) {
        double const b = uniform(random, 0.1, 2), ratio = std::exp2(uniform(random, 0, 5)),
                     a = b * ratio, angle = std::exp2(uniform(random, -12, 1));
        Axes2 const axes = inside_rotated(a, b, angle);
        double excess = 0;
        for (int i = 0; i < 721; ++i)
            for (int k = -20; k <= 20; ++k) {
                double const t = i * pi / 720, phi = k * std::min(angle, pi / 2) / 20;
                excess = std::max(excess, square(axes[0], axes[1], t) / square(a, b, t - phi) - 1);
            }
        double const area = axes[0] * axes[1];
        auto const inputs = [&] { return std::to_string(a) + " " + std::to_string(angle); };
        failures.check(excess <= 1e-12, "half-width", excess, 1e-12, inputs);
        failures.check(area >= b * b * (1 - 1e-15), "area", area, b * b, inputs);
        double const least = a * b * (1 - 4 * ratio * ratio * angle);
        failures.check(area >= least, "area", area, least, inputs);
    }
}

/// Exactly: inside all true ellipses of the voxel, and inside those that are made of what is drawn.
/// Voxels are so narrow that rounding matters, and of all widths.
PW85_TEST("/random_addition/inner_forms")
{
    Failures failures;
    Random random(2);
    Number const whole = pi_exactly();
    for (double const aspect : {1.0, 2.5, 30.0, 1e3, 1e4, 1e5, 1e6})
        for (int draw = 0; draw < 40; ++draw) {
            double const b = some_length(random), a = b * aspect;
            std::uint64_t const angles = std::uint64_t{1} << (1 + random() % 50),
                                part = draw % 4 == 0   ? 0
                                       : draw % 4 == 1 ? angles - 1
                                                       : random() % angles;
            auto const found = inner_form(a, b, 2 * a, part, angles);
            for (int const half : {0, 1, 2}) {
                Number const angle =
                    whole * Number(2 * part + static_cast<unsigned>(half)) / Number(2 * angles);
                Number const c = cos(angle), s = sin(angle), aa = Number(a) * Number(a),
                             bb = Number(b) * Number(b);
                Number const exact[] = {aa * c * c + bb * s * s, (aa - bb) * c * s,
                                        aa * s * s + bb * c * c};
                double const u =
                    std::min((static_cast<double>(part) + 0.5 * half) / static_cast<double>(angles),
                             0x1.fffffffffffffp-1);
                auto const q =
                    pw85::ellipsoid_quaternion(
                        Vector3{a, b, b}, Vector4{std::cos(pi / 2 * u), 0, 0, std::sin(pi / 2 * u)})
                        .q;
                Number const made[] = {Number(q[0]), Number(q[1]), Number(q[3])};
                auto const inputs = [&] {
                    return std::to_string(part) + " of " + std::to_string(angles);
                };
                failures.check(is_inside(found, exact), "inside the true ellipse", a, b, inputs);
                failures.check(is_inside(found, made), "inside the ellipse", a, b, inputs);
            }
        }
}

/// Exactly, for forms as doubles: Q - s I is positive semidefinite for the square s of the radius.
/// The ball is smaller than the shortest semi-axis by no more than 2⁻⁴⁶ of the squared aspect
/// ratio.
PW85_TEST("/random_addition/inner_balls")
{
    Failures failures;
    Random random(3);
    std::normal_distribution<double> normal;
    for (double const aspect : {1.0, 30.0, 1e3, 1e5, 1e6})
        for (int draw = 0; draw < 100; ++draw) {
            double const b = some_length(random);
            Vector3 axes = {b * aspect, b, b * std::pow(aspect, uniform(random, 0, 1))};
            std::shuffle(axes.coordinates, axes.coordinates + 3, random);
            Vector4 turn;
            for (double &one : turn.coordinates) one = normal(random);
            double const radius = radius_inside(b * aspect, b);
            auto const q = pw85::ellipsoid_quaternion(axes, turn / pw85::detail::magnitude(turn)).q;
            Number const s = Number(radius) * Number(radius), xx = Number(q[0]) - s,
                         yy = Number(q[3]) - s, zz = Number(q[5]) - s, xy = q[1], xz = q[2],
                         yz = q[4];
            Number const minors[] = {yy * zz - yz * yz, xx * zz - xz * xz, xx * yy - xy * xy};
            Number const determinant =
                xx * minors[0] + xy * (xz * yz - xy * zz) + xz * (xy * yz - xz * yy);
            auto const inputs = [&] { return std::to_string(axes[0] / axes[1]); };
            failures.check(xx + yy + zz >= 0 && minors[0] + minors[1] + minors[2] >= 0 &&
                               determinant >= 0,
                           "ball inside", radius, b, inputs);
            double const least = b * b * (1 - 0x1p-45 * aspect * aspect);
            failures.check(radius * radius >= least, "square of the radius", radius * radius, least,
                           inputs);
        }
}

/// A half-width h of the inner form is so much smaller than that of the ellipse that positions may
/// be wrong by 27 roundings of the cell in each direction (rounding_loss()).
PW85_TEST("/random_addition/moved_positions")
{
    Failures failures;
    Random random(4);
    for (double const aspect : {1.0, 7.0, 1e3, 1e5})
        for (double const edges : {2.0, 50.0, 1e3}) {
            double const b = some_length(random), a = b * aspect, length = a * edges;
            auto const q = inner_form(a, b, length, 0, std::uint64_t{1} << 50);
            Number const moved = Number(27) * Number(length) * sqrt(Number(2)) * Number(0x1p-53);
            for (int k = 0; k < 42; ++k) {
                Number const c = k < 2 ? k : std::exp2(uniform(random, -40, 0)),
                             s = sqrt(Number(1) - c * c);
                Number const h = sqrt(Number(q[0]) * c * c + Number(2) * Number(q[1]) * c * s +
                                      Number(q[2]) * s * s),
                             all = sqrt(Number(a) * Number(a) * c * c +
                                        Number(b) * Number(b) * s * s);
                failures.check(h + moved <= all, "half-width", static_cast<double>(h + moved),
                               static_cast<double>(all), [&] { return std::to_string(aspect); });
            }
        }
}

/// The images of particles that may meet one whose centre is in the cell.
struct Image {
    Vector3 center;
    pw85::SymmetricMatrix<double, 3> q;
    double longest;
    std::size_t particle;
};

/// A packing, and what is needed to compute it again.
struct Packed {
    int dimensions;
    pw85::Cell cell;
    std::vector<Vector3> semi_axes, centers;
    std::vector<Vector4> quaternions;
    std::vector<std::int32_t> kinds;
    AdditionEnd end = AdditionEnd::none;
    pw85::AdditionState state{};

    /// Adds particles until the addition ends.
    void fill(std::size_t seed, double attempts = unlimited, std::size_t number = any_number)
    {
        RandomAddition addition;
        g_assert_true(random_addition_create(dimensions, cell, semi_axes, seed, addition) ==
                      StatusCode::success);
        do g_assert_true(addition.advance(attempts, number, end) == StatusCode::success);
        while (end == AdditionEnd::none);
        state = addition.state();
        std::size_t const n = state.num_particles;
        centers.resize(n), quaternions.resize(n), kinds.resize(n);
        g_assert_true(addition.particles(centers, quaternions, kinds) == StatusCode::success);
    }

    double longest(std::size_t species) const
    {
        auto const &axes = semi_axes[species].coordinates;
        return *std::max_element(axes, axes + dimensions);
    }

    /// All images in the cell and in those next to it.
    std::vector<Image> images() const
    {
        std::vector<Image> all;
        for (std::size_t k = 0; k < centers.size(); ++k)
            for (int code = 0; code < (dimensions == 2 ? 9 : 27); ++code) {
                Vector3 x = centers[k];
                for (int i = 0, rest = code; i < dimensions; ++i, rest /= 3)
                    x = pw85::detail::add_scaled(x, rest % 3 - 1.0,
                                                 cell[static_cast<std::size_t>(i)]);
                auto const species = static_cast<std::size_t>(kinds[k]);
                all.push_back({x, pw85::ellipsoid_quaternion(semi_axes[species], quaternions[k]).q,
                               longest(species), k});
            }
        return all;
    }
};

/// Returns whether a particle meets an image of another one than `but`.
bool meets(std::vector<Image> const &images, Image const &one, std::size_t but = any_number)
{
    return std::any_of(images.begin(), images.end(), [&](Image const &other) {
        Vector3 const r = other.center - one.center;
        double const reach = other.longest + one.longest;
        return other.particle != but && dot(r, r) < reach * reach * 1.0001 &&
               pw85::overlap(r, one.q, other.q).overlap;
    });
}

pw85::Cell skewed(double edge, int dimensions)
{
    return {{{edge, 0, 0}, {0.3 * edge, edge, 0}, {0, dimensions == 2 ? 0 : -0.2 * edge, edge}}};
}

Packed const examples[] = {
    {2, skewed(14, 2), {{1, 1, 1}}, {}, {}, {}},
    {2, skewed(14, 2), {{2, 1, 1}}, {}, {}, {}},
    {2, skewed(14, 2), {{1, 2.5, 1}, {0.7, 0.7, 0.7}}, {}, {}, {}},
    {3, skewed(6, 3), {{1, 1, 1}}, {}, {}, {}},
};

/// Counts the random attempts that are free among images.
int count_free(Packed const &one, std::vector<Image> const &images, int attempts, Random &random)
{
    int count = 0;
    for (int draw = 0; draw < attempts; ++draw) {
        Vector3 center{};
        for (int i = 0; i < one.dimensions; ++i)
            center = pw85::detail::add_scaled(center, uniform(random, 0, 1),
                                              one.cell[static_cast<std::size_t>(i)]);
        double const angle = uniform(random, 0, pi);
        std::size_t const species = random() % one.semi_axes.size();
        auto const q = pw85::ellipsoid_quaternion(one.semi_axes[species],
                                                  Vector4{std::cos(angle), 0, 0, std::sin(angle)});
        count += !meets(images, {center, q.q, one.longest(species), 0});
    }
    return count;
}

/// No two particles overlap, and no attempt at a random place finds room. Among few, there is room.
PW85_TEST("/random_addition/saturated")
{
    Failures failures;
    Random random(5);
    for (Packed one : examples)
        for (std::size_t const seed : {3u, 4u, 5u}) {
            one.fill(seed);
            g_assert_true(one.end == AdditionEnd::saturated);
            auto const inputs = [&] { return std::to_string(one.centers.size()); };
            failures.check(one.state.free_share == 0, "free share", one.state.free_share, 0,
                           inputs);
            auto images = one.images();
            for (Image const &image : images)
                if (one.centers[image.particle][0] == image.center[0])
                    failures.check(!meets(images, image, image.particle), "overlap",
                                   image.center[0], image.center[1], inputs);
            int const free = count_free(one, images, 4000, random);
            failures.check(free == 0, "free in the packing", free, 0, inputs);
            images.resize(40);
            int const room = count_free(one, images, 400, random);
            failures.check(room > 100, "free among few", room, 100, inputs);
        }
}

/// In a saturated packing of discs of radius 1, each point where two circles of radius 2 about
/// centres cross is inside a third one: the part that is free would have such points as its
/// corners. 2⁻²⁸ is a margin, which excludes the two circles themselves.
PW85_TEST("/random_addition/saturated_discs")
{
    Failures failures;
    Packed one = {2, skewed(40, 2), {{1, 1, 1}}, {}, {}, {}};
    one.fill(6);
    g_assert_true(one.end == AdditionEnd::saturated);
    auto const images = one.images();
    auto const is_inside_any = [&](Vector3 const &x) {
        return std::any_of(images.begin(), images.end(), [&](Image const &image) {
            Vector3 const r = image.center - x;
            return dot(r, r) < 4 - 0x1p-28;
        });
    };
    for (Vector3 const &center : one.centers)
        for (Image const &image : images) {
            Vector3 const r = image.center - center;
            double const square = dot(r, r);
            if (square == 0 || square > 16) continue;
            double const height = std::sqrt(4 / square - 0.25);
            Vector3 const crossing =
                center + Vector3{0.5 * r[0] - height * r[1], 0.5 * r[1] + height * r[0], 0};
            failures.check(is_inside_any(crossing), "crossing", crossing[0], crossing[1],
                           [&] { return std::to_string(std::sqrt(square)); });
        }
    g_assert_cmpint(static_cast<int>(failures.checked()), >, 1000);
}

/// Fractions at saturation: discs 0.5471 (Zhang and Torquato, Phys. Rev. E 88, 053312, 2013), balls
/// 0.3841 (there), ellipses of aspect ratio 2 0.583 (reference/random_addition). The variance of
/// the number N of particles is N S(0), with the structure factor S(0) <= 0.06: measured in these
/// cells, it is 0.051 ± 0.004 for discs (300 seeds), 0.056 ± 0.007 for ellipses (120 seeds) and
/// 0.043 ± 0.008 for balls (60 seeds). So a fraction φ of a cell with the volume of n
/// particles spreads by √(φ S(0)/n); the test allows five times that.
PW85_TEST("/random_addition/fractions")
{
    Failures failures;
    struct Known {
        int dimensions;
        double edge;
        Vector3 axes;
        double fraction;
    };
    for (Known const &known :
         {Known{2, 60, {1, 1, 1}, 0.5471}, {2, 60, {2, 1, 1}, 0.583}, {3, 20, {1, 1, 1}, 0.3841}}) {
        double const edge = known.edge;
        Packed one{known.dimensions,
                   {{{edge, 0, 0}, {0, edge, 0}, {0, 0, edge}}},
                   {known.axes},
                   {},
                   {},
                   {}};
        one.fill(5);
        double const volume = known.dimensions == 2 ? pi * known.axes[0] / (edge * edge)
                                                    : 4 * pi / 3 / (edge * edge * edge),
                     fraction = volume * static_cast<double>(one.centers.size()),
                     spread = std::sqrt(known.fraction * 0.06 * volume);
        failures.check(std::abs(fraction - known.fraction) < 5 * spread, "fraction", fraction,
                       known.fraction, [&] { return std::to_string(spread); });
    }
}

/// Units that are powers of two change nothing but the size.
PW85_TEST("/random_addition/units")
{
    for (Packed const &one : examples)
        for (int const exponent : {-900, -40, 40, 900}) {
            Packed first = one, second = one;
            for (auto &vector : second.cell) vector = std::ldexp(1.0, exponent) * vector;
            for (auto &axes : second.semi_axes) axes = std::ldexp(1.0, exponent) * axes;
            first.fill(7), second.fill(7);
            g_assert_true(first.kinds == second.kinds && first.state.attempts > 0);
            g_assert_true(first.state.attempts == second.state.attempts);
            for (std::size_t k = 0; k < first.centers.size(); ++k)
                for (int i = 0; i < 3; ++i) {
                    g_assert_true(std::ldexp(first.centers[k][i], exponent) ==
                                  second.centers[k][i]);
                    g_assert_true(first.quaternions[k][i] == second.quaternions[k][i]);
                }
        }
}

/// Each limit ends an addition, and is the reason. Another seed gives another packing.
PW85_TEST("/random_addition/ends")
{
    Packed one{3, skewed(12, 3), {{1, 1, 2}}, {}, {}, {}};
    one.fill(1, 50000);
    g_assert_true(one.end == AdditionEnd::attempts && one.state.attempts >= 50000);
    g_assert_true(one.state.attempts < 50000 + 1 / one.state.free_share);
    g_assert_true(one.state.free_share > 0 && one.state.free_share <= 1);
    one.fill(1, unlimited, 20);
    g_assert_true(one.end == AdditionEnd::particles && one.centers.size() == 20);
    auto const centers = one.centers;
    one.fill(1, unlimited, 20);
    g_assert_true(one.centers[19][0] == centers[19][0]);
    one.fill(2, unlimited, 20);
    g_assert_true(one.centers[19][0] != centers[19][0]);
}

/// What was reached before remains, and a limit that was reached before is the reason at once.
PW85_TEST("/random_addition/continued")
{
    Packed one = examples[1];
    RandomAddition addition;
    AdditionEnd end;
    random_addition_create(2, one.cell, one.semi_axes, 3, addition);
    for (std::size_t const number : {1u, 2u, 5u, 5u}) {
        do addition.advance(unlimited, number, end);
        while (end == AdditionEnd::none);
        g_assert_true(end == AdditionEnd::particles && addition.state().num_particles == number);
    }
    double const attempts = addition.state().attempts;
    addition.advance(1, any_number, end);
    g_assert_true(end == AdditionEnd::attempts && addition.state().attempts == attempts);
    std::vector<Vector3> few(4);
    g_assert_true(addition.particles(few) == StatusCode::invalid_argument);
    few.resize(5);
    g_assert_true(addition.particles(few) == StatusCode::success);
    g_assert_true(RandomAddition().advance(1, 1, end) == StatusCode::invalid_argument);
    g_assert_cmpuint(RandomAddition().state().num_particles, ==, 0);
}

/// Limits on the way change neither the packing nor the number of attempts.
PW85_TEST("/random_addition/in_pieces")
{
    for (Packed const &one : examples) {
        Packed whole = one;
        whole.fill(8);
        Random random(6);
        RandomAddition addition;
        AdditionEnd end = AdditionEnd::none;
        random_addition_create(one.dimensions, one.cell, one.semi_axes, 8, addition);
        for (int call = 0; end != AdditionEnd::saturated && call < 100000; ++call) {
            auto const [number, attempts, share] = addition.state();
            bool const by_number = random() % 2 == 0;
            double const more = uniform(random, 1, 5000) / share;
            g_assert_true(addition.advance(by_number ? unlimited : attempts + more,
                                           by_number ? number + 1 : any_number,
                                           end) == StatusCode::success);
        }
        std::vector<Vector3> centers(addition.state().num_particles);
        g_assert_true(addition.particles(centers) == StatusCode::success);
        g_assert_cmpuint(centers.size(), ==, whole.centers.size());
        g_assert_true(addition.state().attempts == whole.state.attempts);
        for (std::size_t k = 0; k < centers.size(); ++k)
            for (int i = 0; i < 3; ++i) g_assert_true(centers[k][i] == whole.centers[k][i]);
    }
}

/// The limits of the contract are accepted, and what is beyond them is refused by its name.
PW85_TEST("/random_addition/extremes")
{
    auto const requirement = [](double edge, double shortest) {
        pw85::Cell const cell = {{{edge, 0, 0}, {0, edge, 0}, {0, 0, edge}}};
        std::vector<Vector3> const axes = {{1, 1, 1}, {shortest, shortest, shortest}};
        RandomAddition addition;
        pw85_error error{};
        bool const is_made =
            random_addition_create(3, cell, axes, 1, addition) == StatusCode::success;
        pw85_last_error(&error);
        return std::string(is_made ? "" : error.requirement);
    };
    g_assert_cmpstr(requirement(0x1p250, 1).c_str(), ==, "");
    g_assert_cmpuint(requirement(0x1p280, 1).find("above 2²⁵⁰ times"), !=, std::string::npos);
    g_assert_cmpuint(requirement(1, 1).find("farther apart"), !=, std::string::npos);
    g_assert_cmpstr(requirement(10, 0x1p-480).c_str(), ==, "");
    g_assert_cmpuint(requirement(10, 0x1p-481).find("at least 2⁻⁴⁸⁰ times"), !=, std::string::npos);
}

/// As many species as there can be get one voxel each.
PW85_TEST("/random_addition/voxels_of_many_species")
{
    Divisions<3> many{{8192, 1, 8192}, 1}, few = many;
    limit_voxels(many, 0x7fffffff);
    g_assert_true(many.count() == 1);
    limit_voxels(few, 1);
    g_assert_true(few.count() == 8192.0 * 8192.0);
}

} // namespace

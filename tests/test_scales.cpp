// SPDX-License-Identifier: BSD-3-Clause
// Every function that takes lengths or times gives corresponding results in other units. Pairs of
// various sizes and size ratios, walls, cells and motions are multiplied by powers of two; the
// results must change by the powers of it that belong to the units of their declarations.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85_systems.h>

#include "calls.hpp"
#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "flights.hpp"
#include "marks.hpp"
#include "rows_of_calls.hpp"

using namespace pw85_tests;

namespace {

using Pairs = std::vector<Sample<double, 3>>;

constexpr std::size_t num_pairs = 4;

/// The largest aspect ratio, and what two results of lanes, which may be more or less exact than
/// those of one pair, may differ by: 64 u aspect² of the largest coordinate each
/// (tests/batch/test_derivatives.cpp), more than the 4 u cond of μ².
constexpr double largest_aspect = 20.0,
                 difference_of_lanes = 2.0 * 64.0 * 0x1p-53 * largest_aspect * largest_aspect;

/// A factor 2^length of lengths, and 2^time of times.
struct Units {
    int length, time;
};

/// Ellipsoid 2 is larger than the other by some power of two.
Pairs unlike_pairs(Random &random, int size_ratio)
{
    Pairs pairs;
    for (std::size_t i = 0; i < num_pairs; ++i) {
        auto const q1 = random_form<3>(random, 1.0, random.log_uniform(1.0, largest_aspect));
        auto const q2 = random_form<3>(random, std::ldexp(random.uniform(1.0, 2.0), size_ratio),
                                       random.log_uniform(1.0, largest_aspect));
        pairs.push_back(placed<3>(random.direction<3>(), random.log_uniform(0.02, 9.0), q1, q2));
    }
    return pairs;
}

/// The array of a name among the parameters of a call, or null.
double *find(Call &call, std::string_view name)
{
    for (std::size_t k = 0; k < call.size(); ++k)
        if (call.parameter(k).name == name) return call.elements<double>(k);
    return nullptr;
}

/// Fills the inputs of a call that its pairs do not determine. What moves comes near within one or
/// two units of time, turns and grows; walls and ends are at the distance of the other ellipsoid.
class Filling {
  public:
    Filling(Call &call, Pairs const &pairs, int size_ratio, Random &random)
        : call_(call), pairs_(pairs), factor_(std::ldexp(1.0, size_ratio)), random_(random)
    {
        if (random.sign() < 0.0) end_ = random.log_uniform(0.1, 100.0);
        if (random.uniform(0.0, 1.0) < 0.125) end_ = std::numeric_limits<double>::infinity();
        moving_ = random.uniform(0.0, 1.0) < 0.25 ? Moving::centres : Moving::all;
        for (std::size_t k = 0; k < call.size(); ++k)
            if (!call.parameter(k).output) fill(k);
        for (std::size_t k = 0; k < call.size(); ++k)
            if (!call.parameter(k).output && call.parameter(k).name == std::string_view("lambda"))
                fill_lambda(k);
    }

  private:
    double side() const
    {
        return 4.0 * (std::sqrt(pw85::detail::largest_diagonal(pairs_[0].q1)) +
                      std::sqrt(pw85::detail::largest_diagonal(pairs_[0].q2)));
    }

    void fill(std::size_t k)
    {
        Parameter const &p = call_.parameter(k);
        if (p.type == Type::motion)
            for (std::size_t i = 0; i < call_.length(k); ++i)
                call_.elements<pw85_motion>(k)[i] =
                    motion(i, p.name == std::string_view("motion2"));
        if (p.name == std::string_view("images") && random_.sign() < 0.0)
            call_[k].pointer = nullptr; // the nearest ones
        if (p.type != Type::real) return;
        if (!p.pointer) call_[k].real = number(p, norm(pairs_[0].r12), call_[k].real);
        std::size_t const width = p.pointer ? call_.row_length(k) : 1;
        for (std::size_t i = 0; p.pointer && i < call_.length(k) / width; ++i)
            fill_row(p, i, width, call_.elements<double>(k) + i * width);
    }

    double number(Parameter const &p, double distance, double given)
    {
        std::string_view const name = p.name;
        if (name == "t_max" && p.time == 1) return end_;
        if (name == "mu2") return random_.log_uniform(0.1, 10.0);
        if (name == "skin") return 0.125 * side();
        if (name == "curvature") return random_.log_uniform(0.1, 1.0) / distance;
        if (p.length == 1) return random_.log_uniform(0.1, 1.0) * distance;
        return given;
    }

    void fill_row(Parameter const &p, std::size_t i, std::size_t width, double *row)
    {
        std::string_view const name = p.name;
        auto const &pair = pairs_[i % pairs_.size()];
        double const distance = norm(pair.r12);
        if (width == 1) row[0] = number(p, distance, row[0]);
        if (name == "offsets" && random_.uniform(0.0, 1.0) < 0.25) row[0] = -row[0];
        bool const is_direction = p.length == 0 && (width == 2 || width == 3);
        double const towards = name == "direction" || name == "directions" ? -1.5 : 0.0;
        for (std::size_t d = 0; d < width && is_direction; ++d)
            row[d] = random_.normal() + towards * pair.r12[static_cast<int>(d)] / distance;
        for (std::size_t d = 0; d < width && name == "velocity"; ++d)
            row[d] = velocity(pair, static_cast<int>(d), 1.0);
        for (std::size_t d = 0; d < width && name == "centers"; ++d)
            row[d] = random_.uniform(0.0, side());
        for (std::size_t d = 0; d < width && name == "s2"; ++d) row[d] *= factor_;
        if (name == "lower" || name == "upper")
            fill_corner(pair, name == "lower" ? -1.0 : 1.0, row);
        if (name == "cell") fill_cell(row);
    }

    /// Of the box around ellipsoid 2, where this is, or around the origin.
    void fill_corner(Sample<double, 3> const &pair, double sign, double *row) const
    {
        for (int d = 0; d < 3; ++d)
            row[d] = (end_ > 3.0 ? 0.0 : pair.r12[d]) + sign * std::sqrt(pair.q2(d, d));
    }

    /// A cubic one, or one that is not reduced.
    void fill_cell(double *row) const
    {
        double const skew = end_ > 3.0 ? 0.0 : side(),
                     all[9] = {side(), 0.0,         0.0,         2.5 * skew, side(),
                               0.0,    0.25 * skew, -3.0 * skew, side()};
        std::copy_n(all, 9, row);
    }

    double velocity(Sample<double, 3> const &pair, int d, double towards)
    {
        return 0.2 * norm(pair.r12) * random_.uniform(-1.0, 1.0) -
               towards * random_.uniform(0.5, 1.0) * pair.r12[d];
    }

    pw85_motion motion(std::size_t i, bool is_second)
    {
        auto const &pair = pairs_[i % pairs_.size()];
        auto m = random_motion<3>(random_, 1.0, moving_);
        for (int d = 0; d < 3; ++d) m.velocity[d] = velocity(pair, d, is_second ? 1.0 : 0.0);
        m.growth = end_ < HUGE_VAL ? std::fmax(m.growth, -0.5 / end_) : std::fabs(m.growth);
        if (end_ == HUGE_VAL && random_.sign() < 0.0) m = {{}, {}, m.growth};
        return c_motion(m);
    }

    /// Where derivatives are those of the contact function.
    void fill_lambda(std::size_t k)
    {
        double const *const r12 = find(call_, "r12"), *const q1 = find(call_, "q1"),
                            *const q2 = find(call_, "q2"), *const s1 = find(call_, "s1"),
                            *const s2 = find(call_, "s2");
        bool const is_flat = std::string_view(call_.function().name).ends_with("_2d");
        for (std::size_t i = 0; i < (call_.parameter(k).pointer ? call_.length(k) : 1); ++i) {
            double out[2];
            if (s1 != nullptr)
                pw85_contact_factored(r12 + 3 * i, s1 + 9 * i, s2 + 9 * i, out);
            else if (is_flat)
                pw85_contact_2d(r12 + 2 * i, q1 + 3 * i, q2 + 3 * i, out);
            else
                pw85_contact(r12 + 3 * i, q1 + 6 * i, q2 + 6 * i, out);
            if (call_.parameter(k).pointer)
                call_.elements<double>(k)[i] = out[1];
            else
                call_[k].real = out[1];
        }
    }

    Call &call_;
    Pairs const &pairs_;
    double factor_, end_ = 3.0;
    Moving moving_;
    Random &random_;
};

bool names(Function const &function, std::string_view part)
{
    return std::string_view(function.name).find(part) < std::string_view::npos;
}

/// Sets the inputs of a call to those of another, in units that are smaller by powers of two.
void copy_inputs(Call &from, Units units, Call &to)
{
    for (std::size_t k = 0; k < from.size(); ++k) {
        Parameter const &p = from.parameter(k);
        if (p.output) continue;
        int const power = p.length * units.length + p.time * units.time;
        if (!p.pointer) {
            to[k] = from[k];
            if (p.type == Type::real) to[k].real = std::ldexp(from[k].real, power);
        } else if (from[k].pointer == nullptr)
            to[k].pointer = nullptr;
        else if (p.type == Type::real)
            for (std::size_t i = 0; i < from.length(k); ++i)
                to.elements<double>(k)[i] = std::ldexp(from.elements<double>(k)[i], power);
        else if (p.type == Type::motion)
            for (std::size_t i = 0; i < from.length(k); ++i) {
                pw85_motion &m = to.elements<pw85_motion>(k)[i] = from.elements<pw85_motion>(k)[i];
                for (double &x : m.velocity) x = std::ldexp(x, units.length - units.time);
                for (double &x : m.angular_velocity) x = std::ldexp(x, -units.time);
                m.growth = std::ldexp(m.growth, -units.time);
            }
    }
}

/// The power of two of a number of an output. In second derivatives those with respect to r12 are
/// per length; moments of inertia are of unit density.
int power_of(Function const &function, Parameter const &p, std::size_t i, Units units)
{
    if (!p.mixed_units) return p.length * units.length + p.time * units.time;
    if (p.name == std::string_view("inertia")) return 5 * units.length;
    std::size_t const n = p.shape.back().number, d = n == 9 ? 3 : 2, row = i / n % n,
                      column = i % n;
    int const of_value = names(function, "distance");
    return units.length * (of_value - (row < d) - (column < d));
}

int is_reproducible()
{
    int on;
    g_assert_cmpint(pw85_is_reproducible(&on), ==, PW85_SUCCESS);
    return on;
}

/// By how much numbers may differ, relative to the scale of their row: 0 where bits are the same.
/// Between units far from the sizes of the pairs they are, because lanes and formulas for numbers
/// of order one leave those pairs to one function. Only the lanes of grains take them too. Outside
/// of the reproducible mode the compiler may fuse operations of derivatives of one pair, and not
/// the same ones where it has compiled a formula for both.
double difference_of(Function const &function, bool are_both_far)
{
    bool const has_lanes =
        std::find(with_lanes.begin(), with_lanes.end(), function.name) != with_lanes.end() ||
        is_one_of(function.name, {"pw85_contact_derivatives_batch", "pw85_contact_pairs",
                                  "pw85_contact_derivatives_pairs", "pw85_law_forces_pairs"});
    bool const has_formulas =
        names(function, "overlap_area") || names(function, "witness") ||
        is_one_of(function.name,
                  {"pw85_contact_segment", "pw85_contact_triangle", "pw85_contact_box"});
    bool const may_fuse =
        is_reproducible() == 0 &&
        (names(function, "contact_geometry") || names(function, "contact_gradient") ||
         names(function, "contact_torque") || names(function, "contact_hessian"));
    if (are_both_far) return names(function, "grain_contact_batch") ? difference_of_lanes : 0.0;
    return has_lanes || has_formulas || may_fuse ? difference_of_lanes : 0.0;
}

double area_of(double const *q)
{
    double area;
    g_assert_cmpint(pw85_area_2d(q, &area), ==, PW85_SUCCESS);
    return area;
}

/// The largest magnitude of a row. Derivatives of areas by rotations may cancel; they have the
/// error of the smaller area.
double scale_of_row(Call &call, std::size_t k, std::size_t i)
{
    if (names(call.function(), "overlap_area_torque"))
        return std::fmin(area_of(find(call, "q1") + 3 * i), area_of(find(call, "q2") + 3 * i));
    std::size_t const width = call.row_length(k);
    double const *const row = call.elements<double>(k) + i / width * width;
    return std::abs(*std::max_element(
        row, row + width, [](double x, double y) { return std::fabs(x) < std::fabs(y); }));
}

/// Compares the outputs of a call with those of one in other units.
void compare(Failures &failures, Call &own, Call &other, Units units, bool are_both_far)
{
    Function const &function = own.function();
    double const difference = difference_of(function, are_both_far);
    for (std::size_t k = 0; k < own.size(); ++k) {
        Parameter const &p = own.parameter(k);
        if (!p.output || p.type == Type::handle) continue;
        auto const describe = [&] { return std::string(p.name) + " of " + other.text(); };
        std::size_t const bytes = size_of(p.type) * own.length(k);
        if (p.type != Type::real) {
            bool const same =
                std::memcmp(own.elements<void>(k), other.elements<void>(k), bytes) == 0;
            if (!failures.check(same, function.name, 0.0, 1.0, describe)) return;
            continue;
        }
        for (std::size_t i = 0; i < own.length(k); ++i) {
            int const power = power_of(function, p, i, units);
            double const expected = std::ldexp(own.elements<double>(k)[i], power),
                         actual = other.elements<double>(k)[i],
                         most = difference > 0.0 ? difference * scale_of_row(other, k, i) : 0.0;
            bool const same = std::fabs(actual - expected) <= most || actual == expected ||
                              (std::isnan(actual) && std::isnan(expected));
            if (!failures.check(same, function.name, actual, expected, describe)) return;
        }
    }
}

/// Functions of one to several rows with units, without objects.
bool is_tested(Function const &function)
{
    bool has_unit = false;
    for (Parameter const &p : function.parameters) {
        bool const is_unknown = p.mixed_units && !p.output && p.type == Type::real;
        if (p.type == Type::handle || is_unknown) return false;
        has_unit = has_unit || p.length != 0 || p.time != 0;
    }
    return has_unit;
}

/// Calls visit() with calls of a function that differ by units: one of pairs of sizes of order one,
/// and others far from that.
template <class Visit> void for_each_problem(Function const &function, Visit const &visit)
{
    Random random(700);
    for (int const size_ratio : {-30, -20, -3, 0, 3, 20, 30})
        for (int n = 0; n < draws(8); ++n) {
            auto const pairs = unlike_pairs(random, size_ratio);
            Call own(function, pairs), far_away(function, pairs);
            Filling(own, pairs, size_ratio, random);
            Units const units = {-40, 7 * (n % 5 - 2)};
            copy_inputs(own, units, far_away);
            visit(own, far_away, units, false);
            for (int const length : {-20, 20, 40}) {
                Call other(function, pairs);
                copy_inputs(own, {length, units.time}, other);
                visit(far_away, other, {length - units.length, 0}, true);
            }
        }
}

void check_function(Failures &failures, Function const &function)
{
    for_each_problem(function, [&](Call &own, Call &other, Units units, bool are_both_far) {
        int const status = own().status, found = other().status;
        if (failures.check(found == status, function.name, found, status,
                           [&] { return other.text(); }))
            compare(failures, own, other, units, are_both_far);
    });
}

void test_functions()
{
    int tested = 0;
    for (Function const &function : declared_functions()) {
        if (!is_tested(function)) continue;
        Failures failures;
        check_function(failures, function);
        ++tested;
    }
    g_assert_cmpint(tested, >=, 180);
}

PW85_TEST("/scales/functions") { test_functions(); }

PW85_TEST("/scales/reproducible")
{
    int const before = is_reproducible();
    g_assert_cmpint(pw85_set_reproducible(1), ==, PW85_SUCCESS);
    test_functions();
    g_assert_cmpint(pw85_set_reproducible(before), ==, PW85_SUCCESS);
}

/// The pairs and images of a Verlet list, and whether it holds for these particles.
std::vector<std::int32_t> entries_of(Call &create)
{
    std::size_t const last = create.size() - 1;
    g_assert_cmpint(create().status, ==, PW85_SUCCESS);
    auto *const list = *create.elements<pw85_neighbors *>(last);
    pw85_pair_list const found = pw85_neighbors_list(list);
    std::vector<std::int32_t> all(found.pairs, found.pairs + 2 * found.num_pairs);
    all.insert(all.end(), found.images, found.images + 3 * found.num_pairs);
    return all;
}

PW85_TEST("/scales/neighbors")
{
    auto const &all = declared_functions();
    auto const create = std::find_if(
        all.begin(), all.end(), [](Function const &f) { return names(f, "neighbors_create"); });
    std::size_t entries = 0;
    Failures failures;
    for_each_problem(*create, [&](Call &own, Call &other, Units, bool) {
        auto const expected = entries_of(own), found = entries_of(other);
        failures.check(found == expected, "entries", static_cast<double>(found.size()),
                       static_cast<double>(expected.size()), [&] { return other.text(); });
        entries += found.size();
    });
    g_assert_cmpuint(entries, >, 1000);
}

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
// Compares areas and volumes of common parts with what others do: polygons of 100 points inside the
// ellipses, which the package SIBER intersects (here by Boost.Geometry), and Monte Carlo. Prints
// the rows `kind,method,time,error,ratio`: nanoseconds per pair, the largest error as a fraction of
// the smaller body, and the time over that of the first method of the kind. The polygons are made
// before the time is taken. The time of Monte Carlo is that of as many points as bring the standard
// deviation to 10⁻⁶ of the smaller body, by the time of a point. Errors are those against the
// templates with long double.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include <pw85_batch.h>

#include "least_time.hpp"
#include "random_pairs.hpp"

using namespace pw85_tests;

namespace {

using Polygon = boost::geometry::model::polygon<boost::geometry::model::d2::point_xy<double>>;

constexpr std::size_t pairs = 256;
constexpr int corners = 100;

/// Pairs of which most have a part in common.
template <int D> std::vector<Sample<double, D>> draw_pairs()
{
    Random random(1580 + D);
    std::vector<Sample<double, D>> drawn;
    PairOptions options{};
    options.aspect = 5.0;
    options.mu2_min = 0.1;
    options.mu2_max = 0.9;
    for (std::size_t k = 0; k < pairs; ++k) drawn.push_back(random_pair<D>(random, options));
    return drawn;
}

template <int D> double whole(pw85::SymmetricMatrix<double, D> const &q)
{
    double x = 0.0;
    (D == 3 ? pw85_volume : pw85_area_2d)(q.entries, &x);
    return x;
}

template <int D> double smaller(Sample<double, D> const &p)
{
    return std::fmin(whole(p.q1), whole(p.q2));
}

template <int D> double common(Sample<double, D> const &p)
{
    double x = 0.0;
    (D == 3 ? pw85_overlap_volume : pw85_overlap_area_2d)(p.r12.coordinates, p.q1.entries,
                                                          p.q2.entries, &x);
    return x;
}

template <int D> double truth(Sample<double, D> const &p)
{
    auto const wide = convert<long double>(p);
    if constexpr (D == 3)
        return static_cast<double>(pw85::overlap_volume(wide.r12, wide.q1, wide.q2).volume);
    else
        return static_cast<double>(pw85::overlap_area(wide.r12, wide.q1, wide.q2).area);
}

/// The derivative with respect to r12, with those with respect to the forms.
template <int D> double gradient(Sample<double, D> const &p)
{
    double r12[3], q1[6], q2[6];
    (D == 3 ? pw85_overlap_volume_gradient : pw85_overlap_area_gradient_2d)(
        p.r12.coordinates, p.q1.entries, p.q2.entries, r12, q1, q2);
    return r12[0];
}

/// A regular polygon of a circle, mapped to an ellipse.
Polygon polygon_of(pw85::SymmetricMatrix<double, 2> const &q, pw85::Vector<double, 2> const &center)
{
    double const a = std::sqrt(q(0, 0)), b = q(0, 1) / a, c = std::sqrt(q(1, 1) - b * b);
    Polygon polygon;
    for (int k = 0; k <= corners; ++k) {
        double const angle = -2.0 * std::numbers::pi * (k % corners) / corners; // clockwise, closed
        double const x = std::cos(angle), y = std::sin(angle);
        boost::geometry::append(polygon.outer(), boost::geometry::model::d2::point_xy<double>(
                                                     center[0] + a * x, center[1] + b * x + c * y));
    }
    return polygon;
}

struct PolygonPair {
    Polygon first, second;
};

double common(PolygonPair const &p)
{
    std::vector<Polygon> parts;
    boost::geometry::intersection(p.first, p.second, parts);
    double sum = 0.0;
    for (Polygon const &part : parts) sum += boost::geometry::area(part);
    return sum;
}

/// The pairs as rows.
struct PairRows {
    std::vector<double> r12, q1, q2, areas;
};

PairRows rows_of(std::vector<Sample<double, 2>> const &drawn)
{
    PairRows rows{{}, {}, {}, std::vector<double>(drawn.size())};
    for (auto const &p : drawn) {
        rows.r12.insert(rows.r12.end(), p.r12.coordinates, p.r12.coordinates + 2);
        rows.q1.insert(rows.q1.end(), p.q1.entries, p.q1.entries + 3);
        rows.q2.insert(rows.q2.end(), p.q2.entries, p.q2.entries + 3);
    }
    return rows;
}

double time_of_rows(PairRows &rows)
{
    return pw85_bench::least_time(pairs, [&](std::size_t begin, std::size_t end) {
        pw85_overlap_area_batch_2d(end - begin, &rows.r12[2 * begin], &rows.q1[3 * begin],
                                   &rows.q2[3 * begin], &rows.areas[begin]);
    });
}

template <class Items, class Call> double time_of(Items const &items, Call call)
{
    double volatile sink = 0.0;
    double const time =
        pw85_bench::least_time(items.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) sink = call(items[i]);
        });
    static_cast<void>(sink);
    return time;
}

/// Nanoseconds for a point of Monte Carlo: a point of the box of ellipsoid 1, and whether it is in
/// both.
template <int D> double time_of_point(Sample<double, D> const &p)
{
    constexpr std::size_t points = 4096;
    Random random(1590);
    auto const f1 = pw85::detail::factorize(p.q1, 0.0), f2 = pw85::detail::factorize(p.q2, 0.0);
    long hits = 0;
    double const time = pw85_bench::least_time(points, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            pw85::Vector<double, D> x{};
            for (int i = 0; i < D; ++i) x[i] = std::sqrt(p.q1(i, i)) * random.uniform(-1.0, 1.0);
            hits += pw85::detail::inverse_form(f1, x) <= 1.0 &&
                    pw85::detail::inverse_form(f2, x - p.r12) <= 1.0;
        }
    });
    return hits < 0 ? 0.0 : time;
}

/// The points that are needed, on average over the pairs.
template <int D> double points_needed(std::vector<Sample<double, D>> const &drawn)
{
    double sum = 0.0;
    for (auto const &p : drawn) {
        double box = std::pow(2.0, D);
        for (int i = 0; i < D; ++i) box *= std::sqrt(p.q1(i, i));
        double const share = common(p) / box, sigma = 1e-6 * smaller(p) / box;
        sum += share * (1.0 - share) / (sigma * sigma);
    }
    return sum / static_cast<double>(drawn.size());
}

void print(char const *kind, char const *method, double time, char const *error, double first)
{
    std::printf("%s,%s,%.3g,%s,%.2g\n", kind, method, time, error, time / first);
}

template <int D> void compare(char const *kind)
{
    auto const drawn = draw_pairs<D>();
    auto const largest = [&](auto const &items, auto const &call) {
        double error = 0.0;
        for (std::size_t k = 0; k < drawn.size(); ++k)
            error =
                std::fmax(error, std::fabs(call(items[k]) - truth(drawn[k])) / smaller(drawn[k]));
        char text[32];
        std::snprintf(text, sizeof text, "%.1e", error);
        return std::string(text);
    };
    auto const ours = [](Sample<double, D> const &p) { return common(p); };
    double const first = time_of(drawn, ours);
    print(kind, D == 3 ? "pw85_overlap_volume" : "pw85_overlap_area_2d", first,
          largest(drawn, ours).c_str(), first);
    print(kind, D == 3 ? "pw85_overlap_volume_gradient" : "pw85_overlap_area_gradient_2d",
          time_of(drawn, [](Sample<double, D> const &p) { return gradient(p); }), "", first);
    if constexpr (D == 2) {
        PairRows rows = rows_of(drawn);
        print(kind, "pw85_overlap_area_batch_2d", time_of_rows(rows), "", first);
        std::vector<PolygonPair> polygons;
        for (auto const &p : drawn)
            polygons.push_back({polygon_of(p.q1, {}), polygon_of(p.q2, p.r12)});
        auto const theirs = [](PolygonPair const &p) { return common(p); };
        print(kind, "polygons of 100 points (Boost.Geometry)", time_of(polygons, theirs),
              largest(polygons, theirs).c_str(), first);
    }
    print(kind, "Monte Carlo", points_needed(drawn) * time_of_point(drawn[0]), "1.0e-06", first);
}

} // namespace

int main()
{
    std::printf("kind,method,time,error,ratio\n");
    compare<2>("area");
    compare<3>("volume");
    return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
// Prints the time of the functions of one ellipsoid and a convex set, of their batches, and of the
// test whether one ellipsoid contains another, as CSV, in nanoseconds. μ² is log-uniform from 1/4
// to 4, so that half of the sets overlap, and half of the ellipsoids are contained.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <pw85.h>
#include <pw85_batch.h>

#include "least_time.hpp"
#include "pairs.hpp"

using namespace pw85_bench;
using pw85_tests::Random;

namespace {

using Vector3 = pw85::Vector<double, 3>;
using Form3 = pw85::SymmetricMatrix<double, 3>;

/// Arrays of up to three points and of a form for each ellipsoid.
struct Rows {
    std::vector<Vector3> points[3];
    std::vector<Form3> q, contained;

    double const *point(int k, std::size_t i) const { return points[k][i].coordinates; }
    double const *form(std::size_t i) const { return q[i].entries; }
};

/// The factor that makes μ² log-uniform from 1/4 to 4.
double scale(Random &random, double mu2) { return std::sqrt(random.log_uniform(0.25, 4.0) / mu2); }

double mu2_of_hull(int count, Vector3 const (&points)[3], Form3 const &q)
{
    return (count == 2 ? pw85::contact_segment(points[0], points[1], q)
                       : pw85::contact_triangle(points[0], points[1], points[2], q))
        .mu2;
}

double mu2_of_box(Vector3 (&corners)[3], Form3 const &q)
{
    for (int i = 0; i < 3; ++i)
        if (corners[0][i] > corners[1][i]) std::swap(corners[0][i], corners[1][i]);
    return pw85::contact_box(corners[0], corners[1], q).mu2;
}

/// Ellipsoids of sizes within a factor of 2, and sets about as large, which are not around their
/// centres. `count` is the number of points of a hull, or 0 for boxes.
Rows random_sets(double aspect, int count)
{
    Random random(static_cast<std::uint64_t>(aspect) + 7);
    Rows rows;
    while (rows.q.size() < block_size) {
        Form3 const q = random.form(random.log_uniform(0.5, 2.0), aspect);
        Vector3 const place = random.log_uniform(0.5, 4.0) * random.direction<3>();
        Vector3 points[3];
        for (auto &x : points) x = place + random.log_uniform(0.5, 2.0) * random.direction<3>();
        double const mu2 = count == 0 ? mu2_of_box(points, q) : mu2_of_hull(count, points, q);
        if (!(mu2 > 1e-12)) continue;
        double const factor = scale(random, mu2);
        for (int k = 0; k < 3; ++k) rows.points[k].push_back(factor * points[k]);
        rows.q.push_back(q);
    }
    return rows;
}

/// Pairs of ellipsoids, by the separation and two forms.
Rows random_contents(double aspect)
{
    Random random(static_cast<std::uint64_t>(aspect) + 8);
    Rows rows;
    for (int n = 0; n < block_size; ++n) {
        Form3 const q1 = random.form(random.log_uniform(0.5, 2.0), aspect),
                    q2 = random.form(1.0, aspect);
        Vector3 const r12 = random.log_uniform(0.1, 2.0) * random.direction<3>();
        double const factor = scale(random, pw85::containment(r12, q1, q2).mu2);
        rows.points[0].push_back(factor * r12);
        rows.q.push_back(q1);
        rows.contained.push_back((factor * factor) * q2);
    }
    return rows;
}

double mu2[block_size], point[3 * block_size];
unsigned char overlap[block_size];
int answer;

using Call = void (*)(Rows const &, std::size_t begin, std::size_t end);

/// Calls a function of one row for a range of rows.
template <auto call> void each(Rows const &rows, std::size_t begin, std::size_t end)
{
    for (std::size_t i = begin; i < end; ++i) call(rows, i);
}

struct Function {
    char const *name;
    int count; ///< as for random_sets(); -1 for pairs of ellipsoids
    Call call;
};

#define PW85_BENCH_TWO(x, i) (x).point(0, i), (x).point(1, i), (x).form(i)
#define PW85_BENCH_THREE(x, i) (x).point(0, i), (x).point(1, i), (x).point(2, i), (x).form(i)

constexpr Function functions[] = {
    {"contact_segment", 2, each<[](Rows const &x, std::size_t i) {
         pw85_contact_segment(PW85_BENCH_TWO(x, i), mu2, point);
     }>},
    {"contact_triangle", 3, each<[](Rows const &x, std::size_t i) {
         pw85_contact_triangle(PW85_BENCH_THREE(x, i), mu2, point);
     }>},
    {"contact_box", 0, each<[](Rows const &x, std::size_t i) {
         pw85_contact_box(PW85_BENCH_TWO(x, i), mu2, point);
     }>},
    {"overlap_segment", 2, each<[](Rows const &x, std::size_t i) {
         pw85_overlap_segment(PW85_BENCH_TWO(x, i), &answer);
     }>},
    {"overlap_triangle", 3, each<[](Rows const &x, std::size_t i) {
         pw85_overlap_triangle(PW85_BENCH_THREE(x, i), &answer);
     }>},
    {"overlap_box", 0,
     each<[](Rows const &x, std::size_t i) { pw85_overlap_box(PW85_BENCH_TWO(x, i), &answer); }>},
    {"intersect_line", 2,
     each<[](Rows const &x, std::size_t i) { pw85_intersect_line(PW85_BENCH_TWO(x, i), point); }>},
    {"intersect_line_batch", 2,
     [](Rows const &x, std::size_t i, std::size_t end) {
         pw85_intersect_line_batch(end - i, PW85_BENCH_TWO(x, i), mu2, point);
     }},
    {"contact_segment_batch", 2,
     [](Rows const &x, std::size_t i, std::size_t end) {
         pw85_contact_segment_batch(end - i, PW85_BENCH_TWO(x, i), mu2, point);
     }},
    {"contact_triangle_batch", 3,
     [](Rows const &x, std::size_t i, std::size_t end) {
         pw85_contact_triangle_batch(end - i, PW85_BENCH_THREE(x, i), mu2, point);
     }},
    {"contact_box_batch", 0,
     [](Rows const &x, std::size_t i, std::size_t end) {
         pw85_contact_box_batch(end - i, PW85_BENCH_TWO(x, i), mu2, point);
     }},
    {"overlap_segment_batch", 2,
     [](Rows const &x, std::size_t i, std::size_t end) {
         pw85_overlap_segment_batch(end - i, PW85_BENCH_TWO(x, i), overlap);
     }},
    {"overlap_triangle_batch", 3,
     [](Rows const &x, std::size_t i, std::size_t end) {
         pw85_overlap_triangle_batch(end - i, PW85_BENCH_THREE(x, i), overlap);
     }},
    {"overlap_box_batch", 0,
     [](Rows const &x, std::size_t i, std::size_t end) {
         pw85_overlap_box_batch(end - i, PW85_BENCH_TWO(x, i), overlap);
     }},
    {"contains", -1, each<[](Rows const &x, std::size_t i) {
         pw85_contains(x.point(0, i), x.form(i), x.contained[i].entries, &answer);
     }>},
};

} // namespace

int main()
{
    double const aspects[] = {2.0, 10.0, 100.0, 1000.0};
    std::puts("function,aspect_2,aspect_10,aspect_100,aspect_1000");
    for (Function const &function : functions) {
        std::printf("%s", function.name);
        for (double const aspect : aspects) {
            Rows const rows =
                function.count < 0 ? random_contents(aspect) : random_sets(aspect, function.count);
            auto const call = [&](std::size_t begin, std::size_t end) {
                function.call(rows, begin, end);
            };
            std::printf(",%.3g", least_time(block_size, call));
        }
        std::puts("");
    }
    return 0;
}

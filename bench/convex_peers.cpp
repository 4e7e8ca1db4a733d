// SPDX-License-Identifier: BSD-3-Clause
// Compares DGD (growth distances of convex sets) and ellipsoid_tree (overlaps of ellipsoids) with
// this library on the same pairs. measure.py runs it by name: --only convex_peers.
//
// Half of the pairs overlap. Times are in nanoseconds, the least of several passes over a block.
// Wrong are booleans that differ from the exact answer. The error is the largest relative one of
// μ², by DGD's growth distance and this library's contact function.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include <pw85.h>

#include <Eigen/Eigenvalues>
#include <dgd/dgd.h>
#include <dgd/geometry/3d/ellipsoid.h>
#include <ellipsoid_tree/intersections.hpp>

#include "least_time.hpp"
#include "pairs.hpp"

using namespace pw85_bench;

namespace {

constexpr int pairs_of_a_kind = 4000;

/// An ellipsoid as DGD has it: semi-axes, and a rotation with a centre.
struct Body {
    std::unique_ptr<dgd::Ellipsoid> shape;
    dgd::Transform3r place = dgd::Transform3r::Identity();

    explicit Body(ellipsoid_tree::Ellipsoid const &x)
    {
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> const solver(Eigen::Matrix3d{x.Sigma});
        Eigen::Vector3d const axes = solver.eigenvalues().cwiseSqrt();
        Eigen::Matrix3d rotation = solver.eigenvectors();
        if (rotation.determinant() < 0.0) rotation.col(0) *= -1.0;
        shape = std::make_unique<dgd::Ellipsoid>(axes(0), axes(1), axes(2));
        dgd::Linear(place) = rotation;
        dgd::Affine(place) = x.mu;
    }
};

ellipsoid_tree::Ellipsoid ellipsoid(pw85::Vector<double, 3> const &center,
                                    pw85::SymmetricMatrix<double, 3> const &q)
{
    Eigen::Matrix3d sigma;
    double const *const e = q.entries;
    sigma << e[0], e[1], e[2], e[1], e[3], e[4], e[2], e[4], e[5];
    return {Eigen::Vector3d(center[0], center[1], center[2]), sigma};
}

/// A pair as each of the libraries has it, made beforehand.
struct Problem {
    Pair pair;
    ellipsoid_tree::Ellipsoid first, second;
    Body body1, body2;

    explicit Problem(Pair const &p)
        : pair(p), first(ellipsoid({0.0, 0.0, 0.0}, p.q1)), second(ellipsoid(p.r12, p.q2)),
          body1(first), body2(second)
    {
    }
};

bool overlap(Problem const &x)
{
    int result = 0;
    pw85_overlap(x.pair.r12.coordinates, x.pair.q1.entries, x.pair.q2.entries, &result);
    return result == 1;
}

double contact(Problem const &x)
{
    double out[2];
    pw85_contact(x.pair.r12.coordinates, x.pair.q1.entries, x.pair.q2.entries, out);
    return out[0];
}

bool overlap_by_tree(Problem const &x)
{
    return ellipsoid_tree::intersects(x.first, x.second, 1.0);
}

double growth(Problem const &x)
{
    dgd::Output<3> out;
    return dgd::GrowthDistanceTrn<3>(x.body1.shape.get(), x.body1.place, x.body2.shape.get(),
                                     x.body2.place, dgd::Settings(), out, false);
}

bool overlap_by_dgd(Problem const &x)
{
    dgd::Output<3> out;
    return dgd::DetectCollision<3>(x.body1.shape.get(), x.body1.place, x.body2.shape.get(),
                                   x.body2.place, dgd::Settings(), out, false);
}

/// Nanoseconds per pair. The results are stored, so that the compiler cannot remove the calls.
template <class Call> double time_of(std::vector<Problem> const &problems, Call call)
{
    double volatile sink = 0.0;
    double const time = least_time(problems.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) sink = static_cast<double>(call(problems[i]));
    });
    static_cast<void>(sink);
    return time;
}

void print_row(double aspect, double excess)
{
    std::vector<Problem> problems;
    for (Pair const &pair : random_block(aspect, excess, pairs_of_a_kind))
        problems.emplace_back(pair);
    int wrong_tree = 0, wrong_dgd = 0;
    double error = 0.0;
    for (Problem const &x : problems) {
        double const mu2 = contact(x), mu = growth(x);
        wrong_tree += overlap_by_tree(x) != overlap(x);
        wrong_dgd += (mu < 1.0) != overlap(x);
        error = std::max(error, std::abs(mu * mu - mu2) / mu2);
    }
    std::printf("%g,%g,%.0f,%.0f,%d,%.0f,%.0f,%.0f,%d,%.1e\n", aspect, excess,
                time_of(problems, overlap), time_of(problems, overlap_by_tree), wrong_tree,
                time_of(problems, overlap_by_dgd), time_of(problems, contact),
                time_of(problems, growth), wrong_dgd, error);
}

} // namespace

int main()
{
    std::puts("aspect,excess,overlap,overlap_tree,wrong_tree,overlap_dgd,contact,growth_dgd,wrong_"
              "dgd,error_dgd");
    for (double const excess : {0.0, 1e-3, 1e-7})
        for (double const aspect : {2.0, 10.0, 100.0}) print_row(aspect, excess);
}

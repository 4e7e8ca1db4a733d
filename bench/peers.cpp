// FCL side by side with this library, on the same pairs: whether two ellipsoids overlap, and their distance.
//
// Half of the pairs overlap, with |μ² - 1| as given; distances are those of the other half. Times are nanoseconds, the least of
// several passes over a block; wrong and failed answers are in percent. A form comes from its principal axes only to rounding,
// some 1e-16 times the square of the aspect ratio, which is far below the errors found: those are absolute, the largest semi-axis
// of the first ellipsoid being 1.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>

#include <fcl/fcl.h>

#include <pw85.h>

#include "pairs.hpp"

using namespace pw85_bench;

namespace {

/// An ellipsoid as FCL takes it: semi-axes, and where they are.
struct Body {
    fcl::Ellipsoidd shape;
    fcl::Transform3d place = fcl::Transform3d::Identity();

    Body(pw85::SymmetricMatrix<double, 3> const &q, pw85::Vector<double, 3> const &center) : shape(1.0, 1.0, 1.0)
    {
        fcl::Matrix3d form;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) form(i, j) = q(i, j);
        Eigen::SelfAdjointEigenSolver<fcl::Matrix3d> const axes(form);
        fcl::Matrix3d turn = axes.eigenvectors();
        if (turn.determinant() < 0.0) turn.col(0) *= -1.0;
        shape = fcl::Ellipsoidd(axes.eigenvalues().cwiseSqrt());
        place.linear() = turn;
        place.translation() = fcl::Vector3d(center[0], center[1], center[2]);
    }
};

struct Bodies {
    Body first, second;
};

bool fcl_collide(Bodies const &b, fcl::GJKSolverType solver)
{
    fcl::CollisionRequestd request;
    request.gjk_solver_type = solver;
    fcl::CollisionResultd result;
    return fcl::collide(&b.first.shape, b.first.place, &b.second.shape, b.second.place, request, result) > 0;
}

/// NaN where FCL throws.
double fcl_distance(Bodies const &b, fcl::GJKSolverType solver)
{
    fcl::DistanceRequestd request;
    request.gjk_solver_type = solver;
    fcl::DistanceResultd result;
    try {
        return fcl::distance(&b.first.shape, b.first.place, &b.second.shape, b.second.place, request, result);
    } catch (std::exception const &) {
        return std::numeric_limits<double>::quiet_NaN();
    }
}

bool overlap(Pair const &x)
{
    int result = 0;
    pw85_overlap(x.r12.coordinates, x.q1.entries, x.q2.entries, &result);
    return result == 1;
}

double distance(Pair const &x)
{
    double result = 0.0;
    pw85_distance(x.r12.coordinates, x.q1.entries, x.q2.entries, &result, nullptr, nullptr);
    return result;
}

/// Nanoseconds per item, the least of some passes; results go where the compiler cannot drop them.
template <class Items, class Call> double time_of(Items const &items, Call call)
{
    double least = std::numeric_limits<double>::infinity();
    double volatile sink = 0.0;
    for (int pass = 0; pass < 7; ++pass) {
        auto const start = std::chrono::steady_clock::now();
        for (auto const &item : items) sink = static_cast<double>(call(item));
        std::chrono::duration<double, std::nano> const taken = std::chrono::steady_clock::now() - start;
        least = std::min(least, taken.count() / static_cast<double>(items.size()));
    }
    static_cast<void>(sink);
    return least;
}

struct Solver {
    char const *name;
    fcl::GJKSolverType type;
};

void compare(std::vector<Pair> const &pairs, std::vector<Bodies> const &bodies, Solver const &solver)
{
    std::vector<Pair> apart;
    std::vector<Bodies> bodies_apart;
    int wrong = 0, failed = 0;
    double largest = 0.0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        bool const overlaps = overlap(pairs[i]);
        if (fcl_collide(bodies[i], solver.type) != overlaps) ++wrong;
        if (overlaps) continue;
        apart.push_back(pairs[i]);
        bodies_apart.push_back(bodies[i]);
        double const found = fcl_distance(bodies[i], solver.type);
        if (!(found >= 0.0)) // it says -1 for pairs that it takes for overlapping
            ++failed;
        else
            largest = std::max(largest, std::abs(found - distance(pairs[i])));
    }
    auto const fcl_collides = [&](Bodies const &b) { return fcl_collide(b, solver.type); };
    auto const fcl_distances = [&](Bodies const &b) { return fcl_distance(b, solver.type); };
    std::printf("%s,%.0f,%.0f,%.3g,%.0f,%.0f,%.3g,%.1e\n", solver.name, time_of(pairs, overlap),
                time_of(bodies, fcl_collides), 100.0 * wrong / static_cast<double>(pairs.size()),
                time_of(apart, distance), time_of(bodies_apart, fcl_distances),
                100.0 * failed / static_cast<double>(apart.size()), largest);
}

} // namespace

int main()
{
    std::printf("aspect,excess,solver,overlap,overlap_fcl,wrong,distance,distance_fcl,failed,error\n");
    for (double const aspect : {2.0, 10.0, 100.0})
        for (double const excess : {0.5, 1e-2, 1e-4, 1e-6}) {
            auto const pairs = random_block(aspect, excess, 1000);
            std::vector<Bodies> bodies;
            for (Pair const &x : pairs) bodies.push_back({{x.q1, {0.0, 0.0, 0.0}}, {x.q2, x.r12}});
            for (Solver const solver : {Solver{"libccd", fcl::GST_LIBCCD}, Solver{"indep", fcl::GST_INDEP}}) {
                std::printf("%g,%g,", aspect, excess);
                compare(pairs, bodies, solver);
            }
        }
    return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Random clusters of hard ellipsoids: neighbours that overlap along the branches of a tree.
#ifndef PW85_REFERENCE_CLUSTER_HPP_INCLUDED
#define PW85_REFERENCE_CLUSTER_HPP_INCLUDED

#include <algorithm>
#include <cstdint>

#include <pw85/algebra/philox.hpp>
#include <pw85/pw85.hpp>

#include "graphs.hpp"

namespace virial {

using Vector3 = pw85::Vector<double, 3>;
using Form = pw85::SymmetricMatrix<double, 3>;
using pw85::detail::Stream;

inline constexpr int most_particles = 6;

struct Ellipsoid {
    Vector3 center;
    Form form;
};

/// A point of the unit disc, not its centre.
inline pw85::Vector<double, 2> in_disc(Stream &random)
{
    pw85::Vector<double, 2> x;
    do x = {random.symmetric(), random.symmetric()};
    while (dot(x, x) > 1.0);
    return x;
}

/// A uniform rotation, as a quaternion: G. Marsaglia, Choosing a point from the surface of a
/// sphere, Annals of Mathematical Statistics 43, 645 (1972).
inline pw85::Vector<double, 4> random_rotation(Stream &random)
{
    auto const u = in_disc(random), v = in_disc(random);
    double const factor = pw85::detail::square_root((1.0 - dot(u, u)) / dot(v, v));
    return {u[0], u[1], factor * v[0], factor * v[1]};
}

/// Clusters of ellipsoids with the same semi-axes.
class Clusters {
  public:
    explicit Clusters(Vector3 semi_axes)
        : semi_axes_(semi_axes), largest_(largest_determinant(semi_axes))
    {
    }

    /// The overlaps of a cluster, in which each branch of a tree is a uniformly distributed pair
    /// that overlaps. `trials` grows by the number of ellipsoids that were tried.
    Graph overlaps(Branches const &tree, Stream &random, std::uint64_t &trials) const
    {
        Ellipsoid cluster[most_particles];
        cluster[0] = {{0.0, 0.0, 0.0},
                      pw85::ellipsoid_quaternion(semi_axes_, {1.0, 0.0, 0.0, 0.0}).q};
        Graph graph = 0;
        for (auto const &[i, j] : tree) {
            cluster[j] = neighbor(cluster[i], random, trials);
            graph |= edge(i, j);
        }
        for (int j = 1; j <= static_cast<int>(tree.size()); ++j)
            for (int i = 0; i < j; ++i)
                if (!(graph & edge(i, j)) && overlap(cluster[i], cluster[j])) graph |= edge(i, j);
        return graph;
    }

    /// B2 in units of the volume of an ellipsoid, if each trial found a neighbour: see neighbor().
    double bound_on_b2() const
    {
        return 0.5 * pw85::detail::square_root(largest_) /
               (semi_axes_[0] * semi_axes_[1] * semi_axes_[2]);
    }

  private:
    static bool overlap(Ellipsoid const &first, Ellipsoid const &second)
    {
        return pw85::overlap(second.center - first.center, first.form, second.form).overlap;
    }

    /// An upper bound of det(2 Q1 + 2 Q2). det(A + B) is at most the product of the sums of
    /// eigenvalues, those of A in ascending and those of B in descending order: M. Fiedler, Bounds
    /// for the determinant of the sum of Hermitian matrices, Proceedings of the American
    /// Mathematical Society 30, 27 (1971).
    static double largest_determinant(Vector3 a)
    {
        std::sort(a.coordinates, a.coordinates + 3);
        double const outer = 2.0 * (a[0] * a[0] + a[2] * a[2]), middle = 4.0 * a[1] * a[1];
        return outer * middle * outer;
    }

    /// The point of the ellipsoid with the form L·diag(d)·Lᵀ that belongs to a point of the unit
    /// ball, L·diag(√d) x.
    static Vector3 image_of_ball(pw85::detail::Factorization<double, 3> const &f, Vector3 x)
    {
        for (int i = 0; i < 3; ++i) x[i] = x[i] * pw85::detail::square_root(f.pivots[i]);
        return {x[0], x[1] + f.lower[1][0] * x[0],
                x[2] + f.lower[2][0] * x[0] + f.lower[2][1] * x[1]};
    }

    /// An ellipsoid that overlaps a given one, of uniform orientation and place. μ² >= f(1/2) =
    /// r12ᵀ (2 Q1 + 2 Q2)⁻¹ r12, so the centres of all that overlap are in the ellipsoid with the
    /// form 2 Q1 + 2 Q2. The orientation of a trial is accepted with a probability proportional to
    /// the volume of this ellipsoid, and its place is uniform there. So the probability of a
    /// neighbour is 2 B2 / (4π/3 √largest_).
    Ellipsoid neighbor(Ellipsoid const &given, Stream &random, std::uint64_t &trials) const
    {
        for (;;) {
            ++trials;
            Form const form = pw85::ellipsoid_quaternion(semi_axes_, random_rotation(random)).q;
            auto const outer =
                pw85::detail::factorize(pw85::detail::blend(2.0, given.form, 2.0, form), 0.0);
            double const determinant = outer.pivots[0] * outer.pivots[1] * outer.pivots[2],
                         chosen = random.uniform();
            if (chosen * chosen * largest_ > determinant) continue;
            Ellipsoid const trial = {given.center + image_of_ball(outer, random.in_ball()), form};
            if (overlap(given, trial)) return trial;
        }
    }

    Vector3 semi_axes_;
    double largest_;
};

} // namespace virial

#endif

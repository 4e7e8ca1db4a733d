// SPDX-License-Identifier: GPL-2.0-only
// Passes rows of pairs to the library, and its contacts to the laws of force.
#include "grain_geometry.hpp"

#include <pw85_batch.h>

#include <algorithm>

namespace pw85_lammps {

void GrainSearch::add(Vector const &r12, double const *q1, double const *q2, Vector const &normal)
{
    pairs_.r12[size_] = r12;
    pairs_.start[size_] = normal;
    std::copy_n(q1, PW85_SYM, pairs_.q1[size_].begin());
    std::copy_n(q2, PW85_SYM, pairs_.q2[size_].begin());
    ++size_;
}

void GrainSearch::solve() { solve(0, size_); }

void GrainSearch::search_again(std::size_t k, Vector const &normal)
{
    start(k, normal);
    solve(k, 1);
}

/// The library marks a pair without a contact with NaN; the status says no more than that.
void GrainSearch::solve(std::size_t first, std::size_t count)
{
    auto &[r12, start, q1, q2] = pairs_;
    auto &[normal, point, depth, radius, curvatures] = results_;
    pw85_grain_contact_batch(count, r12[first].data(), q1[first].data(), q2[first].data(),
                             start[first].data(), normal[first].data(), &depth[first],
                             point[first].data(), curvatures[first].data(), &radius[first]);
    for (std::size_t l = first; l < first + count; ++l) {
        Vector const half = 0.5 * depth[l] * normal[l];
        store(normal[l], rows_.normal, l);
        store(point[l] + half, rows_.arm1, l);
        store(point[l] - half - r12[l], rows_.arm2, l);
        store(curvatures[l], rows_.curvatures, l);
        rows_.depth[l] = depth[l];
        rows_.radius[l] = radius[l];
    }
}

GrainGeometry GrainSearch::contact(std::size_t k) const
{
    return {load(rows_.normal, k),    rows_.depth[k],  load(rows_.arm1, k),
            load(rows_.arm2, k),      rows_.radius[k], -1,
            load(rows_.curvatures, k)};
}

GrainGeometry wall_geometry(double const *q, Vector const &normal, double distance,
                            Vector const &direction, double curvature)
{
    GrainGeometry g{};
    g.normal = normal;
    pw85_grain_contact_wall(normal.data(), distance, direction.data(), curvature, q, &g.depth,
                            g.arm1.data(), g.curvatures.data(), &g.radius);
    g.arm2 = g.arm1 - g.depth * normal;
    return g;
}

} // namespace pw85_lammps

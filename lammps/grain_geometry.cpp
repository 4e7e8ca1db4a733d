// SPDX-License-Identifier: GPL-2.0-only
// Passes rows of pairs to the library, and its contacts to the laws of force.
#include "grain_geometry.hpp"

#include <pw85_batch.h>

namespace pw85_lammps {

/// The library marks a pair without a contact with NaN; the status says no more than that.
void GrainSearch::solve(std::size_t first, std::size_t count)
{
    auto &[r12, start, q1, q2] = pairs_;
    auto &[normal, point] = results_;
    pw85_grain_contact_batch(count, r12[first].data(), q1[first].data(), q2[first].data(),
                             start[first].data(), normal[first].data(), &rows_.depth[first],
                             point[first].data(), rows_.curvatures[first].data(),
                             &rows_.radius[first]);
    for (std::size_t l = first; l < first + count; ++l) {
        store(normal[l], rows_.normal, l);
        store(point[l], rows_.point, l);
    }
}

GrainGeometry GrainSearch::contact(std::size_t k) const
{
    auto const [arm1, arm2] = rows_.arms(k);
    return {load(rows_.normal, k), rows_.depth[k], arm1, arm2, rows_.radius[k], -1,
            rows_.curvatures[k]};
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

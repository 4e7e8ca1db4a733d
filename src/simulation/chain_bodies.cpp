// SPDX-License-Identifier: BSD-3-Clause
// The particles of event chains: see chain_bodies.hpp.
#include "chain_bodies.hpp"

#include <pw85/motion/free_path.hpp>
#include <pw85/overlap/overlap.hpp>

namespace pw85::detail::simulation {

int ChainBodies::prepare() noexcept
{
    std::size_t const n = configuration_.size();
    longest_ = configuration_.longest_semi_axis();
    unit_ = n > 0 ? unit_of(longest_) : Unit{};
    Cell const &cell = configuration_.cell;
    neighbors::Periodicity periodicity;
    own_images_may_touch_ = cell.exists && periodicity.prepare(cell.vectors, cell.periodic) &&
                            periodicity.shortest() <= (1.0 + 0x1p-40) * 2.0 * longest_;
    if (!bodies_.resize(n) || !numbers_.resize(n)) return PW85_ENOMEM;
    if (int const status = bins_.prepare(configuration_, bin_size * longest_)) return status;
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t const i = bins_.number_in_configuration(k);
        bodies_[k] = read(i);
        numbers_[i] = static_cast<std::int32_t>(k);
    }
    return PW85_SUCCESS;
}

/// Returns the body of a particle.
///
/// In two dimensions directions are in the plane of the centres. The forms are block diagonal, and
/// so is M of path_bounds.hpp. So the bounds, the contact and its plane are those of the ellipses,
/// whatever the entry of z is, and z has no part in the normal. An entry like the others makes the
/// bounds narrow.
ChainBody ChainBodies::read(std::size_t particle) const noexcept
{
    Form3 q = unit_.to_local(configuration_.q[particle]);
    if (configuration_.dimensions == 2) q[5] = 0.5 * (q[0] + q[3]);
    double const root = elementary::sqrt(trace(q));
    return {configuration_.centers[particle], configuration_.half_widths[particle], q, root,
            1.0 / root};
}

/// Returns whether a plane certainly separates body i from its image.
bool ChainBodies::separates(SeparatingPlane const &plane, std::size_t i,
                            Vector3 const &center) const noexcept
{
    auto const &[translation, j] = plane.image;
    Vector3 const r12 = unit_.to_local(1.0) * separation(center, bodies_[j].center, translation);
    auto const pair = pair_of(r12, bodies_[i].q, bodies_[j].q);
    double const gap = free_by_normal({pair, {}}, -plane.normal, plane.normal);
    return gap > 0.0 && gap < infinity<double>(); // infinity if the square of the normal vanishes
}

bool ChainBodies::is_free_of(SeparatingPlane &plane, std::size_t i,
                             Vector3 const &center) const noexcept
{
    if (separates(plane, i, center)) return true;
    plane.normal = {};
    auto const &[translation, j] = plane.image;
    Vector3 const r12 = separation(center, bodies_[j].center, translation);
    return !call_overlap(r12, configuration_.q[bins_.number_in_configuration(i)],
                         configuration_.q[bins_.number_in_configuration(j)])
                .overlap;
}

void ChainBodies::move(std::size_t i, Vector3 const &center) noexcept
{
    bodies_[i].center = center;
    bins_.move(i, center);
    configuration_.centers[bins_.number_in_configuration(i)] = center;
}

} // namespace pw85::detail::simulation

// SPDX-License-Identifier: BSD-3-Clause
// Decides whether particles meet a hard mesh: see mesh_wall.hpp.
#include "mesh_wall.hpp"

#include "../base/last_error.hpp"
#include "../base/objects.hpp"

namespace pw85::detail::simulation {

namespace {

/// The part by which lengths are enlarged before they decide that an image is far from the mesh. It
/// covers thousands of rounding errors.
constexpr double margin = 0x1p-40;

} // namespace

void MeshWall::enclose(Cell const &cell) noexcept
{
    Vector3 lower = {infinity<double>(), infinity<double>(), infinity<double>()}, upper = -lower;
    for (std::size_t k = 0; k < triangles.size(); ++k)
        for (int d = 0; d < 3; ++d) {
            double const x =
                vertices[3 * static_cast<std::size_t>(triangles[k]) + static_cast<std::size_t>(d)];
            lower[d] = minimum(lower[d], x);
            upper[d] = maximum(upper[d], x);
        }
    cell_ = cell;
    middle_ = 0.5 * lower + 0.5 * upper;
    half_widths_ = 0.5 * upper - 0.5 * lower;
}

int MeshWall::prepare(Cell const &cell) noexcept
{
    pw85_mesh *made = nullptr;
    if (int const status = mesh_create(vertices.size() / 3, vertices.data(), triangles.size() / 3,
                                       triangles.data(), made))
        return status;
    mesh_.reset(made);
    if (!exists()) return PW85_SUCCESS;
    enclose(cell);
    neighbors::Periodicity periodicity;
    if (!cell.find_lattice(periodicity)) return PW85_EINVAL;
    for (int k = 0; k < 3; ++k) {
        bool const is_periodic = periodicity.is_periodic(k);
        dual_[k] = is_periodic ? periodicity.dual_of_cell(k) : Vector3{};
        dual_bound_[k] = is_periodic ? periodicity.dual_of_cell_bound(k) : 0.0;
        if (!(2.0 * magnitude_of_dot(dual_[k], half_widths_) <= most_cells))
            return note_cause(PW85_EINVAL, "vertices", "must be within 16 periods of the cell");
    }
    return PW85_SUCCESS;
}

/// Returns the sum of the half-widths of the boxes of a particle and of the mesh.
Vector3 MeshWall::reach_of(Particle const &particle) const noexcept
{
    Vector3 reach = particle.half_widths + half_widths_;
    for (int d = 0; d < 3; ++d)
        reach[d] += margin * (reach[d] + absolute(particle.center[d]) + absolute(middle_[d]));
    return reach;
}

/// Finds the images of a particle that may meet the mesh. Returns false if there are more than
/// most_images, or if one is too far away.
///
/// The image n of a particle meets the mesh only if |r + Σ n_l a_l| <= h along each axis, with the
/// difference r of the middles and the sum h of the half-widths. So |D_l·r + n_l| <= Σ|D_ld| h_d
/// for the dual D_l of a periodic vector.
bool MeshWall::find_images(Particle const &particle, Vector3 const &reach,
                           ImageRange &images) const noexcept
{
    Vector3 const r = particle.center - middle_;
    double count = 1.0;
    for (int l = 0; l < 3; ++l) {
        double const along = dot(dual_[l], r),
                     size = sum_of_magnitudes(r) + sum_of_magnitudes(reach),
                     width = magnitude_of_dot(dual_[l], reach) + margin * dual_bound_[l] * size;
        count *= 2.0 * width + 1.0;
        if (!(absolute(along) + width < 0x1p29 && count <= most_images)) return false;
        images.first[l] = static_cast<std::int32_t>(elementary::ceil(-along - width));
        images.last[l] = static_cast<std::int32_t>(elementary::floor(width - along));
    }
    return true;
}

bool MeshWall::is_testable(Particle const &particle) const noexcept
{
    ImageRange images;
    return !exists() || find_images(particle, reach_of(particle), images);
}

/// Returns whether any image of a particle whose box meets that of the mesh passes a test of its
/// centre, or the particle is not testable.
template <class Test>
bool MeshWall::any_image(Particle const &particle, Test const &test) const noexcept
{
    Vector3 const reach = reach_of(particle);
    ImageRange images;
    if (!find_images(particle, reach, images)) return true;
    auto const &[first, last] = images;
    for (std::int32_t i = first[0]; i <= last[0]; ++i)
        for (std::int32_t j = first[1]; j <= last[1]; ++j)
            for (std::int32_t k = first[2]; k <= last[2]; ++k) {
                Vector3 const center = particle.center + cell_.translation({{i, j, k}});
                bool meets = true;
                for (int d = 0; d < 3; ++d)
                    meets = meets && absolute(center[d] - middle_[d]) <=
                                         reach[d] + margin * absolute(center[d]);
                if (meets && test(center)) return true;
            }
    return false;
}

bool MeshWall::cuts(Particle const &particle) const noexcept
{
    return exists() && any_image(particle, [&](Vector3 const &center) {
               int overlap;
               int const status =
                   mesh_overlap(*mesh_, center.coordinates, particle.q.entries, &overlap);
               return status != PW85_SUCCESS || overlap != 0;
           });
}

std::int32_t MeshWall::nearest(Particle const &particle) const noexcept
{
    double least = infinity<double>();
    std::int32_t nearest = -1;
    any_image(particle, [&](Vector3 const &center) {
        double mu2;
        std::int32_t triangle;
        int const status =
            mesh_contact(*mesh_, center.coordinates, particle.q.entries, &mu2, nullptr, &triangle);
        if (status == PW85_SUCCESS && mu2 < least) least = mu2, nearest = triangle;
        return false;
    });
    return nearest;
}

// The form is F Fᵀ with a factor whose singular values are the semi-axes up to a few u. An entry is
// a sum of three products, which errs by less than 3 u a² for the longest semi-axis a. The least
// eigenvalue is therefore smaller by less than 9 u a², of 16 u a² here. The centres, and the
// vertices relative to them, err by less than 8 u times the coordinates, which are below 2²⁸ b:
// less than 2⁻²² b, of 2⁻²⁰ b here.
double MeshWall::longest_step(Vector3 const &semi_axes) noexcept
{
    double const b = minimum(minimum(semi_axes[0], semi_axes[1]), semi_axes[2]),
                 ratio = largest_coordinate(semi_axes) / b,
                 square = 1.0 - 0x1p-49 * (ratio * ratio);
    return square > 0.0 ? (2.0 - 0x1p-20) * (b * elementary::sqrt(square)) : 0.0;
}

} // namespace pw85::detail::simulation

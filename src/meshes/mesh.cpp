// SPDX-License-Identifier: BSD-3-Clause
// The triangle meshes of the C API: how a mesh is made, and the functions of contact that search it
// (search.hpp).
#include <pw85.h>
#include <pw85_systems.h>

#include <new>

#include "../base/c_arrays.hpp"
#include "../base/last_error.hpp"
#include "../base/objects.hpp"
#include "../base/owner.hpp"
#include "../neighbors/order.hpp"
#include "contact_bounds.hpp"
#include "ellipsoids.hpp"
#include "winding.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::c_api;
using namespace pw85::detail::meshes;
using pw85::detail::neighbors::Box;

namespace {

Box box_of(Vector3 const &x) noexcept { return {{x[0], x[1], x[2]}, {x[0], x[1], x[2]}}; }

Box box_of(Triangle const &triangle) noexcept
{
    auto const &[a, b, c] = triangle.vertices;
    return enclose(enclose(box_of(a), box_of(b)), box_of(c));
}

Vector3 middle(Box const &box) noexcept
{
    Vector3 x;
    for (int d = 0; d < 3; ++d) x[d] = 0.5 * box.lower[d] + 0.5 * box.upper[d];
    return x;
}

/// Stores triangles in the order of the middles of their boxes on the curve, and builds the tree.
/// Returns false if there is no memory.
bool arrange(Array<Triangle> const &triangles, pw85_mesh &mesh) noexcept
{
    Array<neighbors::KeyedIndex> order;
    if (!order.resize(triangles.size()) || !mesh.triangles.resize(triangles.size())) return false;
    if (triangles.size() == 0) return true;
    Box around = neighbors::empty_box;
    for (std::size_t k = 0; k < triangles.size(); ++k)
        around = enclose(around, box_of(triangles[k]));
    for (std::size_t k = 0; k < triangles.size(); ++k)
        order[k] = {neighbors::key_of(middle(box_of(triangles[k])), around),
                    static_cast<std::int32_t>(k)};
    if (!neighbors::sort(order) || !mesh.tree.resize(triangles.size())) return false;
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        mesh.triangles[k] = triangles[static_cast<std::size_t>(order[k].index)];
        mesh.tree.set(k, box_of(mesh.triangles[k]));
    }
    mesh.tree.enclose_levels();
    return true;
}

/// The arrays of a mesh, as the caller gives them.
struct Given {
    std::size_t num_vertices;
    double const *vertices;
    std::size_t num_triangles;
    std::int32_t const *triangles;

    int check() const noexcept
    {
        if (num_vertices > INT32_MAX)
            return note_cause(PW85_EINVAL, "num_vertices", "must be below 2³¹");
        if (num_triangles > INT32_MAX)
            return note_cause(PW85_EINVAL, "num_triangles", "must be below 2³¹");
        for (std::size_t k = 0; k < 3 * num_vertices; ++k)
            if (!elementary::isfinite(vertices[k])) return PW85_EINVAL;
        for (std::size_t k = 0; k < 3 * num_triangles; ++k)
            if (triangles[k] < 0 || static_cast<std::size_t>(triangles[k]) >= num_vertices)
                return note_cause(PW85_EINVAL, "triangles", "must have indices of vertices", k / 3,
                                  k % 3, triangles[k]);
        return PW85_SUCCESS;
    }

    Triangle triangle(std::size_t k) const noexcept
    {
        auto const vertex = [&](std::size_t i) {
            return load_vector<3>(vertices + 3 * triangles[3 * k + i]);
        };
        return {{vertex(0), vertex(1), vertex(2)}, static_cast<std::int32_t>(k)};
    }
};

int create(Given const &given, pw85_mesh *&mesh) noexcept
{
    if (int const status = given.check()) return status;
    Owner<pw85_mesh> made(new (std::nothrow) pw85_mesh);
    Array<Triangle> triangles;
    if (made == nullptr || !triangles.resize(given.num_triangles)) return PW85_ENOMEM;
    for (std::size_t k = 0; k < triangles.size(); ++k) triangles[k] = given.triangle(k);
    made->is_closed = is_closed(triangles);
    if (!arrange(triangles, *made)) return PW85_ENOMEM;
    mesh = made.release();
    return PW85_SUCCESS;
}

/// The contact of a triangle, and its number.
struct NearestTriangle {
    ShapeContact<double> contact;
    std::int32_t index;
};

/// Returns the triangle with the least computed μ²; the first one of several.
NearestTriangle find_nearest(pw85_mesh const &mesh, Vector3 const &center, Form3 const &q) noexcept
{
    Status const status = validate(mesh, center, q);
    if (status != Status::success) return {all_nan<ShapeContact<double>>(status), -1};
    NearestTriangle best{all_nan<ShapeContact<double>>(status), -1};
    best.contact.mu2 = infinity<double>();
    Ellipsoid const ellipsoid(center, q);
    auto const visit = [&](Triangle const &triangle) {
        auto const &[a, b, c] = ellipsoid.relative(triangle).points;
        ShapeContact<double> contact{};
        contact.status = static_cast<Status>(
            pw85_contact_triangle(a.coordinates, b.coordinates, c.coordinates, q.entries,
                                  &contact.mu2, contact.point.coordinates));
        bool const is_first = best.index < 0 || triangle.index < best.index;
        if (contact.mu2 < best.contact.mu2 || (contact.mu2 == best.contact.mu2 && is_first))
            best = {contact, triangle.index};
        return best.contact.mu2;
    };
    ContactBounds const bounds(ellipsoid, margin_of_contact(ellipsoid.form()));
    search(mesh, bounds, infinity<double>(), visit);
    return best;
}

/// Returns whether any triangle overlaps. The bounds are proofs, and need no margin.
[[gnu::noinline]] ShapeOverlap find_overlap(pw85_mesh const &mesh, Vector3 const &center,
                                            Form3 const &q) noexcept
{
    Status const status = validate(mesh, center, q);
    if (status != Status::success) return {false, status};
    int overlap = 0;
    Ellipsoid const ellipsoid(center, q);
    auto const visit = [&](Triangle const &triangle) {
        auto const &[a, b, c] = ellipsoid.relative(triangle).points;
        pw85_overlap_triangle(a.coordinates, b.coordinates, c.coordinates, q.entries, &overlap);
        return overlap > 0 ? -1.0 : 1.0;
    };
    search(mesh, ContactBounds(ellipsoid, {0.0, {0.0, 0.0, 0.0}}), 1.0, visit);
    return {overlap > 0, status};
}

int store(NearestTriangle const &found, double *mu2, double *point, std::int32_t *triangle) noexcept
{
    if (mu2 != nullptr) *mu2 = found.contact.mu2;
    c_api::store(found.contact.point, point);
    if (triangle != nullptr) *triangle = found.index;
    return static_cast<int>(found.contact.status);
}

} // namespace

int pw85::detail::mesh_create(size_t num_vertices, double const *vertices, size_t num_triangles,
                              int32_t const *triangles, pw85_mesh *&mesh) noexcept
{
    return create({num_vertices, vertices, num_triangles, triangles}, mesh);
}

void pw85_mesh_destroy(pw85_mesh *mesh) { delete mesh; }

int pw85::detail::mesh_contact(pw85_mesh const &mesh, double const center[3], double const q[6],
                               double *mu2, double point[3], int32_t *triangle) noexcept
{
    return store(find_nearest(mesh, load_vector<3>(center), load_matrix<3>(q)), mu2, point,
                 triangle);
}

int pw85::detail::mesh_contact_batch(pw85_mesh const &mesh, size_t n, double const *centers,
                                     double const *q, double *mu2, double *point,
                                     int32_t *triangle) noexcept
{
    return each_ellipsoid(n, [&](std::size_t i) {
        return mesh_contact(mesh, centers + 3 * i, q + 6 * i, mu2 != nullptr ? mu2 + i : nullptr,
                            point != nullptr ? point + 3 * i : nullptr,
                            triangle != nullptr ? triangle + i : nullptr);
    });
}

int pw85::detail::mesh_overlap(pw85_mesh const &mesh, double const center[3], double const q[6],
                               int *overlap) noexcept
{
    auto const answer = find_overlap(mesh, load_vector<3>(center), load_matrix<3>(q));
    if (answer.status == Status::success) *overlap = answer.overlap;
    return static_cast<int>(answer.status);
}

int pw85::detail::mesh_overlap_batch(pw85_mesh const &mesh, size_t n, double const *centers,
                                     double const *q, unsigned char *overlap) noexcept
{
    return each_ellipsoid(n, [&](std::size_t i) {
        auto const answer =
            find_overlap(mesh, load_vector<3>(centers + 3 * i), load_matrix<3>(q + 6 * i));
        overlap[i] = answer.status != Status::success ? 255 : answer.overlap;
        return static_cast<int>(answer.status);
    });
}

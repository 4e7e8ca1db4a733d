// The C API of an ellipsoid and convex sets. The functions check for null pointers; the core checks everything else.
#include <pw85.h>

#include <pw85/shapes/overlap_polytope.hpp>

#include <cstdint>

#include "c_arrays.hpp"
#include "floating_point_environment.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::c_api;

namespace {

int store_contact(ShapeContact<double> const &c, double *mu2, double *point) noexcept
{
    if (mu2 != nullptr) *mu2 = c.mu2;
    store(c.point, point);
    return static_cast<int>(c.status);
}

/// The status for a null pointer; it marks the answer.
int null_overlap(int *overlap) noexcept
{
    if (overlap != nullptr) *overlap = -1;
    return null_pointer();
}

int store_overlap(ShapeOverlap const &answer, int *overlap) noexcept
{
    *overlap = answer.status == Status::success ? static_cast<int>(answer.overlap) : -1;
    return static_cast<int>(answer.status);
}

/// Whether the arrays of planes can be read.
bool are_planes(size_t n, double const *normals, double const *offsets) noexcept
{
    return n == 0 || (n <= PTRDIFF_MAX / (PW85_DIM * sizeof(double)) && !any_null(normals, offsets));
}

} // namespace

int pw85_contact_segment(double const end1[3], double const end2[3], double const q[6], double *mu2, double point[3])
{
    if (any_null(end1, end2, q)) return null_pointer(mu2, 1, point, PW85_DIM);
    return in_default_environment([&] {
        return store_contact(contact_segment(load_vector<3>(end1), load_vector<3>(end2), load_matrix<3>(q)), mu2,
                             point);
    });
}

int pw85_contact_triangle(double const vertex1[3], double const vertex2[3], double const vertex3[3], double const q[6],
                          double *mu2, double point[3])
{
    if (any_null(vertex1, vertex2, vertex3, q)) return null_pointer(mu2, 1, point, PW85_DIM);
    return in_default_environment([&] {
        return store_contact(contact_triangle(load_vector<3>(vertex1), load_vector<3>(vertex2), load_vector<3>(vertex3),
                                              load_matrix<3>(q)),
                             mu2, point);
    });
}

int pw85_contact_box(double const lower[3], double const upper[3], double const q[6], double *mu2, double point[3])
{
    if (any_null(lower, upper, q)) return null_pointer(mu2, 1, point, PW85_DIM);
    return in_default_environment([&] {
        return store_contact(contact_box(load_vector<3>(lower), load_vector<3>(upper), load_matrix<3>(q)), mu2, point);
    });
}

int pw85_overlap_segment(double const end1[3], double const end2[3], double const q[6], int *overlap)
{
    if (any_null(end1, end2, q, overlap)) return null_overlap(overlap);
    return in_default_environment([&] {
        return store_overlap(overlap_segment(load_vector<3>(end1), load_vector<3>(end2), load_matrix<3>(q)), overlap);
    });
}

int pw85_overlap_triangle(double const vertex1[3], double const vertex2[3], double const vertex3[3], double const q[6],
                          int *overlap)
{
    if (any_null(vertex1, vertex2, vertex3, q, overlap)) return null_overlap(overlap);
    return in_default_environment([&] {
        return store_overlap(overlap_triangle(load_vector<3>(vertex1), load_vector<3>(vertex2), load_vector<3>(vertex3),
                                              load_matrix<3>(q)),
                             overlap);
    });
}

int pw85_overlap_box(double const lower[3], double const upper[3], double const q[6], int *overlap)
{
    if (any_null(lower, upper, q, overlap)) return null_overlap(overlap);
    return in_default_environment([&] {
        return store_overlap(overlap_box(load_vector<3>(lower), load_vector<3>(upper), load_matrix<3>(q)), overlap);
    });
}

int pw85_contact_polytope(size_t n, double const *normals, double const *offsets, double const q[6], double *mu2,
                          double point[3])
{
    if (any_null(q) || !are_planes(n, normals, offsets)) return null_pointer(mu2, 1, point, PW85_DIM);
    return in_default_environment(
        [&] { return store_contact(contact_polytope(n, normals, offsets, load_matrix<3>(q), {}), mu2, point); });
}

int pw85_overlap_polytope(size_t n, double const *normals, double const *offsets, double const q[6], int *overlap)
{
    if (any_null(q, overlap) || !are_planes(n, normals, offsets)) return null_overlap(overlap);
    return in_default_environment(
        [&] { return store_overlap(overlap_polytope(n, normals, offsets, load_matrix<3>(q), {}), overlap); });
}

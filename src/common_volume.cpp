// The C API of volumes and areas, of ellipsoids and of common parts. The functions check for null pointers; the core checks
// everything else.
#include <pw85.h>

#include <pw85/volume/half_space.hpp>
#include <pw85/volume/overlap_volume_derivatives.hpp>

#include "c_arrays.hpp"
#include "floating_point_environment.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::c_api;

namespace {

int store_volume(Volume<double> const &v, double *volume) noexcept
{
    *volume = v.volume;
    return static_cast<int>(v.status);
}

int store_area(Area<double> const &a, double *area) noexcept
{
    *area = a.area;
    return static_cast<int>(a.status);
}

} // namespace

int pw85_volume(double const q[6], double *volume)
{
    if (any_null(q, volume)) return null_pointer(volume, 1);
    return in_default_environment([&] { return store_volume(pw85::volume(load_matrix<3>(q)), volume); });
}

int pw85_area_2d(double const q[3], double *area)
{
    if (any_null(q, area)) return null_pointer(area, 1);
    return in_default_environment([&] { return store_area(pw85::area(load_matrix<2>(q)), area); });
}

int pw85_overlap_volume(double const r12[3], double const q1[6], double const q2[6], double *volume)
{
    if (any_null(r12, q1, q2, volume)) return null_pointer(volume, 1);
    return in_default_environment([&] {
        return store_volume(overlap_volume(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2)), volume);
    });
}

int pw85_overlap_area_2d(double const r12[2], double const q1[3], double const q2[3], double *area)
{
    if (any_null(r12, q1, q2, area)) return null_pointer(area, 1);
    return in_default_environment(
        [&] { return store_area(overlap_area(load_vector<2>(r12), load_matrix<2>(q1), load_matrix<2>(q2)), area); });
}

int pw85_overlap_volume_gradient(double const r12[3], double const q1[6], double const q2[6], double d_r12[3],
                                 double d_q1[6], double d_q2[6])
{
    if (any_null(r12, q1, q2)) return null_pointer(d_r12, PW85_DIM, d_q1, PW85_SYM, d_q2, PW85_SYM);
    return in_default_environment([&] {
        auto const g = overlap_volume_gradient(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2));
        store(g.r12, d_r12);
        store(g.q1, d_q1);
        store(g.q2, d_q2);
        return static_cast<int>(g.status);
    });
}

int pw85_overlap_volume_torque(double const r12[3], double const q1[6], double const q2[6], double d_rot1[3],
                               double d_rot2[3])
{
    if (any_null(r12, q1, q2)) return null_pointer(d_rot1, PW85_DIM, d_rot2, PW85_DIM);
    return in_default_environment([&] {
        auto const t = overlap_volume_torque(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2));
        store(t.rotation1, d_rot1);
        store(t.rotation2, d_rot2);
        return static_cast<int>(t.status);
    });
}

int pw85_overlap_volume_plane(double const normal[3], double offset, double const q[6], double *volume)
{
    if (any_null(normal, q, volume)) return null_pointer(volume, 1);
    return in_default_environment(
        [&] { return store_volume(overlap_volume_plane(load_vector<3>(normal), offset, load_matrix<3>(q)), volume); });
}

// SPDX-License-Identifier: GPL-2.0-only
// compute pw85/order: it sums the dyads of the axes of all ellipsoids, and finds the eigenvalues of
// their mean.
#include "compute_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace LAMMPS_NS;

namespace pw85_lammps {

namespace {

/// Eigenvalues of a symmetric matrix, the largest first, with their unit vectors.
struct Eigensystem {
    std::array<double, 3> values;
    std::array<Vector, 3> vectors;
};

/// Turns two numbers or vectors, by an angle with a cosine and a sine.
template <class X> void turn(X &x, X &y, double c, double s)
{
    X const first = c * x + s * y;
    y = c * y - s * x;
    x = first;
}

/// Computes eigenvalues and eigenvectors by Jacobi's rotations, until all off-diagonal entries
/// vanish. Each sweep squares their relative size.
Eigensystem eigensystem(std::array<Vector, 3> a)
{
    std::array<Vector, 3> v{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
    for (int sweep = 0; sweep < 30; ++sweep)
        for (std::size_t p = 0; p < 2; ++p)
            for (std::size_t q = p + 1; q < 3; ++q) {
                if (a[p][q] == 0.0) continue;
                double const angle = 0.5 * std::atan2(2.0 * a[p][q], a[p][p] - a[q][q]);
                double const c = std::cos(angle), s = std::sin(angle);
                for (Vector &row : a) turn(row[p], row[q], c, s);
                turn(a[p], a[q], c, s);
                turn(v[p], v[q], c, s);
            }
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&a](std::size_t k, std::size_t l) { return a[k][k] > a[l][l]; });
    Eigensystem result;
    for (std::size_t k = 0; k < 3; ++k) {
        result.values[k] = a[order[k]][order[k]];
        result.vectors[k] = v[order[k]];
    }
    return result;
}

/// Returns the vector, or its negative if its largest component is negative.
Vector with_sign(Vector const &x)
{
    auto const largest = std::max_element(
        x.begin(), x.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    return *largest < 0.0 ? -1.0 * x : x;
}

} // namespace

ComputeOrder::ComputeOrder(LAMMPS *lammps, int narg, char **arg)
    : Compute(lammps, narg, arg),
      ellipsoids_(lammps, "Compute pw85/order", "leave it out of the group")
{
    if (narg != 3) stop_all(*error, "Illegal compute pw85/order command: it takes no arguments");
    scalar_flag = vector_flag = 1;
    extscalar = extvector = 0;
    size_vector = 6;
    vector = new double[6];
}

/// Returns the axis of an ellipsoid whose length differs most from the middle one; in two
/// dimensions the long axis in the plane. Returns nothing for spheres and discs.
std::optional<Vector> ComputeOrder::axis(int i) const
{
    double const *const q = ellipsoids_.quaternion(i);
    Vector const v = pw85_lammps::vector(q + 1);
    auto const turned = [&](std::size_t k) {
        Vector e{};
        e[k] = 1.0;
        return (q[0] * q[0] - dot(v, v)) * e + (2.0 * dot(v, e)) * v + (2.0 * q[0]) * cross(v, e);
    };
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](std::size_t k, std::size_t l) {
        return ellipsoids_.semi_axis(i, k) < ellipsoids_.semi_axis(i, l);
    });
    if (domain->dimension == 2) {
        auto const is_up = [&](std::size_t k) { return std::abs(turned(k)[2]) > 0.5; };
        std::size_t const longest = is_up(order[2]) ? order[1] : order[2],
                          other = is_up(order[0]) ? order[1] : order[0];
        if (ellipsoids_.semi_axis(i, longest) == ellipsoids_.semi_axis(i, other)) return {};
        return turned(longest);
    }
    double const below = ellipsoids_.semi_axis(i, order[1]) - ellipsoids_.semi_axis(i, order[0]);
    double const above = ellipsoids_.semi_axis(i, order[2]) - ellipsoids_.semi_axis(i, order[1]);
    if (below == 0.0 && above == 0.0) return {};
    return turned(above >= below ? order[2] : order[0]);
}

double ComputeOrder::compute_scalar()
{
    compute_vector();
    invoked_scalar = update->ntimestep;
    scalar = vector[3];
    return scalar;
}

void ComputeOrder::compute_vector()
{
    invoked_vector = update->ntimestep;
    ellipsoids_.read([this](int i) { return (atom->mask[i] & groupbit) != 0; });
    std::array<double, 7> sum{}; // xx, xy, xz, yy, yz, zz, and the number of axes
    for (int i = 0; i < atom->nlocal; ++i) {
        auto const u = ellipsoids_.selected(i) ? axis(i) : std::nullopt;
        if (!u) continue;
        std::size_t entry = 0;
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t l = k; l < 3; ++l) sum[entry++] += (*u)[k] * (*u)[l];
        sum[6] += 1.0;
    }
    MPI_Allreduce(MPI_IN_PLACE, sum.data(), static_cast<int>(sum.size()), MPI_DOUBLE, MPI_SUM,
                  world);
    if (sum[6] == 0.0) {
        std::fill_n(vector, 6, std::numeric_limits<double>::quiet_NaN());
        return;
    }
    for (std::size_t k = 0; k < 6; ++k) sum[k] /= sum[6];
    bool const is_flat = domain->dimension == 2;
    Eigensystem const mean = eigensystem(
        {{{sum[0], sum[1], sum[2]}, {sum[1], sum[3], sum[4]}, {sum[2], sum[4], sum[5]}}});
    Vector const director = with_sign(mean.vectors[0]);
    std::copy(director.begin(), director.end(), vector);
    for (std::size_t k = 0; k < 3; ++k)
        vector[3 + k] = is_flat ? 2.0 * mean.values[k] - 1.0 : 1.5 * mean.values[k] - 0.5;
}

} // namespace pw85_lammps

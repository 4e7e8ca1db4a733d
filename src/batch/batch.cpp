// The batch functions of the C API.
#include <pw85.h>

#include <cmath>

#include <pw85/pw85.hpp>

#include "../c_arrays.hpp"

using namespace pw85;
using namespace pw85::c_api;

namespace {

constexpr size_t max_rows = SIZE_MAX / 2 / (PW85_SYM * sizeof(double));

int contact_row(double const *r12, double const *q1, double const *q2, double *mu2, double *lambda)
{
    auto const c = contact(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2));
    *mu2 = c.mu2;
    if (lambda) *lambda = c.lambda;
    return static_cast<int>(c.status);
}

int overlap_row(double const *r12, double const *q1, double const *q2, unsigned char *overlap)
{
    auto const c = contact(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2));
    *overlap = c.status != Status::success ? 255 : c.mu2 < 1.0;
    return static_cast<int>(c.status);
}

bool pairs_ok(size_t m, int32_t const *pairs, size_t n, double const *centers, double const *q)
{
    if (m > max_rows || n > max_rows || any_null(pairs, centers, q)) return false;
    for (size_t k = 0; k < 2 * m; ++k)
        if (pairs[k] < 0 || static_cast<size_t>(pairs[k]) >= n) return false;
    return true;
}

void separation(double const *ci, double const *cj, double const *cell, double r[3])
{
    for (int d = 0; d < 3; ++d) r[d] = cj[d] - ci[d];
    if (!cell) return;
    double best[3] = {r[0], r[1], r[2]}, best2 = INFINITY;
    for (int a = -2; a <= 2; ++a)
        for (int b = -2; b <= 2; ++b)
            for (int c = -2; c <= 2; ++c) {
                double v[3], s = 0;
                for (int d = 0; d < 3; ++d) {
                    v[d] = r[d] + a * cell[d] + b * cell[3 + d] + c * cell[6 + d];
                    s += v[d] * v[d];
                }
                if (s < best2) {
                    best2 = s;
                    for (int d = 0; d < 3; ++d) best[d] = v[d];
                }
            }
    for (int d = 0; d < 3; ++d) r[d] = best[d];
}

} // namespace

int pw85_contact_batch(size_t n, double const *r12, double const *q1, double const *q2, double *mu2, double *lambda)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(r12, q1, q2, mu2)) return PW85_EINVAL;
    int first = PW85_SUCCESS;
    for (size_t i = 0; i < n; ++i) {
        int const s = contact_row(r12 + 3 * i, q1 + 6 * i, q2 + 6 * i, mu2 + i, lambda ? lambda + i : nullptr);
        if (!first) first = s;
    }
    return first;
}

int pw85_overlap_batch(size_t n, double const *r12, double const *q1, double const *q2, unsigned char *overlap)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(r12, q1, q2, overlap)) return PW85_EINVAL;
    int first = PW85_SUCCESS;
    for (size_t i = 0; i < n; ++i) {
        int const s = overlap_row(r12 + 3 * i, q1 + 6 * i, q2 + 6 * i, overlap + i);
        if (!first) first = s;
    }
    return first;
}

int pw85_contact_pairs(size_t num_pairs, int32_t const *pairs, size_t num_particles, double const *centers,
                       double const *q, double const *cell, double *mu2, double *lambda)
{
    if (num_pairs == 0) return PW85_SUCCESS;
    if (any_null(mu2) || !pairs_ok(num_pairs, pairs, num_particles, centers, q)) return PW85_EINVAL;
    int first = PW85_SUCCESS;
    for (size_t k = 0; k < num_pairs; ++k) {
        int const i = pairs[2 * k], j = pairs[2 * k + 1];
        double r[3];
        separation(centers + 3 * i, centers + 3 * j, cell, r);
        int const s = contact_row(r, q + 6 * i, q + 6 * j, mu2 + k, lambda ? lambda + k : nullptr);
        if (!first) first = s;
    }
    return first;
}

int pw85_overlap_pairs(size_t num_pairs, int32_t const *pairs, size_t num_particles, double const *centers,
                       double const *q, double const *cell, unsigned char *overlap)
{
    if (num_pairs == 0) return PW85_SUCCESS;
    if (any_null(overlap) || !pairs_ok(num_pairs, pairs, num_particles, centers, q)) return PW85_EINVAL;
    int first = PW85_SUCCESS;
    for (size_t k = 0; k < num_pairs; ++k) {
        int const i = pairs[2 * k], j = pairs[2 * k + 1];
        double r[3];
        separation(centers + 3 * i, centers + 3 * j, cell, r);
        int const s = overlap_row(r, q + 6 * i, q + 6 * j, overlap + k);
        if (!first) first = s;
    }
    return first;
}

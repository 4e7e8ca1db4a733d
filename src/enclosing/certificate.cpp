// SPDX-License-Identifier: BSD-3-Clause
// Proofs that points are inside, and that the volume is close to the least.
#define PW85_SHORT_OPERATIONS // before doubled.hpp: calls take no longer here
#include "certificate.hpp"

namespace pw85::detail::enclosing {

namespace {

constexpr double u = 0x1p-53;
/// Bound on the error of a sum of products of Doubled numbers: twice 80 u².
constexpr double sum_error = 160.0 * u * u;

double magnitude(Wide const &x) noexcept { return elementary::abs(x.high); }

/// Returns entry (i, j) of a symmetric matrix that is stored as a lower triangle.
double entry(double const *a, int i, int j) noexcept { return a[i >= j ? at(i, j) : at(j, i)]; }

} // namespace

bool Certificate::prepare(Cloud const &cloud, double const *center, double const *form) noexcept
{
    int const n = cloud.n;
    cloud_ = &cloud;
    frame_.n = n;
    for (int k = 0; k < n; ++k) frame_.center[k] = Wide(center[k]);
    // NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage): form has all entries
    for (int k = 0; k < at(n, 0); ++k) frame_.a[k] = Wide(form[k]);
    if (!invert_factor(n, frame_.a, 0x1p-50)) return false;
    eta_ = sensitivity_ = 0.0;
    for (int i = 0; i < n; ++i) {
        Wide row[max_dimension];
        double sizes[max_dimension], deviation = 0.0, size_of_row = 0.0;
        for (int j = 0; j < n; ++j) {
            row[j] = Wide(0.0);
            sizes[j] = 0.0;
            for (int k = 0; k <= i; ++k) {
                row[j] = row[j] + frame_.a[at(i, k)] * Wide(entry(form, k, j));
                sizes[j] += magnitude(frame_.a[at(i, k)]) * elementary::abs(entry(form, k, j));
            }
        }
        for (int j = 0; j < n; ++j) {
            Wide p(i == j ? -1.0 : 0.0);
            double size = 1.0;
            for (int k = 0; k <= j; ++k) {
                p = p + row[k] * frame_.a[at(j, k)];
                size += sizes[k] * magnitude(frame_.a[at(j, k)]);
            }
            deviation += magnitude(p) + 2.0 * sum_error * size;
            size_of_row += size;
        }
        eta_ = deviation > eta_ ? deviation : eta_;
        sensitivity_ = size_of_row * u > sensitivity_ ? size_of_row * u : sensitivity_;
    }
    return eta_ < 0x1p-10;
}

double Certificate::error_of(int row, Wide const *z) const noexcept
{
    double size = 0.0;
    for (int j = 0; j <= row; ++j) size += magnitude(frame_.a[at(row, j)]) * magnitude(z[j]);
    return sum_error * size;
}

double Certificate::protrusion(std::size_t point) const noexcept
{
    Wide z[max_dimension], w[max_dimension], excess(-1.0);
    offset_of(*cloud_, frame_.center, point, z);
    multiply(frame_, z, w);
    double error = eta_, size = 1.0;
    for (int i = 0; i < frame_.n; ++i) {
        double const e = error_of(i, z);
        excess = excess + w[i] * w[i];
        size += w[i].high * w[i].high;
        error += e * (2.0 * magnitude(w[i]) + e);
    }
    error = (error + sum_error * size) * (1.0 + 128.0 * u);
    double const bound = excess.high + error;
    // The sum is rounded by at most u of each of the two terms.
    return bound + 2.0 * u * (magnitude(excess) + error);
}

double Certificate::largest_protrusion(std::size_t count, std::size_t const *points) const noexcept
{
    double largest = -1.0;
    for (std::size_t i = 0; i < count; ++i) {
        double const p = protrusion(points[i]);
        largest = p > largest ? p : largest;
    }
    return largest;
}

/// In double precision w errs by at most (n + 4) u <= 20u of Σ|A_ij||z_j|, and |z_j| < 4: the
/// extents are below 2, the exact centre is between the points, and rounding moves it by no more
/// than an extent. With S = |4 Σ_j |A_ij|| (the norm of a vector), w errs by at most 20u S. |A z|²
/// errs in addition by less than 20u of itself. That is at most 20u S, because |A z| <= S, and |A
/// z| <= 1 if the result matters. Together these are at most 60uS + 400u²S² < 66uS for uS < 1/68,
/// and the limit below is negative for larger S. The remaining 2uS are more than the roundings of
/// the limit if S >= 1/2. If S < 1/2, every point is inside. The second η is more than the
/// roundings of η.
double Certificate::largest_protrusion() const noexcept
{
    double a[max_packed] = {}, center[max_dimension] = {}, sum = 0.0, largest = -1.0;
    for (int i = 0; i < frame_.n; ++i) {
        double size = 0.0;
        for (int j = 0; j <= i; ++j) {
            a[at(i, j)] = frame_.a[at(i, j)].high;
            size += 4.0 * elementary::abs(a[at(i, j)]);
        }
        sum += size * size;
        center[i] = frame_.center[i].high;
    }
    double const limit = 1.0 - 2.0 * eta_ - 68.0 * u * elementary::sqrt(sum);
    for (std::size_t i = 0; i < cloud_->m; ++i) {
        if (squared_norm(*cloud_, a, center, i) <= limit) continue;
        double const p = protrusion(i);
        largest = p > largest ? p : largest;
    }
    return largest;
}

/// Adds a point to Σ u w and Σ u w wᵀ, w = A (x - c). Returns a bound on the error of w.
double Certificate::add_moments(std::size_t point, double weight, Wide *first,
                                Wide *second) const noexcept
{
    Wide z[max_dimension], w[max_dimension];
    offset_of(*cloud_, frame_.center, point, z);
    multiply(frame_, z, w);
    double error = 0.0;
    for (int i = 0; i < frame_.n; ++i) {
        double const e = error_of(i, z);
        error = e > error ? e : error;
        Wide const weighted = Wide(weight) * w[i];
        first[i] = first[i] + weighted;
        for (int j = 0; j <= i; ++j) second[at(i, j)] = second[at(i, j)] + weighted * w[j];
    }
    return error;
}

/// The sums have `count` terms with |w_i| < 1.1, so each entry of T errs by at most 3 (4 (count +
/// 40)) u² of n · 1.1² < 15n (count + 40) u² from the sums and quotients, and by 2.2 · 2 n times
/// the error of w. The bound has 17n (count + 40) u² more, for the roundings of ratio_excess().
double Certificate::excess(std::size_t count, std::size_t const *points,
                           double const *weights) const noexcept
{
    int const n = frame_.n;
    Wide total(0.0), first[max_dimension], second[max_packed];
    for (Wide &x : first) x = Wide(0.0);
    for (Wide &x : second) x = Wide(0.0);
    double error = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        total = total + Wide(weights[i]);
        double const e = add_moments(points[i], weights[i], first, second);
        error = e > error ? e : error;
    }
    for (int i = 0; i < n; ++i) first[i] = first[i] / total;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j)
            second[at(i, j)] = Wide(n) * (second[at(i, j)] / total - first[i] * first[j]);
    return ratio_excess(second,
                        n * (32.0 * (static_cast<double>(count) + 40.0) * u * u + 5.0 * error));
}

/// Let ε = error/t. Each entry of T/t errs by at most ε, and t by ε of itself. F counts 2ε for each
/// entry. If n = 1, the exact F is 0. Otherwise 1/2 > F >= 2nε, so ε < 1/8, and the exact F is at
/// most 8/7 F < 0.58. The exponent F²/(2 (1 - F)) + nη of the exact F is then below 0.4 and at most
/// 1.6 F² + nη, and exp(x) <= 1 + 1.24 x there.
///
/// The roundings of Wide numbers here are below (4n² + 44n + 20) u² of the result. The bound has
/// room for n times 17n (count + 40) u²/t >= 550n u², because t < 1.21 n: see excess().
double Certificate::ratio_excess(Wide const *t, double error) const noexcept
{
    int const n = frame_.n;
    Wide trace(0.0);
    for (int i = 0; i < n; ++i) trace = trace + t[at(i, i)];
    Wide const mean = trace / Wide(n);
    if (!(mean.high > 2.0 * n * error)) return infinity<double>();
    double square = 0.0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j) {
            double const d = magnitude(i == j ? t[at(i, i)] - mean : t[at(i, j)]) + 2.0 * error;
            square += (i == j ? 1.0 : 2.0) * (d / mean.high) * (d / mean.high);
        }
    double const f = elementary::sqrt(square);
    if (!(f < 0.5)) return infinity<double>();
    // det Q/(nⁿ det S) <= (1/t)ⁿ (1 + 2 (F² + n η))
    Wide const factor = Wide(1.0) / (mean - Wide(n * error));
    Wide ratio = Wide(1.0) + Wide(2.0 * (f * f + n * eta_));
    for (int i = 0; i < n; ++i) ratio = ratio * factor;
    double const excess = ((ratio - Wide(1.0)) / (sqrt(ratio) + Wide(1.0))).high * (1.0 + 4.0 * u);
    return excess > 0.0 ? excess : 0.0;
}

} // namespace pw85::detail::enclosing

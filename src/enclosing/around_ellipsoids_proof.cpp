// SPDX-License-Identifier: BSD-3-Clause
// The proof of the smallest ellipsoid around ellipsoids: steps 4 and 5 of around_ellipsoids.hpp.
#define PW85_SHORT_OPERATIONS // before doubled.hpp: calls take no longer here
#include "around_ellipsoids.hpp"

#include "../any_dimension/shared.hpp"

namespace pw85::detail::enclosing {

namespace {

using any_dimension::packed_index;

/// Maximum number of enlargements of the ellipsoid, each by twice as much as the one before.
constexpr int max_enlargements = 48;

/// Returns whether z is proved to be in the ellipsoid of the form q around 0: q - z zᵀ is positive
/// definite. The errors are those of shows_inside() in any_dimension/containment.hpp.
template <class T> bool is_point_inside(int n, double const *q, T const *z) noexcept
{
    T matrix[max_packed] = {};
    T const share = T(4 * any_dimension::factorization_error(n) + 64 * n) * T(unit_roundoff<T>());
    for (int i = 0; i < n; ++i)
        for (int j = i; j < n; ++j) {
            int const k = packed_index(n, i, j);
            T const entry = T(q[k]);
            matrix[k] = (i == j ? entry - share * entry : entry) - z[i] * z[j];
        }
    return any_dimension::factorize(n, matrix);
}

/// Finds vectors f_k with Σ f_k f_kᵀ = W and f_kᵀ J f_k = 0, where tr J W = 0. It rotates pairs of
/// columns of a Cholesky factor, and each rotation makes one form f_kᵀ J f_k zero (J. F. Sturm and
/// S. Zhang, Math. Oper. Res. 28, 246 (2003)). The factor replaces W. The rows of the result are
/// the vectors.
void split(std::size_t d, Square<double> &factor, Square<double> &vectors) noexcept
{
    double forms[max_lifted];
    factorize(d, factor.x, 0x1p-60);
    auto const form = [&](double const *f, double const *g) {
        return dot(d - 1, f, g) - f[d - 1] * g[d - 1];
    };
    for (std::size_t k = 0; k < d; ++k) {
        double *const f = vectors.x + k * d;
        for (std::size_t i = 0; i < d; ++i) f[i] = i < k ? 0.0 : factor.x[i * d + k];
        forms[k] = form(f, f);
    }
    for (std::size_t turn = 0; turn + 1 < d; ++turn) {
        std::size_t high = 0, low = 0;
        for (std::size_t k = 1; k < d; ++k) {
            if (forms[k] > forms[high]) high = k;
            if (forms[k] < forms[low]) low = k;
        }
        if (!(forms[high] > 0.0 && forms[low] < 0.0)) break;
        double *const f = vectors.x + high * d, *const g = vectors.x + low * d;
        double const mixed = form(f, g),
                     root = elementary::sqrt(mixed * mixed - forms[high] * forms[low]),
                     t = -forms[high] / (mixed < 0.0 ? mixed - root : mixed + root),
                     norm = elementary::sqrt(1.0 + t * t);
        for (std::size_t i = 0; i < d; ++i) {
            double const x = f[i], y = g[i];
            f[i] = (x + t * y) / norm;
            g[i] = (y - t * x) / norm;
        }
        forms[low] += forms[high];
        forms[high] = 0.0;
    }
}

} // namespace

/// Appends a point of an ellipsoid, moved towards the centre until it is proved to be inside. It
/// moves by rounding errors, or to the centre if these are larger than the ellipsoid.
bool AroundEllipsoids::add_point(Body const &one, double const *from_center, double weight) noexcept
{
    int const n = bodies_.n;
    std::size_t const size = points_.size(), count = weights_.size();
    if (!points_.resize(size + extent(n)) || !weights_.resize(count + 1) ||
        !indices_.resize(count + 1))
        return false;
    weights_[count] = weight;
    indices_[count] = count;
    double *const point = &points_[size];
    Wide z[max_dimension];
    for (int power = -52; power <= 0; ++power) {
        double const left = 1.0 - times_power_of_two(1.0, power);
        for (int k = 0; k < n; ++k) {
            point[k] = one.center[k] + left * from_center[k];
            z[k] = Wide(point[k]) - Wide(one.center[k]);
        }
        if (is_point_inside(n, one.form, z)) return true;
    }
    return true; // the centre
}

/// Appends the points where an active ellipsoid touches the outer one.
bool AroundEllipsoids::add_contacts(std::size_t k) noexcept
{
    int const n = bodies_.n;
    std::size_t const d = extent(n) + 1;
    Body const one = body(active_[k]);
    Wide *const b = factor_.x;
    factor_of(n, one.form, b);
    moments_factor_ = moments_[k];
    split(d, moments_factor_, vectors_);
    for (std::size_t row = 0; row < d; ++row) {
        double const *const f = vectors_.x + row * d;
        double const norm = elementary::sqrt(dot(d - 1, f, f)), weight = f[d - 1] * f[d - 1],
                     length = f[d - 1] < 0.0 ? -norm : norm;
        if (!(norm > 0.0 && weight > 0x1p-200)) continue;
        double from_center[max_dimension] = {};
        for (int i = 0; i < n; ++i) {
            Wide sum(0.0);
            for (int j = 0; j <= i; ++j) sum = sum + b[i * n + j] * Wide(f[j] / length);
            from_center[i] = sum.high;
        }
        if (!add_point(one, from_center, weight)) return false;
    }
    return true;
}

/// Returns whether an ellipsoid is proved to be inside: in double precision, where r12 may be
/// rounded by u, or with twice its digits and the exact r12. For active ellipsoids ν comes from
/// their multiplier, which is correct also if they touch at several points.
bool AroundEllipsoids::is_inside(std::size_t i) noexcept
{
    using namespace any_dimension;
    int const n = bodies_.n;
    Body const one = body(i);
    double r[max_dimension] = {};
    for (int k = 0; k < n; ++k) r[k] = one.center[k] - outer_.center[k];
    Input const in{n, r, outer_.form, one.form};
    auto &work = memory_.work;
    scale(in, {}, work.pair);
    double const nu = nu_[i];
    if (shows_inside(work.pair, nu, work.at.factors)) return true;
    double const kappa2 = reach(i, false), other = nu_[i] + 0.5 * maximum(0.0, 1.0 - kappa2);
    nu_[i] = nu;
    Wide exact[max_dimension];
    for (int k = 0; k < n; ++k) exact[k] = Wide(one.center[k]) - Wide(outer_.center[k]);
    return shows_inside_wider(in, exact, nu, other);
}

bool AroundEllipsoids::are_inside() noexcept
{
    for (std::size_t i = 0; i < bodies_.m; ++i)
        if (!is_inside(i)) return false;
    return true;
}

/// Enlarges the ellipsoid until all ellipsoids are proved to be inside.
Status AroundEllipsoids::certify(double gap, double tolerance) noexcept
{
    int const n = bodies_.n;
    for (std::size_t k = 0; k < active_.size(); ++k) {
        nu_[active_[k]] = multipliers_[k];
        if (!add_contacts(k)) return Status::out_of_memory;
    }
    cloud_.m = weights_.size();
    cloud_.points = points_.data();
    Certificate certificate;
    double factor = 1.0 + gap, slack = 0.0, form[max_packed];
    for (int trial = 0; trial < max_enlargements; ++trial) {
        round_outer(factor);
        for (int i = 0; i < n; ++i)
            for (int j = 0; j <= i; ++j) form[at(i, j)] = outer_.form[packed_index(n, j, i)];
        if (!certificate.prepare(cloud_, outer_.center, form)) return Status::not_positive_definite;
        if (trial > 0 && are_inside()) {
            excess_ = certificate.excess(cloud_.m, indices_.data(), weights_.data());
            return excess_ <= tolerance ? Status::success : Status::no_convergence;
        }
        slack = trial > 0 ? 2.0 * slack : maximum(0x1p-47, 0x1p-6 * certificate.sensitivity());
        factor *= 1.0 + slack;
    }
    return Status::not_positive_definite;
}

} // namespace pw85::detail::enclosing

// SPDX-License-Identifier: BSD-3-Clause
// The search for the smallest ellipsoid around ellipsoids: pw85_enclosing_ellipsoid_of().
#include "around_ellipsoids.hpp"

#include <new>

namespace pw85::detail::enclosing {

namespace {

using any_dimension::packed_index, any_dimension::packed_size;

/// More rounds than this are not taken. They are needed for few ellipsoids in many dimensions.
constexpr int max_rounds = 60;
/// Upper bound of rounds that together do not halve the gap.
constexpr int max_idle_rounds = 20;
/// Upper bound of ellipsoids whose conjugate axes give first points.
constexpr std::size_t max_first = 4;
/// A point or an ellipsoid counts in a round if it protrudes by this share of the largest
/// protrusion.
constexpr double least_share = 0.03;

std::size_t extent(int n) noexcept { return static_cast<std::size_t>(n); }

/// Proves that z is in the ellipsoid of the form q around 0: q - z zᵀ is positive definite. The
/// errors are those of shows_inside() in any_dimension/containment.hpp.
template <class T> bool is_point_inside(int n, double const *q, T const *z, int unit) noexcept
{
    T matrix[max_packed];
    T const share = T(4 * any_dimension::factorization_error(n) + 64 * n) * T(unit_roundoff<T>());
    for (int i = 0; i < n; ++i)
        for (int j = i; j < n; ++j) {
            int const k = packed_index(n, i, j);
            T const entry = T(times_power_of_two(q[k], -2 * unit));
            matrix[k] = (i == j ? entry - share * entry : entry) - z[i] * z[j];
        }
    return any_dimension::factorize(n, matrix);
}

/// x - y exactly, in units of 2^unit.
void difference(int n, double const *x, double const *y, int unit, Wide *z) noexcept
{
    for (int k = 0; k < n; ++k)
        z[k] = Wide(times_power_of_two(x[k], -unit)) - Wide(times_power_of_two(y[k], -unit));
}

void invert(int n, double const *form, double *inverse) noexcept
{
    double factors[max_packed] = {}, column[max_dimension] = {};
    for (int k = 0; k < packed_size(n); ++k) factors[k] = form[k];
    any_dimension::factorize(n, factors);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) column[j] = i == j ? 1.0 : 0.0;
        any_dimension::solve(n, factors, column, column);
        for (int j = i; j < n; ++j) inverse[packed_index(n, i, j)] = column[j];
    }
}

} // namespace

Status AroundEllipsoids::status_of_input() const noexcept
{
    Status first = Status::success;
    for (std::size_t i = 0; i < bodies_.m; ++i) {
        auto const numbers = any_dimension::status_of_numbers(bodies_.n, bodies_.center(i));
        if (numbers != Status::success) return numbers;
        auto const form = any_dimension::status_of_form(bodies_.n, bodies_.form(i));
        if (form == Status::invalid_argument) return form;
        if (first == Status::success) first = form;
    }
    return first;
}

/// Appends a point of an ellipsoid, moved towards the centre until it is proved to be inside: by
/// rounding errors, or to the centre if these are larger than the ellipsoid.
bool AroundEllipsoids::add_point(std::size_t owner, double const *from_center) noexcept
{
    int const n = bodies_.n;
    std::size_t const size = points_.size();
    if (!points_.resize(size + extent(n)) || !owners_.resize(owners_.size() + 1)) return false;
    owners_[owners_.size() - 1] = owner;
    double *const point = &points_[size];
    double const *const center = bodies_.center(owner), *const q = bodies_.form(owner);
    int const unit = half_exponent(any_dimension::largest_diagonal(n, q));
    Wide z[max_dimension];
    for (int power = -52; power <= 0; ++power) {
        double const left = 1.0 - times_power_of_two(1.0, power);
        for (int k = 0; k < n; ++k) point[k] = center[k] + left * from_center[k];
        difference(n, point, center, unit, z);
        if (is_point_inside(n, q, z, unit)) return true;
    }
    return true; // the centre
}

/// Appends the point of an ellipsoid that is farthest along a normal.
bool AroundEllipsoids::add_support(std::size_t owner, double const *normal) noexcept
{
    int const n = bodies_.n;
    double point[max_dimension] = {};
    any_dimension::product(n, bodies_.form(owner), normal, point);
    double const width = elementary::sqrt(any_dimension::dot(n, normal, point));
    for (int k = 0; k < n; ++k) point[k] /= width;
    return add_point(owner, point);
}

bool AroundEllipsoids::add_first_points() noexcept
{
    int const n = bodies_.n;
    double z[max_dimension] = {};
    for (std::size_t i = 0; i < bodies_.m && i < max_first; ++i) {
        double factors[max_packed] = {}; // the rows of √D Lᵀ are conjugate semi-axes
        for (int k = 0; k < packed_size(n); ++k) factors[k] = bodies_.form(i)[k];
        any_dimension::factorize(n, factors);
        for (int k = 0; k < 2 * n; ++k) {
            int const row = k / 2;
            double const pivot = elementary::sqrt(factors[packed_index(n, row, row)]);
            for (int j = 0; j < n; ++j)
                z[j] = (k % 2 ? -pivot : pivot) * (j < row    ? 0.0
                                                   : j == row ? 1.0
                                                              : factors[packed_index(n, row, j)]);
            if (!add_point(i, z)) return false;
        }
    }
    // A single ellipsoid is the smallest one around its conjugate axes.
    for (int k = 0; bodies_.m > 1 && k < 2 * n; ++k) {
        double const sign = k % 2 ? -1.0 : 1.0;
        int const axis = k / 2;
        auto const height = [&](std::size_t i) {
            double const width = elementary::sqrt(bodies_.form(i)[packed_index(n, axis, axis)]);
            return sign * bodies_.center(i)[axis] + width;
        };
        std::size_t highest = 0;
        for (std::size_t i = 1; i < bodies_.m; ++i)
            if (height(i) > height(highest)) highest = i;
        for (int j = 0; j < n; ++j) z[j] = j == axis ? sign : 0.0;
        if (!add_support(highest, z)) return false;
    }
    return true;
}

/// Finds the smallest ellipsoid around the points.
Status AroundEllipsoids::enclose_points(double tolerance) noexcept
{
    int const n = bodies_.n;
    search_.reset(new (std::nothrow) Search(n, owners_.size(), points_.data()));
    if (search_ == nullptr) return Status::out_of_memory;
    Status const status = search_->run(tolerance);
    if (status != Status::success && status != Status::no_convergence) return status;
    outer_.n = n;
    for (int i = 0; i < n; ++i) {
        outer_.center[i] = search_->center(i);
        for (int j = i; j < n; ++j) outer_.form[packed_index(n, i, j)] = search_->form(i, j);
    }
    invert(n, outer_.form, outer_.inverse);
    return Status::success;
}

/// κ² of one ellipsoid in the outer one, its point relative to the outer centre, and the ν of its
/// upper bound. Most ellipsoids are far inside: by the triangle inequality κ <= |r| + √tr(Q⁻¹Q_i)
/// in the norm of the outer one.
double AroundEllipsoids::reach(std::size_t i, double *point, double &nu) noexcept
{
    using namespace any_dimension;
    int const n = bodies_.n;
    double r[max_dimension] = {}, s[max_dimension] = {}, trace = 0.0;
    double const *const q = bodies_.form(i);
    for (int k = 0; k < n; ++k) r[k] = bodies_.center(i)[k] - outer_.center[k];
    product(n, outer_.inverse, r, s);
    for (int k = 0; k < n; ++k)
        for (int l = k; l < n; ++l) {
            int const at = packed_index(n, k, l);
            trace += (k == l ? 1.0 : 2.0) * outer_.inverse[at] * q[at];
        }
    double const far = elementary::sqrt(maximum(0.0, dot(n, r, s))),
                 wide = elementary::sqrt(maximum(0.0, trace)), kappa = far + wide;
    nu = wide / kappa;
    if (point == nullptr && kappa < 1.0 - 0x1p-20) return kappa * kappa;
    int const unit = half_exponent(largest_diagonal(n, outer_.form));
    auto &work = memory_.work;
    auto &search = memory_.search;
    scale({n, r, outer_.form, q}, {unit, unit, unit, false}, work.pair);
    minimize_dual(work.pair, search, work.at, [&](auto const &state) {
        return has_converged(work.pair, state, 4.0 * unit_roundoff<double>());
    });
    auto const &best = search.best;
    if (!(best.mu2 > 0.0)) return far * far; // a point
    nu = search.nu;
    for (int k = 0; point != nullptr && k < n; ++k)
        point[k] = times_power_of_two(best.q2s[k] / best.root2, unit);
    return best.mu2;
}

/// Computes κ² of all ellipsoids. Returns max κ² - 1, at least 0.
double AroundEllipsoids::measure() noexcept
{
    double largest = 1.0;
    for (std::size_t i = 0; i < bodies_.m; ++i) {
        kappa2_[i] = reach(i, nullptr, nu_[i]);
        largest = maximum(largest, kappa2_[i]);
    }
    return largest - 1.0;
}

/// Appends the farthest points of the ellipsoids that protrude most.
bool AroundEllipsoids::add_protruding(double gap) noexcept
{
    int const limit = 4 * (bodies_.n + 1);
    double point[max_dimension] = {};
    for (int count = 0; count < limit; ++count) {
        std::size_t worst = 0;
        for (std::size_t i = 1; i < bodies_.m; ++i)
            if (kappa2_[i] > kappa2_[worst]) worst = i;
        if (kappa2_[worst] <= 1.0 + least_share * gap) break;
        reach(worst, point, nu_[worst]);
        if (!add_point(worst, point) || !drop_last_inside(gap)) return false;
        kappa2_[worst] = 0.0;
    }
    return true;
}

/// Removes the last point unless it protrudes by a share of the gap: where the gap is that of
/// rounded points, a new one is no farther out than those before.
bool AroundEllipsoids::drop_last_inside(double gap) noexcept
{
    int const n = bodies_.n;
    std::size_t const last = owners_.size() - 1;
    double z[max_dimension] = {}, normal[max_dimension] = {};
    for (int k = 0; k < n; ++k) z[k] = points_[last * extent(n) + extent(k)] - outer_.center[k];
    any_dimension::product(n, outer_.inverse, z, normal);
    if (any_dimension::dot(n, z, normal) > 1.0 + 0.5 * least_share * gap) return true;
    return points_.resize(last * extent(n)) && owners_.resize(last);
}

/// Appends, for each point near the surface, the point of its ellipsoid along the normal there. The
/// points that are best for the ellipsoid that is sought satisfy this equation.
bool AroundEllipsoids::follow_normals(double gap) noexcept
{
    using any_dimension::dot, any_dimension::product;
    int const n = bodies_.n;
    double const least = 1.0 - minimum(0.3, maximum(10.0 * gap, 1e-9));
    double z[max_dimension] = {}, normal[max_dimension] = {}, qs[max_dimension] = {};
    for (std::size_t i = 0, count = owners_.size(); i < count; ++i) {
        for (int k = 0; k < n; ++k) z[k] = points_[i * extent(n) + extent(k)] - outer_.center[k];
        product(n, outer_.inverse, z, normal);
        if (dot(n, z, normal) < least) continue;
        std::size_t const owner = owners_[i];
        product(n, bodies_.form(owner), normal, qs);
        double const width = elementary::sqrt(dot(n, normal, qs));
        for (int k = 0; k < n; ++k)
            z[k] = bodies_.center(owner)[k] - outer_.center[k] + qs[k] / width;
        product(n, outer_.inverse, z, qs);
        if (!(dot(n, z, qs) > 1.0 + least_share * gap)) continue;
        if (!add_support(owner, normal) || !drop_last_inside(gap)) return false;
    }
    return true;
}

/// Proves that an ellipsoid is inside, in double precision, where r12 may be rounded by u, or with
/// twice its digits and the exact r12.
bool AroundEllipsoids::is_inside(std::size_t i) noexcept
{
    using namespace any_dimension;
    int const n = bodies_.n, unit = half_exponent(largest_diagonal(n, outer_.form));
    double r[max_dimension] = {};
    for (int k = 0; k < n; ++k) r[k] = bodies_.center(i)[k] - outer_.center[k];
    Input const in{n, r, outer_.form, bodies_.form(i)};
    Units const units{unit, unit, unit, false};
    auto &work = memory_.work;
    scale(in, units, work.pair);
    if (shows_inside(work.pair, nu_[i], work.at.factors)) return true;
    double ignored[max_dimension];
    double const kappa2 = reach(i, ignored, nu_[i]);
    double const nu = nu_[i] + 0.5 * maximum(0.0, 1.0 - kappa2);
    return with_wide_workspace([&](auto &wide) {
        scale(in, units, wide.pair);
        difference(n, bodies_.center(i), outer_.center, unit, wide.pair.r12);
        return shows_inside(wide.pair, Wide(nu), wide.at.factors);
    });
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
    double factor = 1.0 + gap, slack = 0x1p-47;
    for (int trial = 0; trial < 24; ++trial) {
        factor *= 1.0 + slack;
        if (!search_->enlarge(factor)) return Status::not_positive_definite;
        factor = 1.0;
        for (int i = 0; i < bodies_.n; ++i)
            for (int j = i; j < bodies_.n; ++j)
                outer_.form[packed_index(bodies_.n, i, j)] = search_->form(i, j);
        invert(bodies_.n, outer_.form, outer_.inverse);
        if (are_inside())
            return search_->excess() <= tolerance ? Status::success : Status::no_convergence;
        slack *= 2.0;
    }
    return Status::not_positive_definite;
}

Status AroundEllipsoids::run(double tolerance) noexcept
{
    if (Status const status = status_of_input(); status != Status::success) return status;
    if (!kappa2_.resize(bodies_.m) || !nu_.resize(bodies_.m) || !add_first_points())
        return Status::out_of_memory;
    // (1 + gap)^(n/2) takes half of the tolerance.
    double const target = tolerance / (1.0 + tolerance) / bodies_.n;
    double gap = 1.0, last = infinity<double>();
    for (int round = 0, idle = 0; round < max_rounds; ++round) {
        // The shape of an ellipsoid errs by the root of its excess.
        double const inner =
            minimum(0.125 * tolerance, maximum(1e-12, minimum(1e-6, 0.01 * gap * gap)));
        Status const status = enclose_points(inner);
        if (status != Status::success) return status;
        gap = measure();
        idle = gap < 0.5 * last ? 0 : idle + 1;
        if (idle == 0) last = gap;
        if (gap <= target || idle == max_idle_rounds) break;
        std::size_t const count = owners_.size();
        if (round + 1 < max_rounds && !(follow_normals(gap) && add_protruding(gap)))
            return Status::out_of_memory;
        if (owners_.size() == count) { // The search reads the points, which may have moved.
            if (Status const again = enclose_points(inner); again != Status::success) return again;
            break;
        }
    }
    return certify(gap, tolerance);
}

} // namespace pw85::detail::enclosing

// SPDX-License-Identifier: BSD-3-Clause
// The search for the smallest ellipsoid around ellipsoids, pw85_enclosing_ellipsoid_of(): steps 1
// to 3 of around_ellipsoids.hpp. around_ellipsoids_proof.cpp has the others.
#define PW85_SHORT_OPERATIONS // before doubled.hpp: calls take no longer here
#include "around_ellipsoids.hpp"

#include <new>

#include "../any_dimension/shared.hpp"
#include "../base/owner.hpp"
#include "max_det.hpp"

namespace pw85::detail::enclosing {

namespace {

using any_dimension::packed_index, any_dimension::packed_size;

/// Maximum number of rounds. Random ellipsoids need about 10.
constexpr int max_rounds = 60;
/// An ellipsoid becomes active if it protrudes by this share of the largest protrusion.
constexpr double least_share = 0.03;
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

void factor_of(int n, double const *form, Wide *b) noexcept
{
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) b[i * n + j] = Wide(form[packed_index(n, i, j)]);
    factorize(extent(n), b, 0x1p-100);
    for (int i = 0; i < n; ++i)
        for (int j = i + 1; j < n; ++j) b[i * n + j] = Wide(0.0);
}

[[gnu::cold, gnu::noinline]] Status AroundEllipsoids::status_of_input() const noexcept
{
    Status first = Status::success;
    for (std::size_t i = 0; i < bodies_.m; ++i) {
        auto const numbers = any_dimension::status_of_numbers(bodies_.n, bodies_.center(i));
        if (numbers != Status::success) return numbers;
        auto const form = any_dimension::exact_status_of_form(bodies_.n, bodies_.form(i));
        if (form == Status::invalid_argument) return form;
        if (first == Status::success) first = form;
    }
    return first;
}

/// Chooses units of the coordinates, powers of two, in which the extent of all ellipsoids is in [1,
/// 2).
[[gnu::cold, gnu::noinline]] Status AroundEllipsoids::choose_units() noexcept
{
    int const n = bodies_.n;
    cloud_.n = n;
    for (int k = 0; k < n; ++k) {
        double lowest = infinity<double>(), highest = -lowest, widest = 0.0;
        for (std::size_t i = 0; i < bodies_.m; ++i) {
            double const x = 0.5 * bodies_.center(i)[k],
                         width = 0.5 * elementary::sqrt(bodies_.form(i)[packed_index(n, k, k)]);
            lowest = minimum(lowest, x - width);
            highest = maximum(highest, x + width);
            widest = maximum(widest, width);
        }
        Unit const unit{binary_exponent(maximum(highest - lowest, widest)) + 1};
        if (unit < Unit{-max_exponent} || Unit{max_exponent} < unit)
            return Status::invalid_argument;
        cloud_.units[k] = unit;
        cloud_.scale[k] = 1.0;
    }
    return Status::success;
}

/// Returns an ellipsoid in these units. Entries that underflow are rounded by 2⁻¹⁰⁷⁴, which
/// shows_inside() allows for.
Body AroundEllipsoids::body(std::size_t i) const noexcept
{
    int const n = bodies_.n;
    Unit const *const units = cloud_.units;
    Body body;
    for (int k = 0; k < n; ++k) {
        body.center[k] = units[k].to_local(bodies_.center(i)[k]);
        for (int l = k; l < n; ++l) {
            int const at = packed_index(n, k, l);
            body.form[at] = (units[k] * units[l]).to_local(bodies_.form(i)[at]);
        }
    }
    return body;
}

bool AroundEllipsoids::is_active(std::size_t i) const noexcept
{
    for (std::size_t k = 0; k < active_.size(); ++k)
        if (active_[k] == i) return true;
    return false;
}

bool AroundEllipsoids::activate(std::size_t i) noexcept
{
    if (is_active(i)) return true;
    if (!active_.resize(active_.size() + 1)) return false;
    active_[active_.size() - 1] = i;
    return true;
}

/// Activates the ellipsoids that reach farthest along the coordinates. The first frame is that of
/// the covariance of uniform bodies of the same mass.
[[gnu::cold, gnu::noinline]] bool AroundEllipsoids::begin() noexcept
{
    int const n = bodies_.n;
    for (int k = 0; k < 2 * n; ++k) {
        double const sign = k % 2 ? -1.0 : 1.0;
        int const axis = k / 2;
        auto const height = [&](std::size_t i) {
            double const width = elementary::sqrt(bodies_.form(i)[packed_index(n, axis, axis)]);
            return sign * bodies_.center(i)[axis] + width;
        };
        std::size_t highest = 0;
        for (std::size_t i = 1; i < bodies_.m; ++i)
            if (height(i) > height(highest)) highest = i;
        if (!activate(highest)) return false;
    }
    Wide const count(static_cast<double>(active_.size()));
    for (Wide &x : frame_.center) x = Wide(0.0);
    for (Wide &x : covariance_) x = Wide(0.0);
    for (std::size_t i = 0; i < active_.size(); ++i)
        for (int k = 0; k < n; ++k)
            frame_.center[k] = frame_.center[k] + Wide(body(active_[i]).center[k]) / count;
    for (std::size_t i = 0; i < active_.size(); ++i) {
        Body const one = body(active_[i]);
        for (int k = 0; k < n; ++k)
            for (int l = 0; l <= k; ++l) {
                Wide const product = (Wide(one.center[k]) - frame_.center[k]) *
                                     (Wide(one.center[l]) - frame_.center[l]);
                covariance_[at(k, l)] =
                    covariance_[at(k, l)] +
                    (product + Wide(one.form[packed_index(n, k, l)]) / Wide(n)) / count;
            }
    }
    return true;
}

bool AroundEllipsoids::update_frame() noexcept
{
    for (int k = 0; k < at(bodies_.n, 0); ++k) frame_.a[k] = covariance_[k];
    return invert_factor(bodies_.n, frame_.a, 0x1p-80);
}

/// Computes L of max_det.hpp in the frame: (A B, A (c_i - c); 0, 1).
[[gnu::cold, gnu::noinline]] void AroundEllipsoids::find_map(std::size_t i, Wide *map) noexcept
{
    int const n = bodies_.n, d = n + 1;
    Body const one = body(i);
    Wide z[max_dimension], w[max_dimension];
    Wide *const b = factor_.x;
    factor_of(n, one.form, b);
    for (int j = 0; j < d; ++j) {
        for (int k = 0; k < n; ++k)
            z[k] = j < n ? b[k * n + j] : Wide(one.center[k]) - frame_.center[k];
        enclosing::multiply(frame_, z, w);
        for (int k = 0; k < n; ++k) map[k * d + j] = w[k];
        map[n * d + j] = Wide(j == n ? 1.0 : 0.0);
    }
}

/// Reads the outer ellipsoid from Z, which is in map_: its centre is -Z₁₁⁻¹ z₁₂ and its form ρ
/// Z₁₁⁻¹ in the frame, with ρ = d - (z₂₂ - z₁₂ᵀ Z₁₁⁻¹ z₁₂). Returns ρ, or 0 if Z is not definite.
[[gnu::cold, gnu::noinline]] Wide AroundEllipsoids::read_outer() noexcept
{
    int const n = bodies_.n, d = n + 1;
    std::size_t const size = extent(n);
    Wide *const k = factor_.x;
    Wide y[max_dimension];
    auto const z = [&](int i, int j) { return map_.x[i * d + j]; };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) k[i * n + j] = z(i, j);
    if (!factorize(size, k, 0.0)) return Wide(0.0);
    for (int i = 0; i < n; ++i) y[i] = z(i, n);
    substitute(size, k, y);
    Wide const rho = Wide(d) - z(n, n) + dot(size, y, y);
    substitute_back(size, k, y);
    // Solves A w = v.
    auto const leave_frame = [&](Wide *v) {
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < i; ++j) v[i] = v[i] - frame_.a[at(i, j)] * v[j];
            v[i] = v[i] / frame_.a[at(i, i)];
        }
    };
    for (int j = 0; j < n; ++j) {
        Wide *const x = columns_.x + j * n;
        for (int i = 0; i < n; ++i) x[i] = Wide(i == j ? 1.0 : 0.0);
        substitute_back(size, k, x);
        leave_frame(x);
    }
    leave_frame(y);
    for (int i = 0; i < n; ++i) {
        frame_.center[i] = frame_.center[i] - y[i];
        for (int j = 0; j <= i; ++j) {
            Wide sum(0.0);
            for (int l = 0; l < n; ++l) sum = sum + columns_.x[l * n + i] * columns_.x[l * n + j];
            covariance_[at(i, j)] = rho * sum / Wide(n);
        }
    }
    return rho;
}

/// Reads the outer ellipsoid, the multipliers and the moments.
template <class Search> bool AroundEllipsoids::read(Search const &search) noexcept
{
    std::size_t const d = extent(bodies_.n) + 1;
    for (std::size_t l = 0; l < d * d; ++l) map_.x[l] = Wide(search.z().x[l]);
    Wide const rho = read_outer();
    if (!(rho.high > 0.0)) return false;
    for (std::size_t i = 0; i < active_.size(); ++i) {
        multipliers_[i] = (Wide(search.lambda(i)) / rho).high;
        for (std::size_t l = 0; l < d * d; ++l)
            moments_[i].x[l] = Wide(search.moments(i).x[l]).high;
    }
    return true;
}

/// Continues a search with twice the digits, and reads its result. It is compiled for size.
template <class Search> [[gnu::cold, gnu::noinline]] Status
AroundEllipsoids::read_wider(Search const &search, double difference) noexcept
{
    std::size_t const count = active_.size();
    Owner<MaxDet<Wide>> const wide(new (std::nothrow) MaxDet<Wide>);
    if (wide == nullptr || !wide->reserve(bodies_.n, count)) return Status::out_of_memory;
    for (std::size_t i = 0; i < count; ++i) find_map(active_[i], wide->map(i).x);
    wide->begin_at(search);
    wide->solve(difference);
    return read(*wide) ? Status::success : Status::not_positive_definite;
}

/// Finds the smallest ellipsoid around the active ones. If double precision does not reach the
/// difference of the bounds, and this is the final difference, the search continues with twice the
/// digits.
Status AroundEllipsoids::enclose_active(double difference, bool is_final) noexcept
{
    std::size_t const count = active_.size();
    if (!update_frame()) return Status::not_positive_definite;
    Owner<MaxDet<double>> const search(new (std::nothrow) MaxDet<double>);
    if (search == nullptr || !search->reserve(bodies_.n, count) || !moments_.resize(count) ||
        !multipliers_.resize(count))
        return Status::out_of_memory;
    for (std::size_t i = 0; i < count; ++i) {
        find_map(active_[i], map_.x);
        for (std::size_t k = 0; k < max_lifted * max_lifted; ++k)
            search->map(i).x[k] = map_.x[k].high;
    }
    search->begin();
    Status status = Status::success;
    if (search->solve(difference) > difference && is_final)
        status = read_wider(*search, difference);
    else if (!read(*search))
        status = Status::not_positive_definite;
    if (status == Status::success) round_outer(1.0);
    return status;
}

/// Rounds the centre, and a multiple of the form.
void AroundEllipsoids::round_outer(double factor) noexcept
{
    int const n = bodies_.n;
    Wide const scale = Wide(factor) * Wide(n);
    for (int i = 0; i < n; ++i) {
        outer_.center[i] = frame_.center[i].high;
        for (int j = 0; j <= i; ++j)
            outer_.form[packed_index(n, j, i)] = (scale * covariance_[at(i, j)]).high;
    }
    invert(n, outer_.form, inverse_);
}

/// Returns κ² of one ellipsoid in the outer one, and sets the ν of its upper bound. Most ellipsoids
/// are far inside: by the triangle inequality κ <= |r| + √tr(Q⁻¹Q_i) in the norm of the outer one,
/// which is enough where `roughly`.
double AroundEllipsoids::reach(std::size_t i, bool roughly) noexcept
{
    using namespace any_dimension;
    int const n = bodies_.n;
    Body const one = body(i);
    double r[max_dimension] = {}, s[max_dimension] = {}, trace = 0.0;
    for (int k = 0; k < n; ++k) r[k] = one.center[k] - outer_.center[k];
    product(n, inverse_, r, s);
    for (int k = 0; k < n; ++k)
        for (int l = k; l < n; ++l) {
            int const at = packed_index(n, k, l);
            trace += (k == l ? 1.0 : 2.0) * inverse_[at] * one.form[at];
        }
    double const far = elementary::sqrt(maximum(0.0, any_dimension::dot(n, r, s))),
                 wide = elementary::sqrt(maximum(0.0, trace)), kappa = far + wide;
    nu_[i] = wide / kappa;
    if (roughly && kappa < 1.0 - 0x1p-20) return kappa * kappa;
    auto &work = memory_.work;
    auto &search = memory_.search;
    scale({n, r, outer_.form, one.form}, {}, work.pair);
    find_dual(memory_);
    if (!(search.best.mu2 > 0.0)) return far * far; // a point
    nu_[i] = search.nu;
    return search.best.mu2;
}

/// Computes κ² of all ellipsoids. Returns max κ² - 1, at least 0. Active ones are inside by their
/// matrix S, with less rounding error than κ² has: they do not count.
double AroundEllipsoids::measure() noexcept
{
    for (std::size_t i = 0; i < bodies_.m; ++i) kappa2_[i] = reach(i, true);
    for (std::size_t k = 0; k < active_.size(); ++k) {
        double &kappa2 = kappa2_[active_[k]];
        kappa2 = minimum(kappa2, 1.0);
    }
    double largest = 1.0;
    for (std::size_t i = 0; i < bodies_.m; ++i) largest = maximum(largest, kappa2_[i]);
    return largest - 1.0;
}

/// Deactivates the active ellipsoids that are inside and have almost no weight.
void AroundEllipsoids::drop_idle(double gap) noexcept
{
    auto const d = extent(bodies_.n) + 1;
    double const least = 1e-4 / static_cast<double>(d * d);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < active_.size(); ++i) {
        bool const idle =
            moments_[i].x[d * d - 1] < least && kappa2_[active_[i]] < 1.0 - maximum(0.1, 4.0 * gap);
        if (!idle) active_[kept++] = active_[i];
    }
    // The array keeps its memory: this cannot fail.
    if (!active_.resize(kept)) return;
}

/// Activates the ellipsoids that protrude most. Returns false if there is no memory.
bool AroundEllipsoids::activate_protruding(double gap) noexcept
{
    int const limit = 4 * (bodies_.n + 1);
    for (int count = 0; count < limit; ++count) {
        std::size_t worst = 0;
        for (std::size_t i = 1; i < bodies_.m; ++i)
            if (kappa2_[i] > kappa2_[worst]) worst = i;
        if (kappa2_[worst] <= 1.0 + least_share * gap) break;
        if (!activate(worst)) return false;
        kappa2_[worst] = 0.0;
    }
    return true;
}

Status AroundEllipsoids::run(double tolerance) noexcept
{
    if (Status const status = status_of_input(); status != Status::success) return status;
    if (Status const status = choose_units(); status != Status::success) return status;
    if (!kappa2_.resize(bodies_.m) || !nu_.resize(bodies_.m) || !begin())
        return Status::out_of_memory;
    // (1 + gap)^(n/2) takes half of the tolerance, and the difference of the bounds of the active
    // ellipsoids, which is that of the squared volume, three eighths. Nearer to the optimum the
    // ellipsoids have less clearance, and the proof that they are inside must enlarge the outer one
    // by more.
    double const target = tolerance / (1.0 + tolerance) / bodies_.n,
                 least = 0.75 * tolerance / (1.0 + tolerance);
    double gap = 1.0, difference = maximum(1e-2, least);
    for (int round = 0; round < max_rounds; ++round) {
        bool const is_final = difference <= least;
        Status const status = enclose_active(difference, is_final);
        if (status != Status::success) return status;
        gap = measure();
        if ((is_final && gap <= target) || round + 1 == max_rounds) break;
        if (!is_final) drop_idle(gap);
        std::size_t const count = active_.size();
        if (!activate_protruding(gap)) return Status::out_of_memory;
        bool const has_more = active_.size() > count;
        if (!has_more && is_final) break;
        difference = has_more ? maximum(least, minimum(difference, 0.05 * gap)) : least;
    }
    return certify(gap, tolerance);
}

} // namespace pw85::detail::enclosing

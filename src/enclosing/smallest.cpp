// SPDX-License-Identifier: BSD-3-Clause
// The search for the smallest ellipsoid around points: pw85_enclosing_ellipsoid().
#include "smallest.hpp"

namespace pw85::detail::enclosing {

namespace {

/// Maximum number of rounds. Random clouds need about 10.
constexpr int max_rounds_of_cloud = 200;
/// Maximum number of successive rounds that together do not halve the gap. After these, rounding
/// errors prevent progress.
constexpr int max_idle_rounds = 12;
/// The largest increase of the form, in units of its sensitivity to rounding.
constexpr int max_increase = 12;

} // namespace

/// Returns the capacity of the core set. At most n (n + 3)/2 points determine a minimum; the core
/// set holds several times as many.
std::size_t Search::capacity() const noexcept
{
    auto const d = static_cast<std::size_t>(cloud_.n) + 1;
    return 3 * d * (d + 1) / 2 + 16;
}

bool Search::has_memory() noexcept
{
    if (!candidates_.resize(cloud_.m) || !kappa_.resize(cloud_.m)) return false;
    for (std::size_t i = 0; i < cloud_.m; ++i) candidates_[i] = i;
    count_ = cloud_.m;
    return core_.reserve(capacity());
}

bool Search::begin() noexcept
{
    std::size_t pairs[max_dimension][2];
    if (!find_outermost(cloud_, pairs)) return false;
    for (int i = 0; i < cloud_.n; ++i)
        for (std::size_t const point : pairs[i])
            if (!core_.contains(point)) core_.append(point, 0.5 / cloud_.n);
    return true;
}

/// Computes the frame of the ellipsoid zᵀS⁻¹z <= 1, with the mean and the covariance S of the
/// weights.
bool Search::update_frame() noexcept
{
    moments(cloud_, core_.size(), core_.points(), core_.weights(), frame_.center, covariance_);
    for (int k = 0; k < at(cloud_.n, 0); ++k) frame_.a[k] = covariance_[k];
    return invert_factor(cloud_.n, frame_.a, 0x1p-50);
}

void Search::improve_weights(double gap) noexcept
{
    Wide z[max_dimension], w[max_dimension];
    for (std::size_t i = 0; i < core_.size(); ++i) {
        offset_of(cloud_, frame_.center, core_.points()[i], z);
        multiply(frame_, z, w);
        double *const y = core_.coordinates(i);
        for (int k = 0; k < cloud_.n; ++k) y[k] = w[k].high;
        y[cloud_.n] = 1.0;
    }
    core_.solve(gap);
}

/// Computes κ = zᵀS⁻¹z/n of each candidate. Returns max κ - 1, at least 0.
double Search::measure() noexcept
{
    double center[max_dimension], largest = 1.0;
    for (int k = 0; k < at(cloud_.n, 0); ++k) triangle_[k] = frame_.a[k].high;
    for (int k = 0; k < cloud_.n; ++k) center[k] = frame_.center[k].high;
    for (std::size_t i = 0; i < count_; ++i) {
        kappa_[i] = squared_norm(cloud_, triangle_, center, candidates_[i]) / cloud_.n;
        largest = kappa_[i] > largest ? kappa_[i] : largest;
    }
    return largest - 1.0;
}

/// Removes the candidates that cannot have a weight at the minimum: κ_i + 1/n, in units of (n +
/// 1)/n, is below the bound of R. Harman and L. Pronzato, Stat. Probab. Lett. 77, 90 (2007).
/// Rounding errors are harmless, because the certificate is for all points.
void Search::eliminate(double gap) noexcept
{
    double const n = cloud_.n, d = n + 1.0, e = gap * n / d;
    double const least = 1.0 + 0.5 * e - 0.5 * elementary::sqrt(e * (4.0 + e - 4.0 / d));
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count_; ++i) {
        if ((1.0 + n * kappa_[i]) / d < least - 1e-9) continue;
        candidates_[kept] = candidates_[i];
        kappa_[kept++] = kappa_[i];
    }
    count_ = kept;
}

/// Puts a candidate on a list, sorted by κ, of points that are outside in different directions: no
/// two of them have an angle below 37° in the norm of the ellipsoid. Of two such points only the
/// farther one is kept.
void Search::add_to_worst(std::size_t candidate, Outermost &worst) noexcept
{
    Outermost::Point point{candidate, kappa_[candidate], {}};
    double const *const a = triangle_, length = point.kappa * cloud_.n;
    for (int i = 0; i < cloud_.n; ++i)
        for (int j = 0; j <= i; ++j)
            point.w[i] += a[at(i, j)] *
                          (cloud_.coordinate(candidates_[candidate], j) - frame_.center[j].high);
    auto const is_similar = [&](Outermost::Point const &other) {
        double product = 0.0;
        for (int k = 0; k < cloud_.n; ++k) product += point.w[k] * other.w[k];
        return product > 0.0 && product * product > 0.64 * length * other.kappa * cloud_.n;
    };
    int kept = 0;
    while (kept < worst.size && worst.points[kept].kappa >= point.kappa)
        if (is_similar(worst.points[kept++])) return;
    int end = kept;
    for (int k = kept; k < worst.size; ++k)
        if (!is_similar(worst.points[k])) worst.points[end++] = worst.points[k];
    worst.size = end < worst.limit ? end + 1 : worst.limit;
    for (int k = worst.size - 1; k > kept; --k) worst.points[k] = worst.points[k - 1];
    worst.points[kept] = point;
}

/// Adds candidates with κ > 1 + gap to the core set, the worst of each direction. Returns how many.
int Search::add_worst(double gap) noexcept
{
    Outermost worst;
    auto const free = static_cast<int>(capacity() - core_.size());
    worst.size = 0;
    worst.limit = free < 2 * (cloud_.n + 1) ? free : 2 * (cloud_.n + 1);
    for (std::size_t i = 0; i < count_ && worst.limit > 0; ++i) {
        bool const is_full = worst.size == worst.limit;
        if (kappa_[i] <= 1.0 + gap) continue;
        if (is_full && kappa_[i] <= worst.points[worst.limit - 1].kappa) continue;
        if (!core_.contains(candidates_[i])) add_to_worst(i, worst);
    }
    double const weight = 0.01 / static_cast<double>(core_.size());
    for (int k = 0; k < worst.size; ++k)
        core_.append(candidates_[worst.points[k].candidate], weight);
    return worst.size;
}

Status Search::run(double tolerance) noexcept
{
    if (Status const status = choose_scale(cloud_); status != Status::success) return status;
    if (!has_memory()) return Status::out_of_memory;
    if (!begin() || !update_frame()) return Status::not_positive_definite;
    // (1 + g)^(n/2) <= 1 + tolerance for twice this gap.
    double const target = tolerance / (1.0 + tolerance) / cloud_.n;
    double gap = 1.0, last = infinity<double>();
    for (int round = 0, idle = 0; round < max_rounds_of_cloud && idle < max_idle_rounds; ++round) {
        double const inner = gap / 16.0 < 0.5 * target ? 0.5 * target : gap / 16.0;
        improve_weights(inner < 0.05 ? inner : 0.05);
        if (!update_frame()) return Status::not_positive_definite;
        gap = measure();
        if (gap <= target) break;
        idle = gap < 0.5 * last ? 0 : idle + 1;
        if (idle == 0) last = gap;
        eliminate(gap);
        core_.remove_idle(gap);
        if (add_worst(0.5 * target) == 0 && inner <= 0.5 * target) break;
    }
    return certify(gap, tolerance);
}

/// Rounds the centre and the form to double precision, and enlarges the form until all points are
/// proved to be inside.
Status Search::certify(double gap, double tolerance) noexcept
{
    double slack = 0.0, scale = 1.0 + gap;
    for (int k = 0; k < cloud_.n; ++k) center_[k] = frame_.center[k].high;
    for (int trial = 0; trial < max_increase; ++trial) {
        Wide const factor = Wide(scale) * Wide(cloud_.n);
        for (int k = 0; k < at(cloud_.n, 0); ++k) form_[k] = (factor * covariance_[k]).high;
        if (!certificate_.prepare(cloud_, center_, form_)) return Status::not_positive_definite;
        double outside = certificate_.largest_protrusion(core_.size(), core_.points());
        if (outside <= 0.0) outside = certificate_.largest_protrusion();
        if (outside <= 0.0) {
            excess_ = certificate_.excess(core_.size(), core_.points(), core_.weights());
            return excess_ <= tolerance ? Status::success : Status::no_convergence;
        }
        slack = slack == 0.0 ? 0x1p-6 * certificate_.sensitivity() : 2.0 * slack;
        scale *= (1.0 + outside) * (1.0 + slack);
    }
    return Status::not_positive_definite;
}

} // namespace pw85::detail::enclosing

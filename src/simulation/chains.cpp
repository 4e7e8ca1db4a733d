// Event chains: see chains.hpp.
#include "chains.hpp"

#include <pw85/motion/free_path.hpp>
#include <pw85/overlap/overlap.hpp>

namespace pw85::detail::simulation {

namespace {

/// The longest way without contact, over the longest semi-axis of all particles. It is a compromise: contacts on longer ways are found in
/// several stages, and more particles are near a longer stage. In dense fluids ways are a few tenths of the shorter semi-axes.
constexpr double stage_size = 0.25;

/// The side of a bin, over the same length.
constexpr double bin_size = 1.0;

/// So many ways of no length follow each other only if particles block each other.
constexpr int most_idle_ways = 1000;

/// rᵀadj(M)r - (1 + 1/t) det M on a way, as a polynomial of its length x. It is positive where f > 1 at the t of spheres with these traces
/// (item 1 of motion/passage.hpp).
struct WayPolynomial {
    double excess, approach, speed; ///< excess - 2 approach x + speed x²

    /// The least value up to a length.
    double least(double length) const noexcept
    {
        if (!(approach > 0.0)) return excess;
        if (approach >= speed * length) return excess - (2.0 * approach - speed * length) * length;
        return excess - approach * approach / speed;
    }

    /// The first root, which is known to exist unless the polynomial begins at zero or below.
    double root() const noexcept
    {
        if (!(excess > 0.0)) return 0.0;
        return excess / (approach + std::sqrt(std::max(0.0, approach * approach - excess * speed)));
    }
};

/// The polynomial for some candidate, and its rounding error: the sum of the magnitudes of all terms is below 8 (Σ|r_i| + x)² (tr M)² + 16
/// (1 + 1/t) (tr M)³. The margin, 2⁻³² times that, is above the rounding errors by far, so that `size`, which stands for Σ|r_i| + x, may be
/// small compared with the coordinates of the centres.
struct RoughPath {
    WayPolynomial polynomial;
    double margin;
};

RoughPath rough_path(Vector3 const &r12, Form3 const &q1, Form3 const &q2, Vector3 const &direction,
                     double size) noexcept
{
    double const trace1 = q1[0] + q1[3] + q1[5], trace2 = q2[0] + q2[3] + q2[5];
    double const t = std::sqrt(trace1 / trace2), trace = trace1 + t * trace2, level = 1.0 + 1.0 / t;
    auto const m = blend(q1, t, q2), adj = adjugate(m);
    Vector3 const s = product(adj, r12);
    return {{dot(r12, s) - level * determinant(m, adj), dot(direction, s), dot(direction, product(adj, direction))},
            0x1p-32 * trace * trace * (8.0 * size * size + 16.0 * level * trace)};
}

/// The multiple of `digit`, a power of two, below a way that is less than 2⁵³ times as long.
double rounded_down(double way, double digit) noexcept { return std::floor(way / digit) * digit; }

} // namespace

int Chains::prepare() noexcept
{
    longest_ = 0.0;
    for (std::size_t i = 0; i < configuration_.size(); ++i)
        for (double const length : configuration_.semi_axes[i].coordinates) longest_ = std::max(longest_, length);
    return bins_.prepare(configuration_, bin_size * longest_);
}

/// Finds the images whose boxes meet that of particle i on a way. The box of the way has the boxes of its ends.
bool Chains::find_candidates(std::size_t i, Vector3 const &direction, double stage) noexcept
{
    Vector3 const half = 0.5 * stage * direction;
    Vector3 own = configuration_.half_widths[i];
    for (int d = 0; d < 3; ++d) own[d] += absolute(half[d]);
    num_candidates_ = 0;
    bool has_room = true;
    bins_.visit(configuration_.centers[i] + half, own, [&](std::size_t j, Multiples const &image) {
        if (num_candidates_ == candidates_.size()) has_room = candidates_.resize(2 * num_candidates_ + 64);
        if (!has_room || j == i) return;
        Vector3 const translation = configuration_.cell.translation(image);
        candidates_[num_candidates_++] = {configuration_.separation(i, j, translation), translation, j, 0.0};
    });
    return has_room;
}

/// Keeps the candidates that may be touched, the nearest first. The others are free at each place on the way, however it is rounded.
void Chains::sort_by_bounds(std::size_t i, Vector3 const &direction, double stage) noexcept
{
    double const far = stage + 0x1p-16 * sum_of_magnitudes(configuration_.centers[i]);
    std::size_t count = 0;
    for (std::size_t k = 0; k < num_candidates_; ++k) {
        Candidate candidate = candidates_[k];
        auto const [polynomial, margin] =
            rough_path(candidate.r12, configuration_.q[i], configuration_.q[candidate.index], direction,
                       sum_of_magnitudes(candidate.r12) + far);
        if (polynomial.least(stage) > margin) continue;
        candidate.bound = polynomial.root();
        std::size_t place = count++;
        for (; place > 0 && candidates_[place - 1].bound > candidate.bound; --place)
            candidates_[place] = candidates_[place - 1];
        candidates_[place] = candidate;
    }
    num_candidates_ = count;
}

Chains::Way Chains::find_way(std::size_t i, Vector3 const &direction, double stage) noexcept
{
    sort_by_bounds(i, direction, stage);
    Way way{stage, nullptr};
    for (std::size_t k = 0; k < num_candidates_ && candidates_[k].bound < way.length; ++k) {
        Candidate const &candidate = candidates_[k];
        auto const &q = configuration_.q;
        auto const path = free_path(candidate.r12, q[i], q[candidate.index], direction, way.length);
        if (path.length < way.length) way = {path.length, &candidate};
    }
    return way;
}

/// Whether particle i, at its place on the way, overlaps any candidate, by the exact test.
bool Chains::overlaps(std::size_t i) const noexcept
{
    for (std::size_t k = 0; k < num_candidates_; ++k) {
        auto const &[r12, translation, j, bound] = candidates_[k];
        Vector3 const r = configuration_.separation(i, j, translation);
        if (overlap(r, configuration_.q[i], configuration_.q[j]).overlap) return true;
    }
    return false;
}

/// Moves particle i along its way, as far as rounding allows, and returns how far. The separations are rounded by some u of the
/// coordinates, which may cost more where a contact grazes.
double Chains::advance(std::size_t i, Vector3 const &direction, double way, double digit) noexcept
{
    Vector3 &center = configuration_.centers[i];
    Vector3 const start = center;
    double back = std::max(digit, 0x1p-52 * (largest_coordinate(start) + longest_));
    for (double moved = rounded_down(way, digit); moved > 0.0; back *= 4.0) {
        center = start + moved * direction;
        if (!overlaps(i)) {
            bins_.move(i, center);
            return moved;
        }
        moved = rounded_down(moved - back, digit);
    }
    center = start;
    return 0.0;
}

int Chains::run(std::size_t first, Vector3 const &direction, double length, ChainSums &sums) noexcept
{
    double const digit = times_power_of_two(1.0, binary_exponent(length) - 52);
    double remaining = length;
    int idle = 0;
    sums.length += length;
    for (std::size_t i = first; remaining > 0.0;) {
        double const stage = std::min(remaining, stage_size * longest_);
        if (!find_candidates(i, direction, stage)) return PW85_ENOMEM;
        Way const way = find_way(i, direction, stage);
        double const moved = advance(i, direction, way.length, digit);
        remaining -= moved;
        idle = moved > 0.0 ? 0 : idle + 1;
        if (idle > most_idle_ways) return PW85_ECONVERGENCE;
        if (way.touched == nullptr) continue;
        sums.transfers += dot(way.touched->r12, direction) - moved;
        ++sums.contacts;
        i = way.touched->index;
    }
    return PW85_SUCCESS;
}

} // namespace pw85::detail::simulation

/// @file
/// Many pairs at once, from C++: std::span over the functions of the compiled library (link with pw85).
///
/// The contracts are those of pw85.h: a bad pair is marked (NaN, or 255 for overlaps) and the status of the first one is
/// returned; sizes that do not fit together, or an index out of range, are `Status::invalid_argument` before anything is
/// written. Empty spans are fine. The lambda outputs may be left out.
#ifndef PW85_BATCH_HPP_INCLUDED
#define PW85_BATCH_HPP_INCLUDED

#include <pw85.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include <pw85/status.hpp>
#include <pw85/symmetric.hpp>

namespace pw85 {

using Vectors = std::span<Vector<double, 3> const>;
using Forms = std::span<SymmetricMatrix<double, 3> const>;

/// Particles i and j of a pair.
using IndexPair = std::array<std::int32_t, 2>;

/// Rows = vectors of a periodic cell.
using Cell = std::array<Vector<double, 3>, 3>;

/// Particles, in a periodic cell or not.
struct Particles {
    Vectors centers;
    Forms q;
    Cell const *cell = nullptr;
};

/// contact() for pairs of double precision.
static inline Status contact_batch(Vectors r12, Forms q1, Forms q2, std::span<double> mu2,
                                   std::span<double> lambda = {}) noexcept;

/// contact() for pairs of single precision: the forms are widened, computed with in double, and the results rounded.
static inline Status contact_batch(std::span<Vector<float, 3> const> r12, std::span<SymmetricMatrix<float, 3> const> q1,
                                   std::span<SymmetricMatrix<float, 3> const> q2, std::span<float> mu2,
                                   std::span<float> lambda = {}) noexcept;

/// overlap() for pairs: 1, 0, or 255.
static inline Status overlap_batch(Vectors r12, Forms q1, Forms q2, std::span<unsigned char> overlap) noexcept;

/// contact() for the pairs of a neighbour list.
static inline Status contact_pairs(std::span<IndexPair const> pairs, Particles const &particles, std::span<double> mu2,
                                   std::span<double> lambda = {}) noexcept;

/// overlap() for the pairs of a neighbour list.
static inline Status overlap_pairs(std::span<IndexPair const> pairs, Particles const &particles,
                                   std::span<unsigned char> overlap) noexcept;

namespace detail {

static_assert(sizeof(Vector<double, 3>) == 3 * sizeof(double));
static_assert(sizeof(SymmetricMatrix<double, 3>) == 6 * sizeof(double));
static_assert(sizeof(IndexPair) == 2 * sizeof(std::int32_t));

template <class Row> static double const *numbers(std::span<Row const> rows) noexcept
{
    return reinterpret_cast<double const *>(rows.data());
}

static inline std::int32_t const *numbers(std::span<IndexPair const> pairs) noexcept
{
    return reinterpret_cast<std::int32_t const *>(pairs.data());
}

static inline double const *numbers(Cell const *cell) noexcept { return reinterpret_cast<double const *>(cell); }

/// The output, or null if it was left out.
static inline double *optional(std::span<double> lambda) noexcept { return lambda.empty() ? nullptr : lambda.data(); }

template <class Lambda> static bool fits(std::size_t n, Lambda lambda) noexcept
{
    return lambda.empty() || lambda.size() == n;
}

static inline bool fit(Particles const &particles) noexcept { return particles.centers.size() == particles.q.size(); }

/// Copies `count` rows and widens them.
template <class Row, class Wide>
static void widen(std::span<Row const> rows, std::size_t first, std::size_t count, Wide *wide) noexcept
{
    for (std::size_t i = 0; i < count; ++i)
        for (int k = 0; k < static_cast<int>(sizeof(Row) / sizeof(float)); ++k)
            wide[i][k] = static_cast<double>(rows[first + i][k]);
}

} // namespace detail

static inline Status contact_batch(Vectors r12, Forms q1, Forms q2, std::span<double> mu2,
                                   std::span<double> lambda) noexcept
{
    std::size_t const n = mu2.size();
    if (r12.size() != n || q1.size() != n || q2.size() != n || !detail::fits(n, lambda))
        return Status::invalid_argument;
    return static_cast<Status>(pw85_contact_batch(n, detail::numbers(r12), detail::numbers(q1), detail::numbers(q2),
                                                  mu2.data(), detail::optional(lambda)));
}

static inline Status contact_batch(std::span<Vector<float, 3> const> r12, std::span<SymmetricMatrix<float, 3> const> q1,
                                   std::span<SymmetricMatrix<float, 3> const> q2, std::span<float> mu2,
                                   std::span<float> lambda) noexcept
{
    constexpr std::size_t block = 32; // 4 KiB of stack
    std::size_t const n = mu2.size();
    if (r12.size() != n || q1.size() != n || q2.size() != n || !detail::fits(n, lambda))
        return Status::invalid_argument;
    Vector<double, 3> r[block];
    SymmetricMatrix<double, 3> p[block], q[block];
    double wide_mu2[block], wide_lambda[block];
    Status first_bad = Status::success;
    for (std::size_t first = 0; first < n; first += block) {
        std::size_t const count = std::min(block, n - first);
        detail::widen(r12, first, count, r);
        detail::widen(q1, first, count, p);
        detail::widen(q2, first, count, q);
        Status const status = contact_batch(Vectors(r, count), Forms(p, count), Forms(q, count),
                                            std::span(wide_mu2, count), std::span(wide_lambda, count));
        if (first_bad == Status::success) first_bad = status;
        for (std::size_t i = 0; i < count; ++i) {
            mu2[first + i] = static_cast<float>(wide_mu2[i]);
            if (!lambda.empty()) lambda[first + i] = static_cast<float>(wide_lambda[i]);
        }
    }
    return first_bad;
}

static inline Status overlap_batch(Vectors r12, Forms q1, Forms q2, std::span<unsigned char> overlap) noexcept
{
    std::size_t const n = overlap.size();
    if (r12.size() != n || q1.size() != n || q2.size() != n) return Status::invalid_argument;
    return static_cast<Status>(
        pw85_overlap_batch(n, detail::numbers(r12), detail::numbers(q1), detail::numbers(q2), overlap.data()));
}

static inline Status contact_pairs(std::span<IndexPair const> pairs, Particles const &particles, std::span<double> mu2,
                                   std::span<double> lambda) noexcept
{
    std::size_t const n = pairs.size();
    if (mu2.size() != n || !detail::fits(n, lambda) || !detail::fit(particles)) return Status::invalid_argument;
    return static_cast<Status>(pw85_contact_pairs(
        n, detail::numbers(pairs), particles.centers.size(), detail::numbers(particles.centers),
        detail::numbers(particles.q), detail::numbers(particles.cell), mu2.data(), detail::optional(lambda)));
}

static inline Status overlap_pairs(std::span<IndexPair const> pairs, Particles const &particles,
                                   std::span<unsigned char> overlap) noexcept
{
    std::size_t const n = pairs.size();
    if (overlap.size() != n || !detail::fit(particles)) return Status::invalid_argument;
    return static_cast<Status>(pw85_overlap_pairs(n, detail::numbers(pairs), particles.centers.size(),
                                                  detail::numbers(particles.centers), detail::numbers(particles.q),
                                                  detail::numbers(particles.cell), overlap.data()));
}

} // namespace pw85

#endif

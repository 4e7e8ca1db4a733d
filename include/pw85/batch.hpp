/// @file
/// Many pairs at once, from C++: `std::span` over the functions of the compiled library (link with pw85).
///
/// The contracts are those of pw85.h: a bad pair is marked (NaN, or 255 for overlaps) and the status of the first one is
/// returned; sizes that do not fit together, or an index out of range, are `Status::invalid_argument` before anything is
/// written. Empty spans are fine. Outputs with a default may be left out.
#ifndef PW85_BATCH_HPP_INCLUDED
#define PW85_BATCH_HPP_INCLUDED

#include <pw85.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include <pw85/first_contact.hpp>
#include <pw85/status.hpp>
#include <pw85/symmetric.hpp>

namespace pw85 {

using Vectors = std::span<Vector<double, 3> const>;
using Forms = std::span<SymmetricMatrix<double, 3> const>;

/// Those of ellipses.
using FlatVectors = std::span<Vector<double, 2> const>;
using FlatForms = std::span<SymmetricMatrix<double, 2> const>;

/// Particles i and j of a pair.
using IndexPair = std::array<std::int32_t, 2>;

/// Multiples of the vectors of a cell, to be added to the second particle of a pair.
using Image = std::array<std::int32_t, 3>;

/// Rows = vectors of a periodic cell.
using Cell = std::array<Vector<double, 3>, 3>;

/// A reduced cell, NaN where the status is not success.
struct ReducedCell {
    Cell cell;
    Status status;
};

/// Where the contact functions of pairs and their derivatives go; see pw85_contact_derivatives_batch().
struct DerivativeSpans {
    std::span<double> mu2 = {}, lambda = {};
    std::span<Vector<double, 3>> point = {}, normal = {}, d_r12 = {}, d_rot1 = {}, d_rot2 = {};
};

/// Where first contacts go, and for each particle its next one and the index of the pair, -1 if there is none; see
/// pw85_first_contact_pairs().
struct EventSpans {
    std::span<double> time;
    std::span<double> next = {};
    std::span<std::int64_t> next_pair = {}; ///< not without `next`
};

/// Where forces go, one row for each particle, and the virial; see pw85_contact_forces_pairs().
struct ForceSpans {
    std::span<Vector<double, 3>> forces = {}, torques = {};
    std::array<Vector<double, 3>, 3> *virial = nullptr;
};

/// The pairs of a neighbour list, each with the image that it stands for; without images they are the nearest ones.
struct PairList {
    std::span<IndexPair const> pairs;
    std::span<Image const> images = {};
};

/// Particles, in a periodic cell or not.
struct Particles {
    Vectors centers;
    Forms q;
    Cell const *cell = nullptr;
};

/// @name Many pairs
/// @{

/// contact() for pairs of double precision: see pw85_contact_batch().
///
/// @param r12,q1,q2 one row for each pair
/// @param[out] mu2 one number for each pair
/// @param[out] lambda the same, or empty
/// @return Status::success, Status::invalid_argument, or the status of the first bad pair, which is NaN
static inline Status contact_batch(Vectors r12, Forms q1, Forms q2, std::span<double> mu2,
                                   std::span<double> lambda = {}) noexcept;

/// contact() for pairs of single precision: the forms are widened, computed with in double, and the results rounded.
///
/// @param r12,q1,q2,mu2,lambda as for contact_batch() of double precision
/// @return as for contact_batch() of double precision
static inline Status contact_batch(std::span<Vector<float, 3> const> r12, std::span<SymmetricMatrix<float, 3> const> q1,
                                   std::span<SymmetricMatrix<float, 3> const> q2, std::span<float> mu2,
                                   std::span<float> lambda = {}) noexcept;

/// overlap() for pairs: see pw85_overlap_batch().
///
/// @param r12,q1,q2 as for contact_batch()
/// @param[out] overlap one for each pair: 1, 0, or 255 for a bad one
/// @return as for contact_batch()
static inline Status overlap_batch(Vectors r12, Forms q1, Forms q2, std::span<unsigned char> overlap) noexcept;

/// contact() for pairs of ellipses: see pw85_contact_batch_2d().
///
/// @param r12,q1,q2 one of each for each pair
/// @param[out] mu2,lambda as for contact_batch()
/// @return as for contact_batch()
static inline Status contact_batch(FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double> mu2,
                                   std::span<double> lambda = {}) noexcept;

/// overlap() for pairs of ellipses: see pw85_overlap_batch_2d().
///
/// @param r12,q1,q2 one of each for each pair
/// @param[out] overlap as for overlap_batch()
/// @return as for contact_batch()
static inline Status overlap_batch(FlatVectors r12, FlatForms q1, FlatForms q2,
                                   std::span<unsigned char> overlap) noexcept;

/// closest_approach() for pairs: see pw85_closest_approach_batch().
///
/// @param directions one for each pair, of any lengths > 0
/// @param q1,q2 as for contact_batch()
/// @param[out] distance one for each pair
/// @return as for contact_batch(); a zero direction is Status::invalid_argument
static inline Status closest_approach_batch(Vectors directions, Forms q1, Forms q2,
                                            std::span<double> distance) noexcept;

/// contact(), contact_geometry() and the derivatives for pairs: see pw85_contact_derivatives_batch().
///
/// @param r12,q1,q2 as for contact_batch()
/// @param[out] out one row for each pair in all spans, or in some
/// @return as for contact_batch()
static inline Status contact_derivatives_batch(Vectors r12, Forms q1, Forms q2, DerivativeSpans const &out) noexcept;

/// Whether an ellipsoid overlaps any of others. Looks at these up to the first that overlaps or is bad.
///
/// @param q1 form of the one
/// @param r12,q2 centres of the others relative to that of the one, and their forms
/// @param[out] any 1 or 0; -1 on error
/// @return Status::success, Status::invalid_argument, or the status of a bad pair that no overlap precedes
static inline Status overlap_any(SymmetricMatrix<double, 3> const &q1, Vectors r12, Forms q2, int &any) noexcept;

/// contact() for the pairs of a neighbour list: see pw85_contact_pairs().
///
/// @param list indices of particles, with or without images
/// @param particles centres, forms and cell; sizes must fit, and indices be those of particles
/// @param[out] mu2,lambda as for contact_batch()
/// @return as for contact_batch(); Status::invalid_argument also for images without a cell, a cell that is not finite or,
/// unless there are images, singular
static inline Status contact_pairs(PairList const &list, Particles const &particles, std::span<double> mu2,
                                   std::span<double> lambda = {}) noexcept;

/// overlap() for the pairs of a neighbour list.
///
/// @param list,particles as for contact_pairs()
/// @param[out] overlap as for overlap_batch()
/// @return as for contact_pairs()
static inline Status overlap_pairs(PairList const &list, Particles const &particles,
                                   std::span<unsigned char> overlap) noexcept;

/// contact_derivatives_batch() for the pairs of a neighbour list.
///
/// @param list,particles as for contact_pairs()
/// @param[out] out as for contact_derivatives_batch()
/// @return as for contact_pairs()
static inline Status contact_derivatives_pairs(PairList const &list, Particles const &particles,
                                               DerivativeSpans const &out) noexcept;

/// first_contact() for the pairs of a neighbour list, and the next event of each particle: see pw85_first_contact_pairs().
///
/// @param list,particles as for contact_pairs()
/// @param motions one for each particle
/// @param end as for first_contact()
/// @param[out] out one time for each pair, and one event for each particle
/// @return as for contact_pairs(); Status::no_convergence, too
static inline Status first_contact_pairs(PairList const &list, Particles const &particles,
                                         std::span<Motion<double, 3> const> motions, double end,
                                         EventSpans const &out) noexcept;

/// @}

/// @name Periodic cells
/// @{

/// A reduced cell of the same lattice, the prepared form of a cell: see pw85_cell_reduce().
///
/// @param cell rows are its vectors
/// @return the reduced cell; Status::invalid_argument for a cell that is singular or not finite
static inline ReducedCell cell_reduce(Cell const &cell) noexcept;

/// The nearest images of the pairs of a list: see pw85_nearest_images().
///
/// @param pairs,centers indices of particles, and where these are
/// @param cell rows are its vectors
/// @param[out] r12 from the first to the image of the second, one for each pair, or none
/// @param[out] images multiples of the vectors of the cell, one row for each pair, or none
/// @return Status::success, or Status::invalid_argument, also for the first bad pair, whose rows are NaN and INT32_MIN
static inline Status nearest_images(std::span<IndexPair const> pairs, Vectors centers, Cell const &cell,
                                    std::span<Vector<double, 3>> r12, std::span<Image> images = {}) noexcept;

/// Up to which μ² nearest images are all there is: see pw85_nearest_image_limit().
///
/// @param q forms of the particles; infinity is the limit of none
/// @param cell rows are its vectors
/// @param[out] mu2 the limit
/// @return Status::success, Status::invalid_argument (also a cell that is singular or not finite),
/// Status::not_positive_definite
static inline Status nearest_image_limit(Forms q, Cell const &cell, double &mu2) noexcept;

/// @}

/// @name Many forms
/// @{

/// ellipsoid_quaternion() for many ellipsoids; the bits are the same.
///
/// @param semi_axes,quaternions one for each ellipsoid: lengths, and (w, x, y, z)
/// @param[out] q one form for each
/// @return Status::success or Status::invalid_argument; a bad row is NaN
static inline Status ellipsoid_quaternion_batch(Vectors semi_axes, std::span<Vector<double, 4> const> quaternions,
                                                std::span<SymmetricMatrix<double, 3>> q) noexcept;

/// bounding_box() for many ellipsoids.
///
/// @param q their forms
/// @param[out] half_widths √Q_ii, one row for each
/// @return Status::success, Status::invalid_argument, or the status of the first bad form, whose row is NaN
static inline Status bounding_boxes(Forms q, std::span<Vector<double, 3>> half_widths) noexcept;

/// @}

/// overlap_any() for others of a system, by their indices: see pw85_overlap_any_indices().
///
/// @param center,q1 centre and form of the one
/// @param indices of the others
/// @param particles the system
/// @param[out] any 1, 0, or -1 on error
/// @return as for overlap_any()
static inline Status overlap_any_indices(Vector<double, 3> const &center, SymmetricMatrix<double, 3> const &q1,
                                         std::span<std::int32_t const> indices, Particles const &particles,
                                         int &any) noexcept;

/// Forces, torques and virial of an energy of pairs: see pw85_contact_forces_pairs().
///
/// @param list,particles as for contact_pairs()
/// @param d_u one for each pair: the derivative of the energy with respect to μ²
/// @param derivatives from contact_derivatives_pairs()
/// @param[out] out sums
/// @return Status::success, Status::invalid_argument
static inline Status contact_forces_pairs(PairList const &list, Particles const &particles, std::span<double const> d_u,
                                          DerivativeSpans const &derivatives, ForceSpans const &out) noexcept;

namespace detail {

static_assert(sizeof(Vector<double, 2>) == 2 * sizeof(double));
static_assert(sizeof(SymmetricMatrix<double, 2>) == 3 * sizeof(double));
static_assert(sizeof(Vector<double, 3>) == 3 * sizeof(double));
static_assert(sizeof(SymmetricMatrix<double, 3>) == 6 * sizeof(double));
static_assert(sizeof(Vector<double, 4>) == 4 * sizeof(double));
static_assert(sizeof(IndexPair) == 2 * sizeof(std::int32_t));
static_assert(sizeof(Image) == 3 * sizeof(std::int32_t));
static_assert(sizeof(Cell) == 9 * sizeof(double));

template <class Row> static double const *numbers(std::span<Row const> rows) noexcept
{
    return reinterpret_cast<double const *>(rows.data());
}

template <std::size_t N> static std::int32_t const *integers(std::span<std::array<std::int32_t, N> const> rows) noexcept
{
    return rows.empty() ? nullptr : reinterpret_cast<std::int32_t const *>(rows.data());
}

static inline double const *numbers(Cell const *cell) noexcept { return reinterpret_cast<double const *>(cell); }

/// The output, or null if it was left out.
template <class Row> static double *optional(std::span<Row> rows) noexcept
{
    return rows.empty() ? nullptr : reinterpret_cast<double *>(rows.data());
}

/// Whether rows that may be left out are n.
template <class Row> static bool fits(std::size_t n, std::span<Row> rows) noexcept
{
    return rows.empty() || rows.size() == n;
}

static inline bool fits(std::size_t n, DerivativeSpans const &out) noexcept
{
    return fits(n, out.mu2) && fits(n, out.lambda) && fits(n, out.point) && fits(n, out.normal) && fits(n, out.d_r12) &&
           fits(n, out.d_rot1) && fits(n, out.d_rot2);
}

static inline bool fit(PairList const &list, Particles const &particles) noexcept
{
    return fits(list.pairs.size(), list.images) && particles.centers.size() == particles.q.size();
}

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
    constexpr std::size_t block = 16; // 2 KiB of stack
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

static inline Status contact_batch(FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double> mu2,
                                   std::span<double> lambda) noexcept
{
    std::size_t const n = mu2.size();
    if (r12.size() != n || q1.size() != n || q2.size() != n || !detail::fits(n, lambda))
        return Status::invalid_argument;
    return static_cast<Status>(pw85_contact_batch_2d(n, detail::numbers(r12), detail::numbers(q1), detail::numbers(q2),
                                                     mu2.data(), detail::optional(lambda)));
}

static inline Status overlap_batch(FlatVectors r12, FlatForms q1, FlatForms q2,
                                   std::span<unsigned char> overlap) noexcept
{
    std::size_t const n = overlap.size();
    if (r12.size() != n || q1.size() != n || q2.size() != n) return Status::invalid_argument;
    return static_cast<Status>(
        pw85_overlap_batch_2d(n, detail::numbers(r12), detail::numbers(q1), detail::numbers(q2), overlap.data()));
}

static inline Status closest_approach_batch(Vectors directions, Forms q1, Forms q2, std::span<double> distance) noexcept
{
    std::size_t const n = distance.size();
    if (directions.size() != n || q1.size() != n || q2.size() != n) return Status::invalid_argument;
    return static_cast<Status>(pw85_closest_approach_batch(n, detail::numbers(directions), detail::numbers(q1),
                                                           detail::numbers(q2), distance.data()));
}

static inline Status contact_derivatives_batch(Vectors r12, Forms q1, Forms q2, DerivativeSpans const &out) noexcept
{
    std::size_t const n = r12.size();
    if (q1.size() != n || q2.size() != n || !detail::fits(n, out)) return Status::invalid_argument;
    return static_cast<Status>(pw85_contact_derivatives_batch(
        n, detail::numbers(r12), detail::numbers(q1), detail::numbers(q2), detail::optional(out.mu2),
        detail::optional(out.lambda), detail::optional(out.point), detail::optional(out.normal),
        detail::optional(out.d_r12), detail::optional(out.d_rot1), detail::optional(out.d_rot2)));
}

static inline Status overlap_any(SymmetricMatrix<double, 3> const &q1, Vectors r12, Forms q2, int &any) noexcept
{
    any = -1;
    if (r12.size() != q2.size()) return Status::invalid_argument;
    return static_cast<Status>(
        pw85_overlap_any(r12.size(), q1.entries, detail::numbers(r12), detail::numbers(q2), &any));
}

static inline Status contact_pairs(PairList const &list, Particles const &particles, std::span<double> mu2,
                                   std::span<double> lambda) noexcept
{
    std::size_t const n = list.pairs.size();
    if (mu2.size() != n || !detail::fits(n, lambda) || !detail::fit(list, particles)) return Status::invalid_argument;
    return static_cast<Status>(pw85_contact_pairs(n, detail::integers(list.pairs), detail::integers(list.images),
                                                  particles.centers.size(), detail::numbers(particles.centers),
                                                  detail::numbers(particles.q), detail::numbers(particles.cell),
                                                  mu2.data(), detail::optional(lambda)));
}

static inline Status overlap_pairs(PairList const &list, Particles const &particles,
                                   std::span<unsigned char> overlap) noexcept
{
    std::size_t const n = list.pairs.size();
    if (overlap.size() != n || !detail::fit(list, particles)) return Status::invalid_argument;
    return static_cast<Status>(pw85_overlap_pairs(n, detail::integers(list.pairs), detail::integers(list.images),
                                                  particles.centers.size(), detail::numbers(particles.centers),
                                                  detail::numbers(particles.q), detail::numbers(particles.cell),
                                                  overlap.data()));
}

static inline Status contact_derivatives_pairs(PairList const &list, Particles const &particles,
                                               DerivativeSpans const &out) noexcept
{
    std::size_t const n = list.pairs.size();
    if (!detail::fits(n, out) || !detail::fit(list, particles)) return Status::invalid_argument;
    return static_cast<Status>(pw85_contact_derivatives_pairs(
        n, detail::integers(list.pairs), detail::integers(list.images), particles.centers.size(),
        detail::numbers(particles.centers), detail::numbers(particles.q), detail::numbers(particles.cell),
        detail::optional(out.mu2), detail::optional(out.lambda), detail::optional(out.point),
        detail::optional(out.normal), detail::optional(out.d_r12), detail::optional(out.d_rot1),
        detail::optional(out.d_rot2)));
}

static inline Status first_contact_pairs(PairList const &list, Particles const &particles,
                                         std::span<Motion<double, 3> const> motions, double end,
                                         EventSpans const &out) noexcept
{
    static_assert(sizeof(Motion<double, 3>) == sizeof(pw85_motion));
    std::size_t const n = list.pairs.size(), num_particles = particles.centers.size();
    if (out.time.size() != n || motions.size() != num_particles || !detail::fits(num_particles, out.next) ||
        !detail::fits(num_particles, out.next_pair) || !detail::fit(list, particles))
        return Status::invalid_argument;
    return static_cast<Status>(pw85_first_contact_pairs(
        n, detail::integers(list.pairs), detail::integers(list.images), num_particles,
        detail::numbers(particles.centers), detail::numbers(particles.q), detail::numbers(particles.cell),
        reinterpret_cast<pw85_motion const *>(motions.data()), end, out.time.data(),
        out.next.empty() ? nullptr : out.next.data(), out.next_pair.empty() ? nullptr : out.next_pair.data()));
}

static inline ReducedCell cell_reduce(Cell const &cell) noexcept
{
    ReducedCell result;
    result.status =
        static_cast<Status>(pw85_cell_reduce(detail::numbers(&cell), reinterpret_cast<double *>(&result.cell)));
    return result;
}

static inline Status nearest_images(std::span<IndexPair const> pairs, Vectors centers, Cell const &cell,
                                    std::span<Vector<double, 3>> r12, std::span<Image> images) noexcept
{
    std::size_t const n = pairs.size();
    if (!detail::fits(n, r12) || !detail::fits(n, images)) return Status::invalid_argument;
    return static_cast<Status>(pw85_nearest_images(n, detail::integers(pairs), centers.size(), detail::numbers(centers),
                                                   detail::numbers(&cell), detail::optional(r12),
                                                   images.empty() ? nullptr : images.data()->data()));
}

static inline Status nearest_image_limit(Forms q, Cell const &cell, double &mu2) noexcept
{
    return static_cast<Status>(pw85_nearest_image_limit(q.size(), detail::numbers(q), detail::numbers(&cell), &mu2));
}

static inline Status ellipsoid_quaternion_batch(Vectors semi_axes, std::span<Vector<double, 4> const> quaternions,
                                                std::span<SymmetricMatrix<double, 3>> q) noexcept
{
    std::size_t const n = q.size();
    if (semi_axes.size() != n || quaternions.size() != n) return Status::invalid_argument;
    return static_cast<Status>(pw85_ellipsoid_quaternion_batch(n, detail::numbers(semi_axes),
                                                               detail::numbers(quaternions), detail::optional(q)));
}

static inline Status bounding_boxes(Forms q, std::span<Vector<double, 3>> half_widths) noexcept
{
    std::size_t const n = half_widths.size();
    if (q.size() != n) return Status::invalid_argument;
    return static_cast<Status>(pw85_bounding_boxes(n, detail::numbers(q), detail::optional(half_widths)));
}

static inline Status overlap_any_indices(Vector<double, 3> const &center, SymmetricMatrix<double, 3> const &q1,
                                         std::span<std::int32_t const> indices, Particles const &particles,
                                         int &any) noexcept
{
    any = -1;
    if (particles.centers.size() != particles.q.size()) return Status::invalid_argument;
    return static_cast<Status>(pw85_overlap_any_indices(
        center.coordinates, q1.entries, indices.size(), indices.data(), particles.centers.size(),
        detail::numbers(particles.centers), detail::numbers(particles.q), detail::numbers(particles.cell), &any));
}

static inline Status contact_forces_pairs(PairList const &list, Particles const &particles, std::span<double const> d_u,
                                          DerivativeSpans const &derivatives, ForceSpans const &out) noexcept
{
    std::size_t const n = list.pairs.size(), num_particles = particles.centers.size();
    if (d_u.size() != n || !detail::fits(n, derivatives) || !detail::fits(n, list.images) ||
        !detail::fits(num_particles, out.forces) || !detail::fits(num_particles, out.torques))
        return Status::invalid_argument;
    return static_cast<Status>(pw85_contact_forces_pairs(
        n, detail::integers(list.pairs), detail::integers(list.images), num_particles,
        detail::numbers(particles.centers), detail::numbers(particles.cell), d_u.data(),
        detail::optional(derivatives.d_r12), detail::optional(derivatives.d_rot1), detail::optional(derivatives.d_rot2),
        detail::optional(out.forces), detail::optional(out.torques), reinterpret_cast<double *>(out.virial)));
}

} // namespace pw85

#endif

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

#include <pw85/algebra/symmetric.hpp>
#include <pw85/motion/first_contact.hpp>
#include <pw85/status.hpp>

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
    std::array<int, 3> periodic = {1, 1, 1}; ///< along which vectors of the cell there are images
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

/// contains() for pairs: see pw85_contains_batch().
///
/// @param r12,q1,q2 as for contact_batch()
/// @param[out] contains one for each pair: 1, 0, or 255 for a bad one
/// @return as for contact_batch()
static inline Status contains_batch(Vectors r12, Forms q1, Forms q2, std::span<unsigned char> contains) noexcept;

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

/// Brent's method for pairs: see pw85_contact_function_batch().
///
/// @param r12,q1,q2 one row for each
/// @param[out] mu2,lambda one row for each, or empty
/// @return as for contact_batch()
static inline Status contact_function_batch(Vectors r12, Forms q1, Forms q2, std::span<double> mu2,
                                            std::span<double> lambda = {}) noexcept;

/// contact_geometry() for pairs: see pw85_contact_geometry_batch().
///
/// @param r12,q1,q2,lambda one row for each
/// @param[out] point,normal one row for each, or empty
/// @return as for contact_batch()
static inline Status contact_geometry_batch(Vectors r12, Forms q1, Forms q2, std::span<double const> lambda,
                                            std::span<Vector<double, 3>> point,
                                            std::span<Vector<double, 3>> normal = {}) noexcept;

/// contact_gradient() for pairs: see pw85_contact_gradient_batch().
///
/// @param r12,q1,q2,lambda one row for each
/// @param[out] d_r12,d_q1,d_q2 one row for each, or empty
/// @return as for contact_batch()
static inline Status contact_gradient_batch(Vectors r12, Forms q1, Forms q2, std::span<double const> lambda,
                                            std::span<Vector<double, 3>> d_r12,
                                            std::span<SymmetricMatrix<double, 3>> d_q1 = {},
                                            std::span<SymmetricMatrix<double, 3>> d_q2 = {}) noexcept;

/// contact_torque() for pairs: see pw85_contact_torque_batch().
///
/// @param r12,q1,q2,lambda one row for each
/// @param[out] d_rot1,d_rot2 one row for each, or empty
/// @return as for contact_batch()
static inline Status contact_torque_batch(Vectors r12, Forms q1, Forms q2, std::span<double const> lambda,
                                          std::span<Vector<double, 3>> d_rot1,
                                          std::span<Vector<double, 3>> d_rot2 = {}) noexcept;

/// contact_hessian() for pairs: see pw85_contact_hessian_batch().
///
/// @param r12,q1,q2,lambda one row for each
/// @param[out] hessian one row for each
/// @return as for contact_batch()
static inline Status contact_hessian_batch(Vectors r12, Forms q1, Forms q2, std::span<double const> lambda,
                                           std::span<std::array<double, 81>> hessian) noexcept;

/// contact_geometry() for pairs of ellipses: see pw85_contact_geometry_batch_2d().
///
/// @param r12,q1,q2,lambda one row for each
/// @param[out] point,normal one row for each, or empty
/// @return as for contact_batch()
static inline Status contact_geometry_batch(FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double const> lambda,
                                            std::span<Vector<double, 2>> point,
                                            std::span<Vector<double, 2>> normal = {}) noexcept;

/// contact_gradient() for pairs of ellipses: see pw85_contact_gradient_batch_2d().
///
/// @param r12,q1,q2,lambda one row for each
/// @param[out] d_r12,d_q1,d_q2 one row for each, or empty
/// @return as for contact_batch()
static inline Status contact_gradient_batch(FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double const> lambda,
                                            std::span<Vector<double, 2>> d_r12,
                                            std::span<SymmetricMatrix<double, 2>> d_q1 = {},
                                            std::span<SymmetricMatrix<double, 2>> d_q2 = {}) noexcept;

/// contact_torque() for pairs of ellipses: see pw85_contact_torque_batch_2d().
///
/// @param r12,q1,q2,lambda one row for each
/// @param[out] d_rot1,d_rot2 one row for each, or empty
/// @return as for contact_batch()
static inline Status contact_torque_batch(FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double const> lambda,
                                          std::span<double> d_rot1, std::span<double> d_rot2 = {}) noexcept;

/// contact_hessian() for pairs of ellipses: see pw85_contact_hessian_batch_2d().
///
/// @param r12,q1,q2,lambda one row for each
/// @param[out] hessian one row for each
/// @return as for contact_batch()
static inline Status contact_hessian_batch(FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double const> lambda,
                                           std::span<std::array<double, 16>> hessian) noexcept;

/// closest_approach() for pairs of ellipses: see pw85_closest_approach_batch_2d().
///
/// @param directions,q1,q2 one row for each
/// @param[out] distance one row for each
/// @return as for contact_batch()
static inline Status closest_approach_batch(FlatVectors directions, FlatForms q1, FlatForms q2,
                                            std::span<double> distance) noexcept;

/// distance() for pairs: see pw85_distance_batch().
///
/// @param r12,q1,q2 one row for each
/// @param[out] distance,point1,point2 one row for each, or empty
/// @return as for contact_batch()
static inline Status distance_batch(Vectors r12, Forms q1, Forms q2, std::span<double> distance,
                                    std::span<Vector<double, 3>> point1 = {},
                                    std::span<Vector<double, 3>> point2 = {}) noexcept;

/// distance_derivatives() for pairs: see pw85_distance_derivatives_batch().
///
/// @param r12,q1,q2 one row for each
/// @param[out] d_r12,d_rot1,d_rot2,hessian one row for each, or empty
/// @return as for contact_batch()
static inline Status distance_derivatives_batch(Vectors r12, Forms q1, Forms q2, std::span<Vector<double, 3>> d_r12,
                                                std::span<Vector<double, 3>> d_rot1 = {},
                                                std::span<Vector<double, 3>> d_rot2 = {},
                                                std::span<std::array<double, 81>> hessian = {}) noexcept;

/// distance() for pairs of ellipses: see pw85_distance_batch_2d().
///
/// @param r12,q1,q2 one row for each
/// @param[out] distance,point1,point2 one row for each, or empty
/// @return as for contact_batch()
static inline Status distance_batch(FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double> distance,
                                    std::span<Vector<double, 2>> point1 = {},
                                    std::span<Vector<double, 2>> point2 = {}) noexcept;

/// penetration() for pairs: see pw85_penetration_batch().
///
/// @param r12,q1,q2 one row for each
/// @param[out] depth,direction one row for each, or empty
/// @return as for contact_batch(); Status::no_convergence, too
static inline Status penetration_batch(Vectors r12, Forms q1, Forms q2, std::span<double> depth,
                                       std::span<Vector<double, 3>> direction = {}) noexcept;

/// distance_plane() for ellipsoids and half-spaces: see pw85_distance_plane_batch().
///
/// @param normals,offsets,q one row for each
/// @param[out] distance,point one row for each, or empty
/// @return as for contact_batch()
static inline Status distance_plane_batch(Vectors normals, std::span<double const> offsets, Forms q,
                                          std::span<double> distance, std::span<Vector<double, 3>> point = {}) noexcept;

/// distance_plane_derivatives() for ellipsoids and half-spaces: see pw85_distance_plane_derivatives_batch().
///
/// @param normals,q one row for each
/// @param[out] d_center,d_rot one row for each, or empty
/// @return as for contact_batch()
static inline Status distance_plane_derivatives_batch(Vectors normals, Forms q, std::span<Vector<double, 3>> d_center,
                                                      std::span<Vector<double, 3>> d_rot = {}) noexcept;

/// contact_plane() for ellipsoids and half-spaces: see pw85_contact_plane_batch().
///
/// @param normals,offsets,q one row for each
/// @param[out] mu2,point one row for each, or empty
/// @return as for contact_batch()
static inline Status contact_plane_batch(Vectors normals, std::span<double const> offsets, Forms q,
                                         std::span<double> mu2, std::span<Vector<double, 3>> point = {}) noexcept;

/// contact_plane_derivatives() for ellipsoids and half-spaces: see pw85_contact_plane_derivatives_batch().
///
/// @param normals,offsets,q one row for each
/// @param[out] d_center,d_rot one row for each, or empty
/// @return as for contact_batch()
static inline Status contact_plane_derivatives_batch(Vectors normals, std::span<double const> offsets, Forms q,
                                                     std::span<Vector<double, 3>> d_center,
                                                     std::span<Vector<double, 3>> d_rot = {}) noexcept;

/// distance_box() for ellipsoids and boxes: see pw85_distance_box_batch().
///
/// @param lower,upper,q one row for each
/// @param[out] distance,point,normal one row for each, or empty
/// @return as for contact_batch()
static inline Status distance_box_batch(Vectors lower, Vectors upper, Forms q, std::span<double> distance,
                                        std::span<Vector<double, 3>> point = {},
                                        std::span<Vector<double, 3>> normal = {}) noexcept;

/// distance_cylinder() for ellipsoids and cylinders: see pw85_distance_cylinder_batch().
///
/// @param axis,radius,center,q one row for each
/// @param[out] distance,point,normal one row for each, or empty
/// @return as for contact_batch()
static inline Status distance_cylinder_batch(Vectors axis, std::span<double const> radius, Vectors center, Forms q,
                                             std::span<double> distance, std::span<Vector<double, 3>> point = {},
                                             std::span<Vector<double, 3>> normal = {}) noexcept;

/// distance_point() for points and ellipsoids: see pw85_distance_point_batch().
///
/// @param r,q one row for each
/// @param[out] distance,point,normal one row for each, or empty
/// @return as for contact_batch()
static inline Status distance_point_batch(Vectors r, Forms q, std::span<double> distance,
                                          std::span<Vector<double, 3>> point = {},
                                          std::span<Vector<double, 3>> normal = {}) noexcept;

/// intersect_line() for lines and ellipsoids: see pw85_intersect_line_batch().
///
/// @param origin,directions,q one row for each
/// @param[out] enter,leave one row for each, or empty
/// @return as for contact_batch()
static inline Status intersect_line_batch(Vectors origin, Vectors directions, Forms q, std::span<double> enter,
                                          std::span<double> leave = {}) noexcept;

/// first_contact() for pairs: see pw85_first_contact_batch().
///
/// @param r12,q1,q2,motion1,motion2 one row for each
/// @param t_max as for first_contact()
/// @param[out] t one row for each
/// @return as for contact_batch(); Status::no_convergence, too
static inline Status first_contact_batch(Vectors r12, Forms q1, Forms q2, std::span<Motion<double, 3> const> motion1,
                                         std::span<Motion<double, 3> const> motion2, double t_max,
                                         std::span<double> t) noexcept;

/// Whether an ellipsoid overlaps any of others. Looks at these up to the first that overlaps or is bad.
///
/// @param q1 form of the one
/// @param r12,q2 centres of the others relative to that of the one, and their forms
/// @param[out] any 1 or 0; -1 on error
/// @return Status::success, Status::invalid_argument, or the status of the first bad pair if no pair before it
/// overlaps
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
/// @param pairs indices of particles
/// @param particles centres and cell; forms may be left out
/// @param[out] r12 from the first to the image of the second, one for each pair, or none
/// @param[out] images multiples of the vectors of the cell, one row for each pair, or none
/// @return Status::success, or Status::invalid_argument, also for the first bad pair, whose rows are NaN and INT32_MIN
static inline Status nearest_images(std::span<IndexPair const> pairs, Particles const &particles,
                                    std::span<Vector<double, 3>> r12, std::span<Image> images = {}) noexcept;

/// Up to which μ² nearest images are all there is: see pw85_nearest_image_limit().
///
/// @param particles forms and cell; centres may be left out. Infinity is the limit of no particles.
/// @param[out] mu2 the limit
/// @return Status::success, Status::invalid_argument (also a cell that is singular or not finite),
/// Status::not_positive_definite
static inline Status nearest_image_limit(Particles const &particles, double &mu2) noexcept;

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
/// @return as for overlap_any(); Status::invalid_argument, too, where nearest images do not decide
static inline Status overlap_any_indices(Vector<double, 3> const &center, SymmetricMatrix<double, 3> const &q1,
                                         std::span<std::int32_t const> indices, Particles const &particles,
                                         int &any) noexcept;

/// The same for given images of the others: see pw85_overlap_any_indices().
///
/// @param center,q1 centre and form of the one
/// @param indices of the others
/// @param images one for each of the others; none if there are none
/// @param particles the system, in a cell
/// @param[out] any 1, 0, or -1 on error
/// @return Status::success, Status::invalid_argument, Status::not_positive_definite
static inline Status overlap_any_indices(Vector<double, 3> const &center, SymmetricMatrix<double, 3> const &q1,
                                         std::span<std::int32_t const> indices, std::span<Image const> images,
                                         Particles const &particles, int &any) noexcept;

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

/// What rows consist of in C.
template <class Row> struct ElementOf {
    using Type = double;
};
template <> struct ElementOf<unsigned char> {
    using Type = unsigned char;
};
template <> struct ElementOf<Motion<double, 3>> {
    static_assert(sizeof(Motion<double, 3>) == sizeof(pw85_motion));
    using Type = pw85_motion;
};

// Arguments of functions of n rows: inputs have n rows, outputs n or none, which are null in C.

template <class Row> static bool has_rows(std::size_t n, std::span<Row const> input) noexcept
{
    return input.size() == n;
}

template <class Row> static bool has_rows(std::size_t n, std::span<Row> output) noexcept { return fits(n, output); }

static inline bool has_rows(std::size_t, double) noexcept { return true; }

template <class Row> static auto in_c(std::span<Row const> input) noexcept
{
    return reinterpret_cast<typename ElementOf<Row>::Type const *>(input.data());
}

template <class Row> static auto in_c(std::span<Row> output) noexcept
{
    return output.empty() ? nullptr : reinterpret_cast<typename ElementOf<Row>::Type *>(output.data());
}

static inline double in_c(double number) noexcept { return number; }

/// Calls a function of C if the sizes of all rows fit to that of the first.
template <class Function, class First, class... Rest>
static Status call_rows(Function const &function, First first, Rest... rest) noexcept
{
    std::size_t const n = first.size();
    if (!(has_rows(n, rest) && ...)) return Status::invalid_argument;
    return static_cast<Status>(function(n, in_c(first), in_c(rest)...));
}

static inline pw85_pair_list c_struct(PairList const &list) noexcept
{
    return {list.pairs.size(), integers(list.pairs), integers(list.images)};
}

/// Of as many particles as there are centres, or forms where centres are left out.
static inline pw85_system c_struct(Particles const &particles) noexcept
{
    return {std::max(particles.centers.size(), particles.q.size()),
            numbers(particles.centers),
            numbers(particles.q),
            numbers(particles.cell),
            {particles.periodic[0], particles.periodic[1], particles.periodic[2]}};
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
    return detail::call_rows(pw85_contact_batch, r12, q1, q2, mu2, lambda);
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
    return detail::call_rows(pw85_overlap_batch, r12, q1, q2, overlap);
}

static inline Status contains_batch(Vectors r12, Forms q1, Forms q2, std::span<unsigned char> contains) noexcept
{
    return detail::call_rows(pw85_contains_batch, r12, q1, q2, contains);
}

static inline Status contact_batch(FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double> mu2,
                                   std::span<double> lambda) noexcept
{
    return detail::call_rows(pw85_contact_batch_2d, r12, q1, q2, mu2, lambda);
}

static inline Status overlap_batch(FlatVectors r12, FlatForms q1, FlatForms q2,
                                   std::span<unsigned char> overlap) noexcept
{
    return detail::call_rows(pw85_overlap_batch_2d, r12, q1, q2, overlap);
}

static inline Status closest_approach_batch(Vectors directions, Forms q1, Forms q2, std::span<double> distance) noexcept
{
    return detail::call_rows(pw85_closest_approach_batch, directions, q1, q2, distance);
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
        pw85_overlap_any(q1.entries, r12.size(), detail::numbers(r12), detail::numbers(q2), &any));
}

static inline Status contact_pairs(PairList const &list, Particles const &particles, std::span<double> mu2,
                                   std::span<double> lambda) noexcept
{
    std::size_t const n = list.pairs.size();
    if (mu2.size() != n || !detail::fits(n, lambda) || !detail::fit(list, particles)) return Status::invalid_argument;
    pw85_pair_list const c_list = detail::c_struct(list);
    pw85_system const system = detail::c_struct(particles);
    return static_cast<Status>(pw85_contact_pairs(&c_list, &system, mu2.data(), detail::optional(lambda)));
}

static inline Status overlap_pairs(PairList const &list, Particles const &particles,
                                   std::span<unsigned char> overlap) noexcept
{
    std::size_t const n = list.pairs.size();
    if (overlap.size() != n || !detail::fit(list, particles)) return Status::invalid_argument;
    pw85_pair_list const c_list = detail::c_struct(list);
    pw85_system const system = detail::c_struct(particles);
    return static_cast<Status>(pw85_overlap_pairs(&c_list, &system, overlap.data()));
}

static inline Status contact_derivatives_pairs(PairList const &list, Particles const &particles,
                                               DerivativeSpans const &out) noexcept
{
    std::size_t const n = list.pairs.size();
    if (!detail::fits(n, out) || !detail::fit(list, particles)) return Status::invalid_argument;
    pw85_pair_list const c_list = detail::c_struct(list);
    pw85_system const system = detail::c_struct(particles);
    return static_cast<Status>(pw85_contact_derivatives_pairs(
        &c_list, &system, detail::optional(out.mu2), detail::optional(out.lambda), detail::optional(out.point),
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
    pw85_pair_list const c_list = detail::c_struct(list);
    pw85_system const system = detail::c_struct(particles);
    return static_cast<Status>(pw85_first_contact_pairs(
        &c_list, &system, reinterpret_cast<pw85_motion const *>(motions.data()), end, out.time.data(),
        out.next.empty() ? nullptr : out.next.data(), out.next_pair.empty() ? nullptr : out.next_pair.data()));
}

static inline ReducedCell cell_reduce(Cell const &cell) noexcept
{
    ReducedCell result;
    result.status =
        static_cast<Status>(pw85_cell_reduce(detail::numbers(&cell), reinterpret_cast<double *>(&result.cell)));
    return result;
}

static inline Status nearest_images(std::span<IndexPair const> pairs, Particles const &particles,
                                    std::span<Vector<double, 3>> r12, std::span<Image> images) noexcept
{
    std::size_t const n = pairs.size();
    if (!detail::fits(n, r12) || !detail::fits(n, images) || !detail::fits(particles.centers.size(), particles.q))
        return Status::invalid_argument;
    pw85_system const system = detail::c_struct(particles);
    return static_cast<Status>(pw85_nearest_images(n, detail::integers(pairs), &system, detail::optional(r12),
                                                   images.empty() ? nullptr : images.data()->data()));
}

static inline Status nearest_image_limit(Particles const &particles, double &mu2) noexcept
{
    mu2 = detail::quiet_nan<double>();
    if (!detail::fits(particles.q.size(), particles.centers)) return Status::invalid_argument;
    pw85_system const system = detail::c_struct(particles);
    return static_cast<Status>(pw85_nearest_image_limit(&system, &mu2));
}

static inline Status ellipsoid_quaternion_batch(Vectors semi_axes, std::span<Vector<double, 4> const> quaternions,
                                                std::span<SymmetricMatrix<double, 3>> q) noexcept
{
    return detail::call_rows(pw85_ellipsoid_quaternion_batch, semi_axes, quaternions, q);
}

static inline Status bounding_boxes(Forms q, std::span<Vector<double, 3>> half_widths) noexcept
{
    return detail::call_rows(pw85_bounding_boxes, q, half_widths);
}

static inline Status overlap_any_indices(Vector<double, 3> const &center, SymmetricMatrix<double, 3> const &q1,
                                         std::span<std::int32_t const> indices, Particles const &particles,
                                         int &any) noexcept
{
    any = -1;
    if (particles.centers.size() != particles.q.size()) return Status::invalid_argument;
    pw85_system const system = detail::c_struct(particles);
    return static_cast<Status>(pw85_overlap_any_indices(center.coordinates, q1.entries, &system, indices.size(),
                                                        indices.data(), nullptr, &any));
}

static inline Status overlap_any_indices(Vector<double, 3> const &center, SymmetricMatrix<double, 3> const &q1,
                                         std::span<std::int32_t const> indices, std::span<Image const> images,
                                         Particles const &particles, int &any) noexcept
{
    any = -1;
    if (particles.centers.size() != particles.q.size() || images.size() != indices.size())
        return Status::invalid_argument;
    constexpr Image none{}; // null would ask for all images
    pw85_system const system = detail::c_struct(particles);
    return static_cast<Status>(pw85_overlap_any_indices(center.coordinates, q1.entries, &system, indices.size(),
                                                        indices.data(), images.empty() ? none.data() : images[0].data(),
                                                        &any));
}

static inline Status contact_forces_pairs(PairList const &list, Particles const &particles, std::span<double const> d_u,
                                          DerivativeSpans const &derivatives, ForceSpans const &out) noexcept
{
    std::size_t const n = list.pairs.size(), num_particles = particles.centers.size();
    if (d_u.size() != n || !detail::fits(n, derivatives) || !detail::fits(n, list.images) ||
        !detail::fits(num_particles, particles.q) || !detail::fits(num_particles, out.forces) ||
        !detail::fits(num_particles, out.torques))
        return Status::invalid_argument;
    pw85_pair_list const c_list = detail::c_struct(list);
    pw85_system const system = detail::c_struct(particles);
    return static_cast<Status>(pw85_contact_forces_pairs(
        &c_list, &system, d_u.data(), detail::optional(derivatives.d_r12), detail::optional(derivatives.d_rot1),
        detail::optional(derivatives.d_rot2), detail::optional(out.forces), detail::optional(out.torques),
        reinterpret_cast<double *>(out.virial)));
}

static inline Status contact_function_batch(Vectors r12, Forms q1, Forms q2, std::span<double> mu2,
                                            std::span<double> lambda) noexcept
{
    return detail::call_rows(pw85_contact_function_batch, r12, q1, q2, mu2, lambda);
}

static inline Status contact_geometry_batch(Vectors r12, Forms q1, Forms q2, std::span<double const> lambda,
                                            std::span<Vector<double, 3>> point,
                                            std::span<Vector<double, 3>> normal) noexcept
{
    return detail::call_rows(pw85_contact_geometry_batch, r12, q1, q2, lambda, point, normal);
}

static inline Status contact_gradient_batch(Vectors r12, Forms q1, Forms q2, std::span<double const> lambda,
                                            std::span<Vector<double, 3>> d_r12,
                                            std::span<SymmetricMatrix<double, 3>> d_q1,
                                            std::span<SymmetricMatrix<double, 3>> d_q2) noexcept
{
    return detail::call_rows(pw85_contact_gradient_batch, r12, q1, q2, lambda, d_r12, d_q1, d_q2);
}

static inline Status contact_torque_batch(Vectors r12, Forms q1, Forms q2, std::span<double const> lambda,
                                          std::span<Vector<double, 3>> d_rot1,
                                          std::span<Vector<double, 3>> d_rot2) noexcept
{
    return detail::call_rows(pw85_contact_torque_batch, r12, q1, q2, lambda, d_rot1, d_rot2);
}

static inline Status contact_hessian_batch(Vectors r12, Forms q1, Forms q2, std::span<double const> lambda,
                                           std::span<std::array<double, 81>> hessian) noexcept
{
    return detail::call_rows(pw85_contact_hessian_batch, r12, q1, q2, lambda, hessian);
}

static inline Status contact_geometry_batch(FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double const> lambda,
                                            std::span<Vector<double, 2>> point,
                                            std::span<Vector<double, 2>> normal) noexcept
{
    return detail::call_rows(pw85_contact_geometry_batch_2d, r12, q1, q2, lambda, point, normal);
}

static inline Status contact_gradient_batch(FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double const> lambda,
                                            std::span<Vector<double, 2>> d_r12,
                                            std::span<SymmetricMatrix<double, 2>> d_q1,
                                            std::span<SymmetricMatrix<double, 2>> d_q2) noexcept
{
    return detail::call_rows(pw85_contact_gradient_batch_2d, r12, q1, q2, lambda, d_r12, d_q1, d_q2);
}

static inline Status contact_torque_batch(FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double const> lambda,
                                          std::span<double> d_rot1, std::span<double> d_rot2) noexcept
{
    return detail::call_rows(pw85_contact_torque_batch_2d, r12, q1, q2, lambda, d_rot1, d_rot2);
}

static inline Status contact_hessian_batch(FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double const> lambda,
                                           std::span<std::array<double, 16>> hessian) noexcept
{
    return detail::call_rows(pw85_contact_hessian_batch_2d, r12, q1, q2, lambda, hessian);
}

static inline Status closest_approach_batch(FlatVectors directions, FlatForms q1, FlatForms q2,
                                            std::span<double> distance) noexcept
{
    return detail::call_rows(pw85_closest_approach_batch_2d, directions, q1, q2, distance);
}

static inline Status distance_batch(Vectors r12, Forms q1, Forms q2, std::span<double> distance,
                                    std::span<Vector<double, 3>> point1, std::span<Vector<double, 3>> point2) noexcept
{
    return detail::call_rows(pw85_distance_batch, r12, q1, q2, distance, point1, point2);
}

static inline Status distance_derivatives_batch(Vectors r12, Forms q1, Forms q2, std::span<Vector<double, 3>> d_r12,
                                                std::span<Vector<double, 3>> d_rot1,
                                                std::span<Vector<double, 3>> d_rot2,
                                                std::span<std::array<double, 81>> hessian) noexcept
{
    return detail::call_rows(pw85_distance_derivatives_batch, r12, q1, q2, d_r12, d_rot1, d_rot2, hessian);
}

static inline Status distance_batch(FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double> distance,
                                    std::span<Vector<double, 2>> point1, std::span<Vector<double, 2>> point2) noexcept
{
    return detail::call_rows(pw85_distance_batch_2d, r12, q1, q2, distance, point1, point2);
}

static inline Status penetration_batch(Vectors r12, Forms q1, Forms q2, std::span<double> depth,
                                       std::span<Vector<double, 3>> direction) noexcept
{
    return detail::call_rows(pw85_penetration_batch, r12, q1, q2, depth, direction);
}

static inline Status distance_plane_batch(Vectors normals, std::span<double const> offsets, Forms q,
                                          std::span<double> distance, std::span<Vector<double, 3>> point) noexcept
{
    return detail::call_rows(pw85_distance_plane_batch, normals, offsets, q, distance, point);
}

static inline Status distance_plane_derivatives_batch(Vectors normals, Forms q, std::span<Vector<double, 3>> d_center,
                                                      std::span<Vector<double, 3>> d_rot) noexcept
{
    return detail::call_rows(pw85_distance_plane_derivatives_batch, normals, q, d_center, d_rot);
}

static inline Status contact_plane_batch(Vectors normals, std::span<double const> offsets, Forms q,
                                         std::span<double> mu2, std::span<Vector<double, 3>> point) noexcept
{
    return detail::call_rows(pw85_contact_plane_batch, normals, offsets, q, mu2, point);
}

static inline Status contact_plane_derivatives_batch(Vectors normals, std::span<double const> offsets, Forms q,
                                                     std::span<Vector<double, 3>> d_center,
                                                     std::span<Vector<double, 3>> d_rot) noexcept
{
    return detail::call_rows(pw85_contact_plane_derivatives_batch, normals, offsets, q, d_center, d_rot);
}

static inline Status distance_box_batch(Vectors lower, Vectors upper, Forms q, std::span<double> distance,
                                        std::span<Vector<double, 3>> point,
                                        std::span<Vector<double, 3>> normal) noexcept
{
    return detail::call_rows(pw85_distance_box_batch, lower, upper, q, distance, point, normal);
}

static inline Status distance_cylinder_batch(Vectors axis, std::span<double const> radius, Vectors center, Forms q,
                                             std::span<double> distance, std::span<Vector<double, 3>> point,
                                             std::span<Vector<double, 3>> normal) noexcept
{
    return detail::call_rows(pw85_distance_cylinder_batch, axis, radius, center, q, distance, point, normal);
}

static inline Status distance_point_batch(Vectors r, Forms q, std::span<double> distance,
                                          std::span<Vector<double, 3>> point,
                                          std::span<Vector<double, 3>> normal) noexcept
{
    return detail::call_rows(pw85_distance_point_batch, r, q, distance, point, normal);
}

static inline Status intersect_line_batch(Vectors origin, Vectors directions, Forms q, std::span<double> enter,
                                          std::span<double> leave) noexcept
{
    return detail::call_rows(pw85_intersect_line_batch, origin, directions, q, enter, leave);
}

static inline Status first_contact_batch(Vectors r12, Forms q1, Forms q2, std::span<Motion<double, 3> const> motion1,
                                         std::span<Motion<double, 3> const> motion2, double t_max,
                                         std::span<double> t) noexcept
{
    return detail::call_rows(pw85_first_contact_batch, r12, q1, q2, motion1, motion2, t_max, t);
}

} // namespace pw85

#endif

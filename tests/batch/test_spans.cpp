// SPDX-License-Identifier: BSD-3-Clause
// The functions of many rows with std::span give the same numbers and status as the functions of C.
// Sizes that do not match are errors.
#include <tuple>

#include <glib.h>

#include <pw85/batch.hpp>
#include <pw85/systems.hpp>

#include "../cases.hpp"
#include "batch_data.hpp"

using namespace pw85_tests;

namespace {

using Numbers = std::vector<double>;
using Vectors3 = std::vector<pw85::Vector<double, 3>>;
using Forms3 = std::vector<pw85::SymmetricMatrix<double, 3>>;
using Vectors2 = std::vector<pw85::Vector<double, 2>>;
using Forms2 = std::vector<pw85::SymmetricMatrix<double, 2>>;
using Motions = std::vector<pw85::Motion<double, 3>>;
using Codes = std::vector<unsigned char>;
using Signs = std::vector<int>;
template <std::size_t size> using Matrices = std::vector<std::array<double, size>>;

/// Inputs of any function: a few pairs of each kind, bad ones among them.
struct Inputs {
    static constexpr std::size_t n = 40;
    Vectors3 r, upper;
    Forms3 q1, q2;
    Vectors2 flat_r;
    Forms2 flat_q1, flat_q2;
    Numbers lambda, ones;
    Motions motion;

    explicit Inputs(Random &random)
        : upper(n, {1e3, 1e3, 1e3}), flat_r(n), flat_q1(n), flat_q2(n), lambda(n), ones(n, 1.0),
          motion(n)
    {
        for (std::size_t i = 0; i < n; ++i) {
            Pair3 const pair = mixed_pair(random);
            r.push_back(pair.r12);
            q1.push_back(pair.q1);
            q2.push_back(pair.q2);
            std::memcpy(&flat_r[i], &r[i], sizeof flat_r[i]);
            std::memcpy(&flat_q1[i], &q1[i][3], sizeof flat_q1[i]);
            std::memcpy(&flat_q2[i], &q2[i][3], sizeof flat_q2[i]);
            lambda[i] = random.uniform(0.0, 1.1);
            motion[i] = {pair.r12, {0.1, 0.2, 0.3}, 0.0};
        }
    }

    auto pairs() const { return std::tie(r, q1, q2); }
    auto with_lambda() const { return std::tie(r, q1, q2, lambda); }
    auto flat() const { return std::tie(flat_r, flat_q1, flat_q2); }
    auto flat_with_lambda() const { return std::tie(flat_r, flat_q1, flat_q2, lambda); }
};

template <class Row> auto raw(std::vector<Row> const &rows)
{
    return reinterpret_cast<double const *>(rows.data());
}
template <class Row> auto raw(std::vector<Row> &rows)
{
    return reinterpret_cast<double *>(rows.data());
}
auto raw(Motions const &rows) { return reinterpret_cast<pw85_motion const *>(rows.data()); }
unsigned char *raw(Codes &rows) { return rows.data(); }
int *raw(Signs &rows) { return rows.data(); }
double raw(double number) { return number; }

template <class Row> bool are_same(std::vector<Row> const &x, std::vector<Row> const &y)
{
    return std::memcmp(x.data(), y.data(), x.size() * sizeof(Row)) == 0;
}

/// Calls a function by spans and that of C, and a second time with an output that is too short.
template <class Spans, class C, class In, class First, class... Out>
void compare(Spans const &spans, C const &c, In const &in, First first, Out... out)
{
    std::apply(
        [&](auto const &...input) {
            std::tuple<First, Out...> expected{first, out...};
            int const status = std::apply(
                [&](auto &...array) { return c(Inputs::n, raw(input)..., raw(array)...); },
                expected);
            g_assert_cmpint(static_cast<int>(spans(input..., first, out...)), ==, status);
            g_assert_true(std::apply(
                [&](auto const &e, auto const &...es) {
                    return are_same(first, e) && (are_same(out, es) && ...);
                },
                expected));
            first.pop_back();
            g_assert_true(spans(input..., first, out...) == pw85::Status::invalid_argument);
        },
        in);
}

/// The overloads of a function of C++ as one object.
#define SPANS(name) [](auto &&...rows) { return pw85::name(rows...); }

PW85_TEST("/spans/pairs")
{
    Random random(70);
    constexpr std::size_t n = Inputs::n;
    Inputs const in(random);
    Vectors3 const vectors(n);
    Forms3 const forms(n);
    Numbers const numbers(n);
    Matrices<81> const matrices(n);
    compare(SPANS(contact_batch), pw85_contact_batch, in.pairs(), numbers, numbers);
    compare(SPANS(contact_function_batch), pw85_contact_function_batch, in.pairs(), numbers,
            numbers);
    compare(SPANS(closest_approach_batch), pw85_closest_approach_batch, in.pairs(), numbers);
    compare(SPANS(contact_geometry_batch), pw85_contact_geometry_batch, in.with_lambda(), vectors,
            vectors);
    compare(SPANS(contact_gradient_batch), pw85_contact_gradient_batch, in.with_lambda(), vectors,
            forms, forms);
    compare(SPANS(contact_torque_batch), pw85_contact_torque_batch, in.with_lambda(), vectors,
            vectors);
    compare(SPANS(contact_hessian_batch), pw85_contact_hessian_batch, in.with_lambda(), matrices);
    compare(SPANS(distance_batch), pw85_distance_batch, in.pairs(), numbers, vectors, vectors);
    compare(SPANS(distance_derivatives_batch), pw85_distance_derivatives_batch, in.pairs(), vectors,
            vectors, vectors, matrices);
    compare(SPANS(penetration_batch), pw85_penetration_batch, in.pairs(), numbers, vectors);
    compare(SPANS(overlap_witness_batch), pw85_overlap_witness_batch, in.pairs(), Codes(n), numbers,
            vectors);
    compare(SPANS(compare_batch), pw85_compare_batch, std::tie(in.r, in.q1, in.q2, in.ones),
            Signs(n));
    compare(SPANS(contains_batch), pw85_contains_batch, in.pairs(), Codes(n));
    double const end = 2.0;
    compare(SPANS(first_contact_batch), pw85_first_contact_batch,
            std::tie(in.r, in.q1, in.q2, in.motion, in.motion, end), numbers);
}

PW85_TEST("/spans/ellipses")
{
    Random random(71);
    constexpr std::size_t n = Inputs::n;
    Inputs const in(random);
    Vectors2 const vectors(n);
    Forms2 const forms(n);
    Numbers const numbers(n);
    compare(SPANS(contact_batch), pw85_contact_batch_2d, in.flat(), numbers, numbers);
    compare(SPANS(closest_approach_batch), pw85_closest_approach_batch_2d, in.flat(), numbers);
    compare(SPANS(contact_geometry_batch), pw85_contact_geometry_batch_2d, in.flat_with_lambda(),
            vectors, vectors);
    compare(SPANS(contact_gradient_batch), pw85_contact_gradient_batch_2d, in.flat_with_lambda(),
            vectors, forms, forms);
    compare(SPANS(contact_torque_batch), pw85_contact_torque_batch_2d, in.flat_with_lambda(),
            numbers, numbers);
    compare(SPANS(contact_hessian_batch), pw85_contact_hessian_batch_2d, in.flat_with_lambda(),
            Matrices<16>(n));
    compare(SPANS(distance_batch), pw85_distance_batch_2d, in.flat(), numbers, vectors, vectors);
    auto const points = std::tie(in.flat_r, in.flat_q1);
    compare(SPANS(distance_point_batch), pw85_distance_point_batch_2d, points, numbers, vectors,
            vectors);
    compare(SPANS(contact_segment_batch), pw85_contact_segment_batch_2d,
            std::tie(in.flat_r, in.flat_r, in.flat_q1), numbers, vectors);
}

PW85_TEST("/spans/walls")
{
    Random random(72);
    constexpr std::size_t n = Inputs::n;
    Inputs const in(random);
    Vectors3 const vectors(n);
    Numbers const numbers(n);
    auto const plane = std::tie(in.r, in.ones, in.q1);
    compare(SPANS(distance_plane_batch), pw85_distance_plane_batch, plane, numbers, vectors);
    compare(SPANS(distance_plane_derivatives_batch), pw85_distance_plane_derivatives_batch,
            std::tie(in.r, in.q1), vectors, vectors);
    compare(SPANS(contact_plane_batch), pw85_contact_plane_batch, plane, numbers, vectors);
    compare(SPANS(contact_plane_derivatives_batch), pw85_contact_plane_derivatives_batch, plane,
            vectors, vectors);
    compare(SPANS(distance_box_batch), pw85_distance_box_batch, std::tie(in.r, in.upper, in.q1),
            numbers, vectors, vectors);
    compare(SPANS(distance_segment_batch), pw85_distance_segment_batch,
            std::tie(in.r, in.upper, in.q1), numbers, vectors, vectors, vectors);
    compare(SPANS(distance_triangle_batch), pw85_distance_triangle_batch,
            std::tie(in.r, in.upper, in.r, in.q1), numbers, vectors, vectors, vectors);
    compare(SPANS(distance_solid_box_batch), pw85_distance_solid_box_batch,
            std::tie(in.r, in.upper, in.q1), numbers, vectors, vectors, vectors);
    auto const capsule = std::tie(in.r, in.upper, in.ones, in.q1);
    compare(SPANS(contact_capsule_batch), pw85_contact_capsule_batch, capsule, numbers, vectors);
    compare(SPANS(distance_capsule_batch), pw85_distance_capsule_batch, capsule, numbers, vectors,
            vectors, vectors);
    compare(SPANS(distance_cylinder_batch), pw85_distance_cylinder_batch,
            std::tie(in.r, in.ones, in.upper, in.q1), numbers, vectors, vectors);
    compare(SPANS(distance_point_batch), pw85_distance_point_batch, std::tie(in.r, in.q1), numbers,
            vectors, vectors);
    compare(SPANS(intersect_line_batch), pw85_intersect_line_batch, std::tie(in.upper, in.r, in.q1),
            numbers, numbers);
    compare(SPANS(bounding_boxes), pw85_bounding_boxes, std::tie(in.q1), vectors);
}

} // namespace

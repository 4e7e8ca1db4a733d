// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer target: raw bytes as doubles into every public function, by the table of them. A
// success must not come with a NaN in the outputs, an error must. Then what several functions say
// of the same pair must fit together.
#include <pw85.h>
#include <pw85_batch.h>
#include <pw85_systems.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <vector>

#include "../src/gpu/work.hpp"
#include "../tests/marks.hpp"
#include "../tests/rows_of_calls.hpp"
#include "../tests/systems.hpp"

using namespace pw85_tests;

namespace {

// The arguments of one pair.
struct Input {
    double r12[3], q1[6], q2[6], lambda, axes[3], rotation[9];
    std::uint8_t form, scale;
};

[[noreturn]] void fail(char const *function, Input const &in)
{
    std::fprintf(stderr, "%s\n", function);
    auto const *x = reinterpret_cast<double const *>(&in);
    for (std::size_t i = 0; i < offsetof(Input, form) / sizeof *x; ++i)
        std::fprintf(stderr, "%a\n", x[i]);
    __builtin_trap();
}

bool has_nan(double const *x, int n)
{
    return std::any_of(x, x + n, [](double y) { return std::isnan(y); });
}
bool all_nan(double const *x, int n)
{
    return std::all_of(x, x + n, [](double y) { return std::isnan(y); });
}

void check(char const *function, Input const &in, int status, double const *out, int n)
{
    if (status == PW85_SUCCESS ? has_nan(out, n) : !all_nan(out, n)) fail(function, in);
    // Memory is nothing that one row can lack, nor a device what the host does without.
    if (status < PW85_SUCCESS || status > PW85_ECONVERGENCE) fail(function, in);
}

bool contains(std::string const &text, char const *part)
{
    return text.find(part) != std::string::npos;
}

// Sums of forces and building blocks compute with what they get.
bool takes_anything(std::string const &function)
{
    return contains(function, "__") || function == "pw85_contact_forces_pairs" ||
           function == "pw85_legacy_contact_function2";
}

// What there is for some valid pairs only: points and derivatives of distances of pairs that are
// apart, directions of depths of those that overlap, points and normals of those that are not
// concentric and of gaps of contained ellipsoids, and where lines that meet their ellipsoids enter
// and leave.
bool may_be_absent(Call const &call, std::size_t k)
{
    std::string const function = call.function().name;
    return contains(function, "distance_derivatives") ||
           (contains(function, "distance_geometry") &&
            is_one_of(call.parameter(k).name, {"normal"})) ||
           is_one_of(call.parameter(k).name, {"point1", "point2"}) ||
           (contains(function, "penetration") &&
            is_one_of(call.parameter(k).name, {"direction"})) ||
           ((contains(function, "contact_derivatives") || contains(function, "gap_inside")) &&
            is_one_of(call.parameter(k).name, {"point", "normal"})) ||
           contains(function, "intersect_line") || contains(function, "witness");
}

// Whether the first row of an output has a mark where there is none on success.
bool has_mark(Call &call, std::size_t k)
{
    bool const can_be_marked = is_one_of(call.parameter(k).name, {"particle", "next_pair"});
    for (std::size_t i = 0; !can_be_marked && i < call.row_length(k); ++i)
        if (is_marked(call, k, i)) return true;
    return false;
}

// Arguments beside the pair: the other numbers, in turn. Neighbour lists keep theirs: with any
// scale or cell they may have too many images.
void set_others(Input const &in, Call &call)
{
    if (contains(call.function().name, "neighbors")) return;
    double const *const others = in.axes; // and the rotation behind them
    std::size_t next = 0;
    for (std::size_t k = 0; k < call.size(); ++k) {
        Parameter const &p = call.parameter(k);
        bool const of_pair =
            is_one_of(p.name, {"r12", "q1", "q2", "q", "second_moments", "centers", "lambda"});
        if (p.output || of_pair || !(p.type == Type::real || p.type == Type::motion)) continue;
        Numbers const x = numbers(call, k);
        for (std::size_t i = 0; i < x.size; ++i) x.begin[i] = others[next++ % 12];
    }
}

void check_outputs(Input const &in, Call &call, int status)
{
    char const *const name = call.function().name;
    // Memory is nothing that one row can lack, as a neighbour list can, nor a device what the host
    // does without.
    bool const may_lack_memory = status == PW85_ENOMEM && contains(name, "neighbors");
    if (!may_lack_memory && (status < PW85_SUCCESS || status > PW85_ECONVERGENCE)) fail(name, in);
    // An ellipsoid around points is valid also where its excess exceeds the tolerance.
    if (status == PW85_ECONVERGENCE && contains(name, "enclosing")) return;
    // What is wrong with all rows is found before anything is written.
    bool untouched = call.is_of_rows();
    for (std::size_t k = 0; k < call.size(); ++k)
        if (call.parameter(k).output && call.parameter(k).type != Type::handle)
            untouched = untouched && !call.all_written(k);
    if (status != PW85_SUCCESS && !untouched && !first_rows_marked(call)) fail(name, in);
    for (std::size_t k = 0; status == PW85_SUCCESS && k < call.size(); ++k)
        if (call.parameter(k).output && !may_be_absent(call, k) && has_mark(call, k))
            fail(name, in);
}

// A row is what the function of one row gives, to the last bit.
void check_row(Input const &in, Call &call, int status)
{
    Function const *const one = of_one_row(call.function());
    if (one == nullptr) return;
    OneRow const expected = call_one(*one, call, 0);
    if (status != expected.status) fail(call.function().name, in);
    bool const written = status == PW85_SUCCESS || first_rows_marked(call);
    if (written && !are_same(outputs_of(call, 0), expected.out)) fail(call.function().name, in);
}

void check_all(Input const &in)
{
    Sample<double, 3> pair{};
    std::memcpy(&pair.r12, in.r12, sizeof in.r12);
    std::memcpy(&pair.q1, in.q1, sizeof in.q1);
    std::memcpy(&pair.q2, in.q2, sizeof in.q2);
    double contact[2];
    bool const valid = pw85_contact(in.r12, in.q1, in.q2, contact) == PW85_SUCCESS;
    std::vector<Sample<double, 3>> const pairs = {pair};
    for (Function const &function : declared_functions()) {
        Call call(function, pairs, valid && in.scale % 2 == 1 ? contact[1] : in.lambda);
        set_others(in, call);
        int const status = call().status;
        if (!guards_intact(call)) fail(function.name, in);
        if (function.result != Result::status || takes_anything(function.name)) continue;
        check_outputs(in, call, status);
        check_row(in, call, status);
    }
    pw85_strerror(in.form);
}

// What the functions of a pair say of it fits together; where it is a scalar, it is in range.
void check_pair(Input const &in)
{
    double out[2];
    auto const *r = in.r12, *a = in.q1, *b = in.q2;
    int overlap = 7;
    int const status = pw85_contact(r, a, b, out);
    if (status == PW85_SUCCESS && !(out[0] >= 0 && out[1] >= 0 && out[1] <= 1))
        fail("contact: range", in);
    if (pw85_overlap(r, a, b, &overlap) != status) fail("overlap: status", in);
    if (status == PW85_SUCCESS ? overlap != 0 && overlap != 1 : overlap != -1) fail("overlap", in);
    unsigned char code = 7;
    int const batch_status = pw85_contact_batch(1, r, a, b, out, out + 1);
    if (pw85_overlap_batch(1, r, a, b, &code) != batch_status) fail("overlap_batch: status", in);
    if (batch_status == PW85_SUCCESS ? code > 1 : code != 255) fail("overlap_batch", in);
    int any = 7;
    if (pw85_overlap_any(a, 1, r, b, &any) != batch_status) fail("overlap_any: status", in);
    if (batch_status == PW85_SUCCESS ? any != 0 && any != 1 : any != -1) fail("overlap_any", in);
}

// What overlaps has a μ² below one.
void check_comparison(Input const &in)
{
    int overlap = 7, sign = 7;
    int const status = pw85_overlap(in.r12, in.q1, in.q2, &overlap);
    if (pw85_compare(in.r12, in.q1, in.q2, 1.0, &sign) != status) fail("compare: status", in);
    if (status == PW85_SUCCESS ? (sign < 0) != (overlap == 1) || sign > 1 : sign != 2)
        fail("compare", in);
    double const mu2 = in.axes[0];
    int one = 7, row = 7;
    int const of_one = pw85_compare(in.r12, in.q1, in.q2, mu2, &one);
    if (pw85_compare_batch(1, in.r12, in.q1, in.q2, &mu2, &row) != of_one || row != one)
        fail("compare_batch", in);
}

// A rounded μ² is between its neighbours, and the same for both orders of the ellipsoids.
void check_rounding(Input const &in)
{
    double const infinity = std::numeric_limits<double>::infinity(),
                 back[3] = {-in.r12[0], -in.r12[1], -in.r12[2]};
    double out[2], exchanged[2], contact[2];
    int const status = pw85_contact_rounded(in.r12, in.q1, in.q2, out);
    if (pw85_contact(in.r12, in.q1, in.q2, contact) != status) fail("contact_rounded: status", in);
    if (status != PW85_SUCCESS) return;
    pw85_contact_rounded(back, in.q2, in.q1, exchanged);
    if (!(out[0] >= 0.0 && out[0] == exchanged[0])) fail("contact_rounded: exchanged", in);
    int below = 1, above = -1;
    if (out[0] > 0.0) pw85_compare(in.r12, in.q1, in.q2, std::nextafter(out[0], 0.0), &below);
    if (out[0] < infinity)
        pw85_compare(in.r12, in.q1, in.q2, std::nextafter(out[0], infinity), &above);
    if (below != 1 || above != -1) fail("contact_rounded", in);
}

// Whether a search says of a pair what the decision does; it may give up.
bool agree(int search_status, int status)
{
    return search_status == status || search_status == PW85_ECONVERGENCE;
}

// What is inside overlaps.
void check_containment(Input const &in)
{
    int overlap = 7, contains = 7;
    int const status = pw85_overlap(in.r12, in.q1, in.q2, &overlap);
    if (pw85_contains(in.r12, in.q1, in.q2, &contains) != status) fail("contains: status", in);
    if (status == PW85_SUCCESS ? contains != 0 && contains != 1 : contains != -1)
        fail("contains", in);
    if (contains == 1 && overlap != 1) fail("contains: no overlap", in);
    unsigned char code = 7;
    double gap;
    int const found = pw85_gap_inside(in.r12, in.q1, in.q2, &gap, nullptr, nullptr, nullptr);
    if (!agree(found, status)) fail("gap_inside: status", in);
    if (found == PW85_SUCCESS && (contains == 1 ? !(gap >= 0) : gap != 0)) fail("gap_inside", in);
    if (pw85_contains_batch(1, in.r12, in.q1, in.q2, &code) != status)
        fail("contains_batch: status", in);
    if (code != static_cast<unsigned char>(contains)) fail("contains_batch", in);
}

void check_flat_pair(Input const &in)
{
    double out[2];
    auto const *r = in.r12, *a = in.q1, *b = in.q2;
    int const status = pw85_contact_2d(r, a, b, out);
    int overlap = 7;
    if (pw85_overlap_2d(r, a, b, &overlap) != status) fail("overlap_2d: status", in);
    if (status == PW85_SUCCESS ? overlap != 0 && overlap != 1 : overlap != -1)
        fail("overlap_2d", in);
    unsigned char code = 7;
    if (pw85_overlap_batch_2d(1, r, a, b, &code) != status) fail("overlap_batch_2d: status", in);
}

void check_spheroid(Input const &in)
{
    double q[6];
    pw85_spheroid(in.axes[0], in.axes[1], in.rotation, q);
    if (has_nan(q, 6) != all_nan(q, 6)) fail("spheroid", in);
}

// Points and derivatives of a pair that overlaps are NaN.
void check_distance(Input const &in)
{
    double distance, points[6], derivatives[90], row[7];
    int overlap;
    int const decided = pw85_overlap(in.r12, in.q1, in.q2, &overlap);
    int const status = pw85_distance(in.r12, in.q1, in.q2, &distance, points, points + 3);
    if (!agree(status, decided)) fail("distance: status", in);
    if (distance < 0) fail("distance: negative", in);
    bool const apart = status == PW85_SUCCESS && overlap == 0;
    if (apart ? has_nan(points, 6) : !all_nan(points, 6)) fail("distance: points", in);
    if (pw85_distance_derivatives(in.r12, in.q1, in.q2, derivatives, derivatives + 3,
                                  derivatives + 6, derivatives + 9) != status)
        fail("distance_derivatives: status", in);
    if (apart ? has_nan(derivatives, 90) : !all_nan(derivatives, 90))
        fail("distance_derivatives", in);
    if (pw85_distance_batch(1, in.r12, in.q1, in.q2, row, row + 1, row + 4) != status)
        fail("distance_batch: status", in);
    if (apart ? has_nan(row + 1, 6) : !all_nan(row + 1, 6)) fail("distance_batch: points", in);
}

// A pair that does not overlap has depth 0 and no direction.
void check_penetration(Input const &in)
{
    double depth, direction[3];
    int overlap;
    int const decided = pw85_overlap(in.r12, in.q1, in.q2, &overlap);
    int const status = pw85_penetration(in.r12, in.q1, in.q2, &depth, direction);
    if (!agree(status, decided)) fail("penetration: status", in);
    if (status == PW85_SUCCESS && (overlap == 1 ? has_nan(direction, 3) || depth < 0 : depth != 0))
        fail("penetration", in);
}

// The parameters where a line enters and leaves are in order.
void check_line(Input const &in)
{
    double t[2];
    pw85_intersect_line(in.axes, in.r12, in.q1, t);
    if (std::isnan(t[0]) != std::isnan(t[1]) || t[0] > t[1]) fail("intersect_line", in);
}

// Times are not negative and not after the end; infinity is none.
void check_motion(Input const &in)
{
    auto const *x = in.rotation;
    pw85_motion const motions[2] = {{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, x[6]},
                                    {{x[6], x[7], x[8]}, {x[0], x[2], x[4]}, in.lambda}};
    pw85_motion const slide{{x[0], x[1], x[2]}, {0, 0, 0}, 0}, still{};
    double const end = in.axes[0];
    double t;
    auto const check_time = [&](pw85_motion const &a, pw85_motion const &b) {
        int const status = pw85_first_contact(in.r12, in.q1, in.q2, &a, &b, end, &t);
        if (status == PW85_SUCCESS && !(t >= 0 && (t <= end || std::isinf(t))))
            fail("first_contact: range", in);
    };
    check_time(slide, still);
    check_time(motions[0], motions[1]);
}

// What a device does with a pair, here: it answers as the host, marks what is not valid, or leaves
// it to the host.
void check_device(Input const &in)
{
    using namespace pw85::detail::gpu;
    double mu2, lambda, out[17], contact[2];
    unsigned char overlap = 7, expected;
    // Where a pivot is zero to rounding, what is rounded in another way may judge the form
    // differently; this function is not fused, as what a device does is not here.
    int const status = pw85_contact_function(in.r12, in.q1, in.q2, contact);
    bool const agreed = pw85_overlap_batch(1, in.r12, in.q1, in.q2, &expected) == status;
    Pair3 const pair = load(Pairs{in.r12, in.q1, in.q2}, 0);
    ContactArrays const contacts{&mu2, &lambda};
    if (!attempt(contacts, pair, 0)) fallback(contacts, pair, 0);
    check("device: contact", in, status, &mu2, 1);
    OverlapArray const overlaps{&overlap};
    bool const answered = attempt(overlaps, pair, 0) || fallback(overlaps, pair, 0);
    if (agreed && answered && overlap != expected) fail("device: overlap", in);
    DerivativeArrays const derivatives{out, out + 1, out + 2, out + 5, out + 8, out + 11, out + 14};
    if (!attempt(derivatives, pair, 0)) fallback(derivatives, pair, 0);
    check("device: derivatives", in, status, out + 8, 9);
}

// The images of large particles in a small cell are too many to list.
bool are_few(Input const &in)
{
    double mu2;
    return pw85_nearest_image_limit(system_of(1, nullptr, in.q1, in.rotation), &mu2) ==
               PW85_SUCCESS &&
           mu2 > 1e-2 &&
           pw85_nearest_image_limit(system_of(1, nullptr, in.q2, in.rotation), &mu2) ==
               PW85_SUCCESS &&
           mu2 > 1e-2;
}

void check_neighbors(Input const &in)
{
    double centers[6] = {0, 0, 0, in.r12[0], in.r12[1], in.r12[2]}, forms[12];
    std::memcpy(forms, in.q1, sizeof in.q1);
    std::memcpy(forms + 6, in.q2, sizeof in.q2);
    double const *const cell = are_few(in) ? in.rotation : nullptr;
    pw85_neighbors *list;
    std::size_t particle = 7;
    int holds = 7;
    int const status = pw85_neighbors_create(system_of(2, centers, forms, cell), 1.0, 0.0, &list);
    if (pw85_neighbors_check(system_of(2, centers, forms, cell), 1.0, 0.0, &particle) != status &&
        list != nullptr)
        fail("neighbors_check", in);
    if ((status == PW85_SUCCESS) != (list != nullptr)) fail("neighbors_create", in);
    pw85_neighbors_holds(list, system_of(2, centers, forms, cell), &holds);
    if (holds != (list != nullptr ? 1 : -1)) fail("neighbors_holds", in);
    pw85_pair_list const found = pw85_neighbors_list(list);
    for (std::size_t k = 0; k < 2 * found.num_pairs; ++k)
        if (found.pairs[k] < 0 || found.pairs[k] > 1) fail("neighbors_list: pairs", in);
    if (found.num_pairs > 0 && (found.images != nullptr) != (cell != nullptr))
        fail("neighbors_list: images", in);
    pw85_neighbors_destroy(list);
}

// Raw bytes rarely make a positive definite matrix: most inputs are turned into L Lᵀ with entries
// of like magnitude.
void make_definite(double *q, int exponent)
{
    double l[6];
    for (int k = 0; k < 6; ++k) {
        int e = 0;
        l[k] = std::isfinite(q[k]) ? std::frexp(q[k], &e) : 0.5;
        l[k] = std::ldexp(l[k], e % 24);
    }
    for (double *d : {&l[0], &l[3], &l[5]}) *d = std::fabs(*d) + 0x1p-30;
    double const a[6] = {l[0] * l[0],
                         l[0] * l[1],
                         l[0] * l[2],
                         l[1] * l[1] + l[3] * l[3],
                         l[1] * l[2] + l[3] * l[4],
                         l[2] * l[2] + l[4] * l[4] + l[5] * l[5]};
    for (int k = 0; k < 6; ++k) q[k] = std::ldexp(a[k], 2 * exponent);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const *data, std::size_t size)
{
    Input in{};
    std::memcpy(&in, data, std::min(size, sizeof in));
    if (in.form % 4 != 0) {
        make_definite(in.q1, in.form % 4 == 1 ? 0 : in.scale - 128);
        make_definite(in.q2, in.form % 4 == 3 ? 128 - in.scale : 0);
    }
    check_all(in);
    check_pair(in);
    check_flat_pair(in);
    check_spheroid(in);
    check_comparison(in);
    check_rounding(in);
    check_containment(in);
    check_distance(in);
    check_penetration(in);
    check_line(in);
    check_motion(in);
    check_device(in);
    check_neighbors(in);
    return 0;
}

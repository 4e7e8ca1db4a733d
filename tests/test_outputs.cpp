// Every function of the libraries writes what its contract says and nothing behind it, for valid and for invalid pairs.
#include <cstring>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85_legacy.h>
#include <pw85_zheng.h>

#include "declarations.hpp"

namespace {

constexpr std::size_t n = 3; // pairs of a batch

/// A pair, or n of them: prefixes of these arrays are valid pairs in two and in three dimensions.
struct Input {
    double r12[3 * n], q1[6 * n], q2[6 * n], params[PW85_DIM + 2 * PW85_SYM];
};

/// n times the same pair of spheroids; with r12 of NaN, which every function takes for invalid.
Input make_input(bool valid)
{
    double const x = valid ? 1.5 : std::numeric_limits<double>::quiet_NaN();
    double const form[6] = {2.0, 0.0, 0.0, 2.0, 0.0, 3.0};
    Input in{};
    for (double &coordinate : in.r12) coordinate = x;
    for (std::size_t i = 0; i < n; ++i) {
        std::memcpy(in.q1 + 6 * i, form, sizeof form);
        std::memcpy(in.q2 + 6 * i, form, sizeof form);
    }
    std::memcpy(in.params, in.r12, 3 * sizeof(double));
    std::memcpy(in.params + 3, form, sizeof form);
    std::memcpy(in.params + 9, form, sizeof form);
    return in;
}

/// An output array between guards. Its elements are of `size` bytes.
class Output {
  public:
    Output(std::size_t size, std::size_t length) : size_(size), bytes_(2 * margin + size * length, guard) {}

    template <class T> T *data() { return reinterpret_cast<T *>(bytes_.data() + margin); }

    bool guards_intact() const
    {
        std::size_t intact = 0;
        for (std::size_t i = 0; i < margin; ++i)
            intact += (bytes_[i] == guard) + (bytes_[bytes_.size() - 1 - i] == guard);
        return intact == 2 * margin;
    }

    /// Whether something was written to each element.
    bool all_written() const
    {
        for (std::size_t at = margin; at < bytes_.size() - margin; at += size_)
            if (std::string(size_, static_cast<char>(guard)) ==
                std::string(bytes_.begin() + static_cast<std::ptrdiff_t>(at),
                            bytes_.begin() + static_cast<std::ptrdiff_t>(at + size_)))
                return false;
        return true;
    }

  private:
    static constexpr std::size_t margin = 64;
    static constexpr unsigned char guard = 0xa5;
    std::size_t size_;
    std::vector<unsigned char> bytes_;
};

/// A function, the lengths of its outputs, and a call of it. `out(i)` is output i, for doubles; the only output of
/// other types is the first, of elements of `size` bytes.
struct Row {
    std::string name;
    std::vector<std::size_t> lengths;
    std::function<void(Input const &, std::vector<Output> &)> call;
    std::size_t size = sizeof(double);
};

double *at(std::vector<Output> &out, std::size_t i) { return out[i].data<double>(); }

constexpr double lambda = 0.5, axes[3] = {1.0, 2.0, 3.0}, identity[9] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
constexpr pw85_motion motions[n] = {{{-1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.1},
                                    {{0.0, -1.0, 0.0}, {1.0, 0.0, 0.0}, 0.0},
                                    {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.0}};
constexpr int32_t pairs[2 * n] = {0, 1, 1, 2, 2, 0};

// Forms and values.
std::vector<Row> const single_forms{
    {"pw85_version", {}, [](auto const &, auto &) { pw85_version(); }},
    {"pw85_strerror", {}, [](auto const &, auto &) { pw85_strerror(0); }},
    {"pw85_spheroid", {6}, [](auto const &in, auto &out) { pw85_spheroid(1.0, 2.0, in.r12, at(out, 0)); }},
    {"pw85_ellipsoid", {6}, [](auto const &in, auto &out) { pw85_ellipsoid(in.r12, identity, at(out, 0)); }},
    {"pw85_ellipsoid_quaternion",
     {6},
     [](auto const &in, auto &out) { pw85_ellipsoid_quaternion(axes, in.params, at(out, 0)); }},
    {"pw85_ellipse", {3}, [](auto const &in, auto &out) { pw85_ellipse(in.r12[0], 2.0, 0.3, at(out, 0)); }},
    {"pw85__cholesky_decomp", {6}, [](auto const &in, auto &out) { pw85__cholesky_decomp(in.q1, at(out, 0)); }},
    {"pw85__cholesky_solve", {3}, [](auto const &in, auto &out) { pw85__cholesky_solve(in.q1, in.r12, at(out, 0)); }},
    {"pw85__residual",
     {3},
     [](auto const &in, auto &out) { pw85__residual(lambda, in.r12, in.q1, in.q2, at(out, 0)); }},
    {"pw85_f_neg", {}, [](auto const &in, auto &) { pw85_f_neg(lambda, in.params); }},
};

// Pairs in three and two dimensions.
std::vector<Row> const single_pairs{
    {"pw85_contact", {2}, [](auto const &in, auto &out) { pw85_contact(in.r12, in.q1, in.q2, at(out, 0)); }},
    {"pw85_contact_function",
     {2},
     [](auto const &in, auto &out) { pw85_contact_function(in.r12, in.q1, in.q2, at(out, 0)); }},
    {"pw85_contact_geometry",
     {3, 3},
     [](auto const &in, auto &out) { pw85_contact_geometry(in.r12, in.q1, in.q2, lambda, at(out, 0), at(out, 1)); }},
    {"pw85_contact_gradient",
     {3, 6, 6},
     [](auto const &in, auto &out) {
         pw85_contact_gradient(in.r12, in.q1, in.q2, lambda, at(out, 0), at(out, 1), at(out, 2));
     }},
    {"pw85_contact_torque",
     {3, 3},
     [](auto const &in, auto &out) { pw85_contact_torque(in.r12, in.q1, in.q2, lambda, at(out, 0), at(out, 1)); }},
    {"pw85_contact_hessian",
     {81},
     [](auto const &in, auto &out) { pw85_contact_hessian(in.r12, in.q1, in.q2, lambda, at(out, 0)); }},
    {"pw85_overlap",
     {1},
     [](auto const &in, auto &out) { pw85_overlap(in.r12, in.q1, in.q2, out[0].template data<int>()); },
     sizeof(int)},
    {"pw85_closest_approach",
     {1},
     [](auto const &in, auto &out) { pw85_closest_approach(in.r12, in.q1, in.q2, at(out, 0)); }},
    {"pw85_contact_2d",
     {2},
     [](auto const &in, auto &out) { pw85_contact_2d(in.r12, in.q1 + 3, in.q2 + 3, at(out, 0)); }},
    {"pw85_contact_geometry_2d",
     {2, 2},
     [](auto const &in, auto &out) {
         pw85_contact_geometry_2d(in.r12, in.q1 + 3, in.q2 + 3, lambda, at(out, 0), at(out, 1));
     }},
    {"pw85_contact_gradient_2d",
     {2, 3, 3},
     [](auto const &in, auto &out) {
         pw85_contact_gradient_2d(in.r12, in.q1 + 3, in.q2 + 3, lambda, at(out, 0), at(out, 1), at(out, 2));
     }},
    {"pw85_contact_torque_2d",
     {1, 1},
     [](auto const &in, auto &out) {
         pw85_contact_torque_2d(in.r12, in.q1 + 3, in.q2 + 3, lambda, at(out, 0), at(out, 1));
     }},
    {"pw85_contact_hessian_2d",
     {16},
     [](auto const &in, auto &out) { pw85_contact_hessian_2d(in.r12, in.q1 + 3, in.q2 + 3, lambda, at(out, 0)); }},
    {"pw85_overlap_2d",
     {1},
     [](auto const &in, auto &out) { pw85_overlap_2d(in.r12, in.q1 + 3, in.q2 + 3, out[0].template data<int>()); },
     sizeof(int)},
    {"pw85_closest_approach_2d",
     {1},
     [](auto const &in, auto &out) { pw85_closest_approach_2d(in.r12, in.q1 + 3, in.q2 + 3, at(out, 0)); }},
    {"pw85_zheng_ellipses",
     {1},
     [](auto const &in, auto &out) { pw85_zheng_ellipses(in.r12, in.q1 + 3, in.q2 + 3, at(out, 0)); }},
    {"pw85_zheng_ellipsoids",
     {1},
     [](auto const &in, auto &out) { pw85_zheng_ellipsoids(in.r12, in.q1, in.q2, at(out, 0)); }},
};

// Distances of pairs, and from one ellipsoid to walls and points.
std::vector<Row> const distances{
    {"pw85_distance",
     {1, 3, 3},
     [](auto const &in, auto &out) { pw85_distance(in.r12, in.q1, in.q2, at(out, 0), at(out, 1), at(out, 2)); }},
    {"pw85_distance_derivatives",
     {3, 3, 3, 81},
     [](auto const &in, auto &out) {
         pw85_distance_derivatives(in.r12, in.q1, in.q2, at(out, 0), at(out, 1), at(out, 2), at(out, 3));
     }},
    {"pw85_distance_2d",
     {1, 2, 2},
     [](auto const &in, auto &out) {
         pw85_distance_2d(in.r12, in.q1 + 3, in.q2 + 3, at(out, 0), at(out, 1), at(out, 2));
     }},
    {"pw85_penetration",
     {1, 3},
     [](auto const &in, auto &out) { pw85_penetration(in.r12, in.q1, in.q2, at(out, 0), at(out, 1)); }},
    {"pw85_first_contact",
     {1},
     [](auto const &in, auto &out) {
         pw85_first_contact(in.r12, in.q1, in.q2, motions, motions + 1, 1.0, at(out, 0));
     }},
    {"pw85_distance_plane",
     {1, 3},
     [](auto const &in, auto &out) { pw85_distance_plane(in.r12, 1.0, in.q1, at(out, 0), at(out, 1)); }},
    {"pw85_distance_plane_derivatives",
     {3, 3},
     [](auto const &in, auto &out) { pw85_distance_plane_derivatives(in.r12, in.q1, at(out, 0), at(out, 1)); }},
    {"pw85_contact_plane",
     {1, 3},
     [](auto const &in, auto &out) { pw85_contact_plane(in.r12, 1.0, in.q1, at(out, 0), at(out, 1)); }},
    {"pw85_contact_plane_derivatives",
     {3, 3},
     [](auto const &in, auto &out) { pw85_contact_plane_derivatives(in.r12, 1.0, in.q1, at(out, 0), at(out, 1)); }},
    {"pw85_distance_box",
     {1, 3, 3},
     [](auto const &in, auto &out) {
         pw85_distance_box(in.params, in.r12, in.q1, at(out, 0), at(out, 1), at(out, 2));
     }},
    {"pw85_distance_cylinder",
     {1, 3, 3},
     [](auto const &in, auto &out) {
         pw85_distance_cylinder(axes, 4.0, in.r12, in.q1, at(out, 0), at(out, 1), at(out, 2));
     }},
    {"pw85_distance_point",
     {1, 3, 3},
     [](auto const &in, auto &out) { pw85_distance_point(in.r12, in.q1, at(out, 0), at(out, 1), at(out, 2)); }},
    {"pw85_intersect_line",
     {2},
     [](auto const &in, auto &out) { pw85_intersect_line(in.r12, axes, in.q1, at(out, 0)); }},
};

std::vector<Row> const many_pairs{
    {"pw85_contact_batch",
     {n, n},
     [](auto const &in, auto &out) { pw85_contact_batch(n, in.r12, in.q1, in.q2, at(out, 0), at(out, 1)); }},
    {"pw85_overlap_batch",
     {n},
     [](auto const &in, auto &out) {
         pw85_overlap_batch(n, in.r12, in.q1, in.q2, out[0].template data<unsigned char>());
     },
     1},
    {"pw85_contact_batch_2d",
     {n, n},
     [](auto const &in, auto &out) { pw85_contact_batch_2d(n, in.r12, in.q1 + 3, in.q2 + 3, at(out, 0), at(out, 1)); }},
    {"pw85_overlap_batch_2d",
     {n},
     [](auto const &in, auto &out) {
         pw85_overlap_batch_2d(n, in.r12, in.q1 + 3, in.q2 + 3, out[0].template data<unsigned char>());
     },
     1},
    {"pw85_contact_pairs",
     {n, n},
     [](auto const &in, auto &out) {
         pw85_contact_pairs(n, pairs, nullptr, n, in.r12, in.q1, identity, at(out, 0), at(out, 1));
     }},
    {"pw85_overlap_pairs",
     {n},
     [](auto const &in, auto &out) {
         pw85_overlap_pairs(n, pairs, nullptr, n, in.r12, in.q1, identity, out[0].template data<unsigned char>());
     },
     1},
    {"pw85_contact_derivatives_batch",
     {n, n, 3 * n, 3 * n, 3 * n, 3 * n, 3 * n},
     [](auto const &in, auto &out) {
         pw85_contact_derivatives_batch(n, in.r12, in.q1, in.q2, at(out, 0), at(out, 1), at(out, 2), at(out, 3),
                                        at(out, 4), at(out, 5), at(out, 6));
     }},
    {"pw85_contact_derivatives_pairs",
     {n, n, 3 * n, 3 * n, 3 * n, 3 * n, 3 * n},
     [](auto const &in, auto &out) {
         pw85_contact_derivatives_pairs(n, pairs, nullptr, n, in.r12, in.q1, identity, at(out, 0), at(out, 1),
                                        at(out, 2), at(out, 3), at(out, 4), at(out, 5), at(out, 6));
     }},
    {"pw85_closest_approach_batch",
     {n},
     [](auto const &in, auto &out) { pw85_closest_approach_batch(n, in.r12, in.q1, in.q2, at(out, 0)); }},
    {"pw85_distance_batch",
     {n, 3 * n, 3 * n},
     [](auto const &in, auto &out) {
         pw85_distance_batch(n, in.r12, in.q1, in.q2, at(out, 0), at(out, 1), at(out, 2));
     }},
    {"pw85_penetration_batch",
     {n, 3 * n},
     [](auto const &in, auto &out) { pw85_penetration_batch(n, in.r12, in.q1, in.q2, at(out, 0), at(out, 1)); }},
    {"pw85_distance_plane_batch",
     {n, 3 * n},
     [](auto const &in, auto &out) { pw85_distance_plane_batch(n, in.r12, axes, in.q1, at(out, 0), at(out, 1)); }},
    {"pw85_first_contact_batch",
     {n},
     [](auto const &in, auto &out) {
         pw85_first_contact_batch(n, in.r12, in.q1, in.q2, motions, motions, 1.0, at(out, 0));
     }},
    {"pw85_first_contact_pairs",
     {n, n, n},
     [](auto const &in, auto &out) {
         pw85_first_contact_pairs(n, pairs, nullptr, n, in.r12, in.q1, identity, motions, 1.0, at(out, 0), at(out, 1),
                                  out[2].template data<int64_t>());
     }},
    {"pw85_overlap_any",
     {1},
     [](auto const &in, auto &out) { pw85_overlap_any(n, in.q1, in.r12, in.q2, out[0].template data<int>()); },
     sizeof(int)},
    {"pw85_overlap_any_indices",
     {1},
     [](auto const &in, auto &out) {
         pw85_overlap_any_indices(in.r12, in.q1, 2, pairs, n, in.r12, in.q2, identity, out[0].template data<int>());
     },
     sizeof(int)},
    {"pw85_contact_forces_pairs",
     {3 * n, 3 * n, 9},
     [](auto const &in, auto &out) {
         pw85_contact_forces_pairs(n, pairs, nullptr, n, in.r12, identity, in.q1, in.q1, in.q2, in.r12, at(out, 0),
                                   at(out, 1), at(out, 2));
     }},
    {"pw85_ellipsoid_quaternion_batch",
     {6 * n},
     [](auto const &in, auto &out) { pw85_ellipsoid_quaternion_batch(n, in.q1, in.q2, at(out, 0)); }},
    {"pw85_bounding_boxes", {3 * n}, [](auto const &in, auto &out) { pw85_bounding_boxes(n, in.q1, at(out, 0)); }},
    {"pw85_neighbors_create",
     {1},
     [](auto const &in, auto &out) {
         auto **const list = out[0].template data<pw85_neighbors *>();
         pw85_neighbors_create(n, in.r12, in.q1, identity, nullptr, 1.0, 0.5, list);
         pw85_neighbors_destroy(*list);
     },
     sizeof(pw85_neighbors *)},
    {"pw85_neighbors_check",
     {1},
     [](auto const &in, auto &out) {
         pw85_neighbors_check(n, in.r12, in.q1, identity, nullptr, 1.0, 0.5, out[0].template data<std::size_t>());
     },
     sizeof(std::size_t)},
    {"pw85_neighbors_holds",
     {1},
     [](auto const &in, auto &out) {
         pw85_neighbors *list;
         Input const valid = make_input(true);
         pw85_neighbors_create(n, valid.r12, valid.q1, identity, nullptr, 1.0, 0.5, &list);
         pw85_neighbors_holds(list, n, in.r12, in.q1, out[0].template data<int>());
         pw85_neighbors_destroy(list);
     },
     sizeof(int)},
    {"pw85_neighbors_size", {}, [](auto const &, auto &) { pw85_neighbors_size(nullptr); }},
    {"pw85_neighbors_pairs", {}, [](auto const &, auto &) { pw85_neighbors_pairs(nullptr); }},
    {"pw85_neighbors_images", {}, [](auto const &, auto &) { pw85_neighbors_images(nullptr); }},
    {"pw85_neighbors_destroy", {}, [](auto const &, auto &) { pw85_neighbors_destroy(nullptr); }},
    {"pw85_cell_reduce", {9}, [](auto const &in, auto &out) { pw85_cell_reduce(in.q1, at(out, 0)); }},
    {"pw85_nearest_images",
     {3 * n},
     [](auto const &in, auto &out) { pw85_nearest_images(n, pairs, n, in.r12, identity, at(out, 0), nullptr); }},
    {"pw85_nearest_images",
     {3 * n},
     [](auto const &in, auto &out) {
         pw85_nearest_images(n, pairs, n, in.r12, identity, nullptr, out[0].template data<int32_t>());
     },
     sizeof(int32_t)},
    {"pw85_nearest_image_limit",
     {1},
     [](auto const &in, auto &out) { pw85_nearest_image_limit(n, in.q1, identity, at(out, 0)); }},
};

std::vector<Row> const superseded{
    {"pw85_legacy__det_sym", {}, [](auto const &in, auto &) { pw85_legacy__det_sym(in.q1); }},
    {"pw85_legacy__xT_adjA_x", {}, [](auto const &in, auto &) { pw85_legacy__xT_adjA_x(in.r12, in.q1); }},
    {"pw85_legacy__detQ_as_poly",
     {4},
     [](auto const &in, auto &out) { pw85_legacy__detQ_as_poly(in.q1, in.q2, in.q1, in.q2, at(out, 0)); }},
    {"pw85_legacy__rT_adjQ_r_as_poly",
     {3},
     [](auto const &in, auto &out) { pw85_legacy__rT_adjQ_r_as_poly(in.r12, in.q1, in.q2, in.q1, at(out, 0)); }},
    {"pw85_legacy_f1",
     {3},
     [](auto const &in, auto &out) { pw85_legacy_f1(lambda, in.r12, in.q1, in.q2, at(out, 0)); }},
    {"pw85_legacy_f2",
     {1},
     [](auto const &in, auto &out) { pw85_legacy_f2(lambda, in.r12, in.q1, in.q2, at(out, 0)); }},
    {"pw85_legacy_f2_derivatives",
     {3},
     [](auto const &in, auto &out) { pw85_legacy_f2_derivatives(lambda, in.r12, in.q1, in.q2, at(out, 0)); }},
    {"pw85_legacy_contact_function1",
     {2},
     [](auto const &in, auto &out) { pw85_legacy_contact_function1(in.r12, in.q1, in.q2, at(out, 0)); }},
    {"pw85_legacy_contact_function2",
     {2},
     [](auto const &in, auto &out) { pw85_legacy_contact_function2(in.r12, in.q1, in.q2, at(out, 0)); }},
};

std::vector<Row> all_rows()
{
    std::vector<Row> rows;
    for (auto const *part : {&single_forms, &single_pairs, &distances, &many_pairs, &superseded})
        rows.insert(rows.end(), part->begin(), part->end());
    return rows;
}

void test_every_function_is_called()
{
    std::set<std::string> declared, called;
    for (char const *header : {"pw85.h", "pw85_legacy.h", "pw85_zheng.h"})
        declared.merge(pw85_tests::declared_in(header));
    for (auto const &row : all_rows()) called.insert(row.name);
    for (auto const &name : declared)
        if (!called.contains(name)) g_test_message("%s is not called here", name.c_str());
    g_assert_true(declared == called);
}

void test_outputs(void const *valid)
{
    Input const in = make_input(valid != nullptr);
    int failed = 0;
    for (auto const &row : all_rows()) {
        std::vector<Output> out;
        for (std::size_t const length : row.lengths) out.emplace_back(row.size, length);
        row.call(in, out);
        for (std::size_t i = 0; i < out.size(); ++i) {
            if (out[i].guards_intact() && out[i].all_written()) continue;
            ++failed;
            g_test_message("%s: output %d is not %d elements", row.name.c_str(), static_cast<int>(i),
                           static_cast<int>(row.lengths[i]));
        }
    }
    g_assert_cmpint(failed, ==, 0);
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    g_test_add_func("/outputs/every_function_is_called", test_every_function_is_called);
    g_test_add_data_func("/outputs/valid", "", test_outputs);
    g_test_add_data_func("/outputs/invalid", nullptr, test_outputs);
    return g_test_run();
}

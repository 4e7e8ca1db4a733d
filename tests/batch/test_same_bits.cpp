// SPDX-License-Identifier: BSD-3-Clause
// The functions of many rows whose lanes give the bits of one row: rows of any size, and unusual
// and bad rows in each place of a pack, among others. A signed distance of ellipsoids that are
// apart may have the bits of a row of distances instead.
#include <cstring>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85_batch.h>

#include "../cases.hpp"
#include "../draws.hpp"
#include "../failures.hpp"
#include "../random_pairs.hpp"

using namespace pw85_tests;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();

/// Two vectors, two forms and a number: what the functions take.
struct Row {
    Vector3 a, b;
    Form3 q1, q2;
    double x;
};

/// Rows, in arrays.
struct Rows {
    std::vector<double> a, b, q1, q2, x;

    explicit Rows(std::vector<Row> const &rows)
    {
        for (Row const &row : rows) {
            a.insert(a.end(), row.a.coordinates, row.a.coordinates + 3);
            b.insert(b.end(), row.b.coordinates, row.b.coordinates + 3);
            q1.insert(q1.end(), row.q1.entries, row.q1.entries + 6);
            q2.insert(q2.end(), row.q2.entries, row.q2.entries + 6);
            x.push_back(row.x);
        }
    }
};

/// What a function gives for some rows, at most seven numbers each. A row more than it computes
/// shows whether it writes too much.
struct Results {
    std::vector<double> number, point, normal;
    int status = 0;

    explicit Results(std::size_t n)
        : number(n + 1, 7.0), point(3 * n + 3, 7.0), normal(3 * n + 3, 7.0)
    {
    }

    bool is_same(std::size_t i, Results const &other, std::size_t j) const
    {
        return std::memcmp(&number[i], &other.number[j], sizeof(double)) == 0 &&
               std::memcmp(&point[3 * i], &other.point[3 * j], 3 * sizeof(double)) == 0 &&
               std::memcmp(&normal[3 * i], &other.normal[3 * j], 3 * sizeof(double)) == 0;
    }
};

/// A function of one row, and that of many. A row may have the bits of `other` if that succeeds.
struct Function {
    char const *name;
    int (*one)(Row const &, double *number, double *point, double *normal);
    int (*many)(std::size_t n, Rows const &, double *number, double *point, double *normal);
    int (*other)(Row const &, double *number, double *point, double *normal) = nullptr;
};

constexpr Function functions[] = {
    {"distance_point",
     [](Row const &row, double *number, double *point, double *normal) {
         return pw85_distance_point(row.a.coordinates, row.q1.entries, number, point, normal);
     },
     [](std::size_t n, Rows const &rows, double *number, double *point, double *normal) {
         return pw85_distance_point_batch(n, rows.a.data(), rows.q1.data(), number, point, normal);
     }},
    {"distance_cylinder",
     [](Row const &row, double *number, double *point, double *normal) {
         return pw85_distance_cylinder(row.b.coordinates, row.x, row.a.coordinates, row.q1.entries,
                                       number, point, normal);
     },
     [](std::size_t n, Rows const &rows, double *number, double *point, double *normal) {
         return pw85_distance_cylinder_batch(n, rows.b.data(), rows.x.data(), rows.a.data(),
                                             rows.q1.data(), number, point, normal);
     }},
    {"penetration",
     [](Row const &row, double *number, double *, double *normal) {
         return pw85_penetration(row.a.coordinates, row.q1.entries, row.q2.entries, number, normal);
     },
     [](std::size_t n, Rows const &rows, double *number, double *, double *normal) {
         return pw85_penetration_batch(n, rows.a.data(), rows.q1.data(), rows.q2.data(), number,
                                       normal);
     }},
    {"signed_distance",
     [](Row const &row, double *number, double *point, double *normal) {
         return pw85_signed_distance(row.a.coordinates, row.q1.entries, row.q2.entries, number,
                                     point, normal);
     },
     [](std::size_t n, Rows const &rows, double *number, double *point, double *normal) {
         return pw85_signed_distance_batch(n, rows.a.data(), rows.q1.data(), rows.q2.data(), number,
                                           point, normal);
     },
     [](Row const &row, double *number, double *point, double *normal) {
         int const status = pw85_distance_batch(1, row.a.coordinates, row.q1.entries,
                                                row.q2.entries, number, point, normal);
         return *number > 0.0 ? status : PW85_EINVAL; // apart
     }},
    {"signed_distance_geometry",
     [](Row const &row, double *number, double *point, double *normal) {
         return pw85_signed_distance_geometry(row.a.coordinates, row.q1.entries, row.q2.entries,
                                              number, point, nullptr, normal);
     },
     [](std::size_t n, Rows const &rows, double *number, double *point, double *normal) {
         return pw85_signed_distance_geometry_batch(n, rows.a.data(), rows.q1.data(),
                                                    rows.q2.data(), number, point, nullptr, normal);
     },
     [](Row const &row, double *number, double *point, double *normal) {
         int const status = pw85_distance_geometry_batch(
             1, row.a.coordinates, row.q1.entries, row.q2.entries, number, point, nullptr, normal);
         return *number > 0.0 ? status : PW85_EINVAL; // apart
     }},
    {"overlap_volume",
     [](Row const &row, double *number, double *, double *) {
         return pw85_overlap_volume(row.a.coordinates, row.q1.entries, row.q2.entries, number);
     },
     [](std::size_t n, Rows const &rows, double *number, double *, double *) {
         return pw85_overlap_volume_batch(n, rows.a.data(), rows.q1.data(), rows.q2.data(), number);
     }},
    {"intersect_line",
     [](Row const &row, double *number, double *point, double *) {
         double t[2];
         int const status =
             pw85_intersect_line(row.a.coordinates, row.b.coordinates, row.q1.entries, t);
         number[0] = t[0];
         if (point != nullptr) point[0] = t[1], point[1] = point[2] = 7.0;
         return status;
     },
     [](std::size_t n, Rows const &rows, double *number, double *point, double *) {
         std::vector<double> leave(n);
         int const status = pw85_intersect_line_batch(n, rows.a.data(), rows.b.data(),
                                                      rows.q1.data(), number, leave.data());
         for (std::size_t i = 0; point != nullptr && i < n; ++i) point[3 * i] = leave[i];
         return status;
     }},
};

std::string text(Row const &row)
{
    return "a = " + hex_text(row.a.coordinates, 3) + ", b = " + hex_text(row.b.coordinates, 3) +
           ", q1 = " + hex_text(row.q1.entries, 6) + ", q2 = " + hex_text(row.q2.entries, 6) +
           ", x = " + hex_text(&row.x, 1);
}

/// Returns whether row i has the bits of `other`.
bool is_other(Function const &function, Row const &row, Results const &many, std::size_t i)
{
    if (function.other == nullptr) return false;
    Results found(1);
    found.status =
        function.other(row, found.number.data(), found.point.data(), found.normal.data());
    return found.status == PW85_SUCCESS && many.is_same(i, found, 0);
}

/// Compares the rows of many with those of one.
void compare(Failures &failures, Function const &function, std::vector<Row> const &rows)
{
    std::size_t const n = rows.size();
    Results many(n), bare(n);
    many.status =
        function.many(n, Rows(rows), many.number.data(), many.point.data(), many.normal.data());
    bare.status = function.many(n, Rows(rows), bare.number.data(), nullptr, nullptr);
    int first_bad = 0;
    for (std::size_t i = 0; i < n; ++i) {
        Results one(1);
        one.status = function.one(rows[i], one.number.data(), one.point.data(), one.normal.data());
        if (first_bad == 0) first_bad = one.status;
        failures.check(many.is_same(i, one, 0) || is_other(function, rows[i], many, i),
                       function.name, many.number[i], one.number[0], [&] {
                           return "row " + std::to_string(i) + " of " + std::to_string(n) + ": " +
                                  text(rows[i]);
                       });
    }
    auto const none = [&] { return std::string(function.name); };
    failures.check(many.is_same(n, Results(0), 0), "beyond the last row", many.number[n], 7.0,
                   none);
    failures.check(std::memcmp(many.number.data(), bare.number.data(), n * sizeof(double)) == 0,
                   "without points", 0.0, 0.0, none);
    failures.check(many.status == first_bad && bare.status == first_bad, "status", many.status,
                   first_bad, none);
}

/// A row of lengths of order one.
Row ordinary(Random &random)
{
    double const aspect = random.log_uniform(1.0, 1000.0);
    return {random.log_uniform(0.1, 3.0) * random.direction<3>(), random.direction<3>(),
            random.form(random.log_uniform(0.5, 2.0), aspect),
            random.form(random.log_uniform(0.5, 2.0), aspect), random.log_uniform(1.0, 4.0)};
}

/// The row in units 2^-length of its points, and 2^-form of its ellipsoids.
Row scaled(Row row, int length, int form)
{
    row.a = pw85::detail::times_power_of_two(row.a, length);
    row.b = pw85::detail::times_power_of_two(row.b, length);
    row.x = std::ldexp(row.x, length);
    row.q1 = pw85::detail::times_power_of_two(row.q1, 2 * form);
    row.q2 = pw85::detail::times_power_of_two(row.q2, 2 * form);
    return row;
}

PW85_TEST("/same_bits/scales")
{
    Failures failures;
    Random random(4711);
    for (Function const &function : functions)
        for (int n = 0; n < draws(400); ++n) {
            std::vector<Row> rows;
            for (int i = 0; i < 61; ++i) {
                int const length = static_cast<int>(random.uniform(-40.0, 41.0)),
                          other = static_cast<int>(random.uniform(-40.0, 41.0));
                rows.push_back(n % 4 == 0   ? scaled(ordinary(random), length, other)
                               : n % 4 == 1 ? scaled(ordinary(random), length, length)
                                            : ordinary(random));
            }
            compare(failures, function, rows);
        }
}

constexpr Form3 sphere{1, 0, 0, 1, 0, 1}, disc{4, 0, 0, 4, 0, 0.25}, needle{0.01, 0, 0, 9, 0, 0.01};

/// Changes of an ordinary row into one that few others are like, or into a bad one.
void (*const unusual[])(Row &) = {
    [](Row &r) {
        r.a = {0, 0, 0};
    }, // concentric
    [](Row &r) {
        r.a = {0, -0.0, 0}, r.q1 = r.q2 = sphere;
    },
    // on an axis, inside, where F(0) < 1
    [](Row &r) {
        r.a = {0.1, 0, 0}, r.b = {0, 0, 1}, r.q1 = r.q2 = disc;
    },
    // on the shortest axis
    [](Row &r) {
        r.a = {0, 0, 0.01}, r.b = {0, 0, -2}, r.q1 = disc, r.q2 = needle;
    },
    [](Row &r) {
        r.b = {1, 0, 0}, r.q1 = r.q2 = sphere;
    },
    [](Row &r) { r.q1 = needle, r.q2 = disc; },
    [](Row &r) { r.q2 = r.q1; }, // equal
    [](Row &r) {
        r.a = {2, 0, 0}, r.q1 = disc;
    }, // on the surface
    // numbers whose products underflow
    [](Row &r) {
        r.a[1] = 0x1p-1060, r.b = {0, 0x1p-1050, 1}, r.q1 = disc;
    },
    [](Row &r) {
        r.a = {0x1p-300, 0x1p-600, 0.5}, r.b = {0x1p-530, 0x1p-520, -1}, r.q1 = needle;
    },
    [](Row &r) { r.q1[1] = r.q2[2] = 0x1p-1070; },
    [](Row &r) {
        r.a = {50, 60, 70};
    }, // apart
    [](Row &r) {
        r.a = {0x1p200, 1, 1};
    },
    [](Row &r) {
        r.b = {0x1p-1000, 0x1p-1001, 0};
    },
    [](Row &r) {
        r.b = {0x1p1000, 0x1p1001, 0};
    },
    [](Row &r) { r.a[1] = nan; }, // bad ones
    [](Row &r) { r.a[2] = -infinity; },
    [](Row &r) { r.q1[4] = nan; },
    [](Row &r) { r.q1[0] = infinity; },
    [](Row &r) { r.q1 = {1, 2, 0, 1, 0, 1}; },
    [](Row &r) { r.q2 = r.q1 = {1, 1, 1, 1, 1, 1}; },
    [](Row &r) {
        r.b = {0, 0, 0}, r.q2 = {0, 0, 0, 0, 0, 0};
    },
    [](Row &r) { r.b[0] = nan, r.x = r.q2[5] = infinity; },
    [](Row &r) { r.x = -1.0, r.q2[5] = nan; },
};

/// Each kind in each place of the packs of a chunk, of 24 rows at most, and in none other.
PW85_TEST("/same_bits/places")
{
    Failures failures;
    Random random(4712);
    for (Function const &function : functions)
        for (auto const &change : unusual)
            for (std::size_t place = 0; place < 26; ++place) {
                std::vector<Row> rows;
                for (std::size_t i = 0; i < place + place % 5 + 1; ++i)
                    rows.push_back(ordinary(random));
                change(rows[place]);
                compare(failures, function, rows);
            }
}

/// Rows of all kinds, more than a list of those that lanes leave over can have.
PW85_TEST("/same_bits/mixed")
{
    Failures failures;
    Random random(4713);
    for (Function const &function : functions) {
        std::vector<Row> rows;
        for (std::size_t i = 0; i < 1300; ++i) {
            rows.push_back(ordinary(random));
            if (i % 3 != 0) unusual[i % std::size(unusual)](rows.back());
        }
        compare(failures, function, rows);
    }
}

} // namespace

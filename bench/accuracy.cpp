// SPDX-License-Identifier: BSD-3-Clause
// Prints the errors of the functions in units of u cond, as CSV. measure.py runs it.
//
//     accuracy                over the contact problems of the reference data
//     accuracy worst [PAIRS]  the worst pairs that a random search of PAIRS pairs finds, for each
//                             decade of aspect ratios
//
// The first table has the median and the largest error of each method for pairs of the categories
// general_aspect_*, by the larger aspect ratio, and for all pairs in the last row. It has "nan" if
// a method gives no number for some pair. For overlaps it has the number of wrong results. A
// distance of closest approach d is converted to μ² = |r12|²/d².
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <pw85_legacy.h>
#include <pw85_zheng.h>

#include <reference_data.hpp>
#include <worst_pairs.hpp>

using namespace pw85_tests;

namespace {

double by_zheng(double const *r12, double const *q1, double const *q2)
{
    double distance;
    pw85_zheng_ellipsoids(r12, q1, q2, &distance);
    return (r12[0] * r12[0] + r12[1] * r12[1] + r12[2] * r12[2]) / (distance * distance);
}

template <auto Function> double first_of_two(double const *r12, double const *q1, double const *q2)
{
    double out[2];
    Function(r12, q1, q2, out);
    return out[0];
}

struct Method {
    char const *name;
    double (*mu2)(double const *, double const *, double const *); ///< null: by the batch
};

constexpr Method methods[] = {
    {"contact", first_of_two<pw85_contact>},
    {"contact_function", first_of_two<pw85_contact_function>},
    {"contact_batch", nullptr},
    {"legacy_contact_function2", first_of_two<pw85_legacy_contact_function2>},
    {"zheng_ellipsoids", by_zheng}};
constexpr std::size_t num_methods = std::size(methods);

/// The largest eigenvalue of a positive definite matrix.
double largest_eigenvalue(Form3 const &a)
{
    Vector3 x{0.6, 0.5, 0.62};
    double value = 0.0;
    for (int i = 0; i < 200; ++i) {
        auto const y = pw85::product(a, x);
        value = std::sqrt(pw85::dot(y, y));
        x = 1.0 / value * y;
    }
    return value;
}

/// The ratio of the largest to the smallest semi-axis. The inverse is computed in a wide type,
/// because rounding errors may exceed the smallest eigenvalue of Q.
double aspect_ratio(Form3 const &q)
{
    auto const wide = convert<Wide>(q);
    auto const adjugate = pw85::detail::adjugate(wide);
    Wide const det = pw85::detail::determinant(wide, adjugate);
    Form3 inverse{};
    for (int k = 0; k < inverse.size; ++k)
        inverse[k] = static_cast<double>(Wide(adjugate[k] / det));
    return std::sqrt(largest_eigenvalue(q) * largest_eigenvalue(inverse));
}

/// The results for one problem.
struct Judgement {
    double aspect;
    double errors[num_methods];
    bool wrong_overlap, wrong_overlap_batch;
};

std::vector<Judgement> judge_problems()
{
    auto const &problems = contact_problems();
    std::vector<Pair3> pairs;
    for (auto const &p : problems) pairs.push_back(p.pair);
    auto const batch = run_batch(pairs);
    std::vector<Judgement> all;
    for (std::size_t i = 0; i < problems.size(); ++i) {
        auto const &p = problems[i];
        double const *r12 = p.pair.r12.coordinates, *q1 = p.pair.q1.entries,
                     *q2 = p.pair.q2.entries;
        Judgement j{std::fmax(aspect_ratio(p.pair.q1), aspect_ratio(p.pair.q2)), {}, false, false};
        for (std::size_t m = 0; m < num_methods; ++m) {
            double const mu2 = methods[m].mu2 ? methods[m].mu2(r12, q1, q2) : batch.mu2[i];
            j.errors[m] = std::fabs(mu2 - p.mu2) / p.mu2 / (0x1p-53 * p.cond);
        }
        int overlap;
        pw85_overlap(r12, q1, q2, &overlap);
        j.wrong_overlap = overlap != static_cast<int>(p.mu2_minus_1 < 0.0);
        j.wrong_overlap_batch = batch.overlap[i] != static_cast<int>(p.mu2_minus_1 < 0.0);
        all.push_back(j);
    }
    return all;
}

void print_statistics(std::vector<double> errors)
{
    if (std::any_of(errors.begin(), errors.end(), [](double x) { return std::isnan(x); })) {
        std::printf(",nan,nan");
        return;
    }
    std::sort(errors.begin(), errors.end());
    std::size_t const n = errors.size();
    std::printf(",%.3g,%.3g", 0.5 * (errors[(n - 1) / 2] + errors[n / 2]), errors.back());
}

void print_row(char const *range, std::vector<Judgement> const &rows)
{
    std::printf("%s,%zu", range, rows.size());
    for (std::size_t m = 0; m < num_methods; ++m) {
        std::vector<double> errors;
        for (auto const &row : rows) errors.push_back(row.errors[m]);
        print_statistics(errors);
    }
    long wrong = 0, wrong_batch = 0;
    for (auto const &row : rows) {
        wrong += row.wrong_overlap;
        wrong_batch += row.wrong_overlap_batch;
    }
    std::printf(",%ld,%ld\n", wrong, wrong_batch);
}

void print_problems()
{
    std::printf("aspect_from,aspect_to,pairs");
    for (auto const &method : methods) std::printf(",median_%s,worst_%s", method.name, method.name);
    std::puts(",wrong_overlap,wrong_overlap_batch");
    auto const all = judge_problems();
    for (int half_decade = 0; half_decade < 12; ++half_decade) {
        double const from = std::pow(10.0, 0.5 * half_decade),
                     to = std::pow(10.0, 0.5 * (half_decade + 1));
        std::vector<Judgement> rows;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (contact_problems()[i].category->starts_with("general_aspect") &&
                all[i].aspect >= from && all[i].aspect < to)
                rows.push_back(all[i]);
        char range[40];
        std::snprintf(range, sizeof range, "%.4g,%.4g", from, to);
        print_row(range, rows);
    }
    print_row("all,", all);
}

/// One of the worst pairs of a function, as in data/found_pairs.txt.
void print_found(int function, double aspect, WorstPairs const &all,
                 WorstPairs::Climber const &found)
{
    std::printf("%s,%g,%g,%ld,%ld,%.3g,", searched[function], aspect, 10.0 * aspect, all.judged(),
                all.broken(function), found.error);
    for (double const x : found.pair.r12.coordinates) std::printf("%a ", x);
    for (double const x : found.pair.q1.entries) std::printf("%a ", x);
    for (double const x : found.pair.q2.entries) std::printf("%a ", x);
    std::puts("");
}

void print_worst(long pairs)
{
    std::puts("function,aspect_from,aspect_to,pairs,beyond_bound,error,pair");
    for (double aspect = 1.0; aspect < 1e6; aspect *= 10.0) {
        WorstPairs all(aspect, 10.0 * aspect);
        all.search(pairs);
        for (int f = 0; f < num_searched; ++f)
            for (auto const &found : all.worst(f)) print_found(f, aspect, all, found);
    }
}

} // namespace

int main(int argc, char **argv)
{
    bool const search = argc > 1 && std::string_view(argv[1]) == "worst";
    long const pairs = search && argc == 3 ? std::atol(argv[2]) : 10000;
    if (argc > (search ? 3 : 1) || pairs < 1) {
        std::fprintf(stderr, "usage: %s [worst [PAIRS]]\n", argv[0]);
        return 1;
    }
    search ? print_worst(pairs) : print_problems();
    return 0;
}

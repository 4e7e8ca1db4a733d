// The accuracy study: writes CSV files into a folder, for draw_accuracy.py. Usage: accuracy FOLDER
//
//   digits.csv   over /F of the reference data, without λ = 0 and 1, where f is 0: per cent of the values with so many
//                correct digits, for f by factorisation (pw85_f_neg) and in rational form (pw85_legacy_f2)
//   errors.csv   over the contact problems: the larger aspect ratio, the condition number, and the error of each of
//                the four contact functions in units of u cond; empty where a function reports failure
//
// and prints the largest errors.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <pw85_legacy.h>

#include <reference_data.hpp>

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;
constexpr int num_bins = 17;

/// Correct decimal digits, 0 to 16; all of them for no error.
int correct_digits(double actual, double expected)
{
    double const error = std::fabs((actual - expected) / expected);
    if (error == 0.0) return num_bins - 1;
    if (!(error < 1.0)) return 0;
    return std::min(num_bins - 1, static_cast<int>(-std::log10(error)));
}

struct Histograms {
    long factorised[num_bins] = {}, rational[num_bins] = {};
    long total = 0;
};

void add_value(Histograms &h, Sample<double, 3> const &p, double lambda, double expected)
{
    double const *r12 = p.r12.coordinates, *q1 = p.q1.entries, *q2 = p.q2.entries;
    double params[PW85_DIM + 2 * PW85_SYM];
    std::copy_n(r12, 3, params);
    std::copy_n(q1, 6, params + 3);
    std::copy_n(q2, 6, params + 9);
    ++h.factorised[correct_digits(-pw85_f_neg(lambda, params), expected)];
    ++h.rational[correct_digits(pw85_legacy_f2(lambda, r12, q1, q2, nullptr), expected)];
    ++h.total;
}

Histograms digits_over_grid()
{
    auto const &grid = spheroid_grid();
    Histograms h;
    for (std::size_t i = 0; i < grid.spheroids.size(); ++i)
        for (std::size_t j = 0; j < grid.spheroids.size(); ++j)
            for (std::size_t k = 0; k < grid.directions.size(); ++k)
                for (std::size_t l = 1; l + 1 < grid.lambdas.size(); ++l)
                    add_value(h, {grid.directions[k], grid.spheroids[i], grid.spheroids[j]}, grid.lambdas[l],
                              grid.f_at(i, j, k, l));
    return h;
}

std::FILE *create(std::string const &path)
{
    std::FILE *file = std::fopen(path.c_str(), "w");
    if (file == nullptr) {
        std::perror(path.c_str());
        std::exit(1);
    }
    return file;
}

void write_digits(std::string const &folder)
{
    auto const h = digits_over_grid();
    std::FILE *file = create(folder + "/digits.csv");
    std::fprintf(file, "digits,factorised,rational\n");
    for (int i = 0; i < num_bins; ++i)
        std::fprintf(file, "%d,%g,%g\n", i, 100.0 * static_cast<double>(h.factorised[i]) / static_cast<double>(h.total),
                     100.0 * static_cast<double>(h.rational[i]) / static_cast<double>(h.total));
    std::fclose(file);
}

struct Solver {
    char const *name;
    int (*call)(double const *, double const *, double const *, double *);
};

constexpr Solver solvers[] = {{"contact", pw85_contact},
                              {"contact_function", pw85_contact_function},
                              {"legacy_contact_function1", pw85_legacy_contact_function1},
                              {"legacy_contact_function2", pw85_legacy_contact_function2}};

/// Ratio of the largest to the smallest semi-axis, by the extreme values of xᵀQx over directions x: power iteration on Q
/// and on adj(Q).
double aspect_ratio(Form3 const &q)
{
    auto const largest_eigenvalue = [](pw85::SymmetricMatrix<long double, 3> const &a) {
        pw85::Vector<long double, 3> x{0.6L, 0.5L, 0.62L};
        long double value = 0.0L;
        for (int i = 0; i < 200; ++i) {
            auto const y = pw85::product(a, x);
            value = std::sqrt(pw85::dot(y, y));
            x = pw85::times(1.0L / value, y);
        }
        return value;
    };
    auto const wide = convert<long double>(q);
    auto const adjugate = pw85::adjugate(wide);
    long double const det = pw85::determinant(wide, adjugate);
    return static_cast<double>(std::sqrt(largest_eigenvalue(wide) * largest_eigenvalue(adjugate) / det));
}

void write_errors(std::string const &folder)
{
    std::FILE *file = create(folder + "/errors.csv");
    std::fprintf(file, "category,aspect,cond");
    for (auto const &solver : solvers) std::fprintf(file, ",%s", solver.name);
    std::fprintf(file, "\n");
    double worst[std::size(solvers)] = {};
    long failed[std::size(solvers)] = {};
    for (auto const &p : contact_problems()) {
        double const aspect = std::fmax(aspect_ratio(p.pair.q1), aspect_ratio(p.pair.q2));
        std::fprintf(file, "%s,%.4g,%.4g", p.category->c_str(), aspect, p.cond);
        for (std::size_t i = 0; i < std::size(solvers); ++i) {
            double out[2];
            int const status = solvers[i].call(p.pair.r12.coordinates, p.pair.q1.entries, p.pair.q2.entries, out);
            double const units = std::fabs(out[0] - p.mu2) / p.mu2 / (u * p.cond);
            failed[i] += status != PW85_SUCCESS;
            if (status == PW85_SUCCESS) worst[i] = std::fmax(worst[i], units);
            status == PW85_SUCCESS ? std::fprintf(file, ",%.4g", units) : std::fprintf(file, ",");
        }
        std::fprintf(file, "\n");
    }
    std::fclose(file);
    std::printf("%-26s %22s %9s\n", "", "largest error / u cond", "failures");
    for (std::size_t i = 0; i < std::size(solvers); ++i)
        std::printf("%-26s %22.3g %9ld\n", solvers[i].name, worst[i], failed[i]);
}

} // namespace

int main(int argc, char **argv)
{
    if (argc != 2) {
        std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
        return 1;
    }
    write_digits(argv[1]);
    write_errors(argv[1]);
    return 0;
}

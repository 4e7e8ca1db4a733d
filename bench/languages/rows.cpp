// SPDX-License-Identifier: BSD-3-Clause
// The program of bench/languages.py in C++: calls are templates of the headers, rows are spans.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <pw85/batch.hpp>
#include <pw85/pw85.hpp>
#include <span>
#include <vector>

namespace {

using Vector = pw85::Vector<double, 3>;
using Form = pw85::SymmetricMatrix<double, 3>;

constexpr std::size_t num_pairs = 1000, most_rows = 16 * num_pairs;

std::vector<Vector> r12(most_rows), points[2] = {r12, r12};
std::vector<Form> q1(most_rows), q2(most_rows);
std::vector<double> numbers[2] = {std::vector<double>(most_rows), std::vector<double>(most_rows)};
std::vector<unsigned char> bytes(most_rows);

void check(pw85::Status status)
{
    if (status == pw85::Status::success) return;
    std::fprintf(stderr, "%s\n", pw85::strerror(status));
    std::exit(1);
}

template <typename T> void read(std::vector<T> &rows, std::FILE *file)
{
    if (std::fread(rows.data(), sizeof(T), num_pairs, file) != num_pairs) std::exit(1);
    for (std::size_t i = num_pairs; i < most_rows; ++i) rows[i] = rows[i - num_pairs];
}

template <typename Function> double time_of(Function function)
{
    auto const start = std::chrono::steady_clock::now();
    function();
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start)
        .count();
}

/// A function of pairs. A call takes the first form of pair j and the other arguments of pair i.
/// Results are in `numbers` and `points`, truth values of rows in `bytes`.
struct Function {
    char const *name;
    void (*call)(std::size_t i, std::size_t j);
    pw85::Status (*rows)(std::size_t n);
    std::size_t copies; ///< of the pairs, that are computed as rows
    int num_numbers, num_points;
    bool is_truth;

    void call_each(std::size_t shift) const
    {
        for (std::size_t i = 0; i < num_pairs; ++i) call(i, i + shift);
    }

    void write(std::FILE *file) const
    {
        for (int k = 0; k < num_numbers; ++k)
            std::fwrite(numbers[k].data(), sizeof(double), num_pairs, file);
        for (int k = 0; k < num_points; ++k)
            std::fwrite(points[k].data(), sizeof(Vector), num_pairs, file);
    }

    void run(std::size_t rounds, std::FILE *file) const
    {
        std::size_t const n = copies * num_pairs;
        double per_call = 1e300, per_row = 1e300;
        for (std::size_t k = 0; k < rounds; ++k) {
            per_call = std::min(per_call, time_of([&] { call_each(k); }));
            per_row = std::min(per_row, time_of([&] { check(rows(n)); }));
        }
        for (std::size_t i = 0; is_truth && i < num_pairs; ++i) numbers[0][i] = bytes[i];
        write(file);
        call_each(0);
        write(file);
        std::printf("%s,%.17g,%.17g\n", name, per_call / num_pairs, per_row / double(n));
    }
};

void overlap_call(std::size_t i, std::size_t j)
{
    auto const found = pw85::overlap(r12[i], q1[j], q2[i]);
    check(found.status);
    numbers[0][i] = found.overlap;
}

void contact_call(std::size_t i, std::size_t j)
{
    auto const found = pw85::contact(r12[i], q1[j], q2[i]);
    check(found.status);
    numbers[0][i] = found.mu2;
    numbers[1][i] = found.lambda;
}

void distance_call(std::size_t i, std::size_t j)
{
    auto const found = pw85::distance(r12[i], q1[j], q2[i]);
    check(found.status);
    numbers[0][i] = found.distance;
    points[0][i] = found.point1;
    points[1][i] = found.point2;
}

void volume_call(std::size_t i, std::size_t j)
{
    auto const found = pw85::overlap_volume(r12[i], q1[j], q2[i]);
    check(found.status);
    numbers[0][i] = found.volume;
}

/// The first n rows.
template <typename T> std::span<T> rows_of(std::vector<T> &rows, std::size_t n)
{
    return {rows.data(), n};
}

pw85::Status overlap_rows(std::size_t n)
{
    return pw85::overlap_batch(rows_of(r12, n), rows_of(q1, n), rows_of(q2, n), rows_of(bytes, n));
}

pw85::Status contact_rows(std::size_t n)
{
    return pw85::contact_batch(rows_of(r12, n), rows_of(q1, n), rows_of(q2, n),
                               rows_of(numbers[0], n), rows_of(numbers[1], n));
}

pw85::Status distance_rows(std::size_t n)
{
    return pw85::distance_batch(rows_of(r12, n), rows_of(q1, n), rows_of(q2, n),
                                rows_of(numbers[0], n), rows_of(points[0], n),
                                rows_of(points[1], n));
}

pw85::Status volume_rows(std::size_t n)
{
    return pw85::overlap_volume_batch(rows_of(r12, n), rows_of(q1, n), rows_of(q2, n),
                                      rows_of(numbers[0], n));
}

Function const functions[] = {
    {"overlap", overlap_call, overlap_rows, 16, 1, 0, true},
    {"contact", contact_call, contact_rows, 16, 2, 0, false},
    {"distance", distance_call, distance_rows, 4, 1, 2, false},
    {"overlap_volume", volume_call, volume_rows, 1, 1, 0, false},
};

} // namespace

int main(int argc, char **argv)
{
    std::FILE *const given = argc == 4 ? std::fopen(argv[1], "rb") : nullptr;
    std::FILE *const file = argc == 4 ? std::fopen(argv[2], "wb") : nullptr;
    if (!given || !file) return 1;
    read(r12, given);
    read(q1, given);
    read(q2, given);
    for (Function const &function : functions)
        function.run(std::strtoul(argv[3], nullptr, 10), file);
    return std::fclose(file) != 0;
}

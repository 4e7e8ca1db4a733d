// SPDX-License-Identifier: BSD-3-Clause
// What compare_any_dimension.py asks of the headers: how often the contact function evaluates f,
// and how long one factorisation of a matrix takes, in the flags of a user's program.
#include <cstddef>

#include <pw85/any_dimension/contact.hpp>

using namespace pw85::detail::any_dimension;

extern "C" {

/// Evaluations of m pairs.
[[gnu::visibility("default")]] long any_dimension_evaluations(int n, std::size_t m,
                                                              double const *r12, double const *q1,
                                                              double const *q2)
{
    long sum = 0;
    auto const rows = static_cast<std::size_t>(n), size = static_cast<std::size_t>(packed_size(n));
    for (std::size_t i = 0; i < m; ++i) {
        Input const in{n, r12 + i * rows, q1 + i * size, q2 + i * size};
        sum += with_workspace([&](auto &work) {
                   return maximize_in(in, units_of(in), work);
               }).evaluations;
    }
    return sum;
}

/// Factorises m forms. Returns the sum of the last pivots.
[[gnu::visibility("default")]] double any_dimension_factorize(int n, std::size_t m, double const *q)
{
    double memory[max_packed_size], sum = 0.0;
    int const size = packed_size(n);
    for (std::size_t i = 0; i < m; ++i, q += size) {
        for (int k = 0; k < size; ++k) memory[k] = q[k];
        factorize(n, memory);
        sum += memory[size - 1];
    }
    return sum;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "function.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include <pw85.h>
#include <pw85_batch.h>
#include <pw85_legacy.h>
#include <pw85_systems.h>
#include <pw85_zheng.h>

namespace pypw85 {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool all_finite(double const *x, int count) noexcept
{
    for (int i = 0; i < count; ++i)
        if (!std::isfinite(x[i])) return false;
    return true;
}

/// Status of a function that returns none: whether its result is NaN.
int status_of(double value) noexcept { return std::isnan(value) ? PW85_EINVAL : PW85_SUCCESS; }

/// Status of a function of one matrix, which fails where that is not positive definite.
int status_of(double value, double const *a) noexcept
{
    if (!std::isnan(value)) return PW85_SUCCESS;
    return all_finite(a, PW85_SYM) ? PW85_ENOTPD : PW85_EINVAL;
}

/// Status of a function of λ and a pair, which keeps no record: pw85_condition() refuses the same
/// arguments, and records why.
int status_of(double value, double const *lambda, double const *r12, double const *q1,
              double const *q2) noexcept
{
    if (!std::isnan(value)) return PW85_SUCCESS;
    double ignored;
    int const status = pw85_condition(r12, q1, q2, *lambda, &ignored);
    return status != PW85_SUCCESS ? status : PW85_EINVAL;
}

/// Returns the status of a function that keeps no record. If it is refused, the other function
/// refuses the same inputs, and records why; it writes at most two numbers.
template <class Other, class... In> int recorded(int status, Other const &other, In... in) noexcept
{
    double ignored[2];
    if (status != PW85_SUCCESS) static_cast<void>(other(in..., ignored));
    return status;
}

/// The numbers that a function has written into one array, as outputs.
template <std::size_t size> void split(double const (&row)[size], Outputs out) noexcept
{
    for (std::size_t i = 0; i < size; ++i) *out[i] = row[i];
}

/// An integer as an output.
void number(int status, int integer, double *out) noexcept
{
    *out = status == PW85_SUCCESS ? integer : nan;
}

pw85_motion const *motion(double const *numbers) noexcept
{
    static_assert(sizeof(pw85_motion) == 7 * sizeof(double));
    return reinterpret_cast<pw85_motion const *>(numbers);
}

int f(Inputs in, Outputs out)
{
    double params[PW85_DIM + 2 * PW85_SYM];
    std::copy_n(in[1], PW85_DIM, params);
    std::copy_n(in[2], PW85_SYM, params + PW85_DIM);
    std::copy_n(in[3], PW85_SYM, params + PW85_DIM + PW85_SYM);
    *out[0] = -pw85_f_neg(*in[0], params);
    return status_of(*out[0], in[0], in[1], in[2], in[3]);
}

/// The pointer of a parameter of a batch function, of which `number` come before it, `inputs` of
/// all being inputs.
template <class Pointer>
Pointer array(std::size_t inputs, std::size_t number, Inputs in, Outputs out) noexcept
{
    if constexpr (std::is_same_v<Pointer, double const *>)
        return in[number];
    else
        return out[number - inputs];
}

template <class... Pointers>
int call_batch(int (*function)(std::size_t, Pointers...), std::size_t n, Inputs in, Outputs out)
{
    constexpr std::size_t inputs = (std::size_t{std::is_same_v<Pointers, double const *>} + ...);
    return [&]<std::size_t... k>(std::index_sequence<k...>)
    {
        return function(n, array<Pointers>(inputs, k, in, out)...);
    }
    (std::index_sequence_for<Pointers...>{});
}

/// A function of many rows of the C API, whose arrays are in the order of the operands.
template <auto function> int batch(std::size_t n, Inputs in, Outputs out)
{
    return call_batch(function, n, in, out);
}

template <class... Pointers> int call_codes(int (*function)(std::size_t, Pointers...),
                                            std::size_t n, Inputs in, unsigned char *codes)
{
    return [&]<std::size_t... k>(std::index_sequence<k...>) { return function(n, in[k]..., codes); }
    (std::make_index_sequence<sizeof...(Pointers) - 1>{});
}

/// A function of many rows of the C API that answers by one byte for each row.
template <auto function> int codes(std::size_t n, Inputs in, unsigned char *answers)
{
    return call_codes(function, n, in, answers);
}

/// Calls a function of one row for n rows; its inputs are arrays of these sizes.
template <auto function, std::size_t... sizes>
int codes_of_each(std::size_t n, Inputs in, unsigned char *answers)
{
    int first_bad = PW85_SUCCESS;
    for (std::size_t i = 0; i < n; ++i) {
        int answer;
        int const status = [&]<std::size_t... k>(std::index_sequence<k...>)
        {
            return function(in[k] + i * sizes..., &answer);
        }
        (std::make_index_sequence<sizeof...(sizes)>{});
        answers[i] = status == PW85_SUCCESS ? static_cast<unsigned char>(answer) : 255;
        if (first_bad == PW85_SUCCESS) first_bad = status;
    }
    return first_bad;
}

/// One call(begin, count) for each run of rows that have the same t_max. Returns the status of the
/// first bad row.
template <class Call> int for_runs(std::size_t n, double const *t_max, Call const &call)
{
    int first_bad = PW85_SUCCESS;
    for (std::size_t begin = 0, end; begin < n; begin = end) {
        end = begin + 1;
        while (end < n && t_max[end] == t_max[begin]) ++end;
        int const status = call(begin, end - begin);
        if (first_bad == PW85_SUCCESS) first_bad = status;
    }
    return first_bad;
}

int first_contact_batch(std::size_t n, Inputs in, Outputs out)
{
    return for_runs(n, in[5], [&](std::size_t begin, std::size_t count) {
        return pw85_first_contact_batch(count, in[0] + 3 * begin, in[1] + 6 * begin,
                                        in[2] + 6 * begin, motion(in[3]) + begin,
                                        motion(in[4]) + begin, in[5][begin], out[0] + begin);
    });
}

int closest_passage_batch(std::size_t n, Inputs in, Outputs out)
{
    return for_runs(n, in[4], [&](std::size_t begin, std::size_t count) {
        return pw85_closest_passage_batch(count, in[0] + 3 * begin, in[1] + 6 * begin,
                                          in[2] + 6 * begin, in[3] + 3 * begin, in[4][begin],
                                          out[0] + begin, out[1] + begin);
    });
}

} // namespace

void parse_signature(Function &function) noexcept
{
    int operand = -1;
    bool output = false;
    for (char const *c = function.signature; *c != '\0'; ++c) {
        if (*c == '>') output = true;
        if (*c == '(') {
            ++operand;
            ++(output ? function.nout : function.nin);
        }
        if (*c >= '0' && *c <= '9') {
            Core &core = function.cores[operand];
            core.dims[core.ndim++] = *c - '0';
        }
    }
}

std::vector<Function> &functions()
{
    static std::vector<Function> table{
#include "functions.inc"
    };
    return table;
}

} // namespace pypw85

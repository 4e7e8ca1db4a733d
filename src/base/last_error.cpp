// SPDX-License-Identifier: BSD-3-Clause
// The causes of refusals. Requirements are decided as the templates of the functions decide them.
#include "last_error.hpp"

#include <cstdint>
#include <limits>

#include <pw85/contact/factor.hpp>
#include <pw85/contact/scaling.hpp>
#include <pw85/status.hpp>

#include "c_arrays.hpp"
#include "floating_point_environment.hpp"

using namespace pw85;
using namespace pw85::detail;

namespace {

constinit thread_local pw85_error last{0, nullptr, nullptr, nullptr, 0, 0, 0.0};
constinit thread_local pw85_error noted{0, nullptr, nullptr, nullptr, 0, 0, 0.0};

/// A requirement that an argument does not meet; none if `text` is null.
struct Complaint {
    char const *text = nullptr;
    std::size_t entry = 0;
    bool is_of_entry = false; ///< and not of the argument, or of a row, as a whole
};

/// The first entry of an argument that is bad.
template <class IsBad>
Complaint of_entries(Argument const &one, char const *text, IsBad const &is_bad) noexcept
{
    for (std::size_t i = 0; i < one.count; ++i)
        if (is_bad(one.numbers()[i])) return {text, i, true};
    return {};
}

Complaint of_finite(Argument const &one) noexcept
{
    if (one.limits & limit::may_be_nan) return {};
    if (one.limits & limit::may_be_infinite)
        return of_entries(one, "must not be NaN", [](double x) { return elementary::isnan(x); });
    return of_entries(one, "must be finite", [](double x) { return !elementary::isfinite(x); });
}

bool is_definite(double const *a, std::size_t count) noexcept
{
    return (count == 6 ? validate(c_api::load_matrix<3>(a)) : validate(c_api::load_matrix<2>(a))) ==
           Status::success;
}

bool has_independent_columns(double const *s) noexcept
{
    return is_regular(c_api::load_factor<3>(s));
}

Complaint of_form(Argument const &one) noexcept
{
    std::size_t const columns = one.columns > 0 ? one.columns : one.count;
    for (std::size_t i = 0; (one.limits & limit::definite) && i < one.count; i += columns)
        if (!is_definite(one.numbers() + i, columns)) return {"must be positive definite", i};
    if ((one.limits & limit::independent) && !has_independent_columns(one.numbers()))
        return {"must have columns that are not zero and not nearly dependent"};
    return {};
}

bool is_all_zero(double const *numbers, std::size_t count) noexcept
{
    for (std::size_t i = 0; i < count; ++i)
        if (!is_zero(numbers[i])) return false;
    return true;
}

/// Returns the first row that is zero.
Complaint of_zero_rows(Argument const &one, std::size_t columns) noexcept
{
    for (std::size_t i = 0; i + columns <= one.count; i += columns)
        if (is_all_zero(one.numbers() + i, columns)) return {"must not be zero", i};
    return {};
}

/// The largest error of an entry of RᵀR is that of pw85_ellipsoid().
bool is_rotation(double const *r) noexcept
{
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            double const product = r[i] * r[j] + r[3 + i] * r[3 + j] + r[6 + i] * r[6 + j];
            if (!(elementary::abs(product - (i == j ? 1.0 : 0.0)) <= 1e-6)) return false;
        }
    return true;
}

/// Requirements on single numbers.
Complaint of_range(Argument const &one) noexcept
{
    constexpr struct {
        unsigned limit;
        char const *text;
    } ranges[] = {{limit::positive, "must be > 0"},
                  {limit::from_zero, "must be >= 0"},
                  {limit::unit_interval, "must be in [0, 1]"},
                  {limit::at_most_one, "must be at most 1"}};
    for (auto const &[limit, text] : ranges) {
        if (!(one.limits & limit)) continue;
        Complaint const found = of_entries(one, text, [limit = limit](double x) {
            return elementary::isnan(x) || !is_within(x, limit);
        });
        if (found.text != nullptr) return found;
    }
    if (!(one.limits & limit::finite_square)) return {};
    return of_entries(one, "must have a finite square that is not 0",
                      [](double x) { return x * x == 0.0 || !elementary::isfinite(x * x); });
}

/// Requirements on an array, or on two arguments.
Complaint of_whole(Argument const &one, Argument const *begin, Argument const *end) noexcept
{
    if ((one.limits & limit::not_zero) && one.count > 0)
        if (Complaint const zero = of_zero_rows(one, one.columns > 0 ? one.columns : one.count);
            zero.text != nullptr)
            return zero;
    if ((one.limits & limit::rotation) && !is_rotation(one.numbers()))
        return {"must be a rotation matrix, whose columns are orthonormal"};
    if (one.limits & limit::rows_not_zero)
        if (Complaint const zero = of_zero_rows(one, 3); zero.text != nullptr) return zero;
    if (one.limits & limit::independent_rows) return {"must have independent rows"};
    if (one.limits & limit::below_next)
        for (std::size_t i = 0; i < one.count; ++i)
            if (one.numbers()[i] > (&one + 1)->numbers()[i])
                return {"must be at most upper", i, true};
    double const growth = one.limits & limit::until_t_max ? one.numbers()[6] : 0.0;
    for (Argument const *other = begin; growth < 0.0 && other != end; ++other)
        if (other->is_number && 1.0 + growth * other->number <= 0.0)
            return {"must not shrink to nothing before t_max", 6, true};
    return {};
}

pw85_error cause_of(Argument const &one, Complaint const &found) noexcept
{
    bool const has_value = found.is_of_entry || one.is_number;
    double const value = has_value ? one.numbers()[found.entry] : quiet_nan<double>();
    std::size_t const row = one.columns > 0 ? found.entry / one.columns : 0;
    return {0, nullptr, one.name, found.text, row, found.entry - row * one.columns, value};
}

/// Finds the first row, and of its arguments the first one, of which find(argument) complains.
template <class Find> bool find_cause(Argument const *begin, Argument const *end, Find const &find,
                                      pw85_error &cause) noexcept
{
    bool any = false;
    for (Argument const *one = begin; one != end; ++one) {
        Complaint const found = find(*one);
        if (found.text == nullptr) continue;
        pw85_error const own = cause_of(*one, found);
        if (!any || own.row < cause.row) cause = own;
        any = true;
    }
    return any;
}

/// Returns the first complaint about an argument; of two about an entry, that it is not finite.
Complaint of_number(Argument const &one, Argument const *begin, Argument const *end) noexcept
{
    Complaint const finite = of_finite(one), range = of_range(one);
    Complaint const value = range.text != nullptr ? range : of_whole(one, begin, end);
    bool const is_first = value.text != nullptr && value.entry < finite.entry;
    return finite.text == nullptr || is_first ? value : finite;
}

/// Null pointers come first, then NaN, because other causes follow from these; of many rows the
/// first bad one.
bool find_invalid(Argument const *begin, Argument const *end, pw85_error &cause) noexcept
{
    auto const of_null = [](Argument const &one) {
        bool const is_bad = one.is_null() && !(one.limits & limit::optional);
        return is_bad ? Complaint{"must not be null"} : Complaint{};
    };
    auto const finite = [](Argument const &one) {
        return one.columns == 0 ? of_finite(one) : Complaint{};
    };
    auto const value = [&](Argument const &one) { return of_number(one, begin, end); };
    return find_cause(begin, end, of_null, cause) || find_cause(begin, end, finite, cause) ||
           find_cause(begin, end, value, cause);
}

} // namespace

namespace pw85::detail {

int refuse(int status, pw85_error const &cause) noexcept
{
    last = cause;
    last.status = status;
    return status;
}

int refuse(int status, char const *function, Argument const *arguments, std::size_t count) noexcept
{
    return in_default_environment([&] {
        Argument const *const end = arguments + count;
        pw85_error cause{0, nullptr, nullptr, pw85_strerror(status), 0, 0, quiet_nan<double>()};
        if (status == PW85_EINVAL) find_invalid(arguments, end, cause);
        if (status == PW85_ENOTPD) find_cause(arguments, end, of_form, cause);
        cause.function = function;
        return refuse(status, cause);
    });
}

int note_cause(int status, char const *argument, char const *requirement, std::size_t row,
               std::size_t entry, double value) noexcept
{
    noted = {status, nullptr, argument, requirement, row, entry, value};
    return status;
}

int refuse_noted(int status, char const *function, Argument const *arguments,
                 std::size_t count) noexcept
{
    pw85_error cause = noted;
    noted.requirement = nullptr;
    if (cause.requirement == nullptr || cause.status != status)
        return refuse(status, function, arguments, count);
    cause.function = function;
    return refuse(status, cause);
}

int refuse_arrays_or_size(char const *function, char const *name_of_size, std::size_t size,
                          NamedArray const *arrays, std::size_t count) noexcept
{
    for (std::size_t k = 0; k < count; ++k)
        if (arrays[k].pointer == nullptr)
            return refuse(PW85_EINVAL, {0, function, arrays[k].name, "must not be null", 0, 0,
                                        quiet_nan<double>()});
    return refuse(PW85_EINVAL, {0, function, name_of_size,
                                "must be small enough for the bytes of each array to fit ptrdiff_t",
                                0, 0, static_cast<double>(size)});
}

int refuse_row(int status, std::size_t row) noexcept
{
    last.row = row;
    return status;
}

} // namespace pw85::detail

int pw85_last_error(pw85_error *error)
{
    if (error == nullptr) return PW85_EINVAL;
    *error = last;
    last = {0, nullptr, nullptr, nullptr, 0, 0, 0.0};
    return PW85_SUCCESS;
}

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The contact function of two ellipsoids in n dimensions, 1 <= n <= 16, with n known at run time.
///
/// The search tries these types, and takes the first one whose result is certified: double, numbers
/// with twice its digits (algebra/doubled.hpp), and numbers with seven times its digits
/// (algebra/extended_number.hpp), whose memory is allocated.
#ifndef PW85_ANY_DIMENSION_CONTACT_HPP_INCLUDED
#define PW85_ANY_DIMENSION_CONTACT_HPP_INCLUDED

#include <pw85/any_dimension/definite.hpp>
#include <pw85/any_dimension/search.hpp>
#include <pw85/contact/contact.hpp>

#include <cfloat>
#include <cstdlib>

namespace pw85::detail::any_dimension {

/// Memory of a search.
template <class T, class N = int> struct Workspace {
    Pair<T, N> pair;
    Evaluation<T, N> at;
};

/// Computes the maximum of f by numbers of type T, in the units of the pair.
template <class T, class N> [[gnu::noinline]] PW85_FUNCTION inline Maximum<double>
maximize_in(InputOf<N> const &in, Units const &units, Workspace<T, N> &work) noexcept
{
    scale(in, units, work.pair);
    auto const m = maximize(work.pair, work.at);
    if constexpr (std::is_same_v<T, double>)
        return m;
    else
        return {rounded(m.mu2), rounded(m.lambda), rounded(m.complement),
                m.evaluations,  m.converged,       m.certified};
}

/// Calls function(workspace) with a workspace on the stack.
template <class N = int, class Function>
[[gnu::noinline]] PW85_FUNCTION inline auto with_workspace(Function const &function) noexcept
{
    Workspace<double, N> work;
    return function(work);
}

/// Calls function(workspace) with a workspace for numbers with twice the digits. This function, and
/// the functions that only it calls, are compiled for size.
template <class Function> [[gnu::noinline, gnu::cold]] PW85_FUNCTION auto
with_wide_workspace(Function const &function) noexcept
{
    Workspace<Doubled<double>> work;
    return function(work);
}

/// Computes with extended numbers, in memory that is allocated.
[[gnu::cold, gnu::noinline]] PW85_FUNCTION inline Contact<double>
contact_extended(Input const &in, Units const &units) noexcept
{
    using Extended = exact::Extended<double>;
    auto *const work = static_cast<Workspace<Extended> *>(std::malloc(sizeof(Workspace<Extended>)));
    if (work == nullptr) return all_nan<Contact<double>>(StatusCode::out_of_memory);
    Maximum<double> const m = maximize_in(in, units, *work);
    std::free(work);
    if (!m.certified) return all_nan<Contact<double>>(StatusCode::no_convergence);
    return {m.mu2, units.swapped ? m.complement : m.lambda, StatusCode::success};
}

/// Computes with numbers of twice, and then of seven times, the digits.
[[gnu::cold, gnu::noinline]] PW85_FUNCTION inline Contact<double>
contact_wider(Input const &in, Units const &units) noexcept
{
    if constexpr (FLT_EVAL_METHOD == 0) {
        Maximum<double> const m =
            with_wide_workspace([&](auto &work) { return maximize_in(in, units, work); });
        if (m.certified)
            return {m.mu2, units.swapped ? m.complement : m.lambda, StatusCode::success};
    }
    return contact_extended(in, units);
}

/// Returns the contact function of a valid pair with r12 != 0, in the units of the pair.
template <class N> PW85_FUNCTION inline Contact<double>
contact_in_units(InputOf<N> const &in, Units const &units) noexcept
{
    if (!keep_digits(in, units)) return all_nan<Contact<double>>(StatusCode::no_convergence);
    Maximum<double> const m =
        with_workspace<N>([&](auto &work) { return maximize_in(in, units, work); });
    if (!m.certified) return contact_wider({in.n, in.r12, in.q1, in.q2}, units);
    return {m.mu2, units.swapped ? m.complement : m.lambda, StatusCode::success};
}

/// Returns the contact function.
template <class N> PW85_FUNCTION inline Contact<double> find_contact(InputOf<N> const &in) noexcept
{
    StatusCode const status = status_of(in);
    if (status != StatusCode::success) return all_nan<Contact<double>>(status);
    if (largest_magnitude(in.n, in.r12) == 0.0) return {0.0, 0.5, StatusCode::success};
    auto const units = units_of(in);
    auto result = contact_in_units(in, units);
    result.mu2 = units.mu().to_caller(result.mu2, 2);
    return result;
}

} // namespace pw85::detail::any_dimension

namespace pw85 {

/// Returns the contact function in n dimensions, 1 <= n <= 16. r12 has n numbers, and each form n
/// (n + 1)/2: the rows of the upper triangle.
PW85_FUNCTION inline Contact<double> nd_contact(int n, double const *r12, double const *q1,
                                                double const *q2) noexcept
{
    return detail::any_dimension::find_contact(detail::any_dimension::Input{n, r12, q1, q2});
}

/// Returns the contact function, bitwise equal to nd_contact(N, ...). The number of dimensions is
/// known at compile time, which saves time in few dimensions.
template <int N> PW85_FUNCTION inline Contact<double>
nd_contact(double const *r12, double const *q1, double const *q2) noexcept
{
    using namespace detail::any_dimension;
    static_assert(N >= 1 && N <= max_dimension);
    return find_contact(InputOf<Dimension<N>>{{}, r12, q1, q2});
}

} // namespace pw85

#endif

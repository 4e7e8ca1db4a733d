// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The result of a call that fails: every number is NaN, and the status tells the cause. Every
/// function with a status calls all_nan().
#ifndef PW85_ALGEBRA_ALL_NAN_HPP_INCLUDED
#define PW85_ALGEBRA_ALL_NAN_HPP_INCLUDED

#include <pw85/algebra/factor.hpp>
#include <pw85/status.hpp>

namespace pw85::detail {

template <class T> PW85_FUNCTION constexpr void set_nan(T &x) noexcept { x = quiet_nan<T>(); }

template <class T, int D> PW85_FUNCTION constexpr void set_nan(Vector<T, D> &x) noexcept
{
    for (int i = 0; i < D; ++i) set_nan(x[i]);
}

template <class T, int D> PW85_FUNCTION constexpr void set_nan(SymmetricMatrix<T, D> &a) noexcept
{
    for (int k = 0; k < a.size; ++k) set_nan(a[k]);
}

template <class T, int D> PW85_FUNCTION constexpr void set_nan(Factor<T, D> &s) noexcept
{
    for (T &x : s.entries) set_nan(x);
}

template <class T, std::size_t M, std::size_t N>
PW85_FUNCTION constexpr void set_nan(T (&rows)[M][N]) noexcept
{
    for (auto &row : rows)
        for (T &x : row) set_nan(x);
}

/// Returns a result with NaN in every number and the given status. The type of a result has up to
/// five numbers, vectors or matrices, followed by the status.
template <class Result> PW85_FUNCTION constexpr Result all_nan(StatusCode status) noexcept
{
    Result result{};
    result.status = status;
    if constexpr (requires { Result{{}, {}, {}, {}, {}, {}}; }) {
        auto &[a, b, c, d, e, last] = result;
        (set_nan(a), set_nan(b), set_nan(c), set_nan(d), set_nan(e));
    } else if constexpr (requires { Result{{}, {}, {}, {}, {}}; }) {
        auto &[a, b, c, d, last] = result;
        (set_nan(a), set_nan(b), set_nan(c), set_nan(d));
    } else if constexpr (requires { Result{{}, {}, {}, {}}; }) {
        auto &[a, b, c, last] = result;
        (set_nan(a), set_nan(b), set_nan(c));
    } else if constexpr (requires { Result{{}, {}, {}}; }) {
        auto &[a, b, last] = result;
        (set_nan(a), set_nan(b));
    } else {
        auto &[a, last] = result;
        set_nan(a);
    }
    return result;
}

} // namespace pw85::detail

#endif

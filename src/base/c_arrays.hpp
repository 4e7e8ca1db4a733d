// SPDX-License-Identifier: BSD-3-Clause
// Converts between the arrays of the C API and the values of the C++ headers. All shims of the C
// API use it.
#ifndef PW85_BASE_C_ARRAYS_HPP_INCLUDED
#define PW85_BASE_C_ARRAYS_HPP_INCLUDED

#include <cstddef>
#include <cstring>
#include <type_traits>

#include <pw85.h>

#include <pw85/algebra/factor.hpp>
#include <pw85/motion/motion.hpp>
#include <pw85/status.hpp>

namespace pw85::detail::c_api {
namespace {

inline bool any_null() noexcept { return false; }

/// Returns whether any of the pointers is null.
template <class Pointer, class... Pointers> bool any_null(Pointer first, Pointers... rest) noexcept
{
    return first == nullptr || any_null(rest...);
}

template <int D> Vector<double, D> load_vector(double const *x) noexcept
{
    Vector<double, D> v;
    std::memcpy(v.coordinates, x, sizeof v.coordinates);
    return v;
}

template <int D> SymmetricMatrix<double, D> load_matrix(double const *a) noexcept
{
    SymmetricMatrix<double, D> m;
    std::memcpy(m.entries, a, sizeof m.entries);
    return m;
}

/// A type with the layout of an array of the C API, as that array. Nothing is copied: a copy would
/// pass through memory where a function that is not inlined reads it.
template <class Type> Type const &view(double const *x) noexcept
{
    static_assert(std::is_standard_layout_v<Type> && alignof(Type) == alignof(double));
    return *reinterpret_cast<Type const *>(x);
}

template <int D> Vector<double, D> const &view_vector(double const *x) noexcept
{
    return view<Vector<double, D>>(x);
}

template <int D> SymmetricMatrix<double, D> const &view_matrix(double const *a) noexcept
{
    return view<SymmetricMatrix<double, D>>(a);
}

template <int D> Factor<double, D> load_factor(double const *a) noexcept
{
    Factor<double, D> s;
    std::memcpy(s.entries, a, sizeof s.entries);
    return s;
}

inline Motion<double, 3> load_motion(pw85_motion const &m) noexcept
{
    return {load_vector<3>(m.velocity), load_vector<3>(m.angular_velocity), m.growth};
}

// Outputs may be null.

inline void store(double number, double *x) noexcept
{
    if (x != nullptr) *x = number;
}

inline void store(int number, int *x) noexcept { *x = number; }

template <std::size_t size> void store(double const (&rows)[size][size], double *x) noexcept
{
    if (x != nullptr) std::memcpy(x, rows, sizeof rows);
}

template <int D> void store(Vector<double, D> const &v, double *x) noexcept
{
    for (int i = 0; x != nullptr && i < D; ++i) x[i] = v[i];
}

template <int D> void store(SymmetricMatrix<double, D> const &m, double *a) noexcept
{
    for (int k = 0; a != nullptr && k < m.size; ++k) a[k] = m[k];
}

template <int D> void store(Factor<double, D> const &s, double *a) noexcept
{
    if (a != nullptr) std::memcpy(a, s.entries, sizeof s.entries);
}

/// Stores a member of a result. An answer is stored on success alone: the function has marked it as
/// unknown before.
template <class Member, class Output>
void store_member(Status status, Member const &member, Output output) noexcept
{
    if constexpr (std::is_same_v<Member, bool> && std::is_same_v<Output, int *>) {
        if (status == Status::success) *output = member;
    } else {
        store(member, output);
    }
}

/// Returns the part of an output from an entry on; null if the output is.
inline double *part(double *x, int entry) noexcept { return x == nullptr ? x : x + entry; }

/// Returns the status of a result, all of whose members are stored.
inline int put(Status status) noexcept { return static_cast<int>(status); }

/// Stores members of a result, each of which is followed by the output that receives it, and
/// returns the status of the result.
template <class Member, class Output, class... Others>
int put(Status status, Member const &member, Output output, Others const &...others) noexcept
{
    store_member(status, member, output);
    return put(status, others...);
}

/// Fills an array with NaN, unless it is null.
inline void store_nan(double *x, int count) noexcept
{
    for (int i = 0; x != nullptr && i < count; ++i) x[i] = quiet_nan<double>();
}

/// Returns the status for a null pointer.
inline int null_pointer() noexcept { return static_cast<int>(Status::invalid_argument); }

/// Returns the status for a null pointer, and fills the outputs that are not null with NaN: arrays,
/// each followed by its length.
template <class... Outputs> int null_pointer(double *out, int count, Outputs... outputs) noexcept
{
    store_nan(out, count);
    return null_pointer(outputs...);
}

} // namespace
} // namespace pw85::detail::c_api

#endif

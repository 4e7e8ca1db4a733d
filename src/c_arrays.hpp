// Converts between the arrays of the C API and the values of the C++ headers. All shims of the C API use it.
#ifndef PW85_C_ARRAYS_HPP_INCLUDED
#define PW85_C_ARRAYS_HPP_INCLUDED

#include <cstring>
#include <type_traits>

#include <pw85/algebra/factor.hpp>
#include <pw85/status.hpp>

namespace pw85::detail::c_api {
namespace {

inline bool any_null() noexcept { return false; }

/// Whether any of the pointers is null.
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

/// A type with the layout of an array of the C API, as that array. Nothing is copied: a copy would pass through memory where a
/// function that is not inlined reads it.
template <class Type> Type const &view(double const *x) noexcept
{
    static_assert(std::is_standard_layout_v<Type> && alignof(Type) == alignof(double));
    return *reinterpret_cast<Type const *>(x);
}

template <int D> Factor<double, D> load_factor(double const *a) noexcept
{
    Factor<double, D> s;
    std::memcpy(s.entries, a, sizeof s.entries);
    return s;
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

/// Fills an array with NaN, unless it is null.
inline void store_nan(double *x, int count) noexcept
{
    for (int i = 0; x != nullptr && i < count; ++i) x[i] = quiet_nan<double>();
}

/// The status for a null pointer.
inline int null_pointer() noexcept { return static_cast<int>(Status::invalid_argument); }

/// The same; it also fills outputs with NaN that are not null: arrays, each followed by its length.
template <class... Outputs> int null_pointer(double *out, int count, Outputs... outputs) noexcept
{
    store_nan(out, count);
    return null_pointer(outputs...);
}

} // namespace
} // namespace pw85::detail::c_api

#endif

/// @file
/// Calls functions of the C API with spans. The functions here compare the sizes of spans, and convert rows to pointers to their
/// numbers. rows.hpp, lists.hpp, systems.hpp and the Python module call them.
#ifndef PW85_BATCH_CALLS_HPP_INCLUDED
#define PW85_BATCH_CALLS_HPP_INCLUDED

#include <pw85.h>

#include <algorithm>

#include <pw85/batch/values.hpp>

namespace pw85::detail {

/// The type of the numbers in C of which a row consists.
template <class Row> struct ElementOf {
    static_assert(sizeof(Row) % sizeof(double) == 0);
    using Type = double;
};
template <> struct ElementOf<unsigned char> {
    using Type = unsigned char;
};
template <> struct ElementOf<int> {
    using Type = int;
};
template <> struct ElementOf<std::int64_t> {
    using Type = std::int64_t;
};
template <std::size_t N> struct ElementOf<std::array<std::int32_t, N>> {
    static_assert(sizeof(std::array<std::int32_t, N>) == N * sizeof(std::int32_t));
    using Type = std::int32_t;
};
template <> struct ElementOf<Motion<double, 3>> {
    static_assert(sizeof(Motion<double, 3>) == sizeof(pw85_motion));
    using Type = pw85_motion;
};

static_assert(sizeof(Vector<double, 2>) == 2 * sizeof(double));
static_assert(sizeof(SymmetricMatrix<double, 2>) == 3 * sizeof(double));
static_assert(sizeof(Vector<double, 3>) == 3 * sizeof(double));
static_assert(sizeof(SymmetricMatrix<double, 3>) == 6 * sizeof(double));
static_assert(sizeof(Vector<double, 4>) == 4 * sizeof(double));
static_assert(sizeof(Cell) == 9 * sizeof(double));

/// Whether an array has n rows, or is left out.
template <class Row> static bool fits(std::size_t n, std::span<Row> rows) noexcept
{
    return rows.empty() || rows.size() == n;
}

// Arguments of functions of n rows. Inputs have n rows. Outputs have n rows or none; those without rows are null in C.

template <class Row> static bool has_rows(std::size_t n, std::span<Row const> input) noexcept
{
    return input.size() == n;
}

template <class Row> static bool has_rows(std::size_t n, std::span<Row> output) noexcept { return fits(n, output); }

static inline bool has_rows(std::size_t, double) noexcept { return true; }

template <class Row> static auto in_c(std::span<Row const> input) noexcept
{
    return reinterpret_cast<typename ElementOf<Row>::Type const *>(input.data());
}

template <class Row> static auto in_c(std::span<Row> output) noexcept
{
    return output.empty() ? nullptr : reinterpret_cast<typename ElementOf<Row>::Type *>(output.data());
}

static inline double in_c(double number) noexcept { return number; }

static inline double const *in_c(Cell const *cell) noexcept { return reinterpret_cast<double const *>(cell); }

/// Converts a list. Images are null in C if there are none, which means the nearest images.
static inline pw85_pair_list in_c(PairList const &list) noexcept
{
    return {list.pairs.size(), in_c(list.pairs), list.images.empty() ? nullptr : in_c(list.images)};
}

/// Converts a system. It has as many particles as there are centres, or as there are forms if centres are left out.
static inline pw85_system in_c(Particles const &particles) noexcept
{
    return {(std::max)(particles.centers.size(), particles.q.size()),
            in_c(particles.centers),
            in_c(particles.q),
            in_c(particles.cell),
            {particles.periodic[0], particles.periodic[1], particles.periodic[2]}};
}

/// Calls a function of rows if all arguments have as many rows as the first one.
template <class Function, class First, class... Rest>
static StatusCode call_rows(Function const &function, First first, Rest... rest) noexcept
{
    std::size_t const n = first.size();
    if (!(has_rows(n, rest) && ...)) return StatusCode::invalid_argument;
    return static_cast<StatusCode>(function(n, in_c(first), in_c(rest)...));
}

/// Whether the sizes of a list and of a system are consistent.
static inline bool fit(PairList const &list, Particles const &particles) noexcept
{
    return fits(list.pairs.size(), list.images) && particles.centers.size() == particles.q.size();
}

/// Calls a function of a list and a system, with rows for each pair, if all sizes are consistent.
template <class Function, class... Rows> static StatusCode call_pairs(Function const &function, PairList const &list,
                                                                      Particles const &particles, Rows... rows) noexcept
{
    if (!fit(list, particles) || !(has_rows(list.pairs.size(), rows) && ...)) return StatusCode::invalid_argument;
    pw85_pair_list const c_list = in_c(list);
    pw85_system const system = in_c(particles);
    return static_cast<StatusCode>(function(&c_list, &system, in_c(rows)...));
}

} // namespace pw85::detail

#endif

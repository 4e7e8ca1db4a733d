// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A search for a root t > 0. The caller has a method that suggests steps, such as Newton's. The
/// search keeps them in a bracket of the root, and bisects the bracket if they do not converge.
///
/// The root may be anywhere in the range of the scalar. So the size of a step is its size in log t,
/// and bisection halves the range of log t. The caller loops: it evaluates its function at t,
/// passes a bound on the root to take_bound(), and passes the step that its method suggests to
/// take_step(). The searches for the contact function (factorized_search.hpp), for first contacts
/// and for distances use this search.
#ifndef PW85_CONTACT_SAFEGUARDED_SEARCH_HPP_INCLUDED
#define PW85_CONTACT_SAFEGUARDED_SEARCH_HPP_INCLUDED

#include <pw85/algebra/scalar.hpp>

namespace pw85::detail {

/// The state of a search.
template <class T> struct SafeguardedSearch {
    T t;            ///< the next point, in the bracket
    T lower, upper; ///< the bracket of the root; a limit of the scalar if no bound is known
    T shortest;     ///< the size of the shortest step in log t until now; 2 at the beginning
    T reach;        ///< the factor from the known end of the bracket to the next probe
    int free_steps; ///< number of next steps that may go anywhere in the bracket
};

/// The first probe is the known end of the bracket times 2 to the power of this exponent. Each
/// probe doubles the exponent.
inline constexpr int first_reach = 10;

/// The largest number of probes that are needed if one end of the bracket is known and the root is
/// in the range of `Lane`.
template <class Lane> PW85_FUNCTION consteval int max_probes() noexcept
{
    constexpr long range =
        long{std::numeric_limits<Lane>::max_exponent} - std::numeric_limits<Lane>::min_exponent;
    int probes = 0;
    for (long covered = 0, reach = first_reach; covered < range; covered += reach, reach *= 2)
        ++probes;
    return probes;
}

template <class T>
PW85_FUNCTION inline T clamp(SafeguardedSearch<T> const &search, T const &t) noexcept
{
    return minimum(maximum(t, search.lower), search.upper);
}

/// A search that begins at t.
template <class T>
PW85_FUNCTION inline SafeguardedSearch<T> safeguarded_search(T const &t, int free_steps) noexcept
{
    SafeguardedSearch<T> search{t,    smallest_number<T>(), largest_number<T>(),
                                T(2), T(1 << first_reach),  free_steps};
    search.t = clamp(search, t);
    return search;
}

/// Narrows the bracket to a bound on the root, which is t or lies between t and the root. The bound
/// is a lower one if the root is above t.
template <class T> PW85_FUNCTION inline void take_bound(SafeguardedSearch<T> &search, bool above,
                                                        T const &bound) noexcept
{
    if (above)
        search.lower = maximum(search.lower, bound);
    else
        search.upper = minimum(search.upper, bound);
}

/// Returns whether the width of the bracket in log t is at most `width`.
template <class T>
PW85_FUNCTION inline bool is_narrow(SafeguardedSearch<T> const &search, T const &width) noexcept
{
    return search.upper <= search.lower + width * search.lower;
}

/// Returns whether a step is at most half as long as the shortest one until now. The steps of a
/// method that converges are.
template <class T>
PW85_FUNCTION inline bool halves(SafeguardedSearch<T> const &search, T const &size) noexcept
{
    return size <= T(0.5) * search.shortest;
}

/// The next point if the steps do not converge: the middle of the bracket in log t. If only one end
/// of the bracket is known, it is a point beyond that end, farther with each probe, as long as this
/// is in the bracket.
template <class T> PW85_FUNCTION inline T probe(SafeguardedSearch<T> &search) noexcept
{
    bool const below = !(search.lower > smallest_number<T>());
    bool const above = !(search.upper < largest_number<T>());
    if (below || above) {
        T const t = below ? T(search.upper / search.reach) : T(search.lower * search.reach);
        if (t > search.lower && t < search.upper) {
            search.reach = search.reach * search.reach;
            return t;
        }
    }
    return square_root(search.lower) * square_root(search.upper);
}

/// Goes to `next`, or as far as the bracket allows.
template <class T>
PW85_FUNCTION inline void go_to(SafeguardedSearch<T> &search, T const &next) noexcept
{
    search.t = clamp(search, next);
    if (search.free_steps > 0) --search.free_steps;
}

/// Goes to `next` by a step of some size in log t, or to a probe() if the step neither halves nor
/// is free.
template <class T> PW85_FUNCTION inline void take_step(SafeguardedSearch<T> &search, T const &next,
                                                       T const &size) noexcept
{
    bool const trusted = search.free_steps > 0 || halves(search, size);
    search.shortest = minimum(search.shortest, size);
    go_to(search, next);
    if (!trusted) search.t = probe(search);
}

} // namespace pw85::detail

#endif

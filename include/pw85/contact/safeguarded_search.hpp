/// @file
/// A search for the place where something changes its sign: whatever steps the caller has, such as Newton's, kept in a bracket, and
/// bisection where they do not converge.
///
/// The unknown t is positive and may be anywhere in the range of the scalar, so log t is what steps are measured in and what is bisected.
/// The caller loops: it looks at t, tells by take_bound() on which side of t the root is, and by take_step() where its method leads.
#ifndef PW85_CONTACT_SAFEGUARDED_SEARCH_HPP_INCLUDED
#define PW85_CONTACT_SAFEGUARDED_SEARCH_HPP_INCLUDED

#include <pw85/algebra/scalar.hpp>

namespace pw85::detail {

/// The state of a search.
template <class T> struct SafeguardedSearch {
    T t;            ///< where to look next, in the bracket
    T lower, upper; ///< the bracket of the root; the limits of the scalar where no bound is known
    T shortest;     ///< of the steps in log t until now, 2 at the beginning
    T reach;        ///< the factor from the end that is known to the next probe
    int free_steps; ///< how many of the next steps may go anywhere in the bracket
};

/// The exponent of the first probe's factor; that of each later one is twice the one before.
inline constexpr int first_reach = 10;

/// The largest number of probes that are needed where one end of the bracket is known and the root is in the range of `Lane`.
template <class Lane> PW85_FUNCTION consteval int max_probes() noexcept
{
    constexpr long range = long{std::numeric_limits<Lane>::max_exponent} - std::numeric_limits<Lane>::min_exponent;
    int probes = 0;
    for (long covered = 0, reach = first_reach; covered < range; covered += reach, reach *= 2) ++probes;
    return probes;
}

template <class T> PW85_FUNCTION inline T clamp(SafeguardedSearch<T> const &search, T const &t) noexcept
{
    return minimum(maximum(t, search.lower), search.upper);
}

/// A search that begins at t.
template <class T> PW85_FUNCTION inline SafeguardedSearch<T> safeguarded_search(T const &t, int free_steps) noexcept
{
    SafeguardedSearch<T> search{t, smallest_number<T>(), largest_number<T>(), T(2), T(1 << first_reach), free_steps};
    search.t = clamp(search, t);
    return search;
}

/// Takes note of a bound, t or something between t and the root: one from below where the root is above t.
template <class T>
PW85_FUNCTION inline void take_bound(SafeguardedSearch<T> &search, bool above, T const &bound) noexcept
{
    if (above)
        search.lower = maximum(search.lower, bound);
    else
        search.upper = minimum(search.upper, bound);
}

/// Whether the bracket leaves no more than a step of `width` in log t.
template <class T> PW85_FUNCTION inline bool is_narrow(SafeguardedSearch<T> const &search, T const &width) noexcept
{
    return search.upper <= search.lower + width * search.lower;
}

/// Whether a step is at most half of the shortest until now, as those of a method that converges are.
template <class T> PW85_FUNCTION inline bool halves(SafeguardedSearch<T> const &search, T const &size) noexcept
{
    return size <= T(0.5) * search.shortest;
}

/// The middle of the bracket in log t, or a point far beyond the only end that is known, the farther the more were tried, if it is in the
/// bracket.
template <class T> PW85_FUNCTION inline T probe(SafeguardedSearch<T> &search) noexcept
{
    bool const below = !(search.lower > smallest_number<T>());
    bool const above = !(search.upper < largest_number<T>());
    if (below || above) {
        T const t = below ? T(search.upper / search.reach) : T(search.lower * search.reach);
        search.reach = search.reach * search.reach;
        if (t > search.lower && t < search.upper) return t;
    }
    return square_root(search.lower) * square_root(search.upper);
}

/// Goes to `next`, or as far as the bracket allows.
template <class T> PW85_FUNCTION inline void go_to(SafeguardedSearch<T> &search, T const &next) noexcept
{
    search.t = clamp(search, next);
    if (search.free_steps > 0) --search.free_steps;
}

/// Goes to `next` by a step of some size in log t, or to a probe() if the step neither halves nor is free.
template <class T>
PW85_FUNCTION inline void take_step(SafeguardedSearch<T> &search, T const &next, T const &size) noexcept
{
    bool const trusted = search.free_steps > 0 || halves(search, size);
    search.shortest = minimum(search.shortest, size);
    go_to(search, next);
    if (!trusted) search.t = probe(search);
}

} // namespace pw85::detail

#endif

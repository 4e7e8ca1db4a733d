/// @file
/// The last tier of the overlap test.
#ifndef PW85_EXACT_HPP_INCLUDED
#define PW85_EXACT_HPP_INCLUDED

#include <pw85/decision.hpp>
#include <pw85/dyadic.hpp>
#include <pw85/rational.hpp>

namespace pw85 {

/// A polynomial of degree up to 4, in increasing powers.
struct ExactPolynomial {
    Dyadic c[5];
    int degree;

    void trim() noexcept
    {
        while (degree >= 0 && c[degree].sign() == 0) --degree;
    }
};

/// Minus the remainder of p by q, times a positive number.
static inline ExactPolynomial negative_remainder(ExactPolynomial p, ExactPolynomial const &q) noexcept
{
    bool negative = true;
    while (p.degree >= q.degree) {
        Dyadic const lead = p.c[p.degree];
        int const shift = p.degree - q.degree;
        for (int i = 0; i < p.degree; ++i) {
            p.c[i] = p.c[i] * q.c[q.degree];
            if (i >= shift) p.c[i] = p.c[i] - lead * q.c[i - shift];
        }
        if (q.c[q.degree].sign() < 0) negative = !negative;
        --p.degree;
        p.trim();
    }
    for (int i = 0; negative && i <= p.degree; ++i) p.c[i] = -p.c[i];
    return p;
}

/// The number of distinct roots of p in (0, ∞), by Sturm's theorem; p(0) != 0. `exact` becomes false if a number did not fit.
static inline int count_positive_roots(ExactPolynomial p, bool &exact) noexcept
{
    p.trim();
    ExactPolynomial q{{}, p.degree - 1};
    for (int i = 1; i <= p.degree; ++i) q.c[i - 1] = Dyadic(i) * p.c[i];
    int at_zero = 0, at_infinity = 0, sign_at_zero = 0, sign_at_infinity = 0;
    while (p.degree >= 0) {
        for (int i = 0; i <= p.degree; ++i) exact = exact && p.c[i].is_exact();
        if (!exact) return 0;
        int const zero = p.c[0].sign(), infinity = p.c[p.degree].sign();
        if (zero * sign_at_zero < 0) ++at_zero;
        if (infinity * sign_at_infinity < 0) ++at_infinity;
        if (zero != 0) sign_at_zero = zero;
        sign_at_infinity = infinity;
        ExactPolynomial const next = q.degree >= 0 ? negative_remainder(p, q) : q;
        p = q;
        q = next;
    }
    return at_zero - at_infinity;
}

/// Item 3, for the numbers as they were given. Not certain if their magnitudes span so many binades that 16384 bits do not
/// hold what comes of them.
template <class T, int D> [[gnu::noinline]] static inline Decision
decide_exactly(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    Vector<Dyadic, D> r;
    SymmetricMatrix<Dyadic, D> p, q;
    for (int i = 0; i < D; ++i) r[i] = Dyadic(r12[i]);
    for (int k = 0; k < p.size; ++k) {
        p[k] = Dyadic(q1[k]);
        q[k] = Dyadic(q2[k]);
    }
    auto const form = rational_form(Pair<Dyadic, D>{r, p, q, Dyadic(1)});
    ExactPolynomial quartic{{-form.b[0], form.a[0] - form.b[1] - form.b[0], form.a[1] - form.b[2] - form.b[1],
                             form.a[2] - form.b[3] - form.b[2], -form.b[3]},
                            4};
    bool exact = true;
    bool const has_root = count_positive_roots(quartic, exact) > 0;
    return to_decision(exact && has_root, exact && !has_root);
}

} // namespace pw85

#endif

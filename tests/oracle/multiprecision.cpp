// SPDX-License-Identifier: BSD-3-Clause
#include "multiprecision.hpp"

#define MPFR_USE_NO_MACRO // functions, whose addresses can be taken
#define MPFR_USE_INTMAX_T
#include <mpfr.h>

namespace pw85_tests {

static_assert(64 % GMP_NUMB_BITS == 0 && sizeof(mpfr_exp_t) <= sizeof(long));

/// A number as MPFR sees it. MPFR writes the limbs in place; store() keeps the rest.
template <unsigned Digits> struct Multiprecision<Digits>::View {
    explicit View(Multiprecision const &x) noexcept
    {
        mpfr_custom_init_set(number, x.kind_, x.exponent_, bits,
                             const_cast<unsigned char *>(x.limbs_));
    }

    /// The result of a function of MPFR that takes (result, arguments..., rounding).
    template <class Function, class... Arguments>
    static Multiprecision apply(Function function, Arguments const &...arguments) noexcept
    {
        Multiprecision result;
        View view(result);
        function(view.number, arguments..., MPFR_RNDN);
        result.kind_ = mpfr_custom_get_kind(view.number);
        result.exponent_ = mpfr_regular_p(view.number) ? mpfr_custom_get_exp(view.number) : 0;
        return result;
    }

    mpfr_t number;
};

#define PW85_UNARY(name, function)                                                                 \
    template <unsigned Digits>                                                                     \
    Multiprecision<Digits> Multiprecision<Digits>::name(Multiprecision const &x) noexcept          \
    {                                                                                              \
        return View::apply(function, View(x).number);                                              \
    }
#define PW85_BINARY(name, function)                                                                \
    template <unsigned Digits> Multiprecision<Digits> Multiprecision<Digits>::name(                \
        Multiprecision const &x, Multiprecision const &y) noexcept                                 \
    {                                                                                              \
        return View::apply(function, View(x).number, View(y).number);                              \
    }
#define PW85_COMPARISON(name, function)                                                            \
    template <unsigned Digits>                                                                     \
    bool Multiprecision<Digits>::name(Multiprecision const &x, Multiprecision const &y) noexcept   \
    {                                                                                              \
        return function(View(x).number, View(y).number) != 0;                                      \
    }

PW85_BINARY(sum, mpfr_add)
PW85_BINARY(difference, mpfr_sub)
PW85_BINARY(product, mpfr_mul)
PW85_BINARY(quotient, mpfr_div)
PW85_BINARY(angle, mpfr_atan2)
PW85_BINARY(power, mpfr_pow)
PW85_UNARY(negative, mpfr_neg)
PW85_UNARY(absolute, mpfr_abs)
PW85_UNARY(root, mpfr_sqrt)
PW85_UNARY(cube_root, mpfr_cbrt)
PW85_UNARY(exponential, mpfr_exp)
PW85_UNARY(logarithm, mpfr_log)
PW85_UNARY(sine, mpfr_sin)
PW85_UNARY(cosine, mpfr_cos)
PW85_COMPARISON(less, mpfr_less_p)
PW85_COMPARISON(less_equal, mpfr_lessequal_p)
PW85_COMPARISON(equal, mpfr_equal_p)

template <unsigned Digits>
Multiprecision<Digits> Multiprecision<Digits>::rounded_down(Multiprecision const &x) noexcept
{
    return View::apply([](auto to, auto from, auto) { mpfr_floor(to, from); }, View(x).number);
}

template <unsigned Digits>
Multiprecision<Digits> Multiprecision<Digits>::scaled(Multiprecision const &x, int n) noexcept
{
    return View::apply([n](auto to, auto from, auto mode) { mpfr_mul_2si(to, from, n, mode); },
                       View(x).number);
}

template <unsigned Digits>
Multiprecision<Digits> Multiprecision<Digits>::from_floating(long double x) noexcept
{
    return View::apply([x](auto to, auto mode) { mpfr_set_ld(to, x, mode); });
}

template <unsigned Digits>
Multiprecision<Digits> Multiprecision<Digits>::from_signed(std::intmax_t x) noexcept
{
    return View::apply([x](auto to, auto mode) { mpfr_set_sj(to, x, mode); });
}

template <unsigned Digits>
Multiprecision<Digits> Multiprecision<Digits>::from_unsigned(std::uintmax_t x) noexcept
{
    return View::apply([x](auto to, auto mode) { mpfr_set_uj(to, x, mode); });
}

template <unsigned Digits> template <unsigned Other>
Multiprecision<Digits>::Multiprecision(Multiprecision<Other> const &x) noexcept
    : Multiprecision(View::apply(mpfr_set, typename Multiprecision<Other>::View(x).number))
{
}

template <unsigned Digits> Multiprecision<Digits>::Multiprecision(char const *text) noexcept
    : Multiprecision(View::apply([text](auto to, auto mode) { mpfr_set_str(to, text, 10, mode); }))
{
}

template <unsigned Digits> Multiprecision<Digits>::operator double() const noexcept
{
    return mpfr_get_d(View(*this).number, MPFR_RNDN);
}

template <unsigned Digits> Multiprecision<Digits>::operator long double() const noexcept
{
    return mpfr_get_ld(View(*this).number, MPFR_RNDN);
}

template <unsigned Digits> Multiprecision<Digits>::operator float() const noexcept
{
    return mpfr_get_flt(View(*this).number, MPFR_RNDN);
}

template <unsigned Digits> std::string Multiprecision<Digits>::str() const
{
    char text[64];
    mpfr_snprintf(text, sizeof text, "%.40Rg", View(*this).number);
    return text;
}

template <unsigned Digits> int Multiprecision<Digits>::binary_exponent() const noexcept
{
    return static_cast<int>(exponent_) - 1;
}

template class Multiprecision<20>;
template class Multiprecision<50>;
template class Multiprecision<100>;
template class Multiprecision<200>;
template class Multiprecision<360>;
template Multiprecision<100>::Multiprecision(Multiprecision<50> const &) noexcept;
template Multiprecision<200>::Multiprecision(Multiprecision<50> const &) noexcept;
template Multiprecision<50>::Multiprecision(Multiprecision<100> const &) noexcept;
template Multiprecision<50>::Multiprecision(Multiprecision<200> const &) noexcept;

} // namespace pw85_tests

// SPDX-License-Identifier: BSD-3-Clause
// Integers of any size and fractions of them (GMP): what is exact in the truths of the tests.
#ifndef PW85_TESTS_ORACLE_EXACT_NUMBERS_HPP_INCLUDED
#define PW85_TESTS_ORACLE_EXACT_NUMBERS_HPP_INCLUDED

#include <cmath>
#include <compare>
#include <concepts>
#include <utility>

#include <gmp.h>

namespace pw85_tests {

class Integer {
  public:
    Integer() { mpz_init(value_); }
    Integer(std::integral auto x)
    {
        auto const wide = static_cast<long long>(x);
        mpz_init_set_d(value_, static_cast<double>(wide >> 32));
        mpz_mul_2exp(value_, value_, 32);
        mpz_add_ui(value_, value_, static_cast<unsigned long>(wide & 0xffffffff));
    }
    /// Without what is behind the point; x is in the range of doubles.
    explicit Integer(std::floating_point auto x)
    {
        auto const whole = std::trunc(x);
        auto const high = static_cast<double>(whole);
        mpz_init_set_d(value_, high);
        if (whole != high) *this += Integer(static_cast<double>(whole - high));
    }
    Integer(Integer const &x) { mpz_init_set(value_, x.value_); }
    Integer(Integer &&x) noexcept : Integer() { mpz_swap(value_, x.value_); }
    ~Integer() { mpz_clear(value_); }
    Integer &operator=(Integer x) noexcept
    {
        mpz_swap(value_, x.value_);
        return *this;
    }

    explicit operator double() const { return mpz_get_d(value_); }
    int sign() const { return mpz_sgn(value_); }

    Integer &operator+=(Integer const &x) { return mpz_add(value_, value_, x.value_), *this; }
    Integer &operator-=(Integer const &x) { return mpz_sub(value_, value_, x.value_), *this; }
    Integer &operator*=(Integer const &x) { return mpz_mul(value_, value_, x.value_), *this; }

    friend Integer operator+(Integer x, Integer const &y) { return x += y; }
    friend Integer operator-(Integer x, Integer const &y) { return x -= y; }
    friend Integer operator*(Integer x, Integer const &y) { return x *= y; }
    /// Towards zero.
    friend Integer operator/(Integer x, Integer const &y)
    {
        mpz_tdiv_q(x.value_, x.value_, y.value_);
        return x;
    }
    friend Integer operator<<(Integer x, int shift)
    {
        mpz_mul_2exp(x.value_, x.value_, static_cast<mp_bitcnt_t>(shift));
        return x;
    }
    friend Integer operator-(Integer x)
    {
        mpz_neg(x.value_, x.value_);
        return x;
    }
    friend Integer abs(Integer x)
    {
        mpz_abs(x.value_, x.value_);
        return x;
    }
    /// The largest integer that is not larger than the root.
    friend Integer sqrt(Integer x)
    {
        mpz_sqrt(x.value_, x.value_);
        return x;
    }
    friend bool operator==(Integer const &x, Integer const &y) { return (x <=> y) == 0; }
    friend std::strong_ordering operator<=>(Integer const &x, Integer const &y)
    {
        return mpz_cmp(x.value_, y.value_) <=> 0;
    }

  private:
    mpz_t value_;
};

class Rational {
  public:
    Rational() { mpq_init(value_); }
    Rational(int x) : Rational() { mpq_set_si(value_, x, 1); }
    /// A finite number, exactly.
    Rational(std::floating_point auto x) : Rational()
    {
        int exponent = 0;
        auto const fraction = std::frexp(x, &exponent);
        auto const high = static_cast<double>(fraction);
        mpq_set_d(value_, high);
        if (fraction != high) *this += Rational(static_cast<double>(fraction - high));
        if (exponent < 0)
            mpq_div_2exp(value_, value_, static_cast<mp_bitcnt_t>(-exponent));
        else
            mpq_mul_2exp(value_, value_, static_cast<mp_bitcnt_t>(exponent));
    }
    Rational(Rational const &x) : Rational() { mpq_set(value_, x.value_); }
    Rational(Rational &&x) noexcept : Rational() { mpq_swap(value_, x.value_); }
    ~Rational() { mpq_clear(value_); }
    Rational &operator=(Rational x) noexcept
    {
        mpq_swap(value_, x.value_);
        return *this;
    }

    explicit operator double() const { return mpq_get_d(value_); }
    int sign() const { return mpq_sgn(value_); }

    Rational &operator+=(Rational const &x) { return mpq_add(value_, value_, x.value_), *this; }
    Rational &operator-=(Rational const &x) { return mpq_sub(value_, value_, x.value_), *this; }
    Rational &operator*=(Rational const &x) { return mpq_mul(value_, value_, x.value_), *this; }
    Rational &operator/=(Rational const &x) { return mpq_div(value_, value_, x.value_), *this; }

    friend Rational operator+(Rational x, Rational const &y) { return x += y; }
    friend Rational operator-(Rational x, Rational const &y) { return x -= y; }
    friend Rational operator*(Rational x, Rational const &y) { return x *= y; }
    friend Rational operator/(Rational x, Rational const &y) { return x /= y; }
    friend Rational operator-(Rational x)
    {
        mpq_neg(x.value_, x.value_);
        return x;
    }
    friend Rational abs(Rational x)
    {
        mpq_abs(x.value_, x.value_);
        return x;
    }
    friend bool operator==(Rational const &x, Rational const &y) { return (x <=> y) == 0; }
    friend std::strong_ordering operator<=>(Rational const &x, Rational const &y)
    {
        return mpq_cmp(x.value_, y.value_) <=> 0;
    }

  private:
    mpq_t value_;
};

} // namespace pw85_tests

#endif

// SPDX-License-Identifier: BSD-3-Clause
// Numbers of many digits for the truths of the tests. All operations are compiled once, in
// multiprecision.cpp, so that a template of the core with such a number is a sequence of calls,
// which takes a tenth of the time to compile.
#ifndef PW85_TESTS_ORACLE_MULTIPRECISION_HPP_INCLUDED
#define PW85_TESTS_ORACLE_MULTIPRECISION_HPP_INCLUDED

#include <concepts>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>

namespace pw85_tests {

/// A binary floating-point number with at least `Digits` decimal digits and exponents to ±2^62,
/// correctly rounded (MPFR). It is a plain value: MPFR gets the limbs for the time of a call.
template <unsigned Digits> class Multiprecision {
    static_assert(Digits == 20 || Digits == 50 || Digits == 100 || Digits == 200 || Digits == 360,
                  "multiprecision.cpp has the operations of these");

  public:
    static constexpr int bits = (static_cast<int>(Digits) * 3322 / 1000 + 2 + 63) / 64 * 64;

    constexpr Multiprecision() noexcept : kind_(zero_kind), exponent_(0), limbs_{} {}
    Multiprecision(std::floating_point auto x) noexcept : Multiprecision(from_floating(x)) {}
    Multiprecision(std::signed_integral auto x) noexcept : Multiprecision(from_signed(x)) {}
    Multiprecision(std::unsigned_integral auto x) noexcept : Multiprecision(from_unsigned(x)) {}
    template <unsigned Other> explicit Multiprecision(Multiprecision<Other> const &x) noexcept;
    /// A decimal number.
    explicit Multiprecision(char const *text) noexcept;

    explicit operator double() const noexcept;
    explicit operator long double() const noexcept;
    /// Rounded once.
    explicit operator float() const noexcept;
    explicit operator int() const noexcept { return static_cast<int>(static_cast<double>(*this)); }
    std::string str() const;
    friend std::ostream &operator<<(std::ostream &stream, Multiprecision const &x)
    {
        return stream << x.str();
    }

    Multiprecision &operator+=(Multiprecision const &x) noexcept { return *this = sum(*this, x); }
    Multiprecision &operator-=(Multiprecision const &x) noexcept
    {
        return *this = difference(*this, x);
    }
    Multiprecision &operator*=(Multiprecision const &x) noexcept
    {
        return *this = product(*this, x);
    }
    Multiprecision &operator/=(Multiprecision const &x) noexcept
    {
        return *this = quotient(*this, x);
    }
    Multiprecision &operator++() noexcept { return *this += 1; }

    friend Multiprecision operator+(Multiprecision const &x, Multiprecision const &y) noexcept
    {
        return sum(x, y);
    }
    friend Multiprecision operator-(Multiprecision const &x, Multiprecision const &y) noexcept
    {
        return difference(x, y);
    }
    friend Multiprecision operator*(Multiprecision const &x, Multiprecision const &y) noexcept
    {
        return product(x, y);
    }
    friend Multiprecision operator/(Multiprecision const &x, Multiprecision const &y) noexcept
    {
        return quotient(x, y);
    }
    friend Multiprecision operator-(Multiprecision const &x) noexcept { return negative(x); }
    friend Multiprecision operator+(Multiprecision const &x) noexcept { return x; }

    friend bool operator<(Multiprecision const &x, Multiprecision const &y) noexcept
    {
        return less(x, y);
    }
    friend bool operator>(Multiprecision const &x, Multiprecision const &y) noexcept
    {
        return less(y, x);
    }
    friend bool operator<=(Multiprecision const &x, Multiprecision const &y) noexcept
    {
        return less_equal(x, y);
    }
    friend bool operator>=(Multiprecision const &x, Multiprecision const &y) noexcept
    {
        return less_equal(y, x);
    }
    friend bool operator==(Multiprecision const &x, Multiprecision const &y) noexcept
    {
        return equal(x, y);
    }

    friend Multiprecision abs(Multiprecision const &x) noexcept { return absolute(x); }
    friend Multiprecision fabs(Multiprecision const &x) noexcept { return absolute(x); }
    friend Multiprecision sqrt(Multiprecision const &x) noexcept { return root(x); }
    friend Multiprecision cbrt(Multiprecision const &x) noexcept { return cube_root(x); }
    friend Multiprecision exp(Multiprecision const &x) noexcept { return exponential(x); }
    friend Multiprecision log(Multiprecision const &x) noexcept { return logarithm(x); }
    friend Multiprecision sin(Multiprecision const &x) noexcept { return sine(x); }
    friend Multiprecision cos(Multiprecision const &x) noexcept { return cosine(x); }
    friend Multiprecision atan(Multiprecision const &x) noexcept { return angle(x, 1); }
    friend Multiprecision atan2(Multiprecision const &y, Multiprecision const &x) noexcept
    {
        return angle(y, x);
    }
    friend Multiprecision pow(Multiprecision const &x, Multiprecision const &y) noexcept
    {
        return power(x, y);
    }
    friend Multiprecision floor(Multiprecision const &x) noexcept { return rounded_down(x); }
    friend Multiprecision ldexp(Multiprecision const &x, int n) noexcept { return scaled(x, n); }
    friend Multiprecision frexp(Multiprecision const &x, int *exponent) noexcept
    {
        *exponent = x == 0 ? 0 : x.binary_exponent() + 1;
        return scaled(x, -*exponent);
    }
    friend int ilogb(Multiprecision const &x) noexcept { return x.binary_exponent(); }
    friend bool isnan(Multiprecision const &x) noexcept { return !(x == x); }
    friend bool isinf(Multiprecision const &x) noexcept { return x == x && !isfinite(x); }
    friend bool isfinite(Multiprecision const &x) noexcept { return (x - x) == 0; }

  private:
    template <unsigned Other> friend class Multiprecision;
    struct View;

    static constexpr int zero_kind = 2; // MPFR's number for zeros

    static Multiprecision from_floating(long double x) noexcept;
    static Multiprecision from_signed(std::intmax_t x) noexcept;
    static Multiprecision from_unsigned(std::uintmax_t x) noexcept;
    static Multiprecision sum(Multiprecision const &x, Multiprecision const &y) noexcept;
    static Multiprecision difference(Multiprecision const &x, Multiprecision const &y) noexcept;
    static Multiprecision product(Multiprecision const &x, Multiprecision const &y) noexcept;
    static Multiprecision quotient(Multiprecision const &x, Multiprecision const &y) noexcept;
    static Multiprecision negative(Multiprecision const &x) noexcept;
    static bool less(Multiprecision const &x, Multiprecision const &y) noexcept;
    static bool less_equal(Multiprecision const &x, Multiprecision const &y) noexcept;
    static bool equal(Multiprecision const &x, Multiprecision const &y) noexcept;
    static Multiprecision absolute(Multiprecision const &x) noexcept;
    static Multiprecision root(Multiprecision const &x) noexcept;
    static Multiprecision cube_root(Multiprecision const &x) noexcept;
    static Multiprecision exponential(Multiprecision const &x) noexcept;
    static Multiprecision logarithm(Multiprecision const &x) noexcept;
    static Multiprecision sine(Multiprecision const &x) noexcept;
    static Multiprecision cosine(Multiprecision const &x) noexcept;
    static Multiprecision angle(Multiprecision const &y, Multiprecision const &x) noexcept;
    static Multiprecision power(Multiprecision const &x, Multiprecision const &y) noexcept;
    static Multiprecision rounded_down(Multiprecision const &x) noexcept;
    static Multiprecision scaled(Multiprecision const &x, int n) noexcept;
    int binary_exponent() const noexcept;

    int kind_; // sign, and zero, infinite, not a number or regular
    long exponent_;
    alignas(8) unsigned char limbs_[std::size_t(bits / 8)];
};

} // namespace pw85_tests

/// The limits of what MPFR computes with; as for a type of Boost, the exponents have practically
/// none.
template <unsigned Digits> class std::numeric_limits<pw85_tests::Multiprecision<Digits>> {
    using Number = pw85_tests::Multiprecision<Digits>;

  public:
    static constexpr bool is_specialized = true, is_signed = true, is_integer = false,
                          is_exact = false;
    static constexpr bool has_infinity = true, has_quiet_NaN = true, is_bounded = true,
                          is_iec559 = false;
    static constexpr int radix = 2, digits = Number::bits, digits10 = (digits - 1) * 30103 / 100000;
    static constexpr int max_digits10 = digits10 + 3, max_exponent = 1 << 29,
                         min_exponent = -max_exponent;
    static constexpr int max_exponent10 = 161614248, min_exponent10 = -max_exponent10;
    static constexpr std::float_round_style round_style = std::round_to_nearest;

    static Number epsilon() noexcept { return ldexp(Number(1), 1 - digits); }
    static Number max() noexcept { return ldexp(Number(1) - epsilon() / 2, max_exponent); }
    static Number min() noexcept { return ldexp(Number(1), min_exponent - 1); }
    static Number lowest() noexcept { return -max(); }
    static Number infinity() noexcept { return Number(std::numeric_limits<double>::infinity()); }
    static Number quiet_NaN() noexcept { return Number(std::numeric_limits<double>::quiet_NaN()); }
};

#endif

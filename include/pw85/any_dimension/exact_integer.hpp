// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Integers of any size, in memory of their own. exact_sign.hpp computes determinants and Sturm's
/// sequence with them. If there is no memory for a result, the result is the value `undefined`, and
/// so are all results that are computed from it.
#ifndef PW85_ANY_DIMENSION_EXACT_INTEGER_HPP_INCLUDED
#define PW85_ANY_DIMENSION_EXACT_INTEGER_HPP_INCLUDED

#include <pw85/algebra/powers_of_two.hpp>
#include <pw85/algebra/wide_integer.hpp>

#include <cstdlib>
#include <utility>

namespace pw85::detail::any_dimension {

using exact::Limb, exact::DoubleLimb, exact::SignedDoubleLimb, exact::limb_bits;

/// sign·Σ limbs[i] 2^(limb_bits·i). The highest limb is not zero.
class Integer {
  public:
    static constexpr int undefined = 2;

    [[gnu::always_inline]] Integer() noexcept = default;
    [[gnu::always_inline]] Integer(Integer &&x) noexcept
        : limbs_(std::exchange(x.limbs_, nullptr)), size_(std::exchange(x.size_, 0)),
          sign_(std::exchange(x.sign_, 0))
    {
    }
    [[gnu::always_inline]] Integer &operator=(Integer &&x) noexcept
    {
        std::swap(limbs_, x.limbs_);
        std::swap(size_, x.size_);
        std::swap(sign_, x.sign_);
        return *this;
    }
    [[gnu::always_inline]] ~Integer() { std::free(limbs_); }

    /// Makes limbs that are zero and must be filled; undefined if there is no memory.
    [[gnu::always_inline]] Integer(int sign, std::size_t size) noexcept
        : limbs_(static_cast<Limb *>(std::calloc(size, sizeof(Limb)))), size_(size), sign_(sign)
    {
        if (limbs_ == nullptr) size_ = 0, sign_ = undefined;
    }

    [[gnu::always_inline]] int sign() const noexcept { return sign_; }
    [[gnu::always_inline]] bool is_defined() const noexcept { return sign_ != undefined; }
    [[gnu::always_inline]] std::size_t size() const noexcept { return size_; }
    [[gnu::always_inline]] Limb const *limbs() const noexcept { return limbs_; }
    [[gnu::always_inline]] Limb *limbs() noexcept { return limbs_; }
    [[gnu::always_inline]] void set_sign(int sign) noexcept
    {
        if (sign_ != 0 && sign_ != undefined) sign_ = sign;
    }
    [[gnu::always_inline]] void negate() noexcept { set_sign(-sign_); }
    /// Removes zero limbs at the top.
    [[gnu::always_inline]] void trim() noexcept
    {
        while (size_ > 0 && limbs_[size_ - 1] == 0) --size_;
        if (size_ == 0 && sign_ != undefined) sign_ = 0;
    }

  private:
    Limb *limbs_ = nullptr;
    std::size_t size_ = 0;
    int sign_ = 0;
};

PW85_FUNCTION inline Integer undefined_integer() noexcept
{
    Integer x(1, 1);
    x.set_sign(Integer::undefined);
    return x;
}

/// Returns x 2^exponent, which must be an integer, for any finite x.
PW85_FUNCTION inline Integer to_integer(double x, long exponent) noexcept
{
    if (x == 0.0) return {};
    int const e = binary_exponent(absolute(x)) - 52;
    auto mantissa = static_cast<std::uint64_t>(times_power_of_two(absolute(x), -e));
    long shift = e + exponent;
    if (shift < 0) {
        mantissa >>= -shift;
        shift = 0;
    }
    auto const whole = static_cast<std::size_t>(shift / limb_bits);
    Integer result(x < 0.0 ? -1 : 1, whole + 128 / limb_bits + 1);
    if (!result.is_defined()) return result;
    for (int bit = 0; bit < 53; ++bit) {
        auto const place = static_cast<std::size_t>(shift) + static_cast<std::size_t>(bit);
        result.limbs()[place / limb_bits] |= static_cast<Limb>(mantissa >> bit & 1)
                                             << place % limb_bits;
    }
    result.trim();
    return result;
}

/// Returns the sign of |x| - |y|.
PW85_FUNCTION inline int compare_magnitudes(Integer const &x, Integer const &y) noexcept
{
    if (x.size() != y.size()) return x.size() > y.size() ? 1 : -1;
    for (std::size_t i = x.size(); i-- > 0;)
        if (x.limbs()[i] != y.limbs()[i]) return x.limbs()[i] > y.limbs()[i] ? 1 : -1;
    return 0;
}

/// Returns x + sign·y, with sign = ±1.
[[gnu::noinline]] PW85_FUNCTION inline Integer sum(Integer const &x, Integer const &y,
                                                   int sign) noexcept
{
    if (!x.is_defined() || !y.is_defined()) return undefined_integer();
    int const sign_of_y = sign * y.sign();
    bool const add = x.sign() == 0 || y.sign() == 0 || x.sign() == sign_of_y;
    bool const x_first = compare_magnitudes(x, y) >= 0;
    Integer const &larger = x_first ? x : y, &smaller = x_first ? y : x;
    Integer result(x_first ? x.sign() : sign_of_y, larger.size() + 1);
    if (!result.is_defined()) return result;
    SignedDoubleLimb carry = 0;
    for (std::size_t i = 0; i < larger.size(); ++i) {
        SignedDoubleLimb const other = i < smaller.size() ? smaller.limbs()[i] : Limb{0};
        carry += static_cast<SignedDoubleLimb>(larger.limbs()[i]) + (add ? other : -other);
        result.limbs()[i] = static_cast<Limb>(carry);
        carry >>= limb_bits;
    }
    result.limbs()[larger.size()] = static_cast<Limb>(carry);
    result.trim();
    return result;
}

/// Adds factor·x to y, for `size` limbs of x, and the limb above them.
PW85_FUNCTION inline void add_multiple(Limb *y, Limb const *x, std::size_t size,
                                       Limb factor) noexcept
{
    DoubleLimb carry = 0;
    for (std::size_t j = 0; j < size; ++j) {
        carry += y[j] + DoubleLimb{factor} * x[j];
        y[j] = static_cast<Limb>(carry);
        carry >>= limb_bits;
    }
    y[size] = static_cast<Limb>(carry);
}

[[gnu::noinline]] PW85_FUNCTION inline Integer operator*(Integer const &x,
                                                         Integer const &y) noexcept
{
    if (!x.is_defined() || !y.is_defined()) return undefined_integer();
    if (x.sign() == 0 || y.sign() == 0) return {};
    Integer result(x.sign() * y.sign(), x.size() + y.size());
    if (!result.is_defined()) return result;
    for (std::size_t i = 0; i < x.size(); ++i)
        add_multiple(result.limbs() + i, y.limbs(), y.size(), x.limbs()[i]);
    result.trim();
    return result;
}

PW85_FUNCTION inline Integer operator+(Integer const &x, Integer const &y) noexcept
{
    return sum(x, y, 1);
}
PW85_FUNCTION inline Integer operator-(Integer const &x, Integer const &y) noexcept
{
    return sum(x, y, -1);
}

PW85_FUNCTION inline Integer copy(Integer const &x) noexcept { return x + Integer(); }

/// Returns the number of zero bits below the lowest bit that is set, for x != 0.
PW85_FUNCTION inline std::size_t trailing_zeros(Integer const &x) noexcept
{
    std::size_t i = 0;
    while (x.limbs()[i] == 0) ++i;
    return i * limb_bits + static_cast<std::size_t>(std::countr_zero(x.limbs()[i]));
}

/// Returns |x|/2^zeros, rounded down, for zeros smaller than the bits of x.
PW85_FUNCTION inline Integer shifted_down(Integer const &x, std::size_t zeros) noexcept
{
    std::size_t const whole = zeros / limb_bits;
    int const bits = static_cast<int>(zeros % limb_bits);
    Integer result(1, x.size() - whole);
    for (std::size_t i = 0; i < result.size(); ++i) {
        std::size_t const place = i + whole;
        Limb const high = place + 1 < x.size() ? x.limbs()[place + 1] : Limb{0};
        result.limbs()[i] =
            bits == 0 ? x.limbs()[place]
                      : static_cast<Limb>(x.limbs()[place] >> bits | high << (limb_bits - bits));
    }
    result.trim();
    return result;
}

/// Returns the inverse of an odd number modulo 2^limb_bits. Newton's method doubles the number of
/// correct bits, which is three at first: x² = 1 modulo 8.
PW85_FUNCTION constexpr Limb inverse_of_odd(Limb x) noexcept
{
    Limb y = x;
    for (int bits = 3; bits < limb_bits; bits *= 2) y *= Limb{2} - x * y;
    return y;
}

/// Returns x/y for an x that y divides, from the lowest limb on (T. Jebelean, J. Symbolic Comput.
/// 15, 169, 1993).
[[gnu::noinline]] PW85_FUNCTION inline Integer exact_quotient(Integer const &x,
                                                              Integer const &y) noexcept
{
    if (!x.is_defined() || !y.is_defined()) return undefined_integer();
    if (x.sign() == 0) return {};
    std::size_t const zeros = trailing_zeros(y);
    Integer rest = shifted_down(x, zeros);
    Integer const odd = shifted_down(y, zeros);
    if (!rest.is_defined() || !odd.is_defined()) return undefined_integer();
    Integer quotient(x.sign() * y.sign(), rest.size() - odd.size() + 1);
    if (!quotient.is_defined()) return quotient;
    Limb const inverse = inverse_of_odd(odd.limbs()[0]);
    for (std::size_t i = 0; i < quotient.size(); ++i) {
        Limb const digit = rest.limbs()[i] * inverse;
        quotient.limbs()[i] = digit;
        SignedDoubleLimb carry = 0;
        DoubleLimb product = 0;
        for (std::size_t j = i; j < quotient.size(); ++j) { // only these limbs matter
            if (j - i < odd.size()) product += DoubleLimb{digit} * odd.limbs()[j - i];
            carry += static_cast<SignedDoubleLimb>(rest.limbs()[j]) -
                     static_cast<SignedDoubleLimb>(static_cast<Limb>(product));
            rest.limbs()[j] = static_cast<Limb>(carry);
            carry >>= limb_bits;
            product >>= limb_bits;
        }
    }
    quotient.trim();
    return quotient;
}

} // namespace pw85::detail::any_dimension

#endif

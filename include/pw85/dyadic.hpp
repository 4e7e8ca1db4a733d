/// @file
/// Exact arithmetic on binary fractions, for the few decisions that rounding cannot make.
#ifndef PW85_DYADIC_HPP_INCLUDED
#define PW85_DYADIC_HPP_INCLUDED

#include <cmath>
#include <cstdint>
#include <type_traits>

namespace pw85 {

/// A number ± m·2^(32 e) with an integer m of up to 16384 bits. Sums, differences and products are exact as long as they
/// fit; a result that does not, and all that is computed from it, says so in is_exact().
class Dyadic {
  public:
    Dyadic() noexcept = default;

    Dyadic(int x) noexcept : Dyadic(static_cast<double>(x)) {}

    /// The exact value of a finite number of at most 64 significant bits.
    template <class T>
    requires(!std::is_integral_v<T>) explicit Dyadic(T const &x) noexcept
    {
        using std::frexp;
        using std::ldexp;
        if (x == T(0)) return;
        sign_ = x < T(0) ? -1 : 1;
        int binary_exponent = 0;
        T const fraction = frexp(x < T(0) ? T(-x) : x, &binary_exponent);
        auto const mantissa = static_cast<std::uint64_t>(ldexp(fraction, 64));
        assign(mantissa, binary_exponent - 64);
    }

    int sign() const noexcept { return sign_; }
    bool is_exact() const noexcept { return exact_; }

    Dyadic operator-() const noexcept
    {
        Dyadic result = *this;
        result.sign_ = -sign_;
        return result;
    }

    friend Dyadic operator+(Dyadic const &x, Dyadic const &y) noexcept { return sum(x, y, y.sign_); }
    friend Dyadic operator-(Dyadic const &x, Dyadic const &y) noexcept { return sum(x, y, -y.sign_); }

    [[gnu::noinline]] friend Dyadic operator*(Dyadic const &x, Dyadic const &y) noexcept
    {
        Dyadic z;
        z.exact_ = x.exact_ && y.exact_ && x.size_ + y.size_ <= capacity;
        if (!z.exact_ || x.sign_ * y.sign_ == 0) return z;
        z.size_ = x.size_ + y.size_;
        for (int i = 0; i < z.size_; ++i) z.limbs_[i] = 0;
        for (int i = 0; i < x.size_; ++i) {
            std::uint64_t carry = 0;
            for (int j = 0; j < y.size_; ++j) {
                carry += z.limbs_[i + j] + std::uint64_t{x.limbs_[i]} * y.limbs_[j];
                z.limbs_[i + j] = static_cast<std::uint32_t>(carry);
                carry >>= 32;
            }
            z.limbs_[i + y.size_] = static_cast<std::uint32_t>(carry);
        }
        z.exponent_ = x.exponent_ + y.exponent_;
        z.sign_ = x.sign_ * y.sign_;
        z.trim();
        return z;
    }

  private:
    static constexpr int capacity = 512;

    /// Sets the magnitude mantissa·2^binary_exponent.
    void assign(std::uint64_t mantissa, int binary_exponent) noexcept
    {
        exponent_ = binary_exponent >= 0 ? binary_exponent / 32 : -((31 - binary_exponent) / 32);
        int const shift = binary_exponent - 32 * exponent_;
        std::uint64_t const low = (mantissa & 0xffffffffu) << shift, high = (mantissa >> 32) << shift;
        std::uint64_t const middle = (low >> 32) + (high & 0xffffffffu);
        limbs_[0] = static_cast<std::uint32_t>(low);
        limbs_[1] = static_cast<std::uint32_t>(middle);
        limbs_[2] = static_cast<std::uint32_t>((middle >> 32) + (high >> 32));
        size_ = 3;
        trim();
    }

    /// The limb that weighs 2^(32 position).
    std::uint32_t limb(int position) const noexcept
    {
        int const i = position - exponent_;
        return i >= 0 && i < size_ ? limbs_[i] : 0;
    }

    int top() const noexcept { return exponent_ + size_; }

    /// Drops zero limbs at both ends.
    void trim() noexcept
    {
        while (size_ > 0 && limbs_[size_ - 1] == 0) --size_;
        int zeros = 0;
        while (zeros < size_ && limbs_[zeros] == 0) ++zeros;
        for (int i = zeros; zeros > 0 && i < size_; ++i) limbs_[i - zeros] = limbs_[i];
        size_ -= zeros;
        exponent_ += zeros;
        if (size_ == 0) sign_ = exponent_ = 0;
    }

    static int compare_magnitudes(Dyadic const &x, Dyadic const &y) noexcept
    {
        if (x.top() != y.top()) return x.top() < y.top() ? -1 : 1;
        int const bottom = x.exponent_ < y.exponent_ ? x.exponent_ : y.exponent_;
        for (int p = x.top() - 1; p >= bottom; --p)
            if (x.limb(p) != y.limb(p)) return x.limb(p) < y.limb(p) ? -1 : 1;
        return 0;
    }

    /// x plus |y| with the given sign.
    [[gnu::noinline]] static Dyadic sum(Dyadic const &x, Dyadic const &y, int sign_of_y) noexcept
    {
        bool const exact = x.exact_ && y.exact_;
        if (!exact || sign_of_y == 0 || x.sign_ == 0) {
            Dyadic z = x.sign_ == 0 ? y : x;
            z.sign_ = x.sign_ == 0 ? sign_of_y : x.sign_;
            z.exact_ = exact;
            return z;
        }
        bool const subtract = x.sign_ != sign_of_y;
        bool const swap = subtract && compare_magnitudes(x, y) < 0;
        return combine(swap ? y : x, swap ? x : y, subtract, swap ? sign_of_y : x.sign_);
    }

    /// sign·(|x| ± |y|), where a difference is not negative.
    static Dyadic combine(Dyadic const &x, Dyadic const &y, bool subtract, int sign) noexcept
    {
        Dyadic z;
        z.exponent_ = x.exponent_ < y.exponent_ ? x.exponent_ : y.exponent_;
        int const size = (x.top() > y.top() ? x.top() : y.top()) - z.exponent_ + 1;
        z.exact_ = size <= capacity;
        if (!z.exact_) return z;
        std::int64_t carry = 0;
        for (int i = 0; i < size; ++i) {
            std::int64_t const addend = y.limb(z.exponent_ + i);
            carry += std::int64_t{x.limb(z.exponent_ + i)} + (subtract ? -addend : addend);
            z.limbs_[i] = static_cast<std::uint32_t>(carry & 0xffffffff);
            carry >>= 32;
        }
        z.size_ = size;
        z.sign_ = sign;
        z.trim();
        return z;
    }

    std::uint32_t limbs_[capacity]; // only the first size_ are set, lowest first
    int size_ = 0;
    int exponent_ = 0;
    int sign_ = 0;
    bool exact_ = true;
};

} // namespace pw85

#endif

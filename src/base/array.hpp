// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// An array whose growth can fail. Neighbour lists, sums of forces and simulations keep their data
/// in it, because the C API reports missing memory as a status.
#ifndef PW85_BASE_ARRAY_HPP_INCLUDED
#define PW85_BASE_ARRAY_HPP_INCLUDED

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <type_traits>
#include <utility>

namespace pw85::detail {

/// An array of plain data whose size can grow. std::vector would throw an exception if memory is
/// short, and would initialise each new element.
template <class T> class Array {
    static_assert(std::is_trivially_copyable_v<T>);

  public:
    Array() noexcept = default;
    [[gnu::always_inline]] Array(Array &&other) noexcept
        : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0))
    {
    }
    [[gnu::always_inline]] Array &operator=(Array &&other) noexcept
    {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        return *this;
    }
    [[gnu::always_inline]] ~Array() { std::free(data_); }

    /// Sets the size to n and keeps the elements that exist. Returns false and changes nothing if
    /// there is no memory.
    [[nodiscard, gnu::always_inline]] bool resize(std::size_t n) noexcept
    {
        if (n > PTRDIFF_MAX / sizeof(T)) return false;
        void *const data = std::realloc(data_, n > 0 ? n * sizeof(T) : 1);
        if (data == nullptr) return false;
        data_ = static_cast<T *>(data);
        size_ = n;
        return true;
    }

    [[gnu::always_inline]] void free() noexcept { *this = Array(); }
    [[gnu::always_inline]] std::size_t size() const noexcept { return size_; }
    [[gnu::always_inline]] T *data() noexcept { return data_; }
    [[gnu::always_inline]] T const *data() const noexcept { return data_; }
    [[gnu::always_inline]] T &operator[](std::size_t i) noexcept { return data_[i]; }
    [[gnu::always_inline]] T const &operator[](std::size_t i) const noexcept { return data_[i]; }

  private:
    T *data_ = nullptr;
    std::size_t size_ = 0;
};

} // namespace pw85::detail

#endif

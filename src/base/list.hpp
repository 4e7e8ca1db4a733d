// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A list whose growth can fail. Event chains (simulation/contact_search.hpp) keep images in it.
#ifndef PW85_BASE_LIST_HPP_INCLUDED
#define PW85_BASE_LIST_HPP_INCLUDED

#include "array.hpp"

namespace pw85::detail {

/// A sequence with a capacity: the elements at the beginning of an Array.
template <class T> class List {
  public:
    /// Raises the capacity to n elements or more. Returns false and changes nothing if there is no
    /// memory.
    [[nodiscard, gnu::always_inline]] bool reserve(std::size_t n) noexcept
    {
        return n <= memory_.size() || memory_.resize(2 * n + 64);
    }

    /// Adds an element at the end, within the capacity.
    [[gnu::always_inline]] void push(T const &element) noexcept { memory_[size_++] = element; }

    /// Inserts an element before that with an index, within the capacity.
    [[gnu::always_inline]] void insert(std::size_t index, T element) noexcept
    {
        for (std::size_t i = size_++; i > index; --i) memory_[i] = memory_[i - 1];
        memory_[index] = element;
    }

    /// Removes the last element, and returns it.
    [[gnu::always_inline]] T pop() noexcept { return memory_[--size_]; }

    /// Removes all elements. The capacity stays.
    [[gnu::always_inline]] void clear() noexcept { size_ = 0; }

    [[gnu::always_inline]] std::size_t size() const noexcept { return size_; }
    [[gnu::always_inline]] bool is_empty() const noexcept { return size_ == 0; }
    [[gnu::always_inline]] T &operator[](std::size_t i) noexcept { return memory_[i]; }
    [[gnu::always_inline]] T const &operator[](std::size_t i) const noexcept { return memory_[i]; }
    [[gnu::always_inline]] T const &last() const noexcept { return memory_[size_ - 1]; }
    [[gnu::always_inline]] T *begin() noexcept { return memory_.data(); }
    [[gnu::always_inline]] T *end() noexcept { return memory_.data() + size_; }

  private:
    Array<T> memory_;
    std::size_t size_ = 0;
};

} // namespace pw85::detail

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A list whose growth can fail. Event chains (simulation/chains.cpp) keep images in it.
#ifndef PW85_BASE_LIST_HPP_INCLUDED
#define PW85_BASE_LIST_HPP_INCLUDED

#include "array.hpp"

namespace pw85::detail {

/// The elements at the beginning of an Array that may have room for more.
template <class T> class List {
  public:
    /// Makes room for n elements. Returns false and changes nothing if there is no memory.
    [[nodiscard, gnu::always_inline]] bool reserve(std::size_t n) noexcept
    {
        return n <= room_.size() || room_.resize(2 * n + 64);
    }

    /// Adds an element at the end. There must be room for it.
    [[gnu::always_inline]] void push(T const &element) noexcept { room_[size_++] = element; }

    /// Adds an element, which is number `place` then. There must be room for it.
    [[gnu::always_inline]] void insert(std::size_t place, T element) noexcept
    {
        for (std::size_t i = size_++; i > place; --i) room_[i] = room_[i - 1];
        room_[place] = element;
    }

    /// Removes the last element, and returns it.
    [[gnu::always_inline]] T pop() noexcept { return room_[--size_]; }

    /// Removes all elements. The room stays.
    [[gnu::always_inline]] void clear() noexcept { size_ = 0; }

    [[gnu::always_inline]] std::size_t size() const noexcept { return size_; }
    [[gnu::always_inline]] bool is_empty() const noexcept { return size_ == 0; }
    [[gnu::always_inline]] T &operator[](std::size_t i) noexcept { return room_[i]; }
    [[gnu::always_inline]] T const &last() const noexcept { return room_[size_ - 1]; }
    [[gnu::always_inline]] T *begin() noexcept { return room_.data(); }
    [[gnu::always_inline]] T *end() noexcept { return room_.data() + size_; }

  private:
    Array<T> room_;
    std::size_t size_ = 0;
};

} // namespace pw85::detail

#endif

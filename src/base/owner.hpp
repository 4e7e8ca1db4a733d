// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A pointer that owns what `new` has made. It has the members of std::unique_ptr that the library
/// needs: <memory> takes a compiler longer than all headers of an overlap test.
#ifndef PW85_BASE_OWNER_HPP_INCLUDED
#define PW85_BASE_OWNER_HPP_INCLUDED

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

namespace pw85::detail {

/// Ends the life of an object, or of an array of them.
template <class T> struct Delete {
    [[gnu::always_inline]] static void destroy(std::remove_extent_t<T> *object) noexcept
    {
        if constexpr (std::is_array_v<T>)
            delete[] object;
        else
            delete object;
    }
};

template <class T, class Destroyer = Delete<T>> class Owner {
    using Object = std::remove_extent_t<T>;

  public:
    Owner() noexcept = default;
    [[gnu::always_inline]] explicit Owner(Object *object) noexcept : object_(object) {}
    [[gnu::always_inline]] Owner(Owner &&other) noexcept : object_(other.release()) {}
    [[gnu::always_inline]] Owner &operator=(Owner &&other) noexcept
    {
        reset(other.release());
        return *this;
    }
    [[gnu::always_inline]] ~Owner() { Destroyer::destroy(object_); }

    [[gnu::always_inline]] void reset(Object *object) noexcept
    {
        Destroyer::destroy(std::exchange(object_, object));
    }
    [[gnu::always_inline]] Object *release() noexcept { return std::exchange(object_, nullptr); }
    [[gnu::always_inline]] Object *get() const noexcept { return object_; }
    [[gnu::always_inline]] Object &operator*() const noexcept { return *object_; }
    [[gnu::always_inline]] Object *operator->() const noexcept { return object_; }
    [[gnu::always_inline]] explicit operator bool() const noexcept { return object_ != nullptr; }
    [[gnu::always_inline]] bool operator==(std::nullptr_t) const noexcept
    {
        return object_ == nullptr;
    }

  private:
    Object *object_ = nullptr;
};

} // namespace pw85::detail

#endif

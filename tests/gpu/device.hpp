// SPDX-License-Identifier: BSD-3-Clause
// Arrays in the memory of a device, for tests: of the fake driver or of a real one.
#ifndef PW85_TESTS_GPU_DEVICE_HPP_INCLUDED
#define PW85_TESTS_GPU_DEVICE_HPP_INCLUDED

#include <cstring>
#include <vector>

#include <glib.h>

#include "../../src/gpu/driver.hpp"

namespace pw85_tests {

/// The driver that the library finds; the test ends without one.
inline pw85::detail::gpu::Driver const &device()
{
    pw85::detail::gpu::Driver const *const found = pw85::detail::gpu::driver();
    if (found == nullptr) g_error("no driver, or no device");
    return *found;
}

/// A stream, destroyed when all of its work is done.
class Stream {
  public:
    Stream()
    {
        g_assert_cmpint(device().create_stream(&handle_, pw85::detail::gpu::non_blocking), ==, 0);
    }
    Stream(Stream const &) = delete;
    Stream &operator=(Stream const &) = delete;
    ~Stream()
    {
        wait();
        device().destroy_stream(handle_);
    }
    void *handle() const { return handle_; }
    void wait() const { g_assert_cmpint(device().synchronize(handle_), ==, 0); }

  private:
    void *handle_ = nullptr;
};

/// Numbers on the device; copies wait for the default stream.
template <class T> class DeviceArray {
  public:
    explicit DeviceArray(std::size_t size) : size_(size)
    {
        g_assert_cmpint(device().allocate(&address_, bytes(), nullptr), ==, 0);
        g_assert_cmpint(device().synchronize(nullptr), ==, 0);
    }
    explicit DeviceArray(std::vector<T> const &values) : DeviceArray(values.size())
    {
        copy([&](void *pinned) {
            std::memcpy(pinned, values.data(), bytes());
            g_assert_cmpint(device().to_device(address_, pinned, bytes(), nullptr), ==, 0);
        });
    }
    DeviceArray(DeviceArray const &) = delete;
    DeviceArray &operator=(DeviceArray const &) = delete;
    ~DeviceArray()
    {
        device().release(address_, nullptr);
        device().synchronize(nullptr);
    }

    T *get() const { return reinterpret_cast<T *>(address_); }

    std::vector<T> values() const
    {
        std::vector<T> result(size_);
        copy([&](void *pinned) {
            g_assert_cmpint(device().to_host(pinned, address_, bytes(), nullptr), ==, 0);
            g_assert_cmpint(device().synchronize(nullptr), ==, 0);
            std::memcpy(result.data(), pinned, bytes());
        });
        return result;
    }

  private:
    std::size_t bytes() const { return (size_ + 1) * sizeof(T) - sizeof(T) * (size_ > 0); }

    template <class Transfer> void copy(Transfer transfer) const
    {
        void *pinned = nullptr;
        g_assert_cmpint(device().allocate_pinned(&pinned, bytes(), 0), ==, 0);
        transfer(pinned);
        g_assert_cmpint(device().synchronize(nullptr), ==, 0);
        device().release_pinned(pinned);
    }

    std::size_t size_;
    pw85::detail::gpu::Address address_ = 0;
};

} // namespace pw85_tests

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The part of NVIDIA's driver interface (CUDA driver API) that the library uses. The functions are
/// declared here and found at run time (driver.cpp). So a build needs neither the headers nor the
/// library of the driver. The other files of this folder use it.
#ifndef PW85_GPU_DRIVER_HPP_INCLUDED
#define PW85_GPU_DRIVER_HPP_INCLUDED

#include <cstddef>
#include <cstdint>

namespace pw85::detail::gpu {

using Address = std::uint64_t; ///< CUdeviceptr
using Result = int;            ///< CUresult: 0 is success
using Handle = void *;         ///< CUcontext, CUstream, CUlibrary, CUkernel
using Callback = void (*)(void *);

// X(function, versioned symbol, parameters)
#define PW85_DRIVER_FUNCTIONS(X)                                                                   \
    X(init, cuInit, (unsigned flags))                                                              \
    X(device_count, cuDeviceGetCount, (int *count))                                                \
    X(device, cuDeviceGet, (int *device, int ordinal))                                             \
    X(attribute, cuDeviceGetAttribute, (int *value, int attribute, int device))                    \
    X(retain_context, cuDevicePrimaryCtxRetain, (Handle * context, int device))                    \
    X(current_context, cuCtxGetCurrent, (Handle * context))                                        \
    X(current_device, cuCtxGetDevice, (int *device))                                               \
    X(push_context, cuCtxPushCurrent_v2, (Handle context))                                         \
    X(pop_context, cuCtxPopCurrent_v2, (Handle * context))                                         \
    X(pointer_attribute, cuPointerGetAttribute, (void *value, int attribute, Address pointer))     \
    X(load_library, cuLibraryLoadData,                                                             \
      (Handle * library, void const *code, void *options, void *option_values,                     \
       unsigned num_options, void *library_options, void *library_option_values,                   \
       unsigned num_library_options))                                                              \
    X(kernel, cuLibraryGetKernel, (Handle * kernel, Handle library, char const *name))             \
    X(launch, cuLaunchKernel,                                                                      \
      (Handle kernel, unsigned grid_x, unsigned grid_y, unsigned grid_z, unsigned block_x,         \
       unsigned block_y, unsigned block_z, unsigned shared_bytes, Handle stream, void **arguments, \
       void **extra))                                                                              \
    X(launch_host, cuLaunchHostFunc, (Handle stream, Callback function, void *data))               \
    X(allocate, cuMemAllocAsync, (Address * pointer, std::size_t size, Handle stream))             \
    X(release, cuMemFreeAsync, (Address pointer, Handle stream))                                   \
    X(allocate_managed, cuMemAllocManaged, (Address * pointer, std::size_t size, unsigned flags))  \
    X(allocate_pinned, cuMemHostAlloc, (void **pointer, std::size_t size, unsigned flags))         \
    X(release_pinned, cuMemFreeHost, (void *pointer))                                              \
    X(fill, cuMemsetD32Async, (Address pointer, unsigned value, std::size_t count, Handle stream)) \
    X(to_device, cuMemcpyHtoDAsync_v2,                                                             \
      (Address to, void const *from, std::size_t size, Handle stream))                             \
    X(to_host, cuMemcpyDtoHAsync_v2, (void *to, Address from, std::size_t size, Handle stream))    \
    X(create_stream, cuStreamCreate, (Handle * stream, unsigned flags))                            \
    X(synchronize, cuStreamSynchronize, (Handle stream))                                           \
    X(destroy_stream, cuStreamDestroy_v2, (Handle stream))

// Values of the driver's enumerations.
/// CU_DEVICE_ATTRIBUTE_CONCURRENT_MANAGED_ACCESS
inline constexpr int concurrent_managed_access = 89;
inline constexpr int pointer_memory_type = 2; ///< CU_POINTER_ATTRIBUTE_MEMORY_TYPE
inline constexpr unsigned attach_global = 1;  ///< CU_MEM_ATTACH_GLOBAL
inline constexpr unsigned non_blocking = 1;   ///< CU_STREAM_NON_BLOCKING

struct Driver {
#define PW85_DRIVER_POINTER(function, symbol, parameters) Result(*function) parameters;
    PW85_DRIVER_FUNCTIONS(PW85_DRIVER_POINTER)
#undef PW85_DRIVER_POINTER
};

/// Returns the driver, initialised and with at least one device. The result is null if there is no
/// device, or if the driver is too old to have all functions. The first call searches for the
/// driver, and later calls return the same pointer.
Driver const *driver() noexcept;

/// Ensures that the calling thread has a context while the object lives. It uses the current
/// context, or else that of the first device.
class Context {
  public:
    explicit Context(Driver const *driver) noexcept;
    Context(Context const &) = delete;
    Context &operator=(Context const &) = delete;
    ~Context();

    /// Returns the context; null if there is none.
    Handle handle() const noexcept { return handle_; }

  private:
    Driver const *driver_;
    Handle handle_ = nullptr;
    bool pushed_ = false;
};

} // namespace pw85::detail::gpu

#endif

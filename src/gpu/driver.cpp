// SPDX-License-Identifier: BSD-3-Clause
// Finds the library of NVIDIA's driver at run time, and keeps it loaded. gpu.cpp and
// host_arrays.cpp call driver().
#include "driver.hpp"

#if __has_include(<dlfcn.h>)
#include <dlfcn.h>
#endif

namespace pw85::detail::gpu {

namespace {

#if __has_include(<dlfcn.h>)
void *open_driver() noexcept { return dlopen("libcuda.so.1", RTLD_NOW | RTLD_LOCAL); }
void *find(void *library, char const *symbol) noexcept { return dlsym(library, symbol); }
void close(void *library) noexcept { dlclose(library); }
#else
void *open_driver() noexcept { return nullptr; }
void *find(void *, char const *) noexcept { return nullptr; }
void close(void *) noexcept {}
#endif

bool find_all(void *library, Driver &driver) noexcept
{
    bool complete = true;
#define PW85_DRIVER_FIND(function, symbol, parameters)                                             \
    driver.function = reinterpret_cast<Result(*) parameters>(find(library, #symbol));              \
    complete = complete && driver.function != nullptr;
    PW85_DRIVER_FUNCTIONS(PW85_DRIVER_FIND)
#undef PW85_DRIVER_FIND
    return complete;
}

/// Returns whether the driver can be initialised and has a device.
bool is_usable(Driver const &driver) noexcept
{
    int count = 0;
    return driver.init(0) == 0 && driver.device_count(&count) == 0 && count > 0;
}

/// Returns the primary context of the first device. It is never released.
Handle first_context(Driver const &driver) noexcept
{
    int device = 0;
    Handle context = nullptr;
    if (driver.device(&device, 0) != 0 || driver.retain_context(&context, device) != 0)
        return nullptr;
    return context;
}

/// Loads the driver. An initialised driver has threads of its own, so it is never unloaded.
Driver const *load() noexcept
{
    static Driver driver;
    void *const library = open_driver();
    if (library == nullptr) return nullptr;
    if (find_all(library, driver)) return is_usable(driver) ? &driver : nullptr;
    close(library);
    return nullptr;
}

} // namespace

Driver const *driver() noexcept
{
    static Driver const *const found = load();
    return found;
}

Context::Context(Driver const *driver) noexcept : driver_(driver)
{
    if (driver == nullptr) return;
    if (driver->current_context(&handle_) == 0 && handle_ != nullptr) return;
    static auto const first = first_context(*driver);
    pushed_ = first != nullptr && driver->push_context(first) == 0;
    handle_ = pushed_ ? first : nullptr;
}

Context::~Context()
{
    Handle popped;
    if (pushed_) driver_->pop_context(&popped);
}

} // namespace pw85::detail::gpu

// SPDX-License-Identifier: BSD-3-Clause
// A driver that needs no device, as libcuda.so.1 in a folder of the tests. Each stream is a thread,
// the memory of the device is that of the process, and the program is the same source compiled for
// the host. The environment variable PW85_FAKE_DRIVER selects a way in which it fails. If it is
// used wrongly, it ends the process.
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "../../src/gpu/driver.hpp"
#include "../../src/gpu/work.hpp"

using namespace pw85::detail::gpu;

#define FAKE extern "C" __attribute__((visibility("default")))

namespace {

[[maybe_unused]] constexpr Result success = 0, invalid_value = 1, out_of_memory = 2,
                                  no_device = 100, invalid_program = 218, not_found = 500,
                                  launch_failure = 719, unknown = 999;

bool is_mode(char const *mode)
{
    char const *const set = std::getenv("PW85_FAKE_DRIVER");
    return set != nullptr && std::strcmp(set, mode) == 0;
}

[[noreturn]] void refuse(char const *what)
{
    std::fprintf(stderr, "fake driver: %s\n", what);
    std::abort();
}

/// What the device can address.
class Memory {
  public:
    /// Filled with bytes that are neither zero nor a number.
    Result allocate(Address *pointer, std::size_t size)
    {
        void *const memory = std::malloc(size);
        if (size == 0 || memory == nullptr) return out_of_memory;
        std::memset(memory, 0xff, size < fill ? size : fill);
        std::lock_guard const lock(mutex_);
        *pointer = reinterpret_cast<Address>(memory);
        blocks_[*pointer] = size;
        return success;
    }

    Result release(Address pointer)
    {
        std::lock_guard const lock(mutex_);
        if (blocks_.erase(pointer) == 0) refuse("memory that is not there is given back");
        std::free(reinterpret_cast<void *>(pointer));
        return success;
    }

    bool contains(Address pointer, std::size_t size)
    {
        std::lock_guard const lock(mutex_);
        auto const next = blocks_.upper_bound(pointer);
        if (next == blocks_.begin()) return false;
        auto const [begin, length] = *std::prev(next);
        return pointer + size <= begin + length;
    }

    std::size_t size()
    {
        std::lock_guard const lock(mutex_);
        return blocks_.size();
    }

  private:
    // of memory that is only reserved, no more is touched
    static constexpr std::size_t fill = std::size_t{1} << 20;
    std::mutex mutex_;
    std::map<Address, std::size_t> blocks_;
};

Memory &memory()
{
    static Memory m;
    return m;
}

/// Runs what is queued, in order; while all are held, nothing.
class Stream {
  public:
    Stream()
    {
        // What the thread needs is there before this, and longer.
        mutex();
        changed();
        is_held();
        memory();
        thread_ = std::thread([this] { work(); });
    }
    ~Stream()
    {
        push({});
        thread_.join();
    }

    void push(std::function<void()> task)
    {
        std::lock_guard const lock(mutex());
        tasks_.push_back(std::move(task));
        changed().notify_all();
    }

    void synchronize()
    {
        std::unique_lock lock(mutex());
        changed().wait(lock, [&] { return tasks_.empty(); });
    }

    static void hold(bool held)
    {
        std::lock_guard const lock(mutex());
        is_held() = held;
        changed().notify_all();
    }

  private:
    // Neither is destroyed at the exit of the process: a thread of a stream that a failed test has
    // left may still wait for them, and the destructor would wait for it.
    static std::mutex &mutex()
    {
        static auto *const m = new std::mutex;
        return *m;
    }
    static std::condition_variable &changed()
    {
        static auto *const c = new std::condition_variable;
        return *c;
    }
    static bool &is_held()
    {
        static bool held = false;
        return held;
    }

    /// A task is in the queue until it is done.
    void work()
    {
        for (bool going = true; going;) {
            std::unique_lock lock(mutex());
            changed().wait(lock, [&] { return !tasks_.empty() && !is_held(); });
            auto const task = tasks_.front();
            lock.unlock();
            going = static_cast<bool>(task);
            if (going) task();
            lock.lock();
            tasks_.pop_front();
            changed().notify_all();
        }
    }

    std::deque<std::function<void()>> tasks_;
    std::thread thread_;
};

/// 1 is another name of the default stream.
Stream &stream(Handle handle)
{
    static Stream legacy;
    return reinterpret_cast<std::uintptr_t>(handle) <= 1 ? legacy : *static_cast<Stream *>(handle);
}

/// An entry of the program for the device.
struct Kernel {
    char const *name;
    std::size_t argument_size;
    void (*run)(void const *argument, unsigned blocks);
};

template <class Work> void run_attempt(void const *argument, unsigned blocks)
{
    auto const &work = *static_cast<Work const *>(argument);
    Tile tile;
    for (unsigned block = 0; block < blocks; ++block) {
        std::memset(static_cast<void *>(&tile), 0xff, sizeof tile);
        for (unsigned thread = 0; thread < block_size; ++thread)
            load_tile(work, tile, block, thread);
        for (unsigned thread = 0; thread < block_size; ++thread) attempt(work, tile, block, thread);
        for (unsigned thread = 0; thread < block_size; ++thread)
            store_tile(work, tile, block, thread);
    }
}

template <class Work, void (*step)(Work const &, std::size_t, std::size_t)>
void run_list(void const *argument, unsigned blocks)
{
    std::size_t const threads = std::size_t{blocks} * block_size;
    for (std::size_t thread = 0; thread < threads; ++thread)
        step(*static_cast<Work const *>(argument), thread, threads);
}

#define ENTRIES(Rows, Out, name)                                                                   \
    {"pw85_" #name "_attempt", sizeof(Attempt<Rows, Out>), run_attempt<Attempt<Rows, Out>>},       \
        {"pw85_" #name "_fallback", sizeof(Fallback<Rows, Out>),                                   \
         run_list<Fallback<Rows, Out>, fallback<Rows, Out>>},
Kernel kernels[] = {
    PW85_GPU_KERNELS(ENTRIES){"pw85_deliver", sizeof(Deliver), run_list<Deliver, deliver>}};

thread_local int current = 0; // contexts that were pushed
int context_of_all;
std::string program;

} // namespace

/// Holds all streams, or lets them go on.
FAKE void fake_hold(int held) { Stream::hold(held != 0); }

/// Blocks of memory that were not given back.
FAKE std::size_t fake_blocks() { return memory().size(); }

FAKE Result cuInit(unsigned) { return is_mode("refuses") ? unknown : success; }

FAKE Result cuDeviceGetCount(int *count)
{
    *count = is_mode("no_device") ? 0 : 1;
    return success;
}

FAKE Result cuDeviceGet(int *device, int)
{
    *device = 0;
    return success;
}

FAKE Result cuDeviceGetAttribute(int *value, int attribute, int)
{
    if (attribute != concurrent_managed_access)
        refuse("another attribute of the device is asked for");
    *value = is_mode("no_shared_memory") ? 0 : 1;
    return success;
}

FAKE Result cuDevicePrimaryCtxRetain(Handle *context, int)
{
    if (is_mode("no_context")) return out_of_memory;
    *context = &context_of_all;
    return success;
}

FAKE Result cuCtxGetCurrent(Handle *context)
{
    *context = current > 0 ? &context_of_all : nullptr;
    return success;
}

FAKE Result cuCtxGetDevice(int *device)
{
    *device = 0;
    return current > 0 ? success : invalid_value;
}

FAKE Result cuCtxPushCurrent_v2(Handle)
{
    ++current;
    return success;
}

FAKE Result cuCtxPopCurrent_v2(Handle *context)
{
    if (current == 0) refuse("there is no context to pop");
    --current;
    *context = &context_of_all;
    return success;
}

FAKE Result cuPointerGetAttribute(void *value, int attribute, Address pointer)
{
    if (attribute != pointer_memory_type) refuse("another attribute of a pointer is asked for");
    *static_cast<unsigned *>(value) = 2;
    return memory().contains(pointer, 1) ? success : invalid_value;
}

FAKE Result cuLibraryLoadData(Handle *library, void const *code, void *, void *, unsigned, void *,
                              void *, unsigned)
{
    if (is_mode("old_program")) return invalid_program;
    program = static_cast<char const *>(code);
    *library = &program;
    return program.starts_with(".version") ? success : invalid_program;
}

FAKE Result cuLibraryGetKernel(Handle *kernel, Handle, char const *name)
{
    for (Kernel &k : kernels)
        if (std::strcmp(k.name, name) == 0 &&
            program.find(".entry " + std::string(name) + "(") != std::string::npos) {
            *kernel = &k;
            return success;
        }
    return not_found;
}

/// The argument is copied at the call, as the driver does.
FAKE Result cuLaunchKernel(Handle kernel, unsigned grid_x, unsigned grid_y, unsigned grid_z,
                           unsigned block_x, unsigned block_y, unsigned block_z, unsigned, Handle s,
                           void **arguments, void **)
{
    if (is_mode("no_launch")) return launch_failure;
    auto const &k = *static_cast<Kernel const *>(kernel);
    if (block_x != block_size || block_y != 1 || block_z != 1 || grid_x == 0 || grid_y != 1 ||
        grid_z != 1)
        refuse("a grid that the program was not made for");
    auto const *const bytes = static_cast<char const *>(arguments[0]);
    stream(s).push([&k, grid_x, argument = std::vector<char>(bytes, bytes + k.argument_size)] {
        k.run(argument.data(), grid_x);
    });
    return success;
}

FAKE Result cuLaunchHostFunc(Handle s, Callback function, void *data)
{
    stream(s).push([=] { function(data); });
    return success;
}

FAKE Result cuMemAllocAsync(Address *pointer, std::size_t size, Handle)
{
    return is_mode("no_memory") ? out_of_memory : memory().allocate(pointer, size);
}

FAKE Result cuMemFreeAsync(Address pointer, Handle s)
{
    stream(s).push([=] { memory().release(pointer); });
    return success;
}

FAKE Result cuMemAllocManaged(Address *pointer, std::size_t size, unsigned flags)
{
    if (flags != attach_global) refuse("managed memory of another kind");
    return is_mode("no_managed_memory") ? out_of_memory : memory().allocate(pointer, size);
}

FAKE Result cuMemHostAlloc(void **pointer, std::size_t size, unsigned)
{
    if (is_mode("no_pinned_memory")) return out_of_memory;
    Address address = 0;
    Result const result = memory().allocate(&address, size);
    *pointer = reinterpret_cast<void *>(address);
    return result;
}

FAKE Result cuMemFreeHost(void *pointer)
{
    return memory().release(reinterpret_cast<Address>(pointer));
}

FAKE Result cuMemsetD32Async(Address pointer, unsigned value, std::size_t count, Handle s)
{
    if (!memory().contains(pointer, count * sizeof value))
        refuse("memory that is not the device's is filled");
    stream(s).push([=] {
        for (std::size_t i = 0; i < count; ++i) reinterpret_cast<unsigned *>(pointer)[i] = value;
    });
    return success;
}

/// One of the two is pinned, so that nobody waits.
FAKE Result cuMemcpyHtoDAsync_v2(Address to, void const *from, std::size_t size, Handle s)
{
    if (!memory().contains(to, size) || !memory().contains(reinterpret_cast<Address>(from), size))
        refuse("a copy from or to memory that is not known");
    stream(s).push([=] { std::memcpy(reinterpret_cast<void *>(to), from, size); });
    return success;
}

FAKE Result cuMemcpyDtoHAsync_v2(void *to, Address from, std::size_t size, Handle s)
{
    return cuMemcpyHtoDAsync_v2(reinterpret_cast<Address>(to), reinterpret_cast<void const *>(from),
                                size, s);
}

FAKE Result cuStreamCreate(Handle *s, unsigned)
{
    *s = new Stream;
    return success;
}

FAKE Result cuStreamSynchronize(Handle s)
{
    stream(s).synchronize();
    return success;
}

FAKE Result cuStreamDestroy_v2(Handle s)
{
    delete static_cast<Stream *>(s);
    return success;
}

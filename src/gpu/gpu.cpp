// SPDX-License-Identifier: BSD-3-Clause
// The functions of pw85_gpu.h for arrays on a device. They check the arguments, load the program
// (device_code.hpp), and queue its stages (work.hpp) on the caller's stream.
#include <pw85_gpu.h>

#include <algorithm>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../base/parallel.hpp"
#include "device_code.hpp"
#include "driver.hpp"
#include "mailboxes.hpp"
#include "work.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::gpu;
using pw85::detail::max_rows;
using pw85::detail::c_api::any_null;

namespace {

/// The two stages for one type of rows and one of outputs.
struct Stages {
    Handle attempt, fallback;
};

/// The functions of the program for the device.
struct Code {
#define PW85_GPU_STAGES(Rows, Out, name) Stages name;
    PW85_GPU_KERNELS(PW85_GPU_STAGES)
#undef PW85_GPU_STAGES
    Handle deliver;
};

#define PW85_GPU_STAGES(Rows, Out, name)                                                           \
    Stages const &stages(Code const &code, Rows const &, Out const &) noexcept { return code.name; }
PW85_GPU_KERNELS(PW85_GPU_STAGES)
#undef PW85_GPU_STAGES

bool load(Driver const &driver, Code &code) noexcept
{
    Handle library = nullptr;
    if (device_code[0] == '\0') return false;
    if (driver.load_library(&library, device_code, nullptr, nullptr, 0, nullptr, nullptr, 0) != 0)
        return false;
    bool complete = driver.kernel(&code.deliver, library, "pw85_deliver") == 0;
#define PW85_GPU_STAGES(Rows, Out, name)                                                           \
    complete = complete &&                                                                         \
               driver.kernel(&code.name.attempt, library, "pw85_" #name "_attempt") == 0 &&        \
               driver.kernel(&code.name.fallback, library, "pw85_" #name "_fallback") == 0;
    PW85_GPU_KERNELS(PW85_GPU_STAGES)
#undef PW85_GPU_STAGES
    return complete;
}

/// Returns the functions of the program. The first call loads the program. The result is null if
/// that fails.
Code const *code_for(Driver const &driver) noexcept
{
    static Code code{};
    static bool const loaded = load(driver, code);
    return loaded ? &code : nullptr;
}

/// Memory of the device while the object lives. It is allocated and released in the order of a
/// stream.
class Scratch {
  public:
    Scratch(Driver const &driver, Handle stream, std::size_t size) noexcept
        : driver_(driver), stream_(stream)
    {
        if (driver.allocate(&address_, size, stream) != 0) address_ = 0;
    }
    Scratch(Scratch const &) = delete;
    Scratch &operator=(Scratch const &) = delete;
    ~Scratch()
    {
        if (address_ != 0) driver_.release(address_, stream_);
    }
    Address address() const noexcept { return address_; }

  private:
    Driver const &driver_;
    Handle stream_;
    Address address_ = 0;
};

/// Queues work on a stream.
struct Queue {
    Driver const &driver;
    Code const &code;
    Handle stream;

    template <class Work>
    bool launch(Handle kernel, std::size_t blocks, Work const &work) const noexcept
    {
        void *arguments[] = {const_cast<Work *>(&work)};
        return driver.launch(kernel, static_cast<unsigned>(blocks), 1, 1, block_size, 1, 1, 0,
                             stream, arguments, nullptr) == 0;
    }

    bool clear(std::uint32_t *count) const noexcept
    {
        return driver.fill(reinterpret_cast<Address>(count), 0, 1, stream) == 0;
    }
};

/// The largest number of blocks for stages that process a list. It is enough to fill any device,
/// and small enough to cost little if the list is empty.
constexpr std::size_t max_list_blocks = 1024;

/// Queues both stages for up to chunk_size pairs.
template <class Rows, class Out> bool
queue_stages(Queue const &queue, Attempt<Rows, Out> const &attempt, Mailbox const &mailbox) noexcept
{
    std::size_t const blocks = (attempt.size + block_size - 1) / block_size;
    Stages const &s = stages(queue.code, attempt.rows, attempt.out);
    Fallback<Rows, Out> const fallback{attempt.rows, attempt.out, attempt.rest, mailbox};
    return queue.clear(attempt.rest.count) && queue.launch(s.attempt, blocks, attempt) &&
           queue.launch(s.fallback, std::min(blocks, max_list_blocks), fallback);
}

/// Queues both stages for overlaps. The host computes the pairs that both stages leave undecided.
template <class Rows> bool queue_overlaps(Queue const &queue,
                                          Attempt<Rows, OverlapArray> const &attempt,
                                          SharedMailbox &box) noexcept
{
    std::size_t const blocks = (attempt.size + block_size - 1) / block_size;
    return queue.clear(box.mailbox.count) && queue_stages(queue, attempt, box.mailbox) &&
           queue.driver.launch_host(queue.stream, compute_requests, &box) == 0 &&
           queue.launch(queue.code.deliver, std::min(blocks, max_list_blocks),
                        Deliver{box.mailbox, attempt.out});
}

/// Calls queue_chunk(attempt) for each chunk of the pairs.
template <class Rows, class Out, class QueueChunk> bool for_chunks(std::size_t n, Rows const &rows,
                                                                   Out const &out, Address scratch,
                                                                   QueueChunk queue_chunk) noexcept
{
    auto *const words = reinterpret_cast<std::uint32_t *>(scratch);
    for (std::size_t begin = 0; begin < n; begin += chunk_size) {
        auto const size = static_cast<std::uint32_t>(std::min(chunk_size, n - begin));
        if (!queue_chunk(
                Attempt<Rows, Out>{rows.from(begin), out.from(begin), size, {words, words + 1}}))
            return false;
    }
    return true;
}

template <class Rows, class Out> bool queue_all(Queue const &queue, Handle, std::size_t n,
                                                Rows const &rows, Out const &out,
                                                Address scratch) noexcept
{
    return for_chunks(n, rows, out, scratch, [&](Attempt<Rows, Out> const &attempt) {
        return queue_stages(queue, attempt, {});
    });
}

template <class Rows> bool queue_all(Queue const &queue, Handle context, std::size_t n,
                                     Rows const &rows, OverlapArray const &out,
                                     Address scratch) noexcept
{
    SharedMailbox *const box = acquire_mailbox(queue.driver, context, std::min(n, chunk_size));
    if (box == nullptr) return false;
    bool const queued =
        for_chunks(n, rows, out, scratch, [&](Attempt<Rows, OverlapArray> const &attempt) {
            return queue_overlaps(queue, attempt, *box);
        });
    return queue.driver.launch_host(queue.stream, release_mailbox, box) == 0 && queued;
}

/// Returns whether a pointer is null, or the driver knows it.
bool is_known(Driver const &driver, void const *pointer) noexcept
{
    int type = 0;
    return pointer == nullptr || driver.pointer_attribute(&type, pointer_memory_type,
                                                          reinterpret_cast<Address>(pointer)) == 0;
}

bool are_known(Driver const &driver, Pairs const &rows) noexcept
{
    return is_known(driver, rows.r12) && is_known(driver, rows.q1) && is_known(driver, rows.q2);
}

bool are_known(Driver const &driver, DeviceList const &rows) noexcept
{
    auto const &[pairs, centers, q, images, cell, lattice] = rows.list;
    return is_known(driver, pairs) && is_known(driver, images) && is_known(driver, centers) &&
           is_known(driver, q);
}

bool are_known(Driver const &driver, ContactArrays const &out) noexcept
{
    return is_known(driver, out.mu2) && is_known(driver, out.lambda);
}

bool are_known(Driver const &driver, OverlapArray const &out) noexcept
{
    return is_known(driver, out.overlap);
}

bool are_known(Driver const &driver, DerivativeArrays const &out) noexcept
{
    return is_known(driver, out.mu2) && is_known(driver, out.lambda) &&
           is_known(driver, out.point) && is_known(driver, out.normal) &&
           is_known(driver, out.d_r12) && is_known(driver, out.d_rot1) &&
           is_known(driver, out.d_rot2);
}

template <class Rows, class Out>
int run(Handle stream, std::size_t n, Rows const &rows, Out const &out) noexcept
{
    Driver const *const d = driver();
    Context const context(d);
    if (context.handle() == nullptr) return PW85_EDEVICE;
    if (!are_known(*d, rows) || !are_known(*d, out)) return PW85_EINVAL;
    Code const *const code = code_for(*d);
    if (code == nullptr) return PW85_EDEVICE;
    Scratch const scratch(*d, stream, (1 + std::min(n, chunk_size)) * sizeof(std::uint32_t));
    if (scratch.address() == 0) return PW85_EDEVICE;
    return queue_all(Queue{*d, *code, stream}, context.handle(), n, rows, out, scratch.address())
               ? PW85_SUCCESS
               : PW85_EDEVICE;
}

template <class Out>
int run_batch(Handle stream, std::size_t n, Pairs const &pairs, Out const &out) noexcept
{
    if (n > max_rows || any_null(pairs.r12, pairs.q1, pairs.q2)) return PW85_EINVAL;
    return run(stream, n, pairs, out);
}

template <class Out> int run_pairs(Handle stream, pw85_pair_list const &list,
                                   pw85_system const &system, Out const &out) noexcept
{
    if (list.num_pairs > max_rows || system.num_particles > max_rows) return PW85_EINVAL;
    if (any_null(list.pairs) || any_null(system.centers, system.q)) return PW85_EINVAL;
    auto const end = static_cast<std::uint32_t>(
        std::min<std::size_t>(system.num_particles, INT32_MAX + std::size_t{1}));
    DeviceList rows{{list.pairs, system.centers, system.q, list.images, nullptr, nullptr}, end, {}};
    bool const prepared = in_default_environment([&] {
        return kernels::prepare(system.cell, system.periodic, list.images != nullptr, rows.images);
    });
    if (!prepared) return PW85_EINVAL;
    return run(stream, list.num_pairs, rows, out);
}

} // namespace

int pw85_gpu_count(int *count)
{
    if (any_null(count)) return PW85_EINVAL;
    *count = 0;
    Driver const *const d = driver();
    return d != nullptr && d->device_count(count) == 0 ? PW85_SUCCESS : PW85_EDEVICE;
}

int pw85_gpu_contact_batch(void *stream, size_t n, double const *r12, double const *q1,
                           double const *q2, double *mu2, double *lambda)
{
    if (n == 0) return PW85_SUCCESS;
    if (any_null(mu2)) return PW85_EINVAL;
    return run_batch(stream, n, {r12, q1, q2}, ContactArrays{mu2, lambda});
}

int pw85_gpu_overlap_batch(void *stream, size_t n, double const *r12, double const *q1,
                           double const *q2, unsigned char *overlap)
{
    if (n == 0) return PW85_SUCCESS;
    if (any_null(overlap)) return PW85_EINVAL;
    return run_batch(stream, n, {r12, q1, q2}, OverlapArray{overlap});
}

int pw85_gpu_contact_derivatives_batch(void *stream, size_t n, double const *r12, double const *q1,
                                       double const *q2, double *mu2, double *lambda, double *point,
                                       double *normal, double *d_r12, double *d_rot1,
                                       double *d_rot2)
{
    if (n == 0) return PW85_SUCCESS;
    return run_batch(stream, n, {r12, q1, q2},
                     DerivativeArrays{mu2, lambda, point, normal, d_r12, d_rot1, d_rot2});
}

int pw85_gpu_contact_pairs(void *stream, pw85_pair_list const *list, pw85_system const *system,
                           double *mu2, double *lambda)
{
    if (any_null(list) || any_null(system)) return PW85_EINVAL;
    if (list->num_pairs == 0) return PW85_SUCCESS;
    if (any_null(mu2)) return PW85_EINVAL;
    return run_pairs(stream, *list, *system, ContactArrays{mu2, lambda});
}

int pw85_gpu_overlap_pairs(void *stream, pw85_pair_list const *list, pw85_system const *system,
                           unsigned char *overlap)
{
    if (any_null(list) || any_null(system)) return PW85_EINVAL;
    if (list->num_pairs == 0) return PW85_SUCCESS;
    if (any_null(overlap)) return PW85_EINVAL;
    return run_pairs(stream, *list, *system, OverlapArray{overlap});
}

int pw85_gpu_contact_derivatives_pairs(void *stream, pw85_pair_list const *list,
                                       pw85_system const *system, double *mu2, double *lambda,
                                       double *point, double *normal, double *d_r12, double *d_rot1,
                                       double *d_rot2)
{
    if (any_null(list) || any_null(system)) return PW85_EINVAL;
    if (list->num_pairs == 0) return PW85_SUCCESS;
    return run_pairs(stream, *list, *system,
                     DerivativeArrays{mu2, lambda, point, normal, d_r12, d_rot1, d_rot2});
}

// SPDX-License-Identifier: BSD-3-Clause
// The list of all mailboxes. It grows and never shrinks. gpu.cpp acquires mailboxes; the driver
// calls compute_requests() and release_mailbox() in the order of a stream.
#include "mailboxes.hpp"

#include <bit>
#include <mutex>
#include <new>

#include <pw85_batch.h>

namespace pw85::detail::gpu {

namespace {

std::mutex mutex;
SharedMailbox *first = nullptr;

bool has_shared_memory(Driver const &driver) noexcept
{
    int device = 0, concurrent = 0;
    return driver.current_device(&device) == 0 &&
           driver.attribute(&concurrent, concurrent_managed_access, device) == 0 && concurrent != 0;
}

/// Divides a block of memory into the arrays of a mailbox. Arrays of larger elements come first, so
/// that each is aligned.
Mailbox divide(void *count, Address memory, std::size_t capacity) noexcept
{
    auto *const numbers = reinterpret_cast<double *>(memory);
    auto *const indices = reinterpret_cast<std::uint32_t *>(numbers + 15 * capacity);
    return {static_cast<std::uint32_t *>(count),
            indices,
            numbers,
            numbers + 3 * capacity,
            numbers + 9 * capacity,
            reinterpret_cast<unsigned char *>(indices + capacity)};
}

SharedMailbox *make(Driver const &driver, Handle context, std::size_t capacity) noexcept
{
    std::size_t const size = (15 * sizeof(double) + sizeof(std::uint32_t) + 1) * capacity;
    Address memory = 0;
    void *count = nullptr;
    auto *const made = new (std::nothrow) SharedMailbox{{}, capacity, context, true, nullptr};
    if (made != nullptr && has_shared_memory(driver) &&
        driver.allocate_pinned(&count, sizeof(std::uint32_t), 0) == 0) {
        if (driver.allocate_managed(&memory, size, attach_global) == 0) {
            made->mailbox = divide(count, memory, capacity);
            return made;
        }
        driver.release_pinned(count);
    }
    delete made;
    return nullptr;
}

} // namespace

SharedMailbox *acquire_mailbox(Driver const &driver, Handle context, std::size_t capacity) noexcept
{
    std::lock_guard const lock(mutex);
    for (SharedMailbox *box = first; box != nullptr; box = box->next)
        if (box->context == context && box->capacity >= capacity && !box->busy.exchange(true))
            return box;
    SharedMailbox *const made = make(driver, context, std::bit_ceil(capacity));
    if (made == nullptr) return nullptr;
    made->next = first;
    return first = made;
}

void compute_requests(void *mailbox) noexcept
{
    Mailbox const &m = static_cast<SharedMailbox const *>(mailbox)->mailbox;
    pw85_overlap_batch(*m.count, m.r12, m.q1, m.q2, m.results);
}

void release_mailbox(void *mailbox) noexcept
{
    static_cast<SharedMailbox *>(mailbox)->busy = false;
}

} // namespace pw85::detail::gpu

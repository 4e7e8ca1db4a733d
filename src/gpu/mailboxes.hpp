// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Mailboxes in memory that the device and the host share. The device posts pairs that it cannot
/// decide (post_request() of work.hpp), and the host writes their results. gpu.cpp queues both
/// steps.
///
/// The driver manages the memory of the pairs. A mailbox has room for every pair of a launch, but
/// only pages that are written to take memory. Each call reads the number of pairs, usually 0, on
/// both sides; so it stands in pinned memory of the host, which does not move between them. A
/// mailbox serves one call at a time, and later calls use it again.
#ifndef PW85_GPU_MAILBOXES_HPP_INCLUDED
#define PW85_GPU_MAILBOXES_HPP_INCLUDED

#include <atomic>

#include "driver.hpp"
#include "work.hpp"

namespace pw85::detail::gpu {

struct SharedMailbox {
    Mailbox mailbox;
    std::size_t capacity;
    Handle context;
    std::atomic<bool> busy;
    SharedMailbox *next;
};

/// Returns a mailbox with room for `capacity` pairs that no other call uses. The result is null if
/// there is no memory, or if the device and the host cannot use the memory at the same time.
SharedMailbox *acquire_mailbox(Driver const &driver, Handle context, std::size_t capacity) noexcept;

/// Computes the overlaps of the pairs in a mailbox by pw85_overlap_batch(). Driver::launch_host
/// runs it after the stage that posts them.
void compute_requests(void *mailbox) noexcept;

/// Releases a mailbox for other calls. Driver::launch_host runs it after the results were
/// delivered.
void release_mailbox(void *mailbox) noexcept;

} // namespace pw85::detail::gpu

#endif

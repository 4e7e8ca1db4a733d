/// @file
/// Where a device leaves questions for the host, and finds the answers.
///
/// The memory is managed: there is room for every pair of a launch, but only what is written to takes place. A mailbox serves one
/// call at a time; calls that are over leave theirs to the next one.
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

/// A mailbox with room for so many pairs, for the caller alone; null where there is no memory or the device and the host cannot use
/// it at the same time.
SharedMailbox *take_mailbox(Driver const &driver, Handle context, std::size_t capacity) noexcept;

/// Answers the questions that are in a mailbox: for Driver::launch_host, once they are.
void answer(void *mailbox) noexcept;

/// Leaves a mailbox to other calls: for Driver::launch_host, once its answers were delivered.
void leave(void *mailbox) noexcept;

} // namespace pw85::detail::gpu

#endif

// SPDX-License-Identifier: BSD-3-Clause
// Lanes: the search of the contact function, for the kernels of all files.
#include "chunks.hpp"

#include "contact.hpp"

namespace pw85::detail {
inline namespace PW85_PACKS {

[[gnu::flatten]] void run(PackSearches<3> &searches, std::size_t packs) noexcept
{
    run_searches(searches, packs);
}

} // namespace PW85_PACKS
} // namespace pw85::detail

// SPDX-License-Identifier: BSD-3-Clause
// Orders particles along Morton's curve: see memory_order.hpp.
#include "memory_order.hpp"

#include <algorithm>

#include "../neighbors/order.hpp"

namespace pw85::detail::simulation {

int MemoryOrder::prepare(Configuration const &configuration) noexcept
{
    std::size_t const n = configuration.size();
    Cell const &cell = configuration.cell;
    neighbors::Periodicity periodicity;
    if (!periodicity.prepare(cell.exists ? cell.vectors : nullptr, cell.periodic))
        return PW85_EINVAL;
    Array<neighbors::KeyedIndex> keys;
    if (!keys.resize(n) || !places_.resize(n) || !particles_.resize(n)) return PW85_ENOMEM;
    neighbors::Box around = neighbors::empty_box;
    for (std::size_t i = 0; i < n; ++i) {
        auto const [x, y, z] = periodicity.wrapped(configuration.centers[i]).coordinates;
        around = enclose(around, {{x, y, z}, {x, y, z}});
    }
    for (std::size_t i = 0; i < n; ++i)
        keys[i] = {key_of(periodicity.wrapped(configuration.centers[i]), around),
                   static_cast<std::int32_t>(i)};
    std::sort(keys.data(), keys.data() + n,
              [](auto const &a, auto const &b) { return a.key < b.key; });
    for (std::size_t k = 0; k < n; ++k) {
        particles_[k] = keys[k].index;
        places_[static_cast<std::size_t>(keys[k].index)] = static_cast<std::int32_t>(k);
    }
    return PW85_SUCCESS;
}

} // namespace pw85::detail::simulation

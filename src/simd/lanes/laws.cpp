// SPDX-License-Identifier: BSD-3-Clause
// Lanes: the values of laws.
#include "chunks.hpp"

#include "laws.hpp"

namespace pw85::detail::kernels {

#define PW85_LAW(Law)                                                                              \
    template <> [[gnu::flatten]] LawSums PW85_BUILDING::evaluate(                                  \
        Law const &law, std::size_t n, double const *mu2, double *d_u) noexcept                    \
    {                                                                                              \
        return evaluate_law(law, n, mu2, d_u);                                                     \
    }
PW85_LAW(SoftRepulsion)
PW85_LAW(InversePowers)
PW85_LAW(LawTable)

} // namespace pw85::detail::kernels

// SPDX-License-Identifier: BSD-3-Clause
// Lanes: the values of laws. It is compiled once per instruction set.
#include "lane_law.hpp"
#include "lanes.hpp"

namespace pw85::detail::kernels {

namespace {

/// Computes the values of a law, pack by pack. Lanes beyond the last pair repeat that pair, and do
/// not enter the sum.
template <class Law>
LawSums evaluate_law(Law const &given, std::size_t n, double const *mu2, double *d_u) noexcept
{
    Law const law = given; // so that no store to d_u may change it
    Pack energies = Pack(0.0), counts = Pack(0.0);
    for (std::size_t k = 0; k < n; k += lanes) {
        std::size_t const left = n - k;
        LawValues const values = evaluate(law, load_numbers(mu2 + k, left));
        store_lanes(values.d_u, left, d_u + k);
        PackMask const live = PackMask::from_bits(live_lanes(left));
        energies = energies + select(live, values.u, Pack(0.0));
        counts = counts + select(live && !(values.d_u == Pack(0.0)), Pack(1.0), Pack(0.0));
    }
    double energy = 0.0, count = 0.0;
    for (std::size_t i = 0; i < lanes; ++i) {
        energy += energies[i];
        count += counts[i];
    }
    return {energy, static_cast<std::size_t>(count)};
}

} // namespace

namespace PW85_COMPILED_FOR {

[[gnu::flatten]] LawSums evaluate(SoftRepulsion const &law, std::size_t n, double const *mu2,
                                  double *d_u) noexcept
{
    return evaluate_law(law, n, mu2, d_u);
}

[[gnu::flatten]] LawSums evaluate(InversePowers const &law, std::size_t n, double const *mu2,
                                  double *d_u) noexcept
{
    return evaluate_law(law, n, mu2, d_u);
}

[[gnu::flatten]] LawSums evaluate(LawTable const &law, std::size_t n, double const *mu2,
                                  double *d_u) noexcept
{
    return evaluate_law(law, n, mu2, d_u);
}

} // namespace PW85_COMPILED_FOR

} // namespace pw85::detail::kernels

// Divides the cell as domains.hpp says.
#include "domains.hpp"

#include "../kernels/parallel.hpp"

namespace pw85::detail::simulation {

namespace {

/// The largest even number of parts of a vector, or 1. There are no more domains than particles or eight.
///
/// @param reach the most by which the coordinates of neighbours along the vector differ; the factor is for rounding errors
std::uint32_t parts_of(double reach, std::size_t num_particles) noexcept
{
    double const most = std::max(2.0, std::floor(std::cbrt(static_cast<double>(num_particles))));
    double const parts = std::min(most, std::floor((1.0 - 0x1p-20) / reach));
    return parts >= 2.0 ? static_cast<std::uint32_t>(parts) & ~1u : 1;
}

} // namespace

int Domains::prepare(Configuration const &configuration, double reach, Stream &stream) noexcept
{
    neighbors::Periodicity periodicity;
    Cell const &cell = configuration.cell;
    if (!periodicity.prepare(cell.exists ? cell.vectors : nullptr, cell.periodic)) return PW85_EINVAL;
    for (int k = 0; k < 3; ++k) {
        origin_[k] = stream.uniform();
        bool const periodic = periodicity.is_periodic(k);
        dual_[k] = periodic ? periodicity.dual_of_cell(k) : Vector3{0.0, 0.0, 0.0};
        double const along = magnitude_of_dot(dual_[k], Vector3{reach, reach, reach});
        parts_[k] = periodic ? parts_of(along, configuration.size()) : 1;
    }
    return assign(configuration) ? PW85_SUCCESS : PW85_ENOMEM;
}

bool Domains::assign(Configuration const &configuration) noexcept
{
    std::size_t const n = configuration.size(), count = std::size_t{num_domains()} * num_colors();
    if (!domain_of_.resize(n) || !members_.resize(n) || !begin_.resize(count + 2)) return false;
    kernels::for_all(n, [&](kernels::Range range) {
        for (std::size_t i = range.begin; i < range.end; ++i) domain_of_[i] = domain_of(configuration.centers[i]);
        return kernels::Failure{0, PW85_SUCCESS};
    });
    std::fill_n(begin_.data(), count + 2, 0);
    for (std::size_t i = 0; i < n; ++i) ++begin_[domain_of_[i] + 2];
    for (std::size_t k = 2; k < count + 2; ++k) begin_[k] += begin_[k - 1];
    for (std::size_t i = 0; i < n; ++i) members_[begin_[domain_of_[i] + 1]++] = static_cast<std::int32_t>(i);
    return true;
}

std::uint32_t Domains::domain(std::uint32_t color, std::uint32_t place) const noexcept
{
    std::uint32_t part[3];
    for (int k = 2; k >= 0; --k) {
        std::uint32_t const step = is_divided(k) ? 2 : 1, count = parts_[k] / step;
        part[k] = place % count * step + (is_divided(k) ? color & 1u : 0u);
        place /= count;
        if (is_divided(k)) color >>= 1;
    }
    return (part[0] * parts_[1] + part[1]) * parts_[2] + part[2];
}

} // namespace pw85::detail::simulation

// SPDX-License-Identifier: BSD-3-Clause
// Tests of single particles and of a whole configuration: see engine.hpp.
#include "engine.hpp"

#include <algorithm>

#include "../neighbors/bounded_list.hpp"
#include "../rows/many_pairs.hpp"

namespace pw85::detail::simulation {

Engine::Engine() noexcept = default;

Engine::~Engine() = default;

// If the position is outside of the fixed box, the Verlet list is rebuilt for the test. A rejected
// particle may then be outside of its new fixed box.
int Engine::try_placement(std::size_t particle, Particle const &moved, bool take,
                          bool &is_free) noexcept
{
    if (int const status = prepare()) return status;
    Trial<1> const trial{{particles.order().of(particle)}, {moved}};
    std::size_t const place = trial.places[0];
    Particle const old = particles.copy().get(place);
    auto const test = [&] {
        auto const overlaps = [&](std::size_t k) {
            return list.overlaps(k, particles.copy(), [](std::size_t) { return true; });
        };
        return accept_or_revert(trial, overlaps,
                                [](Particle const *) { return Outcome::accepted; });
    };
    Outcome outcome = test();
    int status = PW85_SUCCESS;
    if (outcome == Outcome::unlisted) {
        set(place, moved);
        status = rebuild_list();
        outcome = status == PW85_SUCCESS ? test() : Outcome::rejected;
    }
    is_free = outcome == Outcome::accepted;
    if (is_free && take) {
        particles.commit(place);
        return status;
    }
    set(place, old);
    if (status != PW85_SUCCESS || list.holds(place, particles.copy())) return status;
    return rebuild_list();
}

int Engine::find_neighbors(std::size_t particle, Array<NearImage> &found) noexcept
{
    if (int const status = prepare()) return status;
    Configuration const &all = particles.copy();
    Neighborhood const &rows = list.rows();
    std::size_t const i = particles.order().of(particle);
    Row const row = rows.row(i);
    if (!found.resize(row.size())) return PW85_ENOMEM;
    std::size_t count = 0;
    for (std::size_t k = 0; k < row.size(); ++k) {
        Neighbor const near = row[k];
        auto const j = static_cast<std::size_t>(near.index);
        Vector3 const r12 = all.separation(i, j, rows.translation(near.image));
        Vector3 const reach = all.half_widths[i] + all.half_widths[j];
        bool meets = true;
        for (int d = 0; d < 3; ++d) meets &= absolute(r12[d]) <= reach[d];
        if (meets)
            found[count++] = {particles.order().particle(j), rows.multiples(near.image), r12};
    }
    std::sort(found.data(), found.data() + count, [](NearImage const &a, NearImage const &b) {
        if (a.particle != b.particle) return a.particle < b.particle;
        return std::lexicographical_compare(a.image.n, a.image.n + 3, b.image.n, b.image.n + 3);
    });
    return found.resize(count) ? PW85_SUCCESS : PW85_ENOMEM;
}

int Engine::check(std::int32_t *pair) const noexcept
{
    Configuration const &all = particles.all();
    ExternalPotential const &external = hamiltonian.external;
    if (int const status = find_first_overlap(all, pair)) return status;
    for (std::size_t i = 0; i < all.size() && external.has_walls(); ++i)
        if (external.cuts(all.get(i), all.dimensions)) {
            if (pair != nullptr) pair[0] = static_cast<std::int32_t>(i);
            return PW85_EOVERLAP;
        }
    return PW85_SUCCESS;
}

int find_first_overlap(Configuration const &configuration, std::int32_t *pair) noexcept
{
    neighbors::BoundedList made;
    if (int const status = made.make(configuration.system(), 1.0)) return status;
    pw85_pair_list const list = made.pairs();
    auto const overlap = PW85_OF_PAIR(kernels::chosen(), overlap);
    Failure const first = for_blocks(list.num_pairs, [&](Range range) {
        for (std::size_t k = range.begin; k < range.end; ++k) {
            auto const i = static_cast<std::size_t>(list.pairs[2 * k]),
                       j = static_cast<std::size_t>(list.pairs[2 * k + 1]);
            Vector3 const r =
                configuration.separation(i, j, configuration.cell.translation(image_of(list, k)));
            int answer = 0;
            if (int const status = overlap(r.coordinates, configuration.q[i].entries,
                                           configuration.q[j].entries, &answer))
                return Failure{k, status};
            if (answer == 1) return Failure{k, PW85_EOVERLAP};
        }
        return Failure{0, PW85_SUCCESS};
    });
    if (pair != nullptr && first.status == PW85_EOVERLAP)
        std::copy_n(list.pairs + 2 * first.index, 2, pair);
    return first.status;
}

} // namespace pw85::detail::simulation

/// @file
/// Event chains of hard ellipsoids, after Bernard, Krauth and Wilson, Event-chain Monte Carlo algorithms for hard-sphere systems (2009),
/// doi:10.1103/PhysRevE.80.056704. hard_ellipsoids.cpp offers them in the C API.
///
/// 1. A random particle moves along a direction d until it touches another one. This one moves on from there, and so on, until the sum of
///    the ways is the length of the chain. There are no rejections.
/// 2. For a given direction and length, the chains from all configurations and all particles are a bijection that keeps volumes: the chain
///    along -d from the last particle leads back. So the uniform distribution is stationary. If the direction is random, and opposite
///    directions are equally probable, chains are in detailed balance.
/// 3. Michel, Kapfer and Krauth, Generalized event-chain Monte Carlo (2014), doi:10.1063/1.4863991: βP/ρ, along d, is the mean of
///    (x_last - x_first)/length. Here x is the coordinate along d of the particle that moves, which jumps by that of the separation at each
///    contact.
/// 4. A way is bounded by free_path(), and the place to which it leads is tested by the exact overlap test, for separations that are
///    rounded as in the engine. If rounding leads to an overlap, the way becomes shorter. So no chain leads to an overlap.
/// 5. All ways are multiples of the last digit of the length, so that their sum is the length without rounding. They are not longer than a
///    stage, which depends on the largest particle alone; a particle that touches nothing on a stage goes on with the next.
#ifndef PW85_SIMULATION_CHAINS_HPP_INCLUDED
#define PW85_SIMULATION_CHAINS_HPP_INCLUDED

#include "bins.hpp"
#include "random.hpp"

namespace pw85::detail::simulation {

/// What some chains did. Their βP/ρ is 1 + transfers/length.
struct ChainSums {
    double length;    ///< the sum of the ways
    double transfers; ///< the sum of the coordinates along d of the separations at contacts
    std::int64_t contacts;
};

class Chains {
  public:
    explicit Chains(Configuration &configuration) noexcept : configuration_(configuration) {}

    /// To be called after anything else has changed the configuration. Returns a status.
    int prepare() noexcept;

    /// Makes one chain and adds to the sums. The direction has length one. Returns a status: PW85_ECONVERGENCE if particles block each other
    /// within rounding errors, so that the chain does not advance.
    int run(std::size_t first, Vector3 const &direction, double length, ChainSums &sums) noexcept;

  private:
    /// An image of a particle that is near the way of another one.
    struct Candidate {
        Vector3 r12; ///< from the centre of the particle that moves, at its start
        Vector3 translation;
        std::size_t index;
        double bound; ///< no contact before this way
    };

    /// The longest way of a particle without contact, and the candidate that it touches then; null if there is none.
    struct Way {
        double length;
        Candidate const *touched;
    };

    bool find_candidates(std::size_t i, Vector3 const &direction, double stage) noexcept;
    void sort_by_bounds(std::size_t i, Vector3 const &direction, double stage) noexcept;
    Way find_way(std::size_t i, Vector3 const &direction, double stage) noexcept;
    double advance(std::size_t i, Vector3 const &direction, double way, double digit) noexcept;
    bool overlaps(std::size_t i) const noexcept;

    Configuration &configuration_;
    Bins bins_;
    Array<Candidate> candidates_;
    std::size_t num_candidates_ = 0;
    double longest_ = 0.0; ///< of all semi-axes
};

} // namespace pw85::detail::simulation

#endif

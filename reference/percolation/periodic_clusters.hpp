// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Clusters of particles in a periodic cell, joined bond by bond, and the loops by which they wrap
/// around the cell.
#ifndef PW85_REFERENCE_PERIODIC_CLUSTERS_HPP_INCLUDED
#define PW85_REFERENCE_PERIODIC_CLUSTERS_HPP_INCLUDED

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <pw85/systems.hpp>

namespace pw85_reference {

/// a + factor b.
inline pw85::Image add_scaled(pw85::Image a, std::int32_t factor, pw85::Image const &b)
{
    for (std::size_t d = 0; d < 3; ++d) a[d] += factor * b[d];
    return a;
}

/// A union-find structure that knows in which image of the cell each particle of a cluster is,
/// counted from the cluster's root.
///
/// A bond (i, j, image) connects i with the image of j that is `image` cell vectors away. Within a
/// cluster, a bond closes a loop. The cluster wraps around the cell along a vector of the cell if
/// the loop leads to another image along this vector (Newman and Ziff, Phys. Rev. E 64, 016706,
/// 2001). Images are integers, so the answer is exact.
class PeriodicClusters {
  public:
    /// Each particle is a cluster of its own.
    explicit PeriodicClusters(std::size_t num_particles) : members_(num_particles)
    {
        for (std::size_t i = 0; i < num_particles; ++i) members_[i].parent = i;
    }

    /// Adds a bond.
    ///
    /// @return the image to which the loop leads that the bond closes; zero if it closes no loop
    pw85::Image join(std::size_t i, std::size_t j, pw85::Image const &image)
    {
        auto [root1, image1] = find(i);
        auto [root2, image2] = find(j);
        // By the bond, j is in the image image1 + image, counted from root1.
        pw85::Image shift = add_scaled(add_scaled(image1, 1, image), -1, image2);
        if (root1 == root2) return shift;
        if (members_[root1].size < members_[root2].size) {
            std::swap(root1, root2);
            shift = add_scaled({}, -1, shift);
        }
        members_[root1].size += members_[root2].size;
        members_[root2] = {root1, 0, shift};
        return {};
    }

  private:
    struct Member {
        std::size_t parent = 0, size = 1; ///< the size of a root is that of its cluster
        pw85::Image image{};              ///< counted from the parent
    };

    /// The root of a particle's cluster, and the image of the particle, counted from the root.
    /// Halves the path to the root.
    std::pair<std::size_t, pw85::Image> find(std::size_t i)
    {
        pw85::Image image{};
        while (members_[i].parent != i) {
            Member &member = members_[i];
            Member const &parent = members_[member.parent];
            member.image = add_scaled(member.image, 1, parent.image);
            member.parent = parent.parent;
            image = add_scaled(image, 1, member.image);
            i = member.parent;
        }
        return {i, image};
    }

    std::vector<Member> members_;
};

} // namespace pw85_reference

#endif

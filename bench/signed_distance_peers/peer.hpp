// SPDX-License-Identifier: BSD-3-Clause
// The interface by which signed_distance_peers.cpp calls other libraries.
#ifndef PW85_BENCH_SIGNED_DISTANCE_PEER_HPP_INCLUDED
#define PW85_BENCH_SIGNED_DISTANCE_PEER_HPP_INCLUDED

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace pw85_bench {

/// A pair as the functions of pw85 take it.
struct Forms {
    double r12[3], q1[6], q2[6];
};

/// A signed distance, and a vector along the normal out of the first body; NaN where the library
/// has no answer.
struct Answer {
    double distance = std::numeric_limits<double>::quiet_NaN();
    double normal[3] = {};
};

/// The answer of a library that gives two points of the surfaces: point2 - point1 has the direction
/// of the normal if the bodies are apart, and the opposite one if they overlap.
template <class Vector>
Answer answer_of_points(double distance, Vector const &point1, Vector const &point2)
{
    Answer x{distance};
    for (int i = 0; i < 3; ++i)
        x.normal[i] = std::copysign(1.0, distance) * (point2[i] - point1[i]);
    return x;
}

class DistancePeer {
  public:
    virtual ~DistancePeer() = default;
    /// Makes bodies of the library.
    virtual void take(std::vector<Forms> const &pairs) = 0;
    /// The answer for one of the pairs. This call is timed.
    virtual Answer measure(std::size_t i) = 0;
};

std::unique_ptr<DistancePeer> make_fcl();
std::unique_ptr<DistancePeer> make_coal();
std::unique_ptr<DistancePeer> make_mujoco();
std::unique_ptr<DistancePeer> make_jolt();

} // namespace pw85_bench

#endif

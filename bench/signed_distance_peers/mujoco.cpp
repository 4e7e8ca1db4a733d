// SPDX-License-Identifier: BSD-3-Clause
// MuJoCo's convex collision (mjc_ccd), called as mj_geomDistance() calls it, with the default
// tolerance and number of iterations.
#include <mujoco/mujoco.h>

#include <engine/engine_collision_gjk.h>

#include "bodies.hpp"

namespace {

using namespace pw85_bench;

constexpr double default_tolerance = 1e-6;
constexpr int default_iterations = 35;

class Mujoco final : public DistancePeer {
  public:
    void take(std::vector<Forms> const &pairs) override
    {
        for (auto *const array : {&sizes_, &centers_, &rotations_}) array->clear();
        for_each_body(pairs, [&](PrincipalAxes const &axes, Eigen::Vector3d const &center) {
            add(axes, center);
        });
        types_.assign(2 * pairs.size(), mjGEOM_ELLIPSOID);
        model_->geom_type = types_.data();
        model_->geom_size = sizes_.data();
        data_->geom_xpos = centers_.data();
        data_->geom_xmat = rotations_.data();
    }
    Answer measure(std::size_t i) override
    {
        mjCCDConfig config{};
        config.max_iterations = default_iterations;
        config.tolerance = default_tolerance;
        config.max_contacts = 1;
        config.dist_cutoff = mjMAXVAL;
        config.buffer = buffer_.data();
        mjCCDObj object1, object2;
        int const first = static_cast<int>(2 * i);
        mjc_initCCDObj(&object1, model_.get(), data_.get(), first, 0.0);
        mjc_initCCDObj(&object2, model_.get(), data_.get(), first + 1, 0.0);
        mjCCDStatus status;
        double const d = mjc_ccd(&config, &status, &object1, &object2);
        if (status.nx == 0) return {};
        return answer_of_points(d, status.x1, status.x2);
    }

  private:
    void add(PrincipalAxes const &axes, Eigen::Vector3d const &center)
    {
        for (int i = 0; i < 3; ++i) {
            sizes_.push_back(axes.lengths[i]);
            centers_.push_back(center[i]);
            for (int j = 0; j < 3; ++j) rotations_.push_back(axes.turn(i, j));
        }
    }

    std::vector<double> sizes_, centers_, rotations_;
    std::vector<int> types_;
    std::vector<double> buffer_ =
        std::vector<double>(mjc_ccdSize(0, 0, default_iterations) / sizeof(double) + 1);
    std::unique_ptr<mjModel> model_ = std::make_unique<mjModel>();
    std::unique_ptr<mjData> data_ = std::make_unique<mjData>();
};

} // namespace

std::unique_ptr<DistancePeer> pw85_bench::make_mujoco() { return std::make_unique<Mujoco>(); }

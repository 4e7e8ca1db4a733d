// SPDX-License-Identifier: GPL-2.0-only
// The words of a mixture, and random grains.
#include "grain_mixture.hpp"

#include <pw85.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pw85_lammps {

namespace {

/// The least part of a normal distribution that LO and HI may leave. Draws outside are repeated,
/// 1000 times on average for this part.
constexpr double least_share = 1e-3;

double normal(Stream &stream)
{
    // 1 - u is not zero.
    double const length = std::sqrt(-2.0 * std::log(1.0 - stream.uniform()));
    return length * std::cos(2.0 * std::numbers::pi * stream.uniform());
}

double normal_distribution(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

} // namespace

double NewGrain::mass() const
{
    auto const [a, b, c] = semi_axes;
    double const form[6] = {a * a, 0.0, 0.0, b * b, 0.0, c * c};
    double volume = 0.0;
    pw85_volume(form, &volume);
    return density * volume;
}

double NewGrain::radius() const { return *std::max_element(semi_axes.begin(), semi_axes.end()); }

SizeDistribution SizeDistribution::parse(Words &words)
{
    SizeDistribution size;
    size.kind_ = words.choice<Kind>(
        "distribution of sizes",
        {{"uniform", Kind::uniform}, {"normal", Kind::normal}, {"lognormal", Kind::lognormal}});
    if (size.kind_ != Kind::uniform) {
        size.middle_ = words.positive("middle of the distribution of sizes");
        if (size.kind_ == Kind::lognormal) size.middle_ = std::log(size.middle_);
        size.width_ = words.positive("width of the distribution of sizes");
    }
    size.lower_ = words.positive("smallest size");
    size.upper_ = words.positive("largest size");
    if (!(size.lower_ <= size.upper_))
        words.refuse(
            "has its sizes in the wrong order: write the smallest one before the largest one");
    if (size.kind_ != Kind::uniform && size.share_between(size.lower_, size.upper_) < least_share)
        words.refuse("has a distribution of sizes of which less than a thousandth is between the "
                     "smallest and the "
                     "largest one: bring these closer to its middle, or make it wider");
    return size;
}

double SizeDistribution::share_between(double lower, double upper) const
{
    bool const is_log = kind_ == Kind::lognormal;
    auto const below = [&](double x) {
        return normal_distribution(((is_log ? std::log(x) : x) - middle_) / width_);
    };
    return below(upper) - below(lower);
}

double SizeDistribution::draw(Stream &stream) const
{
    if (kind_ == Kind::one) return 1.0;
    if (kind_ == Kind::uniform) return lower_ + (upper_ - lower_) * stream.uniform();
    for (;;) {
        double const x = middle_ + width_ * normal(stream),
                     size = kind_ == Kind::lognormal ? std::exp(x) : x;
        if (size >= lower_ && size <= upper_) return size;
    }
}

void GrainMixture::parse_grain(Words &words, int num_types)
{
    Kind kind{static_cast<int>(words.whole("type of grain", 1, num_types)), {}};
    for (double &x : kind.semi_axes) x = 0.5 * words.positive("diameter");
    for (;;) {
        if (words.skip("share")) {
            kind.share = words.positive("share");
        } else if (words.skip("density")) {
            kind.density = words.positive("density");
        } else if (words.skip("size")) {
            kind.size = SizeDistribution::parse(words);
        } else {
            break;
        }
    }
    kinds_.push_back(kind);
}

void GrainMixture::parse_orientation(Words &words)
{
    Quaternion q{};
    double square = 0.0;
    for (double &x : q) {
        x = words.coordinate("quaternion");
        square += x * x;
    }
    if (!(square > 0.0))
        words.refuse("has a quaternion of zero: give the orientation as W I J K, such as 1 0 0 0");
    for (double &x : q) x /= std::sqrt(square);
    orientation_ = q;
}

void GrainMixture::parse_velocity(Words &words)
{
    for (double &v : velocity_) v = words.coordinate("velocity");
    if (!words.skip("spread")) return;
    for (double &v : spread_) v = words.number("spread of the velocity");
}

double GrainMixture::largest_radius(std::optional<int> type) const
{
    double largest = 0.0;
    for (Kind const &kind : kinds_) {
        if (type && *type != kind.type) continue;
        largest = std::max(largest,
                           kind.size.largest() *
                               std::max({kind.semi_axes[0], kind.semi_axes[1], kind.semi_axes[2]}));
    }
    return largest;
}

double GrainMixture::largest_curvature_radius(int type) const
{
    double largest = 0.0;
    for (Kind const &kind : kinds_) {
        if (type != kind.type) continue;
        auto const [a, c] = std::minmax({kind.semi_axes[0], kind.semi_axes[1], kind.semi_axes[2]});
        largest = std::max(largest, kind.size.largest() * c * c / a);
    }
    return largest;
}

NewGrain GrainMixture::draw(Stream &stream, bool in_plane) const
{
    Kind const &kind = draw_kind(stream);
    NewGrain grain{kind.type, kind.size.draw(stream) * kind.semi_axes, kind.density, {}, velocity_};
    grain.quaternion = draw_orientation(stream, in_plane);
    for (std::size_t k = 0; k < 3; ++k)
        grain.velocity[k] += spread_[k] * (2.0 * stream.uniform() - 1.0);
    return grain;
}

GrainMixture::Kind const &GrainMixture::draw_kind(Stream &stream) const
{
    double sum = 0.0;
    for (Kind const &kind : kinds_) sum += kind.share;
    double left = sum * stream.uniform();
    for (Kind const &kind : kinds_) {
        left -= kind.share;
        if (left < 0.0) return kind;
    }
    return kinds_.back();
}

/// Uniform over all orientations, as K. Shoemake gives it in Graphics Gems III (1992), p. 124.
Quaternion GrainMixture::draw_orientation(Stream &stream, bool in_plane) const
{
    if (orientation_) return *orientation_;
    double const u = stream.uniform(), a = 2.0 * std::numbers::pi * stream.uniform(),
                 b = 2.0 * std::numbers::pi * stream.uniform();
    if (in_plane) return {std::cos(0.5 * a), 0.0, 0.0, std::sin(0.5 * a)};
    double const p = std::sqrt(1.0 - u), q = std::sqrt(u);
    return {p * std::cos(a), p * std::sin(a), q * std::cos(b), q * std::sin(b)};
}

} // namespace pw85_lammps

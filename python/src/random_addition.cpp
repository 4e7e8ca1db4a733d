// SPDX-License-Identifier: BSD-3-Clause
// Random sequential addition of ellipses in the plane and of ellipsoids, in a periodic cell: places
// and orientations are drawn at random, one after the other, and a particle stays where it overlaps
// none.
//
// Late attempts nearly all fail. So a list of voxels, boxes of places and of angles, holds all that
// may be free, and attempts are drawn in these only: attempts elsewhere would fail for certain, and
// are counted by their mean number. A voxel is left out once one particle overlaps all that could
// be put there; the others are divided again and again. Without any voxel left, the packing is
// saturated (Zhang, Phys. Rev. E 97, 043311, 2018).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <new>
#include <vector>

#include <pw85.h>

#include "arguments.hpp"
#include "calls.hpp"

namespace pypw85 {
namespace {

constexpr double pi = 3.14159265358979323846;
// Attempts that are made at once, at least; voxels whose list may have this length; and acceptance
// below which voxels are (first made, or) divided. These change the time that is needed, but not
// the distribution of the packings.
constexpr std::size_t least_attempts = 4096, most_voxels = 10'000'000;
constexpr double few_accepted = 0.02, most_at_first = 1e8;
// The largest number of halvings of a voxel. Voxels are smaller than 2⁻³⁰ of a semi-axis then, and
// what is left counts as nothing.
constexpr int most_halvings = 30;
// What a particle must overlap to cover a voxel has its semi-axes made smaller by this share, and
// then their squares by what lost() says. Distances are compared with this margin.
constexpr double rounding = 1e-11;
// Errors of places, as a part of the sum of the lengths of the vectors of the cell: see lost()
constexpr double rounding_of_places = 0x1p-47;

/// Random numbers in [0, 1) for one attempt: splitmix64 (Steele, Lea and Flood 2014) from a state
/// that depends on its number.
class Random {
  public:
    Random(std::uint64_t seed, std::uint64_t attempt) noexcept
        : state_(mixed(seed) ^ mixed(~attempt))
    {
    }

    double operator()() noexcept
    {
        state_ += 0x9e3779b97f4a7c15;
        return static_cast<double>(mixed(state_) >> 11) * 0x1p-53;
    }

  private:
    static std::uint64_t mixed(std::uint64_t z) noexcept
    {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }

    std::uint64_t state_;
};

template <std::size_t D> using Vector = std::array<double, D>;
template <std::size_t D> using Form = std::array<double, D == 2 ? 3 : 6>;

/// An ellipsoid about its centre. Its form is inside a ball with its longest semi-axis, `outer`, up
/// to rounding, and around a ball with the radius `inner` for certain.
template <std::size_t D> struct Body {
    Form<D> q;
    double outer, inner;
};

template <std::size_t D> struct Particle {
    Vector<D> center, place; ///< place: in units of the vectors of the cell, in [0, 1)
    Body<D> body;
    std::array<double, 4> quaternion;
    std::uint32_t kind;
};

bool overlaps(Vector<2> const &r, Form<2> const &q1, Form<2> const &q2) noexcept
{
    int overlap = 0;
    return pw85_overlap_2d(r.data(), q1.data(), q2.data(), &overlap) == PW85_SUCCESS &&
           overlap == 1;
}

bool overlaps(Vector<3> const &r, Form<3> const &q1, Form<3> const &q2) noexcept
{
    int overlap = 0;
    return pw85_overlap(r.data(), q1.data(), q2.data(), &overlap) == PW85_SUCCESS && overlap == 1;
}

template <std::size_t D> double length(Vector<D> const &x) noexcept
{
    double sum = 0;
    for (double const one : x) sum += one * one;
    return std::sqrt(sum);
}

/// The semi-axes of an ellipse that is inside each ellipse with semi-axes a >= b that is turned
/// from it by at most an angle.
///
/// With the mean m and half the difference d of the squares of the semi-axes, that of the angle φ
/// has the half-width √(m + d cos 2(t - φ)) along the direction t. So m' + d' cos 2t is never
/// larger if m' = m - |d' - d exp(2iφ)|. Of all d', that with the largest area is sought.
std::array<double, 2> inside_turned(double a, double b, double angle) noexcept
{
    double const m = (a * a + b * b) / 2, d = (a * a - b * b) / 2,
                 s = std::sin(std::min(angle, pi / 2));
    std::array<double, 2> best = {b, b};
    for (int k = 1; k <= 64; ++k) {
        double const less = k / 64.0 * d;
        double const mean = m - std::sqrt((d - less) * (d - less) + 4 * d * less * s * s);
        if (mean <= less) continue;
        std::array<double, 2> const axes = {std::sqrt(mean + less), std::sqrt(mean - less)};
        if (axes[0] * axes[1] > best[0] * best[1]) best = axes;
    }
    return best;
}

/// What rounding can take from the square of each half-width of what is inside all that is put into
/// a voxel. `outer` is the longest semi-axis a, `edges` the sum of the lengths of the vectors of
/// the cell.
///
/// Errors of forms, as norms, in units of 2⁻⁵³ a². That of form_within(): 11 by inside_turned(),
/// whose mean of squares, their difference and root have 2, 2 and 7; 6 by roots, the share and
/// squares; 13 by the angle `twice`, which is up to 3π, has an error of 25 units and moves the form
/// by half of that; 6 by its sums. That of a body that is drawn: 14 by the rotation of its
/// quaternion, whose half angle has 5 units and whose entries have 1; in the plane 21 by
/// pw85_ellipsoid_quaternion(), whose factor has 6 in each entry. In space only the form of a body
/// matters, which is 51, by 7 in each entry of the factor. The largest sum is 71, and 128 are
/// taken.
///
/// Places have errors of at most 27 units of 2⁻⁵³ `edges` in each direction: products and sums of
/// the place of the voxel and of the body that is drawn 6 each, its corner 3, images and
/// separations
/// 12. So they are within 2⁻⁴⁷ `edges`, ε. A half-width h that is left has
/// (h + ε)² <= (1 + t) h² + (1 + 1/t) ε². With t = 1.5 `rounding`, the share makes up for the first
/// factor, and 1 + 1/t <= 1 / `rounding`.
double lost(double outer, double edges) noexcept
{
    double const moved = rounding_of_places * edges;
    return 0x1p-46 * outer * outer + moved * moved / rounding;
}

/// The radius of a ball inside the form of a body that is drawn, however the form is rounded; 0 if
/// rounding leaves none. The exact test finds an overlap wherever two such balls overlap.
double radius_inside(double outer, double inner) noexcept
{
    return std::sqrt(std::max(0.0, inner * inner - lost(outer, 0)));
}

/// The squares of semi-axes, less what rounding can take from them; not all positive if that is
/// more than there is.
std::array<double, 2> squares_within(std::array<double, 2> const &axes, double loss) noexcept
{
    double const a = axes[0] * (1 - rounding), b = axes[1] * (1 - rounding);
    return {a * a - loss, b * b - loss};
}

/// The ellipse with the squares of semi-axes at half of an angle.
Form<2> form_within(std::array<double, 2> const &squares, double twice) noexcept
{
    double const m = (squares[0] + squares[1]) / 2, d = (squares[0] - squares[1]) / 2;
    return {m + d * std::cos(twice), d * std::sin(twice), m - d * std::cos(twice)};
}

/// Twice the angle in the middle of a voxel.
double twice_middle(std::uint64_t angle, std::uint64_t angles) noexcept
{
    return 2 * pi * (static_cast<double>(angle) + 0.5) / static_cast<double>(angles);
}

/// Half the angles of a voxel.
double half_width(std::uint64_t angles) noexcept { return pi / 2 / static_cast<double>(angles); }

/// The particles that are there, by boxes of the cell. Particles that overlap are in the same box
/// or in adjacent ones: a box is wider than two particles by more than the errors of places
/// (lost()). A cell of one box is at least as wide as two particles.
template <std::size_t D> class Packing {
  public:
    Packing(double const *cell, double outer)
    {
        for (std::size_t i = 0; i < D; ++i)
            for (std::size_t k = 0; k < D; ++k) cell_[i][k] = cell[3 * i + k];
        for (std::size_t i = 0; i < D; ++i) edges_ += edge(i);
        std::size_t total = 1;
        for (std::size_t i = 0; i < D; ++i) {
            double const width = 2 * outer * (1 + rounding) + rounding_of_places * edges_;
            boxes_[i] = static_cast<std::int64_t>(
                std::min(std::max(1.0, height(i) / width), D == 2 ? 1024.0 : 256.0));
            total *= static_cast<std::size_t>(boxes_[i]);
        }
        first_.assign(total, -1);
    }

    std::vector<Particle<D>> const &particles() const noexcept { return particles_; }

    Vector<D> point(Vector<D> const &place) const noexcept
    {
        Vector<D> x{};
        for (std::size_t i = 0; i < D; ++i)
            for (std::size_t k = 0; k < D; ++k) x[k] += place[i] * cell_[i][k];
        return x;
    }

    double edge(std::size_t i) const noexcept { return length<D>(cell_[i]); }

    /// The sum of the lengths of the vectors of the cell.
    double edges() const noexcept { return edges_; }

    /// The distance of two opposite faces.
    double height(std::size_t i) const noexcept
    {
        if constexpr (D == 2) {
            return std::abs(cell_[0][0] * cell_[1][1] - cell_[0][1] * cell_[1][0]) / edge(1 - i);
        } else {
            auto const &b = cell_[(i + 1) % 3], &c = cell_[(i + 2) % 3];
            Vector<3> const n = {b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2],
                                 b[0] * c[1] - b[1] * c[0]};
            return std::abs(n[0] * cell_[i][0] + n[1] * cell_[i][1] + n[2] * cell_[i][2]) /
                   length<3>(n);
        }
    }

    void add(Particle<D> const &particle)
    {
        std::size_t const box = index(boxes_of(particle.place));
        next_.push_back(first_[box]);
        first_[box] = static_cast<std::int32_t>(particles_.size());
        particles_.push_back(particle);
    }

    /// Whether a function is true for an image of a particle near a place, of which it gets the
    /// separation and the body.
    template <class Function>
    bool any_near(Vector<D> const &place, Vector<D> const &point, Function const &function) const
    {
        auto const home = boxes_of(place);
        std::size_t const count = D == 2 ? 9 : 27;
        for (std::size_t code = 0; code < count; ++code) {
            auto box = home;
            Vector<D> from = point;
            for (std::size_t i = 0, rest = code; i < D; ++i, rest /= 3) {
                box[i] += rest % 3 == 2 ? -1
                                        // the own box first: most attempts fail there
                                        : static_cast<std::int64_t>(rest % 3);
                double const turns = box[i] < 0 ? -1 : box[i] >= boxes_[i] ? 1 : 0;
                box[i] -= static_cast<std::int64_t>(turns) * boxes_[i];
                for (std::size_t k = 0; k < D && turns != 0; ++k) from[k] -= turns * cell_[i][k];
            }
            for (std::int32_t j = first_[index(box)]; j >= 0;
                 j = next_[static_cast<std::size_t>(j)]) {
                Particle<D> const &other = particles_[static_cast<std::size_t>(j)];
                Vector<D> r;
                for (std::size_t k = 0; k < D; ++k) r[k] = other.center[k] - from[k];
                if (function(r, other.body)) return true;
            }
        }
        return false;
    }

    bool is_free(Particle<D> const &one) const
    {
        return !any_near(one.place, one.center, [&one](Vector<D> const &r, Body<D> const &other) {
            double const distance = length<D>(r);
            if (distance > (one.body.outer + other.outer) * (1 + rounding)) return false;
            return distance < (one.body.inner + other.inner) * (1 - rounding) ||
                   overlaps(r, one.body.q, other.q);
        });
    }

  private:
    using Boxes = std::array<std::int64_t, D>;

    Boxes boxes_of(Vector<D> const &place) const noexcept
    {
        Boxes box;
        for (std::size_t i = 0; i < D; ++i)
            box[i] = std::min(static_cast<std::int64_t>(place[i] * static_cast<double>(boxes_[i])),
                              boxes_[i] - 1);
        return box;
    }

    std::size_t index(Boxes const &box) const noexcept
    {
        std::int64_t number = 0;
        for (std::size_t i = 0; i < D; ++i) number = number * boxes_[i] + box[i];
        return static_cast<std::size_t>(number);
    }

    std::array<Vector<D>, D> cell_;
    Boxes boxes_;
    double edges_ = 0;
    std::vector<std::int32_t> first_, next_;
    std::vector<Particle<D>> particles_;
};

/// What Python knows of an addition.
class Addition {
  public:
    virtual ~Addition() = default;
    /// Makes some attempts, until the largest number of particles or of attempts is reached.
    virtual void advance(std::size_t most, double limit) = 0;
    virtual PyObject *state() const = 0;
    virtual PyObject *placed() const = 0;
};

template <std::size_t D> class AdditionIn final : public Addition {
  public:
    AdditionIn(double const *cell, double const *semi_axes, std::size_t kinds, std::uint64_t seed)
        : packing_(cell, *std::max_element(semi_axes, semi_axes + 3 * kinds)), seed_(seed)
    {
        for (std::size_t k = 0; k < kinds; ++k)
            kinds_.push_back({semi_axes[3 * k], semi_axes[3 * k + 1], semi_axes[3 * k + 2]});
        double inner = inner_of(kinds_[0]);
        is_angle_ = false;
        are_balls_ = true;
        for (auto const &axes : kinds_) {
            inner = std::min(inner, inner_of(axes));
            are_balls_ = are_balls_ && inner_of(axes) == outer_of(axes);
        }
        is_angle_ = D == 2 && !are_balls_;
        // Coarse voxels at first: with halves of these, 15,000 ellipses of aspect ratio 4 take 14 s
        // of a processor in place of 5 s.
        for (std::size_t i = 0; i < D; ++i)
            divisions_[i] = count_of(packing_.edge(i) / (2 * inner));
        double longest = 0;
        for (auto const &axes : kinds_)
            longest = std::max(longest, outer_of(axes) / inner_of(axes));
        angles_ = is_angle_ ? count_of(2 * longest) : 1;
        while (number_of_voxels() > most_at_first) {
            for (auto &one : divisions_) one = (one + 1) / 2;
            angles_ = (angles_ + 1) / 2;
        }
    }

    void advance(std::size_t most, double limit) override
    {
        if (is_saturated_ || packing_.particles().size() >= most) return;
        std::size_t const before = packing_.particles().size();
        double const left = std::ceil((limit - attempts_) * share_);
        if (!(left >= 1)) return;
        auto const number =
            static_cast<std::size_t>(std::min(left, static_cast<double>(attempts_at_once())));
        try_many(number, most);
        bool const is_slow = static_cast<double>(packing_.particles().size() - before) <
                             few_ * static_cast<double>(number);
        // Attempts without voxels take about as long as making these
        bool const is_early = !has_voxels_ && attempts_ < number_of_voxels();
        if (is_slow && !is_early && packing_.particles().size() < most) divide();
    }

    PyObject *state() const override
    {
        return Py_BuildValue("ndndO", static_cast<Py_ssize_t>(packing_.particles().size()),
                             attempts_, static_cast<Py_ssize_t>(voxels_.size()), share_,
                             is_saturated_ ? Py_True : Py_False);
    }

    PyObject *placed() const override
    {
        auto const &particles = packing_.particles();
        npy_intp const n = static_cast<npy_intp>(particles.size());
        npy_intp const shape3[] = {n, 3}, shape4[] = {n, 4}, shape1[] = {n};
        Reference centers(PyArray_ZEROS(2, shape3, NPY_DOUBLE, 0)),
            quaternions(PyArray_ZEROS(2, shape4, NPY_DOUBLE, 0));
        Reference kinds(PyArray_ZEROS(1, shape1, NPY_INT64, 0));
        if (!centers || !quaternions || !kinds) return nullptr;
        auto *const x = static_cast<double *>(data(centers)), *const w = static_cast<double *>(
                                                                  data(quaternions));
        auto *const kind = static_cast<std::int64_t *>(data(kinds));
        for (std::size_t k = 0; k < particles.size(); ++k) {
            std::copy(particles[k].center.begin(), particles[k].center.end(), x + 3 * k);
            std::copy(particles[k].quaternion.begin(), particles[k].quaternion.end(), w + 4 * k);
            kind[k] = particles[k].kind;
        }
        return PyTuple_Pack(3, centers.get(), quaternions.get(), kinds.get());
    }

  private:
    using Axes = std::array<double, 3>;

    struct Voxel {
        std::array<std::uint64_t, D> corner;
        std::uint64_t angle;
        std::uint32_t kind;
    };

    static void *data(Reference const &array)
    {
        return PyArray_DATA(reinterpret_cast<PyArrayObject *>(array.get()));
    }
    static double inner_of(Axes const &axes)
    {
        return *std::min_element(axes.begin(), axes.begin() + D);
    }
    static double outer_of(Axes const &axes)
    {
        return *std::max_element(axes.begin(), axes.begin() + D);
    }
    static std::uint64_t count_of(double x)
    {
        return static_cast<std::uint64_t>(std::clamp(std::ceil(x), 1.0, 8192.0));
    }

    std::size_t attempts_at_once() const
    {
        return std::max({least_attempts, packing_.particles().size() / 4,
                         std::min(voxels_.size(), most_voxels / 8)});
    }

    static Form<D> form(Axes const &axes, std::array<double, 4> const &quaternion)
    {
        double q[6];
        pw85_ellipsoid_quaternion(axes.data(), quaternion.data(), q);
        if constexpr (D == 2)
            return {q[0], q[1], q[3]};
        else
            return {q[0], q[1], q[2], q[3], q[4], q[5]};
    }

    /// The orientation by three random numbers, of which ellipses need the first: an angle from 0
    /// to π; or as Shoemake (Graphics Gems III, 1992) has it.
    static std::array<double, 4> quaternion(double u, double v, double w)
    {
        if constexpr (D == 2) return {std::cos(pi / 2 * u), 0, 0, std::sin(pi / 2 * u)};
        double const s = std::sqrt(1 - u), t = std::sqrt(u);
        return {t * std::cos(2 * pi * w), s * std::sin(2 * pi * v), s * std::cos(2 * pi * v),
                t * std::sin(2 * pi * w)};
    }

    Particle<D> drawn(std::uint64_t attempt) const
    {
        Random random(seed_, attempt);
        Particle<D> one;
        double const choice = random();
        Voxel voxel{};
        std::uint64_t angles = 1;
        std::array<std::uint64_t, D> divisions;
        divisions.fill(1);
        if (has_voxels_) {
            voxel = voxels_[std::min(
                static_cast<std::size_t>(choice * static_cast<double>(voxels_.size())),
                voxels_.size() - 1)];
            divisions = divisions_;
            angles = angles_;
        } else {
            voxel.kind =
                static_cast<std::uint32_t>(std::min(choice * static_cast<double>(kinds_.size()),
                                                    static_cast<double>(kinds_.size() - 1)));
        }
        for (std::size_t i = 0; i < D; ++i)
            one.place[i] = (static_cast<double>(voxel.corner[i]) + random()) /
                           static_cast<double>(divisions[i]);
        for (double &place : one.place) place = std::min(place, std::nextafter(1.0, 0.0));
        double const u = (static_cast<double>(voxel.angle) + random()) /
                         static_cast<double>(angles),
                     v = D == 3 ? random() : 0, w = D == 3 ? random() : 0;
        Axes const &axes = kinds_[voxel.kind];
        one.center = packing_.point(one.place);
        one.quaternion = quaternion(u, v, w);
        double const outer = outer_of(axes);
        one.body = {form(axes, one.quaternion), outer, radius_inside(outer, inner_of(axes))};
        one.kind = voxel.kind;
        return one;
    }

    /// Attempts are tested against the particles that are there by all threads, and then in their
    /// order against those that were added.
    void try_many(std::size_t number, std::size_t most)
    {
        is_free_.assign(number, 0);
        auto const count = static_cast<std::int64_t>(number);
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic, 256)
#endif
        for (std::int64_t k = 0; k < count; ++k)
            is_free_[static_cast<std::size_t>(k)] =
                packing_.is_free(drawn(next_ + static_cast<std::uint64_t>(k)));
        std::size_t k = 0;
        for (; k < number && packing_.particles().size() < most; ++k) {
            if (is_free_[k] == 0) continue;
            Particle<D> const one = drawn(next_ + k);
            if (packing_.is_free(one)) packing_.add(one);
        }
        next_ += number;
        attempts_ += static_cast<double>(k) / share_;
    }

    double number_of_voxels() const noexcept
    {
        double total = static_cast<double>(kinds_.size()) * static_cast<double>(angles_);
        for (auto const one : divisions_) total *= static_cast<double>(one);
        return total;
    }

    /// Makes the list of voxels, or halves them, and leaves out those in which nothing can be put.
    /// A list that would be too long stays as it is.
    void divide()
    {
        bool const can_be_halved =
            is_angle_ || are_balls_ ||
            packing_.edge(0) / static_cast<double>(divisions_[0]) > inner_of(kinds_[0]) / 8;
        if (has_voxels_ && !can_be_halved) return;
        std::size_t const parts = has_voxels_ ? std::size_t{1} << (D + is_angle_) : 1;
        std::vector<Voxel> parents = std::move(voxels_);
        double total = number_of_voxels();
        if (has_voxels_) {
            for (auto &one : divisions_) one *= 2;
            if (is_angle_) angles_ *= 2;
            ++halvings_;
            total *= static_cast<double>(parts);
        }
        auto const parent = [&](std::size_t k) { return parts > 1 ? parents[k] : numbered(k); };
        bool const is_done =
            keep_free(parts > 1 ? parents.size() : static_cast<std::size_t>(total), parts, parent);
        has_voxels_ = true;
        if (!is_done) { // the parents, which are fewer
            for (auto &one : divisions_) one /= 2;
            if (is_angle_) angles_ /= 2;
            --halvings_;
            voxels_ = std::move(parents);
            total /= static_cast<double>(parts);
            few_ /= 2;
        }
        share_ = static_cast<double>(voxels_.size()) / total;
        is_saturated_ = voxels_.empty() || halvings_ == most_halvings;
    }

    /// The voxels by their numbers, before any is halved.
    Voxel numbered(std::size_t number) const noexcept
    {
        Voxel voxel{};
        voxel.angle = number % angles_;
        number /= angles_;
        for (std::size_t i = 0; i < D; ++i) {
            voxel.corner[i] = number % divisions_[i];
            number /= divisions_[i];
        }
        voxel.kind = static_cast<std::uint32_t>(number);
        return voxel;
    }

    /// The parts of voxels in which something may be put; false if they are too many, unless they
    /// were never divided.
    template <class Parent>
    bool keep_free(std::size_t number, std::size_t parts, Parent const &parent)
    {
        std::vector<std::array<double, 2>> squares;
        for (auto const &one : kinds_) squares.push_back(squares_of(one));
        constexpr std::size_t chunk = 1024;
        auto const chunks = static_cast<std::int64_t>((number + chunk - 1) / chunk);
        std::vector<std::vector<Voxel>> kept(static_cast<std::size_t>(chunks));
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic)
#endif
        for (std::int64_t c = 0; c < chunks; ++c) {
            std::size_t const end = std::min(static_cast<std::size_t>(c + 1) * chunk, number);
            for (std::size_t k = static_cast<std::size_t>(c) * chunk; k < end; ++k)
                for (std::size_t part = 0; part < parts; ++part) {
                    Voxel const voxel = parts == 1 ? parent(k) : halved(parent(k), part);
                    if (!is_taken(voxel, squares[voxel.kind]))
                        kept[static_cast<std::size_t>(c)].push_back(voxel);
                }
        }
        std::size_t total = 0;
        for (auto const &some : kept) total += some.size();
        if (total > most_voxels && parts > 1) return false;
        voxels_.clear();
        voxels_.reserve(total);
        for (auto const &some : kept) voxels_.insert(voxels_.end(), some.begin(), some.end());
        return true;
    }

    Voxel halved(Voxel voxel, std::size_t part) const noexcept
    {
        for (std::size_t i = 0; i < D; ++i) voxel.corner[i] = 2 * voxel.corner[i] + (part >> i & 1);
        if (is_angle_) voxel.angle = 2 * voxel.angle + (part >> D & 1);
        return voxel;
    }

    /// Whether one particle overlaps all that could be put into a voxel: what is inside of all
    /// that, at each of its corners. Places at which two ellipsoids overlap are a convex set, so
    /// that the corners decide.
    bool is_taken(Voxel const &voxel, std::array<double, 2> const &squares) const
    {
        if (!(squares[1] > 0)) return false;
        Body<D> const body = body_of(voxel, squares);
        Vector<D> place;
        for (std::size_t i = 0; i < D; ++i)
            place[i] =
                (static_cast<double>(voxel.corner[i]) + 0.5) / static_cast<double>(divisions_[i]);
        std::array<Vector<D>, 1 << D> corners;
        double reach = 0;
        for (std::size_t c = 0; c < corners.size(); ++c) {
            Vector<D> half;
            for (std::size_t i = 0; i < D; ++i)
                half[i] =
                    (static_cast<double>(c >> i & 1) - 0.5) / static_cast<double>(divisions_[i]);
            corners[c] = packing_.point(half);
            reach = std::max(reach, length<D>(corners[c]));
        }
        return packing_.any_near(
            place, packing_.point(place), [&](Vector<D> const &r, Body<D> const &other) {
                double const distance = length<D>(r);
                if (distance > body.outer + other.outer) return false;
                if (distance + reach + rounding_of_places * packing_.edges() <
                    (body.inner + other.inner) * (1 - rounding))
                    return true;
                return std::all_of(corners.begin(), corners.end(), [&](Vector<D> const &corner) {
                    Vector<D> from = r;
                    for (std::size_t k = 0; k < D; ++k) from[k] -= corner[k];
                    return overlaps(from, body.q, other.q);
                });
            });
    }

    /// Of what is inside all bodies of a voxel, less what rounding can take: an ellipse, or in
    /// three dimensions a ball.
    std::array<double, 2> squares_of(Axes const &axes) const
    {
        double const inner = inner_of(axes), outer = outer_of(axes);
        auto const within = D == 2 ? inside_turned(outer, inner, half_width(angles_))
                                   : std::array<double, 2>{inner, inner};
        return squares_within(within, lost(outer, packing_.edges()));
    }

    Body<D> body_of(Voxel const &voxel, std::array<double, 2> const &squares) const
    {
        Body<D> body{{}, std::sqrt(squares[0]), std::sqrt(squares[1])};
        if constexpr (D == 2)
            body.q =
                form_within(squares, twice_middle(voxel.angle, angles_) +
                                         (kinds_[voxel.kind][0] < kinds_[voxel.kind][1] ? pi : 0));
        else
            body.q = {squares[0], 0, 0, squares[0], 0, squares[0]};
        return body;
    }

    Packing<D> packing_;
    std::vector<Axes> kinds_;
    std::vector<Voxel> voxels_;
    std::vector<char> is_free_;
    std::array<std::uint64_t, D> divisions_;
    std::uint64_t angles_;
    std::uint64_t seed_, next_ = 0;
    double attempts_ = 0, share_ = 1, few_ = few_accepted;
    int halvings_ = 0;
    bool is_angle_, are_balls_, has_voxels_ = false, is_saturated_ = false;
};

constexpr char const *capsule_name = "random addition";

Addition *addition_of(PyObject *capsule)
{
    return static_cast<Addition *>(PyCapsule_GetPointer(capsule, capsule_name));
}

void destroy(PyObject *capsule) { delete addition_of(capsule); }

} // namespace

PyObject *random_addition(PyObject *, PyObject *args)
{
    PyObject *cell, *semi_axes;
    int dimensions;
    unsigned long long seed;
    if (!PyArg_ParseTuple(args, "OOiK", &cell, &semi_axes, &dimensions, &seed)) return nullptr;
    npy_intp three = 3, kinds = -1;
    auto const *const vectors =
        static_cast<double const *>(data_of(cell, NPY_DOUBLE, three, 3, false));
    if (vectors == nullptr) return nullptr;
    auto const *const axes =
        static_cast<double const *>(data_of(semi_axes, NPY_DOUBLE, kinds, 3, false));
    if (axes == nullptr) return nullptr;
    try {
        auto const count = static_cast<std::size_t>(kinds);
        std::unique_ptr<Addition> made;
        if (dimensions == 2)
            made = std::make_unique<AdditionIn<2>>(vectors, axes, count, seed);
        else
            made = std::make_unique<AdditionIn<3>>(vectors, axes, count, seed);
        PyObject *const capsule = PyCapsule_New(made.get(), capsule_name, destroy);
        if (capsule != nullptr) made.release();
        return capsule;
    } catch (std::bad_alloc const &) {
        return PyErr_NoMemory();
    }
}

PyObject *random_addition_advance(PyObject *, PyObject *args)
{
    PyObject *capsule;
    Py_ssize_t most;
    double limit;
    if (!PyArg_ParseTuple(args, "Odn", &capsule, &limit, &most)) return nullptr;
    Addition *const addition = addition_of(capsule);
    if (addition == nullptr) return nullptr;
    bool has_memory = true;
    Py_BEGIN_ALLOW_THREADS;
    try {
        addition->advance(static_cast<std::size_t>(most), limit);
    } catch (std::bad_alloc const &) {
        has_memory = false;
    }
    Py_END_ALLOW_THREADS;
    return has_memory ? addition->state() : PyErr_NoMemory();
}

PyObject *inside_turned_ellipses(PyObject *, PyObject *args)
{
    double a, b, angle;
    if (!PyArg_ParseTuple(args, "ddd", &a, &b, &angle)) return nullptr;
    auto const axes = inside_turned(a, b, angle);
    return Py_BuildValue("dd", axes[0], axes[1]);
}

PyObject *radius_inside_body(PyObject *, PyObject *args)
{
    double outer, inner;
    if (!PyArg_ParseTuple(args, "dd", &outer, &inner)) return nullptr;
    return PyFloat_FromDouble(radius_inside(outer, inner));
}

PyObject *form_of_voxel(PyObject *, PyObject *args)
{
    double a, b, edges;
    unsigned long long angle, angles;
    if (!PyArg_ParseTuple(args, "dddKK", &a, &b, &edges, &angle, &angles)) return nullptr;
    auto const squares = squares_within(inside_turned(a, b, half_width(angles)), lost(a, edges));
    if (!(squares[1] > 0)) Py_RETURN_NONE;
    auto const q = form_within(squares, twice_middle(angle, angles));
    return Py_BuildValue("ddd", q[0], q[1], q[2]);
}

PyObject *random_addition_placed(PyObject *, PyObject *capsule)
{
    Addition const *const addition = addition_of(capsule);
    return addition == nullptr ? nullptr : addition->placed();
}

} // namespace pypw85

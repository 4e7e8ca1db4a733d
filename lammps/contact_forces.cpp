// SPDX-License-Identifier: GPL-2.0-only
// The formulas of the laws of contact_law.hpp: forces and couples of one contact, and of many.
#include "contact_law.hpp"

#include <pw85.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pw85_lammps {

namespace {

Vector without_part_along(Vector const &x, Vector const &normal)
{
    return x - dot(x, normal) * normal;
}

/// Returns the larger number. Compilers vectorise a choice between two numbers, but not one between
/// two computations.
double larger(double a, double b) { return a > b ? a : b; }

constexpr double tiny = std::numeric_limits<double>::min();

} // namespace

Vector turn_into_plane(Vector const &x, Vector const &normal)
{
    Vector const part = without_part_along(x, normal);
    return std::sqrt(dot(x, x) / larger(dot(part, part), tiny)) * part;
}

namespace {

/// Returns 1 for positive numbers, 0 for zero. It divides, because compilers make branches from a
/// choice between two constants, and do not vectorise them.
double one_if_positive(double x) { return x / larger(x, tiny); }

/// The spring and the damper of a contact, and the largest force that they can have.
struct Slider {
    double stiffness, damping, limit, spring;
};

/// Returns the force of a slider with a spring that has been turned with the contact. If it slides,
/// the spring becomes as long as Coulomb's limit allows. A spring of zero, which contacts have
/// while a run is set up for the first time, gives no force above the limit, as in LAMMPS.
Vector friction(Slider const &slider, Vector const &slip, Vector &spring)
{
    Vector const force = -slider.stiffness * spring - slider.damping * slip;
    double const ratio = slider.limit / larger(std::sqrt(dot(force, force)), slider.limit + tiny);
    double const known = one_if_positive(dot(spring, spring)),
                 slides = one_if_positive(1.0 - ratio);
    Vector const limited = (1.0 - slides * (1.0 - known) * slider.spring) * ratio * force;
    double const compliance = known * slider.spring / (slider.stiffness + (1.0 - slider.spring));
    spring = spring + compliance * (force - limited);
    return limited;
}

/// Returns the couple that resists rolling. The velocity of rolling is that of Wang,
/// Alonso-Marroquin, Xue and Xie (Particuology 23, 49, 2015), as in LAMMPS's `rolling sds`.
Vector rolling_couple(LawConstants::Slider const &c, Encounter const &e, double pressure,
                      Vector &spring)
{
    Vector const slip = e.radius * cross(e.normal, e.spin);
    spring = turn_into_plane(spring, e.normal) + (c.spring * e.timestep) * slip;
    return -e.radius *
           cross(e.normal,
                 friction({c.stiffness, c.damping, c.friction * pressure, c.spring}, slip, spring));
}

/// Returns the couple about the normal that resists twisting, as in LAMMPS's `twisting sds` and
/// `twisting marshall`. The second law is that of a disc with the contact's radius, on which
/// sliding has its stiffness, its damping and its limit everywhere (J. S. Marshall, J. Comp. Phys.
/// 228, 1541, 2009). Beyond the limit, the couple is that of the limit against the spin.
///
/// @param size the contact's radius
Vector twisting_couple(LawConstants::Twister const &c, Slider const &sliding, Encounter const &e,
                       double size, double pressure, double &spring)
{
    double const rate = dot(e.spin, e.normal), square = 0.5 * c.by_sliding * size * size;
    double const stiffness = c.stiffness + square * sliding.stiffness,
                 damping = c.damping + square * sliding.damping;
    double const limit = c.friction * pressure + 2.0 / 3.0 * c.by_sliding * size * sliding.limit;
    spring += e.timestep * rate;
    double const torque = -stiffness * spring - damping * rate;
    double const against = rate > 0.0 ? -limit : rate < 0.0 ? limit : 0.0;
    double const limited = std::abs(torque) > limit ? against : torque;
    spring += (torque - limited) / larger(stiffness, tiny);
    return limited * e.normal;
}

double damping(LawConstants const &c, double mass, double size, double stiffness)
{
    return c.damping + c.damping_by_mass * mass + c.damping_by_size * mass * size +
           c.damping_by_root * std::sqrt(mass * stiffness);
}

/// The forces of a contact along its normal, without damping.
struct NormalPart {
    double size, secant; ///< the contact's radius, and what `tsuji` takes as the stiffness
    double force;
    /// tangent: dF/dδ; by_radius: derivative of the energy by the equivalent radius
    double energy, tangent, by_radius;
};

NormalPart elastic_part(LawConstants const &c, Encounter const &e)
{
    double const size = std::sqrt(e.radius * e.depth),
                 secant = c.stiffness + c.stiffness_by_size * size;
    double const energy = c.energy * secant * e.depth * e.depth;
    return {size,
            secant,
            secant * e.depth,
            energy,
            c.tangent * secant,
            c.by_radius * energy / e.radius};
}

/// Returns whether surfaces have no contact, but at most a liquid bridge. A contact of JKR ends at
/// a gap.
bool is_apart(LawConstants const &c, double radius, double depth)
{
    return !(depth > (c.jkr ? -c.jkr->largest_gap(radius) : 0.0));
}

/// Returns the contact's radius; 0 if surfaces are apart.
double contact_size(LawConstants const &c, double radius, double depth)
{
    if (is_apart(c, radius, depth)) return 0.0;
    return c.jkr ? c.jkr->size(radius, depth) : std::sqrt(radius * depth);
}

/// Computes the normal force with attraction. There is no elastic force between surfaces that are
/// apart.
NormalPart cohesive_part(LawConstants const &c, Encounter const &e)
{
    if (is_apart(c, e.radius, e.depth)) return {};
    if (c.jkr) {
        double const size = c.jkr->size(e.radius, e.depth);
        return {size,
                c.stiffness_by_size * size,
                c.jkr->force(e.radius, size),
                c.jkr->energy(e.radius, size),
                std::abs(c.jkr->slope(e.radius, size)),
                0.0};
    }
    NormalPart part = elastic_part(c, e);
    part.force -= c.pull * e.radius;
    part.energy -= c.pull * e.radius * e.depth;
    return part;
}

/// Returns the force on which Coulomb's limits depend. With attraction it is that of Thornton (J.
/// Phys. D 24, 1942, 1991), as in LAMMPS: the force plus twice the largest tension.
double pressing_force(LawConstants const &c, Encounter const &e, double force)
{
    double const tension = c.jkr ? c.jkr->pull_off_force(e.radius) : c.pull * e.radius;
    return std::abs(force + 2.0 * tension);
}

/// Purposes of a law.
enum class Scope {
    sliding,  ///< springs, dampers and friction
    turning,  ///< also resistance to rolling or twisting
    cohesive, ///< also attraction
};

template <Scope scope>
Reaction reaction(LawConstants const &c, Encounter const &e, Springs &springs)
{
    constexpr bool attracts = scope == Scope::cohesive;
    NormalPart const part = attracts ? cohesive_part(c, e) : elastic_part(c, e);
    double const damped = damping(c, e.mass, part.size, part.secant),
                 approach = dot(e.velocity, e.normal);
    double pressure = larger(part.force + damped * approach, c.least_pressure),
           limit = std::abs(pressure);
    double energy = part.energy;
    if constexpr (attracts) {
        bool const apart = is_apart(c, e.radius, e.depth);
        if (apart) pressure = 0.0;
        if (c.jkr || c.pull > 0.0) limit = pressing_force(c, e, part.force);
        if (c.bridge) {
            double const radius = LiquidBridge::radius(e.curvatures);
            pressure -= c.bridge->force(radius, larger(0.0, -e.depth));
            energy += c.bridge->energy(radius, -e.depth);
        }
        if (apart) {
            springs = {};
            return {-pressure * e.normal, energy, 0.0, 0.0, {}};
        }
    }
    Reaction result{-pressure * e.normal, energy, part.tangent, part.by_radius, {}};
    LawConstants::Slider const &s = c.sliding;
    Slider const slider{s.stiffness + s.stiffness_by_size * part.size, s.damping * damped,
                        s.friction * limit, s.spring};
    if constexpr (scope != Scope::sliding)
        result.couple = rolling_couple(c.rolling, e, limit, springs.rolling) +
                        twisting_couple(c.twisting, slider, e, part.size, limit, springs.twisting);
    Vector const slip = e.velocity - approach * e.normal;
    springs.sliding = without_part_along(springs.sliding + s.spring * e.timestep * slip, e.normal);
    result.force = result.force + friction(slider, slip, springs.sliding);
    return result;
}

/// A law at some contacts.
struct RowLaw {
    LawConstants constants;
    /// distance from the surfaces within which forces act and velocities count, over the depth
    double inward_force, inward_motion;
    double timestep;
    std::size_t begin, end;

    template <Scope scope>
    void react(GrainSearch::Rows const &geometry, ContactRows &rows, std::size_t l) const
    {
        constexpr bool turns = scope != Scope::sliding;
        Vector const normal = load(geometry.normal, l), overlap = geometry.depth[l] * normal;
        auto const [end1, end2] = geometry.arms(l);
        Vector const arm1 = end1 - inward_force * overlap, arm2 = end2 + inward_force * overlap;
        Vector const place1 = end1 - inward_motion * overlap,
                     place2 = end2 + inward_motion * overlap;
        Vector const spin1 = load(rows.spin1, l), spin2 = load(rows.spin2, l);
        Vector const velocity =
            load(rows.velocity, l) + cross(spin1, place1) - cross(spin2, place2);
        double const mass = rows.mass[l], share = rows.share[l];
        Springs springs{load(rows.sliding, l), turns ? load(rows.rolling, l) : Vector{},
                        turns ? rows.twisting[l] : 0.0};
        Encounter const e{normal,
                          geometry.depth[l],
                          geometry.radius[l],
                          mass,
                          geometry.curvatures[l],
                          velocity,
                          spin1 - spin2,
                          timestep};
        Reaction const r = reaction<scope>(constants, e, springs);
        Vector const force = share * r.force, couple = share * r.couple;
        store(force, rows.force, l);
        store(cross(arm1, force) + couple, rows.torque1, l);
        store(cross(force, arm2) - couple, rows.torque2, l);
        store(springs.sliding, rows.sliding, l);
        if constexpr (turns) {
            store(springs.rolling, rows.rolling, l);
            rows.twisting[l] = springs.twisting;
        }
        rows.energy[l] = share * r.energy;
        rows.rate[l] = share * r.stiffness / mass;
        rows.by_radius[l] = share * r.by_radius;
    }
};

/// Computes all contacts of a law.
template <Scope scope>
void react_each(RowLaw const &law, GrainSearch::Rows const &geometry, ContactRows &rows)
{
    RowLaw const copy = law; // the compiler knows that the rows do not overlap it
    for (std::size_t l = copy.begin; l < copy.end; ++l) copy.react<scope>(geometry, rows, l);
}

using ReactRows = void(RowLaw const &, GrainSearch::Rows const &, ContactRows &);

// react_each() for each instruction set of lanes.hpp.

template <Scope scope>
[[gnu::flatten]] void react_baseline(RowLaw const &law,
                                     GrainSearch::Rows const &__restrict geometry,
                                     ContactRows &__restrict rows)
{
    react_each<scope>(law, geometry, rows);
}

#ifdef PW85_GRAIN_SETS
template <Scope scope>
[[gnu::flatten, gnu::target("avx2")]] void react_avx2(RowLaw const &law,
                                                      GrainSearch::Rows const &__restrict geometry,
                                                      ContactRows &__restrict rows)
{
    react_each<scope>(law, geometry, rows);
}

template <Scope scope> [[gnu::flatten, gnu::target("avx512f")]] void
react_avx512(RowLaw const &law, GrainSearch::Rows const &__restrict geometry,
             ContactRows &__restrict rows)
{
    react_each<scope>(law, geometry, rows);
}

/// Returns the function for the instruction set of chosen_set().
template <Scope scope> ReactRows *react_rows()
{
    static ReactRows *const functions[] = {react_baseline<scope>, react_avx2<scope>,
                                           react_avx512<scope>};
    return functions[static_cast<std::size_t>(chosen_set())];
}
#else
template <Scope scope> ReactRows *react_rows() { return react_baseline<scope>; }
#endif

/// Computes one contact after the other: cohesive laws need branches.
void react_cohesive(RowLaw const &law, GrainSearch::Rows const &geometry, ContactRows &rows)
{
    for (std::size_t l = law.begin; l < law.end; ++l) law.react<Scope::cohesive>(geometry, rows, l);
}

} // namespace

/// With the semi-axes b and c of the contact's ellipse, its area is πbc, and a disc with the same
/// conductance as the ellipse between two large bodies has the radius agm(b, c). That is √(R δ) in
/// Hertz's theory (pw85_hertz). A contact of jkr counts as an ellipse of the same shape.
double ContactLaw::conductance(GrainGeometry const &contact) const
{
    double const size = contact_size(constants_, contact.radius, contact.depth);
    if (heat_ == Heat::radius) return 2.0 * conductivity_ * size;
    double radius = 0.0, ellipse[2];
    pw85_hertz(contact.curvatures.data(), &radius, ellipse);
    double const area_of_disc = std::numbers::pi * size * size;
    return conductivity_ * area_of_disc * std::sqrt(ellipse[0] * ellipse[1]) / radius;
}

Reaction ContactLaw::react(Encounter const &e, Springs &springs) const
{
    if (sticks()) return reaction<Scope::cohesive>(constants_, e, springs);
    return resists_turning() ? reaction<Scope::turning>(constants_, e, springs)
                             : reaction<Scope::sliding>(constants_, e, springs);
}

void ContactLaw::react(GrainSearch::Rows const &geometry, ContactRows &rows, std::size_t first,
                       std::size_t count, Arms arms, double timestep) const
{
    if (arms == Arms::granular)
        for (std::size_t l = first; l < first + count; ++l)
            store(turn_into_plane(load(rows.sliding, l), load(geometry.normal, l)), rows.sliding,
                  l);
    double const inward_force = arms == Arms::surface ? 0.0 : 0.5,
                 inward_motion = arms == Arms::contact ? 0.5 : 0.0;
    RowLaw const law{constants_, inward_force, inward_motion, timestep, first, first + count};
    if (sticks()) return react_cohesive(law, geometry, rows);
    auto *const react =
        resists_turning() ? react_rows<Scope::turning>() : react_rows<Scope::sliding>();
    react(law, geometry, rows);
}

} // namespace pw85_lammps

// SPDX-License-Identifier: GPL-2.0-only
// Laws of force between grains: their words, their mixing, and their formulas.
#include "contact_law.hpp"

#include <pw85.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace LAMMPS_NS;

namespace pw85_lammps {

namespace {

/// Returns E* of two bodies.
double young_of_contact(double e1, double nu1, double e2, double nu2)
{
    return 1.0 / ((1.0 - nu1 * nu1) / e1 + (1.0 - nu2 * nu2) / e2);
}

/// Returns G* of two bodies, 1/((2-ν1)/G1 + (2-ν2)/G2) with G = E/(2(1+ν)).
double shear_of_contact(double e1, double nu1, double e2, double nu2)
{
    return 1.0 / (2.0 * (2.0 - nu1) * (1.0 + nu1) / e1 + 2.0 * (2.0 - nu2) * (1.0 + nu2) / e2);
}

/// Returns the factor of √(m k) for a coefficient of restitution: the polynomial of LAMMPS's
/// `damping tsuji`, which fits Tsuji, Tanaka and Ishida (Powder Technology 71, 239, 1992).
double tsuji_factor(double restitution)
{
    double sum = 0.0;
    for (double const c : {4.8218, -18.022, 27.467, -22.348, 11.087, -4.2783, 1.2728})
        sum = sum * restitution + c;
    return sum;
}

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

ContactLaw ContactLaw::parse(LAMMPS *lammps, std::string const &style, int count, char **words)
{
    Words parser(lammps, style + ": the law of force", count, words);
    ContactLaw law;
    law.parse_normal(parser);
    while (!parser.done()) {
        std::string const keyword = parser.word("a keyword");
        if (keyword == "damping") {
            law.damping_ =
                parser.choice<Damping>("damping", {{"velocity", Damping::velocity},
                                                   {"mass_velocity", Damping::mass_velocity},
                                                   {"viscoelastic", Damping::viscoelastic},
                                                   {"tsuji", Damping::tsuji}});
        } else if (keyword == "tangential") {
            law.parse_tangential(parser);
        } else if (keyword == "rolling") {
            law.parse_rolling(parser);
        } else if (keyword == "twisting") {
            law.parse_twisting(parser);
        } else if (keyword == "liquid") {
            law.parse_liquid(parser);
        } else if (keyword == "heat") {
            law.parse_heat(parser);
        } else if (keyword == "limit_damping") {
            law.limits_damping_ = true;
        } else {
            parser.refuse("has an unknown keyword " + keyword +
                          ": use damping, tangential, rolling, twisting, liquid, heat or "
                          "limit_damping");
        }
    }
    law.check_words(parser);
    if (law.damping_ == Damping::tsuji) law.damping_factor_ = tsuji_factor(law.damping_factor_);
    law.combine_materials(law, law);
    law.find_constants();
    return law;
}

void ContactLaw::check_words(Words &parser) const
{
    if (damping_ == Damping::tsuji && damping_factor_ > 1.0)
        parser.refuse("has a coefficient of restitution above 1");
    if (limits_damping_ && (normal_ == Normal::dmt || normal_ == Normal::jkr))
        parser.refuse(
            "has limit_damping, which forbids the attraction of dmt and jkr: leave it out");
    if (twisting_ == Twisting::marshall && !has_spring())
        parser.refuse("has twisting marshall, which follows from the tangential spring: add "
                      "tangential linear_history or "
                      "mindlin, or use twisting sds");
}

void ContactLaw::parse_normal(Words &parser)
{
    enum class Form { hooke, hertz, material, dmt, jkr };
    auto const form = parser.choice<Form>("normal law", {{"hooke", Form::hooke},
                                                         {"hertz", Form::hertz},
                                                         {"hertz/material", Form::material},
                                                         {"dmt", Form::dmt},
                                                         {"jkr", Form::jkr}});
    bool const has_material = form != Form::hooke && form != Form::hertz;
    normal_ = form == Form::hooke ? Normal::hooke
              : form == Form::dmt ? Normal::dmt
              : form == Form::jkr ? Normal::jkr
                                  : Normal::hertz;
    (has_material ? young_ : stiffness_) =
        has_material ? parser.positive("Young's modulus") : parser.number("stiffness");
    damping_factor_ = parser.number("damping");
    if (has_material) poisson_ = parser.number("Poisson's ratio", 0.0, 0.5);
    if (form == Form::dmt || form == Form::jkr) surface_energy_ = parser.positive("surface energy");
}

void ContactLaw::parse_tangential(Words &parser)
{
    tangential_ = parser.choice<Tangential>("tangential law",
                                            {{"none", Tangential::none},
                                             {"linear_nohistory", Tangential::linear_nohistory},
                                             {"linear_history", Tangential::linear_history},
                                             {"mindlin", Tangential::mindlin}});
    if (tangential_ == Tangential::none) return;
    if (tangential_ == Tangential::mindlin) {
        auto const stiffness = parser.number_or_null("tangential stiffness");
        if (!stiffness && young_ == 0.0)
            parser.refuse("has tangential mindlin NULL, which needs hertz/material, dmt or jkr: "
                          "give the tangential stiffness");
        mindlin_by_material_ = !stiffness;
        tangential_stiffness_ = stiffness.value_or(0.0);
    } else if (tangential_ == Tangential::linear_history) {
        tangential_stiffness_ = parser.number("tangential stiffness");
    }
    if (has_spring() && !mindlin_by_material_ && tangential_stiffness_ == 0.0)
        parser.refuse("has a tangential stiffness of zero: use tangential linear_nohistory");
    tangential_damping_ = parser.number("tangential damping");
    friction_ = parser.number("coefficient of friction");
}

void ContactLaw::parse_rolling(Words &parser)
{
    resists_rolling_ = parser.choice<bool>("rolling law", {{"none", false}, {"sds", true}});
    if (!resists_rolling_) return;
    rolling_stiffness_ = parser.positive("rolling stiffness");
    rolling_damping_ = parser.number("rolling damping");
    rolling_friction_ = parser.number("coefficient of rolling friction");
}

void ContactLaw::parse_twisting(Words &parser)
{
    twisting_ = parser.choice<Twisting>(
        "twisting law",
        {{"none", Twisting::none}, {"marshall", Twisting::marshall}, {"sds", Twisting::sds}});
    if (twisting_ != Twisting::sds) return;
    twisting_stiffness_ = parser.positive("twisting stiffness");
    twisting_damping_ = parser.number("twisting damping");
    twisting_friction_ = parser.number("coefficient of twisting friction");
}

void ContactLaw::parse_liquid(Words &parser)
{
    has_liquid_ = true;
    tension_ = parser.positive("surface tension");
    liquid_volume_ = parser.positive("volume of the liquid");
    liquid_angle_ =
        parser.number("angle of contact in degrees", 0.0, 90.0) * std::numbers::pi / 180.0;
}

void ContactLaw::parse_heat(Words &parser)
{
    heat_ = parser.choice<Heat>(
        "law of heat", {{"none", Heat::none}, {"area", Heat::area}, {"radius", Heat::radius}});
    if (conducts())
        conductivity_ = parser.number(heat_ == Heat::area ? "heat transfer coefficient"
                                                          : "thermal conductivity");
}

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

double ContactLaw::largest_gap(double radius) const
{
    double const jkr = constants_.jkr ? constants_.jkr->largest_gap(radius) : 0.0;
    return std::max(jkr, constants_.bridge ? constants_.bridge->largest_gap() : 0.0);
}

std::optional<ContactLaw> ContactLaw::mixed(ContactLaw const &a, ContactLaw const &b)
{
    if (a.normal_ != b.normal_ || a.damping_ != b.damping_ || a.tangential_ != b.tangential_ ||
        (a.young_ > 0.0) != (b.young_ > 0.0) || a.mindlin_by_material_ != b.mindlin_by_material_ ||
        a.limits_damping_ != b.limits_damping_ || a.resists_rolling_ != b.resists_rolling_ ||
        a.twisting_ != b.twisting_ || a.has_liquid_ != b.has_liquid_ || a.heat_ != b.heat_)
        return {};
    ContactLaw law = a;
    law.stiffness_ = std::sqrt(a.stiffness_ * b.stiffness_);
    law.damping_factor_ = std::sqrt(a.damping_factor_ * b.damping_factor_);
    law.tangential_stiffness_ = std::sqrt(a.tangential_stiffness_ * b.tangential_stiffness_);
    law.tangential_damping_ = std::sqrt(a.tangential_damping_ * b.tangential_damping_);
    law.friction_ = std::sqrt(a.friction_ * b.friction_);
    law.rolling_stiffness_ = std::sqrt(a.rolling_stiffness_ * b.rolling_stiffness_);
    law.rolling_damping_ = std::sqrt(a.rolling_damping_ * b.rolling_damping_);
    law.rolling_friction_ = std::sqrt(a.rolling_friction_ * b.rolling_friction_);
    law.twisting_stiffness_ = std::sqrt(a.twisting_stiffness_ * b.twisting_stiffness_);
    law.twisting_damping_ = std::sqrt(a.twisting_damping_ * b.twisting_damping_);
    law.twisting_friction_ = std::sqrt(a.twisting_friction_ * b.twisting_friction_);
    law.surface_energy_ = std::sqrt(a.surface_energy_ * b.surface_energy_);
    law.tension_ = std::sqrt(a.tension_ * b.tension_);
    law.liquid_volume_ = std::sqrt(a.liquid_volume_ * b.liquid_volume_);
    law.liquid_angle_ = std::acos(std::sqrt(std::cos(a.liquid_angle_) * std::cos(b.liquid_angle_)));
    law.conductivity_ = std::sqrt(a.conductivity_ * b.conductivity_);
    law.combine_materials(a, b);
    law.find_constants();
    return law;
}

void ContactLaw::combine_materials(ContactLaw const &a, ContactLaw const &b)
{
    if (a.young_ == 0.0) return;
    stiffness_ = 4.0 / 3.0 * young_of_contact(a.young_, a.poisson_, b.young_, b.poisson_);
    if (mindlin_by_material_)
        tangential_stiffness_ = 8.0 * shear_of_contact(a.young_, a.poisson_, b.young_, b.poisson_);
}

void ContactLaw::find_constants()
{
    LawConstants &c = constants_ = {};
    bool const is_hertz = normal_ != Normal::hooke, is_mindlin = tangential_ == Tangential::mindlin;
    (is_hertz ? c.stiffness_by_size : c.stiffness) = stiffness_;
    c.energy = is_hertz ? 0.4 : 0.5;
    c.tangent = is_hertz ? 1.5 : 1.0;
    c.by_radius = is_hertz ? 0.5 : 0.0;
    double *const dampings[] = {&c.damping, &c.damping_by_mass, &c.damping_by_size,
                                &c.damping_by_root};
    *dampings[static_cast<std::size_t>(damping_)] = damping_factor_;
    if (normal_ == Normal::dmt) c.pull = 4.0 * std::numbers::pi * surface_energy_;
    if (normal_ == Normal::jkr) c.jkr.emplace(0.75 * stiffness_, surface_energy_);
    if (has_liquid_) c.bridge.emplace(tension_, liquid_volume_, liquid_angle_);
    c.least_pressure = limits_damping_ ? 0.0 : -std::numeric_limits<double>::infinity();
    (is_mindlin ? c.sliding.stiffness_by_size : c.sliding.stiffness) = tangential_stiffness_;
    c.sliding.damping = tangential_damping_;
    c.sliding.friction = friction_;
    c.sliding.spring = has_spring() ? 1.0 : 0.0;
    c.rolling = {rolling_stiffness_, 0.0, rolling_damping_, rolling_friction_,
                 resists_rolling_ ? 1.0 : 0.0};
    c.twisting = {twisting_stiffness_, twisting_damping_, twisting_friction_,
                  twisting_ == Twisting::marshall ? 1.0 : 0.0};
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

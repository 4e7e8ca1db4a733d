// SPDX-License-Identifier: GPL-2.0-only
// Laws of force between grains: their words, their mixing, and their formulas.
#include "contact_law.hpp"

#include <cmath>

using namespace LAMMPS_NS;

namespace pw85_lammps {

namespace {

/// E* of two bodies.
double young_of_contact(double e1, double nu1, double e2, double nu2)
{
    return 1.0 / ((1.0 - nu1 * nu1) / e1 + (1.0 - nu2 * nu2) / e2);
}

/// G* of two bodies, 1/((2-ν1)/G1 + (2-ν2)/G2) with G = E/(2(1+ν)).
double shear_of_contact(double e1, double nu1, double e2, double nu2)
{
    return 1.0 / (2.0 * (2.0 - nu1) * (1.0 + nu1) / e1 + 2.0 * (2.0 - nu2) * (1.0 + nu2) / e2);
}

/// The factor of √(m k) for a coefficient of restitution: the polynomial of LAMMPS's `damping tsuji`, which fits Tsuji, Tanaka and
/// Ishida (Powder Technology 71, 239, 1992).
double tsuji_factor(double restitution)
{
    double sum = 0.0;
    for (double const c : {4.8218, -18.022, 27.467, -22.348, 11.087, -4.2783, 1.2728}) sum = sum * restitution + c;
    return sum;
}

Vector without_part_along(Vector const &x, Vector const &normal) { return x - dot(x, normal) * normal; }

/// A vector of the same length, along its part in the tangent plane.
Vector turn_into_plane(Vector const &x, Vector const &normal)
{
    Vector const part = without_part_along(x, normal);
    double const square = dot(part, part);
    return square > 0.0 ? std::sqrt(dot(x, x) / square) * part : Vector{};
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
            law.damping_ = parser.choice<Damping>("damping", {{"velocity", Damping::velocity},
                                                              {"mass_velocity", Damping::mass_velocity},
                                                              {"viscoelastic", Damping::viscoelastic},
                                                              {"tsuji", Damping::tsuji}});
        } else if (keyword == "tangential") {
            law.parse_tangential(parser);
        } else if (keyword == "rolling") {
            law.parse_rolling(parser);
        } else if (keyword == "limit_damping") {
            law.limits_damping_ = true;
        } else {
            parser.refuse("has an unknown keyword " + keyword + ": use damping, tangential, rolling or limit_damping");
        }
    }
    if (law.damping_ == Damping::tsuji) {
        if (law.damping_factor_ > 1.0) parser.refuse("has a coefficient of restitution above 1");
        law.damping_factor_ = tsuji_factor(law.damping_factor_);
    }
    law.combine_materials(law, law);
    return law;
}

void ContactLaw::parse_normal(Words &parser)
{
    enum class Form { hooke, hertz, material };
    auto const form = parser.choice<Form>(
        "normal law", {{"hooke", Form::hooke}, {"hertz", Form::hertz}, {"hertz/material", Form::material}});
    normal_ = form == Form::hooke ? Normal::hooke : Normal::hertz;
    if (form == Form::material) {
        young_ = parser.positive("Young's modulus");
    } else {
        stiffness_ = parser.number("stiffness");
    }
    damping_factor_ = parser.number("damping");
    if (form == Form::material) poisson_ = parser.number("Poisson's ratio", 0.0, 0.5);
}

void ContactLaw::parse_tangential(Words &parser)
{
    tangential_ = parser.choice<Tangential>("tangential law", {{"none", Tangential::none},
                                                               {"linear_nohistory", Tangential::linear_nohistory},
                                                               {"linear_history", Tangential::linear_history},
                                                               {"mindlin", Tangential::mindlin}});
    if (tangential_ == Tangential::none) return;
    if (tangential_ == Tangential::mindlin) {
        auto const stiffness = parser.number_or_null("tangential stiffness");
        if (!stiffness && young_ == 0.0)
            parser.refuse("has tangential mindlin NULL, which needs hertz/material: give the tangential stiffness");
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

std::optional<ContactLaw> ContactLaw::mixed(ContactLaw const &a, ContactLaw const &b)
{
    if (a.normal_ != b.normal_ || a.damping_ != b.damping_ || a.tangential_ != b.tangential_ ||
        (a.young_ > 0.0) != (b.young_ > 0.0) || a.mindlin_by_material_ != b.mindlin_by_material_ ||
        a.limits_damping_ != b.limits_damping_ || a.resists_rolling_ != b.resists_rolling_)
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
    law.combine_materials(a, b);
    return law;
}

void ContactLaw::combine_materials(ContactLaw const &a, ContactLaw const &b)
{
    if (a.young_ == 0.0) return;
    stiffness_ = 4.0 / 3.0 * young_of_contact(a.young_, a.poisson_, b.young_, b.poisson_);
    if (mindlin_by_material_)
        tangential_stiffness_ = 8.0 * shear_of_contact(a.young_, a.poisson_, b.young_, b.poisson_);
}

Reaction ContactLaw::react(Encounter const &e, Springs &springs) const
{
    double const contact_radius = std::sqrt(e.radius * e.depth);
    bool const is_hertz = normal_ == Normal::hertz;
    double const secant = is_hertz ? stiffness_ * contact_radius : stiffness_;
    double const damped = damping(e, contact_radius, secant);
    double const approach = dot(e.velocity, e.normal);
    double pressure = secant * e.depth + damped * approach;
    if (limits_damping_ && pressure < 0.0) pressure = 0.0;
    double const energy = (is_hertz ? 0.4 : 0.5) * secant * e.depth * e.depth;
    Reaction result{
        -pressure * e.normal, energy, is_hertz ? 1.5 * secant : secant, is_hertz ? 0.5 * energy / e.radius : 0.0, {}};
    if (resists_rolling_) result.couple = rolling_couple(e, pressure, springs.rolling);
    if (tangential_ == Tangential::none) return result;
    double const stiffness = tangential_stiffness_ * (tangential_ == Tangential::mindlin ? contact_radius : 1.0);
    Slider const slider{stiffness, tangential_damping_ * damped, friction_ * std::abs(pressure), has_spring(), false};
    result.force = result.force + friction(e, slider, e.velocity - approach * e.normal, springs.sliding);
    return result;
}

// The velocity of rolling is that of Wang, Alonso-Marroquin, Xue and Xie (Particuology 23, 49, 2015), as in LAMMPS's `rolling sds`.
Vector ContactLaw::rolling_couple(Encounter const &e, double pressure, Vector &spring) const
{
    Slider const slider{rolling_stiffness_, rolling_damping_, rolling_friction_ * std::abs(pressure), true, true};
    return -e.radius * cross(e.normal, friction(e, slider, e.radius * cross(e.normal, e.spin), spring));
}

double ContactLaw::damping(Encounter const &e, double contact_radius, double stiffness) const
{
    switch (damping_) {
    case Damping::velocity:
        return damping_factor_;
    case Damping::mass_velocity:
        return damping_factor_ * e.mass;
    case Damping::viscoelastic:
        return damping_factor_ * e.mass * contact_radius;
    case Damping::tsuji:
        return damping_factor_ * std::sqrt(e.mass * stiffness);
    }
    return 0.0;
}

// The spring follows the contact. If it slides, it is as long as Coulomb's limit allows. A spring of zero, which contacts have while a
// run is set up for the first time, gives no force above the limit, as in LAMMPS.
Vector ContactLaw::friction(Encounter const &e, Slider const &slider, Vector const &slip, Vector &spring) const
{
    if (slider.has_spring && e.timestep > 0.0) {
        if (slider.keeps_length) spring = turn_into_plane(spring, e.normal);
        spring = spring + e.timestep * slip;
        if (!slider.keeps_length) spring = without_part_along(spring, e.normal);
    }
    Vector const force = -slider.stiffness * spring - slider.damping * slip;
    double const square = dot(force, force);
    if (square <= slider.limit * slider.limit) return force;
    if (slider.has_spring && dot(spring, spring) == 0.0) return {};
    Vector const limited = (slider.limit / std::sqrt(square)) * force;
    if (slider.has_spring) spring = (-1.0 / slider.stiffness) * (limited + slider.damping * slip);
    return limited;
}

} // namespace pw85_lammps

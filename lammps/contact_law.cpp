// SPDX-License-Identifier: GPL-2.0-only
// Laws of force between grains: their words and their mixing. contact_forces.cpp has the formulas.
#include "contact_law.hpp"

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

} // namespace pw85_lammps

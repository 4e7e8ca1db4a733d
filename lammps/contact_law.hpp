// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The laws of force between grains. Words, units and formulas are those of LAMMPS's pair_style granular.
#ifndef PW85_LAMMPS_CONTACT_LAW_HPP_INCLUDED
#define PW85_LAMMPS_CONTACT_LAW_HPP_INCLUDED

#include "vectors.hpp"
#include "words.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace pw85_lammps {

/// What a law needs to know of a contact. Velocities are those of the first body relative to the second, at the contact.
struct Encounter {
    Vector const &normal; ///< out of the first body
    double depth, radius, mass;
    Vector velocity, spin; ///< spin: angular velocity of the first body relative to the second
    double timestep;       ///< time since the springs were last updated; zero keeps them as they are
};

/// What a contact keeps from step to step: how far the first body has slid and rolled since it began. Seen from the second body, the
/// first vector has the opposite sign, and the other one is the same.
struct Springs {
    static constexpr int size = 6; ///< numbers in messages

    Vector sliding{}, rolling{};

    Springs reversed() const { return {-1.0 * sliding, rolling}; }

    double *write(double *buffer) const
    {
        return std::copy(rolling.begin(), rolling.end(), std::copy(sliding.begin(), sliding.end(), buffer));
    }

    static Springs read(double const *buffer) { return {vector(buffer), vector(buffer + 3)}; }
};

/// What a law says of a contact.
struct Reaction {
    Vector force;     ///< on the first body
    double energy;    ///< of the normal spring
    double stiffness; ///< dF/dδ of the normal spring
    double by_radius; ///< derivative of the energy by the equivalent radius
    Vector couple;    ///< torque on the first body besides that of the force; the second body has the opposite one
};

/// A normal and a tangential law with their constants.
class ContactLaw {
  public:
    /// Reads `hooke K ETA | hertz K ETA | hertz/material E ETA NU [damping ...] [tangential ...] [rolling ...]
    /// [limit_damping]`.
    /// The first word is words[0].
    static ContactLaw parse(LAMMPS_NS::LAMMPS *lammps, std::string const &style, int count, char **words);

    /// The law of two materials, or nothing if their laws have different forms.
    static std::optional<ContactLaw> mixed(ContactLaw const &a, ContactLaw const &b);

    bool has_spring() const { return tangential_ == Tangential::linear_history || tangential_ == Tangential::mindlin; }

    /// The reaction of a contact, and its new springs.
    Reaction react(Encounter const &e, Springs &springs) const;

  private:
    enum class Normal { hooke, hertz };
    enum class Damping { velocity, mass_velocity, viscoelastic, tsuji };
    enum class Tangential { none, linear_nohistory, linear_history, mindlin };

    /// A spring and a damper in the tangent plane, and the largest force that they can have.
    struct Slider {
        double stiffness, damping, limit;
        bool has_spring;
        bool keeps_length; ///< whether the spring turns with the contact, or loses its part along the normal
    };

    void parse_normal(Words &parser);
    void parse_tangential(Words &parser);
    void parse_rolling(Words &parser);
    void combine_materials(ContactLaw const &a, ContactLaw const &b);
    double damping(Encounter const &e, double contact_radius, double stiffness) const;
    Vector friction(Encounter const &e, Slider const &slider, Vector const &slip, Vector &spring) const;
    Vector rolling_couple(Encounter const &e, double pressure, Vector &spring) const;

    Normal normal_ = Normal::hooke;
    Damping damping_ = Damping::viscoelastic;
    Tangential tangential_ = Tangential::none;
    double stiffness_ = 0.0, damping_factor_ = 0.0;
    double tangential_stiffness_ = 0.0, tangential_damping_ = 0.0, friction_ = 0.0;
    bool resists_rolling_ = false;
    double rolling_stiffness_ = 0.0, rolling_damping_ = 0.0, rolling_friction_ = 0.0;
    double young_ = 0.0, poisson_ = 0.0; ///< of hertz/material; zero for other laws
    bool mindlin_by_material_ = false;   ///< whether the tangential stiffness follows from young_ and poisson_
    bool limits_damping_ = false;
};

} // namespace pw85_lammps

#endif

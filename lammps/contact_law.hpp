// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The laws of force between grains. Words, units and formulas are those of LAMMPS's pair_style
/// granular.
#ifndef PW85_LAMMPS_CONTACT_LAW_HPP_INCLUDED
#define PW85_LAMMPS_CONTACT_LAW_HPP_INCLUDED

#include "cohesion.hpp"
#include "grain_geometry.hpp"
#include "lanes.hpp"
#include "vectors.hpp"
#include "words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pw85_lammps {

/// Point at which the force of a contact acts on each body: at the middle of the overlap, or at the
/// deepest points of both surfaces, as in LAMMPS's gran/hooke/history and gran/hertz/history. The
/// second choice does not conserve angular momentum. The third one is that of LAMMPS's style
/// granular: the force acts at the middle, or on a wall at the surface of the grain; velocities are
/// those of the deepest points; and springs keep their lengths when they turn with the contact.
enum class Arms { contact, surface, granular };

/// Reads `contact | surface | granular`.
inline Arms parse_arms(Words &words)
{
    return words.choice<Arms>(
        "place of its arms",
        {{"contact", Arms::contact}, {"surface", Arms::surface}, {"granular", Arms::granular}});
}

/// Returns the vector turned into the tangent plane: its length, in the direction of its tangential
/// component.
Vector turn_into_plane(Vector const &x, Vector const &normal);

/// Input of a law: the state of a contact. Velocities are those of the first body relative to the
/// second, at the contact.
struct Encounter {
    Vector normal; ///< unit vector, out of the first body
    double depth, radius, mass;
    std::array<double, 2> curvatures; ///< of the gap between both surfaces
    Vector velocity, spin; ///< spin: angular velocity of the first body relative to the second
    double timestep;       ///< time since the springs were last updated; zero does not stretch them
};

/// Memory of a contact from step to step: how far the first body has slid, rolled and twisted
/// since it began. Seen from the second body, the first vector has the opposite sign, and the
/// others are the same.
struct Springs {
    static constexpr int size = 7; ///< numbers in messages

    Vector sliding{}, rolling{};
    double twisting = 0.0; ///< angle about the normal

    Springs reversed() const { return {-1.0 * sliding, rolling, twisting}; }

    double *write(double *buffer) const
    {
        buffer = std::copy(rolling.begin(), rolling.end(),
                           std::copy(sliding.begin(), sliding.end(), buffer));
        *buffer++ = twisting;
        return buffer;
    }

    static Springs read(double const *buffer)
    {
        return {vector(buffer), vector(buffer + 3), buffer[6]};
    }
};

/// Returns the numbers of an atom and its contacts from a restart file, after the first one, which
/// is how many numbers there are. Version 3.0.0 wrote contacts without twisting, the last number of
/// each.
///
/// @param head numbers before those of the contacts; the first of them is the number of contacts
/// @param size numbers of a contact
inline std::vector<double> restarted_contacts(double const *numbers, std::size_t head,
                                              std::size_t size)
{
    auto const total = static_cast<std::size_t>(numbers[0]),
               count = static_cast<std::size_t>(numbers[1]);
    std::size_t const written = count > 0 ? (total - 1 - head) / count : size;
    double const *const first = numbers + 1 + head;
    std::vector<double> all(numbers + 1, first);
    for (std::size_t c = 0; c < count; ++c) {
        all.insert(all.end(), first + written * c, first + written * c + std::min(written, size));
        all.resize(head + size * (c + 1));
    }
    return all;
}

/// Result of a law for a contact.
struct Reaction {
    Vector force;     ///< on the first body
    double energy;    ///< of the normal spring
    double stiffness; ///< dF/dδ of the normal spring
    double by_radius; ///< derivative of the energy by the equivalent radius
    /// torque on the first body in addition to that of the force; the second body has the opposite
    /// one
    Vector couple;
};

/// Returns the mass m1 m2/(m1 + m2) of a contact. A frozen body, of negative mass, moves as if its
/// mass were infinite. Laws take the result: they are vectorised, which its branches prevent.
inline double mass_of_contact(double m1, double m2)
{
    return m1 < 0.0 ? std::abs(m2) : m2 < 0.0 ? m1 : m1 * m2 / (m1 + m2);
}

/// Input of laws for the bodies of some pairs, and the results for the pairs.
struct ContactRows {
    alignas(64) Row<3> velocity; ///< of the first centre relative to the second
    Row<3> spin1, spin2;         ///< angular velocities
    /// the springs of the step before, then those of this step
    Row<3> sliding, rolling;
    double twisting[row_capacity];  ///< twisting springs, too
    double mass[row_capacity];      ///< mass_of_contact()
    double share[row_capacity];     ///< factor of all forces and of the energy
    Row<3> force, torque1, torque2; ///< force: on the first body
    double energy[row_capacity];    ///< of the normal spring
    double rate[row_capacity];      ///< stiffness over mass
    /// derivative of the energy by the equivalent radius
    double by_radius[row_capacity];
};

/// The constants of a law. Constants of parts that a law does not have are zero. The formulas
/// therefore need no branches, and SIMD computes several contacts at a time.
struct LawConstants {
    /// A spring and a damper in the tangent plane, up to a part of the pressure.
    struct Slider {
        /// the second one times the contact's radius a
        double stiffness = 0.0, stiffness_by_size = 0.0;
        double damping = 0.0, friction = 0.0;
        double spring = 0.0; ///< 1 if there is a spring
    };

    double stiffness = 0.0, stiffness_by_size = 0.0;
    /// the energy over the force times the depth, and dF/dδ over F/δ
    double energy = 0.0, tangent = 0.0;
    double by_radius = 0.0; ///< times the energy over the radius
    double damping = 0.0, damping_by_mass = 0.0, damping_by_size = 0.0,
           damping_by_root = 0.0; ///< times 1, m, m a, √(m k)
    /// A spring and a damper that turn about the normal, up to a part of the pressure. Those of
    /// Marshall's law follow from sliding.
    struct Twister {
        double stiffness = 0.0, damping = 0.0, friction = 0.0;
        double by_sliding = 0.0; ///< 1 for Marshall's law
    };

    double least_pressure = 0.0;
    double pull = 0.0;                  ///< of DMT, times the equivalent radius
    std::optional<JkrContact> jkr;      ///< replaces the normal spring
    std::optional<LiquidBridge> bridge; ///< beside it
    Slider sliding, rolling;
    Twister twisting;
};

/// A normal and a tangential law with their constants.
class ContactLaw {
  public:
    /// Reads `hooke K ETA | hertz K ETA | hertz/material E ETA NU | dmt E ETA NU GAMMA | jkr E ETA
    /// NU GAMMA [damping ...] [tangential ...] [rolling ...] [twisting ...] [liquid TENSION VOLUME
    /// ANGLE] [heat ...] [limit_damping]`. The first word is words[0].
    static ContactLaw parse(LAMMPS_NS::LAMMPS *lammps, std::string const &style, int count,
                            char **words);

    /// Returns the law of two materials, or nothing if their laws have different forms.
    static std::optional<ContactLaw> mixed(ContactLaw const &a, ContactLaw const &b);

    bool has_spring() const
    {
        return tangential_ == Tangential::linear_history || tangential_ == Tangential::mindlin;
    }

    /// Returns whether it has springs that roll or twist.
    bool resists_turning() const { return resists_rolling_ || twisting_ != Twisting::none; }

    /// Returns whether the law attracts.
    bool sticks() const { return constants_.pull > 0.0 || constants_.jkr || constants_.bridge; }

    /// Returns the gap between surfaces at which a contact ends that has begun by touching, for an
    /// equivalent radius; 0 without attraction. It grows with the radius.
    double largest_gap(double radius) const;

    bool conducts() const { return heat_ != Heat::none; }

    /// Returns the heat that flows through a contact in a unit of time, over the difference of
    /// temperatures.
    double conductance(GrainGeometry const &contact) const;

    /// Returns the reaction of a contact, and its new springs.
    Reaction react(Encounter const &e, Springs &springs) const;

    /// Computes the forces of contacts from their geometry. Results are meaningless for pairs that
    /// do not overlap.
    ///
    void react(GrainSearch::Rows const &geometry, ContactRows &rows, std::size_t first,
               std::size_t count, Arms arms, double timestep) const;

  private:
    enum class Normal { hooke, hertz, dmt, jkr };
    enum class Damping { velocity, mass_velocity, viscoelastic, tsuji };
    enum class Tangential { none, linear_nohistory, linear_history, mindlin };
    enum class Twisting { none, marshall, sds };
    enum class Heat { none, area, radius };

    void parse_normal(Words &parser);
    void parse_tangential(Words &parser);
    void parse_rolling(Words &parser);
    void parse_twisting(Words &parser);
    void parse_liquid(Words &parser);
    void parse_heat(Words &parser);
    void check_words(Words &parser) const;
    void combine_materials(ContactLaw const &a, ContactLaw const &b);
    void find_constants();

    LawConstants constants_;
    Normal normal_ = Normal::hooke;
    Damping damping_ = Damping::viscoelastic;
    Tangential tangential_ = Tangential::none;
    double stiffness_ = 0.0, damping_factor_ = 0.0;
    double tangential_stiffness_ = 0.0, tangential_damping_ = 0.0, friction_ = 0.0;
    bool resists_rolling_ = false;
    double rolling_stiffness_ = 0.0, rolling_damping_ = 0.0, rolling_friction_ = 0.0;
    Twisting twisting_ = Twisting::none;
    double twisting_stiffness_ = 0.0, twisting_damping_ = 0.0, twisting_friction_ = 0.0;
    double surface_energy_ = 0.0; ///< of dmt and jkr
    bool has_liquid_ = false;
    /// of a liquid bridge; the angle in radians
    double tension_ = 0.0, liquid_volume_ = 0.0, liquid_angle_ = 0.0;
    Heat heat_ = Heat::none;
    double conductivity_ = 0.0; ///< of `heat radius`; of `heat area` over a length
    /// of hertz/material; zero for other laws
    double young_ = 0.0, poisson_ = 0.0;
    /// true if the tangential stiffness follows from young_ and poisson_
    bool mindlin_by_material_ = false;
    bool limits_damping_ = false;
};

} // namespace pw85_lammps

#endif

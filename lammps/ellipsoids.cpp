// SPDX-License-Identifier: GPL-2.0-only
// Reads shapes and orientations from LAMMPS, converts them to forms by pw85, and packs them for the
// ghosts.
#include "ellipsoids.hpp"

#include "words.hpp"

#include <pw85_batch.h>

#include <array>
#include <cmath>
#include <utility>

using namespace LAMMPS_NS;

namespace pw85_lammps {

namespace {

/// Returns a compute property/atom that is not in LAMMPS's list of computes. Only its owner runs
/// it.
std::unique_ptr<Compute> property_compute(LAMMPS *lammps, Modify &modify,
                                          std::vector<std::string> properties)
{
    std::vector<std::string> words{"pw85_ellipsoids", "all", "property/atom"};
    words.insert(words.end(), properties.begin(), properties.end());
    std::vector<char *> arguments(words.size());
    std::transform(words.begin(), words.end(), arguments.begin(),
                   [](std::string &word) { return word.data(); });
    auto const create = modify.compute_map->at("property/atom");
    std::unique_ptr<Compute> compute(
        create(lammps, static_cast<int>(arguments.size()), arguments.data()));
    compute->init();
    return compute;
}

} // namespace

Ellipsoids::Ellipsoids(LAMMPS *lammps, std::string style, std::string otherwise)
    : Pointers(lammps), style_(std::move(style)), otherwise_(std::move(otherwise))
{
    if (!atom->style_match("ellipsoid"))
        stop_all(*error,
                 style_ +
                     " needs ellipsoids: use atom_style ellipsoid, or atom_style hybrid with it");
    shapes_ = property_compute(lammps, *modify, {"shapex", "shapey", "shapez"});
    quaternions_ = property_compute(lammps, *modify, {"quatw", "quati", "quatj", "quatk"});
    if (has_superellipsoids(*atom))
        exponents_ = property_compute(lammps, *modify, {"block1", "block2"});
}

void Ellipsoids::reserve()
{
    auto const capacity = static_cast<std::size_t>(atom->nmax);
    if (radii_.size() >= capacity) return;
    semi_axes_.resize(PW85_DIM * capacity);
    forms_.resize(PW85_SYM * capacity);
    radii_.resize(capacity);
}

void Ellipsoids::read(std::function<bool(int)> const &selected)
{
    reserve();
    if (!has_all_shapes()) read_shapes();
    quaternions_->compute_peratom();
    // Atoms that are not selected may have no shape. Their rows are bad, and are not used.
    pw85_ellipsoid_quaternion_batch(static_cast<std::size_t>(atom->nlocal), semi_axes_.data(),
                                    atom->nlocal > 0 ? quaternions_->array_atom[0] : nullptr,
                                    forms_.data());
    for (int i = 0; i < atom->nlocal; ++i) {
        auto const index = static_cast<std::size_t>(i);
        bool const is_selected = selected(i);
        if (is_selected && std::isnan(forms_[PW85_SYM * index])) refuse_shape(i);
        radii_[index] = is_selected ? largest_semi_axis(i) : 0.0;
    }
}

// Without atom IDs it is unknown whether the atoms are still the same ones.
bool Ellipsoids::has_all_shapes() const
{
    return atom->tag_enable &&
           std::equal(tags_.begin(), tags_.end(), atom->tag, atom->tag + atom->nlocal);
}

// The values that LAMMPS reports for atoms without a shape depend on its release. Here their
// semi-axes are zero, and those of superellipsoids are NaN.
void Ellipsoids::read_shapes()
{
    shapes_->compute_peratom();
    if (exponents_) exponents_->compute_peratom();
    auto const count = static_cast<std::size_t>(atom->nlocal);
    tags_.assign(atom->tag, atom->tag + count);
    for (std::size_t i = 0; i < count; ++i) {
        double const factor = atom->ellipsoid[i] < 0                   ? 0.0
                              : is_superellipsoid(static_cast<int>(i)) ? NAN
                                                                       : 0.5;
        for (std::size_t k = 0; k < PW85_DIM; ++k)
            semi_axes_[PW85_DIM * i + k] = factor * shapes_->array_atom[i][k];
    }
}

/// Returns whether an atom with a shape has exponents other than 2, those of an ellipsoid.
bool Ellipsoids::is_superellipsoid(int i) const
{
    return exponents_ &&
           (exponents_->array_atom[i][0] != 2.0 || exponents_->array_atom[i][1] != 2.0);
}

void Ellipsoids::refuse_shape(int i) const
{
    std::string const type = " (type " + std::to_string(atom->type[i]) + "): ";
    if (atom->ellipsoid[i] < 0)
        refuse(i, "has no shape" + type +
                      "set a shape with the set command (set ... shape Sx Sy Sz) or in the "
                      "Ellipsoids section of the "
                      "data file, or " +
                      otherwise_);
    if (is_superellipsoid(i))
        refuse(i, "is not an ellipsoid, but a superellipsoid" + type +
                      "make its exponents 2 (set ... block 2 2), or " + otherwise_);
    refuse(i, "has a bad shape or quaternion" + type +
                  "correct it with the set command (set ... shape, set ... quat)");
}

std::array<double, PW85_SYM> Ellipsoids::form_with(int i, double const *quaternion) const
{
    std::array<double, PW85_SYM> form;
    pw85_ellipsoid_quaternion(&semi_axes_[PW85_DIM * static_cast<std::size_t>(i)], quaternion,
                              form.data());
    return form;
}

void Ellipsoids::turn(int i, double const *quaternion, std::array<double, PW85_SYM> const &form)
{
    std::copy_n(quaternion, 4, quaternions_->array_atom[i]);
    std::copy(form.begin(), form.end(), &forms_[PW85_SYM * static_cast<std::size_t>(i)]);
}

void Ellipsoids::write_quaternions()
{
    if (atom->nlocal > 0) set_quaternions(*atom, quaternions_->array_atom[0]);
}

int Ellipsoids::pack(int count, int const *atoms, double *buffer) const
{
    for (int k = 0; k < count; ++k) {
        auto const i = static_cast<std::size_t>(atoms[k]);
        buffer = std::copy_n(&forms_[PW85_SYM * i], PW85_SYM, buffer);
        *buffer++ = radii_[i];
    }
    return count * comm_size;
}

void Ellipsoids::unpack(int count, int first, double const *buffer)
{
    for (int k = 0; k < count; ++k, buffer += comm_size) {
        auto const i = static_cast<std::size_t>(first + k);
        std::copy_n(buffer, PW85_SYM, &forms_[PW85_SYM * i]);
        radii_[i] = buffer[PW85_SYM];
    }
}

void Ellipsoids::expect(int type, double radius, double curvature_radius)
{
    auto const raise = [&](std::vector<double> &radii, double value) {
        radii.resize(static_cast<std::size_t>(atom->ntypes) + 1);
        double &entry = radii[static_cast<std::size_t>(type)];
        entry = std::max(entry, value);
    };
    raise(expected_radii_, radius);
    raise(expected_curvature_radii_, curvature_radius);
}

/// Returns the largest bounding radius of each atom type on all processors; 0 for types without
/// ellipsoids.
std::vector<double> Ellipsoids::largest_radii() const
{
    std::vector<double> largest = expected_radii_;
    largest.resize(static_cast<std::size_t>(atom->ntypes) + 1);
    for (int i = 0; i < atom->nlocal; ++i) {
        double &entry = largest[static_cast<std::size_t>(atom->type[i])];
        double const radius = radii_[static_cast<std::size_t>(i)];
        if (radius > entry) entry = radius; // rarely true: the branch is predicted
    }
    MPI_Allreduce(MPI_IN_PLACE, largest.data(), static_cast<int>(largest.size()), MPI_DOUBLE,
                  MPI_MAX, world);
    return largest;
}

std::vector<double> Ellipsoids::largest_curvature_radii() const
{
    std::vector<double> largest = expected_curvature_radii_;
    largest.resize(static_cast<std::size_t>(atom->ntypes) + 1);
    for (int i = 0; i < atom->nlocal; ++i) {
        if (!selected(i)) continue;
        double &entry = largest[static_cast<std::size_t>(atom->type[i])];
        entry =
            std::max(entry, largest_semi_axis(i) * largest_semi_axis(i) / smallest_semi_axis(i));
    }
    MPI_Allreduce(MPI_IN_PLACE, largest.data(), static_cast<int>(largest.size()), MPI_DOUBLE,
                  MPI_MAX, world);
    return largest;
}

void Ellipsoids::for_each_reach(std::function<void(int, int, double)> const &use) const
{
    auto const largest = largest_radii();
    for (int t = 1; t <= atom->ntypes; ++t) {
        for (int u = t; u <= atom->ntypes; ++u) {
            double const a = largest[static_cast<std::size_t>(t)],
                         b = largest[static_cast<std::size_t>(u)];
            if (a > 0.0 && b > 0.0) use(t, u, a + b);
        }
    }
}

void Ellipsoids::require_cutoff(int t, int u, double cutoff, double distance) const
{
    if (cutoff * (1.0 + margin) < distance)
        stop_all(*error, style_ + ": the pair cutoff " + decimal(cutoff) + " of types " +
                             std::to_string(t) + " and " + std::to_string(u) +
                             " misses contacts: raise the cutoff in pair_style or pair_coeff to " +
                             decimal(distance) + " or more");
}

std::string Ellipsoids::name(int i) const { return "atom " + std::to_string(atom->tag[i]); }

void Ellipsoids::refuse(int i, std::string const &reason) const
{
    stop_one(*error, style_ + ": " + name(i) + " " + reason);
}

void Ellipsoids::refuse_pair(int i, int j) const
{
    pw85_error cause;
    pw85_last_error(&cause);
    refuse_pair(i, j, "have no contact function: " + words_of(cause, name(i), name(j)));
}

void Ellipsoids::refuse_pair(int i, int j, std::string const &reason) const
{
    refuse(i, "and " + name(j) + " " + reason);
}

double Ellipsoids::bytes() const
{
    return static_cast<double>((semi_axes_.capacity() + forms_.capacity() + radii_.capacity()) *
                               sizeof(double)) +
           shapes_->memory_usage() + quaternions_->memory_usage() +
           (exponents_ ? exponents_->memory_usage() : 0.0);
}

} // namespace pw85_lammps

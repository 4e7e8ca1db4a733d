// SPDX-License-Identifier: BSD-3-Clause
#include "reference_data.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include <hdf5.h>

namespace pw85_tests {

namespace {

[[noreturn]] void give_up(char const *what)
{
    std::fprintf(stderr, "cannot read %s of %s\n", what, reference_data_path());
    std::abort();
}

/// An open file and its datasets.
class File {
  public:
    File() : id_(H5Fopen(reference_data_path(), H5F_ACC_RDONLY, H5P_DEFAULT))
    {
        if (id_ < 0) give_up("anything");
    }
    File(File const &) = delete;
    File &operator=(File const &) = delete;
    ~File() { H5Fclose(id_); }

    /// All elements of a dataset of numbers, converted to Number.
    template <class Number> std::vector<Number> read(char const *name, hid_t type) const
    {
        hid_t const dataset = open(name);
        std::vector<Number> values(size(dataset));
        if (H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) give_up(name);
        H5Dclose(dataset);
        return values;
    }

    std::vector<double> read(char const *name) const
    {
        return read<double>(name, H5T_NATIVE_DOUBLE);
    }

    /// All elements of a dataset of fixed-length strings.
    std::vector<std::string> read_strings(char const *name) const
    {
        hid_t const dataset = open(name), type = H5Dget_type(dataset);
        std::size_t const length = H5Tget_size(type);
        std::vector<char> characters(size(dataset) * length);
        if (H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, characters.data()) < 0)
            give_up(name);
        H5Tclose(type);
        H5Dclose(dataset);
        std::vector<std::string> strings;
        for (std::size_t i = 0; i < characters.size(); i += length) {
            std::string padded(&characters[i], length);
            strings.push_back(padded.substr(0, padded.find('\0')));
        }
        return strings;
    }

  private:
    hid_t open(char const *name) const
    {
        hid_t const dataset = H5Dopen2(id_, name, H5P_DEFAULT);
        if (dataset < 0) give_up(name);
        return dataset;
    }

    static std::size_t size(hid_t dataset)
    {
        hid_t const space = H5Dget_space(dataset);
        hssize_t const points = H5Sget_simple_extent_npoints(space);
        H5Sclose(space);
        if (points <= 0) give_up("the size");
        return static_cast<std::size_t>(points);
    }

    hid_t id_;
};

Vector3 vector_at(std::vector<double> const &values, std::size_t row)
{
    return {values[3 * row], values[3 * row + 1], values[3 * row + 2]};
}

Form3 form_at(std::vector<double> const &values, std::size_t row)
{
    Form3 form{};
    for (int k = 0; k < form.size; ++k) form[k] = values[6 * row + static_cast<std::size_t>(k)];
    return form;
}

SpheroidGrid read_grid()
{
    File const file;
    SpheroidGrid grid{file.read("/radii"), file.read("/lambdas"), {}, {}, file.read("/F")};
    auto const directions = file.read("/directions"), spheroids = file.read("/spheroids");
    for (std::size_t i = 0; i < directions.size() / 3; ++i)
        grid.directions.push_back(vector_at(directions, i));
    for (std::size_t i = 0; i < spheroids.size() / 6; ++i)
        grid.spheroids.push_back(form_at(spheroids, i));
    return grid;
}

std::vector<ContactProblem> read_problems()
{
    File const file;
    static std::vector<std::string> const names = file.read_strings("/contact/category_names");
    auto const r12 = file.read("/contact/r12"), q1 = file.read("/contact/q1"),
               q2 = file.read("/contact/q2");
    auto const mu2 = file.read("/contact/mu2"), mu2_minus_1 = file.read("/contact/mu2_minus_1");
    auto const lambda = file.read("/contact/lambda"), cond = file.read("/contact/cond");
    auto const category = file.read<std::uint8_t>("/contact/category", H5T_NATIVE_UINT8);
    std::vector<ContactProblem> problems;
    for (std::size_t i = 0; i < mu2.size(); ++i)
        problems.push_back({{vector_at(r12, i), form_at(q1, i), form_at(q2, i)},
                            mu2[i],
                            mu2_minus_1[i],
                            lambda[i],
                            cond[i],
                            &names.at(category[i])});
    return problems;
}

} // namespace

char const *reference_data_path() { return PW85_REFERENCE_DATA; }

SpheroidGrid const &spheroid_grid()
{
    static SpheroidGrid const grid = read_grid();
    return grid;
}

std::vector<ContactProblem> const &contact_problems()
{
    static std::vector<ContactProblem> const problems = read_problems();
    return problems;
}

} // namespace pw85_tests

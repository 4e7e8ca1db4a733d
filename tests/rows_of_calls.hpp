// SPDX-License-Identifier: BSD-3-Clause
// The functions of one row behind those of many: a row of the one is what the other gives.
#ifndef PW85_TESTS_ROWS_OF_CALLS_HPP_INCLUDED
#define PW85_TESTS_ROWS_OF_CALLS_HPP_INCLUDED

#include <string>
#include <vector>

#include "calls.hpp"

namespace pw85_tests {

// These have lanes, whose last bits differ, codes or objects of their own, or arrays of other
// lengths: other programs test them.
inline std::vector<std::string> const with_lanes = {"pw85_contact_batch",
                                                    "pw85_overlap_batch",
                                                    "pw85_closest_approach_batch",
                                                    "pw85_contact_batch_2d",
                                                    "pw85_overlap_batch_2d",
                                                    "pw85_distance_batch",
                                                    "pw85_contains_batch",
                                                    "pw85_compare_batch",
                                                    "pw85_overlap_witness_batch",
                                                    "pw85_overlap_segment_batch",
                                                    "pw85_overlap_triangle_batch",
                                                    "pw85_overlap_box_batch",
                                                    "pw85_overlap_capsule_batch",
                                                    "pw85_overlap_segment_batch_2d",
                                                    "pw85_overlap_box_batch_2d",
                                                    "pw85_overlap_factored_batch",
                                                    "pw85_mesh_contact_batch",
                                                    "pw85_mesh_distance_batch",
                                                    "pw85_mesh_overlap_batch",
                                                    "pw85_contact_polytope_batch",
                                                    "pw85_overlap_polytope_batch",
                                                    "pw85_closest_passage_batch",
                                                    "pw85_contact_segment_batch",
                                                    "pw85_contact_triangle_batch",
                                                    "pw85_contact_box_batch",
                                                    "pw85_grain_contact_batch",
                                                    "pw85_signed_distance_batch",
                                                    "pw85_distance_geometry_batch",
                                                    "pw85_signed_distance_geometry_batch"};

/// The function of one row of a function of many, by its name; null if it has lanes or no such
/// relative.
inline Function const *of_one_row(Function const &many)
{
    std::string name = many.name;
    std::size_t const place = name.find("_batch");
    if (place == std::string::npos ||
        std::find(with_lanes.begin(), with_lanes.end(), name) != with_lanes.end())
        return nullptr;
    name.erase(place, std::string("_batch").size());
    for (Function const &one : declared_functions())
        if (one.name == name) return &one;
    return nullptr;
}

/// What a function of one row gives for a row of the arrays of a function of many.
struct OneRow {
    std::vector<double> out;
    int status;
};

inline OneRow call_one(Function const &one, Call &many, std::size_t row)
{
    std::vector<Argument> arguments(one.parameters.size());
    std::vector<std::vector<double>> outputs(one.parameters.size());
    for (std::size_t k = 0; k < one.parameters.size(); ++k) {
        Parameter const &p = one.parameters[k];
        if (p.output) {
            std::size_t size = 1;
            for (auto const &extent : p.shape) size *= extent.number;
            outputs[k].resize(size);
            arguments[k].pointer = outputs[k].data();
        } else if (!many.parameter(k + 1).pointer)
            arguments[k] = many[k + 1];
        else if (p.type == Type::motion)
            arguments[k].pointer = many.elements<pw85_motion>(k + 1) + row;
        else if (p.pointer)
            arguments[k].pointer = many.elements<double>(k + 1) + row * many.row_length(k + 1);
        else
            arguments[k].real = many.elements<double>(k + 1)[row];
    }
    OneRow result{{}, one.call(arguments.data()).status};
    for (auto const &numbers : outputs)
        result.out.insert(result.out.end(), numbers.begin(), numbers.end());
    return result;
}

/// The outputs of a row of a function of many, one after the other.
inline std::vector<double> outputs_of(Call &many, std::size_t row)
{
    std::vector<double> all;
    for (std::size_t k = 0; k < many.size(); ++k) {
        if (!many.parameter(k).output) continue;
        std::size_t const width = many.row_length(k);
        double const *const first = many.elements<double>(k) + row * width;
        all.insert(all.end(), first, first + width);
    }
    return all;
}

inline bool are_same(std::vector<double> const &x, std::vector<double> const &y)
{
    return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) == 0;
}

} // namespace pw85_tests

#endif

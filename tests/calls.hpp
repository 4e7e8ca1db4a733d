// SPDX-License-Identifier: BSD-3-Clause
// Calls every function of the C API with suitable arguments.
#ifndef PW85_TESTS_CALLS_HPP_INCLUDED
#define PW85_TESTS_CALLS_HPP_INCLUDED

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <pw85_batch.h>
#include <pw85_legacy.h>
#include <pw85_systems.h>
#include <pw85_zheng.h>

#include "functions.hpp"
#include "sample.hpp"

namespace pw85_tests {

inline std::size_t size_of(Type type)
{
    switch (type) {
    case Type::byte:
        return 1;
    case Type::integer:
        return sizeof(int);
    case Type::int32:
        return sizeof(std::int32_t);
    case Type::motion:
        return sizeof(pw85_motion);
    default:
        return 8;
    }
}

/// A function with valid arguments of its own. Arrays have a row for each of some pairs: `r12`,
/// `q1` and `q2` are those of the pair, particles 2i and 2i + 1 those of pair i.
class Call {
  public:
    Call(Function const &function, std::vector<Sample<double, 3>> const &pairs, double lambda = 0.5)
        : function_(&function), pairs_(&pairs), lambda_(lambda),
          arguments_(function.parameters.size()), memory_(function.parameters.size())
    {
        for (std::size_t k = 0; k < arguments_.size(); ++k)
            if (!parameter(k).pointer) arguments_[k] = number(parameter(k));
        for (std::size_t k = 0; k < arguments_.size(); ++k)
            if (parameter(k).pointer) arguments_[k].pointer = array(k);
    }
    ~Call()
    {
        for (void *object : objects_) destroy(object);
        destroy_made();
    }
    Call(Call const &) = delete;
    Call &operator=(Call const &) = delete;

    Answer operator()()
    {
        destroy_made();
        Answer const answer = function_->call(arguments_.data());
        if (std::string(function_->name).ends_with("_destroy")) {
            std::erase(objects_, arguments_[0].pointer);
            arguments_[0].pointer = nullptr;
        }
        return answer;
    }

    Function const &function() const { return *function_; }
    Parameter const &parameter(std::size_t k) const { return function_->parameters[k]; }
    std::size_t size() const { return arguments_.size(); }
    Argument &operator[](std::size_t k) { return arguments_[k]; }

    /// Whether the function takes rows. It finds what is wrong with all of them before it writes
    /// anything.
    bool is_of_rows() const
    {
        return parameter(0).type == Type::size ||
               (parameter(0).type == Type::handle && size() > 1 &&
                std::string(parameter(1).name) == "n");
    }

    /// How many elements an array has.
    std::size_t length(std::size_t k) const
    {
        std::size_t product = 1;
        for (auto const &extent : parameter(k).shape) product *= value(extent);
        return product;
    }

    /// How many elements the rows of an array have: all, if it has no rows.
    std::size_t row_length(std::size_t k) const
    {
        auto const &shape = parameter(k).shape;
        if (shape.empty() || shape[0].parameter < 0) return length(k);
        std::size_t product = 1;
        for (std::size_t i = 1; i < shape.size(); ++i) product *= value(shape[i]);
        return product;
    }

    /// The elements of an array, in the memory of the call.
    template <class T> T *elements(std::size_t k)
    {
        return reinterpret_cast<T *>(memory_[k].data() + margin);
    }

    /// Whether nothing was written beside an output.
    bool guards_intact(std::size_t k) const
    {
        auto const &bytes = memory_[k];
        std::size_t const end = margin + size_of(parameter(k).type) * length(k);
        auto const is_guard = [](unsigned char byte) { return byte == guard; };
        return std::all_of(bytes.begin(), bytes.begin() + margin, is_guard) &&
               std::all_of(bytes.begin() + static_cast<std::ptrdiff_t>(end), bytes.end(), is_guard);
    }

    /// Whether something was written to each element of an output.
    bool all_written(std::size_t k) const
    {
        std::size_t const size = size_of(parameter(k).type);
        std::vector<unsigned char> const untouched(size, guard);
        for (std::size_t i = 0; i < length(k); ++i)
            if (std::memcmp(memory_[k].data() + margin + i * size, untouched.data(), size) == 0)
                return false;
        return true;
    }

    /// The bytes of all outputs.
    std::vector<unsigned char> outputs() const
    {
        std::vector<unsigned char> all;
        for (std::size_t k = 0; k < size(); ++k)
            if (parameter(k).output && parameter(k).type != Type::handle)
                all.insert(all.end(), memory_[k].begin(), memory_[k].end());
        return all;
    }

    /// Name and arguments, in hexadecimal floating point.
    std::string text()
    {
        std::string all = function_->name;
        for (std::size_t k = 0; k < size(); ++k) {
            Parameter const &p = parameter(k);
            if (p.output || p.type == Type::handle) continue;
            all += std::string(", ") + p.name + " = ";
            if (!p.pointer)
                all += p.type == Type::real ? hex_text(&arguments_[k].real, 1)
                                            : std::to_string(arguments_[k].size);
            else if (arguments_[k].pointer == nullptr)
                all += "null";
            else if (p.type == Type::real)
                all += hex_text(elements<double>(k), static_cast<int>(length(k)));
            else
                all += "...";
        }
        return all;
    }

  private:
    static constexpr unsigned char guard = 0xa5;
    static constexpr std::ptrdiff_t margin = 64;
    using Numbers = std::vector<double>;

    std::size_t value(Extent const &extent) const
    {
        if (extent.parameter < 0) return extent.number;
        std::size_t const n = arguments_[static_cast<std::size_t>(extent.parameter)].size;
        return extent.number == packed ? n * (n + 1) / 2 : n;
    }

    bool takes(char const *name) const
    {
        auto const &all = function_->parameters;
        return std::any_of(all.begin(), all.end(),
                           [&](Parameter const &p) { return std::string(p.name) == name; });
    }

    Argument number(Parameter const &p) const
    {
        std::string const name = p.name;
        Argument x{};
        x.size = name == "num_particles"    ? 2 * pairs_->size()
                 : name == "m"              ? 4 * pairs_->size()
                 : name == "num_parameters" ? 2
                                            : pairs_->size();
        if (name == "n" && p.type == Type::integer) x.size = 3, x.integer = 3;
        if (name == "kind") x.integer = PW85_LAW_SOFT_REPULSION;
        x.real = name == "lambda"   ? lambda_
                 : name == "angle"  ? 0.3
                 : name == "radius" ? 4.0
                 : name == "skin"   ? 0.5 * unit()
                                    : 1.0;
        return x;
    }

    void *array(std::size_t k)
    {
        Parameter const &p = parameter(k);
        if (p.type == Type::handle && !p.output) return make_object();
        auto const bytes = size_of(p.type) * length(k);
        memory_[k].assign(bytes + 2 * margin, guard);
        if (p.output && p.type == Type::handle) {
            *elements<void *>(k) = nullptr;
            made_ = elements<void *>(k);
        }
        if (!p.output) fill(k);
        return elements<void>(k);
    }

    void fill(std::size_t k)
    {
        Parameter const &p = parameter(k);
        std::string const name = p.name;
        for (std::size_t i = 0; i < length(k); ++i) {
            if (p.type == Type::int32)
                elements<std::int32_t>(k)[i] =
                    static_cast<std::int32_t>(name == "images"      ? 0
                                              : name == "triangles" ? i % pairs_->size()
                                                                    : i);
            else if (p.type == Type::integer)
                elements<int>(k)[i] = 1;
            else if (p.type == Type::motion)
                elements<pw85_motion>(k)[i] =
                    motions[(i + (name == "motion2")) % std::size(motions)];
        }
        if (p.type != Type::real) return;
        std::size_t const columns = row_length(k);
        for (std::size_t i = 0; i < length(k) / columns; ++i) {
            Numbers const numbers = row(name, i, columns);
            std::copy(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(columns),
                      elements<double>(k) + i * columns);
        }
    }

    /// Row i of an array of that name: at least as many numbers as it has columns.
    Numbers row(std::string const &name, std::size_t i, std::size_t columns) const
    {
        bool const of_particles = takes("centers");
        bool const second = of_particles ? i % 2 == 1 : name == "q2" || name == "q4";
        auto const &pair = (*pairs_)[(of_particles ? i / 2 : i) % pairs_->size()];
        double const *r = pair.r12.coordinates, *q = second ? pair.q2.entries : pair.q1.entries;
        Numbers const separation(r, r + 3), nothing(3, 0.0);
        if (name == "centers") return second ? separation : nothing;
        if (name == "points") return corner(i);
        if (name == "cell") return cell();
        if (name == "lambda") return {lambda_};
        // of a soft repulsion
        if (name == "parameters") return {2.0 + static_cast<double>(i)};
        if (name == "s1" || name == "s2") return {1, 0.5, 0, 0, 2, 0.25, 0, 0, 3}; // factors
        if (name == "rotation") return {1, 0, 0, 0, 1, 0, 0, 0, 1};
        if (name == "semi_axes" || name == "axis" || name == "offsets" || name == "d_u")
            return {1, 2, 3};
        if (name == "curvatures") return {0.5, 2};
        if (name == "quaternion" || name == "quaternions") return {1, 2, 3, 4};
        if (name == "upper" || name == "lower") return box(r, name == "upper" ? 1.0 : -1.0);
        if (name == "end2" || name == "vertex2") return {r[1], r[2], r[0]};
        if (name == "vertex3") return {-r[2], r[0], r[1]};
        if (name == "params") {
            Numbers all = separation;
            all.insert(all.end(), pair.q1.entries, pair.q1.entries + 6);
            all.insert(all.end(), pair.q2.entries, pair.q2.entries + 6);
            return all;
        }
        bool const is_form = name[0] == 'q' || name == "forms" || name == "a" || name == "l" ||
                             name == "second_moments";
        if (is_form) return columns == 6 ? Numbers(q, q + 6) : Numbers(q + 3, q + 6);
        return separation;
    }

    /// One of four points around the second centre of a pair, not in a plane.
    Numbers corner(std::size_t i) const
    {
        auto const &pair = (*pairs_)[i / 4 % pairs_->size()];
        double const *r = pair.r12.coordinates;
        Numbers point(r, r + 3);
        if (i % 4 > 0) point[i % 4 - 1] += std::abs(r[0]) + std::sqrt(std::abs(pair.q1[0]));
        return point;
    }

    /// The largest length of the pairs.
    double unit() const
    {
        double largest = std::numeric_limits<double>::min();
        for (auto const &pair : *pairs_)
            for (auto const &q : {pair.q1, pair.q2})
                for (int i = 0; i < 3; ++i) {
                    largest = std::max(largest, pw85::detail::absolute(pair.r12[i]));
                    if (q(i, i) > 0) largest = std::max(largest, std::sqrt(q(i, i)));
                }
        return std::min(largest, 0x1p1000);
    }

    /// A cell in which the largest particle meets a few images.
    Numbers cell() const
    {
        Numbers vectors = {3, 1, 0, -1, 4, 1, 0.5, 1, 5};
        for (double &x : vectors) x *= unit();
        return vectors;
    }

    static Numbers box(double const *r, double sign)
    {
        return {sign * pw85::detail::absolute(r[0]), sign * pw85::detail::absolute(r[1]),
                sign * pw85::detail::absolute(r[2])};
    }

    /// Whether the objects of the call are meshes, not neighbour lists.
    bool has_meshes() const { return std::string(function_->name).starts_with("pw85_mesh"); }

    void destroy(void *object) const
    {
        if (has_meshes())
            pw85_mesh_destroy(static_cast<pw85_mesh *>(object));
        else
            pw85_neighbors_destroy(static_cast<pw85_neighbors *>(object));
    }

    /// A neighbour list of as many particles as the call has, or a mesh.
    void *make_object()
    {
        std::string const name = has_meshes() ? "pw85_mesh_create" : "pw85_neighbors_create";
        auto const &all = declared_functions();
        auto const create =
            std::find_if(all.begin(), all.end(), [&](Function const &f) { return f.name == name; });
        Call call(*create, *pairs_);
        call();
        objects_.push_back(*call.made_);
        *call.made_ = nullptr;
        return objects_.back();
    }

    void destroy_made()
    {
        if (made_ == nullptr) return;
        destroy(*made_);
        *made_ = nullptr;
    }

    static constexpr pw85_motion motions[3] = {{{-1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.1},
                                               {{0.0, -1.0, 0.0}, {1.0, 0.0, 0.0}, 0.0},
                                               {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.0}};

    Function const *function_;
    std::vector<Sample<double, 3>> const *pairs_;
    double lambda_;
    std::vector<Argument> arguments_;
    std::vector<std::vector<unsigned char>> memory_;
    std::vector<void *> objects_;
    void **made_ = nullptr;
};

} // namespace pw85_tests

#endif

// SPDX-License-Identifier: BSD-3-Clause
// Whether the reproducible mode gives the recorded bits on this machine. Each function of pw85.h
// that computes from numbers has a line of 64-bit checksums of its outputs and statuses in
// checksums.txt: over 512, 8,192, 131,072 and 1,007,616 pairs. Functions that compute depths of
// overlaps take a sixteenth of the pairs, and functions that have no rows take one in 128.
//
// Usage: checksums check TABLE PARTS    compares; PARTS, 1 to 4, is how many checksums of each line
//        checksums record [FUNCTION...] prints the table, or these lines of it
//        checksums rows FUNCTION        prints the outputs for the first pairs, to compare two
//                                       machines
#include <cinttypes>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "../marks.hpp"
#include "../rows_of_calls.hpp"
#include "exact_pairs.hpp"

using namespace pw85_tests;

namespace {

/// The number of pairs that are computed at once. It is more than a thread takes, so that all
/// functions use threads where they can.
constexpr std::size_t chunk = 8192;

/// The first part is over the first pairs alone. They tell apart the instruction sets.
constexpr std::size_t first_pairs = 512;

/// The number of chunks of each part; that of the first is not whole.
constexpr int parts = 4, chunks_of_part[parts] = {0, 1, 16, 123};

/// A checksum of numbers by their values, whatever the order of their bytes. All NaN count as one,
/// because their signs and payloads are not specified.
class Checksum {
  public:
    void add(std::uint64_t x)
    {
        state_ = (state_ ^ x) * 0x9e3779b97f4a7c15u;
        state_ ^= state_ >> 29;
    }
    void add(double x)
    {
        std::uint64_t bits;
        std::memcpy(&bits, &x, sizeof bits);
        add(x == x ? bits : ~std::uint64_t{0});
        if (prints) std::printf("%a\n", x);
    }
    void add(std::int64_t x)
    {
        add(static_cast<std::uint64_t>(x));
        if (prints) std::printf("%" PRId64 "\n", x);
    }
    std::uint64_t value() const { return state_; }

    static inline bool prints = false;

  private:
    std::uint64_t state_ = 0x243f6a8885a308d3u;
};

/// Checksums by functions.
using Checksums = std::map<std::string, Checksum>;

void add_element(Checksum &sum, Type type, void const *elements, std::size_t i)
{
    switch (type) {
    case Type::real:
        return sum.add(static_cast<double const *>(elements)[i]);
    case Type::integer:
        return sum.add(std::int64_t{static_cast<int const *>(elements)[i]});
    case Type::int32:
        return sum.add(std::int64_t{static_cast<std::int32_t const *>(elements)[i]});
    case Type::int64:
        return sum.add(static_cast<std::int64_t const *>(elements)[i]);
    default:
        return sum.add(std::int64_t{static_cast<unsigned char const *>(elements)[i]});
    }
}

/// Calls a function, and adds its status and outputs.
void add_call(Checksum &sum, Call &call)
{
    Answer const answer = call();
    sum.add(std::int64_t{answer.status});
    sum.add(answer.real);
    for (std::size_t k = 0; k < call.size(); ++k)
        for (std::size_t i = 0; call.parameter(k).output && i < call.length(k); ++i)
            add_element(sum, call.parameter(k).type, call.elements<void>(k), i);
}

/// The functions whose results are numbers for each pair or ellipsoid. Lists of neighbours are a
/// part of DenseSystem. Zheng's functions call the C library.
bool is_checked(Function const &function)
{
    std::string const name = function.name;
    bool const other = name.rfind("pw85_", 0) != 0 || name.rfind("pw85_zheng", 0) == 0 ||
                       name.rfind("pw85_legacy", 0) == 0 || name.rfind("pw85_neighbors", 0) == 0 ||
                       name.find("reproducible") != std::string::npos;
    return !other && function.result != Result::other &&
           std::none_of(function.parameters.begin(), function.parameters.end(),
                        [](Parameter const &p) { return p.type == Type::handle; }) &&
           std::any_of(function.parameters.begin(), function.parameters.end(),
                       [](Parameter const &p) { return !p.output; });
}

/// Points are no rows: one of them that is not finite spoils the result of all.
bool is_of_rows(Function const &function)
{
    return std::any_of(function.parameters.begin(), function.parameters.end(),
                       [](Parameter const &p) {
                           return p.type == Type::size && !p.pointer && !is_one_of(p.name, {"m"});
                       });
}

bool is_of_pair(std::string const &name)
{
    return is_one_of(name, {"r12", "q1", "q2", "q", "second_moments", "r", "direction",
                            "directions", "centers", "params", "cell"});
}

/// Contact functions and λ of pairs in three dimensions, and λ in two.
struct Known {
    std::vector<double> mu2, lambda, lambda_2d;
};

/// Changes the arguments of a call that are the same for all pairs, by some thousandths, and
/// motions by more. λ and μ² are those of the pairs.
void vary(Call &call, Integers integers, Known const &known)
{
    bool const flat = std::string(call.function().name).find("_2d") != std::string::npos;
    auto const factor = [&] { return 1.0 + integers.between(-4000, 4000) * 0x1p-12; };
    for (std::size_t k = 0; k < call.size(); ++k) {
        Parameter const &p = call.parameter(k);
        std::string const name = p.name;
        if (p.output || !p.pointer || is_of_pair(name)) continue;
        for (std::size_t i = 0; i < call.length(k); ++i)
            if (p.type == Type::motion) {
                auto &motion = call.elements<pw85_motion>(k)[i];
                double const speed = 500.0 * factor(), turn = factor();
                for (double &x : motion.velocity) x = x * speed;
                for (double &x : motion.angular_velocity) x = x * turn;
            } else if (name == "lambda" && p.type == Type::real) {
                call.elements<double>(k)[i] = (flat ? known.lambda_2d : known.lambda)[i];
            } else if (name == "mu2" && p.type == Type::real) {
                call.elements<double>(k)[i] = known.mu2[i];
            } else if (p.type == Type::real) {
                call.elements<double>(k)[i] *= factor();
            }
    }
}

/// The function of one row, for each row of a call.
void add_rows_one_by_one(Checksum &sum, Function const &one, Call &many, std::size_t rows)
{
    std::vector<Argument> arguments(one.parameters.size());
    for (std::size_t row = 0; row < rows; ++row) {
        double out[96] = {}; // room for all outputs
        for (std::size_t k = 0; k < one.parameters.size(); ++k) {
            std::size_t const width = many.row_length(k + 1);
            if (one.parameters[k].output)
                arguments[k].pointer = out + 8 * k;
            else if (one.parameters[k].pointer)
                arguments[k].pointer = many.elements<double>(k + 1) + row * width;
            else
                arguments[k].real = many.elements<double>(k + 1)[row];
        }
        sum.add(std::int64_t{one.call(arguments.data()).status});
        for (std::size_t k = 0; k < one.parameters.size(); ++k) {
            Parameter const &p = one.parameters[k];
            std::size_t const length = p.shape.empty() ? 1 : p.shape[0].number;
            for (std::size_t i = 0; p.output && i < length; ++i)
                add_element(sum, p.type, out + 8 * k, i);
        }
    }
}

Function const &find(std::string const &name)
{
    auto const &all = declared_functions();
    return *std::find_if(all.begin(), all.end(), [&](Function const &f) { return f.name == name; });
}

std::vector<double> output_of(char const *function, char const *output,
                              std::vector<ExactPair> const &pairs)
{
    Call call(find(function), pairs);
    call();
    for (std::size_t k = 0; k < call.size(); ++k)
        if (std::string(call.parameter(k).name) == output)
            return {call.elements<double>(k), call.elements<double>(k) + call.length(k)};
    return {};
}

/// Whether a function may take milliseconds for a pair: no other chunk than the first is computed.
bool is_very_slow(std::string const &name)
{
    return (name.starts_with("pw85_overlap_volume") &&
            !name.starts_with("pw85_overlap_volume_plane")) ||
           name.starts_with("pw85_overlap_area");
}

/// Whether a function takes so long that it computes few of the pairs of a chunk.
bool is_slow(std::string const &name)
{
    return is_one_of(
        name, {"pw85_penetration_batch", "pw85_signed_distance_batch", "pw85_penetration_batch_2d",
               "pw85_signed_distance_batch_2d", "pw85_overlap_volume_batch",
               "pw85_overlap_volume_gradient_batch", "pw85_overlap_volume_torque_batch",
               // some hundred microseconds
               "pw85_signed_distance_derivatives_batch",
               // twice the digits
               "pw85_surface_area_batch", "pw85_shell_moments_batch", "pw85_inertia_batch",
               "pw85_perimeter_batch_2d", "pw85_shell_moments_batch_2d",
               "pw85_distance_segment_batch", "pw85_distance_triangle_batch",
               "pw85_distance_solid_box_batch", "pw85_distance_capsule_batch"});
}

/// Names of functions; none stand for all.
using Names = std::vector<std::string>;

bool selects(Names const &only, std::string const &name)
{
    return only.empty() || std::find(only.begin(), only.end(), name) != only.end();
}

/// The functions that `only` selects, for a chunk of pairs.
void add_pairs(Checksums &sums, std::vector<ExactPair> const &pairs, Integers const &integers,
               Names const &only, bool is_first)
{
    constexpr std::size_t single_calls = 64;
    std::vector<ExactPair> const few(pairs.begin(),
                                     pairs.begin() + std::ptrdiff_t(pairs.size() / 16));
    Known const known{output_of("pw85_contact_batch", "mu2", pairs),
                      output_of("pw85_contact_batch", "lambda", pairs),
                      output_of("pw85_contact_batch_2d", "lambda", pairs)};
    for (Function const &function : declared_functions()) {
        std::string const name = function.name;
        if (!is_checked(function) || (!is_first && is_very_slow(name))) continue;
        if (!is_of_rows(function)) {
            for (std::size_t i = 0; i < single_calls && selects(only, name); ++i) {
                std::vector<ExactPair> const pair{pairs[i]};
                Call call(function, pair);
                vary(call, integers, {{known.mu2[i]}, {known.lambda[i]}, {known.lambda_2d[i]}});
                add_call(sums[name], call);
            }
            continue;
        }
        Call call(function, is_slow(name) ? few : pairs);
        vary(call, integers, known);
        if (selects(only, name)) add_call(sums[name], call);
        if (!is_one_of(name,
                       {"pw85_contact_batch", "pw85_overlap_batch", "pw85_closest_approach_batch",
                        "pw85_contact_batch_2d", "pw85_overlap_batch_2d", "pw85_distance_batch"}))
            continue;
        std::string one = name;
        one.erase(one.find("_batch"), 6);
        if (selects(only, one))
            add_rows_one_by_one(sums[one + ", each"], find(one), call, pairs.size());
    }
}

/// Particles on a lattice, with the list of their neighbours: each particle is in many pairs. The
/// box has so many particles along each side.
class DenseSystem {
  public:
    DenseSystem(Integers integers, std::size_t side) : size_(side * side * side)
    {
        for (int i = 0; i < 3; ++i) cell_[4 * i] = 1400.0 * static_cast<double>(side);
        for (std::size_t i = 0; i < size_; ++i) {
            int const place[3] = {static_cast<int>(i % side), static_cast<int>(i / side % side),
                                  static_cast<int>(i / side / side)};
            for (int const x : place) centers_.push_back(1400.0 * x + integers.between(-200, 200));
            auto const q = exact_form(integers, 1);
            q_.insert(q_.end(), q.entries, q.entries + 6);
        }
        system_ = {size_, centers_.data(), q_.data(), cell_, {1, 1, 1}};
        pw85_neighbors_create(&system_, 1.0, 100.0, &neighbors_);
        list_ = pw85_neighbors_list(neighbors_);
    }
    ~DenseSystem() { pw85_neighbors_destroy(neighbors_); }
    DenseSystem(DenseSystem const &) = delete;
    DenseSystem &operator=(DenseSystem const &) = delete;

    void add(Checksums &sums) const
    {
        std::size_t const n = list_.num_pairs;
        Checksum &pairs = sums["system, neighbours"];
        for (std::size_t k = 0; k < 2 * n; ++k) pairs.add(std::int64_t{list_.pairs[k]});
        std::vector<double> mu2(n), lambda(n), rows[5];
        for (auto &row : rows) row.resize(3 * n);
        pw85_contact_derivatives_pairs(&list_, &system_, mu2.data(), lambda.data(), rows[0].data(),
                                       rows[1].data(), rows[2].data(), rows[3].data(),
                                       rows[4].data());
        for (auto const &row : rows) add_numbers(sums["system, derivatives"], row);
        add_numbers(sums["system, derivatives"], mu2);
        std::vector<double> forces(3 * size_), torques(3 * size_), virial(9);
        pw85_contact_forces_pairs(&list_, &system_, mu2.data(), rows[2].data(), rows[3].data(),
                                  rows[4].data(), forces.data(), torques.data(), virial.data());
        for (auto const &numbers : {forces, torques, virial})
            add_numbers(sums["system, forces"], numbers);
        add_laws(sums["system, laws"]);
    }

  private:
    static void add_numbers(Checksum &sum, std::vector<double> const &numbers)
    {
        for (double const x : numbers) sum.add(x);
    }

    /// Exponents of both kinds: products, and powers.
    void add_laws(Checksum &sum) const
    {
        double const soft[][2] = {{3.0, 2.5}, {2.0, 2.25}},
                     powers[][5] = {{1, 12, 1, 6, 4}, {1.5, 9.3, 2, 5.1, 6.25}};
        double const table[] = {0.25, 2.25, 5, -3, 2, -1, 0, -0.25, 0.125, 0};
        for (auto const &law : soft) add_law(sum, {PW85_LAW_SOFT_REPULSION, 2, law});
        for (auto const &law : powers) add_law(sum, {PW85_LAW_INVERSE_POWERS, 5, law});
        add_law(sum, {PW85_LAW_TABLE, std::size(table), table});
    }

    void add_law(Checksum &sum, pw85_law const &law) const
    {
        double energy = 0;
        std::vector<double> forces(3 * size_), torques(3 * size_), virial(9);
        sum.add(std::int64_t{pw85_law_forces_pairs(&list_, &system_, &law, &energy, forces.data(),
                                                   torques.data(), virial.data())});
        sum.add(energy);
        for (auto const &numbers : {forces, torques, virial}) add_numbers(sum, numbers);
    }

    std::size_t const size_;
    double cell_[9] = {0, 0, 0, 300, 0, 0, 0, -200, 0};
    std::vector<double> centers_, q_;
    pw85_system system_{};
    pw85_neighbors *neighbors_ = nullptr;
    pw85_pair_list list_{};
};

std::vector<ExactPair> next_pairs(Integers &integers, std::size_t count)
{
    std::vector<ExactPair> pairs(count);
    for (ExactPair &pair : pairs) pair = exact_pair(integers);
    return pairs;
}

/// The checksums of the first part.
Checksums first_part(Names const &only)
{
    Checksums sums;
    Integers integers(85);
    add_pairs(sums, next_pairs(integers, first_pairs), integers, only, true);
    if (only.empty()) DenseSystem(integers, 6).add(sums);
    return sums;
}

/// Calls `visit(part, checksums)` after each part, up to so many.
template <class Visit> void compute(int last_part, Names const &only, Visit const &visit)
{
    visit(0, first_part(only));
    Checksums sums;
    Integers integers(85);
    int chunks = 0;
    for (int part = 1; part < last_part; ++part) {
        for (; chunks < chunks_of_part[part]; ++chunks) {
            auto const pairs = next_pairs(integers, chunk);
            add_pairs(sums, pairs, integers, only, chunks == 0);
            if (only.empty() && chunks < 2) DenseSystem(integers, 14).add(sums);
        }
        visit(part, sums);
    }
}

using Table = std::map<std::string, std::vector<std::uint64_t>>;

Table computed(int last_part, Names const &only)
{
    Table table;
    compute(last_part, only, [&](int, Checksums const &sums) {
        for (auto const &[name, sum] : sums) table[name].push_back(sum.value());
    });
    return table;
}

int record(Names const &only)
{
    for (auto const &[name, sums] : computed(parts, only)) {
        for (std::uint64_t const sum : sums) std::printf("%016" PRIx64 " ", sum);
        std::printf("%s\n", name.c_str());
    }
    return 0;
}

Table read(char const *path)
{
    Table table;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::vector<std::uint64_t> sums(parts);
        for (std::uint64_t &sum : sums) words >> std::hex >> sum;
        std::string name;
        std::getline(words >> std::ws, name);
        table[name] = sums;
    }
    return table;
}

int check(char const *path, int last_part)
{
    Table expected = read(path);
    bool right = true;
    for (auto const &[name, sums] : computed(last_part, {})) {
        auto const &known = expected[name];
        bool const same =
            known.size() == parts && std::equal(sums.begin(), sums.end(), known.begin());
        right = right && same;
        if (!same)
            std::printf("%s: %s\n", name.c_str(),
                        known.empty() ? "not in the table" : "other bits than recorded");
        expected.erase(name);
    }
    for (auto const &[name, sums] : expected) std::printf("%s: no such function\n", name.c_str());
    return right && expected.empty() ? 0 : 1;
}

int print_rows(char const *function)
{
    Checksum::prints = true;
    compute(1, {function}, [](int, Checksums const &) {});
    Checksum::prints = false;
    return 0;
}

/// Numbers that differ between the instruction sets.
std::vector<double> contacts_of_first_pairs()
{
    Integers integers(85);
    return output_of("pw85_contact_batch", "mu2", next_pairs(integers, first_pairs));
}

bool switch_to(int on)
{
    int now = -1;
    return pw85_set_reproducible(on) == PW85_SUCCESS &&
           pw85_is_reproducible(&now) == PW85_SUCCESS && now == on;
}

} // namespace

int main(int argc, char **argv)
{
    std::string const task = argc > 1 ? argv[1] : "";
    std::vector<double> const usual = contacts_of_first_pairs();
    bool switched = switch_to(1);
    int result = 2;
    if (task == "record") result = record(Names(argv + 2, argv + argc));
    if (task == "check" && argc == 4) result = check(argv[2], std::atoi(argv[3]));
    if (task == "rows" && argc == 3) result = print_rows(argv[2]);
    switched = switch_to(0) && switched && are_same(contacts_of_first_pairs(), usual);
    if (!switched) std::printf("the mode does not switch\n");
    return switched ? result : 2;
}

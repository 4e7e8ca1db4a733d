// SPDX-License-Identifier: BSD-3-Clause
// The format of saved simulations: what the manual says of it, and bytes that were changed.
#include <algorithm>
#include <cmath>
#include <cstring>

#include <glib.h>

#include "cases.hpp"
#include "failures.hpp"
#include "saved_sections.hpp"
#include "saved_simulations.hpp"

using namespace pw85_tests;

namespace {

/// Why bytes are refused; empty if they are not refused as invalid bytes.
std::string cause_of(std::span<unsigned char const> bytes)
{
    pw85_hard_ellipsoids *made = nullptr;
    int const status = pw85_hard_ellipsoids_restore(bytes.size(), bytes.data(), &made);
    SimulationPointer const owner(made);
    pw85_error error;
    if (status != PW85_EINVAL || made != nullptr || pw85_last_error(&error) != PW85_SUCCESS ||
        std::strcmp(error.argument, "bytes") != 0)
        return {};
    return error.requirement;
}

// The requirements that bytes do not meet.
constexpr char const *not_a_state = "must be a state that pw85_hard_ellipsoids_save() wrote",
                     *incomplete =
                         "must be complete: num_bytes differs from the number in the state",
                     *changed_bytes = "must be as they were saved: their checksum differs",
                     *later_format =
                         "must have a format that this version knows: restore them with a later "
                         "version",
                     *later_section =
                         "must have no section that this version does not know: restore them with "
                         "a later version",
                     *memory_image =
                         "must not be of a version that saved memory: continue the simulation with "
                         "that version, or create it again from its particles";

void expect_cause(Bytes const &bytes, char const *wanted)
{
    std::string const cause = cause_of(bytes);
    if (cause != wanted) g_test_fail_printf("\"%s\" instead of \"%s\"", cause.c_str(), wanted);
}

/// States of a simulation with all sections, and of one with the fewest.
std::vector<Bytes> states()
{
    return {state_of(simulation_in_space()), state_of(simulation_in_plane())};
}

PW85_TEST("/saved_states/numbers")
{
    SimulationPointer const simulation = simulation_in_space();
    SavedSections state(state_of(simulation));
    g_assert_true(state.bytes() == state_of(simulation));
    std::string names;
    for (auto const &[name, words] : state.sections) names += name;
    g_assert_cmpstr(names.c_str(), ==,
                    "SETTINGSCELL    PARTICLELAW     MESH    SPECIES WALLS   FIELDS  POTENTIA");
    Words const &settings = state["SETTINGS"];
    g_assert_true(settings.size() == 20 && settings[0] == 3 && settings[1] == 77 &&
                  settings[2] == 3 && settings[6] == word_of(0.5));
    std::uint64_t trials = 0;
    for (std::size_t k = 10; k < 15; ++k) trials += settings[k];
    g_assert_true(trials == 3 * 18);
    Words const &particles = state["PARTICLE"];
    pw85_system const system = pw85_hard_ellipsoids_system(simulation.get());
    g_assert_true(particles.size() == 180);
    for (std::size_t i = 0; i < 18; ++i)
        for (std::size_t k = 0; k < 10; ++k) {
            double const number =
                k < 3   ? system.centers[3 * i + k]
                : k < 7 ? pw85_hard_ellipsoids_quaternions(simulation.get())[4 * i + k - 3]
                        : pw85_hard_ellipsoids_semi_axes(simulation.get())[3 * i + k - 7];
            g_assert_true(particles[10 * i + k] == word_of(number));
        }
    Words const &cell = state["CELL"];
    g_assert_true(cell.size() == 12 && cell[4] == word_of(9.25) && cell[10] == 1 && cell[11] == 0);
    g_assert_true(state["LAW"] == Words({2, word_of(0.25), word_of(12.0), word_of(1.0),
                                         word_of(6.0), word_of(1.5)}));
    Words const &mesh = state["MESH"];
    g_assert_true(mesh.size() == 1 + 12 + 6 && mesh[0] == 4 && mesh[3] == word_of(5.5) &&
                  std::equal(mesh.begin() + 13, mesh.end(), Words({0, 1, 2, 1, 2, 3}).begin()));
    g_assert_true(state["SPECIES"] ==
                  Words({word_of(0.5), word_of(0.75), word_of(1.25), word_of(0.2), word_of(0.1)}));
    Words const &walls = state["WALLS"], &fields = state["FIELDS"];
    g_assert_true(walls.size() == 16 && walls[14] == word_of(-1.0) && walls[15] == word_of(4.0));
    g_assert_true(fields.size() == 18 && fields[9] == 3 && fields[10] == 2 &&
                  fields[17] == word_of(-0.4));
    double energy = 0.0;
    for (int i = 0; i < 18; ++i)
        energy += quadratic_potential(nullptr, i, system.centers + 3 * i, nullptr, nullptr);
    g_assert_true(state["POTENTIA"] == Words({word_of(energy)}));
}

// The first numbers of a state are the bytes that the manual names.
PW85_TEST("/saved_states/head")
{
    unsigned char const head[] = {0x89, 'P', 'W', '8', '5', '\r', '\n', 0x1a,
                                  1,    0,   0,   0,   0,   0,    0,    0};
    for (Bytes const &state : states()) {
        g_assert_true(std::equal(std::begin(head), std::end(head), state.begin()));
        g_assert_true(word_at(state, 16) == state.size());
        g_assert_true(word_at(state, state.size() - 8) ==
                      crc32(std::span(state).first(state.size() - 8)));
    }
    g_assert_cmpuint(crc32(std::vector<unsigned char>{'1', '2', '3', '4', '5', '6', '7', '8', '9'}),
                     ==,
                     0xcbf43926); // the check value of this CRC in the catalogue of Cook
}

PW85_TEST("/saved_states/each_byte")
{
    for (Bytes const &state : states())
        for (std::size_t k = 0; k < state.size(); ++k)
            for (int const bit : {1, 2, 4, 8, 16, 32, 64, 128, 255}) {
                Bytes changed = state;
                changed[k] ^= static_cast<unsigned char>(bit);
                // The signature, the format and the length come before what only the checksum sees.
                if (k >= 24)
                    expect_cause(changed, changed_bytes);
                else if (cause_of(changed).empty())
                    g_test_fail_printf("byte %zu, bits %d", k, bit);
            }
}

PW85_TEST("/saved_states/lengths")
{
    for (Bytes const &state : states()) {
        for (std::size_t size = 0; size < state.size(); ++size)
            if (cause_of(std::span(state).first(size)).empty())
                g_test_fail_printf("%zu bytes", size);
        expect_cause(Bytes(state.begin(), state.end() - 1), incomplete);
        for (std::size_t more = 1; more < 20; ++more) {
            Bytes longer = state;
            longer.resize(state.size() + more);
            expect_cause(longer, incomplete);
            if (more % 8 == 0 && cause_of(sealed(longer)).empty())
                g_test_fail_printf("%zu zero bytes more", more);
        }
    }
}

// With the right checksum, and other lengths of sections and counts of vertices.
PW85_TEST("/saved_states/huge_lengths")
{
    for (Bytes const &state : states())
        for (std::size_t at = 24; at < state.size() - 8;
             at += 16 + static_cast<std::size_t>(word_at(state, at + 8))) {
            bool const is_mesh = std::memcmp(&state[at], "MESH", 4) == 0;
            for (std::size_t const place : {at + 8, at + 16})
                for (std::uint64_t const length :
                     {std::uint64_t{0}, word_at(state, place) + 8, word_at(state, place) - 8,
                      word_at(state, place) + 4, std::uint64_t{1} << 31, std::uint64_t{1} << 32,
                      std::uint64_t{1} << 60, std::uint64_t{1} << 61, std::uint64_t{1} << 63,
                      0 - std::uint64_t{8}, ~std::uint64_t{0}}) {
                    if (place == at + 16 && !is_mesh) continue; // no length
                    Bytes word, changed = state;
                    append_word(word, length);
                    std::copy(word.begin(), word.end(), &changed[place]);
                    if (cause_of(sealed(changed)).empty())
                        g_test_fail_printf("%.8s: %llx", reinterpret_cast<char const *>(&state[at]),
                                           static_cast<unsigned long long>(length));
                }
        }
}

PW85_TEST("/saved_states/order")
{
    for (Bytes const &state : states()) {
        SavedSections reversed(state);
        std::reverse(reversed.sections.begin(), reversed.sections.end());
        g_assert_true(reversed.bytes() != state && state_of(restored(reversed.bytes())) == state);
        SavedSections const sections(state);
        for (auto const &section : sections.sections) {
            SavedSections repeated = sections;
            repeated.sections.push_back(section);
            expect_cause(repeated.bytes(), not_a_state);
        }
        for (std::size_t i = 0; i < sections.sections.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                SavedSections swapped = sections;
                std::swap(swapped.sections[i].first, swapped.sections[j].first);
                if (cause_of(swapped.bytes()).empty())
                    g_test_fail_printf("%s as %s", sections.sections[i].first.c_str(),
                                       sections.sections[j].first.c_str());
                swapped = sections;
                swapped.sections[i].first = sections.sections[j].first;
                if (cause_of(swapped.bytes()).empty())
                    g_test_fail_printf("two of %s", sections.sections[j].first.c_str());
            }
    }
}

PW85_TEST("/saved_states/unknown_sections")
{
    for (Bytes const &state : states())
        for (std::size_t place = 0; place <= SavedSections(state).sections.size(); ++place)
            for (Words const &words : {Words{}, Words{1, 2, 3}}) {
                SavedSections more(state);
                auto const at = more.sections.begin() + static_cast<std::ptrdiff_t>(place);
                auto const added = more.sections.insert(at, {"comments", words});
                g_assert_true(state_of(restored(more.bytes())) == state);
                for (char const *const name :
                     {"Comments", "COMMENTS", "1omments", "{omments", "`omments"}) {
                    added->first = name;
                    expect_cause(more.bytes(), later_section);
                }
            }
}

PW85_TEST("/saved_states/missing_sections")
{
    Bytes const state = state_of(simulation_in_space());
    for (std::size_t k = 0; k < SavedSections(state).sections.size(); ++k) {
        SavedSections fewer(state);
        std::string const name = fewer.sections[k].first;
        fewer.sections.erase(fewer.sections.begin() + static_cast<std::ptrdiff_t>(k));
        Bytes const bytes = fewer.bytes();
        if (name == "SETTINGS" || name == "PARTICLE")
            expect_cause(bytes, not_a_state);
        else
            g_assert_true(state_of(restored(bytes)) == bytes);
    }
}

// Bytes of other versions.
PW85_TEST("/saved_states/formats")
{
    for (Bytes const &state : states())
        for (std::uint64_t const format : {std::uint64_t{0}, std::uint64_t{2}, ~std::uint64_t{0}}) {
            SavedSections other(state);
            other.format = format;
            expect_cause(other.bytes(), later_format);
        }
    for (std::uint64_t const mark : {1U, 2U, 5U, 16U}) {
        Bytes image;
        append_word(image, 0x70773835'6d630000 + mark);
        for (int k = 0; k < 60; ++k) append_word(image, 0);
        expect_cause(image, memory_image);
        std::reverse(image.begin(),
                     image.begin() + 8); // of a machine with the other order of bytes
        expect_cause(image, memory_image);
    }
    expect_cause({}, not_a_state);
    expect_cause(Bytes(500), not_a_state);
}

// Numbers that no simulation has, with the right checksum.
PW85_TEST("/saved_states/impossible_numbers")
{
    Bytes const state = state_of(simulation_in_space());
    std::uint64_t const nan = word_of(double{NAN}), minus_one = ~std::uint64_t{0},
                        beyond = std::uint64_t{1} << 32; // 0 in 32 bits
    struct {
        char const *section;
        std::size_t word;
        std::uint64_t value;
    } const changes[] = {
        {"SETTINGS", 0, 4},
        {"SETTINGS", 0, beyond + 3},
        {"SETTINGS", 3, nan},
        {"SETTINGS", 6, nan},
        {"SETTINGS", 6, word_of(0.25)},
        {"SETTINGS", 10, minus_one},
        {"CELL", 0, nan},
        {"CELL", 9, 2},
        {"CELL", 11, minus_one},
        {"PARTICLE", 0, nan},
        {"PARTICLE", 3, word_of(2.0)},
        {"PARTICLE", 7, word_of(-1.0)},
        {"LAW", 0, 0},
        {"LAW", 0, 7},
        {"LAW", 0, beyond + 2},
        {"LAW", 1, nan},
        {"MESH", 0, 3},
        {"MESH", 1, nan},
        {"MESH", 13, 4},
        {"MESH", 13, minus_one},
        {"SPECIES", 3, nan},
        {"SPECIES", 4, word_of(2.0)},
        {"WALLS", 0, 9},
        {"WALLS", 0, beyond},
        {"FIELDS", 1, beyond},
        {"MESH", 13, beyond},
        {"WALLS", 7, nan},
        {"FIELDS", 0, 9},
        {"FIELDS", 1, 3},
        {"FIELDS", 8, nan},
        {"POTENTIA", 0, nan},
    };
    for (auto const &[section, word, value] : changes)
        if (cause_of(with_word(state, section, word, value)).empty())
            g_test_fail_printf("%s, word %zu: %llx", section, word,
                               static_cast<unsigned long long>(value));
    for (auto const &[name, words] : SavedSections(state).sections) {
        SavedSections longer(state), shorter(state);
        longer[name].push_back(0);
        shorter[name].pop_back();
        if (cause_of(longer.bytes()).empty() || cause_of(shorter.bytes()).empty())
            g_test_fail_printf("%s: a number more or less", name.c_str());
    }
}

/// A state with the settings, particles, a cell and more sections.
Bytes changed_state(std::vector<std::pair<std::string, Words>> const &changes)
{
    SavedSections state(state_of(simulation_in_space()));
    std::erase_if(state.sections, [](auto const &one) {
        return one.first != "SETTINGS" && one.first != "PARTICLE" && one.first != "CELL    ";
    });
    for (auto const &[name, words] : changes) {
        std::erase_if(state.sections,
                      [&name = name](auto const &one) { return one.first == name; });
        state.sections.emplace_back(name, words);
    }
    return state.bytes();
}

Words words_of(std::initializer_list<double> numbers)
{
    Words words;
    for (double const x : numbers) words.push_back(word_of(x));
    return words;
}

// A triangle in the unit cube.
Words triangle()
{
    Words mesh = {3};
    for (double const x : {0.1, 0.1, 0.1, 0.2, 0.1, 0.1, 0.1, 0.2, 0.1}) mesh.push_back(word_of(x));
    mesh.insert(mesh.end(), {0, 1, 2});
    return mesh;
}

// pw85_hard_ellipsoids_create() refuses such cells, too. Without walls nothing reads the vector.
PW85_TEST("/saved_states/infinite_vector")
{
    Bytes const state = changed_state({});
    for (double const bad : {double{NAN}, HUGE_VAL})
        for (std::size_t const word : {std::size_t{6}, std::size_t{8}})
            if (cause_of(with_word(state, "CELL", word, word_of(bad))).empty())
                g_test_fail_printf("%g in word %zu", bad, word);
}

// The box of the ball has some 10¹⁶ images of the mesh. They need not be tested: it overlaps its
// own images.
PW85_TEST("/saved_states/large_particle_and_mesh")
{
    double const a = 0x1p20;
    Bytes bytes =
        changed_state({{"MESH    ", triangle()},
                       {"PARTICLE", words_of({3.0, 3.0, 3.0, 1.0, 0.0, 0.0, 0.0, a, a, a})}});
    bytes = with_word(bytes, "CELL", 11, 1); // periodic along all vectors
    pw85_hard_ellipsoids *made = nullptr;
    int const status = pw85_hard_ellipsoids_restore(bytes.size(), bytes.data(), &made);
    SimulationPointer const owner(made);
    g_assert_true(status == PW85_EOVERLAP || status == PW85_ENOMEM);
}

// After a sweep without memory for its rows there are none, which trials of the volume need.
PW85_TEST("/saved_states/rows_without_memory")
{
    Bytes bytes = changed_state(
        {{"LAW     ",
          {2, word_of(0.25), word_of(12.0), word_of(1.0), word_of(6.0), word_of(1e5)}}});
    bytes = with_word(bytes, "CELL", 11, 1); // periodic along all vectors
    SimulationPointer const simulation = restored(bytes);
    g_assert_nonnull(simulation.get());
    for (int k = 0; k < 2; ++k) {
        g_assert_cmpint(pw85_hard_ellipsoids_sweep(simulation.get(), 1), ==, PW85_ENOMEM);
        g_assert_cmpint(
            pw85_hard_ellipsoids_volume_moves(simulation.get(), 1, 0.001, PW85_CHANGE_ISOTROPIC),
            ==, PW85_ENOMEM);
    }
}

// The disc is so thin that no translation is free of the mesh. Its step stays > 0.
PW85_TEST("/saved_states/tuned_thin_disc")
{
    SimulationPointer const simulation = restored(changed_state(
        {{"MESH    ", triangle()},
         {"PARTICLE", words_of({3.0, 3.0, 3.0, 1.0, 0.0, 0.0, 0.0, 0.5, 0.5, 0x1p-27})}}));
    g_assert_nonnull(simulation.get());
    g_assert_cmpint(pw85_hard_ellipsoids_tune(simulation.get(), 20, 0.4, 0.0, 0), ==, PW85_SUCCESS);
    Bytes const state = state_of(simulation);
    g_assert_true(state_of(restored(state)) == state);
}

/// Numbers in the place of another one: special ones, and some near it.
std::vector<std::uint64_t> replacements_of(std::uint64_t word)
{
    std::vector<std::uint64_t> words = {1,
                                        2,
                                        7,
                                        std::uint64_t{1} << 31,
                                        std::uint64_t{1} << 53,
                                        std::uint64_t{1} << 63,
                                        ~std::uint64_t{0}};
    for (double const x :
         {0.0, 1.0,  -1.0, 1e-100, 0x1p-1074, 1e2,   1e3,   1e4,    1e5,      1e7,
          1e9, 1e12, 1e16, -1e16,  1e20,      1e100, 1e300, -1e300, HUGE_VAL, double{NAN}})
        words.push_back(word_of(x));
    for (double const factor : {-1.0, 0.5, 1.0 + 0x1p-50, 2.0, 0x1p10})
        words.push_back(word_of(factor * std::bit_cast<double>(word)));
    return words;
}

// What is done with a simulation ends, whatever its state was, and leaves one that can be saved and
// restored. Nothing measures time: a test of minutes fails.
void expect_bounded_work(pw85_hard_ellipsoids *made)
{
    SimulationPointer const simulation(made);
    std::size_t count;
    double number;
    pw85_hard_ellipsoids_check(made, nullptr);
    pw85_hard_ellipsoids_energy(made, &number);
    pw85_hard_ellipsoids_neighbors(made, 0, 0, &count, nullptr, nullptr, nullptr);
    pw85_hard_ellipsoids_sweep(made, 1);
    pw85_hard_ellipsoids_volume_moves(made, 1, 1.0, PW85_CHANGE_ISOTROPIC);
    double const length = pw85_hard_ellipsoids_semi_axes(made)[0];
    pw85_hard_ellipsoids_chain(made, 1, length, nullptr, &number);
    pw85_hard_ellipsoids_compress(made, 1, &number);
    Bytes const state = state_of(simulation);
    g_assert_true(!state.empty() && state_of(restored(state)) == state);
}

// Each number of the settings, the cell, a particle and the rest, with the right checksum.
void test_each_number(Bytes const &state)
{
    for (auto const &[name, words] : SavedSections(state).sections)
        for (std::size_t k = 0; k < words.size() && (name != "PARTICLE" || k < 10); ++k)
            for (std::uint64_t const word : replacements_of(words[k])) {
                Bytes const changed = with_word(state, name, k, word);
                pw85_hard_ellipsoids *made = nullptr;
                if (pw85_hard_ellipsoids_restore(changed.size(), changed.data(), &made) !=
                    PW85_SUCCESS)
                    continue;
                std::vector<unsigned char> saved(pw85_hard_ellipsoids_num_bytes(made));
                pw85_hard_ellipsoids_save(made, saved.size(), saved.data());
                if (saved != changed)
                    g_test_fail_printf("%s, word %zu: %llx is saved as another number",
                                       name.c_str(), k, static_cast<unsigned long long>(word));
                expect_bounded_work(made);
            }
}

PW85_TEST("/saved_states/each_number_of_all_sections")
{
    SavedSections state(state_of(simulation_in_space()));
    std::erase_if(state.sections, [](auto const &one) { return one.first == "POTENTIA"; });
    test_each_number(state.bytes()); // trials wait for no potential
    test_each_number(state_of(simulation_in_plane()));
}

// Of hard particles in a cell that is periodic along all vectors, and of those with a law.
PW85_TEST("/saved_states/each_number_of_closed_cells")
{
    for (auto const &changes :
         {std::vector<std::pair<std::string, Words>>{},
          {{"LAW     ",
            {2, word_of(0.25), word_of(12.0), word_of(1.0), word_of(6.0), word_of(1.5)}}}})
        test_each_number(
            with_word(with_word(changed_state(changes), "CELL", 11, 1), "CELL", 8, word_of(9.5)));
}

/// Expects that a call was refused with a status, and why.
void expect_refusal(int status, int wanted, char const *requirement)
{
    pw85_error error;
    g_assert_cmpint(status, ==, wanted);
    g_assert_cmpint(pw85_last_error(&error), ==, PW85_SUCCESS);
    g_assert_cmpstr(error.requirement, ==, requirement);
}

/// A state in a cell that is periodic along all vectors.
Bytes closed_state() { return with_word(changed_state({}), "CELL", 11, 1); }

// Lists of neighbours of such lengths would take hours and all memory.
PW85_TEST("/saved_states/long_lists")
{
    char const *const too_long =
        "particles, steps and the cutoff must not be so long that lists of neighbours exceed the "
        "memory or have more than 2¹⁵ images of the cell";
    pw85_hard_ellipsoids *made = nullptr;
    Bytes const long_particle = with_word(closed_state(), "PARTICLE", 9, word_of(1e4));
    expect_refusal(pw85_hard_ellipsoids_restore(long_particle.size(), long_particle.data(), &made),
                   PW85_ENOMEM, too_long);
    SimulationPointer const simulation = restored(changed_state({}));
    double const steps[] = {1e3, 0.1, 0.1}; // in a cell that is open along a vector
    g_assert_cmpint(pw85_hard_ellipsoids_set_steps(simulation.get(), steps), ==, PW85_SUCCESS);
    expect_refusal(pw85_hard_ellipsoids_sweep(simulation.get(), 1), PW85_ENOMEM, too_long);
}

// Steps that pw85_hard_ellipsoids_set_steps() refuses are no state.
PW85_TEST("/saved_states/long_steps")
{
    Bytes const state = closed_state();
    char const *const too_long = "must be at most the longest vector of the cell";
    double const longest = 9.25;
    for (double const step : {longest, longest * (1.0 + 0x1p-52)}) {
        SimulationPointer const simulation = restored(state);
        double const steps[] = {step, 0.1, 0.1}, of_kind[] = {step, 0.1},
                     kind[] = {0.5, 0.75, 1.25};
        Bytes const with_step = with_word(state, "SETTINGS", 3, word_of(step));
        SavedSections species(state);
        species.sections.emplace_back("SPECIES ", words_of({0.5, 0.75, 1.25, step, 0.1}));
        int const status = pw85_hard_ellipsoids_set_steps(simulation.get(), steps),
                  status_of_kind =
                      pw85_hard_ellipsoids_set_kind_steps(simulation.get(), 1, kind, of_kind);
        if (step == longest) {
            g_assert_true(status == PW85_SUCCESS && status_of_kind == PW85_SUCCESS);
            g_assert_nonnull(restored(with_step).get());
            g_assert_nonnull(restored(species.bytes()).get());
        } else {
            expect_refusal(status_of_kind, PW85_EINVAL, too_long);
            expect_cause(with_step, not_a_state);
            expect_cause(species.bytes(), not_a_state);
        }
    }
}

// A step as long as the cell becomes shorter with it, so that the state can be restored.
PW85_TEST("/saved_states/steps_of_smaller_cells")
{
    double const steps[] = {9.25, 0.1, 0.1}, kind[] = {0.5, 0.75, 1.25}, of_kind[] = {9.25, 0.1};
    SimulationPointer const simulation = restored(closed_state());
    g_assert_true(pw85_hard_ellipsoids_set_steps(simulation.get(), steps) == PW85_SUCCESS &&
                  pw85_hard_ellipsoids_set_kind_steps(simulation.get(), 1, kind, of_kind) ==
                      PW85_SUCCESS);
    double factor, now[3], of_kind_now[2];
    g_assert_cmpint(pw85_hard_ellipsoids_compress(simulation.get(), 0, &factor), ==, PW85_SUCCESS);
    g_assert_true(pw85_hard_ellipsoids_steps(simulation.get(), now) == PW85_SUCCESS &&
                  now[0] == 9.25);
    g_assert_cmpint(pw85_hard_ellipsoids_compress(simulation.get(), 1, &factor), ==, PW85_SUCCESS);
    g_assert_true(factor < 1.0);
    double const longest = pw85_hard_ellipsoids_system(simulation.get()).cell[4];
    g_assert_true(pw85_hard_ellipsoids_steps(simulation.get(), now) == PW85_SUCCESS &&
                  now[0] == longest);
    g_assert_true(pw85_hard_ellipsoids_kind_steps(simulation.get(), 1, kind, of_kind_now) ==
                      PW85_SUCCESS &&
                  of_kind_now[0] == longest);
    Bytes const state = state_of(simulation);
    g_assert_true(state_of(restored(state)) == state);
}

// The rounding errors of the places of such particles and vertices are many periods of the cell.
PW85_TEST("/saved_states/far_mesh")
{
    char const *const too_many = "particles must not be so long or so far away that more than 2¹⁴ "
                                 "of their images may meet the mesh";
    SimulationPointer const simulation = restored(changed_state({}));
    double const vertices[] = {4.0, 4.0, 1e16, 5.0, 4.0, 1e16, 4.0, 5.0, 1e16};
    std::int32_t const triangle[] = {0, 1, 2};
    expect_refusal(
        pw85_hard_ellipsoids_set_mesh(simulation.get(), 3, vertices, 1, triangle, nullptr),
        PW85_EINVAL, too_many);
}

// The bins of event chains.
PW85_TEST("/saved_states/skewed_and_long_cells")
{
    Bytes const state = closed_state();
    SimulationPointer const skewed = restored(with_word(state, "CELL", 7, word_of(1e9)));
    double number;
    expect_refusal(pw85_hard_ellipsoids_chain(skewed.get(), 1, 1.0, nullptr, &number), PW85_EINVAL,
                   "the cell must not be so skewed or so small that a particle spans more than "
                   "2²⁰ bins of it");
    SimulationPointer const elongated = restored(with_word(state, "CELL", 0, word_of(1e12)));
    g_assert_cmpint(pw85_hard_ellipsoids_chain(elongated.get(), 1, 1.0, nullptr, &number), ==,
                    PW85_SUCCESS);
}

} // namespace

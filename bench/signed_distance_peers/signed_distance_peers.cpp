// SPDX-License-Identifier: BSD-3-Clause
// Prints times and errors of signed distances by this library and by others, as CSV: for each scale
// and signed distance, four columns for each library. measure.py runs it by name:
// --only signed_distance_peers. Libraries that were not built in are named on the error stream.
//
// The semi-axes are log-uniform between scale/10 and scale. Distances are in units of the scale.
// Times are in nanoseconds. Wrong are, in percent, answers with the wrong sign, and calls without
// an answer. The error is the largest relative one of the distance, where a library has an answer;
// the error of the normal is the largest angle, in radians. The truth has 50 digits. Where bodies
// overlap, it is the least depth if no direction has a smaller one. The normals of all libraries
// try to refute this; the program fails if one does.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <child_processes.hpp>
#include <least_time.hpp>
#include <signed_distance_cases.hpp>

#include "peer.hpp"

using namespace pw85_bench;
using Normal = pw85::Vector<Wide, 3>;

namespace {

constexpr int pairs_of_each_kind = 1000;
constexpr double largest_aspect = 10.0;

class Pw85 final : public DistancePeer {
  public:
    void take(std::vector<Forms> const &pairs) override { pairs_ = pairs; }
    Answer measure(std::size_t i) override
    {
        Forms const &p = pairs_[i];
        double distance = 0.0, point1[3], point2[3];
        if (pw85_signed_distance(p.r12, p.q1, p.q2, &distance, point1, point2) != PW85_SUCCESS)
            return {};
        return answer_of_points(distance, point1, point2);
    }

  private:
    std::vector<Forms> pairs_;
};

struct Library {
    char const *name;
    std::unique_ptr<DistancePeer> peer;
};

std::vector<Library> make_libraries()
{
    std::vector<Library> libraries;
    libraries.push_back({"pw85", std::make_unique<Pw85>()});
    libraries.push_back({"fcl", make_fcl()});
#ifdef PW85_BENCH_COAL
    libraries.push_back({"coal", make_coal()});
#else
    std::fputs("coal is skipped: configure with -Dcoal=FOLDER, its source\n", stderr);
#endif
#ifdef PW85_BENCH_MUJOCO
    libraries.push_back({"mujoco", make_mujoco()});
#else
    std::fputs("MuJoCo is skipped: configure with -Dmujoco=FOLDER, its source\n", stderr);
#endif
#ifdef PW85_BENCH_JOLT
    libraries.push_back({"jolt", make_jolt()});
#else
    std::fputs("Jolt is skipped: configure with -Djolt=FOLDER, its source\n", stderr);
#endif
    return libraries;
}

std::vector<Forms> forms_of(std::vector<Case> const &cases)
{
    std::vector<Forms> forms;
    for (Case const &c : cases) {
        Forms f;
        std::copy_n(c.pair.r12.coordinates, 3, f.r12);
        std::copy_n(c.pair.q1.entries, 6, f.q1);
        std::copy_n(c.pair.q2.entries, 6, f.q2);
        forms.push_back(f);
    }
    return forms;
}

/// Fails if the width along n is larger than the distance of the case, which is the largest one.
void try_to_refute(Case const &c, Normal const &n)
{
    auto const pair = pw85_tests::convert<Wide>(c.pair);
    if (pw85_tests::width_along(pair, n) <= c.distance + Wide("1e-30")) return;
    std::fprintf(stderr, "the distance is wrong: %s\n", pw85_tests::hex_text(c.pair).c_str());
    std::exit(EXIT_FAILURE);
}

/// The angle between the normals, in radians; π if the library has no normal.
double angle_of(Case const &c, double const *normal)
{
    Normal const given{normal[0], normal[1], normal[2]};
    Wide const length2 = pw85::dot(given, given);
    if (!(length2 > 0)) return std::acos(-1.0);
    Normal const n = Wide(1 / sqrt(length2)) * given;
    try_to_refute(c, n);
    Normal const difference = n - c.normal;
    return 2.0 * std::asin(std::min(1.0, 0.5 * static_cast<double>(
                                                   Wide(sqrt(pw85::dot(difference, difference))))));
}

struct Errors {
    int wrong = 0;
    double distance = 0.0, normal = 0.0;

    void add(Case const &c, Answer const &found)
    {
        double const exact = static_cast<double>(c.distance);
        if (!std::isfinite(found.distance)) {
            ++wrong;
            return;
        }
        wrong += (found.distance > 0.0) != (exact > 0.0);
        double const error = static_cast<double>(Wide(Wide(found.distance) - c.distance));
        distance = std::max(distance, std::fabs(error / exact));
        normal = std::max(normal, angle_of(c, found.normal));
    }
};

/// Nanoseconds per call, for those pairs for which the library does not end the process.
double time_of(DistancePeer &peer, std::vector<std::size_t> const &pairs)
{
    double volatile sink = 0.0;
    double const time = least_time(pairs.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) sink = peer.measure(pairs[k]).distance;
    });
    static_cast<void>(sink);
    return time;
}

void print_columns(Library const &library, std::vector<Case> const &cases)
{
    library.peer->take(forms_of(cases));
    auto const answers = call_in_children(cases.size(), Answer{},
                                          [&](std::size_t i) { return library.peer->measure(i); });
    Errors errors;
    std::vector<std::size_t> answered;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        errors.add(cases[i], answers[i]);
        if (!std::isnan(answers[i].distance)) answered.push_back(i);
    }
    std::printf(",%.0f,%.3g,%.1e,%.1e", time_of(*library.peer, answered),
                100.0 / pairs_of_each_kind * errors.wrong, errors.distance, errors.normal);
}

void print_row(std::vector<Library> const &libraries, double scale, double distance)
{
    pw85_tests::Random random(7311);
    auto const cases =
        draw_cases(random, {scale / largest_aspect, scale}, scale * distance, pairs_of_each_kind);
    std::printf("%g,%g", scale, distance);
    for (Library const &library : libraries) print_columns(library, cases);
    std::puts("");
}

} // namespace

int main()
{
    auto const libraries = make_libraries();
    std::string head = "scale,distance";
    for (Library const &library : libraries)
        for (char const *const column : {"time_", "wrong_", "error_", "normal_"})
            head += std::string(",") + column + library.name;
    std::puts(head.c_str());
    for (double const scale : {1.0, 0.001})
        for (double const distance :
             {-1e-2, -1e-3, -1e-5, -1e-7, -1e-9, 1e-9, 1e-7, 1e-5, 1e-3, 1e-2})
            print_row(libraries, scale, distance);
    return EXIT_SUCCESS;
}

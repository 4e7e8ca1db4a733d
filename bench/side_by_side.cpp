// SPDX-License-Identifier: BSD-3-Clause
// Compares the overlap tests of several libraries on the same pairs. measure.py runs it.
//
// Times are in nanoseconds per pair, for four aspect ratios; half of the pairs overlap, with μ²
// between 1/4 and 4. Wrong results are in per cent: at aspect ratio 1000 for these pairs, and at
// aspect ratio 10 by |μ² - 1|. pw85 2.0 and HOOMD-blue 2 take part if Meson is given their sources
// (-Dpw85_2, -Dhoomd).
#include <cstdio>

#include <Eigen/Geometry>

#include <pw85.h>
#include <pw85_batch.h>

#include "least_time.hpp"
#include "pairs.hpp"
#include "peer.hpp"
#include "principal_axes.hpp"

using namespace pw85_bench;

namespace {

/// The overlap tests of this library.
template <class Overlaps> class Own final : public Peer {
  public:
    explicit Own(Overlaps overlaps) : overlaps_(overlaps) {}
    void take(Rows rows) override { rows_ = rows; }
    void decide(std::size_t begin, std::size_t end, unsigned char *overlap) const override
    {
        overlaps_({end - begin, rows_.r12 + 3 * begin, rows_.q1 + 6 * begin, rows_.q2 + 6 * begin},
                  overlap + begin);
    }

  private:
    Overlaps overlaps_;
    Rows rows_{};
};

template <class Overlaps> std::unique_ptr<Peer> own(Overlaps overlaps)
{
    return std::make_unique<Own<Overlaps>>(overlaps);
}

/// Calls the function of one pair for each pair.
template <class OverlapsOne> std::unique_ptr<Peer> one_by_one(OverlapsOne overlaps)
{
    return own([overlaps](Rows x, unsigned char *overlap) {
        for (std::size_t i = 0; i < x.n; ++i)
            overlap[i] = overlaps(x.r12 + 3 * i, x.q1 + 6 * i, x.q2 + 6 * i);
    });
}

template <int (*contact)(double const *, double const *, double const *, double *)>
bool overlaps_by(double const *r12, double const *q1, double const *q2)
{
    double out[2];
    contact(r12, q1, q2, out);
    return out[0] < 1.0;
}

bool overlaps_exactly(double const *r12, double const *q1, double const *q2)
{
    int overlap = 0;
    pw85_overlap(r12, q1, q2, &overlap);
    return overlap == 1;
}

/// pw85_overlap() of ellipsoids that are given by semi-axes and quaternions, of which each test
/// makes forms, as HOOMD-blue does.
class FromQuaternions final : public Peer {
  public:
    void take(Rows rows) override
    {
        pairs_.clear();
        for (std::size_t i = 0; i < rows.n; ++i)
            pairs_.push_back({shape(rows.q1 + 6 * i), shape(rows.q2 + 6 * i), rows.r12 + 3 * i});
    }
    void decide(std::size_t begin, std::size_t end, unsigned char *overlap) const override
    {
        for (std::size_t i = begin; i < end; ++i) {
            auto const &[first, second, r12] = pairs_[i];
            double q1[PW85_SYM], q2[PW85_SYM];
            pw85_ellipsoid_quaternion(first.lengths, first.quaternion, q1);
            pw85_ellipsoid_quaternion(second.lengths, second.quaternion, q2);
            overlap[i] = overlaps_exactly(r12, q1, q2);
        }
    }

  private:
    struct Shape {
        double lengths[3], quaternion[4];
    };
    struct Pair {
        Shape first, second;
        double const *r12;
    };

    static Shape shape(double const *q)
    {
        PrincipalAxes const axes(q);
        Eigen::Quaterniond const turn(axes.turn);
        return {{axes.lengths[0], axes.lengths[1], axes.lengths[2]},
                {turn.w(), turn.x(), turn.y(), turn.z()}};
    }

    std::vector<Pair> pairs_;
};

struct Entry {
    char const *name, *gives;
    std::unique_ptr<Peer> peer;
};

std::vector<Entry> entries()
{
    std::vector<Entry> list;
    list.push_back({"pw85_overlap_batch", "boolean", own([](Rows x, unsigned char *overlap) {
                        pw85_overlap_batch(x.n, x.r12, x.q1, x.q2, overlap);
                    })});
    list.push_back({"pw85_overlap", "boolean", one_by_one(overlaps_exactly)});
    list.push_back(
        {"forms of quaternions and pw85_overlap", "boolean", std::make_unique<FromQuaternions>()});
    list.push_back({"pw85_contact", "value", one_by_one(overlaps_by<pw85_contact>)});
    list.push_back(
        {"pw85_contact_function", "value", one_by_one(overlaps_by<pw85_contact_function>)});
#ifdef PW85_BENCH_PW85_2
    list.push_back({"pw85 2.0", "value", peer_pw85_2()});
#endif
#ifdef PW85_BENCH_HOOMD
    list.push_back({"HOOMD-blue 2 (quaternions)", "boolean", peer_hoomd()});
    list.push_back({"HOOMD-blue 2 (matrices)", "boolean", peer_hoomd_matrices()});
#endif
    list.push_back({"FCL 0.7", "boolean", peer_fcl()});
    return list;
}

Rows rows(Block const &block)
{
    return {block.size(), block.r12.data(), block.q1.data(), block.q2.data()};
}

double time_of(Peer &peer, Block &block)
{
    peer.take(rows(block));
    return least_time(block.size(), [&](std::size_t begin, std::size_t end) {
        peer.decide(begin, end, block.overlap.data());
    });
}

double percent_wrong(Peer &peer, Block &block)
{
    std::vector<unsigned char> answers(block.size());
    pw85_overlap_batch(block.size(), block.r12.data(), block.q1.data(), block.q2.data(),
                       block.overlap.data());
    peer.take(rows(block));
    peer.decide(0, block.size(), answers.data());
    int wrong = 0;
    for (std::size_t i = 0; i < block.size(); ++i) wrong += answers[i] != block.overlap[i];
    return 100.0 * wrong / static_cast<double>(block.size());
}

/// One result of each library, for a block of pairs.
void measure(std::vector<Entry> &list, std::vector<std::vector<double>> &results,
             double (*number)(Peer &, Block &), double aspect, double excess)
{
    Block block(random_block(aspect, excess));
    for (std::size_t i = 0; i < list.size(); ++i)
        results[i].push_back(number(*list[i].peer, block));
}

} // namespace

int main()
{
    auto list = entries();
    std::vector<std::vector<double>> results(list.size());
    for (double const aspect : {2.0, 10.0, 100.0, 1000.0})
        measure(list, results, time_of, aspect, 0.0);
    measure(list, results, percent_wrong, 1000.0, 0.0);
    for (double const excess : {1e-3, 1e-5, 1e-7})
        measure(list, results, percent_wrong, 10.0, excess);
    std::printf("library,gives,aspect_2,aspect_10,aspect_100,aspect_1000,wrong_1000,wrong_1e-3,"
                "wrong_1e-5,wrong_1e-7\n");
    for (std::size_t i = 0; i < list.size(); ++i) {
        std::printf("%s,%s", list[i].name, list[i].gives);
        for (double const x : results[i]) std::printf(x < 100.0 ? ",%.3g" : ",%.0f", x);
        std::printf("\n");
    }
    return 0;
}

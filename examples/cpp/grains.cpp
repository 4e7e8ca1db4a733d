// Which of a thousand grains in a periodic cell overlap, and the normals of contacts:
// a neighbour list, exact overlap tests, and the contact function of its pairs.
#include <pw85/linked.hpp>
#include <pw85/systems.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <vector>

using Vector3 = pw85::Vector<double, 3>;

// Ends the program if a call failed.
static void check(pw85::Status status)
{
    if (status == pw85::Status::success) return;
    std::fprintf(stderr, "%s\n", pw85::strerror(status));
    std::exit(EXIT_FAILURE);
}

// Numbers in [0, 1) that are the same everywhere.
static double uniform()
{
    static std::uint32_t state = 1;
    state = 1664525u * state + 1013904223u;
    return state / 4294967296.0;
}

int main()
{
    // An array of three vectors: one pair of braces for each, and two around them.
    pw85::Cell const cell{{{20, 0, 0}, {0, 20, 0}, {0, 0, 20}}};
    std::vector<Vector3> centers;
    std::vector<pw85::SymmetricMatrix<double, 3>> q;
    for (int i = 0; i < 1000; i++) {
        centers.push_back({20 * uniform(), 20 * uniform(), 20 * uniform()});
        pw85::Vector<double, 4> const quaternion{uniform() - 0.5, uniform() - 0.5,
                                                 uniform() - 0.5, uniform() - 0.5};
        auto const form =
            pw85::ellipsoid_quaternion(Vector3{0.5, 0.7, 1.1}, quaternion);
        check(form.status);
        q.push_back(form.q);
    }
    pw85::Particles const grains{centers, q, &cell};

    pw85::Neighbors neighbors;
    check(pw85::neighbors_create(grains, {}, neighbors));
    std::size_t const n = neighbors.pairs().size();
    std::vector<unsigned char> overlap(n);
    std::vector<double> mu2(n);
    std::vector<Vector3> normals(n);
    check(pw85::overlap_pairs(neighbors.list(), grains, overlap));
    check(pw85::contact_derivatives_pairs(neighbors.list(), grains,
                                          {.mu2 = mu2, .normal = normals}));

    auto const deepest = static_cast<std::size_t>(
        std::min_element(mu2.begin(), mu2.end()) - mu2.begin());
    std::printf("%zu pairs of boxes intersect, %d pairs of grains overlap\n", n,
                std::accumulate(overlap.begin(), overlap.end(), 0));
    auto const [i, j] = neighbors.pairs()[deepest];
    std::printf("smallest mu^2 = %.6f, grains %d and %d\n", mu2[deepest], i, j);
    Vector3 const normal = normals[deepest];
    std::printf("normal there: (%.4f, %.4f, %.4f)\n", normal[0], normal[1], normal[2]);
}

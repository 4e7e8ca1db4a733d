// SPDX-License-Identifier: GPL-2.0-only
// Reads meshes, and finds the local minima of the contact function on them.
#include "wall_mesh.hpp"

#include <pw85.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string_view>
#include <tuple>
#include <utility>

namespace pw85_lammps {

namespace {

/// Cosine of the angle between normals up to which neighbouring triangles approximate a curved
/// surface: 20°.
constexpr double nearly_parallel = 0.93969262;

/// A point whose barycentric coordinate is smaller than this is on the edge. It is far above
/// rounding errors, and far below the size of a contact.
constexpr double on_edge = 0x1p-30;

/// The least μ at a contact. Below it, the depth is more than half of the distance of the surface
/// from the centre, and it becomes uncertain on which side the grain is.
constexpr double least_mu2 = 0.25;

constexpr std::size_t stl_head = 84, stl_record = 50; ///< bytes

constexpr std::string_view vertex_word = "vertex";

using Soup = std::vector<std::array<Vector, 3>>;

template <class Number> Number number_at(std::string const &bytes, std::size_t place)
{
    Number x;
    std::memcpy(&x, &bytes[place], sizeof(x));
    return x;
}

/// Returns whether a file is binary STL: its length follows from the number of triangles in it.
/// Files in text form start with "solid", but some binary ones do so, too.
bool is_binary(std::string const &bytes)
{
    return bytes.size() >= stl_head &&
           bytes.size() ==
               stl_head + stl_record * std::size_t{number_at<std::uint32_t>(bytes, stl_head - 4)};
}

Soup read_binary(std::string const &bytes)
{
    Soup soup;
    for (std::size_t record = stl_head; record < bytes.size(); record += stl_record) {
        std::array<Vector, 3> triangle{};
        std::size_t place = record + 3 * sizeof(float); // after the normal
        for (Vector &corner : triangle)
            for (double &x : corner) {
                x = static_cast<double>(number_at<float>(bytes, place));
                place += sizeof(float);
            }
        soup.push_back(triangle);
    }
    return soup;
}

/// @param index counts vertices from zero
[[noreturn]] void refuse_vertex(Words const &words, std::size_t index)
{
    words.refuse("has a bad vertex " + std::to_string(index + 1) +
                 " in its mesh, which must be finite: export the file again, as STL");
}

/// Returns whether a word of a text file begins a vertex. Some programs write capitals.
bool is_vertex(std::string const &word)
{
    return std::equal(word.begin(), word.end(), vertex_word.begin(), vertex_word.end(),
                      [](unsigned char a, char b) { return std::tolower(a) == b; });
}

Soup read_text(std::string const &bytes, Words const &words)
{
    Soup soup;
    std::istringstream stream(bytes);
    std::size_t count = 0;
    for (std::string word; stream >> word;) {
        if (!is_vertex(word)) continue;
        Vector x{};
        if (!(stream >> x[0] >> x[1] >> x[2])) refuse_vertex(words, count);
        if (count % 3 == 0) soup.emplace_back();
        soup.back()[count++ % 3] = x;
    }
    if (count == 0 || count % 3 != 0)
        words.refuse("has a mesh without triangles, or with an incomplete one: export the file "
                     "again, as STL");
    return soup;
}

/// Refuses corners that are not finite, which could not be compared with others.
void check_corners(Soup const &soup, Words const &words)
{
    for (std::size_t t = 0; t < soup.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            if (!std::isfinite(dot(soup[t][k], soup[t][k]))) refuse_vertex(words, 3 * t + k);
}

/// The triangles of a file, with corners that neighbours share. Triangles of which two corners are
/// the same point are left out.
struct Welded {
    std::vector<Vector> vertices;
    std::vector<WallMesh::Triangle> triangles;

    explicit Welded(Soup const &soup)
    {
        std::map<Vector, int> numbers;
        for (auto const &corners : soup) {
            WallMesh::Triangle t{};
            for (std::size_t k = 0; k < 3; ++k) {
                auto const [place, is_new] =
                    numbers.emplace(corners[k], static_cast<int>(numbers.size()));
                if (is_new) vertices.push_back(corners[k]);
                t[k] = place->second;
            }
            if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) triangles.push_back(t);
        }
    }

    /// Refuses a mesh with an edge that belongs to one triangle alone.
    void check_closed(Words const &words, std::string const &file) const
    {
        std::map<std::pair<int, int>, int> counts;
        for (auto const &t : triangles)
            for (std::size_t k = 0; k < 3; ++k) ++counts[std::minmax({t[k], t[(k + 1) % 3]})];
        for (auto const &[edge, count] : counts)
            if (count == 1)
                words.refuse("has a mesh that is not closed, " + file + ": the edge from " +
                             text(edge.first) + " to " + text(edge.second) +
                             " belongs to one triangle alone. Close the hole, or add the word open "
                             "if it is meant");
    }

    std::string text(int vertex) const
    {
        std::ostringstream stream;
        Vector const &x = vertices[static_cast<std::size_t>(vertex)];
        stream << "(" << x[0] << ", " << x[1] << ", " << x[2] << ")";
        return stream.str();
    }
};

/// Returns Q⁻¹x up to a positive factor, by the adjugate.
Vector direction_of_inverse(double const *q, Vector const &x)
{
    double const a = q[3] * q[5] - q[4] * q[4], b = q[2] * q[4] - q[1] * q[5],
                 c = q[1] * q[4] - q[2] * q[3];
    double const d = q[0] * q[5] - q[2] * q[2], e = q[1] * q[2] - q[0] * q[4],
                 f = q[0] * q[3] - q[1] * q[1];
    double const adjugate[6] = {a, b, c, d, e, f};
    return product(adjugate, x);
}

/// Returns a lower bound on the smallest semi-axis of a grain: the determinant of the form is the
/// product of the squares of three semi-axes, of which two are at most the radius.
double least_semi_axis(Grain const &grain)
{
    double const *const q = grain.form;
    double const determinant = q[0] * (q[3] * q[5] - q[4] * q[4]) -
                               q[1] * (q[1] * q[5] - q[2] * q[4]) +
                               q[2] * (q[1] * q[4] - q[2] * q[3]);
    return std::sqrt(determinant) / (grain.radius * grain.radius);
}

Vector normalized(Vector const &x) { return (1.0 / std::sqrt(dot(x, x))) * x; }

} // namespace

WallMesh::WallMesh(std::vector<Vector> vertices, std::vector<Triangle> triangles)
    : vertices_(std::move(vertices)), triangles_(std::move(triangles))
{
    std::vector<std::array<Vector, 2>> boxes;
    for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
        auto const x = corners(t);
        std::array<Vector, 2> box{};
        for (std::size_t k = 0; k < 3; ++k)
            std::tie(box[0][k], box[1][k]) = std::minmax({x[0][k], x[1][k], x[2][k]});
        boxes.push_back(box);
    }
    grid_.build(boxes);
}

std::unique_ptr<WallMesh> WallMesh::box(Vector const &lower, Vector const &upper)
{
    // Bit k of the number of a corner says whether it is at the upper place along axis k.
    std::vector<Vector> vertices(8);
    for (std::size_t corner = 0; corner < 8; ++corner)
        for (std::size_t k = 0; k < 3; ++k)
            vertices[corner][k] = (corner >> k & 1) != 0 ? upper[k] : lower[k];
    std::vector<Triangle> triangles;
    for (int k = 0; k < 3; ++k)
        for (int side = 0; side < 2; ++side) {
            int const a = side << k, b = a + (1 << (k + 1) % 3), c = a + (1 << (k + 2) % 3),
                      d = b + c - a;
            triangles.push_back({a, b, d});
            triangles.push_back({a, d, c});
        }
    auto solid = std::make_unique<WallMesh>(std::move(vertices), std::move(triangles));
    solid->solid_ = {lower, upper};
    return solid;
}

bool WallMesh::contains(Vector const &point) const
{
    if (!solid_) return false;
    for (std::size_t k = 0; k < 3; ++k)
        if (!(point[k] > (*solid_)[0][k] && point[k] < (*solid_)[1][k])) return false;
    return true;
}

std::unique_ptr<WallMesh> WallMesh::parse(Words &words)
{
    std::string const file = words.word("a file");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) words.refuse("has a mesh that cannot be read: " + file);
    std::string const bytes{std::istreambuf_iterator<char>(stream),
                            std::istreambuf_iterator<char>()};
    Soup const soup = is_binary(bytes) ? read_binary(bytes) : read_text(bytes, words);
    check_corners(soup, words);
    Welded mesh(soup);
    double const scale = words.skip("scale") ? words.positive("scale") : 1.0;
    Vector shift{};
    if (words.skip("shift"))
        for (double &x : shift) x = words.coordinate("shift");
    if (mesh.triangles.empty())
        words.refuse("has a mesh whose triangles are all lines or points: " + file);
    if (!words.skip("open")) mesh.check_closed(words, file);
    for (Vector &x : mesh.vertices) {
        x = scale * x + shift;
        if (!std::isfinite(dot(x, x)))
            words.refuse("has a mesh with a vertex that is not finite: " + file);
    }
    return std::make_unique<WallMesh>(std::move(mesh.vertices), std::move(mesh.triangles));
}

std::string WallMesh::touch(Grain const &grain, double gap,
                            std::vector<GrainGeometry> &contacts) const
{
    std::vector<Minimum> const found = minima(grain, gap);
    std::vector<Minimum const *> kept;
    std::vector<Vector> normals;
    for (auto m = found.begin(); m != found.end(); ++m) {
        // A triangle before this one, with a smaller φ, shows that the minimum of this one is not
        // a minimum of the surface.
        if (std::any_of(found.begin(), m,
                        [&](Minimum const &l) { return has_feature(l.triangle, *m); }))
            continue;
        if (m->mu2 < least_mu2)
            return "is so deep in the mesh of the wall that its side is uncertain: use a larger "
                   "stiffness or a smaller "
                   "time step, or move it out of the mesh before the run";
        Vector const n = normal(*m, grain);
        GrainGeometry g = wall_geometry(grain.form, n, dot(n, m->point));
        if (m->mu2 >= 1.0 && !(g.depth > -gap)) continue;
        bool is_same = false;
        for (std::size_t k = 0; k < kept.size(); ++k)
            is_same |= dot(n, normals[k]) > nearly_parallel &&
                       are_neighbours(kept[k]->triangle, m->triangle);
        if (is_same) continue;
        kept.push_back(&*m);
        normals.push_back(n);
        g.triangle = m->triangle;
        contacts.push_back(g);
    }
    return {};
}

/// Returns the minima on all triangles that a grain overlaps, or that are closer than a gap, the
/// smallest first.
///
/// The grain scaled by μ touches a triangle whose surface is (μ - 1) h from its own, with h at
/// least the smallest semi-axis. All triangles up to this μ are there: each minimum of a triangle
/// meets the smaller ones of its neighbours.
std::vector<WallMesh::Minimum> WallMesh::minima(Grain const &grain, double gap) const
{
    double const scale = 1.0 + (gap > 0.0 ? gap / least_semi_axis(grain) : 0.0);
    Vector const half = scale * Vector{std::sqrt(grain.form[0]), std::sqrt(grain.form[3]),
                                       std::sqrt(grain.form[5])};
    std::vector<Minimum> found;
    for (int const t : grid_.find({grain.center - half, grain.center + half})) {
        Minimum const m = minimum(t, grain);
        if (m.mu2 < scale * scale) found.push_back(m);
    }
    std::sort(found.begin(), found.end(), [](Minimum const &a, Minimum const &b) {
        return std::pair(a.mu2, a.triangle) < std::pair(b.mu2, b.triangle);
    });
    return found;
}

WallMesh::Minimum WallMesh::minimum(int triangle, Grain const &grain) const
{
    auto x = corners(triangle);
    for (Vector &corner : x) corner = corner - grain.center;
    Minimum m{1.0, {}, triangle, {}};
    pw85_contact_triangle(x[0].data(), x[1].data(), x[2].data(), grain.form, &m.mu2,
                          m.point.data());
    Vector const area = cross(x[1] - x[0], x[2] - x[0]);
    double const all = dot(area, area);
    for (std::size_t k = 0; k < 3; ++k) {
        Vector const &a = x[(k + 1) % 3], &b = x[(k + 2) % 3];
        m.uses[k] = dot(area, cross(a - m.point, b - m.point)) > on_edge * all;
    }
    return m;
}

/// Returns the normal of a contact, out of the grain.
Vector WallMesh::normal(Minimum const &m, Grain const &grain) const
{
    if (!(m.uses[0] && m.uses[1] && m.uses[2]))
        return normalized(direction_of_inverse(grain.form, m.point));
    auto const x = corners(m.triangle);
    Vector const n = normalized(cross(x[1] - x[0], x[2] - x[0]));
    return dot(n, m.point) < 0.0 ? -1.0 * n : n;
}

/// Returns whether a triangle has the edge or the corner at which a minimum of another triangle is.
bool WallMesh::has_feature(int triangle, Minimum const &m) const
{
    Triangle const &t = triangles_[static_cast<std::size_t>(triangle)];
    Triangle const &own = triangles_[static_cast<std::size_t>(m.triangle)];
    for (std::size_t k = 0; k < 3; ++k)
        if (m.uses[k] && std::find(t.begin(), t.end(), own[k]) == t.end()) return false;
    return true;
}

bool WallMesh::are_neighbours(int t, int u) const
{
    Triangle const &a = triangles_[static_cast<std::size_t>(t)],
                   &b = triangles_[static_cast<std::size_t>(u)];
    return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

std::array<Vector, 3> WallMesh::corners(int triangle) const
{
    Triangle const &t = triangles_[static_cast<std::size_t>(triangle)];
    auto const vertex = [this](int k) { return vertices_[static_cast<std::size_t>(k)]; };
    return {vertex(t[0]), vertex(t[1]), vertex(t[2])};
}

// There are about as many cells as triangles; most cells have few triangles.
void WallMesh::Grid::build(std::vector<std::array<Vector, 2>> const &boxes)
{
    lower_ = boxes.front()[0];
    upper_ = boxes.front()[1];
    for (auto const &box : boxes)
        for (std::size_t k = 0; k < 3; ++k) {
            lower_[k] = std::min(lower_[k], box[0][k]);
            upper_[k] = std::max(upper_[k], box[1][k]);
        }
    double const per_edge = std::ceil(std::cbrt(static_cast<double>(boxes.size())));
    for (std::size_t k = 0; k < 3; ++k) {
        double const length = upper_[k] - lower_[k];
        counts_[k] = length > 0.0 ? static_cast<int>(per_edge) : 1;
        size_[k] = length > 0.0 ? length / per_edge : 1.0;
    }
    cells_.resize(static_cast<std::size_t>(counts_[0]) * static_cast<std::size_t>(counts_[1]) *
                  static_cast<std::size_t>(counts_[2]));
    for (std::size_t t = 0; t < boxes.size(); ++t)
        for_each_cell(boxes[t],
                      [&](std::size_t cell) { cells_[cell].push_back(static_cast<int>(t)); });
}

template <class Use>
void WallMesh::Grid::for_each_cell(std::array<Vector, 2> const &box, Use use) const
{
    int first[3], last[3];
    for (std::size_t k = 0; k < 3; ++k) {
        if (box[1][k] < lower_[k] || box[0][k] > upper_[k]) return;
        auto const place = [&](double x) {
            return static_cast<int>(std::clamp((x - lower_[k]) / size_[k], 0.0, counts_[k] - 1.0));
        };
        first[k] = place(box[0][k]);
        last[k] = place(box[1][k]);
    }
    for (int x = first[0]; x <= last[0]; ++x)
        for (int y = first[1]; y <= last[1]; ++y)
            for (int z = first[2]; z <= last[2]; ++z)
                use(static_cast<std::size_t>(z) +
                    static_cast<std::size_t>(counts_[2]) *
                        (static_cast<std::size_t>(y) +
                         static_cast<std::size_t>(counts_[1]) * static_cast<std::size_t>(x)));
}

std::vector<int> WallMesh::Grid::find(std::array<Vector, 2> const &box) const
{
    std::vector<int> found;
    for_each_cell(box, [&](std::size_t cell) {
        found.insert(found.end(), cells_[cell].begin(), cells_[cell].end());
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

} // namespace pw85_lammps

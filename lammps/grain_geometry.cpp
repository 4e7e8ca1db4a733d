// SPDX-License-Identifier: GPL-2.0-only
// Newton's iteration for the common normal, and the equivalent radius from the curvatures there.
#include "grain_geometry.hpp"

#include <pw85.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pw85_lammps {

namespace {

/// The iteration converges quadratically. After a step of this length in radians, the error of the
/// normal is some 1e-13. That of the depth, which is stationary, is its square.
constexpr double last_step = 0x1p-22;
constexpr int max_steps = 30;

/// A vector of the tangent plane.
struct PlaneVector {
    double x, y;

    friend PlaneVector operator+(PlaneVector const &a, PlaneVector const &b)
    {
        return {a.x + b.x, a.y + b.y};
    }
    friend PlaneVector operator-(PlaneVector const &a, PlaneVector const &b)
    {
        return {a.x - b.x, a.y - b.y};
    }
};

/// A symmetric matrix on the tangent plane.
struct PlaneMatrix {
    double xx, xy, yy;

    double determinant() const { return xx * yy - xy * xy; }

    friend PlaneMatrix operator+(PlaneMatrix const &a, PlaneMatrix const &b)
    {
        return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy};
    }

    friend PlaneVector operator*(PlaneMatrix const &m, PlaneVector const &v)
    {
        return {m.xx * v.x + m.xy * v.y, m.xy * v.x + m.yy * v.y};
    }
};

/// The highest point of an ellipsoid along a unit vector, and the reciprocal of its height h =
/// √(n·Qn).
struct Support {
    double height, scale;
    Vector point;
};

Support support(double const *q, Vector const &normal)
{
    Vector const image = product(q, normal);
    double const height = std::sqrt(dot(normal, image)), scale = 1.0 / height;
    return {height, scale, scale * image};
}

/// Two unit vectors that complete a unit vector n to an orthonormal basis (Duff and others, Journal
/// of Computer Graphics Techniques 6, 1, 2017).
struct Tangents {
    explicit Tangents(Vector const &n)
    {
        double const sign = n[2] < 0.0 ? -1.0 : 1.0, a = -1.0 / (sign + n[2]), b = n[0] * n[1] * a;
        first = {1.0 + sign * n[0] * n[0] * a, sign * b, -sign * n[0]};
        second = {b, sign + n[1] * n[1] * a, -n[1]};
    }

    PlaneVector in_plane(Vector const &v) const { return {dot(first, v), dot(second, v)}; }
    Vector in_space(PlaneVector const &v) const { return v.x * first + v.y * second; }

    Vector first, second;
};

/// The second derivatives of h on the tangent plane, Q/h - pp/h. Their eigenvalues are the radii of
/// curvature.
PlaneMatrix radii_of_curvature(double const *q, Support const &s, Tangents const &t)
{
    Vector const u = product(q, t.first), v = product(q, t.second);
    PlaneVector const p = t.in_plane(s.point);
    return {s.scale * (dot(t.first, u) - p.x * p.x), s.scale * (dot(t.first, v) - p.x * p.y),
            s.scale * (dot(t.second, v) - p.y * p.y)};
}

PlaneMatrix inverse(PlaneMatrix const &m)
{
    double const factor = 1.0 / m.determinant();
    return {factor * m.yy, -factor * m.xy, factor * m.xx};
}

/// How a point of support p and the radii of curvature A there change if the normal turns by x in
/// the tangent plane, to first order: by Ax and -(A (p·x) + Ax pᵀ + p (Ax)ᵀ)/h.
struct Turn {
    Turn(PlaneMatrix const &m, Support const &s, Tangents const &t, PlaneVector const &x)
    {
        PlaneVector const a = m * x, p = t.in_plane(s.point);
        double const along = p.x * x.x + p.y * x.y;
        point = t.in_space(a);
        radii = {-s.scale * (m.xx * along + 2.0 * a.x * p.x),
                 -s.scale * (m.xy * along + a.x * p.y + a.y * p.x),
                 -s.scale * (m.yy * along + 2.0 * a.y * p.y)};
    }

    Vector point;
    PlaneMatrix radii;
};

/// The eigenvalues of the sum of both surfaces' curvatures. The smaller one is the determinant over
/// the larger one, so that it does not come from a difference.
struct Curvatures {
    explicit Curvatures(PlaneMatrix const &sum)
    {
        double const mean = 0.5 * (sum.xx + sum.yy), half = 0.5 * (sum.xx - sum.yy);
        large = mean + std::sqrt(half * half + sum.xy * sum.xy);
        double const quotient = sum.determinant() / large;
        small = quotient < large ? quotient : large;
    }

    double small, large;
};

/// The largest ratio of curvatures for approximate_radius().
constexpr double largest_ratio = 0x1p14;

/// Hertz's equivalent radius R, with a relative error of 1e-15 at most for curvatures whose ratio q
/// is up to largest_ratio.
///
/// R is the largest value of 2 agm(1, k)²/(κ1 + κ2 k²), which the axis ratio k of the contact's
/// ellipse gives (pw85_hertz). The polynomial in x = q^(-1/8) - 1 is k √q with an error of 4.4e-8,
/// by a minimax fit. Because k is stationary, R errs by the square of that, 7e-16 at most. For k =
/// 0.003, the smallest k, five steps make the means equal to 1e-18.
double approximate_radius(Curvatures const &c)
{
    double const root = std::sqrt(c.small / c.large), x = std::sqrt(std::sqrt(root)) - 1.0;
    double p = -18.74904377413505;
    p = p * x - 87.06880334735197;
    p = p * x - 172.19228907682344;
    p = p * x - 185.40234673169687;
    p = p * x - 112.28982142769661;
    p = p * x - 32.6840723729428;
    p = p * x - 0.9023072913707475;
    p = p * x - 0.2800748513544689;
    p = p * x - 1.6652324362178421;
    p = p * x + 0.2211017953454545;
    p = p * x + 1.3333210122327765;
    p = p * x + 1.0;
    double a = 1.0, b = p * root;
    for (int step = 0; step < 5; ++step) {
        double const mean = 0.5 * (a + b);
        b = std::sqrt(a * b);
        a = mean;
    }
    double const mean = 0.5 * (a + b);
    return 2.0 * mean * mean / (c.small * (1.0 + p * p));
}

/// Hertz's equivalent radius for any curvatures.
double equivalent_radius(Curvatures const &c)
{
    if (c.large <= largest_ratio * c.small) return approximate_radius(c);
    double const curvatures[2] = {c.small, c.large};
    double radius = 0.0;
    pw85_hertz(curvatures, &radius, nullptr);
    return radius;
}

/// Computes the contact of a pair for its present normal, and a step of Newton's method. Where the
/// step is short, the depth is stationary, and the points and curvatures change by their
/// derivatives.
void evaluate(GrainSearch::Rows &rows, std::size_t l)
{
    auto const n = load(rows.normal, l);
    auto const q1 = load(rows.q1, l), q2 = load(rows.q2, l);
    Support const s1 = support(q1.data(), n), s2 = support(q2.data(), n);
    Tangents const t(n);
    PlaneMatrix const m1 = radii_of_curvature(q1.data(), s1, t),
                      m2 = radii_of_curvature(q2.data(), s2, t);
    Vector const slope = s1.point + s2.point - load(rows.r12, l);
    double const depth = dot(n, slope);
    PlaneMatrix const m = m1 + m2 + PlaneMatrix{-depth, 0.0, -depth};
    PlaneVector const step = inverse(m) * t.in_plane(-1.0 * slope);
    double const square = step.x * step.x + step.y * step.y, determinant = m.determinant();
    Turn const turn1(m1, s1, t, step), turn2(m2, s2, t, step);
    PlaneMatrix const sum = inverse(m1 + turn1.radii) + inverse(m2 + turn2.radii);
    store((1.0 / std::sqrt(1.0 + square)) * (n + t.in_space(step)), rows.turned, l);
    store(s1.point + turn1.point, rows.arm1, l);
    store(-1.0 * (s2.point + turn2.point), rows.arm2, l);
    store<3>({sum.xx, sum.xy, sum.yy}, rows.curvature, l);
    rows.depth[l] = depth;
    rows.step[l] = square;
    rows.least[l] = m.xx < determinant ? m.xx : determinant;
}

PW85_GRAIN_LANES void evaluate_all(GrainSearch::Rows &rows, std::size_t count)
{
    for (std::size_t l = 0; l < count; ++l) evaluate(rows, l);
}

/// Whether a pair needs another step. If not, its normal stays as it is, so that another evaluation
/// gives the same contact.
bool is_active(GrainSearch::Rows const &rows, std::size_t l)
{
    return rows.step[l] > last_step * last_step && rows.least[l] > 0.0;
}

Curvatures curvatures(GrainSearch::Rows const &rows, std::size_t l)
{
    auto const sum = load(rows.curvature, l);
    return Curvatures({sum[0], sum[1], sum[2]});
}

PW85_GRAIN_LANES void find_radii(GrainSearch::Rows &rows, std::size_t count)
{
    for (std::size_t l = 0; l < count; ++l) {
        Curvatures const c = curvatures(rows, l);
        rows.radius[l] = approximate_radius(c);
        rows.excess[l] = c.large - largest_ratio * c.small;
    }
}

} // namespace

/// Unused rows have unit spheres, so that loops over whole registers work on valid numbers.
GrainSearch::GrainSearch() : rows_{}
{
    double const sphere[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    while (size_ < capacity) add({1.0, 0.0, 0.0}, sphere, sphere, {1.0, 0.0, 0.0});
    clear();
}

/// Turns the normals of the pairs that need another step; returns whether there are any.
bool GrainSearch::turn()
{
    bool any = false;
    for (std::size_t l = 0; l < size_; ++l) {
        if (!is_active(rows_, l)) continue;
        any = true;
        store(load(rows_.turned, l), rows_.normal, l);
    }
    return any;
}

void GrainSearch::solve()
{
    std::size_t const count = whole_registers(size_);
    int step = 0;
    do evaluate_all(rows_, count);
    while (++step < max_steps && turn());
    find_radii(rows_, count);
    for (std::size_t l = 0; l < size_; ++l) {
        bool const found = rows_.step[l] <= last_step * last_step && rows_.least[l] > 0.0;
        if (!found) rows_.depth[l] = std::numeric_limits<double>::quiet_NaN();
        if (rows_.excess[l] > 0.0) rows_.radius[l] = equivalent_radius(curvatures(rows_, l));
    }
}

GrainGeometry GrainSearch::contact(std::size_t k) const
{
    Curvatures const c = curvatures(rows_, k);
    return {load(rows_.turned, k), rows_.depth[k],  load(rows_.arm1, k),
            load(rows_.arm2, k),   rows_.radius[k], -1,
            {c.small, c.large}};
}

void GrainSearch::replace(std::size_t k, GrainGeometry const &contact)
{
    store(contact.normal, rows_.turned, k);
    store(contact.arm1, rows_.arm1, k);
    store(contact.arm2, rows_.arm2, k);
    rows_.depth[k] = contact.depth;
    rows_.radius[k] = contact.radius;
    store<3>({contact.curvatures[0], 0.0, contact.curvatures[1]}, rows_.curvature, k);
}

namespace {

/// The number (1, 2) of ab - ba.
double commutator(PlaneMatrix const &a, PlaneMatrix const &b)
{
    return a.xy * (b.yy - b.xx) + b.xy * (a.xx - a.yy);
}

/// The derivatives of R by the sum of curvatures W, as a symmetric matrix. Because R is the largest
/// value of 2 agm(1, k)²/(κ1 + κ2 k²) over k, they are -R/(κ1 + κ2 k²) times 1 and k² along the
/// directions of κ1 and κ2.
PlaneMatrix radius_by_curvature(PlaneMatrix const &sum)
{
    Curvatures const c(sum);
    double const curvatures[2] = {c.small, c.large}, gap = c.large - c.small;
    double radius = 0.0, ellipse[2];
    pw85_hertz(curvatures, &radius, ellipse);
    double const k2 = ellipse[1] / ellipse[0], factor = -radius / (c.small + c.large * k2);
    // times W - κ1, which is κ2 - κ1 along the direction of κ2
    double const part = gap > 0.0 ? (k2 - 1.0) / gap : 0.0;
    return {factor * (1.0 + part * (sum.xx - c.small)), factor * part * sum.xy,
            factor * (1.0 + part * (sum.yy - c.small))};
}

/// The part of an ellipsoid in the derivatives of R. Let A be its radii of curvature, K = 1/A, and
/// G = -K R_W K, so that R changes by tr(G dA).
struct RadiusPart {
    RadiusPart(double const *q, Vector const &normal, Tangents const &t)
        : end(support(q, normal)), radii(radii_of_curvature(q, end, t)), curvature(inverse(radii))
    {
    }

    /// If the normal turns by x, A changes as in Turn. So R changes by D·x with
    /// D = -(tr(GA) p + 2 AG p)/h, where GA = -K R_W.
    void differentiate(PlaneMatrix const &by_curvature, Tangents const &t)
    {
        PlaneMatrix const &k = curvature, &w = by_curvature;
        PlaneVector const p = t.in_plane(end.point), wkp = w * (k * p);
        double const trace = k.xx * w.xx + 2.0 * k.xy * w.xy + k.yy * w.yy;
        by_normal = {end.scale * (trace * p.x + 2.0 * wkp.x),
                     end.scale * (trace * p.y + 2.0 * wkp.y)};
        by_spin = 2.0 * commutator(curvature, by_curvature);
    }

    /// The derivative by a rotation ω of the ellipsoid, n×(A y - D) + S n - p×y. Here y is the
    /// derivative of R by r12, S that by a rotation about the normal, and a fixed normal turns by
    /// -ω×n as seen from the ellipsoid.
    Vector by_rotation(Vector const &normal, Tangents const &t, PlaneVector const &y) const
    {
        return cross(normal, t.in_space(radii * y - by_normal)) + by_spin * normal -
               cross(end.point, t.in_space(y));
    }

    Support end;
    PlaneMatrix radii, curvature;
    PlaneVector by_normal{}; ///< D
    double by_spin = 0.0;    ///< S
};

} // namespace

RadiusGradient radius_gradient(double const *q1, double const *q2, Vector const &normal,
                               double depth)
{
    Tangents const t(normal);
    RadiusPart part1(q1, normal, t), part2(q2, normal, t);
    PlaneMatrix const by_curvature = radius_by_curvature(part1.curvature + part2.curvature);
    part1.differentiate(by_curvature, t);
    part2.differentiate(by_curvature, t);
    // A change of r12 turns the normal by H⁻¹ times its part across the normal, with the second
    // derivatives H of the depth.
    PlaneMatrix const turn = inverse(part1.radii + part2.radii + PlaneMatrix{-depth, 0.0, -depth});
    PlaneVector const y = turn * (part1.by_normal + part2.by_normal);
    return {t.in_space(y), part1.by_rotation(normal, t, y), part2.by_rotation(normal, t, y)};
}

GrainGeometry wall_geometry(double const *q, Vector const &normal, double distance,
                            Vector const &direction, double curvature)
{
    Support const s = support(q, normal);
    Tangents const t(normal);
    double const depth = s.height - distance, x = dot(t.first, direction),
                 y = dot(t.second, direction);
    PlaneMatrix const wall{curvature * x * x, curvature * x * y, curvature * y * y};
    Curvatures sum(inverse(radii_of_curvature(q, s, t)) + wall);
    sum.small = std::max(sum.small, least_curvature_ratio * sum.large);
    return {normal,
            depth,
            s.point,
            s.point - depth * normal,
            equivalent_radius(sum),
            -1,
            {sum.small, sum.large}};
}

} // namespace pw85_lammps

// Do a thin disk and a rod overlap? Prints the contact function of the two, then checks
// it: with the factor μ the two touch, in one point and with one tangent plane. Only
// headers of pw85 are needed.
#include <pw85/pw85.hpp>

#include <cmath>
#include <cstdio>

using Vector = pw85::Vector<double, 3>;
using Form = pw85::SymmetricMatrix<double, 3>;

// The gradient of (m - c)ᵀ Q⁻¹ (m - c), which is 1 on the surface of the ellipsoid,
// over 2, for x = m - c.
static Vector surface_gradient(Form const &q, Vector const &x)
{
    return pw85::cholesky_solve(pw85::cholesky(q), x);
}

static Vector normalized(Vector const &x)
{
    return 1.0 / std::sqrt(pw85::dot(x, x)) * x;
}

static void print(char const *what, Vector const &x)
{
    std::printf("%s = (%.6f, %.6f, %.6f)\n", what, x[0], x[1], x[2]);
}

int main()
{
    Vector const x1{-0.5, 0.4, -0.7}, x2{0.2, -0.3, 0.4};
    auto const [q1, status1] =
        pw85::spheroid(10.0, 0.1, Vector{0.0, 0.0, 1.0}); // oblate, axis z
    auto const [q2, status2] =
        pw85::spheroid(0.5, 5.0, Vector{1.0, 0.0, 0.0}); // prolate, axis x
    Vector const r12 = x2 - x1;

    auto const [mu2, lambda, status] = pw85::contact(r12, q1, q2);
    if (status != pw85::Status::success) {
        std::fprintf(stderr, "%s\n", pw85::strerror(status));
        return 1;
    }
    std::printf("mu^2 = %g\n", mu2);
    std::printf("lambda = %g\n", lambda);
    std::printf("The spheroids %s.\n\n", mu2 < 1.0 ? "overlap" : "do not overlap");

    // The point where the spheroids touch when they are scaled by mu, which multiplies
    // the forms by mu².
    Vector const point = pw85::contact_geometry(r12, q1, q2, lambda).point;
    Vector const from1 = point, from2 = point - r12;
    Vector const gradient1 = surface_gradient(mu2 * q1, from1);
    Vector const gradient2 = surface_gradient(mu2 * q2, from2);
    print("contact point", x1 + point);
    std::printf("on spheroid 1, scaled: %.10f\n", pw85::dot(from1, gradient1));
    std::printf("on spheroid 2, scaled: %.10f\n", pw85::dot(from2, gradient2));
    print("normal to spheroid 1", normalized(gradient1));
    print("normal to spheroid 2", normalized(gradient2));
    return 0;
}

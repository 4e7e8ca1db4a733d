// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The area of an ellipsoid and the perimeter of an ellipse, and the second moments of a uniform
/// sheet or wire of this shape.
///
/// Let a_i be the semi-axes, p_i = 1/a_i², and n a unit vector. The point x_i = a_i n_i of the
/// surface has the element of area a1 a2 a3 √(Σ p_i n_i²) dn. Averages over the sphere of such
/// functions are Carlson's R_s of the variables p with all parameters 1/2 (DLMF 19.16.9). A factor
/// n_i² adds one to the parameter of p_i. So the area is S = 4π a1 a2 a3 R_G(p) (DLMF 19.33.1), and
/// the mean of x_i² over the surface is a_i² R_(1/2)(½ + e_i; p)/(3 R_G). The relation
///
///     c R_s(b) = (c + s) R_s(b + e_i) - s p_i R_(s-1)(b + e_i),    c = Σ b_j,
///
/// follows from ∂R_s/∂p_i = s (b_i/c) R_(s-1)(b + e_i) (DLMF 19.18.4). Let D_i be the R_D whose
/// last variable is p_i. Two applications of the relation and Σ p_i D_i = 3 R_F (DLMF 19.21.9) give
///
///     mean of x_i² = a_i²/4 + Σ_(j≠i) p_j D_j/(24 R_G).
///
/// All terms are positive. For an ellipse p has two variables, and c is 1 instead of 3/2. A third
/// variable 0 makes the complete integrals special cases of R_D and R_G: the perimeter is 8 a1 a2
/// R_G(p, 0), and the mean of x_i² is a_i²/3 + Σ_(j≠i) p_j D_j/(18 R_G).
///
/// R_G follows from 2 R_G = z R_F + (x-z)(z-y) R_D(x, y; z)/3 + √(xy/z) (DLMF 19.21.10), where all
/// terms are positive if z is the variable in the middle.
///
/// All numbers are of the type Finer<T>, with twice the digits of T, and the results are rounded
/// once. The squares of the semi-axes come from Jacobi's rotations, whose errors are a few units of
/// 2^-104 times the largest square (for double). So the relative errors of the smaller ones are
/// below 2^-98 times the square of the aspect ratio.
#ifndef PW85_BODIES_SURFACE_HPP_INCLUDED
#define PW85_BODIES_SURFACE_HPP_INCLUDED

#include <pw85/algebra/unit_ball.hpp>
#include <pw85/bodies/carlson.hpp>
#include <pw85/distance/nearest.hpp>
#include <pw85/volume/volume.hpp>

namespace pw85 {

/// The length of an ellipse. It is NaN if the status is not success.
template <class T> struct Perimeter {
    T perimeter;
    StatusCode status;
};

/// Second moments about the centre, the mean of x xᵀ. They are NaN if the status is not success.
template <class T, int D> struct Moments {
    SymmetricMatrix<T, D> moments;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// A sheet of the shape of an ellipsoid, in its principal axes.
template <class W, int D> struct Sheet {
    PrincipalAxes<W, D> axes;
    W size;           ///< the product of the semi-axes times R_G(p)
    Vector<W, D> sum; ///< Σ_(j≠i) p_j D_j/R_G(p) for each axis i
};

/// R_G of three numbers, of which one may be zero, from `products`, which are x_i R_D(x_j, x_k;
/// x_i).
template <class W>
PW85_FUNCTION inline W carlson_r_g(Vector<W, 3> const &x, Vector<W, 3> const &products) noexcept
{
    int low = 0, high = 0;
    for (int i = 1; i < 3; ++i) {
        if (x[i] < x[low]) low = i;
        if (!(x[i] < x[high])) high = i;
    }
    int const middle = low == high ? 1 : 3 - low - high;
    W const third = W(1) / W(3), z = x[middle];
    W const r_f = third * (products[0] + products[1] + products[2]);
    W const difference = third * (W(W(x[high] - z) * W(z - x[low])) * W(products[middle] / z));
    return W(0.5) * (z * r_f + difference + W(sqrt(W(W(x[high] * x[low]) / z))));
}

/// The sheet of a valid form whose largest diagonal entry is in [1, 4).
template <class T, int D>
PW85_FUNCTION inline Sheet<Finer<T>, D> sheet_of(SymmetricMatrix<T, D> const &q) noexcept
{
    using W = Finer<T>;
    Sheet<W, D> sheet{principal_axes(converted<W>(q)), W(1), {}};
    Vector<W, 3> p{}, products{};
    W square = W(1);
    for (int i = 0; i < D; ++i) {
        p[i] = W(1) / sheet.axes.squares[i];
        square = square * sheet.axes.squares[i];
    }
    auto const integrals = carlson_r_d<T>(p);
    for (int i = 0; i < D; ++i) products[i] = p[i] * integrals[i];
    W const r_g = carlson_r_g(p, products);
    sheet.size = W(sqrt(square)) * r_g;
    for (int i = 0; i < D; ++i) {
        for (int j = 0; j < D; ++j)
            if (j != i) sheet.sum[i] = sheet.sum[i] + products[j];
        sheet.sum[i] = sheet.sum[i] / r_g;
    }
    return sheet;
}

/// The area or the perimeter of a sheet.
template <class T, class W, int D>
PW85_FUNCTION inline T rounded_area(Sheet<W, D> const &sheet) noexcept
{
    W const factor = D == 3 ? W(W(4) * fine_circle_constant<T>()) : W(8);
    return rounded(W(factor * sheet.size));
}

/// The area or the perimeter of a valid form.
template <class T, int D> PW85_RARE T surface_of(SymmetricMatrix<T, D> const &q) noexcept
{
    Unit const unit = unit_of(q);
    return unit.to_caller(rounded_area<T>(sheet_of(unit.to_local(q))), D - 1);
}

/// The second moments of a sheet of a valid form, and its area or perimeter.
template <class T, int D> struct SheetMoments {
    SymmetricMatrix<T, D> moments;
    T area;
};

template <class T, int D>
PW85_RARE SheetMoments<T, D> sheet_moments(SymmetricMatrix<T, D> const &q) noexcept
{
    using W = Finer<T>;
    Unit const unit = unit_of(q);
    auto const scaled = unit.to_local(q);
    auto const sheet = sheet_of(scaled);
    SymmetricMatrix<T, D> moments{};
    for (int i = 0; i < D; ++i)
        for (int j = i; j < D; ++j) {
            W sum = W(scaled(i, j));
            for (int k = 0; k < D; ++k)
                sum = sum + W(sheet.axes.axes[i][k] * sheet.axes.axes[j][k]) * sheet.sum[k] / W(6);
            moments(i, j) = rounded(W(sum / W(D + 1)));
        }
    return {unit.to_caller(moments, 2), unit.to_caller(rounded_area<T>(sheet), D - 1)};
}

PW85_RARE_TIER(surface_of)
PW85_RARE_TIER(sheet_moments)

} // namespace pw85::detail

namespace pw85 {

template <class T>
PW85_FUNCTION inline Area<T> surface_area(SymmetricMatrix<T, 3> const &q) noexcept
{
    StatusCode const status = detail::validate(q);
    if (status != StatusCode::success) return detail::all_nan<Area<T>>(status);
    return {detail::surface_of(q), status};
}

template <class T>
PW85_FUNCTION inline Perimeter<T> perimeter(SymmetricMatrix<T, 2> const &q) noexcept
{
    StatusCode const status = detail::validate(q);
    if (status != StatusCode::success) return detail::all_nan<Perimeter<T>>(status);
    return {detail::surface_of(q), status};
}

template <class T, int D>
PW85_FUNCTION inline Moments<T, D> shell_moments(SymmetricMatrix<T, D> const &q) noexcept
{
    StatusCode const status = detail::validate(q);
    if (status != StatusCode::success) return detail::all_nan<Moments<T, D>>(status);
    return {detail::sheet_moments(q).moments, status};
}

} // namespace pw85

#endif

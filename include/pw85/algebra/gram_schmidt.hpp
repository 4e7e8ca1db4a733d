// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Directions that are conjugate with respect to M = α S1 S1ᵀ + β S2 S2ᵀ, by Gram–Schmidt
/// orthogonalisation of the unit vectors. contact/contact_factored.hpp and contact/geometry.hpp
/// solve equations with M by them. M itself is never computed.
///
/// The columns of K = [√α S1ᵀ; √β S2ᵀ] are the images of the unit vectors, and M = KᵀK. Each place
/// takes the longest image that remains. An image that has mostly cancelled is made orthogonal to
/// the earlier ones once more. Then the rounding errors in a row of K are a few u times the entries
/// of that row. This holds also if the lengths of the rows differ by many orders of magnitude. (For
/// Householder's method this is a theorem of A. J. Cox and N. J. Higham, in: Numerical Analysis
/// 1997, Longman, 57, 1998. Here tests/test_factored.cpp checks it.)
///
/// With conjugate directions w_j, M⁻¹x = Σ w_j (w_jᵀx)/(w_jᵀM w_j).
#ifndef PW85_ALGEBRA_GRAM_SCHMIDT_HPP_INCLUDED
#define PW85_ALGEBRA_GRAM_SCHMIDT_HPP_INCLUDED

#include <pw85/algebra/factor.hpp>

namespace pw85::detail {

/// A vector with its images.
template <class T, int D> struct ImagedVector {
    Vector<T, D> w;
    Vector<T, D> first, second; ///< S1ᵀw and S2ᵀw
};

template <class T, int D> PW85_FUNCTION constexpr ImagedVector<T, D>
add_scaled(ImagedVector<T, D> const &x, T const &factor, ImagedVector<T, D> const &y) noexcept
{
    return {add_scaled(x.w, factor, y.w), add_scaled(x.first, factor, y.first),
            add_scaled(x.second, factor, y.second)};
}

/// A direction, and its component of the right side x.
template <class T, int D> struct ConjugateDirection {
    ImagedVector<T, D> vector;
    T component; ///< wᵀx
    T square;    ///< wᵀM w
    T removed;   ///< by how much projections have shortened the square
};

/// Conjugate directions for M, and the components of x along them.
template <class T, int D> struct ConjugateBasis {
    T alpha, beta;
    /// the share of a square that projections must leave; otherwise a second projection follows
    T least_rest;
    ConjugateDirection<T, D> directions[std::size_t(D)];
    T reciprocals[std::size_t(D)]; ///< 1/(wᵀM w)
};

/// xᵀM y.
template <class T, int D>
PW85_FUNCTION constexpr T inner_product(ConjugateBasis<T, D> const &basis,
                                        ImagedVector<T, D> const &x,
                                        ImagedVector<T, D> const &y) noexcept
{
    return basis.alpha * dot(x.first, y.first) + basis.beta * dot(x.second, y.second);
}

/// Subtracts from direction j its component along direction i.
template <class T, int D>
PW85_FUNCTION constexpr void project_out(ConjugateBasis<T, D> &basis, int i, int j) noexcept
{
    auto const &along = basis.directions[i];
    auto &d = basis.directions[j];
    T const product = inner_product(basis, along.vector, d.vector),
            factor = product * basis.reciprocals[i];
    d.vector = add_scaled(d.vector, T(-factor), along.vector);
    d.component = d.component - factor * along.component;
    d.removed = d.removed + factor * product;
    d.square = inner_product(basis, d.vector, d.vector);
}

/// Puts the longest of the remaining images in place j. If the projections have left less than the
/// least rest of its square, second ones follow.
template <class T, int D>
PW85_FUNCTION inline void choose_direction(ConjugateBasis<T, D> &basis, int j) noexcept
{
    for (int k = j + 1; k < D; ++k)
        if (basis.directions[k].square > basis.directions[j].square) {
            auto const longer = basis.directions[k];
            basis.directions[k] = basis.directions[j];
            basis.directions[j] = longer;
        }
    auto const &d = basis.directions[j];
    if (!(d.square > basis.least_rest * d.removed))
        for (int i = 0; i < j; ++i) project_out(basis, i, j);
    basis.reciprocals[j] = T(1) / d.square;
}

/// Makes direction j unit vector j.
template <class T, int D>
PW85_FUNCTION constexpr void set_unit_vector(ConjugateBasis<T, D> &basis, int j,
                                             Factor<T, D> const &s1,
                                             Factor<T, D> const &s2) noexcept
{
    auto &[vector, component, square, removed] = basis.directions[j];
    vector.w[j] = T(1);
    for (int k = 0; k < D; ++k) {
        vector.first[k] = s1(j, k);
        vector.second[k] = s2(j, k);
    }
    square = inner_product(basis, vector, vector);
}

/// Directions for M = α S1 S1ᵀ + β S2 S2ᵀ, with the components of x. The errors of the images are
/// some u/√least_rest.
template <class T, int D> PW85_FUNCTION inline ConjugateBasis<T, D>
conjugate_basis(T const &alpha, Factor<T, D> const &s1, T const &beta, Factor<T, D> const &s2,
                Vector<T, D> const &x, T const &least_rest) noexcept
{
    ConjugateBasis<T, D> basis{alpha, beta, least_rest, {}, {}};
    for (int j = 0; j < D; ++j) {
        set_unit_vector(basis, j, s1, s2);
        basis.directions[j].component = x[j];
    }
    for (int j = 0; j < D; ++j) {
        choose_direction(basis, j);
        for (int k = j + 1; k < D; ++k) project_out(basis, j, k);
    }
    return basis;
}

/// The solution of equations with M, and yᵀM⁻¹y, from the components of the right side y along the
/// directions.
template <class T, int D> struct ConjugateSolution {
    ImagedVector<T, D> vector; ///< M⁻¹y
    T square;
};

template <class T, int D> PW85_FUNCTION constexpr ConjugateSolution<T, D>
solve(ConjugateBasis<T, D> const &basis, Vector<T, D> const &components) noexcept
{
    ConjugateSolution<T, D> sum{};
    for (int j = 0; j < D; ++j) {
        T const weight = components[j] * basis.reciprocals[j];
        sum.vector = add_scaled(sum.vector, weight, basis.directions[j].vector);
        sum.square = sum.square + weight * components[j];
    }
    return sum;
}

/// The components of the right side for which the directions were computed.
template <class T, int D>
PW85_FUNCTION constexpr Vector<T, D> components(ConjugateBasis<T, D> const &basis) noexcept
{
    Vector<T, D> x{};
    for (int j = 0; j < D; ++j) x[j] = basis.directions[j].component;
    return x;
}

/// M⁻¹x for M = w1 S1 S1ᵀ + w2 S2 S2ᵀ, with its images.
template <class T, int D>
PW85_FUNCTION inline ImagedVector<T, D> solve_blend(T const &w1, Factor<T, D> const &s1,
                                                    T const &w2, Factor<T, D> const &s2,
                                                    Vector<T, D> const &x) noexcept
{
    auto const basis = conjugate_basis(w1, s1, w2, s2, x, negative_power_of_two<T>(4));
    return solve(basis, components(basis)).vector;
}

} // namespace pw85::detail

#endif

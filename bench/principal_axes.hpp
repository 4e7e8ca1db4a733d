// SPDX-License-Identifier: BSD-3-Clause
// Computes the semi-axes and principal directions of a form, for libraries that need them. The
// relative error is that of rounding, some 1e-16, plus 1e-19 times the square of the aspect ratio.
#ifndef PW85_BENCH_PRINCIPAL_AXES_HPP_INCLUDED
#define PW85_BENCH_PRINCIPAL_AXES_HPP_INCLUDED

#include <Eigen/Eigenvalues>

namespace pw85_bench {

struct PrincipalAxes {
    Eigen::Vector3d lengths;
    Eigen::Matrix3d turn; // its columns are the directions

    /// @param q the six entries of a form
    explicit PrincipalAxes(double const *q)
    {
        using Matrix = Eigen::Matrix<long double, 3, 3>;
        Matrix form;
        form << q[0], q[1], q[2], q[1], q[3], q[4], q[2], q[4], q[5];
        Eigen::SelfAdjointEigenSolver<Matrix> const axes(form);
        lengths = axes.eigenvalues().cwiseSqrt().cast<double>();
        turn = axes.eigenvectors().cast<double>();
        if (turn.determinant() < 0.0) turn.col(0) *= -1.0;
    }
};

} // namespace pw85_bench

#endif

function [d_r12, d_q1, d_q2] = pw85_overlap_volume_gradient (varargin)
%pw85_overlap_volume_gradient  Computes the derivatives of the volume V of the intersection of
%  two ellipsoids.
%
%   [d_r12, d_q1, d_q2] = pw85_overlap_volume_gradient (r12, q1, q2)
%   [d_r12, d_q1, d_q2] = pw85_overlap_volume_gradient (x, y)
%
%  The derivatives are 0 if the ellipsoids do not overlap. If one ellipsoid is inside the other
%  one, V is its volume, and only the derivatives with respect to its form are not 0.
%
%  The error of the derivative with respect to a number p is below u (256 m + 64 s), with u =
%  2⁻⁵³. The term s is defined as for pw85_overlap_volume(), with ∂V/∂p instead of V. The term m
%  depends on the volume v of the smaller ellipsoid, the inverse P of its form, and the inverse
%  P' of the form to which p belongs. It is v √P_ii for p = r12_i, v √(P_ii P'_ii) for a
%  diagonal entry p of a form, and v (√(P_ii P'_jj) + √(P_jj P'_ii)) for another entry.
%
%  For ellipsoids in three dimensions.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         Vector from the centre of ellipsoid 1 to that of ellipsoid 2. 3 columns.
%  q1, q2      Forms of the ellipsoids, in the square of the unit of r12. 6 columns each.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi]: see pw85_from_matgeom.
%
%  d_r12       ∂V/∂r12; its negative is the derivative with respect to the centre of ellipsoid
%              1. 3 columns.
%  d_q1, d_q2  Derivatives with respect to the stored entries of q1 and q2 (a stored
%              off-diagonal entry is two entries of the matrix). 6 columns each.
%
%  The function of the C API is pw85_overlap_volume_gradient().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [d_r12, d_q1, d_q2] = pw85_mex ('overlap_volume_gradient', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:3}] = pw85_overlap_volume_gradient (r2 - r1, q1, q2);
%! [b{1:3}] = pw85_overlap_volume_gradient (x, y);
%! assert (b, a);
%! [b{1:3}] = pw85_overlap_volume_gradient (x, y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

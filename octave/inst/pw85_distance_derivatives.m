function [d_r12, d_rot1, d_rot2, hessian] = pw85_distance_derivatives (varargin)
%pw85_distance_derivatives  Computes the derivatives of the distance of two ellipsoids.
%
%   [d_r12, d_rot1, d_rot2, hessian] = pw85_distance_derivatives (r12, q1, q2)
%   [d_r12, d_rot1, d_rot2, hessian] = pw85_distance_derivatives (x, y)
%
%  The derivatives are NaN if the ellipsoids overlap.
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
%  d_r12       Derivative with respect to r12: the unit normal at the closest points, into
%              ellipsoid 2. 3 columns.
%  d_rot1, d_rot2  Derivatives with respect to rotations, as for pw85_contact_torque(). 3
%              columns each.
%  hessian     Symmetric matrix of second derivatives with respect to r12, rotation 1 and
%              rotation 2, as for pw85_contact_hessian(). 81 columns, a matrix of 9 x 9 row by
%              row.
%
%  The function of the C API is pw85_distance_derivatives().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [d_r12, d_rot1, d_rot2, hessian] = pw85_mex ('distance_derivatives', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:4}] = pw85_distance_derivatives (r2 - r1, q1, q2);
%! [b{1:4}] = pw85_distance_derivatives (x, y);
%! assert (b, a);
%! [b{1:4}] = pw85_distance_derivatives (x, y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

function [d_r12, d_rot1, d_rot2, hessian] = pw85_signed_distance_derivatives (varargin)
%pw85_signed_distance_derivatives  Computes the derivatives of the signed distance of two
%  ellipsoids.
%
%   [d_r12, d_rot1, d_rot2, hessian] = pw85_signed_distance_derivatives (r12, q1, q2)
%   [d_r12, d_rot1, d_rot2, hessian] = pw85_signed_distance_derivatives (x, y)
%
%  At contact, the derivatives are the limits from both sides. The function has no output for
%  derivatives with respect to the entries of the forms. They are -n_i n_j/(2α) for q1 and -n_i
%  n_j/(2β) for q2, and twice that for entries off the diagonal, with n = d_r12 and the
%  half-widths α and β along n.
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
%  d_r12       Derivative with respect to r12: the unit normal to both surfaces at the points of
%              pw85_signed_distance(), out of ellipsoid 1. If several directions give the same
%              signed distance, the derivative does not exist, and the result is one of the
%              subgradients. 3 columns.
%  d_rot1, d_rot2  Derivatives with respect to rotations, as for pw85_contact_torque(). 3
%              columns each.
%  hessian     Symmetric matrix of second derivatives, as for pw85_distance_derivatives(); NaN,
%              if the extremum over the directions is not isolated, or so nearly degenerate that
%              half of the digits would be lost. 81 columns, a matrix of 9 x 9 row by row.
%
%  The function of the C API is pw85_signed_distance_derivatives().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [d_r12, d_rot1, d_rot2, hessian] = pw85_mex ('signed_distance_derivatives', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:4}] = pw85_signed_distance_derivatives (r2 - r1, q1, q2);
%! [b{1:4}] = pw85_signed_distance_derivatives (x, y);
%! assert (b, a);
%! [b{1:4}] = pw85_signed_distance_derivatives (x, y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

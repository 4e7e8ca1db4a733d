function [d_r12, d_rot1, d_rot2] = pw85_grain_radius_gradient (varargin)
%pw85_grain_radius_gradient  Computes the derivatives of the radius of pw85_grain_contact().
%
%   [d_r12, d_rot1, d_rot2] = pw85_grain_radius_gradient (r12, q1, q2, normal)
%   [d_r12, d_rot1, d_rot2] = pw85_grain_radius_gradient (x, y, normal)
%
%  They include the change of the normal with the motion. A force that depends on the radius
%  needs these derivatives to conserve the energy.
%
%  For ellipsoids in three dimensions.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         Vector from the centre of ellipsoid 1 to that of ellipsoid 2. 3 columns.
%  q1, q2      Forms of the ellipsoids, in the square of the unit of r12. 6 columns each.
%  normal      That of pw85_grain_contact(), of any length; not zero. 3 columns.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi]: see pw85_from_matgeom.
%
%  d_r12       Derivative with respect to r12. 3 columns.
%  d_rot1, d_rot2  Derivatives with respect to rotations, as for pw85_contact_torque(). 3
%              columns each.
%
%  The function of the C API is pw85_grain_radius_gradient().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [d_r12, d_rot1, d_rot2] = pw85_mex ('grain_radius_gradient', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:3}] = pw85_grain_radius_gradient (r2 - r1, q1, q2, [1 0 0]);
%! [b{1:3}] = pw85_grain_radius_gradient (x, y, [1 0 0]);
%! assert (b, a);
%! [b{1:3}] = pw85_grain_radius_gradient (x, y(end,:), [1 0 0]);
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

function [d_rot1, d_rot2] = pw85_contact_torque (varargin)
%pw85_contact_torque  Computes the derivatives of μ² with respect to rotations of the
%  ellipsoids.
%
%   [d_rot1, d_rot2] = pw85_contact_torque (r12, q1, q2, lambda)
%   [d_rot1, d_rot2] = pw85_contact_torque (x, y, lambda)
%
%  If an ellipsoid rotates about its own centre by a small rotation vector ω, μ² changes by
%  d_rot·ω. An energy U(μ²) exerts the torque -U'(μ²) d_rot on the ellipsoid.
%
%  For ellipses and ellipsoids.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         Vector from the centre of ellipsoid 1 to that of ellipsoid 2. 3 or 2 columns.
%  q1, q2      Forms of the ellipsoids, in the square of the unit of r12. 6 or 3 columns each.
%  lambda      The maximiser λ of f, from pw85_contact(). 1 column.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi] or, in the plane, [xc yc a b
%              theta]: see pw85_from_matgeom.
%
%  d_rot1, d_rot2  Derivatives for ellipsoids 1 and 2, per radian. 3 or 1 columns each.
%
%  The function of the C API is pw85_contact_torque().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [d_rot1, d_rot2] = pw85_mex ('contact_torque', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:2}] = pw85_contact_torque (r2 - r1, q1, q2, 0.5);
%! [b{1:2}] = pw85_contact_torque (x, y, 0.5);
%! assert (b, a);
%! [b{1:2}] = pw85_contact_torque (x, y(end,:), 0.5);
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

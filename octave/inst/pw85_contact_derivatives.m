function [mu2, lambda, point, normal, d_r12, d_rot1, d_rot2] = pw85_contact_derivatives (varargin)
%pw85_contact_derivatives  Computes pw85_contact(), pw85_contact_geometry(),
%  pw85_contact_gradient() and pw85_contact_torque() for many pairs in one call.
%
%   [mu2, lambda, point, normal, d_r12, d_rot1, d_rot2] = pw85_contact_derivatives (r12, q1, q2)
%   [mu2, lambda, point, normal, d_r12, d_rot1, d_rot2] = pw85_contact_derivatives (x, y)
%
%  The forces and torques of an energy U(μ²) follow from the results. If r12 = 0, the
%  derivatives are zero, and the point and the normal are NaN.
%
%  For ellipsoids in three dimensions.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12          3 columns.
%  q1, q2       6 columns each.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi]: see pw85_from_matgeom.
%
%  mu2, lambda  The results of pw85_contact(). 1 column each.
%  point       Contact points relative to the centres of the first ellipsoids. 3 columns.
%  normal      Unit normals. 3 columns.
%  d_r12       ∂μ²/∂r12. 3 columns.
%  d_rot1, d_rot2  Derivatives with respect to rotations, as for pw85_contact_torque(). 3
%              columns each.
%
%  The function of the C API is pw85_contact_derivatives_batch().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [mu2, lambda, point, normal, d_r12, d_rot1, d_rot2] = pw85_mex ('contact_derivatives', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:7}] = pw85_contact_derivatives (r2 - r1, q1, q2);
%! [b{1:7}] = pw85_contact_derivatives (x, y);
%! assert (b, a);
%! [b{1:7}] = pw85_contact_derivatives (x, y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

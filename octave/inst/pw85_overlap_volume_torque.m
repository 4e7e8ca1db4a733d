function [d_rot1, d_rot2] = pw85_overlap_volume_torque (varargin)
%pw85_overlap_volume_torque  Computes the derivatives of the volume V of the intersection with
%  respect to rotations of the ellipsoids.
%
%   [d_rot1, d_rot2] = pw85_overlap_volume_torque (r12, q1, q2)
%   [d_rot1, d_rot2] = pw85_overlap_volume_torque (x, y)
%
%  If an ellipsoid rotates about its own centre by a small rotation vector ω, V changes by
%  d_rot·ω. An energy U(V) exerts the torque -U'(V) d_rot on the ellipsoid. With ∂V/∂r12 from
%  pw85_overlap_volume_gradient(), d_rot1 + d_rot2 + r12 × ∂V/∂r12 = 0.
%
%  The derivatives are the axial vectors of 2 q1 G1 and 2 q2 G2, where G is the matrix of the
%  derivatives ∂V/∂q. Each component is a sum of products 2 q_ij G_jk. The error of a component
%  is below the sum of 2 |q_ij| times the bound on the error of G_jk.
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
%  d_rot1, d_rot2  Derivatives for ellipsoids 1 and 2, per radian. 3 columns each.
%
%  The function of the C API is pw85_overlap_volume_torque().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [d_rot1, d_rot2] = pw85_mex ('overlap_volume_torque', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:2}] = pw85_overlap_volume_torque (r2 - r1, q1, q2);
%! [b{1:2}] = pw85_overlap_volume_torque (x, y);
%! assert (b, a);
%! [b{1:2}] = pw85_overlap_volume_torque (x, y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

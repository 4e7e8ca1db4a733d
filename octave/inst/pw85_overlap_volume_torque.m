function [d_rot1, d_rot2] = pw85_overlap_volume_torque (varargin)
%pw85_overlap_volume_torque  Derivatives of the volume of the common part with respect to
%  rotations.
%
%   [d_rot1, d_rot2] = pw85_overlap_volume_torque (r12, q1, q2)
%   [d_rot1, d_rot2] = pw85_overlap_volume_torque (x, y)
%
%  For a rotation of an ellipsoid about its own centre by the small vector ω, dV = d_rot·ω. The
%  torque of an energy U(V) is -U'(V) d_rot. With ∂V/∂r12 from pw85_overlap_volume_gradient(),
%  d_rot1 + d_rot2 + r12 × ∂V/∂r12 = 0. The derivatives are the axial vectors of 2 q1 G1 and 2
%  q2 G2 with the matrices G of ∂V/∂q, and their errors follow from those of G: each is below
%  twice the sum of |q_ij| times the bound for G_jk over the products that the vector is made
%  of.
%
%  For ellipsoids in three dimensions.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         From the centre of ellipsoid 1 to that of ellipsoid 2. 3 columns.
%  q1          Forms of the ellipsoids, in the square of the unit of r12. 6 columns.
%  q2          Forms of the ellipsoids, in the square of the unit of r12. 6 columns.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi]: see pw85_from_matgeom.
%
%  d_rot1      Per radian, for ellipsoids 1 and 2. 3 columns.
%  d_rot2      Per radian, for ellipsoids 1 and 2. 3 columns.
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

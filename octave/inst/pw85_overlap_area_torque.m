function [d_rot1, d_rot2] = pw85_overlap_area_torque (varargin)
%pw85_overlap_area_torque  Computes the derivatives of the area of the intersection with respect
%  to the angles of both ellipses.
%
%   [d_rot1, d_rot2] = pw85_overlap_area_torque (r12, q1, q2)
%   [d_rot1, d_rot2] = pw85_overlap_area_torque (x, y)
%
%  See pw85_overlap_volume_torque(). Angles are counter-clockwise.
%
%  For ellipses.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         Vector from the centre of ellipse 1 to that of ellipse 2. 2 columns.
%  q1, q2      Forms (xx, xy, yy) of the ellipses, in the square of the unit of r12. 3 columns
%              each.
%  x, y        Rows of matGeom, [xc yc a b theta]: see pw85_from_matgeom.
%
%  d_rot1, d_rot2  Per radian. 1 column each.
%
%  The function of the C API is pw85_overlap_area_torque_2d().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [d_rot1, d_rot2] = pw85_mex ('overlap_area_torque', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 3 1 0], [5.5 0.5 3 1 30; 5.9 0.1 3 1 10; 3.95 0.1 1 0.5 9]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:2}] = pw85_overlap_area_torque (r2 - r1, q1, q2);
%! [b{1:2}] = pw85_overlap_area_torque (x, y);
%! assert (b, a);
%! [b{1:2}] = pw85_overlap_area_torque (x, y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

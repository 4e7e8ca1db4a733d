function [d_r12, d_q1, d_q2] = pw85_overlap_area_gradient (varargin)
%pw85_overlap_area_gradient  Computes the derivatives of the area of the intersection of two
%  ellipses; see pw85_overlap_volume_gradient().
%
%   [d_r12, d_q1, d_q2] = pw85_overlap_area_gradient (r12, q1, q2)
%   [d_r12, d_q1, d_q2] = pw85_overlap_area_gradient (x, y)
%
%  The bounds on the errors are those of pw85_overlap_volume_gradient(), with areas instead of
%  volumes.
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
%  d_r12       ∂A/∂r12; its negative is the derivative with respect to the centre of ellipse 1.
%              2 columns.
%  d_q1, d_q2  Derivatives with respect to the stored entries of q1 and q2 (a stored
%              off-diagonal entry is two entries of the matrix). 3 columns each.
%
%  The function of the C API is pw85_overlap_area_gradient_2d().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [d_r12, d_q1, d_q2] = pw85_mex ('overlap_area_gradient', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 3 1 0], [5.5 0.5 3 1 30; 5.9 0.1 3 1 10; 3.95 0.1 1 0.5 9]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:3}] = pw85_overlap_area_gradient (r2 - r1, q1, q2);
%! [b{1:3}] = pw85_overlap_area_gradient (x, y);
%! assert (b, a);
%! [b{1:3}] = pw85_overlap_area_gradient (x, y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

function [distance, point1, point2, normal] = pw85_signed_distance_geometry (varargin)
%pw85_signed_distance_geometry  Computes the signed distance of two ellipsoids, as
%  pw85_signed_distance() does, with the points where it is reached and the normal there.
%
%   [distance, point1, point2, normal] = pw85_signed_distance_geometry (r12, q1, q2)
%   [distance, point1, point2, normal] = pw85_signed_distance_geometry (x, y)
%
%  For ellipses and ellipsoids.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         Vector from the centre of ellipsoid 1 to that of ellipsoid 2. 3 or 2 columns.
%  q1, q2      Forms of the ellipsoids, in the square of the unit of r12. 6 or 3 columns each.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi] or, in the plane, [xc yc a b
%              theta]: see pw85_from_matgeom.
%
%  distance    The signed distance, in the unit of r12. 1 column.
%  point1, point2  The closest points of ellipsoids 1 and 2 if they are apart, or the deepest
%              points if they overlap, both relative to the centre of ellipsoid 1. The outward
%              normals there are opposite, and along point2 - point1. 3 or 2 columns each.
%  normal      Unit vector, outward from ellipsoid 1 and into ellipsoid 2: the derivative of the
%              signed distance with respect to r12. 3 or 2 columns.
%
%  The function of the C API is pw85_signed_distance_geometry().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [distance, point1, point2, normal] = pw85_mex ('signed_distance_geometry', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:4}] = pw85_signed_distance_geometry (r2 - r1, q1, q2);
%! [b{1:4}] = pw85_signed_distance_geometry (x, y);
%! assert (b, a);
%! [b{1:4}] = pw85_signed_distance_geometry (x, y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

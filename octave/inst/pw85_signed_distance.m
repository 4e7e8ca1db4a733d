function [distance, point1, point2] = pw85_signed_distance (varargin)
%pw85_signed_distance  Computes the signed distance of two ellipsoids, and the points where it
%  is reached.
%
%   [distance, point1, point2] = pw85_signed_distance (r12, q1, q2)
%   [distance, point1, point2] = pw85_signed_distance (x, y)
%
%  The signed distance is the distance if the ellipsoids are apart, and minus the penetration
%  depth if they overlap.
%
%  In both cases the signed distance is the largest value of n·r12 - α - β over unit vectors n,
%  with the half-widths α and β of the ellipsoids along n. It is a continuous, convex function
%  of r12, whose gradient is a unit vector. The sign is exact: positive only if the ellipsoids
%  are apart, and negative only if they overlap, as pw85_overlap() decides.
%
%  If the ellipsoids overlap, moving ellipsoid 2 by point1 - point2 is the shortest translation
%  that separates them. If several translations have this length, the result is one of them.
%
%  Errors and times are as for pw85_distance() if the ellipsoids are apart, and as for
%  pw85_penetration() if they overlap. If the ellipsoids overlap, point2 - point1 differs from
%  distance times the unit normal by less than 2¹⁸ u (|r12| + |point1| + |r12 - point2|), with u
%  = 2⁻⁵³. This bound holds if the minimum is isolated, for aspect ratios up to 10³.
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
%
%  The function of the C API is pw85_signed_distance().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [distance, point1, point2] = pw85_mex ('signed_distance', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:3}] = pw85_signed_distance (r2 - r1, q1, q2);
%! [b{1:3}] = pw85_signed_distance (x, y);
%! assert (b, a);
%! [b{1:3}] = pw85_signed_distance (x, y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

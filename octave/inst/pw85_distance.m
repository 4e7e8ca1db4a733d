function [distance, point1, point2] = pw85_distance (varargin)
%pw85_distance  Distance of the surfaces of two ellipsoids, and the points where they are
%  closest.
%
%   [distance, point1, point2] = pw85_distance (r12, q1, q2)
%   [distance, point1, point2] = pw85_distance (x, y)
%
%  The error of the distance is below 8 u Σ, with u = 2⁻⁵³ and Σ = Σ|n_i r12_i| + Σ|n_i q1_ij
%  n_j|/(2α) + Σ|n_i q2_ij n_j|/(2β), the sums over all i and j. Rounding the data entry by
%  entry can change the distance by u Σ. Here n is the unit normal, and α and β are the
%  half-widths of the ellipsoids along it. The answer can be checked independently: any unit
%  vector n gives a lower bound n·r12 - α - β of the distance, and any two points of the
%  ellipsoids give an upper bound. distance is the lower bound for the normal that
%  pw85_distance_derivatives() returns, and |point2 - point1| is an upper bound.
%
%  The vector point2 - point1 differs from distance times n by less than 2¹⁸ u (|r12| + |point1|
%  + |r12 - point2|), and |point2 - point1| differs from distance by no more than that. The
%  points are the closest points of a pair whose r12 differs by no more than that. The distance
%  of each point from the surface is below 2¹⁸ u times the longest semi-axis of its ellipsoid,
%  plus the rounding error u |point2| of its coordinates.
%
%  For ellipses and ellipsoids.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         From the centre of ellipsoid 1 to that of ellipsoid 2. 3 or 2 columns.
%  q1          Forms of the ellipsoids, in the square of the unit of r12. 6 or 3 columns.
%  q2          Forms of the ellipsoids, in the square of the unit of r12. 6 or 3 columns.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi] or, in the plane, [xc yc a b
%              theta]: see pw85_from_matgeom.
%
%  distance    The distance, in the unit of r12; zero if the ellipsoids overlap, as
%              pw85_overlap() decides. 1 column.
%  point1      The closest points of ellipsoids 1 and 2, both relative to the centre of
%              ellipsoid 1; NaN if the ellipsoids overlap. 3 or 2 columns.
%  point2      The closest points of ellipsoids 1 and 2, both relative to the centre of
%              ellipsoid 1; NaN if the ellipsoids overlap. 3 or 2 columns.
%
%  The function of the C API is pw85_distance().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [distance, point1, point2] = pw85_mex ('distance', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:3}] = pw85_distance (r2 - r1, q1, q2);
%! [b{1:3}] = pw85_distance (x, y);
%! assert (b, a);
%! [b{1:3}] = pw85_distance (x, y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

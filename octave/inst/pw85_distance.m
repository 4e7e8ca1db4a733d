function [distance, point1, point2] = pw85_distance (varargin)
%pw85_distance  Computes the distance of the surfaces of two ellipsoids, and the points where
%  they are closest.
%
%   [distance, point1, point2] = pw85_distance (r12, q1, q2)
%   [distance, point1, point2] = pw85_distance (x, y)
%
%  The distance is the largest value of n·r12 - α - β over unit vectors n, with the half-widths
%  α and β of the ellipsoids along n. Its error is below 8 u Σ, with u = 2⁻⁵³. Here Σ = Σ|n_i
%  r12_i| + Σ|n_i q1_ij n_j|/(2α) + Σ|n_i q2_ij n_j|/(2β), summed over all i and j, with n, α
%  and β at the closest points. Rounding the data entry by entry can change the distance by u Σ.
%
%  A program can verify the result by a lower and an upper bound. For any unit vector n, n·r12 -
%  α - β is a lower bound of the distance; distance is this bound for the normal of
%  pw85_distance_derivatives(). The distance between any point of ellipsoid 1 and any point of
%  ellipsoid 2 is an upper bound, such as |point2 - point1|.
%
%  Let ε = 2¹⁸ u (|r12| + |point1| + |r12 - point2|). The vector point2 - point1 differs from
%  distance times n by less than ε, and the length of this vector differs from distance by at
%  most ε. The points are the exact closest points for a pair whose r12 differs by at most ε.
%  Each point is off its surface by less than 2¹⁸ u times the longest semi-axis of its
%  ellipsoid, plus the rounding error u |point2| of its coordinates.
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
%  distance    The distance, in the unit of r12; zero if the ellipsoids overlap, as
%              pw85_overlap() decides. 1 column.
%  point1, point2  The closest points of ellipsoids 1 and 2, both relative to the centre of
%              ellipsoid 1; NaN if the ellipsoids overlap. 3 or 2 columns each.
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

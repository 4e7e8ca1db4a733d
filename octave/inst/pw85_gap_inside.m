function [gap, point1, point2, normal] = pw85_gap_inside (varargin)
%pw85_gap_inside  Computes the least gap between the surface of ellipsoid 1 and an ellipsoid 2
%  inside it.
%
%   [gap, point1, point2, normal] = pw85_gap_inside (r12, q1, q2)
%   [gap, point1, point2, normal] = pw85_gap_inside (x, y)
%
%  Ellipsoid 2 can move by the gap in any direction without leaving ellipsoid 1. The gap is the
%  smallest value of α - β - n·r12 over unit vectors n, with the half-widths α and β of
%  ellipsoids 1 and 2 along n. This function of n may have several local minima. The library
%  proves that its result is the global minimum. If several directions give the same value, the
%  result is one of them.
%
%  gap is the value of α - β - n·r12 for the returned normal n, up to a few roundings. If the
%  minima are isolated, no other direction has a value that is smaller by more than 128 u α (1 +
%  α/β), with u = 2⁻⁵³ and α and β along the returned normal. If the minima are not isolated, as
%  for spheroids with a common axis, another direction may have a value that is smaller by up to
%  2⁻²⁰ of the gap (2⁻⁴⁰ in two dimensions).
%
%  The time is 50 to 300 times that of pw85_contact() if the minima are isolated. Otherwise it
%  is up to a few tenths of a second.
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
%  gap         The gap, in the unit of r12; zero if the ellipsoids touch, or if ellipsoid 2 is
%              not inside ellipsoid 1, as pw85_contains() decides. 1 column.
%  point1, point2  The closest points of the surfaces of ellipsoids 1 and 2, both relative to
%              the centre of ellipsoid 1; NaN if ellipsoid 2 is not inside. 3 or 2 columns each.
%  normal      Outward unit normal of both ellipsoids at these points, from point2 to point1;
%              the derivative of the gap with respect to r12 is its negative; NaN if ellipsoid 2
%              is not inside. 3 or 2 columns.
%
%  The function of the C API is pw85_gap_inside().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [gap, point1, point2, normal] = pw85_mex ('gap_inside', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:4}] = pw85_gap_inside (r2 - r1, q1, q2);
%! [b{1:4}] = pw85_gap_inside (x, y);
%! assert (b, a);
%! [b{1:4}] = pw85_gap_inside (x, y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

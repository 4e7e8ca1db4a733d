function [mu2, point] = pw85_containment (varargin)
%pw85_containment  Computes the least factor by which ellipsoid 1 must be scaled about its
%  centre to contain ellipsoid 2, and a point where the two then touch.
%
%   [mu2, point] = pw85_containment (r12, q1, q2)
%   [mu2, point] = pw85_containment (x, y)
%
%  The square of the factor is the largest value of xᵀ q1⁻¹ x over the points x of ellipsoid 2,
%  relative to the centre of ellipsoid 1. It is at most 1 if ellipsoid 2 is inside ellipsoid 1;
%  pw85_contains() decides this exactly.
%
%  The relative error of the square is below 16 u c, with u = 2⁻⁵³. If each entry of r12, q1 and
%  q2 changes by at most a fraction ε of itself, the square changes by at most a fraction ε c,
%  to first order in ε. A lower and an upper bound prove the result.
%
%  For ellipses and ellipsoids.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         Vector from the centre of ellipsoid 1 to that of ellipsoid 2; it may be zero. 3
%              or 2 columns.
%  q1, q2      Forms of the ellipsoids, in the square of the unit of r12. 6 or 3 columns each.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi] or, in the plane, [xc yc a b
%              theta]: see pw85_from_matgeom.
%
%  mu2         Square of the factor. 1 column.
%  point       A point of contact on the surface of ellipsoid 2, relative to the centre of
%              ellipsoid 1. If r12 = 0, there are several such points, and the result is one of
%              them. The same holds for a short r12 that has no component along the longest
%              semi-axis of ellipsoid 2, after the linear map that makes ellipsoid 1 a unit
%              ball. 3 or 2 columns.
%
%  The function of the C API is pw85_containment().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [mu2, point] = pw85_mex ('containment', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:2}] = pw85_containment (r2 - r1, q1, q2);
%! [b{1:2}] = pw85_containment (x, y);
%! assert (b, a);
%! [b{1:2}] = pw85_containment (x, y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

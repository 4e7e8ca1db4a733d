function [depth, direction] = pw85_penetration (varargin)
%pw85_penetration  Computes the penetration depth of two ellipsoids that overlap, and its
%  direction.
%
%   [depth, direction] = pw85_penetration (r12, q1, q2)
%   [depth, direction] = pw85_penetration (x, y)
%
%  The depth is the length of the shortest translation of ellipsoid 2 that separates them.
%
%  The depth is the smallest value of α + β - n·r12 over unit vectors n, with the half-widths α
%  and β of the ellipsoids along n. This function of n may have several local minima. The
%  library proves that its result is the global minimum. If several directions give the same
%  value, the result is one of them.
%
%  depth is the value of α + β - n·r12 for the returned direction n. Its error is below 8 u Σ,
%  with u = 2⁻⁵³ and Σ as for pw85_distance(). No other direction has a value that is smaller by
%  more than 32 u Σ, where Σ is the larger one of the two directions.
%
%  For more than 90 % of random pairs a simple sufficient condition proves the minimum, and the
%  time is 3 to 8 times that of pw85_contact(). For the other pairs the time is 10 to 60 times
%  that of pw85_contact(), and about 1000 times if the minimum is not isolated.
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
%  depth       The depth, in the unit of r12; zero if the ellipsoids do not overlap, as
%              pw85_overlap() decides. 1 column.
%  direction   Unit vector along which ellipsoid 2 must move; NaN if the ellipsoids do not
%              overlap. 3 or 2 columns.
%
%  The function of the C API is pw85_penetration().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [depth, direction] = pw85_mex ('penetration', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:2}] = pw85_penetration (r2 - r1, q1, q2);
%! [b{1:2}] = pw85_penetration (x, y);
%! assert (b, a);
%! [b{1:2}] = pw85_penetration (x, y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

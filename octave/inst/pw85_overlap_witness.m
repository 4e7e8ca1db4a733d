function [overlap, lambda, point] = pw85_overlap_witness (varargin)
%pw85_overlap_witness  Tests whether two ellipsoids overlap, as pw85_overlap() does, and returns
%  a number or a point that proves the answer.
%
%   [overlap, lambda, point] = pw85_overlap_witness (r12, q1, q2)
%   [overlap, lambda, point] = pw85_overlap_witness (x, y)
%
%  If the ellipsoids are apart, the proof is a double λ with f(λ) > 1. The function finds such a
%  double if there is one. If the ellipsoids overlap, the proof is a point inside both. The
%  function searches for this point near the contact point of the ellipsoids scaled by μ; the
%  search may fail if 1 - μ² is below 1e-13. For tangent ellipsoids there is no proof: λ and
%  point are then NaN. A proof is exact for the given doubles, and a program can verify it in
%  rational arithmetic.
%
%  For ellipsoids in three dimensions.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         Vector from the centre of ellipsoid 1 to that of ellipsoid 2. 3 columns.
%  q1, q2      Forms of the ellipsoids, in the square of the unit of r12. 6 columns each.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi]: see pw85_from_matgeom.
%
%  overlap     1 or 0. 1 column.
%  lambda      λ from 0 to 1, with f(λ) > 1, if the ellipsoids are apart; otherwise NaN. 1
%              column.
%  point       A point inside both ellipsoids and on neither surface, relative to the centre of
%              ellipsoid 1, if they overlap; otherwise NaN. 3 columns.
%
%  The function of the C API is pw85_overlap_witness().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [overlap, lambda, point] = pw85_mex ('overlap_witness', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:3}] = pw85_overlap_witness (r2 - r1, q1, q2);
%! [b{1:3}] = pw85_overlap_witness (x, y);
%! assert (b, a);
%! [b{1:3}] = pw85_overlap_witness (x, y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

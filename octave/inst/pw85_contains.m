function contains = pw85_contains (varargin)
%pw85_contains  Tests whether ellipsoid 2 is inside ellipsoid 1.
%
%   contains = pw85_contains (r12, q1, q2)
%   contains = pw85_contains (x, y)
%
%  Ellipsoid 2 may touch the surface of ellipsoid 1 from inside.
%
%  The answer is exact for the numbers given. Every ellipsoid contains itself.
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
%  contains    true or false.
%
%  The function of the C API is pw85_contains().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  contains = pw85_mex ('contains', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:1}] = pw85_contains (r2 - r1, q1, q2);
%! [b{1:1}] = pw85_contains (x, y);
%! assert (b, a);
%! [b{1:1}] = pw85_contains (x, y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

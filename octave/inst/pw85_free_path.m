function t = pw85_free_path (varargin)
%pw85_free_path  Computes the free path of ellipsoid 1: how far it may move until it touches
%  ellipsoid 2.
%
%   t = pw85_free_path (r12, q1, q2, direction [, t_max])
%   t = pw85_free_path (x, y, direction [, t_max])
%
%  Ellipsoid 1 moves by t times direction, and the separation is then r12 - t direction. If the
%  ellipsoids do not overlap at t = 0, they do not overlap at the returned t or before: rounding
%  errors make t smaller, never larger. At the returned t the ellipsoids touch up to rounding:
%  μ² <= 1 + 80 u S, with u = 2⁻⁵³ and S as for pw85_first_contact().
%
%  t is 0 if the ellipsoids overlap at t = 0, or touch and do not separate. If they separate, an
%  overlap of at most 128 times the bound on the rounding error of μ² is ignored.
%
%  For ellipsoids in three dimensions.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         Vector from the centre of ellipsoid 1 to that of ellipsoid 2. 3 columns.
%  q1, q2      Forms of the ellipsoids, in the square of the unit of r12. 6 columns each.
%  direction   Of any length; not zero. 3 columns.
%  t_max       The end of the path, as a multiple of direction: a length if direction is a unit
%              vector; >= 0; may be infinite. 1 column. Infinite if it is missing.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi]: see pw85_from_matgeom.
%
%  t           The free path, in the unit of t_max, from 0 to t_max, or infinity if there is no
%              contact on the path. 1 column.
%
%  The function of the C API is pw85_free_path().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  t = pw85_mex ('free_path', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:1}] = pw85_free_path (r2 - r1, q1, q2, [1 0 0], Inf);
%! [b{1:1}] = pw85_free_path (x, y, [1 0 0], Inf);
%! assert (b, a);
%! [b{1:1}] = pw85_free_path (x, y(end,:), [1 0 0], Inf);
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

function distance = pw85_closest_approach (varargin)
%pw85_closest_approach  Computes the distance of closest approach of two ellipsoids along a
%  direction.
%
%   distance = pw85_closest_approach (direction, q1, q2)
%   distance = pw85_closest_approach (x, y, direction)
%
%  This is the distance of the centres at which the ellipsoids touch from outside, if their
%  orientations are fixed and the centres are on a line along d = direction. It is |d|/μ(d),
%  where μ(d) is μ for r12 = d.
%
%  For ellipses and ellipsoids.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  direction   From centre 1 to centre 2, of any length; not zero. 3 or 2 columns.
%  q1, q2      Forms of the ellipsoids. 6 or 3 columns each.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi] or, in the plane, [xc yc a b
%              theta]: see pw85_from_matgeom.
%
%  distance    Distance of the centres, in the unit of the semi-axes. 1 column.
%
%  The function of the C API is pw85_closest_approach().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  distance = pw85_mex ('closest_approach', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:1}] = pw85_closest_approach ([1 0 0], q1, q2);
%! [b{1:1}] = pw85_closest_approach (x, y, [1 0 0]);
%! assert (b, a);
%! [b{1:1}] = pw85_closest_approach (x, y(end,:), [1 0 0]);
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

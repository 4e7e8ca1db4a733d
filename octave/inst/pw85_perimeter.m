function perimeter = pw85_perimeter (varargin)
%pw85_perimeter  Computes the perimeter of an ellipse, 8 R_G(0, a², b²), with Carlson's integral
%  R_G.
%
%   perimeter = pw85_perimeter (q)
%   perimeter = pw85_perimeter (x)
%
%  For ellipses.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  q           Form of the ellipse. 3 columns.
%  x           Rows of matGeom, [xc yc a b theta]: see pw85_from_matgeom.
%
%  perimeter    1 column.
%
%  The function of the C API is pw85_perimeter_2d().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  perimeter = pw85_mex ('perimeter', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 3 1 0], [5.5 0.5 3 1 30; 5.9 0.1 3 1 10; 3.95 0.1 1 0.5 9]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:1}] = pw85_perimeter (q2);
%! [b{1:1}] = pw85_perimeter (y);
%! assert (b, a);
%! [b{1:1}] = pw85_perimeter (y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

function area = pw85_area (varargin)
%pw85_area  Computes the area of an ellipse, π √det q.
%
%   area = pw85_area (q)
%   area = pw85_area (x)
%
%  The bound on the error is that of pw85_volume().
%
%  For ellipses.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  q           Form of the ellipse. 3 columns.
%  x           Rows of matGeom, [xc yc a b theta]: see pw85_from_matgeom.
%
%  area        The area, in the square of the unit of length. 1 column.
%
%  The function of the C API is pw85_area_2d().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  area = pw85_mex ('area', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 3 1 0], [5.5 0.5 3 1 30; 5.9 0.1 3 1 10; 3.95 0.1 1 0.5 9]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:1}] = pw85_area (q2);
%! [b{1:1}] = pw85_area (y);
%! assert (b, a);
%! [b{1:1}] = pw85_area (y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

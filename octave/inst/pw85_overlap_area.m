function area = pw85_overlap_area (varargin)
%pw85_overlap_area  Computes the area of the intersection of two ellipses; see
%  pw85_overlap_volume().
%
%   area = pw85_overlap_area (r12, q1, q2)
%   area = pw85_overlap_area (x, y)
%
%  The bound on the error is that of pw85_overlap_volume(), with areas instead of volumes.
%
%  For ellipses.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         Vector from the centre of ellipse 1 to that of ellipse 2; it may be zero. 2
%              columns.
%  q1, q2      Forms (xx, xy, yy) of the ellipses, in the square of the unit of r12. 3 columns
%              each.
%  x, y        Rows of matGeom, [xc yc a b theta]: see pw85_from_matgeom.
%
%  area        The area, in the square of the unit of length. 1 column.
%
%  The function of the C API is pw85_overlap_area_2d().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  area = pw85_mex ('overlap_area', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 3 1 0], [5.5 0.5 3 1 30; 5.9 0.1 3 1 10; 3.95 0.1 1 0.5 9]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:1}] = pw85_overlap_area (r2 - r1, q1, q2);
%! [b{1:1}] = pw85_overlap_area (x, y);
%! assert (b, a);
%! [b{1:1}] = pw85_overlap_area (x, y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

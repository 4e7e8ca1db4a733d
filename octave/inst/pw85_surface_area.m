function area = pw85_surface_area (varargin)
%pw85_surface_area  Computes the surface area of an ellipsoid, 4π abc R_G(1/a², 1/b², 1/c²),
%  with Carlson's integral R_G.
%
%   area = pw85_surface_area (q)
%   area = pw85_surface_area (x)
%
%  For ellipsoids in three dimensions.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  q           Form of the ellipsoid. 6 columns.
%  x           Rows of matGeom, [xc yc zc a b c phi theta psi]: see pw85_from_matgeom.
%
%  area         1 column.
%
%  The function of the C API is pw85_surface_area().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  area = pw85_mex ('surface_area', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:1}] = pw85_surface_area (q2);
%! [b{1:1}] = pw85_surface_area (y);
%! assert (b, a);
%! [b{1:1}] = pw85_surface_area (y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

function sign = pw85_compare (varargin)
%pw85_compare  Compares μ² with a number mu2 >= 0, and returns the sign of μ² - mu2.
%
%   sign = pw85_compare (r12, q1, q2, mu2)
%   sign = pw85_compare (x, y, mu2)
%
%  The sign is exact for the numbers given. pw85_overlap() is the case mu2 = 1. A bound on the
%  error of μ² decides almost all pairs, and exact arithmetic decides the others.
%
%  For ellipsoids in three dimensions.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         Vector from the centre of ellipsoid 1 to that of ellipsoid 2. 3 columns.
%  q1, q2      Forms of the ellipsoids, in the square of the unit of r12. 6 columns each.
%  mu2         The number to compare with; >= 0; may be infinite. 1 column.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi]: see pw85_from_matgeom.
%
%  sign        -1 if μ² < mu2, 0 if they are equal, 1 if μ² > mu2. 1 column.
%
%  The function of the C API is pw85_compare().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  sign = pw85_mex ('compare', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:1}] = pw85_compare (r2 - r1, q1, q2, 1);
%! [b{1:1}] = pw85_compare (x, y, 1);
%! assert (b, a);
%! [b{1:1}] = pw85_compare (x, y(end,:), 1);
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

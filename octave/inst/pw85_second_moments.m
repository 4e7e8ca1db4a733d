function moments = pw85_second_moments (varargin)
%pw85_second_moments  Computes the mean of x xᵀ over a uniform solid ellipsoid, about its
%  centre: q/5.
%
%   moments = pw85_second_moments (q)
%   moments = pw85_second_moments (x)
%
%  The error of each entry is below u times the entry, with u = 2⁻⁵³.
%
%  For ellipses and ellipsoids.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  q           Form of the ellipsoid. 6 or 3 columns.
%  x           Rows of matGeom, [xc yc zc a b c phi theta psi] or, in the plane, [xc yc a b
%              theta]: see pw85_from_matgeom.
%
%  moments      6 or 3 columns.
%
%  The function of the C API is pw85_second_moments().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  moments = pw85_mex ('second_moments', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:1}] = pw85_second_moments (q2);
%! [b{1:1}] = pw85_second_moments (y);
%! assert (b, a);
%! [b{1:1}] = pw85_second_moments (y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

function volume = pw85_volume (varargin)
%pw85_volume  Computes the volume of an ellipsoid, (4/3)π √det q.
%
%   volume = pw85_volume (q)
%   volume = pw85_volume (x)
%
%  The relative error is below 2⁻⁵² for aspect ratios below 10⁷. For a larger aspect ratio k it
%  is below 2⁻⁵² k²/10¹⁴.
%
%  For ellipsoids in three dimensions.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  q           Form of the ellipsoid. 6 columns.
%  x           Rows of matGeom, [xc yc zc a b c phi theta psi]: see pw85_from_matgeom.
%
%  volume      The volume, in the third power of the unit of length. 1 column.
%
%  The function of the C API is pw85_volume().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  volume = pw85_mex ('volume', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:1}] = pw85_volume (q2);
%! [b{1:1}] = pw85_volume (y);
%! assert (b, a);
%! [b{1:1}] = pw85_volume (y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

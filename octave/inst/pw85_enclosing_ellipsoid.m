function [center, q, excess] = pw85_enclosing_ellipsoid (varargin)
%pw85_enclosing_ellipsoid  Ellipsoid of least volume around points, with a proof.
%
%   [center, q, excess] = pw85_enclosing_ellipsoid (points [, tolerance])
%
%  points      A row for each point; 1 to 16 columns, fewer than rows.
%  tolerance   Upper bound of the excess that is asked for; 1e-6 if it is missing.
%
%  center      The centre, a row.
%  q           The form, a row: the upper triangle of the matrix row by row. Every point is
%              inside, in exact arithmetic.
%  excess      The volume is at most 1 + excess times the least one.
%
%  The function of the C API is pw85_enclosing_ellipsoid().

% SPDX-License-Identifier: BSD-3-Clause
  [center, q, excess] = pw85_mex ('enclosing_ellipsoid', varargin{:});
end

%!test # a square has the circle through its corners
%! [center, q, excess] = pw85_enclosing_ellipsoid ([1 1; 1 -1; -1 1; -1 -1] + 3, 1e-9);
%! assert (center, [3 3], 1e-8);
%! assert (q, [2 0 2], 1e-8);
%! assert (excess <= 1e-9);
%!test # a cube of four dimensions
%! corners = dec2bin (0:15) - '0';
%! [center, q] = pw85_enclosing_ellipsoid (2 * corners - 1);
%! assert (q, [4 0 0 0 4 0 0 4 0 4], 1e-5);
%!error <points: must have more rows than columns> pw85_enclosing_ellipsoid ([0 0; 1 1])
%!error <points: must not be in a plane or nearly so> pw85_enclosing_ellipsoid ([1 1; 2 2; 3 3; 4 4])
%!error <points, row 2: must be finite> pw85_enclosing_ellipsoid ([0 0; NaN 1; 1 0])
%!error <points: must have 1 to 16 columns, not 17> pw85_enclosing_ellipsoid (ones (20, 17))
%!error <tolerance: must be one positive number> pw85_enclosing_ellipsoid (eye (3)(:,1:2), 0)
%!error <takes one or two arguments, not 0> pw85_enclosing_ellipsoid ()

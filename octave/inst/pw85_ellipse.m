function q = pw85_ellipse (varargin)
%pw85_ellipse  Computes the quadratic form (xx, xy, yy) of an ellipse.
%
%   q = pw85_ellipse (a, b, angle)
%
%  For ellipses.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  a, b        Semi-axes, whose squares are in the range of double; > 0. 1 column each.
%  angle       From the x axis to the first semi-axis, counter-clockwise, in radians. 1 column.
%
%  q           The form. 3 columns.
%
%  The function of the C API is pw85_ellipse().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  q = pw85_mex ('ellipse', varargin{:});
end

%!test
%! q = pw85_ellipse ([3; 2], 1, 0.5);
%! assert (all (q(:,[1 end])(:) > 0));

function half_widths = pw85_bounding_boxes (varargin)
%pw85_bounding_boxes  Computes the bounding boxes of n ellipsoids, with sides along the
%  coordinate axes.
%
%   half_widths = pw85_bounding_boxes (q)
%   half_widths = pw85_bounding_boxes (x)
%
%  For ellipsoids in three dimensions.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  q            6 columns.
%  x           Rows of matGeom, [xc yc zc a b c phi theta psi]: see pw85_from_matgeom.
%
%  half_widths  √Qxx, √Qyy, √Qzz, in the unit of the semi-axes. 3 columns.
%
%  The function of the C API is pw85_bounding_boxes().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  half_widths = pw85_mex ('bounding_boxes', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:1}] = pw85_bounding_boxes (q2);
%! [b{1:1}] = pw85_bounding_boxes (y);
%! assert (b, a);
%! [b{1:1}] = pw85_bounding_boxes (y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));

function q = pw85_ellipsoid_quaternion (varargin)
%pw85_ellipsoid_quaternion  Computes the quadratic form of an ellipsoid whose orientation is a
%  quaternion.
%
%   q = pw85_ellipsoid_quaternion (semi_axes, quaternion)
%
%  For ellipsoids in three dimensions.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  semi_axes   Lengths of the principal semi-axes (not diameters), whose squares are in the
%              range of double; > 0. 3 columns.
%  quaternion  (w, x, y, z), scalar first, which rotates the body frame into the space frame; of
%              any length, because the function normalises it; not zero. 4 columns.
%
%  q           The form. 6 columns.
%
%  The function of the C API is pw85_ellipsoid_quaternion().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  q = pw85_mex ('ellipsoid_quaternion', varargin{:});
end

%!test
%! q = pw85_ellipsoid_quaternion ([3 2 1; 4 1 1], [0.9 0.1 0.3 0.2]);
%! assert (all (q(:,[1 end])(:) > 0));

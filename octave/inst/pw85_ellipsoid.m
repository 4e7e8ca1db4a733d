function q = pw85_ellipsoid (varargin)
%pw85_ellipsoid  Computes the quadratic form of an ellipsoid, Q = R diag(semi_axes²) Rᵀ.
%
%   q = pw85_ellipsoid (semi_axes, rotation)
%
%  For ellipsoids in three dimensions.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  semi_axes   Lengths of the principal semi-axes (not diameters), whose squares are in the
%              range of double; > 0. 3 columns.
%  rotation    Row-major matrix R, which takes the body frame to the space frame; its columns
%              are the directions of the semi-axes. Each entry of RᵀR - I must be at most 1e-6
%              in magnitude: single precision is enough. R may be a reflection. 9 columns.
%
%  q           The form. 6 columns.
%
%  The function of the C API is pw85_ellipsoid().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  q = pw85_mex ('ellipsoid', varargin{:});
end

%!test
%! q = pw85_ellipsoid ([3 2 1; 4 1 1], eye (3));
%! assert (all (q(:,[1 end])(:) > 0));

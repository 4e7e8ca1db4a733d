function was = pw85_reproducible (varargin)
%pw85_reproducible  The mode that gives the same bits on every processor and in every language.
%
%   is_on = pw85_reproducible ()
%   was = pw85_reproducible (true)
%   was = pw85_reproducible (false)
%
%  The mode holds for the process.

% SPDX-License-Identifier: BSD-3-Clause
  was = pw85_mex ('reproducible', varargin{:});
end

%!test
%! was = pw85_reproducible (true);
%! assert (pw85_reproducible (was), true);
%! assert (pw85_reproducible (), was);
%!error <on: must be true or false> pw85_reproducible ('on')
%!error <on: must be true or false> pw85_reproducible ([true false])

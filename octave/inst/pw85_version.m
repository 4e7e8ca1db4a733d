function version = pw85_version (varargin)
%pw85_version  Version of the library pw85 that is in use.
%
%   version = pw85_version ()

% SPDX-License-Identifier: BSD-3-Clause
  version = pw85_mex ('version', varargin{:});
end

%!assert (regexp (pw85_version (), '^\d+\.\d+\.\d+'), 1)
%!error <takes no argument> pw85_version (1)

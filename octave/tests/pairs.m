% SPDX-License-Identifier: BSD-3-Clause
% Prints the bits of 1,000 pairs, as r/data-raw/pairs.c does in C.

pw85_reproducible (true);
state = 1;
numbers = zeros (1000, 17);
for k = 1:numel (numbers)
  state = mod (state * 16807, 2147483647);
  numbers(floor ((k - 1) / 17) + 1, mod (k - 1, 17) + 1) = mod (state, 65536) / 65536;
end
body = @(m) pw85_ellipsoid_quaternion (0.25 + 2 * m(:,1:3), m(:,4:7) - 0.5 + [1 0 0 0]);
r12 = 5 * numbers(:,1:3) - 2;
q1 = body (numbers(:,4:10));
q2 = body (numbers(:,11:17));
[mu2, lambda] = pw85_contact (r12, q1, q2);
found = [mu2, lambda, pw85_distance(r12, q1, q2), pw85_overlap_volume(r12, q1, q2)];
digits = reshape (cellstr (num2hex (found(:))), size (found))';
printf ('%s %s %s %s\n', digits{:});
% One by one they are the same, and in any order.
assert (arrayfun (@(k) pw85_contact (r12(k,:), q1(k,:), q2(k,:)), (1:1000)'), mu2);
assert (pw85_overlap_volume (r12(end:-1:1,:), q1(end:-1:1,:), q2(end:-1:1,:)), found(end:-1:1,4));

# SPDX-License-Identifier: BSD-3-Clause
"""``python3 -m pypw85.cli`` is ``pw85``."""

from . import main

main()

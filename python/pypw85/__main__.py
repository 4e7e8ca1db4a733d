# SPDX-License-Identifier: BSD-3-Clause
"""``python3 -m pypw85`` is ``pw85``."""

from .cli import main

main()

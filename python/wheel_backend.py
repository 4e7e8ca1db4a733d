# SPDX-License-Identifier: BSD-3-Clause
"""Build backend: meson-python, told by an older version's own means that only the package goes into the wheel.

Before 0.13, meson-python does not obey ``install = ["--tags=..."]`` of pyproject.toml, and would add the headers, the
reference data and more of the library.
"""

import mesonpy
from mesonpy import build_sdist, build_wheel, get_requires_for_build_sdist, get_requires_for_build_wheel

__all__ = [
    "build_editable",
    "build_sdist",
    "build_wheel",
    "get_requires_for_build_editable",
    "get_requires_for_build_sdist",
    "get_requires_for_build_wheel",
    "prepare_metadata_for_build_editable",
]


def _refuse_editable(*args, **kwargs):
    """Without the hooks for it, pip would pretend that an editable installation succeeded."""
    raise SystemExit(
        "pypw85 has no editable installation: install it without -e, or build it with Meson and add the folder python "
        "of the build folder to PYTHONPATH"
    )


get_requires_for_build_editable = prepare_metadata_for_build_editable = build_editable = _refuse_editable


if tuple(int(part) for part in mesonpy.__version__.split(".")[:2]) < (0, 13):
    _install_plan = mesonpy.Project._install_plan

    def _package_only(project):
        return {
            kind: {file: details for file, details in files.items() if details["tag"] == "python-runtime"}
            for kind, files in _install_plan.fget(project).items()
        }

    mesonpy.Project._install_plan = property(_package_only)

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
]


def get_requires_for_build_editable(config_settings=None):
    """Refuse an editable installation: without this function, pip would pretend that it succeeded."""
    raise SystemExit(
        "pypw85 has no editable installation: install it without -e, or build it with Meson and add the folder python "
        "of the build folder to PYTHONPATH"
    )


build_editable = get_requires_for_build_editable


if tuple(int(part) for part in mesonpy.__version__.split(".")[:2]) < (0, 13):
    _install_plan = mesonpy.Project._install_plan

    def _package_only(project):
        return {
            kind: {file: details for file, details in files.items() if details["tag"] == "python-runtime"}
            for kind, files in _install_plan.fget(project).items()
        }

    mesonpy.Project._install_plan = property(_package_only)

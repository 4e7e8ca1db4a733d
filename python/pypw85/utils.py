# SPDX-License-Identifier: BSD-3-Clause
"""Options of the configuration file of pw85 1.0, for programs that were written for it. Nothing else reads this file."""

from __future__ import annotations

import configparser
import os
import sys
from pathlib import Path

__all__ = ["get_config_dir", "get_config_option"]


def get_config_dir() -> str:
    """The folder where the configuration file is, if there is one.

    As in version 1.0: ``.pypw85`` in the home directory, ``Library/Application Support/pypw85`` there on macOS, ``pypw85`` in
    ``%APPDATA%`` on Windows.
    """
    if sys.platform.startswith("darwin"):
        return str(Path.home() / "Library" / "Application Support" / "pypw85")
    if sys.platform.startswith("win32"):
        return str(Path(os.environ["APPDATA"]) / "pypw85")
    return str(Path.home() / ".pypw85")


def get_config_option(name: str) -> str:
    """An option of the section ``[pw85]`` of the file ``pypw85.cfg``.

    Parameters
    ----------
    name : str
        ``"datadir"``, the folder of the reference data, or anything else that is in the file.

    Raises
    ------
    RuntimeError
        There is no such file.
    KeyError
        There is no such section or option.
    """
    path = Path(get_config_dir(), "pypw85.cfg")
    configuration = configparser.ConfigParser(interpolation=None)
    if not configuration.read(path, encoding="utf-8"):
        raise RuntimeError(f"the configuration file {path} does not exist")
    return configuration["pw85"][name]

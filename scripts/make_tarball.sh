#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Makes the tarball of a release from what is committed, with its checksum: build-dist/meson-dist/pw85-VERSION.tar.gz. It needs git, Meson
# and compilers. The test of the tarball is scripts/test_tarball.sh.
set -eu
cd "$(dirname "$0")/.."
rm -rf build-dist # it may have another version
meson setup build-dist -Dlibrary=false -Dtests=disabled -Dbench=disabled -Dpython=disabled -Dfortran=disabled
meson dist -C build-dist --no-tests --formats gztar

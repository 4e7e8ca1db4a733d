#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Makes the package for `pkg install` in the current folder: pw85-VERSION.tar.gz.
set -eu
sources=$(cd "$(dirname "$0")" && pwd)
version=$(sed -n 's/^Version: //p' "$sources/DESCRIPTION")
tar -chzf "pw85-$version.tar.gz" -C "$sources" --exclude='*.in' --exclude='*.mex' --exclude='*.o' --exclude=.gitignore \
  --exclude=package.sh --exclude=./tests \
  --transform "s|^\.|pw85-$version|" .

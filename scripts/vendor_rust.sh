#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# vendor_rust.sh CRATE copies the sources of the library to CRATE/library, where CRATE is a copy of rust/pw85-sys that is to be packed. In
# the folder of pw85, the feature `vendored` compiles the sources where they are.
set -eu
mkdir "$1/library"
folder=$(cd "$1/library" && pwd)
cd "$(dirname "$0")/.."
cp LICENSE "$folder/../"
cp -R include src "$folder/"
rm -r "$folder/src/gpu" "$folder/src/legacy"

#!/bin/bash -eu
# Not yet run. The flags of OSS-Fuzz already have the sanitizer; the targets link its engine.
meson setup "$WORK/build" -Dfuzz=enabled -Dfuzz_engine="$LIB_FUZZING_ENGINE" -Dgsl=disabled -Dgpu=disabled -Dopenmp=disabled \
  -Dtests=disabled -Dbench=disabled -Dpython=disabled -Dfortran=disabled -Ddefault_library=static -Db_lundef=false
meson compile -C "$WORK/build" fuzz_pw85
cp "$WORK/build/fuzz/fuzz_pw85" "$OUT/"

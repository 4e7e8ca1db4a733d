#!/bin/sh
# Units for aarch64 with and without SVE in one program, headers only, on a processor without SVE: in the Test Anything
# Protocol. Usage: check_aarch64.sh COMPILER QEMU SOURCE_DIR INCLUDE_DIR...
compiler=$1 qemu=$2 source=$3
shift 3
includes=$(printf ' -I%s' "$@")
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT

# build COMMAND...: the compiler with what all units have in common
build() {
  # shellcheck disable=SC2086 # a list of words
  "$compiler" -std=c++20 -O3 -DHEADERS_ONLY $includes "$@" || exit 1
}

# check NUMBER DESCRIPTION WANTED_STATUS ARGUMENT...: of the program
check() {
  number=$1 description=$2 wanted=$3
  shift 3
  "$qemu" -cpu cortex-a72 -L /usr/aarch64-linux-gnu "$work/program" "$@" 2>"$work/messages"
  if [ $? -eq "$wanted" ]; then echo "ok $number $description"; else echo "not ok $number $description"; fi
}

echo 1..3
build -DUNIT=plain_unit -c "$source/unit.cpp" -o "$work/plain.o"
build -march=armv8.2-a+sve -msve-vector-bits=256 -DUNIT=other_unit -c "$source/unit.cpp" -o "$work/other.o"
build "$source/two_units.cpp" "$work/plain.o" "$work/other.o" -o "$work/program"
check 1 "plain first" 0
build "$source/two_units.cpp" "$work/other.o" "$work/plain.o" -o "$work/program"
check 2 "plain last" 0
check 3 "the emulator refuses SVE" 132 other

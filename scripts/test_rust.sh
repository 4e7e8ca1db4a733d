#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Tests the crates for Rust: installs the library into build-rust, with the packages of Debian or Ubuntu that they need, runs the tests and
# the examples of all pages of reference, the linter and the formatter, compares bits with those of a program in C, packs both crates,
# and builds README's program by these packages in a project of its own, with the installed library and with that which pw85-sys compiles.
# No step needs a network.
set -eu
cd "$(dirname "$0")/.."
. scripts/library.sh
# shellcheck disable=SC2086,SC2154 # a list of words
install_library build-rust $rust_packages
# The compiler of the system: its linter does not change between two runs.
[ ! -x /usr/bin/cargo ] || PATH=/usr/bin:$PATH
root=$PWD
work=$root/build-rust/rust
rm -rf "$work" && mkdir -p "$work/vendor"
export CARGO_TARGET_DIR="$PWD/build-rust/target" CARGO_NET_OFFLINE=true
cd rust

echo '+ cargo build without the library'
if PKG_CONFIG_LIBDIR=/nonexistent PKG_CONFIG_PATH='' cargo build -q -p pw85-sys 2>"$work/message"; then exit 1; fi
grep -q 'the library pw85, version [0-9.]* or later, is not installed' "$work/message"

# The programs of the examples are linked with the library of the compiler: this takes half of the time.
libraries="$prefix/lib:$(rustc --print sysroot)/lib"
export PKG_CONFIG_PATH="$prefix/lib/pkgconfig" LD_LIBRARY_PATH="$libraries" RUSTDOCFLAGS='-D warnings -C debuginfo=0 -C prefer-dynamic'
echo '+ cargo fmt, cargo clippy, cargo doc'
cargo fmt --check
cargo clippy -q --all-targets -- -D warnings
cargo clippy -q --all-targets --no-default-features -- -D warnings
cargo doc -q --no-deps
echo '+ cargo test'
cargo test -q >"$work/test.log" 2>&1 || { cat "$work/test.log" && exit 1; }
grep '^test result' "$work/test.log"

echo '+ the flags of Meson'
/usr/bin/python3 -B "$root/tests/install/check_vendored.py" "$root/build-rust"

echo '+ the bits of C'
# shellcheck disable=SC2046 # a list of words
cc -std=c99 ../r/data-raw/pairs.c -o "$work/pairs" $(pkg-config --cflags --libs pw85)
"$work/pairs" >"$work/pairs.txt"
cargo run -q --example pairs | diff - "$work/pairs.txt"

echo '+ cargo package'
cp -R . "$work/crates"
"$root/scripts/vendor_rust.sh" "$work/crates/pw85-sys"
cd "$work/crates"
cat >"$work/vendored.toml" <<END
[source]
crates-io = { replace-with = "vendored" }
vendored = { directory = "$work/vendor" }
END
for crate in pw85-sys pw85; do
  cargo package -q --allow-dirty --config "$work/vendored.toml" -p "$crate" 2>"$work/package.log" || { cat "$work/package.log" && exit 1; }
  mkdir "$work/vendor/$crate"
  tar -xzf "$CARGO_TARGET_DIR/package/$crate-"[0-9]*.crate -C "$work/vendor/$crate" --strip-components=1
  echo '{"files": {}}' >"$work/vendor/$crate/.cargo-checksum.json"
done

echo '+ README, in a project that takes these packages'
mkdir -p "$work/readme/src"
cat >"$work/readme/Cargo.toml" <<'END'
[package]
name = "readme"
version = "0.0.0"
edition = "2021"

[dependencies]
pw85 = "3"

[features]
vendored = ["pw85/vendored"]

[workspace]
END
# shellcheck disable=SC2016 # the marks of blocks
sed -n '/^```rust$/,/^```$/p;/^```text$/q' pw85/README.md | sed '/^```/d' >"$work/readme/src/main.rs"
# shellcheck disable=SC2016
sed -n '/^```text$/,/^```$/p' pw85/README.md | sed '/^```/d' >"$work/expected"
cargo run -q --manifest-path "$work/readme/Cargo.toml" --config "$work/vendored.toml" | diff - "$work/expected"
grep -q "$(head -n 1 "$work/expected")" "$root/examples/c/pair.txt"

# Without optimisation: the library is compiled in a third of the time.
echo '+ README, with the library that pw85-sys compiles'
unset PKG_CONFIG_PATH
export PKG_CONFIG_LIBDIR=/nonexistent CXXFLAGS=-O0 LD_LIBRARY_PATH=''
cargo run -q --features vendored --manifest-path "$work/readme/Cargo.toml" --config "$work/vendored.toml" | diff - "$work/expected"

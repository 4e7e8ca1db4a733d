# Not yet run with crates.io. In the folder of the sources of pw85, publishes pw85-sys @VERSION@ and then pw85 @VERSION@, which needs it, with
# the addresses of pw85 and its licence. `.ci/run rust` packs the same crates without addresses, and builds a program by the packages.
#
# The build of pw85-sys asks pkg-config for the library: a user installs it first, or chooses the feature `vendored`, which compiles the
# sources of the library in the package. docs.rs makes the pages of reference without the library.
set -eu
folder=$(mktemp -d)
cp -R rust "$folder/rust"
scripts/vendor_rust.sh "$folder/rust/pw85-sys"
cp LICENSE "$folder/rust/pw85/"
for crate in pw85-sys pw85; do
  sed 's|^license = .*|&\nhomepage = "https://@HOMEPAGE@"\nrepository = "https://@REPOSITORY@"|' "rust/$crate/Cargo.toml" \
    >"$folder/rust/$crate/Cargo.toml"
done
cd "$folder/rust"
cargo publish -p pw85-sys
cargo publish -p pw85

# Not yet run by CRAN. In the folder of the sources of pw85, makes the source package for CRAN, pw85_@VERSION@.tar.gz, with the address of
# its maintainer, and the comments that go with it, cran-comments.md. `.ci/run r` checks the same package without these addresses.
#
# CRAN's machines need the library: the package asks pkg-config for it (SystemRequirements in DESCRIPTION). It is not yet in Debian.
set -eu
folder=$(mktemp -d)
cp -R r "$folder/pw85"
sed -e 's|pw85@pw85.invalid|@CONTACT@|' -e '/^License:/i URL: https://@HOMEPAGE@\nBugReports: https://@HOMEPAGE@/issues' \
  r/DESCRIPTION >"$folder/pw85/DESCRIPTION"
R CMD build "$folder/pw85"
rm -r "$folder"
R CMD check --as-cran pw85_@VERSION@.tar.gz
cat >cran-comments.md <<END
This is a new package. It is an interface to the C library pw85, which \`configure\` finds by pkg-config.

$(R --version | head -n 1), R CMD check --as-cran: $(tail -n 1 pw85.Rcheck/00check.log)
END

# Not yet run with npm's registry. In the folder of the sources of pw85, makes the package pw85-@VERSION@.tgz with the addresses of its
# page, and publishes it. `.ci/run npm` checks the same package without these addresses. Needs an account: npm login.
set -eu
scripts/build_npm.sh
folder=$(mktemp -d)
cp -R js "$folder/pw85"
sed -e '/"license":/i \  "homepage": "https://@HOMEPAGE@",\n  "repository": {"type": "git", "url": "git+https://@REPOSITORY@"},\n  "bugs": "https://@HOMEPAGE@/issues",' \
  js/package.json >"$folder/pw85/package.json"
npm publish --dry-run "$folder/pw85"
npm publish "$folder/pw85"
rm -r "$folder"

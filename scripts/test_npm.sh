#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Tests the npm package: builds it in build-npm, with the packages of Debian or Ubuntu that it needs, packs it, installs it from the
# package without a network, and runs its tests and README's programs in Node and, if the npm registry is there, in Deno, the types by
# TypeScript, and a page in Chromium.
set -eu
cd "$(dirname "$0")/.."
. scripts/packages.sh
# shellcheck disable=SC2086,SC2154 # a list of words
if command -v apt-get >/dev/null; then
  install_packages $npm_packages
  # Node's own packages have npm in nodejs.
  command -v npm >/dev/null || install_packages npm
fi

scripts/build_npm.sh
for module in pw85 plane; do
  size=$(wc -c <js/$module.wasm)
  echo "+ $module.wasm: $size bytes"
  [ "$size" -lt 300000 ]
done

echo '+ npm pack, npm install'
work=$PWD/build-npm/test
rm -rf "$work" && mkdir -p "$work"
cp -R js/tests "$work/tests"
cd "$work"
export npm_config_cache="$work/cache" npm_config_update_notifier=false
npm pack --silent ../../js >packed
tar -tzf pw85-*.tgz | sort >files
printf 'package/%s\n' LICENSE README.md package.json plane.wasm pw85.d.ts pw85.js pw85.wasm questions.js | diff - files
echo '{"type": "module", "private": true}' >package.json
npm install --silent --offline --no-audit --no-fund ./pw85-*.tgz

echo '+ tests'
PW85_PAIRS=../../r/tests/testthat/pairs.txt node --test tests

echo '+ README'
readme=node_modules/pw85/README.md
# shellcheck disable=SC2016 # the marks of blocks
sed -n '/^```js$/,/^```$/p' $readme | sed '/^```/d' >readme.js
# shellcheck disable=SC2016
sed -n '/^```text$/,/^```$/p' $readme | sed '/^```/d' >expected
grep -qxF "$(head -n 1 expected)" ../../examples/c/pair.txt
sed -n 's/^console.log(.*); \/\/ //p' $readme >>expected
node readme.js | diff - expected

echo '+ Deno'
if npm install --silent --no-audit --no-fund --prefix deno deno@2.9.6; then
  deno=deno/node_modules/.bin/deno
  $deno run --no-remote --allow-read readme.js | diff - expected
  # loaders.test.js starts Node.
  PW85_PAIRS=../../r/tests/testthat/pairs.txt $deno test --no-remote --no-check --allow-read --allow-env \
    tests/arguments.test.js tests/bits.test.js tests/plane.test.js tests/truths.test.js
else
  echo 'No Deno here.'
fi

echo '+ types'
if command -v tsc >/dev/null; then
  tsc --noEmit --strict --target es2020 --module es2020 --moduleResolution node --typeRoots /nonexistent --skipLibCheck false tests/types.ts
else
  echo 'No TypeScript here.'
fi

echo '+ Chromium'
cp ../../r/tests/testthat/pairs.txt .
/usr/bin/python3 tests/browser.py "$work"

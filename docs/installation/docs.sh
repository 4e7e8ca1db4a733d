# Run in the root of the repository. On Debian: apt-get install doxygen python3-breathe
# furo python3-sphinx-inline-tabs python3-sphinx-copybutton python3-myst-parser
# libjs-katex libjs-three clang lld; for its tests hunspell hunspell-en-gb nodejs chromium
# chromium-driver python3-selenium.
set -e
# start
meson setup build-docs -Ddocs=enabled
meson compile -C build-docs docs
# end

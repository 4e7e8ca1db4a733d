# Run in the root of the repository. On Debian: apt-get install doxygen python3-breathe furo python3-sphinx-inline-tabs
# libjs-katex; for its tests hunspell hunspell-en-gb nodejs.
set -e
# start
meson setup build-docs -Ddocs=enabled
meson compile -C build-docs docs
# end

# Run in the root of the repository, after debian.sh.
set -e
# start
/usr/bin/python3 -m venv --system-site-packages "$HOME/.venv/pw85"
"$HOME/.venv/pw85/bin/pip" install --no-build-isolation .
"$HOME/.venv/pw85/bin/python" examples/python/pair.py
# end

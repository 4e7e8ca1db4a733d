# Run in the root of the repository.
set -e
# start
scripts/test.sh
# end

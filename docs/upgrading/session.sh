# start tables
pw85 check grains.csv
# end tables
echo "status $?"
# start ignore
pw85 check grains.csv --ignore-columns tilt
# end ignore
echo "status $?"
# start resume
pw85 mc --resume run.h5 --sweeps 400
# end resume
echo "status $?"
# start restart
pw85 mc run.h5 --sweeps 400 --out continued.h5
# end restart

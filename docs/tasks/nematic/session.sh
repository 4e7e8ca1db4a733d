# start packings
for fraction in $FRACTIONS; do
  pw85 pack "isotropic-$fraction.csv" -n "$NUMBER" --axes 1,1,3 --fraction "$fraction"
  pw85 pack "aligned-$fraction.csv" -n "$NUMBER" --axes 1,1,3 --fraction "$fraction" \
    --lattice stretched --align 0,0,1
done
# end packings
# start runs
echo "volume fraction,start,nematic order,error,mark" >orders.csv
for fraction in $FRACTIONS; do
  for start in isotropic aligned; do
    pw85 mc "$start-$fraction.csv" --sweeps "$SWEEPS" --out "$start-$fraction.h5" \
      >"$start-$fraction.txt"
    awk -v run="$fraction,$start" \
      '/^nematic_order/ { print run "," $2 "," $3 "," $5 }' \
      "$start-$fraction.txt" >>orders.csv
  done
done
# end runs
# start pictures
pw85 plot "aligned-$fraction.h5" series.png
pw85 draw "aligned-$fraction.h5" nematic.png --color orientation
# end pictures

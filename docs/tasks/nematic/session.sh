# start packings
for fraction in $FRACTIONS; do
  pw85 pack "isotropic-$fraction.csv" -n "$NUMBER" --axes 1,1,3 --fraction "$fraction"
  pw85 pack "aligned-$fraction.csv" -n "$NUMBER" --axes 1,1,3 --fraction "$fraction" \
    --lattice stretched --align 0,0,1
done
# end packings
# start runs
for fraction in $FRACTIONS; do
  for start in isotropic aligned; do
    pw85 mc "$start-$fraction.csv" --sweeps "$SWEEPS" --equilibrate $((SWEEPS / 4)) \
      --out "$start-$fraction.h5" >"$start-$fraction.txt"
    echo "$start $fraction" $(grep "^nematic_order" "$start-$fraction.txt")
  done
done
# end runs
# start pictures
pw85 plot "aligned-$fraction.h5" series.png
pw85 draw "aligned-$fraction.h5" nematic.png --color orientation
# end pictures

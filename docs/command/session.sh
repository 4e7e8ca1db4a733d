# start check
pw85 check grains.xyz --worst 3 --csv contacts.csv
# end check
echo "status $?"
# start csv
cut -d, -f 3-7 contacts.csv
# end csv
# start draw
pw85 draw grains.xyz grains.png
pw85 draw grains.xyz grains.html --contacts
# end draw
# start convert
pw85 convert grains.xyz grains.gsd
pw85 check grains.gsd --worst 0
# end convert
# start relax
pw85 relax grains.xyz apart.data
pw85 check apart.data >/dev/null && echo "no overlaps"
# end relax
# start pack
pw85 pack packing.data -n 40 --axes 1,1,2 --axes 1.5,1.5,0.5 --fraction 0.5 \
  --voxels packing.vtk >/dev/null
pw85 check packing.data >/dev/null && echo "no overlaps"
pw85 plot packing.data packing.png >/dev/null
# end pack
# start rsa
pw85 pack saturated.h5 --dimensions 2 --rsa --axes 2,1 --cell 40,40 --seed 1 >/dev/null
pw85 check saturated.h5 >/dev/null 2>&1 && echo "no overlaps"
pw85 draw saturated.h5 saturated.svg 2>/dev/null
# end rsa
# start mc
pw85 mc packing.data --pressure 0.05 --sweeps 200 --out run.h5 >/dev/null
pw85 mc --resume run.h5 --sweeps 400 | tail -n 1
pw85 draw run.h5 run.png
# end mc
# start walls
pw85 mc packing.data --periodic ab --wall plane:0,0,-1,2.1 --wall plane:0,0,1,10.2 \
  --field weight:0,0,0.5 --sweeps 200 --out slit.h5 | tail -n 1
# end walls
# start law
pw85 mc packing.data --law powers:1,12,1,6,2.25 --sweeps 200 --out sticky.h5 | tail -n 1
# end law

#!/bin/sh
# seeds.sh FOLDER: a folder for each target in FOLDER, with files to start from: samples, small ones written here, and of the
# corpus those a fuzzer can work with.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
for target in dxf rul svg garmentcode obj seams recipe; do mkdir -p "$1/$target"; done
for folder in "$here/../../samples" ${TOILE_CORPUS:+"$TOILE_CORPUS/patterns"}; do
  find "$folder" -iname '*.dxf' -size -140k -exec cp {} "$1/dxf" \;
  find "$folder" -iname '*.rul' -size -140k -exec cp {} "$1/rul" \;
  find "$folder" \( -iname '*.svg' -o -iname '*.svgz' \) -size -60k -exec cp {} "$1/svg" \;
  find "$folder" -iname '*.json' -size -60k -exec cp {} "$1/garmentcode" \;
  find "$folder" -iname '*.obj' -size -60k -exec cp {} "$1/obj" \;
  find "$folder" -name '*.seams.toml' -exec cp {} "$1/seams" \;
  find "$folder" -name '*.toml' ! -name '*.seams.toml' -exec cp {} "$1/recipe" \;
done
cp -r "$here"/nasty/. "$1"
printf 'UNITS: METRIC\nNUMBER OF SIZES: 3\nSIZE LIST: 36 38 40\nSAMPLE SIZE: 38\nRULE: DELTA 1\n-1.5,2 0,0 1.5,-2\nEND\n' >"$1/rul/small.rul"
printf '<svg xmlns="http://www.w3.org/2000/svg" width="50cm" viewBox="0 0 500 500"><style>.a{fill:none;stroke:red}</style><g id="front" transform="rotate(3)"><path class="a" d="M10 10h200c9 80 9 90 0 300l-200 0z"/><text x="90" y="90">Front cut 2</text></g><use href="#front" x="240"/></svg>' >"$1/svg/small.svg"
printf '{"pattern":{"panels":{"p":{"vertices":[[0,0],[40,0],[40,60],[0,60]],"translation":[0,90,20],"rotation":[0,0,0],"edges":[{"endpoints":[0,1]},{"endpoints":[1,2],"curvature":{"type":"cubic","params":[[0.3,0.1],[0.7,0.1]]}},{"endpoints":[2,3],"curvature":[0.5,0.1]},{"endpoints":[3,0],"curvature":{"type":"circle","params":[50,0,1]}}]}},"stitches":[[{"panel":"p","edge":1},{"panel":"p","edge":3}]]},"properties":{"units_in_meter":100,"curvature_coords":"relative"}}' >"$1/garmentcode/small.json"
{
  for y in 0 1 2; do for x in 0 1 2; do printf 'v 0.%d 1.%d 0.1\nvt 0.%d 0.%d\n' "$x" "$y" "$x" "$y"; done; done
  printf 'g front\n'
  for f in '1 2 5 4' '2 3 6 5' '4 5 8 7' '5 6 9 8'; do
    printf 'f'
    for k in $f; do printf ' %d/%d' "$k" "$k"; done
    printf '\n'
  done
} >"$1/obj/small.obj"
printf '[[piece]]\nname = "GORE"\nstart = "bottom left"\nedges = ["hem", "right", "top", "left"]\nhems = ["hem"]\n[[seam]]\nname = "g"\nring = "GORE"\nfrom = "right"\nto = "left"\n[[seam]]\nname = "w"\nalong = "WAISTBAND.e0"\neach = "GORE.top"\n' >"$1/seams/small.toml"
chmod -R u+w "$1"

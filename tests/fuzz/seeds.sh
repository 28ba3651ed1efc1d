#!/bin/sh
# seeds.sh FOLDER: FOLDER/dxf and FOLDER/rul with files to start from; of the corpus only those a fuzzer can work with.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1/dxf" "$1/rul"
for folder in "$here/../../samples" ${TOILE_CORPUS:+"$TOILE_CORPUS/patterns"}; do
  find "$folder" -iname '*.dxf' -size -140k -exec cp {} "$1/dxf" \;
  find "$folder" -iname '*.rul' -size -140k -exec cp {} "$1/rul" \;
done
printf 'UNITS: METRIC\nNUMBER OF SIZES: 3\nSIZE LIST: 36 38 40\nSAMPLE SIZE: 38\nRULE: DELTA 1\n-1.5,2 0,0 1.5,-2\nEND\n' >"$1/rul/small.rul"
chmod -R u+w "$1"

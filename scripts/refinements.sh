#!/usr/bin/env bash
# Makes finer and finer meshes of a case of the gallery, with a case file each, and times them:
#
#     scripts/refinements.sh large 0.3 0.45 0.55 0.68
#
# Needs Gmsh (`gmsh` in the path, or GMSH) and, unless TRESCA says where it is, a release build of the program. The sizes
# are those of the `.geo` file; out/refinements keeps the meshes and the case files.
set -euo pipefail
cd "$(dirname "$0")/.."

name=$1
shift
directory=out/refinements
mkdir -p "$directory"
cases=()
for size in "$@"; do
  "${GMSH:-gmsh}" -v 1 -3 "gallery/$name/$name.geo" -setnumber size "$size" -o "$directory/$name-$size.msh"
  sed "s/$name\.msh/$name-$size.msh/" "gallery/$name/$name.toml" > "$directory/$name-$size.toml"
  cases+=("$directory/$name-$size.toml")
done
"${TRESCA:-target/release/tresca}" bench case "${cases[@]}"

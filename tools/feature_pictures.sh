#!/bin/sh
# The pictures of docs/features.md: tools/feature_pictures.sh TUKOR [FOLDER]
# Scenes of tools/feature_scenes.py by gl and by trace.
set -e
tukor=$1
out=${2:-docs/images/features}
scenes=$(mktemp -d)
trap 'rm -r "$scenes"' EXIT
mkdir -p "$out"
plain="--size 480x112 --fov 14"
beside="--size 480x210 --eye 0,1.2,4.5 --target 0,0,-0.4 --fov 26"
picture() {  # NAME FIDELITY VIEW...
    name=$1 fidelity=$2
    shift 2
    view="$* --environment studio --environment-rotation 30 --quiet"
    "$tukor" render "$scenes/$name.glb" $view --renderer gl --fidelity "$fidelity" --samples 16 -o "$out/$name-gl.jpg"
    "$tukor" render "$scenes/$name.glb" $view --renderer trace --samples "${samples:-64}" -o "$out/$name-trace.jpg"
}
python3 "$(dirname "$0")/feature_scenes.py" "$scenes" group behind textured frosted iridescence clearcoat metal
for name in textured frosted iridescence clearcoat metal; do picture $name single $plain; done
picture group exact $plain
samples=256 picture behind exact $beside

#!/bin/sh
# The pictures of docs/features.md: tools/feature_pictures.sh TUKOR [FOLDER]
# Scenes of tools/feature_scenes.py by gl and by trace.
set -e
tukor=$1
out=${2:-docs/images/features}
scenes=$(mktemp -d)
trap 'rm -r "$scenes"' EXIT
mkdir -p "$out"
python3 "$(dirname "$0")/feature_scenes.py" "$scenes" group textured frosted iridescence clearcoat metal
for model in "$scenes"/*.glb; do
    name=$(basename "$model" .glb)
    view="--size 480x112 --fov 14 --environment studio --environment-rotation 30 --quiet"
    "$tukor" render "$model" $view --renderer gl --fidelity single --samples 16 -o "$out/$name-gl.jpg"
    "$tukor" render "$model" $view --renderer trace --samples 64 -o "$out/$name-trace.jpg"
done

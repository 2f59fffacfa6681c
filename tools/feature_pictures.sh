#!/bin/sh
# The pictures of docs/features.md: tools/feature_pictures.sh TUKOR [FOLDER]
# Every scene of tools/feature_scenes.py by gl and by trace, one above the other; needs ImageMagick.
set -e
tukor=$1
out=${2:-docs/images/features}
scenes=$(mktemp -d)
trap 'rm -r "$scenes"' EXIT
mkdir -p "$out"
python3 "$(dirname "$0")/feature_scenes.py" "$scenes"
for model in "$scenes"/*.glb; do
    name=$(basename "$model" .glb)
    view="--size 480x112 --fov 16 --tonemap neutral --environment studio --environment-rotation 30"
    "$tukor" render "$model" $view --renderer gl --fidelity single --samples 32 -o "$scenes/gl.png"
    "$tukor" render "$model" $view --renderer trace --samples 64 -o "$scenes/trace.png"
    convert "$scenes/gl.png" "$scenes/trace.png" -append -quality 88 "$out/$name.jpg"
done

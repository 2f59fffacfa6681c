#!/bin/bash
# The pictures of docs/features.md: tools/feature_pictures.sh TUKOR [FOLDER [NAME...]], TUKOR where it was built with -DTUKOR_BENCH=ON
# Scenes of tools/feature_scenes.py and bench/packed_shapes by gl, by trace and, where it has the feature and blender is there, by Cycles.
set -e
tukor=$1
out=$(realpath -m "${2:-docs/images/features}")
names="${*:3}"
here=$(dirname "$(realpath "$0")")
scenes=$(mktemp -d)
trap 'rm -r "$scenes"' EXIT
mkdir -p "$out"
"$tukor" environment convert studio --rotate 30 -o "$scenes/studio.exr"
python3 "$here/feature_scenes.py" "$scenes"
"$(dirname "$tukor")/../../bench/packed_shapes" "$scenes/packed.glb"

# WIDTH HEIGHT EYE TARGET FOV
row="400 94 0,0,10.5 0,0,0 8"
few="400 94 0,0.5,8 0,-0.05,0 9"
floor="400 150 0,1.2,7 0,-0.2,0 16"
beside="480 210 0,1.2,4.5 0,0,-0.4 26"

picture() {  # NAME FIDELITY SAMPLES PEER WIDTH HEIGHT EYE TARGET FOV
    local name=$1 fidelity=$2 samples=$3 peer=$4 width=$5 height=$6 eye=$7 target=$8 fov=$9 light=1
    if [ -n "$names" ] && [[ " $names " != *" $name "* ]]; then return; fi
    if [ "$name" = lamps ]; then light=0.1; fi
    local view="--environment $scenes/studio.exr --environment-intensity $light --size ${width}x$height --eye $eye --target $target --fov $fov --time-seconds 1 --tonemap none --quiet"
    if [ "$name" = variants ]; then view+=" --variant festive"; fi
    "$tukor" render "$scenes/$name.glb" $view --renderer gl --fidelity "$fidelity" --samples 16 -o "$out/$name-gl.jpg"
    "$tukor" render "$scenes/$name.glb" $view --renderer trace --samples "$samples" -o "$out/$name-trace.jpg"
    if [ "$peer" = cycles ] && command -v blender > /dev/null; then
        blender -b --factory-startup --python "$here/../bench/offline/cycles.py" -- "{\"models\": [[\"$scenes/$name.glb\", \"\"]],
            \"environment\": \"$scenes/studio.exr\", \"intensity\": $light, \"eye\": [$eye], \"target\": [$target], \"fov\": $fov,
            \"size\": [$width, $height], \"samples\": $samples, \"seed\": 1, \"out\": \"$out/$name-cycles.jpg\"}" > "$scenes/cycles.txt" ||
            { cat "$scenes/cycles.txt"; exit 1; }
    fi
}
for name in metal plastic metallic ior specular clearcoat sheen frosted thin emission unlit blend textured; do
    picture $name single 64 cycles $row
done
for name in anisotropy iridescence instances variants; do picture $name single 64 alone $row; done
for name in mask colors moved; do picture $name single 64 cycles $few; done
picture packed single 64 alone $few
picture lamps single 64 cycles $floor
picture group exact 64 cycles $floor
picture behind exact 256 cycles $beside

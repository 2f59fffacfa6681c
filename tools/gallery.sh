#!/usr/bin/env bash
# Renders the demo's gallery: metals, glass and water under a built-in and photographic environments.
#
# usage: tools/gallery.sh TUKOR FOLDER
set -euo pipefail
tukor=$1
folder=$2
photos=/usr/share/blender/datafiles/studiolights/world
mkdir -p "$folder"

render() {  # name, arguments of tukor render
    local name=$1; shift
    echo "  $folder/$name.png"
    "$tukor" render "$@" --size 960x540 --error 2 --samples 16 --quiet -o "$folder/$name.png"
}

echo "Rendering:"
render gold-knot-courtyard     torus-knot --material gold --environment $photos/courtyard.exr
render silver-teapot-studio    teapot --material silver --environment studio
render glass-sphere-forest     sphere --material glass --environment $photos/forest.exr --eye 0,0,4 --target 0,0,0
render glass-sphere-single     sphere --material glass --environment $photos/forest.exr --eye 0,0,4 --target 0,0,0 --fidelity single
render glass-knot-interior     torus-knot --material glass --environment $photos/interior.exr
render diamond-studio          brilliant --material diamond --environment studio
render tumbler-sunset          tumbler --environment $photos/sunset.exr
render water-sky               water --material water --environment sky

echo
echo "The gallery is in $(cd "$folder" && pwd)"
echo "glass-sphere-single is the textbook's single interface, upright; glass-sphere-forest is solid glass: the forest stands on its head."
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
    echo "Open the window with: ./demo view"
else
    echo "On a machine with a display, ./demo view opens the window."
fi

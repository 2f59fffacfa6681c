#include "tukor/scene/gltf_features.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "tukor/scene/sibling_file.h"

namespace tukor {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view kRead[] = {
    "KHR_mesh_quantization"sv,
    "EXT_mesh_gpu_instancing"sv,
    "EXT_meshopt_compression"sv,
    "KHR_draco_mesh_compression"sv,
    "KHR_texture_transform"sv,
    "KHR_materials_anisotropy"sv,
    "KHR_materials_clearcoat"sv,
    "KHR_materials_dispersion"sv,
    "KHR_materials_emissive_strength"sv,
    "KHR_materials_ior"sv,
    "KHR_materials_iridescence"sv,
    "KHR_materials_sheen"sv,
    "KHR_materials_specular"sv,
    "KHR_materials_transmission"sv,
    "KHR_materials_unlit"sv,
    "KHR_materials_variants"sv,
    "KHR_lights_punctual"sv,
    "KHR_materials_volume"sv,
};

// Without effect on the picture, or with a texture in another format beside.
constexpr std::string_view kHarmless[] = {
    "KHR_texture_basisu"sv, "EXT_texture_webp"sv, "EXT_texture_avif"sv,
    "MSFT_texture_dds"sv,   "KHR_xmp_json_ld"sv,  "KHR_xmp"sv,
};

bool contains(std::span<const std::string_view> names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

// Changes how surfaces look and nothing else: the picture is poorer without, not wrong in shape.
bool isAppearance(std::string_view name) {
    return name.starts_with("KHR_materials_") || name == "EXT_lights_image_based";
}

}  // namespace

void refuseUnknownExtensions(const JsonItem& root) {
    for (const JsonItem item : root.list("extensionsRequired")) {
        const std::string_view name = item.text();
        if (contains(kRead, name) || contains(kHarmless, name) || isAppearance(name)) continue;
        item.fail(fmt::format("the file requires the extension {}, which is not supported",
                              printable(name)));
    }
}

void noteFeatures(const JsonItem& root, const ModelOptions& options, Notes& notes) {
    for (const JsonItem item : root.list("extensionsUsed")) {
        const std::string_view name = item.text();
        if (!contains(kRead, name) && !contains(kHarmless, name))
            notes.add("extensions that are not rendered", name);
    }
    const std::size_t animations = root.list("animations").size();
    if (animations > 0 && !options.timeSeconds)
        notes.add("it is animated and shown at rest; --time-seconds chooses a moment");
    if (animations > 1 && options.timeSeconds && options.animation.empty())
        notes.add("of its animations the first is shown");
}

}  // namespace tukor

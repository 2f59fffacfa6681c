// The choice among the looks of a product that a glTF file holds: KHR_materials_variants.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tukor/scene/gltf_document.h"

namespace tukor {

/// The names of all variants, in their order.
[[nodiscard]] std::vector<std::string> variantsOf(const GltfDocument& document);

/// The number of the variant of that name; none for an empty name. Throws Error, which lists the
/// names, where there is no such variant.
[[nodiscard]] std::optional<std::size_t> variantOf(const GltfDocument& document,
                                                   std::string_view name);

/// The index of a primitive's material under a variant, or its own; none where it has none.
[[nodiscard]] std::optional<JsonItem> materialOfVariant(const JsonItem& primitive,
                                                        std::optional<std::size_t> variant);

}  // namespace tukor

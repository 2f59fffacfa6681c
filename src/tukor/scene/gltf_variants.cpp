#include "tukor/scene/gltf_variants.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tukor/base/error.h"
#include "tukor/scene/sibling_file.h"

namespace tukor {

namespace {

std::optional<JsonItem> extensionOf(const JsonItem& item) {
    const std::optional<JsonItem> extensions = item.find("extensions");
    return extensions ? extensions->find("KHR_materials_variants") : std::nullopt;
}

}  // namespace

std::vector<std::string> variantsOf(const GltfDocument& document) {
    std::vector<std::string> names;
    if (const std::optional<JsonItem> extension = extensionOf(document.root()))
        for (const JsonItem variant : extension->list("variants"))
            names.emplace_back(variant.textOr("name", ""));
    return names;
}

std::optional<std::size_t> variantOf(const GltfDocument& document, std::string_view name) {
    if (name.empty()) return std::nullopt;
    std::vector<std::string> known = variantsOf(document);
    const auto found = std::find(known.begin(), known.end(), name);
    if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
    if (known.empty())
        throw Error(
            fmt::format("{}: no variant '{}': the model has no variants", document.name(), name));
    for (std::string& one : known) one = printable(one);
    throw Error(fmt::format("{}: no variant '{}'; there are {}", document.name(), name,
                            fmt::join(known, ", ")));
}

std::optional<JsonItem> materialOfVariant(const JsonItem& primitive,
                                          std::optional<std::size_t> variant) {
    if (variant)
        if (const std::optional<JsonItem> extension = extensionOf(primitive))
            for (const JsonItem mapping : extension->list("mappings"))
                for (const JsonItem one : mapping.list("variants"))
                    if (one.count() == *variant) return mapping.find("material");
    return primitive.find("material");
}

}  // namespace tukor

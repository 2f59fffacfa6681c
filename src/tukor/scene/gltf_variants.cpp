#include "tukor/scene/gltf_variants.h"

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

std::optional<std::size_t> variantOf(const GltfDocument& document, std::string_view name) {
    if (name.empty()) return std::nullopt;
    std::vector<std::string> known;
    if (const std::optional<JsonItem> extension = extensionOf(document.root()))
        for (const JsonItem variant : extension->list("variants")) {
            known.push_back(printable(variant.textOr("name", "")));
            if (variant.textOr("name", "") == name) return known.size() - 1;
        }
    if (known.empty())
        throw Error(
            fmt::format("{}: no variant '{}': the model has no variants", document.name(), name));
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

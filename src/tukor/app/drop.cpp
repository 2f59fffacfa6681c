#include "tukor/app/drop.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>
#include <utility>

#include "tukor/app/session.h"
#include "tukor/base/file.h"
#include "tukor/environment/texture_chain.h"
#include "tukor/scene/model_file.h"

namespace tukor {
namespace {

template <std::size_t size>
bool isOneOf(const std::array<std::string_view, size>& extensions, const std::string& path) {
    return std::find(extensions.begin(), extensions.end(), lowerExtension(path)) !=
           extensions.end();
}

/// Pictures of radiance: no model has textures of them.
constexpr std::array<std::string_view, 3> kRadiance{".hdr", ".exr", ".pic"};
constexpr std::array<std::string_view, 3> kPictures{".png", ".jpg", ".jpeg"};

}  // namespace

bool namesEnvironment(const std::filesystem::path& path) {
    std::error_code ignored;
    return isOneOf(kRadiance, path.string()) || isOneOf(kPictures, path.string()) ||
           hasTextureExtension(path) || std::filesystem::is_directory(path, ignored);
}

SessionOptions withDropped(SessionOptions options, const std::vector<std::string>& files) {
    const bool beside = std::any_of(files.begin(), files.end(), [](const std::string& file) {
        return hasModelExtension(file);
    });
    std::vector<std::string> models;
    for (const std::string& file : files) {
        if (beside ? isOneOf(kRadiance, file) : namesEnvironment(file)) {
            options.light.environment = file;
        } else if (!beside || hasModelExtension(file)) {
            models.push_back(file);
        }
    }
    return models.empty() ? options : withModels(std::move(options), std::move(models));
}

}  // namespace tukor

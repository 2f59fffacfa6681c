// In place of file_textures.cpp where models have no files beside them: in the browser.
#ifdef __EMSCRIPTEN__
#include "tukor/scene/file_textures.h"

namespace tukor {

using Picture = FileTextures::Picture;

Picture FileTextures::file(std::string_view) {
    notes_.add("textures are not rendered");
    return nullptr;
}

Picture FileTextures::withOpacity(const Picture&, const Picture&) {
    return nullptr;
}

Picture FileTextures::metallicRoughness(const Picture&, const Picture&) {
    return nullptr;
}

Picture FileTextures::normals(const Picture&, float) {
    return nullptr;
}

void FileTextures::decode() {}

}  // namespace tukor
#endif

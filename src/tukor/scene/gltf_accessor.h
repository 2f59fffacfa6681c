// Typed arrays in the buffers of a glTF file, validated before the first element is read.
#pragma once
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "tukor/scene/gltf_document.h"

namespace tukor {

enum class GltfComponent { int8 = 5120, uint8, int16, uint16, uint32 = 5125, float32 };

/// An array of vectors or indices; all of its elements lie inside its buffers. Refers to them.
class GltfAccessor {
public:
    /// Accessor `index`. Throws Error where it does not fit into its views.
    GltfAccessor(const GltfDocument& document, std::size_t index, const JsonItem& user);

    [[nodiscard]] std::size_t count() const noexcept { return count_; }
    [[nodiscard]] int components() const noexcept { return components_; }

    /// Throws Error unless elements are unsigned scalars, as indices are.
    void requireIndices() const;
    /// Throws Error unless elements have three components.
    void requireVec3() const { requireComponents(3, 3); }
    /// Throws Error unless elements have so many components.
    void requireComponents(int least, int most) const;

    [[nodiscard]] std::uint32_t index(std::size_t element) const noexcept;
    /// Normalised integers become [-1, 1] or [0, 1].
    [[nodiscard]] glm::vec3 vec3(std::size_t element) const noexcept;
    /// The same of two to four components; 0 for the second and third that are not there, 1 for the
    /// fourth. NaN and infinities become 0.
    [[nodiscard]] glm::vec4 vec4(std::size_t element) const noexcept;

    /// Of sixteen components, by columns. NaN and infinities become 0.
    [[nodiscard]] glm::mat4 mat4(std::size_t element) const noexcept;

private:
    [[nodiscard]] const std::byte* find(std::size_t element) const noexcept;
    void readSparse(const GltfDocument& document, const JsonItem& sparse);

    JsonItem item_;
    std::size_t count_ = 0;
    GltfComponent type_ = GltfComponent::float32;
    int components_ = 1;
    bool normalized_ = false;
    const std::byte* data_ = nullptr;  // of element 0; null: all zeros
    std::size_t stride_ = 0;
    std::vector<std::uint32_t> replaced_;      // increasing; elements that are elsewhere
    const std::byte* replacements_ = nullptr;  // their values, close together
};

}  // namespace tukor

#include "tukor/scene/gltf_accessor.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/scene/sibling_file.h"

namespace tukor {

namespace {

// Elements of an accessor without data of its own; the others are bounded by the file's size.
constexpr std::size_t kMostZeros = 1 << 22;

constexpr std::byte kZeros[64] = {};  // larger than any element

std::size_t sizeOf(GltfComponent type) noexcept {
    switch (type) {
        case GltfComponent::int8:
        case GltfComponent::uint8:
            return 1;
        case GltfComponent::int16:
        case GltfComponent::uint16:
            return 2;
        default:
            return 4;
    }
}

GltfComponent componentTypeOf(const JsonItem& item) {
    const std::size_t code = item.count();
    if (code < 5120 || code > 5126 || code == 5124)
        item.fail(fmt::format("component type {}; expected 5120 to 5123, 5125 or 5126", code));
    return static_cast<GltfComponent>(code);
}

int componentsOf(const JsonItem& item) {
    constexpr std::pair<std::string_view, int> kTypes[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3},
                                                           {"VEC4", 4},   {"MAT2", 4}, {"MAT3", 9},
                                                           {"MAT4", 16}};
    for (const auto& [name, components] : kTypes)
        if (item.text() == name) return components;
    item.fail(fmt::format("type '{}'; expected SCALAR, VEC2 to VEC4 or MAT2 to MAT4",
                          printable(item.text())));
}

// The first byte of `count` elements inside a view.
const std::byte* place(const GltfView& view, std::size_t offset, std::size_t count,
                       std::size_t elementSize, std::size_t stride, const JsonItem& user) {
    const std::size_t size = view.bytes.size();
    const bool fits = count == 0 || (offset <= size && elementSize <= size - offset &&
                                     (count - 1) <= (size - offset - elementSize) / stride);
    if (!fits)
        user.fail(fmt::format("{} elements of {} bytes from byte {} do not fit into a view of {}",
                              count, elementSize, offset, size));
    return view.bytes.data() + (count == 0 ? 0 : offset);
}

template <class T>
T load(const std::byte* from, int index) noexcept {
    T value;
    std::memcpy(&value, from + static_cast<std::size_t>(index) * sizeof(T), sizeof(T));
    return value;
}

template <class T>
float loadAs(const std::byte* from, int index, bool normalized) noexcept {
    const auto value = static_cast<float>(load<T>(from, index));
    return normalized ? std::max(value / static_cast<float>(std::numeric_limits<T>::max()), -1.0f)
                      : value;
}

float component(const std::byte* from, int index, GltfComponent type, bool normalized) noexcept {
    switch (type) {
        case GltfComponent::int8:
            return loadAs<std::int8_t>(from, index, normalized);
        case GltfComponent::uint8:
            return loadAs<std::uint8_t>(from, index, normalized);
        case GltfComponent::int16:
            return loadAs<std::int16_t>(from, index, normalized);
        case GltfComponent::uint16:
            return loadAs<std::uint16_t>(from, index, normalized);
        case GltfComponent::uint32:
            return loadAs<std::uint32_t>(from, index, normalized);
        case GltfComponent::float32:
            break;
    }
    return load<float>(from, index);
}

std::uint32_t indexAt(const std::byte* from, GltfComponent type) noexcept {
    switch (type) {
        case GltfComponent::uint8:
            return load<std::uint8_t>(from, 0);
        case GltfComponent::uint16:
            return load<std::uint16_t>(from, 0);
        default:
            return load<std::uint32_t>(from, 0);
    }
}

}  // namespace

GltfAccessor::GltfAccessor(const GltfDocument& document, std::size_t index, const JsonItem& user)
    : item_(document.item("accessors", index, user)) {
    const JsonItem& item = item_;
    count_ = item.at("count").count();
    type_ = componentTypeOf(item.at("componentType"));
    components_ = componentsOf(item.at("type"));
    normalized_ = item.truthOr("normalized", false);
    const std::size_t elementSize = sizeOf(type_) * static_cast<std::size_t>(components_);
    if (count_ > std::numeric_limits<std::uint32_t>::max())
        item.fail(fmt::format("{} elements; at most 2^32 - 1 can be told apart", count_));

    if (const std::optional<JsonItem> viewIndex = item.find("bufferView")) {
        const GltfView view = document.view(viewIndex->count(), item);
        stride_ = view.stride == 0 ? elementSize : view.stride;
        if (stride_ < elementSize)
            item.fail(fmt::format("elements of {} bytes at a stride of {}", elementSize, stride_));
        data_ = place(view, item.countOr("byteOffset", 0), count_, elementSize, stride_, item);
    } else if (count_ > kMostZeros) {
        item.fail(fmt::format("{} elements without a buffer view; at most {} are read", count_,
                              kMostZeros));
    }
    if (const std::optional<JsonItem> sparse = item.find("sparse")) readSparse(document, *sparse);
}

void GltfAccessor::readSparse(const GltfDocument& document, const JsonItem& sparse) {
    const std::size_t count = sparse.at("count").count();
    const JsonItem indices = sparse.at("indices"), values = sparse.at("values");
    const GltfComponent type = componentTypeOf(indices.at("componentType"));
    if (type != GltfComponent::uint8 && type != GltfComponent::uint16 &&
        type != GltfComponent::uint32)
        indices.fail("indices must be unsigned");
    const std::byte* const from =
        place(document.view(indices.at("bufferView").count(), indices),
              indices.countOr("byteOffset", 0), count, sizeOf(type), sizeOf(type), indices);
    const std::size_t elementSize = sizeOf(type_) * static_cast<std::size_t>(components_);
    replacements_ = place(document.view(values.at("bufferView").count(), values),
                          values.countOr("byteOffset", 0), count, elementSize, elementSize, values);
    replaced_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        replaced_[i] = indexAt(from + i * sizeOf(type), type);
        if (replaced_[i] >= count_ || (i > 0 && replaced_[i] <= replaced_[i - 1]))
            indices.fail(fmt::format("element {} is {}; expected increasing indices below {}", i,
                                     replaced_[i], count_));
    }
}

const std::byte* GltfAccessor::find(std::size_t element) const noexcept {
    if (!replaced_.empty()) {
        const auto found = std::lower_bound(replaced_.begin(), replaced_.end(), element);
        if (found != replaced_.end() && *found == element)
            return replacements_ + static_cast<std::size_t>(found - replaced_.begin()) *
                                       sizeOf(type_) * static_cast<std::size_t>(components_);
    }
    return data_ != nullptr ? data_ + element * stride_ : kZeros;
}

void GltfAccessor::requireIndices() const {
    const bool isUnsigned = type_ == GltfComponent::uint8 || type_ == GltfComponent::uint16 ||
                            type_ == GltfComponent::uint32;
    if (components_ != 1 || !isUnsigned || normalized_)
        item_.fail("not indices: expected unsigned SCALARs");
}

void GltfAccessor::requireComponents(int least, int most) const {
    if (components_ < least || components_ > most)
        item_.fail(least == 1      ? std::string("expected type SCALAR")
                   : least == 16   ? std::string("expected type MAT4")
                   : least == most ? fmt::format("expected type VEC{}", least)
                                   : fmt::format("expected type VEC{} or VEC{}", least, most));
}

std::uint32_t GltfAccessor::index(std::size_t element) const noexcept {
    TUKOR_ASSERT(element < count_);
    return indexAt(find(element), type_);
}

glm::vec3 GltfAccessor::vec3(std::size_t element) const noexcept {
    TUKOR_ASSERT(element < count_ && components_ == 3);
    const std::byte* const from = find(element);
    if (type_ == GltfComponent::float32)
        return {load<float>(from, 0), load<float>(from, 1), load<float>(from, 2)};
    return {component(from, 0, type_, normalized_), component(from, 1, type_, normalized_),
            component(from, 2, type_, normalized_)};
}

glm::vec4 GltfAccessor::vec4(std::size_t element) const noexcept {
    TUKOR_ASSERT(element < count_ && components_ <= 4);
    const std::byte* const from = find(element);
    glm::vec4 v(0.0f, 0.0f, 0.0f, 1.0f);
    for (int i = 0; i < components_; ++i) {
        v[i] = component(from, i, type_, normalized_);
        if (!std::isfinite(v[i])) v[i] = 0.0f;
    }
    return v;
}

glm::mat4 GltfAccessor::mat4(std::size_t element) const noexcept {
    TUKOR_ASSERT(element < count_ && components_ == 16);
    const std::byte* const from = find(element);
    glm::mat4 m(1.0f);
    for (int i = 0; i < 16; ++i) {
        const float value = component(from, i, type_, normalized_);
        m[i / 4][i % 4] = std::isfinite(value) ? value : 0.0f;
    }
    return m;
}

}  // namespace tukor

#include "scene_bytes.h"

#include <cstring>
#include <string>
#include <type_traits>

namespace tukor::web {

namespace {

// One list of members for both directions: `Stream` copies out of them or into them.
template <class Stream, class SceneType>
void transfer(Stream& stream, SceneType& scene) {
    stream.list(scene.parts, [&](auto& part) {
        stream.values(part.name);
        stream.values(part.materialName);
        stream.value(part.material.kind);
        stream.value(part.material.tint);
        stream.value(part.material.eta);
        stream.value(part.material.k);
        stream.value(part.material.sigmaA);
        stream.value(part.material.priority);
        stream.values(part.mesh.positions);
        stream.values(part.mesh.normals);
        stream.values(part.mesh.triangles);
    });
    stream.list(scene.warnings, [&](auto& warning) { stream.values(warning); });
}

class Writer {
public:
    template <class T>
    void value(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        put(&value, sizeof(T));
    }
    template <class Values>
    void values(const Values& values) {
        static_assert(std::is_trivially_copyable_v<typename Values::value_type>);
        value(values.size());
        put(values.data(), values.size() * sizeof(values[0]));
    }
    template <class Item, class Each>
    void list(const std::vector<Item>& items, const Each& each) {
        value(items.size());
        for (const Item& item : items) each(item);
    }
    std::vector<std::byte> bytes;

private:
    void put(const void* from, std::size_t size) {
        const auto* first = static_cast<const std::byte*>(from);
        bytes.insert(bytes.end(), first, first + size);
    }
};

class Reader {
public:
    explicit Reader(std::span<const std::byte> bytes) : rest_(bytes) {}

    template <class T>
    void value(T& value) {
        take(&value, sizeof(T));
    }
    template <class Values>
    void values(Values& values) {
        values.resize(count());
        take(values.data(), values.size() * sizeof(values[0]));
    }
    template <class Item, class Each>
    void list(std::vector<Item>& items, const Each& each) {
        items.resize(count());
        for (Item& item : items) each(item);
    }

private:
    std::size_t count() {
        std::size_t size = 0;
        value(size);
        return size;
    }
    void take(void* to, std::size_t size) {
        if (size > 0) std::memcpy(to, rest_.data(), size);
        rest_ = rest_.subspan(size);
    }
    std::span<const std::byte> rest_;
};

}  // namespace

std::vector<std::byte> bytesFromScene(const Scene& scene) {
    Writer writer;
    transfer(writer, scene);
    return std::move(writer.bytes);
}

Scene sceneFromBytes(std::span<const std::byte> bytes) {
    Scene scene;
    Reader reader(bytes);
    transfer(reader, scene);
    return scene;
}

}  // namespace tukor::web

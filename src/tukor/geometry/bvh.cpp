#include "tukor/geometry/bvh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/parallel.h"
#include "tukor/geometry/bvh_binary.h"
#include "tukor/geometry/bvh_traversal.h"

namespace tukor {

namespace {

using detail::BinaryNode;
using detail::BvhItem;

constexpr std::uint32_t kMaxTriangles = 1u << 24;  // what 24 bits, and a float, can count

// Deep enough for all triangles in leaves of 4 (22 levels), and one stack entry a level fits.
constexpr int kMaxDepth = geometry::kBvhStackSize;

struct Gathered {
    std::array<std::uint32_t, 4> nodes{};
    int count = 0;
};

// The traversal goes into one inner child of a node and puts the others on its stack. This is how
// many entries that takes below each node when no node is opened: one for each level at most.
std::vector<int> leastStackSizes(const std::vector<BinaryNode>& tree) {
    std::vector<int> sizes(tree.size(), 0);
    for (std::size_t i = tree.size(); i-- > 0;) {  // children come after their parents
        if (tree[i].leaf()) continue;
        const std::uint32_t child = tree[i].child;
        const int both = !tree[child].leaf() && !tree[child + 1].leaf() ? 1 : 0;
        sizes[i] = both + std::max(sizes[child], sizes[child + 1]);
    }
    return sizes;
}

// The up to four descendants of a node that become its children: the largest are opened first, as
// long as `room` entries of the stack suffice for all below.
Gathered gather(const std::vector<BinaryNode>& tree, const std::vector<int>& stackSizes,
                std::uint32_t index, int room) {
    Gathered found;
    found.nodes[0] = index;
    found.count = 1;
    const auto opened = [&](int slot) {
        Gathered next = found;
        const std::uint32_t child = tree[found.nodes[slot]].child;
        next.nodes[slot] = child;
        next.nodes[next.count++] = child + 1;
        return next;
    };
    const auto fits = [&](const Gathered& children) {
        int inner = 0, below = 0;
        for (int slot = 0; slot < children.count; ++slot)
            if (!tree[children.nodes[slot]].leaf()) {
                ++inner;
                below = std::max(below, stackSizes[children.nodes[slot]]);
            }
        return inner == 0 || inner - 1 + below <= room;
    };
    if (!tree[index].leaf()) found = opened(0);
    bool open = true;
    while (open && found.count < 4) {
        open = false;
        int largest = -1;
        for (int slot = 0; slot < found.count; ++slot)
            if (!tree[found.nodes[slot]].leaf() &&
                (largest < 0 || tree[found.nodes[slot]].area() > tree[found.nodes[largest]].area()))
                largest = slot;
        if (largest < 0) break;
        const Gathered next = opened(largest);
        if (fits(next)) {
            found = next;
            open = true;
        }
    }
    return found;
}

// Bytes that enclose [least, most] on a grid of 256 planes.
struct Grid {
    float origin;
    std::uint32_t exponent;  // biased

    Grid(float least, float most) : origin(least), exponent(1) {
        // The smallest power of two with 255 steps over the box; 2^-100 keeps flat boxes normal.
        const double extent = static_cast<double>(most) - least;
        int power = extent > 0.0 ? std::max(std::ilogb(extent / 255.0), -100) : -100;
        while (std::ldexp(255.0, power) < extent) ++power;
        exponent = static_cast<std::uint32_t>(power + 127);
    }
    [[nodiscard]] double scale() const { return std::ldexp(1.0, static_cast<int>(exponent) - 127); }
    [[nodiscard]] std::uint32_t below(float x) const {
        return static_cast<std::uint32_t>(std::floor((static_cast<double>(x) - origin) / scale()));
    }
    [[nodiscard]] std::uint32_t above(float x) const {
        return static_cast<std::uint32_t>(std::ceil((static_cast<double>(x) - origin) / scale()));
    }
};

struct Folded {
    std::vector<glm::uvec4> texels;
    std::vector<std::uint32_t> order;  // items, as leaves come
    int stackSize = 0;
};

Folded fold(const std::vector<BinaryNode>& tree) {
    struct Pending {
        std::uint32_t binary;
        int stack;  // entries on the stack, at most, when the traversal gets here
    };
    Folded folded;
    folded.order.reserve(tree.front().count);
    const std::vector<int> stackSizes = leastStackSizes(tree);
    std::vector<Pending> pending{{0, 0}};  // index = node
    for (std::size_t node = 0; node < pending.size(); ++node) {
        const auto [binary, stack] = pending[node];
        const Gathered children = gather(tree, stackSizes, binary, geometry::kBvhStackSize - stack);
        const glm::vec3 least = tree[binary].least, most = tree[binary].most;
        const std::array grids = {Grid(least.x, most.x), Grid(least.y, most.y),
                                  Grid(least.z, most.z)};
        const glm::uvec3 corner = glm::floatBitsToUint(least);
        glm::uvec4 frame(corner,
                         grids[0].exponent | grids[1].exponent << 8 | grids[2].exponent << 16);
        glm::uvec4 low(0, 0, 0, static_cast<std::uint32_t>(pending.size()));
        glm::uvec4 high(0, 0, 0, static_cast<std::uint32_t>(folded.order.size()));
        std::uint32_t kinds = 0;
        int inner = 0;
        for (int slot = 0; slot < children.count; ++slot)
            if (!tree[children.nodes[slot]].leaf()) ++inner;
        const int below = stack + std::max(inner - 1, 0);
        folded.stackSize = std::max(folded.stackSize, below);
        for (int slot = 0; slot < children.count; ++slot) {
            const BinaryNode& child = tree[children.nodes[slot]];
            if (child.count == 0) continue;
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] |= grids[axis].below(child.least[axis]) << (8 * slot);
                high[axis] |= grids[axis].above(child.most[axis]) << (8 * slot);
            }
            if (child.leaf()) {
                kinds |= child.count << (4 * slot);
                for (std::uint32_t i = 0; i < child.count; ++i)
                    folded.order.push_back(child.first + i);
            } else {
                kinds |= geometry::kBvhInner << (4 * slot);
                pending.push_back({children.nodes[slot], below});
            }
        }
        low.w |= (kinds & 255u) << 24;
        high.w |= (kinds >> 8) << 24;
        folded.texels.insert(folded.texels.end(), {frame, low, high});
    }
    return folded;
}

std::vector<BvhItem> itemsOf(std::span<const Mesh* const> parts, std::vector<BvhSource>& sources) {
    std::size_t count = 0;
    for (const Mesh* part : parts) count += part->triangles.size();
    if (count > kMaxTriangles)
        throw Error(
            fmt::format("{} triangles; at most {} can be traced at once: simplify the model", count,
                        kMaxTriangles));
    std::vector<BvhItem> items;
    items.reserve(count);
    sources.reserve(count);
    for (std::size_t part = 0; part < parts.size(); ++part) {
        const Mesh& mesh = *parts[part];
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const glm::uvec3 t = mesh.triangles[i];
            const glm::vec3 a = mesh.positions[t.x], b = mesh.positions[t.y],
                            c = mesh.positions[t.z];
            const glm::vec3 least = glm::min(a, glm::min(b, c)), most = glm::max(a, glm::max(b, c));
            const glm::vec3 sum = a + b + c;
            if (!std::isfinite(sum.x) || !std::isfinite(sum.y) || !std::isfinite(sum.z))
                throw Error(fmt::format("triangle {} of part {}: a position is not a finite number",
                                        i, part));
            items.push_back({least, static_cast<std::uint32_t>(items.size()), most});
            sources.push_back({static_cast<std::uint32_t>(part), static_cast<std::uint32_t>(i)});
        }
    }
    return items;
}

// Whole rows of the texture, so that it can be filled by one call.
std::size_t wholeRows(std::size_t texels) {
    constexpr std::size_t width = kBvhTextureWidth;
    return std::max<std::size_t>((texels + width - 1) / width, 1) * width;
}

}  // namespace

Bvh buildBvh(std::span<const Mesh* const> parts) {
    std::vector<BvhSource> sources;
    std::vector<BvhItem> items = itemsOf(parts, sources);
    Bvh bvh;
    if (items.empty()) {
        bvh.nodeCount = 1;  // a root without children
        bvh.nodes.resize(wholeRows(3), glm::uvec4(0));
        bvh.triangles.resize(wholeRows(3), glm::vec4(0.0f));
        bvh.normals.resize(wholeRows(3), glm::vec4(0.0f));
        return bvh;
    }

    const std::vector<BinaryNode> tree = detail::buildBinaryTree(items, kMaxDepth);
    Folded folded = fold(tree);
    TUKOR_ASSERT(folded.stackSize <= geometry::kBvhStackSize);

    bvh.nodeCount = static_cast<int>(folded.texels.size() / 3);
    bvh.stackSize = folded.stackSize;
    bvh.nodes = std::move(folded.texels);
    bvh.nodes.resize(wholeRows(bvh.nodes.size()), glm::uvec4(0));
    bvh.triangles.resize(wholeRows(3 * items.size()), glm::vec4(0.0f));
    bvh.normals.resize(wholeRows(3 * items.size()), glm::vec4(0.0f));
    bvh.sources.resize(items.size());
    parallelFor(0, static_cast<int>(items.size()), 8192, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            const std::uint32_t rank = items[folded.order[i]].triangle;
            const BvhSource source = sources[rank];
            bvh.sources[i] = source;
            const Mesh& mesh = *parts[source.part];
            const glm::uvec3 t = mesh.triangles[source.triangle];
            for (int corner = 0; corner < 3; ++corner) {
                const bool first = corner == 0;
                bvh.triangles[3 * i + corner] =
                    glm::vec4(mesh.positions[t[corner]], first ? static_cast<float>(rank) : 0.0f);
                if (!mesh.normals.empty())
                    bvh.normals[3 * i + corner] = glm::vec4(mesh.normals[t[corner]], 0.0f);
            }
            bvh.normals[3 * i].w = static_cast<float>(source.part);
        }
    });
    return bvh;
}

}  // namespace tukor

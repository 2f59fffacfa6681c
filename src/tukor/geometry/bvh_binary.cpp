#include "tukor/geometry/bvh_binary.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

#include "tukor/base/parallel.h"

namespace tukor::detail {

namespace {

constexpr int kBins = 16;
// Meeting a node costs about as much as meeting a triangle: three texels each.
constexpr float kNodeCost = 1.0f, kTriangleCost = 1.0f;

struct Box {
    glm::vec3 least{std::numeric_limits<float>::max()};
    glm::vec3 most{std::numeric_limits<float>::lowest()};

    void include(glm::vec3 low, glm::vec3 high) {
        least = glm::min(least, low);
        most = glm::max(most, high);
    }
    [[nodiscard]] float area() const {
        const glm::vec3 d = most - least;
        return d.x * d.y + d.y * d.z + d.z * d.x;
    }
};

struct Bin {
    Box box;
    std::uint32_t count = 0;
};

// Twice the centre: its order is all that counts.
glm::vec3 centreOf(const BvhItem& item) {
    return item.least + item.most;
}

struct Split {
    std::uint32_t left;  // items to the left; 0: make a leaf
    Box boxes[2];
};

class Builder {
public:
    Builder(std::vector<BvhItem>& items, int maxDepth) : items_(items), maxDepth_(maxDepth) {}

    std::vector<BinaryNode> build() {
        BinaryNode root{};
        Box box;
        for (const BvhItem& item : items_) box.include(item.least, item.most);
        root.least = box.least;
        root.most = box.most;
        root.count = static_cast<std::uint32_t>(items_.size());
        std::vector<BinaryNode> nodes{root};

        // From the top level by level, until there is enough to do for every core; then every
        // subtree for itself.
        std::vector<std::uint32_t> level{0}, subtrees;
        for (int depth = 0; !level.empty(); ++depth) {
            std::vector<Split> splits(level.size());
            parallelFor(0, static_cast<int>(level.size()), 1, [&](int begin, int end) {
                for (int i = begin; i < end; ++i) splits[i] = split(nodes[level[i]], depth);
            });
            std::vector<std::uint32_t> next;
            for (std::size_t i = 0; i < level.size(); ++i) {
                if (splits[i].left == 0) continue;
                const auto child = adopt(nodes, level[i], splits[i]);
                for (std::uint32_t side : {child, child + 1})
                    (nodes[side].count > kSubtreeSize ? next : subtrees).push_back(side);
            }
            depths_.resize(nodes.size(), depth + 1);
            level = std::move(next);
        }
        std::vector<std::vector<BinaryNode>> grown(subtrees.size());
        parallelFor(0, static_cast<int>(subtrees.size()), 1, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                grown[i].push_back(nodes[subtrees[i]]);
                grow(grown[i], 0, depths_[subtrees[i]]);
            }
        });
        for (std::size_t i = 0; i < subtrees.size(); ++i) {
            const auto offset = static_cast<std::uint32_t>(nodes.size()) - 1;
            for (BinaryNode& node : grown[i])
                if (!node.leaf()) node.child += offset;
            nodes[subtrees[i]] = grown[i].front();
            nodes.insert(nodes.end(), grown[i].begin() + 1, grown[i].end());
        }
        return nodes;
    }

private:
    // Small enough for some hundred subtrees of a usual model, large enough to be worth a task.
    static constexpr std::uint32_t kSubtreeSize = 2048;

    static std::uint32_t adopt(std::vector<BinaryNode>& nodes, std::uint32_t parent,
                               const Split& split) {
        const auto child = static_cast<std::uint32_t>(nodes.size());
        nodes[parent].child = child;
        const BinaryNode node = nodes[parent];
        const std::uint32_t counts[2] = {split.left, node.count - split.left};
        for (int side = 0; side < 2; ++side)
            nodes.push_back({split.boxes[side].least, split.boxes[side].most,
                             side == 0 ? node.first : node.first + split.left, counts[side]});
        return child;
    }

    void grow(std::vector<BinaryNode>& nodes, std::uint32_t index, int depth) {
        const Split halves = split(nodes[index], depth);
        if (halves.left == 0) return;
        const std::uint32_t child = adopt(nodes, index, halves);
        grow(nodes, child, depth + 1);
        grow(nodes, child + 1, depth + 1);
    }

    // Levels that splitting in the middle needs for `count` items.
    static int levelsFor(std::uint32_t count) {
        const std::uint32_t leaves = (count + kMaxLeafSize - 1) / kMaxLeafSize;
        return leaves <= 1 ? 0 : std::bit_width(leaves - 1);
    }

    Split split(const BinaryNode& node, int depth) {
        const auto begin = items_.begin() + node.first, end = begin + node.count;
        if (node.count <= 1) return {0, {}};
        Box centres;
        for (auto item = begin; item != end; ++item)
            centres.include(centreOf(*item), centreOf(*item));
        const glm::vec3 extent = centres.most - centres.least;
        if (depth + levelsFor(node.count) >= maxDepth_) return splitInTheMiddle(node, extent);

        std::array<std::array<Bin, kBins>, 3> bins;
        // A little less than kBins, so that the last centre is in the last bin.
        const glm::vec3 scale(extent.x > 0.0f ? (kBins - 0.001f) / extent.x : 0.0f,
                              extent.y > 0.0f ? (kBins - 0.001f) / extent.y : 0.0f,
                              extent.z > 0.0f ? (kBins - 0.001f) / extent.z : 0.0f);
        const auto binOf = [&](const BvhItem& item, int axis) {
            const float place = (centreOf(item)[axis] - centres.least[axis]) * scale[axis];
            // Overflow makes NaN or infinity: any bin will do.
            return place >= 0.0f && place < kBins ? static_cast<int>(place) : 0;
        };
        for (auto item = begin; item != end; ++item)
            for (int axis = 0; axis < 3; ++axis) {
                Bin& bin = bins[axis][binOf(*item, axis)];
                bin.box.include(item->least, item->most);
                ++bin.count;
            }

        float best = std::numeric_limits<float>::infinity();
        int bestAxis = -1, bestBin = 0;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(scale[axis] > 0.0f)) continue;
            std::array<float, kBins> rightCost{};
            Bin right, left;
            for (int i = kBins - 1; i > 0; --i) {
                right.box.include(bins[axis][i].box.least, bins[axis][i].box.most);
                right.count += bins[axis][i].count;
                rightCost[i] = right.count == 0 ? 0.0f : right.box.area() * float(right.count);
            }
            for (int i = 0; i + 1 < kBins; ++i) {
                left.box.include(bins[axis][i].box.least, bins[axis][i].box.most);
                left.count += bins[axis][i].count;
                if (left.count == 0 || left.count == node.count) continue;
                const float cost = left.box.area() * float(left.count) + rightCost[i + 1];
                if (cost < best) {
                    best = cost;
                    bestAxis = axis;
                    bestBin = i;
                }
            }
        }
        const float area = node.area();
        if (node.count <= kMaxLeafSize &&
            !(kNodeCost * area + kTriangleCost * best < kTriangleCost * area * float(node.count)))
            return {0, {}};
        if (bestAxis < 0) return splitInTheMiddle(node, extent);

        Split result{0, {}};
        for (int i = 0; i < kBins; ++i) {
            const Bin& bin = bins[bestAxis][i];
            if (bin.count > 0)
                result.boxes[i <= bestBin ? 0 : 1].include(bin.box.least, bin.box.most);
        }
        const auto middle = std::partition(
            begin, end, [&](const BvhItem& item) { return binOf(item, bestAxis) <= bestBin; });
        result.left = static_cast<std::uint32_t>(middle - begin);
        return result;
    }

    Split splitInTheMiddle(const BinaryNode& node, glm::vec3 extent) {
        if (node.count <= kMaxLeafSize) return {0, {}};
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                         : extent.y >= extent.z                       ? 1
                                                                      : 2;
        const auto begin = items_.begin() + node.first, end = begin + node.count;
        // A whole number of full leaves on the left keeps the promise on the depth.
        const std::uint32_t leaves = (node.count + kMaxLeafSize - 1) / kMaxLeafSize;
        const std::uint32_t left = std::bit_floor(leaves - 1) * kMaxLeafSize;
        std::nth_element(begin, begin + left, end, [&](const BvhItem& a, const BvhItem& b) {
            const float p = centreOf(a)[axis], q = centreOf(b)[axis];
            return p != q ? p < q : a.triangle < b.triangle;
        });
        Split result{left, {}};
        for (auto item = begin; item != end; ++item)
            result.boxes[item < begin + left ? 0 : 1].include(item->least, item->most);
        return result;
    }

    std::vector<BvhItem>& items_;
    int maxDepth_;
    std::vector<int> depths_;  // of the nodes above the subtrees
};

}  // namespace

std::vector<BinaryNode> buildBinaryTree(std::vector<BvhItem>& items, int maxDepth) {
    return Builder(items, maxDepth).build();
}

}  // namespace tukor::detail

#include "game/simulation/box_tree.h"

#include <array>
#include <utility>

namespace oblong {
namespace {

constexpr std::uint32_t kMostInLeaf = 4;

using Axis = World Vec3<World>::*;

Axis longest_axis(const Box& area) {
    constexpr std::array<Axis, 3> kAxes{&Vec3<World>::x, &Vec3<World>::y, &Vec3<World>::z};
    const auto length = [&](Axis axis) { return widening_difference(area.maxs.*axis, area.mins.*axis); };
    return *std::max_element(kAxes.begin(), kAxes.end(), [&](Axis a, Axis b) { return length(a) < length(b); });
}

}  // namespace

BoxTree::BoxTree(std::vector<Entry> entries) : entries_(std::move(entries)) {
    if (!entries_.empty()) add_node(0, static_cast<std::uint32_t>(entries_.size()));
}

void BoxTree::add_node(std::uint32_t first, std::uint32_t end) {
    Box bounds = entries_[first].box;
    for (std::uint32_t i = first; i < end; ++i) bounds = bounds.united(entries_[i].box);
    const std::size_t node = nodes_.size();
    nodes_.push_back({bounds, first, end});
    if (end - first <= kMostInLeaf) {
        std::sort(entries_.data() + first, entries_.data() + end,
                  [](const Entry& a, const Entry& b) { return a.number < b.number; });
        return;
    }
    const Axis axis = longest_axis(bounds);
    const std::uint32_t middle = first + (end - first) / 2;
    Entry* const entries = entries_.data();
    std::nth_element(entries + first, entries + middle, entries + end, [axis](const Entry& a, const Entry& b) {
        return std::pair(a.box.mins.*axis, a.number) < std::pair(b.box.mins.*axis, b.number);
    });
    add_node(first, middle);
    nodes_[node].second_child = static_cast<std::uint32_t>(nodes_.size());
    add_node(middle, end);
}

std::vector<std::uint32_t> BoxTree::overlapping(const Box& area) const {
    std::vector<std::uint32_t> found;
    std::uint32_t from = 0;
    do {
        const Part part = part_overlapping(area, from);
        found.insert(found.end(), part.numbers.begin(), part.numbers.end());
        from = part.next;
    } while (from != 0);
    std::sort(found.begin(), found.end());
    return found;
}

BoxTree::Part BoxTree::part_overlapping(const Box& area, std::uint32_t from) const {
    Part part;
    if (!nodes_.empty()) collect_part(0, area, from, part);
    std::sort(part.numbers.begin(), part.numbers.end());
    return part;
}

// Returns false when a bound is reached.
bool BoxTree::collect_part(std::uint32_t index, const Box& area, std::uint32_t from, Part& part) const {
    const Node& node = nodes_[index];
    if (node.end <= from) return true;
    if (part.looks >= kMostLooks || part.numbers.size() + kMostInLeaf > kMostFound) {
        part.next = std::max(node.first, from);
        return false;
    }
    ++part.looks;
    if (!node.bounds.overlaps(area)) return true;
    if (node.second_child != 0)
        return collect_part(index + 1, area, from, part) && collect_part(node.second_child, area, from, part);
    for (std::uint32_t i = std::max(node.first, from); i < node.end; ++i)
        if (entries_[i].box.overlaps(area)) part.numbers.push_back(entries_[i].number);
    return true;
}

}  // namespace oblong

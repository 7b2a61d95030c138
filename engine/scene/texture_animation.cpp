#include "engine/scene/texture_animation.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "engine/base/input_error.h"
#include "engine/base/table.h"

namespace oblong {

namespace {

/// The frames of one name: [0] digits, [1] letters; none: missing.
struct NamedFrames {
    NamedFrames() {
        for (auto& frames : of_kind) frames.fill(TextureIndex::none());
    }
    std::array<std::array<TextureIndex, TextureAnimations::kMostFrames>, 2> of_kind;
    std::string fault;  ///< empty: none
};

struct FrameName {
    int kind, frame;
    std::string name;
};

/// Capital letters are valid too, as in Quake.
std::optional<FrameName> frame_name_of(const std::string& texture) {
    const char letter = texture[1];
    if (letter >= '0' && letter <= '9') return FrameName{0, letter - '0', texture.substr(2)};
    if (letter >= 'a' && letter <= 'j') return FrameName{1, letter - 'a', texture.substr(2)};
    if (letter >= 'A' && letter <= 'J') return FrameName{1, letter - 'A', texture.substr(2)};
    return std::nullopt;
}

std::map<std::string, NamedFrames> frames_by_name(const Level& level, std::vector<std::string>& warnings) {
    std::map<std::string, NamedFrames> names;
    for (const TextureIndex index : level.textures.indices()) {
        const std::string& texture = level.textures[index].name;
        if (texture.size() < 2 || texture[0] != '+') continue;
        const auto found = frame_name_of(texture);
        if (!found) {
            warnings.push_back(printable("texture '" + texture + "': expected a frame 0 to 9 or a to j behind the +"));
            continue;
        }
        NamedFrames& frames = names[found->name];
        TextureIndex& place = item(item(frames.of_kind, found->kind), found->frame);
        if (!place.is_none()) frames.fault = "'" + texture + "' is there twice, expected once";
        place = index;
    }
    return names;
}

const MipTexture& first_of(const Level& level, const NamedFrames& frames) {
    for (const auto& of_kind : frames.of_kind)
        for (const TextureIndex index : of_kind)
            if (!index.is_none()) return level.textures[index];
    return level.textures.front();  // not reached: a name has a frame
}

/// What is wrong with the frames of one kind: a gap, or a size that differs from the first frame's. Empty if nothing.
std::string fault_of(const Level& level, int kind, const std::string& name, const NamedFrames& frames) {
    const auto& of_kind = item(frames.of_kind, kind);
    const MipTexture& first = first_of(level, frames);
    const auto last = std::find_if(of_kind.rbegin(), of_kind.rend(), [](TextureIndex i) { return !i.is_none(); });
    for (int frame = 0; frame < of_kind.rend() - last; ++frame) {
        const TextureIndex index = item(of_kind, frame);
        if (index.is_none()) {
            const char letter = static_cast<char>((kind == 0 ? '0' : 'a') + frame);
            return std::string("frame '+") + letter + name + "' is missing, expected no gap";
        }
        const MipTexture& texture = level.textures[index];
        if (texture.width != first.width || texture.height != first.height)
            return "'" + texture.name + "' and '" + first.name + "' differ in size, expected frames of one size";
    }
    return "";
}

std::vector<TextureIndex> present(const std::array<TextureIndex, TextureAnimations::kMostFrames>& frames) {
    std::vector<TextureIndex> sequence(frames.begin(), frames.end());
    std::erase_if(sequence, [](TextureIndex index) { return index.is_none(); });
    return sequence;
}

}  // namespace

TextureAnimations::TextureAnimations(const Level& level, std::vector<std::string>& warnings) {
    for (auto& [name, frames] : frames_by_name(level, warnings)) {
        for (const int kind : {0, 1})
            if (frames.fault.empty()) frames.fault = fault_of(level, kind, name, frames);
        if (!frames.fault.empty()) {
            warnings.push_back(printable("animated texture '" + name + "': " + frames.fault + "; it stands still"));
            continue;
        }
        const Sequence digits = present(frames.of_kind[0]), letters = present(frames.of_kind[1]);
        if (digits.size() + letters.size() < 2) continue;
        of_texture_.resize(level.textures.size());
        add(digits, letters);
    }
}

void TextureAnimations::add(const Sequence& digits, const Sequence& letters) {
    const Index<Sequence> first(sequences_.count()), last(first.number() + !digits.empty() - letters.empty());
    for (const Sequence& frames : {digits, letters})
        if (!frames.empty()) sequences_.push_back(frames);
    for (const TextureIndex texture : digits) of_texture_[texture] = {first, last};
    for (const TextureIndex texture : letters) of_texture_[texture] = {last, first};
}

TextureIndex TextureAnimations::shown(TextureIndex texture, bool is_switched, std::int64_t time_ms) const {
    if (!is_animated(texture)) return texture;
    const Pair& pair = of_texture_[texture];
    const Sequence& frames = sequences_[is_switched ? pair.switched : pair.normal];
    return item(frames, time_ms / kFrameMs % std::ssize(frames));
}

}  // namespace oblong

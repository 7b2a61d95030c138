#include "tests/fuzz/common/entity_mutator.h"

#include <algorithm>

#include "engine/level/entity_classes.h"
#include "tests/map/map_source.h"

namespace oblong::fuzz {
namespace {

constexpr const char* kNames[] = {"a", "b", "c", "d"};
constexpr const char* kExternalMaps[] = {"room", "self", "no_such"};
constexpr const char* kTextures[] = {"wall",   "floor",  "*water", "*lava",   "sky",  "mirror", "{bars",
                                     "+0lamp", "*slime", "clip",   "trigger", "skip", "hint",   "no_such"};

int coordinate(std::minstd_rand& random) {
    return below(16, random) == 0 ? static_cast<int>(odd_number(random) % 100'000)
                                  : static_cast<int>(below(33, random)) * 8 - 128;
}

std::string number(std::minstd_rand& random) {
    const std::size_t kind = below(8, random);
    if (kind == 0) return std::to_string(odd_number(random));
    if (kind == 1) return "0." + std::to_string(below(1000, random));
    return kind == 2 ? "-1" : std::to_string(below(64, random) * 4);
}

std::string numbers(std::size_t count, std::minstd_rand& random) {
    std::string text = number(random);
    while (--count > 0) text += " " + number(random);
    return text;
}

std::string place(std::minstd_rand& random) {
    std::string text;
    for (int axis = 0; axis < 3; ++axis) text += std::to_string(coordinate(random)) + (axis < 2 ? " " : "");
    return text;
}

std::string value_of(const EntityKey& key, std::minstd_rand& random) {
    if (key.name == "origin") return place(random);
    if (key.name == "model") return "*" + std::to_string(below(9, random));
    if (below(12, random) == 0) return number(random);
    if (key.name == "_surface") return one_of(kTextures, random);
    if (key.name == "_external_map") return one_of(kExternalMaps, random);
    if (key.name == "_external_map_classname") return std::string(one_of(entity_classes(), random).name);
    using enum KeyKind;
    if (key.kind == Text) return below(2, random) ? "mmamm" : std::string(key.usual);
    if (key.kind == Numbers) return numbers(key.least + below(1u + key.most - key.least, random), random);
    if ((key.kind == Choice || key.kind == Flags) && !key.values.empty())
        return std::string(one_of(key.values, random).value);
    if (key.kind == Name || key.kind == Target || key.kind == Place) return one_of(kNames, random);
    return key.kind == Texture ? "{bars" : number(random);
}

std::string pair_of(const EntityClass& its_class, std::minstd_rand& random) {
    std::vector<const EntityKey*> keys;
    for (const EntityKey& key : keys_of_all()) keys.push_back(&key);
    for (const auto& some : its_class.keys)
        for (const EntityKey& key : some) keys.push_back(&key);
    if (keys.empty()) return "";
    const EntityKey& key = *one_of(keys, random);
    return "\"" + std::string(key.name.substr(0, key.name.find('#'))) + "\" \"" + value_of(key, random) + "\"\n";
}

std::string box_brush(std::minstd_rand& random) {
    test::Whole low, high;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = coordinate(random);
        high[axis] = low[axis] + 8 + static_cast<int>(below(12, random)) * 8;
    }
    return test::box(low, high, one_of(kTextures, random));
}

// Of the kinds that a map's source can have.
std::string any_brush(std::minstd_rand& random) {
    const test::Whole middle{coordinate(random), coordinate(random), coordinate(random)};
    const int size = 8 + static_cast<int>(below(10, random)) * 8, sides = 3 + static_cast<int>(below(6, random));
    const std::size_t kind = below(6, random);
    if (kind == 0) return test::prism(middle, size, size, sides, one_of(kTextures, random));
    if (kind == 1) return test::ball(middle, size, 3, sides, one_of(kTextures, random));
    return box_brush(random);
}

std::string new_entity(bool has_brushes, std::minstd_rand& random) {
    const EntityClass& its_class = one_of(entity_classes(), random);
    std::string text = "{\n\"classname\" \"" + std::string(its_class.name) + "\"\n\"targetname\" \"" +
                       one_of(kNames, random) + "\"\n\"target\" \"" + one_of(kNames, random) + "\"\n";
    for (std::size_t pairs = below(5, random); pairs > 0; --pairs) text += pair_of(its_class, random);
    const bool is_brush = its_class.shape == ClassShape::Brush;
    if (!is_brush) text += "\"origin\" \"" + place(random) + "\"\n";
    if (is_brush && !has_brushes) text += "\"model\" \"*" + std::to_string(1 + below(8, random)) + "\"\n";
    if (is_brush && has_brushes) text += box_brush(random);
    return text + "}\n";
}

// The place behind one of the lines that name a class.
std::size_t class_line_end(const std::string& text, std::minstd_rand& random) {
    const std::size_t found = text.find("\"classname\"", below(text.size(), random));
    return found == std::string::npos ? found : text.find('\n', found);
}

void replace_coordinate(std::string& text, std::minstd_rand& random) {
    const std::size_t begin = text.find_first_of("-0123456789", below(text.size(), random));
    if (begin == std::string::npos) return;
    const std::size_t end = std::min(text.find_first_not_of("-.0123456789", begin), text.size());
    text.replace(begin, end - begin, below(2, random) ? number(random) : std::to_string(coordinate(random)));
}

void replace_texture(std::string& text, std::minstd_rand& random) {
    const std::size_t found = text.find(") wall ", below(text.size(), random));
    if (found != std::string::npos) text.replace(found + 2, 4, one_of(kTextures, random));
}

}  // namespace

void mutate_entities(std::string& text, bool has_brushes, std::minstd_rand& random) {
    const std::size_t line_end = class_line_end(text, random);
    const std::size_t kind = below(10, random);
    const bool has_line = line_end != std::string::npos;
    if (kind < 2) {
        text += new_entity(has_brushes, random);
    } else if (kind < 4) {
        if (has_line) text.insert(line_end + 1, pair_of(one_of(entity_classes(), random), random));
    } else if (kind < 6) {
        if (has_brushes && has_line) text.insert(line_end + 1, box_brush(random));
    } else if (kind < 8) {
        replace_coordinate(text, random);
    } else if (kind == 8) {
        replace_texture(text, random);
    } else {
        Bytes bytes;
        set_text(bytes, text);
        mutate_bytes(bytes);
        text = text_of(bytes);
    }
}

std::string made_map(Input seeds) {
    constexpr std::size_t kSeed = 4, kMost = 24;
    std::string brushes = test::room({-128, -128, -128}, {128, 128, 128}), entities;
    for (std::size_t at = 0; at + kSeed <= std::min(seeds.size(), kSeed * kMost); at += kSeed) {
        std::uint32_t seed = 0;
        for (const std::uint8_t byte : seeds.subspan(at, kSeed)) seed = seed << 8 | byte;
        std::minstd_rand random(seed / 2 + 1);
        if (seed % 2 == 0)
            brushes += any_brush(random);
        else
            entities += new_entity(true, random);
    }
    return test::level(brushes, test::entity_at("info_player_start", {0, 0, -100}) + entities);
}

}  // namespace oblong::fuzz

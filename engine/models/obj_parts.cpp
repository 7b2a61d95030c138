#include "engine/models/obj_parts.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "engine/base/input_error.h"
#include "engine/base/table.h"
#include "engine/base/text.h"
#include "engine/io/doubles.h"
#include "engine/io/files.h"
#include "engine/mesh/mesh.h"
#include "engine/pictures/picture.h"

namespace oblong {
namespace {

constexpr int kMostCorners = 255;  ///< of a face: tinyobjloader counts them in a byte

std::optional<int> parse_int(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    int number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return number;
}

/// The number of v, vt or vn lines so far, and the largest index of one in a face, with its line.
struct ObjRecords {
    const char* name;
    std::int64_t count = 0, greatest = 0, greatest_line = 0;
};

class ObjChecker {
  public:
    explicit ObjChecker(double scale) : coordinate_limit_(kMeshLimit / scale) {}

    ObjSummary check(std::string_view text) {
        for (; !text.empty(); text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1)) {
            ++line_;
            check_line(text.substr(0, text.find('\n')));
        }
        for (const ObjRecords* records : {&vertices_, &texcoords_}) check_greatest(*records);
        if (normals_.greatest > normals_.count) missing_normal_line_ = normals_.greatest_line;
        if (missing_normal_line_ > 0)
            summary_.warnings.push_back(at_line(missing_normal_line_) +
                                        ": a normal that the file does not have: those are computed");
        if (summary_.faces == 0) throw InputError("file", "has no faces, expected lines of f");
        return summary_;
    }

  private:
    void check_line(std::string_view line) {
        const std::string_view kind = take_word(line);
        if (kind == "v") check_numbers(line, vertices_, 3, coordinate_limit_);
        if (kind == "vt") check_numbers(line, texcoords_, 1, kFarthestTexcoord);
        if (kind == "vn") check_numbers(line, normals_, 3, 1e30);
        if (kind == "f") check_face(line);
        if (kind == "s") summary_.has_smoothing_groups = true;
    }

    /// Checks at least `least` numbers; the absolute values of the first three are below a limit.
    void check_numbers(std::string_view words, ObjRecords& records, int least, double limit) {
        ++records.count;
        int count = 0;
        for (std::string_view word = take_word(words); !word.empty(); word = take_word(words)) {
            const std::optional<double> number = parse_double(word);
            if (!number || !std::isfinite(*number))
                fail(std::string(records.name) + " '" + std::string(word) + "', expected a number");
            if (++count <= 3 && std::abs(*number) >= limit)
                fail(std::string(records.name) + " " + std::string(word) + ", expected less than " +
                     std::to_string(limit) + " either way");
        }
        if (count < least)
            fail(std::string(records.name) + " of " + std::to_string(count) + " numbers, expected " +
                 std::to_string(least) + " or more");
    }

    void check_face(std::string_view words) {
        ++summary_.faces;
        int corners = 0;
        for (std::string_view word = take_word(words); !word.empty(); word = take_word(words)) {
            check_corner(word);
            ++corners;
        }
        if (corners < 3 || corners > kMostCorners)
            fail("a face of " + std::to_string(corners) + " corners, expected 3 to " + std::to_string(kMostCorners));
    }

    /// "3", "3/1", "3//2" or "3/1/2".
    void check_corner(std::string_view word) {
        std::string_view rest = word;
        const std::array<ObjRecords*, 3> kinds{&vertices_, &texcoords_, &normals_};
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            const std::size_t slash = std::min(rest.find('/'), rest.size());
            const std::string_view number = rest.substr(0, slash);
            if (i != 1 || !number.empty() || slash == rest.size()) check_index(word, number, *kinds[i]);
            if (slash == rest.size()) return;
            rest.remove_prefix(slash + 1);
        }
        fail("corner '" + std::string(word) + "', expected vertex/texture/normal");
    }

    void check_index(std::string_view word, std::string_view text, ObjRecords& records) {
        const std::optional<int> index = parse_int(text);
        if (!index) fail("corner '" + std::string(word) + "', expected numbers of vertex/texture/normal");
        if (*index < 0 && -std::int64_t{*index} <= records.count) return;
        const bool is_missing_normal = *index < 0 && &records == &normals_;
        if (is_missing_normal) missing_normal_line_ = line_;
        if (is_missing_normal) return;
        if (*index <= 0)
            fail(std::string(records.name) + " " + std::to_string(*index) + ", expected 1 and up" +
                 (records.count > 0 ? ", or " + bounds_text(-1, -records.count) : ""));
        if (*index <= records.greatest) return;
        records.greatest = *index;
        records.greatest_line = line_;
    }

    /// Faces may refer to later lines.
    static void check_greatest(const ObjRecords& records) {
        if (records.greatest <= records.count) return;
        throw InputError(
            at_line(records.greatest_line),
            std::string(records.name) + " " + std::to_string(records.greatest) + ", expected " +
                (records.count > 0 ? bounds_text(1, records.count) : "none: the file has no lines of them"));
    }

    [[noreturn]] void fail(const std::string& what_is_wrong) const { throw InputError(at_line(line_), what_is_wrong); }

    double coordinate_limit_;
    std::int64_t line_ = 0, missing_normal_line_ = 0;  ///< the second: 0: none
    ObjRecords vertices_{"vertex"}, texcoords_{"texture coordinate"}, normals_{"normal"};
    ObjSummary summary_;
};

/// Whether a line has a name of the user's, in which # and a backslash mean themselves.
bool has_name(std::string_view kind) {
    constexpr std::array<std::string_view, 4> kKinds{"usemtl", "mtllib", "newmtl", "map_Kd"};
    return std::find(kKinds.begin(), kKinds.end(), kind) != kKinds.end();
}

/// Lines that the mesh does not need, but for which tinyobjloader would take many times their size.
bool is_unused(std::string_view kind) {
    constexpr std::array<std::string_view, 5> kKinds{"o", "g", "l", "p", "t"};
    return std::find(kKinds.begin(), kKinds.end(), kind) != kKinds.end();
}

}  // namespace

std::string as_word(std::string_view name) {
    while (!name.empty() && is_space(name.back())) name.remove_suffix(1);
    while (!name.empty() && is_space(name.front())) name.remove_prefix(1);
    std::string word(name);
    for (std::size_t at = 0; (at = word.find("\\ ", at)) != std::string::npos;) word.replace(at, 2, 1, kBlankInName);
    std::replace_if(word.begin(), word.end(), is_space, kBlankInWord);
    std::replace(word.begin(), word.end(), '\\', '/');
    return word;
}

std::string simple_obj(std::string file) {
    const std::string whole = plain_text(std::move(file));
    std::string_view text = whole;
    std::string simple;
    simple.reserve(text.size());
    std::size_t lines = 1;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + (text.substr(end, 2) == "\r\n" ? 2 : 1), text.size()));
        std::string_view rest = line;
        const std::string_view kind = take_word(rest);
        if (is_unused(kind)) line = {};
        const bool is_named = has_name(kind), is_word = kind == "usemtl" || kind == "mtllib";
        if (!is_named) line = line.substr(0, line.find('#'));
        if (!is_named && line.ends_with('\\')) {
            simple.append(line.substr(0, line.size() - 1)) += ' ';
            ++lines;
        } else {
            if (is_word) simple.append(kind) += ' ';
            simple.append(is_word ? as_word(rest) : std::string(line)).append(std::exchange(lines, 1), '\n');
        }
    }
    return simple;
}

ObjSummary check_obj(std::string_view text, double scale) {
    return ObjChecker(scale).check(text);
}

namespace {

constexpr std::int32_t kLargestSkinSide = 4096;
constexpr double kRounding = 1.0 / 1024;  ///< of coordinates in files, repetitions

/// The number of repetitions of a skin along a side of `size` texels, from the whole number below `least`.
std::int32_t repetitions(double least, double greatest, std::int32_t size, bool& is_cut) {
    const double wanted = std::max(std::ceil(greatest - kRounding) - std::floor(least + kRounding), 1.0);
    const std::int32_t most = std::max(kLargestSkinSide / size, 1);
    is_cut |= wanted > most;
    return static_cast<std::int32_t>(std::min<double>(wanted, most));
}

std::int32_t whole_repetitions(double least) {
    return static_cast<std::int32_t>(std::floor(least + kRounding));
}

Skin repeated(const Skin& skin, std::int32_t across, std::int32_t down) {
    Skin larger{skin.name, skin.width * across, skin.height * down, {}};
    for (std::int32_t y = 0; y < larger.height; ++y)
        for (std::int32_t x = 0; x < larger.width; ++x)
            larger.texels.push_back(item(skin.texels, y % skin.height * skin.width + x % skin.width));
    return larger;
}

}  // namespace

void PlaceRange::include(const SkinPlace& place) {
    least = {std::min(least.u, place.u), std::min(least.v, place.v)};
    greatest = {std::max(greatest.u, place.u), std::max(greatest.v, place.v)};
}

MeshTexel SkinScale::texel_at(const SkinPlace& place) const {
    return {fixed_of<Texel>((place.u - first_u) * width), fixed_of<Texel>((place.v - first_v) * height)};
}

SkinScale repeat_skin(Skin& skin, const PlaceRange& range, std::int64_t& texels_left,
                      std::vector<std::string>& warnings) {
    if (range.least.u > range.greatest.u) return {};
    const SkinScale scale{whole_repetitions(range.least.u), whole_repetitions(range.least.v),
                          static_cast<double>(skin.width), static_cast<double>(skin.height)};
    bool is_cut = false;
    std::int32_t across = repetitions(range.least.u, range.greatest.u, skin.width, is_cut),
                 down = repetitions(range.least.v, range.greatest.v, skin.height, is_cut);
    const std::int64_t texels = std::int64_t{skin.width} * across * skin.height * down;
    const bool fits = across * down == 1 || texels <= texels_left;
    if (!fits) across = down = 1;
    if (across > 1 || down > 1) {
        skin = repeated(skin, across, down);
        texels_left -= texels;
    }
    if (!fits)
        warnings.push_back("material '" + skin.name +
                           "' is not repeated, since the model's pictures are too large for it");
    else if (is_cut)
        warnings.push_back("material '" + skin.name + "' is repeated over more than " +
                           std::to_string(kLargestSkinSide) + " texels: beyond, its border is shown");
    return scale;
}

Skin resized(const Skin& skin, const Skin& other) {
    if (skin.width == other.width && skin.height == other.height) return skin;
    Skin result{skin.name, other.width, other.height, {}};
    for (std::int32_t y = 0; y < result.height; ++y)
        for (std::int32_t x = 0; x < result.width; ++x)
            result.texels.push_back(
                item(skin.texels, y * skin.height / result.height * skin.width + x * skin.width / result.width));
    return result;
}

}  // namespace oblong

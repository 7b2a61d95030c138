#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <system_error>

#include "engine/base/input_error.h"
#include "engine/base/text.h"
#include "engine/io/files.h"
#include "engine/models/obj_parts.h"

namespace oblong {
namespace {

Skin skin_of_colour(const std::string& name, Rgb8 colour, const Palette& palette) {
    return {name, 1, 1, {nearest_colour(palette, colour, kOrdinaryColours)}};
}

Rgb8 diffuse_colour(const tinyobj::material_t& material) {
    const auto channel = [&](int i) {
        const double value = material.diffuse[i];
        return static_cast<std::uint8_t>(value > 0 ? std::min(value, 1.0) * 255 + 0.5 : 0);
    };
    return {channel(0), channel(1), channel(2)};
}

/// Paths in files of other systems have backslashes.
std::string with_slashes(std::string path) {
    std::replace(path.begin(), path.end(), '\\', '/');
    return path;
}

/// An option of map_Kd before the picture's name: at most so many words follow, of which these change nothing.
struct MapOption {
    std::string_view name;
    int most;
    bool are_numbers;
    std::string_view usual;
};
constexpr std::array<MapOption, 14> kMapOptions{{{"-s", 3, true, "1 1 1"},
                                                 {"-o", 3, true, "0 0 0"},
                                                 {"-t", 3, true, "0 0 0"},
                                                 {"-mm", 2, true, "0 1"},
                                                 {"-bm", 1, true, "1"},
                                                 {"-boost", 1, true, "0"},
                                                 {"-texres", 1, true, ""},
                                                 {"-blendu", 1, false, "on"},
                                                 {"-blendv", 1, false, "on"},
                                                 {"-clamp", 1, false, "off"},
                                                 {"-cc", 1, false, "off"},
                                                 {"-imfchan", 1, false, ""},
                                                 {"-type", 1, false, ""},
                                                 {"-colorspace", 1, false, "sRGB"}}};

/// Reads the parts of a material file that are used.
class MaterialLines {
  public:
    MaterialLines(std::vector<tinyobj::material_t>& materials, std::map<std::string, int>& numbers,
                  std::string& warnings)
        : materials_(materials), numbers_(numbers), warnings_(warnings) {}

    void read(std::string_view line) {
        ++line_;
        const std::string_view kind = take_word(line);
        if (kind == "newmtl") begin(line);
        if (kind == "Kd") read_colour(line);
        if (kind == "map_Kd") read_map(line.substr(0, std::min(line.find(" #"), line.find("\t#"))));
    }

  private:
    void begin(std::string_view name) {
        if (materials_.size() >= kMostMaterials)
            throw InputError(at_line(line_),
                             "more than " + std::to_string(kMostMaterials) + " materials, expected fewer");
        const std::string word = as_word(name);
        numbers_.emplace(word, static_cast<int>(materials_.size()));
        materials_.emplace_back().name = name_of_word(word);
        std::fill_n(materials_.back().diffuse_texopt.scale, 3, 1.0);
        has_colour_ = false;
    }

    void read_colour(std::string_view words) {
        for (int channel = 0; channel < 3; ++channel) {
            const std::string word(take_word(words));
            const std::optional<double> number = parse_double(word);
            if (!number || !std::isfinite(*number))
                throw InputError(at_line(line_), "Kd '" + word + "', expected three numbers");
            if (!materials_.empty()) materials_.back().diffuse[channel] = *number;
        }
        has_colour_ = true;
    }

    void read_map(std::string_view words) {
        if (materials_.empty()) return;
        for (std::string_view rest = words;; words = rest) {
            const std::string_view name = take_word(rest);
            const auto is_named = [&](const MapOption& option) { return option.name == name; };
            const auto option = std::find_if(kMapOptions.begin(), kMapOptions.end(), is_named);
            if (option == kMapOptions.end()) break;
            read_option(*option, rest);
        }
        tinyobj::material_t& material = materials_.back();
        material.diffuse_texname = name_of_word(as_word(words));
        if (!has_colour_) std::fill_n(material.diffuse, 3, 0.6);
    }

    void read_option(const MapOption& option, std::string_view& words) {
        std::string given;
        std::array<double, 3> numbers{};
        int count = 0;
        for (std::string_view rest = words; count < option.most; words = rest, ++count) {
            const std::string_view word = take_word(rest);
            const std::optional<double> number = parse_double(word);
            if (option.are_numbers && !number) break;
            numbers[static_cast<std::size_t>(count)] = std::clamp(number.value_or(0), -1e6, 1e6);
            given.append(given.empty() ? "" : " ").append(word);
        }
        tinyobj::texture_option_t& map = materials_.back().diffuse_texopt;
        if (option.name == "-s") std::copy_n(numbers.begin(), count, map.scale);
        if (option.name == "-o") std::copy_n(numbers.begin(), count, map.origin_offset);
        if (option.name != "-s" && option.name != "-o" && given != option.usual)
            warnings_ += at_line(line_) + ": map_Kd's " + std::string(option.name) + " " + given + " is ignored\n";
    }

    std::vector<tinyobj::material_t>& materials_;
    std::map<std::string, int>& numbers_;
    std::string& warnings_;
    std::int64_t line_ = 0;
    bool has_colour_ = false;
};

/// The path of a file that the model names. Throws FileError if it is not in the model's folder.
std::string path_in(const std::filesystem::path& folder, const std::string& name) {
    const std::string path = (folder / name).string();
    if (leads_out(folder.string(), name))
        throw FileError(path, "open", "is outside of the model's folder, expected a file in it");
    return path;
}

/// The files that a line of mtllib names: one whose name has blanks, or several.
std::vector<std::string> files_of(const std::filesystem::path& folder, const std::string& word) {
    const auto is_there = [&](const std::string& file) { return !find_below({folder.string()}, file).empty(); };
    const std::string whole = name_of_word(word);
    std::vector<std::string> names = split(word, {&kBlankInWord, 1});
    for (std::string& name : names) name = name_of_word(name);
    const bool are_several = !is_there(whole) && std::any_of(names.begin(), names.end(), is_there);
    return are_several ? names : std::vector{whole};
}

}  // namespace

/// A whole word as a number; charconv refuses a plus, and lacks doubles in some libraries.
std::optional<double> parse_double(std::string_view word) {
    const std::string text(word);
    if (text.find_first_not_of("+-.0123456789eE") != std::string::npos) return std::nullopt;
    char* stop = nullptr;
    const double number = std::strtod(text.c_str(), &stop);
    if (text.empty() || *stop != '\0') return std::nullopt;
    return number;
}

std::string name_of_word(std::string word) {
    std::replace(word.begin(), word.end(), kBlankInWord, ' ');
    std::replace(word.begin(), word.end(), kBlankInName, ' ');
    return word;
}

bool ObjMaterialReader::operator()(const std::string& name, std::vector<tinyobj::material_t>* materials,
                                   std::map<std::string, int>* numbers, std::string* warning, std::string*) {
    if (++named_ > kMostMaterials)
        throw InputError("mtllib", "more than " + std::to_string(kMostMaterials) + " material files, expected fewer");
    bool is_read = !read_.empty();
    for (const std::string& file_name : files_of(folder_, name)) {
        if (file_name.empty()) continue;
        std::string file;
        std::istringstream text;
        try {
            file = path_in(folder_, file_name);
            const auto end = std::filesystem::weakly_canonical(file);
            if (read_.contains(end)) continue;
            text.str(simple_obj(read_text(file)));
            read_.insert(end);
        } catch (const FileError& missing) {
            *warning += std::string(missing.what()) + "\n";
            continue;
        }
        std::string ignored;
        MaterialLines lines(*materials, *numbers, ignored);
        naming_file(file, [&] {
            for (std::string line; std::getline(text, line);) lines.read(line);
        });
        std::istringstream each(ignored);
        for (std::string line; std::getline(each, line);) *warning += file + ": " + line + "\n";
        is_read = true;
    }
    return is_read;
}

SkinMaker::Picture SkinMaker::read(const std::string& name) const {
    try {
        const PngImage image = read_parsed(path_in(folder_, with_slashes(name)), decode_picture);
        return {{"", image.width_px, image.height_px, indices_of(image, palette_, kOrdinaryColours, dither_)}, ""};
    } catch (const FileError& error) {
        return {{}, error.what()};
    }
}

bool SkinMaker::takes(std::size_t texels) {
    const bool fits = static_cast<std::int64_t>(texels) <= texels_left;
    if (fits) texels_left -= static_cast<std::int64_t>(texels);
    return fits;
}

Skin SkinMaker::skin_of(const tinyobj::material_t& material) {
    const std::string& name = material.diffuse_texname;
    Skin coloured = skin_of_colour(material.name, diffuse_colour(material), palette_);
    if (name.empty()) return coloured;
    std::error_code ignored;  // then it has no such file
    const std::string file = std::filesystem::weakly_canonical(folder_ / with_slashes(name), ignored).string();
    auto known = pictures_.find(file);
    if (known == pictures_.end() && texels_left > 0) known = pictures_.emplace(file, read(name)).first;
    std::string fault = known == pictures_.end() ? "" : known->second.fault;
    if (fault.empty() && (known == pictures_.end() || !takes(known->second.skin.texels.size()))) {
        texels_left = 0;  // no more pictures are read to find that they do not fit either
        fault = (folder_ / name).string() + ": size: the model's pictures have more than " +
                std::to_string(kMostSkinTexels) + " texels, expected fewer";
    }
    if (!fault.empty()) {
        warnings_.push_back(fault + ": the material's colour stands for it");
        return coloured;
    }
    Skin skin = known->second.skin;
    skin.name = material.name;
    return skin;
}

Skin grey_skin(const Palette& palette) {
    return skin_of_colour("no material", {192, 192, 192}, palette);
}

}  // namespace oblong

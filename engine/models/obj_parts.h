#pragma once

#include <tiny_obj_loader.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "engine/mesh/mesh.h"
#include "engine/pictures/picture.h"

namespace oblong {

inline constexpr std::size_t kMostMaterials = 4096;
inline constexpr std::int64_t kMostSkinTexels = std::int64_t{1}
                                                << 26;  ///< of a model's pictures and of their repetitions
inline constexpr double kFarthestTexcoord = 1024;       ///< repetitions of a skin

struct ObjSummary {
    std::int64_t faces = 0;
    bool has_smoothing_groups = false;
    std::vector<std::string> warnings;
};

/// A whole word as a number.
std::optional<double> parse_double(std::string_view word);

/// Names of materials and files may have blanks, which end a name for tinyobjloader: in between, other letters stand
/// for them, and a slash for backslashes.
std::string as_word(std::string_view name);
std::string name_of_word(std::string word);
inline constexpr char kBlankInWord = '\x1f', kBlankInName = '\x1e';  ///< the second: one behind a backslash

/// An OBJ file's text for check_obj() and tinyobjloader: without a byte order mark, with LF line ends, without
/// comments, and with lines that a backslash continues joined; then empty lines follow, so that the others keep their
/// numbers. Names of materials are words: as_word().
std::string simple_obj(std::string file);

/// Checks what tinyobjloader does not: that the words of v, vt, vn and f lines are numbers in range, and that the
/// corners of faces exist, of which normals may be missing. Throws InputError with the line.
ObjSummary check_obj(std::string_view text, double scale);

/// Reads the material files that an OBJ file names, beside it, each once. Throws FileError for a colour that is no
/// three numbers, and for more than kMostMaterials of them or of files.
class ObjMaterialReader : public tinyobj::MaterialReader {
  public:
    explicit ObjMaterialReader(std::filesystem::path folder) : folder_(std::move(folder)) {}

    bool operator()(const std::string& name, std::vector<tinyobj::material_t>* materials,
                    std::map<std::string, int>* numbers, std::string* warning, std::string* error) override;

  private:
    std::filesystem::path folder_;
    std::set<std::filesystem::path> read_;
    std::size_t named_ = 0;
};

/// Makes the skins of materials: their pictures, which are beside the OBJ file and each read once, or else their
/// colours.
class SkinMaker {
  public:
    SkinMaker(std::filesystem::path folder, const Palette& palette, Dither dither, std::vector<std::string>& warnings)
        : folder_(std::move(folder)), palette_(palette), dither_(dither), warnings_(warnings) {}

    /// Adds a warning if the picture cannot be read, or is too large for what is left of kMostSkinTexels: then no other
    /// is read.
    Skin skin_of(const tinyobj::material_t& material);
    /// Takes this many texels of those that are left, if there are as many.
    bool takes(std::size_t texels);

    std::int64_t texels_left = kMostSkinTexels;

  private:
    struct Picture {
        Skin skin;
        std::string fault;  ///< empty: none
    };
    Picture read(const std::string& name) const;

    std::filesystem::path folder_;
    const Palette& palette_;
    Dither dither_;
    std::vector<std::string>& warnings_;
    std::map<std::string, Picture> pictures_;  ///< by their files, which may have many names
};

/// A place on a skin, in repetitions of it, v down.
struct SkinPlace {
    double u = 0, v = 0;
};

/// The range of the vertices' places.
struct PlaceRange {
    SkinPlace least{1e9, 1e9}, greatest{-1e9, -1e9};
    void include(const SkinPlace& place);
};

/// Converts places to texels.
struct SkinScale {
    std::int32_t first_u = 0, first_v = 0;  ///< whole repetitions left of the skin and above it
    double width = 1, height = 1;           ///< of the skin, texels
    MeshTexel texel_at(const SkinPlace& place) const;
};

/// Repeats a skin as often as its places need, up to 4,096 texels a side, since a skin is drawn only once; adds a
/// warning if that is too few, or too many for what is left of kMostSkinTexels.
SkinScale repeat_skin(Skin& skin, const PlaceRange& range, std::int64_t& texels_left,
                      std::vector<std::string>& warnings);

/// Resized to another skin's size, by the nearest texels.
Skin resized(const Skin& skin, const Skin& other);

/// The skin of faces without a material.
Skin grey_skin(const Palette& palette);

}  // namespace oblong

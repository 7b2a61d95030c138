#pragma once

#include <tiny_obj_loader.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/mesh/mesh.h"
#include "tools/common/quantise.h"

namespace oblong {

/// Reads the material files that an OBJ file names, beside it.
class ObjMaterialReader : public tinyobj::MaterialReader {
  public:
    explicit ObjMaterialReader(std::filesystem::path folder) : folder_(std::move(folder)) {}

    bool operator()(const std::string& name, std::vector<tinyobj::material_t>* materials,
                    std::map<std::string, int>* numbers, std::string* warning, std::string* error) override;

  private:
    std::filesystem::path folder_;
};

/// A material's picture, or else its colour; PNGs are beside the OBJ file. Adds a warning where a PNG can't be read.
Skin make_skin(const tinyobj::material_t& material, const std::filesystem::path& folder, const Palette& palette,
               Dither dither, std::vector<std::string>& warnings);

/// Of faces without a material.
Skin grey_skin(const Palette& palette);

}  // namespace oblong

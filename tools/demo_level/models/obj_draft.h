#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace oblong::model_source {

/// A point of a model, y up.
struct ModelPoint {
    double x = 0, y = 0, z = 0;
};

/// A Wavefront OBJ file while it is made.
class ObjDraft {
  public:
    explicit ObjDraft(const std::string& material_file);

    void use_material(const std::string& name);
    /// What follows is smooth within itself, and not to what came before.
    void begin_smooth_part();
    /// The columns of the picture, of 0 to 1, that what follows shows; until then the whole of it.
    void use_columns(double first, double end) {
        first_column_ = first;
        end_column_ = end;
    }

    /// Rings of points, from the bottom up, each running clockwise as seen from above, with faces between each two that
    /// show outward. Texture coordinates go from 0 to 1 around and up.
    void add_closed_grid(const std::vector<std::vector<ModelPoint>>& rows);

    const std::string& text() const { return text_; }

  private:
    std::string text_;
    std::size_t points_ = 1, places_ = 1;  ///< the numbers of the next v and vt
    int parts_ = 0;
    double first_column_ = 0, end_column_ = 1;
};

}  // namespace oblong::model_source

#include "tools/demo_level/models/obj_draft.h"

#include <cstdio>

namespace oblong::model_source {
namespace {

std::string decimal(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4f", value);
    return std::string(text) == "-0.0000" ? "0.0000" : text;
}

}  // namespace

ObjDraft::ObjDraft(const std::string& material_file)
    : text_("# Made by oblong-demo-level.\nmtllib " + material_file + "\n") {}

void ObjDraft::use_material(const std::string& name) {
    text_ += "usemtl " + name + "\n";
}

void ObjDraft::begin_smooth_part() {
    text_ += "s " + std::to_string(++parts_) + "\n";
}

void ObjDraft::add_closed_grid(const std::vector<std::vector<ModelPoint>>& rows) {
    const std::size_t sides = rows.front().size();
    const auto share = [](std::size_t part, std::size_t whole) {
        return static_cast<double>(part) / static_cast<double>(whole);
    };
    const double columns = end_column_ - first_column_;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        for (const ModelPoint& p : rows[row])
            text_ += "v " + decimal(p.x) + " " + decimal(p.y) + " " + decimal(p.z) + "\n";
        for (std::size_t side = 0; side <= sides; ++side)
            text_ += "vt " + decimal(first_column_ + columns * share(side, sides)) + " " +
                     decimal(share(row, rows.size() - 1)) + "\n";
    }
    const auto corner = [&](std::size_t row, std::size_t side) {
        return " " + std::to_string(points_ + row * sides + side % sides) + "/" +
               std::to_string(places_ + row * (sides + 1) + side);
    };
    for (std::size_t row = 0; row + 1 < rows.size(); ++row)
        for (std::size_t side = 0; side < sides; ++side)
            text_ += "f" + corner(row, side) + corner(row, side + 1) + corner(row + 1, side + 1) +
                     corner(row + 1, side) + "\n";
    points_ += rows.size() * sides;
    places_ += rows.size() * (sides + 1);
}

}  // namespace oblong::model_source

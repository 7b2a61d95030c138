#include "tools/render/camera_list.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "engine/base/input_error.h"
#include "engine/base/table.h"
#include "engine/base/text.h"
#include "engine/fixed/trig.h"

namespace oblong {

namespace {

constexpr std::array<std::string_view, 6> kColumns{"x", "y", "z", "yaw", "pitch", "roll"};

constexpr std::string_view kSpace = " \t\r";

std::string trimmed(const std::string& field) {
    const std::size_t first = field.find_first_not_of(kSpace);
    if (first == std::string::npos) return "";
    return field.substr(first, field.find_last_not_of(kSpace) + 1 - first);
}

/// The kColumns entry of each column of the file.
std::vector<std::size_t> parse_header(const std::string& line) {
    if (trimmed(line).empty()) throw InputError(at_line(1), "is empty, expected the columns' names: x,y,z,yaw,pitch");
    std::vector<std::size_t> columns;
    for (const std::string& field : split(line, ",")) {
        const std::string name = trimmed(field);
        const auto known = std::find(kColumns.begin(), kColumns.end(), name);
        const auto index = as_size(known - kColumns.begin());
        if (known == kColumns.end() || std::count(columns.begin(), columns.end(), index))
            throw InputError(at_line(1),
                             "column '" + name + "', expected x, y, z, yaw, pitch and perhaps roll, each once");
        columns.push_back(index);
    }
    for (std::size_t index = 0; index < 5; ++index)
        if (!std::count(columns.begin(), columns.end(), index))
            throw InputError(at_line(1),
                             "no column '" + std::string(kColumns[index]) + "', expected x, y, z, yaw, pitch");
    return columns;
}

World world_of(std::int64_t raw_32, std::size_t line) {
    const std::int64_t raw = rounded_shift(raw_32, 20, Rounding::NearestHalfUp);
    if (raw < -(std::int64_t{32768} << 12) || raw > std::int64_t{32768} << 12)
        throw InputError(at_line(line), "a coordinate beyond +-32,768 units, expected one within");
    return World::from_raw(static_cast<std::int32_t>(raw));
}

Camera parse_camera(const std::string& text, const std::vector<std::size_t>& columns, std::size_t line) {
    const std::vector<std::string> fields = split(text, ",");
    if (fields.size() != columns.size())
        throw InputError(at_line(line),
                         std::to_string(fields.size()) + " fields, expected " + std::to_string(columns.size()));
    std::array<std::int64_t, 6> values_32{};
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const std::string field = trimmed(fields[i]);
        const std::optional<std::int64_t> value_32 = parse_decimal(field, 32);
        if (!value_32) throw InputError(at_line(line), "'" + field + "', expected a decimal number");
        values_32[columns[i]] = *value_32;
    }
    const auto angle = [&](std::size_t index) {
        // Reduced modulo a turn first, as the format has only 16 integer bits.
        return degrees_to_angle(Degrees::from_raw(values_32[index] % (std::int64_t{360} << 32) * 65536));
    };
    Camera camera;
    camera.eye = {world_of(values_32[0], line), world_of(values_32[1], line), world_of(values_32[2], line)};
    camera.yaw = angle(3);
    camera.pitch = angle(4);
    camera.roll = angle(5);
    return camera;
}

}  // namespace

std::vector<Camera> parse_cameras(std::span<const std::uint8_t> bytes, Degrees field_of_view) {
    const std::vector<std::string> lines = split(plain_text({bytes.begin(), bytes.end()}), "\n");
    const std::vector<std::size_t> columns = parse_header(lines[0]);
    std::vector<Camera> cameras;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (lines[i].find_first_not_of(kSpace) == std::string::npos) continue;
        cameras.push_back(parse_camera(lines[i], columns, i + 1));
        cameras.back().field_of_view = field_of_view;
    }
    if (cameras.empty()) throw InputError(at_line(2), "no camera, expected at least one");
    return cameras;
}

}  // namespace oblong

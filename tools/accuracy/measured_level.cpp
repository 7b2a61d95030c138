#include "tools/accuracy/measured_level.h"

#include <stdexcept>

#include "engine/base/input_error.h"
#include "engine/level/bsp_read.h"
#include "engine/visibility/eye.h"

namespace oblong {

MeasuredLevel make_measured_level(const std::string& name, const std::string& about, std::span<const std::uint8_t> file,
                                  std::vector<Camera> cameras) {
    MeasuredLevel measured{name, about, read_bsp(file), {}, {}, std::move(cameras)};
    try {
        measured.exact = reference::read_level(file);
    } catch (const std::runtime_error& error) {  // what the engine's reader lets pass
        throw InputError("the reference's reading", error.what());
    }
    measured.models = models_at_rest(measured.level);
    for (std::size_t i = 0; i < measured.cameras.size(); ++i) {
        const PlacedEye eye = place_eye(measured.level, measured.cameras[i].eye);
        if (measured.level.leaves[eye.leaf].contents == contents::kSolid)
            throw InputError("camera " + std::to_string(i + 1), "in a wall or outside, expected an eye in the open");
        measured.cameras[i].eye = eye.position;
    }
    return measured;
}

}  // namespace oblong

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
    for (Camera& camera : measured.cameras) camera.eye = place_eye(measured.level, camera.eye).position;
    return measured;
}

}  // namespace oblong

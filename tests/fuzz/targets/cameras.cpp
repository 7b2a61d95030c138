// Lists of cameras, and routes (CSV).

#include "game/input/route.h"
#include "tests/fuzz/common/fuzz.h"
#include "tools/render/camera_list.h"

namespace oblong::fuzz {

void run(Input input) {
    constexpr std::string_view kRoute = "x,y,z,speed";
    if (text_of(input).starts_with(kRoute))
        expect(!parse_route(input).empty(), "a place to go to");
    else
        for (const Camera& camera : parse_cameras(input, Degrees::from_int(90)))
            expect(camera.field_of_view == Degrees::from_int(90), "the field of view that was given");
}

}  // namespace oblong::fuzz

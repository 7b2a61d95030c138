// Lists of cameras, and routes (CSV).

#include "game/input/route.h"
#include "tests/fuzz/common/fuzz.h"
#include "tools/render/camera_list.h"

namespace oblong::fuzz {

constexpr std::string_view kRoute = "x,y,z,speed";

void mutate(Bytes& input, std::minstd_rand& random) {
    if (below(2, random) == 0) return mutate_bytes(input);
    std::string text = text_of(input);
    const std::size_t line = text.rfind('\n', below(text.size(), random));
    if (line != std::string::npos && below(4, random) == 0) text += text.substr(line);
    replace_number(text, random);
    set_text(input, text);
}

void read(Input input) {
    if (text_of(input).starts_with(kRoute))
        parse_route(input);
    else
        parse_cameras(input, Degrees::from_int(90));
}

void run(Input input) {
    if (text_of(input).starts_with(kRoute))
        expect(!parse_route(input).empty(), "a place to go to");
    else
        for (const Camera& camera : parse_cameras(input, Degrees::from_int(90)))
            expect(camera.field_of_view == Degrees::from_int(90), "the field of view that was given");
}

}  // namespace oblong::fuzz

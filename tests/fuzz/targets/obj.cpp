// OBJ models, with the materials beside them: read and drawn.

#include "engine/models/obj.h"

#include "engine/base/checksum.h"
#include "tests/fuzz/common/played_level.h"
#include "tests/support/folders.h"

namespace oblong::fuzz {

void mutate(Bytes& input, std::minstd_rand& random) {
    if (below(2, random) == 0) return mutate_bytes(input);
    std::string text = text_of(input);
    replace_number(text, random);
    set_text(input, text);
}

// The model; behind a zero byte, if there is one, its materials.
void run(Input input) {
    static const test::TemporaryFolder folder;
    const std::string text = text_of(input);
    const std::size_t end = text.find('\0');
    folder.write("m.mtl", end == std::string::npos ? "newmtl a\nKd 1 0 0\n" : text.substr(end + 1));
    const ObjModel model = read_obj(folder.write("m.obj", text.substr(0, end)), greys());
    expect(model.mesh.frames.size() == 1 && !model.mesh.triangles.empty(), "a model of one frame");
    draw_in_stage(model.mesh, fnv1a_of(input));
}

}  // namespace oblong::fuzz

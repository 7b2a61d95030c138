#pragma once

#include "tests/support/bsp_writer.h"

namespace oblong::test {

/// The smallest level that has one of everything: a floor at z = 8, 32 x 16 units, lit, with empty space above
/// (leaf 1) and solid below (leaf 0). Its texture lies a texel a unit, moved by 4 texels along u.
inline Lumps make_tiny_lumps() {
    Lumps lumps;
    const auto write = [&lumps](Lump lump) { return ByteWriter(lump_of(lumps, lump)); };
    write(Lump::Entities).text("{ \"classname\" \"worldspawn\" }").u8(0);
    write(Lump::Planes).f32(0).f32(0).f32(1).f32(8).i32(2);

    write(Lump::Textures).i32(1).i32(8);
    write(Lump::Textures).text("floor").number(8, 0).number(3, 0).i32(16).i32(16).i32(40).i32(296).i32(360).i32(376);
    lump_of(lumps, Lump::Textures).resize(8 + 40 + 256 + 64 + 16 + 4, 7);

    for (const float x : {0.F, 32.F})
        for (const float y : {0.F, 16.F}) write(Lump::Vertices).f32(x).f32(y).f32(8);
    write(Lump::Visibility).u8(1);
    write(Lump::Nodes).i32(0).i16(-2).i16(-1).i16(0).i16(0).i16(0).i16(32).i16(16).i16(64).i16(0).i16(1);
    write(Lump::TexInfos).f32(1).f32(0).f32(0).f32(4).f32(0).f32(-1).f32(0).f32(0).i32(0).i32(0);
    write(Lump::Faces).i16(0).i16(0).i32(0).i16(4).i16(0).u8(0).u8(255).u8(255).u8(255).i32(0);
    lump_of(lumps, Lump::Lighting).resize((48 / 16 + 1) * (16 / 16 + 1), 100);
    write(Lump::ClipNodes).i32(0).i16(-1).i16(-2);
    write(Lump::Leaves).i32(-2).i32(-1).number(8, 0).i32(0).i16(0).i16(0).i32(0);
    write(Lump::Leaves).i32(-1).i32(0).i16(0).i16(0).i16(8).i16(32).i16(16).i16(64).i16(0).i16(1).i32(0);
    write(Lump::MarkFaces).i16(0);
    // Clockwise seen from above: (0,0) (0,16) (32,16) (32,0). Edge 0 is never used: it has no negative.
    write(Lump::Edges).i16(0).i16(0).i16(0).i16(1).i16(3).i16(1).i16(3).i16(2).i16(2).i16(0);
    write(Lump::SurfEdges).i32(1).i32(-2).i32(3).i32(4);
    write(Lump::Models).f32(0).f32(0).f32(0).f32(32).f32(16).f32(64).f32(0).f32(0).f32(0);
    write(Lump::Models).i32(0).i32(0).i32(0).i32(0).i32(1).i32(0).i32(1);
    return lumps;
}

}  // namespace oblong::test

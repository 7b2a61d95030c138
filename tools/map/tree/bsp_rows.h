#pragma once

#include "tools/map/tree/bsp_file.h"

namespace oblong::map {

/// The lumps of a level file that are rows of fields: visit(place in the file, name, rows, fields), where fields(io,
/// row) passes each field of a row to `io` in order. Writer and reader share it, so that they agree.
template <class Bsp, class Visit>
void visit_rows(Bsp& bsp, const Visit& visit) {
    visit(1, "lump planes", bsp.planes, [](auto& io, auto& plane) {
        io.floats(plane.normal);
        io.number(plane.distance);
        io.i32(plane.type);
    });
    visit(3, "lump vertices", bsp.vertices, [](auto& io, auto& vertex) { io.floats(vertex); });
    visit(5, "lump nodes", bsp.nodes, [](auto& io, auto& node) {
        io.i32(node.plane);
        for (auto& child : node.children) io.i16(child);
        io.box(node.box);
        io.u16(node.first_face);
        io.u16(node.face_count);
    });
    visit(6, "lump texinfos", bsp.texinfos, [](auto& io, auto& texinfo) {
        for (auto& axis : texinfo.axes) {
            io.floats(axis.direction);
            io.number(axis.offset);
        }
        io.i32(texinfo.texture);
        io.i32(texinfo.flags);
    });
    visit(7, "lump faces", bsp.faces, [](auto& io, auto& face) {
        io.i16(face.plane);
        io.i16(face.is_back);
        io.i32(face.first_surf_edge);
        io.i16(face.edge_count);
        io.i16(face.texinfo);
        for (auto& style : face.styles) io.u8(style);
        io.i32(face.light_offset);
    });
    visit(9, "lump clip nodes", bsp.clip_nodes, [](auto& io, auto& node) {
        io.i32(node.plane);
        for (auto& child : node.children) io.i16(child);
    });
    visit(10, "lump leaves", bsp.leaves, [](auto& io, auto& leaf) {
        io.i32(leaf.contents);
        io.i32(leaf.visibility_offset);
        io.box(leaf.box);
        io.u16(leaf.first_mark_face);
        io.u16(leaf.mark_face_count);
        io.unused_i32(1);  // four levels of ambient sound
    });
    visit(11, "lump mark faces", bsp.mark_faces, [](auto& io, auto& face) { io.u16(face); });
    visit(12, "lump edges", bsp.edges, [](auto& io, auto& edge) {
        for (auto& vertex : edge) io.u16(vertex);
    });
    visit(13, "lump surface edges", bsp.surf_edges, [](auto& io, auto& edge) { io.i32(edge); });
    visit(14, "lump models", bsp.models, [](auto& io, auto& model) {
        io.floats(model.mins);
        io.floats(model.maxs);
        io.unused_i32(3);  // the origin
        for (auto& head : model.head_nodes) io.i32(head);
        io.i32(model.visible_leaf_count);
        io.i32(model.first_face);
        io.i32(model.face_count);
    });
}

}  // namespace oblong::map

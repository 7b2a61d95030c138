#include "game/dos/prepared_game.h"

#include <array>
#include <cstring>
#include <map>
#include <memory>

namespace oblong {
namespace {

// visit(archive, value) writes or reads, depending on the archive; values are const for a writer.
template <class Archive, class Value>
void visit(Archive& archive, Value& value);

template <class Archive, class... Values>
void visit_all(Archive& archive, Values&... values) {
    (visit(archive, values), ...);
}

template <class Archive, class List>
void visit_list(Archive& archive, List& list) {
    archive.count(list);
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(*list.data())>, std::uint8_t>)
        archive.add(list);
    else
        for (auto& each : list) visit(archive, each);
}

// Numbers that are narrower in small memory than where they are written, or always the same there.
template <class Archive, class Number>
void visit_narrowed(Archive& archive, Number& value) {
    std::int32_t number = value;
    archive.number(number);
    if constexpr (!std::is_const_v<Number>) value = static_cast<Number>(number);
    if (value != number) throw InputError("level", std::to_string(number) + ", which small memory does not hold");
}

// Classes of one number: indices, children of nodes, directed edges.
template <class Archive, class Value>
void visit_bits(Archive& archive, Value& value) {
    std::conditional_t<sizeof(Value) == sizeof(LevelNumber), LevelNumber, std::int32_t> bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    visit_narrowed(archive, bits);
    if constexpr (!std::is_const_v<Value>) std::memcpy(static_cast<void*>(&value), &bits, sizeof bits);
}

template <class Value, class Kind>
inline constexpr bool kIs = std::is_same_v<std::remove_const_t<Value>, Kind>;

template <class Archive, class Enum>
void visit_enum(Archive& archive, Enum& value) {
    auto number = static_cast<std::uint8_t>(value);
    archive.number(number);
    if constexpr (!std::is_const_v<Enum>) value = static_cast<Enum>(number);
}

template <class Archive, class Value>
void visit_part_of_level(Archive& archive, Value& v) {
    if constexpr (kIs<Value, LevelPlane>) {
        visit(archive, v.normal);
        for (auto& rest : v.normal_rest_60) visit_narrowed(archive, rest);
        visit(archive, v.distance), visit_narrowed(archive, v.distance_rest_72), visit(archive, v.axis);
    } else if constexpr (kIs<Value, TexInfo>)
        visit_all(archive, v.s, v.t, v.s_offset, v.t_offset, v.texture, v.material);
    else if constexpr (kIs<Value, Face>) {
        visit_all(archive, v.plane, v.is_back, v.edges, v.texinfo, v.styles, v.light_offset);
        for (auto* number : {&v.texel_min_u, &v.texel_min_v, &v.texel_extent_u, &v.texel_extent_v})
            visit_narrowed(archive, *number);
    } else if constexpr (kIs<Value, Node>)
        visit_all(archive, v.plane, v.children, v.box, v.faces);
    else if constexpr (kIs<Value, Leaf>)
        visit_narrowed(archive, v.contents), visit_all(archive, v.visibility_offset, v.box, v.mark_faces);
    else if constexpr (kIs<Value, ClipNode>)
        visit_all(archive, v.plane, v.children);
    else if constexpr (kIs<Value, SubModel>)
        visit_all(archive, v.box, v.origin, v.root, v.clip_roots), visit_narrowed(archive, v.visible_leaf_count),
            visit(archive, v.faces);
    else if constexpr (kIs<Value, MipTexture>)
        visit_all(archive, v.name, v.width, v.height, v.mips, v.is_missing);
    else if constexpr (kIs<Value, Edge>)
        visit_all(archive, v.from, v.to);
    else if constexpr (kIs<Value, TJunction>)
        visit_all(archive, v.edge, v.vertex);
    else if constexpr (kIs<Value, Entity>)
        visit(archive, v.pairs);
    else {
        static_assert(kIs<Value, Level>);
        if constexpr (!std::is_const_v<Value>) v.t_junctions.emplace();
        visit_all(archive, v.entities, v.planes, v.textures, v.vertices, v.visibility, v.nodes, v.texinfos, v.faces,
                  v.lighting, v.coloured_lighting, v.clip_nodes, v.leaves, v.mark_faces, v.edges, v.surf_edges,
                  v.models, v.sky, *v.t_junctions);
    }
}

template <class Archive, class Value>
void visit_part_of_mesh(Archive& archive, Value& v) {
    if constexpr (kIs<Value, Skin>)
        visit_all(archive, v.width, v.height, v.texels);
    else if constexpr (kIs<Value, MeshVertex>)
        visit_all(archive, v.position, v.normal);
    else if constexpr (kIs<Value, MeshTexel>)
        visit_all(archive, v.u, v.v);
    else if constexpr (kIs<Value, MeshTriangle>)
        visit_all(archive, v.vertices, v.skin);
    else if constexpr (kIs<Value, MeshFrame>)
        visit_all(archive, v.vertices, v.mins, v.maxs, v.parts);
    else if constexpr (kIs<Value, MeshSequence>)
        visit_all(archive, v.first, v.ends_ms);
    else if constexpr (kIs<Value, Mesh>)
        visit_all(archive, v.frames, v.texels, v.triangles, v.skins, v.frame_sequences, v.skin_sequences, v.turns);
    else
        visit_part_of_level(archive, v);
}

template <class Archive, class Value>
void visit(Archive& archive, Value& value) {
    if constexpr (std::is_integral_v<Value>)
        archive.number(value);
    else if constexpr (std::is_enum_v<Value>)
        visit_enum(archive, value);
    else if constexpr (requires { value.raw; })
        archive.number(value.raw);
    else if constexpr (kIs<Value, Angle>)
        archive.number(value.bam);
    else if constexpr (requires { value.z; })
        visit_all(archive, value.x, value.y, value.z);
    else if constexpr (requires { std::tuple_size<std::remove_const_t<Value>>::value; })
        std::apply([&](auto&... parts) { visit_all(archive, parts...); }, value);
    else if constexpr (requires { value.data(); })
        visit_list(archive, value);
    else if constexpr (requires { value.first.number(), value.count; })
        visit_bits(archive, value.first), visit_narrowed(archive, value.count);
    else if constexpr (kIs<Value, LevelBox>)
        for (auto* corner : {&value.mins, &value.maxs})
            for (auto& number : *corner) visit_narrowed(archive, number);
    else if constexpr (kIs<Value, MeshBox>)
        visit_all(archive, value.mins, value.maxs);
    else if constexpr (sizeof(Value) == sizeof(LevelNumber))
        visit_bits(archive, value);
    else
        visit_part_of_mesh(archive, value);
}

constexpr std::array<Angle PlacedMesh::*, 3> kTurns{&PlacedMesh::yaw, &PlacedMesh::pitch, &PlacedMesh::roll};

// All fields but the mesh.
template <class Archive, class Model>
void visit_model(Archive& archive, Model& model) {
    auto& placed = model.placed;
    visit_all(archive, placed.frame, placed.next_frame, placed.blend_256, placed.skin, placed.colour, placed.position,
              placed.yaw, placed.pitch, placed.roll, placed.scale, placed.shading, placed.highlight, placed.least_light,
              model.first_frame, model.frames, model.skin, model.turn_ms);
    auto entity = static_cast<std::uint32_t>(model.entity);
    auto turns = static_cast<std::uint8_t>(std::find(kTurns.begin(), kTurns.end(), model.turns) - kTurns.begin());
    visit_all(archive, model.is_door, entity, turns);
    if constexpr (!std::is_const_v<Model>) {
        model.entity = entity;
        model.turns = kTurns[turns % kTurns.size()];
    }
}

void write_models(const LevelModels& models, Writer& writer) {
    std::map<const Mesh*, std::uint32_t> numbers;
    writer.count(models.meshes);
    for (const auto& mesh : models.meshes) {
        numbers.emplace(mesh.get(), static_cast<std::uint32_t>(numbers.size()));
        visit(writer, *mesh);
    }
    writer.count(models.models);
    for (const LevelModel& model : models.models) {
        writer.number(numbers.at(model.placed.mesh));
        visit_model(writer, model);
    }
}

void read_models(Reader& reader, LevelModels& models) {
    const std::size_t count = reader.count(models.meshes);
    for (std::size_t i = 0; i < count; ++i) {
        auto mesh = std::make_unique<Mesh>();
        visit(reader, *mesh);
        mesh->planes = facing_planes(*mesh);
        mesh->places = shared_places(*mesh);
        models.meshes[i] = std::move(mesh);
    }
    reader.count(models.models);
    for (LevelModel& model : models.models) {
        std::uint32_t number = 0;
        reader.number(number);
        if (number >= count) throw InputError("models", "a model of a mesh that is not there");
        model.placed.mesh = models.meshes[number].get();
        visit_model(reader, model);
    }
}

using OwnTexts = std::vector<std::pair<std::string, std::string>>;

}  // namespace

std::vector<std::uint8_t> encode_prepared_game(const GameData& data) {
    Writer writer;
    visit_all(writer, data.level_hash, data.level);
    for (const auto& shade : data.colormap.shades) writer.add(shade);
    write_models(data.models, writer);
    return std::move(writer.bytes);
}

void decode_prepared_game(std::span<const std::uint8_t> bytes, GameData& data) {
    Reader reader(bytes);
    visit_all(reader, data.level_hash, data.level);
    for (auto& shade : data.colormap.shades) reader.add(shade);
    data.colormap.palette = data.palette;
    read_models(reader, data.models);
    reader.expect_end();
}

std::vector<std::uint8_t> encode_definition(const GameDefinition& game) {
    Writer writer;
    const OwnTexts captions(game.captions.begin(), game.captions.end());
    visit_all(writer, game.folder, game.title, game.levels, game.palette, game.demo, captions);
    return std::move(writer.bytes);
}

GameDefinition decode_definition(std::span<const std::uint8_t> bytes) {
    GameDefinition game;
    OwnTexts captions;
    Reader reader(bytes);
    visit_all(reader, game.folder, game.title, game.levels, game.palette, game.demo, captions);
    reader.expect_end();
    game.captions = {captions.begin(), captions.end()};
    return game;
}

}  // namespace oblong

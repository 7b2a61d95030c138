#include "game/dos/prepared_game.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <type_traits>

#include "engine/base/little_endian.h"

namespace oblong {
namespace {

/// Appends the visited values.
class Writer {
  public:
    template <class Int>
    void number(const Int& value) {
        append_little_endian(bytes, value);
    }
    template <class T>
    std::size_t count(const std::vector<T>& list) {
        number(static_cast<std::uint32_t>(list.size()));
        return list.size();
    }
    void add(std::span<const std::uint8_t> list) { bytes.insert(bytes.end(), list.begin(), list.end()); }
    std::vector<std::uint8_t> bytes;
};

/// Reads the visited values.
class Reader {
  public:
    explicit Reader(std::span<const std::uint8_t> bytes) : reader_(bytes) {}

    template <class Int>
    void number(Int& value) {
        value = reader_.next<Int>();
    }
    template <class T>
    std::size_t count(std::vector<T>& list) {
        const auto size = reader_.next<std::uint32_t>();
        expect_at(reader_.offset(), size <= reader_.rest(), "a list longer than the bytes left");
        list.resize(size);
        return size;
    }
    void add(std::span<std::uint8_t> list) {
        const auto from = reader_.take(list.size());
        std::copy(from.begin(), from.end(), list.begin());
    }
    void expect_end() const { expect_at(reader_.offset(), reader_.rest() == 0, "more bytes than expected"); }

  private:
    LittleEndianReader reader_;
};

// visit(archive, value) writes or reads, depending on the archive; values are const for a writer.
template <class Archive, class Value>
void visit(Archive& archive, Value& value);

template <class Archive, class... Values>
void visit_all(Archive& archive, Values&... values) {
    (visit(archive, values), ...);
}

template <class Archive, class List>
void visit_list(Archive& archive, List& list) {
    const std::size_t count = archive.count(list);
    if constexpr (std::is_same_v<typename List::value_type, std::uint8_t>)
        archive.add(list);
    else
        for (std::size_t i = 0; i < count; ++i) visit(archive, list[i]);
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
void visit_part_of_mesh(Archive& archive, Value& v) {
    if constexpr (kIs<Value, Skin>)
        visit_all(archive, v.width, v.height, v.texels);
    else if constexpr (kIs<Value, MeshVertex>)
        visit_all(archive, v.position, v.normal);
    else if constexpr (kIs<Value, MeshTexel>)
        visit_all(archive, v.u, v.v);
    else if constexpr (kIs<Value, MeshTriangle>)
        visit_all(archive, v.vertices[0], v.vertices[1], v.vertices[2], v.skin);
    else if constexpr (kIs<Value, MeshBox>)
        visit_all(archive, v.mins, v.maxs);
    else if constexpr (kIs<Value, MeshFrame>)
        visit_all(archive, v.vertices, v.mins, v.maxs, v.parts);
    else if constexpr (kIs<Value, MeshSequence>)
        visit_all(archive, v.first, v.ends_ms);
    else {
        static_assert(kIs<Value, Mesh>);
        visit_all(archive, v.frames, v.texels, v.triangles, v.skins, v.frame_sequences, v.skin_sequences);
        std::uint8_t turns = v.turns;
        archive.number(turns);
        if constexpr (!std::is_const_v<Value>) v.turns = turns != 0;
    }
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
    else if constexpr (requires { value.data(); })
        visit_list(archive, value);
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
    std::uint8_t is_door = model.is_door;
    archive.number(entity);
    archive.number(turns);
    archive.number(is_door);
    if constexpr (!std::is_const_v<Model>) {
        model.entity = entity;
        model.turns = kTurns[turns % kTurns.size()];
        model.is_door = is_door != 0;
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

}  // namespace

std::vector<std::uint8_t> encode_prepared_game(const GameData& data) {
    Writer writer;
    writer.number(data.level_hash);
    for (const auto& shade : data.colormap.shades) writer.add(shade);
    write_models(data.models, writer);
    return std::move(writer.bytes);
}

void decode_prepared_game(std::span<const std::uint8_t> bytes, GameData& data) {
    Reader reader(bytes);
    reader.number(data.level_hash);
    for (auto& shade : data.colormap.shades) reader.add(shade);
    data.colormap.palette = data.palette;
    read_models(reader, data.models);
    reader.expect_end();
}

std::vector<std::uint8_t> encode_t_junctions(const Level& level, const TJunctions& junctions) {
    Writer writer;
    for (const EdgeIndex edge : level.edges.indices()) {
        const std::span<const VertexIndex> inside = junctions.on_edge(edge);
        writer.number(static_cast<std::uint16_t>(inside.size()));
        for (const VertexIndex vertex : inside) writer.number(vertex.number());
    }
    return std::move(writer.bytes);
}

}  // namespace oblong

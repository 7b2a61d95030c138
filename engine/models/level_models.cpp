#include "engine/models/level_models.h"

#include <algorithm>
#include <compare>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "engine/base/table.h"
#include "engine/base/text.h"
#include "engine/effects/entity_values.h"
#include "engine/fixed/arithmetic.h"
#include "engine/fixed/trig.h"
#include "engine/io/doubles.h"
#include "engine/io/files.h"
#include "engine/level/entities.h"
#include "engine/level/entity_classes.h"
#include "engine/level/trace.h"
#include "engine/mesh/mesh.h"
#include "engine/models/obj.h"
#include "engine/models/turning_brushes.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

constexpr std::int32_t kItemTurn_ms = 3600;             ///< Quake's items turn by 100 degrees a second
constexpr std::int32_t kLeastLight = 110;               ///< of items: a lightmap value
constexpr World kFarthestFloor = World::from_int(256);  ///< below an item
constexpr World kLift = World::from_int(6);             ///< by which an item is lifted before it drops

/// A file and its reading options.
struct ModelFile {
    std::string path;
    World scale = World::from_int(1);
    bool is_z_up = false;
    Dither dither = Dither::None;
    std::strong_ordering operator<=>(const ModelFile&) const = default;
};

/// Of a level's models, each reading counted: the size of the file, and of the mesh made of it. A few letters in the
/// level can name a large file again, at another scale. A reading counts as much as a small model at least.
constexpr std::size_t kMostModels_bytes = std::size_t{1} << 27, kLeastReading_bytes = std::size_t{1} << 16;

std::size_t size_in_bytes(const Mesh& mesh) {
    std::size_t bytes = mesh.triangles.size() * (sizeof(MeshTriangle) + sizeof(FacingPlane));
    for (const MeshFrame& frame : mesh.frames) bytes += frame.vertices.size() * sizeof(MeshVertex);
    for (const Skin& skin : mesh.skins) bytes += skin.texels.size();
    return bytes;
}

class ModelFinder {
  public:
    explicit ModelFinder(const ModelFolders& folders) : game_(folders.game) {
        const std::string level_folder = fs::path(folders.level_file).parent_path().string();
        if (!folders.named.empty()) {
            std::error_code ignored;
            if (!fs::is_directory(folders.named, ignored))
                throw FileError(folders.named, "--models", "is no folder, expected one of models");
            folders_.push_back(folders.named);
        }
        folders_.push_back(level_folder);
        folders_.push_back((level_folder / fs::path("..")).string());
        folders_.insert(folders_.end(), folders.games.begin(), folders.games.end());
        if (!folders.own.empty()) folders_.push_back(folders.own);
    }

    std::optional<std::string> find(const fs::path& path) const {
        for (const std::string& folder : folders_)
            for (const fs::path& below : {path, path.filename(), "progs" / path.filename(), "models" / path.filename()})
                if (std::string file = find_below({folder}, below.string()); !file.empty()) return file;
        if (game_ == nullptr || path.extension() != ".mdl") return std::nullopt;
        const std::optional<std::string> in_game = game_->find(path.generic_string());
        return in_game ? in_game : game_->find(("progs" / path.filename()).generic_string());
    }

  private:
    const GameFiles* game_;
    std::vector<std::string> folders_;
};

class LevelModelReader {
  public:
    LevelModelReader(const Level& level, const Palette& palette, const ModelFolders& folders)
        : level_(level),
          palette_(palette),
          finder_(folders),
          shows_classes_(!folders.named.empty() || folders.game != nullptr) {}

    LevelModels read() {
        for (const Entity& entity : level_.entities) {
            if (role_of(entity) == ClassRole::Worldspawn) {
                world_type_ = parse_decimal(entity.value("worldtype"), 0).value_or(0);
                has_health_ = !entity.value("health").empty();
            }
            if (std::string glass = entity.value("glass"); !glass.empty()) glasses_.push_back(std::move(glass));
        }
        std::sort(glasses_.begin(), glasses_.end());
        glasses_.erase(std::unique(glasses_.begin(), glasses_.end()), glasses_.end());
        for (std::size_t i = 0; i < level_.entities.size(); ++i) read_entity(level_.entities[i], i);
        return std::move(models_);
    }

  private:
    void read_entity(const Entity& entity, std::size_t index) {
        const EntityClass* const its_class = find_entity_class(entity.value("classname"));
        if (its_class == nullptr) return;
        const EntityValues values(entity, index, models_.warnings);
        const bool is_model = its_class->role == ClassRole::TriangleModel;
        const std::int64_t flags = parse_decimal(entity.value("spawnflags"), 0).value_or(0);
        const ClassModel* quakes = shows_classes_ ? find_class_model(*its_class, flags, world_type_) : nullptr;
        const OwnModel own = its_class->role == ClassRole::Health && !has_health_ ? OwnModel{} : its_class->own_model;
        const bool is_own = !quakes && !own.file.empty();
        const bool is_brushes = its_class->role == ClassRole::TurningDoor || its_class->role == ClassRole::Rotating;
        if (!is_model && !quakes && !is_own && !is_brushes) return;
        if (models_.models.size() >= kMostLevelModels) {
            if (is_model || is_brushes)
                values.warn("the level has more than " + std::to_string(kMostLevelModels) + " models: it is left out");
            return;
        }
        const std::size_t before = models_.models.size();
        if (is_model) read_model(values);
        if (is_brushes) {
            if (auto model = turning_.read(level_, entity, values, models_.meshes)) models_.models.push_back(*model);
        }
        if (is_own) read_own_item(own, values);
        if (quakes) read_item(*quakes, *its_class, own, index, values);
        if (models_.models.size() > before) models_.models.back().entity = index;
    }

    void read_model(const EntityValues& values) {
        const std::optional<Vec3<World>> origin = values.origin();
        const fs::path path = values.text("model");
        if (!origin) return;
        if (path.empty() || !stays_below(path.string()))
            return values.warn("model is \"" + path.string() +
                               "\", expected a path of a file below the level's folder: it is left out");
        const std::optional<std::string> file = finder_.find(path);
        if (!file)
            return values.warn("there is no file " + path.string() + " for the model at " + values.text("origin") +
                               ": it is left out");
        const ModelFile read = file_of(*file, values);
        const Mesh* const mesh = mesh_of(read, values);
        if (mesh == nullptr) return;
        LevelModel model = model_of(*mesh, values);
        model.placed.position = *origin;
        models_.models.push_back(model);
    }

    static ModelFile file_of(const std::string& path, const EntityValues& values) {
        ModelFile file{path};
        file.scale = values.number("scale");
        const std::string up = values.text("up"), dither = values.text("dither");
        file.is_z_up = up == "z";
        if (!up.empty() && up != "z" && up != "y")
            values.warn("up is \"" + up + "\", expected y or z: it is taken as y");
        if (values.whole_number("dither", 0, 1) == 1) file.dither = Dither::FloydSteinberg;
        return file;
    }

    static LevelModel model_of(const Mesh& mesh, const EntityValues& values) {
        LevelModel model;
        model.placed.mesh = &mesh;
        const auto last = [](const auto& list) { return static_cast<std::int32_t>(list.size()) - 1; };
        const std::int32_t last_frame = last(mesh.frame_sequences);
        const std::int32_t frame = values.whole_number("frame", 0, last_frame);
        model.first_frame = static_cast<std::uint32_t>(frame);
        model.frames = static_cast<std::uint32_t>(values.whole_number("frames", 1, last_frame - frame + 1));
        model.skin = static_cast<std::uint32_t>(values.whole_number("skin", 0, last(mesh.skin_sequences)));
        if (mesh.turns) model.turn_ms = kItemTurn_ms;
        if (!values.text("period").empty()) model.turn_ms = values.period_ms();
        read_look(values, model.placed);
        return model;
    }

    static void read_look(const EntityValues& values, PlacedMesh& placed) {
        constexpr World kWhole = World::from_int(3600);
        const auto angle = [](World degrees) { return degrees_to_angle(convert<Degrees>(degrees)); };
        placed.yaw = angle(values.number("angle", {-kWhole, kWhole}));
        if (const auto angles = values.vector("angles", {-kWhole, kWhole})) {
            placed.pitch = angle(angles->x);
            placed.yaw = angle(angles->y);
            placed.roll = angle(angles->z);
        }
        const std::string shading = values.text("shading");
        if (shading == "flat") placed.shading = Shading::Flat;
        if (shading == "phong") placed.shading = Shading::Phong;
        if (!shading.empty() && shading != "flat" && shading != "gouraud" && shading != "phong")
            values.warn("shading is \"" + shading + "\", expected flat, gouraud or phong: it is taken as gouraud");
        placed.highlight = values.whole_number("highlight");
        placed.least_light = values.whole_number("least_light");
    }

    void read_item(const ClassModel& quakes, const EntityClass& its_class, const OwnModel& own, std::size_t index,
                   const EntityValues& values) {
        const Entity& entity = level_.entities[index];
        const std::optional<Vec3<World>> origin = parse_world_vector(entity.value("origin"));
        if (!origin) return;
        const std::optional<std::string> file = finder_.find(fs::path(quakes.file).replace_extension(".mdl"));
        if (!file) {
            if (!own.file.empty()) return read_own_item(own, values);
            return report_missing(quakes, entity, index);
        }
        const Mesh* const mesh = mesh_of({*file}, values);
        if (mesh == nullptr) return;
        LevelModel model;
        model.placed.mesh = mesh;
        model.placed.position = resting_place(*origin, its_class.over_floor);
        model.first_frame = std::min(quakes.frame, static_cast<std::uint32_t>(mesh->frame_sequences.size() - 1));
        model.skin = std::min(quakes.skin, static_cast<std::uint32_t>(mesh->skin_sequences.size() - 1));
        if (mesh->turns) model.turn_ms = kItemTurn_ms;
        models_.models.push_back(model);
    }

    /// Shows nothing if its file is missing, as for Quake's classes without a folder of models.
    void read_own_item(const OwnModel& own, const EntityValues& values) {
        const std::optional<Vec3<World>> origin = values.origin();
        const fs::path named = values.text("model");
        const bool has_own = !named.empty() && stays_below(named.string());
        const std::optional<std::string> file = finder_.find(has_own ? named : fs::path(own.file));
        if (!origin) return;
        if (!file && !named.empty())
            values.warn("there is no file " + named.string() + " for the model at " + values.text("origin") +
                        ", which is not shown");
        if (!file) return;
        const Mesh* const mesh = mesh_of({*file, values.number("scale"), false, Dither::None}, values);
        if (mesh == nullptr) return;
        LevelModel model;
        model.placed.mesh = mesh;
        model.skin = skin_of_glass(values.text("glass"), *mesh);
        model.placed.position = resting_place(*origin, own.over_floor);
        model.placed.shading = Shading::Phong;
        model.placed.highlight = 120;
        model.placed.least_light = kLeastLight;
        model.turn_ms = kItemTurn_ms;
        models_.models.push_back(model);
    }

    /// The skin that read_obj() makes for one of glasses_; 0 in other files.
    std::uint32_t skin_of_glass(const std::string& glass, const Mesh& mesh) const {
        const auto found = std::lower_bound(glasses_.begin(), glasses_.end(), glass);
        const std::size_t skin = glass.empty() ? 0 : as_size(found - glasses_.begin()) + 1;
        return skin < mesh.skin_sequences.size() ? static_cast<std::uint32_t>(skin) : 0;
    }

    /// One warning for each file, at the first entity that needs it; one for all brush models.
    void report_missing(const ClassModel& quakes, const Entity& entity, std::size_t index) {
        const std::string file(quakes.file);
        const bool has_brushes = file.ends_with(".bsp");
        if (!missing_.insert(has_brushes ? "brushes" : file).second) return;
        const std::string what = has_brushes ? "its model " + file +
                                                   " is made of brushes, which is not shown (an .mdl of its "
                                                   "name would be), nor are others like it"
                                             : "there is no file " + file + " for the model, which is not shown";
        EntityValues(entity, index, models_.warnings).warn("at " + entity.value("origin") + ": " + what);
    }

    Vec3<World> resting_place(const Vec3<World>& origin, std::int32_t over_floor) const {
        if (over_floor == kStays) return origin;
        const Vec3<World> start{origin.x, origin.y, saturating_convert<World>(widening_difference(origin.z, -kLift))};
        const std::optional<Floor> floor = find_floor(level_, start, kFarthestFloor);
        if (!floor) return origin;
        Vec3<World> place = floor->position;
        place.z += World::from_int(over_floor);
        return place;
    }

    /// Null, with a warning, if the models that were read before are too large already.
    const Mesh* mesh_of(const ModelFile& file, const EntityValues& values) {
        const auto known = meshes_.find(file);
        if (known != meshes_.end()) return known->second;
        if (bytes_read_ >= kMostModels_bytes) {
            values.warn("the level's models, at each of their scales, have more than " +
                        std::to_string(kMostModels_bytes) + " bytes: " + file.path + " is left out");
            return nullptr;
        }
        Mesh mesh = read_mesh(file, values);
        bytes_read_ += kLeastReading_bytes + size_in_bytes(mesh);
        mesh.planes = facing_planes(mesh);
        mesh.places = shared_places(mesh);
        models_.meshes.push_back(std::make_unique<const Mesh>(std::move(mesh)));
        return meshes_.emplace(file, models_.meshes.back().get()).first->second;
    }

    Mesh read_mesh(const ModelFile& file, const EntityValues& values) {
        if (lower_case(fs::path(file.path).extension().string()) != ".obj")
            return read_parsed_game_file(file.path, [&](const auto& bytes) {
                bytes_read_ += bytes.size();
                return read_mdl(bytes, file.scale);
            });
        std::error_code has_none;
        const std::uintmax_t size = fs::file_size(file.path, has_none);
        if (!has_none) bytes_read_ += static_cast<std::size_t>(size);
        const double scale = number_of(file.scale);
        ObjModel model = read_obj(file.path, palette_, {scale, file.is_z_up, file.dither, glasses_});
        for (const std::string& warning : model.warnings) values.warn(file.path + ": " + warning);
        return std::move(model.mesh);
    }

    const Level& level_;
    const Palette& palette_;
    ModelFinder finder_;
    bool shows_classes_;  ///< Quake's own, with models
    std::int64_t world_type_ = 0;
    bool has_health_ = false;
    LevelModels models_;
    std::map<ModelFile, const Mesh*> meshes_;
    std::size_t bytes_read_ = 0;  ///< see kMostModels_bytes
    TurningBrushes turning_;
    std::vector<std::string> glasses_;  ///< that the level's entities name, sorted
    std::set<std::string> missing_;     ///< files of Quake's classes
};

}  // namespace

LevelModels read_level_models(const Level& level, const Palette& palette, const ModelFolders& folders) {
    return LevelModelReader(level, palette, folders).read();
}

}  // namespace oblong

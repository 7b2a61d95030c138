#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/level/level.h"
#include "engine/scene/face_table.h"

namespace oblong {

/// A light that is not in the lightmaps: a torch, a lantern, a muzzle flash. To a light sample at a distance of d units
/// it adds radius - d (128: full light) times its brightness, as in Quake, if it is in front of the face. Walls cast no
/// shadow of it.
struct MovingLight {
    Vec3<World> position;
    World radius;                       ///< clamped to kMostLightRadius
    std::int32_t brightness_256 = 256;  ///< 256: 1; clamped to kMostBrightness_256
    constexpr bool operator==(const MovingLight&) const = default;
};

inline constexpr World kMostLightRadius = World::from_int(2048);
inline constexpr std::int32_t kMostBrightness_256 = 16 * 256;

/// Whether a light within `strays` of its position, 0 to 4,096 units, may touch a face whose model has not moved
/// (MovingLights::touch).
bool may_touch(const MovingLight& light, World strays, const Level& level, FaceIndex face, const FaceTable& faces);

/// The moving lights that touch a face.
struct LightTouch {
    std::uint32_t lights = 0;   ///< one bit each
    std::uint32_t version = 0;  ///< changes whenever one of them or the face has moved; 0: none
};

/// The moving lights of a frame, and the faces that they touch. A frame without lights tests and stores nothing.
class MovingLights {
  public:
    /// Most lights of one frame: those with the least distance from the eye minus radius; of equal ones the first.
    /// Choosing them takes time linear in the number of lights.
    static constexpr int kMost = 32;

    /// `level` and `faces` must outlive it.
    MovingLights(const Level& level, const FaceTable& faces) : level_(level), faces_(faces) {}

    /// Sets the lights from now on. Those without radius or brightness are ignored.
    void set(std::span<const MovingLight> lights, const Vec3<World>& eye);
    bool is_empty() const { return active_ == 0; }
    /// The lights that touch a lit face, its model moved by `offset`: they are in front of its plane and nearer than
    /// their radius, and their reach overlaps the rectangle of its light samples.
    LightTouch touch(FaceIndex face, const Vec3<World>& offset);
    /// Adds these lights to the samples of a face, row by row, with 8 fraction bits. For a light of brightness 1 the
    /// error is below 1/64 if the face has more than 1/16 texels a unit.
    void add_light(FaceIndex face, const Vec3<World>& offset, std::uint32_t lights,
                   std::span<std::int32_t> samples_8) const;

  private:
    /// A light keeps its slot, also in frames without it, until a new light takes the slot.
    struct Known {
        MovingLight light;
        std::uint64_t version = 0;
    };
    /// What touched a face at the last call of touch(). If all members but `version` are equal, the light is equal: a
    /// changed light gets a version above all others, so `newest` changes for each set that contains it.
    struct FaceTouch {
        std::uint32_t lights = 0, version = 0;
        std::uint64_t newest = 0;
        Vec3<World> offset;
    };

    void choose(std::span<const MovingLight> lights, const Vec3<World>& eye);
    void keep_known();
    void add_new();
    FaceTouch& last_touch(FaceIndex face);

    const Level& level_;
    const FaceTable& faces_;
    std::array<Known, kMost> known_;
    std::uint32_t active_ = 0;  ///< the known lights of this frame, one bit each
    std::uint64_t version_ = 0;
    std::vector<MovingLight> chosen_;         ///< scratch
    Table<FaceTouch> touches_;                ///< of all faces ever touched
    Table<Index<FaceTouch>, Face> touch_of_;  ///< none: never touched; allocated when a light first touches a face
};

}  // namespace oblong

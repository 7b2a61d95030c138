#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/level/level.h"
#include "engine/scene/face_table.h"

namespace oblong {

/// A light that the lightmaps do not hold: a torch, a lantern, a muzzle flash. To a light sample in front of whose face
/// it is, at a distance of d units, it adds radius - d (128: full light) times its brightness, as in Quake; walls cast
/// no shadow of it.
struct MovingLight {
    Vec3<World> position;
    World radius;                       ///< kMostLightRadius at most: longer ones count as that
    std::int32_t brightness_256 = 256;  ///< 256: 1; kMostBrightness_256 at most: brighter ones count as that
    constexpr bool operator==(const MovingLight&) const = default;
};

inline constexpr World kMostLightRadius = World::from_int(2048);
inline constexpr std::int32_t kMostBrightness_256 = 16 * 256;

/// Which moving lights touch a face.
struct LightTouch {
    std::uint32_t lights = 0;   ///< a bit each
    std::uint32_t version = 0;  ///< another one whenever one of them, or the face, has moved; 0: none touches it
};

/// The moving lights of a frame, and which faces they touch. For a frame without them nothing is tested or kept.
class MovingLights {
  public:
    /// Lights that count in one frame: those whose reach is nearest to the eye (distance less radius; of equal ones
    /// those that come first). Choosing them takes time linear in the number of lights.
    static constexpr int kMost = 32;

    /// The level must outlive it.
    MovingLights(const Level& level, const FaceTable& faces) : level_(level), faces_(faces) {}

    /// Sets the lights from now on. Those without radius or brightness do not count.
    void set(std::span<const MovingLight> lights, const Vec3<World>& eye);
    bool is_empty() const { return active_ == 0; }
    /// The lights that touch a lit face, its model moved by `offset`: its plane is nearer than their radius and they
    /// are in front of it, and their reach touches the rectangle of its light samples.
    LightTouch touch(FaceIndex face, const Vec3<World>& offset);
    /// Adds the light of those lights to the samples of a face, row by row, with 8 fraction bits. That of a light of
    /// brightness 1 is within 1/64 of the exact value if the face has more than 1/16 texels a unit.
    void add_light(FaceIndex face, const Vec3<World>& offset, std::uint32_t lights,
                   std::span<std::int32_t> samples_8) const;

  private:
    /// A light that stays in its place until another one takes it, in frames that don't show it too.
    struct Known {
        MovingLight light;
        std::uint64_t version = 0;
    };
    /// What touched a face when it was last asked for. Equal ones mean equal light: a light that changes gets a version
    /// above all others, so that the newest one of any set that it is in changes.
    struct FaceTouch {
        std::uint32_t lights = 0, version = 0;
        std::uint64_t newest = 0;
        Vec3<World> offset;
    };

    void choose(std::span<const MovingLight> lights, const Vec3<World>& eye);
    void keep_known();
    void add_new();
    bool touches(const MovingLight& light, const Face& face, TexelDensity density, const Vec3<World>& offset) const;

    const Level& level_;
    const FaceTable& faces_;
    std::array<Known, kMost> known_;
    std::uint32_t active_ = 0;  ///< those of the known lights that are in this frame, a bit each
    std::uint64_t version_ = 0;
    std::vector<MovingLight> chosen_;  ///< scratch
    Table<FaceTouch, Face> touch_of_;  ///< made when a light first touches a face
};

}  // namespace oblong

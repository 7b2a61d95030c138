#pragma once

#include <array>
#include <optional>

#include "tools/map/light/lightmaps.h"
#include "tools/map/source/map_file.h"
#include "tools/map/tree/bsp_file.h"

namespace oblong::map {

/// How light fades with distance d (in world units, times the key "wait"), as the key "delay" says.
enum class Falloff {
    kLinear = 0,         ///< light - d
    kInverse = 1,        ///< light / (d / 128)
    kInverseSquare = 2,  ///< light / (d / 128)^2
    kNone = 3,           ///< light
    kFarther = 5,        ///< light / ((d + 128) / 128)^2
};

/// An entity `light...`, or another with a key light that is nothing else for its class. Its keys, and what they are
/// where they are not given: engine/level/entity_classes.
struct LightSource {
    Point origin;
    double brightness = 0;       ///< at least 0
    bool is_subtracted = false;  ///< the key was negative: takes light away
    double wait = 1;
    Falloff falloff = Falloff::kLinear;
    int style = 0;
    const MapEntity* entity = nullptr;
    std::optional<Point> direction;  ///< of a spotlight
    double cone_cosine = -1;         ///< of half of the spotlight's opening
    double radius = 0;               ///< what is as near as this throws no shadow in its light: the lamp's own body

    /// Light that arrives (or is taken away) at a distance, before the angle of the surface counts; at least 0.
    double at_distance(double distance) const;
    /// The distance from which on nothing is seen of it.
    double range() const;
    bool shines_on(const Point& towards) const;
};

/// Parallel light from the sky: worldspawn's _sunlight and _sun_mangle ("yaw pitch roll", pitch -90 shines straight
/// down).
struct Sun {
    double brightness = 0;
    Point direction{0, 0, -1};  ///< that the light travels in
};

struct Lights {
    std::vector<LightSource> sources;
    Sun sun;
    std::vector<double> least;  ///< by model: worldspawn's _minlight (or light), the brush entity's if that is more
};

/// The entities must outlive what it returns.
Lights lights_of(const std::vector<MapEntity>& entities);

/// Gives each light that can be switched (has a targetname, but no style) the style of its name, from 32 on, as a key.
void assign_switchable_styles(std::vector<MapEntity>& entities);

/// The samples of a face's lightmap: at every 16th texel, from the multiple of 16 at or below the least texel of its
/// corners to the one at or above the greatest.
struct LightGrid {
    static constexpr int kStep = 16;
    std::array<int, 2> first{};  ///< in steps: texel / kStep
    std::array<int, 2> count{};
};

/// Where light is measured for the samples of a face's lightmap.
class FaceSampler {
  public:
    FaceSampler(const BspFile& bsp, const FileFace& face, const Tracer& tracer);

    const Point& normal() const { return normal_; }
    const LightGrid& grid() const { return grid_; }
    const Point& centre() const { return centre_; }
    double radius() const { return radius_; }

    /// The point, kLift over the face, at sample (u, v) of the grid (fractions lie between samples). One that is
    /// inside of a wall or beyond it moves to the nearest point over the face itself.
    Point point_at(double u, double v) const;

  private:
    static constexpr double kLift = 1, kInset = 1;

    Point nearest_over_face(const Point& point) const;

    const Tracer& tracer_;
    LightGrid grid_;
    Point normal_;
    std::vector<Point> corners_;  // lifted
    Point centre_;                // of the lifted corners
    double radius_ = 0;
    Point base_, step_u_, step_v_;
};

}  // namespace oblong::map

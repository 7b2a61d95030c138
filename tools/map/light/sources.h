#pragma once

#include <array>
#include <optional>

#include "tools/map/source/geometry.h"
#include "tools/map/source/map_file.h"

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
    double brightness = 0;       ///< at least 0: also how far it reaches
    double luminance = 1;        ///< of its colour: what arrives is that much of it
    bool is_subtracted = false;  ///< the key was negative: takes light away
    double wait = 1;
    Falloff falloff = Falloff::kLinear;
    int style = 0;
    const MapEntity* entity = nullptr;
    std::optional<Point> direction;  ///< of a spotlight
    double cone_cosine = -1;         ///< of half of the spotlight's opening
    double radius = 0;               ///< what is as near as this throws no shadow in its light: the lamp's own body
    std::string surface;             ///< a texture whose faces shine in its place
    double surface_offset = 2;       ///< units over them
    bool is_surface_spotlight = false;

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

/// Light out of the hemisphere over a surface: the keys of worldspawn that begin with "_".
struct HemisphereSettings {
    double sunlight2 = 0, sunlight3 = 0;  ///< where nothing but sky is seen: above the horizon, and below
    bool has_dirt = false;                ///< corners are darker
    double dirt_depth = 128, dirt_scale = 1, dirt_gain = 1;
    int bounces = 0;  ///< of light from surface to surface
    double bounce_scale = 1;

    bool is_needed() const { return sunlight2 > 0 || sunlight3 > 0 || has_dirt || bounces > 0; }
};

struct Lights {
    std::vector<LightSource> sources;
    Sun sun;
    HemisphereSettings hemisphere;
    std::vector<double> least;  ///< by model: worldspawn's _minlight (or light), the brush entity's if that is more
};

/// The entities must outlive what it returns.
Lights lights_of(const std::vector<MapEntity>& entities);

/// Gives each light that can be switched (has a targetname, but no style) the style of its name, from 32 on, as a key.
void assign_switchable_styles(std::vector<MapEntity>& entities);

}  // namespace oblong::map

#pragma once

#include <array>
#include <optional>

#include "tools/map/source/checks.h"
#include "tools/map/source/geometry.h"
#include "tools/map/source/map_file.h"
#include "tools/map/tree/bsp_file.h"

namespace oblong::map {

/// How light fades with distance d (world units, times the key "wait"), by the key "delay".
enum class Falloff {
    kLinear = 0,         ///< light - d
    kInverse = 1,        ///< light / (d / 128)
    kInverseSquare = 2,  ///< light / (d / 128)^2
    kNone = 3,           ///< light
    kFarther = 5,        ///< light / ((d + 128) / 128)^2
};

/// The usual share of light that depends on the cosine of its angle to the normal of a surface: "_anglescale".
inline constexpr double kAngleShare = 0.5;

/// An entity `light...`, or another entity with a key "light" that has no other meaning for its class. For the keys and
/// their defaults see engine/level/entity_classes.
struct LightSource {
    Point origin;
    double brightness = 0;  ///< at least 0: also determines its range
    double luminance = 1;   ///< of its colour: a factor of its light
    Hue hue;
    bool is_subtracted = false;  ///< the key was negative: subtracts light
    double wait = 1;
    double angle_share = kAngleShare;
    Falloff falloff = Falloff::kLinear;
    int style = 0;
    const MapEntity* entity = nullptr;
    std::optional<Point> direction;  ///< of a spotlight
    double cone_cosine = -1;         ///< of half of the spotlight's opening
    double full_cosine = -1;         ///< of that within which it is at its full, at least the former
    double deviance = 0;             ///< radius in units: shines from points all over a ball
    int samples = 1;                 ///< of the ball
    double radius = 0;               ///< surfaces within it cast no shadow: the lamp's own body
    std::string surface;             ///< a texture whose faces shine instead of it
    double surface_offset = 2;       ///< units above them
    bool is_surface_spotlight = false;

    /// Light added (or subtracted) at a distance, without the factor for the surface's angle; at least 0.
    double at_distance(double distance) const;
    /// The distance beyond which its light is invisible.
    double range() const;
    /// Of a spotlight's cone: 0 outside, 1 where it is at its full, linear by the cosine in between.
    double share_towards(const Point& direction) const;
};

/// Parallel light from the sky: worldspawn's _sunlight and _sun_mangle ("yaw pitch roll", pitch -90 shines straight
/// down).
struct Sun {
    double brightness = 0;  ///< the luminance of its light
    Hue hue;
    Point direction{0, 0, -1};   ///< in which the light travels
    double penumbra_radius = 0;  ///< of its disc at distance 1
    double angle_share = kAngleShare;
};

/// Light from the hemisphere over a surface: worldspawn's keys that begin with "_".
struct HemisphereSettings {
    Light sunlight2, sunlight3;  ///< if only sky is visible: above the horizon, and below
    bool has_dirt = false;       ///< corners are darker
    double dirt_depth = 128, dirt_scale = 1, dirt_gain = 1;
    int bounces = 0;  ///< of light from surface to surface
    double bounce_scale = 1;
    double bounce_colour = 1;       ///< 0: surfaces reflect all colours alike
    bool is_bounce_styled = false;  ///< light of other styles than 0 is reflected, too

    bool is_needed() const { return sunlight2.luminance > 0 || sunlight3.luminance > 0 || has_dirt || bounces > 0; }
};

struct Lights {
    std::vector<LightSource> sources;
    Sun sun;
    HemisphereSettings hemisphere;
    std::vector<Light> least;  ///< by model: worldspawn's _minlight (or light), the brush entity's if that is more
    std::vector<int> shadow_models;  ///< numbers of brush models that shade as the world does: "_shadow"
    bool is_coloured = false;        ///< some of the light is not white
};

/// The entities must outlive the result.
Lights lights_of(const std::vector<MapEntity>& entities);

/// Replaces each light with a deviance by lights all over its ball, which share its luminance.
void spread_deviant_lights(std::vector<LightSource>& sources);

/// Sets the light of brush sides from the keys of their entities ("_phong", "_minlight" ...) and of the worldspawn.
void set_surface_light(std::vector<MapEntity>& entities);

/// Sets the key "style" of each switchable light (with a targetname but no style) to the style of its name, from 32 on.
void assign_switchable_styles(std::vector<MapEntity>& entities);

/// Replaces each light with the key "_surface": puts a light at the middle of each piece, at most kSurfacePiece units
/// wide, of the surfaces with this texture, `offset` units above the surface. The result does not depend on the number
/// of faces into which the compiler cut a surface. A texture without faces is a warning.
void spread_surface_lights(std::vector<LightSource>& sources, const BspFile& bsp, Warnings& warnings);

inline constexpr double kSurfacePiece = 128;

}  // namespace oblong::map

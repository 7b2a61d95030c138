#include "tools/map/light/sources.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "engine/base/input_error.h"
#include "engine/base/text.h"
#include "engine/level/entity_classes.h"
#include "tools/map/source/entities.h"

namespace oblong::map {

namespace {

constexpr double kFadeUnit = 128;  // of the inverse falloffs
constexpr double kLeastSeen = 1;   // of 255, doubled
constexpr int kFirstSwitchableStyle = 32, kStyleCount = 64;

double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

/// The default of a key, a light's unless it says otherwise.
double usual(std::string_view key, std::string_view class_name = "light") {
    return std::stod(std::string(usual_text(class_name, key)));
}

double value_of(const MapEntity& entity, std::string_view key) {
    return number_of(entity, key, usual(key));
}

bool is_falloff(double delay) {
    const std::span<const KeyValue> values = find_entity_key(*find_entity_class("light"), "delay")->values;
    return std::any_of(values.begin(), values.end(),
                       [&](const KeyValue& each) { return std::stod(std::string(each.value)) == delay; });
}

bool is_light(const MapEntity& entity) {
    return role_of(entity) == ClassRole::Lamp;
}

// As in id's compiler, any other entity with a key "light" shines, unless its class has its own key of that name.
bool shines(const MapEntity& entity) {
    if (numbers_of(entity, "light", 1).empty() || !entity.brushes.empty()) return false;
    const EntityClass* const its_class = find_entity_class(entity.value("classname"));
    return its_class == nullptr || find_entity_key(*its_class, "light") == find_entity_key({}, "light");
}

// "yaw pitch roll", pitch positive upward.
std::optional<Point> direction_of_mangle(const MapEntity& entity, std::string_view key) {
    const auto angles = numbers_of(entity, key, 2);
    if (angles.empty()) return std::nullopt;
    const double yaw = radians(angles[0]), pitch = radians(angles[1]);
    return Point{std::cos(yaw) * std::cos(pitch), std::sin(yaw) * std::cos(pitch), std::sin(pitch)};
}

std::optional<Point> spot_direction(const MapEntity& entity, const Point& origin,
                                    const std::vector<MapEntity>& entities) {
    if (const auto direction = direction_of_mangle(entity, "mangle")) return direction;
    if (!entity.has("target")) return std::nullopt;
    const auto target = std::find_if(entities.begin(), entities.end(), [&](const MapEntity& other) {
        return other.value("targetname") == entity.value("target");
    });
    if (target == entities.end() || origin_of(*target).value_or(origin) == origin) return std::nullopt;
    return unit(*origin_of(*target) - origin);
}

struct Colour {
    double luminance = 1;
    Hue hue;
};

// "red green blue", 0 to 255 or 0 to 1.
Colour colour_of(const std::vector<double>& channels) {
    const double luminance = (299 * channels[0] + 587 * channels[1] + 114 * channels[2]) / 1000;
    const bool is_of_255 = std::max({channels[0], channels[1], channels[2]}) > 1;
    Colour colour{std::max(0.0, is_of_255 ? luminance / 255 : luminance), {}};
    for (std::size_t i = 0; i < 3 && luminance > 0; ++i)
        colour.hue.channels[i] = std::max(0.0, channels[i]) / luminance;
    return colour;
}

// White without the key.
Colour colour_of(const MapEntity& entity, std::string_view key, const Colour& otherwise = {}) {
    const auto channels = numbers_of(entity, key, 3);
    return channels.empty() ? otherwise : colour_of(channels);
}

Light light_of(double brightness, const Colour& colour) {
    return colour.hue.of(brightness * colour.luminance);
}

Light own_least_of(const MapEntity& entity) {
    return light_of(number_of(entity, "_minlight", 0), colour_of(entity, "_minlight_color"));
}

// "light" and "_light" may be a number, or a colour with an optional number: "red green blue brightness".
std::pair<double, Colour> brightness_of(const MapEntity& entity, double otherwise) {
    const std::string key = entity.has("light") ? "light" : "_light", value = entity.value(key);
    std::size_t words = 0;
    for (std::string_view rest = value; !take_word(rest).empty();) ++words;
    const auto numbers = numbers_of(entity, key, std::min<std::size_t>(words, 4));
    if (numbers.empty()) return {otherwise, {}};
    if (numbers.size() < 3) return {numbers.front(), {}};
    return {numbers.size() == 4 ? numbers.back() : otherwise, colour_of(numbers)};
}

// The entity's, or else the world's.
double angle_share_of(const MapEntity& entity, double otherwise) {
    const double share = number_of(entity, "_anglescale", number_of(entity, "_anglesense", otherwise));
    return share < 0 || share > 1 ? otherwise : share;
}

LightSource source_of(const MapEntity& entity, const Point& origin, const std::vector<MapEntity>& entities) {
    LightSource source;
    source.origin = origin;
    source.entity = &entity;
    auto [brightness, colour] = brightness_of(entity, usual("light"));
    if (brightness == 0 && is_light(entity)) brightness = usual("light");  // as in id's compiler and its successors
    source.brightness = std::abs(brightness);
    colour = colour_of(entity, "_color", colour);
    source.luminance = colour.luminance;
    source.hue = colour.hue;
    source.is_subtracted = brightness < 0;
    source.angle_share = angle_share_of(entity, angle_share_of(entities.front(), kAngleShare));
    if (!is_light(entity)) return source;  // its other keys have other meanings
    source.wait = value_of(entity, "wait");
    if (source.wait <= 0) source.wait = usual("wait");
    const double delay = value_of(entity, "delay");
    source.falloff = static_cast<Falloff>(static_cast<int>(is_falloff(delay) ? delay : usual("delay")));
    const double style = value_of(entity, "style");
    source.style = static_cast<int>(style >= 0 && style < kStyleCount ? style : usual("style"));
    source.direction = spot_direction(entity, origin, entities);
    source.radius = std::max(value_of(entity, "radius"), 0.0);
    source.surface = lower_case(entity.value("_surface"));
    source.surface_offset = value_of(entity, "_surface_offset");
    source.is_surface_spotlight = value_of(entity, "_surface_spotlight") > 0;
    const double cone = value_of(entity, "angle");
    if (source.direction || source.is_surface_spotlight) {
        source.cone_cosine = source.full_cosine = std::cos(radians((cone > 0 ? cone : usual("angle")) / 2));
        const double soft = value_of(entity, "_softangle");
        if (soft > 0) source.full_cosine = std::max(source.cone_cosine, std::cos(radians(soft / 2)));
    }
    constexpr double kMostSamples = 64;
    source.deviance = std::max(value_of(entity, "_deviance"), 0.0);
    source.samples = static_cast<int>(std::clamp(value_of(entity, "_samples"), 1.0, kMostSamples));
    return source;
}

// The switchable styles that are not set by a light's key "style", for example with its own "pattern".
std::vector<int> styles_left_free(const std::vector<MapEntity>& entities) {
    std::set<double> taken;
    for (const MapEntity& entity : entities)
        if (is_light(entity) && entity.has("style")) taken.insert(number_of(entity, "style", 0));
    std::vector<int> free;
    for (int style = kFirstSwitchableStyle; style < kStyleCount; ++style)
        if (!taken.contains(style)) free.push_back(style);
    return free;
}

HemisphereSettings hemisphere_of(const MapEntity& world) {
    const auto value = [&](std::string_view key) { return number_of(world, key, usual(key, "worldspawn")); };
    HemisphereSettings settings;
    // In ericw-tools these are suns all over the sky, which share the brightness and are weighted by (1 + cosine) / 2
    // like lamps: the mean over an open hemisphere is 3/4.
    const double dome = 1 - angle_share_of(world, kAngleShare) / 2;
    settings.sunlight2 = light_of(dome * std::max(value("_sunlight2"), 0.0), colour_of(world, "_sunlight2_color"));
    settings.sunlight3 = light_of(dome * std::max(value("_sunlight3"), 0.0), colour_of(world, "_sunlight3_color"));
    settings.has_dirt = value("_dirt") > 0;
    settings.dirt_depth = std::max(value("_dirtdepth"), 1.0);
    settings.dirt_scale = std::max(value("_dirtscale"), 0.0);
    settings.dirt_gain = std::max(value("_dirtgain"), 0.0);
    constexpr double kMostBounces = 8;
    settings.bounces = static_cast<int>(std::clamp(value("_bounce"), 0.0, kMostBounces));
    settings.bounce_scale = std::max(value("_bouncescale"), 0.0);
    settings.bounce_colour = std::clamp(value("_bouncecolorscale"), 0.0, 1.0);
    settings.is_bounce_styled = value("_bouncestyled") > 0;
    return settings;
}

bool has_colours(const Lights& lights, const std::vector<MapEntity>& entities) {
    const HemisphereSettings& hemisphere = lights.hemisphere;
    return !lights.sun.hue.is_white() || !hemisphere.sunlight2.is_white() || !hemisphere.sunlight3.is_white() ||
           !lights.least.front().is_white() ||
           !std::all_of(entities.begin(), entities.end(),
                        [](const MapEntity& entity) { return own_least_of(entity).is_white(); }) ||
           !std::all_of(lights.sources.begin(), lights.sources.end(),
                        [](const LightSource& source) { return source.hue.is_white(); });
}

}  // namespace

double LightSource::at_distance(double distance) const {
    const double faded = std::max(distance * wait, 1.0);
    const double full = luminance * brightness;
    switch (falloff) {
        case Falloff::kLinear:
            return luminance * std::max(brightness - faded, 0.0);
        case Falloff::kInverse:
            return full * kFadeUnit / faded;
        case Falloff::kInverseSquare:
            return full * (kFadeUnit / faded) * (kFadeUnit / faded);
        case Falloff::kFarther:
            return full * (kFadeUnit / (faded + kFadeUnit)) * (kFadeUnit / (faded + kFadeUnit));
        default:
            return full;
    }
}

double LightSource::range() const {
    switch (falloff) {
        case Falloff::kLinear:
            return brightness / wait;
        case Falloff::kInverse:
            return brightness * kFadeUnit / kLeastSeen / wait;
        case Falloff::kInverseSquare:
        case Falloff::kFarther:
            return kFadeUnit * std::sqrt(brightness / kLeastSeen) / wait;
        default:
            return 1e9;
    }
}

double LightSource::share_towards(const Point& towards) const {
    const double cosine = direction ? dot(*direction, towards) : 1;
    if (cosine < cone_cosine) return 0;
    return cosine >= full_cosine ? 1 : (cosine - cone_cosine) / (full_cosine - cone_cosine);
}

void spread_deviant_lights(std::vector<LightSource>& sources) {
    std::vector<LightSource> spread;
    for (const LightSource& source : sources) {
        const int count = source.deviance > 0 ? source.samples : 1;
        for (int i = 0; i < count; ++i) {
            LightSource& part = spread.emplace_back(source);
            part.luminance /= count;
            if (count == 1) continue;
            const double height = 1 - (2 * i + 1.0) / count, ring = std::sqrt(1 - height * height),
                         angle = i * kGoldenAngle;
            part.origin =
                source.origin + Point{ring * std::cos(angle), ring * std::sin(angle), height} * source.deviance;
        }
    }
    sources = std::move(spread);
}

Lights lights_of(const std::vector<MapEntity>& entities) {
    Lights lights;
    for (const MapEntity& entity : entities) {
        const auto origin = origin_of(entity);
        if ((!is_light(entity) && !shines(entity)) || !origin) continue;
        LightSource source = source_of(entity, *origin, entities);
        if (source.brightness > 0 && source.luminance > 0) lights.sources.push_back(source);
    }
    const MapEntity& world = entities.front();
    const auto [brightness, colour] = brightness_of(world, 0);
    lights.least = {light_of(number_of(world, "_minlight", brightness),
                             colour_of(world, "_minlight_color", world.has("_minlight") ? Colour{} : colour))};
    for (const MapEntity& entity : entities) {
        if (entity.brushes.empty() || belongs_to_world(entity)) continue;
        if (number_of(entity, "_shadow", 0) > 0) lights.shadow_models.push_back(static_cast<int>(lights.least.size()));
        lights.least.push_back(own_least_of(entity).raise_to(lights.least.front()));
    }
    lights.hemisphere = hemisphere_of(world);
    const Colour of_sun = colour_of(world, "_sunlight_color");
    lights.sun.brightness = number_of(world, "_sunlight", 0) * of_sun.luminance;
    lights.sun.hue = of_sun.hue;
    lights.sun.angle_share = angle_share_of(world, kAngleShare);
    for (const char* const key : {"_sun_mangle", "_sunlight_mangle", "_sun_angle"})
        lights.sun.direction = direction_of_mangle(world, key).value_or(lights.sun.direction);
    constexpr double kMostPenumbra = 90;
    const double penumbra = std::clamp(number_of(world, "_sunlight_penumbra", 0), 0.0, kMostPenumbra);
    lights.sun.penumbra_radius = std::tan(radians(penumbra) / 2);
    lights.is_coloured = has_colours(lights, entities);
    return lights;
}

void set_surface_light(std::vector<MapEntity>& entities) {
    const double usual_angle = usual("_phong_angle", "func_group");
    for (MapEntity& entity : entities) {
        if (entity.brushes.empty()) continue;
        SurfaceLight light;
        const double angle = number_of(entity, "_phong_angle", 0);
        if (angle > 0 || number_of(entity, "_phong", 0) > 0) light.smooth_degrees = angle > 0 ? angle : usual_angle;
        light.smooth_group = static_cast<int>(number_of(entity, "_phong_group", 0));
        if (role_of(entity) != ClassRole::Worldspawn && belongs_to_world(entity)) light.least = own_least_of(entity);
        light.ignores_light = number_of(entity, "_lightignore", 0) > 0;
        light.has_no_dirt = number_of(entity, "_dirt", 0) < 0;
        for (MapBrush& brush : entity.brushes)
            for (MapSide& side : brush.sides) side.texture.light = light;
    }
}

void assign_switchable_styles(std::vector<MapEntity>& entities) {
    const std::vector<int> free = styles_left_free(entities);
    std::vector<std::string> names;
    for (MapEntity& entity : entities) {
        const std::string name = entity.value("targetname");
        if (!is_light(entity) || name.empty() || entity.has("style")) continue;
        const auto found = std::find(names.begin(), names.end(), name);
        const auto index = static_cast<std::size_t>(found - names.begin());
        if (found == names.end()) names.push_back(name);
        if (index >= free.size())
            throw InputError(at_line(entity.line), "more than " + std::to_string(free.size()) +
                                                       " names of switchable lights, expected at most " +
                                                       std::to_string(free.size()));
        entity.pairs.push_back({"style", std::to_string(free[index]), entity.line});
    }
}

}  // namespace oblong::map

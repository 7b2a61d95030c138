#include "game/view.h"

#include <algorithm>

#include "game/player.h"

namespace oblong {
namespace {

// A jump longer than this within a tick is no motion but another place (a teleporter).
constexpr World kLongestMotion = World::from_int(128);

World between(World before, World after, std::int32_t fraction_16) {
    const std::int64_t way = std::int64_t{after.raw} - before.raw;
    return World::from_raw(static_cast<std::int32_t>(before.raw + floor_shift(way * fraction_16, 16)));
}

Place between(const Place& before, const Place& after, std::int32_t fraction_16) {
    return {between(before.x, after.x, fraction_16), between(before.y, after.y, fraction_16),
            between(before.z, after.z, fraction_16)};
}

Place eye_of(const Player& player) {
    return player.place + Place{World{}, World{}, World::from_int(kEyeHeight) - player.eye_lag};
}

bool is_motion(const Place& before, const Place& after) {
    const auto is_near = [](World way) { return way <= kLongestMotion && way >= -kLongestMotion; };
    const Place way = after - before;
    return is_near(way.x) && is_near(way.y) && is_near(way.z);
}

}  // namespace

Camera camera_at(const Moment& moment, ViewLead lead, Degrees field_of_view) {
    const Player& player = moment.after.player;
    const Place before = eye_of(moment.before.player), after = eye_of(player);
    Camera camera;
    camera.eye = is_motion(before, after) ? between(before, after, moment.fraction_16) : after;
    camera.yaw = player.yaw + Angle::from_bam(lead.yaw);
    camera.pitch =
        Angle::from_bam(std::clamp(player.pitch + lead.pitch, -Player::kSteepestPitch, Player::kSteepestPitch));
    camera.field_of_view = field_of_view;
    return camera;
}

std::vector<PlacedModel> models_at(const Stage& stage, const Moment& moment) {
    std::vector<PlacedModel> placed;
    for (std::size_t i = 0; i < stage.movers.size(); ++i) {
        const Mover& mover = stage.movers[i];
        const Place before = offset_of(mover, moment.before.movers[i]),
                    after = offset_of(mover, moment.after.movers[i]);
        placed.push_back({mover.model, between(before, after, moment.fraction_16)});
    }
    for (const ModelIndex model : stage.still_models) placed.push_back({model, {}});
    return placed;
}

std::int64_t time_ms_at(const Moment& moment) {
    const std::int64_t ticks_16 = (moment.before.tick << 16) + moment.fraction_16;
    return ticks_16 * 1000 / kTicksPerSecond >> 16;
}

}  // namespace oblong

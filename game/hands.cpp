#include "game/hands.h"

#include <utility>

#include "engine/base/input_error.h"
#include "game/world.h"

namespace oblong {

Hands::Hands(const GameState& start, std::optional<Demo> replayed, bool records)
    : replayed_(std::move(replayed)), records_(records) {
    recorded_.start_hash = hash_of(start);
    if (replayed_ && replayed_->start_hash != recorded_.start_hash)
        throw InputError("start", "recorded on another level, expected this one's");
}

void Hands::play_tick(const Stage& stage, GameState& state) {
    was_replayed_ = is_replaying();
    last_ = was_replayed_ ? replayed_->ticks[next_].input : live_.next();
    step(stage, state, last_);
    if (!was_replayed_ && !records_) return;
    const std::uint64_t hash = hash_of(state);
    if (records_) recorded_.ticks.push_back({last_, hash});
    if (was_replayed_ && replayed_->ticks[next_++].state_hash != hash)
        throw InputError("tick " + std::to_string(next_), "leads to another state than when it was recorded");
}

ViewLead Hands::lead(std::int32_t fraction_16) const {
    return was_replayed_ ? lead_of(last_, fraction_16) : live_.lead(fraction_16);
}

}  // namespace oblong

#include "game/collision.h"

#include "engine/level/trace.h"

namespace oblong {
namespace {

// A solid model where it stands now.
struct Obstacle {
    ModelIndex model;
    Place offset;
};

const SubModel& model_of(const Stage& stage, const Obstacle& obstacle) {
    return stage.level->models[obstacle.model];
}

// Calls visit(obstacle) for the world, the models that stand still and the movers, until one answers false.
template <class Visit>
bool for_each_obstacle(const Stage& stage, const GameState& state, Visit visit) {
    if (!visit(Obstacle{kWorldModel, {}})) return false;
    for (const ModelIndex model : stage.solid_still_models)
        if (!visit(Obstacle{model, {}})) return false;
    for (std::size_t i = 0; i < stage.movers.size(); ++i)
        if (!visit(Obstacle{stage.movers[i].model, offset_of(stage.movers[i], state.movers[i])})) return false;
    return true;
}

// Where a model can be hit at all: its box, grown by the player's and some room for rounding.
bool can_meet(const Stage& stage, const Obstacle& obstacle, const Box& swept) {
    if (obstacle.model == kWorldModel) return true;
    const Box box = box_of(model_of(stage, obstacle).box);
    return box.grown(place_of(2, 2, 2)).moved(obstacle.offset).overlaps(swept);
}

}  // namespace

Contact move_box(const Stage& stage, const GameState& state, const Place& from, const Place& to) {
    const Box swept = player_box(from).united(player_box(to));
    Contact first{to, false, {}, {}, false};
    Unit first_fraction = Unit::from_int(1);
    for_each_obstacle(stage, state, [&](const Obstacle& obstacle) {
        if (!can_meet(stage, obstacle, swept)) return true;
        const TraceResult trace = trace_hull(*stage.level, model_of(stage, obstacle), Hull::Player,
                                             from - obstacle.offset, to - obstacle.offset);
        if (trace.is_all_solid) {
            first = {from, true, {}, obstacle.model, true};
        } else if (trace.is_hit && (!first.has_hit || trace.fraction < first_fraction)) {
            first = {trace.end + obstacle.offset, true, trace.normal, obstacle.model, false};
            first_fraction = trace.fraction;
        }
        return !first.is_stuck;
    });
    return first;
}

bool is_free(const Stage& stage, const GameState& state, const Place& place) {
    const Box here = player_box(place);
    return for_each_obstacle(stage, state, [&](const Obstacle& obstacle) {
        return !can_meet(stage, obstacle, here) || hull_contents(*stage.level, model_of(stage, obstacle), Hull::Player,
                                                                 place - obstacle.offset) != contents::kSolid;
    });
}

std::int32_t contents_at(const Stage& stage, const Place& point) {
    return hull_contents(*stage.level, stage.level->world(), Hull::Point, point);
}

}  // namespace oblong

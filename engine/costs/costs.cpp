#include "engine/costs/costs.h"

#include <algorithm>

#include "engine/costs/prices.h"

namespace oblong {

namespace {

struct Clock {
    std::string_view name;
    std::int64_t megahertz;
};
constexpr std::array<Clock, kProcessors.size()> kClocks{
    {{"386 at 33 MHz", 33}, {"486 at 66 MHz", 66}, {"Pentium at 90 MHz", 90}}};

/// The events in the order of kPrices.
class EventList {
  public:
    void add(std::int64_t count) { item(events_, size_++) = count; }
    void add_if(bool applies, std::int64_t count) { add(applies ? count : 0); }
    const Events& events() const { return events_; }

  private:
    Events events_{};
    std::size_t size_ = 0;
};

void add_spans(const FrameCounts& counts, const Accuracy& accuracy, EventList& list) {
    const StageCounts& stages = counts.stages;
    list.add(stages.nodes);
    list.add(stages.vertices);
    list.add(stages.clipped_corners);
    list.add_if(accuracy.edges == EdgeStepping::Accumulated, stages.edge_rows);
    list.add(counts.spans);
    list.add(stages.surfaces);
    list.add_if(accuracy.mip == MipSelection::Span, counts.spans);
    list.add_if(accuracy.texturing == Texturing::Exact, counts.spans);
}

void add_blocks(const StageCounts& stages, Texturing texturing, EventList& list) {
    const auto is = [&](Texturing one) { return texturing == one; };
    list.add_if(is(Texturing::Affine), stages.blocks);
    list.add_if(is(Texturing::Every8) || is(Texturing::Every16) || is(Texturing::Every32), stages.blocks);
    list.add_if(is(Texturing::Bounded), stages.blocks);
    list.add_if(is(Texturing::BoundedTexels), stages.blocks);
    list.add_if(is(Texturing::Exact), stages.blocks);
    list.add(stages.last_blocks);
}

void add_texels(const FrameCounts& counts, const Accuracy& accuracy, EventList& list) {
    const StageCounts& stages = counts.stages;
    const auto is = [&](ReciprocalMethod method) { return accuracy.reciprocal == method; };
    const bool has_two_steps = is(ReciprocalMethod::Table256TwoNewton),
               has_steps =
                   has_two_steps || is(ReciprocalMethod::Table256Newton) || is(ReciprocalMethod::Table1024Newton),
               is_exact = accuracy.texturing == Texturing::Exact;
    const std::int64_t reciprocals = counts.divisions - stages.exact_divisions;
    list.add_if(is(ReciprocalMethod::Exact), reciprocals);
    list.add_if(!is(ReciprocalMethod::Exact), reciprocals);
    list.add_if(has_steps, reciprocals);
    list.add_if(has_two_steps, reciprocals);
    list.add(stages.textured_pixels - stages.divided_pixels);
    list.add_if(!is_exact, stages.divided_pixels);
    list.add_if(is_exact, stages.divided_pixels);
    list.add(stages.exact_divisions);
}

void add_effects(const FrameCounts& counts, EventList& list) {
    list.add(counts.stages.sky_directions);
    for (const Effect effect : {Effect::Liquid, Effect::Translucency, Effect::Lights, Effect::Fog, Effect::Sprites,
                                Effect::Mirror, Effect::Underwater})
        list.add(counts.of(effect));
    list.add(counts.stages.particles);
}

void add_lit_texels(const StageCounts& stages, const Accuracy& accuracy, EventList& list) {
    const std::int64_t texels = stages.lit_texels - stages.coloured_texels;
    list.add_if(accuracy.light == LightSampling::Interpolated, texels);
    list.add_if(accuracy.light == LightSampling::Nearest, texels);
    list.add_if(accuracy.dithers_light, stages.lit_texels);
    list.add(stages.coloured_texels);
}

}  // namespace

Events events_of(const FrameCounts& counts, const Accuracy& accuracy) {
    EventList list;
    add_spans(counts, accuracy, list);
    add_blocks(counts.stages, accuracy.texturing, list);
    add_texels(counts, accuracy, list);
    add_effects(counts, list);
    add_lit_texels(counts.stages, accuracy, list);
    return list.events();
}

std::string_view event_name(std::size_t event) {
    return item(kPrices, event).event;
}

std::int64_t cost_of(const Events& events, Currency currency) {
    std::int64_t cost_10 = 5;
    for (std::size_t i = 0; i < kEventCount; ++i) cost_10 += events[i] * item(kPrices[i].prices_10, currency);
    return cost_10 / 10;
}

std::string_view name_of(Processor processor) {
    return item(kClocks, processor).name;
}

std::int64_t cycles_on(Processor processor, const Events& events) {
    return cost_of(events, Currency(static_cast<int>(Currency::Cycles386) + static_cast<int>(processor)));
}

std::int64_t megahertz_of(Processor processor) {
    return item(kClocks, processor).megahertz;
}

std::int64_t frame_rate_10(Processor processor, std::int64_t cycles) {
    const std::int64_t least = std::max<std::int64_t>(cycles, 1);
    return (megahertz_of(processor) * 10'000'000 + least / 2) / least;
}

}  // namespace oblong

#include "engine/costs/costs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace oblong::test {

namespace {

/// The number of a frame's events with this name.
std::int64_t events_named(std::string_view name, const FrameCounts& counts, const Accuracy& accuracy) {
    const Events events = events_of(counts, accuracy);
    for (std::size_t i = 0; i < kEventCount; ++i)
        if (event_name(i) == name) return events[i];
    ADD_FAILURE() << "no event '" << name << "'";
    return -1;
}

/// Every count of a different power of two, so that an event shows which counts it is made of.
FrameCounts different_counts() {
    FrameCounts counts;
    StageCounts& stages = counts.stages;
    std::int64_t value = 1;
    for (std::int64_t* count : {&counts.faces_visited,
                                &counts.spans,
                                &stages.nodes,
                                &stages.vertices,
                                &stages.projected,
                                &stages.clipped_corners,
                                &stages.edges,
                                &stages.edge_rows,
                                &stages.surfaces,
                                &stages.blocks,
                                &stages.last_blocks,
                                &stages.sky_directions,
                                &stages.exact_divisions,
                                &stages.lit_texels,
                                &stages.particles,
                                &counts.of(Effect::Liquid),
                                &counts.of(Effect::Translucency),
                                &counts.of(Effect::Fog),
                                &counts.of(Effect::Mirror),
                                &stages.divided_pixels,
                                &stages.textured_pixels,
                                &counts.divisions})
        *count = value *= 2;
    return counts;
}

TEST(Costs, EachEventHasANameAndAPrice) {
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < kEventCount; ++i) {
        EXPECT_TRUE(names.insert(event_name(i)).second) << event_name(i);
        Events one{};
        one[i] = 10;
        std::int64_t sum = 0;  // one price may be none: that of what goes along with it has it then
        for (std::size_t k = 0; k < kCurrencyCount; ++k) {
            EXPECT_GE(cost_of(one, Currency(k)), 0) << event_name(i);
            sum += cost_of(one, Currency(k));
        }
        EXPECT_GT(sum, 0) << event_name(i);
    }
}

TEST(Costs, EventsAreApartByTheSettingsThatDoOtherWorkForThem) {
    const FrameCounts counts = different_counts();
    const StageCounts& stages = counts.stages;
    for (const std::int32_t texturing : {0, 1, 2, 3, 4, 5, 6}) {
        Accuracy accuracy;
        accuracy.texturing = Texturing(texturing);
        std::int64_t blocks = 0;
        for (const char* kind : {"affine", "even", "bounded", "texel-bounded", "exact"}) {
            const std::int64_t events = events_named(std::string(kind) + " blocks", counts, accuracy);
            EXPECT_TRUE(events == 0 || blocks == 0) << kind;
            blocks += events;
        }
        EXPECT_EQ(blocks, stages.blocks) << texturing;
        EXPECT_EQ(events_named("textured pixels", counts, accuracy), stages.textured_pixels - stages.divided_pixels);
        EXPECT_EQ(events_named("divided pixels", counts, accuracy) + events_named("exact pixels", counts, accuracy),
                  stages.divided_pixels);
    }
    Accuracy other;
    other.edges = EdgeStepping::Accumulated;
    other.light = LightSampling::Nearest;
    other.reciprocal = ReciprocalMethod::Table256Newton;
    for (const auto& [name, expected] : {std::pair<const char*, std::int64_t>{"lit texels", stages.lit_texels},
                                         {"block divisions", counts.divisions - stages.exact_divisions}}) {
        EXPECT_EQ(events_named(name, counts, {}), expected) << name;
        EXPECT_EQ(events_named(name, counts, other), 0) << name;
    }
    for (const auto& [name, expected] : {std::pair<const char*, std::int64_t>{"nearest lit texels", stages.lit_texels},
                                         {"table lookups", counts.divisions - stages.exact_divisions},
                                         {"stepped edge rows", stages.edge_rows}}) {
        EXPECT_EQ(events_named(name, counts, {}), 0) << name;
        EXPECT_EQ(events_named(name, counts, other), expected) << name;
    }
    for (const auto& [name, expected] : {std::pair<const char*, std::int64_t>{"nodes", stages.nodes},
                                         {"spans", counts.spans},
                                         {"surfaces", stages.surfaces},
                                         {"shared divisions", stages.exact_divisions},
                                         {"sky directions", stages.sky_directions},
                                         {"fogged pixels", counts.of(Effect::Fog)},
                                         {"mirrored pixels", counts.of(Effect::Mirror)},
                                         {"particles", stages.particles}})
        EXPECT_EQ(events_named(name, counts, {}), expected) << name;
}

}  // namespace
}  // namespace oblong::test

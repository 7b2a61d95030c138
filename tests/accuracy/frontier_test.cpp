#include "tools/accuracy/frontier.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace oblong::test {

namespace {

/// Made up: each setting of perspective costs twice the coarser one's and has a third of its error, but `every8` costs
/// more than the more exact ones; a table costs less, and its error is 10 times as large.
Trial made_up(const Accuracy& accuracy) {
    Trial trial{accuracy, 1000, {1, 1}};
    for (int i = 0; i < static_cast<int>(accuracy.texturing); ++i) {
        trial.error /= 3;
        trial.costs[0] *= 2;
    }
    if (accuracy.texturing == Texturing::Every8) trial.costs[0] = 1000;
    if (accuracy.reciprocal == ReciprocalMethod::Table256) trial.costs[0] *= 0.9, trial.error *= 10;
    trial.costs[1] = trial.costs[0];
    return trial;
}

TEST(Frontier, IsFoundWhereCombinationsOfDialsAreBest) {
    const std::vector<Accuracy> front = search_frontier(made_up, 1000, 1.02);
    const auto has = [&](Texturing texturing, ReciprocalMethod reciprocal) {
        return std::any_of(front.begin(), front.end(), [&](const Accuracy& accuracy) {
            return accuracy.texturing == texturing && accuracy.reciprocal == reciprocal;
        });
    };
    for (const Texturing texturing : {Texturing::Affine, Texturing::Every32, Texturing::Every16, Texturing::Bounded,
                                      Texturing::BoundedTexels, Texturing::Exact})
        EXPECT_TRUE(has(texturing, ReciprocalMethod::Exact)) << static_cast<int>(texturing);
    EXPECT_FALSE(has(Texturing::Every8, ReciprocalMethod::Exact)) << "others are closer and cheaper";
    EXPECT_TRUE(has(Texturing::Affine, ReciprocalMethod::Table256)) << "the cheapest of all";
    EXPECT_FALSE(has(Texturing::Exact, ReciprocalMethod::Table256)) << "bounded texels are closer and cheaper";
}

TEST(Frontier, ComparesNoPicturesWhoseErrorsDifferInKind) {
    // Floors of one colour cost less, and have no texels that could be out of place.
    const auto measure = [](const Accuracy& accuracy) {
        Trial trial = made_up(accuracy);
        if (!accuracy.textures_floors) trial.costs = {trial.costs[0] / 16, trial.costs[1] / 16};
        return trial;
    };
    const std::vector<Accuracy> front = search_frontier(measure, 1000, 1.02);
    for (const Preset preset : {Preset::Year1991, Preset::Year1994, Preset::Year1996, Preset::Exact})
        EXPECT_EQ(std::count(front.begin(), front.end(), accuracy_of(preset)), 1) << name_of(preset);
}

TEST(Frontier, MeasuresNoCombinationTwiceAndNotMoreThanItMay) {
    std::vector<Accuracy> measured;
    const auto measure = [&](const Accuracy& accuracy) {
        EXPECT_EQ(std::count(measured.begin(), measured.end(), accuracy), 0);
        measured.push_back(accuracy);
        return made_up(accuracy);
    };
    search_frontier(measure, 12, 1.02);
    EXPECT_EQ(measured.size(), 12u);
}

TEST(Frontier, NamesTheDialsThatDifferFromTheNearestPreset) {
    Accuracy accuracy = accuracy_of(Preset::Year1994);
    accuracy.pixel_bound_256 = 256;
    EXPECT_EQ(name_of_combination(accuracy), "1994 pixel-bound=1");
    EXPECT_EQ(name_of_combination(accuracy_of(Preset::Year1991)), "1991");
}

}  // namespace
}  // namespace oblong::test

#include "engine/files/json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "engine/files/files.h"
#include "tests/support/refusal.h"

// nlohmann's reader is the witness: the same texts are JSON, and their values are the same.
namespace oblong {
namespace {

using Json = nlohmann::ordered_json;

void expect_equal(const JsonValue& found, const Json& expected) {
    if (expected.is_string()) {
        EXPECT_EQ(found.text(), expected.get<std::string>());
    } else if (expected.is_structured()) {
        const JsonValue::Members& parts = expected.is_array() ? found.elements() : found.members();
        ASSERT_EQ(parts.size(), expected.size());
        std::size_t i = 0;
        for (const auto& [name, value] : expected.items()) {
            EXPECT_EQ(parts[i].first, name);
            expect_equal(parts[i++].second, value);
        }
    } else {
        const std::string refusal = test::refusal<FileError>([&] { found.text(); });
        EXPECT_TRUE(refusal.find("is " + std::string(expected.type_name())) != std::string::npos) << refusal;
    }
}

/// Returns whether the text is JSON.
bool check(const std::string& text) {
    SCOPED_TRACE(text);
    const bool is_json = Json::accept(text);
    const std::string refusal = test::refusal<FileError>([&] {
        const JsonValue found = parse_json("x.json", text);
        EXPECT_TRUE(is_json);
        if (is_json) expect_equal(found, Json::parse(text));
    });
    const bool names_twice = refusal.find("is there twice") != std::string::npos;
    EXPECT_EQ(refusal.empty(), is_json && !names_twice) << refusal;
    return is_json;
}

constexpr const char* kSample =
    "\xef\xbb\xbf{\"a\": [\"x\", -0.5e+2, 10, true, {}], \"\": [ ],\t\"b\\n\\u00e9\\ud83d\\uDE00\" :\r\n {\"\\/\": "
    "\"\xc3\xa9 \xe2"
    "\x82\xac \xf0\x9f\x98\x80\", \"c\": false, \"d\": null}, \"e\": 0}";

TEST(Json, ValuesAreThoseOfAnotherReader) {
    EXPECT_TRUE(check(kSample));
    for (const char* text :
         {"\"\"", " 1 ", "-1.5E-3", "\"\\\"\\\\\\/\\b\\f\\n\\r\\t\\u0000\\u07ff\\u0800\\uffff\"", "[[[]]]"})
        EXPECT_TRUE(check(text));
    for (const char* text : {"",
                             "{",
                             "[1,]",
                             "{\"a\":1,}",
                             "01",
                             "1.",
                             ".5",
                             "-",
                             "1e",
                             "+1",
                             "nul",
                             "truex",
                             "1 2",
                             "\"",
                             "\"\n\"",
                             "\"\\x\"",
                             "\"\\u12g4\"",
                             "\"\\ud800\"",
                             "\"\\ud800\\u0041\"",
                             "\"\\udc00\"",
                             "\"\\ud800\\ud800\"",
                             "\"\xe0\x9f\xbf\"",
                             "\"\xf0\x8f\xbf\xbf\"",
                             "{1: 2}",
                             "{\"a\" 1}",
                             "'a'",
                             "\"\xc0\x80\"",
                             "\"\xe0\x80\x80\"",
                             "\"\xed\xa0\x80\"",
                             "\"\xf4\x90\x80\x80\"",
                             "\"\xff\"",
                             "\"\x80\"",
                             "\"\xc3\"",
                             "[1}"})
        EXPECT_FALSE(check(text));
}

TEST(Json, DamagedTextsAreRefusedAsByAnotherReader) {
    std::mt19937 random(1);
    const std::string letters = "{}[]\",:\\u0e-.tfn \xc3\xa9\xed\xf0\x9f\x01";
    int accepted = 0;
    constexpr int kTexts = 5000;
    for (int i = 0; i < kTexts; ++i) {
        std::string text = kSample;
        for (auto changes = 1 + random() % 3; changes > 0; --changes) {
            const std::size_t at = 3 + random() % (text.size() - 3);
            if (random() % 2)
                text[at] = letters[random() % letters.size()];
            else
                text.erase(at, 1);
        }
        accepted += check(text);
    }
    EXPECT_GT(accepted, kTexts / 20);
    EXPECT_LT(accepted, kTexts / 2);
}

TEST(Json, DeepNestingIsRefused) {
    const std::string all(100'000, '[');
    EXPECT_NE(test::refusal<FileError>([&] { parse_json("x.json", all); }).find("no JSON"), std::string::npos);
}

}  // namespace
}  // namespace oblong

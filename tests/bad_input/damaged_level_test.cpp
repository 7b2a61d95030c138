#include <ostream>

#include "tests/bad_input/run_program.h"
#include "tests/support/bsp_writer.h"
#include "tests/support/folders.h"

// Whole levels with a part gone or moved, through the program. What the reader takes, the renderer must draw:
// tests/level tries far more damage on the reader alone.
namespace oblong::test {
namespace {

const std::string kProgram = "oblong-render";

struct LevelCase {
    std::string name, path;
};

void PrintTo(const LevelCase& level, std::ostream* out) {
    *out << level.name;
}

std::vector<LevelCase> level_cases() {
    std::vector<LevelCase> cases{{"demo", test::build_folder() + "/assets/demo.bsp"}};
    for (const std::string name : kRealLevels) cases.push_back({name, name + ".bsp"});
    return cases;
}

class DamagedLevel : public testing::TestWithParam<LevelCase> {
  protected:
    void SetUp() override {
        const std::string& path = GetParam().path;
        if (path.starts_with("/")) {
            file_ = read_file_bytes(path);
        } else {
            OBLONG_NEEDS_SHARED_LEVELS();
            file_ = read_shared_file(path);
        }
        ASSERT_GT(file_.size(), kBspHeaderSize);
        cameras_ = folder_.write("cameras.csv", std::string("x,y,z,yaw,pitch\n0,0,64,30,0\n500,-300,100,210,20\n"));
    }
    Outcome render(const Bytes& level) {
        return run_program({kProgram, folder_.write("bad.bsp", level), "--cameras", cameras_});
    }
    /// Read as a level: then it is drawn. Or refused: then with the file's and the lump's name.
    void expect_drawn_or_refused(const Bytes& level, bool runs_refused, const std::string& damage) {
        const std::string where = fault_of(level);
        if (!where.empty() && !runs_refused) return;
        const Outcome outcome = render(level);
        if (where.empty())
            EXPECT_EQ(outcome.exit_code, 0) << damage << ": " << outcome.error;
        else
            EXPECT_TRUE(names_fault(outcome, kProgram, folder_.path("bad.bsp"), where)) << damage;
    }
    TemporaryFolder folder_;
    Bytes file_;
    std::string cameras_;
};

TEST_P(DamagedLevel, CutAtALumpsBorderItIsRefused) {
    for (std::size_t lump = 0; lump < kLumpCount; ++lump) {
        const std::size_t start = number_at(file_, 4 + lump * 8, 4);
        const std::size_t end = start + number_at(file_, 8 + lump * 8, 4);
        for (const std::size_t cut : {start, end}) {
            if (cut >= file_.size()) continue;
            const Bytes rest(file_.begin(), file_.begin() + static_cast<std::ptrdiff_t>(cut));
            EXPECT_TRUE(names_fault(render(rest), kProgram, folder_.path("bad.bsp"), "lump '")) << "cut at " << cut;
        }
    }
}

TEST_P(DamagedLevel, LumpMovedOrResizedIsDrawnOrRefused) {
    for (std::size_t field = 4; field < kBspHeaderSize; field += 4) {
        const std::int64_t value = number_at(file_, field, 4);
        for (const std::int64_t changed : {std::int64_t{0}, value - 4, value + 1, value + 4, value * 2, value / 2,
                                           std::int64_t{-1}, std::int64_t{0x7fffffff}}) {
            Bytes bad = file_;
            put_number(bad, field, 4, changed);
            const bool runs_refused = changed == value + 4;
            expect_drawn_or_refused(bad, runs_refused,
                                    "byte " + std::to_string(field) + " set to " + std::to_string(changed));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Levels, DamagedLevel, testing::ValuesIn(level_cases()),
                         [](const auto& level) { return level.param.name; });

}  // namespace
}  // namespace oblong::test

#include "engine/models/obj.h"

#include <gtest/gtest.h>

#include "engine/io/files.h"
#include "tests/support/folders.h"
#include "tests/support/palettes.h"
#include "tests/support/point.h"
#include "tests/support/refusal.h"

namespace oblong::test::obj_test {
namespace {

using Texels = std::vector<std::uint8_t>;

class ObjFiles : public ::testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder_.path(name); }
    ObjModel read(const std::string& text, const ObjOptions& options = {.is_z_up = true}) const {
        write_file(path("model.obj"), text);
        return read_obj(path("model.obj"), grey_palette(), options);
    }
    std::string error_of(const std::string& text, const ObjOptions& options = {.is_z_up = true}) const {
        const std::string message = refusal<FileError>([&] { read(text, options); });
        if (message.empty()) return message;
        EXPECT_NE(message.find("expected"), std::string::npos) << message;
        return message.substr(message.find("model.obj: ") + 11);
    }

    void write_picture(const std::string& name, std::int32_t width, std::int32_t height, const Texels& texels) const {
        write_file(path(name), encode_indexed_png(texels, width, height, grey_palette()));
    }
    /// Of one colour.
    void write_picture(const std::string& name, std::int32_t width, std::int32_t height,
                       std::uint8_t colour = 1) const {
        write_picture(name, width, height, Texels(as_size(width * height), colour));
    }

  private:
    const TemporaryFolder folder_;
};

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// Eight corners of a cube of side 2, six faces of four, counter-clockwise seen from outside.
const std::string kCube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// Of a triangle, outward by the project's winding: clockwise seen from the front.
Point normal_of(const Mesh& mesh, std::size_t triangle) {
    const auto corner = [&](std::size_t i) {
        return to_point(mesh.frames[0].vertices[mesh.triangles[triangle].vertices[i]].position);
    };
    return cross(corner(2) - corner(0), corner(1) - corner(0));
}

double area_of(const Mesh& mesh) {
    double area = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) area += length(normal_of(mesh, i)) / 2;
    return area;
}

TEST_F(ObjFiles, AFileThatCountsCounterClockwiseBecomesClockwise) {
    const Mesh mesh = read(kSquare + "f 1 2 3 4\n").mesh;
    ASSERT_EQ(mesh.triangles.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_GT(normal_of(mesh, i)[2], 0);
    EXPECT_EQ(area_of(mesh), 1);
    EXPECT_EQ(mesh.frames.size(), 1u);
    EXPECT_EQ(mesh.frame_sequences.size(), 1u);
}

TEST_F(ObjFiles, AxesOfMostProgramsAreTurnedIntoTheWorlds) {
    const Mesh mesh = read("v 1 2 3\nv 2 2 3\nv 1 3 3\nvn 0 0 1\nf 1//1 2//1 3//1\n", {}).mesh;
    const MeshVertex& first = mesh.frames[0].vertices[0];
    EXPECT_EQ(first.position, (Vec3<World>{World::from_int(3), World::from_int(1), World::from_int(2)}));
    EXPECT_EQ(first.normal, (Vec3<Unit>{Unit::from_int(1), {}, {}}));
    EXPECT_GT(normal_of(mesh, 0)[0], 0);
}

TEST_F(ObjFiles, ScaleIsAppliedBeforeRounding) {
    const Mesh mesh = read("v 0.00012345 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", {.scale = 1000, .is_z_up = true}).mesh;
    EXPECT_NEAR(number_of(mesh.frames[0].vertices[0].position.x), 0.12345, 1 / 8192.0);
    EXPECT_EQ(number_of(mesh.frames[0].maxs.x), 1000);
}

TEST_F(ObjFiles, NegativeNumbersCountBackwards) {
    const Mesh mesh = read(kSquare + "f -4 -3 -2\nv 9 9 9\nf -5 -4 -2\n").mesh;
    EXPECT_EQ(mesh.frames[0].vertices.size(), 4u);
    EXPECT_EQ(area_of(mesh), 1);
}

TEST_F(ObjFiles, ConcavePolygonsKeepTheirArea) {
    // An arrow head; the line between its barbs is the shorter diagonal, and outside. Then a comb of three teeth.
    EXPECT_NEAR(area_of(read("v 0 0 0\nv 0.1 -1 0\nv 0 9 0\nv -0.1 -1 0\nf 1 2 3 4\n").mesh), 0.9, 1e-2);
    EXPECT_NEAR(
        area_of(read("v 0 0 0\nv 5 0 0\nv 5 3 0\nv 4 3 0\nv 4 1 0\nv 3 1 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\n"
                     "v 1 3 0\nv 0 3 0\nf 1 2 3 4 5 6 7 8 9 10 11 12\n")
                    .mesh),
        11, 1e-9);
}

TEST_F(ObjFiles, MissingNormalsAreSmoothUnlessGroupsSayElse) {
    const auto distinct = [&](const std::string& text) { return read(text).mesh.frames[0].vertices.size(); };
    const std::string corners = kCube.substr(0, kCube.find('f')), faces = kCube.substr(kCube.find('f'));
    EXPECT_EQ(distinct(kCube), 8u);
    EXPECT_EQ(distinct(corners + "s off\n" + faces), 24u);
    EXPECT_EQ(distinct(corners + "s 1\n" + faces), 8u);
    const Mesh smooth = read(kCube).mesh, flat = read(corners + "s 0\n" + faces).mesh;
    for (const MeshVertex& vertex : smooth.frames[0].vertices) {
        EXPECT_NEAR(number_of(vertex.normal.x), number_of(vertex.position.x) / std::sqrt(3), 0.25);
        EXPECT_GT(number_of(vertex.normal.x) * number_of(vertex.position.x), 0);
        EXPECT_GT(number_of(vertex.normal.z) * number_of(vertex.position.z), 0);
    }
    for (const MeshVertex& vertex : flat.frames[0].vertices)
        EXPECT_NEAR(std::abs(number_of(vertex.normal.x)) + std::abs(number_of(vertex.normal.y)) +
                        std::abs(number_of(vertex.normal.z)),
                    1, 1e-9);
}

TEST_F(ObjFiles, NormalsOfTheFileAreMadeOneLong) {
    const Mesh mesh = read(kSquare + "vn 0 3 4\nvn 0 0 0\nf 1//1 2//1 3//2\n").mesh;
    EXPECT_NEAR(number_of(mesh.frames[0].vertices[0].normal.y), 0.6, 1e-9);
    bool has_computed = false;
    for (const MeshVertex& vertex : mesh.frames[0].vertices) has_computed |= number_of(vertex.normal.z) == 1;
    EXPECT_TRUE(has_computed) << "a normal of no direction counts as missing";
}

TEST_F(ObjFiles, NormalsThatFacesNameInVainAreComputed) {
    const Mesh plain = read(kCube).mesh;
    const std::size_t faces = kCube.find('f');
    for (const std::string corner : {"//1", "//99", "//-1", "//-7"}) {
        std::string named = kCube.substr(0, faces);
        for (const char letter : kCube.substr(faces))
            named += std::isdigit(letter) != 0 ? letter + corner : std::string(1, letter);
        const ObjModel model = read(named);
        ASSERT_EQ(model.mesh.frames[0].vertices.size(), plain.frames[0].vertices.size()) << corner;
        for (std::size_t i = 0; i < 8; ++i)
            EXPECT_EQ(model.mesh.frames[0].vertices[i].normal, plain.frames[0].vertices[i].normal) << corner;
        ASSERT_EQ(model.warnings.size(), 1u) << corner;
        EXPECT_TRUE(model.warnings[0].ends_with(": a normal that the file does not have: those are computed"));
    }
}

TEST_F(ObjFiles, NamesMayHaveBlanksAndSigns) {
    write_picture("my wood.png", 2, 1, {7, 8});
    const std::string material =
        "newmtl Dark Oak #2\nKd 0.5 0.5 0.5\nnewmtl Dark\nKd 1 1 1\n"
        "newmtl\t a  b \nmap_Kd  my wood.png # a note\n";
    const std::string faces = kSquare + "usemtl Dark Oak #2\nf 1 2 3\nusemtl Dark\nf 1 2 3\nusemtl a  b\nf 1 2 3\n";
    write_file(path("the materials.mtl"), material);
    write_file(path("one.mtl"), material.substr(0, material.find("newmtl\t")));
    write_file(path("two.mtl"), material.substr(material.find("newmtl\t")));
    for (const std::string library :
         {"the materials.mtl", " the materials.mtl ", "one.mtl two.mtl", "none.mtl the\\ materials.mtl"}) {
        const ObjModel model = read("mtllib " + library + "\n" + faces);
        ASSERT_EQ(model.mesh.skins.size(), 3u) << library;
        EXPECT_EQ(model.mesh.skins[0].texels, Texels{128});
        EXPECT_EQ(model.mesh.skins[1].texels, Texels{223});
        EXPECT_EQ(model.mesh.skins[2].texels, (Texels{7, 8}));
        EXPECT_EQ(model.warnings.size(), library[0] == 'n' ? 1u : 0u) << library;
    }
    EXPECT_EQ(read("usemtl no such\n" + kSquare + "f 1 2 3\n").warnings.at(0),
              "material [ 'no such' ] not found in .mtl");
}

TEST_F(ObjFiles, OptionsOfAPictureAreObeyedOrNamed) {
    write_picture("a 4x2.png", 4, 2);
    struct Case {
        std::string options;
        double u, v;  ///< of the place (0.25, 0.5), in texels from the skin's top left corner
        std::size_t repetitions;
        std::string warning;
    };
    for (const auto& [options, u, v, repetitions, warning] : {
             Case{"", 1, 1, 1, ""},
             Case{"-s 2 1 1 ", 2, 1, 2, ""},
             Case{"-s 2 ", 2, 1, 2, ""},
             Case{"-o 0.25 0 0 ", 2, 1, 2, ""},
             Case{"-o 0.25 -s 2 2 -blendu on -clamp off -mm 0 1 ", 3, 0, 3, ""},
             Case{"-clamp on ", 1, 1, 1, "-clamp on"},
             Case{"-blendv off -s 2 1 ", 2, 1, 2, "-blendv off"},
             Case{"-mm 0.5 2 ", 1, 1, 1, "-mm 0.5 2"},
             Case{"-bm 3 ", 1, 1, 1, "-bm 3"},
             Case{"-imfchan r ", 1, 1, 1, "-imfchan r"},
             Case{"-texres 64 ", 1, 1, 1, "-texres 64"},
         }) {
        write_file(path("m.mtl"), "newmtl m\nmap_Kd " + options + "a 4x2.png\n");
        const ObjModel model =
            read("mtllib m.mtl\nusemtl m\n" + kSquare + "vt 0.25 0.5\nvt 1 0.5\nvt 0 0.5\nf 1/1 2/2 3/3\n");
        EXPECT_EQ(model.mesh.skins[0].width, 4 * static_cast<std::int32_t>(repetitions)) << options;
        EXPECT_EQ(number_of(model.mesh.texels[0].u), u) << options;
        EXPECT_EQ(number_of(model.mesh.texels[0].v), v) << options;
        ASSERT_EQ(model.warnings.size(), warning.empty() ? 0u : 1u) << options;
        for (const std::string& said : model.warnings)
            EXPECT_EQ(said, path("m.mtl") + ": line 2: map_Kd's " + warning + " is ignored");
    }
}

TEST_F(ObjFiles, MaterialsBecomeSkins) {
    Texels texels = {10, 20, 30, 40, 50, 60, 70, 80};
    write_picture("wood.png", 4, 2, texels);
    write_file(
        path("m.mtl"),
        std::string("\xef\xbb\xbfnewmtl wood\r\nmap_Kd wood.png\r\nnewmtl red\r\nKd 0.5 0.5 0.5\r\nnewmtl gone\r\n"
                    "Kd 1 1 1\r\nmap_Kd none.png\r\nnewmtl unused\r\nmap_Kd unused.png\r\n"));
    const ObjModel model =
        read("\xef\xbb\xbfmtllib m.mtl\r\n" + kSquare +
             "vt 0.25 0\r\nvt 1 0\r\nvt 1 1\r\nusemtl wood\r\nf 1/1 2/2 3/3\r\nusemtl red\r\nf 1/1 2/2 3/3\r\n"
             "usemtl gone\r\nf 1 2 3\r\n");
    const Mesh& mesh = model.mesh;
    ASSERT_EQ(mesh.skins.size(), 3u);
    EXPECT_EQ(mesh.skins[0].texels, texels);
    EXPECT_EQ(mesh.skins[1].texels, Texels{128});
    EXPECT_EQ(mesh.skins[2].texels, Texels{223});  // the lightest that does not glow
    EXPECT_EQ(mesh.triangles[1].skin, 1u);
    const MeshTexel& first = mesh.texels[mesh.triangles[0].vertices[0]];
    EXPECT_EQ(number_of(first.u), 1);
    EXPECT_EQ(number_of(first.v), 2);  // v goes up in the file, down in a skin
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_NE(model.warnings[0].find("none.png"), std::string::npos) << model.warnings[0];
}

TEST_F(ObjFiles, AColourThatIsNoThreeNumbersIsNamedWithItsLine) {
    for (const std::string colour : {"nan 0 0", "0 inf 0", "0 0 1e999", "0.5 red 0", "0.5 0.5"}) {
        write_file(path("m.mtl"), "# red\n\tnewmtl red\r\n\tKd 1 0 0 # here\r\nnewmtl odd\nKd " + colour + "\n");
        const std::string said =
            refusal<FileError>([&] { read("mtllib m.mtl\n" + kSquare + "usemtl red\nf 1 2 3\n"); });
        EXPECT_TRUE(said.starts_with(path("m.mtl") + ": line 5: Kd '")) << colour << said;
        EXPECT_TRUE(said.ends_with("', expected three numbers")) << said;
    }
}

TEST_F(ObjFiles, OtherMaterialsStandForGlass) {
    write_picture("clear.png", 2, 2, {1, 2, 3, 4});
    write_picture("red.png", 4, 4, 9);
    write_file(path("m.mtl"), std::string("newmtl ring\nKd 0 0 0\nnewmtl glass\nmap_Kd clear.png\nnewmtl red\n"
                                          "map_Kd red.png\n"));
    const std::string text = "mtllib m.mtl\n" + kSquare +
                             "vt 0 0\nvt 1 1\nusemtl ring\nf 1 2 3\nusemtl glass\n"
                             "f 1/1 2/2 4/1\n";
    const Mesh mesh = read(text, {.is_z_up = true, .glasses = {"none", "red"}}).mesh;
    ASSERT_EQ(mesh.skin_sequences.size(), 3u);
    EXPECT_EQ(mesh.skin_sequences[1].first, 0u) << "there is no such material";
    ASSERT_EQ(mesh.skin_sequences[2].first, 2u);
    ASSERT_EQ(mesh.skins.size(), 4u);
    EXPECT_EQ(mesh.skins[1].texels, (Texels{1, 2, 3, 4}));
    EXPECT_EQ(mesh.skins[2].texels, mesh.skins[0].texels);
    EXPECT_EQ(mesh.skins[3].texels, Texels(4, 9)) << "as large as glass itself";
    const std::string without = text.substr(0, text.find("usemtl glass")) + "f 1/1 2/2 4/1\n";
    EXPECT_EQ(read(without, {.is_z_up = true, .glasses = {"red"}}).mesh.skins.size(), 1u);
}

TEST_F(ObjFiles, APictureIsRepeatedAsOftenAsFacesAsk) {
    write_picture("tile.png", 2, 2, {1, 2, 3, 4});
    write_file(path("m.mtl"), std::string("newmtl tile\nmap_Kd tile.png\n"));
    const std::string head = "mtllib m.mtl\nusemtl tile\n" + kSquare;
    const ObjModel model = read(head + "vt -1 0\nvt 2 0\nvt 2 1\nf 1/1 2/2 3/3\n");
    const Mesh& mesh = model.mesh;
    EXPECT_EQ(mesh.skins[0].texels, (Texels{1, 2, 1, 2, 1, 2, 3, 4, 3, 4, 3, 4}));
    EXPECT_EQ(number_of(mesh.texels[mesh.triangles[0].vertices[0]].u), 0);
    EXPECT_EQ(number_of(mesh.texels[mesh.triangles[0].vertices[1]].u), 6);
    EXPECT_TRUE(model.warnings.empty());

    const ObjModel cut = read(head + "vt -1000 3.5\nvt 1000 3.75\nvt 2 3.999\nf 1/1 2/2 3/3\n");
    EXPECT_EQ(cut.mesh.skins[0].width, 4000);
    EXPECT_EQ(cut.mesh.skins[0].height, 2);
    EXPECT_TRUE(cut.warnings.empty());
    EXPECT_EQ(read(head + "vt -1023 0\nvt 1023.5 0\nvt 2 1\nf 1/1 2/2 3/3\n").mesh.skins[0].width, 4094);
    write_picture("tile.png", 6, 2);
    const ObjModel wide = read(head + "vt -1023 0\nvt 1023.5 0\nvt 2 1\nf 1/1 2/2 3/3\n");
    EXPECT_EQ(wide.mesh.skins[0].width, 4092);
    EXPECT_EQ(wide.warnings.size(), 1u);
}

TEST_F(ObjFiles, WhatIsMissingIsAWarning) {
    const ObjModel model = read("mtllib lost.mtl\nusemtl gold\n" + kSquare + "f 1 2 3\n");
    ASSERT_FALSE(model.warnings.empty());
    EXPECT_NE(model.warnings[0].find("lost.mtl"), std::string::npos) << model.warnings[0];
    EXPECT_EQ(model.mesh.skins.size(), 1u);
    EXPECT_EQ(model.mesh.texels[0].u, Texel::from_raw(1 << 15));
}

TEST_F(ObjFiles, WhatLiesOutsideOfTheFolderIsNotRead) {
    const TemporaryFolder other;
    const std::string mtl = other.write("gold.mtl", "newmtl gold\nKd 1 1 1\n"),
                      picture = other.write("tile.png", encode_indexed_png(Texels{1, 2}, 2, 1, grey_palette()));
    const auto from_below = [&](const std::string& file) { return "../../" + file.substr(file.rfind("oblong-")); };
    std::filesystem::create_symlink(mtl, path("link.mtl"));
    std::filesystem::create_symlink(picture, path("link.png"));
    for (const std::string& name : {mtl, from_below(mtl), std::string("link.mtl"), std::string("..\\gold.mtl")}) {
        const ObjModel model = read("mtllib " + name + "\nusemtl gold\n" + kSquare + "f 1 2 3\n");
        ASSERT_FALSE(model.warnings.empty()) << name;
        EXPECT_NE(model.warnings[0].find("is outside of the model's folder, expected a file in it"), std::string::npos)
            << model.warnings[0];
    }
    for (const std::string& name : {picture, from_below(picture), std::string("link.png")}) {
        write_file(path("own.mtl"), "newmtl gold\nmap_Kd " + name + "\n");
        const ObjModel model = read("mtllib own.mtl\nusemtl gold\n" + kSquare + "f 1 2 3\n");
        EXPECT_EQ(model.mesh.skins[0].texels.size(), 1u) << name;
        ASSERT_EQ(model.warnings.size(), 1u) << name;
        EXPECT_NE(model.warnings[0].find("is outside of the model's folder"), std::string::npos) << model.warnings[0];
    }
}

TEST_F(ObjFiles, FilesWithOtherLineEndsAndNotesAreRead) {
    const Mesh mesh =
        read("# a note\r\n\r\no thing\r\ng part one\r\nv +1.5e0 0 0\r\n v\t2. .5 -0\r\nv 0 1 0 1\r\nl 1 2\r\nf 1 2 3")
            .mesh;
    EXPECT_EQ(mesh.triangles.size(), 1u);
    EXPECT_EQ(number_of(mesh.frames[0].maxs.x), 2);
    const std::string noted =
        "# from C:\\models\\\nv 0 0 0 # one\nv 1 \\\n 0 0#two\nv 0 1 0\ng a\\\nf 1 2 \\\n 3# all\n";
    for (const char end : {'\n', '\r'}) {
        std::string text = noted;
        std::replace(text.begin(), text.end(), '\n', end);
        EXPECT_EQ(read(text).mesh.triangles.size(), 1u) << text;
    }
}

TEST_F(ObjFiles, BrokenOnesAreRefusedWithTheLine) {
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"", "file: "},
        {kSquare, "file: has no faces"},
        {kSquare + "f 1 2\n", "line 5: a face of 2 corners"},
        {kSquare + "f 1 2 5\n", "line 5: vertex 5, expected 1 to 4"},
        {"f 1 2 5\n", "line 1: vertex 5, expected none: the file has no lines of them"},
        {"v 1 2 3\nf 1 1 5\n", "line 2: vertex 5, expected 1"},
        {"f -1 -2 -3\n", "line 1: vertex -1, expected 1 and up"},
        {kSquare + "f 1 2 -5\n", "line 5: vertex -5, expected 1 and up, or -1 to -4"},
        {kSquare + "f 0 1 2\n", "line 5: vertex 0"},
        {kSquare + "f 1/1 2/1 3/1\n", "line 5: texture coordinate 1"},
        {kSquare + "f 1//0 2//1 3//1\n", "line 5: normal 0, expected 1 and up"},
        {kSquare + "f 1 2 x\n", "line 5: corner 'x'"},
        {kSquare + "f 1 2 \\\n 3 # one\nf 1 \\\n2 x\n", "line 7: corner 'x'"},
        {kSquare + "f 1 2 3/\n", "line 5: corner '3/'"},
        {kSquare + "f 1 2 3/1/1/1\n", "line 5: corner '3/1/1/1'"},
        {kSquare + "f 1 2 99999999999\n", "line 5: corner '99999999999'"},
        {"v 0 0\n", "line 1: vertex of 2 numbers"},
        {"\r\nv 0 nan 0\r\n", "line 2: vertex 'nan'"},
        {"v 0 inf 0\n", "line 1: vertex 'inf'"},
        {"v 0 1e999 0\n", "line 1: vertex '1e999'"},
        {"v 0 0 -32768\n", "line 1: vertex -32768"},
        {"v 0 0 1,5\n", "line 1: vertex '1,5'"},
        {"vt 2000\n", "line 1: texture coordinate 2000"},
        {"vn 1 0\n", "line 1: normal of 2 numbers"},
    };
    for (const auto& [text, message] : cases) {
        const std::string found = error_of(text);
        EXPECT_TRUE(found.starts_with(message)) << text << " -> " << found;
        EXPECT_EQ(found.size() == message.size(), message.find("expected") != std::string::npos) << found;
    }
    std::string many = kSquare + "f";
    for (int i = 0; i < 256; ++i) many += " 1";
    EXPECT_TRUE(error_of(many).starts_with("line 5: a face of 256 corners"));
}

TEST_F(ObjFiles, ACoordinateIsTooLargeOnceItIsScaled) {
    EXPECT_EQ(error_of(kSquare + "f 1 2 3\n", {.scale = 32767}), "");
    EXPECT_TRUE(error_of(kSquare + "f 1 2 3\n", {.scale = 32768}).starts_with("line 2: "));
}

TEST_F(ObjFiles, AMillionTrianglesAreRead) {
    constexpr int kSide = 708;  // squares
    std::string text;
    for (int y = 0; y <= kSide; ++y)
        for (int x = 0; x <= kSide; ++x)
            text += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string((x * y) % 7) + "\n";
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const int a = y * (kSide + 1) + x + 1, b = a + kSide + 1;
            text += "f " + std::to_string(a) + " " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " +
                    std::to_string(b) + "\n";
        }
    const Mesh mesh = read(text).mesh;
    EXPECT_EQ(mesh.triangles.size(), std::size_t{2} * kSide * kSide);
    EXPECT_EQ(mesh.texels.size(), std::size_t{kSide + 1} * (kSide + 1));
}

/// Each would take minutes or gigabytes if all were looked through for each, or if each were kept.
TEST_F(ObjFiles, ManyNamesPolygonsAndSkinsCostNoMoreThanTheirSize) {
    std::string names, polygons;
    for (int i = 0; i < 150'000; ++i) names += "usemtl m" + std::to_string(i) + "\nf 1 2 3\n";
    EXPECT_EQ(read(kSquare + names).warnings.size(), 150'000u);
    for (int i = 0; i < 255; ++i) polygons += "v " + std::to_string(i) + " 0 0\n";
    for (int i = 0; i < 1'000; ++i) {
        polygons += "f";
        for (int corner = 1; corner <= 255; ++corner) polygons += " " + std::to_string(corner);
        polygons += "\n";
    }
    EXPECT_EQ(read(polygons).mesh.triangles.size(), 253'000u);

    std::string materials, faces = "mtllib many.mtl\nmtllib ./many.mtl\nvt 0 0\nvt 256 256\n" + kSquare;
    for (int i = 0; i < 64; ++i) {
        materials += "newmtl m" + std::to_string(i) + "\nmap_Kd tile.png\n";
        faces += "usemtl m" + std::to_string(i) + "\nf 1/1 2/2 3/2\n";
    }
    write_file(path("many.mtl"), materials);
    write_picture("tile.png", 16, 16);
    const ObjModel repeated = read(faces);
    std::size_t texels = 0;
    for (const Skin& skin : repeated.mesh.skins) texels += skin.texels.size();
    EXPECT_LE(texels, std::size_t{1} << 26);
    EXPECT_EQ(repeated.warnings.size(), 61u);

    // One picture by five names, the last of which finds no room; nor does a small one then, which is not read.
    write_picture("large.png", 4096, 4095);
    std::string five = "newmtl m5\nmap_Kd tile.png\n", uses = kSquare + "mtllib five.mtl\n";
    for (std::size_t i = 0; i < 5; ++i)
        five.insert(0,
                    "newmtl m" + std::to_string(i) + "\nmap_Kd " + std::string(i, '/').insert(0, "./") + "large.png\n");
    for (int i = 0; i < 6; ++i) uses += "usemtl m" + std::to_string(i) + "\nf 1 2 3\n";
    write_file(path("five.mtl"), five);
    const ObjModel full = read(uses);
    EXPECT_EQ(full.warnings.size(), 2u);
    for (const std::string& warning : full.warnings)
        EXPECT_NE(warning.find("pictures have more than 67108864 texels"), std::string::npos) << warning;
    for (int i = 64; i <= 4096; ++i) materials += "newmtl m" + std::to_string(i) + "\n";
    write_file(path("many.mtl"), materials);
    EXPECT_TRUE(refusal<FileError>([&] { read(faces); }).ends_with("more than 4096 materials, expected fewer"));
}

/// All faces at one corner, each with a texture place of its own, none of them smooth.
TEST_F(ObjFiles, AHundredThousandFacesAtOneCornerAreRead) {
    std::string text = kSquare + "s off\n";
    for (int i = 1; i <= 100'000; ++i) text += "vt 0." + std::to_string(i) + "\nf 1/-1 2/-1 3/-1\n";
    EXPECT_EQ(read(text).mesh.texels.size(), 300'000u);
}

}  // namespace
}  // namespace oblong::test::obj_test

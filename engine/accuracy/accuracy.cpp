#include "engine/accuracy/accuracy.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "engine/base/table.h"

namespace oblong {
namespace {

/// Whole pixels, a short table of sines, and two divisions a span, which on a 486 cost less than a table of reciprocals
/// does; floors and ceilings without textures, as in Catacomb 3-D and Wolfenstein 3D (F. Sanglard, Game Engine Black
/// Book: Wolfenstein 3D).
Accuracy of_1991() {
    Accuracy accuracy;
    accuracy.texturing = Texturing::Affine;
    accuracy.subpixel_bits = 0;
    accuracy.edges = EdgeStepping::Accumulated;
    accuracy.sine = SineMethod::Lerp256;
    accuracy.textures_floors = false;
    accuracy.colour_levels = 0;
    return accuracy;
}

/// No texel a pixel from its place: on an i486 fewer instructions than divisions every 16 pixels take.
Accuracy within_a_pixel() {
    Accuracy accuracy;
    accuracy.pixel_bound_256 = 256;
    accuracy.colour_levels = 16;
    return accuracy;
}

Accuracy textured_by(Texturing texturing, std::int32_t colour_levels) {
    Accuracy accuracy;
    accuracy.texturing = texturing;
    accuracy.colour_levels = colour_levels;
    return accuracy;
}

constexpr std::array<std::string_view, kPresets.size()> kNames{"1991", "1994", "1996", "pixel", "bounded", "exact"};

template <auto Field>
constexpr std::int32_t get_field(const Accuracy& accuracy) {
    return static_cast<std::int32_t>(accuracy.*Field);
}

template <auto Field>
constexpr void set_field(Accuracy& accuracy, std::int32_t value) {
    auto& field = accuracy.*Field;
    field = static_cast<std::remove_reference_t<decltype(field)>>(value);
}

template <class Value>
constexpr DialSetting named(std::string_view name, Value value) {
    return {name, static_cast<std::int32_t>(value)};
}

constexpr std::array kTexturings{
    named("affine", Texturing::Affine),   named("every32", Texturing::Every32),
    named("every16", Texturing::Every16), named("every8", Texturing::Every8),
    named("bounded", Texturing::Bounded), named("bounded-texels", Texturing::BoundedTexels),
    named("exact", Texturing::Exact)};
constexpr std::array kBounds{named("4", 1024),   named("2", 512),    named("1", 256),    named("0.75", 192),
                             named("0.375", 96), named("0.125", 32), named("0.03125", 8)};
constexpr std::array kReciprocals{
    named("table256", ReciprocalMethod::Table256), named("table256-newton1", ReciprocalMethod::Table256Newton),
    named("table1024-newton1", ReciprocalMethod::Table1024Newton),
    named("table256-newton2", ReciprocalMethod::Table256TwoNewton), named("exact", ReciprocalMethod::Exact)};
constexpr std::array kInverseZBits{named("16", 16), named("20", 20), named("24", 24),
                                   named("28", 28), named("36", 36), named("44", 44)};
constexpr std::array kOverZBits{named("8", 8),   named("12", 12), named("16", 16),
                                named("20", 20), named("24", 24), named("30", 30)};
constexpr std::array kSines{
    named("nearest256", SineMethod::Nearest256), named("lerp256", SineMethod::Lerp256),
    named("cordic16", SineMethod::Cordic16),     named("quarter1024", SineMethod::Quarter1024Lerp),
    named("cordic30", SineMethod::Cordic30),     named("exact", SineMethod::NearestStep)};
constexpr std::array kMatrixBits{named("8", 8),   named("11", 11), named("14", 14),
                                 named("16", 16), named("22", 22), named("30", 30)};
constexpr std::array kViewBits{named("0", 0), named("4", 4), named("8", 8), named("12", 12), named("16", 16)};
constexpr std::array kSubpixelBits{named("0", 0), named("2", 2), named("4", 4), named("8", 8)};
constexpr std::array kEdges{named("accumulated", EdgeStepping::Accumulated), named("exact", EdgeStepping::Exact)};
constexpr std::array kTJunctions{named("open", false), named("mended", true)};
constexpr std::array kMips{named("none", MipSelection::None), named("face", MipSelection::Face),
                           named("span", MipSelection::Span)};
constexpr std::array kMipBiases{named("2", 2), named("1", 1), named("-1", -1), named("0", 0)};
constexpr std::array kLights{named("nearest", LightSampling::Nearest),
                             named("interpolated", LightSampling::Interpolated)};
constexpr std::array kShades{named("16", 16), named("32", 32), named("64", 64)};
constexpr std::array kFloors{named("flat", false), named("textured", true)};
constexpr std::array kColourLevels{named("off", 0), named("16", 16), named("32", 32), named("64", 64)};
constexpr std::array kDithers{named("off", false), named("on", true)};

template <auto Field>
constexpr Dial dial(std::string_view name, std::string_view caption, std::string_view about, std::string_view unit,
                    std::string_view read_in, bool changes_work, std::span<const DialSetting> settings,
                    std::int32_t least = 0, std::int32_t greatest = 0, int fraction_bits = 0) {
    return {name,     caption, about,    unit,          read_in,          changes_work,
            settings, least,   greatest, fraction_bits, get_field<Field>, set_field<Field>};
}

constexpr std::array kDials{
    dial<&Accuracy::sine>("sine", "sine",
                          "Sines and cosines of the camera's angles: from tables, by rotations, or rounded once.", "",
                          "engine/frame/frame.cpp", true, kSines),
    dial<&Accuracy::matrix_bits>("matrix-bits", "matrix bits",
                                 "Fraction bits of the camera's axes, the rotation of every vertex.", "fraction bits",
                                 "engine/frame/frame.cpp", false, kMatrixBits, 6, 30),
    dial<&Accuracy::view_bits>("view-bits", "view position bits", "Fraction bits of vertices in viewspace.",
                               "fraction bits", "engine/frame/frame.cpp", false, kViewBits, 0, 16),
    dial<&Accuracy::mends_t_junctions>(
        "t-junctions", "T-junctions",
        "Whether a face has corners where corners of others lie on its edges. Without them cracks open.", "",
        "engine/frame/claim_faces.cpp", true, kTJunctions),
    dial<&Accuracy::subpixel_bits>("subpixel-bits", "sub-pixel bits",
                                   "Fraction bits of screen vertices; 0: whole pixels.", "fraction bits",
                                   "engine/frame/frame.cpp", false, kSubpixelBits, 0, 8),
    dial<&Accuracy::edges>("edges", "edges",
                           "How an edge steps from row to row: by a 16.16 slope that is added up, or exactly.", "",
                           "engine/frame/claim_faces.cpp", true, kEdges),
    dial<&Accuracy::mip>(
        "mip", "mip level",
        "Where a mip level is chosen: nowhere, for a face by its nearest corner, for a span by its nearest pixel.", "",
        "engine/frame/surface_pass.cpp", true, kMips),
    dial<&Accuracy::mip_bias>("mip-bias", "mip bias", "Added to mip levels: above 0 blurs, below 0 flickers.", "levels",
                              "engine/frame/surface_pass.cpp", true, kMipBiases, -3, 3),
    dial<&Accuracy::textures_floors>(
        "floors", "floors", "Whether floors and ceilings have textures, or each face one colour of its texture.", "",
        "engine/frame/surface_pass.cpp", true, kFloors),
    dial<&Accuracy::light>("light", "light",
                           "The light of a texel: that of the nearest sample, or interpolated between four.", "",
                           "engine/scene/face_surface.cpp", true, kLights),
    dial<&Accuracy::shades>("shades", "shades", "Steps of light between twice a colour and black.", "shades",
                            "engine/scene/face_surface.cpp", true, kShades),
    dial<&Accuracy::dithers_light>("dither", "dithered light",
                                   "Mixes two shades in a pattern of 4x4 texels where the light lies between them.", "",
                                   "engine/scene/face_surface.cpp", true, kDithers),
    dial<&Accuracy::colour_levels>(
        "colours", "coloured light",
        "Steps of red, green and blue in coloured light, each shown as the palette's nearest colour; off: grey light.",
        "steps", "engine/scene/face_surface.cpp", true, kColourLevels),
    dial<&Accuracy::inverse_z_bits>("inverse-z-bits", "1/z bits", "Fraction bits of 1/z.", "fraction bits",
                                    "engine/frame/surface_pass.cpp", false, kInverseZBits, 12, 44),
    dial<&Accuracy::over_z_bits>("over-z-bits", "u/z, v/z bits", "Fraction bits of u/z and v/z.", "fraction bits",
                                 "engine/frame/surface_pass.cpp", false, kOverZBits, 4, 30),
    dial<&Accuracy::texturing>("perspective", "perspective",
                               "How often a span of pixels divides by z: at its ends, every so many pixels, as often "
                               "as a bound of the error asks, or as if at each pixel.",
                               "", "engine/raster/texture_blocks.cpp", true, kTexturings),
    dial<&Accuracy::pixel_bound_256>("pixel-bound", "pixel bound",
                                     "The bound of perspective=bounded: how far from its place a texel may show.",
                                     "pixels", "engine/raster/block_rule.cpp", true, kBounds, 1, 4096, 8),
    dial<&Accuracy::texel_bound_256>(
        "texel-bound", "texel bound",
        "The bound of perspective=bounded-texels: how far off a texture coordinate may be.", "texels",
        "engine/raster/block_rule.cpp", true, kBounds, 1, 4096, 8),
    dial<&Accuracy::reciprocal>("reciprocal", "reciprocal",
                                "z from 1/z: from a table, sharpened by Newton's steps, or by a division.", "",
                                "engine/raster/texture_blocks.cpp", true, kReciprocals),
};

/// value * 2^-fraction_bits in decimal, exact, without trailing zeros.
std::string decimal(std::int32_t value, int fraction_bits) {
    const std::int32_t whole = std::abs(value) >> fraction_bits;
    std::int32_t rest = std::abs(value) & ((1 << fraction_bits) - 1);
    std::string text = (value < 0 ? "-" : "") + std::to_string(whole);
    if (rest != 0) text += '.';
    for (; rest != 0; rest &= (1 << fraction_bits) - 1) {
        rest *= 10;
        text += static_cast<char>('0' + (rest >> fraction_bits));
    }
    return text;
}

}  // namespace

Accuracy accuracy_of(Preset preset) {
    switch (preset) {
        case Preset::Year1991:
            return of_1991();
        case Preset::Year1994:
            return textured_by(Texturing::Affine, 0);
        case Preset::Year1996:
            return textured_by(Texturing::Every16, 0);
        case Preset::Pixel:
            return within_a_pixel();
        case Preset::Bounded:
            break;
        case Preset::Exact:
            return textured_by(Texturing::Exact, 64);
    }
    return {};
}

std::string_view name_of(Preset preset) {
    return item(kNames, preset);
}

std::optional<Preset> preset_named(std::string_view name) {
    for (const Preset preset : kPresets)
        if (name_of(preset) == name) return preset;
    return std::nullopt;
}

std::span<const Dial> all_dials() {
    return kDials;
}

const Dial* dial_named(std::string_view name) {
    const auto found = std::find_if(kDials.begin(), kDials.end(), [=](const Dial& dial) { return dial.name == name; });
    return found == kDials.end() ? nullptr : &*found;
}

std::string value_text(const Dial& dial, std::int32_t value) {
    for (const DialSetting& setting : dial.settings)
        if (setting.value == value) return std::string(setting.name);
    return decimal(value, dial.fraction_bits);
}

void turn(const Dial& dial, int steps, Accuracy& accuracy) {
    const std::int32_t value = dial.get(accuracy);
    const auto nearest =
        std::min_element(dial.settings.begin(), dial.settings.end(), [=](const DialSetting& a, const DialSetting& b) {
            return std::abs(a.value - value) < std::abs(b.value - value);
        });
    const auto last = static_cast<std::ptrdiff_t>(dial.settings.size()) - 1;
    const std::ptrdiff_t next = std::clamp<std::ptrdiff_t>(nearest - dial.settings.begin() + steps, 0, last);
    dial.set(accuracy, dial.settings[as_size(next)].value);
}

}  // namespace oblong

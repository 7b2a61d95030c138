#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/surface/palette.h"
#include "engine/view/screen.h"

/// The first header of a program that uses Oblong as a library: a window of 8-bit pixels, pictures, sounds, models and
/// levels. Numbers are whole: places in world units, angles in degrees; where a name ends in `_256`, in 256ths of them.
/// Whatever can fail throws a std::runtime_error whose text names the file and the place in it. Nothing here is shared
/// between objects but what an argument's comment says, and an object may be destroyed in any order but for that.
namespace oblong {

class Platform;
struct Level;
struct Settings;

/// Of the library, as "0.1.0".
const char* version();

// Colours

/// A file of 768 bytes (Quake's palette.lmp), or a PNG with a palette.
Palette load_palette(const std::string& file);
/// Sets colours `first` to `last` of a palette to an even way from one colour to another.
void set_ramp(Palette& palette, int first, int last, Rgb8 from, Rgb8 to);
/// Moves colours `first` to `last` by so many places, round and round: what waterfalls and lamps were made of.
void cycle_colours(Palette& palette, int first, int last, std::int64_t places);

// Pictures

/// Pixels of one's own, rows top to bottom: a sprite, a texture, a canvas.
struct Picture {
    std::int32_t width_px = 0, height_px = 0;
    std::vector<std::uint8_t> pixels;  ///< one colour's number each

    /// A picture of colour 0.
    static Picture of_size(std::int32_t width_px, std::int32_t height_px);
    /// To draw into; valid while the picture lives and keeps its size.
    Framebuffer canvas() { return {pixels.data(), width_px, height_px, width_px}; }
};
/// The number of the colour that draw_picture() leaves out.
inline constexpr std::uint8_t kTransparent = 255;
/// A PNG, TGA, JPEG or BMP file in the palette's nearest colours; more than half transparent pixels are kTransparent.
Picture load_picture(const std::string& file, const Palette& palette);
/// Writes a canvas as a PNG with this palette.
void save_picture(const std::string& file, Framebuffer canvas, const Palette& palette);
/// A checksum of a canvas's pixels (CRC-32, as zlib's): equal pictures have equal ones on every machine.
std::uint32_t checksum(Framebuffer canvas);

// Drawing: what lies outside the canvas is left out; of a colour's number the lowest 8 bits count

/// Paints all of a canvas.
void clear(Framebuffer canvas, std::int32_t colour = 0);
/// Sets one pixel.
void set_pixel(Framebuffer canvas, std::int32_t x, std::int32_t y, std::int32_t colour);
/// The colour of a pixel; 0 outside the canvas.
std::uint8_t pixel_at(Framebuffer canvas, std::int32_t x, std::int32_t y);
/// A line between two pixels, both included.
void draw_line(Framebuffer canvas, std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1,
               std::int32_t colour);
/// The border of a rectangle, a pixel wide.
void draw_rectangle(Framebuffer canvas, std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height,
                    std::int32_t colour);
/// A whole rectangle.
void fill_rectangle(Framebuffer canvas, std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height,
                    std::int32_t colour);
/// A circle that is round on the mode's display: `radius_px` columns wide, fewer or more rows high.
void draw_circle(Framebuffer canvas, const ScreenMode& mode, std::int32_t x, std::int32_t y, std::int32_t radius_px,
                 std::int32_t colour);
/// The same, filled.
void fill_circle(Framebuffer canvas, const ScreenMode& mode, std::int32_t x, std::int32_t y, std::int32_t radius_px,
                 std::int32_t colour);
/// A triangle between three pixels' middles, filled; triangles with a common side share no pixel and leave no gap.
void fill_triangle(Framebuffer canvas, PixelPosition a, PixelPosition b, PixelPosition c, std::int32_t colour);
/// A picture, its left upper corner at (x, y), without its pixels of kTransparent.
void draw_picture(Framebuffer canvas, const Picture& picture, std::int32_t x, std::int32_t y);
/// A picture turned (counter-clockwise on square pixels) and scaled about its middle, which is put at (x, y).
void draw_turned(Framebuffer canvas, const Picture& picture, std::int32_t x, std::int32_t y, std::int32_t degrees_256,
                 std::int32_t scale_256 = 256);
/// A line of ASCII text from (x, y) right and down, 6 pixels a letter, 8 high, times `scale`.
void draw_label(Framebuffer canvas, std::int32_t x, std::int32_t y, std::string_view text, std::int32_t colour,
                std::int32_t scale = 1);

// Numbers

/// The sine of an angle, 65,536 for 1; that of an angle 90 degrees larger is the cosine.
std::int32_t sine_65536(std::int64_t degrees_256);
/// The next of a row of random numbers, the same on every machine: at least 0, less than `limit`.
std::int32_t random_below(std::int32_t limit, std::uint64_t& state);

// A window

/// A window that shows 8-bit pixels in the shape of the mode's display, and its keys, mouse, gamepad and time.
///
/// With OBLONG_HEADLESS=FRAMES or FRAMES:FILE.png in the environment there is no window: so many pictures are drawn, 70
/// a second by a clock of their own, and the last one is saved: for tests of a program.
class Window {
  public:
    explicit Window(const std::string& title, ScreenMode mode = {});
    /// Shown by a platform of one's own, which outlives it.
    Window(Platform& platform, ScreenMode mode);
    ~Window();
    Window(const Window&) = delete;

    Palette palette;  ///< of the next picture; at first 216 even colours and 40 greys

    /// Shows the canvas, waits for the display, takes the input. False once the user has closed the window, or close().
    bool show();
    /// The next show() is the last.
    void close();
    /// The pixels of the next picture; what was drawn stays.
    Framebuffer canvas();
    /// Its size, and the shape of its display.
    const ScreenMode& mode() const;
    /// Changes both: canvas() is another one, of colour 0.
    void set_mode(const ScreenMode& mode);
    /// Of the picture being drawn: milliseconds since the window opened.
    std::int64_t time_ms() const;

    /// Whether a key, button or stick is held: "Space", "Left Shift", "W" (of a US keyboard), "Mouse 1", "Wheel Up",
    /// "Pad A", "Pad Left Stick Up".
    bool is_down(std::string_view input) const;
    /// Whether it was pressed since the picture before.
    bool was_pressed(std::string_view input) const;
    /// How far a half of a stick or a trigger is pressed, 0 to 256; keys and buttons 0 or 256.
    std::int32_t pressure_256(std::string_view input) const;
    /// The pixel under the mouse, perhaps outside the canvas.
    PixelPosition mouse() const;
    /// How far the mouse was moved since the picture before, while it is captured: right and down.
    PixelPosition mouse_motion() const;
    /// Hides the mouse and keeps it in the window, or lets it go.
    void capture_mouse(bool is_captured);
    /// Fills the screen, or goes back. Alt+Enter does so, too.
    void set_full_screen(bool is_full);

  private:
    struct State;
    State* state_;
};

// Sound

/// What plays sounds and music. Without a sound device it is silent: see problem().
class Speaker {
  public:
    Speaker();
    ~Speaker();
    Speaker(const Speaker&) = delete;

    /// A FLAC or WAV file of one channel: its number for play().
    std::int32_t load(const std::string& file);
    /// A sound of one's own: samples of 16 bits.
    std::int32_t add(const std::vector<std::int16_t>& samples, std::int32_t rate_hz);
    /// Plays a sound once; `pan_256` from -256, left, to 256, right.
    void play(std::int32_t sound, std::int32_t volume_256 = 256, std::int32_t pan_256 = 0);
    /// Plays a tracker module (MOD) again and again, instead of the one before.
    void play_music(const std::string& file, std::int32_t volume_256 = 256);
    /// Ends the music.
    void stop_music();
    /// Why nothing is heard; empty if there is a device.
    const std::string& problem() const;

  private:
    struct State;
    State* state_;
};

// Places in the world: x east, y north, z up

/// A place, and the way that something there looks or is turned.
struct Pose {
    std::int32_t x_256 = 0, y_256 = 0, z_256 = 0;  ///< 256ths of a unit
    /// 256ths of a degree: counter-clockwise from east, down, to the right.
    std::int32_t yaw_256 = 0, pitch_256 = 0, roll_256 = 0;
    bool operator==(const Pose&) const = default;
};
/// In whole units and degrees.
Pose pose_at(std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t yaw = 0, std::int32_t pitch = 0,
             std::int32_t roll = 0);
/// Moved by so many 256ths of a unit ahead and to the right, on the level ground, and up.
Pose moved(const Pose& pose, std::int32_t ahead_256, std::int32_t right_256, std::int32_t up_256 = 0);

// Models

/// A corner of a triangle: its place in the model, units, and the texel of the picture that it shows.
struct Corner {
    std::int32_t x = 0, y = 0, z = 0;
    std::int32_t u = 0, v = 0;
};

/// Triangles with pictures on them.
class Model {
  public:
    Model();
    /// An OBJ file with its materials, or Quake's MDL; `scale_256` times as large.
    Model(const std::string& file, const Palette& palette, std::int32_t scale_256 = 256);
    ~Model();
    Model(const Model&) = delete;

    /// A picture for triangles to come: its number.
    std::int32_t add_picture(const Picture& picture);
    /// A triangle that is seen where its corners run clockwise.
    void add_triangle(const Corner& a, const Corner& b, const Corner& c, std::int32_t picture);
    /// How many frames of motion a file had; 1 without any.
    std::int32_t frame_count() const;

  private:
    friend class Stage;
    friend class LevelScene;
    struct State;
    State* state_;
};

/// Draws models without a level.
class Stage {
  public:
    explicit Stage(const Palette& palette, ScreenMode mode = {});
    ~Stage();
    Stage(const Stage&) = delete;

    /// Begins a picture seen from `eye`: what is drawn from here on hides what is farther.
    void look(const Pose& eye, std::int32_t field_of_view = 90);
    /// Light from everywhere, and from one side: toward (x, y, z), any length. 256: a picture's own colours.
    void set_light(std::int32_t ambient_256, std::int32_t from_side_256 = 0, std::int32_t x = 0, std::int32_t y = 0,
                   std::int32_t z = 1);
    /// Draws a model. `frame`: of its motion.
    void draw(const Model& model, const Pose& pose, Framebuffer canvas, std::int32_t frame = 0);

  private:
    struct State;
    State* state_;
};

// Levels

/// A level of Quake's format (oblong-map makes them), with its doors, items and effects.
class LevelScene {
  public:
    explicit LevelScene(const std::string& bsp_file, const Palette& palette, ScreenMode mode = {});
    ~LevelScene();
    LevelScene(const LevelScene&) = delete;

    /// Where the player comes in, at eye height.
    Pose start() const;
    /// Draws the picture seen from `eye`, at a time from 0 on, which moves water, lights and sky.
    void draw(const Pose& eye, std::int64_t time_ms, Framebuffer canvas, std::int32_t field_of_view = 90);
    /// The colours for a picture from there: the level's own cycles, the tint under water.
    Palette palette_at(const Pose& eye, std::int64_t time_ms) const;
    /// Shows a model in the next picture, also if it is gone by then.
    void show(const Model& model, const Pose& pose, std::int32_t frame = 0);

    /// Where a body gets whose eye is at `eye` and wants to be at `wanted` (see moved()): it slides along walls and
    /// doors, and climbs steps of 18 units. It looks as wanted.
    Pose walked(const Pose& eye, const Pose& wanted) const;
    /// Whether it stands on something.
    bool stands(const Pose& eye) const;
    /// The number of the first entity behind `after` with this value of a key ("targetname", "door1"), or -1.
    std::int32_t find_entity(const std::string& key, const std::string& value, std::int32_t after = -1) const;
    /// A key's value of an entity, perhaps empty.
    std::string entity_value(std::int32_t entity, const std::string& key) const;
    /// Moves the brushes of an entity (a door, a lift) away from where the level has them.
    void move_entity(std::int32_t entity, std::int32_t east_256, std::int32_t north_256, std::int32_t up_256);
    /// Turns a func_door_rotating about its axis, counter-clockwise where that points to the eye, away from where the
    /// level has it. It stops nobody then.
    void turn_entity(std::int32_t entity, std::int32_t degrees_256);

    /// The accuracy of pictures: "1991", "1994", "1996", "bounded" or "exact".
    void set_accuracy(const std::string& preset);
    /// All that can be set (engine/frame/settings.h).
    Settings& settings();
    /// What the file holds (engine/level/level.h).
    const Level& level() const;

  private:
    struct State;
    State* state_;
};

}  // namespace oblong

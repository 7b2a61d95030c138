#pragma once

#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/surface/palette.h"
#include "engine/view/present_rect.h"
#include "engine/view/screen.h"

/// The first header of a program that uses Oblong as a library: a window of 8-bit pixels, pictures, sounds, models and
/// levels. Numbers are integers: positions in world units, angles in degrees; names that end in `_256`: in 256ths of
/// these. Whatever can fail throws a std::runtime_error that names the file and the place in it. Objects share nothing
/// except as an argument's comment says, and otherwise may be destroyed in any order; a moved object's
/// place may only be assigned to or destroyed.
namespace oblong {

class Platform;
struct Level;
struct Settings;

/// The library's version, as "0.1.0".
const char* version();
/// Prints an error on standard error and returns main()'s exit code, 1; the examples end so.
int report(const std::exception& error);
/// The path of a file in the running program's folder.
std::string beside_program(const std::string& file);

/// A file by its name, which what() tells.
struct File {
    File(const char* its_name);
    File(std::string its_name);
    /// One in memory, named for errors; its bytes outlive the call.
    File(std::string its_name, std::span<const std::uint8_t> its_bytes);

    std::string name;
    std::span<const std::uint8_t> bytes;
};

// Colours

/// A file of 768 bytes (Quake's palette.lmp), or a PNG with a palette.
Palette load_palette(const File& file);
/// Sets colours `first` to `last` of a palette to an even gradient between two colours.
void set_ramp(Palette& palette, int first, int last, Rgb8 from, Rgb8 to);
/// Sets them to those of pictures that are found most: all, if there are no more.
void set_from_pictures(Palette& palette, int first, int last, const std::vector<File>& pictures);
/// All colours mixed with one, whose share is 0 to 256: a fade, a flash.
Palette mixed(const Palette& palette, Rgb8 colour, std::int32_t share_256);
/// Moves colours `first` to `last` cyclically by a number of places: for waterfalls and lamps.
void cycle_colours(Palette& palette, int first, int last, std::int64_t places);

// Pictures

/// A program's own pixels, rows top to bottom: a sprite, a texture, a canvas.
struct Picture {
    std::int32_t width_px = 0, height_px = 0;
    std::vector<std::uint8_t> pixels;  ///< a colour's index each

    /// A picture of colour 0.
    static Picture of_size(std::int32_t width_px, std::int32_t height_px);
    /// For drawing into it; valid while the picture exists with this size.
    Framebuffer canvas();
};
/// The index of the transparent colour, which draw_picture() and models skip.
inline constexpr std::uint8_t kTransparent = 255;
/// A PNG, TGA, JPEG or BMP file in the palette's nearest colours; pixels with alpha below 128 become kTransparent.
Picture load_picture(const File& file, const Palette& palette);
/// Writes a canvas as a PNG with this palette; the file's name ends in .png.
void save_picture(const std::string& file, Framebuffer canvas, const Palette& palette);
/// A checksum of a canvas's pixels (CRC-32, as zlib's): the same on every machine.
std::uint32_t checksum(Framebuffer canvas);

// Drawing: clipped to the canvas; only the lowest 8 bits of a colour count

/// Fills a canvas.
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
/// A filled rectangle.
void fill_rectangle(Framebuffer canvas, std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height,
                    std::int32_t colour);
/// A circle that is round on the mode's display: the radius is `radius_px` columns, clamped to 0 to 8,192, and fewer or
/// more rows. Throws for a mode that no window can have.
void draw_circle(Framebuffer canvas, const ScreenMode& mode, std::int32_t x, std::int32_t y, std::int32_t radius_px,
                 std::int32_t colour);
/// The same, filled.
void fill_circle(Framebuffer canvas, const ScreenMode& mode, std::int32_t x, std::int32_t y, std::int32_t radius_px,
                 std::int32_t colour);
/// A triangle between three pixels' middles, filled; adjacent triangles share no pixel and leave no gap. Corners are
/// clamped to 2^20 pixels.
void fill_triangle(Framebuffer canvas, PixelPosition a, PixelPosition b, PixelPosition c, std::int32_t colour);
/// A picture, its left upper corner at (x, y), without its pixels of kTransparent.
void draw_picture(Framebuffer canvas, const Picture& picture, std::int32_t x, std::int32_t y);
/// A part of a picture, perhaps mirrored: a frame of a sheet, a tile. Beyond the picture it is transparent.
struct PicturePart {
    std::int32_t x = 0, y = 0, width_px = 0, height_px = 0;
    bool is_mirrored = false, is_upside_down = false;
    bool is_opaque = false;  ///< its pixels of kTransparent are drawn, too
    std::int32_t scale = 1;  ///< as many pixels for each of its pixels, both ways
};
/// A part, its left upper corner at (x, y).
void draw_part(Framebuffer canvas, const Picture& picture, const PicturePart& part, std::int32_t x, std::int32_t y);
/// A picture turned (counter-clockwise on square pixels) and scaled about its middle, which is put at (x, y).
void draw_turned(Framebuffer canvas, const Picture& picture, std::int32_t x, std::int32_t y, std::int32_t degrees_256,
                 std::int32_t scale_256 = 256);
/// A line of text in UTF-8 (Latin letters and common marks; a question mark for others) with its left upper corner at
/// (x, y), 6x8 pixels a letter, accents of capitals 2 pixels above, times `scale`.
void draw_label(Framebuffer canvas, std::int32_t x, std::int32_t y, std::string_view text, std::int32_t colour,
                std::int32_t scale = 1);
/// The width of a label at scale 1.
std::int32_t text_width_px(std::string_view line);
/// A text's lines of up to `width_px` at scale 1, broken at spaces and line feeds.
std::vector<std::string> wrapped(std::string_view text, std::int32_t width_px);

// Numbers

/// The sine of an angle, 65,536 for 1; add 90 degrees for the cosine.
std::int32_t sine_65536(std::int64_t degrees_256);
/// The direction of (x, y), 256ths of a degree from 0 to below a turn, counter-clockwise from +x; 0 for (0, 0).
std::int32_t direction_256(std::int64_t x, std::int64_t y);
/// The square root, rounded down.
std::uint32_t integer_root(std::uint64_t value);
/// The next number of a random sequence, the same on every machine, in [0, limit).
std::int32_t random_below(std::int32_t limit, std::uint64_t& state);

/// Adds what was typed to a text: '\b' takes its last letter away.
void add_typed(std::string& text, std::string_view typed);

// A window

/// A window that shows 8-bit pixels in the shape of the mode's display, and its keys, mouse, gamepad and time. All
/// windows of a program are opened and used on one thread.
///
/// With OBLONG_HEADLESS=FRAMES or FRAMES:FILE.png in the environment there is no window, for tests of a program: FRAMES
/// pictures are drawn, 70 a second by a simulated clock, and the last one is saved.
class Window {
  public:
    /// `size`: of the window, pixels of the screen; 0x0: as large as fits.
    explicit Window(const std::string& title, ScreenMode mode = {}, WindowSize size = {});
    /// Shown by the program's own platform, which outlives it.
    Window(Platform& platform, ScreenMode mode);
    ~Window();
    Window(Window&& other) noexcept;
    Window& operator=(Window&& other) noexcept;

    Palette palette;  ///< of the next picture; initially 216 even colours and 40 greys

    /// Shows the canvas, waits for the display, takes the input. False once the user has closed the window, or close().
    bool show();
    /// The next show() is the last.
    void close();
    /// The pixels of the next picture, which keep the last one.
    Framebuffer canvas();
    /// Its size, and the shape of its display.
    const ScreenMode& mode() const;
    /// Changes both: canvas() becomes a new one, of colour 0.
    void set_mode(const ScreenMode& mode);
    /// The time of the picture being drawn: milliseconds since the window opened.
    std::int64_t time_ms() const;

    /// Whether a key, button or stick is held: "Space", "Left Shift", "W" (of a US keyboard), "Mouse 1", "Wheel Up",
    /// "Pad A", "Pad Left Stick Up" of the gamepad used last, "Pad 2 A" of the second.
    bool is_down(std::string_view input) const;
    /// Whether it was pressed since the last picture.
    bool was_pressed(std::string_view input) const;
    /// Whether it was let go since then.
    bool was_released(std::string_view input) const;
    /// How often: notches of a wheel, quick presses.
    std::int32_t press_count(std::string_view input) const;
    /// How far a stick is pushed in one direction, or a trigger is pressed, 0 to 256; keys and buttons: 0 or 256.
    std::int32_t pressure_256(std::string_view input) const;
    /// The text typed since the last picture, in UTF-8, with repeats: '\b' for Backspace, '\n' for Enter.
    const std::string& typed() const;
    /// The pixel under the mouse, perhaps outside the canvas.
    PixelPosition mouse() const;
    /// The motion of the captured mouse since the last picture: right and down.
    PixelPosition mouse_motion() const;
    /// Hides the mouse and keeps it in the window, or releases it.
    void capture_mouse(bool is_captured);
    /// Fills the screen, or returns to the window; so does Alt+Enter.
    void set_full_screen(bool is_full);
    /// At most so many pictures a second; 0: as many as the display shows. A web page shows those.
    void set_rate(std::int32_t pictures_per_second);
    /// The window's icon, in the colours of `palette`, without its pixels of kTransparent.
    void set_icon(const Picture& picture);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

// Sound

/// Plays sounds and music. Without a sound device it is silent: see problem().
class Speaker {
  public:
    Speaker();
    ~Speaker();
    Speaker(Speaker&& other) noexcept;
    Speaker& operator=(Speaker&& other) noexcept;

    /// Loads a sound: WAV or OGG, stereo mixed to one channel, or FLAC of one; returns its number for play().
    std::int32_t load(const File& file);
    /// Adds a sound from 16-bit samples; returns its number for play().
    std::int32_t add(const std::vector<std::int16_t>& samples, std::int32_t rate_hz);
    /// Plays a sound once, or until stop(); `pan_256` from -256, left, to 256, right. Returns a number for what plays;
    /// -1 if too much does, or without a device.
    std::int64_t play(std::int32_t sound, std::int32_t volume_256 = 256, std::int32_t pan_256 = 0,
                      bool is_loop = false);
    /// Whether it still plays.
    bool is_playing(std::int64_t playing) const;
    /// Changes it while it plays.
    void set_volume(std::int64_t playing, std::int32_t volume_256, std::int32_t pan_256 = 0);
    /// Ends it.
    void stop(std::int64_t playing);
    /// Plays a tracker module (MOD) in a loop; replaces the current one.
    void play_music(const File& file, std::int32_t volume_256 = 256);
    /// Changes the music while it plays.
    void set_music_volume(std::int32_t volume_256);
    /// Ends the music.
    void stop_music();
    /// Why there is no sound; empty if there is a device.
    const std::string& problem() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

// Places in the world: x east, y north, z up

/// A position and an orientation.
struct Pose {
    std::int32_t x_256 = 0, y_256 = 0, z_256 = 0;  ///< 256ths of a unit
    /// 256ths of a degree: counter-clockwise from east, down, to the right.
    std::int32_t yaw_256 = 0, pitch_256 = 0, roll_256 = 0;
    bool operator==(const Pose&) const = default;
};
/// In whole units and degrees.
Pose pose_at(std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t yaw = 0, std::int32_t pitch = 0,
             std::int32_t roll = 0);
/// A pose moved horizontally ahead and to the right, and up.
Pose moved(const Pose& pose, std::int32_t ahead_256, std::int32_t right_256, std::int32_t up_256 = 0);

/// Where a place is in the picture seen from `eye`, perhaps beside it; none behind the eye.
std::optional<PixelPosition> project(const Pose& place, const Pose& eye, const ScreenMode& mode = {},
                                     std::int32_t field_of_view = 90);
/// A box along the axes: its corner with the least coordinates, and that with the greatest.
struct Bounds {
    Pose least, greatest;
    bool operator==(const Bounds&) const = default;
};

// Models

/// A corner of a triangle: its position in the model, units, and its texel in the picture.
struct Corner {
    std::int32_t x = 0, y = 0, z = 0;
    std::int32_t u = 0, v = 0;
};

/// How an OBJ file becomes a model.
struct ModelOptions {
    bool is_z_up = false;  ///< its axes are the world's; else y is up and z ahead, as most programs write
    Picture picture = {};  ///< for faces without a material; else they are grey
};

/// A model of textured triangles. In it x is ahead, y left, z up.
class Model {
  public:
    Model();
    /// An OBJ file with its materials, or Quake's MDL; `scale_256` 256ths of a unit for one of the file's.
    Model(const File& file, const Palette& palette, std::int32_t scale_256 = 256, const ModelOptions& options = {});
    /// A picture that stands upright and turns to the eye, the middle of its lower side at its pose; `scale_256` 256ths
    /// of a unit a pixel.
    static Model sprite(const Picture& picture, std::int32_t scale_256 = 256);
    ~Model();
    Model(Model&& other) noexcept;
    Model& operator=(Model&& other) noexcept;

    /// Adds a picture of one pixel or more for triangles, with holes where it is kTransparent; returns its number.
    std::int32_t add_picture(const Picture& picture);
    /// Adds a triangle, visible from the side on which its corners run clockwise.
    void add_triangle(const Corner& a, const Corner& b, const Corner& c, std::int32_t picture);
    /// The box around a frame of its motion.
    Bounds bounds(std::int32_t frame = 0) const;
    /// The number of frames of motion; 1 without motion.
    std::int32_t frame_count() const;
    /// What its file names and does not have, and what is shown instead: materials, pictures.
    const std::vector<std::string>& warnings() const;

  private:
    friend class Stage;
    friend class LevelScene;
    struct State;
    std::unique_ptr<State> state_;
};

/// Draws models without a level.
class Stage {
  public:
    explicit Stage(const Palette& palette, ScreenMode mode = {});
    ~Stage();
    Stage(Stage&& other) noexcept;
    Stage& operator=(Stage&& other) noexcept;

    /// Begins a picture seen from `eye`: models drawn after this hide those behind them.
    void look(const Pose& eye, std::int32_t field_of_view = 90);
    /// Ambient light, and directional light from (x, y, z), any length. 256: a picture's own colours. All colours are
    /// lit; in a LevelScene those from 224 on glow as in Quake: no light changes them.
    void set_light(std::int32_t ambient_256, std::int32_t from_side_256 = 0, std::int32_t x = 0, std::int32_t y = 0,
                   std::int32_t z = 1);
    /// Draws a model. `frame`: a frame of its motion.
    void draw(const Model& model, const Pose& pose, Framebuffer canvas, std::int32_t frame = 0);
    /// Draws the edges of its triangles over all else.
    void draw_edges(const Model& model, const Pose& pose, std::int32_t colour, Framebuffer canvas,
                    std::int32_t frame = 0);
    /// Changes the mode; look() is due again.
    void set_mode(const ScreenMode& mode);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

// Levels

/// What a ray meets.
struct Hit {
    Pose place;  ///< or its end
    bool is_hit = false;
    std::int32_t entity = -1;  ///< whose brushes; -1: the world's, or nothing
};

/// A level of Quake's format (oblong-map makes them), with its doors, items and effects.
class LevelScene {
  public:
    explicit LevelScene(const File& bsp_file, const Palette& palette, ScreenMode mode = {});
    ~LevelScene();
    LevelScene(LevelScene&& other) noexcept;
    LevelScene& operator=(LevelScene&& other) noexcept;

    /// The player's start, at eye height.
    Pose start() const;
    /// Draws the picture seen from `eye`, at a time from 0 on, which moves water, lights and sky.
    void draw(const Pose& eye, std::int64_t time_ms, Framebuffer canvas, std::int32_t field_of_view = 90);
    /// The colours for a picture from there: the level's own cycles, the tint under water.
    Palette palette_at(const Pose& eye, std::int64_t time_ms) const;
    /// Shows a model in the next picture, even if it is destroyed by then.
    void show(const Model& model, const Pose& pose, std::int32_t frame = 0);

    /// The pose that a body with its eye at `eye` reaches on the way to `wanted` (see moved()): it slides along walls
    /// and doors, and climbs steps of 18 units. The orientation is that of `wanted`.
    Pose walked(const Pose& eye, const Pose& wanted) const;
    /// Whether the body stands on a floor.
    bool stands(const Pose& eye) const;
    /// The number of the first entity after `after` with this value of a key ("targetname", "door1"), or -1.
    std::int32_t find_entity(const std::string& key, const std::string& value, std::int32_t after = -1) const;
    /// The value of an entity's key; may be empty.
    std::string entity_value(std::int32_t entity, const std::string& key) const;
    /// Moves the brushes of an entity (a door, a lift) by an offset from their place in the level, clamped to 100,000
    /// units along each axis.
    void move_entity(std::int32_t entity, std::int32_t east_256, std::int32_t north_256, std::int32_t up_256);
    /// Turns a func_door_rotating from its place in the level about its axis, counter-clockwise seen with the axis
    /// pointing at the eye. It is solid only at 0.
    void turn_entity(std::int32_t entity, std::int32_t degrees_256);

    /// Hides an entity's brushes and model, which then stop nobody, or shows them again.
    void hide_entity(std::int32_t entity, bool is_hidden = true);
    /// The box of an entity's brushes where they are now, or one of a body's size around its origin.
    Bounds entity_bounds(std::int32_t entity) const;
    /// Its origin and angle; of brushes the middle of their box.
    Pose entity_pose(std::int32_t entity) const;
    /// Whether the body with its eye at `eye` touches this box: it takes an item, is in a trigger.
    bool touches(const Pose& eye, std::int32_t entity) const;
    /// Follows a line of up to `length` units the way a pose looks, to what is solid, through liquids and skies.
    Hit ray(const Pose& from, std::int32_t length) const;

    /// Changes the mode.
    void set_mode(const ScreenMode& mode);
    /// The accuracy of pictures: "1991", "1994", "1996", "pixel", "bounded" or "exact".
    void set_accuracy(const std::string& preset);
    /// All settings (engine/frame/frame.h).
    Settings& settings();
    /// The contents of the file (engine/level/level.h).
    const Level& level() const;
    /// What of its file is left out or shown otherwise: entities with wrong values, missing models.
    const std::vector<std::string>& warnings() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace oblong

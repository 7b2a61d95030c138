"""How the time of a frame grows with the number of pixels, hidden faces, and visible models.

1. A level in modes from 320x200 to 3840x2400.
2. The same level with 2 to 30 copies of its world, out of sight: the same views must give the same pictures, and should
   take the same time. The levels are written as BSP2, for its higher limits.
3. A hall with 1 to 1,000 models made of triangles, and one with as many brush models, all in view.
Every round draws all of them in turn; a frame's time is the least of the rounds, as other programs only add to it.

usage: tools/measure-frames scale [OPTIONS] [BUILD] [LEVEL CAMERAS [PALETTE]]
  BUILD              a folder built before (default: build)
  LEVEL CAMERAS      (default: the largest real level where a folder shared/ is there, else the demo level)
  --rounds N         (default: 5)
  --most N           cameras (default: 40)
  --render PROGRAM   that oblong-render, as it is (default: BUILD's, built anew if sources changed)
  --out DIR          (default: BUILD/bench)
  --quick            two of each, once: to see that all work
Writes DIR/scale.svg and DIR/scale.json. Fails if a picture differs, or a frame leaves a pixel unwritten.
"""
import json
import math
import os
import statistics
import subprocess
import sys

import copied_level
import runs

MODES = ("320x200", "640x400", "800x600", "1024x768", "1280x800", "1600x1200", "1920x1200", "2560x1600", "3840x2400")
COPIES, MOST_FACES = (1, 2, 5, 10, 30), 120_000
MODELS = (1, 10, 100, 1000)
LARGEST_REAL_LEVEL = "end"
HALL = 2048, 1536  # size and height of the models' hall


class Frames:
    """The frames of some cameras in one level and mode, with the least times of several runs."""

    def __init__(self, program, place, mode="320x200", options=()):
        self.program, self.place, self.mode, self.options = program, place, mode, options
        self.times, self.pictures = None, None

    def run(self, repeat):
        report = runs.report_of(self.program, self.place, repeat, self.mode, self.options)
        for frame in report["frames"]:
            if frame["pixels"]["never"]:
                runs.fail("%s in %s: camera %d leaves %d pixels unwritten" %
                          (self.place.name, self.mode, frame["camera"], frame["pixels"]["never"]))
        times = [frame["microseconds"] for frame in report["frames"]]
        self.times = times if self.times is None else list(map(min, self.times, times))
        self.pictures = [frame["crc32"] for frame in report["frames"]]

    def median(self):
        return statistics.median(self.times)

    def mean(self):
        return statistics.fmean(self.times)


def measure(frames, rounds, repeat):
    for turn in range(rounds):
        for one in frames:
            one.run(repeat)
        print("\rround %d of %d" % (turn + 1, rounds), end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)


def box(x0, y0, z0, x1, y1, z1, texture):
    """A brush of a map."""
    sides = [((x0, y0, z1), (x0, y1, z1), (x1, y1, z1)), ((x0, y0, z0), (x1, y0, z0), (x1, y1, z0)),
             ((x0, y0, z0), (x0, y1, z0), (x0, y1, z1)), ((x1, y0, z0), (x1, y0, z1), (x1, y1, z1)),
             ((x0, y0, z0), (x0, y0, z1), (x1, y0, z1)), ((x0, y1, z0), (x1, y1, z0), (x1, y1, z1))]
    lines = [" ".join("( %d %d %d )" % point for point in side) + " %s 0 0 0 1 1" % texture for side in sides]
    return "{\n%s\n}\n" % "\n".join(lines)


def model_places(count):
    """Positions in the hall, all visible from its west end: rows that rise toward the east."""
    columns = math.ceil(math.sqrt(count))
    size, _ = HALL
    step = (size - 512) / columns
    return [(384 + column * step + step / 2, 128 + (row + 0.5) * (size - 256) / columns, 64 + 960 * column / columns)
            for column in range(columns) for row in range(columns)][:count]


def hall_map(count, entity_at):
    size, height = HALL
    walls = [(-16, -16, -16, size + 16, size + 16, 0), (-16, -16, height, size + 16, size + 16, height + 16),
             (-16, -16, 0, 0, size + 16, height), (size, -16, 0, size + 16, size + 16, height),
             (0, -16, 0, size, 0, height), (0, size, 0, size, size + 16, height)]
    text = '{\n"classname" "worldspawn"\n"_minlight" "80"\n%s}\n' % "".join(box(*wall, "sand_wall") for wall in walls)
    text += '{\n"classname" "info_player_start"\n"origin" "64 %d 32"\n}\n' % (size / 2)
    return text + "".join(entity_at(*place) for place in model_places(count))


def write_ball(path):
    """Writes an OBJ of a sphere of 12 by 7 facets, 24 units across; returns its number of triangles."""
    around, bands, radius = 12, 7, 12
    points = [(0, 0, radius), (0, 0, -radius)]
    for band in range(1, bands):
        high, ring = radius * math.cos(math.pi * band / bands), radius * math.sin(math.pi * band / bands)
        points += [(ring * math.cos(math.tau * i / around), ring * math.sin(math.tau * i / around), high) for i in range(around)]
    at = lambda band, i: 3 + (band - 1) * around + i % around
    faces = [(1, at(1, i), at(1, i + 1)) for i in range(around)] + [(2, at(bands - 1, i + 1), at(bands - 1, i)) for i in range(around)]
    for band in range(1, bands - 1):
        for i in range(around):
            corners = at(band, i), at(band + 1, i), at(band + 1, i + 1), at(band, i + 1)
            faces += [corners[:3], (corners[0], *corners[2:])]
    with open(path, "w") as out:
        out.writelines("v %.4f %.4f %.4f\n" % point for point in points)
        out.writelines("f %d %d %d\n" % face for face in faces)
    return len(faces)


def mesh_at(x, y, z):
    return '{\n"classname" "misc_model"\n"model" "ball.obj"\n"up" "z"\n"origin" "%d %d %d"\n}\n' % (x, y, z)


def brush_model_at(x, y, z):
    return '{\n"classname" "func_wall"\n%s}\n' % box(x - 12, y - 12, z - 12, x + 12, y + 12, z + 12, "brick")


class Scale:
    def __init__(self, options, program):
        self.options, self.program = options, program
        self.folder = runs.work_folder(options.build)
        self.counts = (lambda series: series[::len(series) - 1]) if options.quick else (lambda series: series)

    def by_mode(self, place):
        modes = self.counts(MODES)
        frames = [Frames(self.program, place, mode) for mode in modes]
        self.measure(frames)
        return [self.row(one, {"mode": mode, "pixels": runs.pixels_of(mode)}) for one, mode in zip(frames, modes)]

    def by_faces(self, place):
        rows, frames = [], []
        world_faces = copied_level.world_face_count(place.level)
        for copies in COPIES[:2] if self.options.quick else COPIES:
            if copies * world_faces > MOST_FACES:
                break
            path = os.path.join(self.folder, "copies_%d.bsp" % copies)
            rows.append({"copies": copies, "faces": copied_level.write_copies(place.level, copies, path)})
            frames.append(Frames(self.program, runs.Place("%d copies" % copies, path, place.cameras, place.palette)))
        self.measure(frames)
        for one in frames[1:]:
            if one.pictures != frames[0].pictures:
                runs.fail("%s of %s: another picture than of one" % (one.place.name, place.name))
        return [self.row(one, {**row, "ratio": one.mean() / frames[0].mean()}) for one, row in zip(frames, rows)]

    def by_models(self, kind, entity_at):
        rows, frames = [], []
        for count in self.counts(MODELS):
            hall = self.hall("%d_%s" % (count, kind), hall_map(count, entity_at))
            frames.append(Frames(self.program, hall))
            rows.append({"models": count})
        self.measure(frames)
        return [self.row(one, row) for one, row in zip(frames, rows)]

    def hall(self, name, text):
        """A compiled hall, with cameras at its west corners and between them."""
        path, assets = os.path.join(self.folder, name), os.path.join(self.options.build, "assets")
        with open(path + ".map", "w") as out:
            out.write(text)
        subprocess.run([os.path.join(self.options.build, "bin/oblong-map"), path + ".map", "-o", path + ".bsp", "--fast",
                        "--wad", os.path.join(assets, "demo.wad")], check=True, stdout=subprocess.DEVNULL)
        size, _ = HALL
        with open(path + ".csv", "w") as out:
            out.write("x,y,z,yaw,pitch\n32,%d,800,0,8\n32,32,900,30,12\n32,%d,900,-30,12\n" % (size / 2, size - 32))
        return runs.Place(name, path + ".bsp", path + ".csv", os.path.join(assets, "palette.lmp"))

    def measure(self, frames):
        measure(frames, 1 if self.options.quick else self.options.rounds, 1 if self.options.quick else 5)

    @staticmethod
    def row(frames, about):
        return {**about, "median_us": frames.median(), "mean_us": frames.mean()}


class Panel:
    """A chart with both axes logarithmic."""
    WIDTH, HEIGHT = 250, 190

    def __init__(self, title, across, rows_of_lines):
        self.title, self.across = title, across
        self.lines = rows_of_lines  # name -> [(across, microseconds)]
        points = [point for line in rows_of_lines.values() for point in line]
        self.x = self._decades([x for x, _ in points])
        self.y = self._decades([y for _, y in points])

    @staticmethod
    def _decades(values):
        low, high = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
        return low, max(high, low + 1)

    def svg(self, left, top):
        def place(x, y):
            return (left + (math.log10(x) - self.x[0]) / (self.x[1] - self.x[0]) * self.WIDTH,
                    top + self.HEIGHT - (math.log10(y) - self.y[0]) / (self.y[1] - self.y[0]) * self.HEIGHT)

        text = '<text x="%d" y="%d" font-weight="bold">%s</text>' % (left, top - 24, self.title)
        for power in range(self.x[0], self.x[1] + 1):
            x, y = place(10 ** power, 10 ** self.y[0])
            text += '<line x1="%.1f" y1="%d" x2="%.1f" y2="%d" stroke="#ddd"/>' % (x, top, x, top + self.HEIGHT)
            text += '<text x="%.1f" y="%.1f" text-anchor="middle">%s</text>' % (x, y + 14, format(10 ** power, ","))
        for power in range(self.y[0], self.y[1] + 1):
            x, y = place(10 ** self.x[0], 10 ** power)
            text += '<line x1="%d" y1="%.1f" x2="%d" y2="%.1f" stroke="#ddd"/>' % (left, y, left + self.WIDTH, y)
            text += '<text x="%.1f" y="%.1f" text-anchor="end">%s us</text>' % (x - 4, y + 4, format(10 ** power, ","))
        text += '<text x="%d" y="%d" text-anchor="middle">%s</text>' % (left + self.WIDTH / 2, top + self.HEIGHT + 32, self.across)
        for (name, line), colour in zip(self.lines.items(), ("#357", "#c33")):
            places = [place(*point) for point in line]
            text += '<polyline fill="none" stroke="%s" points="%s"/>' % (colour, " ".join("%.1f,%.1f" % at for at in places))
            text += "".join('<circle cx="%.1f" cy="%.1f" r="3" fill="%s"/>' % (*at, colour) for at in places)
            for (_, value), (x, y) in zip(line, places):
                text += '<text x="%.1f" y="%.1f" text-anchor="end" fill="%s">%s</text>' % (x - 5, y - 6, colour, format(round(value), ","))
        for i, (name, colour) in enumerate(zip(self.lines, ("#357", "#c33"))):
            text += '<text x="%d" y="%d" fill="%s">%s</text>' % (left + 100 * i, top - 8, colour, name if len(self.lines) > 1 else "")
        return text


def write_chart(path, found):
    def line(rows, across):
        return [(row[across], row["median_us"]) for row in rows]

    panels = [Panel("Pixels: " + found["level"], "pixels of the mode", {"": line(found["modes"], "pixels")}),
              Panel("Faces of the level, the view the same", "faces", {"": line(found["faces"], "faces")}),
              Panel("Models in view", "models", {"of %d triangles" % found["triangles_a_mesh"]: line(found["meshes"], "models"),
                                                 "brush models": line(found["brush_models"], "models")})]
    with open(path, "w") as out:
        out.write('<svg xmlns="http://www.w3.org/2000/svg" width="1080" height="290" font-family="sans-serif" font-size="11">'
                  '<rect width="100%%" height="100%%" fill="#fff"/>%s</svg>\n' %
                  "".join(panel.svg(80 + 350 * i, 50) for i, panel in enumerate(panels)))


def print_tables(found):
    print("%s, %d cameras; microseconds a frame" % (found["level"], found["cameras"]))
    for row in found["modes"]:
        print("%12s %12s pixels %10.0f median %10.0f mean %8.2f ns a pixel" %
              (row["mode"], format(row["pixels"], ","), row["median_us"], row["mean_us"], 1000 * row["mean_us"] / row["pixels"]))
    for row in found["faces"]:
        print("%6d copies %12s faces  %10.1f median %10.1f mean %8.3f times the frame of one" %
              (row["copies"], format(row["faces"], ","), row["median_us"], row["mean_us"], row["ratio"]))
    for kind in ("meshes", "brush_models"):
        for row in found[kind]:
            print("%12s %12s %-12s %5.0f median" % ("", format(row["models"], ","), kind.replace("_", " "), row["median_us"]))


def main():
    options = runs.parse_arguments(__doc__, rounds=5, most=40, render=str, out=str, quick=False)
    program = options.render or runs.built_render(options.build)
    scale = Scale(options, program)
    places = {place.name: place for place in runs.places(options.build, options.level_paths, with_demo=True)}
    place = places.get(LARGEST_REAL_LEVEL) or next(iter(places.values()))
    place = place.thinned(2 if options.quick else options.most, scale.folder)
    triangles = write_ball(os.path.join(scale.folder, "ball.obj"))
    found = {"level": place.name, "cameras": place.camera_count(), "triangles_a_mesh": triangles, "modes": scale.by_mode(place), "faces": scale.by_faces(place),
             "meshes": scale.by_models("meshes", mesh_at), "brush_models": scale.by_models("brush_models", brush_model_at)}
    print_tables(found)
    out = options.out or scale.folder
    os.makedirs(out, exist_ok=True)
    write_chart(os.path.join(out, "scale.svg"), found)
    with open(os.path.join(out, "scale.json"), "w") as file:
        json.dump(found, file, indent=1)

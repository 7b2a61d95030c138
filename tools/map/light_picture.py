"""Shows each way of lighting in a small room, by oblong-map on the left and by ericw-tools on the right, in one picture.

usage: light_picture.py TOOLS OUT.png [--build FOLDER]
  TOOLS    a folder with qbsp, vis and light, which are not part of this project
  --build  (default: build)
Below a pair: the mean difference of the lightmaps, 0 to 255, and the share of samples that differ by more than 8.
"""
import argparse
import math
import os
import re
import struct
import tempfile
import zlib

from compare_ericw import Comparison, run

WIDTH, HEIGHT, GAP, LABEL, COLUMNS = 128, 80, 2, 12, 3  # pixels; columns of pairs
LAMP = {"origin": "72 120 112", "light": "350"}


def lamp(**keys):
    return {"lamps": [{**LAMP, **keys}]}


def shown():
    """The rooms by name: their lamps, the world's keys, and the textures of ceiling and floor."""
    brightness = {0: 350, 1: 200, 2: 300, 3: 200, 5: 500}
    rooms = {"delay %d" % kind: lamp(delay=kind, light=light) for kind, light in brightness.items()}
    rooms["wait 2"] = lamp(wait=2)
    rooms["mangle"] = lamp(mangle="45 -45 0", angle=50, light=600)
    rooms["negative light"] = {"lamps": [LAMP, {"origin": "216 216 24", "light": "-250"}]}
    rooms["_color"] = lamp(_color="255 96 32", light=450)
    rooms["_surface"] = lamp(_surface="lamp", light=200)
    rooms["_surface_spotlight"] = lamp(_surface="lamp", light=300, _surface_spotlight=1)
    rooms["in a wall"] = lamp(origin="72 120 144")
    for key, value in {"_minlight": 60, "_phong": 1, "_dirt": 1, "_bounce": 1}.items():
        rooms[key] = {**lamp(), "world": {key: value}}
    rooms["_phong"]["world"]["_phong_angle"] = 89  # their light reads this, their qbsp reads the other
    for key, light, sky in (("_sunlight", 300, "ceiling"), ("_sunlight2", 600, "ceiling"), ("_sunlight3", 600, "floor")):
        rooms[key] = {"world": {key: light, "_sun_mangle": "60 -50 0"}, sky: "sky_night"}
    rooms["in a sky"] = {**lamp(origin="72 120 152"), "world": {"_minlight": 20}, "ceiling": "sky_night"}
    rooms["light 0"] = {**lamp(light=0), "world": {"_minlight": 20}}
    return rooms


def prism(outline, low, high, texture):
    """A brush over an outline, counter-clockwise. A plane's points: the normal is (first - second) x (third - second)."""
    planes = [((1, 0, high), (0, 0, high), (0, 1, high)), ((0, 1, low), (0, 0, low), (1, 0, low))]
    planes += [((*b, 0), (*a, 0), (*a, 1)) for a, b in zip(outline, outline[1:] + outline[:1])]
    lines = ["%s %s 0 0 0 1 1" % (" ".join("( %g %g %g )" % point for point in plane), texture) for plane in planes]
    return "{\n%s\n}\n" % "\n".join(lines)


def box(low, high, texture):
    return prism([(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])], low[2], high[2], texture)


def entity(keys, brushes=""):
    return "{\n%s\n%s}\n" % ("\n".join('"%s" "%s"' % pair for pair in keys.items()), brushes)


def source_of(wad, lamps=(), world={}, ceiling="plaster_ivory", floor="plaster_ivory"):
    """A room of 256 x 256 x 144 units with a table, a pillar and a lamp's box on the wall."""
    wall = "plaster_ivory"
    brushes = box((-16, -16, -16), (272, 272, 0), floor) + box((-16, -16, 144), (272, 272, 160), ceiling)
    brushes += box((-16, 0, 0), (0, 256, 144), wall) + box((256, 0, 0), (272, 256, 144), wall)
    brushes += box((-16, -16, 0), (272, 0, 144), wall) + box((-16, 256, 0), (272, 272, 144), wall)
    brushes += box((64, 176, 32), (144, 224, 40), wall) + box((96, 192, 0), (112, 208, 32), wall)
    brushes += box((248, 160, 64), (256, 208, 96), "lamp")
    turns = [math.tau * i / 12 for i in range(12)]
    brushes += prism([(round(184 + 32 * math.cos(t)), round(96 + 32 * math.sin(t))) for t in turns], 0, 144, wall)
    start = entity({"classname": "info_player_start", "origin": "40 40 28"})
    lights = "".join(entity({"classname": "light", **keys}) for keys in lamps)
    return entity({"classname": "worldspawn", "wad": wad, **world}, brushes) + start + lights


def chunks_of(path):
    with open(path, "rb") as file:
        png, at, chunks = file.read(), 8, {}
    while at < len(png):
        size, name = struct.unpack_from(">I4s", png, at)
        chunks[name] = chunks.get(name, b"") + png[at + 8:at + 8 + size]
        at += 12 + size
    return chunks


def rows_of(chunks):
    """The rows of pixels of an indexed PNG without filters, as oblong-render writes them."""
    bytes_ = zlib.decompress(chunks[b"IDAT"])
    assert not any(bytes_[::WIDTH + 1])
    return [bytes_[i + 1:i + 1 + WIDTH] for i in range(0, len(bytes_), WIDTH + 1)]


def write_png(path, rows, palette):
    head = struct.pack(">2I5B", len(rows[0]), len(rows), 8, 3, 0, 0, 0)
    pixels = zlib.compress(b"".join(b"\0" + row for row in rows), 9)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for name, data in ((b"IHDR", head), (b"PLTE", palette), (b"IDAT", pixels), (b"IEND", b"")):
            file.write(struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data)))


def draw_text(rows, x, y, text, colour):
    """In the engine's font: eight rows of five bits for each character from the space on."""
    with open(os.path.join(os.path.dirname(__file__), "../../engine/draw/font.cpp")) as file:
        glyphs = [re.findall(r"0b([01]{5})", line) for line in file if line.startswith("    {0b")]
    for i, character in enumerate(text):
        for row, bits in zip(rows[y:], glyphs[ord(character) - 32]):
            for k, bit in enumerate(bits):
                if bit == "1":
                    row[x + 6 * i + k] = colour


class Picture:
    def __init__(self, options, scratch):
        self.build, self.scratch = os.path.abspath(options.build), scratch
        options.oblong, options.maps, options.threads = os.path.join(self.build, "bin/oblong-map"), scratch, ["2"]
        self.comparison = Comparison(options, scratch)
        self.rows, self.palette = [], b""

    def frame(self, level):
        cameras = os.path.join(self.scratch, "cameras.csv")
        with open(cameras, "w") as file:
            file.write("x,y,z,yaw,pitch\n16,24,112,42,18\n")
        run([os.path.join(self.build, "bin/oblong-render"), self.comparison.path(level), "--cameras", cameras,
             "--mode", "%dx%d" % (WIDTH, HEIGHT), "--out", self.scratch,
             "--palette", os.path.join(self.build, "assets/palette.lmp")], self.scratch)
        chunks = chunks_of(os.path.join(self.scratch, "00000.png"))
        self.palette = chunks[b"PLTE"]
        return rows_of(chunks)

    def add(self, index, name, room):
        with open(os.path.join(self.scratch, name + ".map"), "w") as file:
            file.write(source_of(os.path.join(self.build, "assets/demo.wad"), **room))
        figures, _ = self.comparison.row(name)
        x, y = index % COLUMNS * 2 * (WIDTH + GAP), index // COLUMNS * (HEIGHT + LABEL)
        if x == 0:
            self.rows += [bytearray(COLUMNS * 2 * (WIDTH + GAP) - GAP) for _ in range(HEIGHT + LABEL)]
        for level, left in (("ours.bsp", x), ("theirs.bsp", x + WIDTH + GAP)):
            for i, row in enumerate(self.frame(level)):
                self.rows[y + i][left:left + WIDTH] = row
        brightest = max(range(256), key=lambda i: sum(self.palette[3 * i:3 * i + 3]))
        text = "%s: %.2f, %.1f %%" % (name, figures[10], 100 * figures[11])
        draw_text(self.rows, x, y + HEIGHT + GAP, text, brightest)
        print(text, flush=True)


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("tools", type=os.path.abspath)
    parser.add_argument("out")
    parser.add_argument("--build", default="build")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        picture = Picture(options, scratch)
        for index, (name, room) in enumerate(shown().items()):
            picture.add(index, name, room)
        write_png(options.out, picture.rows, picture.palette)


if __name__ == "__main__":
    main()

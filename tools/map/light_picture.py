"""Shows each way of lighting in a small room, by oblong-map on the left and by ericw-tools on the right, in one picture.
Needs ImageMagick.

usage: light_picture.py TOOLS OUT.png [--build FOLDER]
  TOOLS    a folder with qbsp, vis and light, which are not part of this project
  --build  (default: build)
Below a pair: the mean difference of the lightmaps, 0 to 255, and the share of samples that differ by more than 8.
"""
import argparse
import math
import os
import tempfile

from compare_ericw import Comparison, run

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


class Rooms:
    def __init__(self, options, scratch):
        self.build, self.scratch = os.path.abspath(options.build), scratch
        options.oblong, options.maps, options.threads = os.path.join(self.build, "bin/oblong-map"), scratch, ["2"]
        self.comparison = Comparison(options, scratch)

    def frame(self, level):
        """The path of a picture of a level."""
        cameras, folder = os.path.join(self.scratch, "cameras.csv"), os.path.join(self.scratch, level + "-pictures")
        with open(cameras, "w") as file:
            file.write("x,y,z,yaw,pitch\n16,24,112,42,18\n")
        run([os.path.join(self.build, "bin/oblong-render"), self.comparison.path(level), "--cameras", cameras,
             "--mode", "128x80", "--out", folder, "--palette", os.path.join(self.build, "assets/palette.lmp")], self.scratch)
        return os.path.join(folder, "00000.png")

    def pair(self, name, room):
        """Arguments of montage: a pair of pictures with its caption."""
        with open(os.path.join(self.scratch, name + ".map"), "w") as file:
            file.write(source_of(os.path.join(self.build, "assets/demo.wad"), **room))
        figures, _ = self.comparison.row(name)
        caption = "%s: %.2f, %.1f %%" % (name, figures[10], 100 * figures[11])
        picture = os.path.join(self.scratch, name + ".png")
        run(["convert", self.frame("ours.bsp"), self.frame("theirs.bsp"), "+append", "PNG24:" + picture], self.scratch)
        print(caption, flush=True)
        return ["-label", caption.replace("%", "%%"), picture]


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("tools", type=os.path.abspath)
    parser.add_argument("out")
    parser.add_argument("--build", default="build")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        rooms = Rooms(options, scratch)
        pairs = [word for name, room in shown().items() for word in rooms.pair(name, room)]
        whole = os.path.join(scratch, "whole.png")
        run(["montage", "-background", "black", "-fill", "white", "-font", "DejaVu-Sans", "-pointsize", "10", *pairs,
             "-geometry", "+2+2", "-tile", "3x", "PNG24:" + whole], scratch)
        run(["convert", whole, "+dither", "-colors", "256", "-define", "png:exclude-chunks=date,time",
             "PNG8:" + os.path.abspath(options.out)], scratch)


if __name__ == "__main__":
    main()

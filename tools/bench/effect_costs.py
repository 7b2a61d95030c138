"""What each effect costs by the pixels that it covers. A scene that does not ask for it pays
nothing, as Plan.HardCaseP5 and bench.UnseenCostsLittle test.

1. Time against covered pixels, from cameras that turn and approach, with a fitted line: a chart for each effect.
2. The time of frames in which all effects own pixels, while everything moves.

usage: tools/measure-frames effects [BUILD]     BUILD: a folder built before, with demo_level (default: build)
Writes BUILD/effects/effect_costs.svg and .json. Takes a minute.
"""
import json
import math
import os
import re
import statistics
import subprocess
import sys

import runs

MAP = os.path.join(runs.ROOT, "tools/effect_costs/all_effects.map")


def without_brush(texture):
    return lambda text: re.sub(r"\{\n(?:\([^\n]* %s 0 0 0 1 1\n)+\}\n" % re.escape(texture), "", text)


def without_key(key):
    return lambda text: re.sub(r'"%s" "[^"]*"\n' % key, "", text)


# Cameras outside the tank of water, and in it.
APPROACHES = [(x, y, 110, yaw, pitch) for x in (-280, -120, 20) for y in (-220, 0, 220) for yaw in (-60, -25, 0, 25, 60)
              for pitch in (0, 15)]
IN_TANK = [(-310, y, z, yaw, pitch) for y in (-60, -30, 0, 30, 60) for z in (100, 120) for yaw in (-6, -3, 0, 3)
           for pitch in (5, 8, 11)]
TOWARD_TANK = [(x, y, 110, yaw, 0) for x in range(-260, 340, 40) for y in (-100, 0, 100) for yaw in (150, 180, 225)]
TIME = "2.9"


class Costs:
    def __init__(self, build):
        self.build = os.path.abspath(build)
        self.work = os.path.join(self.build, "effects")
        self.assets = os.path.join(self.build, "assets")
        os.makedirs(self.work, exist_ok=True)
        self.render = os.path.join(self.build, "bin/oblong-render")
        self.text = open(MAP).read()

    def path(self, name):
        return os.path.join(self.work, name)

    def compile(self, name, changes):
        """Compiles a level from the map with these changes."""
        text = self.text
        for change in changes:
            changed = change(text)
            if changed == text:
                runs.fail("nothing in %s calls for what %s leaves out" % (MAP, name))
            text = changed
        with open(self.path(name + ".map"), "w") as out:
            out.write(text)
        subprocess.run([os.path.join(self.build, "bin/oblong-map"), self.path(name + ".map"), "-o",
                        self.path(name + ".bsp"), "--wad", os.path.join(self.assets, "demo.wad")], check=True)
        return self.path(name + ".bsp")

    def cameras(self, name, rows):
        with open(self.path(name + ".csv"), "w") as out:
            out.write("x,y,z,yaw,pitch\n" + "".join(",".join(map(str, row)) + "\n" for row in rows))
        return self.path(name + ".csv")

    def arguments(self, level, cameras, repeat, *more):
        return [level, "--cameras", cameras, "--palette", os.path.join(self.assets, "palette.lmp"), "--time", TIME,
                "--repeat", str(repeat), *more]

    def frames(self, level, cameras, repeat, *more):
        run = subprocess.run([self.render, *self.arguments(level, cameras, repeat, "--json", "-", *more)],
                             capture_output=True, text=True, check=True)
        return json.loads(run.stdout)


def fitted(points):
    """The slope and offset of the line fitted to points, and the correlation."""
    xs, ys = zip(*points)
    if min(xs) == max(xs) or min(ys) == max(ys):
        return 0, statistics.fmean(ys), 0
    return *statistics.linear_regression(xs, ys), statistics.correlation(xs, ys)


def least_times(costs, level, cameras, runs, *more):
    """The pixels and the least time of several runs, for each effect in each frame."""
    least = {}
    for _ in range(runs):
        for frame in costs.frames(level, cameras, 1, *more)["frames"]:
            for line in frame["effects"]:
                key = (line["name"], frame["camera"])
                pixels, time = least.get(key, (line["pixels"], math.inf))
                least[key] = (pixels, min(time, line["microseconds"]))
    points = {}
    for (name, _), point in least.items():
        points.setdefault(name, []).append(point)
    return points


def times_by_area(costs, level):
    drawn = ["sky", "mirror", "fence", "sprites", "shadows", "particles"]
    points = least_times(costs, level, costs.cameras("approaches", APPROACHES), 15)
    found = {name: points[name] for name in drawn}
    bare = costs.compile("opaque", [without_brush("*water")])
    found["liquid"] = least_times(costs, bare, costs.path("approaches.csv"), 15)["liquid"]
    far_fog = costs.compile("far_fog", [lambda text: text.replace('"fog" "0.05 0.5 0.55 0.65"', '"fog" "0.2 0.5 0.55 0.65 1 350"')])
    found["fog"] = least_times(costs, far_fog, costs.path("approaches.csv"), 15)["fog"]
    tank = costs.compile("tank", [without_key("fog"), without_brush("mirror_hall")])
    found["translucency"] = least_times(costs, tank, costs.cameras("toward_tank", TOWARD_TANK), 15)["translucency"]
    found["underwater"] = []
    for mode in ("160x100", "240x150", "320x200", "400x250", "480x300"):
        in_mode = least_times(costs, tank, costs.cameras("few", IN_TANK[:4]), 8, "--mode", mode)
        found["underwater"] += in_mode["underwater"]
    return found


def chart(name, points, line, left, top):
    width, height, most_x = 220, 130, max(p[0] for p in points) * 1.05
    most_y = max(p[1] for p in points) * 1.1
    place = lambda x, y: (left + x / most_x * width, top + height - y / most_y * height)
    slope, offset, correlation = line
    text = '<text x="%d" y="%d" font-weight="bold">%s</text>' % (left, top - 20, name)
    text += '<text x="%d" y="%d">%.2f ns a pixel + %.1f us, r = %.3f</text>' % (left, top - 6, slope * 1000, offset, correlation)
    text += '<rect x="%d" y="%d" width="%d" height="%d" fill="none" stroke="#999"/>' % (left, top, width, height)
    (x0, y0), (x1, y1) = place(0, max(offset, 0)), place(most_x, offset + slope * most_x)
    text += '<line x1="%.1f" y1="%.1f" x2="%.1f" y2="%.1f" stroke="#c33"/>' % (x0, y0, x1, y1)
    for x, y in points:
        text += '<circle cx="%.1f" cy="%.1f" r="2" fill="#357" fill-opacity="0.6"/>' % place(x, y)
    text += '<text x="%d" y="%d">0</text>' % (left, top + height + 14)
    text += '<text x="%d" y="%d" text-anchor="end">%.0f pixels</text>' % (left + width, top + height + 14, most_x)
    return text + '<text x="%d" y="%d" text-anchor="end">%.0f us</text>' % (left + width, top + 12, most_y)


def report_times(costs, level):
    charts, rows = [], {}
    print("\n%-16s %7s %18s %14s %10s %12s" % ("effect", "frames", "pixels", "ns a pixel", "offset us", "correlation"))
    for index, (name, points) in enumerate(times_by_area(costs, level).items()):
        line = fitted(points)
        rows[name] = {"points": points, "ns_a_pixel": line[0] * 1000, "offset_us": line[1], "correlation": line[2]}
        least, most = min(p[0] for p in points), max(p[0] for p in points)
        print("%-16s %7d %8d to %6d %14.2f %10.1f %12.3f" % (name, len(points), least, most, line[0] * 1000, line[1], line[2]))
        charts.append(chart(name, points, line, 30 + index % 4 * 250, 50 + index // 4 * 200))
    with open(costs.path("effect_costs.svg"), "w") as out:
        out.write('<svg xmlns="http://www.w3.org/2000/svg" width="1030" height="%d" font-family="sans-serif" font-size="11">'
                  '<rect width="100%%" height="100%%" fill="#fff"/>%s</svg>\n' % (40 + (len(charts) + 3) // 4 * 200, "".join(charts)))
    return rows


def time_all(costs, level):
    report = costs.frames(level, costs.cameras("in_tank", IN_TANK), 15, "--time-step", "0.014")
    counts = [len(frame["effects"]) for frame in report["frames"]]
    names = {line["name"] for frame in report["frames"] for line in frame["effects"]}
    times = sorted(f["microseconds"] for f, count in zip(report["frames"], counts) if count == len(names))
    summary = {"frames": len(times), "effects": len(names), "median_us": statistics.median(times),
               "p99_us": times[(len(times) * 99 + 99) // 100 - 1]}
    print("\nall %(effects)d effects in one frame while they move, %(frames)d cameras: median %(median_us).0f us, "
          "99 %% %(p99_us).0f us" % summary)
    return summary


def main():
    if len(sys.argv) > 2 or sys.argv[1:] in (["-h"], ["--help"]):
        sys.exit(__doc__)
    costs = Costs(sys.argv[1] if len(sys.argv) > 1 else os.path.join(runs.ROOT, "build"))
    subprocess.run(["cmake", "--build", costs.build, "--target", "oblong-render", "oblong-map", "demo_level"],
                   check=True, stdout=subprocess.DEVNULL)
    level = costs.compile("all_effects", [])
    found = {"all": time_all(costs, level), "areas": report_times(costs, level)}
    with open(costs.path("effect_costs.json"), "w") as out:
        json.dump(found, out, indent=1)

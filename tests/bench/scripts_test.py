"""The measuring scripts on the demo level: their tables account for all that was counted, and they say what is missing.

usage: scripts_test.py ROOT BUILD OBLONG_RENDER stages|peer|compilers|light
Exit code 77: skipped.
"""
import importlib
import json
import os
import shutil
import stat
import struct
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
ROOT, BUILD, RENDER = sys.argv[1:4]
sys.path.insert(0, os.path.join(ROOT, "tools/bench"))


def check(condition, message):
    if not condition:
        sys.exit("scripts_test: " + message)


def demo(folder, cameras=2):
    """BUILD, and the demo level with a few cameras."""
    with open(os.path.join(ROOT, "assets/demo_cameras.csv")) as file:
        lines = file.read().splitlines()[:cameras + 1]
    path = os.path.join(folder, "cameras.csv")
    with open(path, "w") as file:
        file.write("\n".join(lines) + "\n")
    return [BUILD, os.path.join(BUILD, "assets/demo.bsp"), path]


def run(name, *arguments, **environment):
    return subprocess.run([os.path.join(ROOT, "tools", name), *arguments], capture_output=True, text=True,
                          env={**{k: v for k, v in os.environ.items() if k != "OBLONG_PEER"}, **environment})


def check_stage_costs(folder):
    if not shutil.which("valgrind"):
        print("no valgrind")
        sys.exit(77)
    path = os.path.join(folder, "costs.json")
    ran = run("measure-frames", "stages", "--render", RENDER, "--json", path, *demo(folder))
    check(ran.returncode == 0, "stages: " + ran.stderr)
    with open(path) as file:
        costs = json.load(file)["levels"]["demo"]
    check(abs(sum(costs["stages"].values()) - costs["all"]) < 1e-6 * costs["all"], "the stages do not add up")
    for stage in ("walk and boxes", "transform, clip, project", "edge scan", "coverage", "block set-up", "block fill"):
        check(costs["stages"][stage] > 0.1, "%s costs %g instructions a pixel" % (stage, costs["stages"][stage]))
    check(costs["stages"]["other"] < 0.2 * costs["all"], "a fifth of the instructions is of no stage")

    ran = run("measure-frames", "stages", "--first", "--render", RENDER, *demo(folder))
    check(ran.returncode == 0, "stages --first: " + ran.stderr)
    name, cameras, median, p99, sums, share, _ = ran.stdout.splitlines()[1].split()
    check((name, cameras) == ("demo", "2"), "first pictures of: " + ran.stdout)
    check(1 < float(median) <= float(p99) and float(sums) > 1 and 1 < float(share) < 90, "first pictures light: " + ran.stdout)

    module, place = importlib.import_module("stage_costs"), type("Place", (), {"name": "here"})
    costs = module.Costs(place, {"f": 900, "g": 95, "h": 5}, {"f": {"raster/scan.cpp"}, "g": {"effects/sky.cpp"}}, 10)
    check(costs.stages["edge scan"] == 90 and costs.stages["sky"] == 9.5 and costs.stages["other"] == 0.5, "stages of files")
    try:
        module.Costs(place, {"f": 98, "stray": 2}, {"f": {"raster/scan.cpp"}}, 1)
        check(False, "2 % of the instructions in no stage, and nothing is said")
    except SystemExit as end:
        check("stray" in str(end.code), "what is said of a function without a stage: %s" % end.code)


def make_peer(folder, microseconds):
    """A program that takes so long for every frame."""
    path = os.path.join(folder, "peer")
    with open(path, "w") as file:
        file.write('#!/bin/sh\nwhile [ "$1" != -json ]; do cameras=${cameras:-$2}; shift; done\n'
                   'tail -n +2 "$cameras" | sed "s/.*/%d/" > "$2"\n' % microseconds)
    os.chmod(path, os.stat(path).st_mode | stat.S_IXUSR)
    return path


def check_compare_peer(folder):
    for environment, expected in (({}, "OBLONG_PEER is not set"), ({"OBLONG_PEER": "/no/such"}, "no program there")):
        ran = run("compare-peer", **environment)
        check(ran.returncode == 1 and expected in ran.stderr, "without a peer: %d %s" % (ran.returncode, ran.stderr))
    path = os.path.join(folder, "compared.json")
    ran = run("compare-peer", "--render", RENDER, "--rounds", "2", "--mode", "64x40", "--setting", "bounded", "--setting", "1996",
              "--worst", "1", "--json", path, *demo(folder), OBLONG_PEER=make_peer(folder, 1000000))
    check(ran.returncode == 0, "compare-peer: " + ran.stderr)
    with open(path) as file:
        mode = json.load(file)["modes"]["64x40"]
    for setting in ("bounded", "1996"):
        row = mode["levels"]["all"][setting]
        check(row["frames"] == 2 and row["slower"] == 0, "frames: %s" % row)
        check(abs(row["ratio_median"] * row["median_us"] - 1000000) < 1, "a ratio is not peer / Oblong: %s" % row)
        parts = list(row["ratio_quantiles"].values())
        check(parts == sorted(parts) and parts[0] > 1, "quantiles of the ratio: %s" % parts)
        worst = [line.split() for line in ran.stdout.split(setting + ": frames by ratio")[1].splitlines() if "|" in line][1]
        check(abs(float(worst[2]) - parts[0]) < 0.01, "the worst frame: %s, not of ratio %s" % (worst, parts[0]))
    slower = importlib.import_module("compare_peer").compare([10, 20, 30], [20, 20, 10])
    check(slower["slower"] == 1 and slower["ratio_mean"] == 60 / 50, "a slower frame: %s" % slower)


def make_tools(folder, oblong):
    """A qbsp that is oblong-map, a vis that does nothing, and a light that makes one sample 51 brighter."""
    texts = {"qbsp": 'exec %s "$3" -o "$4" --fast --prt "${4%%.bsp}.prt"' % oblong, "vis": "exit 0",
             "light": "exec python3 -c 'import sys; b = bytearray(open(sys.argv[1], \"rb\").read()); "
                      "i = int.from_bytes(b[68:72], \"little\"); b[i] = (b[i] + 51) % 256; "
                      "open(sys.argv[1], \"wb\").write(b)' \"$4\""}
    for name, text in texts.items():
        path = os.path.join(folder, name)
        with open(path, "w") as file:
            file.write("#!/bin/sh\n" + text + "\n")
        os.chmod(path, os.stat(path).st_mode | stat.S_IXUSR)


def check_compare_ericw(folder):
    oblong = os.path.join(os.path.dirname(RENDER), "oblong-map")
    make_tools(folder, oblong)
    page = os.path.join(folder, "page.md")
    with open(page, "w") as file:
        file.write("before\n<!-- table compilers -->\nold\n<!-- end -->\nafter\n")
    ran = subprocess.run([sys.executable, os.path.join(ROOT, "tools/map/compare_ericw.py"), folder, os.path.join(BUILD, "assets"),
                          "--map", "demo", "--oblong", oblong, "--threads", "2", "--page", page], capture_output=True, text=True)
    check(ran.returncode == 0, "compare_ericw: " + ran.stderr)
    name, figures, times = json.loads(ran.stderr)
    check(name == "demo" and len(times) == 1 and min(times[0]) > 0, "times: %s" % times)
    check(all(figures[i] == figures[i + 1] > 0 for i in (0, 2, 4)), "the same level has other figures: %s" % figures)
    check(1 < figures[6] == figures[7] and figures[8:10] == [0, 0], "the same leaves see others: %s" % figures)
    with open(os.path.join(BUILD, "assets/demo.bsp"), "rb") as file:
        samples = int.from_bytes(file.read()[72:76], "little")
    check(0.5 / samples < figures[11] < 2 / samples, "one sample in %d differs, found %g" % (samples, figures[11]))
    with open(page) as file:
        text = file.read()
    check(text.startswith("before\n") and text.endswith("after\n") and "old" not in text and "| demo |" in text, "page: " + text)


def check_light_picture(folder):
    make_tools(folder, os.path.join(os.path.dirname(RENDER), "oblong-map"))
    picture = os.path.join(folder, "light.png")
    ran = subprocess.run([sys.executable, "-B", os.path.join(ROOT, "tools/map/light_picture.py"), folder, picture,
                          "--build", BUILD], capture_output=True, text=True)
    check(ran.returncode == 0, "light_picture: " + ran.stderr)
    differences = [float(line.split(": ")[1].split(",")[0]) for line in ran.stdout.splitlines()]
    check(len(differences) == 21 and 0 < max(differences) < 0.2, "one sample in a room differs: " + ran.stdout)
    with open(picture, "rb") as file:
        png = file.read()
    width, height = struct.unpack(">2I", png[16:24])
    check(width == 3 * 260 and 7 * 84 < height < 8 * 104 and len(png) < 100000, "not seven rows of pairs")


def main():
    with tempfile.TemporaryDirectory() as folder:
        {"stages": check_stage_costs, "peer": check_compare_peer, "compilers": check_compare_ericw,
         "light": check_light_picture}[sys.argv[4]](folder)


if __name__ == "__main__":
    main()

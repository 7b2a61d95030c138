"""Shared by the measuring scripts: levels with their cameras, and runs of oblong-render, timed or under callgrind."""
import argparse
import csv
import json
import os
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
REAL_LEVELS = ("dm4", "e1m7", "end")


def fail(message):
    sys.exit("%s: %s" % (os.path.basename(sys.argv[0]), message))


class Place:
    """The paths of a level, its cameras and its palette."""

    def __init__(self, name, level, cameras, palette):
        self.name, self.level, self.cameras, self.palette = name, level, cameras, palette
        for path in (level, cameras, palette):
            if not os.path.exists(path):
                fail("%s is not there" % path)

    def thinned(self, most, folder):
        """The same with at most `most` of the cameras, spread over the list."""
        with open(self.cameras, newline="") as file:
            rows = [row for row in csv.reader(file) if row]
        step = -(-(len(rows) - 1) // most)
        path = os.path.join(folder, "cameras_%s_%d.csv" % (self.name, most))
        with open(path, "w", newline="") as file:
            csv.writer(file).writerows([rows[0], *rows[1::step]])
        return Place(self.name, self.level, path, self.palette)

    def camera_count(self):
        with open(self.cameras) as file:
            return sum(1 for line in file if line.strip()) - 1


def shared_folder():
    """The folder with the real levels, in the tests' locations; None if there is none."""
    for folder in (os.path.join(ROOT, "..", "shared"), os.environ.get("OBLONG_SHARED", "")):
        if folder and os.path.isdir(os.path.join(folder, "levels")):
            return folder
    return None


def demo_place(build):
    assets = os.path.join(build, "assets")
    return Place("demo", os.path.join(assets, "demo.bsp"), os.path.join(ROOT, "assets/demo_cameras.csv"),
                 os.path.join(assets, "palette.lmp"))


def real_places():
    shared = shared_folder()
    if not shared:
        return []
    levels = os.path.join(shared, "levels")
    palette = os.path.join(levels, "gfx/palette.lmp")
    return [Place(name, os.path.join(levels, name + ".bsp"), os.path.join(levels, "cameras", name + ".csv"), palette)
            for name in REAL_LEVELS]


def build_and_level(words):
    """[BUILD] [LEVEL CAMERAS [PALETTE]] of a command line: the folder, and the list of the other paths, perhaps empty."""
    if len(words) == 2 or len(words) > 4:
        fail("expected [BUILD] [LEVEL CAMERAS [PALETTE]] (--help)")
    return os.path.abspath(words[0] if words else os.path.join(ROOT, "build")), words[1:]


def parse_arguments(documentation, **wanted):
    """A script's options, with [BUILD] [LEVEL CAMERAS [PALETTE]]: NAME=default, or NAME=type without a default. A list may
    be given several times, False is a switch. Arguments after -- are render_options. --help prints the documentation."""
    own = sys.argv[1:]
    own, render_options = (own[:own.index("--")], own[own.index("--") + 1:]) if "--" in own else (own, [])
    if "-h" in own or "--help" in own:
        print(documentation)
        sys.exit(0)
    parser = argparse.ArgumentParser(usage=documentation, add_help=False)
    parser.add_argument("places", nargs="*")
    for name, default in wanted.items():
        if default is False:
            parser.add_argument("--" + name, action="store_true")
        elif isinstance(default, list):
            parser.add_argument("--" + name, action="append", default=default)
        else:
            is_type = isinstance(default, type)
            parser.add_argument("--" + name, type=default if is_type else type(default), default=None if is_type else default)
    options = parser.parse_args(own)
    options.render_options = render_options
    options.build, options.level_paths = build_and_level(options.places)
    return options


def places(build, level_paths, with_demo):
    """The named level, else the real ones, if they exist."""
    if not level_paths:
        return [demo_place(build), *real_places()] if with_demo else real_places()
    name = os.path.splitext(os.path.basename(level_paths[0]))[0]
    palette = level_paths[2] if len(level_paths) > 2 else os.path.join(build, "assets/palette.lmp")
    return [Place(name, *level_paths[:2], palette)]


def built_render(build):
    subprocess.run(["cmake", "--build", build, "--target", "oblong-render"], check=True, stdout=subprocess.DEVNULL)
    return os.path.join(build, "bin/oblong-render")


def work_folder(build):
    folder = os.path.join(build, "bench")
    os.makedirs(folder, exist_ok=True)
    return folder


def pixels_of(mode):
    width, height = map(int, mode.split("x"))
    return width * height


def render_command(program, place, repeat, mode, options=()):
    return [program, place.level, "--cameras", place.cameras, "--palette", place.palette, "--repeat", str(repeat),
            "--mode", mode, *options]


def report_of(program, place, repeat, mode, options=()):
    """The report of `oblong-render --json`."""
    command = render_command(program, place, repeat, mode, ["--json", "-", *options])
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode != 0:
        fail("%s\n%s" % (" ".join(command), run.stderr))
    return json.loads(run.stdout)


def run_callgrind(command, path, valgrind_options=()):
    """Runs a command under callgrind, which writes its counts to the path."""
    run = subprocess.run(["valgrind", "--tool=callgrind", "--dump-line=no", "--demangle=no",
                          "--callgrind-out-file=" + path, *valgrind_options, *command], capture_output=True, text=True)
    if run.returncode != 0:
        fail("valgrind failed:\n%s" % run.stderr)


def functions_under_callgrind(command, path, valgrind_options=()):
    """Runs a command; returns the instructions by function, by the names in its symbol table."""
    run_callgrind(command, path, valgrind_options)
    return read_callgrind(path)


def read_callgrind(path, with_calls=False):
    """Instructions by function: the lines `POSITION COUNT` below each `fn=`, with or without those of its callees."""
    names, costs, function, is_of_call = {}, {}, None, False
    with open(path) as file:
        for line in file:
            if line.startswith("fn="):
                number, name = re.match(r"fn=\((\d+)\)(?: (.*))?", line).groups()
                function = names.setdefault(number, name)
            elif line.startswith("cfn=") and ") " in line:
                number, name = re.match(r"cfn=\((\d+)\) (.*)", line).groups()
                names.setdefault(number, name)
            elif line.startswith("calls="):
                is_of_call = True
            elif line[0].isdigit() or line[0] in "+-*":
                if function and (with_calls or not is_of_call):
                    name = re.sub(r"'\d+$", "", function)  # the same function in a recursion
                    costs[name] = costs.get(name, 0) + int(line.split()[1])
                is_of_call = False
    return costs


def take_dump(path, number):
    """Instructions by function, with those of its callees, from one of a run's dumps, which is removed."""
    path = "%s.%d" % (path, number)
    costs = read_callgrind(path, with_calls=True)
    os.remove(path)
    return costs


def instructions_by_function(program, place, mode, options, folder):
    """Instructions of one frame of every camera: the difference of runs with more and fewer repeats, so that loading cancels."""
    few, many = 1, 4
    runs = [functions_under_callgrind(render_command(program, place, repeat, mode, options),
                                      os.path.join(folder, "callgrind.out")) for repeat in (few, many)]
    frame = {name: (cost - runs[0].get(name, 0)) / (many - few) for name, cost in runs[1].items()}
    return {name: cost for name, cost in frame.items() if cost > 0}

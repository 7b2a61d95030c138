"""Holds the operations that tools/measure works out against those that the engine's compiled code does.

GCC compiles the engine with a profile (-fprofile-arcs), it draws the cameras of a level, and GCC compiles it again with
what that left behind (-fbranch-probabilities). It then writes down its own form of the code, each block of it with how
often it ran: the operations in a block, times that, are what the code did. Nothing of the sources is interpreted here.
Fails if a part of the frame differs from the model by more than 5 %.

usage: count_operations.py COMPILER SOURCE_DIR BUILD_DIR [LEVEL.bsp CAMERAS.csv]
"""
import collections
import concurrent.futures
import glob
import os
import re
import subprocess
import sys

SETTINGS = ["perspective=bounded", "perspective=affine", "perspective=every16", "perspective=bounded-texels",
            "perspective=exact", "edges=accumulated", "reciprocal=table256-newton1", "light=nearest", "dither=on"]

# The stages of the model that files do the work of. All other files do what the model leaves out.
PARTS = {
    ("nodes",): "visibility/front_to_back visibility/box_culler "
                "visibility/visible_set level/pvs",
    ("vertices", "projection"): "view/screen_polygon",
    ("clipping",): "view/clip",
    ("edges", "edge rows"): "raster/scan",
    ("spans",): "visibility/span_buffer frame/frame frame/claims frame/passes",
    ("gradients",): "view/texture_gradients scene/face_surface surface/surface_cache raster/block_rule",
    ("blocks", "1/z", "pixels"): "raster/texture_blocks raster/perspective_range frame/surface_pass fixed/reciprocal "
                                 "raster/exact_spans raster/kernels/plain",
    ("sky",): "effects/sky view/gradients fixed/root",
    ("lit texels",): "surface/lit_surface",
}
LEFT_OUT = ("left out",)
# What other effects, frames without the span buffer, and lines over frames need: the frames that are counted do not allow them. From the
# libraries of the build.
OF_EFFECTS = re.compile("engine/(draw/|effects/|files/|mesh/|raster/(depth|lines|kernels/(?!plain))|"
                        "scene/(light_styles|texture_animation|pick|"
                        "moving_lights|level_effects)|math/soft_float|"
                        "methods/|"
                        "frame/(fog|light|mirror|model|see_through)_pass|frame/(frame_things|shared_drawing|wireframe))")
BEFORE_FRAMES = re.compile("engine/(level/(bsp|entities|trace|t_junctions)|platform|accuracy|files/files|surface/(palette|colormap|oklab))")
NOT_COUNTED = re.compile("/(sdl|web|dos|library|examples)/")
TOOLS = ["engine/files/arguments.cpp", "tools/render/camera_list.cpp", "tools/measure/operations.cpp",
         "tests/operations/counter/count_operations.cpp"]
LARGEST_DIFFERENCE = 0.05
LARGEST_LEFT_OUT = 0.03  # of all additions

# Functions that headers define are counted where they are called.
FLAGS = ["-std=c++20", "-O1", "-DNDEBUG", "-fno-ivopts"] + [
    word for limit in ("early-inlining-insns", "max-inline-insns-single", "large-function-growth", "inline-unit-growth",
                       "large-unit-insns", "large-stack-frame-growth") for word in ("--param", limit + "=10000")]

KINDS = {"*": "multiplications", "w*": "multiplications", "h*": "multiplications", "/": "divisions", "%": "divisions"}
BLOCK = re.compile(r"^;;   basic block \d+, loop depth \d+(?:, count (\d+) \((?:precise|adjusted))?")
BINARY = re.compile(r"^  \S+ = (\S+) (\+|-|\*|w\*|h\*|/|%|<<|>>|&|\||\^|<|<=|>|>=|==|!=) (\S+);")
OTHER_ADD = re.compile(r"^  (?:if \(|switch \(|\S+ = (?:-|~|ABS|MAX_EXPR|MIN_EXPR|__builtin_c[lt]z))")


def shifts_for(sign, operand):
    """How many shifts and additions a product or quotient by a constant of one or two bits is; None for any other."""
    if not re.fullmatch(r"-?\d+", operand):
        return None
    bits = abs(int(operand)).bit_count()
    return 1 if bits <= 1 else 3 if bits == 2 and sign == "*" else None


def operations_in(dump):
    """Additions, multiplications and divisions in GCC's form of a file, each as often as its block ran."""
    sums = collections.Counter()
    count, divided = 0, set()
    for line in dump:
        if block := BLOCK.match(line):
            count, divided = int(block[1] or 0), set()
        elif binary := BINARY.match(line):
            left, sign, right = binary.groups()
            if sign not in KINDS:
                sums["adds"] += count
            elif shifts := shifts_for(sign, right):
                sums["adds"] += count * shifts
            elif KINDS[sign] == "multiplications" or (left, right) not in divided:
                sums[KINDS[sign]] += count
                divided.add((left, right))  # one division gives the quotient and the rest
        elif OTHER_ADD.match(line):
            sums["adds"] += count
    return sums


def run(*command, **options):
    done = subprocess.run(command, capture_output=True, text=True, **options)
    if done.returncode:
        sys.exit(f"{' '.join(command)}\n{done.stderr}")
    return done.stdout


class CountingBuild:
    """The engine with a profile, a file for each part."""

    def __init__(self, compiler, source, build):
        self.work = f"{build}/operations"
        self.compile = [compiler, *FLAGS, f"-I{source}"]
        self.counted = {}  # by part and profile
        self.pool = concurrent.futures.ThreadPoolExecutor(os.cpu_count())
        os.makedirs(self.work, exist_ok=True)
        parts = {part: [f"engine/{name}.cpp" for name in names.split()] for part, names in PARTS.items()}
        counted = sum(parts.values(), [])
        rest = [file for file in sorted(glob.glob("engine/**/*.cpp", root_dir=source, recursive=True))
                if file not in counted and not NOT_COUNTED.search(file)]
        loading = [file for file in rest if BEFORE_FRAMES.match(file)]
        parts[LEFT_OUT] = [file for file in rest if file not in loading and not OF_EFFECTS.match(file)]
        self.names = {part: part[0].replace("/", "").replace(" ", "_") for part in parts}
        profiled = [[*self.compile, "-fprofile-arcs", "-c", self.write_file(name, parts[part])]
                    for part, name in self.names.items()]
        # Behind the profiled files, whose copies of functions of headers are then the ones that are linked.
        others = [[*self.compile, "-O0", "-c", self.write_file("others", loading + TOOLS)]]
        objects = list(self.pool.map(self.compile_one, profiled + others))
        # Where a room is compiled as one file, its library brings again what is profiled: the first of each name is linked.
        libraries = glob.glob(f"{build}/engine/liboblong_*.a")
        run(compiler, "-fprofile-arcs", *objects, "-Wl,--allow-multiple-definition", "-Wl,--start-group", *libraries,
            "-Wl,--end-group", "-o", "count_operations", cwd=self.work)

    def write_file(self, name, files):
        """A file of all these, by its path."""
        with open(f"{self.work}/{name}.cpp", "w") as out:
            out.writelines(f'#include "{file}"\n' for file in files)
        return out.name

    def compile_one(self, command):
        output = os.path.basename(command[-1])[:-4] + ".o"
        run(*command, "-o", output, cwd=self.work)
        return output

    def count_part(self, part, folder):
        """The operations of a part's file, by the profile in the folder."""
        name = self.names[part]
        with open(f"{folder}/{name}.gcda", "rb") as file:
            key = part, file.read()
        if key not in self.counted:
            run(*self.compile, "-fbranch-probabilities", f"-fdump-tree-optimized-blocks-details={name}.dump", "-c",
                f"{self.work}/{name}.cpp", "-o", f"{name}.o", cwd=folder)
            with open(f"{folder}/{name}.dump") as dump:
                self.counted[key] = operations_in(dump)
        return self.counted[key]

    def count(self, setting, inputs):
        """The operations of a setting's frames: by stage as worked out, and by part as counted."""
        folder = f"{self.work}/{setting}"
        os.makedirs(folder, exist_ok=True)
        for old in glob.glob(f"{folder}/*"):
            os.remove(old)
        lines = run(f"{self.work}/count_operations", *inputs, setting,
                    env={**os.environ, "GCOV_PREFIX": folder, "GCOV_PREFIX_STRIP": str(self.work.count("/"))})
        worked_out = collections.defaultdict(collections.Counter)
        for line in lines.splitlines():
            stage, *numbers = line.split(",")
            worked_out[stage].update(dict(zip(("adds", "multiplications", "divisions"), map(int, numbers))))
        return worked_out, dict(zip(self.names, self.pool.map(lambda part: self.count_part(part, folder), self.names)))


def check(setting, worked_out, counted):
    """Prints a line for each part and kind of operation; returns how many differ by too much."""
    failures = 0
    for part in PARTS:
        for kind in ("adds", "multiplications", "divisions"):
            code, model = counted[part][kind], sum(worked_out[stage][kind] for stage in part)
            is_close = abs(model - code) <= LARGEST_DIFFERENCE * code
            failures += not is_close
            difference = f"{(model - code) / code:+.1%}" if code else ""
            print(f"{setting:28} {', '.join(part):20} {kind:16} {code:>12,} {model:>12,} {difference:>8}"
                  f"{'' if is_close else '  TOO FAR'}")
    share = counted[LEFT_OUT]["adds"] / sum(sums["adds"] for sums in counted.values())
    print(f"{setting:28} left out: {share:.1%} of all additions{'' if share <= LARGEST_LEFT_OUT else '  TOO MANY'}")
    return failures + (share > LARGEST_LEFT_OUT)


def main():
    if len(sys.argv) not in (4, 6):
        sys.exit(__doc__)
    source, build = os.path.abspath(sys.argv[2]), os.path.abspath(sys.argv[3])
    level = sys.argv[4:] or [f"{build}/assets/demo.bsp", f"{source}/assets/demo_cameras.csv"]
    counting = CountingBuild(sys.argv[1], source, build)
    inputs = [f"{build}/assets/palette.lmp", *map(os.path.abspath, level)]
    print(f"{'setting':28} {'part':20} {'kind':16} {'counted':>12} {'worked out':>12} {'':>8}")
    failures = sum(check(setting, *counting.count(setting, inputs)) for setting in SETTINGS)
    sys.exit(f"{failures} figures of tools/measure/operations.cpp are too far from the code" if failures else 0)


if __name__ == "__main__":
    main()

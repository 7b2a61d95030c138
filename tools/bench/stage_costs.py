"""What each stage of a frame costs: instructions a pixel, counted by callgrind.

Subtracts two runs of oblong-render with more and fewer repeats of each frame, so that loading and building surfaces
cancel. A function belongs to the stage of its source file, by the object files' symbol tables, which needs no debug
information. Fails if a function with more than 1 % of the instructions belongs to no stage.

With --first it compares each camera's first picture, most of whose surfaces are not lit yet, with its next one, for all
cameras of a level in order, with the caches as left by earlier ones. Prints the median and the 99th percentile of the
ratios of these pictures, the ratio of their sums, and the share of lighting surfaces in the first pictures.

usage: tools/measure-frames stages [OPTIONS] [BUILD] [LEVEL CAMERAS [PALETTE]]
  BUILD              a folder built before (default: build)
  LEVEL CAMERAS      (default: the demo level, and the real levels where a folder shared/ is there)
  --mode WxH         pixels (default: 320x200)
  --render PROGRAM   that oblong-render of BUILD, as it is (default: built anew if sources changed)
  --most N           cameras of each level (default: 35)
  --first            first pictures against the next
  --functions        also the functions of each stage
  --json FILE        (default: BUILD/bench/stage_costs.json)
  -- OPTION...       further options of oblong-render: -- --accuracy exact
Needs valgrind.
"""
import collections
import json
import os
import re
import statistics
import subprocess

import runs

# The stage of a source file of engine/, by the first matching pattern; and of functions that several files share.
STAGES = [
    ("walk and boxes", r"visibility/(front_to_back|visible_set|brush_models|fragments|eye|box_culler)|"
                       r"level/(side|pvs|bsp_tree|level)|frame/claims"),
    ("transform, clip, project", r"view/(screen_polygon|clip|project|frustum|view|gradients)|math/"),
    ("edge scan", r"raster/(scan|edge)"),
    ("coverage", r"visibility/span_buffer"),
    ("gradients and face constants", r"view/texture_gradients|raster/block_rule|fixed/(reciprocal|root|wide)"),
    ("surface lookup", r"scene/(face_surface|face_table)|surface/|frame/surface_pass"),
    ("block set-up", r"raster/texture_blocks|frame/surface_pass"),
    ("block fill", r"raster/kernels"),
    ("exact spans", r"raster/exact_spans"),
    ("sky", r"effects/sky"),
    ("effects, things, models", r"effects/|mesh/|scene/|raster/depth|view/outline|"
                                r"frame/(face_cover|frame_fog|frame_light|frame_things|mirror_pass|mesh_pass|see_through)"),
    ("other", r"frame/|raster/|accuracy/|fixed/|visibility/|^tools/"),
]
SHARED_FUNCTIONS = [
    ("gradients and face constants", r"make_face_gradients|gradients_of|make_block_thresholds|make_texel_limits"),
    ("walk and boxes", r"BrushModels|VisibleSet|FrontToBack|FacesInView"),
    ("transform, clip, project", r"ClipVertex|VertexCache|ScreenPolygon|to_screen_vertex|Vec3.*View"),
    ("coverage", r"SpanBuffer"),
    ("block set-up", r"SpanTarget|BlockList|TexelBlock"),
    ("exact spans", r"OctaveRow"),
    ("effects, things, models", r"box_around|DepthBuffer|find_facing"),
    ("other", r"^(__)?(mem(cpy|set|move)|(u?div|u?mod|mul)(mod)?ti)|clock_gettime|^operator (new|delete)|malloc|free|^std::"),
]
HOT_SHARE = 0.01


def symbols_of(path):
    listing = subprocess.run(["nm", "--defined-only", path], capture_output=True, text=True, check=True)
    words = [line.split() for line in listing.stdout.splitlines()]
    return [word[2] for word in words if len(word) == 3 and word[1] in "TtWwiu"]


def joined_files(path, root):
    """{file below engine/ or the root: its text} of the sources of a unity object."""
    with open(path[:-2]) as unity:
        names = re.findall(r'#include "(.*)"', unity.read())
    texts = {}
    for name in filter(os.path.exists, names):  # an object may be left from an older build
        with open(name) as file:
            texts[re.sub("^engine/", "", os.path.relpath(name, root))] = file.read()
    return texts


def defining_files(plain, texts):
    """The files that define a function of this name (without arguments; for a lambda, that of the outermost function)."""
    outer = re.sub(r"\(anonymous namespace\)::|\[abi:\w+\]", "", plain).split("::{lambda")[0]
    while re.search(r"<[^<>]*>", outer):
        outer = re.sub(r"<[^<>]*>", "", outer)
    name = outer.split("(")[0].split("::")[-1].split(" ")[-1]
    defines = re.compile(r"^[ \t]*(?!return\b|else\b)[\w:<>,&*\[\] \t]*\b%s\((?:[^;{}]|\{\})*\{" % re.escape(name),
                         re.MULTILINE)
    return {file for file, text in texts.items() if name + "(" in text and defines.search(text)}


def symbol_sources(build):
    """Symbol -> the source files, below engine/ or the root, whose objects define it."""
    sources = collections.defaultdict(set)
    root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..")
    for top in ("engine", "tools/render"):
        for folder, _, files in os.walk(os.path.join(build, top)):
            for path in (os.path.join(folder, name) for name in files):
                if path.endswith(".cxx.o"):
                    texts = joined_files(path, root)
                    plain = plain_names(symbols_of(path))
                    found = {symbol: defining_files(name, texts) for symbol, name in plain.items()}
                elif path.endswith(".cpp.o"):
                    source = re.sub(r".*\.dir/", "" if top == "engine" else "tools/render/", path)[:-2]
                    found = {symbol: {source} for symbol in symbols_of(path)}
                else:
                    continue
                for symbol, names in found.items():  # these rooms belong to no stage
                    sources[symbol] |= {name for name in names if not name.startswith(("draw/", "files/", "methods/"))}
    if not sources:
        runs.fail("no object files in %s: build it first" % build)
    return sources


def plain_names(symbols):
    plain = subprocess.run(["c++filt"], input="\n".join(symbols), capture_output=True, text=True, check=True)
    return dict(zip(symbols, plain.stdout.splitlines()))


def stage_of(plain, files):
    """The stage of a function, or None. A function defined by files of several stages comes from a header."""
    short = plain.replace("oblong::", "").replace("(anonymous namespace)::", "")
    for stage, pattern in SHARED_FUNCTIONS[:1]:  # in a file of mostly another stage
        if re.search(pattern, short):
            return stage
    of_files = {next((stage for stage, pattern in STAGES if re.search(pattern, file)), None) for file in files}
    if len(of_files) == 1:
        return of_files.pop()
    return next((stage for stage, pattern in SHARED_FUNCTIONS if re.search(pattern, short)), None)


class Costs:
    """A level's instructions a pixel, by stage and by function."""

    def __init__(self, place, instructions, sources, pixels):
        self.name = place.name
        self.total = sum(instructions.values()) / pixels
        self.stages = {stage: 0.0 for stage, _ in STAGES}
        self.functions = {stage: [] for stage, _ in STAGES}
        plain = plain_names(list(instructions))
        for symbol, cost in sorted(instructions.items(), key=lambda item: -item[1]):
            stage = stage_of(plain[symbol], sources.get(symbol, ()))
            if stage is None and cost / pixels > HOT_SHARE * self.total:
                runs.fail("%s has %.1f %% of the instructions on %s and belongs to no stage: name its file in STAGES" %
                          (plain[symbol], 100 * cost / pixels / self.total, place.name))
            self.stages[stage or "other"] += cost / pixels
            self.functions[stage or "other"].append((cost / pixels, plain[symbol]))


def mean_of(costs, stage):
    return sum(cost.stages[stage] for cost in costs) / len(costs)


def print_table(costs):
    """A row for each stage, a column for each level, then the mean of the real levels."""
    real = [cost for cost in costs if cost.name != "demo"] or costs
    print("%-30s %s %9s" % ("instructions a pixel", "".join("%9s" % cost.name[:8] for cost in costs), "mean"))
    for stage, _ in STAGES:
        print("%-30s %s %9.2f" % (stage, "".join("%9.2f" % cost.stages[stage] for cost in costs), mean_of(real, stage)))
    print("%-30s %s %9.2f" % ("all", "".join("%9.2f" % cost.total for cost in costs),
                              sum(cost.total for cost in real) / len(real)))


def print_functions(cost):
    print("\n%s" % cost.name)
    for stage, functions in cost.functions.items():
        for instructions, name in functions:
            if instructions > 0.02:
                print("  %8.3f  %-28s %s" % (instructions, stage, name[:110]))


def pairs_of_pictures(program, place, options, folder):
    """For each camera: the instructions of its first picture, those of them for lighting surfaces, those of its next picture."""
    names = [symbol for symbol in symbols_of(program) if "." not in symbol]
    frame, = (symbol for symbol in names if re.match("_ZN6oblong10draw_frame.*ViewSpec", symbol))
    light, = (symbol for symbol in names if symbol.startswith("_ZN6oblong17build_lit_surface"))
    path = os.path.join(folder, "callgrind_first.out")
    command = runs.render_command(program, place, 1, options.mode, options.render_options)
    runs.run_callgrind(command, path, ["--dump-after=" + frame, "--toggle-collect=" + frame])
    for camera in range(place.camera_count()):
        # The second of three pictures is drawn only to count pixels.
        first, _, following = (runs.take_dump(path, 3 * camera + number) for number in (1, 2, 3))
        yield first[frame], first.get(light, 0), following[frame]


def compare_first(program, places, options, folder):
    print("%-8s %8s %31s %30s" % ("level", "cameras", "ratio: median, 99 %, of sums", "of it lighting surfaces"))
    for place in places:
        pairs = list(pairs_of_pictures(program, place, options, folder))
        ratios = sorted(first / following for first, _, following in pairs)
        sums = [sum(parts) for parts in zip(*pairs)]
        p99 = ratios[-(-99 * len(ratios) // 100) - 1]
        print("%-8s %8d %15.2f %7.2f %7.2f %28.1f %%" % (place.name, len(pairs), statistics.median(ratios), p99,
                                                      sums[0] / sums[2], 100 * sums[1] / sums[0]), flush=True)


def main():
    options = runs.parse_arguments(__doc__, mode="320x200", render=str, json=str, most=35, functions=False, first=False)
    build = options.build
    places = runs.places(build, options.level_paths, with_demo=True)
    program = options.render or runs.built_render(build)
    folder = runs.work_folder(build)
    if options.first:
        return compare_first(program, places, options, folder)
    sources = symbol_sources(build)
    costs = []
    for place in places:
        some = place.thinned(options.most, folder)
        instructions = runs.instructions_by_function(program, some, options.mode, options.render_options, folder)
        pixels = runs.pixels_of(options.mode) * some.camera_count()
        costs.append(Costs(some, instructions, sources, pixels))
    print_table(costs)
    for cost in costs if options.functions else ():
        print_functions(cost)
    with open(options.json or os.path.join(folder, "stage_costs.json"), "w") as out:
        json.dump({"mode": options.mode, "options": options.render_options,
                   "levels": {cost.name: {"all": cost.total, "stages": cost.stages} for cost in costs}}, out, indent=1)

"""Compares Oblong with Quake's own software renderer in one run: alternating, with the same levels and cameras.

OBLONG_PEER names the peer's program, which is not in this project: PROGRAM LEVEL CAMERAS PALETTE -r N -m WxH -json FILE
draws every camera's frame N times after an untimed first time, and writes the median of each frame, microseconds, a line
a frame. Every round draws all frames by the peer and by each setting of Oblong, one after the other. A frame's time is
the least of the rounds, as other programs only add to it; no clock is read within a frame. Ratios are peer / Oblong, independent of the machine's speed.

usage: OBLONG_PEER=PROGRAM tools/compare-peer [OPTIONS] [BUILD] [LEVEL CAMERAS [PALETTE]]
  BUILD              a folder built before (default: build)
  LEVEL CAMERAS      (default: the real levels, where a folder shared/ is there)
  --mode WxH         pixels; may be given several times (default: 320x200 and 1280x800)
  --setting NAME     of those below, may be given several times (default: all that this oblong-render has)
  --rounds N         (default: 5)
  --most N           cameras of each level (default: all)
  --render PROGRAM   that oblong-render, as it is (default: BUILD's, built anew if sources changed)
  --worst N          also a histogram of the frames' ratios, and the N frames with the least: where their time goes
  --instructions     also instructions a pixel of both, by callgrind: at most 35 cameras of each level
  --json FILE        (default: BUILD/bench/compare_peer.json)
settings: bounded, no-bmi2, 1996, exact, threads-2
"""
import itertools
import json
import os
import re
import statistics
import subprocess
import sys
import tempfile

import runs

# Name -> options of oblong-render.
SETTINGS = {
    "bounded": [],
    "no-bmi2": ["--instructions", "baseline"],
    "1996": ["--accuracy", "1996"],
    "exact": ["--accuracy", "exact"],
    "threads-2": ["--threads", "2"],
}
TIMED_REPEATS = 5
QUANTILES = (0, 0.001, 0.01, 0.1, 0.5, 0.9)


class Peer:
    def __init__(self, program):
        self.program = program

    def times(self, place, mode, folder):
        path = os.path.join(folder, "peer.txt")
        command = [self.program, place.level, place.cameras, place.palette, "-r", str(TIMED_REPEATS), "-m", mode, "-json", path]
        run = subprocess.run(command, capture_output=True, text=True)
        if run.returncode != 0:
            runs.fail("%s\nexit code %d: %s" % (" ".join(command), run.returncode, run.stderr or run.stdout))
        with open(path) as file:
            return [float(line) for line in file]

    def instructions(self, place, mode, folder):
        """The instructions of one frame of every camera, with its surfaces built."""
        command = [self.program, place.level, place.cameras, place.palette, "-m", mode, "-cg"]
        counts = runs.functions_under_callgrind(command, os.path.join(folder, "callgrind.out"),
                                                ["--instr-atstart=no", "--collect-atstart=no"])
        return sum(counts.values())


def find_peer():
    program = os.environ.get("OBLONG_PEER")
    if not program:
        runs.fail("OBLONG_PEER is not set: it names the program to compare with (--help)")
    if not os.access(program, os.X_OK) or os.path.isdir(program):
        runs.fail("OBLONG_PEER=%s: no program there" % program)
    return Peer(os.path.abspath(program))


def available_settings(program, wanted):
    """The settings whose options this oblong-render has, or `wanted`, which must be among them."""
    text = subprocess.run([program, "--help"], capture_output=True, text=True, check=True).stdout
    known = [name for name, options in SETTINGS.items() if all(re.search(option + r"\b", text) for option in options[::2])]
    for name in wanted:
        if name not in SETTINGS:
            runs.fail("--setting %s: expected one of %s" % (name, ", ".join(SETTINGS)))
        if name not in known:
            runs.fail("--setting %s: %s has no option %s" % (name, program, SETTINGS[name][0]))
    return wanted or known


def own_frames(program, place, mode, setting, *more):
    return runs.report_of(program, place, TIMED_REPEATS, mode, [*SETTINGS[setting], *more])["frames"]


def measure(peer, program, places, mode, settings, rounds, folder):
    """For each level: name -> the times of its frames, the least of the rounds, with `peer` as the peer's name."""
    names = ["peer", *settings]
    taken = {place.name: {name: [] for name in names} for place in places}
    for turn in range(rounds):
        for place in places:
            for i in range(len(names)):
                name = names[(turn + i) % len(names)]  # rotates which one is first
                if name == "peer":
                    times = peer.times(place, mode, folder)
                else:
                    times = [frame["microseconds"] for frame in own_frames(program, place, mode, name, "--whole-frames")]
                if len(times) != place.camera_count():
                    runs.fail("%s: %d times of %d frames from %s" % (place.name, len(times), place.camera_count(), name))
                taken[place.name][name].append(times)
        print("\r%s: round %d of %d" % (mode, turn + 1, rounds), end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    return {level: {name: [min(frame) for frame in zip(*all_rounds)] for name, all_rounds in of.items()}
            for level, of in taken.items()}


def quantile(values, part):
    values = sorted(values)
    return values[min(int(len(values) * part), len(values) - 1)]


def compare(peer_times, times):
    ratios = [theirs / ours for theirs, ours in zip(peer_times, times)]
    return {
        "frames": len(times),
        "peer_median_us": statistics.median(peer_times),
        "median_us": statistics.median(times),
        "p99_us": quantile(times, 0.99),
        "ratio_median": statistics.median(peer_times) / statistics.median(times),
        "ratio_mean": sum(peer_times) / sum(times),
        "ratio_p99": quantile(peer_times, 0.99) / quantile(times, 0.99),
        "slower": sum(ratio < 1 for ratio in ratios),
        "ratio_quantiles": {str(part): quantile(ratios, part) for part in QUANTILES},
    }


def print_row(level, setting, row):
    print("%-8s %-10s %7.1f %7.1f %7.1f | %6.2f %6.2f %6.2f | %5d of %5d | %s" % (
        level, setting, row["peer_median_us"], row["median_us"], row["p99_us"], row["ratio_median"], row["ratio_mean"],
        row["ratio_p99"], row["slower"], row["frames"], " ".join("%5.2f" % value for value in row["ratio_quantiles"].values())))


def report(mode, times, settings):
    """The rows of each level and of all frames together."""
    print("\n%s: microseconds a frame; ratio = peer / Oblong" % mode)
    print("%-8s %-10s %7s %7s %7s | %6s %6s %6s | %14s | %s" % (
        "level", "setting", "peer", "median", "99 %", "median", "mean", "99 %", "slower frames",
        "ratio of the frames: least, 0.1 %, 1 %, 10 %, median, 90 %"))
    everything = {name: [time for of in times.values() for time in of[name]] for name in ["peer", *settings]}
    rows = {}
    for level, of in [*times.items(), ("all", everything)]:
        rows[level] = {setting: compare(of["peer"], of[setting]) for setting in settings}
        for setting, row in rows[level].items():
            print_row(level, setting, row)
    return rows


def report_worst(times, frames, setting, count):
    """How the ratios of the frames are spread, and what the frames with the least have and spend."""
    found = sorted((theirs / ours, theirs, ours, level, number) for level, of in times.items()
                   for number, (theirs, ours) in enumerate(zip(of["peer"], of[setting])))
    print("\n%s: frames by ratio" % setting)
    for step, bin_of in itertools.groupby(found, lambda row: min(int(row[0] * 4), 24)):
        frames_in_bin = len(list(bin_of))
        print("%s %5.2f %5d %s" % ("from" if step == 24 else "    ", step / 4, frames_in_bin,
                                   "#" * -(-60 * frames_in_bin // len(found))))
    print("%-12s %5s %6s %6s | %7s %5s %6s %6s %9s | microseconds" % (
        "frame", "ratio", "peer", "us", "visited", "drawn", "spans", "blocks", "divisions"))
    for ratio, theirs, ours, level, number in found[:count]:
        frame = frames[level][number]
        counts, passes = frame["counts"], sorted(frame["passes"], key=lambda one: -one["microseconds"])
        print("%-12s %5.2f %6.0f %6.0f | %7d %5d %6d %6d %9d | %s" % (
            "%s %d" % (level, number), ratio, theirs, ours, counts["faces_visited"], counts["faces_drawn"], counts["spans"],
            counts["blocks"], counts["divisions"], ", ".join("%s %.0f" % (one["name"], one["microseconds"]) for one in passes[:4])))


def count_instructions(peer, program, places, mode, settings, folder):
    """By level, the instructions a pixel of the peer and of every setting except those of several threads."""
    counts = {}
    for place in (place.thinned(35, folder) for place in places):
        pixels = runs.pixels_of(mode) * place.camera_count()
        counts[place.name] = {"peer": peer.instructions(place, mode, folder) / pixels}
        for setting in settings:
            if "--threads" not in SETTINGS[setting]:
                functions = runs.instructions_by_function(program, place, mode, SETTINGS[setting], folder)
                counts[place.name][setting] = sum(functions.values()) / pixels
    print("\n%s: instructions a pixel" % mode)
    for level, of in counts.items():
        print("%-8s %s" % (level, "   ".join("%s %.2f" % (name, count) for name, count in of.items())))
    return counts


def main():
    options = runs.parse_arguments(__doc__, mode=[], setting=[], rounds=5, most=int, worst=0, render=str, json=str, instructions=False)
    peer = find_peer()
    places = runs.places(options.build, options.level_paths, with_demo=False)
    if not places:
        runs.fail("no folder shared/ with the real levels: name LEVEL and CAMERAS")
    program = options.render or runs.built_render(options.build)
    folder = runs.work_folder(options.build)
    settings = available_settings(program, options.setting)
    if options.most:
        places = [place.thinned(options.most, folder) for place in places]
    found = {}
    with tempfile.TemporaryDirectory() as scratch:
        for mode in options.mode or ["320x200", "1280x800"]:
            times = measure(peer, program, places, mode, settings, options.rounds, scratch)
            found[mode] = {"levels": report(mode, times, settings), "times_us": times}
            if options.worst:
                for setting in settings:
                    frames = {place.name: own_frames(program, place, mode, setting) for place in places}
                    report_worst(times, frames, setting, options.worst)
            if options.instructions:
                found[mode]["instructions"] = count_instructions(peer, program, places, mode, settings, scratch)
    with open(options.json or os.path.join(folder, "compare_peer.json"), "w") as out:
        json.dump({"rounds": options.rounds, "modes": found}, out)

"""Counts the instructions of frames, and fits prices of their events to them: engine/costs/prices.h.

Builds the engine with draw_frames (counter/) for an i486 and for x86-64, draws cameras of levels by the presets and by
every setting of every dial, with surfaces built and unbuilt, under qemu-user with a plugin that counts instructions by
mnemonic and operands, and finds the prices, none negative, with the least squares of relative errors. Cycles are of the
i486 build's instructions by CYCLES.

usage: costs.py fit SOURCE_DIR BUILD_DIR [LEVEL.bsp CAMERAS.csv PALETTE.lmp]...   writes SOURCE_DIR/engine/costs/prices.h
       costs.py check SOURCE_DIR BUILD_DIR   fails if prices are off by more than prices.h says, on other frames
Needs qemu-user, g++ for x86-64, g++-i686-linux-gnu, cmake, ninja; without them exits with 77.
"""
import collections
import concurrent.futures
import os
import re
import shutil
import subprocess
import sys

# By build, as a release and as that for DOS: its compiler and flags, its emulator, the number of getppid().
BUILDS = {"x86-64": ("g++", "-O3", ["qemu-x86_64", "-cpu", "max"], 110),
          "i486": ("i686-linux-gnu-g++", "-O2 -march=i486 -mtune=i486 -fno-pie -no-pie -fcf-protection=none", ["qemu-i386"], 64)}
CURRENCIES = 5  # instructions of x86-64 and i486, cycles of a 386, 486 and Pentium
PRESETS = ["1991", "1994", "1996", "pixel", "bounded", "exact"]
RECIPROCALS = ["table256", "table256-newton1", "table1024-newton1", "table256-newton2"]
# Settings of dials whose frames run other code than any preset's, or have other numbers of events; dials that only round run the same.
PRESET_VARIANTS = PRESETS + [f"{preset}+none" for preset in PRESETS]
VARIANTS = (PRESET_VARIANTS +
            [f"bounded+perspective={way}" for way in ("affine", "every32", "every16", "every8", "bounded-texels", "exact")] +
            [f"bounded+pixel-bound={bound}" for bound in ("4", "0.125", "0.03125")] +
            [f"bounded+perspective=bounded-texels+texel-bound={bound}" for bound in ("4", "1", "0.125", "0.03125")] +
            [f"{preset}+reciprocal={way}" for preset in ("bounded", "bounded+perspective=every8", "bounded+perspective=bounded-texels",
                                                         "exact") for way in RECIPROCALS] +
            ["bounded+edges=accumulated", "exact+edges=accumulated", "bounded+light=nearest", "bounded+dither=on", "1996+dither=on",
             "bounded+light=nearest+dither=on", "bounded+mip=none", "bounded+mip=span", "bounded+mip-bias=2", "bounded+mip-bias=-1",
             "bounded+t-junctions=open", "bounded+subpixel-bits=0", "bounded+shades=16"])

CHECKED = PRESET_VARIANTS + ["bounded+perspective=every8", "bounded+perspective=bounded-texels", "bounded+reciprocal=table256-newton1",
                           "bounded+pixel-bound=0.125", "bounded+edges=accumulated", "bounded+light=nearest", "bounded+dither=on"]
COLOURED = ["bounded", "pixel", "exact", "bounded+light=nearest", "bounded+dither=on"]  # of a level with coloured light

# Cycles of a 386, a 486 and a Pentium: of registers, more if memory is read, more if it is read and written. From Intel's
# manuals of the 80386 and i486 as HelpPC's tables give them, and Agner Fog's of the Pentium. Products and scans take a
# time that depends on the operand: the mean of its range. Conditional jumps are taken half of the times.
CYCLES = {
    "mov": ((2, 1, 1), (2, 0, 0), (0, 0, 0)), "lea": ((2, 1, 1),) + ((0, 0, 0),) * 2,
    "add sub and or xor adc sbb cmp test inc dec neg not": ((2, 1, 1), (4, 1, 1), (5, 2, 2)),
    "shl shr sar rol ror": ((3, 2, 1), (4, 2, 2), (4, 2, 2)), "shld shrd": ((3, 3, 4), (4, 1, 1), (4, 1, 1)),
    "mul imul": ((24, 28, 10), (3, 0, 1), (3, 0, 1)), "div": ((38, 40, 41), (3, 0, 0), (3, 0, 0)),
    "idiv": ((43, 43, 46), (3, 1, 0), (3, 1, 0)), "cltd cwtl cwtd": ((2, 3, 2),) * 3,
    "movzb movzw movsb movsw": ((3, 3, 3), (3, 0, 0), (3, 0, 0)), "set": ((4, 4, 1), (1, 0, 1), (1, 0, 1)),
    "push": ((2, 1, 1), (3, 3, 1), (3, 3, 1)), "pop": ((4, 4, 1), (1, 2, 2), (1, 2, 2)), "leave": ((4, 5, 3),) * 3,
    "j": ((6, 2, 1),) * 3, "jmp call": ((9, 3, 1),) * 3, "ret": ((12, 5, 2),) * 3, "bsf": ((34, 24, 24), (0, 1, 0), (0, 1, 0)),
    "bsr": ((58, 55, 39), (0, 1, 0), (0, 1, 0)), "rep": ((4, 3, 1),) * 3, "bt": ((3, 3, 4), (9, 0, 0), (9, 0, 0)),
    "xchg": ((3, 3, 3), (2, 2, 0), (2, 2, 0)), "nop": ((3, 1, 1),) * 3, "cld std": ((2, 2, 2),) * 3}
TIMES = {name: times for names, times in CYCLES.items() for name in names.split()}
FORMER = 0.1  # the weight of a price that was, beside that of the frames
LARGEST_UNKNOWN = 0.03  # of a frame's instructions: one in a loop across a page's end, where the plugin sees no name; the C library's


def times_of(mnemonic):
    """The times of an instruction as the plugin names it, "movl", "setne", "jae"; None if there are none."""
    for name in (mnemonic, mnemonic[:-1], mnemonic[:3] if mnemonic.startswith("set") else mnemonic[:1]):
        if name in TIMES:
            return TIMES[name]
    return None


def cycles_of(mnemonic, operands):
    """Cycles of a 386, a 486 and a Pentium; None if it is not known."""
    times = times_of(mnemonic)
    if not times:
        return None
    reads = "m" in operands and not mnemonic.startswith(("j", "call", "lea"))
    writes = operands.endswith("m") and not mnemonic.startswith(("cmp", "test", "push"))
    if mnemonic[:-1] == "mov" and writes:
        return times[0]  # stores only
    more = times[2] if writes else times[1] if reads else (0, 0, 0)
    if len(set(times)) == 1 or not (reads or writes):
        return times[0]
    return tuple(map(sum, zip(times[0], more)))


def run(*command, **options):
    done = subprocess.run(command, capture_output=True, text=True, **options)
    if done.returncode:
        sys.exit(f"{' '.join(command)}\n{done.stdout}{done.stderr}")
    return done


class Counter:
    """Programs that draw, and the plugin that counts."""

    def __init__(self, source, build):
        needed = ["cmake", "ninja", "cc"] + [word for compiler, _, emulator, _ in BUILDS.values() for word in (compiler, emulator[0])]
        if missing := [name for name in needed if not shutil.which(name)]:
            print("missing:", *missing)
            sys.exit(77)
        self.work = f"{build}/operations"
        os.makedirs(self.work, exist_ok=True)
        here = os.path.dirname(os.path.abspath(__file__))
        run("cc", "-shared", "-fPIC", "-O2", "-o", f"{self.work}/plugin.so", f"{here}/plugin.c")
        for name, (compiler, flags, _, _) in BUILDS.items():
            run("cmake", "-S", f"{here}/counter", "-B", f"{self.work}/{name}", "-G", "Ninja", "-DCMAKE_SYSTEM_NAME=Generic",
                f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_CXX_FLAGS={flags}")
            run("ninja", "-C", f"{self.work}/{name}")

    def count(self, name, level, which, settings):
        """Of each frame: the setting, "warm" or "cold", its events, and by mnemonic and operands its instructions."""
        bsp, cameras, palette = level
        _, _, emulator, call = BUILDS[name]
        done = run(*emulator, "-plugin", f"{self.work}/plugin.so,call={call}", f"{self.work}/{name}/draw_frames", palette, bsp,
                   cameras, *map(str, which), *settings)
        parts = done.stderr.split("END\n")[1::2]  # every other one is of what ran between frames
        for line, part in zip(done.stdout.splitlines(), parts, strict=True):
            setting, kind, *events = line.split()
            kinds = {}
            for count, mnemonic, *operands in (row.split(" ") for row in part.splitlines()):
                kinds[mnemonic, "".join(operands)] = int(count)
            yield setting, kind, list(map(int, events)), kinds

    def paid(self, name, level, which, settings):
        """Of each frame: the level's name, the setting, "warm" or "cold", its events, what it cost in each currency.
        `which` cameras: the first one and the distance to the next."""
        here, i486 = (list(self.count(build, level, which, settings)) for build in BUILDS)
        for (setting, kind, events, x86), (_, _, same, kinds) in zip(here, i486, strict=True):
            if any(abs(one - other) > 0.001 * one for one, other in zip(events, same)):
                sys.exit(f"{setting}: the builds count other events: {events} {same}")
            cycles, unknown = [0, 0, 0], 0
            for (mnemonic, operands), count in kinds.items():
                times = cycles_of(mnemonic, operands)
                unknown += 0 if times else count
                cycles = [sum_ + count * time for sum_, time in zip(cycles, times or (2, 1, 1))]
            instructions = sum(kinds.values())
            if unknown > LARGEST_UNKNOWN * instructions:
                sys.exit(f"{setting}: {unknown} of {instructions} instructions have no cycles in CYCLES")
            yield name, setting, kind, events, [sum(x86.values()), instructions, *cycles]


def fit(rows, costs, former):
    """Prices, none negative, with the least squares of relative errors: descent by one price after the other. Where frames do not tell
    two events apart, the former prices decide."""
    count = len(rows[0])
    square = [[0.0] * count for _ in range(count)]
    right = [0.0] * count
    for row, cost in zip(rows, costs):
        relative = [(i, value / cost) for i, value in enumerate(row) if value]
        for i, value in relative:
            right[i] += value
            for k, other in relative:
                square[i][k] += value * other
    for i, price in enumerate(former):
        right[i] += FORMER * square[i][i] * price
        square[i][i] *= 1 + FORMER
    prices = [0.0] * count
    for _ in range(20000):
        change = 0.0
        for i in range(count):
            if square[i][i] == 0:
                continue
            price = max(0.0, prices[i] + (right[i] - sum(map(float.__mul__, square[i], prices))) / square[i][i])
            change = max(change, abs(price - prices[i]) * square[i][i] ** 0.5)
            prices[i] = price
        if change < 1e-6:
            break
    return prices


def errors_of(frames, prices):
    """By level, setting and kind: for each currency, by what per cent the prices' sum over its frames is off."""
    sums = collections.defaultdict(lambda: [[0.0, 0.0] for _ in range(CURRENCIES)])
    for level, setting, kind, events, costs in frames:
        for pair, cost, price in zip(sums[level, setting, kind], costs, prices):
            pair[0] += cost
            pair[1] += sum(map(float.__mul__, map(float, events), price))
    return {key: [100 * (priced / cost - 1) for cost, priced in pairs] for key, pairs in sums.items()}


def largest(errors):
    """For each currency."""
    return [max(map(abs, column)) for column in zip(*errors)]


def is_preset(key):
    return key[1].split("+")[0] == key[1].removesuffix("+none") and key[2] == "warm"


def numbers(values, form):
    return ", ".join(format(value, form) for value in values)


def write_prices(path, prices, errors):
    """Puts prices and their errors between the lines of the file that say so."""
    with open(path) as file:
        text = file.read()
    names = re.findall(r'\{"([^"]+)", \{', text)
    rows = "".join(f'    {{"{name}", {{{numbers([10 * price for price in row], ".0f")}}}}},\n' for name, row in zip(names, zip(*prices), strict=True))
    by_preset = {}
    for key, value in sorted(errors.items()):
        if is_preset(key):
            by_preset.setdefault(key[1], []).append(value)
    lines = [f"//   {preset:13} {numbers(largest(values), '4.1f')}\n" for preset, values in sorted(by_preset.items())]
    lines += [f"// presets, at most: {numbers(largest(value for key, value in errors.items() if is_preset(key)), '.1f')}\n",
              f"// any setting, at most: {numbers(largest(errors.values()), '.1f')}\n"]
    text = re.sub(r"(?<=per cent:\n)(//.*\n)*", lambda _: "".join(lines), text)
    text = re.sub(r"(?<=kPrices\{\{\n)(    \{.*\n)*", lambda _: rows, text)
    with open(path, "w") as file:
        file.write(text)


def read_prices(path):
    """Prices by currency; the largest errors said beside them of presets and of any setting."""
    with open(path) as file:
        text = file.read()
    rows = [[float(price) / 10 for price in row.split(",")] for row in re.findall(r'\{"[^"]+", \{(.*?)\}\}', text, re.S)]
    said = [list(map(float, row.split(","))) for row in re.findall(r"at most: (.*)", text)]
    return list(zip(*rows)), said


def fit_all(counter, path, levels):
    """Fits to the first, third ... cameras; errors are of these and of some of the others."""
    def frames_of(name):
        if name == "coloured":  # else what it shares with the demo level would count twice
            return [list(counter.paid(name, levels[name], which, COLOURED)) for which in ((0, 6), (3, 6), (1, 4))]
        demo = name == "demo"
        return [list(counter.paid(name, levels[name], which, settings)) for which, settings in (
            ((0, 2 if demo else 40), PRESET_VARIANTS), ((0, 6 if demo else 170), VARIANTS[len(PRESET_VARIANTS):]),
            ((1, 4) if demo else (21, 84), VARIANTS if demo else PRESET_VARIANTS))]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        counted = list(pool.map(frames_of, levels))
    fitted = [frame for presets, variants, _ in counted for frame in presets + variants]
    former, _ = read_prices(path)
    prices = [fit([frame[3] for frame in fitted], [frame[4][i] for frame in fitted], former[i]) for i in range(CURRENCIES)]
    prices = [[round(price, 1) for price in row] for row in prices]  # as they are written
    errors = errors_of(fitted, prices)
    for key, held_out in errors_of([frame for _, _, others in counted for frame in others], prices).items():
        errors[key] = [max(pair, key=abs) for pair in zip(held_out, errors[key])]
    write_prices(path, prices, errors)


def check(counter, path, levels):
    """Whether the prices are as near to counted frames as they say they are."""
    prices, (of_presets, of_any) = read_prices(path)
    failures = 0
    frames = (frame for name, level in levels.items()
              for frame in counter.paid(name, level, (1, 4), CHECKED if name == "demo" else COLOURED))
    for key, errors in errors_of(frames, prices).items():
        said = of_presets if is_preset(key) else of_any
        is_far = any(abs(error) > most + 0.1 for error, most in zip(errors, said))  # as both are rounded
        failures += is_far
        print(f"{key[0]:9}{key[1]:40} {key[2]:5} {numbers(errors, '+6.1f')} %{'  TOO FAR' if is_far else ''}")
    sys.exit(f"{failures} settings' prices in {path} are further off than it says" if failures else 0)


def coloured(demo, source, build):
    """The demo level with lamps of three colours in turn."""
    with open(f"{source}/assets/demo.map") as file:
        parts = file.read().replace('"wad" "..', f'"wad" "{source}').split('"classname" "light')
    colours = ['"_color" "255 90 60"\n', '"_color" "70 110 255"\n', '"_color" "90 255 120"\n']
    text = parts[0] + "".join(f'{colours[i % 3]}"classname" "light{part}' for i, part in enumerate(parts[1:]))
    name = f"{build}/operations/coloured"
    with open(f"{name}.map", "w") as file:
        file.write(text)
    run(f"{build}/bin/oblong-map", f"{name}.map", "--fast", "--game", f"{source}/assets", "--out", f"{name}.bsp")
    return f"{name}.bsp", *demo[1:]


def main():
    if len(sys.argv) < 4 or sys.argv[1] not in ("fit", "check") or len(sys.argv) % 3 != 1 or (sys.argv[1] == "check" and len(sys.argv) > 4):
        sys.exit(__doc__)
    source, build = map(os.path.abspath, sys.argv[2:4])
    path = f"{source}/engine/costs/prices.h"
    demo = f"{build}/assets/demo.bsp", f"{source}/assets/demo_cameras.csv", f"{build}/assets/palette.lmp"
    counter = Counter(source, build)
    lamps = coloured(demo, source, build)
    if sys.argv[1] == "check":
        check(counter, path, {"demo": demo, "coloured": lamps})
    more = [sys.argv[i:i + 3] for i in range(4, len(sys.argv), 3)]
    fit_all(counter, path, {"demo": demo, "coloured": lamps, **{os.path.basename(level[0])[:-4]: level for level in more}})


if __name__ == "__main__":
    main()

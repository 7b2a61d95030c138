"""Holds what frames take for what nobody sees to a bound: instructions, counted by callgrind.

Each picture is drawn twice: as usual, and with only the effects allowed that own pixels of it (unseen/draw_unseen.cpp,
which checks that both are the same bytes). What the first takes more went to things that own none.

usage: unseen_costs.py ROOT BUILD DRAW_UNSEEN demo|real [DIRECTIONS]
Exit code 77: skipped, without valgrind or without the levels.
"""
import glob
import os
import shutil
import sys
import tempfile

sys.dont_write_bytecode = True
ROOT, BUILD, PROGRAM = sys.argv[1:4]
sys.path.insert(0, os.path.join(ROOT, "tools/bench"))
import runs  # noqa: E402

# Of all instructions; directions at each camera; of how many cameras.
BOUNDS = {"demo": (0.0062, 12, 1000), "real": (0.0014, 1, 60)}


def instructions(place, directions, folder):
    """Of each of a place's cameras: as usual, and with the owning effects only."""
    path = os.path.join(folder, place.name)
    runs.run_callgrind([PROGRAM, place.level, place.cameras, place.palette, str(directions)], path,
                       ["--dump-after=end_place", "--toggle-collect=draw_all_effects", "--toggle-collect=draw_owning_effects"])
    for number in range(1, place.camera_count() + 1):
        costs = runs.read_callgrind("%s.%d" % (path, number), with_calls=True)
        yield costs["draw_all_effects"], costs["draw_owning_effects"]


def check(place, bound, directions, folder):
    """Prints what a place's pictures take; whether that is within the bound."""
    counted = list(instructions(place, directions, folder))
    usual, owning = map(sum, zip(*counted))
    print("%s: %d pictures, %d instructions each, %+.3f %% beyond those of what owns pixels; the most:"
          % (place.name, len(counted) * directions, usual // len(counted) // directions, 100 * (usual / owning - 1)))
    for number, (all_effects, seen) in sorted(enumerate(counted), key=lambda row: -row[1][0] / row[1][1])[:5]:
        print("    camera %d: %+.2f %%" % (number, 100 * (all_effects / seen - 1)))
    return usual <= (1 + bound) * owning


def main():
    kind = sys.argv[4]
    bound, directions, most = BOUNDS[kind]
    directions = int(sys.argv[5]) if len(sys.argv) > 5 else directions
    places = runs.real_places() if kind == "real" else [runs.demo_place(BUILD)]
    if not places or not shutil.which("valgrind"):
        print("no valgrind, or no levels in shared/")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        held = [check(place.thinned(most, folder), bound, directions, folder) for place in places]
    if not all(held):
        sys.exit("more than %g %% went to what owns no pixel" % (100 * bound))


if __name__ == "__main__":
    main()

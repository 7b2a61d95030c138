"""Compiles the engine for Windows by MinGW, as far as code: all rooms but what asks POSIX (engine/io/system.cpp) and devices.

usage: compile_for_windows.py SOURCE_DIR
Needs g++-mingw-w64-x86-64-posix; without it exits with 77.
"""
import glob
import os
import shutil
import subprocess
import sys
import tempfile

COMPILER = "x86_64-w64-mingw32-g++-posix"
# Other people's headers that are the same everywhere.
HEADERS = ["stb", "CLI", "nlohmann", "tiny_obj_loader.h", "png.h", "pngconf.h", "pnglibconf.h", "zlib.h", "zconf.h"]


def main():
    (source,) = sys.argv[1:]
    if not shutil.which(COMPILER):
        print(f"not compiled for Windows: no {COMPILER}, expected the Debian package g++-mingw-w64-x86-64-posix")
        sys.exit(77)
    rooms = sorted({os.path.dirname(path) for path in glob.glob(f"{source}/engine/**/*.cpp", recursive=True)})
    with tempfile.TemporaryDirectory() as headers:
        for name in HEADERS:
            found = [path for path in glob.glob(f"/usr/include/{name}") + glob.glob(f"/usr/include/*/{name}")]
            os.symlink(found[0], f"{headers}/{name}")
        for room in rooms:
            name = os.path.relpath(room, f"{source}/engine")
            if name.startswith(("platform/", "pictures/", "examples")):
                continue
            unit = "".join(f'#include "{path}"\n' for path in sorted(glob.glob(f"{room}/*.cpp"))
                           if not path.endswith("engine/io/system.cpp"))
            subprocess.run([COMPILER, "-std=c++20", "-fsyntax-only", "-xc++", "-", f"-I{source}", "-isystem", headers,
                            '-DOBLONG_VERSION="0"', '-DOBLONG_ASSETS_FROM_PROGRAMS="assets"', "-DTINYOBJLOADER_USE_DOUBLE"],
                           input=unit, text=True, check=True)
            print(f"{name} compiles for Windows")


main()

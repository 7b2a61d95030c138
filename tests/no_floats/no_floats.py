"""No floating point in engine/, shown in four ways (files, which write numbers out, OGG and the SDL door excepted):

1. no source says float or double, or has a number with a point in it;
2. every file compiles with -mgeneral-regs-only, a compiler that has no floating-point registers to use;
3. what comes out calls none of the compiler's software floating point;
4. the inner loops, compiled as usual, hold no floating-point instruction.

usage: no_floats.py COMPILE_COMMANDS.json SOURCE_DIR
"""
import concurrent.futures
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile

EXCEPTED = ("engine/io/", "engine/reference/", "engine/measure/", "engine/pictures/", "engine/models/", "engine/programs/", "engine/platform/sdl/",
            "engine/library/ogg.cpp")
KERNELS = "engine/raster/kernels/"

# __muldf3, __floatsidf, __fixsfdi, __extendsftf2 ...: GCC internals manual, "Routines for floating point emulation".
SOFTWARE_FLOAT = re.compile(r"\bU (__\w*(?:sf|df|xf|tf|hf|bf)\w*)")
ARITHMETIC = (r"v?(?:add|sub|mul|div|sqrt|min|max|cmp\w*?|u?comi|round|rcp|rsqrt|hadd|hsub|addsub|dp|fn?m(?:add|sub)\d*)"
              r"(?:ss|sd|ps|pd)")
FLOAT_INSTRUCTION = re.compile(r"^\s*[0-9a-f]+:\t(?:[a-z]+ )*(" + ARITHMETIC + r"|v?cvt\w+|f[a-z]\w*)\b")

COMMENT_OR_TEXT = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.S)
FLOAT_WORD = re.compile(r"\b(?:float|double|long double)\b|(?<![\w.'])\d[\d']*\.\d*|(?<![\w.)\]])\.\d+")


def float_words(source_text):
    """Floating-point types and numbers in a source, outside comments and quoted texts."""
    return FLOAT_WORD.findall(COMMENT_OR_TEXT.sub(" ", source_text))


def float_instructions(disassembly):
    """The floating-point instructions in the output of objdump -d --no-show-raw-insn."""
    return [line.strip() for line in disassembly.splitlines() if FLOAT_INSTRUCTION.match(line)]


def software_floats(symbols):
    """The routines of software floating point in the output of nm."""
    return SOFTWARE_FLOAT.findall(symbols)


def compile_to(command, output, more_options, source=None):
    """Runs a compile command with its output elsewhere, perhaps on another source; returns the compiler's complaints."""
    words = shlex.split(command)
    words[words.index("-o") + 1] = output
    if source:
        words[words.index("-c") + 1] = source
    done = subprocess.run(words + more_options, capture_output=True, text=True)
    return [done.stderr.strip() or "the compiler failed"] if done.returncode else []


def output_of(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def integer_faults(command, output, source=None):
    """What is wrong with a source when it is compiled without floating-point registers."""
    # Headers precompiled for other registers are left aside.
    faults = compile_to(command, output, ["-O2", "-g0", "-mgeneral-regs-only", "-Wno-invalid-pch"], source)
    return faults or ["calls " + name for name in software_floats(output_of("nm", output))]


def instruction_faults(command, output):
    """The floating-point instructions of a source that is compiled as usual."""
    return (compile_to(command, output, ["-O2", "-g0"]) or
            float_instructions(output_of("objdump", "-d", "--no-show-raw-insn", output)))


def check_files(commands, folder):
    """What is wrong with files that are compiled by the same options, as lines of text. They are compiled as one, since
    reading headers takes most of the time; if anything is wrong then, each is compiled by itself, to name it."""
    path, command = next(iter(commands.items()))
    output = os.path.join(folder, path.replace("/", "_") + ".o")
    together = output + ".cpp"
    with open(together, "w") as file:
        file.writelines(f'#include "{source_of(command)}"\n' for command in commands.values())
    if not integer_faults(command, output, together):
        return []
    return [f"{path}: {fault}" for path, command in commands.items() for fault in integer_faults(command, output)]


def check_kernel(path, command, folder):
    output = os.path.join(folder, path.replace("/", "_") + ".kernel.o")
    return [f"{path}: {fault}" for fault in instruction_faults(command, output)]


def source_of(command):
    words = shlex.split(command)
    return os.path.abspath(words[words.index("-c") + 1])


def groups_of(commands, count):
    """The commands apart by their options, each of these in `count` groups."""
    by_options = {}
    for path, command in commands.items():
        words = shlex.split(command)
        options = tuple(word for i, word in enumerate(words) if i == 0 or words[i - 1] not in ("-o", "-c"))
        by_options.setdefault(options, {})[path] = command
    groups = [dict(list(group.items())[i::count]) for group in by_options.values() for i in range(count)]
    return [group for group in groups if group]


def commands_of(entry):
    """Source -> its compile command, of an entry: of each file of a room where those are compiled as one."""
    whole, command = entry["file"], entry["command"]
    if "/Unity/" not in whole:
        return {whole: command}
    with open(whole) as file:
        return {path: command.replace(whole, path) for path in re.findall(r'^#include "(.+\.cpp)"', file.read(), re.M)}


def engine_commands(entries, source):
    """Path from the project's root -> compile command, of the files that must do without floats."""
    commands = {os.path.relpath(path, source): command for entry in entries for path, command in commands_of(entry).items()}
    return {path: command for path, command in sorted(commands.items())
            if path.startswith("engine/") and not path.startswith(EXCEPTED)}


def check_sources(source):
    faults = []
    for folder, _, names in os.walk(os.path.join(source, "engine")):
        for name in sorted(names):
            path = os.path.relpath(os.path.join(folder, name), source)
            if not path.endswith((".h", ".cpp")) or path.startswith(EXCEPTED):
                continue
            with open(os.path.join(source, path)) as file:
                faults += [f"{path}: says {word}" for word in float_words(file.read())]
    return faults


def check_all(commands):
    workers = os.cpu_count()
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(workers) as pool:
        parts = [pool.submit(check_files, group, folder) for group in groups_of(commands, workers)]
        parts += [pool.submit(check_kernel, path, command, folder) for path, command in commands.items()
                  if path.startswith(KERNELS)]
        return [fault for part in parts for fault in part.result()]


def main():
    commands_path, source = sys.argv[1:]
    with open(commands_path) as file:
        commands = engine_commands(json.load(file), source)
    faults = check_sources(source) + check_all(commands)
    print(*faults, sep="\n")
    print(f"{len(commands)} files, {len(faults)} faults")
    kernels = [path for path in commands if path.startswith(KERNELS)]
    sys.exit(1 if faults or len(commands) < 40 or not kernels else 0)


if __name__ == "__main__":
    main()

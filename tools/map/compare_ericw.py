"""Compares oblong-map with qbsp, vis and light of ericw-tools on a folder of map sources: a row for each map.

usage: compare_ericw.py TOOLS MAPS [--map NAME]... [--oblong PROGRAM] [--threads N]... [--page FILE]
  TOOLS      a folder with qbsp, vis and light, which are not part of this project
  MAPS       a folder of .map files whose key `wad` names files in it: fzwoch/quake_map_source
  --map      one of them; may be given several times (default: all)
  --oblong   (default: build/bin/oblong-map)
  --threads  may be given several times (default: 2 and 1)
  --page     writes the table into this page, between "<!-- table compilers -->" and "<!-- end -->"
Both use 16 points for each light sample (`light -extra4`). For comparing visibility and the light of the world's faces,
their vis and light run on Oblong's own level, so that leaves and faces are the same.
"""
import argparse
import json
import os
import re
import shutil
import statistics
import struct
import subprocess
import sys
import tempfile
import time

HEAD = ["map", "faces", "leaves", "portals", "leaves seen from a leaf", "pairs seen by one alone", "light: mean, over 8"]


def run(command, folder):
    """Runs a command; returns the elapsed seconds."""
    begin = time.perf_counter()
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit("%s\nexit code %d: %s" % (" ".join(command), done.returncode, done.stderr or done.stdout[-2000:]))
    return time.perf_counter() - begin


class Level:
    """The compared parts of a compiled level, version 29."""

    def __init__(self, path):
        with open(path, "rb") as file:
            self.bytes = file.read()
        self.visibility, self.lighting = self.lump(4), self.lump(8)
        self.leaves = list(struct.iter_unpack("<ii6h2H4B", self.lump(10)))
        self.faces = list(struct.iter_unpack("<hhihh4Bi", self.lump(7)))
        self.leaf_count, _, self.world_faces = struct.unpack_from("<3i", self.lump(14), 52)

    def lump(self, index):
        offset, size = struct.unpack_from("<ii", self.bytes, 4 + 8 * index)
        return self.bytes[offset:offset + size]

    def row(self, leaf):
        """The leaves potentially visible from leaf 1 + `leaf`: a number whose bit i is leaf 1 + i."""
        at, row, size = self.leaves[leaf + 1][1], bytearray(), (self.leaf_count + 7) // 8
        if at < 0:
            return (1 << self.leaf_count) - 1
        while len(row) < size:
            byte = self.visibility[at]
            row += bytes(self.visibility[at + 1]) if byte == 0 else bytes([byte])
            at += 2 if byte == 0 else 1
        return int.from_bytes(row[:size], "little") & ((1 << self.leaf_count) - 1)

    def sample_counts(self):
        """The number of samples of each face, 0 without a lightmap; texels are rounded to floats."""
        vertices = list(struct.iter_unpack("<3f", self.lump(3)))
        edges, surf_edges = list(struct.iter_unpack("<HH", self.lump(12))), struct.unpack("<%di" % (len(self.lump(13)) // 4), self.lump(13))
        texinfos = list(struct.iter_unpack("<8fii", self.lump(6)))
        counts = []
        for face in self.faces:
            texinfo = texinfos[face[4]]
            ends = [edges[abs(edge)][edge < 0] for edge in surf_edges[face[2]:face[2] + face[3]]]
            count = 1 if texinfo[9] == 0 else 0
            for axis in (texinfo[0:4], texinfo[4:8]):
                texels = [sum(a * b for a, b in zip(axis, (*vertices[end], 1))) for end in ends]
                low, high = (struct.unpack("<f", struct.pack("<f", texel))[0] // 16 for texel in (min(texels), -max(texels)))
                count *= int(-high - low) + 1
            counts.append(count)
        return counts

    def lightmaps(self, counts):
        """Bytes by face and style."""
        return [{style: self.lighting[face[9] + i * count:face[9] + (i + 1) * count]
                 for i, style in enumerate(face[5:9]) if style != 255 and face[9] >= 0}
                for face, count in zip(self.faces, counts)]


def compare_light(ours, theirs):
    """The mean difference of the world's samples, 0 to 255, and the share of those that differ by more than 8."""
    counts = ours.sample_counts()[:ours.world_faces]
    histogram = [0] * 256
    for count, a, b in zip(counts, ours.lightmaps(counts), theirs.lightmaps(counts)):
        for style in {*a, *b} or {0}:
            for one, other in zip(a.get(style, bytes(count)), b.get(style, bytes(count))):
                histogram[abs(one - other)] += 1
    return sum(i * n for i, n in enumerate(histogram)) / sum(histogram), sum(histogram[9:]) / sum(histogram)


def compare_visibility(ours, theirs):
    """The mean number of leaves visible from a leaf, ours and theirs; and the number of pairs only in ours and only in theirs."""
    rows = [(ours.row(i), theirs.row(i)) for i in range(ours.leaf_count)]
    return (statistics.mean(a.bit_count() for a, _ in rows), statistics.mean(b.bit_count() for _, b in rows),
            *(sum((x & ~y).bit_count() for x, y in pairs) for pairs in (rows, [(b, a) for a, b in rows])))


def portal_count(path):
    with open(path) as file:
        return int(file.read(64).split()[2])


def write_with_clusters(path, level):
    """Rewrites the portals as PRT2, with the leaves of each cluster: those that share a row."""
    with open(path) as file:
        lines = file.read().splitlines()
    clusters = {}
    for leaf in range(level.leaf_count):
        clusters.setdefault(level.leaves[leaf + 1][1], []).append(leaf)
    with open(path, "w") as file:
        file.write("\n".join(["PRT2", str(level.leaf_count), *lines[1:],
                              *(" ".join(map(str, [*leaves, -1])) for leaves in clusters.values())]) + "\n")


class Comparison:
    def __init__(self, options, scratch):
        self.options, self.scratch = options, scratch
        self.oblong = os.path.abspath(options.oblong)

    def path(self, name):
        return os.path.join(self.scratch, name)

    def our_seconds(self, source, threads):
        return run([self.oblong, source, "-o", self.path("ours.bsp"), "--prt", self.path("ours.prt"), "--threads", threads],
                   self.options.maps)

    def their_tool(self, tool, level, threads, *more):
        return run([os.path.join(self.options.tools, tool), "-threads", threads, *more, level], self.options.maps)

    def their_seconds(self, source, threads):
        level = self.path("theirs.bsp")
        qbsp = run([os.path.join(self.options.tools, "qbsp"), "-threads", threads, source, level], self.options.maps)
        return qbsp + self.their_tool("vis", level, threads) + self.their_tool("light", level, threads, "-extra4")

    def row(self, name):
        source, times = os.path.join(self.options.maps, name + ".map"), []
        for threads in self.options.threads:
            times.append((self.our_seconds(source, threads), self.their_seconds(source, threads)))
        ours, theirs = Level(self.path("ours.bsp")), Level(self.path("theirs.bsp"))
        portals = portal_count(self.path("ours.prt")), portal_count(self.path("theirs.prt"))
        shutil.copy(self.path("ours.bsp"), self.path("both.bsp"))
        shutil.copy(self.path("ours.prt"), self.path("both.prt"))
        write_with_clusters(self.path("both.prt"), ours)
        self.their_tool("light", self.path("both.bsp"), "2", "-extra4")
        light = compare_light(ours, Level(self.path("both.bsp")))
        self.their_tool("vis", self.path("both.bsp"), "2")
        visibility = compare_visibility(ours, Level(self.path("both.bsp")))
        return [len(ours.faces), len(theirs.faces), ours.leaf_count, theirs.leaf_count, *portals, *visibility, *light], times


def table_of(rows, threads):
    """A row for each map, with Oblong's figures first."""
    head = [*HEAD, *("%s threads: s, theirs" % count for count in threads)]
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    for name, (figures, times) in rows.items():
        cells = ["%d, %d" % tuple(figures[i:i + 2]) for i in (0, 2, 4)] + ["%.1f, %.1f" % tuple(figures[6:8])]
        cells += ["%d, %d" % tuple(figures[8:10]), "%.2f, %.1f %%" % (figures[10], 100 * figures[11])]
        lines.append("| " + " | ".join([name, *cells, *("%.2f, %.2f" % tuple(time) for time in times)]) + " |")
    return "\n".join(lines) + "\n"


def summary_of(rows, threads):
    figures, times = [row[0] for row in rows.values()], [row[1] for row in rows.values()]
    lines = []

    def add(what, ratios, ours, theirs):
        lines.append("| %s | %.2f | %.2f | %.2f | %s | %s |" % (what, statistics.median(ratios), max(ratios), min(ratios), ours, theirs))

    for i, count in enumerate(threads):
        ours, theirs = ([time[i][k] for time in times] for k in range(2))
        add("time, %s threads" % count, [a / b for a, b in zip(ours, theirs)], "%.1f s" % sum(ours), "%.1f s" % sum(theirs))
    for what, at in (("faces", 0), ("leaves", 2), ("portals", 4), ("leaves seen from a leaf", 6)):
        ours, theirs = [row[at] for row in figures], [row[at + 1] for row in figures]
        add(what, [a / b for a, b in zip(ours, theirs)], "%d" % sum(ours), "%d" % sum(theirs))
    add("light: mean difference of 255", [row[10] for row in figures], "", "")
    return "\n".join(["| ours / theirs | median | most | least | ours in all | theirs |", "|---|---|---|---|---|---|", *lines]) + "\n"


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("tools", type=os.path.abspath)
    parser.add_argument("maps", type=os.path.abspath)
    parser.add_argument("--map", action="append")
    parser.add_argument("--oblong", default="build/bin/oblong-map")
    parser.add_argument("--threads", action="append")
    parser.add_argument("--page")
    options = parser.parse_args()
    options.threads = options.threads or ["2", "1"]
    names = options.map or sorted(name[:-4] for name in os.listdir(options.maps) if name.endswith(".map"))
    rows = {}
    with tempfile.TemporaryDirectory() as scratch:
        comparison = Comparison(options, scratch)
        for name in names:
            rows[name] = comparison.row(name)
            print(json.dumps([name, *rows[name]]), file=sys.stderr, flush=True)
    text = summary_of(rows, options.threads) + "\n" + table_of(rows, options.threads)
    print(text)
    if options.page:
        with open(options.page) as file:
            page = file.read()
        with open(options.page, "w") as file:
            file.write(re.sub(r"(<!-- table compilers -->\n)[\s\S]*?(<!-- end -->)", lambda at: at[1] + text + at[2], page))


if __name__ == "__main__":
    main()

"""A level with copies of its world, none of which is visible from another copy."""
import re
import struct

LUMPS = ("entities", "planes", "textures", "vertices", "visibility", "nodes", "texinfos", "faces", "lighting",
         "clipnodes", "leaves", "markfaces", "edges", "surfedges", "models")
# Records of BSP 29, and of BSP2, which allows any number of them.
NARROW = {"planes": "<4fi", "vertices": "<3f", "nodes": "<i2h6h2H", "texinfos": "<8f2i", "faces": "<2Hi2H4Bi",
          "leaves": "<2i6h2H4B", "markfaces": "<H", "edges": "<2H", "surfedges": "<i", "models": "<9f7i"}
WIDE = {**NARROW, "nodes": "<i2i6f2I", "faces": "<2Ii2I4Bi", "leaves": "<2i6f2I4B", "markfaces": "<I", "edges": "<2I"}
SOLID_LEAF = 0
OUTSIDE = (-2, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)  # a solid leaf


def read_lumps(path):
    with open(path, "rb") as file:
        data = file.read()
    if struct.unpack_from("<i", data)[0] != 29:
        raise ValueError("%s is no BSP 29" % path)
    lumps = {}
    for i, name in enumerate(LUMPS):
        offset, size = struct.unpack_from("<2i", data, 4 + 8 * i)
        lump = data[offset:offset + size]
        lumps[name] = [list(record) for record in struct.iter_unpack(NARROW[name], lump)] if name in NARROW else lump
    return lumps


class World:
    """The world of a level: the contents of its tree, without moving models."""

    def __init__(self, lumps):
        self.lumps = lumps
        model = lumps["models"][0]
        self.mins, self.maxs = model[0:3], model[3:6]
        self.known_leaf_count = model[13]  # the leaves of visible sets are 1 and up
        self.leaf_count = -(-self.known_leaf_count // 8) * 8  # padded, so that rows of copies begin on a byte
        self.faces = lumps["faces"][model[14]:model[14] + model[15]]
        self.first_face = model[14]
        self.nodes, self.leaves = [], lumps["leaves"][1:1 + self.known_leaf_count]
        self.leaves += [[*OUTSIDE] for _ in range(self.leaf_count - self.known_leaf_count)]
        self._number_nodes(model[9])

    def _number_nodes(self, root):
        numbers, waiting = {}, [root]
        while waiting:
            node = waiting.pop()
            numbers[node] = len(numbers)
            waiting += [child for child in self.lumps["nodes"][node][1:3] if child >= 0]
        for node in numbers:  # in the order of their numbers
            record = list(self.lumps["nodes"][node])
            record[1:3] = [numbers[child] if child >= 0 else child for child in record[1:3]]
            self.nodes.append(record)

    def visible_rows(self):
        """For each offset of leaves' visible sets, the packed row of potentially visible leaves."""
        size, packed, rows = self.leaf_count // 8, self.lumps["visibility"], {}
        for start in {leaf[1] for leaf in self.leaves}:
            row, at = bytearray() if start != -1 else bytearray(b"\xff" * size), start
            while len(row) < size and at < len(packed):
                row += bytes(packed[at + 1]) if packed[at] == 0 else packed[at:at + 1]
                at += 2 if packed[at] == 0 else 1
            seen = int.from_bytes(row[:size], "little") & ((1 << self.known_leaf_count) - 1)
            rows[start] = pack(seen.to_bytes(size, "little"))
        return rows


def zeros(count):
    """`count` zeros, packed: a 0 and a count, up to 255 at a time."""
    return b"\0\xff" * (count // 255) + (bytes((0, count % 255)) if count % 255 else b"")


def pack(row):
    return b"".join(zeros(len(part)) if part[0] == 0 else part for part in re.findall(rb"\0+|[^\0]+", row))


class Copies:
    """The lumps of a level of copies in a row along x; the first is at the world's place."""

    def __init__(self, world, count):
        self.world, self.count = world, count
        self.out = {name: [] for name in WIDE}
        self.out["visibility"] = bytearray()
        # A multiple of textures' sizes, so that they continue without a seam.
        self.distance = 2048 * -(-int(world.maxs[0] - world.mins[0] + 64) // 2048)
        self.out["leaves"].append(OUTSIDE)
        self.rows = world.visible_rows()
        for copy in range(count):
            self._add_copy(copy)
        root = self._add_splits(0, count)
        bounds = [*world.mins, world.maxs[0] + (count - 1) * self.distance, *world.maxs[1:]]
        self.out["models"] = [[*bounds, 0, 0, 0, root, 0, 0, 0, count * world.leaf_count, 0, len(self.out["faces"])]]

    def _add_copy(self, copy):
        lumps, out, shift = self.world.lumps, self.out, copy * self.distance
        first = {name: len(records) for name, records in out.items()}
        out["planes"] += [[x, y, z, distance + x * shift, kind] for x, y, z, distance, kind in lumps["planes"]]
        out["vertices"] += [[x + shift, y, z] for x, y, z in lumps["vertices"]]
        out["texinfos"] += [[*t[:3], t[3] - t[0] * shift, *t[4:7], t[7] - t[4] * shift, *t[8:]] for t in lumps["texinfos"]]
        out["edges"] += [[a + first["vertices"], b + first["vertices"]] for a, b in lumps["edges"]]
        out["surfedges"] += [[edge + first["edges"] if edge >= 0 else edge - first["edges"]] for edge, in lumps["surfedges"]]
        for plane, side, edge, edges, texinfo, *rest in self.world.faces:
            out["faces"].append([plane + first["planes"], side, edge + first["surfedges"], edges, texinfo + first["texinfos"], *rest])
        self._add_leaves(copy, first, shift)
        self._add_nodes(copy, first, shift)

    def _add_leaves(self, copy, first, shift):
        world, out = self.world, self.out
        size = world.leaf_count // 8
        before, after = zeros(copy * size), zeros((self.count - 1 - copy) * size)
        face_shift = first["faces"] - world.first_face
        for leaf in world.leaves:
            start, count = leaf[8:10]
            marks = [[mark + face_shift] for mark, in world.lumps["markfaces"][start:start + count]]
            box = [leaf[2] + shift, *leaf[3:5], leaf[5] + shift, *leaf[6:8]]
            out["leaves"].append([leaf[0], len(out["visibility"]), *box, len(out["markfaces"]), count, *leaf[10:]])
            out["markfaces"] += marks
            out["visibility"] += before + self.rows[leaf[1]] + after

    def _add_nodes(self, copy, first, shift):
        def moved(child):
            if child >= 0:
                return child + first["nodes"]
            leaf = -1 - child
            return -1 - (leaf + copy * self.world.leaf_count) if leaf != SOLID_LEAF else child

        for plane, front, back, *box_and_faces in self.world.nodes:
            box, (first_face, count) = box_and_faces[:6], box_and_faces[6:]
            face = first_face - self.world.first_face + first["faces"] if count else 0
            self.out["nodes"].append([plane + first["planes"], moved(front), moved(back), box[0] + shift, *box[1:3],
                                      box[3] + shift, *box[4:], face, count])

    def _add_splits(self, begin, end):
        """Adds a tree over copies [begin, end), divided by planes between them; returns its root."""
        if end - begin == 1:
            return begin * len(self.world.nodes)
        middle = (begin + end) // 2
        back, front = self._add_splits(begin, middle), self._add_splits(middle, end)
        gap = self.distance - (self.world.maxs[0] - self.world.mins[0])
        self.out["planes"].append([1, 0, 0, self.world.mins[0] + middle * self.distance - gap / 2, 0])
        mins, maxs = self.world.mins, self.world.maxs
        self.out["nodes"].append([len(self.out["planes"]) - 1, front, back, mins[0] + begin * self.distance, *mins[1:],
                                  maxs[0] + (end - 1) * self.distance, *maxs[1:], 0, 0])
        return len(self.out["nodes"]) - 1


def world_face_count(source):
    return len(World(read_lumps(source)).faces)


def write_copies(source, count, path):
    """Writes a BSP2 with `count` copies of the world of a BSP 29; returns its number of faces."""
    world = World(read_lumps(source))
    lumps = {**{name: b"" for name in LUMPS}, **Copies(world, count).out}
    lumps["entities"] = b'{\n"classname" "worldspawn"\n}\n\0'
    lumps["textures"] = world.lumps["textures"]
    lumps["lighting"] = world.lumps["lighting"]
    header, body = b"BSP2", []
    for name in LUMPS:
        data = b"".join(struct.pack(WIDE[name], *record) for record in lumps[name]) if name in WIDE else bytes(lumps[name])
        header += struct.pack("<2i", 4 + 8 * len(LUMPS) + sum(map(len, body)), len(data))
        body += [data, bytes(-len(data) % 4)]
    with open(path, "wb") as file:
        file.write(header + b"".join(body))
    return len(lumps["faces"])

"""Floats planted in small files are caught by every one of the four ways, and integers are let through.

usage: no_floats_test.py COMPILER
"""
import os
import sys
import tempfile
import unittest

import no_floats

COMPILER = sys.argv.pop() if len(sys.argv) > 1 else "c++"

PARAMETER = "double twice(double x) { return 2 * x; }"
LOCAL = "int tenth(int x) { double y = x; y *= 0.1; return static_cast<int>(y); }"
INTEGER = "long long tenth(long long x) { return x * 0x1999999a >> 32; }"
# A copy and a fill of bytes: wide registers may move bytes.
COPY = "struct Block { long long a[8]; }; void copy(Block& to, const Block& from) { to = from; }"


def faults_of(texts):
    """Of files, path -> text."""
    with tempfile.TemporaryDirectory() as folder:
        commands = {}
        for path, text in texts.items():
            source = os.path.join(folder, path.replace("/", "_"))
            with open(source, "w") as file:
                file.write(text)
            commands[path] = f"{COMPILER} -std=c++20 -o unused.o -c {source}"
        return no_floats.check_all(commands)


class PlantedFloats(unittest.TestCase):
    def test_parameter_is_caught(self):
        self.assertTrue(faults_of({"engine/a.cpp": PARAMETER}))

    def test_local_is_caught(self):
        self.assertTrue(faults_of({"engine/a.cpp": LOCAL}))

    def test_integers_pass_everywhere(self):
        for text in (INTEGER, COPY):
            self.assertEqual(faults_of({"engine/a.cpp": text}), [])
            self.assertEqual(faults_of({"engine/raster/kernels/a.cpp": text}), [])

    def test_the_one_file_of_several_is_named(self):
        texts = {f"engine/{name}.cpp": INTEGER.replace("tenth", name) for name in "abcdef"}
        self.assertEqual(faults_of(texts), [])
        [fault] = faults_of(texts | {"engine/c.cpp": PARAMETER})
        self.assertTrue(fault.startswith("engine/c.cpp: "))

    def test_files_that_cannot_be_compiled_as_one_are_compiled_apart(self):
        texts = {f"engine/{name}.cpp": INTEGER for name in "abcdef"}
        self.assertEqual(faults_of(texts), [])

    def test_float_that_hides_from_the_option_is_caught_in_a_kernel(self):
        hidden = 'int f() { int x; asm("cvtss2si %%xmm0, %0" : "=r"(x)); return x; }'
        self.assertEqual(faults_of({"engine/a.cpp": hidden}), [])
        self.assertIn("cvtss2si", faults_of({"engine/raster/kernels/a.cpp": hidden})[0])


class Patterns(unittest.TestCase):
    def test_float_words(self):
        for text in ("float x;", "auto y = x * 0.5;", "return .5f;", "std::vector<double> a;", "x = 1e9 + 1'000.0;"):
            self.assertTrue(no_floats.float_words(text), text)

    def test_words_that_are_no_floats(self):
        for text in ("// half: 0.5", "/* a float,\n1.5 */ int x;", 'fail("expected 0.5, a float");', "FloatBits x = a.x1.y;",
                     "to_float_bits(1'000);", "auto [a, b] = c.d;"):
            self.assertEqual(no_floats.float_words(text), [], text)

    def test_float_instructions(self):
        for words in ("addss  %xmm1,%xmm0", "vfmadd213ps %ymm0,%ymm1,%ymm2", "cvttsd2si %xmm0,%eax", "ucomisd %xmm1,%xmm0",
                      "fldl   0x8(%rsp)", "divps  (%rax),%xmm0", "vmulpd %ymm0,%ymm0,%ymm0", "cmpltps %xmm0,%xmm1"):
            self.assertTrue(no_floats.float_instructions(f"  4f:\t{words}"), words)

    def test_integer_instructions(self):
        for words in ("add    %eax,%ebx", "movups %xmm0,(%rax)", "pmaddwd %xmm1,%xmm0", "paddd  %xmm1,%xmm0", "pext   %rax,%rbx,%rcx",
                      "cmpsb  %es:(%rdi),%ds:(%rsi)", "call   40 <fill_spans>", "movaps %xmm0,%xmm1", "subq   $8,%rsp"):
            self.assertEqual(no_floats.float_instructions(f"  4f:\t{words}"), [], words)

    def test_software_floats(self):
        self.assertEqual(no_floats.software_floats("  U __muldf3\n  U __floatsidf\n  U __divti3\n  U memcpy\n"),
                         ["__muldf3", "__floatsidf"])


if __name__ == "__main__":
    unittest.main()

"""Runs every benchmark of oblong-bench for an instant: each did its work, none failed, and none was left out.

usage: each_benchmark_runs.py OBLONG_BENCH
"""
import json
import subprocess
import sys
import tempfile

FAMILIES = {"kernel", "effect_kernel", "sky", "lit_surface", "stage"}
STAGES = {"walk", "transform_clip_project", "edge_scan", "coverage", "span_cutting", "spans"}


def check(condition, message):
    if not condition:
        sys.exit("each_benchmark_runs: " + message)


def main():
    program = sys.argv[1]
    run = subprocess.run([program, "--benchmark_min_time=0.0001", "--benchmark_format=json"], capture_output=True, text=True)
    check(run.returncode == 0, "exit code %d: %s" % (run.returncode, run.stderr))
    results = json.loads(run.stdout)["benchmarks"]
    for result in results:
        check(not result.get("error_occurred") and result["iterations"] >= 1, "%s failed" % result["name"])
        per = [result[name] for name in ("pixel", "texel", "face", "frame") if name in result]
        check(per and all(value > 0 for value in per), "%s has worked on nothing" % result["name"])
    words = [result["name"].split("/") for result in results]
    check({w[0] for w in words} == FAMILIES, "families %s, expected %s" % ({w[0] for w in words}, FAMILIES))
    stages = {w[1] for w in words if w[0] == "stage"}
    check(stages == STAGES, "stages %s, expected %s" % (stages, STAGES))
    short = [program, "--benchmark_filter=plain/", "--benchmark_min_time=0.0001"]
    full = subprocess.run([*short, "--benchmark_out=/dev/full"], capture_output=True, text=True)
    check(full.returncode == 1 and "/dev/full: write: " in full.stderr,
          "results on a full disk: exit code %d, expected 1: %s" % (full.returncode, full.stderr))
    with tempfile.TemporaryDirectory() as folder:
        kept = folder + "/results.json"
        check(subprocess.run([*short, "--benchmark_out=" + kept], capture_output=True).returncode == 0, "no results")
        with open(kept) as file:
            check(json.load(file)["benchmarks"], "no benchmark in the file of results")
    for wrong in (["--benchmark_nonsense=1"], ["--benchmark_filter=^none$"], ["--level", "no.bsp"], ["--mode", "1x1"],
                  ["--benchmark_out=x", "--benchmark_out_format=csv"]):
        refused = subprocess.run([program, *wrong], capture_output=True, text=True)
        check(refused.returncode == 2 and refused.stderr, "%s: exit code %d, expected 2" % (wrong, refused.returncode))


if __name__ == "__main__":
    main()

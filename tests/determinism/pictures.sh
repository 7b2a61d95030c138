# Sourced by the scripts here, from the project's root, with $build and $work set: the compared pictures and the lists of
# their checksums.

levels=""
for place in ../shared "${OBLONG_SHARED:-}"; do
    [ -z "$levels" ] && [ -d "$place/levels" ] && levels=$place/levels
done

# The arguments of oblong-render for each run. Effects move: at several times, one of them past 2^32 milliseconds.
runs=("--accuracy bounded" "--accuracy exact --time 31.4" "--accuracy 1996 --time 4294967.5" "--accuracy 1991"
      "--accuracy bounded --mode 640x480 --time 12.3" "--accuracy exact --mode 640x480"
      "--accuracy bounded --fov 179 --time 8.05" "--accuracy bounded --fov 1"
      "--accuracy 1994 --mode 333x217 --display 16:9 --fov 140 --time 77"
      "--accuracy bounded --dial perspective=bounded-texels" "--accuracy bounded --dial mip=span"
      "--accuracy bounded --dial dither=on" "--accuracy 1991 --dial light=nearest" "--accuracy exact --dial light=nearest")

# choose_cameras STEP: every STEPth camera of each real level, the demo level's and some at the ends of the world, and some
# in a room with all effects, inside a tank of water and outside.
choose_cameras() {
    mkdir -p "$work"
    rm -f "$work"/*.csv
    "$build/bin/oblong-map" tools/effect_costs/all_effects.map -o "$work/all_effects.bsp" --wad "$build/assets/demo.wad" >/dev/null ||
        fail "$build/bin/oblong-map does not compile tools/effect_costs/all_effects.map"
    printf '%s\n' x,y,z,yaw,pitch -310,0,120,0,8 -310,60,40,-20,0 -280,0,120,0,8 -200,200,60,-40,5 300,-200,90,135,10 \
        20,-220,110,25,0 >"$work/all_effects.csv"
    { cat assets/demo_cameras.csv; printf '%s\n' 32767,32767,32767,225,35 -32767,32767,-32767,315,-35 32767,-32767,0,135,0; } >"$work/demo.csv"
    [ -n "$levels" ] || { echo "no folder shared/ beside the project: the demo level alone"; return; }
    local name
    for name in dm4 e1m7 end; do
        awk -v step="$1" 'NR == 1 || NR % step == 2 % step' "$levels/cameras/$name.csv" >"$work/$name.csv"
    done
}

level_path() {
    case $1 in
        demo) echo "$build/assets/demo.bsp" ;;
        all_effects) echo "$work/all_effects.bsp" ;;
        *) echo "$levels/$1.bsp" ;;
    esac
}

# rendered_report PROGRAM LEVEL CAMERAS ARGUMENT...: the JSON of an oblong-render.
rendered_report() {
    local program=$1 level=$2 cameras=$3 report status=0
    shift 3
    report=$(mktemp "$work/report.XXXXXX")
    # Hides its warnings of a level, which are the same at every run.
    "$program" "$level" --cameras "$cameras" --palette "$build/assets/palette.lmp" "$@" --json "$report" >/dev/null 2>"$report.log" &&
        cat "$report" || { status=1; cat "$report.log" >&2; }
    rm -f "$report" "$report.log"
    return "$status"
}

# The CRC-32s of the same, a line for each picture.
rendered_checksums() { rendered_report "$@" | grep -o '"crc32": "[0-9a-f]*"' | cut -d '"' -f 4; }

# The same, each followed by all counts of the frame.
rendered_counts() {
    rendered_report "$@" | sed -nE '/"crc32"/ { s/.*: "([0-9a-f]+)".*/\1/; h }
        /"counts"/,/\}/ { s/^ *"[a-z_]+": ([0-9]+),?$/\1/; T; H }
        /"effects"/ { x; s/\n/ /g; p }'
}

# list_checksums OUTPUT COMMAND...: writes "LEVEL RUN CAMERA CRC32..." for each picture, a line each. COMMAND gets a level, a
# list of cameras and a run's arguments.
list_checksums() {
    local output=$1 cameras name run
    shift
    : >"$output"
    for cameras in "$work"/*.csv; do
        name=$(basename "$cameras" .csv)
        for run in "${runs[@]}"; do
            # shellcheck disable=SC2086
            "$@" "$(level_path "$name")" "$cameras" $run >"$output.run" || fail "$* failed: $name $run"
            awk -v head="$name $run" '{ print head, "camera", NR - 1, $0 }' "$output.run" >>"$output"
        done
    done
    rm -f "$output.run"
}

# All effects except models, whose files are read by libraries that the driver is built without.
effects=sky,liquid,brush_models,fence,translucency,animated_textures,light_styles,moving_lights,fog,particles,sprites,shadows,mirror,underwater
without_models() { rendered_counts "$@" --effects "$effects"; }

# list_reference: the list of the existing build.
list_reference() {
    list_checksums "$work/reference.txt" without_models "$build/bin/oblong-render"
    pictures=$(wc -l <"$work/reference.txt")
    [ "$pictures" -ge 100 ] || fail "only $pictures pictures to compare"
}

# demand_same NAME: requires that its list equals the reference.
demand_same() {
    diff "$work/reference.txt" "$work/$1.txt" >"$work/$1.diff" ||
        { head -n 10 "$work/$1.diff" >&2; fail "$1 draws other pictures (< reference, > $1); all are in $work/$1.diff"; }
}

# demand_same_play NAME TICKS COMMAND...: requires the existing build's states and pictures in a long play of each level.
demand_same_play() {
    local name=$1 ticks=$2 level
    shift 2
    for level in demo ${levels:+dm4 e1m7 end}; do
        "$build/bin/long_play" "$build/assets/palette.lmp" "$(level_path "$level")" "$ticks" >"$work/$name.wanted_play" &&
            "$@" "$build/assets/palette.lmp" "$(level_path "$level")" "$ticks" >"$work/$name.play" ||
            fail "$name does not play $level for $ticks ticks"
        cmp -s "$work/$name.wanted_play" "$work/$name.play" ||
            fail "$name plays $level otherwise: $(diff "$work/$name.wanted_play" "$work/$name.play" | sed -n 2p)"
    done
    echo "$ticks ticks of play in each level, the same in: reference $name"
}

# demand_same_walk NAME COMMAND...: requires that the recorded walk leads to the states recorded by the existing build, and
# that the games saved on the way are the same files as those of the first NAME.
demand_same_walk() {
    local name=$1
    shift
    "$@" "$build/assets/demo.bsp" "$build/assets/walk.demo" >"$work/$name.walk" || fail "$name does not walk the recorded walk"
    grep -q '^end ' "$work/$name.walk" || fail "the recorded walk does not reach the end of the level"
    first_walk=${first_walk:-$work/$name.walk}
    cmp -s "$first_walk" "$work/$name.walk" || fail "$name saves other files than $(basename "$first_walk" .walk)"
}

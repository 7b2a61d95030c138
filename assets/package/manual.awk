# Makes a manual page from its text and its program's --help, so that it lists every option.
#   awk -v program=PROGRAM -v version=VERSION -v date=DATE -f manual.awk TEXT
# A line "@OPTIONS@" or "@OPTIONS COMMAND@" in the text becomes the list of PROGRAM [COMMAND] --help.

function escaped(text) {
    gsub(/\\/, "\\e", text)
    gsub(/-/, "\\-", text)
    return text ~ /^[.']/ ? "\\&" text : text
}

# Splits "--mode TEXT=320x200" into a name, its value's type, and notes on the value.
function list_entry(names, help,    words, count, i, rest, notes) {
    gsub(/ +$/, "", names)
    count = split(names, words, " ")
    rest = ""
    notes = ""
    for (i = 2; i <= count; ++i) {
        if (words[i] == "REQUIRED") notes = notes " Required."
        else rest = rest (rest == "" ? "" : " ") words[i]
    }
    if (match(rest, /=[^ ]+$/)) {
        notes = notes " Default: " substr(rest, RSTART + 1) "."
        rest = substr(rest, 1, RSTART - 1)
    }
    if (match(rest, / ?Needs: .*$/)) {
        notes = notes " Only with " substr(rest, RSTART + 7 + (substr(rest, RSTART, 1) == " ")) "."
        rest = substr(rest, 1, RSTART - 1)
    }
    if (match(rest, / ?Excludes: .*$/)) {
        notes = notes " Not with " substr(rest, RSTART + 10 + (substr(rest, RSTART, 1) == " ")) "."
        rest = substr(rest, 1, RSTART - 1)
    }
    sub(/^TEXT/, "VALUE", rest)
    sub(/^INT:INT in/, "NUMBER in", rest)
    sub(/ \.\.\.$/, "...", rest)
    if (names !~ /^-/) sub(/^VALUE/, "", rest)
    gsub(/,/, ", ", words[1])
    print ".TP"
    print "\\fB" escaped(words[1]) "\\fR" (rest == "" ? "" : " \\fI" escaped(rest) "\\fR")
    print escaped(help) (notes == "" ? "" : (help ~ /[.]$/ ? "" : ".") escaped(notes))
}

# CLI11 begins help in the 31st column, on a line of its own under a long name.
function list_options(command,    line, call, names, is_listing) {
    call = "'" program "' " command " --help"
    names = ""
    while ((call | getline line) > 0) {
        if (line ~ /^(Positionals|Options):/) is_listing = 1
        else if (line ~ /^[^ ]/) is_listing = 0
        if (!is_listing || line !~ /^ /) continue
        if (line ~ /^                              /) {
            list_entry(names, substr(line, 31))
            names = ""
            continue
        }
        if (names != "") list_entry(names, "")
        names = ""
        if (length(line) > 30 && substr(line, 30, 1) == " ") list_entry(substr(line, 3, 28), substr(line, 31))
        else names = substr(line, 3)
    }
    if (names != "") list_entry(names, "")
    if (close(call) != 0) {
        print "manual.awk: " program ": " command " --help: it failed, expected a list of options" > "/dev/stderr"
        exit 1
    }
}

/^@OPTIONS.*@$/ {
    gsub(/^@OPTIONS ?|@$/, "")
    list_options($0)
    next
}
{
    gsub(/@VERSION@/, version)
    gsub(/@DATE@/, date)
    print
}

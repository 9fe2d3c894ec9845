# SPDX-License-Identifier: MIT
#
# Callgrind's profiles, one a frame, with names and positions in full -> a line "STAGE MEAN WORST" for the whole frame
# and each file of firmware/, instructions. A function counts for the file that defines it, with all that was inlined
# into it; what it calls counts for itself. `own`: which files are meant, if not those of firmware/.

BEGIN { if (!own) own = "/firmware/([a-z]*/)?[a-z0-9_]*\\.[ch]$" }

FNR == 1 {
    close_frame()
    mine = 0
}

/^fl=/ {
    mine = $0 ~ own
    stage = $0
    sub(/.*\//, "", stage)
    sub(/\..*/, "", stage)
    if (stage == "frame") stage = "frame.c" # the file, not the whole
}
/^calls=/ { skip = 1; next } # the next line is what the callee took
/^[0-9]/ && skip { skip = 0; next }
/^[0-9]/ && mine { now[stage] += $2; whole += $2 }

END {
    close_frame()
    if (!frames) {
        print "callgrind: not one frame" >"/dev/stderr"
        exit 1
    }
    for (stage in sum) printf "%s %.1f %d\n", stage, sum[stage] / frames, worst[stage] | "sort"
}

function note(stage, count) {
    sum[stage] += count
    if (count > worst[stage]) worst[stage] = count
}

function close_frame(   stage) {
    if (!whole) return # what the program does after its last frame
    frames++
    note("frame", whole)
    for (stage in now) note(stage, now[stage])
    split("", now)
    whole = 0
}

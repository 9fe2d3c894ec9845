# SPDX-License-Identifier: MIT
#
# A wire log with times, as tests/wire_board writes it, becomes what a logic analyser on these wires would have seen, as a
# value change dump:
#   awk -f vcd.awk -v unit_ns=100 -v half=2 WIRES
# unit_ns: the time scale. half: half a period of the clock, in it. mode: SPI mode (0). cs: of each message (usual), of each
# byte, always low, or none; select: a memory LCD's, which the log has. led=0: not wired. from: units before which nothing
# was captured. rest: units of rest where the light changes. dc, sck, mosi: their names. glitch: units after which the clock has a pulse of one more.

function bits_of(hex, number, text) {
    for (number = 1; number < 9; number++)
        text = text (int(hex / 2 ^ (8 - number)) % 2)
    return text
}

function begin() {
    is_on = 1
    print "$date today $end\n$version a test's $end\n$timescale " unit_ns " ns $end\n$scope module wires $end"
    for (i = 0; i < n_names; i++) print "$var wire 1 " id[i] " " name[i] " $end"
    now += 0
    print "$upscope $end\n$enddefinitions $end\n#" now "\n$dumpvars"
    for (i = 0; i < n_names; i++) print level[i] id[i]
    print "$end"
    told = now
}

function set(wire, to) {
    if (!is_on && now >= from) begin()
    if (level[wire] == to) return
    level[wire] = to
    if (!is_on || wire >= n_names) return
    if (now != told) print "#" now
    told = now
    print to id[wire]
}

function send(text, is_last) {
    for (bit = 1; bit < 9; bit++) {
        if (phase) { set(SCK, 1 - idle); set(MOSI, substr(text, bit, 1)) } else set(MOSI, substr(text, bit, 1))
        if (glitch && now > glitch) {
            set(SCK, 1 - level[SCK])
            now++
            set(SCK, 1 - level[SCK])
            glitch = 0
        }
        now += half
        set(SCK, phase ? idle : 1 - idle)
        now += half
        if (!phase) set(SCK, idle)
    }
}

BEGIN {
    DC = 0; SCK = 1; MOSI = 2; RESET = 3
    split("! \" # $ %& {}", ids, " ")
    name[DC] = dc ? dc : "D/C"; name[SCK] = sck ? sck : "SCLK"; name[MOSI] = mosi ? mosi : "sda"; name[RESET] = "RST"
    n_names = 4
    if (cs != "none") { CS = n_names; name[n_names++] = "CS#" } else CS = 99
    if (led != "0") { LED = n_names; name[n_names++] = "LED" } else LED = 98
    for (i = 0; i < n_names; i++) { id[i] = ids[i + 1]; level[i] = 0 }
    idle = mode == 2 || mode == 3; phase = mode == 1 || mode == 3
    level[SCK] = idle; level[RESET] = 1; level[LED] = 0
    if (cs == "select") of["select"] = CS
    level[CS] = cs != "always" && cs != "select"
    of["dc"] = DC; of["reset"] = RESET; of["led"] = LED
    for (value = 0; value < 256; value++) bits[sprintf("%02X", value)] = bits_of(value)
    if (!from) begin()
}

$1 == "t" {
    if (!sent && $2 > told_ns) now += int(($2 - told_ns) / unit_ns)
    told_ns = $2
    sent = 0
}

$1 == "p" && $2 in of {
    now += half + ($2 == "led" ? rest : 0)
    set(of[$2], $3)
}

$1 == "b" {
    if (cs == "") set(CS, 0)
    for (i = 2; i <= NF; i++) {
        if (cs == "byte") set(CS, 0)
        now++
        send(bits[$i])
        now++
        if (cs == "byte") set(CS, 1)
    }
    if (cs == "") set(CS, 1)
    now += half
    sent = 1
}

END { print "#" now + 100 }

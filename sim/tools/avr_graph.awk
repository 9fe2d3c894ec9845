# SPDX-License-Identifier: MIT
#
# What gcc -fcallgraph-info=su tells of other processors, of an AVR image that its gcc, too old for that, compiled with
# -g: avr-objdump -dl IMAGE | awk -f sim/tools/avr_graph.awk. A function's frame is its return address, what it pushes, and
# how far it moves the stack pointer. Every jump out of a function counts as a call.

function plain(address) {
    sub(/^0x/, "", address)
    sub(/^0+/, "", address)
    return address
}

function title(address, name) {
    return plain(address) ":" name
}

function put_node() {
    if (function_name != "") printf "node: { title: \"%s\" label: \"%s\\n%d bytes (static)\" }\n", function_title, function_name, frame_b
}

function put_edge(to) {
    printf "edge: { sourcename: \"%s\" targetname: \"%s\" label: \"%s\" }\n", function_title, to, place
}

/^[0-9a-f]+ <.*>:$/ {
    put_node()
    function_name = $2
    gsub(/[<>:]/, "", function_name)
    function_title = title($1, function_name)
    frame_b = 2
    next
}

# A place in the source, of what follows.
/^\/.*:[0-9]+/ || /^[a-z].*\.[chS]:[0-9]+/ { place = $1 }

$0 !~ /^ *[0-9a-f]+:\t/ { next }
{
    split($0, parts, "\t")
    operation = parts[3]
    operands = parts[4]
}
operation == "push" { frame_b++ }
operation == "rcall" && operands ~ /^\.\+0/ { frame_b += 2; next }

# The frame's place is in r29:r28; what is taken from the stack pointer just after it was read is the frame's size.
operation == "in" && operands ~ /^r2[89], 0x3[de]/ { reading = 1; next }
reading && operation == "subi" && operands ~ /^r28/ { frame_b += number(operands); next }
reading && operation == "sbci" && operands ~ /^r29/ { frame_b += 256 * number(operands) }
reading && operation == "sbiw" && operands ~ /^r28/ { frame_b += number(operands) }
{ reading = 0 }

operation ~ /^e?icall$/ || (operation ~ /^e?ijmp$/ && function_name !~ /tablejump/) { put_edge("__indirect_call") }
operation ~ /^r?(call|jmp)$/ && match($0, /0x[0-9a-f]+ <[^>+]*>/) {
    target = substr($0, RSTART, RLENGTH)
    split(target, parts, " ")
    gsub(/[<>]/, "", parts[2])
    if (parts[2] != function_name && parts[2] !~ /tablejump/) put_edge(title(parts[1], parts[2]))
}

function number(operands,   hex, i, value) {
    sub(/^r[0-9]+, 0x/, "", operands)
    sub(/[^0-9a-fA-F].*/, "", operands)
    hex = tolower(operands)
    value = 0
    for (i = 1; i <= length(hex); i++) value = 16 * value + index("0123456789abcdef", substr(hex, i, 1)) - 1
    return value
}

END { put_node() }

# SPDX-License-Identifier: MIT
#
# `limner sweep`: jobs that a shell, GNU parallel or Slurm run; what is joined is what `limner measure` says, byte by byte
# the same whoever was killed and resumed; what does not belong together is refused. Fronts are held against results that
# are written here.
. tests/tap.sh

limner=$(cd "$BUILD" && pwd)/limner
scenes=$(pwd)/sim/scenes
cd "$work" || exit 1
cp "$scenes/knot.obj" "it's a knot.obj"
cp "$scenes/glass.obj" "$scenes/glass.mtl" .

refused() { # REASON ARGUMENT...: one line that has it
    reason=$1
    shift
    "$limner" sweep "$@" >said 2>err && return 1
    cat err
    [ ! -s said ] && [ "$(wc -l <err)" -eq 1 ] && grep -Eq -- "$reason" err
}

# Jobs ----------------------------------------------------------------------------------------------------

plans() {
    "$limner" sweep "it's a knot.obj" glass.obj --no-cost --size 48x48 --camera random:1:4 --precision fast,exact --method auto,nearest -o plan >said &&
        [ "$(wc -l <plan/jobs)" -eq 8 ] && [ "$(wc -l <plan/results.list)" -eq 8 ] && grep -q '^    parallel --joblog plan/joblog' said
}
tap_check "a job for each model, method and precision" plans

merges() {
    sh plan/jobs && "$limner" sweep --merge plan >said && cat said && [ "$(wc -l <plan/sweep.csv)" -eq 9 ] && [ ! -e plan/front.csv ]
}
tap_check "sh runs them, and their results are joined" merges

as_measured() { # the third job is nearest, fast; the eighth is of glass, nearest, exact
    "$limner" measure "it's a knot.obj" --no-cost --size 48x48 --camera random:1:4 --precision fast --method nearest -o alone >/dev/null &&
        sed -n 4p plan/sweep.csv | grep -qxF "\"it's a knot.obj\",nearest,,$(sed -n 2p alone/measure.csv)" &&
        "$limner" measure glass.obj --no-cost --size 48x48 --camera random:1:4 --precision exact --method nearest -o alone >/dev/null &&
        sed -n 9p plan/sweep.csv | grep -qxF "\"glass.obj\",nearest,,$(sed -n 2p alone/measure.csv)"
}
tap_check "rows are what measure says" as_measured

# Killed and resumed ---------------------------------------------------------------------------------------

# Some jobs and GNU parallel itself are killed without a word, each time elsewhere; then what is left is run.
survives() {
    "$limner" sweep "$scenes/rooms.obj" "it's a knot.obj" glass.obj --no-cost --camera random:1:24 -o killed >/dev/null &&
        cp killed/jobs jobs.before && sh killed/jobs && "$limner" sweep --merge killed >/dev/null && cp killed/sweep.csv whole.csv && rm -r killed/results killed/sweep.csv &&
        cmp jobs.before killed/jobs || return 1
    for round in 1 2 3; do
        parallel -j 2 --joblog killed/joblog --resume-failed <killed/jobs >said 2>&1 &
        crew=$!
        for blow in 1 2 3; do
            sleep 0.$((3 * round + blow - 2))
            pgrep -f "^$limner measure.*killed/results" | sort -R | head -n 1 | while read -r victim; do kill -9 "$victim" 2>/dev/null && echo "$victim" >>victims; done
        done
        kill -9 $crew 2>/dev/null
        wait $crew 2>/dev/null
    done
    [ -s victims ] || { echo "nobody was killed"; return 1; }
    while pgrep -f "^$limner measure.*killed/results" >/dev/null; do sleep 0.2; done
    "$limner" sweep --merge killed >/dev/null 2>&1 && echo "nothing was left to do"
    parallel -j 2 --joblog killed/joblog --resume-failed <killed/jobs >said 2>&1 || { cat said; return 1; }
    "$limner" sweep --merge killed >/dev/null && cmp whole.csv killed/sweep.csv
}
if command -v parallel >/dev/null; then
    : >victims
    tap_check "jobs that were killed are resumed, and the table is the same byte by byte" survives
else
    tap_skip "jobs that were killed are resumed" "Debian's package parallel is not installed"
fi

by_slurm() {
    rm -rf plan/results && job=$(sbatch --parsable --wait plan/slurm.sh) && cp plan/sweep.csv before.csv && echo "$job" && "$limner" sweep --merge plan >/dev/null && cmp before.csv plan/sweep.csv
}
if command -v sbatch >/dev/null && sinfo -h >/dev/null 2>&1; then
    tap_check "Slurm runs them as an array" by_slurm
else
    tap_skip "Slurm runs them as an array" "no Slurm answers here (Debian's slurm-wlm)"
fi

# What an array does, without Slurm: a task is a line.
tasks() {
    rm -rf plan/results
    cp plan/sweep.csv before.csv
    for task in 8 7 6 5 4 3 2 1; do SLURM_ARRAY_TASK_ID=$task sh plan/slurm.sh || return 1; done
    "$limner" sweep --merge plan >/dev/null && cmp before.csv plan/sweep.csv
}
tap_check "a task of an array is a job" tasks

# What does not belong together ------------------------------------------------------------------------------

missing() { mv plan/results/000005 kept && refused '^limner: plan: 1 of 8 results are missing, the first is plan/results/000005; run the jobs that are left$' --merge plan; }
tap_check "a result that is missing is told" missing
cut() { head -c 300 kept >plan/results/000005 && refused 'plan/results/000005: is no whole result of a sweep' --merge plan; }
tap_check "half a result is none" cut
another() { sed 's/^version .*/version 0.0.0 other/' kept >plan/results/000005 && refused 'measured by version 0.0.0 other, others by' --merge plan; }
tap_check "another version's is refused" another
changed() {
    mv kept plan/results/000005 && cp glass.mtl glass.kept && echo '# changed' >>glass.mtl && cp plan/sweep.csv before.csv &&
        refused 'plan/results/000005: .*glass.mtl is not what was measured; run the job again' --merge plan && cmp before.csv plan/sweep.csv &&
        mv glass.kept glass.mtl && "$limner" sweep --merge plan >/dev/null
}
tap_check "what has changed since, a file that a model names, too, is refused" changed

tap_check "no model is refused" refused 'sweep: needs a model' -o none
tap_check "no folder is refused" refused 'sweep: needs -o DIR' glass.obj
tap_check "what measure refuses is refused" refused 'no such method' glass.obj --method quick -o none
tap_check "so is an option that it does not have" refused '--fast: no such option' glass.obj --fast -o none
tap_check "and a folder without jobs" refused 'none/results.list: ' --merge none
nothing_made() { [ ! -e none ]; }
tap_check "then nothing is written" nothing_made

# Fronts -------------------------------------------------------------------------------------------------------

# result NUMBER MODEL METHOD PRECISION WRONG INSTRUCTIONS
result() {
    mkdir -p front/results
    {
        printf 'limner-result 1\nversion 1\nmodel %s\nmethod %s\n\n' "$2" "$3"
        echo 'scene,precision,wrong_percent,core,instructions'
        echo "\"a, \"\"b\"\"\",$4,$5,m4,$6"
    } >"front/results/$1"
    echo "results/$1" >>front/results.list
}
# Of a: nearest fast (0.2, 100), nearest exact (0.1, 300), mesh fast (0.3, 200), which the first dominates.
# Of b: nearest fast (0.4, 300), nearest exact (0.1, 500), mesh fast (0.5, 40). Means: 0.3, 200; 0.1, 400; 0.4, 120.
result 1 a nearest fast 0.2 100
result 2 a nearest exact 0.1 300
result 3 a mesh fast 0.3 200
result 4 b nearest fast 0.4 300
result 5 b nearest exact 0.1 500
result 6 b mesh fast 0.5 40

fronts() {
    "$limner" sweep --merge front >/dev/null || return 1
    cat front/sweep.csv front/front.csv
    [ "$(sed 1d front/sweep.csv | sed 's/^"\(.\)",\([a-z]*\),\(.\),.*/\3/' | tr -d '\n')" = 110111 ] &&
        [ "$(sed 1d front/front.csv)" = "m4,nearest fast,0.300000,200.0,1
m4,nearest exact,0.100000,400.0,1
m4,mesh fast,0.400000,120.0,1" ] && [ "$(head -c 8 front/front.png | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ]
}
dominated() { # mesh fast costs 220 in the mean now, for 0.4: nearest fast is better in both
    sed -i 's/m4,40$/m4,240/' front/results/6 && "$limner" sweep --merge front >/dev/null && grep -qx 'm4,mesh fast,0.400000,220.0,0' front/front.csv && grep -qx 'm4,nearest fast,0.300000,200.0,1' front/front.csv
}
if command -v gnuplot >/dev/null; then
    tap_check "fronts of each model, the common one of means, and its picture" fronts
    tap_check "a setting that another is better than is not on it" dominated
else
    tap_skip "fronts" "Debian's package gnuplot-nox is not installed"
fi

tap_done

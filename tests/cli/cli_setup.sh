# SPDX-License-Identifier: MIT
#
# sim/tools/setup.sh asks, says and installs as it should: with stand-ins for dpkg-query, apt-get, sudo and id, in a
# system where the package `there` is installed, which provides `meant` as well.
. tests/tap.sh

unset DEPS
bin=$work/bin
mkdir "$bin"
stand_in() { # NAME: script on stdin
    { echo '#!/bin/sh' && cat; } >"$bin/$1"
    chmod +x "$bin/$1"
}
export WORK="$work"

stand_in dpkg-query <<'EOF'
echo 'installed there, other-name, meant (= 1.2)'
echo 'config-files gone, left'
EOF
stand_in id <<'EOF'
cat "$WORK/uid"
EOF
stand_in sudo <<'EOF'
echo sudo >>"$WORK/done"
exec "$@"
EOF
# Knows `there`, `wanted`, `moved` and `other`: the last only after an update, and `moved` can only then be
# fetched. Each is 1.5 MB.
stand_in apt-get <<'EOF'
for last; do :; done
case " $* " in
*" update "*) echo update >>"$WORK/done"; touch "$WORK/updated"; exit ;;
esac
case " $* " in
*" other "*) [ -e "$WORK/updated" ] || exit 100 ;;
*" nonsense "*) exit 100 ;;
esac
case " $* " in
*" --print-uris "*) echo "'http://there/x.deb' x.deb 1500000 SHA256:0" ;;
*" moved "*) echo "install $last" >>"$WORK/done"; [ -e "$WORK/updated" ] ;;
*) echo "install $last" >>"$WORK/done" ;;
esac
EOF

# setup UID PACKAGE...: runs it as that user; output and status go to $work/said, what was done to $work/done. On a
# terminal, where ANSWER is typed, if that is set; without a terminal otherwise.
setup() {
    rm -f "$work/done" "$work/updated"
    echo "$1" >"$work/uid"
    shift
    touch "$work/done"
    if [ -n "${ANSWER:-}" ]; then
        echo "$ANSWER" | PATH="$bin:$PATH" script -qec "sh sim/tools/setup.sh $*" /dev/null
    else
        PATH="$bin:$PATH" sh sim/tools/setup.sh "$@" </dev/null 2>&1
    fi >"$work/said"
    echo "status $?" >>"$work/said"
    cat "$work/said"
}

says() { grep -qF -- "$1" "$work/said"; }
did() { [ "$(paste -sd, "$work/done")" = "$1" ]; }

nothing_missing() { setup 0 there && [ "$(cat "$work/said")" = "status 0" ] && did ''; }
nothing_missing_provided() { setup 0 there meant && [ "$(cat "$work/said")" = "status 0" ] && did ''; }
root_installs() { setup 0 there wanted && says "missing packages: wanted (to download: 1.5 MB)" && says "status 0" && did 'install wanted'; }
root_updates() { setup 0 other && says "1.5 MB" && says "status 0" && did 'update,install other'; }
root_tries_again() { setup 0 moved && says "trying again" && says "status 0" && did 'install moved,update,install moved'; }
unknown_package() { setup 0 nonsense && says "nonsense" && says "status 1" && did 'update'; }
deps_no() { DEPS=no setup 0 wanted && says "wanted (to download: 1.5 MB)" && says "apt-get install" && says "status 1" && did ''; }
deps_skip() { DEPS=skip setup 0 wanted && [ "$(cat "$work/said")" = "status 0" ] && did ''; }
no_terminal() { setup 1000 wanted && says "no terminal" && says "as root: apt-get install" && says "status 1" && did ''; }
user_agrees() { ANSWER=y setup 1000 wanted && says "[y/N]" && says "status 0" && did 'sudo,install wanted'; }
user_declines() { ANSWER=n setup 1000 wanted && says "[y/N]" && says "status 1" && did ''; }
user_updates() { ANSWER=yes setup 1000 other && says "size not known" && says "status 0" && did 'sudo,sudo,update,sudo,install other'; }

tap_check "nothing is said when nothing is missing" nothing_missing
tap_check "what an installed package provides is not missing" nothing_missing_provided
tap_check "root: the missing package is named with its size and installed" root_installs
tap_check "root: lists that do not know a package are updated first" root_updates
tap_check "root: a download that fails is tried again with fresh lists" root_tries_again
tap_check "a package that apt does not have is named" unknown_package
tap_check "DEPS=no: only says" deps_no
tap_check "DEPS=skip: does not look" deps_skip
tap_check "not root, no terminal: the command to run is named" no_terminal
tap_on_terminal "not root, yes: installed through sudo" user_agrees
tap_on_terminal "not root, no: nothing is installed" user_declines
tap_on_terminal "not root, lists too old: updated after the yes" user_updates
tap_done

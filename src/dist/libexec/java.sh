# Read by ./dfra of the checkout and by bin/dfra of what is installed: which Java, and how DFRA is launched on it.
# shellcheck shell=sh

home= # of the Java that is used, once it is found

say() { printf 'dfra: %s\n' "$*" >&2; }
die() { status=$1; shift; say "$@"; exit "$status"; } # 64 usage, 69 something needed is missing, 75 try again

java_version() { # of the Java at $1, as its release file says or else itself: 17; or 0
    version=$(sed -n 's/^JAVA_VERSION="\([0-9]*\).*/\1/p' "$1/release" 2>/dev/null) || version=
    [ -n "$version" ] || version=$("$1/bin/java" -version 2>&1 | sed -n 's/.* version "\([0-9]*\).*/\1/p') || version=
    echo "${version:-0}"
}

# Sets home: JAVA_HOME's, else that of the java on the path, else one of those where systems keep them.
find_java() { # $1 the command it must have, java or javac; $2 what that makes it, for people
    on_path=$(command -v java 2>/dev/null) && on_path=$(readlink -f -- "$on_path") || on_path=
    for home in "${JAVA_HOME:-}" "${on_path%/bin/java}" /usr/lib/jvm/*; do
        if [ -n "$home" ] && [ -x "$home/bin/java" ] && [ -x "$home/bin/$1" ] && [ "$(java_version "$home")" -ge 17 ]; then
            [ -z "${JAVA_HOME:-}" ] || [ "$home" = "$JAVA_HOME" ] || say "JAVA_HOME=$JAVA_HOME is no $2 17 or newer; using $home"
            return 0
        fi
    done
    return 1
}

# Becomes DFRA. $1 the folder with config, $2 that with the jars, $3 the jar of the boot class path, $4 as what it was
# called: dfra or ./dfra; then its arguments.
launch() {
    root=$1 lib=$2 boot=$3 called=$4
    shift 4
    set -f # DFRA_OPTIONS is not quoted on purpose: options are separated by blanks, and no pattern in them names a file
    # shellcheck disable=SC2086
    exec "$home/bin/java" ${DFRA_OPTIONS:-} -XX:TieredStopAtLevel=1 -XX:CompileThresholdScaling=3 -XX:+UseSerialGC -Xshare:auto \
        "-Xbootclasspath/a:$boot" "-Ddfra.root=$root" "-Ddfra.boot=$boot" "-Ddfra.lib=$lib" "-Ddfra.called=$called" \
        -cp "$lib/*${DFRA_CLASSPATH:+:$DFRA_CLASSPATH}" org.dfra.app.Main "$@"
}

# Read by ./dfra of the checkout and by bin/dfra of what is installed: which Java, and how DFRA is launched on it.
# shellcheck shell=sh

home= # of the Java that is used, once it is found
without_archive= # whether no archive of classes is used

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
            [ -z "${JAVA_HOME:-}" ] || [ "$home" = "$JAVA_HOME" ] || say "JAVA_HOME=$JAVA_HOME has no $2 17 or newer; using $home"
            return 0
        fi
    done
    return 1
}

# Options of every Java here. What the virtual machine itself says, of an archive that does not fit say, does not belong into
# a command's output.
jvm_options='-XX:TieredStopAtLevel=1 -XX:CompileThresholdScaling=3 -XX:+UseSerialGC -Xshare:auto -Xlog:disable -Xlog:all=error:stderr -Xlog:cds*=off'

# The archive of classes with which a command starts a quarter faster (decision 052), one for each Java, for the jars in the
# folder $1. The archive of robots' processes is beside it (decision 058). It is below the folder with the jars, or in the state
# folder of a user who cannot write there. An archive is code, so one that another user has written is not used.
class_archive() {
    full=$(sed -n '/^JAVA_\(RUNTIME_\)\{0,1\}VERSION="/{s/[^"]*"\(.*\)"/\1/p;q;}' "$home/release" 2>/dev/null) || full=
    folder=$1/archive
    [ -w "$1" ] || folder=${DFRA_STATE:-${HOME:-}/.dfra}/archives$1
    echo "$folder/${full:-$(java_version "$home")}.jsa"
}

is_usable() { [ -f "$1" ] && [ -O "$1" ] && [ ! "$2" -nt "$1" ]; } # the archive $1 of the folder $2

# Writes the archives that are missing, if they can be written. $1 the folder with the jars, $2 the jar of the boot class path.
archive_classes() {
    [ -f "$1/dfra-cli.jar" ] || return 0
    # shellcheck disable=SC2086
    "$home/bin/java" $jvm_options "-Xbootclasspath/a:$2" "-Ddfra.boot-class-path=$2" "-Ddfra.lib=$1" \
        "-Ddfra.command-archive=$(class_archive "$1")" -cp "$1/*" org.dfra.cli.archive.ArchiveWriter </dev/null >/dev/null 2>&1 || :
}

# Becomes DFRA. $1 the folder with config, $2 that with the jars, $3 the jar of the boot class path, $4 as what it was
# called: dfra or ./dfra; then its arguments.
launch() {
    root=$1 lib=$2 boot=$3 called=$4
    shift 4
    main=org.dfra.cli.Main boot_property=dfra.boot-class-path name_property=dfra.command
    # The jars that a robot of an earlier DFRA runs from: stop uses them.
    [ -f "$lib/dfra-cli.jar" ] || main=org.dfra.app.Main boot_property=dfra.boot name_property=dfra.called
    archives=$(class_archive "$lib") archive=
    [ -n "$without_archive" ] || ! is_usable "$archives" "$lib" || archive=$archives
    set -f # DFRA_OPTIONS is not quoted on purpose: options are separated by blanks, and no pattern in them names a file
    # shellcheck disable=SC2086
    exec "$home/bin/java" $jvm_options ${archive:+"-XX:SharedArchiveFile=$archive"} ${DFRA_OPTIONS:-} \
        "-Xbootclasspath/a:$boot" "-Ddfra.root=$root" "-D$boot_property=$boot" "-Ddfra.lib=$lib" "-D$name_property=$called" \
        "-Ddfra.command-archive=$archives" \
        -cp "$lib/*${DFRA_CLASSPATH:+:$DFRA_CLASSPATH}" "$main" "$@"
}

# The same, for stop: if the virtual machine crashes, for which an archive may be the reason, it is started again without one.
launch_surely() {
    stopped=0
    (launch "$@") || stopped=$?
    case $stopped in
        134 | 135 | 139) # SIGABRT, SIGBUS, SIGSEGV
            without_archive=true stopped=0
            (launch "$@") || stopped=$? ;;
    esac
    return "$stopped"
}

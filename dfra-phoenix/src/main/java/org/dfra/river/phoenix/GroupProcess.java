package org.dfra.river.phoenix;

import java.io.IOException;
import java.io.ObjectOutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import java.util.stream.Stream;
import org.dfra.core.host.PrivateFiles;
import org.dfra.river.phoenix.host.ClassArchive;
import org.jspecify.annotations.Nullable;

/**
 * Starts the processes of groups, and finds running ones.
 *
 * <p>A process starts in two steps. It waits until it has read its group from its standard input.
 * The daemon writes the group only after the journal has stored the process's number. If the daemon
 * dies in between, the process exits by itself: no process runs that the journal does not know. The
 * group's ID contains phoenix's secret identity. It is sent on standard input too, since every user
 * of the computer may read command lines.
 */
final class GroupProcess {

  /** System property that identifies a group's process, {@code daemon/group}. */
  static final String GROUP_PROPERTY = "org.dfra.phoenix.group";

  /** System property with the file that the process locks. */
  static final String LOCK_PROPERTY = "org.dfra.phoenix.lock";

  /** System property with the file that the process writes its output to. */
  static final String OUTPUT_PROPERTY = "org.dfra.phoenix.output";

  private GroupProcess() {}

  /**
   * Starts a process that waits for its group on standard input.
   *
   * @throws IOException if the command does not exist or cannot be executed
   */
  static Process start(
      UUID daemon, String group, ActivationGroupDesc desc, PhoenixConfiguration configuration)
      throws IOException {
    PrivateFiles.makeFolder(configuration.outputDirectory());
    Path vmLog = configuration.outputDirectory().resolve(group + ".vm.log");
    if (Files.exists(vmLog) && Files.size(vmLog) > 0) {
      Files.move(
          vmLog, vmLog.resolveSibling(group + ".vm.log.1"), StandardCopyOption.REPLACE_EXISTING);
    }
    PrivateFiles.makeFile(vmLog);
    return new ProcessBuilder(command(daemon, group, desc, configuration))
        .redirectErrorStream(true)
        .redirectOutput(vmLog.toFile())
        .start();
  }

  /** The argument list of a group's process. */
  static List<String> command(
      UUID daemon, String group, ActivationGroupDesc desc, PhoenixConfiguration configuration) {
    List<String> command = new ArrayList<>();
    ActivationGroupDesc.@Nullable CommandEnvironment environment = desc.getCommandEnvironment();
    String path = environment == null ? null : environment.getCommandPath();
    command.add(path != null ? path : ExecPolicy.ownJava());
    command.add(mark(daemon) + group);
    if (environment != null) {
      List<String> options = List.of(environment.getCommandOptions());
      if (path == null || path.equals(ExecPolicy.ownJava())) {
        command.addAll(archiveOptions(options, configuration.groupOptions()));
      }
      command.addAll(options);
    }
    if (desc.getPropertyOverrides() != null) {
      desc.getPropertyOverrides().forEach((name, value) -> command.add("-D" + name + "=" + value));
    }
    command.addAll(configuration.groupOptions());
    command.add("-D" + LOCK_PROPERTY + "=" + lockFile(configuration, group));
    command.add("-D" + OUTPUT_PROPERTY + "=" + configuration.output(group));
    command.add(GroupVm.class.getName());
    return command;
  }

  /** Those of this Java; the journal outlives it, so it does not store them. */
  private static List<String> archiveOptions(List<String> own, List<String> forAll) {
    List<String> options = new ArrayList<>(own);
    options.addAll(forAll);
    return ClassArchive.startOptions(options);
  }

  /** Sends a started process its group; the process then continues. */
  static void sendGroup(
      Process process, ActivationGroupID id, ActivationGroupDesc desc, long incarnation)
      throws IOException {
    try (ObjectOutputStream out = new ObjectOutputStream(process.getOutputStream())) {
      out.writeObject(id);
      out.writeObject(desc);
      out.writeLong(incarnation);
    }
  }

  /** The running processes of a daemon's groups, with the groups' names. */
  static Stream<RunningProcess> findRunning(UUID daemon) {
    String mark = mark(daemon);
    return ProcessHandle.allProcesses()
        .flatMap(
            handle ->
                arguments(handle)
                    .filter(argument -> argument.startsWith(mark))
                    .findFirst()
                    .map(
                        a ->
                            new RunningProcess(
                                a.substring(mark.length()), ProcessIdentity.of(handle)))
                    .stream());
  }

  /** A running process of a group. */
  record RunningProcess(String group, ProcessIdentity process) {

    /**
     * Whether this process is the other one or its descendant. A command may be a script that runs
     * the virtual machine, and a driver may run programs of its own.
     */
    boolean isSameOrDescendantOf(ProcessIdentity other) {
      return process.equals(other)
          || Stream.iterate(
                  ProcessHandle.of(process.pid()),
                  Optional::isPresent,
                  handle -> handle.flatMap(ProcessHandle::parent))
              .anyMatch(handle -> handle.get().pid() == other.pid());
    }
  }

  /** The file that a group's process locks. */
  static Path lockFile(PhoenixConfiguration configuration, String group) {
    return configuration.persistenceDirectory().resolve(group + ".lock");
  }

  private static String mark(UUID daemon) {
    return "-D" + GROUP_PROPERTY + "=" + daemon + "/";
  }

  private static Stream<String> arguments(ProcessHandle handle) {
    Path file = Path.of("/proc", Long.toString(handle.pid()), "cmdline");
    if (Files.isReadable(file)) {
      try {
        return Stream.of(Files.readString(file, StandardCharsets.ISO_8859_1).split("\0"));
      } catch (AccessDeniedException e) {
        return Stream.empty(); // it belongs to another user, so not to this daemon
      } catch (IOException e) {
        if (Files.exists(file)) { // else it has exited meanwhile
          throw new UncheckedIOException(
              "the arguments of process " + handle.pid() + " cannot be read: " + e.getMessage(), e);
        }
        return Stream.empty();
      }
    }
    Optional<String[]> arguments = handle.info().arguments();
    return arguments.stream().flatMap(Stream::of);
  }
}

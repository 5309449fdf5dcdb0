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
import org.jspecify.annotations.Nullable;

/**
 * Starts the processes of groups and finds them again.
 *
 * <p>A process is started in two steps. It does nothing until it has read from its standard input
 * which group it is, and the daemon writes that only when the process's number is safe in the
 * journal. So a daemon that dies between the two leaves a process that ends by itself, and never
 * one that works and is not known. The group's ID has phoenix's secret identity in it; it goes by
 * that way too, since every user of the computer may read command lines.
 */
final class GroupProcess {

  /** System property by which a group's process is known, {@code daemon/group}. */
  static final String GROUP_PROPERTY = "org.dfra.phoenix.group";

  /** System property with the file that the process locks. */
  static final String LOCK_PROPERTY = "org.dfra.phoenix.lock";

  /** System property with the file that the process writes its output to. */
  static final String OUTPUT_PROPERTY = "org.dfra.phoenix.output";

  private GroupProcess() {}

  /**
   * Starts a process that waits to be told its group.
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
      command.addAll(List.of(environment.getCommandOptions()));
    }
    if (desc.getPropertyOverrides() != null) {
      desc.getPropertyOverrides().forEach((name, value) -> command.add("-D" + name + "=" + value));
    }
    command.addAll(configuration.groupOptions());
    command.add("-D" + LOCK_PROPERTY + "=" + lockFile(configuration, group));
    command.add(
        "-D" + OUTPUT_PROPERTY + "=" + configuration.outputDirectory().resolve(group + ".log"));
    command.add(GroupVm.class.getName());
    return command;
  }

  /** Tells a started process which group it is, and lets it go to work. */
  static void sendGroup(
      Process process, ActivationGroupID id, ActivationGroupDesc desc, long incarnation)
      throws IOException {
    try (ObjectOutputStream out = new ObjectOutputStream(process.getOutputStream())) {
      out.writeObject(id);
      out.writeObject(desc);
      out.writeLong(incarnation);
    }
  }

  /** The processes of a daemon's groups that run now, with the group's name. */
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
     * Whether it is this process or was started by it: a command may be a script that runs the
     * virtual machine, and a driver may run programs of its own.
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
        return Stream.empty(); // another user's, and none of this daemon's
      } catch (IOException e) {
        if (Files.exists(file)) { // else it ended meanwhile
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

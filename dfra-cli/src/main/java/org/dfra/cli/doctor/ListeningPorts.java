package org.dfra.cli.doctor;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.dfra.cli.doctor.PortCheck.PortUser;
import org.dfra.core.host.ListeningSocket;

/**
 * Finds the processes that listen on this computer's TCP ports, from Linux's /proc. On other
 * systems it only finds whether a port is in use.
 */
final class ListeningPorts implements PortCheck.PortProbe {

  private static final int LONGEST_COMMAND = 60;

  private final Path proc;

  /**
   * @param proc the folder {@code /proc}
   */
  ListeningPorts(Path proc) {
    this.proc = proc;
  }

  @Override
  public Optional<PortUser> user(int port) {
    if (!Files.isReadable(proc.resolve("net/tcp"))) {
      return isFree(port) ? Optional.empty() : Optional.of(new PortUser(-1, "", false));
    }
    Set<String> sockets =
        ListeningSocket.all(proc).stream()
            .filter(socket -> socket.port() == port)
            .map(socket -> "socket:[" + socket.inode() + "]")
            .collect(Collectors.toSet());
    return sockets.isEmpty() ? Optional.empty() : Optional.of(owner(sockets));
  }

  private static boolean isFree(int port) {
    try (ServerSocket socket = new ServerSocket()) {
      socket.bind(new InetSocketAddress(port));
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  private PortUser owner(Set<String> sockets) {
    try (DirectoryStream<Path> processes = Files.newDirectoryStream(proc, "[0-9]*")) {
      for (Path process : processes) {
        if (holds(process, sockets)) {
          String command = command(process);
          return new PortUser(
              Long.parseLong(process.getFileName().toString()),
              shortened(command),
              command.contains("org.dfra."));
        }
      }
    } catch (IOException e) {
      return new PortUser(-1, "", false); // not available
    }
    return new PortUser(-1, "", false);
  }

  private static boolean holds(Path process, Set<String> sockets) {
    try (DirectoryStream<Path> open = Files.newDirectoryStream(process.resolve("fd"))) {
      for (Path each : open) {
        if (Files.isSymbolicLink(each)
            && sockets.contains(Files.readSymbolicLink(each).toString())) {
          return true;
        }
      }
      return false;
    } catch (IOException e) {
      return false; // another user's, or it has exited
    }
  }

  private static String command(Path process) {
    try {
      return String.join(" ", List.of(Files.readString(process.resolve("cmdline")).split("\0")));
    } catch (IOException e) {
      return ""; // it has exited
    }
  }

  private static String shortened(String command) {
    return command.length() <= LONGEST_COMMAND
        ? command
        : command.substring(0, LONGEST_COMMAND) + "…";
  }
}

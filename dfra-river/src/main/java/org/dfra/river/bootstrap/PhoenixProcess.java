package org.dfra.river.bootstrap;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationSystem;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.dfra.river.call.DeadlineExceededException;
import org.dfra.river.phoenix.Phoenix;
import org.dfra.river.phoenix.PhoenixAdmin;
import org.dfra.river.phoenix.PhoenixLocator;

/**
 * Step 1 of the bootstrap: phoenix, in a process of its own.
 *
 * @param host address or name that activation proxies carry
 * @param port TCP port of the activation system
 * @param registryPort port of the read-only RMI registry, or −1 for none
 * @param state folder of phoenix's journal and of its groups' output
 */
public record PhoenixProcess(String host, int port, int registryPort, Path state) {

  private static final Duration DEADLINE = Duration.ofSeconds(10);
  private static final String MAIN = Phoenix.class.getName();
  private static final long LOOK_AGAIN_NANOS = TimeUnit.MILLISECONDS.toNanos(20);

  /** The activation system's proxy; nothing is sent before its first call. */
  public ActivationSystem system() {
    return PhoenixLocator.system(host, port, DEADLINE);
  }

  /**
   * The administrator's view of it.
   *
   * @param deadline how long each answer is awaited
   */
  public PhoenixAdmin admin(Duration deadline) {
    return (PhoenixAdmin) PhoenixLocator.system(host, port, deadline);
  }

  /** Whether a phoenix answers there. */
  public boolean answers() {
    try {
      admin().groupStatus();
      return true;
    } catch (RemoteException e) {
      return false;
    }
  }

  /**
   * Whether a phoenix answers there. One that is there and does not answer is asked again: on a
   * busy computer that is no sign of death.
   *
   * @param patience how long to ask
   */
  public boolean answers(Duration patience) {
    Patience asking = Patience.of(patience);
    while (true) {
      try {
        admin().groupStatus();
        return true;
      } catch (DeadlineExceededException e) {
        if (asking.isOver()) {
          return false;
        }
      } catch (RemoteException e) {
        return false;
      }
    }
  }

  /** The administrator's view of it. */
  public PhoenixAdmin admin() {
    return (PhoenixAdmin) system();
  }

  /**
   * The number of the process that owns the journal in the state folder; empty where none does, or
   * where the folder cannot be read.
   */
  public OptionalLong pid() {
    try {
      String owner = Files.readString(state.resolve("journal").resolve("phoenix.lock")).strip();
      Path command = Path.of("/proc", owner, "cmdline"); // ProcessHandle cuts long ones short
      boolean isPhoenix =
          !Files.exists(Path.of("/proc/self")) || Files.readString(command).contains(MAIN);
      long pid = Long.parseLong(owner);
      return isPhoenix && ProcessHandle.of(pid).isPresent()
          ? OptionalLong.of(pid)
          : OptionalLong.empty();
    } catch (IOException | NumberFormatException e) {
      return OptionalLong.empty();
    }
  }

  /** The file with what the process prints. */
  public Path log() {
    return state.resolve("phoenix.log");
  }

  /**
   * Starts the process, in a session of its own, and waits until it answers. So neither Ctrl-C in
   * the terminal of whoever starts it nor the end of that terminal ends the robots.
   *
   * @param patience how long to wait
   * @throws IOException if one answers there already, or if it cannot be started, ends or does not
   *     answer in time
   */
  public Process start(Duration patience) throws IOException {
    if (answers()) {
      throw new IOException(
          "a phoenix already answers at " + host + ":" + port + "; use it, or name another port");
    }
    makeFolder();
    Process process =
        new ProcessBuilder(command())
            .redirectErrorStream(true)
            .redirectOutput(ProcessBuilder.Redirect.appendTo(log().toFile()))
            .start();
    process.getOutputStream().close();
    long end = System.nanoTime() + patience.toNanos();
    while (!answers()) {
      if (!process.isAlive()) {
        throw new IOException(
            "phoenix ended at once (exit code " + process.exitValue() + "): " + lastWords());
      }
      if (System.nanoTime() - end > 0) {
        process.destroyForcibly();
        throw new IOException(
            "phoenix did not answer within " + patience.toSeconds() + " s; see " + log());
      }
      // A process that is no part of this one says nothing when it is ready, so this looks again.
      LockSupport.parkNanos(this, LOOK_AGAIN_NANOS);
    }
    return process;
  }

  private void makeFolder() throws IOException {
    try {
      Files.createDirectories(state);
    } catch (IOException e) {
      throw new IOException(
          "phoenix's folder "
              + state
              + " cannot be made ("
              + e
              + "); give this user the right, or phoenix another folder",
          e);
    }
  }

  /**
   * Ends phoenix and every group, and waits until it does not answer any more.
   *
   * @throws IOException if it refuses or does not end in time
   */
  public void shutdown(Duration patience) throws IOException {
    long end = System.nanoTime() + patience.toNanos();
    boolean isAccepted = false;
    while (answers()) {
      if (System.nanoTime() - end > 0) {
        throw new IOException("phoenix did not end within " + patience.toSeconds() + " s");
      }
      if (!isAccepted) {
        try {
          system().shutdown();
          isAccepted = true;
        } catch (RemoteException e) {
          if (!Patience.isWithoutAnswer(e)) {
            throw e;
          } // it is asked again as long as it is there
        }
      }
      LockSupport.parkNanos(this, LOOK_AGAIN_NANOS);
    }
  }

  private String lastWords() throws IOException {
    String said = Files.readString(log());
    int last = said.lastIndexOf(Phoenix.CANNOT_START);
    return last < 0
        ? "see " + log()
        : said.substring(last + Phoenix.CANNOT_START.length()).lines().findFirst().orElse("");
  }

  private List<String> command() {
    List<String> command = new ArrayList<>(OwnSession.prefix(System.getenv("PATH")));
    command.add(JvmCommand.java());
    command.addAll(JvmCommand.options());
    command.add(MAIN);
    String resource = "phoenix.config";
    command.add(PhoenixProcess.class.getResource(resource).toString());
    override(command, "host", quote(host));
    override(command, "port", Integer.toString(port));
    override(command, "registryPort", Integer.toString(registryPort));
    override(command, "persistenceDirectory", quote(state.resolve("journal").toString()));
    override(command, "outputDirectory", quote(state.resolve("output").toString()));
    return command;
  }

  private static void override(List<String> command, String entry, String expression) {
    command.add("org.dfra.river.phoenix." + entry + "=" + expression);
  }

  /** A text as a Jini configuration writes it. */
  static String quote(String text) {
    return '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
  }
}

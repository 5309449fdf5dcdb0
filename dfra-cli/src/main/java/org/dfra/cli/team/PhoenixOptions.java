package org.dfra.cli.team;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import java.util.OptionalLong;
import org.dfra.core.host.CommandName;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import picocli.CommandLine.Spec.Target;

/** The options for the address of this host's phoenix. A picocli mix-in. */
public final class PhoenixOptions {

  /** Timeout for phoenix to start or to end. */
  public static final Duration TIMEOUT = Duration.ofSeconds(30);

  private static final String ADDRESS = "phoenix.address";
  private static final int DEFAULT_PORT = 1198;

  /** By default phoenix has no RMI registry, which would make phoenix accessible to any user. */
  static final int REGISTRY_PORT = -1;

  private static final int LAST_PORT = 65_535;

  @Option(
      names = "--port",
      paramLabel = "PORT",
      description = "TCP port of phoenix (default: the port of its last start, or 1198).")
  private @Nullable Integer port;

  @Option(
      names = "--registry-port",
      paramLabel = "PORT",
      description =
          "Port of phoenix's read-only RMI registry, -1 for none (default ${DEFAULT-VALUE}).")
  private int registryPort = REGISTRY_PORT;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private StateOption state;

  @Spec(Target.MIXEE)
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandSpec spec;

  /** Phoenix's state folder. */
  public Path state() {
    return state.folder();
  }

  /** The phoenix that was last started with this state folder, whether it runs or not. */
  public PhoenixProcess lastStarted() throws IOException {
    PhoenixProcess last = lastStarted(state(), registryPort);
    return at(last.host(), last.port());
  }

  /** The phoenix that was last started with this state folder, if no port is given. */
  static PhoenixProcess lastStarted(Path state, int registryPort) throws IOException {
    Path file = state.resolve(ADDRESS);
    if (!Files.exists(file)) {
      return new PhoenixProcess("localhost", DEFAULT_PORT, registryPort, state);
    }
    String address = Files.readString(file).strip();
    int colon = address.lastIndexOf(':');
    return new PhoenixProcess(
        address.substring(0, colon),
        Integer.parseInt(address.substring(colon + 1)),
        registryPort,
        state);
  }

  /**
   * The running phoenix.
   *
   * @throws CommandFailure if it does not answer
   * @throws java.rmi.AccessException if it belongs to another user
   */
  public PhoenixProcess requireRunning() throws IOException {
    PhoenixProcess phoenix = lastStarted();
    phoenix.requireOwnedByUser();
    if (!phoenix.isResponding(TIMEOUT)) {
      throw new CommandFailure(
          ExitCode.NO_ANSWER,
          "no phoenix answers on port "
              + phoenix.port()
              + " of "
              + phoenix.host()
              + "; bring a robot up first: "
              + CommandName.current()
              + " up ROBOT.XML");
    }
    return phoenix;
  }

  /**
   * Starts a phoenix whose proxies contain this host, and stores its address for later commands.
   *
   * @return it, and its process
   */
  public Map.Entry<PhoenixProcess, Process> start(String host) throws IOException {
    // Groups that run already know phoenix by its former port.
    PhoenixProcess phoenix = at(host, lastStarted(state(), registryPort).port());
    Process process = phoenix.start(TIMEOUT);
    Files.writeString(addressFile(), phoenix.host() + ":" + phoenix.port());
    return Map.entry(phoenix, process);
  }

  /** Writes the process ID of a running phoenix, for a service manager that supervises it. */
  public void writePidFile(PhoenixProcess phoenix) throws IOException {
    OptionalLong pid = phoenix.pid();
    if (pid.isPresent()) {
      Files.writeString(state().resolve("phoenix.pid"), pid.getAsLong() + "\n");
    }
  }

  private PhoenixProcess at(String host, int usualPort) {
    int wanted = port == null ? usualPort : port;
    check("--port", wanted, 1);
    check("--registry-port", registryPort, -1);
    return new PhoenixProcess(host, wanted, registryPort, state());
  }

  private void check(String option, int value, int least) {
    if (value < least || value > LAST_PORT) {
      throw new ParameterException(
          spec.commandLine(),
          option + "=" + value + " is not a port from " + least + " to " + LAST_PORT);
    }
  }

  private Path addressFile() {
    return state().resolve(ADDRESS);
  }

  /** The option for the state folder on this host. A picocli mix-in. */
  public static final class StateOption {

    @Option(
        names = "--state",
        paramLabel = "FOLDER",
        description =
            "Folder of phoenix's journal and logs, and of this computer's identity (default:"
                + " DFRA_STATE, or ~/.dfra).")
    private @Nullable Path state;

    /** The folder, as an absolute path. It may not exist yet. */
    public Path folder() {
      return state == null ? defaultFolder() : state.toAbsolutePath();
    }

    /** The folder if none is named. */
    public static Path defaultFolder() {
      String variable = System.getenv("DFRA_STATE");
      return variable == null || variable.isBlank()
          ? Path.of(home(), ".dfra").toAbsolutePath()
          : Path.of(variable).toAbsolutePath();
    }

    /** The shell's meaning of ~; Java's user.home may be another folder. */
    private static String home() {
      String home = System.getenv("HOME");
      return home == null || home.isBlank() ? System.getProperty("user.home") : home;
    }
  }
}

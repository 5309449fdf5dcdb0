package org.dfra.app;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.activation.ActivationException;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotXml;
import org.dfra.river.bootstrap.HostAddress;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.loading.RobotClasses;
import org.dfra.river.phoenix.GroupStatus;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code ./dfra robot}: brings a robot's service groups up on this host, or takes phoenix down. */
@Command(
    name = "robot",
    description = "Launches a robot's service groups on this host.",
    footer = {
      "",
      "Phoenix is started where none answers, and stays when this command ends.",
      "Running it again does no harm; --down ends phoenix and every group of this",
      "host."
    })
final class RobotCommand implements Callable<Integer> {

  private static final Duration PHOENIX_PATIENCE = Duration.ofSeconds(30);
  private static final int LAST_PORT = 65_535;

  @Parameters(
      paramLabel = "ROBOT.XML",
      arity = "0..1",
      description = "The robot's description (default: the one of atrv1 that comes with DFRA).")
  private Path xml = Path.of(System.getProperty("dfra.root", ""), "config", "robots", "atrv1.xml");

  @Option(names = "--down", description = "End phoenix and every group of this host.")
  private boolean down;

  @Option(
      names = "--port",
      paramLabel = "PORT",
      description = "TCP port of phoenix on this host (default ${DEFAULT-VALUE}).")
  private int port = 1198;

  @Option(
      names = "--registry-port",
      paramLabel = "PORT",
      description =
          "Port of phoenix's read-only RMI registry, -1 for none (default ${DEFAULT-VALUE}).")
  private int registryPort = 1098;

  @Option(
      names = "--state",
      paramLabel = "FOLDER",
      description = "Where phoenix keeps its journal and logs (default ~/.dfra).")
  private Path state = Path.of(System.getProperty("user.home"), ".dfra");

  @Spec
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private CommandSpec spec;

  @Override
  public Integer call() throws IOException, ActivationException {
    check("--port", port, 1);
    check("--registry-port", registryPort, -1);
    return down ? takeDown() : bringUp();
  }

  private void check(String option, int value, int least) {
    if (value < least || value > LAST_PORT) {
      throw new ParameterException(
          spec.commandLine(),
          option + "=" + value + " is not a port from " + least + " to " + LAST_PORT);
    }
  }

  private int takeDown() throws IOException {
    PrintWriter out = spec.commandLine().getOut();
    PhoenixProcess phoenix = phoenix(lastHost());
    if (!phoenix.answers()) {
      out.println("No phoenix answers on port " + port + "; nothing is up.");
      return 0;
    }
    phoenix.shutdown(PHOENIX_PATIENCE);
    out.println("Phoenix and its groups have ended.");
    return 0;
  }

  private int bringUp() throws IOException, ActivationException {
    PrintWriter out = spec.commandLine().getOut();
    RobotDescription robot = RobotXml.read(xml);
    PhoenixProcess phoenix = phoenix(lastHost());
    if (phoenix.answers()) {
      out.println("Phoenix answers on port " + port + " of " + phoenix.host() + ".");
    } else {
      // Its address is in every proxy that brings a module back, so others must reach it too.
      phoenix = phoenix(HostAddress.resolve(robot.host()));
      long pid = phoenix.start(PHOENIX_PATIENCE).pid();
      Files.writeString(hostFile(), phoenix.host());
      out.println("Started phoenix: process " + pid + ", log " + phoenix.log() + ".");
    }
    out.flush();
    RobotBootstrap bootstrap = new RobotBootstrap(phoenix, robot);
    for (RobotBootstrap.Service service : bootstrap.up()) {
      out.println("Up: " + service.name() + " in group " + service.group() + ".");
    }
    sayClasses(bootstrap, out);
    for (GroupStatus group : phoenix.admin().groupStatus()) {
      out.println(
          "Group " + group.name() + ": process " + group.pid() + ", log " + group.output() + ".");
    }
    return 0;
  }

  /** A robot without its class server works, but not for clients that lack its classes. */
  private static void sayClasses(RobotBootstrap bootstrap, PrintWriter out) throws IOException {
    Optional<RobotClasses> classes = bootstrap.classes();
    if (classes.isPresent()) {
      String served =
          "Classes: at http://" + classes.get().host() + ":" + classes.get().port() + ".";
      out.println(classes.get().missing().map(fault -> "Classes: " + fault + ".").orElse(served));
    }
  }

  private PhoenixProcess phoenix(String host) {
    return new PhoenixProcess(host, port, registryPort, state.toAbsolutePath());
  }

  /** The host of the phoenix that was last started with this state. */
  private String lastHost() throws IOException {
    return Files.exists(hostFile()) ? Files.readString(hostFile()).strip() : "localhost";
  }

  private Path hostFile() {
    return state.resolve("phoenix.host");
  }
}

package org.dfra.river.phoenix;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.ActivationSystem;
import java.time.Duration;
import java.util.Properties;
import net.jini.config.ConfigurationFile;
import org.dfra.core.host.FreePorts;
import org.dfra.river.phoenix.stop.StopLocator;
import org.dfra.river.phoenix.stop.StopService;

/**
 * Phoenix in the test's own virtual machine, on a free port, with its journal in the test's folder.
 *
 * <p>Its groups' processes are shell scripts that do nothing, so they cost milliseconds; the test
 * plays their part with a {@link FakeGroup}.
 */
final class InVmPhoenix implements AutoCloseable {

  /** How long a test waits for what should come at once. */
  static final Duration PATIENCE = Duration.ofSeconds(30);

  final Path folder;
  private int port;
  private final String idle;
  private Phoenix phoenix;

  /**
   * @param folder where its files go
   */
  InVmPhoenix(Path folder) throws IOException {
    this.folder = folder;
    this.port = FreePorts.allocate();
    Path script = folder.resolve("idle.sh");
    Files.writeString(script, "#!/bin/sh\nexec sleep 300\n");
    Files.setPosixFilePermissions(script, PosixFilePermissions.fromString("rwx------"));
    this.idle = script.toString();
  }

  /** Starts it with further entries of its configuration. */
  InVmPhoenix start(String... entries) throws Exception {
    String exporter =
        "Exporter = new net.jini.jeri.BasicJeriExporter(org.dfra.river.call.Endpoints.tcp("
            + "\"127.0.0.1\", "
            + port
            + "), new org.dfra.river.call.DeadlineILFactory(20000L), false, true,"
            + " org.dfra.river.phoenix.";
    String secret = "(\"" + journal() + "\")); ";
    String text =
        "org.dfra.river.phoenix { persistenceDirectory = \""
            + journal()
            + "\"; registryPort = -1; permittedCommands = new String[] { \"*\" }; activator"
            + exporter
            + "PhoenixIdentities.ACTIVATOR); system"
            + exporter
            + "PhoenixIdentities.system"
            + secret
            + "monitor"
            + exporter
            + "PhoenixIdentities.monitor"
            + secret
            + "stop"
            + exporter
            + "stop.StopLocator.IDENTITY); "
            + String.join(" ", entries)
            + "}";
    phoenix = Phoenix.start(new ConfigurationFile(new StringReader(text), new String[0]));
    return this;
  }

  /** Its next start is at another address. */
  InVmPhoenix moves() throws IOException {
    port = FreePorts.allocate();
    return this;
  }

  /** Where it listens on 127.0.0.1. */
  int port() {
    return port;
  }

  StopService stopService() {
    return StopLocator.proxyAt("127.0.0.1", port, PATIENCE);
  }

  private Path journal() {
    return folder.resolve("journal");
  }

  ActivationSystem system() throws RemoteException {
    return PhoenixLocator.system("127.0.0.1", port, journal(), PATIENCE);
  }

  PhoenixAdmin admin() throws RemoteException {
    return (PhoenixAdmin) system();
  }

  /** Registers a group whose process does nothing. */
  ActivationGroupID group() throws Exception {
    return system().registerGroup(command(idle));
  }

  /**
   * The same, with a name.
   *
   * @param name {@code robot.group}
   */
  ActivationGroupID group(String name) throws Exception {
    Properties properties = new Properties();
    properties.setProperty(Phoenix.GROUP_NAME, name);
    return system()
        .registerGroup(
            new ActivationGroupDesc(
                properties, new ActivationGroupDesc.CommandEnvironment(idle, new String[0])));
  }

  /** A command that does nothing. */
  String idleCommand() {
    return idle;
  }

  /** A descriptor with a command. */
  static ActivationGroupDesc command(String path) {
    return new ActivationGroupDesc(
        null, new ActivationGroupDesc.CommandEnvironment(path, new String[0]));
  }

  /** Registers an object. */
  ActivationID object(ActivationGroupID group, boolean restart) throws Exception {
    return system().registerObject(new ActivationDesc(group, "a.B", null, null, restart));
  }

  /** What phoenix says of its n-th group. */
  GroupStatus status(int n) throws Exception {
    return admin().groupStatus().get(n);
  }

  /** Ends it, and its groups' processes. */
  @Override
  public void close() {
    if (phoenix != null) {
      phoenix.close();
      phoenix = null;
    }
  }
}

package org.dfra.cli.archive;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import net.jini.config.ConfigurationProvider;
import org.dfra.core.audit.AuditKind.SecurityMode;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotXml;
import org.dfra.core.host.FreePorts;
import org.dfra.core.host.PrivateFiles;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.identity.TeamCredentials;
import org.dfra.river.loading.TrustedCode;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.phoenix.Phoenix;
import org.dfra.river.phoenix.host.ClassArchive;
import org.dfra.river.security.SecureProcess;

/**
 * Brings up a robot of one group whose process writes the archive of robots' processes at its end.
 * The robot has a registrar and a GPS receiver that sends nothing. Everything is on the loopback
 * interface, at free ports and in a temporary folder, and without multicast, so no other program
 * finds it.
 */
final class ArchivedProcesses {

  private static final String HOST = "127.0.0.1";
  private static final Duration PATIENCE = Duration.ofSeconds(60);

  /** How long the group may take to write the archive, milliseconds. */
  private static final long WRITING_MILLIS = 120_000;

  private static final String ROBOT =
      """
      <robot xmlns="urn:dfra:robot:1" name="archive" host="127.0.0.1">
        <group name="all">
          <registrar port="${PORT}" class-server-port="off"/>
          <module name="gps" properties="gps.properties">
            <parameter name="link" value="${LINK}"/>
          </module>
        </group>
      </robot>
      """;

  private static final String MODULE =
      """
      server=org.dfra.river.server.sensor.GPSServer
      proxy=org.dfra.river.proxy.sensor.GPSProxy
      implementation=org.dfra.drivers.gps.m12.M12PlusImpl
      """;

  private ArchivedProcesses() {}

  /** The argument is the file to write, which must not exist. */
  public static void main(String[] args) throws Exception {
    SerialFilters.install();
    TrustedCode.install();
    Path folder = Files.createTempDirectory("dfra-archive-");
    try (ServerSocket receiver = new ServerSocket(0, 1, InetAddress.getByName(HOST))) {
      run(folder, receiver.getLocalPort(), Path.of(args[0]));
    } finally {
      delete(folder);
    }
    System.exit(0); // threads of the directory may still run
  }

  private static void run(Path folder, int receiver, Path archive) throws Exception {
    int port = FreePorts.allocate();
    Path state = folder.resolve("state");
    PhoenixProcess address = new PhoenixProcess(HOST, FreePorts.allocate(), -1, state);
    joinTeam(folder, state);
    RobotDescription robot = describe(folder, port, receiver);
    Phoenix phoenix = Phoenix.start(ConfigurationProvider.getInstance(settings(address, archive)));
    try {
      List<RobotBootstrap.ServiceReference> unused = new RobotBootstrap(address, robot).up();
      call(port);
      loadClasses(address);
    } finally {
      phoenix.close(); // it waits until the process has ended
    }
  }

  /**
   * Makes this process secure, and thereby the group: a secure process loads the classes of an open
   * one, and many more. A Java runtime without {@code keytool} or {@code jdk.security.auth} runs no
   * secure robot, and its archive has those of an open one only.
   */
  private static void joinTeam(Path folder, Path state) throws IOException, InterruptedException {
    PrivateFiles.makeFolder(state);
    Path work = Files.createDirectory(folder.resolve("keys"));
    Path made = folder.resolve("identity");
    try {
      ArchiveIdentity.create(work, made);
      TeamCredentials unused = IdentityFolder.load(made);
    } catch (IOException | IdentityException e) {
      return; // this Java lacks a tool or a module that it needs; the robot is open
    }
    Path identity = Files.move(made, SecureProcess.folder(state));
    SecureProcess.Installed own = SecureProcess.install(identity, false);
    if (own.mode() != SecurityMode.SECURE) {
      throw new IOException("the robot is " + own.mode() + ": " + own.fault());
    }
  }

  private static RobotDescription describe(Path folder, int port, int receiver) throws IOException {
    Files.writeString(folder.resolve("gps.properties"), MODULE);
    Path xml = Files.writeString(folder.resolve("robot.xml"), ROBOT);
    Map<String, String> values =
        Map.of("PORT", Integer.toString(port), "LINK", "tcp://" + HOST + ":" + receiver);
    return RobotXml.read(xml, values::get);
  }

  /** Phoenix's configuration. */
  private static String[] settings(PhoenixProcess phoenix, Path archive) {
    String journal = phoenix.state().resolve("journal").toString();
    String options =
        ClassArchive.writeOptions(archive).stream()
            .map(ArchivedProcesses::quote)
            .collect(Collectors.joining(", ", "new String[] {", "}"));
    return new String[] {
      "-",
      entry("host", quote(phoenix.host())),
      entry("port", Integer.toString(phoenix.port())),
      entry("persistenceDirectory", quote(journal)),
      entry("unexportTimeout", WRITING_MILLIS + "L"),
      entry("groupOptions", options)
    };
  }

  private static String entry(String name, String value) {
    return "org.dfra.river.phoenix." + name + "=" + value;
  }

  /** A text as a Jini configuration writes it. */
  private static String quote(String text) {
    return '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
  }

  /** As a client does. */
  private static void call(int port) throws Exception {
    try (JiniModuleDirectory directory =
        new JiniModuleDirectory(HOST, List.of(), List.of("jini://" + HOST + ":" + port))) {
      GPSSensor gps =
          directory
              .find(GPSSensor.class, PATIENCE)
              .orElseThrow(() -> new IOException("the module does not join its registrar"));
      Object unused = gps.readiness();
      unused = gps.parameters();
    }
  }

  /** Has the group load the classes of modules that this robot does not have. */
  private static void loadClasses(PhoenixProcess phoenix) throws ActivationException, IOException {
    @SuppressWarnings("unchecked") // as phoenix declares it
    Map<ActivationGroupID, ActivationGroupDesc> groups = phoenix.admin().getActivationGroups();
    ActivationGroupID group = groups.keySet().iterator().next(); // the only one
    ActivationDesc desc = new ActivationDesc(group, LoadedClasses.class.getName(), null, null);
    Object unused = phoenix.system().registerObject(desc).activate(false);
  }

  private static void delete(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path each : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.deleteIfExists(each);
      }
    }
  }
}

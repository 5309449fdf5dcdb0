package org.dfra.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupDesc.CommandEnvironment;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.ActivationSystem;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.awaitility.core.ConditionTimeoutException;
import org.dfra.core.host.FreePorts;
import org.dfra.river.bootstrap.JvmCommand;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.phoenix.GroupStatus;
import org.dfra.river.phoenix.Phoenix;
import org.dfra.river.phoenix.PhoenixAdmin;
import org.dfra.river.phoenix.PhoenixLocator;

/**
 * A phoenix in a process of its own that a test starts, kills and starts again.
 *
 * <pre>
 *   try (PhoenixFixture phoenix = new PhoenixFixture(folder).start()) {
 *     ActivationGroupID group = phoenix.group("gps");
 *     Beacon beacon = phoenix.beacon(group, "ok", true);
 *     phoenix.kill();
 *     phoenix.start();
 *     assertThat(phoenix.vms("gps")).hasSize(1);
 *   }
 * </pre>
 *
 * <p>It counts the groups' virtual machines itself, by their command lines, and does not ask
 * phoenix. All its processes are known by the test's folder, which their command lines name; {@link
 * #close} ends every one of them by its number, also when the test has failed.
 */
class PhoenixFixture implements AutoCloseable {

  /** How long a test waits for what takes a virtual machine's start. */
  static final Duration PATIENCE = Duration.ofSeconds(40);

  private static final String LOCK = "-Dorg.dfra.phoenix.lock=";

  final Path folder;
  final int port;
  final int registryPort;
  private final List<String> overrides;
  private List<String> wrapper = List.of();
  private boolean registry;
  private Path journal;
  private Process process;

  /**
   * @param folder where all its files go
   * @param overrides entries of its configuration, {@code name=expression} each
   */
  PhoenixFixture(Path folder, String... overrides) throws IOException {
    this.folder = folder.toRealPath();
    this.journal = this.folder.resolve("journal");
    this.port = FreePorts.allocate();
    this.registryPort = FreePorts.allocate();
    this.overrides = List.of(overrides);
  }

  /** Another folder for the journal, on a disk of its own. */
  PhoenixFixture journalIn(Path other) {
    journal = other;
    return this;
  }

  /** With the read-only registry, through which any user of this computer finds phoenix. */
  PhoenixFixture withRegistry() {
    registry = true;
    return this;
  }

  /** A command to run phoenix's own command by. */
  PhoenixFixture by(String... command) {
    wrapper = List.of(command);
    return this;
  }

  /** Starts phoenix and waits until it answers. */
  PhoenixFixture start() throws IOException {
    launch();
    try {
      await("phoenix answers").atMost(PATIENCE).pollInterval(Duration.ofMillis(20)).until(this::up);
    } catch (ConditionTimeoutException e) {
      throw new AssertionError("phoenix did not come up; it said last: " + lastLines(), e);
    }
    assertThat(process.isAlive()).as("phoenix lives; it said last: %s", lastLines()).isTrue();
    return this;
  }

  /** Starts phoenix where it will end by itself. */
  String startInVain() throws Exception {
    launch();
    assertThat(process.waitFor(PATIENCE.toSeconds(), TimeUnit.SECONDS)).as("phoenix ends").isTrue();
    assertThat(process.exitValue()).as("exit code").isEqualTo(1);
    return output();
  }

  private void launch() throws IOException {
    Files.createDirectories(folder);
    process =
        new ProcessBuilder(command())
            .redirectErrorStream(true)
            .redirectOutput(ProcessBuilder.Redirect.appendTo(log().toFile()))
            .start();
    process.getOutputStream().close();
  }

  private boolean up() {
    if (!process.isAlive()) {
      return true; // no use to wait
    }
    try {
      PhoenixAdmin quick =
          (PhoenixAdmin) PhoenixLocator.system("127.0.0.1", port, journal(), Duration.ofSeconds(2));
      quick.groupStatus();
      return true;
    } catch (RemoteException e) {
      return false;
    }
  }

  private List<String> command() {
    List<String> command = new ArrayList<>(wrapper);
    command.add(JvmCommand.java());
    command.addAll(JvmCommand.options());
    command.add(Phoenix.class.getName());
    command.add(PhoenixProcess.class.getResource("phoenix.config").toString());
    Stream.concat(
            Stream.of(
                "host=\"127.0.0.1\"",
                "port=" + port,
                "registryPort=" + (registry ? registryPort : -1),
                "persistenceDirectory=\"" + journal() + "\"",
                "outputDirectory=\"" + folder.resolve("output") + "\""),
            overrides.stream())
        .forEach(override -> command.add("org.dfra.river.phoenix." + override));
    return command;
  }

  Path journal() {
    return journal;
  }

  private Path log() {
    return folder.resolve("phoenix.log");
  }

  /** What phoenix has printed. */
  String output() {
    try {
      return Files.exists(log()) ? Files.readString(log()) : "nothing";
    } catch (IOException e) {
      return e.toString();
    }
  }

  /** The last of it comes first: what quotes a failure may quote one line only. */
  private String lastLines() {
    List<String> lines = new ArrayList<>(output().lines().toList());
    Collections.reverse(lines);
    return String.join("\n", lines.subList(0, Math.min(20, lines.size())));
  }

  /** The process itself. */
  Process process() {
    return process;
  }

  /** As {@code kill -9} does; its groups live on. */
  void kill() {
    process.destroyForcibly();
    assertThat(process.onExit().completeOnTimeout(null, 20, TimeUnit.SECONDS).join())
        .as("phoenix ended by kill -9")
        .isNotNull();
  }

  ActivationSystem system() {
    try {
      return PhoenixLocator.system("127.0.0.1", port, journal(), Duration.ofSeconds(10));
    } catch (RemoteException e) {
      throw new AssertionError("phoenix's identity cannot be read", e);
    }
  }

  PhoenixAdmin admin() {
    return (PhoenixAdmin) system();
  }

  /** Registers a group with a name. */
  ActivationGroupID group(String name, String... options) throws Exception {
    return system().registerGroup(groupDesc(name, JvmCommand.java(), options));
  }

  static ActivationGroupDesc groupDesc(String name, String command, String... options) {
    Properties properties = new Properties();
    properties.setProperty(Phoenix.GROUP_NAME, name);
    List<String> all = new ArrayList<>(JvmCommand.options());
    all.add("-Xmx48m");
    all.addAll(List.of(options));
    return new ActivationGroupDesc(
        properties, new CommandEnvironment(command, all.toArray(String[]::new)));
  }

  /** Registers a beacon; the mode is {@link BeaconImpl}'s. */
  ActivationID register(ActivationGroupID group, String mode, boolean restart) throws Exception {
    return system().registerObject(desc(group, mode, restart));
  }

  /** A beacon's descriptor. */
  static ActivationDesc desc(ActivationGroupID group, String mode, boolean restart)
      throws ActivationException, IOException {
    return new ActivationDesc(
        group, BeaconImpl.class.getName(), null, new MarshalledObject<>(mode), restart);
  }

  /** Registers a beacon and activates it. */
  Beacon beacon(ActivationGroupID group, String mode, boolean restart) throws Exception {
    return (Beacon) register(group, mode, restart).activate(false);
  }

  /** What phoenix says of the group of that name. */
  GroupStatus status(String name) throws RemoteException {
    return admin().groupStatus().stream()
        .filter(status -> status.name().endsWith("-" + name))
        .findFirst()
        .orElseThrow();
  }

  /** Waits until phoenix says this of the group. */
  GroupStatus awaitStatus(String name, java.util.function.Predicate<GroupStatus> wanted) {
    return await("status of group " + name)
        .atMost(PATIENCE)
        .pollInterval(Duration.ofMillis(10))
        .ignoreExceptionsInstanceOf(RemoteException.class)
        .until(() -> status(name), wanted);
  }

  /** The numbers of the living virtual machines of the group of that name. */
  List<Long> vms(String name) {
    return vms().getOrDefault(name, List.of());
  }

  /** The numbers of the living virtual machines of each group. */
  Map<String, List<Long>> vms() {
    String mine = LOCK + journal() + "/";
    return ProcessHandle.allProcesses()
        .flatMap(
            handle ->
                arguments(handle.pid()).stream()
                    .filter(argument -> argument.startsWith(mine))
                    .map(
                        argument ->
                            Map.entry(
                                argument.substring(
                                    argument.indexOf('-', mine.length()) + 1,
                                    argument.length() - ".lock".length()),
                                handle.pid())))
        .collect(
            Collectors.groupingBy(
                Map.Entry::getKey, Collectors.mapping(Map.Entry::getValue, Collectors.toList())));
  }

  /** A living process's arguments; a dead one has none, also while nobody has buried it. */
  static List<String> arguments(long pid) {
    try {
      return List.of(
          Files.readString(Path.of("/proc", Long.toString(pid), "cmdline"), StandardCharsets.UTF_8)
              .split("\0"));
    } catch (IOException e) {
      return List.of();
    }
  }

  /** Sends a signal by name; returns from STOP when every thread of the process has stopped. */
  static void signal(String name, long pid) throws Exception {
    Process kill = new ProcessBuilder("kill", "-" + name, Long.toString(pid)).start();
    assertThat(kill.waitFor()).as("kill -%s %s", name, pid).isZero();
    if (name.equals("STOP")) {
      await("process " + pid + " to stop")
          .atMost(PATIENCE)
          .pollInterval(Duration.ofMillis(10))
          .until(() -> states(pid).chars().allMatch(state -> state == 'T'));
    }
  }

  /** The states of a process's threads, a letter each (proc(5)). */
  private static String states(long pid) throws IOException {
    StringBuilder states = new StringBuilder();
    try (Stream<Path> tasks = Files.list(Path.of("/proc", Long.toString(pid), "task"))) {
      for (Path task : tasks.toList()) {
        states.append(state(task));
      }
    }
    return states.toString();
  }

  private static char state(Path process) throws IOException {
    String stat = Files.readString(process.resolve("stat"));
    return stat.charAt(stat.lastIndexOf(')') + 2);
  }

  /** Kills as {@code kill -9} does and waits for the end. */
  static void kill(long pid) {
    ProcessHandle.of(pid).ifPresent(ProcessHandle::destroyForcibly);
    awaitDeath(pid);
  }

  /** Waits until a process has ended, and its connections with it; it may still be unburied. */
  static void awaitDeath(long pid) {
    await("end of process " + pid)
        .atMost(PATIENCE)
        .pollInterval(Duration.ofMillis(10))
        .until(() -> hasEnded(pid));
  }

  /** A process gives its files back before it becomes a zombie, but after its command line. */
  private static boolean hasEnded(long pid) {
    try {
      char state = state(Path.of("/proc", Long.toString(pid)));
      return state == 'Z' || state == 'X';
    } catch (IOException e) {
      return true;
    }
  }

  /** The file of a beacon's device; its {@code .log} tells who opened it. */
  Path device(String name) {
    return folder.resolve(name + ".device");
  }

  /**
   * Forgets every group and ends its processes, so that the next test finds this phoenix as one
   * that has just begun. Fails where phoenix does not answer.
   */
  void clear() throws Exception {
    @SuppressWarnings("unchecked") // as phoenix declares it
    Map<ActivationGroupID, ActivationGroupDesc> groups = admin().getActivationGroups();
    for (ActivationGroupID group : groups.keySet()) {
      system().unregisterGroup(group);
    }
    vms().values().forEach(pids -> pids.forEach(PhoenixFixture::kill));
    await("phoenix without a group")
        .atMost(PATIENCE)
        .pollInterval(Duration.ofMillis(10))
        .ignoreExceptionsInstanceOf(RemoteException.class)
        .until(() -> admin().groupStatus().isEmpty() && vms().isEmpty());
  }

  /** Fails if a device ever had two owners at once. */
  void assertNoDeviceConflict() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      for (Path log : files.filter(file -> file.toString().endsWith(".device.log")).toList()) {
        assertThat(Files.readString(log)).as("%s", log).doesNotContain("CONFLICT");
      }
    }
  }

  @Override
  public void close() {
    if (process != null) {
      process.destroyForcibly();
    }
    ProcessHandle.allProcesses()
        .map(ProcessHandle::pid)
        .filter(pid -> pid != ProcessHandle.current().pid())
        .filter(pid -> arguments(pid).stream().anyMatch(a -> a.contains(folder.toString())))
        .toList()
        .forEach(PhoenixFixture::kill);
  }
}

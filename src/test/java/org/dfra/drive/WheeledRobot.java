package org.dfra.drive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.awaitility.core.ConditionFactory;
import org.dfra.app.MarkedProcesses;
import org.dfra.core.config.RobotXml;
import org.dfra.core.host.FreePorts;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.DriveCommand.Brake;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.flow.effector.LeaseRefusedByEmergencyStopException;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.call.DeadlineExceededException;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.robot.RunningPhoenix;
import org.dfra.testing.InteractiveProcess;

/**
 * The robot eta: emulated wheels, a phoenix of its own, a registrar, and the group {@code wheels}
 * with the modules that a test wants. Its drive is ready.
 */
public final class WheeledRobot implements AutoCloseable {

  public static final String HOST = "127.0.0.1";

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  /** Variables that name other robots than this one. */
  private static final List<String> OTHERS =
      List.of("DFRA_TEAM", "DFRA_LOCATORS", "DFRA_HOST", "DFRA_PHOENIX");

  /** What a command has answered. */
  public record CommandResult(int status, String text) {}

  private final Wheels wheels;
  private final RunningPhoenix phoenix;
  private final JiniModuleDirectory directory;
  private final DriveEffector drive;
  private final String locator;
  private final Path xml;

  /** Calls for a command that may miss their deadline. */
  private static final int ATTEMPTS = 3;

  /** What is to be closed, the last first. */
  private final Deque<AutoCloseable> open;

  private WheeledRobot(
      Deque<AutoCloseable> open, Path folder, String administration, String... modules)
      throws Exception {
    this.open = open;
    wheels = opened(new Wheels());
    phoenix = opened(RunningPhoenix.start(folder.resolve("phoenix")));
    int port = FreePorts.allocate();
    locator = "jini://" + HOST + ":" + port;
    xml =
        Files.writeString(
            folder.resolve("robot.xml"), described(administration, port, wheels.url(), modules));
    List<RobotBootstrap.ServiceReference> unused =
        new RobotBootstrap(phoenix.process(), RobotXml.read(xml)).up();
    phoenix.note();
    Files.writeString( // as ./dfra up does
        phoenix.process().state().resolve("phoenix.address"),
        phoenix.process().host() + ":" + phoenix.process().port());
    directory = opened(new JiniModuleDirectory(HOST, List.of(), List.of(locator)));
    drive = directory.find(DriveEffector.class, PATIENCE).orElseThrow();
    assertThat(drive.awaitReadiness(PATIENCE)).isEqualTo(Readiness.READY);
  }

  /**
   * Brings it up, or leaves nothing behind.
   *
   * @param folder of this test alone
   * @param modules of the controller: {@code drive}, and {@code odometry}, {@code battery}
   */
  public static WheeledRobot start(Path folder, String... modules) throws Exception {
    return begin(folder, "", modules);
  }

  /**
   * The same, which may be administered from one more address.
   *
   * @param administrator that address, besides the robot's own
   */
  public static WheeledRobot startAdministeredFrom(
      String administrator, Path folder, String... modules) throws Exception {
    return begin(folder, "<administration from=\"" + administrator + "\"/>", modules);
  }

  private static WheeledRobot begin(Path folder, String administration, String... modules)
      throws Exception {
    Deque<AutoCloseable> open = new ArrayDeque<>();
    try {
      return new WheeledRobot(open, folder, administration, modules);
    } catch (Exception | AssertionError e) {
      try {
        close(open);
      } catch (Exception left) {
        e.addSuppressed(left);
      }
      throw e;
    }
  }

  private <C extends AutoCloseable> C opened(C each) {
    open.push(each);
    return each;
  }

  private static String described(String administration, int port, String link, String... modules) {
    String properties = System.getProperty("dfra.root") + "/config/modules/rflex-%s.properties";
    return """
    <robot xmlns="urn:dfra:robot:1" name="eta" host="127.0.0.1">
      %s
      <group name="lookup"><registrar port="%d"/></group>
      <group name="wheels">
    %s
      </group>
    </robot>
    """
        .formatted(
            administration,
            port,
            Arrays.stream(modules)
                .map(
                    name ->
                        """
                        <module name="%s" properties="%s">
                          <parameter name="link" value="%s"/>
                        </module>
                        """
                            .formatted(name, properties.formatted(name), link))
                .collect(Collectors.joining()));
  }

  public Wheels wheels() {
    return wheels;
  }

  public RunningPhoenix phoenix() {
    return phoenix;
  }

  JiniModuleDirectory directory() {
    return directory;
  }

  public DriveEffector drive() {
    return drive;
  }

  /** That of its registrar. */
  public String locator() {
    return locator;
  }

  /** Its description. */
  Path xml() {
    return xml;
  }

  /** The option of {@code ./dfra stop} that names its phoenix. */
  public String phoenixOption() {
    return "--phoenix=" + phoenix.process().host() + ":" + phoenix.process().port();
  }

  public void awaitFullSpeed() {
    await().atMost(PATIENCE).until(() -> wheels.speed() > 0.9);
  }

  /** Sends a signal to the process of a group. */
  public void signal(String name, String group) throws Exception {
    signal(name, phoenix.group(group).pid());
  }

  /** Sends a signal to a process. */
  static void signal(String name, long pid) throws Exception {
    Process kill = new ProcessBuilder("kill", "-" + name, Long.toString(pid)).start();
    assertThat(kill.waitFor()).isZero();
  }

  /** What {@code ./dfra} answers that knows the robots of this phoenix, and no others. */
  CommandResult dfra(String... words) throws Exception {
    return process(phoenix.process().state(), words);
  }

  /** What {@code ./dfra stop} answers on a computer that knows no robot: it asks this registrar. */
  public CommandResult stopFromElsewhere(Path state, String... words) throws Exception {
    List<String> all = new ArrayList<>(List.of("stop", "--team=", "--host=" + HOST));
    all.addAll(List.of("--wait=20", "--locator=" + locator));
    all.addAll(List.of(words));
    return process(state, all.toArray(String[]::new));
  }

  private static CommandResult process(Path state, String... words) throws Exception {
    List<String> command =
        new ArrayList<>(InteractiveProcess.java(System.getProperty("java.class.path"), List.of()));
    command.add("org.dfra.cli.Main");
    command.addAll(List.of(words));
    command.add("--state=" + state);
    ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
    builder.environment().keySet().removeAll(OTHERS);
    Process asked = builder.start();
    String text = new String(asked.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    return new CommandResult(asked.waitFor(), text);
  }

  /**
   * The same answer, given in the test's own virtual machine: for commands whose process is seen in
   * another test, since to start one costs a second of processor time. Where the environment names
   * other robots it is a process all the same, so that none of them is reached.
   */
  CommandResult dfraHere(String... words) throws Exception {
    if (!Collections.disjoint(System.getenv().keySet(), OTHERS)) {
      return dfra(words);
    }
    MarkedProcesses.Outcome outcome =
        MarkedProcesses.here(with("--state=" + phoenix.process().state(), words));
    return new CommandResult(outcome.exit(), outcome.out() + outcome.err());
  }

  /** {@link #dfra} of a command that looks for robots: by this robot's registrar alone. */
  CommandResult ask(String... words) throws Exception {
    return dfra(thisRobot(words));
  }

  /** {@link #dfraHere} of a command that looks for robots: by this robot's registrar alone. */
  CommandResult askHere(String... words) throws Exception {
    return dfraHere(thisRobot(words));
  }

  private static String[] thisRobot(String... words) {
    return with("--wait=20", with("--host=" + HOST, with("--team=", words)));
  }

  private static String[] with(String option, String... words) {
    return Stream.concat(Arrays.stream(words), Stream.of(option)).toArray(String[]::new);
  }

  /**
   * Makes it as it was at first, for the next test that shares it: its drive ready and released,
   * its wheels stopped and braked, and nobody in command of them.
   */
  public void reset() throws Exception {
    phoenix.note();
    patiently()
        .until(
            () -> {
              EmergencyStopState now = drive.emergencyStopState();
              return !(now.latched() ? drive.releaseEmergencyStop("the next test") : now).latched();
            });
    assertThat(drive.awaitReadiness(PATIENCE)).isIn(Readiness.READY, Readiness.ACTIVE);
    patiently().until(() -> drive.driveState().commander() == null);
    patiently().until(() -> wheels.standingSince() != null);
    try (CommandLease lease = drive.acquireCommandLease(PATIENCE)) {
      drive.execute(lease.key(), new Brake(true));
    }
    patiently()
        .until(
            () ->
                drive.driveState().commander() == null && drive.driveState().parkingBrakeEngaged());
    phoenix.note();
  }

  /**
   * Drives straight on until it is closed. On a busy machine the call for the command may miss its
   * deadline; then it is made again, once the lease is over that the first may have been granted.
   * An order of the previous test may arrive late too, by a phoenix that pursues it in a group that
   * was killed; then the drive is released once more.
   */
  public Commander driven(Duration lease, Velocity velocity) throws Exception {
    for (int attempt = 1; ; attempt++) {
      try {
        return new Commander(drive, lease, velocity);
      } catch (DeadlineExceededException | LeaseRefusedByEmergencyStopException e) {
        if (attempt == ATTEMPTS) {
          throw e;
        }
        reset();
      }
    }
  }

  /** On a busy machine a reading may be too old for a moment, and a call miss its deadline. */
  static ConditionFactory patiently() {
    return await()
        .atMost(PATIENCE)
        .ignoreExceptionsMatching(
            e -> e instanceof RemoteException || e instanceof NotReadyException);
  }

  @Override
  public void close() throws Exception {
    close(open);
  }

  /** Closes all, also where one cannot be. */
  private static void close(Deque<AutoCloseable> open) throws Exception {
    Exception failure = null;
    while (!open.isEmpty()) {
      try {
        open.pop().close();
      } catch (Exception e) { // the others must end too
        if (failure == null) {
          failure = e;
        } else {
          failure.addSuppressed(e);
        }
      }
    }
    if (failure != null) {
      throw failure;
    }
  }
}

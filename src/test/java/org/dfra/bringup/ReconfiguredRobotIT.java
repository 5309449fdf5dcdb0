package org.dfra.bringup;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;
import static org.dfra.bringup.ThermometerRobot.HOST;
import static org.dfra.bringup.ThermometerRobot.group;
import static org.dfra.bringup.ThermometerRobot.registrar;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.activation.ActivationException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.host.FreePorts;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.river.bootstrap.PhoenixInventory;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.bootstrap.RobotDescriptionStore;
import org.dfra.river.bootstrap.RobotRemoval;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.robot.RunningPhoenix;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;

/**
 * A robot whose description is changed between two bringings up, under a phoenix that runs: a
 * registrar in group {@code lookup}, a drive with one device and an eye in other groups.
 */
class ReconfiguredRobotIT {

  private static final Duration PATIENCE = Duration.ofSeconds(60);

  @TempDir static Path folder;

  private static RunningPhoenix phoenix;
  private static int port;
  private static ThermometerRobot mu;
  private JiniModuleDirectory directory;

  @BeforeAll
  static void startPhoenix() throws IOException {
    phoenix = RunningPhoenix.start(folder.resolve("phoenix"));
    PhoenixProcess process = phoenix.process();
    Files.writeString(
        process.state().resolve("phoenix.address"), process.host() + ":" + process.port());
    port = FreePorts.allocate();
    mu = new ThermometerRobot("mu", phoenix, folder, group("lookup", registrar(port)));
  }

  @AfterAll
  static void endPhoenix() throws IOException {
    try (RunningPhoenix ended = phoenix) {
      assertThat(ended).isNotNull();
    }
  }

  @BeforeEach
  void bringUp() throws Exception {
    mu.up(mu.drive(1, "one") + mu.eye(1, "two"));
    directory = new JiniModuleDirectory(HOST, List.of(), List.of("jini://" + HOST + ":" + port));
    mu.steps().clear();
  }

  @AfterEach
  void nothingHadTwoDrivers() {
    directory.close();
    assertThat(DeviceInUseImpl.twice(mu.device("drive"))).doesNotExist();
    assertThat(DeviceInUseImpl.twice(mu.device("eye"))).doesNotExist();
  }

  private ModuleListing<Thermometer> listed(String name) throws InterruptedException {
    return directory
        .findFirst(ModuleQuery.of(Thermometer.class).robot("mu").name(name), PATIENCE)
        .orElseThrow();
  }

  private void awaitCelsius(String name, double celsius) {
    await()
        .atMost(PATIENCE)
        .ignoreExceptions() // the directory may still list the former one
        .until(() -> listed(name).module().celsius() == celsius);
  }

  @Test
  void aModuleInAnotherGroupEndsInItsFormerOneFirstAndKeepsItsIdentity() throws Exception {
    UUID id = listed("drive").id();

    mu.up(group("two", mu.module("drive", 5) + mu.module("eye", 1)));

    assertThat(mu.steps())
        .containsExactly(
            "GROUP_ENDED mu.one one",
            "UNCHANGED mu/registrar lookup",
            "MOVED mu/drive two one",
            "UNCHANGED mu/eye two");
    assertThat(mu.device("drive")).as("a driver has it").exists();
    awaitCelsius("drive", 5);
    assertThat(listed("drive").id()).isEqualTo(id);
    assertThat(groups()).containsExactly("mu.lookup", "mu.two");

    mu.steps().clear();
    // Back again, while phoenix is about to start it in its former group.
    phoenix.kill("mu.two");
    mu.up(mu.drive(6, "one") + mu.eye(1, "two"));
    assertThat(mu.steps()).contains("MOVED mu/drive one two");
    awaitCelsius("drive", 6);
    assertThat(listed("drive").id()).isEqualTo(id);
  }

  @Test
  @EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "has a sibling")
  void whatTheDescriptionDoesNotNameAnyMoreEnds() throws Exception {
    assertThat(listed("eye").module().celsius()).isEqualTo(1);

    mu.up(mu.drive(1, "one") + group("two", ""));

    assertThat(mu.steps()).contains("ENDED mu/eye two", "UNCHANGED mu/drive one");
    assertThat(mu.device("eye")).doesNotExist();
    assertThat(mu.device("drive")).exists();
    await()
        .atMost(PATIENCE)
        .until(() -> directory.find(ModuleQuery.of(Thermometer.class).name("eye")).isEmpty());
  }

  /** As a user types it, and reads what was done. */
  @Test
  void upSaysWhatItMovedEndedAndTookFromAVariable() throws Exception {
    String variable = "DFRA_MU_EYE_LINK";
    String linked =
        mu.module("eye", 1)
            .replace(mu.device("eye").toString(), "${" + variable + ":-" + mu.device("eye") + "}");
    Path xml = mu.xml(group("two", mu.module("drive", 1) + linked));
    System.setProperty(variable, mu.device("other").toString()); // as an environment variable
    try {
      assertThat(mu.dfra("up", xml.toString()))
          .contains(
              "Ended: group mu.one; the robot's XML does not have it any more.",
              "Kept: mu/registrar in group lookup; nothing of it has changed.",
              "Moved: mu/drive in group two; it was in group one.",
              "Restarted: mu/eye in group two; changed: parameter device.");
    } finally {
      System.clearProperty(variable);
    }
    String process = Long.toString(phoenix.group("mu.two").pid());
    assertThat(mu.device("drive")).as("one process has it").hasContent(process);
    assertThat(mu.device("other")).hasContent(process);
    assertThat(mu.device("eye")).doesNotExist();

    mu.xml(mu.drive(1, "two"));
    assertThat(mu.dfra("up", xml.toString()))
        .contains(
            "Ended: mu/eye in group two; the robot's XML does not have it there any more.",
            "Kept: mu/drive in group two; nothing of it has changed.");
    assertThat(mu.device("other")).doesNotExist();
    assertThat(mu.device("drive")).hasContent(process);
    assertThat(mu.dfra("status", xml.toString()))
        .containsPattern("mu\\.two +active +" + process + " +\\d+ +\\d+ +drive\n");
  }

  @Test
  void onlyWhatWasChangedIsRestarted() throws Exception {
    Thermometer drive = listed("drive").module();
    long process = phoenix.group("mu.two").pid();

    mu.up(mu.drive(7, "one") + "<!-- further down -->\n\n" + mu.eye(1, "two"));

    assertThat(mu.steps())
        .containsExactly(
            "UNCHANGED mu/registrar lookup",
            "RESTARTED mu/drive one parameter celsius",
            "UNCHANGED mu/eye two");
    assertThat(drive.celsius()).as("through the proxy from before").isEqualTo(7);
    assertThat(phoenix.group("mu.two").pid()).isEqualTo(process);

    mu.steps().clear();
    mu.up(
        mu.drive(7, "one")
            + "<group name=\"two\"><jvm-option>-Xmx64m</jvm-option>"
            + mu.module("eye", 1)
            + "</group>");
    assertThat(mu.steps()).contains("UNCHANGED mu/eye two", "GROUP_STALE mu.two two");
    assertThat(phoenix.group("mu.two").pid()).as("it works on").isEqualTo(process);
  }

  @Test
  void aRegistrarThatMissesItsDeadlineIsAskedAgain() throws Exception {
    long registrar = phoenix.group("mu.lookup").pid();
    ScheduledExecutorService later = Executors.newSingleThreadScheduledExecutor();
    signal("STOP", registrar);
    try {
      var unused = later.schedule(() -> signal("CONT", registrar), 4, TimeUnit.SECONDS);
      mu.up(mu.drive(1, "one") + mu.eye(1, "two"));
    } finally {
      later.shutdownNow();
      signal("CONT", registrar);
    }
    assertThat(mu.steps()).contains("UNCHANGED mu/registrar lookup", "UNCHANGED mu/drive one");
  }

  private static Process signal(String name, long pid) throws IOException {
    return new ProcessBuilder("kill", "-" + name, Long.toString(pid)).start();
  }

  @Test
  void aPortOfAnotherRobotIsNamedWithItAndNothingIsLeftOfTheOneThatDidNotStart() throws Exception {
    ThermometerRobot nu = new ThermometerRobot("nu", phoenix, folder, "");
    assertThatThrownBy(() -> nu.up(group("lookup", registrar(port))))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            folder.resolve("nu.xml")
                + ":3: nu/registrar cannot start: port "
                + port
                + " is used by robot mu's registrar; give one of the two another port, or"
                + " ./dfra down mu");
    String lamp = nu.module("lamp", 9);
    try (var taken = new ServerSocket(0, 0, InetAddress.getByName(HOST))) {
      String registrar = registrar(taken.getLocalPort());
      String why = "nu/registrar did not start: port " + taken.getLocalPort();
      assertThatThrownBy(() -> nu.up(group("lookup", registrar + lamp))).hasMessageContaining(why);
      assertThat(groups()).noneMatch(name -> name.startsWith("nu."));
      assertThat(new RobotDescriptionStore(phoenix.process().state()).contains("nu")).isFalse();

      nu.up(group("lookup", lamp));
      assertThatThrownBy(() -> nu.up(group("lookup", registrar + lamp))).hasMessageContaining(why);
      assertThat(mu.dfra("status", folder.resolve("nu.xml").toString()))
          .as("the module works on, and there is no registrar")
          .containsPattern("nu\\.lookup +active +\\d+ +1 +0 +lamp\n")
          .doesNotContain("registrar");
    } finally {
      RobotRemoval.removeRobot(phoenix.process(), "nu", PATIENCE);
    }
  }

  @Test
  void whatIsTakenDownIsForgottenAndComesBackAsTheSame() throws Exception {
    UUID id = listed("drive").id();
    List<ProcessHandle> processes = new ArrayList<>();
    for (String group : List.of("mu.lookup", "mu.one", "mu.two")) {
      processes.add(ProcessHandle.of(phoenix.group(group).pid()).orElseThrow());
    }

    assertThat(mu.dfra("down", "mu")).isEqualToIgnoringNewLines("mu is down.");

    assertThat(mu.dfra("status"))
        .startsWith("Phoenix answers, but no such robot is up on this host.");
    assertThat(processes).noneMatch(ProcessHandle::isAlive);
    assertThat(groups()).noneMatch(name -> name.startsWith("mu."));
    assertThat(mu.device("drive")).doesNotExist();
    assertThat(phoenix.process().admin().groupStatus()).isEmpty();

    mu.up(mu.drive(2, "one") + mu.eye(1, "two"));
    awaitCelsius("drive", 2);
    assertThat(listed("drive").id()).isEqualTo(id);
  }

  @Test
  void whatAnInterruptedDownLeftRunningEndsBeforeAnotherDriverHasItsDevice() throws Exception {
    awaitCelsius("drive", 1);
    List<ProcessHandle> left = new ArrayList<>();
    for (String group : List.of("mu.one", "mu.two")) {
      left.add(ProcessHandle.of(phoenix.group(group).pid()).orElseThrow());
    }
    mu.unregister(""); // what down does first; then somebody presses Ctrl-C

    mu.up(group("one", mu.module("eye", 3)) + group("two", mu.module("drive", 3)));

    assertThat(mu.steps())
        .containsSubsequence(
            "PROCESS_ENDED mu.one one 1", "PROCESS_ENDED mu.two two 1", "STARTED mu/eye one");
    assertThat(left).noneMatch(ProcessHandle::isAlive);
    awaitCelsius("drive", 3);
  }

  /** What of it belongs to a robot that is described under another name now. */
  @Test
  void whatAnInterruptedDownOfAnotherRobotLeftRunningEndsToo() throws Exception {
    awaitCelsius("drive", 1);
    ProcessHandle left = ProcessHandle.of(phoenix.group("mu.one").pid()).orElseThrow();
    mu.unregister("one");
    ThermometerRobot nu = new ThermometerRobot("nu", phoenix, folder, "");
    try {
      nu.up(nu.drive(4, "one"));
      assertThat(nu.steps()).containsExactly("PROCESS_ENDED mu.one one 1", "STARTED nu/drive one");
      assertThat(left.isAlive()).isFalse();
    } finally {
      RobotRemoval.removeRobot(phoenix.process(), "nu", PATIENCE);
    }
  }

  /** What {@code module add} and its siblings do; the drive's driver still has the device. */
  @Test
  void modulesThatExchangeTheirDevicesBothEndBeforeEitherStarts() throws Exception {
    awaitCelsius("drive", 1);
    awaitCelsius("eye", 1);
    mu.up(group("one", mu.module("drive", 2, "eye")) + group("two", mu.module("eye", 2, "drive")));
    awaitCelsius("drive", 2);
    awaitCelsius("eye", 2);
    assertThat(mu.steps()).filteredOn(step -> step.startsWith("RESTARTED")).hasSize(2);
  }

  @Test
  @EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "has a sibling")
  void aNewModuleStartsWhenTheOneThatHadItsDeviceHasEnded() throws Exception {
    awaitCelsius("drive", 1);
    mu.up(
        group("mast", mu.module("mast", 4, "drive"))
            + group("one", mu.module("drive", 3, "other")));
    awaitCelsius("mast", 4);
    awaitCelsius("drive", 3);
  }

  @Test
  void nothingNewIsStartedWhereADriverDoesNotEnd() throws Exception {
    awaitCelsius("drive", 1);
    awaitCelsius("eye", 1);
    String exchanged =
        group("one", mu.module("drive", 2, "eye")) + group("two", mu.module("eye", 2, "drive"));
    long pid = phoenix.group("mu.one").pid();
    assertThat(signal("STOP", pid).waitFor()).isZero();
    try {
      assertThatThrownBy(() -> mu.up(exchanged + group("mast", mu.module("mast", 4))))
          .isInstanceOf(ActivationException.class)
          .hasMessageContaining("mu/drive may still work in group one: ")
          .hasMessageContaining("mu/eye is not started: what did not end may have its device")
          .hasMessageContaining("mu/mast is not started: ");
      assertThat(phoenix.group("mu.mast").pid()).isNegative();
    } finally {
      assertThat(signal("CONT", pid).waitFor()).isZero();
    }
    mu.up(exchanged);
    awaitCelsius("drive", 2);
    awaitCelsius("eye", 2);
  }

  @Test
  void noSingleModuleIsStartedBesideADriverThatPhoenixHasForgotten() throws Exception {
    awaitCelsius("drive", 1);
    ProcessHandle left = forgetDrive();
    RobotDescription mast = mu.described(group("one", mu.module("mast", 4, "drive")));
    RobotBootstrap robot = new RobotBootstrap(phoenix.process(), mast);
    RobotBootstrap.ServiceReference unused = robot.add(mast.modules().get(0), "one");
    assertThat(left.isAlive()).isFalse();
    awaitCelsius("mast", 4);

    robot.remove("mast");
    RobotDescription eye = mu.described(group("two", mu.module("eye", 5, "drive")));
    mu.up(mu.drive(1, "one") + mu.eye(1, "two"));
    left = forgetDrive();
    unused = robot.replace(eye.modules().get(0));
    assertThat(left.isAlive()).isFalse();
    awaitCelsius("eye", 5);

    robot.remove("eye"); // it has the drive's device
    mu.up(mu.drive(1, "one") + mu.eye(1, "two"));
    left = forgetDrive();
    robot.start("eye");
    assertThat(left.isAlive()).isFalse();
  }

  /** Phoenix forgets the drive, whose process goes on. */
  private static ProcessHandle forgetDrive() throws Exception {
    ProcessHandle process = ProcessHandle.of(phoenix.group("mu.one").pid()).orElseThrow();
    mu.unregister("one");
    assertThat(process.isAlive()).isTrue();
    return process;
  }

  private static List<String> groups() throws Exception {
    return PhoenixInventory.groups(phoenix.process(), PATIENCE).stream()
        .map(each -> each.robot() + "." + each.name())
        .toList();
  }
}

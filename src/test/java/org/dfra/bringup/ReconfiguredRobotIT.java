package org.dfra.bringup;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.dfra.app.InProcessCommand;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotXml;
import org.dfra.core.host.FreePorts;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.river.bootstrap.BringUpStep;
import org.dfra.river.bootstrap.Inventory;
import org.dfra.river.bootstrap.KnownRobots;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.bootstrap.RobotRemoval;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.phoenix.Phoenix;
import org.dfra.river.phoenix.PhoenixAdmin;
import org.dfra.robot.LivingPhoenix;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * A robot whose description is changed between two bringings up, under a phoenix that runs: a
 * registrar in group {@code lookup}, a drive with one device and an eye in other groups.
 */
class ReconfiguredRobotIT {

  private static final String HOST = "127.0.0.1";
  private static final Duration PATIENCE = Duration.ofSeconds(60);

  @TempDir static Path folder;

  private static LivingPhoenix phoenix;
  private static int port;
  private final List<String> steps = new ArrayList<>();
  private JiniModuleDirectory directory;

  @BeforeAll
  static void startPhoenix() throws IOException {
    phoenix = LivingPhoenix.start(folder.resolve("phoenix"));
    PhoenixProcess process = phoenix.process();
    Files.writeString(
        process.state().resolve("phoenix.address"), process.host() + ":" + process.port());
    port = FreePorts.next();
  }

  @AfterAll
  static void endPhoenix() throws IOException {
    try (LivingPhoenix ended = phoenix) {
      assertThat(ended).isNotNull();
    }
  }

  @BeforeEach
  void bringUp() throws Exception {
    up(drive(1, "one") + eye(1, "two"));
    directory = new JiniModuleDirectory(HOST, List.of(), List.of("jini://" + HOST + ":" + port));
    steps.clear();
  }

  @AfterEach
  void nothingHadTwoDrivers() {
    directory.close();
    assertThat(DeviceInUseImpl.twice(device("drive"))).doesNotExist();
    assertThat(DeviceInUseImpl.twice(device("eye"))).doesNotExist();
  }

  private static Path device(String name) {
    return folder.resolve(name + ".device");
  }

  private static String drive(int celsius, String group) {
    return group(group, module("drive", celsius));
  }

  private static String eye(int celsius, String group) {
    return group(group, module("eye", celsius));
  }

  private static String group(String name, String content) {
    return "<group name=\"" + name + "\">\n" + content + "</group>\n";
  }

  private static String module(String name, int celsius) {
    return module(name, celsius, name);
  }

  private static String module(String name, int celsius, String device) {
    return """
    <module name="%s" server="%s" proxy="%s" driver="%s">
      <parameter name="celsius" value="%d"/>
      <parameter name="device" value="%s"/>
    </module>
    """
        .formatted(
            name,
            ThermometerServer.class.getName(),
            ThermometerProxy.class.getName(),
            DeviceInUseImpl.class.getName(),
            celsius,
            device(device));
  }

  /** Brings robot mu up with these groups beside that of its registrar. */
  private void up(String groups) throws Exception {
    up("mu", lookup() + groups);
  }

  private static String lookup() {
    return group("lookup", "<registrar port=\"" + port + "\" classes=\"off\"/>\n");
  }

  private void up(String robot, String groups) throws Exception {
    RobotDescription description = described(robot, groups);
    try {
      List<RobotBootstrap.Service> unused =
          new RobotBootstrap(phoenix.process(), description).up(step -> steps.add(inWords(step)));
    } finally {
      phoenix.note();
    }
  }

  private static RobotDescription described(String robot, String groups) throws IOException {
    return RobotXml.read(xml(robot, groups));
  }

  private static Path xml(String robot, String groups) throws IOException {
    return Files.writeString(
        folder.resolve(robot + ".xml"),
        "<robot xmlns=\"urn:dfra:robot:1\" name=\"%s\" host=\"%s\">\n%s</robot>\n"
            .formatted(robot, HOST, groups));
  }

  /** What {@code ./dfra} answers, which is run here. */
  private static String dfra(String... words) {
    String state = "--state=" + phoenix.process().state();
    InProcessCommand run =
        InProcessCommand.run(
            Stream.concat(Stream.of(words), Stream.of(state)).toArray(String[]::new));
    phoenix.note();
    assertThat(run.code()).as(run.out() + run.err()).isZero();
    assertThat(run.out() + run.err()).as("in a pipe").doesNotContainPattern("[\\p{Cntrl}&&[^\\n]]");
    return run.out();
  }

  private static String inWords(BringUpStep step) {
    return (step.kind() + " " + step.name() + " " + step.group() + " " + step.detail()).strip();
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

    up(group("two", module("drive", 5) + module("eye", 1)));

    assertThat(steps)
        .containsExactly(
            "GROUP_ENDED mu.one one",
            "KEPT mu/registrar lookup",
            "MOVED mu/drive two one",
            "KEPT mu/eye two");
    assertThat(device("drive")).as("a driver has it").exists();
    awaitCelsius("drive", 5);
    assertThat(listed("drive").id()).isEqualTo(id);
    assertThat(groups()).containsExactly("mu.lookup", "mu.two");

    steps.clear();
    // Back again, while phoenix is about to start it in its former group.
    phoenix.kill("mu.two");
    up(drive(6, "one") + eye(1, "two"));
    assertThat(steps).contains("MOVED mu/drive one two");
    awaitCelsius("drive", 6);
    assertThat(listed("drive").id()).isEqualTo(id);
  }

  @Test
  void whatTheDescriptionDoesNotNameAnyMoreEnds() throws Exception {
    assertThat(listed("eye").module().celsius()).isEqualTo(1);

    up(drive(1, "one") + group("two", ""));

    assertThat(steps).contains("ENDED mu/eye two", "KEPT mu/drive one");
    assertThat(device("eye")).doesNotExist();
    assertThat(device("drive")).exists();
    await()
        .atMost(PATIENCE)
        .until(() -> directory.find(ModuleQuery.of(Thermometer.class).name("eye")).isEmpty());
  }

  /** As a user types it, and reads what was done. */
  @Test
  void upSaysWhatItMovedEndedAndTookFromAVariable() throws Exception {
    String variable = "DFRA_MU_EYE_LINK";
    String linked =
        module("eye", 1)
            .replace(device("eye").toString(), "${" + variable + ":-" + device("eye") + "}");
    Path xml = xml("mu", lookup() + group("two", module("drive", 1) + linked));
    System.setProperty(variable, device("other").toString()); // as an environment variable
    try {
      assertThat(dfra("up", xml.toString()))
          .contains(
              "Ended: group mu.one; the robot's XML does not have it any more.",
              "Kept: mu/registrar in group lookup; nothing of it has changed.",
              "Moved: mu/drive in group two; it was in group one.",
              "Restarted: mu/eye in group two; changed: parameter device.");
    } finally {
      System.clearProperty(variable);
    }
    String process = Long.toString(phoenix.group("mu.two").pid());
    assertThat(device("drive")).as("one process has it").hasContent(process);
    assertThat(device("other")).hasContent(process);
    assertThat(device("eye")).doesNotExist();

    xml("mu", lookup() + drive(1, "two"));
    assertThat(dfra("up", xml.toString()))
        .contains(
            "Ended: mu/eye in group two; the robot's XML does not have it there any more.",
            "Kept: mu/drive in group two; nothing of it has changed.");
    assertThat(device("other")).doesNotExist();
    assertThat(device("drive")).hasContent(process);
    assertThat(dfra("status", xml.toString()))
        .containsPattern("mu\\.two +active +" + process + " +\\d+ +\\d+ +drive\n");
  }

  @Test
  void onlyWhatWasChangedIsStartedAnew() throws Exception {
    Thermometer drive = listed("drive").module();
    long process = phoenix.group("mu.two").pid();

    up(drive(7, "one") + "<!-- further down -->\n\n" + eye(1, "two"));

    assertThat(steps)
        .containsExactly(
            "KEPT mu/registrar lookup",
            "RESTARTED mu/drive one parameter celsius",
            "KEPT mu/eye two");
    assertThat(drive.celsius()).as("through the proxy from before").isEqualTo(7);
    assertThat(phoenix.group("mu.two").pid()).isEqualTo(process);

    steps.clear();
    up(
        drive(7, "one")
            + "<group name=\"two\"><jvm-option>-Xmx64m</jvm-option>"
            + module("eye", 1)
            + "</group>");
    assertThat(steps).contains("KEPT mu/eye two", "GROUP_KEPT mu.two two");
    assertThat(phoenix.group("mu.two").pid()).as("it works on").isEqualTo(process);
  }

  @Test
  void aRegistrarThatMissesItsDeadlineIsAskedAgain() throws Exception {
    long registrar = phoenix.group("mu.lookup").pid();
    ScheduledExecutorService later = Executors.newSingleThreadScheduledExecutor();
    signal("STOP", registrar);
    try {
      var unused = later.schedule(() -> signal("CONT", registrar), 4, TimeUnit.SECONDS);
      up(drive(1, "one") + eye(1, "two"));
    } finally {
      later.shutdownNow();
      signal("CONT", registrar);
    }
    assertThat(steps).contains("KEPT mu/registrar lookup", "KEPT mu/drive one");
  }

  private static Process signal(String name, long pid) throws IOException {
    return new ProcessBuilder("kill", "-" + name, Long.toString(pid)).start();
  }

  @Test
  void aPortOfAnotherRobotIsNamedWithItAndNothingIsLeftOfTheOneThatDidNotStart() throws Exception {
    assertThatThrownBy(
            () -> up("nu", group("lookup", "<registrar port=\"" + port + "\" classes=\"off\"/>\n")))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            folder.resolve("nu.xml")
                + ":3: nu/registrar cannot start: port "
                + port
                + " is used by robot mu's registrar; give one of the two another port, or"
                + " ./dfra down mu");
    String lamp = module("lamp", 9);
    try (var taken = new ServerSocket(0, 0, InetAddress.getByName(HOST))) {
      String registrar = "<registrar port=\"" + taken.getLocalPort() + "\" classes=\"off\"/>\n";
      String why = "nu/registrar did not start: port " + taken.getLocalPort();
      assertThatThrownBy(() -> up("nu", group("lookup", registrar + lamp)))
          .hasMessageContaining(why);
      assertThat(groups()).noneMatch(name -> name.startsWith("nu."));
      assertThat(new KnownRobots(phoenix.process().state()).isKnown("nu")).isFalse();

      up("nu", group("lookup", lamp));
      assertThatThrownBy(() -> up("nu", group("lookup", registrar + lamp)))
          .hasMessageContaining(why);
      assertThat(dfra("status", folder.resolve("nu.xml").toString()))
          .as("the module works on, and there is no registrar")
          .containsPattern("nu\\.lookup +active +\\d+ +1 +0 +lamp\n")
          .doesNotContain("registrar");
    } finally {
      RobotRemoval.of(phoenix.process(), "nu", PATIENCE);
    }
  }

  @Test
  void whatIsTakenDownIsForgottenAndComesBackAsTheSame() throws Exception {
    UUID id = listed("drive").id();
    List<ProcessHandle> processes = new ArrayList<>();
    for (String group : List.of("mu.lookup", "mu.one", "mu.two")) {
      processes.add(ProcessHandle.of(phoenix.group(group).pid()).orElseThrow());
    }

    assertThat(dfra("down", "mu")).isEqualToIgnoringNewLines("mu is down.");

    assertThat(dfra("status")).startsWith("Phoenix answers, but no such robot is up on this host.");
    assertThat(processes).noneMatch(ProcessHandle::isAlive);
    assertThat(groups()).noneMatch(name -> name.startsWith("mu."));
    assertThat(device("drive")).doesNotExist();
    assertThat(phoenix.process().admin().groupStatus()).isEmpty();

    up(drive(2, "one") + eye(1, "two"));
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
    unregisterObjects("mu."); // what down does first; then somebody presses Ctrl-C

    up(group("one", module("eye", 3)) + group("two", module("drive", 3)));

    assertThat(steps)
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
    unregisterObjects("mu.one");
    try {
      up("nu", drive(4, "one"));
      assertThat(steps).containsExactly("PROCESS_ENDED mu.one one 1", "STARTED nu/drive one");
      assertThat(left.isAlive()).isFalse();
    } finally {
      RobotRemoval.of(phoenix.process(), "nu", PATIENCE);
    }
  }

  /** What {@code module add} and its siblings do; the drive's driver still has the device. */
  @Test
  void modulesThatExchangeTheirDevicesBothEndBeforeEitherStarts() throws Exception {
    awaitCelsius("drive", 1);
    awaitCelsius("eye", 1);
    up(group("one", module("drive", 2, "eye")) + group("two", module("eye", 2, "drive")));
    awaitCelsius("drive", 2);
    awaitCelsius("eye", 2);
    assertThat(steps).filteredOn(step -> step.startsWith("RESTARTED")).hasSize(2);
  }

  @Test
  void aNewModuleStartsWhenTheOneThatHadItsDeviceHasEnded() throws Exception {
    awaitCelsius("drive", 1);
    up(group("mast", module("mast", 4, "drive")) + group("one", module("drive", 3, "other")));
    awaitCelsius("mast", 4);
    awaitCelsius("drive", 3);
  }

  @Test
  void nothingNewIsStartedWhereADriverDoesNotEnd() throws Exception {
    awaitCelsius("drive", 1);
    awaitCelsius("eye", 1);
    String exchanged =
        group("one", module("drive", 2, "eye")) + group("two", module("eye", 2, "drive"));
    long pid = phoenix.group("mu.one").pid();
    assertThat(signal("STOP", pid).waitFor()).isZero();
    try {
      assertThatThrownBy(() -> up(exchanged + group("mast", module("mast", 4))))
          .isInstanceOf(ActivationException.class)
          .hasMessageContaining("mu/drive may still work in group one: ")
          .hasMessageContaining("mu/eye is not started: what did not end may have its device")
          .hasMessageContaining("mu/mast is not started: ");
      assertThat(phoenix.group("mu.mast").pid()).isNegative();
    } finally {
      assertThat(signal("CONT", pid).waitFor()).isZero();
    }
    up(exchanged);
    awaitCelsius("drive", 2);
    awaitCelsius("eye", 2);
  }

  @Test
  void noSingleModuleIsStartedBesideADriverThatPhoenixHasForgotten() throws Exception {
    awaitCelsius("drive", 1);
    ProcessHandle left = forgetDrive();
    RobotDescription mast = described("mu", lookup() + group("one", module("mast", 4, "drive")));
    RobotBootstrap robot = new RobotBootstrap(phoenix.process(), mast);
    RobotBootstrap.Service unused = robot.add(mast.modules().get(0), "one");
    assertThat(left.isAlive()).isFalse();
    awaitCelsius("mast", 4);

    robot.remove("mast");
    RobotDescription eye = described("mu", lookup() + group("two", module("eye", 5, "drive")));
    up(drive(1, "one") + eye(1, "two"));
    left = forgetDrive();
    unused = robot.replace(eye.modules().get(0));
    assertThat(left.isAlive()).isFalse();
    awaitCelsius("eye", 5);

    robot.remove("eye"); // it has the drive's device
    up(drive(1, "one") + eye(1, "two"));
    left = forgetDrive();
    robot.start("eye");
    assertThat(left.isAlive()).isFalse();
  }

  /** Phoenix forgets the drive, whose process goes on. */
  private static ProcessHandle forgetDrive() throws Exception {
    ProcessHandle process = ProcessHandle.of(phoenix.group("mu.one").pid()).orElseThrow();
    unregisterObjects("mu.one");
    assertThat(process.isAlive()).isTrue();
    return process;
  }

  @SuppressWarnings("unchecked") // as phoenix declares it
  private static void unregisterObjects(String groups) throws Exception {
    PhoenixAdmin admin = phoenix.process().admin();
    Map<ActivationGroupID, ActivationGroupDesc> registered = admin.getActivationGroups();
    for (var group : registered.entrySet()) {
      String name = group.getValue().getPropertyOverrides().getProperty(Phoenix.GROUP_NAME);
      if (name.startsWith(groups)) {
        for (Object object : admin.getActivatableObjects(group.getKey()).keySet()) {
          phoenix.process().system().unregisterObject((ActivationID) object);
        }
      }
    }
  }

  private static List<String> groups() throws Exception {
    return Inventory.of(phoenix.process(), PATIENCE).stream()
        .map(each -> each.robot() + "." + each.name())
        .toList();
  }
}

package org.dfra.bringup;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectOutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.activation.ActivationException;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import net.jini.lookup.entry.Name;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.RobotXml;
import org.dfra.core.host.FreePorts;
import org.dfra.directory.ModuleQuery;
import org.dfra.example.thermometer.SteadyThermometerImpl;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.river.bootstrap.HostAddress;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.phoenix.GroupStatus;
import org.dfra.robot.RunningPhoenix;
import org.dfra.sim.device.gps.M12Emulator;
import org.dfra.sim.device.gps.M12EmulatorSettings;
import org.dfra.testing.EmbeddedReggie;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/**
 * Robots brought up under one phoenix, in real processes; each test has a robot of its own where it
 * does it harm.
 */
@ExtendWith(EmbeddedReggie.class)
class RobotBootstrapIT {

  private static final String HOST = "127.0.0.1";
  private static final Duration PATIENCE = Duration.ofSeconds(20);
  private static final GeoPosition PLACE = new GeoPosition(27.9506, -82.4572, 14.5);

  @TempDir static Path folder;

  private static RunningPhoenix phoenix;
  private static M12Emulator receiver;
  private static int port;
  private static Path alpha;

  /** Robot alpha: a registrar, and in another group a receiver and a thermometer. */
  @BeforeAll
  static void bringUpAlpha() throws Exception {
    receiver = new M12Emulator(M12EmulatorSettings.at(PLACE).withBaud(115_200), Instant::now);
    receiver.start();
    phoenix = RunningPhoenix.start(folder.resolve("phoenix"));
    port = FreePorts.allocate();
    alpha = alpha("20");
    List<RobotBootstrap.ServiceReference> up = up(alpha);
    assertThat(up)
        .extracting(RobotBootstrap.ServiceReference::name, RobotBootstrap.ServiceReference::group)
        .containsExactly(
            org.assertj.core.groups.Tuple.tuple("alpha/registrar", "lookup"),
            org.assertj.core.groups.Tuple.tuple("alpha/gps_front", "sensors"),
            org.assertj.core.groups.Tuple.tuple("alpha/cellar", "sensors"));
    await().atMost(PATIENCE).until(() -> registered(port).size() == 3);
  }

  @AfterAll
  static void takeDown() throws IOException {
    try (M12Emulator switchedOff = receiver;
        RunningPhoenix ended = phoenix) {
      assertThat(phoenix).isNotNull();
    }
  }

  private static Path alpha(String celsius) throws IOException {
    return robot(
        "alpha",
        HOST,
        "<lookup groups=\"test_alpha\"/>"
            + group("lookup", "<registrar port=\"" + port + "\"/>")
            + group(
                "sensors",
                """
                <module name="gps_front" server="org.dfra.river.server.sensor.GPSServer"
                    proxy="org.dfra.river.proxy.sensor.GPSProxy"
                    implementation="org.dfra.drivers.gps.m12.M12PlusImpl">
                  <parameter name="link" value="%s"/>
                </module>
                """
                        .formatted(receiver.url())
                    + thermometer("cellar", celsius)));
  }

  private static Path robot(String name, String host, String content) throws IOException {
    Path file = folder.resolve(name + ".xml");
    return Files.writeString(
        file,
        """
        <robot xmlns="urn:dfra:robot:1" name="%s" host="%s">
        %s
        </robot>
        """
            .formatted(name, host, content));
  }

  private static String group(String name, String content) {
    return "<group name=\"" + name + "\">\n" + content + "\n</group>\n";
  }

  private static String thermometer(String name, String celsius) {
    return module(name, ThermometerServer.class.getName(), SteadyThermometerImpl.class.getName())
        .formatted("<parameter name=\"celsius\" value=\"" + celsius + "\"/>");
  }

  private static String module(String name, String server, String driver) {
    return "<module name=\""
        + name
        + "\" server=\""
        + server
        + "\" proxy=\""
        + ThermometerProxy.class.getName()
        + "\" implementation=\""
        + driver
        + "\">%s</module>";
  }

  private static List<RobotBootstrap.ServiceReference> up(Path xml) throws Exception {
    try {
      return new RobotBootstrap(phoenix.process(), RobotXml.read(xml)).up();
    } finally {
      phoenix.note();
    }
  }

  /** Service IDs by name, as a registrar has them; its own has the name of its class. */
  private static Map<String, ServiceID> registered(int port) throws Exception {
    ServiceRegistrar registrar = new LookupLocator(HOST, port).getRegistrar();
    Map<String, ServiceID> found = new TreeMap<>();
    for (ServiceItem item : registrar.lookup(new ServiceTemplate(null, null, null), 99).items) {
      String name =
          Arrays.stream(item.attributeSets)
              .filter(Name.class::isInstance)
              .map(each -> ((Name) each).name)
              .findFirst()
              .orElse(item.service.getClass().getSimpleName());
      assertThat(found.put(name, item.serviceID)).as("%s is there twice", name).isNull();
    }
    return found;
  }

  private static JiniModuleDirectory finder(int port) throws IOException {
    return new JiniModuleDirectory(HOST, List.of(), List.of("jini://" + HOST + ":" + port));
  }

  @Test
  void itsModulesAreFoundByWhatTheyCanDo() throws Exception {
    try (JiniModuleDirectory finder = finder(port)) {
      GPSSensor gps =
          finder.findFirst(ModuleQuery.of(GPSSensor.class), PATIENCE).orElseThrow().module();
      assertThat(gps.identification().path()).isEqualTo("alpha/gps_front");
      assertThat(gps.awaitReadiness(PATIENCE)).isEqualTo(Readiness.READY);
      // Half a milliarcsecond is 1.4e-7 degree.
      assertThat(gps.fix().position().latitude()).isCloseTo(PLACE.latitude(), within(2e-7));
    }
  }

  @Test
  void bringingItUpAgainDoublesNothing() throws Exception {
    Map<String, ServiceID> before = registered(port);
    List<Long> processes = List.of(pid("alpha.lookup"), pid("alpha.sensors"));
    int objects = phoenix.group("alpha.sensors").objects();

    List<RobotBootstrap.ServiceReference> again = up(alpha);

    assertThat(again).hasSize(3);
    assertThat(registered(port)).isEqualTo(before);
    assertThat(List.of(pid("alpha.lookup"), pid("alpha.sensors"))).isEqualTo(processes);
    assertThat(phoenix.group("alpha.sensors").objects()).isEqualTo(objects);
    assertThat(phoenix.process().admin().groupStatus())
        .extracting(GroupStatus::name)
        .doesNotHaveDuplicates();
  }

  @Test
  void aChangedParameterCountsAtOnceAndAfterKillMinusNine() throws Exception {
    try (JiniModuleDirectory finder = finder(port)) {
      Thermometer cellar =
          finder.findFirst(ModuleQuery.of(Thermometer.class), PATIENCE).orElseThrow().module();
      double before = cellar.celsius();
      Map<String, ServiceID> known = registered(port);

      up(alpha(Double.toString(before + 5)));
      assertThat(cellar.celsius()).as("the same proxy").isEqualTo(before + 5);

      phoenix.kill("alpha.sensors");
      assertThat(cellar.celsius()).as("the same proxy, after kill -9").isEqualTo(before + 5);
      await().atMost(PATIENCE).untilAsserted(() -> assertThat(registered(port)).isEqualTo(known));
    }
  }

  @Test
  void itsRegistrarKnowsEverythingAfterKillMinusNine() throws Exception {
    ServiceRegistrar proxy = new LookupLocator(HOST, port).getRegistrar();
    Map<String, ServiceID> before = registered(port);
    long process = pid("alpha.lookup");

    phoenix.kill("alpha.lookup");

    ServiceTemplate thermometers =
        new ServiceTemplate(null, new Class<?>[] {Thermometer.class}, null);
    assertThat(proxy.lookup(thermometers)).as("through the proxy from before").isNotNull();
    assertThat(pid("alpha.lookup")).isNotEqualTo(process);
    assertThat(registered(port)).as("at the same port").isEqualTo(before);
    assertThat(new LookupLocator(HOST, port).getRegistrar().getServiceID())
        .isEqualTo(proxy.getServiceID());
  }

  @Test
  void aRegistrarTakesAnotherPortAndOtherGroupsWhenTheyAreChanged() throws Exception {
    int first = FreePorts.allocate();
    up(zeta("old", first));
    ServiceID id = new LookupLocator(HOST, first).getRegistrar().getServiceID();
    int second = FreePorts.allocate();
    up(zeta("new,more", second));
    ServiceRegistrar moved = new LookupLocator(HOST, second).getRegistrar();
    assertThat(moved.getServiceID()).isEqualTo(id);
    assertThat(moved.getGroups()).containsExactlyInAnyOrder("new", "more");
    assertThatThrownBy(() -> new LookupLocator(HOST, first).getRegistrar())
        .isInstanceOf(java.net.ConnectException.class);

    try (ServerSocket taken = new ServerSocket(0, 0, InetAddress.getByName(HOST))) {
      Path xml = zeta("new", taken.getLocalPort());
      assertThatThrownBy(() -> up(xml))
          .isInstanceOf(IOException.class)
          .hasMessageStartingWith(xml + ":")
          .hasMessageContaining("zeta/registrar: ")
          .hasMessageContaining("port " + taken.getLocalPort() + " of 127.0.0.1 cannot be listened")
          .hasMessageEndingWith("end what listens there, or give the registrar another port");
    }
  }

  private static Path zeta(String groups, int port) throws IOException {
    return robot(
        "zeta",
        HOST,
        "<lookup groups=\""
            + groups
            + "\"/>"
            + group("lookup", "<registrar port=\"" + port + "\"/>"));
  }

  @Test
  void aSecondRobotWithoutARegistrarJoinsTheTeamsOne(EmbeddedReggie team) throws Exception {
    Path beta =
        robot(
            "beta",
            HOST,
            "<lookup locators=\""
                + team.locator().replace("jini://", "")
                + "\"/>"
                + group("sensors", thermometer("attic", "30")));
    assertThat(up(beta))
        .extracting(RobotBootstrap.ServiceReference::name)
        .containsExactly("beta/attic");
    await()
        .atMost(PATIENCE)
        .untilAsserted(() -> assertThat(registered(team.port())).containsKey("beta/attic"));
    assertThat(pid("beta.sensors"))
        .as("groups of one name on two robots are two processes")
        .isPositive()
        .isNotEqualTo(pid("alpha.sensors"));
    assertThat(registered(port)).as("at alpha's").doesNotContainKey("beta/attic");
  }

  @Test
  @EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "has a sibling")
  void aRegistrarsPortThatIsTakenIsReportedInOneSentence() throws Exception {
    try (ServerSocket taken = new ServerSocket(0, 0, InetAddress.getByName(HOST))) {
      Path gamma =
          robot(
              "gamma", HOST, group("lookup", "<registrar port=\"" + taken.getLocalPort() + "\"/>"));
      assertThatThrownBy(() -> up(gamma))
          .isInstanceOf(ActivationException.class)
          .hasMessage(
              gamma
                  + ":3: gamma/registrar did not start: port "
                  + taken.getLocalPort()
                  + " of 127.0.0.1 cannot be listened on (Address already in use); end what listens"
                  + " there, or give the registrar another port");
    }
  }

  @Test
  void aModuleThatCannotBeMadeIsNamedWithItsPlace() throws Exception {
    String good = ThermometerServer.class.getName();
    Path delta =
        robot("delta", HOST, group("g", module("t", good, "org.dfra.NoImpl").formatted("")));
    assertThatThrownBy(() -> up(delta))
        .isInstanceOf(ActivationException.class)
        .hasMessage(
            delta
                + ":3: delta/t did not start: driver class org.dfra.NoImpl is not on the group's"
                + " class path; add its jar or correct the name");

    String driver = SteadyThermometerImpl.class.getName();
    robot("delta", HOST, group("g", module("u", "org.dfra.NoServer", driver).formatted("")));
    assertThatThrownBy(() -> up(delta))
        .isInstanceOf(ActivationException.class)
        .hasMessage(
            delta
                + ":3: delta/u did not start: server class org.dfra.NoServer is not on the group's"
                + " class path; add its jar or correct the name");
  }

  @Test
  void xmlThatCannotBeReadIsReportedInOneSentence() throws Exception {
    Path broken = Files.writeString(folder.resolve("broken.xml"), "<robot\n");
    assertThatThrownBy(() -> up(broken))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageStartingWith(broken.toString())
        .message()
        .doesNotContain("\n");
  }

  @Test
  void noProxyCarriesTheLoopbackUnlessTheRobotSaysSo() throws Exception {
    String host = HostAddress.resolve(HostAddress.AUTO);
    assumeFalse(
        HostAddress.isLoopback(host),
        "this machine has no interface but the loopback, so auto can choose no other");
    int here = FreePorts.allocate();
    Path epsilon =
        robot(
            "epsilon",
            "auto",
            group("all", "<registrar port=\"" + here + "\"/>\n" + thermometer("roof", "1")));
    up(epsilon);
    ServiceRegistrar registrar = new LookupLocator(host, here).getRegistrar();
    ServiceTemplate thermometers =
        new ServiceTemplate(null, new Class<?>[] {Thermometer.class}, null);
    await().atMost(PATIENCE).until(() -> registrar.lookup(thermometers) != null);
    ThermometerProxy roof = (ThermometerProxy) registrar.lookup(thermometers);
    assertThat(roof.celsius()).isEqualTo(1);
    assertThat(wire(roof)).contains(host).doesNotContain("localhost");
    assertThat(wire(registrar)).contains(host);
    assertThat(registrar.getLocator().getHost()).isEqualTo(host);
    // Phoenix itself is on the loopback here, and its activator is a part of every proxy.
    assertThat(wire(roof.server().acquireLease(Duration.ofSeconds(1))))
        .contains(host)
        .doesNotContain("127.");

    try (JiniModuleDirectory finder = finder(port)) { // robot alpha says 127.0.0.1
      assertThat(
              wire(
                  finder
                      .findFirst(ModuleQuery.of(GPSSensor.class), PATIENCE)
                      .orElseThrow()
                      .module()))
          .contains("127.0.0.1");
    }
  }

  /** What crosses the wire, as text. */
  private static String wire(Object proxy) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(proxy);
    }
    return bytes.toString(StandardCharsets.ISO_8859_1);
  }

  private static long pid(String group) throws IOException {
    return phoenix.group(group).pid();
  }
}

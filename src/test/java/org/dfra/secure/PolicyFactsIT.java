package org.dfra.secure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;
import static org.dfra.secure.SecureTeam.ANNA;
import static org.dfra.secure.SecureTeam.ok;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicLong;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import net.jini.admin.Administrable;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.app.MarkedProcesses.Outcome;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.Subscription;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.module.LogLevel;
import org.dfra.module.Module;
import org.dfra.river.remote.ModuleAdmin;
import org.dfra.security.AccessRefusedException;
import org.dfra.sim.device.gps.M12Emulator;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * A robot of four processes whose policy depends on the time, on its position, on a fact that an
 * operator sets, and on an operator's confirmation. The module that knows the position is in
 * another process than those that decide. The tests share the robot.
 */
@Timeout(240)
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class PolicyFactsIT {

  private static final String ROBOT = "atrv1";
  private static final String OTTO = "otto";
  private static final String OSCAR = "oscar";
  private static final Duration LEASE = Duration.ofSeconds(25); // above SOON
  private static final Duration SOON = Duration.ofSeconds(20);
  private static final Pattern REQUEST = Pattern.compile("\"id\"\\s*:\\s*\"([a-z0-9]+)\"");

  private static final String POLICY =
      """
      <policy xmlns="urn:dfra:policy:1" team="field" version="2">
        <region name="home">
          <corner latitude="27.97" longitude="-82.46"/>
          <corner latitude="27.97" longitude="-82.44"/>
          <corner latitude="27.99" longitude="-82.44"/>
          <corner latitude="27.99" longitude="-82.46"/>
        </region>
        <permit name="own" standing="own"/>
        <permit name="stop" standing="member,expired" kind="stop"/>
        <permit name="light" member="oscar" method="acquireLease" object="warmth">
          <while fact="load" is="none"/>
          <when from="2026-01-01T00:00:00Z"/>
        </permit>
        <deny name="loaded" member="oscar" method="acquireLease"/>
        <permit name="home" member="otto" method="history" object="warmth">
          <within region="home"/>
        </permit>
        <permit name="home-groups" member="otto" interface="Registrar" method="getMemberGroups">
          <within region="home"/>
        </permit>
        <deny name="away" member="otto" method="history,getMemberGroups"/>
        <permit name="ask-first" member="oscar" method="setLogLevel"><ask/><notify/></permit>
        <permit name="operators" role="operator"/>
        <permit name="observers" role="observer" kind="read,listen,lease,activate"/>
      </policy>
      """;

  @TempDir static Path folder;

  private static SecureTeam team;
  private static M12Emulator receiver;
  private static Thermometer oscars;
  private static Thermometer ottos;
  private static MemberCalls otto;
  private static MemberCalls oscar;

  @BeforeAll
  static void make() throws Exception {
    receiver = TeamRobots.receiver();
    team = new SecureTeam(folder);
    team.init();
    Files.writeString(team.state(ANNA).resolve("authority").resolve("policy.xml"), POLICY);
    team.admit("robot", ROBOT);
    team.admit("observer", OTTO);
    team.admit("operator", OSCAR);
    team.describe(
        ROBOT,
        TeamRobots.group("lookup", TeamRobots.registrar())
            + TeamRobots.group("body", TeamRobots.gps(receiver.url()))
            + TeamRobots.group("warm", TeamRobots.thermometer(17)));
    ok(team.up(ROBOT));
    otto = new MemberCalls(team.security(OTTO));
    oscar = new MemberCalls(team.security(OSCAR));
    oscars = oscar.find(team.registrar(ROBOT), Thermometer.class, "atrv1/warmth");
    ottos = otto.find(team.registrar(ROBOT), Thermometer.class, "atrv1/warmth");
  }

  @AfterAll
  static void end() {
    try {
      team.close();
    } finally {
      receiver.close();
    }
  }

  private static void awaitPermission(Callable<?> call) {
    await()
        .pollInSameThread()
        .pollInterval(Duration.ofMillis(100))
        .atMost(SOON)
        .ignoreException(AccessRefusedException.class)
        .until(
            () -> {
              Object unused = call.call();
              return true;
            });
  }

  private static void awaitRefusal(Callable<?> call) {
    await()
        .pollInSameThread()
        .pollInterval(Duration.ofMillis(100))
        .atMost(SOON)
        .until(
            () -> {
              try {
                Object unused = call.call();
                return false;
              } catch (AccessRefusedException e) {
                return true;
              }
            });
  }

  private static boolean lease() throws Exception {
    oscar.call(() -> oscars.acquireLease(Duration.ofSeconds(5))).close();
    return true;
  }

  @Test
  @Order(1)
  void aFactThatAnOperatorSetsCountsInAnotherProcessUntilItIsUnset() throws Exception {
    assertThatThrownBy(PolicyFactsIT::lease)
        .isInstanceOf(AccessRefusedException.class)
        .hasMessageContaining("by rule loaded");
    Outcome refused = team.ask(OTTO, "policy", "fact", ROBOT, "load=none");
    assertThat(refused.exit()).as(refused.out() + refused.err()).isEqualTo(1);
    assertThat(refused.err()).contains("setFact is refused to observer otto");

    assertThat(ok(team.ask(ANNA, "policy", "fact", ROBOT, "load=none")).out())
        .contains("The fact load of atrv1 is none now.");
    awaitPermission(PolicyFactsIT::lease);
    assertThat(ok(team.ask(OTTO, "policy", "fact", ROBOT)).out())
        .containsPattern("load is none, set at .* by operator anna of field \\(127\\.0\\.0\\.1\\)")
        .contains("The time is 20");

    ok(team.ask(ANNA, "policy", "fact", ROBOT, "load="));
    awaitRefusal(PolicyFactsIT::lease);
  }

  @Test
  @Order(2)
  void aCallThatAnOperatorConfirmsRunsOnce() throws Exception {
    Callable<Boolean> call =
        () -> {
          oscars.setLogLevel(LogLevel.INFO);
          return true;
        };
    assertThatThrownBy(call::call)
        .isInstanceOf(AccessRefusedException.class)
        .hasMessageContaining("only when an operator has confirmed it");
    String request = awaitRequest();
    Outcome refused = team.ask(OTTO, "policy", "confirm", ROBOT, request);
    assertThat(refused.err()).contains("answer is refused to observer otto");
    assertThat(refused.exit()).isEqualTo(1);
    awaitRefusal(call);

    ok(team.ask(ANNA, "policy", "confirm", ROBOT, request));
    awaitPermission(call);
    assertThatThrownBy(call::call).as("a second call").isInstanceOf(AccessRefusedException.class);
    Outcome again = team.ask(ANNA, "policy", "confirm", ROBOT, request);
    assertThat(again.exit()).isEqualTo(3);

    ok(team.ask(ANNA, "policy", "refuse", ROBOT, awaitRequest()));
    await()
        .pollInSameThread()
        .atMost(SOON)
        .untilAsserted(() -> assertThatThrownBy(call::call).hasMessageContaining("has refused it"));
    assertThat(ok(team.ask(ANNA, "policy", "requests")).out())
        .contains("No call waits for a confirmation.");
    assertThat(logs())
        .contains("to operator oscar of field", "by rule ask-first", "was refused by");
    assertThat(ok(team.here(ROBOT, "audit", "--who=oscar")).out()).contains("ask-first");
  }

  private static String awaitRequest() throws Exception {
    String shown = "";
    for (int i = 0; i < 5; i++) { // it is shown within a moment
      shown = ok(team.ask(ANNA, "policy", "requests", "--json")).out();
      Matcher found = REQUEST.matcher(shown);
      if (found.find()) {
        assertThat(shown).contains("setLogLevel", "operator oscar of field", "warmth");
        return found.group(1);
      }
    }
    throw new AssertionError("no request is shown: " + shown);
  }

  private static String logs() throws IOException {
    StringBuilder all = new StringBuilder();
    try (Stream<Path> files = Files.walk(team.state(ROBOT))) {
      for (Path each : files.filter(it -> it.toString().endsWith(".log")).toList()) {
        all.append(Files.readString(each));
      }
    }
    return all.toString();
  }

  @Test
  @Order(3)
  void aPublishedPolicyEndsWhatItDoesNotPermitInEachProcess() throws Exception {
    GPSSensor ottosGps = otto.find(team.registrar(ROBOT), GPSSensor.class, "atrv1/gps_front");
    ServiceItem service = new ServiceItem(null, "a service of oscar", null);
    ServiceTemplate itself =
        oscar.call(
            () ->
                new ServiceTemplate(
                    registrar().register(service, LEASE.toMillis()).getServiceID(), null, null));
    AtomicLong events = new AtomicLong();
    try (Subscription first =
            otto.call(
                () ->
                    ottosGps.subscribe(
                        event -> events.incrementAndGet(), DeliveryPolicy.keepLast(8)));
        Subscription second =
            otto.call(() -> ottos.subscribe(event -> {}, DeliveryPolicy.keepLast(8)))) {
      await().atMost(SOON).until(() -> events.get() > 0);
      List<ModuleAdmin> admins =
          List.of(admin(GPSSensor.class, "gps_front"), admin(Thermometer.class, "warmth"));
      List<Integer> before = leases(admins);
      Files.writeString(
          team.state(ANNA).resolve("authority").resolve("policy.xml"),
          POLICY
              .replace("version=\"2\"", "version=\"3\"")
              .replaceFirst(
                  "<permit ",
                  "<deny name=\"quiet\" member=\"otto\" kind=\"listen\"/>"
                      + "<deny name=\"unlisted\" member=\"oscar\" kind=\"register\"/><permit "));
      String published = ok(team.ask(ANNA, "security", "publish")).out();
      System.out.println(published);
      assertThat(published).containsPattern("Robot atrv1 has list \\d and policy 3 in force");
      long begun = System.nanoTime();
      await()
          .pollInterval(Duration.ofMillis(20))
          .atMost(SOON)
          .until(
              () ->
                  leases(admins).equals(before.stream().map(each -> each - 1).toList())
                      && oscar.call(() -> registrar().lookup(itself)) == null);
      System.out.printf(
          "published: all processes have ended it after %.3f s%n",
          (System.nanoTime() - begun) / 1e9);
      await().atMost(SOON).until(() -> first.interruptedSince().isPresent());
      await().atMost(SOON).until(() -> second.interruptedSince().isPresent());
    }
    assertThat(logs()).contains("a lease of observer otto of field", "no longer permits");
  }

  private static ServiceRegistrar registrar() throws Exception {
    return MemberCalls.registrar(team.registrar(ROBOT));
  }

  private static <M extends Module> ModuleAdmin admin(Class<M> kind, String name) throws Exception {
    M module = oscar.find(team.registrar(ROBOT), kind, "atrv1/" + name);
    return oscar.call(() -> (ModuleAdmin) ((Administrable) module).getAdmin());
  }

  private static List<Integer> leases(List<ModuleAdmin> admins) throws Exception {
    List<Integer> counts = new ArrayList<>();
    for (ModuleAdmin each : admins) {
      counts.add(oscar.call(() -> each.leases().size()));
    }
    return counts;
  }

  @Test
  @Order(4)
  void aClockThatIsBehindTheLatestTimeThatIsKnownCountsAsNotSet() throws Exception {
    ok(team.ask(ANNA, "policy", "fact", ROBOT, "load=none"));
    awaitPermission(PolicyFactsIT::lease);
    Path latest = team.security(ROBOT).resolve("latest-time");
    assertThat(Instant.parse(Files.readString(latest).strip()))
        .as("what the processes have kept")
        .isBetween(Instant.now().minus(Duration.ofMinutes(30)), Instant.now());
    Files.writeString(latest, Instant.now().plus(Duration.ofDays(1)) + "\n");
    assertThat(ok(team.dfra(ROBOT, "status")).out())
        .contains("Clock: this computer's clock says", "so the clock was not set");

    MemberCalls own = new MemberCalls(team.security(ROBOT));
    SecureTeam.kill(
        ProcessHandle.of(
                own.call(() -> team.phoenix(ROBOT).admin().groupStatus()).stream()
                    .filter(each -> each.name().endsWith(".warm"))
                    .findFirst()
                    .orElseThrow()
                    .pid())
            .orElseThrow());
    await()
        .pollInSameThread()
        .atMost(SecureTeam.PATIENCE)
        .ignoreExceptionsMatching(RemoteException.class::isInstance)
        .until(() -> oscars.readiness().serves());
    assertThatThrownBy(PolicyFactsIT::lease)
        .as("a permit with <when>")
        .isInstanceOf(AccessRefusedException.class);
    assertThat(Instant.parse(Files.readString(latest).strip()))
        .as("it never goes back")
        .isAfter(Instant.now().plus(Duration.ofHours(23)));
  }

  /** The last: it ends the receiver. */
  @Test
  @Order(5)
  void thePositionOfAReceiverCountsInEachProcessUntilItIsTooOld() throws Exception {
    ServiceRegistrar registrar = otto.call(() -> MemberCalls.registrar(team.registrar(ROBOT)));
    for (Callable<?> each : List.<Callable<?>>of(ottos::history, registrar::getGroups)) {
      awaitPermission(each);
    }
    assertThat(ok(team.ask(ANNA, "policy", "fact", ROBOT)).out()).contains("It is at 27.98");
    receiver.close();
    for (Callable<?> each : List.<Callable<?>>of(ottos::history, registrar::getGroups)) {
      awaitRefusal(each);
    }
    assertThat(ok(team.ask(ANNA, "policy", "fact", ROBOT)).out())
        .contains("Its position is unknown");
    assertThatThrownBy(ottos::history)
        .isNotInstanceOf(RemoteException.class)
        .hasMessageContaining("by rule away");
  }
}

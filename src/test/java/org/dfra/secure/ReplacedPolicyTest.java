package org.dfra.secure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.dfra.secure.SecureTeam.ANNA;

import java.io.Serializable;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.MarshalledObject;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicLong;
import net.jini.admin.Administrable;
import net.jini.core.event.RemoteEvent;
import net.jini.core.event.RemoteEventListener;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceRegistration;
import net.jini.core.lookup.ServiceTemplate;
import net.jini.jeri.BasicJeriExporter;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.GoToWaypoint;
import org.dfra.behavior.LegGoal;
import org.dfra.core.config.RobotXml;
import org.dfra.core.policy.Policy;
import org.dfra.core.policy.PolicyGuard;
import org.dfra.core.policy.PolicyXml;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.dfra.drive.Commander;
import org.dfra.drive.Wheels;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.Subscription;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.geometry.GeoPosition;
import org.dfra.lease.ModuleLease;
import org.dfra.river.bootstrap.EmbeddedRobot;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.identity.RevokedCertificates;
import org.dfra.river.identity.SignedFiles;
import org.dfra.river.identity.TeamCredentials;
import org.dfra.river.identity.TeamIdentity;
import org.dfra.river.remote.ModuleAdmin;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * What members have obtained of a robot by remote calls ends when a new policy does not permit it.
 * The robot and its callers are in the test's virtual machine, and call each other over TLS.
 */
@Timeout(120)
class ReplacedPolicyTest {

  private static final Duration LEASE = Duration.ofSeconds(20);
  private static final Duration PATIENCE = Duration.ofSeconds(20);
  private static final Duration SOON = Duration.ofSeconds(1); // far below the lease
  private static final Duration POLL = Duration.ofMillis(10);
  private static final String ROBOT = "atrv1";
  private static final String OTHER = "atrv2";
  private static final String LOST = "atrv3";
  private static final String OTTO = "otto";
  private static final String OSCAR = "oscar";

  private static final String LEG =
      """
      <module name="leg" server="org.dfra.river.server.behavior.GoToWaypointServer"
          proxy="org.dfra.river.proxy.behavior.GoToWaypointProxy"
          implementation="org.dfra.secure.WaitingLegImpl"/>
      """;

  /** A service of another robot. */
  public record Plain(String name) implements Serializable {}

  @TempDir static Path folder;

  private static final PolicyGuard GUARD = new PolicyGuard(policy(1, "<permit/>"));
  private static SecureTeam team;
  private static Wheels wheels;
  private static RevokedCertificates revoked;
  private static EmbeddedRobot robot;
  private static MemberCalls anna;
  private static MemberCalls otto;
  private static MemberCalls oscar;
  private static MemberCalls other;

  @BeforeAll
  static void make() throws Exception {
    wheels = new Wheels();
    team = new SecureTeam(folder); // no process of it runs
    team.init();
    team.admit("robot", ROBOT);
    team.admit("robot", OTHER);
    team.admit("robot", LOST);
    team.admit("observer", OTTO);
    team.admit("operator", OSCAR);
    anna = new MemberCalls(team.security(ANNA));
    otto = new MemberCalls(team.security(OTTO));
    oscar = new MemberCalls(team.security(OSCAR));
    other = new MemberCalls(team.security(OTHER));
    TeamCredentials member = IdentityFolder.load(team.security(ROBOT));
    revoked = new RevokedCertificates(member.authority());
    TeamIdentity identity =
        new TeamIdentity(
            new TeamIdentity.Settings(
                member.member(),
                new TeamIdentity.Key(member.privateKey(), List.of(member.chain())),
                Set.of(),
                Set.of(),
                member.authority(),
                revoked,
                GUARD,
                false),
            Clock.systemUTC());
    Path xml =
        team.describe(
            ROBOT,
            TeamRobots.group("all", TeamRobots.registrar(), TeamRobots.drive(wheels.url()), LEG));
    robot = new EmbeddedRobot(RobotXml.read(xml), identity);
    robot.start();
  }

  @AfterAll
  static void end() throws Exception {
    try {
      robot.close();
    } finally {
      team.close();
      wheels.close();
    }
  }

  @BeforeEach
  void permitEverything() {
    replace("<permit/>");
  }

  private static Policy policy(long version, String... rules) {
    String text =
        "<policy xmlns=\"urn:dfra:policy:1\" team=\"field\" version=\"%d\">%n%s%n</policy>"
            .formatted(version, String.join("\n", rules));
    return PolicyXml.read(
        text.getBytes(StandardCharsets.UTF_8), "policy.xml", InterfaceCatalogue.builtIn());
  }

  private static void replace(String... rules) {
    assertThat(GUARD.replace(policy(GUARD.policy().version() + 1, rules))).isTrue();
  }

  private static DriveEffector drive(MemberCalls who) throws Exception {
    return who.find(team.registrar(ROBOT), DriveEffector.class, "atrv1/drive");
  }

  @Test
  void aCommanderLosesTheCommandAndTheWheelsStand() throws Exception {
    DriveEffector annas = drive(anna);
    DriveEffector oscars = drive(oscar);
    try (Commander commander =
        oscar.call(() -> new Commander(oscars, LEASE, new Velocity(0.4, 0)))) {
      await().atMost(PATIENCE).until(() -> wheels.speed() > 0.3);
      replace("<deny member=\"otto\" kind=\"command\"/>", "<permit/>");
      assertThat(annas.driveState().commander()).as("somebody else's right").isNotNull();
      replace("<deny member=\"oscar\" method=\"execute\"/>", "<permit/>");
      await().pollInterval(POLL).atMost(SOON).until(() -> annas.driveState().commander() == null);
      await().pollInterval(POLL).atMost(SOON).until(() -> wheels.speed() < 0.01);
      await().atMost(PATIENCE).until(commander::hasGivenUp);
      await().atMost(PATIENCE).until(() -> !commander.lease().isLive());
    }
    try (Commander next = anna.call(() -> new Commander(annas, LEASE, new Velocity(0.4, 0)))) {
      await().atMost(PATIENCE).until(() -> wheels.speed() > 0.3);
      assertThat(next.hasGivenUp()).isFalse();
    }
  }

  @Test
  void theRobotsOwnProgramsLoseTheCommandIfNobodyMayHaveIt() throws Exception {
    MemberCalls own = new MemberCalls(team.security(ROBOT));
    DriveEffector drive = drive(own);
    try (Commander commander = own.call(() -> new Commander(drive, LEASE, new Velocity(0.4, 0)))) {
      await().atMost(PATIENCE).until(() -> wheels.speed() > 0.3);
      replace("<deny interface=\"DriveEffector\" kind=\"command\"/>", "<permit/>");
      await().pollInterval(POLL).atMost(SOON).until(() -> wheels.speed() < 0.01);
      DriveEffector annas = drive(anna);
      await().pollInterval(POLL).atMost(SOON).until(() -> annas.driveState().commander() == null);
      await().atMost(PATIENCE).until(commander::hasGivenUp);
    }
  }

  @Test
  void aListenerGetsNoMoreEventsUntilAPolicyPermitsItAgain() throws Exception {
    DriveEffector ottos = drive(otto);
    DriveEffector annas = drive(anna);
    AtomicLong events = new AtomicLong();
    AtomicLong annasEvents = new AtomicLong();
    try (Subscription listening =
            otto.call(
                () -> ottos.subscribe(e -> events.incrementAndGet(), DeliveryPolicy.keepLast(8)));
        Subscription annasToo =
            anna.call(
                () ->
                    annas.subscribe(
                        e -> annasEvents.incrementAndGet(), DeliveryPolicy.keepLast(8)))) {
      change(annas);
      await().atMost(PATIENCE).until(() -> events.get() > 0 && annasEvents.get() > 0);
      replace(
          "<deny role=\"observer\" interface=\"Module\" method=\"subscribe\"/>",
          "<permit role=\"operator\"><rate max=\"1\" per=\"1h\"/></permit>", // is not counted
          "<permit/>");
      replace("<deny role=\"observer\" method=\"subscribe\"/>", "<permit/>");
      await().atMost(PATIENCE).until(() -> listening.interruptedSince().isPresent());
      long before = events.get();
      long annasBefore = annasEvents.get();
      change(annas);
      await().atMost(PATIENCE).until(() -> annasEvents.get() > annasBefore);
      assertThat(events).hasValue(before);
      assertThat(annasToo.interruptedSince()).isEmpty();
      assertThat(listening.isOpen()).as("it asks again").isTrue();

      replace("<permit/>");
      await().atMost(PATIENCE).until(() -> listening.interruptedSince().isEmpty());
      change(annas);
      await().atMost(PATIENCE).until(() -> events.get() > before);
    }
  }

  /** Publishes an event. */
  private static void change(DriveEffector annas) throws Exception {
    String old =
        annas.parameters().stream()
            .filter(each -> each.name().equals("max_speed"))
            .findFirst()
            .orElseThrow()
            .value();
    annas.setParameter("max_speed", Double.parseDouble(old) > 0.6 ? "0.5" : "0.7");
  }

  @Test
  void aClientsLeaseEndsAndWhatAnOperatorWouldHaveToConfirmGoesOn() throws Exception {
    DriveEffector ottos = drive(otto);
    DriveEffector oscars = drive(oscar);
    DriveEffector annas = drive(anna);
    ModuleAdmin admin = anna.call(() -> (ModuleAdmin) ((Administrable) annas).getAdmin());
    try (ModuleLease held = otto.call(() -> ottos.acquireLease(LEASE));
        ModuleLease oscarsLease = oscar.call(() -> oscars.acquireLease(LEASE))) {
      assertThat(admin.leases()).hasSize(2);
      replace(
          "<permit member=\"oscar\" method=\"acquireLease\"><ask/></permit>",
          "<deny method=\"acquireLease\"/>",
          "<permit/>");
      await().pollInterval(POLL).atMost(SOON).until(() -> admin.leases().size() == 1);
      Instant end = oscarsLease.expiration();
      await().atMost(PATIENCE).until(() -> oscarsLease.expiration().isAfter(end));
      assertThat(admin.leases()).as("otto's lease is not back").hasSize(1);
      held.close();
    }
  }

  private static GoToWaypoint leg(MemberCalls who) throws Exception {
    return who.find(team.registrar(ROBOT), GoToWaypoint.class, "atrv1/leg");
  }

  @Test
  void aGoalIsPausedIfItsGiverMayNoLongerGiveIt() throws Exception {
    GoToWaypoint annas = leg(anna);
    GoToWaypoint oscars = leg(oscar);
    assertThat(oscars.pursue(new LegGoal(null, new GeoPosition(27.98, -82.45, 0), 2))).isNotNull();
    assertThat(annas.status().phase()).isEqualTo(Phase.RUNNING);
    replace("<deny member=\"anna\" method=\"pursue\"/>", "<permit/>");
    assertThat(annas.status().phase()).isEqualTo(Phase.RUNNING);
    replace("<deny member=\"oscar\" interface=\"GoToWaypoint\"/>", "<permit/>");
    await().pollInterval(POLL).atMost(SOON).until(() -> annas.status().phase() == Phase.PAUSED);
    assertThat(annas.status().activity()).contains("does not permit operator oscar of field");
    annas.resume();
    assertThat(annas.status().phase()).isEqualTo(Phase.RUNNING);
    annas.cancel();
  }

  private static ServiceRegistrar registrar() throws Exception {
    return MemberCalls.registrar(team.registrar(ROBOT));
  }

  private static Optional<Object> service(ServiceID id) throws Exception {
    return Optional.ofNullable(
        anna.call(() -> registrar().lookup(new ServiceTemplate(id, null, null))));
  }

  private static ServiceRegistration register(MemberCalls who, String name) throws Exception {
    return who.call(
        () -> registrar().register(new ServiceItem(null, new Plain(name), null), LEASE.toMillis()));
  }

  /** Listens to the services of a lookup service. */
  private static final class Listener implements RemoteEventListener, AutoCloseable {

    final AtomicLong events = new AtomicLong();
    private final BasicJeriExporter exporter =
        new BasicJeriExporter(
            Endpoints.tcp(SecureTeam.HOST, 0), new DeadlineILFactory(), false, true);

    void listen() throws Exception {
      Object unused =
          registrar()
              .notify(
                  new ServiceTemplate(null, new Class<?>[] {Plain.class}, null),
                  ServiceRegistrar.TRANSITION_NOMATCH_MATCH,
                  (RemoteEventListener) exporter.export(this),
                  (MarshalledObject<?>) null,
                  LEASE.toMillis());
    }

    @Override
    public void notify(RemoteEvent event) {
      events.incrementAndGet();
    }

    @Override
    public void close() {
      boolean unused = exporter.unexport(true);
    }
  }

  @Test
  void registrationsAndListenersOfTheLookupServiceEnd() throws Exception {
    try (Listener ottos = otto.call(Listener::new);
        Listener annas = anna.call(Listener::new)) {
      for (MemberCalls each : List.of(otto, anna)) {
        each.call(
            () -> {
              (each == otto ? ottos : annas).listen();
              return null;
            });
      }
      ServiceRegistration first = register(other, "first");
      await().atMost(PATIENCE).until(() -> ottos.events.get() == 1 && annas.events.get() == 1);
      replace("<deny member=\"otto\" interface=\"Registrar\" kind=\"listen\"/>", "<permit/>");
      await().pollDelay(Duration.ZERO).atMost(PATIENCE).until(() -> isForAnnaOnly(ottos, annas));
      assertThat(service(first.getServiceID())).isPresent();

      replace("<deny member=\"atrv2\" kind=\"register\"/>", "<permit/>");
      await().pollInterval(POLL).atMost(SOON).until(() -> service(first.getServiceID()).isEmpty());
      assertThat(drive(anna).driveState()).as("the robot's own stay").isNotNull();
    }
  }

  /** Registers one more service, of which both were notified at first. */
  private static boolean isForAnnaOnly(Listener ottos, Listener annas) throws Exception {
    long ottosBefore = ottos.events.get();
    long annasBefore = annas.events.get();
    Object unused = register(other, "the service after " + annasBefore);
    await().atMost(PATIENCE).until(() -> annas.events.get() > annasBefore);
    return ottos.events.get() == ottosBefore;
  }

  @Test
  void registrationsOfARevokedMemberEndToo() throws Exception {
    ServiceRegistration made = register(new MemberCalls(team.security(LOST)), "lost");
    assertThat(service(made.getServiceID())).isPresent();
    team.revoke(LOST);
    Path list = team.state(ANNA).resolve("authority").resolve("revoked.crl");
    assertThat(
            revoked.replace(
                SignedFiles.revocations(
                    Files.readAllBytes(list),
                    IdentityFolder.load(team.security(ROBOT)).authority(),
                    list.toString())))
        .isTrue();
    await().pollInterval(POLL).atMost(SOON).until(() -> service(made.getServiceID()).isEmpty());
  }
}

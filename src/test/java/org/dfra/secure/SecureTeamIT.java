package org.dfra.secure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;
import static org.dfra.secure.SecureTeam.ANNA;
import static org.dfra.secure.SecureTeam.ok;

import java.io.IOException;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicLong;
import net.jini.admin.Administrable;
import net.jini.core.entry.Entry;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.dfra.app.MarkedProcesses.Outcome;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.drive.Commander;
import org.dfra.drive.Wheels;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.Subscription;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.lease.ModuleLease;
import org.dfra.river.entry.ModuleEntry;
import org.dfra.river.phoenix.GroupStatus;
import org.dfra.river.remote.ModuleAdmin;
import org.dfra.secure.PlainCalls.Greeted;
import org.dfra.security.AccessRefusedException;
import org.dfra.sim.device.gps.M12Emulator;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;

/**
 * Two robots, an operator and an observer of a team, and a stranger: what each of them may do by
 * the command line. The tests share the team; the last ones change it.
 */
@Timeout(300)
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class SecureTeamIT {

  private static final Duration TO_A_TEAM = Duration.ofSeconds(60);
  private static final Duration LEASE = Duration.ofSeconds(20);
  private static final Duration SECOND_AFTER = Duration.ofSeconds(1);
  private static final Duration BRAKING = Duration.ofMillis(500);
  private static final Duration POLL = Duration.ofMillis(20);
  private static final String FIRST = "atrv1";
  private static final String SECOND = "atrv2";
  private static final String OTTO = "otto";
  private static final String OSCAR = "oscar";
  private static final String STRANGER = "stranger";

  @TempDir static Path folder;

  private static SecureTeam team;
  private static Wheels wheels;
  private static M12Emulator receiver;
  private static MemberCalls anna;
  private static MemberCalls otto;
  private static MemberCalls oscar;

  @BeforeAll
  static void make() throws Exception {
    wheels = new Wheels();
    receiver = TeamRobots.receiver();
    team = new SecureTeam(folder);
    team.describe(
        FIRST,
        TeamRobots.group("lookup", TeamRobots.registrar())
            + TeamRobots.group(
                "body", TeamRobots.drive(wheels.url()), TeamRobots.gps(receiver.url())));
    team.describe(
        SECOND, TeamRobots.group("all", TeamRobots.registrar(), TeamRobots.thermometer(17)));
    try (StallProbe probe = StallProbe.start()) {
      StallProbe.Stopwatch watch = probe.stopwatch();
      ok(team.dfra(ANNA, "security", "init", "field", "--no-passphrase", "--operator=" + ANNA));
      for (String robot : new String[] {FIRST, SECOND}) {
        ok(team.dfra(ANNA, team.issueWords("robot", robot)));
        ok(team.dfra(robot, team.joinWords(robot)));
      }
      CompletableFuture<Outcome> first = inBackground(FIRST);
      ok(team.up(SECOND));
      ok(first.get());
      assertThat(ok(team.ask(FIRST, "module", "call", "atrv2/warmth", "celsius")).out())
          .contains("17");
      Timing took = watch.stop();
      System.out.println("from nothing to a call between two robots of a team: " + took);
      took.requireWithin("from nothing to a call between two robots of a team", TO_A_TEAM);
    }
    team.admit("observer", OTTO);
    team.admit("operator", OSCAR);
    anna = new MemberCalls(team.security(ANNA));
    otto = new MemberCalls(team.security(OTTO));
    oscar = new MemberCalls(team.security(OSCAR));
  }

  private static CompletableFuture<Outcome> inBackground(String robot) {
    return CompletableFuture.supplyAsync(
        () -> {
          try {
            return team.up(robot);
          } catch (Exception e) {
            throw new IllegalStateException(e);
          }
        },
        task -> new Thread(task, "up of " + robot).start());
  }

  @AfterAll
  static void end() {
    try {
      team.close();
    } finally {
      receiver.close();
      wheels.close();
    }
  }

  /** One sentence, without a stack trace. */
  private static void assertRefused(Outcome outcome, String... words) {
    assertThat(outcome.exit()).as(outcome.out() + outcome.err()).isEqualTo(1);
    assertThat(outcome.err().strip()).startsWith("dfra: ").contains(words).hasLineCount(1);
  }

  private static void assertRefused(ThrowingCallable call, String words) {
    assertThatThrownBy(call).isInstanceOf(AccessRefusedException.class).hasMessageContaining(words);
  }

  @Test
  @Order(1)
  void anOperatorSetsAParameterAndAnObserverOnlyReadsAndListens() throws Exception {
    ok(team.ask(ANNA, "module", "set", "atrv1/drive", "max_speed", "0.5"));
    assertThat(
            ok(team.ask(OTTO, "event", "echo", "atrv1/gps_front", "--kind=reading", "--count=1"))
                .out())
        .contains("GpsFix");
    assertRefused(
        team.ask(OTTO, "module", "set", "atrv1/drive", "max_speed", "0.7"),
        "setParameter of drive is refused to observer otto of field (127.0.0.1)");
    DriveEffector drive = otto.find(team.registrar(FIRST), DriveEffector.class, "atrv1/drive");
    assertThat(drive.parameters())
        .filteredOn(each -> each.name().equals("max_speed"))
        .singleElement()
        .satisfies(each -> assertThat(Double.parseDouble(each.value())).isEqualTo(0.5));
    String refused = " of drive is refused to observer otto of field (127.0.0.1)";
    assertRefused(() -> drive.acquireCommandLease(LEASE), "acquireCommandLease" + refused);
    assertRefused(
        () -> drive.execute(new CommandKey(UUID.randomUUID()), new Velocity(1, 0)),
        "execute" + refused);
    assertRefused(() -> drive.releaseEmergencyStop("otto"), "releaseEmergencyStop" + refused);
  }

  @Test
  @Order(2)
  void aStrangerSeesThePublicPersonaOnly() throws Exception {
    assertThat(ok(team.ask(STRANGER, "module", "list")).out())
        .contains("atrv1", "drive", "gps_front", "atrv2", "warmth");
    assertRefused(
        team.ask(STRANGER, "module", "call", "atrv2/warmth", "celsius"),
        "celsius of warmth is refused to a stranger (127.0.0.1)");
    Outcome stop = team.ask(STRANGER, "stop", FIRST);
    assertThat(stop.exit()).as(stop.out() + stop.err()).isEqualTo(4);
    assertThat(stop.out() + stop.err())
        .contains("NOT STOPPED: Effector.emergencyStop of drive is refused to a stranger")
        .doesNotContain("\tat ");

    DriveEffector drive =
        MemberCalls.listed(team.registrar(FIRST), DriveEffector.class, "atrv1/drive");
    assertThat(drive.readiness().serves()).isTrue();
    ServiceRegistrar seen = MemberCalls.registrar(team.registrar(FIRST));
    ServiceTemplate modules = new ServiceTemplate(null, null, new Entry[] {new ModuleEntry()});
    assertThat(seen.getFieldValues(modules, 0, "name")).contains("drive", "gps_front");
    assertThat(seen.getFieldValues(modules, 0, "host")).containsOnlyNulls();
    ModuleEntry guess = new ModuleEntry();
    guess.host = SecureTeam.HOST;
    ServiceTemplate oracle = new ServiceTemplate(null, null, new Entry[] {guess});
    assertThat(seen.lookup(oracle, 8).totalMatches).as("asked by address").isZero();
    assertThat(
            anna.call(() -> MemberCalls.registrar(team.registrar(FIRST)).lookup(oracle, 8))
                .totalMatches)
        .isGreaterThanOrEqualTo(2);
    String refused = " of drive is refused to a stranger (127.0.0.1)";
    assertRefused(
        () -> drive.subscribe(event -> {}, DeliveryPolicy.keepLast(8)), "subscribe" + refused);
    assertRefused(() -> drive.acquireLease(LEASE), "acquireLease" + refused);
    assertRefused(() -> drive.acquireCommandLease(LEASE), "acquireCommandLease" + refused);
    assertRefused(() -> drive.emergencyStop("a stranger"), "emergencyStop" + refused);
    assertRefused(drive::driveState, "driveState" + refused);
    DriveEffector annas = anna.find(team.registrar(FIRST), DriveEffector.class, "atrv1/drive");
    assertThat(annas.emergencyStopState().latched()).isFalse();
  }

  @Test
  @Order(3)
  void aRobotStopsAnotherAndAnOperatorReleasesIt() throws Exception {
    ok(team.ask(SECOND, "stop", FIRST));
    Outcome release = team.ask(SECOND, "stop", FIRST, "--release");
    assertThat(release.exit()).as(release.out() + release.err()).isEqualTo(4);
    assertThat(release.out() + release.err())
        .contains("releaseEmergencyStop of drive is refused to robot atrv2 of field (127.0.0.1)")
        .doesNotContain("\tat ");
    DriveEffector drive = anna.find(team.registrar(FIRST), DriveEffector.class, "atrv1/drive");
    assertThat(drive.emergencyStopState().latched()).isTrue();
    ok(team.ask(ANNA, "stop", FIRST, "--release"));
    assertThat(drive.emergencyStopState().latched()).isFalse();
  }

  @Test
  @Order(4)
  void noPortServesCallsWithoutEncryption() throws Exception {
    int ports = 0;
    for (String robot : List.of(FIRST, SECOND)) {
      for (ProcessHandle process : team.living(robot)) {
        Map<Integer, Greeted> answers = PlainCalls.toAllPortsOf(process.pid());
        ports += answers.size();
        assertThat(answers.values())
            .as("answers of %s to plain calls: %s", process.info().commandLine(), answers)
            .contains(Greeted.ENCRYPTED_ONLY)
            .doesNotContain(Greeted.WELCOME, Greeted.RIVER);
      }
    }
    System.out.println("ports that serve no plain call: " + ports);
    assertThat(ports).as("two phoenixes, three groups, two registrars").isGreaterThanOrEqualTo(7);
  }

  @Test
  @Order(5)
  void aMemberThatNamesAnotherRobotIsNeverCalled() throws Exception {
    MemberCalls second = new MemberCalls(team.security(SECOND));
    int registrar = team.registrar(SECOND);
    try (PretendedThermometer rogue =
        second.call(() -> new PretendedThermometer(FIRST, "warmth", registrar))) {
      for (MemberCalls caller : List.of(anna, otto, new MemberCalls(team.security(FIRST)))) {
        Thermometer found =
            caller.call(
                () ->
                    (Thermometer)
                        MemberCalls.registrar(registrar)
                            .lookup(new ServiceTemplate(rogue.id(), null, null)));
        assertThatThrownBy(found::celsius)
            .isInstanceOf(RemoteException.class)
            .hasStackTraceContaining(
                "does not meet ServerMinPrincipal{CN=atrv1, OU=robot, O=field}");
        assertThatThrownBy(found::readiness).isInstanceOf(RemoteException.class);
      }
      Outcome call = team.ask(ANNA, "module", "call", "atrv1/warmth", "celsius", "--wait=3");
      assertThat(call.exit()).as(call.out() + call.err()).isNotZero();
      assertThat(call.out() + call.err()).doesNotContain("\tat ");
      assertThat(rogue.calls()).as("calls of the pretended module").isZero();
    }
  }

  @Test
  @Order(6)
  @EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "one more robot")
  void aRobotOfAnotherAuthorityIsNeverCalled() throws Exception {
    Path calls = folder.resolve("calls");
    try (SecureTeam others = new SecureTeam(folder.resolve("others"))) {
      others.init(); // a team of the same name
      others.admit("robot", FIRST);
      others.describe(
          FIRST, TeamRobots.group("all", TeamRobots.registrar(), TeamRobots.counted(calls)));
      ok(others.up(FIRST));
      assertThat(ok(others.ask(ANNA, "module", "call", "atrv1/warmth", "celsius")).out())
          .contains("-1");
      assertThat(calls).hasContent("read\n");
      int registrar = others.registrar(FIRST);
      for (MemberCalls caller : List.of(anna, otto)) {
        assertThatThrownBy(
                () ->
                    caller.call(
                        () ->
                            MemberCalls.registrar(registrar)
                                .lookup(new ServiceTemplate(null, null, null), 64)))
            .isInstanceOf(RemoteException.class);
      }
      team.alsoAsk(registrar);
      Outcome list = team.ask(ANNA, "module", "list", "--wait=4");
      assertThat(list.out()).contains("drive", "gps_front").doesNotContain("somebody");
      Outcome call = team.ask(ANNA, "module", "call", "atrv1/warmth", "celsius", "--wait=3");
      assertThat(call.exit()).as(call.out() + call.err()).isNotZero();
      assertThat(calls).as("calls by members").hasContent("read\n");
      team.askNoMore();
    }
  }

  @Test
  @Order(7)
  void killedProcessesComeBackWithTheirIdentity() throws Exception {
    DriveEffector drive = anna.find(team.registrar(FIRST), DriveEffector.class, "atrv1/drive");
    MemberCalls first = new MemberCalls(team.security(FIRST));
    GroupStatus body = first.call(() -> group(FIRST, "body"));
    SecureTeam.kill(ProcessHandle.of(body.pid()).orElseThrow());
    long killed = System.nanoTime();
    await()
        .pollInSameThread()
        .atMost(SecureTeam.PATIENCE)
        .ignoreExceptionsMatching(RemoteException.class::isInstance)
        .until(() -> anna.call(() -> drive.readiness().serves()));
    System.out.printf(
        "a killed group answers an old proxy after %.2f s%n", (System.nanoTime() - killed) / 1e9);
    assertThat(first.call(() -> group(FIRST, "body")).pid()).isNotEqualTo(body.pid());

    long phoenix = team.phoenix(SECOND).pid().orElseThrow();
    Thermometer warmth = anna.find(team.registrar(SECOND), Thermometer.class, "atrv2/warmth");
    SecureTeam.kill(ProcessHandle.of(phoenix).orElseThrow());
    assertThat(warmth.celsius()).as("its group works on").isEqualTo(17);
    ok(team.up(SECOND));
    MemberCalls second = new MemberCalls(team.security(SECOND));
    GroupStatus adopted = second.call(() -> group(SECOND, "all"));
    SecureTeam.kill(ProcessHandle.of(adopted.pid()).orElseThrow());
    await()
        .pollInSameThread()
        .atMost(SecureTeam.PATIENCE)
        .ignoreExceptionsMatching(RemoteException.class::isInstance)
        .until(() -> anna.call(warmth::celsius) == 17);
    for (String robot : List.of(FIRST, SECOND)) {
      for (ProcessHandle process : team.living(robot)) {
        assertThat(PlainCalls.toAllPortsOf(process.pid()).values()).doesNotContain(Greeted.WELCOME);
      }
    }
  }

  private static GroupStatus group(String robot, String name) throws RemoteException, IOException {
    return team.phoenix(robot).admin().groupStatus().stream()
        .filter(each -> each.name().endsWith("." + name))
        .findFirst()
        .orElseThrow();
  }

  private static void awaitRefusal(Callable<?> call) {
    await()
        .pollInterval(POLL)
        .atMost(SecureTeam.PATIENCE)
        .until(
            () -> {
              try {
                Object unused = call.call();
                return false;
              } catch (AccessRefusedException | RemoteException e) {
                return true;
              }
            });
  }

  /** The last: it takes members away. */
  @Test
  @Order(8)
  void aRevokedMemberLosesItsCallsSubscriptionsAndLeasesWithinASecond() throws Exception {
    GPSSensor gps = otto.find(team.registrar(FIRST), GPSSensor.class, "atrv1/gps_front");
    AtomicLong lastEvent = new AtomicLong();
    Subscription listening =
        otto.call(
            () ->
                gps.subscribe(
                    event -> lastEvent.set(System.nanoTime()), DeliveryPolicy.keepLast(8)));
    ModuleLease held = otto.call(() -> gps.acquireLease(LEASE));
    await().atMost(SecureTeam.PATIENCE).until(() -> lastEvent.get() != 0);
    GPSSensor annasGps = anna.find(team.registrar(FIRST), GPSSensor.class, "atrv1/gps_front");
    ModuleAdmin admin = anna.call(() -> (ModuleAdmin) ((Administrable) annasGps).getAdmin());
    int before = anna.call(() -> admin.leases().size());
    assertThat(before).isGreaterThanOrEqualTo(2);
    DriveEffector drive = oscar.find(team.registrar(FIRST), DriveEffector.class, "atrv1/drive");
    DriveEffector annas = anna.find(team.registrar(FIRST), DriveEffector.class, "atrv1/drive");
    try (StallProbe probe = StallProbe.start();
        Commander commander = oscar.call(() -> new Commander(drive, LEASE, new Velocity(0.4, 0)))) {
      await().atMost(SecureTeam.PATIENCE).until(() -> wheels.speed() > 0.3);
      team.revoke(OTTO);
      StallProbe.Stopwatch watch = probe.stopwatch();
      long revoked = System.nanoTime();
      team.revoke(OSCAR, FIRST, SECOND);
      awaitRefusal(gps::fix);
      Timing call = watch.stop();
      awaitRefusal(drive::driveState);
      await().pollInterval(POLL).atMost(SecureTeam.PATIENCE).until(() -> wheels.speed() < 0.01);
      Timing halt = watch.stop();
      await()
          .pollInterval(POLL)
          .atMost(SecureTeam.PATIENCE)
          .until(
              () -> annas.driveState().commander() == null && admin.leases().size() <= before - 2);
      Timing leases = watch.stop();
      System.out.println("revoked: call refused " + call + ", wheels " + halt);
      System.out.println("revoked: leases over " + leases);
      call.requireWithin("from the revocation to a refused call", SECOND_AFTER);
      halt.requireWithin("from the revocation to wheels that stand", SECOND_AFTER.plus(BRAKING));
      leases.requireWithin("from the revocation to the end of leases", SECOND_AFTER);
      long last = lastEvent.get() - revoked;
      System.out.printf("revoked: last event after %.3f s%n", last / 1e9);
      await().during(Duration.ofMillis(1500)).until(() -> lastEvent.get() - revoked == last);
      assertThat(commander.hasGivenUp()).isTrue();
      assertThat(Duration.ofNanos(last)).isLessThan(SECOND_AFTER);
    }
    held.close();
    listening.close();
    assertThat(annas.readiness().serves()).as("the others work on").isTrue();
  }
}

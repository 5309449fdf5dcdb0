package org.dfra.attack.registrar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Objects;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceMatches;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.attack.kit.AttackHosts;
import org.dfra.attack.kit.AttackedRobot;
import org.dfra.attack.kit.FakeServices;
import org.dfra.attack.kit.Fakes;
import org.dfra.benchmarks.task.TaskProcess;
import org.dfra.drive.Commander;
import org.dfra.drive.WheeledRobot;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.persona.ModuleAttributes;
import org.dfra.river.entry.Entries;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * A stranger registers a fake under the service ID of a robot's drive, in the robot's own
 * registrar, so that a stop goes to the fake. It is refused, also after the registrar and the drive
 * were killed; the drive's new incarnation registers under its ID. The tests share the robot and
 * the stranger.
 *
 * <p>{@code dfra.full} kills the drive once more, after the registrar.
 */
@Timeout(180)
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class StolenServiceIT {

  private static final Duration PATIENCE = Duration.ofSeconds(60);
  private static final Duration LEASE = Duration.ofSeconds(20);
  private static final boolean FULL = Boolean.getBoolean("dfra.full");
  private static final String REFUSED = "RegistrationRefusedException";

  @TempDir static Path folder;

  private static AttackHosts hosts;
  private static WheeledRobot robot;
  private static LookupLocator locator;
  private static ServiceID drive;
  private static TaskProcess task;

  @BeforeAll
  static void bringUp() throws Exception {
    hosts = AttackHosts.assumed();
    robot = WheeledRobot.start(folder, "drive");
    locator = new LookupLocator(robot.locator());
    drive = Fakes.id(registrar(), DriveEffector.class);
    task = AttackedRobot.attacker(FakeServices.class, locator.getHost(), locator.getPort());
    assertThat(tried(hosts.attacker(), "learn")).isEqualTo("done");
  }

  @AfterAll
  static void takeDown() throws Exception {
    try (WheeledRobot down = robot;
        TaskProcess killed = task) {
      assertThat(killed == null || killed.isAlive()).as("the attacker").isTrue();
    }
  }

  private static ServiceRegistrar registrar() throws Exception {
    return locator.getRegistrar();
  }

  private static String tried(String source, String verb) throws Exception {
    task.write(source + " " + verb);
    return task.awaitLine("", PATIENCE);
  }

  /** A registration as a client of the robot's registrar sees it. */
  private record Seen(Object proxy, ModuleAttributes attributes) {}

  private static Seen seen() throws Exception {
    ServiceMatches matches = registrar().lookup(new ServiceTemplate(drive, null, null), 1);
    assertThat(matches.totalMatches).as("registrations under the drive's ID").isEqualTo(1);
    ModuleAttributes attributes =
        Entries.toAttributes(matches.items[0].attributeSets).stream()
            .filter(ModuleAttributes.class::isInstance)
            .map(ModuleAttributes.class::cast)
            .findFirst()
            .orElseThrow();
    return new Seen(matches.items[0].service, attributes);
  }

  @Test
  @Order(1)
  void aStopGoesToTheDriveAndNotToAFake() throws Exception {
    Object honest = seen().proxy();
    try (Commander commander = new Commander(robot.drive(), LEASE, new Velocity(1, 0))) {
      robot.awaitFullSpeed();
      assertThat(tried(hosts.attacker(), "steal")).isEqualTo(REFUSED);
      assertThat(tried(hosts.otherAttacker(), "claim eta")).isEqualTo(REFUSED);
      assertThat(seen().proxy()).isEqualTo(honest);
      assertThat(commander.hasGivenUp()).isFalse();
      DriveEffector found = (DriveEffector) seen().proxy();
      assertThat(found.emergencyStop("a test").latched()).isTrue();
      robot.wheels().assertTheyStoodWithinHalfASecondOfTheLastCommand();
    }
    assertThat(robot.drive().releaseEmergencyStop("a test").latched()).isFalse();
  }

  @Test
  @Order(2) // it kills what the robot consists of
  void theDrivesNewIncarnationRegistersUnderItsIdAndAFakeDoesNot() throws Exception {
    ModuleAttributes before = seen().attributes();
    robot.phoenix().kill("eta.wheels");
    assertThat(tried(hosts.attacker(), "steal")).isEqualTo(REFUSED);
    awaitIncarnationAfter(before);

    ModuleAttributes second = seen().attributes();
    robot.phoenix().kill("eta.lookup");
    await("the registrar's new incarnation")
        .atMost(PATIENCE)
        .ignoreExceptionsInstanceOf(IOException.class)
        .until(() -> registrar().getServiceID() != null);
    assertThat(tried(hosts.attacker(), "steal")).as("from its snapshot").isEqualTo(REFUSED);
    assertThat(seen().proxy()).isInstanceOf(DriveEffector.class);
    if (FULL) { // every day RestoredRegistrarTest registers a new incarnation there
      robot.phoenix().kill("eta.wheels");
      awaitIncarnationAfter(second);
    }
  }

  private static void awaitIncarnationAfter(ModuleAttributes before) {
    await("a new incarnation of the drive")
        .atMost(PATIENCE)
        .ignoreExceptionsInstanceOf(IOException.class)
        .until(
            () ->
                Objects.requireNonNull(seen().attributes().activated())
                    .isAfter(Objects.requireNonNull(before.activated())));
    robot.phoenix().note();
  }
}

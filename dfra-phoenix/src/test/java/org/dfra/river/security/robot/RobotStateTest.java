package org.dfra.river.security.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.lang.reflect.Method;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.core.policy.PolicyGuard;
import org.dfra.core.policy.PolicyXml;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.river.identity.FlooredClock;
import org.dfra.security.AccessRequest;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Two processes of a robot, one that is called and one to which operators speak. */
class RobotStateTest {

  private static final Instant NOON = Instant.parse("2026-11-28T12:00:00Z");
  private static final Caller OSCAR =
      new Caller(
          Standing.MEMBER, Optional.of(new Member("field", MemberRole.OPERATOR, "oscar")), "::1");

  @TempDir private Path folder;

  private final AtomicInteger wakes = new AtomicInteger();
  private RobotState called;
  private RobotState other;
  private PolicyControl control;

  @BeforeEach
  void start() throws IOException {
    Path state =
        Files.createDirectory(
            folder.resolve("state"),
            PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------")));
    FlooredClock clock = new FlooredClock(InstantSource.fixed(NOON), Instant.EPOCH, Instant.MAX);
    called = new RobotState(state, clock, wakes::incrementAndGet);
    other = new RobotState(state, clock, () -> {});
    control = other.control();
  }

  private PolicyGuard guard(String rule) {
    String xml =
        "<policy xmlns=\"urn:dfra:policy:1\" team=\"field\" version=\"1\">" + rule + "</policy>";
    return new PolicyGuard(
        PolicyXml.read(
            xml.getBytes(StandardCharsets.UTF_8), "policy.xml", InterfaceCatalogue.builtIn()),
        called.facts(),
        called.confirmations(),
        null,
        InstantSource.fixed(NOON),
        System::nanoTime);
  }

  private static AccessRequest release() {
    try {
      Method method = DriveEffector.class.getMethod("releaseEmergencyStop", String.class);
      return new AccessRequest(OSCAR, "atrv1", "drive", DriveEffector.class, method);
    } catch (NoSuchMethodException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void aFactThatIsSetInOneProcessCountsInTheOther() throws IOException {
    PolicyGuard guard = guard("<permit><while fact=\"load\" is=\"none\"/></permit>");
    control.setFact("load", "none");
    assertThat(guard.decide(release()).isPermitted()).isFalse();
    boolean unused = called.look(false);
    assertThat(guard.decide(release()).isPermitted()).isTrue();
    control.setFact("load", "full");
    unused = called.look(false);
    assertThat(guard.decide(release()).isPermitted()).isFalse();
    assertThat(control.facts().named())
        .containsExactly(new NamedFact("load", "full", NOON, "the robot itself"));
    control.setFact("load", "");
    unused = called.look(false);
    assertThat(called.facts().fact("load")).isEmpty();
  }

  @Test
  void aFactFileThatIsDamagedMakesTheFactsUnknownAndIsNamed() throws IOException {
    control.setFact("load", "none");
    boolean unused = called.look(false);
    assertThat(called.facts().fact("load")).contains("none");
    Path file = folder.resolve("state").resolve(RobotState.FOLDER).resolve("facts.tsv");
    Files.writeString(file, "load\tnone\n");
    unused = called.look(false);
    assertThat(called.facts().fact("load")).isEmpty();
    assertThatThrownBy(control::facts)
        .isInstanceOf(IOException.class)
        .hasMessageContaining(file + ":1 is no fact (it has 2 fields, not 4)");
  }

  @Test
  void factsHaveBounds() throws IOException {
    for (String name : List.of("", "Load", "a b", "x".repeat(65))) {
      assertThatThrownBy(() -> control.setFact(name, "none"))
          .isInstanceOf(IllegalArgumentException.class);
    }
    for (String value : List.of(" ", "a\tb", "a\nb", "x".repeat(65), "\u00fc")) {
      assertThatThrownBy(() -> control.setFact("load", value))
          .isInstanceOf(IllegalArgumentException.class);
    }
    for (int i = 0; i < FactFile.MAX_FACTS; i++) {
      control.setFact("fact" + i, "x");
    }
    assertThatThrownBy(() -> control.setFact("load", "none"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("at most 64 facts");
  }

  @Test
  void aCallIsConfirmedInTheOtherProcessOnce() throws IOException {
    PolicyGuard guard = guard("<permit name=\"ask-first\"><ask/></permit>");
    assertThat(guard.decide(release()).isPermitted()).isFalse();
    assertThat(wakes).hasValue(1);
    assertThat(called.look(false)).as("an answer is awaited").isTrue();
    List<WaitingRequest> waiting = control.requests();
    assertThat(waiting).hasSize(1);
    assertThat(waiting.get(0).method()).isEqualTo("Effector.releaseEmergencyStop");
    assertThat(waiting.get(0).caller()).isEqualTo(OSCAR.toString());
    assertThat(waiting.get(0).secondsLeft()).isBetween(200L, 300L);

    String id = waiting.get(0).id();
    assertThat(control.answer("../" + id, true)).isFalse();
    assertThat(control.answer("other", true)).isFalse();
    assertThat(control.answer(id, true)).isTrue();
    assertThat(control.answer(id, false)).as("it has an answer").isFalse();
    assertThat(control.requests()).isEmpty();
    assertThat(called.look(false)).isFalse();
    assertThat(guard.decide(release()).isPermitted()).isTrue();
    assertThat(guard.decide(release()).isPermitted()).as("a second call").isFalse();
  }

  @Test
  void requestsOfProcessesThatHaveEndedAreDropped() throws IOException {
    PolicyGuard guard = guard("<permit name=\"ask-first\"><ask/></permit>");
    assertThat(guard.decide(release()).isPermitted()).isFalse();
    boolean unused = called.look(false);
    String id = control.requests().get(0).id();
    Path file = folder.resolve("state").resolve(RobotState.FOLDER + "/requests/" + id + ".request");
    String own = "process=" + ProcessHandle.current().pid();
    assertThat(Files.readString(file)).contains(own);
    Files.writeString(file, Files.readString(file).replace(own, "process=" + Integer.MAX_VALUE));
    assertThat(control.answer(id, true)).isFalse();
    assertThat(control.requests()).isEmpty();
    assertThat(file).doesNotExist();
  }

  @Test
  void noPositionIsKnownWithoutARuleThatNeedsOne() throws IOException {
    boolean unused = called.look(false);
    assertThat(called.facts().position()).isEmpty();
    assertThat(folder.resolve("state").resolve(RobotState.FOLDER)).doesNotExist();
    assertThat(control.facts().isPositionNeeded()).isFalse();
    assertThat(called.facts().time()).contains(NOON);
    assertThat(Duration.between(NOON, control.facts().time())).isZero();
  }
}

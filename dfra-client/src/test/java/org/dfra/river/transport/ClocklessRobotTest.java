package org.dfra.river.transport;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.river.transport.RecordingServer.call;

import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import org.dfra.river.fixture.TestTeam;
import org.dfra.river.fixture.TestTeam.Issued;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.FlooredClock;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.Test;

/** A robot that knows only how late it is at least. */
class ClocklessRobotTest {

  private static final TestTeam AUTHORITY = new TestTeam("field");
  private static final Instant NOW = Instant.now().truncatedTo(ChronoUnit.SECONDS);
  private static final Instant YESTERDAY = NOW.minus(Duration.ofDays(1));
  private static final Instant LATEST = NOW.plus(Duration.ofDays(90));

  private final TestIdentities team = new TestIdentities(AUTHORITY);

  private ChannelIdentity anna(Instant from, Instant until) {
    Issued issued =
        AUTHORITY.issue(new Member("field", MemberRole.OPERATOR, "anna").x500(), from, until);
    return team.of(MemberRole.OPERATOR, "anna", issued);
  }

  @Test
  void aNewerCertificateIsBelievedAndSaysHowLateItIs() throws Exception {
    FlooredClock clock = new FlooredClock(() -> Instant.EPOCH, YESTERDAY, LATEST);
    Instant issued = NOW.minus(Duration.ofMinutes(5));
    try (RecordingServer robot =
        RecordingServer.as(team.withClock(MemberRole.ROBOT, "atrv1", clock))) {
      assertThat(call(robot.from(anna(issued, LATEST)))).containsExactly(1, 2, 3);
      assertThat(robot.last(Caller.class).standing()).isEqualTo(Standing.MEMBER);
      assertThat(clock.floor()).isEqualTo(issued);

      Instant before = issued.minusSeconds(1);
      assertThat(call(robot.from(anna(YESTERDAY.minusSeconds(60), before))))
          .containsExactly(1, 2, 3);
      assertThat(robot.last(Caller.class).standing())
          .as("what had expired by then")
          .isEqualTo(Standing.EXPIRED);
    }
  }

  @Test
  void aStrangersCertificateSaysNothing() throws Exception {
    FlooredClock clock = new FlooredClock(() -> Instant.EPOCH, YESTERDAY, LATEST);
    TestTeam others = new TestTeam("field");
    Issued forged =
        others.issue(new Member("field", MemberRole.OPERATOR, "anna").x500(), NOW, LATEST);
    try (RecordingServer robot =
        RecordingServer.as(team.withClock(MemberRole.ROBOT, "atrv1", clock))) {
      assertThatThrownBy(() -> call(robot.from(team.of(MemberRole.OPERATOR, "anna", forged))))
          .isInstanceOf(java.io.IOException.class);
      assertThat(clock.floor()).isEqualTo(YESTERDAY);
    }
  }

  @Test
  void aRobotWhoseClockIsSetDoesNotBelieveTheFuture() throws Exception {
    FlooredClock clock = new FlooredClock(() -> YESTERDAY, YESTERDAY.minusSeconds(60), LATEST);
    try (RecordingServer robot =
        RecordingServer.as(team.withClock(MemberRole.ROBOT, "atrv1", clock))) {
      assertThatThrownBy(() -> call(robot.from(anna(NOW, LATEST))))
          .isInstanceOf(java.io.IOException.class);
      assertThat(clock.floor()).isEqualTo(YESTERDAY.minusSeconds(60));
    }
  }
}

package org.dfra.river.security;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import org.dfra.river.fixture.TestTeam;
import org.dfra.river.fixture.TestTeam.Issued;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.identity.TeamCredentials;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a robot whose clock may be lost remembers between its starts. */
class KnownTimeTest {

  private static final TestTeam TEAM = new TestTeam("field");

  @TempDir private Path folders;

  private final Issued issued = TEAM.issue(new Member("field", MemberRole.ROBOT, "atrv1"));
  private final Instant from = issued.certificate().getNotBefore().toInstant();
  private final Instant until = issued.certificate().getNotAfter().toInstant();
  private Instant shown = from.plus(Duration.ofHours(2));
  private Path folder;
  private TeamCredentials credentials;

  @BeforeEach
  void join() throws Exception {
    folder = TEAM.writeIdentity(folders.resolve("security"), issued);
    credentials = IdentityFolder.load(folder);
  }

  private KnownTime start() {
    return KnownTime.of(folder, credentials, () -> shown, true);
  }

  private Instant kept() throws IOException {
    return Instant.parse(Files.readString(folder.resolve(SecurityFiles.LATEST_TIME)).strip());
  }

  @Test
  void whatTheClockHasShownIsRememberedByTheNextStart() throws IOException {
    KnownTime first = start();
    first.keep();
    Instant seen = shown;
    assertThat(kept()).isEqualTo(seen);
    assertThat(first.fault()).isEmpty();

    shown = Instant.EPOCH;
    KnownTime second = start();
    assertThat(second.clock().instant()).isEqualTo(seen);
    assertThat(second.fault().orElseThrow())
        .contains("this computer's clock says 1970-01-01T00:00:00Z")
        .contains("delete " + folder.resolve(SecurityFiles.LATEST_TIME));
    second.keep();
    assertThat(kept()).isEqualTo(seen);
  }

  @Test
  void theFileIsWrittenEveryTenMinutesAndByTheLatestProcess() throws IOException {
    KnownTime time = start();
    time.keep();
    Instant written = shown;
    shown = written.plus(KnownTime.STEP).minusSeconds(1);
    time.keep();
    assertThat(kept()).isEqualTo(written);
    shown = written.plus(KnownTime.STEP);
    Instant other = shown.plusSeconds(5);
    Files.writeString(folder.resolve(SecurityFiles.LATEST_TIME), other + "\n"); // another process
    time.keep();
    assertThat(kept()).isEqualTo(other);
  }

  @Test
  void withoutAFileTheAuthoritySaysHowLateItIs() throws Exception {
    shown = Instant.EPOCH;
    Instant listed = credentials.revocations().orElseThrow().getThisUpdate().toInstant();
    assertThat(start().clock().floor()).isEqualTo(listed).isAfter(from);
    Files.writeString(folder.resolve(SecurityFiles.LATEST_TIME), "yesterday\n");
    assertThat(start().clock().floor()).isEqualTo(listed);
    Files.delete(folder.resolve(SecurityFiles.REVOKED));
    Files.delete(folder.resolve(SecurityFiles.LATEST_TIME));
    credentials = IdentityFolder.load(folder);
    assertThat(start().clock().floor()).isEqualTo(from);
  }

  @Test
  void anExpiredCertificateStaysExpiredAndNothingLaterIsKept() throws IOException {
    shown = until.plus(Duration.ofDays(3000));
    KnownTime far = start();
    far.keep();
    assertThat(kept()).isEqualTo(until.plusSeconds(1));
    shown = Instant.EPOCH;
    assertThat(credentials.validityFault(start().clock().instant())).isNotEmpty();
  }

  @Test
  void aCommandWritesNothing() {
    KnownTime.of(folder, credentials, () -> shown, false).keep();
    assertThat(folder.resolve(SecurityFiles.LATEST_TIME)).doesNotExist();
  }
}

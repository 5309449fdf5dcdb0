package org.dfra.core.audit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.core.audit.AuditFixture.ANNA;
import static org.dfra.core.audit.AuditFixture.CLOCK;
import static org.dfra.core.audit.AuditFixture.DRIVE;
import static org.dfra.core.audit.AuditFixture.PATIENCE;
import static org.dfra.core.audit.AuditFixture.READ;
import static org.dfra.core.audit.AuditFixture.STRANGER;
import static org.dfra.core.audit.AuditFixture.count;
import static org.dfra.core.audit.AuditFixture.large;
import static org.dfra.core.audit.AuditFixture.lines;
import static org.dfra.core.audit.AuditFixture.refusal;
import static org.dfra.core.audit.AuditFixture.request;
import static org.dfra.core.audit.AuditFixture.settings;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.dfra.core.audit.AuditKind.SecurityMode;
import org.dfra.security.AccessRequest;
import org.dfra.security.Caller;
import org.dfra.security.Decision;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a trail records, and where. */
class AuditTrailTest {

  @TempDir Path temp;

  private Path folder;

  @BeforeEach
  void nameFolder() {
    folder = temp.resolve("audit");
  }

  private void assertWhole() throws IOException {
    assertThat(AuditVerifier.verify(folder, List.of()))
        .isNotEmpty()
        .allSatisfy(each -> assertThat(each.broken()).isEmpty());
  }

  @Test
  void recordsWhoDidWhatAndWhatWasDecided() throws Exception {
    try (AuditTrail trail = new AuditTrail(settings(folder, "gps"), CLOCK)) {
      trail.start();
      Decision decision = Decision.permit("operators-drive");
      trail.record(AuditEvent.call(request(ANNA, DRIVE), decision, List.of("log", "notify")));
      trail.record(AuditEvent.processStarted(SecurityMode.SECURE, "joined team field"));
      trail.flush(PATIENCE);
    }
    List<AuditLine> lines = lines(folder);
    AuditLine call = lines.get(0);
    assertThat(call.time()).isEqualTo(CLOCK.instant());
    assertThat(call.number()).isEqualTo(2);
    assertThat(List.of(call.kind(), call.standing(), call.member(), call.address()))
        .containsExactly("call", "member", "operator anna of field", "192.0.2.7");
    assertThat(List.of(call.robot(), call.object(), call.method()))
        .containsExactly("atrv1", "drive", "Drive.setVelocity");
    assertThat(List.of(call.decision(), call.rule())).containsExactly("permit", "operators-drive");
    assertThat(call.obligations()).containsExactly("log", "notify");
    assertThat(lines.get(1).decision()).isEqualTo("secure");
    assertThat(lines).extracting(AuditLine::kind).containsExactly("call", "start", "end");
    assertWhole();
  }

  @Test
  void chainGoesOnOverFilesAndStarts() throws Exception {
    for (int start = 0; start < 3; start++) {
      try (AuditTrail trail = new AuditTrail(settings(folder, "gps"), CLOCK)) {
        trail.start();
        for (int i = 0; i < 25; i++) {
          trail.record(large(i));
        }
      }
    }
    assertThat(TrailFile.in(folder, "gps")).hasSizeGreaterThan(5);
    assertThat(count(lines(folder), AuditKind.CALL)).isEqualTo(75);
    assertWhole();
  }

  @Test
  void keepsItsSizeAndTheChainOfWhatIsLeft() throws Exception {
    try (AuditTrail trail = new AuditTrail(settings(folder, "gps", 3), CLOCK)) {
      trail.start();
      for (int i = 0; i < 200; i++) {
        trail.record(large(i));
      }
    }
    assertThat(TrailFile.in(folder, "gps")).hasSize(3);
    assertThat(TrailFile.in(folder, "gps").get(0).number()).isGreaterThan(5);
    for (TrailFile each : TrailFile.in(folder, "gps")) {
      assertThat(Files.size(each.path())).isLessThanOrEqualTo(AuditSettings.LEAST_BYTES);
    }
    assertWhole();
  }

  @Test
  void onlyItsUserMayReadIt() throws Exception {
    try (AuditTrail trail = new AuditTrail(settings(folder, "gps"), CLOCK)) {
      trail.start();
      trail.record(refusal(ANNA));
    }
    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(folder)))
        .isEqualTo("rwx------");
    try (Stream<Path> files = Files.list(folder)) {
      assertThat(files)
          .isNotEmpty()
          .allSatisfy(
              each ->
                  assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(each)))
                      .isEqualTo("rw-------"));
    }
  }

  @Test
  void refusesAFolderThatOthersMayEnter() throws Exception {
    Files.createDirectory(folder);
    Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwxr-xr-x"));
    try (AuditTrail trail = new AuditTrail(settings(folder, "gps"), CLOCK)) {
      assertThatThrownBy(trail::start)
          .isInstanceOf(IOException.class)
          .hasMessageContaining("type: chmod 700 " + folder);
    }
  }

  @Test
  void refusesASecondWriterOfAStream() throws Exception {
    try (AuditTrail one = new AuditTrail(settings(folder, "gps"), CLOCK);
        AuditTrail two = new AuditTrail(settings(folder, "gps"), CLOCK);
        AuditTrail other = new AuditTrail(settings(folder, "laser"), CLOCK)) {
      one.start();
      other.start();
      assertThatThrownBy(two::start)
          .isInstanceOf(IOException.class)
          .hasMessageContaining("give each a stream of its own");
    }
    assertThat(AuditVerifier.verify(folder, List.of()))
        .extracting(VerifiedStream::stream)
        .containsExactly("gps", "laser");
    assertWhole();
  }

  @Test
  void sumsReadsByCallerAndMethod() throws Exception {
    AccessRequest lookedUp = request(STRANGER, READ);
    try (AuditTrail trail = new AuditTrail(settings(folder, "gps"), CLOCK)) {
      trail.start();
      for (int i = 0; i < 1_000; i++) {
        trail.recordRead(request(ANNA, AuditFixture.Drive.class.getMethod("velocity")));
      }
      trail.recordRead(lookedUp);
      trail.flush(PATIENCE);
      trail.flush(PATIENCE); // there is nothing to record in the second interval
      trail.recordRead(lookedUp);
    }
    List<AuditLine> reads = new ArrayList<>(lines(folder));
    reads.removeIf(each -> !each.is(AuditKind.READS));
    assertThat(reads)
        .extracting(each -> each.address() + " " + each.count())
        .containsExactlyInAnyOrder("192.0.2.7 1000", "198.51.100.9 1", "198.51.100.9 1");
    assertThat(reads).allSatisfy(each -> assertThat(each.since()).isPresent());
    assertThat(reads).extracting(AuditLine::method).containsOnly("Drive.velocity");
  }

  @Test
  void recordsTheFirstOfEqualEventsAtOnceAndSumsTheOthers() throws Exception {
    try (AuditTrail trail = new AuditTrail(settings(folder, "gps"), CLOCK)) {
      trail.start();
      for (int i = 0; i < 10; i++) {
        trail.record(refusal(ANNA));
        trail.record(refusal(STRANGER));
      }
      trail.flush(PATIENCE);
    }
    assertThat(lines(folder))
        .extracting(each -> each.kind() + " " + each.address() + " " + each.count())
        .startsWith("call 192.0.2.7 1", "call 198.51.100.9 1")
        .contains("call 192.0.2.7 9", "call 198.51.100.9 9")
        .hasSize(5);
  }

  @Test
  void textFromOutsideIsPrintableAndBounded() throws Exception {
    Caller odd = Caller.stranger("\u001b[2J\n" + "9".repeat(500));
    Decision decision = Decision.deny("r\u202eule", "\n{\"n\":1}" + "x".repeat(100_000));
    AccessRequest request = new AccessRequest(odd, "a\nb", "\u0000".repeat(5_000), DRIVE);
    try (AuditTrail trail = new AuditTrail(settings(folder, "gps"), CLOCK)) {
      trail.start();
      trail.record(AuditEvent.call(request, decision, List.of("\u001b".repeat(500))));
    }
    String text = Files.readString(TrailFile.of(folder, "gps", 1).path());
    assertThat(text.lines()).hasSize(3).allSatisfy(each -> assertThat(each).hasSizeLessThan(4_000));
    assertThat(text.codePoints().filter(each -> each != '\n').anyMatch(Character::isISOControl))
        .isFalse();
    assertThat(lines(folder).get(0).robot()).isEqualTo("a\\nb");
    assertWhole();
  }

  @Test
  void aClosedTrailSaysSo() throws Exception {
    AuditTrail trail = new AuditTrail(settings(folder, "gps"), CLOCK);
    assertThat(trail.status().fault()).isPresent();
    trail.start();
    trail.start();
    trail.record(refusal(ANNA));
    trail.flush(PATIENCE);
    assertThat(trail.status()).isEqualTo(new AuditStatus(1, 0, Optional.empty()));
    trail.close();
    trail.close();
    assertThatThrownBy(() -> trail.flush(PATIENCE)).hasMessageContaining("is closed");
  }
}

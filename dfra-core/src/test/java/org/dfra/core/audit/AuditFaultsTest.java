package org.dfra.core.audit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.core.audit.AuditFixture.CLOCK;
import static org.dfra.core.audit.AuditFixture.PATIENCE;
import static org.dfra.core.audit.AuditFixture.count;
import static org.dfra.core.audit.AuditFixture.different;
import static org.dfra.core.audit.AuditFixture.large;
import static org.dfra.core.audit.AuditFixture.lines;
import static org.dfra.core.audit.AuditFixture.settings;
import static org.dfra.core.audit.AuditFixture.unbounded;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.dfra.core.audit.VerifiedStream.Kind;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Crashes, and disks that are full or slow: calls go on, and the chain too. */
class AuditFaultsTest {

  @TempDir Path temp;

  private Path folder;

  @BeforeEach
  void nameFolder() {
    folder = temp.resolve("audit");
  }

  private AuditTrail started() throws IOException {
    AuditTrail trail = new AuditTrail(settings(folder, "gps"), CLOCK);
    trail.start();
    return trail;
  }

  private VerifiedStream verified() throws IOException {
    return AuditVerifier.verify(folder, List.of()).get(0);
  }

  @ParameterizedTest
  @ValueSource(strings = {"{\"n\":5,\"ti", "\u0000\u0000\u0000", "no json\n", "{}\n{\"n\":"})
  void tornEndIsMovedAsideAndRecordedAndTheChainGoesOn(String torn) throws Exception {
    try (AuditTrail trail = started()) {
      trail.record(different(1));
    }
    Path file = TrailFile.of(folder, "gps", 1).path();
    Files.writeString(file, torn, StandardOpenOption.APPEND);
    assertThat(verified().broken()).isPresent();
    try (AuditTrail trail = started()) {
      trail.record(different(2));
    }
    assertThat(TrailRecovery.beside(file)).hasContent(torn.strip());
    assertThat(lines(folder))
        .extracting(AuditLine::kind)
        .containsExactly("call", "end", "torn", "call", "end");
    assertThat(lines(folder).get(2).reason())
        .isEqualTo(
            torn.getBytes(StandardCharsets.UTF_8).length
                + " bytes after the last whole line of gps.000001.jsonl are now at the end of"
                + " gps.000001.jsonl.torn");
    assertThat(verified().broken()).isEmpty();
    assertThat(verified().notes()).hasSize(1);
  }

  @Test
  void whatASecondCrashTearsIsKeptBesideTheFirst() throws Exception {
    Path file = TrailFile.of(folder, "gps", 1).path();
    for (String torn : List.of("", "first", "second")) {
      if (!torn.isEmpty()) {
        Files.writeString(file, torn, StandardOpenOption.APPEND);
      }
      try (AuditTrail trail = started()) {
        trail.record(different(1));
      }
    }
    assertThat(TrailRecovery.beside(file)).hasContent("firstsecond");
    assertThat(verified().broken()).isEmpty();
  }

  /** A crash after any byte: the next start continues the lines that were whole. */
  @Test
  void crashAtAnyByteOfTheLastLineLosesOnlyThat() throws Exception {
    try (AuditTrail trail = started()) {
      trail.record(different(1));
    }
    Path file = TrailFile.of(folder, "gps", 1).path();
    byte[] whole = Files.readAllBytes(file);
    int last = new String(whole, StandardCharsets.UTF_8).indexOf("{\"n\":3");
    for (int end = last; end < whole.length; end += 7) {
      Files.deleteIfExists(TrailRecovery.beside(file));
      Files.write(file, Arrays.copyOf(whole, end));
      try (AuditTrail trail = started()) {
        trail.record(different(2));
      }
      assertThat(verified().broken()).as("cut at byte %s", end).isEmpty();
      assertThat(count(lines(folder), AuditKind.CALL)).isEqualTo(2);
    }
  }

  /** The process died between the creation of a file and its first line. */
  @ParameterizedTest
  @ValueSource(strings = {"", "{\"n\":"})
  void fileWithoutItsFirstLineIsContinued(String content) throws Exception {
    try (AuditTrail trail = started()) {
      trail.record(different(1));
    }
    Files.writeString(TrailFile.of(folder, "gps", 2).path(), content);
    try (AuditTrail trail = started()) {
      trail.record(different(2));
    }
    assertThat(verified().broken()).isEmpty();
    assertThat(verified().files()).isEqualTo(2);
    assertThat(verified().last()).isEqualTo(content.isEmpty() ? 6 : 7);
  }

  @Test
  void whatAStartMovesAsideIsNotHiddenWhereItIsAmongGoodLines() throws Exception {
    try (AuditTrail trail = started()) {
      trail.record(different(1));
      trail.record(different(2));
    }
    Path file = TrailFile.of(folder, "gps", 1).path();
    Files.writeString(file, Files.readString(file).replace("number 1", "number 9"));
    try (AuditTrail trail = started()) {
      trail.record(different(3));
    }
    assertThat(verified().broken())
        .hasValueSatisfying(
            each -> {
              assertThat(each.kind()).isEqualTo(Kind.CHANGED);
              assertThat(each.line()).isEqualTo(2);
            });
  }

  @Test
  void fullDiskStopsNoCallAndIsReported() throws Exception {
    FaultyFiles disk = new FaultyFiles();
    try (AuditTrail trail = new AuditTrail(settings(folder, "gps"), CLOCK, disk)) {
      trail.start();
      trail.record(different(0));
      trail.flush(PATIENCE);
      disk.setFull(true);
      for (int i = 1; i <= 30; i++) {
        trail.record(large(i));
      }
      assertThatThrownBy(() -> trail.flush(PATIENCE))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("No space left on device")
          .hasMessageContaining("free space on the disk");
      assertThat(trail.status().dropped()).isEqualTo(30);
      assertThat(trail.status().fault()).isPresent();
      disk.setFull(false);
      trail.record(different(31));
      trail.flush(PATIENCE);
      assertThat(trail.status().fault()).isEmpty();
    }
    assertThat(count(lines(folder), AuditKind.CALL)).isEqualTo(2);
    assertThat(count(lines(folder), AuditKind.RECORDS_DROPPED)).isEqualTo(30);
    assertThat(verified().broken()).isEmpty();
  }

  @Test
  void diskThatIsFullWhileAFileBeginsLeavesAWholeChain() throws Exception {
    FaultyFiles disk = new FaultyFiles();
    try (AuditTrail trail = new AuditTrail(settings(folder, "gps"), CLOCK, disk)) {
      trail.start();
      int number = 0;
      for (int round = 0; round < 12; round++) {
        disk.setFull(true);
        trail.record(large(number++));
        assertThatThrownBy(() -> trail.flush(PATIENCE)).isInstanceOf(IOException.class);
        disk.setFull(false);
        for (int i = 0; i < 3; i++) {
          trail.record(large(number++));
        }
        trail.flush(PATIENCE);
      }
    }
    assertThat(verified().broken()).isEmpty();
    assertThat(verified().files()).isGreaterThan(3);
    assertThat(count(lines(folder), AuditKind.CALL)).isEqualTo(36);
    assertThat(count(lines(folder), AuditKind.RECORDS_DROPPED)).isEqualTo(12);
  }

  @Test
  void slowDiskStopsNoCallAndEveryEventIsCounted() throws Exception {
    FaultyFiles disk = new FaultyFiles();
    int events = 10_000;
    try (AuditTrail trail = new AuditTrail(unbounded(folder), CLOCK, disk)) {
      trail.start();
      CountDownLatch blocked = disk.block();
      for (int i = 0; i < events; i++) {
        trail.record(different(i)); // this would never end if it waited
      }
      assertThat(trail.status().dropped()).isPositive();
      assertThatThrownBy(() -> trail.flush(Duration.ofMillis(50)))
          .hasMessageContaining("was not on the disk within 50 ms");
      blocked.countDown();
      trail.flush(PATIENCE);
    }
    List<AuditLine> lines = lines(folder);
    assertThat(count(lines, AuditKind.CALL) + count(lines, AuditKind.RECORDS_DROPPED))
        .isEqualTo(events);
    assertThat(verified().broken()).isEmpty();
  }
}

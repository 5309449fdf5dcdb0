package org.dfra.core.audit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.core.audit.AuditFixture.CLOCK;
import static org.dfra.core.audit.AuditFixture.PATIENCE;
import static org.dfra.core.audit.AuditFixture.refusal;
import static org.dfra.core.audit.AuditFixture.settings;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.KeyPairGenerator;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import org.dfra.core.audit.HeadStore.Outcome;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What members keep of other members' trails. */
class HeadStoreTest {

  private static final Instant TIME = CLOCK.instant();

  @TempDir static Path certificates;

  private static TestMember robot;
  private static TestMember other;

  @TempDir Path temp;

  @BeforeAll
  static void create() throws Exception {
    robot = TestMember.create(certificates, "robot", "atrv1");
    other = TestMember.create(certificates, "robot", "atrv2");
  }

  private static AuditHead head(String stream, long number, char digit, TestMember signer) {
    return AuditHead.sign(stream, number, Character.toString(digit).repeat(64), TIME, signer.key());
  }

  @Test
  void headIsSignedAndAnyChangeIsFound() throws Exception {
    AuditHead head = head("gps", 17, 'a', robot);
    assertThat(head.verify(robot.certificate())).isTrue();
    assertThat(head.verify(other.certificate())).isFalse();
    String hash = head.hash();
    String signature = head.signature();
    assertThat(new AuditHead("gps", 18, hash, TIME, signature).verify(robot.certificate()))
        .isFalse();
    assertThat(new AuditHead("laser", 17, hash, TIME, signature).verify(robot.certificate()))
        .isFalse();
    assertThat(
            new AuditHead("gps", 17, hash, TIME.plusMillis(1), signature)
                .verify(robot.certificate()))
        .isFalse();
    assertThat(
            new AuditHead("gps", 17, "b".repeat(64), TIME, signature).verify(robot.certificate()))
        .isFalse();
    assertThat(new AuditHead("gps", 17, hash, TIME, "AAAA").verify(robot.certificate())).isFalse();
  }

  @Test
  void trailSignsItsEnd() throws Exception {
    Path folder = temp.resolve("audit");
    try (AuditTrail trail = new AuditTrail(settings(folder, "gps"), CLOCK)) {
      trail.start();
      assertThatThrownBy(() -> trail.head(robot.key(), PATIENCE))
          .hasMessageContaining("has no record yet");
      trail.record(refusal(AuditFixture.ANNA));
      AuditHead head = trail.head(robot.key(), PATIENCE);
      assertThat(head.verify(robot.certificate())).isTrue();
      assertThat(head.number()).isEqualTo(2);
      KeyPairGenerator edwards = KeyPairGenerator.getInstance("Ed25519");
      assertThatThrownBy(() -> trail.head(edwards.generateKeyPair().getPrivate(), PATIENCE))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("needs a private key for ECDSA");
    }
  }

  @Test
  void onlyNewerHeadsReplaceOlderOnesAlsoAfterARestart() throws Exception {
    Path file = temp.resolve("heads/heads.jsonl");
    HeadStore store = HeadStore.open(file, CLOCK);
    assertThat(store.keep(head("gps", 5, 'a', robot), robot.certificate())).isEqualTo(Outcome.KEPT);
    assertThat(store.keep(head("gps", 9, 'b', other), other.certificate())).isEqualTo(Outcome.KEPT);
    assertThat(store.keep(head("gps", 7, 'c', robot), robot.certificate())).isEqualTo(Outcome.KEPT);

    HeadStore again = HeadStore.open(file, CLOCK);
    assertThat(again.heads()).isEqualTo(store.heads());
    assertThat(again.heads())
        .extracting(each -> each.member().name() + " " + each.head().number())
        .containsExactly("atrv1 5", "atrv1 7", "atrv2 9");
    assertThat(again.keep(head("gps", 6, 'd', robot), robot.certificate()))
        .isEqualTo(Outcome.KNOWN);
    assertThat(again.keep(head("gps", 7, 'c', robot), robot.certificate()))
        .isEqualTo(Outcome.KNOWN);
    assertThat(again.keep(head("gps", 7, 'd', robot), robot.certificate()))
        .isEqualTo(Outcome.CONTRADICTION);
    assertThat(again.keep(head("gps", 8, 'd', other), robot.certificate()))
        .isEqualTo(Outcome.NOT_SIGNED);
    assertThat(HeadStore.read(file)).isEqualTo(again.heads());
    assertThat(again.heads())
        .extracting(each -> each.member().name() + " " + each.head().hash().charAt(0))
        .as("what contradicts is kept beside the first")
        .containsExactly("atrv1 a", "atrv1 c", "atrv1 d", "atrv2 b");
    assertThat(HeadStore.open(file, CLOCK).heads()).isEqualTo(again.heads());
    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)))
        .isEqualTo("rw-------");
  }

  @Test
  void headsThatAreHoursApartStayAndAFloodOfNewOnesReplacesOnlyTheNewest() throws Exception {
    Path file = temp.resolve("heads/heads.jsonl");
    AtomicReference<Instant> now = new AtomicReference<>(TIME);
    HeadStore store = HeadStore.open(file, now::get);
    long number = 0;
    for (int hour = 0; hour < 40; hour++) {
      for (int i = 0; i < 5; i++) {
        now.set(now.get().plusSeconds(1));
        assertThat(store.keep(head("gps", ++number, 'a', robot), robot.certificate()))
            .isEqualTo(Outcome.KEPT);
      }
      now.set(now.get().plusSeconds(3600));
    }
    List<Long> kept = store.heads().stream().map(each -> each.head().number()).toList();
    assertThat(kept).hasSize(HeadStore.MOST_OF_STREAM).isSorted().endsWith(number);
    assertThat(kept.get(0)).as("a day later than the oldest").isBetween(40L, 100L);
    assertThat(HeadStore.open(file, now::get).heads()).isEqualTo(store.heads());
    assertThat(store.lastReceived("robot atrv1 of field")).contains(now.get().minusSeconds(3600));
    assertThat(store.lastReceived("robot atrv2 of field")).isEmpty();
    assertThat(HeadStore.parse(HeadStore.text(store.heads()), "wire")).isEqualTo(store.heads());
  }

  @Test
  void aMemberCannotFillIt() throws Exception {
    HeadStore store = HeadStore.open(temp.resolve("heads/heads.jsonl"), CLOCK);
    for (int i = 0; i < HeadStore.MOST_STREAMS; i++) {
      assertThat(store.keep(head("s" + i, 1, 'a', robot), robot.certificate()))
          .isEqualTo(Outcome.KEPT);
    }
    assertThat(store.keep(head("more", 1, 'a', robot), robot.certificate()))
        .isEqualTo(Outcome.FULL);
    assertThat(store.keep(head("s3", 2, 'a', robot), robot.certificate()))
        .as("a newer head of a known stream")
        .isEqualTo(Outcome.KEPT);
    assertThat(store.keep(head("gps", 1, 'a', other), other.certificate()))
        .as("a head of another member")
        .isEqualTo(Outcome.KEPT);
  }

  @Test
  void aFileOfSomethingElseIsRefusedWithItsLine() throws Exception {
    Path file = temp.resolve("heads/heads.jsonl");
    HeadStore store = HeadStore.open(file, CLOCK);
    Outcome unused = store.keep(head("gps", 5, 'a', robot), robot.certificate());
    Files.writeString(file, Files.readString(file) + "{\"stream\":\"gps\"}\n");
    assertThatThrownBy(() -> HeadStore.open(file, CLOCK))
        .isInstanceOf(IOException.class)
        .hasMessageContaining(file + ":2: this is no head of an audit trail");
    assertThatThrownBy(() -> HeadStore.read(temp.resolve("none")))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("there is no file");
  }
}

package org.dfra.core.audit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;
import static org.dfra.core.audit.AuditFixture.CLOCK;
import static org.dfra.core.audit.AuditFixture.count;
import static org.dfra.core.audit.AuditFixture.different;
import static org.dfra.core.audit.AuditFixture.large;
import static org.dfra.core.audit.AuditFixture.lines;
import static org.dfra.core.audit.AuditFixture.settings;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Two processes with a stream each, one of which is killed while it writes. */
class AuditProcessesTest {

  @TempDir Path temp;

  /** Writes records to a stream until it is killed. */
  static final class Writer {

    private Writer() {}

    public static void main(String[] args) throws Exception {
      AuditTrail trail = new AuditTrail(settings(Path.of(args[0]), "group"), CLOCK);
      trail.start();
      for (int i = 0; ; i++) {
        trail.record(large(i));
        if (i % 10 == 0) {
          trail.flush(AuditFixture.PATIENCE);
        }
      }
    }
  }

  @Test
  void streamOfAKilledProcessIsWholeAndItsSuccessorContinuesIt() throws Exception {
    Path folder = temp.resolve("audit");
    Process writer =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-cp",
                System.getProperty("java.class.path"),
                Writer.class.getName(),
                folder.toString())
            .redirectErrorStream(true)
            .redirectOutput(temp.resolve("output").toFile())
            .start();
    try (AuditTrail own = new AuditTrail(settings(folder, "here"), CLOCK);
        AuditTrail same = new AuditTrail(settings(folder, "group"), CLOCK)) {
      own.start();
      own.record(different(1));
      await("the third file")
          .atMost(Duration.ofSeconds(20))
          .until(
              () -> {
                assertThat(writer.isAlive()).as(Files.readString(temp.resolve("output"))).isTrue();
                return TrailFile.in(folder, "group").size() > 2;
              });
      assertThatThrownBy(same::start).hasMessageContaining("another process");
      assertThat(writer.destroyForcibly().waitFor(10, TimeUnit.SECONDS)).isTrue();
      long before = TrailFile.in(folder, "group").get(0).number();
      same.start();
      same.record(different(2));
      assertThat(before).isPositive();
    } finally {
      Process unused = writer.destroyForcibly();
    }
    List<VerifiedStream> streams = AuditVerifier.verify(folder, List.of());
    assertThat(streams).extracting(VerifiedStream::stream).containsExactly("group", "here");
    assertThat(streams).allSatisfy(each -> assertThat(each.broken()).isEmpty());
    assertThat(count(lines(folder), AuditKind.PROCESS_ENDED))
        .as("of the two closed here")
        .isEqualTo(2);
  }
}

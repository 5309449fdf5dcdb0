package org.dfra.core.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import org.dfra.core.lease.SteppedScheduler;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MonotonicTimestampTest {

  private static final MonotonicTimestamp AT_FIVE = new MonotonicTimestamp("one", 5_000_000_000L);

  @TempDir Path folder;

  @Test
  void withinABootTheAgeIsExact() {
    assertThat(AT_FIVE.minAge(new MonotonicTimestamp("one", 7_500_000_000L)))
        .isEqualTo(Duration.ofMillis(2500));
    assertThat(AT_FIVE.isSameBoot(new MonotonicTimestamp("one", 1))).isTrue();
    assertThat(AT_FIVE.minAge(new MonotonicTimestamp("one", 1))).as("never negative").isZero();
  }

  @Test
  void whatWasBeforeThisBootIsAtLeastAsOldAsIt() {
    assertThat(AT_FIVE.isSameBoot(new MonotonicTimestamp("two", 1))).isFalse();
    assertThat(AT_FIVE.minAge(new MonotonicTimestamp("two", 3_000_000_000L)))
        .isEqualTo(Duration.ofSeconds(3));
  }

  @Test
  void whereABootIsNotKnownNothingIsKnownOfTheAge() {
    MonotonicTimestamp unknown = new MonotonicTimestamp("", 9_000_000_000L);
    assertThat(AT_FIVE.minAge(unknown)).isZero();
    assertThat(unknown.minAge(new MonotonicTimestamp("one", Long.MAX_VALUE))).isZero();
    assertThat(unknown.isSameBoot(unknown)).isFalse();
  }

  @Test
  void namesTheBootThatTheOperatingSystemNames() throws Exception {
    Path file = Files.writeString(folder.resolve("boot_id"), "one\n");
    SteppedScheduler time = new SteppedScheduler();
    MonotonicTimestamp then = MonotonicTimestamp.now(new BootId(file), time);
    time.step(Duration.ofSeconds(4));
    assertThat(then.minAge(MonotonicTimestamp.now(new BootId(file), time)))
        .as("over an overflow of the count, too")
        .isEqualTo(Duration.ofSeconds(4));
    assertThat(MonotonicTimestamp.now(new BootId(folder.resolve("none")), time).bootId()).isEmpty();
    assertThat(MonotonicTimestamp.now(new BootId(folder), time).bootId())
        .as("unreadable")
        .isEmpty();
  }

  @Test
  void isReadAsItIsWritten() {
    for (MonotonicTimestamp each :
        new MonotonicTimestamp[] {AT_FIVE, new MonotonicTimestamp("", -3)}) {
      assertThat(MonotonicTimestamp.parse(each.toString())).isEqualTo(each);
    }
    for (String none : new String[] {"", "2026-11-21T12:00:00Z", "x one"}) {
      assertThatIllegalArgumentException().isThrownBy(() -> MonotonicTimestamp.parse(none));
    }
  }
}

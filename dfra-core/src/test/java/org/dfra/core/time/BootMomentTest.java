package org.dfra.core.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import org.dfra.core.lease.SteppedScheduler;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BootMomentTest {

  private static final BootMoment AT_FIVE = new BootMoment("one", 5_000_000_000L);

  @TempDir Path folder;

  @Test
  void withinABootTheAgeIsExact() {
    assertThat(AT_FIVE.leastAge(new BootMoment("one", 7_500_000_000L)))
        .isEqualTo(Duration.ofMillis(2500));
    assertThat(AT_FIVE.isOfBoot(new BootMoment("one", 1))).isTrue();
    assertThat(AT_FIVE.leastAge(new BootMoment("one", 1))).as("never negative").isZero();
  }

  @Test
  void whatWasBeforeThisBootIsAtLeastAsOldAsIt() {
    assertThat(AT_FIVE.isOfBoot(new BootMoment("two", 1))).isFalse();
    assertThat(AT_FIVE.leastAge(new BootMoment("two", 3_000_000_000L)))
        .isEqualTo(Duration.ofSeconds(3));
  }

  @Test
  void whereABootIsNotKnownNothingIsKnownOfTheAge() {
    BootMoment unknown = new BootMoment("", 9_000_000_000L);
    assertThat(AT_FIVE.leastAge(unknown)).isZero();
    assertThat(unknown.leastAge(new BootMoment("one", Long.MAX_VALUE))).isZero();
    assertThat(unknown.isOfBoot(unknown)).isFalse();
  }

  @Test
  void namesTheBootThatTheOperatingSystemNames() throws Exception {
    Path file = Files.writeString(folder.resolve("boot_id"), "one\n");
    SteppedScheduler time = new SteppedScheduler();
    BootMoment then = BootMoment.now(new BootId(file), time);
    time.step(Duration.ofSeconds(4));
    assertThat(then.leastAge(BootMoment.now(new BootId(file), time)))
        .as("over an overflow of the count, too")
        .isEqualTo(Duration.ofSeconds(4));
    assertThat(BootMoment.now(new BootId(folder.resolve("none")), time).boot()).isEmpty();
    assertThat(BootMoment.now(new BootId(folder), time).boot()).as("unreadable").isEmpty();
  }

  @Test
  void isReadAsItIsWritten() {
    for (BootMoment each : new BootMoment[] {AT_FIVE, new BootMoment("", -3)}) {
      assertThat(BootMoment.parse(each.toString())).isEqualTo(each);
    }
    for (String none : new String[] {"", "2026-11-21T12:00:00Z", "x one"}) {
      assertThatIllegalArgumentException().isThrownBy(() -> BootMoment.parse(none));
    }
  }
}

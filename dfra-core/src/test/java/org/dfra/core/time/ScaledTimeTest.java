package org.dfra.core.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dfra.time.Scheduler;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ScaledTimeTest {

  private static final Instant BEGIN = Instant.parse("2026-11-21T16:00:00Z");

  /** A real time that is moved by hand. */
  private static final class HandTime implements Scheduler {
    long nanos = 7_000;
    final List<Long> waits = new ArrayList<>();

    @Override
    public long nanos() {
      return nanos;
    }

    @Override
    public ScheduledTask after(long wait, Runnable task) {
      waits.add(wait);
      return () -> {};
    }
  }

  private final HandTime real = new HandTime();

  @TempDir Path folder;

  private BootId boot(String id) throws IOException {
    return new BootId(Files.writeString(folder.resolve(id), id + "\n"));
  }

  @Test
  void runsAtItsSpeedFromTheInstantOnWhenItWasReal() {
    ScaledTime time = new ScaledTime(4, BEGIN, () -> BEGIN.plusSeconds(10), real);

    assertThat(time.instant()).isEqualTo(BEGIN.plusSeconds(40));
    real.nanos += 500_000_000;
    assertThat(time.instant()).isEqualTo(BEGIN.plusSeconds(42));
  }

  @Test
  void waitsShorterWhereItRunsFaster() {
    ScaledTime time = new ScaledTime(4, BEGIN, () -> BEGIN, real);

    Scheduler.ScheduledTask unused = time.after(1_000, () -> {});

    assertThat(real.waits).containsExactly(250L);
  }

  @Test
  void doesNotJumpWhenTheComputersClockIsSet() {
    Instant[] clock = {BEGIN};
    ScaledTime time = new ScaledTime(2, BEGIN, () -> clock[0], real);

    clock[0] = BEGIN.plusSeconds(3600);

    assertThat(time.instant()).isEqualTo(BEGIN);
  }

  @Test
  void agreesWithAnotherVirtualMachineThatReceivedItLater() {
    ScaledTime early = new ScaledTime(2.5, BEGIN, () -> BEGIN, real);
    real.nanos += 2_000_000_000;
    ScaledTime late = new ScaledTime(2.5, BEGIN, () -> BEGIN.plusSeconds(2), real);

    assertThat(late.instant()).isEqualTo(early.instant()).isEqualTo(BEGIN.plusSeconds(5));
  }

  @Test
  void agreesWithAnotherVirtualMachineThatWasStartedAfterTheClockWasSet() throws Exception {
    BootId boot = boot("1b9d6bcd");
    ScaledTime early = new ScaledTime(4, BEGIN, () -> BEGIN.plusSeconds(10), real);
    real.nanos += 2_000_000_000;
    Instant setBack = BEGIN.minusSeconds(100);
    ScaledTime late = ScaledTime.parse(early.toHostText(boot), boot, () -> setBack, real);

    assertThat(late.instant()).isEqualTo(early.instant()).isEqualTo(BEGIN.plusSeconds(48));
    assertThat(late.toHostText(boot)).isEqualTo(early.toHostText(boot));
  }

  @Test
  void goesByTheClockOnAnotherComputerAndAfterAnotherBoot() throws Exception {
    ScaledTime here = new ScaledTime(4, BEGIN, () -> BEGIN, real);
    String text = here.toHostText(boot("1b9d6bcd"));
    assertThat(text).isEqualTo("4x since 2026-11-21T16:00:00Z (boot 1b9d6bcd, 0.000007000 s)");
    real.nanos += 500_000_000_000L;
    BootId unnamed = new BootId(folder.resolve("nowhere"));
    for (BootId other : List.of(boot("77aa"), unnamed)) {
      ScaledTime there = ScaledTime.parse(text, other, () -> BEGIN.plusSeconds(3), real);
      assertThat(there.instant()).isEqualTo(BEGIN.plusSeconds(12));
    }
    assertThat(here.toHostText(unnamed)).isEqualTo(here.toString());
  }

  /** As in a shortage of file descriptors. Its wall clock may be an hour off by now. */
  @Test
  void doesNotGoByTheClockWhileItCannotReadWhichBootItIs() throws Exception {
    ScaledTime here = new ScaledTime(4, BEGIN, () -> BEGIN, real);
    String text = here.toHostText(boot("1b9d6bcd"));
    Path unreadable = Files.createDirectory(folder.resolve("boot_id"));
    BootId unknown = new BootId(unreadable);
    assertThatThrownBy(() -> ScaledTime.parse(text, unknown, () -> BEGIN, real))
        .isInstanceOf(UncheckedIOException.class)
        .hasMessageContaining("which boot of this computer it is cannot be read")
        .hasMessageContaining("ulimit -n");
    assertThatThrownBy(() -> here.toHostText(unknown)).isInstanceOf(UncheckedIOException.class);
    Files.delete(unreadable);
    Files.writeString(unreadable, "1b9d6bcd\n");
    assertThat(here.toHostText(unknown)).isEqualTo(text);
    assertThat(ScaledTime.parse(text, unknown, () -> BEGIN.minusSeconds(3600), real).instant())
        .isEqualTo(here.instant());
  }

  @Test
  void readsWhatItWritesForThisComputer() {
    String text = ScaledTime.parse("4x since 2026-11-21T16:00:00Z").toHostText();
    assertThat(ScaledTime.parse(text).toHostText()).isEqualTo(text);
  }

  @ParameterizedTest
  @ValueSource(strings = {"4x since 2026-11-21T16:00:00Z", "0.5x since 2026-11-21T16:00:00.250Z"})
  void readsWhatItWrites(String text) {
    assertThat(ScaledTime.parse(text)).hasToString(text);
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "4x", "4 since 2026-11-21T16:00:00Z", "4x since noon", "..x since x"})
  void refusesWhatIsNoTime(String text) {
    assertThatThrownBy(() -> ScaledTime.parse(text))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("\"" + text + "\" is not a time; write it like 4x since 2026-11-21T16:00:00Z");
  }

  @Test
  void refusesASpeedThatIsNone() {
    assertThatThrownBy(() -> ScaledTime.parse("0x since 2026-11-21T16:00:00Z"))
        .hasMessage("speed 0.0 is outside 0.01 to 1000.0");
  }
}

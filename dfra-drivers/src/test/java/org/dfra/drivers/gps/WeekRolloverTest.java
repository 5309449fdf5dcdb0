package org.dfra.drivers.gps;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Clock;
import java.time.Instant;
import java.time.InstantSource;
import org.dfra.drivers.link.LinkAddress;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class WeekRolloverTest {

  private static final LinkAddress RECEIVER = LinkAddress.parse("tcp://127.0.0.1:4001");
  private static final LinkAddress RECORDING = LinkAddress.parse("replay:recording.bin");

  /** What the computer's clock says has no part in this; none of these would change with it. */
  @ParameterizedTest
  @CsvSource({ // reported, meant
    "2026-11-22T10:00:01Z, 2026-11-22T10:00:01Z",
    "2026-11-01T00:00:00Z, 2026-11-01T00:00:00Z", // the day of the release
    "2026-10-31T23:59:59Z, 2046-06-16T23:59:59Z", // before it, so 1024 weeks later
    "2007-04-08T10:00:01Z, 2026-11-22T10:00:01Z", // 1024 weeks
    "1987-08-23T10:00:01Z, 2026-11-22T10:00:01Z", // 2048 weeks
    "2017-06-01T00:00:00Z, 2037-01-15T00:00:00Z",
    "1970-01-01T00:00:00Z, 2028-11-16T00:00:00Z", // 3072 weeks
    "2046-06-17T00:00:00Z, 2046-06-17T00:00:00Z", // far ahead of most computers
    "2080-01-01T00:00:00Z, 2080-01-01T00:00:00Z",
  })
  void aReceiverCannotReportADateBeforeTheRelease(Instant reported, Instant meant) {
    assertThat(WeekRollover.of(InstantSource.system(), RECEIVER).correct(reported))
        .isEqualTo(meant);
    assertThat(WeekRollover.of(Clock.systemDefaultZone(), RECEIVER).correct(reported))
        .as("by another name of the computer's clock")
        .isEqualTo(meant);
  }

  @ParameterizedTest
  @ValueSource(strings = {"1999-08-22T00:00:00Z", "2007-04-08T10:00:01Z", "2026-11-22T10:00:01Z"})
  void aRecordingKeepsItsDates(Instant recorded) {
    assertThat(WeekRollover.of(InstantSource.system(), RECORDING).correct(recorded))
        .isEqualTo(recorded);
    assertThat(WeekRollover.of(() -> Instant.EPOCH, RECORDING).correct(recorded))
        .as("in a simulation")
        .isEqualTo(recorded);
  }

  @ParameterizedTest
  @CsvSource({ // the simulated clock, reported, meant
    "2026-11-22T10:00:00Z, 2007-04-08T10:00:01Z, 2026-11-22T10:00:01Z", // 1024 weeks
    "2026-11-22T10:00:00Z, 2017-06-01T00:00:00Z, 2017-06-01T00:00:00Z", // 494 weeks: believed
    "2026-11-22T10:00:00Z, 2016-06-01T00:00:00Z, 2036-01-16T00:00:00Z", // 547 weeks
    "2026-11-22T10:00:00Z, 2046-07-09T10:00:00Z, 2046-07-09T10:00:00Z", // later: believed
    "2009-01-01T00:00:00Z, 1999-08-22T00:00:00Z, 1999-08-22T00:00:00Z", // 488 weeks: believed
    "2010-01-01T00:00:00Z, 1990-05-18T00:00:00Z, 2010-01-01T00:00:00Z",
  })
  void aSimulationGoesByItsOwnClock(Instant clock, Instant reported, Instant meant) {
    assertThat(WeekRollover.of(() -> clock, RECEIVER).correct(reported)).isEqualTo(meant);
  }

  @Test
  void aSimulationOfAnyYearIsBelieved() {
    Instant begin = Instant.parse("2004-06-01T12:00:00Z");
    assertThat(WeekRollover.of(() -> begin, RECEIVER).correct(begin.plusSeconds(1)))
        .isEqualTo(begin.plusSeconds(1));
  }
}

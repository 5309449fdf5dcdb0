package org.dfra.drivers.gps;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WeekRolloverTest {

  @ParameterizedTest
  @CsvSource({ // the computer's clock, reported, meant
    "2026-11-22T10:00:00Z, 2026-11-22T10:00:01Z, 2026-11-22T10:00:01Z",
    "2026-11-22T10:00:00Z, 2007-04-08T10:00:01Z, 2026-11-22T10:00:01Z", // 1024 weeks
    "2026-11-22T10:00:00Z, 1987-08-23T10:00:01Z, 2026-11-22T10:00:01Z", // 2048 weeks
    "2026-11-22T10:00:00Z, 2017-06-01T00:00:00Z, 2017-06-01T00:00:00Z", // 494 weeks: believed
    "2026-11-22T10:00:00Z, 2016-06-01T00:00:00Z, 2036-01-16T00:00:00Z", // 547 weeks
    "2026-11-22T10:00:00Z, 2046-07-09T10:00:00Z, 2046-07-09T10:00:00Z", // later: believed
    "1970-01-01T00:03:00Z, 2026-11-22T10:00:00Z, 2026-11-22T10:00:00Z", // no clock battery
    "1970-01-01T00:03:00Z, 2007-04-08T10:00:00Z, 2007-04-08T10:00:00Z", // later than its clock
    "2010-01-01T00:00:00Z, 1999-08-22T00:00:00Z, 2019-04-07T00:00:00Z",
    "2024-03-01T00:00:00Z, 2009-01-04T00:00:00Z, 2028-08-20T00:00:00Z", // a clock years behind
  })
  void movesADateByWholePeriods(Instant clock, Instant reported, Instant meant) {
    assertThat(new WeekRollover(() -> clock).correct(reported)).isEqualTo(meant);
  }

  @Test
  void aSimulationOfAnyYearIsBelieved() {
    Instant begin = Instant.parse("2004-06-01T12:00:00Z");
    assertThat(new WeekRollover(() -> begin).correct(begin.plusSeconds(1)))
        .isEqualTo(begin.plusSeconds(1));
  }
}

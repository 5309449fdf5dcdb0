package org.dfra.drivers.gps.ubx;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.drivers.fixture.Modules.awaitReadiness;
import static org.dfra.drivers.fixture.Modules.context;

import java.time.Instant;
import java.time.InstantSource;
import java.util.Map;
import org.dfra.drivers.fixture.ScriptedLink;
import org.dfra.drivers.fixture.ScriptedLinks;
import org.dfra.drivers.fixture.StepTicker;
import org.dfra.drivers.gps.ubx.UbxParser.UbxFramer;
import org.dfra.lifecycle.Readiness;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The driver alone: the test is the receiver and the time. */
@Timeout(120)
class UbxImplTest {

  private static final String URL = "tcp://receiver:4001";
  private static final Instant HOST = Instant.parse("2026-11-21T13:01:30.5Z");

  @Test
  void correctsADateThatIs1024WeeksTooEarly() {
    correctsADateThatIs1024WeeksTooEarly(InstantSource.system()); // whatever it says
  }

  @Test
  void correctsADateThatIs1024WeeksTooEarlyInASimulation() {
    correctsADateThatIs1024WeeksTooEarly(() -> HOST);
  }

  private static void correctsADateThatIs1024WeeksTooEarly(InstantSource clock) {
    int[] pvt = new int[92];
    pvt[4] = 2007 & 0xFF;
    pvt[5] = 2007 >> 8;
    pvt[6] = 4;
    pvt[7] = 7; // 1024 weeks before 21 November 2026
    pvt[8] = 13;
    pvt[9] = 1;
    pvt[10] = 30;
    pvt[11] = 7; // date and time are valid, and UTC
    pvt[20] = 3;
    pvt[21] = 1;
    ScriptedLinks links = new ScriptedLinks(URL);
    ScriptedLink link = new ScriptedLink(URL);
    links.add(link);
    try (UbxImpl gps =
        new UbxImpl(context("gps", Map.of("link", URL), clock), new StepTicker(false), links)) {
      gps.start();
      link.say(UbxCommands.encode(UbxFramer.NAV_PVT, pvt));
      awaitReadiness(gps, Readiness.READY);
      assertThat(gps.time().utc()).isEqualTo("2026-11-21T13:01:30Z");
      assertThat(gps.fix().utc()).isEqualTo("2026-11-21T13:01:30Z");
    }
  }
}

package org.dfra.core.policy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.core.policy.PolicyFixture.ANNA;
import static org.dfra.core.policy.PolicyFixture.call;
import static org.dfra.core.policy.PolicyFixture.policy;

import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import org.dfra.geometry.GeoPosition;
import org.junit.jupiter.api.Test;

/** Conditions decide by the facts at the time of the call, and fail closed. */
class PolicyConditionTest {

  /** A square of 1° whose east side has a notch down to its middle. */
  private static final String HALL =
      "<region name=\"hall\"><corner latitude=\"0\" longitude=\"0\"/>"
          + "<corner latitude=\"0\" longitude=\"1\"/><corner latitude=\"0.5\" longitude=\"0.5\"/>"
          + "<corner latitude=\"1\" longitude=\"1\"/><corner latitude=\"1\" longitude=\"0\"/></region>";

  private final SettableFacts facts = new SettableFacts();

  private PolicyGuard guard(String... lines) {
    return new PolicyGuard(
        policy(lines), facts, Confirmations.none(), null, InstantSource.system(), System::nanoTime);
  }

  private static boolean permits(PolicyGuard guard) {
    return guard.decide(call(ANNA, "execute")).isPermitted();
  }

  @Test
  void anUnknownFactHoldsForADenialAndNotForAPermit() {
    for (String condition :
        new String[] {
          "<within region=\"hall\"/>",
          "<when from=\"2026-01-01T00:00:00Z\"/>",
          "<when from=\"06:00\" until=\"20:00\"/>",
          "<while fact=\"load\" is=\"none\"/>"
        }) {
      assertThat(permits(guard(HALL, "<permit>" + condition + "</permit>")))
          .as("a permit that depends on %s", condition)
          .isFalse();
      assertThat(permits(guard(HALL, "<deny>" + condition + "</deny>", "<permit/>")))
          .as("a denial that depends on %s", condition)
          .isFalse();
    }
  }

  @Test
  void aDenialWhoseConditionFailsLeavesTheCallToTheNextRule() {
    facts.named.put("load", "full");
    assertThat(permits(guard("<deny><while fact=\"load\" is=\"none\"/></deny>", "<permit/>")))
        .isTrue();
    facts.named.put("load", "none");
    assertThat(permits(guard("<deny><while fact=\"load\" is=\"none\"/></deny>", "<permit/>")))
        .isFalse();
  }

  @Test
  void allConditionsOfARuleMustHold() {
    PolicyGuard guard =
        guard(HALL, "<permit><within region=\"hall\"/><while fact=\"load\" is=\"none\"/></permit>");
    facts.position = new GeoPosition(0.5, 0.2, 0);
    assertThat(permits(guard)).isFalse();
    facts.named.put("load", "none");
    assertThat(permits(guard)).as("the same guard sees the new fact").isTrue();
    facts.position = new GeoPosition(2, 0.2, 0);
    assertThat(permits(guard)).isFalse();
  }

  @Test
  void aRegionHasItsNotch() {
    PolicyGuard guard = guard(HALL, "<permit><within region=\"hall\"/></permit>");
    double[][] inside = {{0.1, 0.8}, {0.9, 0.8}, {0.5, 0.4}, {0.01, 0.01}};
    double[][] outside = {{0.5, 0.6}, {0.5, -0.1}, {-0.1, 0.5}, {1.1, 0.5}, {0.5, 1.5}};
    for (double[] each : inside) {
      facts.position = new GeoPosition(each[0], each[1], 100);
      assertThat(permits(guard)).as("%s is inside", facts.position).isTrue();
    }
    for (double[] each : outside) {
      facts.position = new GeoPosition(each[0], each[1], 0);
      assertThat(permits(guard)).as("%s is outside", facts.position).isFalse();
    }
  }

  @Test
  void aPeriodHasItsFirstInstantAndNotItsEnd() {
    PolicyGuard guard =
        guard(
            "<permit><when from=\"2026-01-01T00:00:00Z\" until=\"2026-01-02T00:00:00Z\"/></permit>");
    assertThat(permitsAt(guard, "2025-12-31T23:59:59Z")).isFalse();
    assertThat(permitsAt(guard, "2026-01-01T00:00:00Z")).isTrue();
    assertThat(permitsAt(guard, "2026-01-02T00:00:00Z")).isFalse();
  }

  @Test
  void aDailyPeriodMayIncludeMidnight() {
    PolicyGuard night = guard("<permit><when from=\"22:00\" until=\"06:00\"/></permit>");
    assertThat(permitsAt(night, "2026-01-01T23:00:00Z")).isTrue();
    assertThat(permitsAt(night, "2026-01-01T05:59:00Z")).isTrue();
    assertThat(permitsAt(night, "2026-01-01T06:00:00Z")).isFalse();
    PolicyGuard day = guard("<permit><when from=\"06:00\" until=\"22:00\"/></permit>");
    assertThat(permitsAt(day, "2026-01-01T12:00:00Z")).isTrue();
    assertThat(permitsAt(day, "2026-01-01T23:00:00Z")).isFalse();
  }

  private boolean permitsAt(PolicyGuard guard, String time) {
    facts.time = Instant.parse(time);
    return permits(guard);
  }

  @Test
  void aRegionWithoutAreaOrWithCrossingEdgesIsRefused() {
    assertThat(fault(0, 0, 0, 1, 0, 2)).contains("encloses no area");
    assertThat(fault(0, 0, 1, 1, 0, 1, 1, 0)).contains("the edges after corners 1 and 3 cross");
    assertThat(fault(0, -179, 0, 179, 1, 0)).contains("358.0° wide, at most 10.0°");
    assertThat(fault(0, 0, 0, 1, 1, 1, 1, 0)).isNull();
  }

  private static String fault(double... degrees) {
    List<GeoPosition> corners = new ArrayList<>();
    for (int i = 0; i < degrees.length; i += 2) {
      corners.add(new GeoPosition(degrees[i], degrees[i + 1], 0));
    }
    return PolicyRegion.fault(corners);
  }
}

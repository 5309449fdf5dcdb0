package org.dfra.behaviors.waypoint;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.dfra.behavior.GoalRefusedException;
import org.dfra.geometry.GeoPosition;
import org.junit.jupiter.api.Test;

class WaypointDistanceLimitTest {

  private static final GeoPosition ROBOT = new GeoPosition(48, 11, 510);

  @Test
  void letsANearWaypointPass() {
    // a degree of latitude is 111.2 km there: 1999 m and 2001 m
    assertThatCode(
            () ->
                WaypointDistanceLimit.DEFAULT.requireWithin(
                    ROBOT, new GeoPosition(48.017977, 11, 0)))
        .doesNotThrowAnyException();
    assertThatThrownBy(
            () ->
                WaypointDistanceLimit.DEFAULT.requireWithin(
                    ROBOT, new GeoPosition(48.017997, 11, 0)))
        .isInstanceOf(GoalRefusedException.class);
  }

  @Test
  void saysHowFarAWaypointIsAndWhatToDo() {
    assertThatThrownBy(
            () -> WaypointDistanceLimit.DEFAULT.requireWithin(ROBOT, new GeoPosition(57, 11, 0)))
        .isInstanceOf(GoalRefusedException.class)
        .hasMessage(
            "the waypoint 57.0000000°,11.0000000° is 1000.5 km from the robot at"
                + " 48.0000000°,11.0000000°, farther than 2000.0 m; send a nearer one, and see that"
                + " latitude and longitude are not swapped");
    assertThatThrownBy(
            () ->
                new WaypointDistanceLimit(50).requireWithin(ROBOT, new GeoPosition(48.001, 11, 0)))
        .hasMessageContaining("is 111.2 m from the robot")
        .hasMessageContaining("farther than 50.0 m");
  }

  @Test
  void refusesALimitThatIsNone() {
    assertThatThrownBy(() -> new WaypointDistanceLimit(Double.NaN))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> new WaypointDistanceLimit(0))
        .hasMessage("a maximum distance of 0.0 m is not above 0; give a greater one");
  }
}

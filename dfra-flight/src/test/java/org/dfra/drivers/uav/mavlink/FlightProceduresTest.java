package org.dfra.drivers.uav.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.dronefleet.mavlink.common.MavCmd;
import java.time.Duration;
import java.util.List;
import org.dfra.drivers.uav.mavlink.MavlinkCommand.CommandInt;
import org.dfra.drivers.uav.mavlink.MavlinkCommand.CommandLong;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.GlobalPosition;
import org.dfra.drivers.uav.mavlink.VehicleState.FlightMode;
import org.dfra.flow.effector.FlightCommand;
import org.dfra.flow.effector.FlightCommand.Arm;
import org.dfra.flow.effector.FlightCommand.Disarm;
import org.dfra.flow.effector.FlightCommand.GoTo;
import org.dfra.flow.effector.FlightCommand.Hold;
import org.dfra.flow.effector.FlightCommand.Land;
import org.dfra.flow.effector.FlightCommand.ReturnToLaunch;
import org.dfra.flow.effector.FlightCommand.TakeOff;
import org.dfra.geometry.GeoPosition;
import org.junit.jupiter.api.Test;

/** The numbers of the modes are those of ArduCopter's and PX4's user guides. */
class FlightProceduresTest {

  private static final Vehicle PX4 = new Vehicle(1, 1, 2, 12);
  private static final Vehicle ARDUPILOT = new Vehicle(1, 1, 2, 3);
  private static final GlobalPosition HERE =
      new GlobalPosition(Duration.ZERO, 27.95, -82.45, 40, 0, 0, 0, 0, 0.0);
  private static final double SEPARATION = -25.5;
  private static final float ANY = Float.NaN;

  @Test
  void setsTheModeOfEachAutopilotInItsOwnNumbers() {
    assertThat(steps(new Hold(), PX4)).containsExactly(mode(4, 3));
    assertThat(steps(new Hold(), ARDUPILOT)).containsExactly(mode(17, 0));
    assertThat(FlightMode.RETURN.isReportedBy(PX4, 0x05040000L)).isTrue();
    assertThat(FlightMode.RETURN.isReportedBy(ARDUPILOT, 6)).isTrue();
    assertThat(FlightMode.LAND.isReportedBy(PX4, 0x06040000L)).isTrue();
    assertThat(FlightMode.LAND.isReportedBy(ARDUPILOT, 6)).isFalse();
  }

  @Test
  void armsInAModeThatCanBeArmedAndDisarmsWithoutForce() {
    CommandLong arm = CommandLong.of(MavCmd.MAV_CMD_COMPONENT_ARM_DISARM, 1, 0);
    assertThat(steps(new Arm(), PX4)).containsExactly(mode(4, 3), arm);
    assertThat(steps(new Arm(), ARDUPILOT)).containsExactly(mode(4, 0), arm);
    assertThat(steps(new Disarm(), ARDUPILOT))
        .containsExactly(CommandLong.of(MavCmd.MAV_CMD_COMPONENT_ARM_DISARM, 0, 0));
  }

  @Test
  void sendsPx4AHeightAboveTheSeaAndArduPilotOneAboveTheGround() {
    assertThat(steps(new TakeOff(10), PX4))
        .containsExactly(new CommandLong(MavCmd.MAV_CMD_NAV_TAKEOFF, 0, 0, 0, ANY, ANY, ANY, 50));
    assertThat(steps(new TakeOff(10), ARDUPILOT))
        .containsExactly(
            mode(4, 0), new CommandLong(MavCmd.MAV_CMD_NAV_TAKEOFF, 0, 0, 0, 0, 0, 0, 10));
  }

  /** 39 m above the ellipsoid, which is 25.5 m above the sea here, is 64.5 m above the sea. */
  @Test
  void turnsAHeightAboveTheEllipsoidIntoOneAboveTheSea() {
    GoTo there = new GoTo(new GeoPosition(27.9506, -82.4572, 39), 5);
    CommandInt place =
        new CommandInt(
            MavCmd.MAV_CMD_DO_REPOSITION, 5, 1, 0, ANY, 279_506_000, -824_572_000, 64.5f);
    assertThat(steps(there, PX4)).containsExactly(place);
    assertThat(steps(there, ARDUPILOT))
        .containsExactly(mode(4, 0), place, CommandLong.of(MavCmd.MAV_CMD_DO_CHANGE_SPEED, 1, 5));
  }

  @Test
  void fliesNoFasterThanItMay() {
    GoTo there = new GoTo(new GeoPosition(27.9506, -82.4572, 39), 50);
    assertThat(((CommandInt) steps(there, PX4).get(0)).p1()).isEqualTo(8);
  }

  @Test
  void landsAndReturnsFromWhereItIs() {
    assertThat(steps(new Land(), PX4))
        .containsExactly(new CommandLong(MavCmd.MAV_CMD_NAV_LAND, 0, 0, 0, ANY, ANY, ANY, 0));
    assertThat(steps(new Land(), ARDUPILOT))
        .containsExactly(CommandLong.of(MavCmd.MAV_CMD_NAV_LAND, 0, 0));
    for (Vehicle vehicle : List.of(PX4, ARDUPILOT)) {
      assertThat(steps(new ReturnToLaunch(), vehicle))
          .containsExactly(CommandLong.of(MavCmd.MAV_CMD_NAV_RETURN_TO_LAUNCH, 0, 0));
    }
  }

  @Test
  void doesNotGuessAHeight() {
    GoTo there = new GoTo(new GeoPosition(27.9506, -82.4572, 39), 5);
    assertThatThrownBy(() -> FlightProcedures.steps(there, PX4, HERE, null, 8))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageEndingWith("set the parameter geoid_separation");
    assertThatThrownBy(() -> FlightProcedures.steps(new TakeOff(5), PX4, null, SEPARATION, 8))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("has no position");
  }

  @Test
  void knowsWhatItCanFly() {
    assertThat(FlightProcedures.supports(PX4)).isTrue();
    assertThat(FlightProcedures.supports(ARDUPILOT)).isTrue();
    assertThat(FlightProcedures.supports(new Vehicle(1, 1, 2, 0))).isFalse();
  }

  private static List<MavlinkCommand> steps(FlightCommand command, Vehicle vehicle) {
    return FlightProcedures.steps(command, vehicle, HERE, SEPARATION, 8);
  }

  private static CommandLong mode(int main, int sub) {
    return new CommandLong(MavCmd.MAV_CMD_DO_SET_MODE, 1, main, sub, 0, 0, 0, 0);
  }
}

package org.dfra.drivers.uav.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.MavCmd;
import java.util.HexFormat;
import org.dfra.drivers.uav.mavlink.MavlinkCommand.CommandInt;
import org.dfra.drivers.uav.mavlink.MavlinkCommand.CommandLong;
import org.junit.jupiter.api.Test;

/** The same bytes as were packed field by field from the protocol's definition. */
class MavlinkEncoderTest {

  private static final Vehicle VEHICLE = new Vehicle(1, 1, 2, 12);
  private static final CommandLong ARM = CommandLong.of(MavCmd.MAV_CMD_COMPONENT_ARM_DISARM, 1, 0);

  private final MavlinkEncoder encoder = new MavlinkEncoder(255);

  @Test
  void sendsAHeartbeatOfAGroundStation() {
    assertThat(hex(encoder.heartbeat()))
        .isEqualTo("FD09000000FFBE00000000000000060800" + "04033D48");
  }

  @Test
  void sendsACommandAndTheSameAgainWithAConfirmation() {
    encoder.heartbeat();
    String parameters = "0000803F" + "00000000".repeat(6) + "90010101";
    assertThat(hex(encoder.command(VEHICLE, ARM, 0)))
        .isEqualTo("FD20000001FFBE4C0000" + parameters + "7004");
    assertThat(hex(encoder.command(VEHICLE, ARM, 1)))
        .isEqualTo("FD21000002FFBE4C0000" + parameters + "01" + "8DD8");
  }

  @Test
  void sendsAPlaceToTheCentimetre() {
    encoder.heartbeat();
    encoder.command(VEHICLE, ARM, 0);
    encoder.command(VEHICLE, ARM, 1);
    CommandInt there =
        new CommandInt(
            MavCmd.MAV_CMD_DO_REPOSITION, 5, 1, 0, Float.NaN, 279_506_000, -824_572_000, 64.5f);
    assertThat(hex(encoder.command(VEHICLE, there, 0)))
        .isEqualTo(
            "FD20000003FFBE4B0000"
                + "0000A0400000803F000000000000C07F50ECA810A007DACE00008142C0000101"
                + "87AD");
  }

  private static String hex(byte[] bytes) {
    return HexFormat.of().withUpperCase().formatHex(bytes);
  }
}

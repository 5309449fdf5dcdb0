package org.dfra.drivers.uav.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.HexFormat;
import java.util.List;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.BatteryStatus;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.CommandAck;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.ExtendedState;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.GlobalPosition;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.GpsRaw;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.Heartbeat;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.Malformed;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.Other;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.SystemStatus;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.SystemTime;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.Text;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.VfrHud;
import org.dfra.drivers.uav.mavlink.MavlinkParser.MavlinkFrame;
import org.junit.jupiter.api.Test;

/**
 * Frames packed field by field from the protocol's definition, without DFRA's code and without the
 * library, checksums bit by bit.
 */
class MavlinkDecoderTest {

  @Test
  void readsAHeartbeatOfMavlink1() {
    MavlinkFrame frame = frame("FE094E0101000000000002035104031C7F");
    assertThat(frame).isEqualTo(new MavlinkFrame(1, 1, 1, 0x4E, new Heartbeat(2, 3, false, 0, 4)));
  }

  @Test
  void readsAHeartbeat() {
    MavlinkFrame frame = frame("FD09000011010100000000000403020C9D0403DE49");
    assertThat(frame)
        .isEqualTo(new MavlinkFrame(2, 1, 1, 17, new Heartbeat(2, 12, true, 0x03040000, 4)));
  }

  @Test
  void readsWhereTheAutopilotIsAndHowItMoves() {
    assertThat(
            message(
                "FD1C0000070101210000"
                    + "40E2010050ECA810A007DACE24F40000204E00002C0170FECEFF0C7B"
                    + "14BD"))
        .isEqualTo(
            new GlobalPosition(
                Duration.ofMillis(123_456), 27.9506, -82.4572, 62.5, 20, 3, -4, -0.5, 315.0));
  }

  @Test
  void readsWhatTheReceiverSays() {
    assertThat(
            message(
                "FD2C0000080101180000"
                    + "00909B68E548060050ECA810A007DACE409C00005A007800F401DF77030B"
                    + "A4380000DC050000C40900002C01"
                    + "285C"))
        .isEqualTo(
            new GpsRaw(
                Duration.ofSeconds(1_769_000_000),
                3,
                27.9506,
                -82.4572,
                40,
                14.5,
                0.9,
                1.2,
                5.0,
                306.87,
                11,
                1.5,
                2.5));
  }

  @Test
  void knowsThatMavlink1HasNoHeightAboveTheEllipsoid() {
    String base = "00909B68E548060050ECA810A007DACE409C00005A007800F401DF77030B";
    GpsRaw raw =
        (GpsRaw) message("FD1E0000080101180000" + base + sum("1E0000080101180000" + base, 24));
    assertThat(raw.height()).isNull();
    assertThat(raw.heightMsl()).isEqualTo(40);
  }

  @Test
  void readsSpeedAndClimb() {
    assertThat(message("FD1300000901014A0000000000000000A04000007A420000003F3B0132DCC3"))
        .isEqualTo(new VfrHud(5, 315, 62.5, 0.5));
  }

  @Test
  void readsThatItFlies() {
    assertThat(message("FD0200000A0101F5000000024E27")).isEqualTo(new ExtendedState(2));
  }

  @Test
  void readsItsSupply() {
    assertThat(
            message(
                "FD1F00000B0101010000"
                    + "000000000000000000000000FA00B83DD20400000000000000000000000057"
                    + "024D"))
        .isEqualTo(new SystemStatus(15.8, 12.34, 0.87));
  }

  @Test
  void readsABatteryThatIsCharged() {
    assertThat(
            message(
                "FD2400000D0101930000"
                    + "FFFFFFFFFFFFFFFFFF7FA00FA00F3C0F3C0FFFFFFFFFFFFFFFFFFFFFFFFF6AFF0000013F"
                    + "4737"))
        .isEqualTo(new BatteryStatus(0, 15.8, -1.5, 0.63));
  }

  @Test
  void readsItsClock() {
    assertThat(message("FD0B00000C010102000090609F68E548060040E201D078"))
        .isEqualTo(
            new SystemTime(
                Instant.ofEpochSecond(1_769_000_000, 250_000_000), Duration.ofMillis(123_456)));
  }

  @Test
  void readsARefusalAndWhomItIsFor() {
    assertThat(message("FD0A000005 01014D00009001020000000000FFBEA398"))
        .isEqualTo(new CommandAck(400, 2, 255, 190));
  }

  /** Of the ten bytes of an acknowledgement only two are sent where the others are zero. */
  @Test
  void takesWhatIsLeftOutForZero() {
    assertThat(message("FD02000006 01014D00009001BFFC")).isEqualTo(new CommandAck(400, 0, 0, 0));
  }

  @Test
  void readsWhatIsForPeople() {
    assertThat(
            message(
                "FD1700000E0101FD0000"
                    + "045072654172 6D3A204750533A206E6F20334420666978"
                    + "FF76"))
        .isEqualTo(new Text(4, "PreArm: GPS: no 3D fix"));
  }

  @Test
  void doesNotBelieveALatitudeBeyondThePole() {
    String bytes =
        "1C0000070101210000" + "40E20100FFFFFF7FA007DACE24F40000204E00002C0170FECEFF0C7B";
    assertThat(message("FD" + bytes + sum(bytes, 104)))
        .isEqualTo(
            new Malformed("GLOBAL_POSITION_INT", "latitude 214.7483647° is outside −90° to 90°"));
  }

  @Test
  void doesNotBelieveASpeedThatIsNoNumber() {
    String bytes = "130000090101 4A0000 00000000 0000C07F 00007A42 0000003F 3B01 32";
    assertThat(message("FD" + bytes + sum(bytes, 20))).isInstanceOf(Malformed.class);
  }

  @Test
  void namesWhatItDoesNotRead() {
    String bytes = "1C0000070101 1E0000" + "00".repeat(27) + "01";
    assertThat(message("FD" + bytes + sum(bytes, 39))).isEqualTo(new Other("Attitude"));
  }

  private static MavlinkMessage message(String hex) {
    return frame(hex).message();
  }

  private static MavlinkFrame frame(String hex) {
    List<MavlinkFrame> frames = MavlinkParser.parse(bytes(hex));
    assertThat(frames).hasSize(1);
    return frames.get(0);
  }

  /** The checksum's two bytes, bit by bit. */
  private static String sum(String hex, int extra) {
    int sum = 0xFFFF;
    for (byte next : bytes(hex + HexFormat.of().toHexDigits((byte) extra))) {
      sum ^= next & 0xFF;
      for (int bit = 0; bit < 8; bit++) {
        sum = (sum & 1) == 0 ? sum >> 1 : sum >> 1 ^ 0x8408;
      }
    }
    return HexFormat.of().toHexDigits((byte) sum) + HexFormat.of().toHexDigits((byte) (sum >> 8));
  }

  private static byte[] bytes(String hex) {
    return HexFormat.of().parseHex(hex.replace(" ", ""));
  }
}
